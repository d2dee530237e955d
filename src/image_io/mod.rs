//! Pixels ↔ bytes, by format; exposure, tone curves and clipping; and the difference of two pictures.
//!
//! Knows no files: bytes are in memory, and the caller decides where they are stored. Knows nothing
//! of scenes or rays either: a picture is a rectangle of linear colours.

mod clipping;
mod decode;
mod difference;
mod encode;
mod format;
mod picture;
mod quantize;
mod tone;

pub use clipping::{Clipping, exposure_that_holds};
pub use decode::{DecodeError, decode};
pub use difference::{Difference, SizeMismatch, compare, difference_picture};
pub use encode::{EncodeError, encode};
pub use format::{Format, UnknownFormat};
pub use picture::{Picture, WrongLength};
pub use quantize::rgba_bytes;
pub use tone::{Tone, ToneCurve};
