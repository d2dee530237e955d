//! Why a description cannot be traced, or not with a certain structure.

use std::io;

use thiserror::Error;

use crate::accel::LoadError;

use crate::assets::MemoryShortage;
use crate::math::ConditionError;

/// A part of a description that cannot be traced.
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
    /// An object's place or size is beyond the range in which the formulas hold.
    #[error(
        "object {object} is too large, too small or too far away to be traced in single precision"
    )]
    OutOfRange {
        /// Index of the object in the description.
        object: usize,
    },
    /// A light is beyond the range in which the formulas hold.
    #[error("light {light} is too far away to be traced in single precision")]
    LightOutOfRange {
        /// Index of the light in the description.
        light: usize,
    },
    /// The camera's frame is degenerate.
    #[error("the camera has no frame: its direction is zero or parallel to its up vector")]
    Camera,
    /// The camera, or its image rectangle, is beyond the range in which the formulas hold.
    #[error(
        "the camera is too far away, or its image plane too near or too far, to be traced in \
         single precision"
    )]
    CameraOutOfRange,
}

/// Why a structure cannot be built over a scene that can be traced.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum BuildError {
    /// It does not support the shape of an object.
    #[error("object {object} is a {shape}: only triangles and meshes can be traced with it")]
    Unsupported {
        /// Index of the object in the scene.
        object: usize,
        /// The name of its shape.
        shape: &'static str,
    },
    /// It does not fit into memory.
    #[error("the structure is too large: {0}")]
    NoMemory(#[from] MemoryShortage),
    /// The library behind it failed.
    #[error("{text}")]
    Library {
        /// Its message.
        text: String,
    },
}

/// Why a structure was not saved.
#[derive(Debug, Error)]
pub enum SaveError {
    /// It is none that can be.
    #[error("`{structure}` cannot be saved")]
    NotPortable {
        /// Its name.
        structure: &'static str,
    },
    /// It cannot be built.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// It cannot be written.
    #[error(transparent)]
    Unwritable(#[from] io::Error),
}

/// Why bytes are no structure over a scene.
#[derive(Debug, Error)]
#[error("the structure over {}: {source}", in_words(*mesh))]
pub struct ReadError {
    /// The mesh of the scene over which it should be; none for the objects.
    pub mesh: Option<usize>,
    /// What is wrong.
    pub source: LoadError,
}

impl ReadError {
    pub(super) fn of_mesh(mesh: usize, source: LoadError) -> Self {
        Self { mesh: Some(mesh), source }
    }

    pub(super) fn of_objects(source: LoadError) -> Self {
        Self { mesh: None, source }
    }
}

fn in_words(mesh: Option<usize>) -> String {
    mesh.map_or_else(|| "the objects".to_owned(), |mesh| format!("mesh {}", mesh + 1))
}
