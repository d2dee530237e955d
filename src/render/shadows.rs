//! What arrives of a light: the shadow rays of a wave.
//!
//! Sixteen surfaces that follow each other go together, and the rays from all of them to their
//! first point of a light come before those to their second: the points of one number lie in one
//! part of the light, so that rays which follow each other start and end near each other.

use glam::{Mat4, Vec3, Vec4};

use crate::math::{Hit, Ray};
use crate::scene::Light;
use crate::simd::{Kernel, LANES, Row as _, Simd, dispatch, ones};

use super::batch::{Batch, Context, Shaded};
use super::incidence::{Incidence, LightPlane};
use super::receivers::{Receiver, Receivers, Row, Rows3};
use super::{RayClass, Stage};

/// Shadow rays asked together: few enough to stay in a core's cache.
const RAYS_AT_ONCE: usize = 4096;

/// Rows of rays asked together: enough also where a third of the surfaces do not face the light.
const ROWS_AT_ONCE: usize = RAYS_AT_ONCE / LANES * 3 / 2;

/// Points of a light that are taken up together: of sixteen surfaces each.
const STEP: usize = 4;

/// Light that is dimmed below this by what it passes through is gone.
const LEAST_SHARE: f32 = 1.0 / 16_384.0;

/// The buffers of shadow rays.
#[derive(Default)]
pub(super) struct Shadows {
    /// The surfaces of a wave, and how many sixteens of them there are; the buffer is longer.
    receivers: Vec<Receivers>,
    count: usize,
    /// What light sends to each of them.
    sums: Vec<Sums>,
    /// Where light samples are put that are made on the fly, for each lane.
    points: [Vec<[f32; 2]>; LANES],
    sent: Sent,
    blocked: Vec<bool>,
    /// The share of the light that arrives along each ray.
    shares: Vec<f32>,
    walk: Walk,
}

/// Rays to one light, and what light along them would add.
#[derive(Default)]
struct Sent {
    rays: Vec<Ray>,
    rows: Vec<SentRow>,
    /// How many of both there are; the buffers are longer.
    ray_count: usize,
    row_count: usize,
}

/// The rays of sixteen surfaces, each to a point of its own: those of the lanes that it reaches.
#[derive(Clone, Default)]
struct SentRow {
    /// Which of the wave's [`Receivers`], and whether some of them have highlights.
    receivers: usize,
    shines: bool,
    incidence: Incidence,
}

/// Sums over the points of a light, for each of sixteen surfaces.
#[derive(Clone, Copy, Default)]
struct Sums {
    diffuse: Row,
    specular: Row,
}

/// Shadow rays on their way through transparent objects.
#[derive(Default)]
struct Walk {
    rays: Vec<Ray>,
    hits: Vec<Hit>,
    /// Which of the shadow rays each is.
    indices: Vec<u32>,
}

impl Shadows {
    /// Takes up the surfaces of a wave.
    pub(super) fn receive(&mut self, context: &Context<'_>, surfaces: &[Shaded]) {
        let receiver = |shaded: &Shaded| Receiver {
            finish: &context.finishes[shaded.surface.material],
            origin: shaded.origin,
            normal: shaded.surface.normal,
            geometric_normal: shaded.surface.geometric_normal,
            view_dir: shaded.dir,
        };
        self.count = surfaces.len().div_ceil(LANES);
        if self.receivers.len() < self.count {
            self.receivers.resize(self.count, Receivers::NONE);
        }
        for (receivers, surfaces) in self.receivers.iter_mut().zip(surfaces.chunks(LANES)) {
            receivers.lay_out(surfaces.iter().map(receiver));
        }
        self.sent.make_room();
    }

    /// Adds the light of one light to the colours of all surfaces of the wave.
    pub(super) fn add_light(&mut self, context: &Context<'_>, light: usize, batch: &mut Batch) {
        let plane = LightPlane::new(&context.scene.lights[light]);
        self.sums.clear();
        self.sums.resize(self.count, Sums::default());
        let mut buffers = std::mem::take(&mut self.points);
        for index in 0..self.count {
            let first = index * LANES;
            let end = (first + LANES).min(batch.shaded.len());
            let points = points(context, light, batch, &batch.shaded[first..end], &mut buffers);
            let mut point = 0;
            while point < points[0].len() {
                if self.sent.is_full() {
                    self.arrive(context, batch);
                }
                let receivers = &self.receivers[index];
                let sent = &mut self.sent;
                dispatch(Send { plane, receivers, index, points, point: &mut point, sent });
            }
        }
        self.points = buffers;
        self.arrive(context, batch);
        self.add_up(context, light, batch);
        batch.lap(Stage::Shading);
    }

