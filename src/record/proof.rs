//! The proof that all structures did the same work: equal pictures, equal hits.

use serde::{Deserialize, Serialize};

/// What was compared with the reference's results.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Proof {
    /// The structure whose results all others must equal.
    pub reference: String,
    /// A structure that agrees with the reference on all rays that the reference had time for, and gives the expected
    /// results for the remaining rays; absent if the reference had time for all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub witness: Option<String>,
    /// The structures that were checked, the reference included.
    pub structures: Vec<StructureProof>,
    /// The peers, whose results need not be equal.
    #[serde(default, alias = "yardsticks")]
    pub peers: Vec<PeerAgreement>,
}

impl Proof {
    /// Whether nothing differed.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.structures.iter().all(StructureProof::holds)
    }

    /// The entry of a peer.
    #[must_use]
    pub fn peer(&self, name: &str) -> Option<&PeerAgreement> {
        self.peers.iter().find(|entry| entry.structure == name)
    }

    /// The entry of a structure.
    #[must_use]
    pub fn structure(&self, name: &str) -> Option<&StructureProof> {
        self.structures.iter().find(|entry| entry.structure == name)
    }
}

/// How a structure's results differ from the reference's.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StructureProof {
    /// The structure.
    pub structure: String,
    /// SHA-256 of its picture, computed as [`PictureFile::hash`](super::PictureFile::hash); absent if it rendered none.
    pub picture_hash: Option<String>,
    /// Whether its picture equals the reference's, bit for bit; absent if either rendered none.
    pub picture_equal: Option<bool>,
    /// Width and height of the pictures that were compared, which are smaller than the scene's where there was no time
    /// for that; absent if none were, and in older records.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub picture_size: Option<[u32; 2]>,
    /// Pixels with a different bit.
    pub differing_pixels: u64,
    /// The largest difference in a channel of a pixel, in linear units.
    pub largest_difference: f64,
    /// Recorded rays whose results were compared, with the reference's or with the witness's.
    pub rays_checked: u64,
    /// How many of these results differed: another distance, object, primitive or place on it.
    pub differing_hits: u64,
    /// The first ray with a different result, and both results, in words.
    pub first_difference: Option<String>,
}

impl StructureProof {
    /// Whether nothing differed.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.picture_equal != Some(false) && self.differing_pixels == 0 && self.differing_hits == 0
    }
}

/// How a peer's results agree with the reference's. A peer has formulas of its own, so the last bits of its hits and
/// pictures differ.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PeerAgreement {
    /// The peer.
    pub structure: String,
    /// Recorded rays whose results were compared.
    pub rays_checked: u64,
    /// How many of these results agree: the same primitive, a distance that is close, or both no hit; for shadow rays
    /// the same result.
    pub rays_agreeing: u64,
    /// The largest difference of close distances, as a share of the larger one.
    pub close: f32,
}

impl PeerAgreement {
    /// The share of the results that agree, from 0 to 1; `None` if none was compared.
    #[must_use]
    pub fn share(&self) -> Option<f64> {
        (self.rays_checked > 0).then(|| self.rays_agreeing as f64 / self.rays_checked as f64)
    }
}
