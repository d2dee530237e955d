//! The root, for eight rays at once, a ray in each lane: every ray visits it, and of rays in all directions about half
//! meet none of its children. These never take a slot.

use crate::accel::PACK;
use crate::math::{Lanes as _, Lanes3, Mask as _};
use crate::simd::{Row as _, Simd, splat3};

use super::super::node::Node;
use super::columns::Columns;

/// The root of a tree.
pub(super) struct Root<'a> {
    pub(super) node: &'a Node,
    /// How many children it has, the first so many.
    pub(super) children: usize,
}

/// What eight rays enter of the root's children.
pub(super) struct Entered<S: Simd> {
    /// For each child where the rays enter it; infinite where they do not.
    pub(super) begins: [S::F8; PACK],
    /// A bit for each ray that enters any.
    pub(super) any: u32,
}

impl<'a> Root<'a> {
    pub(super) fn new(node: &'a Node) -> Self {
        Self { node, children: node.present().count() }
    }

    /// Where rays enter the children, by the terms with which [`Node::intervals`] does: of the two planes of an axis
    /// the one that is met first is the near one.
    #[inline(always)]
    pub(super) fn enter<S: Simd>(&self, rays: &Columns<S>) -> Entered<S> {
        let infinite = S::F8::splat(f32::INFINITY);
        let Columns { inv_dir: [x, y, z], low, high, searched: [t_min, t_max], .. } = rays;
        let mut begins = [infinite; PACK];
        let mut any = 0;
        for (lane, of_child) in begins.iter_mut().enumerate().take(self.children) {
            let [min, max] = self.node.corners(lane);
            let (min, max): (Lanes3<S::F8>, _) = (splat3::<S::F8>(min), splat3::<S::F8>(max));
            let (a, b) = (S::F8::slab(min[0], *x, low[0]), S::F8::slab(max[0], *x, high[0]));
            let (c, d) = (S::F8::slab(min[1], *y, low[1]), S::F8::slab(max[1], *y, high[1]));
            let (e, f) = (S::F8::slab(min[2], *z, low[2]), S::F8::slab(max[2], *z, high[2]));
            let begin = a.min(b).max(c.min(d)).max(e.min(f).max(*t_min));
            let end = a.max(b).min(c.max(d)).min(e.max(f).min(*t_max));
            let entered = begin.le(end);
            any |= entered.bits();
            *of_child = begin.select_where(entered, infinite);
        }
        Entered { begins, any }
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3A;

    use super::*;
    use crate::accel::bvh8::node::{Child, near_planes};
    use crate::accel::bvh8::slab_ray::SlabRay;
    use crate::math::{Aabb, BoxRay, Padding, Random, Ray};
    use crate::simd::{Kernel, dispatch};

    const PADDING: Padding = Padding { largest: 2.0, factor: 1.0 };

    /// Where eight rays enter the children of a node: together, and each by itself.
    struct Enter<'a>(&'a Node, &'a [Ray; PACK]);

    type Begins = [[f32; PACK]; PACK];

    impl Kernel for Enter<'_> {
        type Output = (Begins, u32, Begins);

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let Self(node, rays) = self;
            let (columns, usual) = Columns::<S>::new(&[0, 1, 2, 3, 4, 5, 6, 7], rays, PADDING);
            assert_eq!(usual & 0xFF, 0xFF);
            let entered = Root::new(node).enter::<S>(&columns);
            let begins = S::transpose_eight(entered.begins);
            let (mut together, mut alone) = ([[0.0; PACK]; PACK], [[0.0; PACK]; PACK]);
            for lane in 0..PACK {
                begins[lane].store(&mut together[lane]);
                let ray = &rays[lane];
                let slab = SlabRay::new::<S>(ray, &BoxRay::new(ray, PADDING), PADDING)
                    .expect("it moves along all axes");
                let (begin, end) = node.intervals::<S>(
                    near_planes(slab.octant),
                    splat3::<S::F8>(slab.inv_dir.to_array()),
                    splat3::<S::F8>(slab.near.to_array()),
                    splat3::<S::F8>(slab.far.to_array()),
                    [S::F8::splat(ray.t_min), S::F8::splat(ray.t_max)],
                );
                let met = begin.le(end).bits();
                begin.select(met, S::F8::splat(f32::INFINITY)).store(&mut alone[lane]);
            }
            (together, entered.any, alone)
        }
    }

    #[test]
    fn eight_rays_enter_the_children_that_each_of_them_enters() {
        let mut random = Random::new(&[31]);
        let (mut met, mut alive) = (0, 0);
        for round in 0..2000 {
            let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
            let mut node = Node::EMPTY;
            for lane in 0..1 + round % PACK {
                let bounds = Aabb::of_points([point(), point()]);
                // Some are flat.
                let max = if round % 3 == 0 { bounds.max.with_z(bounds.min.z) } else { bounds.max };
                node.set(lane, Child::node(lane), &Aabb { max, ..bounds });
            }
            node.sort();
            let rays = std::array::from_fn(|_| {
                let (origin, target) = (3.0 * point(), point());
                let (t_min, t_max) = (point().x.max(0.0), 4.0 * (point().x + 0.4));
                Ray::with_interval(origin.into(), (target - origin).into(), t_min, t_max)
            });
            let (together, any, alone) = dispatch(Enter(&node, &rays));
            assert_eq!(together, alone);
            for (lane, begins) in alone.iter().enumerate() {
                let entered = begins.iter().filter(|begin| begin.is_finite()).count();
                assert_eq!(any >> lane & 1 != 0, entered > 0);
                met += entered;
                alive += usize::from(entered > 0);
            }
        }
        assert!(met > alive * 3 / 2 && (3_000..13_000).contains(&alive), "{met} {alive}");
    }
}