    /// Traces the buffered rays and sums up what arrives.
    fn arrive(&mut self, context: &Context<'_>, batch: &mut Batch) {
        batch.lap(Stage::MakingRays);
        self.find_shares(context, batch);
        let rows = &self.sent.rows[..self.sent.row_count];
        dispatch(Arrive { rows, shares: &self.shares, sums: &mut self.sums });
        (self.sent.ray_count, self.sent.row_count) = (0, 0);
        batch.lap(Stage::Shading);
    }

    /// Adds the sums to the colours.
    fn add_up(&self, context: &Context<'_>, light: usize, batch: &mut Batch) {
        let (samples, color) = match context.scene.lights[light] {
            Light::Point { color, .. } => (1, color),
            Light::Area { color, .. } => (context.light_samples.per_view_sample(), color),
        };
        let color = color / samples as f32;
        for (surfaces, sums) in batch.shaded.chunks(LANES).zip(&self.sums) {
            for (lane, shaded) in surfaces.iter().enumerate() {
                let finish = &context.finishes[shaded.surface.material];
                let mut sent = sums.diffuse[lane] * finish.diffuse;
                if finish.shines {
                    sent += sums.specular[lane] * finish.specular;
                }
                let path = &shaded.path;
                batch.colors[path.sample as usize] += path.weight() * color * sent;
            }
        }
    }

    fn find_shares(&mut self, context: &Context<'_>, batch: &mut Batch) {
        let rays = &self.sent.rays[..self.sent.ray_count];
        self.shares.clear();
        if rays.is_empty() {
            return;
        }
        if context.transparent {
            self.shares.resize(rays.len(), 1.0);
            self.walk.run(context, batch, rays, &mut self.shares);
            return;
        }
        if self.blocked.len() < rays.len() {
            self.blocked.resize(rays.len(), false);
        }
        let blocked = &mut self.blocked[..rays.len()];
        batch.occluded(context, rays, blocked);
        self.shares.extend(blocked.iter().map(|&blocked| f32::from(u8::from(!blocked))));
    }
}

/// The points of a light that up to sixteen surfaces take.
fn points<'a>(
    context: &'a Context<'_>,
    light: usize,
    batch: &Batch,
    surfaces: &[Shaded],
    buffers: &'a mut [Vec<[f32; 2]>; LANES],
) -> [&'a [[f32; 2]]; LANES] {
    let mut points: [&[[f32; 2]]; LANES] = [&[[0.0; 2]]; LANES];
    if let Light::Area { .. } = context.scene.lights[light] {
        let assignment = &batch.assignment[light];
        for ((points, shaded), buffer) in points.iter_mut().zip(surfaces).zip(buffers) {
            let (sample, key) = (shaded.path.sample as usize, shaded.path.key);
            *points = context.light_samples.points(assignment, light, sample, key, buffer);
        }
        // Lanes without a surface take what another takes.
        let first = points[0];
        points[surfaces.len()..].fill(first);
    }
    points
}

impl Sent {
    fn make_room(&mut self) {
        const NO_RAY: Ray = Ray { origin: Vec3::ZERO, t_min: 0.0, dir: Vec3::ZERO, t_max: 0.0 };
        self.rays.resize(RAYS_AT_ONCE, NO_RAY);
        self.rows.resize_with(ROWS_AT_ONCE, SentRow::default);
    }

    /// Whether there may be no room for another [`STEP`] rows.
    fn is_full(&self) -> bool {
        self.ray_count + STEP * LANES > self.rays.len() || self.row_count + STEP > self.rows.len()
    }
}

/// Sends rays from sixteen surfaces to a light, until all are sent or the buffers are full.
struct Send<'a> {
    plane: LightPlane,
    receivers: &'a Receivers,
    index: usize,
    points: [&'a [[f32; 2]]; LANES],
    /// The first of the points that no ray was sent to.
    point: &'a mut usize,
    sent: &'a mut Sent,
}

impl Kernel for Send<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let count = self.points[0].len();
        let mut to_light = Rows3::default();
        while *self.point < count && !self.sent.is_full() {
            let next = (count - *self.point).min(STEP);
            let rows = rows_of::<S>(&self.points, *self.point, next);
            *self.point += next;
            for i in 0..next {
                let row = &mut self.sent.rows[self.sent.row_count];
                (row.receivers, row.shines) = (self.index, self.receivers.shining != 0);
                let [u, v] = [rows[2 * i % 8], rows[(2 * i + 1) % 8]];
                row.incidence.fall::<S>(&self.plane, self.receivers, u, v, &mut to_light);
                let lanes = row.incidence.lanes;
                let rays = &mut self.sent.rays[self.sent.ray_count..][..LANES];
                self.sent.ray_count += put_rays(&self.receivers.starts, &to_light, lanes, rays);
                self.sent.row_count += usize::from(lanes != 0);
            }
        }
    }
}

