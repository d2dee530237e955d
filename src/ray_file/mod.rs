//! Recorded rays and their answers ↔ bytes, so that others trace the very same rays.
//!
//! A [`RayFile`] has the rays of a scene, class by class in the order in which they are traced, what each of them is to
//! find, and the hash of the geometry that they are for. Its bytes end with a hash of all of them, by which the rays
//! are cited. `docs/ray-files.md` describes the form byte by byte. [`rodent`] and [`tinybvh`] are the forms of other
//! programs. Nothing here traces a ray or opens a file.
//!
//! ```
//! use srt::glam::Vec3;
//! use srt::math::{Hit, Ray};
//! use srt::ray_file::{ClassRays, RayAnswers, RayFile};
//! use srt::record::RayClass;
//!
//! let rays = vec![Ray::new(Vec3::ZERO, Vec3::X)];
//! let answers = RayAnswers::ClosestHit(vec![Hit::MISS]);
//! let file = RayFile {
//!     geometry: [7; 32],
//!     classes: vec![ClassRays { class: RayClass::View, rays, answers }],
//! };
//! let mut bytes = file.encode();
//! assert_eq!(RayFile::decode(&bytes)?, file);
//! bytes[100] ^= 1;
//! assert!(RayFile::decode(&bytes).unwrap_err().to_string().contains("was altered"));
//! # Ok::<(), srt::ray_file::RayFileError>(())
//! ```

mod decode;
mod encode;
mod error;
pub mod rodent;
pub mod tinybvh;

use crate::math::{Hit, Ray};
use crate::record::RayClass;

pub use crate::sealed::Hash;
pub use error::RayFileError;

/// How the name of a file ends.
pub const EXTENSION: &str = "srtrays";

/// Rays in a call of a comparison, as in a renderer's wave. Kernels for many rays depend on it.
pub const RAYS_PER_CALL: u32 = 1024;

/// How a file begins.
const MAGIC: [u8; 8] = *b"srt-rays";

/// The version of the form.
const VERSION: u32 = 1;

/// Bytes before the table of classes.
const HEADER: usize = 56;

/// Bytes of an entry of the table.
const ENTRY: usize = 16;

/// Bytes of a ray.
const RAY: usize = 32;

/// Bytes of the closest hit, and of whether there is any.
const CLOSEST: usize = 20;
const ANY: usize = 1;

/// The rays of a scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RayFile {
    /// The hash of the geometry that they are for: see `scene::Scene::geometry_hash`.
    pub geometry: Hash,
    /// The classes, each once.
    pub classes: Vec<ClassRays>,
}

/// The rays of a class.
#[derive(Clone, Debug, PartialEq)]
pub struct ClassRays {
    /// The class.
    pub class: RayClass,
    /// The rays, in the order in which they are traced.
    pub rays: Vec<Ray>,
    /// Their answers, in the same order. The kind is the query.
    pub answers: RayAnswers,
}

/// What rays find.
#[derive(Clone, Debug, PartialEq)]
pub enum RayAnswers {
    /// The closest hit of each, or [`Hit::MISS`].
    ClosestHit(Vec<Hit>),
    /// Whether each hits anything.
    AnyHit(Vec<bool>),
}

impl RayFile {
    /// The rays of a class; `None` if there are none.
    #[must_use]
    pub fn class(&self, class: RayClass) -> Option<&ClassRays> {
        self.classes.iter().find(|own| own.class == class)
    }
}

impl RayAnswers {
    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::ClosestHit(hits) => hits.len(),
            Self::AnyHit(blocked) => blocked.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// How many of the rays hit something.
    #[must_use]
    pub fn hit_count(&self) -> usize {
        match self {
            Self::ClosestHit(hits) => hits.iter().filter(|hit| hit.is_hit()).count(),
            Self::AnyHit(blocked) => blocked.iter().filter(|&&blocked| blocked).count(),
        }
    }

    /// The query, in words.
    #[must_use]
    pub fn query(&self) -> &'static str {
        match self {
            Self::ClosestHit(_) => "closest hit",
            Self::AnyHit(_) => "any hit",
        }
    }

    /// The code of the query, and the bytes of an answer.
    fn code_and_size(&self) -> (u8, usize) {
        match self {
            Self::ClosestHit(_) => (0, CLOSEST),
            Self::AnyHit(_) => (1, ANY),
        }
    }
}

#[cfg(test)]
mod tests;
