//! A ray as the slab test of wide nodes sees it.

use glam::Vec3A;

use crate::math::{BoxRay, Lanes, Mask as _, Padding, Ray};
use crate::simd::Simd;

/// Width times inverse direction up to which the products below stay far from overflow. Beyond it
/// an axis is one along which the ray hardly moves, or not at all: see [`SlabRay::cut`].
///
/// No terms serve where an inverse direction is 0, as that of an infinite direction: its product with the infinite
/// planes of a child that is not there is no number, and the ray would enter it.
pub(super) const LARGEST_PRODUCT: f32 = 1e37;

/// The product that takes the place of those beyond.
pub(super) const CUT_PRODUCT: f32 = 1e36;

/// The widths, and the parameters of hits, up to which it serves. Rays that go farther are walked
/// one by one.
pub(super) const FARTHEST: f32 = 1e28;

/// Four units of rounding: the fused form is off by at most three of them.
pub(super) const SLACK: f32 = 4.0 * (f32::EPSILON / 2.0);

/// What the near and the far planes of boxes are measured from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sides {
    pub(super) near: Vec3A,
    pub(super) far: Vec3A,
    /// A bit for each axis along which the ray runs backwards.
    pub(super) octant: u32,
}

impl Sides {
    #[inline(always)]
    pub(super) fn of(box_ray: &BoxRay) -> Self {
        let backwards = box_ray.inv_dir.cmplt(Vec3A::ZERO);
        Self {
            near: Vec3A::select(backwards, box_ray.origin_minus, box_ray.origin_plus),
            far: Vec3A::select(backwards, box_ray.origin_plus, box_ray.origin_minus),
            octant: backwards.bitmask(),
        }
    }
}

/// The terms of the slab test `plane·inv_dir − offset`.
///
/// Where an instruction set fuses product and difference, the test is one operation a plane, and
/// its result differs from [`BoxRay::interval`]'s. The offsets hold a slack that makes the interval
/// wider, for every plane within reach. With `w` the largest distance of a plane from the padded
/// origin and `u` a unit of rounding, `BoxRay` rounds `(plane − origin)·inv_dir` from a value that
/// is off by at most `u·w·|inv_dir|`; the offset here is off by `2u·w·|inv_dir|`; both end in one
/// monotone rounding. So `4u·w·|inv_dir|`, and the smallest normal number against underflow, cover
/// the difference.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlabRay {
    pub(super) inv_dir: Vec3A,
    /// Offsets of the near planes.
    pub(super) near: Vec3A,
    /// Offsets of the far planes.
    pub(super) far: Vec3A,
    /// A bit for each axis along which the ray runs backwards.
    pub(super) octant: u32,
}

impl SlabRay {
    /// In a place without a ray.
    pub(super) const VACANT: Self =
        Self { inv_dir: Vec3A::ZERO, near: Vec3A::ZERO, far: Vec3A::ZERO, octant: 0 };

    /// The terms of a usual ray, or `None` if it hardly moves along some axis, or infinitely fast.
    #[inline(always)]
    pub(super) fn new<S: Simd>(ray: &Ray, box_ray: &BoxRay, padding: Padding) -> Option<Self> {
        let (terms, reach, octant) = Self::usual_terms(ray, box_ray, padding);
        let product = reach * terms.inv_dir.abs();
        let moves = Vec3A::ZERO.cmplt(terms.inv_dir.abs());
        let usual = product.cmple(Vec3A::splat(LARGEST_PRODUCT)) & moves;
        usual.all().then(|| Self::of_terms::<S>(terms, product, octant))
    }

    /// The usual terms of a ray, or else those of one that hardly moves along some axes, or `None`.
    #[inline(always)]
    pub(super) fn any<S: Simd>(ray: &Ray, box_ray: &BoxRay, padding: Padding) -> Option<Self> {
        Self::new::<S>(ray, box_ray, padding).or_else(|| Self::cut::<S>(ray, box_ray, padding))
    }

    /// The terms of a ray that hardly moves along some axes, or `None` if it moves too little or is
    /// too far away.
    #[cold]
    #[inline(never)]
    pub(super) fn cut<S: Simd>(ray: &Ray, box_ray: &BoxRay, padding: Padding) -> Option<Self> {
        let (terms, reach, octant) = Self::usual_terms(ray, box_ray, padding);
        let cut = terms.cut(reach);
        let taken = cut.bounded == 0b111 && cut.gives_bound != 0;
        taken.then(|| Self::of_terms::<S>(cut.terms, cut.product, octant))
    }

    /// The terms of [`BoxRay`], an axis in each lane; the largest distances of planes; the octant.
    #[inline(always)]
    fn usual_terms(
        ray: &Ray,
        box_ray: &BoxRay,
        padding: Padding,
    ) -> (SlabTerms<Vec3A>, Vec3A, u32) {
        let Sides { near, far, octant } = Sides::of(box_ray);
        let reach = padding.reach(Vec3A::from(ray.origin), Vec3A::splat(box_ray.pad));
        (SlabTerms { inv_dir: box_ray.inv_dir, near, far }, reach, octant)
    }

