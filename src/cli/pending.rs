//! Stand-ins for layers that are not part of the library yet, under the names those will have.
//!
//! Each goes away by a change of one `use` line. Names and rules are real; what would have to read,
//! make or compare data answers that it cannot yet.

use std::io::{self, Write};
use std::path::Path;

use super::interrupt::Interrupt;
use super::options::RenderOptions;
use super::progress::Progress;
use super::report::{RayClass, Report};
use crate::image_io::Picture;

/// What a stand-in answers.
#[derive(Clone, Copy, Debug, thiserror::Error)]
#[error("this is not part of srt yet")]
pub(crate) struct NotYet;

/// `image_io::Format`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// Truevision TGA.
    Tga,
    /// Portable network graphics.
    Png,
    /// Portable pixmap.
    Ppm,
    /// OpenEXR.
    Exr,
    /// Radiance RGBE.
    Hdr,
}

impl Format {
    /// All of them.
    pub(crate) const ALL: [Self; 5] = [Self::Tga, Self::Png, Self::Ppm, Self::Exr, Self::Hdr];

    /// The name, which is also the extension.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Tga => "tga",
            Self::Png => "png",
            Self::Ppm => "ppm",
            Self::Exr => "exr",
            Self::Hdr => "hdr",
        }
    }

    /// The format of that name, in any case.
    pub(crate) fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.name().eq_ignore_ascii_case(name))
    }

    /// The format that a path's extension names.
    pub(crate) fn from_path(path: &Path) -> Option<Self> {
        path.extension().and_then(|extension| extension.to_str()).and_then(Self::from_name)
    }
}

/// `image_io::decode`.
pub(crate) fn decode(_: &[u8], _: Format) -> Result<Picture, NotYet> {
    Err(NotYet)
}

/// `image_io::encode`.
pub(crate) fn encode(_: &Picture, _: Format) -> Result<Vec<u8>, NotYet> {
    Err(NotYet)
}

/// `image_io::Difference`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Difference {
    /// Pixels that differ in any channel.
    pub(crate) differing: u64,
    /// The largest difference of a channel.
    pub(crate) largest: f64,
    /// The mean difference of all channels of all pixels.
    pub(crate) mean: f64,
    /// The root of the mean square of the same.
    pub(crate) rmse: f64,
    /// Column and row of the first pixel that differs.
    pub(crate) first: Option<(u32, u32)>,
}

/// `image_io::compare`.
pub(crate) fn compare(_: &Picture, _: &Picture) -> Result<Difference, NotYet> {
    Err(NotYet)
}

/// `image_io::difference_picture`.
pub(crate) fn difference_picture(a: &Picture, _: &Picture) -> Picture {
    a.clone()
}

/// `assets::generate::Kind`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A ball of triangles.
    Icosphere,
    /// A knotted tube.
    Knot,
    /// Displaced terrain.
    Terrain,
    /// A columned hall with fine and coarse triangles.
    Hall,
    /// Triangles anywhere.
    Soup,
}

impl Kind {
    /// All of them.
    pub(crate) const ALL: [Self; 5] =
        [Self::Icosphere, Self::Knot, Self::Terrain, Self::Hall, Self::Soup];

    /// The name on the command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Icosphere => "icosphere",
            Self::Knot => "knot",
            Self::Terrain => "terrain",
            Self::Hall => "hall",
            Self::Soup => "soup",
        }
    }
}

/// `assets::generate` and `MeshData::to_obj`.
pub(crate) fn write_mesh(_: Kind, _: u32, _: u64, _: &mut impl Write) -> io::Result<()> {
    Err(io::Error::other(NotYet))
}

/// `scene::Structure`: a line of the table of structures.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Structure {
    /// The name on the command line.
    pub(crate) name: &'static str,
    /// What it is, in a line.
    pub(crate) summary: &'static str,
}

/// `scene::STRUCTURES`.
pub(crate) const STRUCTURES: &[Structure] = &[
    Structure { name: "none", summary: "every primitive is tested against every ray" },
    Structure { name: "ball", summary: "one bounding ball around each mesh" },
    Structure { name: "bvh", summary: "a binary tree of boxes" },
    Structure { name: "cwbvh", summary: "a compressed tree of boxes, eight to a node" },
];

/// A rendering and its figures.
pub(crate) struct Traced {
    /// What was rendered.
    pub(crate) picture: Picture,
    /// What it took.
    pub(crate) report: Report,
}

/// Parse, load, build, render: what `render.rs` will do itself.
pub(crate) fn trace(
    source: &str,
    options: &RenderOptions,
    interrupt: &Interrupt,
) -> Result<Traced, NotYet> {
    let size = source.len() as u64;
    let progress = Progress::start(size, options.quiet, interrupt.clone());
    progress.tile_done(size, 0);
    if progress.cancelled() {
        let picture = Picture { width: 0, height: 0, pixels: Vec::new() };
        let rays = vec![RayClass { name: "view", rays: 0, counts: None }];
        return Ok(Traced { picture, report: Report { rays, ..Report::default() } });
    }
    Err(NotYet)
}
