//! Pixels ↔ bytes, by format. Knows no files: bytes come and go in memory.

mod picture;

pub use picture::Picture;
