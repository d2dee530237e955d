use glam::Vec3;

use super::super::super::node::Child;
use super::super::super::slab_ray::tests::STILL;
use super::*;
use crate::math::{Aabb, BoxRay, Random};
use crate::simd::{Kernel, LARGEST_PACKET as RAYS, PacketKernel, dispatch};

/// Whether the first of some rays, as many as a packet has, make one.
struct Makes<'a>(&'a [Ray; RAYS], Padding);

impl Kernel for Makes<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<S: Simd>(self) -> bool {
        S::in_packets(self)
    }
}

impl PacketKernel for Makes<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<S: Simd, R: Row<N>, const N: usize>(self) -> bool {
        let rays = self.0.first_chunk().expect("the largest packet");
        let mut packet = Packet::<S, R, N>::vacant();
        packet.load(rays, self.1).is_some_and(|(_, fits)| fits || packet.cut(self.1))
    }
}

/// For each child, where each ray of a packet enters and leaves it, and what bounds these.
struct Intervals<'a>(&'a [Ray; RAYS], &'a Node, Padding);

/// The intervals of a kernel in a node: for each child and ray, and for each child.
struct Met {
    rays: usize,
    of_rays: [[[f32; RAYS]; 2]; PACK],
    of_all: [[f32; PACK]; 2],
}

impl Kernel for Intervals<'_> {
    type Output = Option<Met>;

    #[inline(always)]
    fn run<S: Simd>(self) -> Option<Met> {
        S::in_packets(self)
    }
}

impl PacketKernel for Intervals<'_> {
    type Output = Option<Met>;

    #[inline(always)]
    fn run<S: Simd, R: Row<N>, const N: usize>(self) -> Option<Met> {
        let Self(rays, node, padding) = self;
        let rays = rays.first_chunk().expect("the largest packet");
        // Where the opposite rays were.
        let opposite =
            rays.map(|ray| Ray { origin: -ray.origin, dir: -ray.dir, t_min: 2.0, ..ray });
        let mut packet = Packet::<S, R, N>::vacant();
        let _ = packet.load(&opposite, padding);
        let (ends, fits) = packet.load(rays, padding)?;
        if !fits && !packet.cut(padding) {
            return None;
        }
        let of_rays = [[[0.0; RAYS]; 2]; PACK];
        let mut met = Met { rays: N, of_rays, of_all: [[0.0; PACK]; 2] };
        for (lane, [begins, leaves]) in met.of_rays.iter_mut().enumerate() {
            let (begin, leave) = packet.interval(node, lane, ends);
            begin.store(begins.first_chunk_mut().expect("the largest packet"));
            leave.store(leaves.first_chunk_mut().expect("the largest packet"));
        }
        let (begin, leave) = packet.hull_of_node(node, S::F8::splat(ends.largest()));
        begin.store(&mut met.of_all[0]);
        leave.store(&mut met.of_all[1]);
        Some(met)
    }
}

#[test]
fn intervals_of_packets_contain_what_is_accepted() {
    let mut random = Random::new(&[23]);
    let mut accepted = 0;
    for round in 0..5_000 {
        let scale = [1.0, 1e-6, 1e6][round % 3];
        // Few different coordinates, so that rays often run in the planes of boxes.
        let mut point = || {
            Vec3::from_array(std::array::from_fn(|_| scale * (random.below(9) as f32 - 4.0) / 3.0))
        };
        let mut node = Node::EMPTY;
        for lane in 0..PACK {
            let corners = [point().into(), point().into()];
            node.set(lane, Child::node(lane), &Aabb::of_points(corners));
        }
        let padding = Padding::of_bounds(&node.bounds());
        let origins: [Vec3; RAYS] = std::array::from_fn(|_| point());
        let along = round % 3;
        // One octant for all: each ray moves along the axes across by nothing, little or much.
        let signs = STILL.map(|x| x.signum());
        let sides = [signs[random.below(8) as usize], signs[random.below(8) as usize]];
        let rays = origins.map(|origin| {
            let mut dir = Vec3::ZERO;
            dir[along] = 1.0;
            for (axis, side) in [(along + 1) % 3, (along + 2) % 3].into_iter().zip(sides) {
                let across = [STILL[random.below(8) as usize].abs(), 0.3, 0.0];
                dir[axis] = across[random.below(3) as usize].copysign(side);
            }
            Ray { t_min: -f32::MAX, t_max: f32::MAX, ..Ray::new(origin, dir) }
        });
        let met = dispatch(Intervals(&rays, &node, padding)).expect("a packet");
        for (lane, [begins, leaves]) in met.of_rays.iter().enumerate() {
            for (number, ray) in rays.iter().enumerate().take(met.rays) {
                let own = BoxRay::new(ray, padding).interval(&node.child_bounds(lane));
                if own.0 > own.1 {
                    continue;
                }
                accepted += 1;
                let of_ray = (begins[number], leaves[number]);
                let of_all = (met.of_all[0][lane], met.of_all[1][lane]);
                for (begin, leave) in [of_ray, of_all] {
                    assert!(begin <= own.0 && own.1 <= leave, "{ray:?}: {own:?} {begin} {leave}");
                }
            }
        }
    }
    assert!(accepted > 10_000, "{accepted}");
}

fn grid(dir: Vec3) -> [Ray; RAYS] {
    std::array::from_fn(|i| Ray::new(Vec3::new((i / 4) as f32, (i % 4) as f32, 0.5), dir))
}

#[test]
fn rays_along_an_axis_make_packets() {
    for largest in [1e-6, 1.0, 1e6] {
        let padding = Padding { largest, factor: 1.0 };
        for (axis, along) in [1.0, -1.0, 0.01].into_iter().flat_map(|x| [0, 1, 2].map(|a| (a, x))) {
            for (a, b) in STILL.into_iter().flat_map(|a| STILL.map(|b| (a, b))) {
                let mut dir = Vec3::ZERO;
                dir[axis] = along;
                dir[(axis + 1) % 3] = a;
                dir[(axis + 2) % 3] = b;
                assert!(dispatch(Makes(&grid(dir), padding)), "{dir}");
            }
        }
    }
}

#[test]
fn rays_without_terms_make_none() {
    let padding = Padding { largest: 1.0, factor: 1.0 };
    let makes = |change: fn(&mut Ray)| {
        let mut rays = grid(Vec3::X);
        change(&mut rays[5]);
        dispatch(Makes(&rays, padding))
    };
    assert!(makes(|_| ()));
    assert!(makes(|ray| ray.dir.y = 0.5), "of the same octant");
    assert!(!makes(|ray| ray.dir.y = -0.0), "of another octant");
    assert!(!makes(|ray| ray.dir.x = 0.0));
    assert!(!makes(|ray| ray.dir.x = 1e-35));
    assert!(!makes(|ray| ray.dir.y = f32::NAN));
    assert!(!makes(|ray| ray.dir.y = f32::INFINITY));
    assert!(!makes(|ray| ray.dir = Vec3::INFINITY));
    assert!(!makes(|ray| ray.origin.y = f32::NAN));
    assert!(!makes(|ray| ray.origin.y = 1e30));
    assert!(!makes(|ray| ray.t_max = f32::NAN));
}
