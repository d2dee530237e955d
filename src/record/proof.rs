//! That what was compared is the same work: equal pictures, equal hits.

use serde::{Deserialize, Serialize};

/// What all structures were held against.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Proof {
    /// The structure that the others had to agree with.
    pub reference: String,
    /// A structure that agreed with the reference wherever that had time, and answered for it on
    /// all other rays; absent where the reference had time for all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub witness: Option<String>,
    /// The structures that rendered, the reference included.
    pub structures: Vec<StructureProof>,
    /// The yardsticks, which are not held to equality.
    #[serde(default)]
    pub yardsticks: Vec<YardstickProof>,
}

impl Proof {
    /// Whether nothing differed anywhere.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.structures.iter().all(StructureProof::holds)
    }

    /// The entry of a yardstick.
    #[must_use]
    pub fn yardstick(&self, name: &str) -> Option<&YardstickProof> {
        self.yardsticks.iter().find(|entry| entry.structure == name)
    }

    /// The entry of a structure.
    #[must_use]
    pub fn structure(&self, name: &str) -> Option<&StructureProof> {
        self.structures.iter().find(|entry| entry.structure == name)
    }
}

/// How a structure's answers differ from the reference's.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StructureProof {
    /// The structure.
    pub structure: String,
    /// SHA-256 of its picture, made as [`PictureFile::hash`](super::PictureFile::hash); absent if
    /// it rendered none.
    pub picture_hash: Option<String>,
    /// Whether its picture is the reference's, bit for bit; absent if either rendered none.
    pub picture_equal: Option<bool>,
    /// Pixels of which a bit differs.
    pub differing_pixels: u64,
    /// The largest difference in a channel of a pixel, in linear units.
    pub largest_difference: f64,
    /// Recorded rays whose answers were compared, with the reference's or with the witness's.
    pub rays_checked: u64,
    /// How many of these answers differed: another distance, object, primitive or place on it.
    pub differing_hits: u64,
    /// The first ray that differed and both answers, in words.
    pub first_difference: Option<String>,
}

impl StructureProof {
    /// Whether nothing differed.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.picture_equal != Some(false) && self.differing_pixels == 0 && self.differing_hits == 0
    }
}

/// How a yardstick's answers agree with the reference's: its formulas are its own, so its hits and
/// pictures differ in their last bits.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct YardstickProof {
    /// The yardstick.
    pub structure: String,
    /// Recorded rays whose answers were compared.
    pub rays_checked: u64,
    /// How many of these answers agree: the same primitive, a distance that is close, or nothing;
    /// for shadow rays the same answer.
    pub rays_agreeing: u64,
    /// How far close distances may lie apart, as a share of the larger one.
    pub close: f32,
}

impl YardstickProof {
    /// The share of the answers that agree, from 0 to 1; `None` if none was compared.
    #[must_use]
    pub fn share(&self) -> Option<f64> {
        (self.rays_checked > 0).then(|| self.rays_agreeing as f64 / self.rays_checked as f64)
    }
}
