//! Numbers as bytes, the lowest byte first, with checksums over all of them.
//!
//! Lists are written and read in groups of many elements, on all threads. What they consist of has
//! checksums of its own, so that a wrong one is known as soon as it is read.

use std::io::{self, Read, Write};

use glam::{Vec3, Vec3A};
use rayon::prelude::*;

use crate::math::Aabb;
use crate::parallel::for_chunks;
use crate::simd::{ask_for_huge_pages, extend};

use super::LoadError;
use super::checksum::{Fnv, xxh64};

/// The most bytes that have a checksum together, and the most such pieces in a group.
const PIECE: usize = 1 << 18;
const PIECES: usize = 8;

/// So many elements are converted by a thread at a time.
const AT_ONCE: usize = 1 << 10;

/// Elements of `N` words that have a checksum together.
const fn in_piece(words: usize) -> usize {
    PIECE / (4 * words)
}

/// Writes numbers, the lowest byte first.
pub struct Encoder<'a> {
    out: &'a mut dyn Write,
    checksum: Fnv,
}

impl<'a> Encoder<'a> {
    pub(crate) fn new(out: &'a mut dyn Write) -> Self {
        Self { out, checksum: Fnv::NEW }
    }

    /// Writes bytes as they are. For more than a few, [`list`](Self::list) is faster.
    ///
    /// # Errors
    /// If they cannot be written; so for all other functions.
    pub fn bytes(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.checksum.add(bytes);
        self.out.write_all(bytes)
    }

    /// Writes a whole number.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn u32(&mut self, value: u32) -> io::Result<()> {
        self.bytes(&value.to_le_bytes())
    }

    /// Writes the bits of three floats.
    ///
    /// # Errors
    /// If they cannot be written.
    pub fn vec3(&mut self, value: Vec3) -> io::Result<()> {
        value.to_array().iter().try_for_each(|x| self.bytes(&x.to_le_bytes()))
    }

    /// Writes the elements of a list, each as `N` words. Their number is not written.
    ///
    /// # Errors
    /// If they cannot be written.
    pub fn list<T: Sync, const N: usize>(
        &mut self,
        list: &[T],
        words: impl Fn(&T) -> [u32; N] + Sync,
    ) -> io::Result<()> {
        let mut bytes = Vec::new();
        for group in list.chunks(PIECES * const { in_piece(N) }) {
            bytes.resize(N * group.len(), [0; 4]);
            for_chunks(&mut bytes, N * AT_ONCE, &|first, bytes| {
                let (of_elements, _) = bytes.as_chunks_mut::<N>();
                for (bytes, element) in of_elements.iter_mut().zip(&group[first / N..]) {
                    *bytes = words(element).map(u32::to_le_bytes);
                }
            });
            self.group(bytes.as_flattened(), const { 4 * N * in_piece(N) })?;
        }
        Ok(())
    }

    /// Writes a group of a list, in pieces of so many bytes, behind their checksums.
    fn group(&mut self, bytes: &[u8], piece: usize) -> io::Result<()> {
        bytes.chunks(piece).try_for_each(|piece| self.bytes(&xxh64(piece).to_le_bytes()))?;
        self.out.write_all(bytes)
    }

    /// Writes a name behind its length.
    pub(crate) fn name(&mut self, name: &str) -> io::Result<()> {
        let too_long = |_| io::Error::other(format!("`{name}` is longer than 255 bytes"));
        let length = u8::try_from(name.len()).map_err(too_long)?;
        self.bytes(&[length])?;
        self.bytes(name.as_bytes())
    }

    /// Writes the checksum of all that was written since the last one.
    pub(crate) fn checksum(&mut self) -> io::Result<()> {
        let sum = std::mem::replace(&mut self.checksum, Fnv::NEW);
        self.out.write_all(&sum.0.to_le_bytes())?;
        self.out.flush()
    }
}

/// Reads numbers as [`Encoder`] writes them.
pub struct Decoder<'a> {
    input: &'a mut dyn Read,
    /// How many bytes there are, at most; not known where it is none.
    size: Option<u64>,
    checksum: Fnv,
    /// The group of a list that is read, kept for the next.
    group: Vec<u8>,
}

