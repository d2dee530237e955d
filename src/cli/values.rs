//! Values of options that are more than a number: sizes, crops, times, percentages, and numbers with
//! a unit.

use std::fmt;
use std::net::{IpAddr, SocketAddr};
use std::str::FromStr;
use std::time::Duration;

use super::frames::{FrameRange, LAST_FRAME};
use crate::assets::generate::{MAX_TRIANGLES, read_count};
use crate::description::Camera;
use crate::film::{Crop, Share};
use crate::image_io::Tone;

/// A value that could not be read, and what would be right.
#[derive(Debug, thiserror::Error, PartialEq, Eq)]
pub(crate) enum ValueError {
    /// Not two numbers with an `x` between them.
    #[error("expected WIDTHxHEIGHT in pixels, such as 800x600")]
    SizeForm,
    /// A side of no or of too many pixels.
    #[error("width and height must lie between 1 and {}", Camera::MAX_SIDE)]
    SizeRange,
    /// Not four numbers with commas between them.
    #[error("expected four pixel coordinates x0,y0,x1,y1, such as 0,0,320,240")]
    CropForm,
    /// A crop without pixels.
    #[error("the crop is empty: x0 must be less than x1, and y0 less than y1")]
    CropEmpty,
    /// Not a number of triangles.
    #[error("expected a number such as 70000, 70k or 1M")]
    CountForm,
    /// None, or more than can be made.
    #[error("the number must lie between 1 and {MAX_TRIANGLES}")]
    CountRange,
    /// Not a whole number, or one out of bounds.
    #[error("expected a whole number from {least} to {most}")]
    Whole {
        /// The least that is allowed.
        least: u64,
        /// The most.
        most: u64,
    },
    /// Not a time.
    #[error("expected a number of seconds above 0, such as 90 or 2.5")]
    Seconds,
    /// Not a time with its unit.
    #[error("expected a time above 0 with its unit, such as 30s, 5m or 2h")]
    Time,
    /// Not a standard error.
    #[error("expected an error above 0 and below 1, such as 0.01")]
    Noise,
    /// Not a part of so many.
    #[error("expected a part and their number, such as 3/7, with at most {}", Share::MOST)]
    Share,
    /// Not two sizes of meshes.
    #[error("expected two numbers of triangles, the smaller first, up to 100M, such as 1k..10M")]
    Sizes,
    /// Not two frames.
    #[error("expected the first frame and the last, up to {LAST_FRAME}, such as 0..60")]
    Frames,
    /// Not a number of stops.
    #[error(
        "expected a number of stops from -{0} to {0}, such as -1.5: each doubles or halves the light",
        Tone::MAX_STOPS
    )]
    Stops,
    /// Not a place along a ray.
    #[error("expected a number from 0, at most 3.4e38")]
    RayEnd,
    /// Not the address of a machine.
    #[error("expected an address in digits, such as 127.0.0.1 for this machine alone")]
    Address,
    /// An address with a port.
    #[error("expected an address alone, such as 127.0.0.1: the port is given by --port")]
    AddressWithPort,
    /// Not a percentage.
    #[error("expected a percentage from 0, such as 10%")]
    Percent,
}

/// Width and height of a picture in pixels, each from 1 to [`Camera::MAX_SIDE`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Size {
    /// Width in pixels.
    pub(crate) width: u32,
    /// Height in pixels.
    pub(crate) height: u32,
}

impl FromStr for Size {
    type Err = ValueError;

