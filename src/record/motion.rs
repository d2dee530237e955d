//! Structures that follow a scene that moves: what it took to make each ready for a frame, and what its rays took.

use serde::{Deserialize, Serialize};

use super::{RayClass, Round, Run};

/// The version of the record: raised when a field changes its meaning or goes away.
pub const MOTION_VERSION: u32 = 1;

/// A sequence of frames with several structures, each kept ready in several ways.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Motion {
    /// [`MOTION_VERSION`].
    pub motion_version: u32,
    /// How it was made.
    pub run: Run,
    /// The scene's file.
    pub scene: String,
    /// The frame that all were built for, which is not timed, and the last one.
    pub frames: [u32; 2],
    /// Objects of the scene.
    pub objects: u64,
    /// Triangles in memory, those of each mesh once.
    pub triangles: u64,
    /// What moved before each frame that was measured.
    pub moved: Vec<Moved>,
    /// The rays of each class that was traced.
    pub rays: Vec<MotionRays>,
    /// Structures and strategies.
    pub strategies: Vec<StrategyRecord>,
    /// How many rays the first strategy's answers were compared with those of no structure at all, in all frames.
    pub compared_with_none: u64,
    /// How many of these differ.
    pub differ_from_none: u64,
}

/// What moved between two frames.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Moved {
    /// Objects that are elsewhere, or whose mesh is deformed.
    pub objects: u64,
    /// Triangles of meshes that are deformed otherwise.
    pub triangles: u64,
    /// Whether it is the same scene: the same objects of the same meshes.
    pub is_same_scene: bool,
}

/// The rays of a class: a picture's in each frame, the same with all structures.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MotionRays {
    /// The class.
    pub class: RayClass,
    /// How many, frame by frame.
    pub rays: Vec<u64>,
}

/// A small picture of a frame, for a page; it is in no record.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FramePicture {
    /// The frame.
    pub frame: u32,
    /// Width and height.
    pub size: [u32; 2],
    /// Its bytes as PNG.
    pub png: Vec<u8>,
}

/// How a structure is made ready for a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Strategy {
    /// It is built anew.
    Rebuild,
    /// It is built anew, with a build that looks less closely.
    QuickRebuild,
    /// Its boxes follow what has moved.
    Refit,
    /// Its boxes follow, and neighbours in the tree change places where that makes boxes smaller.
    Rotate,
    /// Its boxes follow, and parts of the tree that have become much worse are built anew.
    Partial,
}

impl Strategy {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::Rebuild, Self::QuickRebuild, Self::Refit, Self::Rotate, Self::Partial];

    /// The name on the command line and in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Rebuild => "rebuild",
            Self::QuickRebuild => "quick",
            Self::Refit => "refit",
            Self::Rotate => "rotate",
            Self::Partial => "partial",
        }
    }

    /// What it does, in a line.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::Rebuild => "built anew for each frame, in medium quality",
            Self::QuickRebuild => "built anew for each frame, in the fastest quality",
            Self::Refit => "built once; boxes follow what moves",
            Self::Rotate => {
                "as refit, and neighbours in the tree change places where boxes become smaller"
            }
            Self::Partial => {
                "as refit, and parts that cost a fifth more than when they were built are rebuilt"
            }
        }
    }
}

/// A structure with a strategy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StrategyRecord {
    /// The structure.
    pub structure: String,
    /// The strategy.
    pub strategy: Strategy,
    /// What it took to be ready for each frame.
    pub updates: Vec<Round>,
    /// The rays of each class in the order of [`Motion::rays`], frame by frame: nanoseconds of the median round.
    pub trace_ns: Vec<Vec<u64>>,
    /// The cost of its trees in the last frame, by the surface area heuristic: over the triangles of all meshes, and
    /// over the objects. Absent where there is no tree.
    pub sah_costs: [Option<f64>; 2],
    /// In how many frames it had to be built anew, although it was to follow.
    pub rebuilt: u64,
    /// How many rays were compared with those of the first strategy.
    pub compared: u64,
    /// How many of these differ.
    pub differing: u64,
}