    #[inline(always)]
    fn of_terms<S: Simd>(terms: SlabTerms<Vec3A>, product: Vec3A, octant: u32) -> Self {
        let (near, far) = terms.offsets::<S>(product);
        Self { inv_dir: terms.inv_dir, near, far, octant }
    }
}

/// Terms of the slab test: of one axis for a ray in each lane, or of one ray for an axis in each.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlabTerms<L> {
    pub(super) inv_dir: L,
    /// What near planes are measured from.
    pub(super) near: L,
    /// What far planes are measured from.
    pub(super) far: L,
}

/// Terms that serve where a ray hardly moves, or not at all.
pub(super) struct CutTerms<L> {
    pub(super) terms: SlabTerms<L>,
    /// Reach times inverse direction.
    pub(super) product: L,
    /// Bits of the lanes whose terms serve, if an axis of the ray gives a bound on |t|.
    pub(super) bounded: u32,
    /// Bits of the lanes that give such a bound.
    pub(super) gives_bound: u32,
}

impl<L: Lanes> SlabTerms<L> {
    /// What [`Row::slab`](crate::simd::Row::slab) takes for near and for far planes: origins, or
    /// offsets with a slack where the instruction set fuses. `product` is the reach times the inverse
    /// direction.
    #[inline(always)]
    pub(super) fn offsets<S: Simd>(&self, product: L) -> (L, L) {
        self.offsets_with::<S>(Self::slack(product))
    }

    /// By how much the fused form may be off: `product` is the reach times the inverse direction.
    #[inline(always)]
    pub(super) fn slack(product: L) -> L {
        product * L::splat(SLACK) + L::splat(f32::MIN_POSITIVE)
    }

    /// [`offsets`](Self::offsets) with a slack that is known.
    #[inline(always)]
    pub(super) fn offsets_with<S: Simd>(&self, slack: L) -> (L, L) {
        if !S::FUSES {
            return (self.near, self.far);
        }
        (self.near * self.inv_dir + slack, self.far * self.inv_dir - slack)
    }

    /// The terms with those lanes replaced in which the ray hardly moves.
    ///
    /// On these a smaller inverse direction `±C/w` will do, with origins that are `4u·w` farther out;
    /// `w` is the reach. With `C`, `F` and `L` for [`CUT_PRODUCT`], [`FARTHEST`] and
    /// [`LARGEST_PRODUCT`]: one axis has a product `w·|inv_dir|` of at most `F`, so `BoxRay` accepts no
    /// `|t|` beyond `1.01·F`. On an axis with a product beyond `L` it accepts `t` behind a near plane
    /// only if `(plane − origin)·inv_dir ≤ t`; say the ray runs forwards, then `plane − origin` is at
    /// most `1.02·w·F/L`, much less than `u·w`. Farther out, and with the rounding of the origin by
    /// `u·w`, the difference is at most `−2.9u·w`, and its product with the smaller inverse at most
    /// `−2.8u·C`. That is less than `−1.01·F`, hence than `t`. Far planes are the mirror image, and
    /// the slack of the fused form has room for a `w` that is larger by `4u·w`.
    #[inline(always)]
    pub(super) fn cut(&self, reach: L) -> CutTerms<L> {
        let Self { inv_dir, near, far } = *self;
        let (farthest, largest) = (L::splat(FARTHEST), L::splat(LARGEST_PRODUCT));
        let of_cut = L::splat(CUT_PRODUCT);
        let product = reach * inv_dir.abs();
        let is_usual = product.le(largest) & L::splat(0.0).lt(inv_dir.abs());
        let still = largest.lt(product).bits();
        let out = (reach * L::splat(SLACK)).flipped_by(inv_dir);
        let terms = Self {
            inv_dir: (of_cut / reach).flipped_by(inv_dir).select(still, inv_dir),
            near: (near + out).select(still, near),
            far: (far - out).select(still, far),
        };
        CutTerms {
            terms,
            product: of_cut.select(still, product),
            bounded: is_usual.bits() | still & reach.le(farthest).bits(),
            gives_bound: product.le(farthest).bits(),
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use glam::Vec3;

    use super::super::node::{Child, Node, WIDTH, near_planes};
    use super::*;
    use crate::math::{Aabb, Random};
    use crate::simd::{Kernel, Row, dispatch, splat3};

    /// Components of directions along which a ray hardly moves, of both signs.
    pub(in crate::accel::bvh8) const STILL: [f32; 8] =
        [0.0, -0.0, 1e-38, -1e-38, 1e-30, -1e-30, 1e-45, -1e-25];

    /// Asks a kernel for the intervals of a ray in the boxes of a node; none if it does not take it.
    struct Intervals<'a>(&'a Ray, &'a Node, Padding);

    impl Kernel for Intervals<'_> {
        type Output = Option<[[f32; WIDTH]; 2]>;

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let Self(ray, node, padding) = self;
            let box_ray = BoxRay::new(ray, padding);
            let slab = SlabRay::any::<S>(ray, &box_ray, padding)?;
            let (begin, end) = node.intervals::<S>(
                near_planes(slab.octant),
                splat3::<S::F8>(slab.inv_dir.to_array()),
                splat3::<S::F8>(slab.near.to_array()),
                splat3::<S::F8>(slab.far.to_array()),
                [S::F8::splat(-f32::MAX), S::F8::splat(f32::MAX)],
            );
            let mut intervals = [[0.0; WIDTH]; 2];
            begin.store(&mut intervals[0]);
            end.store(&mut intervals[1]);
            Some(intervals)
        }
    }

