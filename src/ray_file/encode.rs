//! Rays → bytes.

use sha2::{Digest, Sha256};

use super::{
    ClassRays, ENTRY, HEADER, Hash, MAGIC, RAY, RAYS_PER_CALL, RayAnswers, RayFile, VERSION,
};
use crate::record::RayClass;

impl RayFile {
    /// The bytes of the file.
    ///
    /// # Panics
    /// If a class has not as many answers as rays.
    #[must_use]
    pub fn encode(&self) -> Vec<u8> {
        let data: usize = self.classes.iter().map(bytes_of_class).sum();
        let mut bytes = Vec::with_capacity(HEADER + data + size_of::<Hash>());
        bytes.extend(MAGIC);
        bytes.extend(VERSION.to_le_bytes());
        bytes.extend((self.classes.len() as u32).to_le_bytes());
        bytes.extend(self.geometry);
        bytes.extend(RAYS_PER_CALL.to_le_bytes());
        bytes.extend([0; 4]);
        for own in &self.classes {
            assert_eq!(own.rays.len(), own.answers.len(), "an answer for each ray");
            bytes.extend([code(own.class), own.answers.code_and_size().0]);
            bytes.extend([0; 6]);
            bytes.extend((own.rays.len() as u64).to_le_bytes());
        }
        for own in &self.classes {
            for ray in &own.rays {
                ray.to_array().iter().for_each(|number| bytes.extend(number.to_le_bytes()));
            }
            add_answers(&own.answers, &mut bytes);
        }
        let hash: Hash = Sha256::digest(&bytes).into();
        bytes.extend(hash);
        bytes
    }

    /// The hash of the contents, which ends the file, and by which the rays are cited.
    ///
    /// # Panics
    /// As [`encode`](Self::encode).
    #[must_use]
    pub fn hash(&self) -> Hash {
        hash_of(&self.encode()).unwrap_or_default()
    }
}

/// The hash at the end of a file's bytes.
pub(super) fn hash_of(bytes: &[u8]) -> Option<Hash> {
    bytes.last_chunk().copied()
}

/// The number of a class in files: its place in [`RayClass::ALL`].
fn code(class: RayClass) -> u8 {
    class as u8
}

fn bytes_of_class(own: &ClassRays) -> usize {
    ENTRY + own.rays.len() * (RAY + own.answers.code_and_size().1)
}

fn add_answers(answers: &RayAnswers, bytes: &mut Vec<u8>) {
    match answers {
        RayAnswers::ClosestHit(hits) => {
            for hit in hits {
                bytes.extend(hit.t.to_le_bytes());
                bytes.extend(hit.object.to_le_bytes());
                bytes.extend(hit.prim.to_le_bytes());
                bytes.extend(hit.u.to_le_bytes());
                bytes.extend(hit.v.to_le_bytes());
            }
        }
        RayAnswers::AnyHit(blocked) => {
            bytes.extend(blocked.iter().map(|&blocked| u8::from(blocked)));
        }
    }
}
