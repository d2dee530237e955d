//! The same work on several structures → measurements.
//!
//! A [`Plan`] is what to compare, [`run`] does it and returns a
//! [`Comparison`](crate::record::Comparison), the plain data that reports are made of. For each
//! scene the rays of a small rendering are recorded once and replayed to every structure in
//! interleaved rounds; hits and whole pictures are compared bit for bit. This layer knows no
//! terminal, no format of scenes and no report. To name its machine and its commit it reads files
//! of the system, runs git, and reads the program's own sources.
//!
//! | file | what |
//! |---|---|
//! | `plan.rs`, `budget.rs`, `observer.rs`, `progress.rs` | what to compare, the time for it, who watches |
//! | `run.rs` | the whole plan |
//! | `conformance.rs` | whether structures from outside keep the contract, before all scenes |
//! | `scene.rs`, `scene/` | one scene: its steps, one file each |
//! | `context.rs`, `pools.rs` | what the steps share: a scene and its plan, threads |
//! | `candidate.rs`, `panics.rs` | a structure with its row of the report, and its panics |
//! | `record_rays.rs`, `extra_rays.rs`, `trace.rs` | the same rays for all, and their results |
//! | `ray_exchange.rs` | recorded rays and files of rays |
//! | `proof.rs`, `agreement.rs` | whether results are equal, or a peer's close |
//! | `rounds.rs`, `clock.rs`, `hardware.rs` | how something is timed and counted |
//! | `trial.rs`, `block_sample.rs`, `class_rounds.rs`, `passes.rs`, `replay.rs` | which rays are timed, and how often |
//! | `render_picture.rs`, `picture_size.rs`, `picture_file.rs` | pictures |
//! | `sweep.rs`, `family.rs` | growth with the size of a scene |
//! | `sampling_study/` | what random numbers and shuffling cost, and how much noise they leave |
//! | `machine.rs`, `commit.rs`, `sources.rs` | on which machine, and from which sources |
//! | `measure.rs` | the parts of it that benchmarks take |
//!
//! # Bring your own structure
//!
//! Implement [`Accel`](crate::accel::Accel) for a type of yours: `build` makes it from the boxes of
//! primitives, `traverse` offers ranges of slots that a ray may hit, `shape` returns its size, and
//! `tree`, if you write it, returns its boxes, so that their end-point overlap is measured. The
//! contract stands at the trait; in short: leave out only what lies in boxes that
//! [`BoxRay::interval`](crate::math::BoxRay::interval) shows to be missed by the ray or behind the
//! end of the search, and take comparisons as inclusive. A primitive may be offered more than once.
//! If `build` wants its primitives in another order, it returns that order, and slots count in it.
//! Then name it and compare it:
//!
//! ```
//! use srt::accel::{Accel, BoundingBall, Bvh};
//! use srt::compare::{Plan, SceneInput, Silent, run};
//! use srt::scene::{Scene, Structure, structure_named};
//! # use srt::scene_file::{ParseOptions, parse};
//! # let camera = "eyepos 0 -5 0\neyedir 0 1 0\neyeup 0 0 1\nwdist 1\nfovy_deg 40\nnx 9\nny 9\n";
//! # let text = format!("sce1.0\n{camera}ball 1 0 0 0\nend\n");
//! # let parsed = parse(&text, &ParseOptions::default()).unwrap();
//! # let scene = Scene::new(&parsed.description, vec![]).unwrap();
//! // Over the objects, and over the triangles of each mesh: here a type of the library's stands
//! // in for yours.
//! let mine = Structure::new::<BoundingBall, BoundingBall>("mine", "one ball around everything");
//! let none = *structure_named("none").unwrap();
//! let input = SceneInput { name: "a".into(), path: "a.sce".into(), hash: String::new(), scene };
//! let mut plan = Plan::of_scenes(vec![input]);
//! plan.budget = Some(std::time::Duration::from_millis(200));
//! let result = run(&plan, &[none, mine], &Silent)?;
//! let proof = result.comparison.scenes[0].proof.as_ref().unwrap();
//! assert!(proof.holds(), "the first ray that differs is in the proof: {proof:?}");
//! # Ok::<(), srt::compare::CompareError>(())
//! ```
//!
//! A difference is reported with a ray that shows it, cut to the piece around the hit and printed
//! in full precision. `examples/custom_accel.rs` does all of this with a loose grid.

mod agreement;
mod block_sample;
mod budget;
mod candidate;
mod class_rounds;
mod clock;
mod commit;
mod conformance;
mod context;
mod extra_rays;
mod family;
mod hardware;
mod machine;
pub mod measure;
mod motion;
mod observer;
mod panics;
mod passes;
mod picture_file;
mod picture_size;
mod plan;
mod pools;
mod progress;
mod proof;
mod ray_exchange;
mod record_rays;
mod record_so_far;
mod render_picture;
mod replay;
mod resume;
mod rounds;
mod run;
mod sampling_study;
mod scene;
mod sources;
mod sweep;
mod trace;
mod trial;

pub use family::Family;
pub use machine::{disturbances, machine};
pub use motion::{MeasuredMotion, MotionError, MotionPlan, measure_motion, offers};
pub use observer::{Observer, Silent};
pub(crate) use panics::catch_panic;
pub(crate) use picture_file::{heatmap_name, picture_name};
pub use plan::{PictureOptions, Plan, SceneInput, SweepPlan};
pub use ray_exchange::{WrongAnswers, answered_rays, wrong_answers};
pub use resume::{ResumeError, expect_same};
pub use run::{CompareError, ComparisonResult, check_plan, describe, run};
