//! The triangles of a mesh, eight to a pack, as structures offer them.

mod bounds;
mod pack;
mod save;

use std::ops::Range;

use glam::{DVec3, Vec3, Vec3A, Vec4};
use rayon::prelude::*;

use crate::accel::{
    Bounded, IntoPrimitives as _, PACK, PackHits, Packs, Primitives, Query, Search, in_32_bits,
};
use crate::counters::Counters;
use crate::math::slab::not_before;
use crate::math::{Aabb, BoxRay, Hit, Lanes, Lanes3, Mask as _, NONE, Padding, Ray, ones, within};
use crate::simd::{Cache, Row, Simd, prefetch};

use self::pack::{PRIM, Pack, load3, pack};
use super::triangle::{flat_hit, scaled_hit};
use super::triangle_mesh::extent::mean_and_bounds;
use super::{MeshError, Triangle, TriangleMesh, TriangleRay, TriangleRays};

/// Lanes that a ray alone is tested with.
const LANES: usize = 4;

/// Triangles in slot order. Hits have object 0; `prim` is the index of the triangle in the mesh.
#[derive(Clone, Debug)]
pub struct TriangleSet {
    packs: Vec<Pack>,
    /// Whether each triangle stands in the slot of its index, and in no other.
    in_mesh_order: bool,
    count: u32,
    mean_vertex: Vec3A,
    padding: Padding,
}

/// Four lanes of a pack: what rays that come one by one are tested with.
#[derive(Clone, Copy)]
struct Half<'a> {
    pack: &'a Pack,
    /// The first of the lanes: 0 or 4.
    first: usize,
}

/// What a pack offers a ray: lanes whose triangle is hit at an acceptable `t`, before their boxes are tested.
struct Candidates {
    t: Vec4,
    u: Vec4,
    v: Vec4,
    det: Vec4,
    lanes: u32,
}

impl TriangleSet {
    /// The triangles of a mesh in its order. A structure that is built over a [`TriangleMesh`] puts them into packs
    /// only once.
    ///
    /// # Panics
    /// With the message of the error, where [`try_new`](Self::try_new) gives one.
    #[must_use]
    pub fn new(positions: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        Self::try_new(positions, triangles).unwrap_or_else(|error| panic!("{error}"))
    }

    /// The triangles of a mesh in its order, if they can be traced.
    ///
    /// # Errors
    /// As of [`TriangleMesh::try_new`].
    pub fn try_new(positions: &[Vec3], triangles: &[[u32; 3]]) -> Result<Self, MeshError> {
        Ok(TriangleMesh::try_new(positions, triangles)?.into_primitives(None))
    }

    /// Those of a mesh: `triangle` of a slot is the triangle there, and its index in the mesh; none leaves it empty.
    /// `in_mesh_order` is whether that is the index of the slot.
    pub(super) fn of_mesh(
        mesh: &TriangleMesh<'_>,
        in_mesh_order: bool,
        slots: usize,
        triangle: impl Fn(usize) -> Option<(Triangle, u32)> + Sync + Send,
    ) -> Self {
        Self {
            packs: pack(slots, triangle),
            in_mesh_order,
            count: mesh.count(),
            mean_vertex: mesh.mean_point(),
            padding: mesh.padding(),
        }
    }

    /// With the padding of the box around it; an error if that is out of the range of triangles.
    fn padded(mut self) -> Result<Self, MeshError> {
        let bounds = self.total_bounds();
        if let Some(error) = MeshError::of_bounds(&bounds) {
            return Err(error);
        }
        self.padding = Padding::of_bounds(&bounds);
        Ok(self)
    }

