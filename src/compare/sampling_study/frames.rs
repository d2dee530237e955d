//! Small frames with either method of sampling and growing numbers of samples: time and noise.

use std::time::Duration;

use glam::DVec3;

use crate::record::{FramePart, NoisePoint};
use crate::render::{RayClass, Rendering, Sampling, Settings};
use crate::scene::{Light, Scene, TracedWorld};

use crate::compare::budget::Budget;
use crate::compare::clock::timed;
use crate::compare::context::SceneContext;
use crate::compare::picture_size::fit;
use crate::compare::render_picture::{colors, render_until};
use crate::compare::rounds::interleaved;

use super::converged::rmse;
use super::operations::{self, Operation};

/// View samples along each side of a pixel, for each point of the curves.
const SIDES: [u32; 6] = [1, 2, 3, 4, 6, 8];

/// The longer side of the frames in pixels, at least and at most.
const SMALLEST: u32 = 16;
const LARGEST: u32 = 96;

/// Rounds that the size of the frames leaves time for.
const ROUNDS: u32 = 8;

/// The share of a scene's time that these rounds may take.
const SHARE_OF_ROUNDS: f64 = 0.5;

/// A method with a number of samples, and the time and the noise of its frames.
pub(super) struct Frames {
    settings: Settings,
    /// Time in nanoseconds and noise of each frame.
    rounds: Vec<(u64, f64)>,
    /// Surfaces that were hit in the last frame: each takes samples of every area light.
    surfaces: u64,
}

/// The size of a scene's frames, by what a small one takes; `None` if it is cancelled.
pub(super) fn settings(
    context: &SceneContext<'_>,
    tracer: &dyn TracedWorld,
    budget: Budget,
) -> Option<Settings> {
    let picture = context.picture_settings();
    let sized = |side: u32| {
        let [width, height] = fit([picture.width, picture.height], side);
        Settings { width, height, crop: None, count: false, ..picture.clone() }
    };
    let trial = Settings { aa: 2, ..sized(SMALLEST) };
    let time = (0..2)
        .map(|_| render(context, tracer, &trial).map(|rendering| rendering.stats.time))
        .try_fold(Duration::MAX, |least, time| Some(least.min(time?)))?;
    let views = |settings: &Settings| f64::from(settings.width) * f64::from(settings.height);
    let sample = time.as_secs_f64() / (views(&trial) * f64::from(trial.samples_per_pixel()));
    let samples = 2 * ROUNDS * SIDES.iter().map(|side| side * side).sum::<u32>();
    let pixels = SHARE_OF_ROUNDS * budget.left().as_secs_f64() / (f64::from(samples) * sample);
    let largest = sized(LARGEST);
    let longer = f64::from(largest.width.max(largest.height));
    let side = longer * (pixels / views(&largest)).sqrt().min(1.0);
    Some(sized((side as u32).max(SMALLEST)))
}

/// Renders frames of both methods in interleaved rounds; without those that have no whole frame.
pub(super) fn measure(
    context: &SceneContext<'_>,
    tracer: &dyn TracedWorld,
    settings: &Settings,
    converged: &[DVec3],
    budget: Budget,
) -> Vec<Frames> {
    let with = |(sampling, aa)| Frames {
        settings: Settings { aa, sampling, ..settings.clone() },
        rounds: Vec::new(),
        surfaces: 0,
    };
    let each = |sampling| SIDES.map(|side| (sampling, side));
    let mut tasks: Vec<Frames> = Sampling::ALL.into_iter().flat_map(each).map(with).collect();
    let rounds = interleaved(tasks.len(), &context.rounds(budget), |task, _| {
        let settings = &mut tasks[task].settings;
        // The same random numbers for all that run beside each other, others in each round.
        settings.seed = settings.seed.wrapping_add(1);
        let (rendering, round) = timed(|| render(context, tracer, settings));
        let rendering = rendering?;
        tasks[task].surfaces = surfaces(&rendering);
        let picture = colors(rendering.image)?;
        // A frame of milliseconds that another program interrupts would seem many times as long.
        let time = round.cpu_ns.unwrap_or(round.wall_ns);
        Some(((time, rmse(&picture, converged)), time))
    });
    for (task, rounds) in tasks.iter_mut().zip(rounds) {
        task.rounds = rounds;
    }
    tasks.retain(|task| !task.rounds.is_empty());
    tasks
}

/// A whole frame on one thread.
fn render(
    context: &SceneContext<'_>,
    tracer: &dyn TracedWorld,
    settings: &Settings,
) -> Option<Rendering> {
    let work = || render_until(context.cancelled, context.scene, tracer, settings);
    Some(context.pools.one.install(work)).filter(|rendering| rendering.complete)
}

/// How many surfaces were shaded.
fn surfaces(rendering: &Rendering) -> u64 {
    let classes = [RayClass::View, RayClass::Mirror, RayClass::Refraction];
    classes.iter().map(|&class| rendering.stats.class(class).hits).sum()
}

impl Frames {
    /// Its point of the curve.
    pub(super) fn point(&self, scene: &str) -> Option<NoisePoint> {
        let (rounds_ns, rounds_rmse) = self.rounds.iter().copied().unzip();
        (!self.rounds.is_empty()).then(|| NoisePoint {
            scene: scene.to_owned(),
            sampling: self.settings.sampling.name().to_owned(),
            pixel_samples: self.settings.samples_per_pixel(),
            light_samples: self.settings.light_samples.pow(2),
            rounds_ns,
            rounds_rmse,
        })
    }

    /// How often it does what was timed; nothing for other numbers of samples than that.
    pub(super) fn parts(&self, name: &str, scene: &Scene) -> Vec<FramePart> {
        if self.settings.aa != operations::SIDE {
            return Vec::new();
        }
        let pixels = u64::from(self.settings.width) * u64::from(self.settings.height);
        let pixel_samples = self.settings.samples_per_pixel();
        let is_area = |light: &&Light| matches!(light, Light::Area { .. });
        let lights = scene.lights.iter().filter(is_area).count() as u64;
        let points = self.surfaces * lights;
        let mut counts = vec![(Operation::Place, pixels * u64::from(pixel_samples))];
        counts.extend(match self.settings.sampling {
            Sampling::Shuffled => vec![
                (Operation::Shuffle, pixels * lights),
                (Operation::Tables, 1),
                (Operation::Take, points),
            ],
            Sampling::Independent => vec![(Operation::Make, points)],
        });
        let part = |(operation, count): (Operation, u64)| FramePart {
            scene: name.to_owned(),
            sampling: self.settings.sampling.name().to_owned(),
            pixel_samples,
            operation: operation.name(),
            count,
        };
        counts.into_iter().map(part).collect()
    }
}
