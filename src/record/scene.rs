//! A scene, and what all structures did with it.

use serde::{Deserialize, Serialize};

use super::{Proof, StructureRecord};

/// A scene of the comparison.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SceneRecord {
    /// A short name, different from that of every other scene.
    pub name: String,
    /// The scene's file, as typed.
    pub path: String,
    /// SHA-256 of the scene's file and of all files that it names.
    pub hash: String,
    /// Objects in the scene.
    pub objects: u64,
    /// Triangles in the scene, those of a mesh for each object that is made of it.
    pub triangles: u64,
    /// Triangles that are stored, those of each mesh once; 0 in older records, which do not tell.
    #[serde(default)]
    pub stored_triangles: u64,
    /// Lights in the scene.
    pub lights: u64,
    /// The picture as the reference rendered it.
    pub picture: Option<PictureFile>,
    /// That all structures gave the same picture and the same hits.
    pub proof: Option<Proof>,
    /// What the ends of the colours of all heatmaps of this scene stand for.
    pub heat_scale: Option<HeatScale>,
    /// The structures, in the order in which they were named.
    pub structures: Vec<StructureRecord>,
}

impl SceneRecord {
    /// The structure of a name.
    #[must_use]
    pub fn structure(&self, name: &str) -> Option<&StructureRecord> {
        self.structures.iter().find(|structure| structure.name == name)
    }
}

/// A picture in a PNG file that travels beside the record.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PictureFile {
    /// The name of the file, relative to the record's, with `/` between folders.
    pub file: String,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// SHA-256 of the pixels before they are rounded to bytes: row by row from the top left, red,
    /// green and blue as little-endian 32-bit floats.
    pub hash: String,
}

/// The colour scale (matplotlib's *inferno*) that the heatmaps of a scene share: tests of boxes
/// and primitives by all of a pixel's rays, per view sample.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct HeatScale {
    /// Tests at the darkest colour.
    pub low: f64,
    /// Tests at the brightest colour.
    pub high: f64,
    /// How colours are spaced between them.
    pub spacing: Spacing,
}

/// How a scale is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Spacing {
    /// Equal steps are equal differences.
    Linear,
    /// Equal steps are equal factors.
    Logarithmic,
}