    /// Moves the triangles, in whatever order they stand: the same triangles of the mesh, with its vertices elsewhere.
    /// [`settle`](Self::settle) is to follow.
    ///
    /// # Errors
    /// As of [`try_new`](Self::try_new), without the range, or that there are not as many triangles; whether they are
    /// the same ones is not looked at. Then nothing has moved.
    pub fn move_to(&mut self, positions: &[Vec3], triangles: &[[u32; 3]]) -> Result<(), MeshError> {
        let extent = mean_and_bounds(positions, triangles);
        let (mean_vertex, _) = extent.ok_or_else(|| MeshError::of_first(positions, triangles))?;
        if triangles.len() != self.count as usize {
            let before = self.count as usize;
            return Err(MeshError::OtherTriangles { triangles: triangles.len(), before });
        }
        self.packs.par_iter_mut().with_min_len(1 << 9).for_each(|pack| {
            for lane in 0..PACK {
                let prim = pack.rows[PRIM][lane];
                if let Some(corners) = triangles.get(prim as usize) {
                    pack.set(lane, &Triangle::of_mesh(positions, corners), prim);
                }
            }
        });
        self.mean_vertex = mean_vertex;
        Ok(())
    }

    /// Takes note of the box around all triangles after they were moved.
    ///
    /// # Errors
    /// If it is out of the range of triangles, or if it is empty or not finite and there are triangles.
    pub fn settle(&mut self, bounds: &Aabb) -> Result<(), MeshError> {
        // An empty box is not told from one with a NaN.
        if bounds.is_empty() && self.count > 0 {
            let Aabb { min, max } = bounds;
            let largest = min.abs().max(max.abs()).max_element();
            return Err(MeshError::OutOfRange { largest, side: bounds.size().max_element() });
        }
        if let Some(error) = MeshError::of_bounds(bounds) {
            return Err(error);
        }
        self.padding = Padding::of_bounds(bounds);
        Ok(())
    }

    /// How many triangles there are, copies not counted.
    #[must_use]
    pub fn triangle_count(&self) -> u32 {
        self.count
    }

    /// Bytes of the packed triangles, copies in several slots included.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        (self.packs.capacity() * size_of::<Pack>()) as u64
    }

    /// The corners of the triangle in a slot, in double precision.
    pub(super) fn corners(&self, slot: u32) -> [DVec3; 3] {
        self.slot(slot).0.corners.map(|corner| corner.as_dvec3())
    }

    /// The index in the mesh of the triangle in a slot.
    pub(super) fn prim(&self, slot: u32) -> u32 {
        self.slot(slot).1
    }

    fn slot(&self, slot: u32) -> (Triangle, u32) {
        let (pack, lane) = (&self.packs[slot as usize / PACK], slot as usize % PACK);
        (pack.triangle(lane), pack.rows[PRIM][lane])
    }

    /// Calls `test` with each half of a pack that holds some of the slots, and a mask of their lanes,
    /// until it returns true.
    #[inline(always)]
    fn any_half(&self, slots: Range<u32>, mut test: impl FnMut(Half<'_>, u32) -> bool) -> bool {
        let (start, end) = (slots.start as usize, slots.end as usize);
        (start / LANES..end.div_ceil(LANES)).any(|i| {
            let first = i * LANES;
            let from = start.saturating_sub(first).min(LANES);
            let to = (end - first).min(LANES);
            let mask = (1u32 << to) - (1u32 << from);
            test(Half { pack: &self.packs[i / 2], first: i % 2 * LANES }, mask)
        })
    }
}

impl Bounded for TriangleSet {
    // Of the corners, which are finite wherever they come from.
    const SOUND_BOXES: bool = true;

    fn count(&self) -> u32 {
        self.count
    }

    #[inline]
    fn bounds(&self, index: u32) -> Aabb {
        self.slot(index).0.bounds()
    }

    #[inline(always)]
    fn bounds_of_eight<S: Simd>(&self, first: u32, rows: &mut [[f32; 8]; PACK]) {
        let [[a, b, c], [d, e, f]] = self.boxes::<S>(first as usize / PACK);
        let corners = S::transpose_eight([a, b, c, a, d, e, f, d]);
        for lane in 0..PACK {
            corners[lane].store(&mut rows[lane]);
        }
    }

