//! A scene, and what was measured of all structures over it.

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
    /// Triangles in the scene; those of a mesh count once for each object with that mesh.
    pub triangles: u64,
    /// Triangles in memory; those of a mesh count once. 0 in older records, which do not have this field.
    #[serde(default)]
    pub stored_triangles: u64,
    /// Lights in the scene.
    pub lights: u64,
    /// The recorded rays, where they were written to a file or read from one; absent in older records.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rays: Option<RecordedRays>,
    /// The picture that the reference rendered.
    pub picture: Option<PictureFile>,
    /// The proof that all structures gave the same picture and the same hits.
    pub proof: Option<Proof>,
    /// The colour scale of all heatmaps of this scene.
    pub heat_scale: Option<HeatScale>,
    /// Whether the structures were built anew for each pass over the rays, so that intervals include the effect of
    /// their place in memory; false in older records, and where builds take too long.
    #[serde(default)]
    pub built_anew: bool,
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

/// Recorded rays in a file, by which they can be cited and traced by others.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct RecordedRays {
    /// SHA-256 of all rays and their answers, which ends the file.
    pub hash: String,
    /// SHA-256 of the scene's geometry.
    pub geometry: String,
    /// Whether the rays were read from the file; else they were written to it.
    pub replayed: bool,
}

/// A picture in a PNG file beside the record.
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

/// The colour scale (matplotlib's *inferno*) of all heatmaps of a scene: box and primitive tests of all of a pixel's
/// rays, per view sample.
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Spacing {
    /// Equal steps are equal differences.
    #[default]
    Linear,
    /// Equal steps are equal factors.
    Logarithmic,
}
