//! Bounding polytopes between parallel planes of fixed directions: k-DOPs, here of k = 14.
//!
//! * *Idea*: A box is what lies between three pairs of planes. Four more pairs, across the diagonals of space, cut off
//!   its corners: parts that lie aslant are held more closely.
//! * *Paper*: Kay, Kajiya: *Ray Tracing Complex Scenes*, 1986, whose "plane sets" have seven directions as here; the
//!   name is of Klosowski, Held, Mitchell, Sowizral, Zikan: *Efficient Collision Detection Using Bounding Volume
//!   Hierarchies of k-DOPs*, 1998.
//! * *Build*: that of the binary tree (`builder=`), and O(n · depth) for the planes.
//! * *A ray*: O(log n) nodes in the mean, two polytopes each: that of a box, and where it is met four more divisions'
//!   worth.
//! * *Memory*: 128 bytes a node, four times that of boxes.
//! * *It wins*: in the number of nodes that are visited, where what lies aslant is large beside its parts; seldom in
//!   time.
//! * *Picture*: `docs/gallery/cells-kdop.png`.
//!
//! Along an axis the padded test of boxes serves. Along a diagonal, a point that a padded box accepts is at most 1.1
//! paddings outside of it on each axis, hence 3.3 along `(±1, ±1, ±1)`; four are allowed for, and the rounding of `f64`
//! vanishes beside the rest.

use glam::{DVec3, Vec3A};
use rayon::prelude::*;

use crate::math::{Aabb, BoxRay, NONE, Ray, round_down, round_up};

use super::super::RegionForm;
use super::super::sphere_ray::skips_nothing;
use super::Volume;

/// The diagonals of space; the other four run backwards along these.
const DIAGONALS: [DVec3; 4] = [
    DVec3::new(1.0, 1.0, 1.0),
    DVec3::new(1.0, 1.0, -1.0),
    DVec3::new(1.0, -1.0, 1.0),
    DVec3::new(-1.0, 1.0, 1.0),
];

/// By how many paddings the planes across diagonals are moved outwards.
const MORE: f64 = 4.0;

/// A polytope of fourteen sides.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct KDop {
    /// Where the sides along the axes are.
    low: [f32; 3],
    high: [f32; 3],
    /// Between which products with each diagonal it lies.
    least: [f32; 4],
    most: [f32; 4],
}

/// A ray as such polytopes see it.
pub struct KDopRay {
    box_ray: BoxRay,
    t_min: f32,
    /// The origin along each diagonal, less and more what planes are moved by.
    origin: [[f64; 2]; 4],
    /// How far it runs along each diagonal for a unit of the parameter.
    speed: [f64; 4],
    /// How many diagonals are looked at: none where parameters are too coarse for them.
    diagonals: usize,
}

impl KDop {
    /// How many sides there are.
    pub const SIDES: usize = 14;

    /// The box between the sides along the axes.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        Aabb { min: self.low.into(), max: self.high.into() }
    }

    /// For each side a direction out of it and the product of its points with that: six along the axes, eight along the
    /// diagonals.
    #[must_use]
    pub fn sides(&self) -> [(DVec3, f64); Self::SIDES] {
        let pair =
            |out: DVec3, least: f32, most: f32| [(-out, -f64::from(least)), (out, f64::from(most))];
        std::array::from_fn(|side| {
            let (i, which) = (side / 2, side % 2);
            match i.checked_sub(3) {
                None => pair(DVec3::AXES[i], self.low[i], self.high[i])[which],
                Some(i) => pair(DIAGONALS[i], self.least[i], self.most[i])[which],
            }
        })
    }

    /// Where the ray from an origin in a direction enters, and through which of the [`sides`](Self::sides); `None` if
    /// it misses, or nothing is before it.
    #[must_use]
    pub fn entered_from(&self, origin: DVec3, dir: DVec3) -> Option<(f64, usize)> {
        let (mut begin, mut through, mut end) = (f64::NEG_INFINITY, 0, f64::INFINITY);
        for (side, (out, at)) in self.sides().into_iter().enumerate() {
            let (ahead, speed) = (at - out.dot(origin), out.dot(dir));
            if speed < 0.0 && ahead / speed > begin {
                (begin, through) = (ahead / speed, side);
            } else if speed > 0.0 {
                end = end.min(ahead / speed);
            } else if speed == 0.0 && ahead < 0.0 {
                return None;
            }
        }
        (begin <= end && begin.is_finite()).then_some((begin, through))
    }

    /// Both ends of each edge.
    #[must_use]
    pub fn edges(&self) -> Vec<[DVec3; 2]> {
        let sides = self.sides();
        let size = self.bounds().size().max_element().max(f32::MIN_POSITIVE);
        let tolerance = 1e-7 * f64::from(size);
        let mut edges = Vec::new();
        for (i, &(n, a)) in sides.iter().enumerate() {
            for (j, &(m, b)) in sides.iter().enumerate().skip(i + 1) {
                let along = n.cross(m);
                if along == DVec3::ZERO {
                    continue;
                }
                // On both planes, and in the plane of their normals.
                let (nn, mm, nm) = (n.length_squared(), m.length_squared(), n.dot(m));
                let point = (n * (a * mm - b * nm) + m * (b * nn - a * nm)) / (nn * mm - nm * nm);
                let (mut begin, mut end) = (f64::NEG_INFINITY, f64::INFINITY);
                for (k, &(out, at)) in sides.iter().enumerate() {
                    if k == i || k == j {
                        continue;
                    }
                    let (ahead, speed) = (at - out.dot(point), out.dot(along));
                    if speed < 0.0 {
                        begin = begin.max(ahead / speed);
                    } else if speed > 0.0 {
                        end = end.min(ahead / speed);
                    } else if ahead < -tolerance {
                        end = f64::NEG_INFINITY;
                    }
                }
                if (end - begin) * along.length() > tolerance {
                    edges.push([point + begin * along, point + end * along]);
                }
            }
        }
        edges
    }
}

