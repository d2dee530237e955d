use glam::{Vec3, Vec4};

use super::*;
use crate::math::Random;
use crate::simd::{Kernel, dispatch};

/// Eight rays at once.
struct Eight<'a>(&'a [Ray; PACK], &'a mut [TriangleRay; PACK]);

impl Kernel for Eight<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let [ox, oy, oz, _, dx, dy, dz, _] =
            S::F8::of_records(self.0.each_ref().map(Ray::as_array));
        let one = S::F8::splat(1.0);
        let inv_dir = [one / dx, one / dy, one / dz];
        TriangleRay::eight::<S>(&[ox, oy, oz], &[dx, dy, dz], &inv_dir, self.1);
    }
}

#[test]
fn eight_rays_are_each_what_it_is_alone() {
    let mut random = Random::new(&[29]);
    let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
    for round in 0..1000 {
        let tiny = if round % 4 == 0 { 1e-39 } else { 1.0 };
        let rays: [Ray; PACK] = std::array::from_fn(|_| Ray::new(point(), tiny * point()));
        let mut eight = [TriangleRay::default(); PACK];
        dispatch(Eight(&rays, &mut eight));
        let bits = |ray: &TriangleRay| ray.values.map(f32::to_bits);
        for (ray, of_eight) in rays.iter().zip(&eight) {
            assert_eq!(bits(of_eight), bits(&TriangleRay::from(ray)), "{ray:?}");
        }
    }
}

#[test]
fn the_dominant_axis_comes_last_and_equal_ones_have_an_order() {
    let last = |dir: [f32; 3]| axes(&dir).0[2] as usize;
    assert_eq!(last([-3.0, 2.0, 1.0]), 0);
    assert_eq!(last([0.0, 2.0, -1.0]), 1);
    assert_eq!(last([0.0, 2.0, -2.5]), 2);
    assert_eq!(last([1.0, -1.0, 1.0]), 0);
    assert_eq!(last([0.0, -1.0, 1.0]), 1);
}

fn axes(dir: &[f32; 3]) -> Axes {
    Axes::of_dominant(Axes::dominant(dir))
}

#[test]
fn lanes_have_the_axis_of_each_of_them() {
    let dirs = [[1.0, 1.0, -1.0], [0.5, -1.0, 1.0], [0.0, 0.0, 1e-30], [2.0, -3.0, 1.0f32]];
    let rows = [0, 1, 2].map(|axis| Vec4::from_array(dirs.map(|dir| dir[axis])));
    let of_axes = lanes_by_dominant_axis(rows);
    for (lane, dir) in dirs.into_iter().enumerate() {
        let axis = axes(&dir).0[2] as usize;
        for (other, lanes) in of_axes.into_iter().enumerate() {
            assert_eq!(lanes >> lane & 1 != 0, other == axis, "{dir:?} {other}");
        }
    }
    let inv_dir = rows.map(|row| Vec4::ONE / row);
    let rays = TriangleRays::new(&rows, &rows, &inv_dir);
    let corners = rays.arrange(|corner, axis| [1.0, 2.0, 3.0][axis as usize] + corner as f32);
    let of_formula = rays.scaled_hit(|corner, axis| [1.0, 2.0, 3.0][axis as usize] + corner as f32);
    for (lane, dir) in dirs.into_iter().enumerate() {
        for (number, corner) in corners.iter().enumerate() {
            let point = [1.0, 2.0, 3.0].map(|coordinate| coordinate + number as f32);
            assert_eq!(corner.map(|row| row[lane]), axes(&dir).arrange(&point));
        }
        let ShearedRay { origin, slopes, along } = &rays.sheared;
        let alone = TriangleRay::from(&Ray::new(dir.into(), dir.into())).splat::<f32>();
        assert_eq!(origin.map(|row| row[lane]), alone.origin);
        assert_eq!(slopes.map(|row| row[lane]), alone.slopes);
        assert_eq!(along.map(|row| row[lane]), alone.along);
        let hit = scaled_hit(&alone, corners.map(|corner| corner.map(|row| row[lane])));
        let [t, u, v, scale] = [of_formula.t, of_formula.u, of_formula.v, of_formula.scale];
        assert_eq!([t[lane], u[lane], v[lane], scale[lane]], [hit.t, hit.u, hit.v, hit.scale]);
    }
}