impl<'a> Decoder<'a> {
    pub(crate) fn new(input: &'a mut dyn Read) -> Self {
        Self { input, size: None, checksum: Fnv::NEW, group: Vec::new() }
    }

    /// The same, of a source that has so many bytes: room for lists is then taken once.
    #[cfg(feature = "program")]
    pub(crate) fn of_size(input: &'a mut dyn Read, size: u64) -> Self {
        Self { size: Some(size), ..Self::new(input) }
    }

    /// Reads so many bytes.
    ///
    /// # Errors
    /// If there are fewer, or they cannot be read; so for all other functions.
    pub fn array<const N: usize>(&mut self) -> Result<[u8; N], LoadError> {
        let mut bytes = [0; N];
        self.input.read_exact(&mut bytes)?;
        self.checksum.add(&bytes);
        Ok(bytes)
    }

    /// Reads a whole number.
    ///
    /// # Errors
    /// If there is none.
    pub fn u32(&mut self) -> Result<u32, LoadError> {
        self.array().map(u32::from_le_bytes)
    }

    /// Reads three floats, which may be any.
    ///
    /// # Errors
    /// If there are fewer.
    pub fn vec3(&mut self) -> Result<Vec3, LoadError> {
        let mut float = || self.array().map(f32::from_le_bytes);
        Ok(Vec3::new(float()?, float()?, float()?))
    }

    /// Reads a list of so many elements of `N` words, on all threads. `what` is what errors call
    /// them. A length that is wrong takes not much more memory than the bytes that are there.
    ///
    /// # Errors
    /// If there are fewer, or their checksums are those of others.
    pub fn list<T: Send, const N: usize>(
        &mut self,
        length: u32,
        what: &'static str,
        element: impl Fn([u32; N]) -> T + Sync,
    ) -> Result<Vec<T>, LoadError> {
        let mut list = Vec::new();
        if let Some(size) = self.size {
            if 4 * N as u64 * u64::from(length) > size {
                return Err(LoadError::Truncated);
            }
            list.reserve_exact(length as usize);
            ask_for_huge_pages(list.spare_capacity_mut());
        }
        let mut left = length as usize;
        while left > 0 {
            let count = left.min(PIECES * const { in_piece(N) });
            left -= count;
            self.group(4 * N * count, const { 4 * N * in_piece(N) }, what)?;
            let (words, _) = self.group.as_chunks();
            let (words, _): (&[[_; N]], _) = words.as_chunks();
            extend(&mut list, count, |place| element(words[place].map(u32::from_le_bytes)));
        }
        list.shrink_to_fit();
        Ok(list)
    }

    /// Reads a group of so many bytes, in pieces, of the list that errors call so.
    fn group(&mut self, bytes: usize, piece: usize, what: &'static str) -> Result<(), LoadError> {
        let mut sums = vec![[0; 8]; bytes.div_ceil(piece)];
        self.input.read_exact(sums.as_flattened_mut())?;
        self.checksum.add(sums.as_flattened());
        self.group.resize(bytes, 0);
        self.input.read_exact(&mut self.group)?;
        let pieces = self.group.par_chunks(piece).zip(&sums);
        let are_right = pieces.all(|(piece, sum)| xxh64(piece) == u64::from_le_bytes(*sum));
        if are_right { Ok(()) } else { Err(LoadError::Damaged { what }) }
    }

    /// Reads a name behind its length.
    pub(crate) fn name(&mut self) -> Result<String, LoadError> {
        let [length] = self.array()?;
        let mut bytes = [0; u8::MAX as usize];
        let bytes = &mut bytes[..usize::from(length)];
        self.input.read_exact(bytes)?;
        self.checksum.add(bytes);
        Ok(String::from_utf8_lossy(bytes).into_owned())
    }

