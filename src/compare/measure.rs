//! The parts of a comparison that a benchmark of your own takes: rays of each class, their results,
//! and interleaved rounds.
//!
//! ```
//! use srt::accel::BuildConfig;
//! use srt::compare::measure::{FirstHits, fixed_rounds, timed, view_rays};
//! use srt::scene::{STRUCTURES, Scene};
//! # use srt::scene_file::{ParseOptions, parse};
//! # let camera = "eyepos 0 -5 0\neyedir 0 1 0\neyeup 0 0 1\nwdist 1\nfovy_deg 40\nnx 32\nny 32\n";
//! # let text = format!("sce1.0\n{camera}ball 1 0 0 0\nend\n");
//! # let parsed = parse(&text, &ParseOptions::default()).unwrap();
//! # let scene = Scene::new(&parsed.description, vec![]).unwrap();
//! let worlds: Vec<_> =
//!     STRUCTURES.iter().map(|one| one.build(&scene, &BuildConfig::default())).collect();
//! let view = view_rays(&scene);
//! let set = FirstHits::new(&scene, &*worlds[0], &view).mirror_rays();
//!
//! // Results before times.
//! let (mut expected, mut results) = (set.results(), set.results());
//! expected.trace(&*worlds[0], &set.rays);
//! for world in &worlds {
//!     results.trace(&**world, &set.rays);
//!     assert_eq!(results.count_differing(&expected), 0);
//! }
//!
//! let rounds = fixed_rounds(worlds.len(), 3, |index| {
//!     let ((), round) = timed(|| results.trace(&*worlds[index], &set.rays));
//!     round.own_ns()
//! });
//! assert_eq!((rounds.len(), rounds[0].len()), (worlds.len(), 3));
//! ```

pub use super::clock::timed;
pub use super::extra_rays::{FirstHits, probe_rays, view_rays};
pub use super::record_rays::RaySet;
pub use super::rounds::fixed_rounds;
pub use crate::ray_file::RayAnswers;
