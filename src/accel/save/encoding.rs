//! Numbers as bytes, the lowest byte first, with a checksum over all of them.

use std::io::{self, Read, Write};

use glam::{Vec3, Vec3A};

use crate::math::Aabb;

use super::LoadError;

/// As many elements of a list are expected at first, whatever its length is said to be: more room
/// is taken as they come.
const ROOM: u32 = 1 << 12;

/// FNV-1a with 64 bits. A changed byte always changes it.
struct Checksum(u64);

impl Checksum {
    const NEW: Self = Self(0xCBF2_9CE4_8422_2325);

    fn add(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01B3);
        }
    }
}

/// Writes numbers, the lowest byte first.
pub struct Encoder<'a> {
    out: &'a mut dyn Write,
    checksum: Checksum,
}

impl<'a> Encoder<'a> {
    pub(super) fn new(out: &'a mut dyn Write) -> Self {
        Self { out, checksum: Checksum::NEW }
    }

    /// Writes bytes as they are.
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

    /// Writes a box: its low corner, then its high one.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn aabb(&mut self, value: &Aabb) -> io::Result<()> {
        self.vec3(value.min.into())?;
        self.vec3(value.max.into())
    }

    /// Writes a name behind its length.
    pub(super) fn name(&mut self, name: &str) -> io::Result<()> {
        let too_long = |_| io::Error::other(format!("`{name}` is longer than 255 bytes"));
        let length = u8::try_from(name.len()).map_err(too_long)?;
        self.bytes(&[length])?;
        self.bytes(name.as_bytes())
    }

    /// Writes the checksum of all that was written.
    pub(super) fn checksum(&mut self) -> io::Result<()> {
        self.out.write_all(&self.checksum.0.to_le_bytes())?;
        self.out.flush()
    }
}

/// Reads numbers as [`Encoder`] writes them.
pub struct Decoder<'a> {
    input: &'a mut dyn Read,
    checksum: Checksum,
}

impl<'a> Decoder<'a> {
    pub(super) fn new(input: &'a mut dyn Read) -> Self {
        Self { input, checksum: Checksum::NEW }
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

    /// Reads a box, whose corners may be any.
    ///
    /// # Errors
    /// If there is none.
    pub fn aabb(&mut self) -> Result<Aabb, LoadError> {
        Ok(Aabb { min: Vec3A::from(self.vec3()?), max: Vec3A::from(self.vec3()?) })
    }

    /// Reads so many elements of a list. A length that is wrong takes no more memory than the bytes
    /// that are there.
    ///
    /// # Errors
    /// If one of them cannot be read.
    pub fn list<T>(
        &mut self,
        length: u32,
        mut element: impl FnMut(&mut Self) -> Result<T, LoadError>,
    ) -> Result<Vec<T>, LoadError> {
        let mut list = Vec::with_capacity(length.min(ROOM) as usize);
        for _ in 0..length {
            list.push(element(self)?);
        }
        Ok(list)
    }

    /// Reads a name behind its length.
    pub(super) fn name(&mut self) -> Result<String, LoadError> {
        let [length] = self.array()?;
        let bytes = self.list(u32::from(length), Self::array::<1>)?;
        Ok(String::from_utf8_lossy(bytes.as_flattened()).into_owned())
    }

    /// Reads a checksum and compares it with that of all that was read.
    pub(super) fn checksum(&mut self) -> Result<(), LoadError> {
        let expected = self.checksum.0;
        match u64::from_le_bytes(self.array()?) == expected {
            true => Ok(()),
            false => Err(LoadError::Damaged),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checksum_is_fnv_1a() {
        // From the reference implementation of Fowler, Noll and Vo.
        let of = |text: &str| {
            let mut checksum = Checksum::NEW;
            checksum.add(text.as_bytes());
            checksum.0
        };
        assert_eq!(of(""), 0xCBF2_9CE4_8422_2325);
        assert_eq!(of("a"), 0xAF63_DC4C_8601_EC8C);
        assert_eq!(of("foobar"), 0x8594_4171_F739_67E8);
    }

    #[test]
    fn what_is_written_is_read() {
        let mut bytes = Vec::new();
        let mut out = Encoder::new(&mut bytes);
        let bounds = Aabb { min: Vec3A::new(-0.0, 1.5, f32::NAN), max: Vec3A::INFINITY };
        out.name("bvh8").unwrap();
        out.u32(0xDEAD_BEEF).unwrap();
        out.aabb(&bounds).unwrap();
        out.checksum().unwrap();
        assert_eq!(bytes[..9], *b"\x04bvh8\xEF\xBE\xAD\xDE");
        let mut rest = &bytes[..];
        let mut input = Decoder::new(&mut rest);
        assert_eq!((input.name().unwrap(), input.u32().unwrap()), ("bvh8".to_owned(), 0xDEAD_BEEF));
        let read = input.aabb().unwrap();
        let bits = |v: Vec3A| v.to_array().map(f32::to_bits);
        assert_eq!([bits(read.min), bits(read.max)], [bits(bounds.min), bits(bounds.max)]);
        input.checksum().unwrap();
        assert!(matches!(input.u32(), Err(LoadError::Truncated)));
    }

    #[test]
    fn a_list_that_is_said_to_be_long_takes_no_memory() {
        let mut input = &[0; 12][..];
        let list = Decoder::new(&mut input).list(u32::MAX, Decoder::u32);
        assert!(matches!(list, Err(LoadError::Truncated)));
    }
}
