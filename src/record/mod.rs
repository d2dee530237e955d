//! A comparison as plain data: all that a report may know.
//!
//! The `compare` layer fills a [`Comparison`] by measuring, the `report` layer turns it into
//! bytes, and neither needs the other. Nothing here knows how rays are traced, what a structure is
//! or how a page looks. What was measured is kept raw, round by round; everything that follows
//! from it (medians, intervals, ratios, slopes) is computed by [`statistics`] and gathered in
//! [`derived`], so that every report prints the same figures.
//!
//! Times are whole nanoseconds in fields that end in `_ns`, memory is bytes, hashes are
//! hexadecimal. Pictures travel beside the record as files, which it names ([`PictureFile`]).

mod baseline;
mod class;
mod comparison;
mod estimate;
mod machine;
mod proof;
mod ray_class;
mod run;
mod sampling;
mod scene;
mod structure;
mod sweep;

pub use baseline::{Baseline, Change, Changes};
pub use class::{ClassRecord, CommonRays, HardwareCounters, Round};
pub use comparison::{Comparison, SCHEMA_VERSION};
pub use estimate::{Estimate, Interval};
pub use machine::Machine;
pub use proof::{Proof, StructureProof, YardstickProof};
pub use ray_class::RayClass;
pub use run::{Options, RoundRule, Run};
pub use sampling::{ConvergedPicture, FramePart, NoisePoint, OperationCost, SamplingChapter};
pub use scene::{HeatScale, PictureFile, SceneRecord, Spacing};
pub use structure::{
    BuildRecord, BuildStage, Memory, PictureRound, Shape, Status, StructureRecord,
};
pub use sweep::{Dropped, Sweep, SweepPoint};