/// The least and the largest product of a box's corners with each diagonal.
type Spans = [[f64; 2]; 4];

/// Of nothing.
const EMPTY: Spans = [[f64::INFINITY, f64::NEG_INFINITY]; 4];

fn spans(bounds: &Aabb) -> Spans {
    let [low, high] = [bounds.min, bounds.max].map(Vec3A::as_dvec3);
    DIAGONALS.map(|diagonal| {
        let (a, b) = (diagonal * low, diagonal * high);
        [a.min(b).element_sum(), a.max(b).element_sum()]
    })
}

fn both(mut a: Spans, b: Spans) -> Spans {
    for ([least, most], other) in a.iter_mut().zip(b) {
        (*least, *most) = (least.min(other[0]), most.max(other[1]));
    }
    a
}

/// The next float that is not above, or not below.
fn rounded([least, most]: [f64; 2]) -> [f32; 2] {
    [round_down(least), round_up(most)]
}

impl Volume for KDop {
    type Ray = KDopRay;

    fn ray(ray: &Ray, box_ray: &BoxRay) -> KDopRay {
        let (origin, dir) = (ray.origin.as_dvec3(), ray.dir.as_dvec3());
        let pad = f64::from(box_ray.pad);
        let more = MORE * pad;
        KDopRay {
            box_ray: *box_ray,
            t_min: ray.t_min,
            origin: DIAGONALS.map(|diagonal| diagonal.dot(origin)).map(|at| [at + more, at - more]),
            speed: DIAGONALS.map(|diagonal| diagonal.dot(dir)),
            diagonals: if skips_nothing(dir, pad) { 0 } else { DIAGONALS.len() },
        }
    }

    fn around(bounds: &Aabb, boxes: &[Aabb], some: &[u32]) -> Self {
        let all = some.par_iter().with_min_len(1 << 12).filter(|&&index| index != NONE);
        let spans = all.map(|&index| spans(&boxes[index as usize])).reduce(|| EMPTY, both);
        let sides = spans.map(rounded);
        Self {
            low: bounds.min.to_array(),
            high: bounds.max.to_array(),
            least: sides.map(|[least, _]| least),
            most: sides.map(|[_, most]| most),
        }
    }

    fn form(&self) -> RegionForm {
        RegionForm::Polytope(*self)
    }

    #[inline]
    fn entered(&self, ray: &KDopRay, end: f32) -> Option<f64> {
        let (near, far) = ray.box_ray.interval(&self.bounds());
        let (begin, leave) = (near.max(ray.t_min), far.min(end));
        if begin > leave {
            return None;
        }
        let (mut begin, mut leave) = (f64::from(begin), f64::from(leave));
        for i in 0..ray.diagonals {
            let ([plus, minus], speed) = (ray.origin[i], ray.speed[i]);
            let (low, high) = (f64::from(self.least[i]) - plus, f64::from(self.most[i]) - minus);
            if speed == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return None;
                }
                continue;
            }
            let (a, b) = (low / speed, high / speed);
            begin = begin.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        (begin <= leave).then_some(begin)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::*;
    use super::*;
    use glam::Vec3;

