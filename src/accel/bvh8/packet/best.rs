//! The best hits of a packet so far.

use std::hint::black_box;

use crate::accel::{Query, Search};
use crate::math::{Hit, Mask as _, NONE, Ray, ones};
use crate::simd::Row;

/// The best hits so far: in memory, where those of a single ray can be replaced.
#[repr(C, align(64))]
pub(super) struct Best<const N: usize> {
    t: [f32; N],
    u: [f32; N],
    v: [f32; N],
    /// Words as bits of floats, so that rows of them are chosen as the others are.
    prim: [f32; N],
    /// A bit for each ray that has hit something.
    pub(super) hit: u32,
}

impl<const N: usize> Best<N> {
    /// None yet: the searches end with the rays.
    #[inline(always)]
    pub(super) fn none_before<R: Row<N>>(ends: R) -> Self {
        let prim = [f32::from_bits(NONE); N];
        let mut best = Self { t: [0.0; N], u: [0.0; N], v: [0.0; N], prim, hit: 0 };
        ends.store(&mut best.t);
        best
    }

    /// Where the searches end.
    #[inline(always)]
    pub(super) fn ends<R: Row<N>>(&self) -> R {
        R::load(&self.t)
    }

    /// Where the search of a ray ends.
    #[inline(always)]
    pub(super) fn end(&self, ray: usize) -> f32 {
        self.t[ray % N]
    }

    /// The primitive of a ray's best hit, or none.
    #[inline(always)]
    fn prim(&self, ray: usize) -> u32 {
        self.prim[ray % N].to_bits()
    }

    /// Takes hits of some rays on a primitive, at parameters that are no farther than their best ones, where they are
    /// the better ones.
    #[inline(always)]
    pub(super) fn offer<R: Row<N>>(&mut self, [t, u, v]: [R; 3], prim: u32, mut found: u32) {
        // As if it were other memory, so that rows are read, chosen and written whole. Else the compiler makes masked
        // stores of this, which AMD's processors are slow at with AVX2, and never hand on to loads.
        let before = black_box(&*self);
        let (ends, prims) = (before.ends::<R>(), R::load(&before.prim));
        let (old_u, old_v) = (R::load(&before.u), R::load(&before.v));
        // Equal parameters are rare: the smaller id goes before.
        for ray in ones(ends.le(t).bits() & found) {
            if prim >= self.prim(ray) {
                found &= !(1 << ray);
            }
        }
        t.select(found, ends).store(&mut self.t);
        u.select(found, old_u).store(&mut self.u);
        v.select(found, old_v).store(&mut self.v);
        R::splat(f32::from_bits(prim)).select(found, prims).store(&mut self.prim);
        self.hit |= found;
    }

    /// Takes a hit of a ray, no farther than its best one, if it is the better one.
    #[inline(always)]
    pub(super) fn offer_one(&mut self, ray: usize, hit: &Hit) {
        let ray = ray % N;
        if hit.t < self.t[ray] || hit.prim < self.prim(ray) {
            (self.t[ray], self.u[ray], self.v[ray]) = (hit.t, hit.u, hit.v);
            self.prim[ray] = f32::from_bits(hit.prim);
            self.hit |= 1 << ray;
        }
    }

    /// The answers of all rays.
    #[inline(always)]
    pub(super) fn answer<R: Row<N>, Q: Query>(
        &self,
        query: &Q,
        rays: &[Ray; N],
        answers: &mut [Q::Answer; N],
    ) {
        let mut t = [0.0; N];
        let mut object = [0; N];
        if const { matches!(Q::SEARCH, Search::First) } {
            for (ray, object) in object.iter_mut().enumerate() {
                *object = if self.hit >> ray & 1 != 0 { 0 } else { NONE };
            }
        } else {
            self.ends::<R>().select(self.hit, R::splat(Hit::MISS.t)).store(&mut t);
            for (object, prim) in object.iter_mut().zip(self.prim) {
                *object = if prim.to_bits() == NONE { NONE } else { 0 };
            }
        }
        for (ray, answer) in answers.iter_mut().enumerate() {
            let (prim, object) = (self.prim(ray), object[ray]);
            let found = Hit { t: t[ray], object, prim, u: self.u[ray], v: self.v[ray] };
            *answer = query.of_one(&rays[ray], &found);
        }
    }

    /// The hit of a ray; if there is none, the end of its search is in its place.
    #[inline(always)]
    pub(super) fn of_ray(&self, ray: usize) -> Hit {
        let ray = ray % N;
        Hit { t: self.t[ray], object: 0, prim: self.prim(ray), u: self.u[ray], v: self.v[ray] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;
    use crate::simd::{Kernel, PacketKernel, Simd, dispatch};

    /// Offers hits to all rays at once, and to each of them.
    struct Offer(u64);

    impl Kernel for Offer {
        type Output = [Vec<Hit>; 2];

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            S::in_packets(self)
        }
    }

    impl PacketKernel for Offer {
        type Output = [Vec<Hit>; 2];

        #[inline(always)]
        fn run<S: Simd, R: Row<N>, const N: usize>(self) -> Self::Output {
            let mut random = Random::new(&[79, self.0]);
            let ends = R::splat(3.0);
            let (mut at_once, mut each) =
                (Best::<N>::none_before(ends), Best::<N>::none_before(ends));
            for _ in 0..12 {
                let prim = random.below(5);
                let [mut t, mut u] = [[0.0; N]; 2];
                let mut found = 0;
                for ray in 0..N {
                    // Few parameters, so that many are equal; a hit's coordinates tell the primitive.
                    (t[ray], u[ray]) = (1.0 + random.below(3) as f32, prim as f32);
                    found |= u32::from(t[ray] <= each.end(ray) && random.below(3) > 0) << ray;
                }
                at_once.offer([R::load(&t), R::load(&u), R::load(&t)], prim, found);
                for ray in ones(found) {
                    each.offer_one(ray, &Hit { t: t[ray], object: 0, prim, u: u[ray], v: t[ray] });
                }
                assert_eq!(at_once.hit, each.hit);
            }
            [at_once, each].map(|best| (0..N).map(|ray| best.of_ray(ray)).collect())
        }
    }

    #[test]
    fn the_best_of_each_ray_is_the_first_by_parameter_and_then_by_id() {
        for seed in 0..40 {
            let [at_once, each] = dispatch(Offer(seed));
            assert!(at_once.iter().zip(&each).all(|(a, b)| a.same_bits(b)), "{at_once:?} {each:?}");
            assert!(each.iter().filter(|hit| hit.prim != NONE).all(|hit| hit.u == hit.prim as f32));
        }
    }
}
