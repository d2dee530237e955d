//! What a picture depends on, as parts state it, so that only parts of one picture are put together.

use std::fmt;

use sha2::{Digest, Sha256};

use super::{Hash, header};
use crate::render::Settings;
use crate::sealed::hexadecimal;

/// What a picture depends on. Structures, threads and instruction sets are not among it: they do not change a bit.
#[derive(Clone, Debug, PartialEq)]
pub struct Origin {
    /// SHA-256 of the scene: its text, and its meshes as they were loaded.
    pub scene: Hash,
    /// SHA-256 of the renderer's sources.
    pub sources: Hash,
    /// The renderer's version: at most 16 printable ASCII characters.
    pub version: String,
    /// All settings; `count`, which changes no picture, is false in a file. A view is not the heatmap.
    pub settings: Settings,
}

/// The first thing in which two origins differ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    what: &'static str,
    other: String,
    own: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} in place of {}", self.what, self.other, self.own)
    }
}

impl Origin {
    /// SHA-256 of all of it: equal of the parts of one picture, and of no others.
    #[must_use]
    pub fn hash(&self) -> Hash {
        let mut bytes = Vec::new();
        header::add_origin(self, &mut bytes);
        Sha256::digest(&bytes).into()
    }

    /// In what another origin differs from this one first, if it does.
    #[must_use]
    pub fn difference(&self, other: &Self) -> Option<Difference> {
        let differs = |what, own: String, other: String| {
            (own != other).then_some(Difference { what, other, own })
        };
        let (a, b) = (&self.settings, &other.settings);
        differs("a renderer of version", self.version.clone(), other.version.clone())
            .or_else(|| differs("a renderer of sources", hex(&self.sources), hex(&other.sources)))
            .or_else(|| differs("a scene with hash", hex(&self.scene), hex(&other.scene)))
            .or_else(|| differs("a size of", size(a), size(b)))
            .or_else(|| differs("the crop", a.region().to_string(), b.region().to_string()))
            .or_else(|| differs("--view", a.view.name().to_owned(), b.view.name().to_owned()))
            .or_else(|| differs("--aa", a.aa.to_string(), b.aa.to_string()))
            .or_else(|| {
                differs("--light-samples", a.light_samples.to_string(), b.light_samples.to_string())
            })
            .or_else(|| {
                let name = |settings: &Settings| settings.sampling.name().to_owned();
                differs("--sampling", name(a), name(b))
            })
            .or_else(|| {
                differs("--max-recursion", a.max_recursion.to_string(), b.max_recursion.to_string())
            })
            .or_else(|| differs("--seed", a.seed.to_string(), b.seed.to_string()))
    }
}

fn size(settings: &Settings) -> String {
    format!("{}x{}", settings.width, settings.height)
}

/// The first digits of a hash, enough to tell two apart.
fn hex(hash: &Hash) -> String {
    hexadecimal(&hash[..8]) + "…"
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::Crop;
    use crate::render::{Sampling, View};

    fn origin() -> Origin {
        let settings = Settings {
            width: 40,
            height: 30,
            crop: None,
            aa: 2,
            light_samples: 1,
            sampling: Sampling::Shuffled,
            max_recursion: 3,
            seed: 7,
            view: View::Color,
            count: false,
        };
        Origin { scene: [1; 32], sources: [2; 32], version: "0.1.0".to_owned(), settings }
    }

    #[test]
    fn all_that_changes_a_picture_is_named_and_changes_the_hash() {
        let own = origin();
        type Change = fn(&mut Origin);
        let changes: [(&str, Change); 11] = [
            ("a renderer of version 0.2.0 in place of 0.1.0", |o| o.version = "0.2.0".to_owned()),
            ("a renderer of sources 0303", |o| o.sources = [3; 32]),
            ("a scene with hash 0404040404040404… in place of 0101", |o| o.scene = [4; 32]),
            ("a size of 41x30 in place of 40x30", |o| o.settings.width = 41),
            ("the crop 0,0,9,9 in place of 0,0,40,30", |o| {
                o.settings.crop = Some(Crop { x0: 0, y0: 0, x1: 9, y1: 9 });
            }),
            ("--view depth in place of color", |o| o.settings.view = View::Depth),
            ("--aa 3 in place of 2", |o| o.settings.aa = 3),
            ("--light-samples 2 in place of 1", |o| o.settings.light_samples = 2),
            ("--sampling independent", |o| o.settings.sampling = Sampling::Independent),
            ("--max-recursion 4 in place of 3", |o| o.settings.max_recursion = 4),
            ("--seed 8 in place of 7", |o| o.settings.seed = 8),
        ];
        for (text, change) in changes {
            let mut other = origin();
            change(&mut other);
            let difference = own.difference(&other).unwrap().to_string();
            assert!(difference.starts_with(text), "{difference}");
            assert_ne!(own.hash(), other.hash(), "{text}");
        }
        let mut same = origin();
        same.settings.crop = Some(same.settings.region());
        same.settings.count = true;
        assert_eq!((own.difference(&same), own.hash() == same.hash()), (None, true));
    }
}
