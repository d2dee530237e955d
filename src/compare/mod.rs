//! The same work on several structures → measurements.
//!
//! A [`Plan`] says what is compared, [`run`] does it and gives a [`Comparison`](crate::record::Comparison), the plain data
//! that reports are made of. For each scene the rays of a small rendering are recorded once and
//! replayed to every structure in interleaved rounds; hits and whole pictures are compared bit for
//! bit. Knows no terminal, no file and no report.
//!
//! | file | what |
//! |---|---|
//! | `plan.rs`, `budget.rs`, `observer.rs`, `progress.rs` | what is asked, the time for it, who watches |
//! | `scene.rs`, `picture_steps.rs` | one scene, step by step |
//! | `record_rays.rs`, `extra_rays.rs` | the same rays for all |
//! | `rounds.rs`, `replay.rs`, `builds.rs`, `pictures.rs`, `clock.rs`, `hardware.rs` | what is timed and counted |
//! | `sweep.rs` | growth with the number of triangles |
//! | `sampling_study/` | what random numbers and shuffling cost, and how much noise they leave |
//! | `proof.rs`, `hash.rs` | that the answers are equal |
//! | `agreement.rs` | that a yardstick's are close |
//! | `entrant.rs`, `guard.rs`, `quality.rs` | a structure and its row; its panics; its form |
//! | `machine.rs`, `commit.rs`, `sources.rs` | what measured, and what it was built from |
//!
//! # Bring your own structure
//!
//! Implement [`Accel`](crate::accel::Accel) for a type of yours: `build` makes it from the boxes of
//! primitives, `traverse` offers ranges of slots that a ray may hit, `shape` tells its size, and
//! `tree`, if you write it, shows its boxes, so that their end-point overlap is measured. The
//! contract stands at the trait; in short: leave out only what lies in boxes that
//! [`BoxRay::interval`](crate::math::BoxRay::interval) says the ray misses or meets behind the end
//! of the search, and take comparisons as inclusive. A primitive may be offered more than once.
//! Where `build` wants its primitives in another order, it returns that order, and slots count in
//! it. Then name it and compare it:
//!
//! ```
//! use srt::accel::{Accel, BoundingBall, Bvh};
//! use srt::compare::{Plan, SceneInput, Silent, run};
//! use srt::scene::{Scene, Structure, structure_named};
//! # use srt::scene_file::{ParseOptions, parse};
//! # let text = "sce1.0\neyepos 0 -5 0\neyedir 0 1 0\neyeup 0 0 1\nwdist 1\nfovy_deg 40\nnx 9\nny 9\nball 1 0 0 0\nend\n";
//! # let parsed = parse(text, &ParseOptions::default()).unwrap();
//! # let scene = Scene::new(&parsed.description, vec![]).unwrap();
//! // Over the objects, and over the triangles of each mesh: here a type of the library's stands
//! // in for yours.
//! let mine = Structure::new::<BoundingBall, BoundingBall>("mine", "one ball around everything");
//! let none = *structure_named("none").unwrap();
//! let input = SceneInput { name: "a".into(), path: "a.sce".into(), hash: String::new(), scene };
//! let mut plan = Plan::of_scenes(vec![input]);
//! plan.budget = Some(std::time::Duration::from_millis(200));
//! let outcome = run(&plan, &[none, mine], &Silent)?;
//! let proof = outcome.comparison.scenes[0].proof.as_ref().unwrap();
//! assert!(proof.holds(), "a ray that differs is told: {proof:?}");
//! # Ok::<(), srt::compare::CompareError>(())
//! ```
//!
//! What differs is told by the ray that shows it, cut to the piece around the hit and printed in
//! full precision. `examples/custom_accel.rs` does all of this with a uniform grid.

mod agreement;
mod budget;
mod builds;
mod clock;
mod commit;
mod entrant;
mod extra_rays;
mod guard;
mod hardware;
mod hash;
mod machine;
mod observer;
mod picture_steps;
mod pictures;
mod plan;
mod progress;
mod proof;
mod quality;
mod record_rays;
mod replay;
mod rounds;
mod run;
mod sampling_study;
mod scene;
mod sources;
mod sweep;

use rayon::ThreadPool;

pub(crate) use guard::guarded;
pub use observer::{Observer, Silent};
pub(crate) use picture_steps::{heatmap_name, picture_name};
pub use plan::{PictureOptions, Plan, SceneInput, SweepPlan};
pub use run::{CompareError, Outcome, run};

use scene::Stage;

/// The threads that work.
struct Pools {
    one: ThreadPool,
    all: ThreadPool,
}
