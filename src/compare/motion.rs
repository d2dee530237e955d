//! Structures that follow a scene that moves: each is made ready for a frame in several ways, and traces the frame's
//! rays.
//!
//! All that is compared goes through a frame together: first each is made ready, then the recorded rays of a small
//! picture of that frame go through all of them in interleaved rounds, on one thread. Who is first changes from frame
//! to frame and from round to round. The answers of all must be equal, bit for bit, and those of some rays equal to
//! those of no structure at all.

mod pictures;

use crate::accel::{BuildConfig, Quality, Update};
use crate::record::{
    FramePicture, MOTION_VERSION, Motion, MotionRays, Moved, RayClass, Round, Run, Strategy,
    StrategyRecord,
};
use crate::render::Settings;
use crate::scene::{Scene, SceneChange, Structure, TracedWorld, structure_named};

use super::clock::timed;
use super::machine::build_of_program;
use super::observer::Observer;
use super::pools::Pools;
use super::record_rays::{RaySet, rays_of_picture};
use super::trace::trace;
use crate::analysis::statistics::median;
use pictures::{picture_of, shown_frames};

/// Tests of triangles that no structure at all may make in a frame for each class.
const TESTS_OF_NONE: u64 = 40_000_000;

/// Rays of each class that are compared with those of no structure at all in a frame, at most.
const MOST_FOR_NONE: u64 = 2_000;

/// What is compared.
#[derive(Clone, Debug)]
pub struct MotionPlan {
    /// The structures.
    pub structures: Vec<Structure>,
    /// How each is made ready, of what it offers.
    pub strategies: Vec<Strategy>,
    /// The frame that all are built for, and the last one.
    pub frames: [u32; 2],
    /// Threads that build and refit.
    pub threads: usize,
    /// Rounds of the rays of each frame.
    pub rounds: u32,
    /// The most rays of a class in a frame.
    pub rays_per_class: usize,
    /// Width and height of the picture whose rays are recorded.
    pub size: [u32; 2],
    /// The most frames of which a picture is rendered, of that size; none for 0.
    pub pictures: u32,
}

/// What was measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeasuredMotion {
    /// The record.
    pub motion: Motion,
    /// Pictures of some frames, from the first to the last, rendered with the first structure.
    pub pictures: Vec<FramePicture>,
}

/// Why there is no record.
#[derive(Debug, thiserror::Error)]
pub enum MotionError<E> {
    /// A frame of the scene cannot be had.
    #[error("there is no frame {frame}")]
    Frame {
        /// Which one.
        frame: u32,
        /// Why.
        why: E,
    },
    /// A structure cannot be built.
    #[error("`{structure}` in frame {frame}: {text}")]
    Build {
        /// Its name.
        structure: String,
        /// The frame.
        frame: u32,
        /// Why.
        text: String,
    },
    /// A picture cannot be written.
    #[error("the picture of frame {frame}: {text}")]
    Picture {
        /// The frame.
        frame: u32,
        /// Why.
        text: String,
    },
    /// The system grants no threads.
    #[error("cannot start {threads} threads: {text}")]
    Threads {
        /// How many were asked for.
        threads: usize,
        /// Why.
        text: String,
    },
}

