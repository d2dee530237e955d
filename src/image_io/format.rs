//! The picture formats, by the extension of their files.

use std::fmt;
use std::path::Path;

use thiserror::Error;

/// A way to write a picture as bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Truevision TGA as the course wrote it: 24 bit, uncompressed, rows from the bottom.
    Tga,
    /// Portable Network Graphics, 8 bits a channel.
    Png,
    /// Binary portable pixmap (`P6`), 8 bits a channel.
    Ppm,
    /// OpenEXR: linear 32 bit floats.
    Exr,
    /// Radiance: linear, 8 bits of mantissa and a shared exponent.
    Hdr,
}

impl Format {
    /// All formats, in the order in which they are listed.
    pub const ALL: [Self; 5] = [Self::Tga, Self::Png, Self::Ppm, Self::Exr, Self::Hdr];

    /// The format that a path's extension names, in capitals or not.
    ///
    /// # Errors
    /// If there is no extension, or none that is known.
    pub fn from_path(path: &Path) -> Result<Self, UnknownFormat> {
        match path.extension() {
            Some(extension) => Self::from_name(&extension.to_string_lossy()),
            None => Err(UnknownFormat { found: None, suggestion: None }),
        }
    }

    /// The format of a name, in capitals or not.
    ///
    /// # Errors
    /// If the name is not one of [`Format::ALL`].
    pub fn from_name(name: &str) -> Result<Self, UnknownFormat> {
        let lower = name.to_ascii_lowercase();
        Self::ALL.into_iter().find(|format| format.name() == lower).ok_or_else(|| UnknownFormat {
            suggestion: nearest(&lower),
            found: Some(name.to_owned()),
        })
    }

    /// The extension of its files, in small letters and without the point.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Tga => "tga",
            Self::Png => "png",
            Self::Ppm => "ppm",
            Self::Exr => "exr",
            Self::Hdr => "hdr",
        }
    }

    /// Whether values beyond 1 survive: linear floats, where the others have clamped bytes.
    #[must_use]
    pub fn is_linear(self) -> bool {
        matches!(self, Self::Exr | Self::Hdr)
    }

    /// The format as the image crate calls it.
    pub(super) fn of_image_crate(self) -> image::ImageFormat {
        match self {
            Self::Tga => image::ImageFormat::Tga,
            Self::Png => image::ImageFormat::Png,
            Self::Ppm => image::ImageFormat::Pnm,
            Self::Exr => image::ImageFormat::OpenExr,
            Self::Hdr => image::ImageFormat::Hdr,
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The format that a name with one slip, or another common name, probably means.
fn nearest(name: &str) -> Option<Format> {
    if matches!(name, "targa" | "icb" | "vda") {
        return Some(Format::Tga);
    }
    let distance = |format: &Format| strsim::osa_distance(format.name(), name);
    Format::ALL.into_iter().min_by_key(distance).filter(|format| distance(format) <= 1)
}

/// No picture format has this name.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{}; known are .tga, .png, .ppm, .exr and .hdr{}", self.what(), self.hint())]
pub struct UnknownFormat {
    /// The extension or name, as it was given; `None` where a path had none.
    pub found: Option<String>,
    /// The format that was probably meant.
    pub suggestion: Option<Format>,
}

impl UnknownFormat {
    fn what(&self) -> String {
        match &self.found {
            Some(name) => format!("unknown picture format `.{name}`"),
            None => "the name has no extension that gives the picture format".to_owned(),
        }
    }

    fn hint(&self) -> String {
        self.suggestion.map_or_else(String::new, |format| format!(" (did you mean `.{format}`?)"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extension_decides_in_capitals_or_not() {
        for format in Format::ALL {
            assert_eq!(
                Format::from_path(Path::new("a/b.c").with_extension(format.name()).as_path()),
                Ok(format)
            );
            assert_eq!(Format::from_name(&format.name().to_uppercase()), Ok(format));
        }
        assert_eq!(Format::ALL.map(Format::is_linear), [false, false, false, true, true]);
    }

    #[test]
    fn an_unknown_extension_lists_the_known_ones() {
        let error = |path: &str| Format::from_path(Path::new(path)).unwrap_err().to_string();
        assert_eq!(
            error("out.pgn"),
            "unknown picture format `.pgn`; known are .tga, .png, .ppm, .exr and .hdr (did you mean `.png`?)"
        );
        assert_eq!(
            error("out.jpeg"),
            "unknown picture format `.jpeg`; known are .tga, .png, .ppm, .exr and .hdr"
        );
        assert!(error("out").starts_with("the name has no extension"));
        assert!(error("picture.targa").contains("did you mean `.tga`?"));
    }
}
