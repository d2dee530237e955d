//! The header of a file, by its fields: written, and read with every value checked.

use super::{HEADER, Hash, Kind, MAGIC, Origin, PartFileError, VERSION};
use crate::description::{Camera, Options};
use crate::film::{Crop, Division, Share};
use crate::render::{Sampling, Settings, View};
use crate::sealed::{u32_at, u64_at};

/// Where fields are.
const ORIGIN: usize = 16;
const SOURCES: usize = 48;
const NAME: usize = 80;
const SIZE: usize = 96;
const REGION: usize = 104;
const AA: usize = 120;
const LIGHT_SAMPLES: usize = 124;
const RECURSION: usize = 128;
const CHOICES: usize = 132;
const SEED: usize = 136;
const KIND: usize = 144;
const NUMBER: usize = 148;
const COUNT: usize = 152;
const RESERVED: usize = 156;

/// The bytes of a version's name.
const NAME_LENGTH: usize = SIZE - NAME;

/// The numbers of kinds; those of divisions are 1 more than their places.
const CHECKPOINT: u8 = 0;

/// The views that parts may show, by their numbers: a heatmap is not what the scene looks like, but what a structure
/// tested.
const VIEWS: [View; 5] = [View::Color, View::Normal, View::Depth, View::Object, View::Primitive];

/// Appends the header of a file with so many parts.
pub(super) fn add_header(origin: &Origin, kind: Kind, parts: u32, bytes: &mut Vec<u8>) {
    bytes.extend(MAGIC);
    bytes.extend(VERSION.to_le_bytes());
    bytes.extend(parts.to_le_bytes());
    add_origin(origin, bytes);
    let (code, share) = match kind {
        Kind::Checkpoint => (CHECKPOINT, Share { number: 0, count: 0 }),
        Kind::Part { division, share } => (1 + division as u8, share),
    };
    bytes.extend([code, 0, 0, 0]);
    for number in [share.number, share.count, 0] {
        bytes.extend(number.to_le_bytes());
    }
}

/// Appends the bytes of an origin.
pub(super) fn add_origin(origin: &Origin, bytes: &mut Vec<u8>) {
    let Origin { scene, sources, version, settings } = origin;
    bytes.extend(scene);
    bytes.extend(sources);
    let mut name = [0; NAME_LENGTH];
    let length = version.len().min(NAME_LENGTH);
    name[..length].copy_from_slice(&version.as_bytes()[..length]);
    bytes.extend(name);
    let region = settings.region();
    for number in [
        settings.width,
        settings.height,
        region.x0,
        region.y0,
        region.x1,
        region.y1,
        settings.aa,
        settings.light_samples,
        settings.max_recursion,
    ] {
        bytes.extend(number.to_le_bytes());
    }
    let view = VIEWS.iter().position(|&view| view == settings.view).unwrap_or(VIEWS.len());
    bytes.extend([view as u8, settings.sampling as u8, 0, 0]);
    bytes.extend(settings.seed.to_le_bytes());
}

/// Reads a header whose magic and version were checked.
pub(super) fn read(header: &[u8; HEADER]) -> Result<(Origin, Kind), PartFileError> {
    let number = |at: usize| u32_at(header, at);
    let wrong = |at, what| PartFileError::Header { at, what };
    let within = |at, what, least: u32, most: u32| {
        let found = number(at);
        if (least..=most).contains(&found) { Ok(found) } else { Err(wrong(at, what)) }
    };
    let side = |at| within(at, "size of the picture", 1, Camera::MAX_SIDE);
    let (width, height) = (side(SIZE)?, side(SIZE + 4)?);
    let [x0, y0, x1, y1] = [0, 4, 8, 12].map(|behind| number(REGION + behind));
    let region = Crop { x0, y0, x1, y1 };
    let is_region = !region.is_empty()
        && region.is_within(width, height)
        && region.pixels() <= Settings::MAX_PIXELS;
    if !is_region {
        return Err(wrong(REGION, "region"));
    }
    let crop = (region != Crop { x0: 0, y0: 0, x1: width, y1: height }).then_some(region);
    let (aa, light_samples) = (
        within(AA, "samples of a pixel", 0, Options::MAX_AA)?,
        within(LIGHT_SAMPLES, "samples of a light", 1, Settings::MAX_LIGHT_SIDE)?,
    );
    let max_recursion = within(RECURSION, "depth of recursion", 0, Options::MAX_RECURSION)?;
    let [view, sampling, zeros @ ..] = number(CHOICES).to_le_bytes();
    let view = VIEWS.get(usize::from(view)).copied().ok_or(wrong(CHOICES, "view"))?;
    let sampling = Sampling::ALL.get(usize::from(sampling)).copied();
    let sampling = sampling.ok_or(wrong(CHOICES + 1, "sampling"))?;
    if zeros != [0; 2] {
        return Err(wrong(CHOICES + 2, "reserved bytes"));
    }
    let settings = Settings {
        width,
        height,
        crop,
        aa,
        light_samples,
        sampling,
        max_recursion,
        seed: u64_at(header, SEED),
        view,
        count: false,
    };
    let hash = |at: usize| header[at..].first_chunk::<32>().copied().unwrap_or(Hash::default());
    let version = name(&header[NAME..SIZE]).ok_or(wrong(NAME, "version of the renderer"))?;
    let origin = Origin { scene: hash(ORIGIN), sources: hash(SOURCES), version, settings };
    Ok((origin, kind(header)?))
}

fn kind(header: &[u8; HEADER]) -> Result<Kind, PartFileError> {
    let wrong = |at, what| PartFileError::Header { at, what };
    let [code, zeros @ ..] = u32_at(header, KIND).to_le_bytes();
    if zeros != [0; 3] || u32_at(header, RESERVED) != 0 {
        return Err(wrong(KIND + 1, "reserved bytes"));
    }
    let share = Share { number: u32_at(header, NUMBER), count: u32_at(header, COUNT) };
    if code == CHECKPOINT {
        let none = share == Share { number: 0, count: 0 };
        return if none { Ok(Kind::Checkpoint) } else { Err(wrong(NUMBER, "number of the part")) };
    }
    let division = Division::ALL.get(usize::from(code) - 1).copied();
    let division = division.ok_or(wrong(KIND, "kind"))?;
    if !(1..=share.count).contains(&share.number) || share.count > Share::MOST {
        return Err(wrong(NUMBER, "number of the part"));
    }
    Ok(Kind::Part { division, share })
}

/// Printable ASCII and then zeros, or `None`.
fn name(bytes: &[u8]) -> Option<String> {
    let end = bytes.iter().position(|&byte| byte == 0).unwrap_or(bytes.len());
    let (name, zeros) = bytes.split_at(end);
    let is_name = name.iter().all(u8::is_ascii_graphic) && zeros.iter().all(|&byte| byte == 0);
    is_name.then(|| name.iter().copied().map(char::from).collect())
}