    /// Reads a checksum and compares it with that of all that was read since the last one.
    pub(crate) fn checksum(&mut self) -> Result<(), LoadError> {
        let expected = std::mem::replace(&mut self.checksum, Fnv::NEW).0;
        match u64::from_le_bytes(self.array()?) == expected {
            true => {
                self.checksum = Fnv::NEW;
                Ok(())
            }
            false => Err(LoadError::Damaged { what: "numbers" }),
        }
    }
}

/// A box as words: its low corner, then its high one.
pub(in crate::accel) fn words_of(bounds: &Aabb) -> [u32; 6] {
    let ([a, b, c], [d, e, f]) = (bounds.min.to_array(), bounds.max.to_array());
    [a, b, c, d, e, f].map(f32::to_bits)
}

/// The box of words.
pub(in crate::accel) fn box_of(words: [u32; 6]) -> Aabb {
    let [a, b, c, d, e, f] = words.map(f32::from_bits);
    Aabb { min: Vec3A::new(a, b, c), max: Vec3A::new(d, e, f) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// More than a group of elements of five words.
    const MANY: u32 = (PIECES * in_piece(5) + in_piece(5) + 1) as u32;

    fn five(i: u32) -> [u32; 5] {
        std::array::from_fn(|k| i.wrapping_mul(0x9E37_79B9) ^ k as u32)
    }

    fn written() -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut out = Encoder::new(&mut bytes);
        out.name("bvh8").unwrap();
        out.u32(0xDEAD_BEEF).unwrap();
        out.vec3(Vec3::new(-0.0, 1.5, f32::NAN)).unwrap();
        out.checksum().unwrap();
        let numbers: Vec<u32> = (0..MANY).collect();
        out.list(&numbers, |&i| five(i)).unwrap();
        out.checksum().unwrap();
        bytes
    }

    fn read(mut bytes: &[u8], size: Option<u64>) -> Result<(), LoadError> {
        let mut input = Decoder { size, ..Decoder::new(&mut bytes) };
        assert_eq!((input.name()?, input.u32()?), ("bvh8".to_owned(), 0xDEAD_BEEF));
        let [x, y, z] = input.vec3()?.to_array().map(f32::to_bits);
        assert_eq!([x, y, z], [-0.0, 1.5, f32::NAN].map(f32::to_bits));
        input.checksum()?;
        let list = input.list(MANY, "fives", |words: [u32; 5]| words)?;
        assert!(list.into_iter().eq((0..MANY).map(five)));
        input.checksum()
    }

    #[test]
    fn what_is_written_is_read() {
        let bytes = written();
        assert_eq!(bytes[..9], *b"\x04bvh8\xEF\xBE\xAD\xDE");
        read(&bytes, None).unwrap();
        read(&bytes, Some(bytes.len() as u64)).unwrap();
        assert!(matches!(read(&bytes[..bytes.len() - 1], None), Err(LoadError::Truncated)));
    }

    #[test]
    fn what_was_altered_is_named() {
        let mut bytes = written();
        let length = bytes.len();
        let list_at = length - 8 - 20 * MANY as usize - 8 * 10;
        for place in [list_at + 3, list_at + 7 * 8, list_at + 8 * 8, length - 9, length - 20] {
            bytes[place] ^= 1;
            let error = read(&bytes, None).unwrap_err();
            assert!(matches!(error, LoadError::Damaged { what: "fives" }), "{place}: {error}");
            bytes[place] ^= 1;
        }
        bytes[length - 1] ^= 1;
        assert!(matches!(read(&bytes, None), Err(LoadError::Damaged { what: "numbers" })));
    }

    #[test]
    fn a_list_that_is_said_to_be_long_takes_no_memory() {
        for size in [None, Some(12)] {
            let mut input = &[0; 12][..];
            let mut input = Decoder { size, ..Decoder::new(&mut input) };
            let list = input.list(u32::MAX, "numbers", |[word]| word);
            assert!(matches!(list, Err(LoadError::Truncated)));
        }
    }

    #[test]
    fn boxes_are_six_words() {
        let bounds = Aabb { min: Vec3A::new(-0.0, 1.5, 2.0), max: Vec3A::new(3.0, 4.0, 5.0) };
        assert_eq!(box_of(words_of(&bounds)), bounds);
    }
}
