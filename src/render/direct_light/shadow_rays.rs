//! Shadow rays to one light, with what light along them would contribute.
//!
//! The rays from sixteen shaded points to their first point of the light come before those to their
//! second. Points of equal number lie in one part of the light, so that rays which follow each
//! other are coherent: they start and end near each other.

use glam::{Mat4, Vec3, Vec4};

use crate::math::Lanes as _;
use crate::math::Ray;
use crate::simd::{Kernel, LANES, Row as _, Simd, dispatch};

use super::light_contribution::LightContribution;
use super::light_points::LanePoints;
use super::light_surface::LightSurface;
use super::shading_lanes::{LaneVectors, ShadingLanes};

/// Rays in the buffer: few enough to stay in a core's cache.
const MAX_RAYS: usize = 4096;

/// Rows in the buffer: enough also where a third of the points do not face the light.
const MAX_ROWS: usize = MAX_RAYS / LANES * 3 / 2;

/// Points of a light that are read at once, for each of sixteen shaded points.
const STEP: usize = 4;

/// The buffer of rays.
pub(super) struct ShadowRays {
    rays: Vec<Ray>,
    rows: Vec<ShadowRow>,
    /// How many of both there are; the buffers are longer.
    ray_count: usize,
    row_count: usize,
}

/// The rays of sixteen shaded points, each to a point of its own: those of the lanes that are lit.
#[derive(Clone, Default)]
pub(super) struct ShadowRow {
    /// The index of their [`ShadingLanes`] in the wave.
    pub(super) lanes: usize,
    /// Whether some of them have highlights.
    pub(super) has_specular: bool,
    pub(super) contribution: LightContribution,
}

/// Sixteen shaded points and the points of a light that their shadow rays go to.
pub(super) struct ShadowSource<'a> {
    pub(super) surface: LightSurface,
    pub(super) lanes: &'a ShadingLanes,
    /// The index of `lanes` in the wave.
    pub(super) index: usize,
    pub(super) points: LanePoints<'a>,
}

impl ShadowRays {
    pub(super) fn new() -> Self {
        const NO_RAY: Ray = Ray { origin: Vec3::ZERO, t_min: 0.0, dir: Vec3::ZERO, t_max: 0.0 };
        Self {
            rays: vec![NO_RAY; MAX_RAYS],
            rows: vec![ShadowRow::default(); MAX_ROWS],
            ray_count: 0,
            row_count: 0,
        }
    }

    pub(super) fn rays(&self) -> &[Ray] {
        &self.rays[..self.ray_count]
    }

    /// The rows of the rays, in the order of the rays.
    pub(super) fn rows(&self) -> &[ShadowRow] {
        &self.rows[..self.row_count]
    }

    pub(super) fn clear(&mut self) {
        (self.ray_count, self.row_count) = (0, 0);
    }

    /// Whether there may be no room for another [`STEP`] rows.
    pub(super) fn is_full(&self) -> bool {
        self.ray_count + STEP * LANES > self.rays.len() || self.row_count + STEP > self.rows.len()
    }

    /// Appends the rays to the light's points from number `first` on, until there are no more or
    /// the buffer is full. Returns the number of the first point that is left.
    pub(super) fn append(&mut self, source: &ShadowSource<'_>, first: usize) -> usize {
        dispatch(Append { buffer: self, source, first })
    }
}

struct Append<'a> {
    buffer: &'a mut ShadowRays,
    source: &'a ShadowSource<'a>,
    first: usize,
}

impl Kernel for Append<'_> {
    type Output = usize;

    #[inline(always)]
    fn run<S: Simd>(self) -> usize {
        let Self { buffer, source, first: mut next } = self;
        let count = source.points[0].len();
        let mut to_light = LaneVectors::default();
        while next < count && !buffer.is_full() {
            let step = (count - next).min(STEP);
            let rows = rows_of::<S>(&source.points, next, step);
            next += step;
            for i in 0..step {
                let [u, v] = [rows[2 * i % 8], rows[(2 * i + 1) % 8]];
                buffer.append_row::<S>(source, u, v, &mut to_light);
            }
        }
        next
    }
}

impl ShadowRays {
    /// Appends the rays to the points at `u`, `v` of the light. `to_light` is overwritten.
    #[inline(always)]
    fn append_row<S: Simd>(
        &mut self,
        source: &ShadowSource<'_>,
        u: S::F16,
        v: S::F16,
        to_light: &mut LaneVectors,
    ) {
        let lanes = source.lanes;
        let row = &mut self.rows[self.row_count];
        (row.lanes, row.has_specular) = (source.index, lanes.has_specular != 0);
        row.contribution.compute::<S>(&source.surface, lanes, u, v, to_light);
        let lit = row.contribution.lit;
        let rays = &mut self.rays[self.ray_count..][..LANES];
        self.ray_count += put_rays(&lanes.ray_starts, to_light, lit, rays);
        self.row_count += usize::from(lit != 0);
    }
}

/// Up to four points of each lane, as rows: u and v of the first, then of the second, …
#[inline(always)]
fn rows_of<S: Simd>(points: &LanePoints<'_>, first: usize, count: usize) -> [S::F16; 2 * STEP] {
    if count == 1 {
        let (mut u, mut v) = ([0.0; LANES], [0.0; LANES]);
        for lane in 0..LANES {
            [u[lane], v[lane]] = points[lane][first];
        }
        let mut rows = [S::F16::splat(0.0); 2 * STEP];
        (rows[0], rows[1]) = (S::F16::load(&u), S::F16::load(&v));
        return rows;
    }
    let mut records = [[0.0; 2 * STEP]; LANES];
    for lane in 0..LANES {
        let points = points[lane][first..first + count].as_flattened();
        if let Some(all) = points.first_chunk() {
            records[lane] = *all;
        } else {
            records[lane][..points.len()].copy_from_slice(points);
        }
    }
    S::F16::of_records(records.each_ref())
}

/// Puts the rays of the lanes of a mask to the front of `rays`, and returns how many there are.
///
/// A ray ends just before the light. It starts off the surface, so its `t_min` is 0.
#[inline(always)]
fn put_rays(starts: &[Vec4; LANES], to_light: &LaneVectors, mask: u32, rays: &mut [Ray]) -> usize {
    let mut count = 0;
    for first in (0..LANES).step_by(4) {
        // Halves of rays as they lie in memory: origin and `t_min`, direction and `t_max`.
        let [x, y, z] = to_light;
        let ends = Mat4::from_cols(
            Vec4::from_slice(&x[first..]),
            Vec4::from_slice(&y[first..]),
            Vec4::from_slice(&z[first..]),
            Vec4::splat(1.0f32.next_down()),
        )
        .transpose();
        for (i, end) in [ends.x_axis, ends.y_axis, ends.z_axis, ends.w_axis].iter().enumerate() {
            let lane = first + i;
            let start = starts[lane];
            rays[count % LANES] =
                Ray { origin: start.truncate(), t_min: start.w, dir: end.truncate(), t_max: end.w };
            count += (mask >> lane & 1) as usize;
        }
    }
    count
}
