//! Bytes → parts. Bytes may come from anywhere: nothing is taken for granted, and no more memory is used than a small
//! multiple of their number.

use super::header;
use super::{
    COLOR, ENTRY, HEADER, Hash, MAGIC, MOMENTS, PartFile, PartFileError, SAMPLES, SUMS,
    SUMS_AND_MOMENTS, VERSION,
};
use crate::film::{Crop, FilmError, Moments, Part, Piece, Values, tile_at};
use crate::math::Color;
use crate::sealed::{self, u32_at, u64_at};

impl PartFile {
    /// Reads the bytes of a file. Each part is of a tile of the picture, with samples that it has; whether parts
    /// overlap is for the [`Film`](crate::film::Film) to say.
    ///
    /// # Errors
    /// If the bytes are no such file, or are not all of it, or were altered.
    pub fn decode(bytes: &[u8]) -> Result<Self, PartFileError> {
        if !bytes.starts_with(&MAGIC) {
            return Err(PartFileError::Magic);
        }
        let found = bytes.len() as u64;
        let short = |expected: u64| PartFileError::Length { expected, found };
        let least = (HEADER + size_of::<Hash>()) as u64;
        let header: &[u8; HEADER] = bytes.first_chunk().ok_or_else(|| short(least))?;
        let version = u32_at(header, 8);
        if version != VERSION {
            return Err(PartFileError::Version { found: version });
        }
        let table = u64::from(u32_at(header, 12)) * ENTRY as u64;
        if least + table > found {
            return Err(short(least + table));
        }
        // All of it is measured and hashed before anything is read from it.
        let (table, data) = bytes[HEADER..].split_at(table as usize);
        let sizes = table.chunks_exact(ENTRY).map(|entry| Entry::read(entry).bytes());
        let data_bytes = sizes.fold(0u64, u64::saturating_add);
        let expected = (least + table.len() as u64).saturating_add(data_bytes);
        if expected != found {
            return Err(PartFileError::Length { expected, found });
        }
        sealed::check(bytes)
            .map_err(|sealed::Altered { found, stated }| PartFileError::Hash { found, stated })?;
        let (origin, kind) = header::read(header)?;
        let (region, samples) = (origin.settings.region(), origin.settings.film_samples());
        let mut parts = Vec::with_capacity(table.len() / ENTRY);
        let mut rest = data;
        for (number, entry) in (1..).zip(table.chunks_exact(ENTRY)) {
            let entry = Entry::read(entry);
            entry.check(region, samples, number)?;
            let (own, behind) = rest.split_at(entry.bytes() as usize);
            rest = behind;
            parts.push(entry.part(own));
        }
        Ok(Self { origin, kind, parts })
    }
}

/// An entry of the table.
struct Entry {
    area: Crop,
    first: u32,
    end: u32,
    form: u32,
    reserved: u32,
}

impl Entry {
    fn read(bytes: &[u8]) -> Self {
        let number = |place: usize| u32_at(bytes, 4 * place);
        let area = Crop { x0: number(0), y0: number(1), x1: number(2), y1: number(3) };
        Self { area, first: number(4), end: number(5), form: number(6), reserved: number(7) }
    }

    /// The bytes of its values, of an entry that may be wrong.
    fn bytes(&self) -> u64 {
        let Crop { x0, y0, x1, y1 } = self.area;
        let pixels = u64::from(x1.saturating_sub(x0)) * u64::from(y1.saturating_sub(y0));
        let each = match self.form {
            SAMPLES => COLOR as u64 * u64::from(self.end.saturating_sub(self.first)),
            SUMS_AND_MOMENTS => (COLOR + MOMENTS) as u64,
            _ => COLOR as u64,
        };
        pixels.saturating_mul(each)
    }

    fn check(&self, region: Crop, all_samples: u32, number: usize) -> Result<(), PartFileError> {
        let &Self { area, first, end, form, reserved } = self;
        if reserved != 0 || ![SUMS, SAMPLES, SUMS_AND_MOMENTS].contains(&form) {
            return Err(PartFileError::Entry { number });
        }
        let wrong = |error| Err(PartFileError::Part { number, error });
        if tile_at(region, area).is_none() {
            return wrong(FilmError::NoTile { area });
        }
        if first >= end || end > all_samples || form != SAMPLES && first > 0 {
            return wrong(FilmError::Range { area, first, end, all_samples });
        }
        Ok(())
    }

    /// The part of an entry that was checked, from the bytes of its values.
    fn part(&self, bytes: &[u8]) -> Part {
        let piece = Piece { area: self.area, samples: self.first..self.end };
        let values = match self.form {
            SUMS_AND_MOMENTS => {
                let (sums, moments) = bytes.split_at(self.area.pixels() as usize * COLOR);
                let moments = moments
                    .chunks_exact(MOMENTS)
                    .map(|bytes| Moments { sum: f64_at(bytes, 0), squares: f64_at(bytes, 8) });
                Values::SumsAndMoments(colors(sums), moments.collect())
            }
            SAMPLES => Values::Samples(colors(bytes)),
            _ => Values::Sums(colors(bytes)),
        };
        Part { piece, values }
    }
}