    fn clipped_bounds(&self, index: u32, to: &Aabb) -> Aabb {
        self.slot(index).0.clipped_bounds(to)
    }

    fn mean_point(&self) -> Vec3A {
        self.mean_vertex
    }

    fn total_bounds(&self) -> Aabb {
        bounds::bounds_of(self)
    }
}

impl Primitives for TriangleSet {
    type Packs = Self;

    fn packs(&self) -> &Self {
        self
    }

    fn padding(&self) -> Padding {
        self.padding
    }

    fn slots(&self) -> u32 {
        in_32_bits(self.packs.len() * PACK)
    }

    /// # Panics
    /// If `order` names a slot that there is not.
    fn reorder(&mut self, order: &[u32]) {
        let slots = self.packs.len() * PACK;
        let from = |slot: usize| order.get(slot).filter(|&&from| from != NONE);
        self.packs = pack(order.len(), |slot| {
            // Triangles come from all over the mesh: what is two packs ahead is on its way meanwhile.
            if let Some(&ahead) = from(slot + 2 * PACK)
                && let Some(pack) = self.packs.get(ahead as usize / PACK)
            {
                prefetch(pack, Cache::First);
            }
            from(slot).map(|&from| {
                assert!(
                    (from as usize) < slots,
                    "the order names slot {from}, and there are {slots}, counted from 0"
                );
                self.slot(from)
            })
        });
        self.in_mesh_order = false;
    }

    fn close_ranks(&mut self) {
        if self.in_mesh_order {
            return;
        }
        let mut order = vec![NONE; self.count as usize];
        for (pack, first) in self.packs.iter().zip((0..).step_by(PACK)) {
            for (&prim, slot) in pack.rows[PRIM].iter().zip(first..) {
                if let Some(place) = order.get_mut(prim as usize) {
                    *place = slot;
                }
            }
        }
        if let Some(lost) = order.iter().position(|&slot| slot == NONE) {
            panic!("triangle {lost} of the mesh is in no slot: an order has left it out");
        }
        self.reorder(&order);
        self.in_mesh_order = true;
    }

    #[inline]
    fn test<Q: Query, C: Counters>(
        &self,
        query: &Q,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        answer: &mut Q::Answer,
        counters: &mut C,
    ) {
        counters.primitives(slots.len() as u32);
        let of_triangles = TriangleRay::new(ray, &box_ray.inv_dir.to_array());
        self.any_half(slots, |half, mask| {
            let end = query.end(ray, answer);
            let candidates = half.candidates(ray, &of_triangles, end, mask);
            candidates.lanes != 0 && half.record(query, &candidates, ray, box_ray, answer)
        });
    }
}

impl Packs for TriangleSet {
    const GRAIN: u32 = LANES as u32;

    type Ray = TriangleRay;
    type Rays<R: Lanes> = TriangleRays<R>;

    #[inline(always)]
    fn ray(ray: &Ray, inv_dir: &[f32; 3]) -> TriangleRay {
        TriangleRay::new(ray, inv_dir)
    }

    #[inline(always)]
    fn eight_rays<S: Simd>(
        origin: &Lanes3<S::F8>,
        dir: &Lanes3<S::F8>,
        inv_dir: &Lanes3<S::F8>,
        rays: &mut [TriangleRay; PACK],
    ) {
        TriangleRay::eight::<S>(origin, dir, inv_dir, rays);
    }

    #[inline(always)]
    fn rays<R: Lanes>(origin: &Lanes3<R>, dir: &Lanes3<R>, inv_dir: &Lanes3<R>) -> TriangleRays<R> {
        TriangleRays::new(origin, dir, inv_dir)
    }