    fn from_str(text: &str) -> Result<Self, ValueError> {
        let (width, height) = text.split_once(['x', 'X', '×']).ok_or(ValueError::SizeForm)?;
        let size = Self {
            width: number(width).ok_or(ValueError::SizeForm)?,
            height: number(height).ok_or(ValueError::SizeForm)?,
        };
        let sides = 1..=Camera::MAX_SIDE;
        let fits = sides.contains(&size.width) && sides.contains(&size.height);
        if fits { Ok(size) } else { Err(ValueError::SizeRange) }
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

/// Reads a crop, `x0,y0,x1,y1`; there is at least one pixel in it.
pub(super) fn crop(text: &str) -> Result<Crop, ValueError> {
    let values: Option<Vec<u32>> = text.split(',').map(number).collect();
    let Some(&[x0, y0, x1, y1]) = values.as_deref() else {
        return Err(ValueError::CropForm);
    };
    let crop = Crop { x0, y0, x1, y1 };
    if crop.is_empty() { Err(ValueError::CropEmpty) } else { Ok(crop) }
}

/// Reads a number of triangles: digits, and `k` or `M` for thousands or millions.
pub(super) fn triangles(text: &str) -> Result<u32, ValueError> {
    let count = read_count(text).ok_or(ValueError::CountForm)?;
    if (1..=MAX_TRIANGLES).contains(&count) { Ok(count) } else { Err(ValueError::CountRange) }
}

/// Reads whole numbers from `least` to `most`.
pub(super) fn whole<T: TryFrom<u64> + Clone + Send + Sync + 'static>(
    least: u64,
    most: u64,
) -> impl Fn(&str) -> Result<T, ValueError> + Clone + Send + Sync + 'static {
    move |text| {
        let number = text.trim().parse().ok().filter(|n| (least..=most).contains(n));
        number.and_then(|n| T::try_from(n).ok()).ok_or(ValueError::Whole { least, most })
    }
}

/// Reads a time in seconds, above 0 and at most a year.
pub(super) fn seconds(text: &str) -> Result<Duration, ValueError> {
    const YEAR: f64 = 366.0 * 86_400.0;
    let seconds: f64 = text.trim().parse().map_err(|_| ValueError::Seconds)?;
    let fits = seconds > 0.0 && seconds <= YEAR;
    if fits { Ok(Duration::from_secs_f64(seconds)) } else { Err(ValueError::Seconds) }
}

/// Reads a time with its unit, `30s`, `1.5m` or `2h`; a number alone is in seconds.
pub(super) fn time(text: &str) -> Result<Duration, ValueError> {
    let text = text.trim();
    let units = [("ms", 0.001), ("s", 1.0), ("m", 60.0), ("h", 3600.0)];
    let unit = units.iter().find_map(|(unit, length)| Some((text.strip_suffix(unit)?, length)));
    let (number, length) = unit.unwrap_or((text, &1.0));
    let number: f64 = number.trim_end().parse().map_err(|_| ValueError::Time)?;
    seconds(&(number * length).to_string()).map_err(|_| ValueError::Time)
}

/// Reads a standard error of a pixel's luminance.
pub(super) fn noise(text: &str) -> Result<f64, ValueError> {
    let noise = text.trim().parse().ok().filter(|&noise: &f64| noise > 0.0 && noise < 1.0);
    noise.ok_or(ValueError::Noise)
}

/// Reads a part of so many, `3/7`.
pub(super) fn share(text: &str) -> Result<Share, ValueError> {
    let (part, count) = text.split_once('/').ok_or(ValueError::Share)?;
    let (part, count) = (number(part), number(count));
    let (Some(part), Some(count)) = (part, count) else { return Err(ValueError::Share) };
    let fits = (1..=count).contains(&part) && count <= Share::MOST;
    if fits { Ok(Share { number: part, count }) } else { Err(ValueError::Share) }
}

/// Reads the address of a machine.
pub(super) fn address(text: &str) -> Result<IpAddr, ValueError> {
    let has_port = text.parse::<SocketAddr>().is_ok();
    let error = if has_port { ValueError::AddressWithPort } else { ValueError::Address };
    text.trim().parse().map_err(|_| error)
}

/// Reads where a ray begins or ends, in units of its direction.
pub(super) fn ray_end(text: &str) -> Result<f32, ValueError> {
    let end = text.trim().parse().ok().filter(|end| (0.0..=f32::MAX).contains(end));
    end.ok_or(ValueError::RayEnd)
}

