//! The first ray for which a structure answers differently, in full precision.

use std::fmt;

use glam::Vec3;

use crate::accel::{Quality, Update};
use crate::math::{Hit, Ray};

/// The first ray whose answers differ.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub struct FirstDifference {
    /// The mesh, by its name in [`nasty_meshes`](super::nasty_meshes).
    pub mesh: &'static str,
    /// What it was scaled by.
    pub scale: f32,
    /// What it was moved by after that.
    pub offset: Vec3,
    /// How the structure was to be built.
    pub quality: Quality,
    /// How it has followed the triangles, if it was built for them in other places.
    pub update: Option<Update>,
    /// How the ray was searched for.
    pub way: Way,
    /// The ray.
    pub ray: Ray,
    /// What every structure must answer.
    pub expected: Answer,
    /// What this one did.
    pub got: Answer,
}

/// Both answers for a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// Its first hit.
    pub hit: Hit,
    /// Whether it hits anything.
    pub blocked: bool,
}

/// How rays are searched for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Many in a slice.
    Slice,
    /// Many in a slice, and what is tested counted.
    Counted,
    /// By themselves.
    Alone,
}

impl Answer {
    pub(super) fn same_bits(&self, other: &Self) -> bool {
        self.hit.same_bits(&other.hit) && self.blocked == other.blocked
    }
}

impl fmt::Display for FirstDifference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { mesh, scale, offset, ray, .. } = self;
        let (quality, way) = (self.quality.name(), self.way);
        let followed = self.update.map(|update| format!(" and {}", update.participle()));
        let followed = followed.unwrap_or_default();
        writeln!(
            f,
            "mesh `{mesh}` times {scale:e} plus {offset}, built `{quality}`{followed}, traced {way}: {ray:?}"
        )?;
        writeln!(f, "  got      {}", self.got)?;
        write!(f, "  expected {}", self.expected)
    }
}

impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let blocked = if self.blocked { "blocked" } else { "not blocked" };
        match self.hit.is_hit() {
            true => write!(f, "{:?}, {blocked}", self.hit),
            false => write!(f, "no hit, {blocked}"),
        }
    }
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Slice => "in a slice",
            Self::Counted => "in a slice, counting",
            Self::Alone => "alone",
        })
    }
}
