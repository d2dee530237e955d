//! The frames of a scene that moves: which ones, and the pictures that they go to.

use std::fmt;
use std::path::{Path, PathBuf};

use super::exit::Failure;

/// The last frame that there is.
pub(crate) const LAST_FRAME: u32 = 99_999_999;

/// What stands for the number of a frame in the name of a picture: this, any number of times.
const PLACE: char = '#';

/// The frames from one to another, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FrameRange {
    /// The first.
    pub(crate) first: u32,
    /// The last: the first, or a later one.
    pub(crate) last: u32,
}

impl FrameRange {
    /// The numbers of the frames.
    pub(crate) fn numbers(self) -> std::ops::RangeInclusive<u32> {
        self.first..=self.last
    }
}

impl fmt::Display for FrameRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..{}", self.first, self.last)
    }
}

/// The names of the pictures of several frames: a path with a place for the number in the name of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct FrameNames {
    folder: PathBuf,
    before: String,
    digits: usize,
    behind: String,
}

impl FrameNames {
    /// The names that a path describes; `None` if it has no place for a number. Of several places the last one counts.
    pub(crate) fn of(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_str()?;
        let end = name.rfind(PLACE)? + PLACE.len_utf8();
        let before = name[..end].trim_end_matches(PLACE);
        Some(Self {
            folder: path.parent().unwrap_or(Path::new("")).to_owned(),
            before: before.to_owned(),
            digits: end - before.len(),
            behind: name[end..].to_owned(),
        })
    }

    /// The name of a frame's picture. A number that is longer than its place takes what it needs.
    pub(crate) fn of_frame(&self, frame: u32) -> PathBuf {
        let Self { folder, before, digits, behind } = self;
        folder.join(format!("{before}{frame:0digits$}{behind}"))
    }
}

/// The path of one picture: of a frame that was typed the number is put into its place. `#` alone may be a part of a
/// name where no frame was typed; more of them are not meant to be.
pub(crate) fn path_of_picture(path: PathBuf, frame: Option<u32>) -> Result<PathBuf, Failure> {
    match (FrameNames::of(&path), frame) {
        (Some(names), Some(frame)) => Ok(names.of_frame(frame)),
        (Some(names), None) if names.digits > 1 => Err(Failure::new(format_args!(
            "`{}` in the name of the output stands for the number of a frame: add `--frames 0..60`, or `--frame 12` \
             for one of them",
            PLACE.to_string().repeat(names.digits),
        ))),
        _ => Ok(path),
    }
}

/// The names of the pictures of several frames.
pub(crate) fn names_of_pictures(path: &Path) -> Result<FrameNames, Failure> {
    FrameNames::of(path).ok_or_else(|| {
        Failure::new(format_args!(
            "the output `{}` has no place for the number of a frame: put `####` into the name of the file, as in \
             frames/####.png",
            path.display(),
        ))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(path: &str, frame: u32) -> Option<String> {
        FrameNames::of(Path::new(path)).map(|names| names.of_frame(frame).display().to_string())
    }

    #[test]
    fn numbers_stand_in_their_places() {
        assert_eq!(name("frames/####.png", 7).as_deref(), Some("frames/0007.png"));
        assert_eq!(name("a-##b.exr", 7).as_deref(), Some("a-07b.exr"));
        assert_eq!(name("a#.png", 1234).as_deref(), Some("a1234.png"));
        assert_eq!(name("a#1-###.png", 5).as_deref(), Some("a#1-005.png"));
        assert_eq!(name("frames##/a.png", 5), None);
        assert_eq!(name("-", 5), None);
    }

    #[test]
    fn one_picture_has_a_frame_or_no_place_for_one() {
        let path = |path: &str, frame| path_of_picture(path.into(), frame);
        assert_eq!(path("a-##.png", Some(3)).unwrap(), Path::new("a-03.png"));
        assert_eq!(path("a.png", Some(3)).unwrap(), Path::new("a.png"));
        assert_eq!(path("song#1.png", None).unwrap(), Path::new("song#1.png"));
        assert!(path("a-##.png", None).unwrap_err().to_string().contains("`##`"));
        assert!(names_of_pictures(Path::new("a.png")).unwrap_err().to_string().contains("####"));
    }
}
