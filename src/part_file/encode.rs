//! Parts → bytes.

use std::io::{self, Write};

use sha2::{Digest, Sha256};

use super::{
    COLOR, ENTRY, HEADER, Hash, MOMENTS, PartFile, SAMPLES, SUMS, SUMS_AND_MOMENTS, header,
};
use crate::film::{Part, Values};
use crate::math::Color;

impl PartFile {
    /// Writes the bytes of the file, as they are made.
    ///
    /// # Errors
    /// Those of the writer, and if there are more than 2³² − 1 parts.
    pub fn write(&self, to: &mut dyn Write) -> io::Result<()> {
        let count = u32::try_from(self.parts.len()).map_err(io::Error::other)?;
        let mut to = Hashed { to, hash: Sha256::new() };
        let mut bytes = Vec::with_capacity(HEADER);
        header::add_header(&self.origin, self.kind, count, &mut bytes);
        to.write_all(&bytes)?;
        for part in &self.parts {
            to.write_all(&entry(part))?;
        }
        for part in &self.parts {
            bytes.clear();
            add_values(&part.values, &mut bytes);
            to.write_all(&bytes)?;
        }
        let hash = to.hash.finalize();
        to.to.write_all(&hash)
    }

    /// How long the file is, in bytes.
    #[must_use]
    pub fn length(&self) -> u64 {
        let of_part = |part: &Part| match &part.values {
            Values::Sums(values) | Values::Samples(values) => values.len() * COLOR,
            Values::SumsAndMoments(sums, moments) => sums.len() * COLOR + moments.len() * MOMENTS,
        };
        let parts: usize = self.parts.iter().map(|part| ENTRY + of_part(part)).sum();
        (HEADER + parts + size_of::<Hash>()) as u64
    }
}

/// Passes bytes on, and hashes them.
struct Hashed<'a> {
    to: &'a mut dyn Write,
    hash: Sha256,
}

impl Hashed<'_> {
    fn write_all(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.hash.update(bytes);
        self.to.write_all(bytes)
    }
}

fn entry(part: &Part) -> [u8; ENTRY] {
    let (area, samples) = (part.piece.area, &part.piece.samples);
    let form = match part.values {
        Values::Sums(_) => SUMS,
        Values::Samples(_) => SAMPLES,
        Values::SumsAndMoments(..) => SUMS_AND_MOMENTS,
    };
    let numbers = [area.x0, area.y0, area.x1, area.y1, samples.start, samples.end, form, 0];
    let mut entry = [0; ENTRY];
    for (bytes, number) in entry.chunks_exact_mut(4).zip(numbers) {
        bytes.copy_from_slice(&number.to_le_bytes());
    }
    entry
}

fn add_values(values: &Values, bytes: &mut Vec<u8>) {
    match values {
        Values::Sums(colors) | Values::Samples(colors) => add_colors(colors, bytes),
        Values::SumsAndMoments(colors, moments) => {
            add_colors(colors, bytes);
            for moment in moments {
                bytes.extend(moment.sum.to_le_bytes());
                bytes.extend(moment.squares.to_le_bytes());
            }
        }
    }
}

fn add_colors(colors: &[Color], bytes: &mut Vec<u8>) {
    for color in colors {
        color.to_array().iter().for_each(|channel| bytes.extend(channel.to_le_bytes()));
    }
}
