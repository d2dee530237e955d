//! What a check compared, as far as it came.

use std::fmt;

/// What was compared, with no difference.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// Meshes of which all rays were compared. A mesh counts once for each scale and place that it is put in, and once
    /// more where it was traced in another way than in packs of triangles.
    pub meshes: usize,
    /// Meshes of the whole check: more than `meshes` if it was ended before.
    pub all_meshes: usize,
    /// Rays, each searched for its closest and for any hit, in slices and alone.
    pub rays: usize,
    /// How many of them hit something.
    pub hits: usize,
}

impl Summary {
    /// Whether all rays of all meshes were compared.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.meshes == self.all_meshes
    }

    /// This and another check of the same structure.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            meshes: self.meshes + other.meshes,
            all_meshes: self.all_meshes + other.all_meshes,
            rays: self.rays + other.rays,
            hits: self.hits + other.hits,
        }
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { meshes, all_meshes, rays, hits } = self;
        if self.is_whole() {
            return write!(
                f,
                "{rays} rays at {meshes} meshes, {hits} of them hits: all results are equal"
            );
        }
        write!(
            f,
            "{rays} rays, {hits} of them hits: no difference so far; ended with {meshes} of {all_meshes} meshes \
             compared in full"
        )
    }
}