/// Reads two sizes of meshes, `1k..10M`.
pub(super) fn sizes(text: &str) -> Result<(u32, u32), ValueError> {
    let (first, last) = text.split_once("..").ok_or(ValueError::Sizes)?;
    let first = triangles(first.trim()).map_err(|_| ValueError::Sizes)?;
    let last = triangles(last.trim()).map_err(|_| ValueError::Sizes)?;
    if first <= last { Ok((first, last)) } else { Err(ValueError::Sizes) }
}

/// Reads the first frame and the last, `0..60`.
pub(super) fn frames(text: &str) -> Result<FrameRange, ValueError> {
    let (first, last) = text.split_once("..").ok_or(ValueError::Frames)?;
    let (Some(first), Some(last)) = (number(first), number(last)) else {
        return Err(ValueError::Frames);
    };
    let fits = first <= last && last <= LAST_FRAME;
    if fits { Ok(FrameRange { first, last }) } else { Err(ValueError::Frames) }
}

/// Reads an exposure in stops.
pub(super) fn stops(text: &str) -> Result<f32, ValueError> {
    let stops: f32 = text.trim().parse().map_err(|_| ValueError::Stops)?;
    // Neither infinities nor NaN are at most anything.
    if stops.abs() <= Tone::MAX_STOPS { Ok(stops) } else { Err(ValueError::Stops) }
}

/// Reads a percentage, `10%` or `10`, as a share: 0.1.
pub(super) fn percent(text: &str) -> Result<f64, ValueError> {
    let text = text.trim();
    let number = text.strip_suffix('%').unwrap_or(text).trim_end();
    let percent: f64 = number.parse().map_err(|_| ValueError::Percent)?;
    let fits = percent.is_finite() && percent >= 0.0;
    if fits { Ok(percent / 100.0) } else { Err(ValueError::Percent) }
}