/// Up to four points of each surface, as rows of u and v for the first, then for the second, …
#[inline(always)]
fn rows_of<S: Simd>(
    points: &[&[[f32; 2]]; LANES],
    first: usize,
    count: usize,
) -> [S::F16; 2 * STEP] {
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
    S::transpose(&records)
}

/// Puts the rays of some lanes to the front, and says how many there are. Only what lies between
/// the surface and the light counts; the surface itself is left behind by where the rays start.
#[inline(always)]
fn put_rays(starts: &[Vec4; LANES], to_light: &Rows3, lanes: u32, rays: &mut [Ray]) -> usize {
    let mut count = 0;
    for first in (0..LANES).step_by(4) {
        // Halves of rays as they lie in memory: origin and beginning, direction and end.
        let [x, y, z] = to_light;
        let ways = Mat4::from_cols(
            Vec4::from_slice(&x[first..]),
            Vec4::from_slice(&y[first..]),
            Vec4::from_slice(&z[first..]),
            Vec4::splat(1.0f32.next_down()),
        )
        .transpose();
        for (i, way) in [ways.x_axis, ways.y_axis, ways.z_axis, ways.w_axis].iter().enumerate() {
            let lane = first + i;
            let start = starts[lane];
            rays[count % LANES] =
                Ray { origin: start.truncate(), t_min: start.w, dir: way.truncate(), t_max: way.w };
            count += (lanes >> lane & 1) as usize;
        }
    }
    count
}

/// Adds what arrives along the rays of some rows to the sums of their surfaces: for each surface
/// point by point, so that no sum depends on the surfaces beside it.
struct Arrive<'a> {
    rows: &'a [SentRow],
    shares: &'a [f32],
    sums: &'a mut [Sums],
}

impl Kernel for Arrive<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let mut rest = self.shares;
        for SentRow { receivers, shines, incidence } in self.rows {
            let (own, behind) = rest.split_at(incidence.lanes.count_ones() as usize);
            rest = behind;
            let mut shares = [0.0; LANES];
            if let Some(all) = own.first_chunk() {
                shares = *all;
            } else {
                for (lane, &share) in ones(incidence.lanes).zip(own) {
                    shares[lane % LANES] = share;
                }
            }
            let shares = S::F16::load(&shares);
            let Sums { diffuse, specular } = &mut self.sums[*receivers];
            let sum = S::F16::load(diffuse) + S::F16::load(&incidence.diffuse) * shares;
            sum.store(diffuse);
            if *shines {
                let sum = S::F16::load(specular) + S::F16::load(&incidence.specular) * shares;
                sum.store(specular);
            }
        }
    }
}

impl Walk {
    /// Follows rays from hit to hit: an opaque object takes all of the light, a transparent one
    /// the share of its opacity. The rays are not bent.
    fn run(&mut self, context: &Context<'_>, batch: &mut Batch, rays: &[Ray], shares: &mut [f32]) {
        self.rays.clear();
        self.rays.extend_from_slice(rays);
        self.indices.clear();
        self.indices.extend(0..rays.len() as u32);
        while !self.rays.is_empty() {
            self.hits.clear();
            self.hits.resize(self.rays.len(), Hit::MISS);
            batch.intersect(context, RayClass::Shadow, &self.rays, &mut self.hits);
            self.dim_and_keep(context, shares);
        }
    }

    /// Dims the rays that hit something, and keeps those that still carry light.
    fn dim_and_keep(&mut self, context: &Context<'_>, shares: &mut [f32]) {
        let mut kept = 0;
        for i in 0..self.rays.len() {
            let hit = self.hits[i];
            if !hit.is_hit() {
                continue;
            }
            let index = self.indices[i];
            let object = &context.scene.objects[hit.object as usize];
            let share = &mut shares[index as usize];
            *share *= context.finishes[object.material].transparency;
            if *share < LEAST_SHARE {
                *share = 0.0;
            } else {
                // The next hit behind this one. On the same ray the same primitive gives the same
                // parameter, so it is not met again.
                self.rays[kept] = Ray { t_min: hit.t.next_up(), ..self.rays[i] };
                self.indices[kept] = index;
                kept += 1;
            }
        }
        self.rays.truncate(kept);
        self.indices.truncate(kept);
    }
}
