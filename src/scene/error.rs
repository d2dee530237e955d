//! Why a description cannot be traced.

use thiserror::Error;

use crate::math::ConditionError;

/// A description that says something no ray can be traced through.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SceneError {
    /// An object's transform has no inverse.
    #[error("object {object}: {source}")]
    Transform {
        /// Index of the object in the description.
        object: usize,
        /// What is wrong with the matrix.
        source: ConditionError,
    },
    /// An object's place or size is beyond what single precision holds.
    #[error(
        "object {object} is too large, too small or too far away to be traced in single precision"
    )]
    OutOfRange {
        /// Index of the object in the description.
        object: usize,
    },
    /// The camera's frame is degenerate.
    #[error("the camera has no frame: its direction is zero or parallel to its up vector")]
    Camera,
}
