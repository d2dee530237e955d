//! Parts of a picture ↔ bytes: what a machine sends of it, and what a rendering leaves to go on from.
//!
//! A [`PartFile`] has parts as a [`Film`](crate::film::Film) takes them, and what they are of: the hash of the scene,
//! the settings, and the version of the renderer ([`Origin`]). Parts of different origins are not parts of one picture.
//! Its bytes end with a hash of all of them. `docs/part-file.md` describes the form byte by byte. Nothing here opens a
//! file.
//!
//! ```
//! use srt::film::{Crop, Part, Piece, Share, Values};
//! use srt::math::Color;
//! use srt::part_file::{Kind, Origin, PartFile};
//! use srt::render::{Sampling, Settings, View};
//!
//! let settings = Settings {
//!     width: 2, height: 1, crop: None, aa: 0, light_samples: 1, sampling: Sampling::Shuffled,
//!     max_recursion: 1, seed: 0, view: View::Color, count: false,
//! };
//! let origin = Origin { scene: [1; 32], sources: [2; 32], version: "0.1.0".to_owned(), settings };
//! let piece = Piece { area: Crop { x0: 0, y0: 0, x1: 2, y1: 1 }, samples: 0..1 };
//! let parts = vec![Part { piece, values: Values::Sums(vec![Color::ONE, Color::X]) }];
//! let file = PartFile { origin, kind: Kind::Checkpoint, parts };
//! let mut bytes = Vec::new();
//! file.write(&mut bytes)?;
//! assert_eq!(PartFile::decode(&bytes)?, file);
//! bytes[200] ^= 1;
//! assert!(PartFile::decode(&bytes).unwrap_err().to_string().contains("was altered"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod decode;
mod encode;
mod error;
mod header;
mod origin;

use crate::film::{Division, Part, Share};

pub use crate::sealed::Hash;
pub use error::PartFileError;
pub use origin::{Difference, Origin};

/// How the name of a part's file ends.
pub const EXTENSION: &str = "srtp";

/// How a file begins.
const MAGIC: [u8; 8] = *b"srt-part";

/// The version of the form.
const VERSION: u32 = 1;

/// Bytes before the table of parts.
const HEADER: usize = 160;

/// Bytes of an entry of the table.
const ENTRY: usize = 32;

/// Bytes of a colour, and of the moments of a pixel.
const COLOR: usize = 12;
const MOMENTS: usize = 16;

/// The numbers of the forms of values in the table.
const SUMS: u32 = 0;
const SAMPLES: u32 = 1;
const SUMS_AND_MOMENTS: u32 = 2;

/// Parts of a picture, and what it is a picture of.
#[derive(Clone, Debug, PartialEq)]
pub struct PartFile {
    /// What the picture depends on.
    pub origin: Origin,
    /// Which of its parts these are.
    pub kind: Kind,
    /// The parts: tiles of the picture, with samples that each may have.
    pub parts: Vec<Part>,
}

/// Which parts of a picture a file has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Those that were done when it was written.
    Checkpoint,
    /// A machine's share.
    Part {
        /// How the picture is divided.
        division: Division,
        /// Which part it is.
        share: Share,
    },
}