fn colors(bytes: &[u8]) -> Vec<Color> {
    let channel = |bytes: &[u8], at| f32::from_bits(u32_at(bytes, at));
    let colors = bytes.chunks_exact(COLOR);
    colors.map(|own| Color::new(channel(own, 0), channel(own, 4), channel(own, 8))).collect()
}

fn f64_at(bytes: &[u8], at: usize) -> f64 {
    f64::from_bits(u64_at(bytes, at))
}

#[cfg(test)]
mod tests {
    use sha2::{Digest, Sha256};

    use super::*;
    use crate::film::{Division, Share};
    use crate::part_file::{Kind, Origin};
    use crate::render::{Sampling, Settings, View};

    fn file() -> PartFile {
        let crop = Crop { x0: 3, y0: 0, x1: 22, y1: 30 };
        let settings = Settings {
            width: 40,
            height: 30,
            crop: Some(crop),
            aa: 2,
            light_samples: 3,
            sampling: Sampling::Independent,
            max_recursion: 5,
            seed: u64::MAX - 1,
            view: View::Color,
            count: false,
        };
        let origin = Origin { scene: [9; 32], sources: [8; 32], version: "1.2.3".into(), settings };
        let tile = |x0, y0, x1, y1| Crop { x0, y0, x1, y1 };
        let values = |n: usize| (0..n).map(|i| Color::splat(f32::from_bits(i as u32))).collect();
        let moments = vec![Moments { sum: f64::NAN, squares: 0.5 }; 42];
        let nan = Values::SumsAndMoments(values(42), moments);
        let parts = [
            (tile(3, 0, 19, 16), 0..2, Values::Sums(values(256))),
            (tile(19, 0, 22, 16), 1..4, Values::Samples(values(144))),
            (tile(19, 16, 22, 30), 0..4, nan),
        ];
        let parts =
            parts.map(|(area, samples, values)| Part { piece: Piece { area, samples }, values });
        let share = Share { number: 2, count: 5 };
        let kind = Kind::Part { division: Division::Samples, share };
        PartFile { origin, kind, parts: parts.into() }
    }

    fn bytes(file: &PartFile) -> Vec<u8> {
        let mut bytes = Vec::new();
        file.write(&mut bytes).unwrap();
        assert_eq!(bytes.len() as u64, file.length());
        bytes
    }

    /// With the hash of what was changed.
    fn rehashed(mut bytes: Vec<u8>) -> Vec<u8> {
        bytes.truncate(bytes.len() - 32);
        let hash = Sha256::digest(&bytes);
        bytes.extend(hash);
        bytes
    }

    #[test]
    fn what_is_written_is_read_again_to_the_bit() {
        let written = bytes(&file());
        let read = PartFile::decode(&written).unwrap();
        assert_eq!(bytes(&read), written);
        assert_eq!((&read.origin, read.kind), (&file().origin, file().kind));
    }

    #[test]
    fn every_byte_counts() {
        let whole = bytes(&file());
        for at in (0..300).chain((300..whole.len()).step_by(97)) {
            let mut altered = whole.clone();
            altered[at] ^= 1;
            assert!(PartFile::decode(&altered).is_err(), "byte {at}");
            assert!(PartFile::decode(&whole[..at]).is_err(), "cut at {at}");
        }
        let longer = [&whole[..], b"x"].concat();
        assert!(matches!(PartFile::decode(&longer), Err(PartFileError::Length { .. })));
    }

    #[test]
    fn what_was_forged_with_a_right_hash_is_refused_by_name() {
        let whole = bytes(&file());
        for (at, byte, part) in [
            (80, b' ', "version of the renderer"),
            (96, 9, "region"),
            (96, 0, "size of the picture"),
            (98, 1, "size of the picture"),
            (104, 200, "region"),
            (121, 2, "samples of a pixel"),
            (124, 0, "samples of a light"),
            (130, 1, "depth of recursion"),
            (132, 5, "its view"),
            (133, 2, "its sampling"),
            (134, 1, "reserved bytes"),
            (144, 3, "its kind"),
            (144, 0, "number of the part"),
            (145, 1, "reserved bytes"),
            (148, 6, "number of the part"),
            (156, 1, "reserved bytes"),
            (160 + 28, 1, "entry 1"),
        ] {
            let mut forged = whole.clone();
            forged[at] = byte;
            let error = PartFile::decode(&rehashed(forged)).unwrap_err().to_string();
            assert!(error.contains(part), "{at}: {error}");
        }
        let part = |part: fn(&mut PartFile)| {
            let mut forged = file();
            part(&mut forged);
            PartFile::decode(&bytes(&forged)).unwrap_err().to_string()
        };
        assert!(part(|file| file.parts[0].piece.samples.end = 5).contains("entry 1"));
        let moved = part(|file| file.parts[1].piece.area.y0 = 17);
        assert!(moved.contains("by its own counts"), "{moved}");
        let other = part(|file| {
            (file.parts[2].piece.area.y0, file.parts[2].piece.area.y1) = (15, 29);
        });
        assert!(other.contains("entry 3") && other.contains("no tile"), "{other}");
    }
}
