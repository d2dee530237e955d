//! A comparison as plain data: all that a report is made from.
//!
//! `compare` fills a [`Comparison`] by measuring, and `report` turns it into bytes; neither needs the other.
//! Measurements are kept raw, round by round. Everything that follows from them (medians, intervals, ratios, slopes) is
//! computed by [`analysis`](crate::analysis). Nothing here depends on how rays are traced, how a structure works or how
//! a page looks.
//!
//! Times are whole nanoseconds in fields that end in `_ns`, memory is in bytes, hashes are hexadecimal. Pictures are
//! files beside the record, which names them ([`PictureFile`]).

mod baseline;
mod class;
mod comparison;
mod conformance;
mod estimate;
mod machine;
mod motion;
mod proof;
mod ray_class;
mod run;
mod sampling;
mod scene;
mod structure;
mod sweep;

pub use baseline::{Baseline, Change, Changes};
pub use class::{BlockSample, ClassRecord, HardwareCounters, Round};
pub use comparison::{Comparison, SCHEMA_VERSION};
pub use conformance::{Conformance, ConformanceDifference, ConformanceOutcome};
pub use estimate::{Estimate, Interval};
pub use machine::Machine;
pub use motion::{
    FramePicture, MOTION_VERSION, Motion, MotionRays, Moved, Strategy, StrategyRecord,
};
pub use proof::{PeerAgreement, Proof, StructureProof};
pub use ray_class::RayClass;
pub use run::{Options, RoundRule, Run};
pub use sampling::{ConvergedPicture, FramePart, NoisePoint, OperationCost, SamplingChapter};
pub use scene::{HeatScale, PictureFile, RecordedRays, SceneRecord, Spacing};
pub use structure::{
    BuildRecord, BuildStage, Memory, PictureRound, ShapeRecord, Status, StructureRecord,
};
pub use sweep::{Dropped, Sweep, SweepPoint};