    #[inline(always)]
    fn test_pack<S: Simd>(&self, pack: usize, ray: &TriangleRay) -> PackHits<S::F8> {
        let (rows, axes) = (&self.packs[pack].rows, ray.rows());
        let corners = [
            load3::<S>(rows, axes),
            load3::<S>(rows, [axes[0] + 3, axes[1] + 3, axes[2] + 3]),
            load3::<S>(rows, [axes[0] + 6, axes[1] + 6, axes[2] + 6]),
        ];
        scaled_hit(&ray.splat(), corners)
    }

    #[inline(always)]
    fn test_lane<R: Lanes>(&self, pack: usize, lane: usize, rays: &TriangleRays<R>) -> PackHits<R> {
        let pack = &self.packs[pack];
        rays.scaled_hit(|corner, axis| pack.coordinate(corner, axis as usize, lane))
    }

    // Cold: else the kernels keep their rows in memory for a call in the midst of them, which hardly ever comes.
    #[cold]
    #[inline(never)]
    fn flat_hit(&self, pack: usize, lane: usize, ray: &Ray) -> [f32; 3] {
        flat_hit(ray, self.packs[pack].triangle(lane).corners)
    }

    #[inline(always)]
    fn boxes<S: Simd>(&self, pack: usize) -> [Lanes3<S::F8>; 2] {
        let rows = &self.packs[pack].rows;
        let (mut low, b, c) =
            (load3::<S>(rows, [0, 1, 2]), load3::<S>(rows, [3, 4, 5]), load3::<S>(rows, [6, 7, 8]));
        let mut high = low;
        for axis in 0..3 {
            low[axis] = low[axis].min(b[axis]).min(c[axis]);
            high[axis] = high[axis].max(b[axis]).max(c[axis]);
        }
        [low, high]
    }

    #[inline(always)]
    fn prefetch(&self, pack: usize, into: Cache) {
        prefetch(&self.packs[pack], into);
    }

    fn bytes(&self) -> u64 {
        self.bytes()
    }

    #[inline(always)]
    fn id(&self, pack: usize, lane: usize) -> u32 {
        self.packs[pack].rows[PRIM][lane % PACK]
    }
}