/// A number of digits alone (Rust's own parser would also take `+3`); too large ones saturate, so
/// that they meet the message about ranges.
fn number(text: &str) -> Option<u32> {
    let text = text.trim();
    if text.is_empty() || !text.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    Some(text.parse().unwrap_or(u32::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_of_pictures() {
        assert_eq!("800x600".parse(), Ok(Size { width: 800, height: 600 }));
        assert_eq!("1X65535".parse(), Ok(Size { width: 1, height: 65_535 }));
        for bad in ["", "800", "800x", "x600", "-1x5", "+1x5", "8.5x4", "1x2x3", "axb"] {
            assert_eq!(bad.parse::<Size>(), Err(ValueError::SizeForm), "{bad}");
        }
        for bad in ["0x5", "5x0", "65536x1", "99999999999999x1"] {
            assert_eq!(bad.parse::<Size>(), Err(ValueError::SizeRange), "{bad}");
        }
    }

    #[test]
    fn crops() {
        assert_eq!(crop("1,2,3,4"), Ok(Crop { x0: 1, y0: 2, x1: 3, y1: 4 }));
        assert_eq!(crop("0, 0, 320, 240").unwrap().to_string(), "0,0,320,240");
        for bad in ["", "1,2,3", "1,2,3,4,5", "1,2,3,", "-1,0,3,4", "a,b,c,d"] {
            assert_eq!(crop(bad), Err(ValueError::CropForm), "{bad}");
        }
        for bad in ["3,0,3,4", "4,0,3,4", "0,4,3,4"] {
            assert_eq!(crop(bad), Err(ValueError::CropEmpty), "{bad}");
        }
    }

    #[test]
    fn numbers_of_triangles() {
        for (text, count) in [("1", 1), ("70000", 70_000), ("70k", 70_000), ("10M", 10_000_000)] {
            assert_eq!(triangles(text), Ok(count), "{text}");
        }
        for bad in ["", "k", "-5", "1.5k", "5kk", "many"] {
            assert_eq!(triangles(bad), Err(ValueError::CountForm), "{bad}");
        }
        for bad in ["0", "0k", "101M", "99999999999"] {
            assert_eq!(triangles(bad), Err(ValueError::CountRange), "{bad}");
        }
    }

    #[test]
    fn whole_numbers() {
        let read = whole::<u16>(1, 1024);
        assert_eq!((read("1"), read(" 1024 ")), (Ok(1), Ok(1024)));
        for bad in ["", "0", "1025", "-1", "1.5", "x", "99999999999999999999"] {
            let error = read(bad).unwrap_err().to_string();
            assert_eq!(error, "expected a whole number from 1 to 1024", "{bad}");
        }
        assert_eq!(whole::<u64>(0, u64::MAX)("18446744073709551615"), Ok(u64::MAX));
    }

    #[test]
    fn times_and_percentages() {
        assert_eq!(seconds("2.5"), Ok(Duration::from_millis(2_500)));
        for bad in ["", "0", "-1", "nan", "inf", "1e9", "ten"] {
            assert_eq!(seconds(bad), Err(ValueError::Seconds), "{bad}");
        }
        assert_eq!(sizes("1k..10M"), Ok((1_000, 10_000_000)));
        assert_eq!(sizes("5..5"), Ok((5, 5)));
        for bad in ["", "1k", "1k..", "10M..1k", "0..5", "1..1000M", "1..99999M", "a..b"] {
            assert_eq!(sizes(bad), Err(ValueError::Sizes), "{bad}");
        }
        assert_eq!((percent("10%"), percent("0"), percent("2.5 %")), (Ok(0.1), Ok(0.0), Ok(0.025)));
        for bad in ["", "%", "-1%", "nan", "inf%", "ten"] {
            assert_eq!(percent(bad), Err(ValueError::Percent), "{bad}");
        }
    }

    #[test]
    fn times_with_units_and_shares() {
        for (text, milliseconds) in
            [("30s", 30_000), ("1.5m", 90_000), ("2h", 7_200_000), ("9", 9_000), (" 50 ms ", 50)]
        {
            assert_eq!(time(text), Ok(Duration::from_millis(milliseconds)), "{text}");
        }
        for bad in ["", "s", "0s", "-1s", "nan", "infs", "5d", "1e9h", "3 0s x"] {
            assert_eq!(time(bad), Err(ValueError::Time), "{bad}");
        }
        assert_eq!(
            (share("3/7"), share("1/1")),
            (Ok(Share { number: 3, count: 7 }), share(" 1 / 1 "))
        );
        for bad in ["", "3", "/", "0/7", "8/7", "-1/7", "1/0", "1/1000001", "1/7/9", "a/b"] {
            assert_eq!(share(bad), Err(ValueError::Share), "{bad}");
        }
        assert_eq!(noise("0.01"), Ok(0.01));
        for bad in ["", "0", "1", "-0.1", "nan", "x"] {
            assert_eq!(noise(bad), Err(ValueError::Noise), "{bad}");
        }
    }

    #[test]
    fn exposures() {
        let read = ["0", "-0", "1.5", "-32", "+2", " .5 "].map(stops);
        assert_eq!(read, [0.0, 0.0, 1.5, -32.0, 2.0, 0.5].map(Ok));
        for bad in ["", "EV", "32.5", "-33", "nan", "inf", "-inf", "1e9", "1,5", "2EV"] {
            let error = stops(bad).unwrap_err().to_string();
            assert!(
                error.starts_with("expected a number of stops from -32 to 32"),
                "{bad}: {error}"
            );
        }
    }

    #[test]
    fn a_crop_may_touch_the_far_edges() {
        let within = |text| crop(text).unwrap().is_within(3, 4);
        assert!(within("0,0,3,4"));
        assert!(!within("0,0,4,4"));
        assert!(!within("0,0,3,5"));
    }
}
