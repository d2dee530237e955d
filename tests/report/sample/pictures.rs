//! Pictures of a record, painted.

use std::collections::BTreeMap;

use srt::image_io::{Format, Picture, encode};
use srt::math::{Color, Random};
use srt::record::{Comparison, PictureFile};

pub(super) fn picture_file(file: &str, key: u64) -> PictureFile {
    PictureFile { file: file.to_owned(), width: 160, height: 120, hash: hash(key) }
}

/// Something that looks like a SHA-256.
pub(super) fn hash(key: u64) -> String {
    let mut random = Random::new(&[key, 99]);
    (0..4).map(|_| format!("{:016x}", random.next_u64())).collect()
}

/// The PNG files that a record names.
pub(crate) fn pictures(comparison: &Comparison) -> BTreeMap<String, Vec<u8>> {
    let mut pictures = BTreeMap::new();
    for scene in &comparison.scenes {
        let heats = scene.structures.iter().filter_map(|structure| structure.heatmap.as_ref());
        for (i, file) in scene.picture.iter().chain(heats).enumerate() {
            let picture = paint(file, i);
            pictures.insert(file.file.clone(), encode(&picture, Format::Png).unwrap());
        }
    }
    pictures
}

/// A ball on a plane; in colour, or as a heatmap that darkens with `kind`.
fn paint(file: &PictureFile, kind: usize) -> Picture {
    let mut picture = Picture::new(file.width, file.height);
    for (i, pixel) in (0..).zip(&mut picture.pixels) {
        let x = (i % file.width) as f32 / file.width as f32 * 2.0 - 1.0;
        let y = (i / file.width) as f32 / file.height as f32 * 2.0 - 1.0;
        let r2 = (x * x * 1.78 + y * y) * 2.0;
        let light = if r2 < 1.0 { (1.0 - r2).sqrt() * 0.8 + 0.1 } else { 0.15 + 0.2 * y.max(0.0) };
        *pixel = match kind {
            0 => Color::new(light, light * 0.8, light * 0.6),
            _ => Color::new(light, light * light, 0.3 * light) * (1.2 / kind as f32),
        };
    }
    picture
}
