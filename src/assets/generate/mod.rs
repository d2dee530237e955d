//! Generated meshes: of any size, for scenes and measurements.
//!
//! One module a kind. A mesh is a function of (kind, number of triangles, seed) and of nothing else:
//! equal to the bit on every platform, since the arithmetic is that of `f64`, rounded once, and
//! powers, sines and cosines come from `libm` in Rust.

mod block;
mod grid;
mod hair;
mod hall;
mod icosphere;
mod noise;
mod recipe;
mod scan;
mod soup;
mod stadium;
mod teapot;
mod terrain;
mod torus_knot;

use std::fmt;

pub use crate::math::read_count;
pub use recipe::{Recipe, RecipeError};

use super::MeshData;

/// The kinds of meshes. All have z up, no degenerate triangle, and lie within [−1, 1]³.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MeshKind {
    /// The unit ball: 20·k² triangles, so within about 1/k of the requested number; closed.
    Icosphere,
    /// A trefoil tube of radius 0.12 in [−0.97, 0.97]² × [−0.37, 0.37]; closed.
    TorusKnot,
    /// A square [−1, 1]² displaced to heights within ±0.35 by fractal noise.
    Terrain,
    /// A room [−1, 1] × [−0.6, 0.6] × [0, 0.8] seen from inside: six faces of two triangles, and
    /// fluted columns, arches and vases of all the others.
    Hall,
    /// Random triangles in [−1, 1]³, shrinking as n^(−1/3) so that any number fills the cube alike.
    Soup,
    /// A coral like a brain, about as large as the unit ball: closed, with triangles of about one size all over its
    /// furrows, as a scanner gives them; 20·k² triangles.
    Scan,
    /// A teapot 1/100 as large as the stadium in whose middle it stands, [−1, 1] × [−0.75, 0.75] × [0, 0.25]: the
    /// stands are of few, long triangles, and the teapot of all others.
    Stadium,
    /// Strands on a ball of radius 0.42, each a curved strip of 16 long, thin triangles; none connected.
    Hair,
    /// The cube [−1, 1]³, each face of k² squares: 12·k² triangles; flat, open along its edges.
    Box,
}

impl MeshKind {
    /// All kinds, in the order in which they are listed.
    pub const ALL: [Self; 9] = [
        Self::Icosphere,
        Self::TorusKnot,
        Self::Terrain,
        Self::Hall,
        Self::Soup,
        Self::Scan,
        Self::Stadium,
        Self::Hair,
        Self::Box,
    ];

    /// Its name in scenes and on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Icosphere => "icosphere",
            Self::TorusKnot => "torus-knot",
            Self::Terrain => "terrain",
            Self::Hall => "hall",
            Self::Soup => "soup",
            Self::Scan => "scan",
            Self::Stadium => "stadium",
            Self::Hair => "hair",
            Self::Box => "box",
        }
    }

    /// Its description, in a line.
    #[must_use]
    pub fn description(self) -> &'static str {
        match self {
            Self::Icosphere => "a ball: a subdivided icosahedron, triangles of about one size",
            Self::TorusKnot => "a trefoil knot of a round tube, closed and smooth",
            Self::Terrain => "a square of land, displaced by fractal noise (chosen by the seed)",
            Self::Hall => "a columned hall: a few huge triangles, the others fine",
            Self::Soup => "random triangles in a cube (chosen by the seed), none connected",
            Self::Scan => {
                "a coral like a brain (chosen by the seed), closed, fine all over as scans are"
            }
            Self::Stadium => {
                "a fine teapot in a stadium a hundred times as large, of few long triangles"
            }
            Self::Hair => "strands on a ball (chosen by the seed), strips of long, thin triangles",
            Self::Box => "a cube, its faces divided evenly",
        }
    }

    /// The kind of this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

impl fmt::Display for MeshKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The most triangles that are generated: their indices fit in 32 bits for every kind.
pub const MAX_TRIANGLES: u32 = 100_000_000;

/// A mesh of about `triangles` triangles, at most [`MAX_TRIANGLES`].
///
/// For 1000 or more the number is met within 3 %, by the soup exactly; the icosphere and the scan take
/// the nearest 20·k² (within 15 % at 1000, 2 % at 70,000, 0.5 % at a million), the box the nearest
/// 12·k². Smaller numbers give the fewest that make the shape. The seed matters to the terrain, the
/// soup, the scan and the hair.
///
/// ```
/// use srt::assets::generate::{MeshKind, generate};
///
/// let ball = generate(MeshKind::Icosphere, 70_000, 0);
/// assert_eq!(ball.triangles.len(), 69_620);
/// ```
#[must_use]
pub fn generate(kind: MeshKind, triangles: u32, seed: u64) -> MeshData {
    let triangles = triangles.clamp(1, MAX_TRIANGLES);
    match kind {
        MeshKind::Icosphere => icosphere::generate(triangles),
        MeshKind::TorusKnot => torus_knot::generate(triangles),
        MeshKind::Terrain => terrain::generate(triangles, seed),
        MeshKind::Hall => hall::generate(triangles),
        MeshKind::Soup => soup::generate(triangles, seed),
        MeshKind::Scan => scan::generate(triangles, seed),
        MeshKind::Stadium => stadium::generate(triangles),
        MeshKind::Hair => hair::generate(triangles, seed),
        MeshKind::Box => block::generate(triangles),
    }
}

#[cfg(test)]
mod tests;