/// Measures a sequence; `scene_of` gives the frames, one after the other. If the observer cancels it, the record has
/// the frames that were done.
///
/// # Errors
/// If a frame cannot be had, a structure cannot be built, or a picture cannot be written.
pub fn measure_motion<E>(
    plan: &MotionPlan,
    mut scene_of: impl FnMut(u32) -> Result<Scene, E>,
    observer: &dyn Observer,
) -> Result<MeasuredMotion, MotionError<E>> {
    let pools = Pools::start(plan.threads)
        .map_err(|(threads, error)| MotionError::Threads { threads, text: error.to_string() })?;
    let [first, last] = plan.frames;
    let mut frame_of = |frame| scene_of(frame).map_err(|why| MotionError::Frame { frame, why });
    let mut before = frame_of(first)?;
    let mut followers = followers(plan);
    for follower in &mut followers {
        pools
            .all
            .install(|| follower.build(&before))
            .map_err(|text| follower.failed(first, text))?;
    }
    let mut motion = Motion {
        motion_version: MOTION_VERSION,
        run: run(plan),
        frames: plan.frames,
        objects: before.objects.len() as u64,
        triangles: before.stored_triangle_count(),
        ..Motion::default()
    };
    let shown = shown_frames(plan);
    let mut pictures = Vec::new();
    let mut show = |frame, scene: &Scene, followers: &[Follower]| {
        if shown.contains(&frame)
            && let Some(world) = followers.first().and_then(|own| own.world.as_deref())
        {
            let picture = pools.all.install(|| picture_of(plan, frame, scene, world));
            pictures.extend(picture.map_err(|text| MotionError::Picture { frame, text })?);
        }
        Ok(())
    };
    show(first, &before, &followers)?;
    for frame in first + 1..=last {
        if observer.cancelled() {
            motion.run.partial = true;
            break;
        }
        observer.begins(&format!("frame {frame}"));
        observer.advanced(f64::from(frame - first - 1) / f64::from(last - first));
        let after = frame_of(frame)?;
        let change = SceneChange::between(&before, &after);
        motion.moved.push(moved(change.as_ref()));
        for place in 0..followers.len() {
            let place = (place + frame as usize) % followers.len();
            let follower = &mut followers[place];
            let updated = pools.all.install(|| follower.update(&after, change.as_ref()));
            updated.map_err(|text| follower.failed(frame, text))?;
        }
        pools.one.install(|| trace_frame(plan, &mut motion, &mut followers, &after));
        show(frame, &after, &followers)?;
        before = after;
    }
    motion.strategies = followers.into_iter().map(Follower::finish).collect();
    Ok(MeasuredMotion { motion, pictures })
}

fn run(plan: &MotionPlan) -> Run {
    let mut run = build_of_program();
    run.options.threads = plan.threads as u32;
    run.options.trace_threads = 1;
    run.options.size = Some(plan.size);
    run.rounds.at_least = plan.rounds;
    run
}

fn moved(change: Option<&SceneChange<'_>>) -> Moved {
    let Some(change) = change else { return Moved::default() };
    Moved {
        objects: change.moved_objects() as u64,
        triangles: change.moved_triangles(),
        is_same_scene: true,
    }
}

/// How a structure follows with a strategy; `None` if it is built anew.
fn update_of(strategy: Strategy) -> Option<Update> {
    match strategy {
        Strategy::Rebuild | Strategy::QuickRebuild => None,
        Strategy::Refit => Some(Update::Refit),
        Strategy::Rotate => Some(Update::Rotate),
        Strategy::Partial => Some(Update::Partial),
    }
}

/// Whether a structure offers a strategy.
#[must_use]
pub fn offers(structure: &Structure, strategy: Strategy) -> bool {
    update_of(strategy).is_none_or(|update| structure.can_follow(update))
}

/// A structure, and how it is made ready.
struct Follower {
    structure: Structure,
    config: BuildConfig,
    world: Option<Box<dyn TracedWorld>>,
    record: StrategyRecord,
}

fn followers(plan: &MotionPlan) -> Vec<Follower> {
    let strategies = |structure: &Structure| {
        let offered = |strategy: &Strategy| offers(structure, *strategy);
        let of = |strategy| Follower::new(*structure, strategy);
        plan.strategies.iter().copied().filter(offered).map(of).collect::<Vec<_>>()
    };
    plan.structures.iter().flat_map(strategies).collect()
}

impl Follower {
    fn new(structure: Structure, strategy: Strategy) -> Self {
        let quality = match strategy {
            Strategy::QuickRebuild => Quality::Fastest,
            _ => Quality::default(),
        };
        let record = StrategyRecord {
            structure: structure.name.to_owned(),
            strategy,
            updates: Vec::new(),
            trace_ns: Vec::new(),
            sah_costs: [None; 2],
            rebuilt: 0,
            compared: 0,
            differing: 0,
        };
        let config = BuildConfig { quality, ..BuildConfig::default() };
        Self { structure, config, world: None, record }
    }

    fn build(&mut self, scene: &Scene) -> Result<(), String> {
        let built = self.structure.try_build(scene, &self.config);
        // The old one goes once the new one is there: otherwise the new one would lie where it lay.
        self.world = Some(built.map_err(|error| error.to_string())?);
        Ok(())
    }

    /// Makes it ready for a frame.
    fn update(&mut self, scene: &Scene, change: Option<&SceneChange<'_>>) -> Result<(), String> {
        let update = update_of(self.record.strategy);
        // What is replaced is dropped outside of what is timed.
        let mut old = None;
        let (done, round) = timed(|| {
            if let (Some(update), Some(world), Some(change)) = (update, &mut self.world, change)
                && world.refit(change, update)
            {
                return Ok(true);
            }
            old = self.world.take();
            self.build(scene).map(|()| false)
        });
        drop(old);
        self.record.rebuilt += u64::from(!done? && update.is_some());
        self.record.updates.push(round);
        Ok(())
    }

