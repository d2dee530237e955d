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
    /// Whether the triangles were tested one by one, and not in packs:
    /// [`check_one_by_one`](super::check_one_by_one).
    pub one_by_one: bool,
    /// What was asked.
    pub question: Question,
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
    /// Its first hit. Of all hits, the first that differs.
    pub hit: Hit,
    /// Whether it hits anything. Of all hits, whether there is still one.
    pub blocked: bool,
}

/// What is asked of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    /// Its first hit, and whether there is any.
    First,
    /// The same of the hits on two triangles of three, by [`Filtered`](crate::accel::Filtered).
    Filtered,
    /// [`AllHits`](crate::accel::AllHits).
    All,
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
        let Self { mesh, scale, offset, quality, update, one_by_one, question, way, ray, .. } =
            self;
        let subject = Subject {
            mesh,
            scale: *scale,
            offset: *offset,
            made: (*quality, *update),
            one_by_one: *one_by_one,
        };
        writeln!(f, "{subject}{question}, traced {way}: {ray:?}")?;
        writeln!(f, "  got      {}", self.got)?;
        write!(f, "  expected {}", self.expected)
    }
}

/// What is checked: a structure over a mesh in a place.
pub(super) struct Subject<'a> {
    pub(super) mesh: &'a str,
    pub(super) scale: f32,
    pub(super) offset: Vec3,
    pub(super) made: (Quality, Option<Update>),
    pub(super) one_by_one: bool,
}

impl fmt::Display for Subject<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { mesh, scale, offset, made: (quality, update), one_by_one } = self;
        write!(f, "mesh `{mesh}` times {scale:e} plus {offset}, built `{}`", quality.name())?;
        if let Some(update) = update {
            write!(f, " and {}", update.participle())?;
        }
        f.write_str(if *one_by_one { ", triangles tested one by one" } else { "" })
    }
}

impl fmt::Display for Question {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::First => "",
            Self::Filtered => ", hits filtered",
            Self::All => ", all hits",
        })
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