impl Half<'_> {
    /// Four lanes of a corner, its axes in the order of a ray's.
    #[inline(always)]
    fn corner(&self, number: usize, axes: [usize; 3]) -> Lanes3<Vec4> {
        axes.map(|axis| {
            // 0 or 4, which the compiler sees here, so that four lanes are one load.
            let half = &self.pack.rows[3 * number + axis][self.first & LANES..];
            Vec4::load_bits(half.first_chunk().expect("a row has two halves"))
        })
    }

    #[inline(always)]
    fn candidates(&self, ray: &Ray, of_triangles: &TriangleRay, end: f32, mask: u32) -> Candidates {
        let axes = of_triangles.rows();
        let corners = [self.corner(0, axes), self.corner(1, axes), self.corner(2, axes)];
        let mut hits = scaled_hit(&of_triangles.splat(), corners);
        for lane in ones(hits.flat() & mask) {
            let corners = self.pack.triangle(self.first + lane).corners;
            hits.replace(lane, flat_hit(ray, corners));
        }
        let t = hits.t / hits.scale;
        let in_reach = within(t, [Vec4::splat(ray.t_min), Vec4::splat(end)]);
        let lanes = (hits.inside & in_reach).bits() & mask;
        Candidates { t, u: hits.u, v: hits.v, det: hits.scale, lanes }
    }

    /// Records the candidates that count. Returns whether the search is over.
    #[inline]
    fn record<Q: Query>(
        &self,
        query: &Q,
        candidates: &Candidates,
        ray: &Ray,
        box_ray: &BoxRay,
        answer: &mut Q::Answer,
    ) -> bool {
        for lane in ones(candidates.lanes) {
            let (t, det) = (candidates.t[lane], candidates.det[lane]);
            // What another lane has cut off meanwhile need not be looked at.
            let end = query.end(ray, answer);
            let Some(begin) = box_ray.begin(&self.bounds(lane), [ray.t_min, end]) else { continue };
            let hit = Hit {
                t: not_before(t, begin),
                object: 0,
                prim: self.pack.rows[PRIM][self.first + lane],
                u: candidates.u[lane] / det,
                v: candidates.v[lane] / det,
            };
            if t <= end && (!Q::FILTERS || query.accepts(ray, &hit)) {
                query.record(answer, &hit);
                if const { matches!(Q::SEARCH, Search::First) } {
                    return true;
                }
            }
        }
        false
    }

    #[inline(always)]
    fn bounds(&self, lane: usize) -> Aabb {
        self.pack.triangle(self.first + lane).bounds()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::{Kernel, dispatch};

    const POSITIONS: [Vec3; 4] = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];

    struct Eight<'a>(&'a TriangleSet, u32);

    impl Kernel for Eight<'_> {
        type Output = [[f32; 8]; PACK];

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let mut rows = [[0.0; 8]; PACK];
            self.0.bounds_of_eight::<S>(self.1, &mut rows);
            rows
        }
    }

    #[test]
    fn eight_boxes_are_those_one_by_one() {
        let at = |i: u32| Vec3::new(i as f32, 7.0 - i as f32, (i % 5) as f32 - 2.0);
        let positions: Vec<_> = (0..30).map(at).collect();
        let triangles: Vec<_> = (0..27).map(|i| [i + 1, i, i + 2]).collect();
        let set = TriangleSet::new(&positions, &triangles);
        for first in (0..27).step_by(PACK) {
            let rows = dispatch(Eight(&set, first));
            for (index, [a, b, c, _, d, e, f, _]) in (first..27).zip(rows) {
                let expected = Aabb { min: Vec3A::new(a, b, c), max: Vec3A::new(d, e, f) };
                assert_eq!(set.bounds(index), expected);
            }
        }
    }

    #[test]
    fn vertices_without_triangles_do_not_count() {
        let far = Vec3::splat(1e6);
        let positions = [far, Vec3::ZERO, Vec3::X, Vec3::ONE, Vec3::Y, far];
        let set = TriangleSet::new(&positions, &[[1, 2, 3], [1, 3, 4]]);
        assert_eq!(set.mean_point(), Vec3A::new(0.5, 0.5, 0.25));
        assert_eq!(set.total_bounds().max, Vec3A::ONE);
        assert_eq!(TriangleSet::new(&positions, &[]).mean_point(), Vec3A::ZERO);
    }

    #[test]
    #[should_panic(expected = "triangle 1 of the mesh is in no slot")]
    fn what_an_order_has_left_out_is_not_built_over() {
        let mut set = TriangleSet::new(&POSITIONS, &[[0, 1, 2], [1, 2, 3]]);
        set.reorder(&[0, NONE, 0]);
        set.close_ranks();
    }

    #[test]
    #[should_panic(expected = "the order names slot 8, and there are 8, counted from 0")]
    fn an_order_names_slots_that_there_are() {
        TriangleSet::new(&POSITIONS, &[[0, 1, 2], [1, 2, 3]]).reorder(&[1, 0, 8]);
    }

    #[test]
    fn triangles_do_not_settle_in_a_box_that_is_none() {
        let mut set = TriangleSet::new(&POSITIONS, &[[0, 1, 2]]);
        let half = Aabb { min: Vec3A::ZERO, max: Vec3A::new(1.0, f32::NAN, 1.0) };
        for bounds in [half, Aabb::EMPTY, Aabb { min: Vec3A::ONE, max: Vec3A::ZERO }] {
            let error = set.settle(&bounds).unwrap_err();
            assert!(matches!(error, MeshError::OutOfRange { .. }), "{error}");
        }
        assert_eq!(TriangleSet::new(&[], &[]).settle(&Aabb::EMPTY), Ok(()));
    }
}