    fn failed<E>(&self, frame: u32, text: String) -> MotionError<E> {
        MotionError::Build { structure: self.record.structure.clone(), frame, text }
    }

    fn finish(mut self) -> StrategyRecord {
        if let Some(world) = &self.world {
            let report = world.build_report();
            self.record.sah_costs = [report.meshes.sah_cost, report.objects.sah_cost];
        }
        self.record
    }
}

/// Traces the rays of a frame with all structures, and compares their answers.
fn trace_frame(plan: &MotionPlan, motion: &mut Motion, followers: &mut [Follower], scene: &Scene) {
    let Some(first) = followers.first().and_then(|first| first.world.as_deref()) else { return };
    let [width, height] = plan.size;
    let settings = Settings { width, height, ..Settings::of_scene(scene) };
    let sets = rays_of_picture(scene, first, &settings, plan.rays_per_class);
    let frames_before = motion.moved.len() - 1;
    for set in &sets {
        let place = class_of(motion, followers, set.class, frames_before);
        motion.rays[place].rays.push(set.rays.len() as u64);
        trace_set(plan, followers, set, place, frames_before);
    }
    compare_with_none(motion, followers, scene, &sets);
    // A class that does not occur in this frame takes no time.
    for rays in motion.rays.iter_mut().map(|own| &mut own.rays) {
        rays.resize(frames_before + 1, 0);
    }
    for times in followers.iter_mut().flat_map(|own| &mut own.record.trace_ns) {
        times.resize(frames_before + 1, 0);
    }
}

/// The place of a class among those that have occurred.
fn class_of(
    motion: &mut Motion,
    followers: &mut [Follower],
    class: RayClass,
    frames_before: usize,
) -> usize {
    if let Some(place) = motion.rays.iter().position(|own| own.class == class) {
        return place;
    }
    motion.rays.push(MotionRays { class, rays: vec![0; frames_before] });
    for follower in followers {
        follower.record.trace_ns.push(vec![0; frames_before]);
    }
    motion.rays.len() - 1
}

/// The rays of a class, in interleaved rounds.
fn trace_set(
    plan: &MotionPlan,
    followers: &mut [Follower],
    set: &RaySet,
    place: usize,
    frames_before: usize,
) {
    let count = followers.len();
    let mut expected = set.results();
    let mut results = set.results();
    let mut rounds: Vec<Vec<Round>> = vec![Vec::new(); count];
    for round in 0..plan.rounds as usize {
        for turn in 0..count {
            let own = (turn + round + frames_before) % count;
            let Some(world) = &followers[own].world else { continue };
            let ((), time) = timed(|| trace(&**world, &set.rays, &mut results, None));
            rounds[own].push(time);
        }
    }
    if let Some(world) = &followers[0].world {
        trace(&**world, &set.rays, &mut expected, None);
    }
    for (follower, rounds) in followers.iter_mut().zip(&rounds) {
        let Some(world) = &follower.world else { continue };
        trace(&**world, &set.rays, &mut results, None);
        follower.record.compared += set.rays.len() as u64;
        follower.record.differing += results.count_differing(&expected) as u64;
        let times: Vec<f64> = rounds.iter().map(|round| round.own_ns() as f64).collect();
        let time = median(&times).unwrap_or_default();
        follower.record.trace_ns[place].push(time as u64);
    }
}

/// Compares some answers of the first structure with those of none.
fn compare_with_none(motion: &mut Motion, followers: &[Follower], scene: &Scene, sets: &[RaySet]) {
    let tests = scene.triangle_count() + scene.objects.len() as u64;
    let count = (TESTS_OF_NONE / tests.max(1)).min(MOST_FOR_NONE) as usize;
    let (Some(none), Some(first)) = (structure_named("none"), &followers[0].world) else { return };
    if count == 0 {
        return;
    }
    let none = none.build(scene, &BuildConfig::default());
    for set in sets {
        let some = set.spread(count);
        let (mut expected, mut results) = (some.results(), some.results());
        trace(&*none, &some.rays, &mut expected, None);
        trace(&**first, &some.rays, &mut results, None);
        motion.compared_with_none += some.rays.len() as u64;
        motion.differ_from_none += results.count_differing(&expected) as u64;
    }
}