    #[test]
    fn intervals_contain_what_is_accepted_and_hardly_more() {
        let mut random = Random::new(&[17]);
        let (mut accepted, mut beside) = (0, 0);
        for round in 0..100_000 {
            let scale = [1.0, 1e-6, 1e-3, 1e6, 1e15][round % 5];
            // Few different coordinates, so that rays often run in the planes of boxes.
            let mut coordinate = || scale * (random.below(9) as f32 - 4.0) / 3.0;
            let mut node = Node::EMPTY;
            for lane in 0..WIDTH {
                let mut corner = || Vec3A::from_array(std::array::from_fn(|_| coordinate()));
                node.set(lane, Child::node(lane), &Aabb::of_points([corner(), corner()]));
            }
            let padding = Padding::of_bounds(&node.bounds());
            let mut origin = Vec3::from_array(std::array::from_fn(|_| coordinate()));
            let mut dir = Vec3::ZERO;
            let along = random.below(3) as usize;
            for axis in 0..3 {
                dir[axis] = STILL[random.below(8) as usize];
                // Beside the plane by what padding covers, or a few roundings less or more.
                let pads = [0.0, 1.0, -1.0, 1.3, -1.3, 2.0, -2.0, 4.0][random.below(8) as usize];
                let reach = padding.largest + origin.abs().max_element();
                origin[axis] += pads * 16.0 * f32::EPSILON * reach;
                for _ in 0..random.below(3) {
                    origin[axis] = origin[axis].next_up();
                }
                for _ in 0..random.below(3) {
                    origin[axis] = origin[axis].next_down();
                }
            }
            // Short directions have parameters near the farthest.
            dir[along] = scale * [1.0, -1.0, 1e-25, -1e-25][random.below(4) as usize];
            let ray = Ray::new(origin, dir);
            let box_ray = BoxRay::new(&ray, padding);
            let intervals = dispatch(Intervals(&ray, &node, padding)).expect("a ray that is taken");
            for (lane, _) in node.present() {
                let (near, far) = box_ray.interval(&node.child_bounds(lane));
                let (begin, end) = (intervals[0][lane], intervals[1][lane]);
                if near <= far {
                    assert!(begin <= near && far <= end, "{ray:?}: {begin} {near} {far} {end}");
                    accepted += 1;
                }
                let (near, far) = box_ray.widened(1.0).interval(&node.child_bounds(lane));
                if near > far {
                    assert!(begin > end, "{ray:?}: {begin} {end}");
                    beside += 1;
                }
            }
        }
        assert!(accepted > 10_000 && beside > 10_000, "{accepted} {beside}");
    }

    #[test]
    fn rays_without_a_bound_are_not_taken() {
        let mut node = Node::EMPTY;
        node.set(0, Child::node(0), &Aabb::of_points([Vec3A::ZERO, Vec3A::ONE]));
        let padding = Padding::of_bounds(&node.bounds());
        let taken = |origin: Vec3, dir: Vec3| {
            dispatch(Intervals(&Ray::new(origin, dir), &node, padding)).is_some()
        };
        assert!(taken(Vec3::ZERO, Vec3::X));
        assert!(!taken(Vec3::ZERO, Vec3::ZERO), "moves along no axis");
        assert!(!taken(Vec3::ZERO, Vec3::new(1e-35, 0.0, 0.0)), "hardly moves");
        assert!(!taken(Vec3::new(0.0, 1e30, 0.0), Vec3::X), "too far away");
        assert!(!taken(Vec3::new(0.0, f32::NAN, 0.0), Vec3::X), "is nowhere");
        for infinite in [f32::INFINITY, f32::NEG_INFINITY] {
            assert!(!taken(Vec3::ZERO, Vec3::splat(infinite)), "is everywhere at once");
            assert!(!taken(Vec3::ZERO, Vec3::new(0.5, infinite, 0.5)), "is so along an axis");
            assert!(!taken(Vec3::ZERO, Vec3::new(0.0, infinite, 0.5)), "and stays along another");
        }
    }
}