    #[test]
    fn polytopes_hold_the_corners_of_all_boxes_below() {
        assert_volumes_hold_what_is_below(|kdop: &KDop, bounds| {
            let sides = Aabb { min: kdop.low.into(), max: kdop.high.into() };
            sides.union(*bounds) == sides
                && bounds.corners().iter().all(|corner| {
                    (0..4).all(|i| {
                        let along = DIAGONALS[i].dot(Vec3::from(*corner).as_dvec3());
                        f64::from(kdop.least[i]) <= along && along <= f64::from(kdop.most[i])
                    })
                })
        });
    }

    #[test]
    fn what_the_padded_box_accepts_the_polytope_accepts() {
        assert_what_the_box_accepts_the_volume_accepts::<KDop>();
    }

    /// The polytope of one box, cut by a plane across a corner.
    fn cut_cube() -> KDop {
        let cube = Aabb { min: Vec3A::ZERO, max: Vec3A::splat(2.0) };
        let mut kdop = KDop::around(&cube, &[cube], &[0]);
        kdop.most[0] = 5.0;
        kdop
    }

    #[test]
    fn a_cube_with_a_corner_cut_off_has_three_more_edges() {
        let cube = Aabb { min: Vec3A::ZERO, max: Vec3A::splat(2.0) };
        let length = |kdop: &KDop| {
            let edges = kdop.edges();
            (edges.len(), edges.iter().map(|[a, b]| a.distance(*b)).sum::<f64>())
        };
        let (count, total) = length(&KDop::around(&cube, &[cube], &[0]));
        assert!(count == 12 && (total - 24.0).abs() < 1e-6, "{count} {total}");
        // Each of three edges loses 1, and three of the length of a face's diagonal come.
        let (count, total) = length(&cut_cube());
        let expected = 24.0 - 3.0 + 3.0 * 2.0f64.sqrt();
        assert!(count == 15 && (total - expected).abs() < 1e-6, "{count} {total}");
    }

    #[test]
    fn a_ray_enters_through_the_side_that_it_comes_to_last() {
        let kdop = cut_cube();
        let towards = DVec3::splat(-1.0);
        let (t, side) = kdop.entered_from(DVec3::splat(3.0), towards).expect("met");
        assert!((t - (3.0 - 5.0 / 3.0)).abs() < 1e-9 && side == 7, "{t} {side}");
        let (t, side) = kdop.entered_from(DVec3::new(0.5, 0.5, 4.0), DVec3::NEG_Z).expect("met");
        assert_eq!((t, side), (2.0, 5));
        assert_eq!(kdop.entered_from(DVec3::new(1.9, 1.9, 4.0), DVec3::X), None);
        let (near, far) = (DVec3::new(1.9, 1.9, 4.0), DVec3::new(3.0, 1.0, 1.0));
        let (t, _) = kdop.entered_from(near, DVec3::NEG_Z).expect("met");
        assert!((t - 2.8).abs() < 1e-6, "{t}");
        assert_eq!(kdop.entered_from(far, DVec3::Y), None);
    }

    #[test]
    fn a_ray_past_what_lies_aslant_meets_its_box_alone() {
        // Small boxes along a diagonal; the ray crosses a corner of the box around all.
        let boxes: Vec<Aabb> = (0..10)
            .map(|i| Vec3A::splat(i as f32))
            .map(|at| Aabb { min: at, max: at + 0.1 })
            .collect();
        let bounds = boxes.iter().fold(Aabb::EMPTY, |around, one| around.union(*one));
        let kdop = KDop::around(&bounds, &boxes, &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
        let ray = Ray::new(Vec3::new(8.0, 1.0, -1.0), Vec3::Z);
        let box_ray = BoxRay::new(&ray, crate::math::Padding::of_bounds(&bounds));
        let (near, far) = box_ray.interval(&bounds);
        assert!(near <= far);
        assert_eq!(kdop.entered(&KDop::ray(&ray, &box_ray), f32::MAX), None);
        let through = Ray::new(Vec3::new(5.05, 5.05, -1.0), Vec3::Z);
        let box_ray = BoxRay::new(&through, crate::math::Padding::of_bounds(&bounds));
        assert!(kdop.entered(&KDop::ray(&through, &box_ray), f32::MAX).is_some());
    }
}
