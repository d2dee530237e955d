//! What is to be compared: plain data.

use std::collections::BTreeMap;
use std::time::Duration;

use super::family::Family;
use crate::accel::BuildConfig;
use crate::ray_file::RayFile;
use crate::record::{Comparison, RayClass, RoundRule};
use crate::render::{Sampling, Settings};
use crate::scene::Scene;

use super::picture_size::fit;

/// A scene, ready to be traced, and its name in a report.
#[derive(Clone, Debug)]
pub struct SceneInput {
    /// A short name, different from that of every other scene; files are named by it.
    pub name: String,
    /// The scene's file, as typed.
    pub path: String,
    /// SHA-256 of the scene's file and of all files that it names, hexadecimal.
    pub hash: String,
    /// The scene.
    pub scene: Scene,
}

/// How pictures are rendered. What is absent is taken from the scene, within
/// [`LARGEST_SIDE`](Self::LARGEST_SIDE) and [`LARGEST_AA`](Self::LARGEST_AA).
#[derive(Clone, Copy, Debug)]
pub struct PictureOptions {
    /// Width and height in pixels.
    pub size: Option<[u32; 2]>,
    /// View samples along each side of a pixel.
    pub aa: Option<u32>,
    /// Light samples along each side of an area light.
    pub light_samples: u32,
    /// How many times a view ray may be mirrored or refracted.
    pub max_recursion: Option<u32>,
    /// How area lights are sampled.
    pub sampling: Sampling,
    /// Where random numbers start.
    pub seed: u64,
}

impl Default for PictureOptions {
    fn default() -> Self {
        Self {
            size: None,
            aa: None,
            light_samples: 1,
            max_recursion: None,
            sampling: Sampling::default(),
            seed: 0,
        }
    }
}

impl PictureOptions {
    /// The longer side of a picture at most, unless a size is given.
    pub const LARGEST_SIDE: u32 = 300;
    /// Samples along each side of a pixel at most, unless a number is given.
    pub const LARGEST_AA: u32 = 2;

    /// The settings of a scene's picture.
    pub(super) fn settings(&self, scene: &Scene) -> Settings {
        let of_scene = Settings::of_scene(scene);
        let [width, height] =
            self.size.unwrap_or_else(|| fit([of_scene.width, of_scene.height], Self::LARGEST_SIDE));
        Settings {
            width,
            height,
            aa: self.aa.unwrap_or(of_scene.aa.min(Self::LARGEST_AA)),
            light_samples: self.light_samples,
            max_recursion: self.max_recursion.unwrap_or(of_scene.max_recursion),
            sampling: self.sampling,
            seed: self.seed,
            ..of_scene
        }
    }
}

/// A family of scenes of growing size.
#[derive(Clone, Debug)]
pub struct SweepPlan {
    /// The family.
    pub family: Family,
    /// Sizes in the family's unit, growing.
    pub sizes: Vec<u32>,
}

impl SweepPlan {
    /// The sizes between two that are evenly spread by factor, two for each power of ten; both
    /// ends are among them.
    #[must_use]
    pub fn sizes_between(first: u32, last: u32) -> Vec<u32> {
        let steps = (0..).map(|step| f64::from(first) * 10f64.powf(0.5 * f64::from(step)));
        // A step that nearly reaches the end is left out for it.
        let below = steps.take_while(|&size| size < 0.9 * f64::from(last));
        below.map(|size| size.round() as u32).chain([last]).collect()
    }
}

/// What is to be compared, and how long that may take.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The command that started it, quoted for a shell.
    pub command: String,
    /// The scenes.
    pub scenes: Vec<SceneInput>,
    /// The classes of rays that are replayed, where a scene has them.
    pub classes: Vec<RayClass>,
    /// How pictures are rendered.
    pub picture: PictureOptions,
    /// The structure that ratios are taken to; where none is named, `none` if it is compared, else the first.
    pub base: Option<String>,
    /// How structures are built.
    pub build: BuildConfig,
    /// Threads that render, and that builds on all threads use.
    pub threads: usize,
    /// How long the whole may take; `None` for as long as the rounds need.
    pub budget: Option<Duration>,
    /// When rounds end.
    pub rounds: RoundRule,
    /// The relative standard deviation of a time from run to run on this machine, which intervals include.
    pub between_runs: f64,
    /// The most rays of a class that are recorded.
    pub rays_per_class: usize,
    /// Rays that are measured in place of recorded ones, by the names of their scenes. They are for the geometry of
    /// these scenes.
    pub replayed: BTreeMap<String, RayFile>,
    /// Whether the observer gets the rays of each scene that are recorded.
    pub keep_rays: bool,
    /// The record of the same plan that was stopped, to go on with: see [`expect_same`](super::expect_same).
    pub resumed: Option<Comparison>,
    /// Growth with the number of triangles, if that is to be measured.
    pub sweep: Option<SweepPlan>,
    /// Whether to study what random numbers and shuffling cost, and how much noise they leave.
    pub sampling_study: bool,
}

impl Plan {
    /// The classes of rays that a renderer sends.
    pub const USUAL_CLASSES: [RayClass; 4] =
        [RayClass::View, RayClass::Shadow, RayClass::Mirror, RayClass::Refraction];

    /// What differed from run to run of the same comparison on virtual machines, whose neighbours differ from minute to
    /// minute (`docs/measuring.md` has the runs).
    pub const BETWEEN_RUNS: f64 = 0.05;

    /// A plan for some scenes, with the defaults of the command for everything else.
    #[must_use]
    pub fn of_scenes(scenes: Vec<SceneInput>) -> Self {
        Self {
            command: String::new(),
            scenes,
            classes: Self::USUAL_CLASSES.to_vec(),
            picture: PictureOptions::default(),
            base: None,
            build: BuildConfig::default(),
            threads: std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
            budget: None,
            rounds: RoundRule { warmup: 1, at_least: 10, relative_interval: 0.02 },
            between_runs: Self::BETWEEN_RUNS,
            rays_per_class: 200_000,
            replayed: BTreeMap::new(),
            keep_rays: false,
            resumed: None,
            sweep: None,
            sampling_study: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sweeps_step_evenly_up_to_their_last_size() {
        assert_eq!(SweepPlan::sizes_between(1_000, 30_000), [1_000, 3_162, 10_000, 30_000]);
        assert_eq!(SweepPlan::sizes_between(10, 100), [10, 32, 100]);
        assert_eq!(SweepPlan::sizes_between(5, 5), [5]);
    }
}
