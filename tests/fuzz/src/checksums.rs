//! A built scene as `docs/built-file.md` describes it, whose checksums are made right as far as its parts can be found.

use std::hash::Hasher;

/// Makes the checksums right: those of lists, which have one each as long as they are short, and those of what is
/// between them. Ends where a length leads out of the bytes.
pub fn right_checksums(bytes: &mut [u8]) {
    let _ = Walk { bytes, at: 0, sum: FNV }.file();
}

/// Where FNV-1a begins, with 64 bits.
const FNV: u64 = 0xCBF2_9CE4_8422_2325;

/// The most bytes of a list that has one checksum.
const PIECE: usize = 1 << 18;

struct Walk<'a> {
    bytes: &'a mut [u8],
    at: usize,
    /// Of what was passed since the last checksum of that kind.
    sum: u64,
}

impl Walk<'_> {
    fn file(&mut self) -> Option<()> {
        self.pass(8 + 4)?;
        self.name()?;
        self.pass(32)?;
        let structure = self.name()?;
        self.name()?;
        self.pass(3 * 4 + 2 * 32)?;
        self.seal()?;
        let letters = self.number()?;
        self.list(letters.div_ceil(4), 1)?;
        self.seal()?;
        let meshes = self.number()?;
        for mesh in 0..meshes {
            if self.number()? == mesh {
                self.mesh()?;
            }
        }
        self.seal()?;
        self.scene()?;
        for _ in 0..self.number()? {
            self.pass(4 + 12)?;
            self.structure(&structure)?;
        }
        self.pass(4)?;
        self.structure(&structure)
    }

    fn mesh(&mut self) -> Option<()> {
        let [vertices, triangles, normals, indices, _] = self.numbers()?;
        self.seal()?;
        for length in [vertices, normals, triangles] {
            self.list(length, 3)?;
        }
        if indices != u32::MAX as usize {
            self.list(indices, 3)?;
        }
        self.seal()
    }

    fn scene(&mut self) -> Option<()> {
        self.pass(11 * 8 + 2 * 4 + 2 * 4 + 12)?;
        let lengths = self.numbers::<5>()?;
        self.seal()?;
        for (length, words) in lengths.into_iter().zip([12, 13, 24, 9, 10]) {
            self.list(length, words)?;
        }
        self.seal()
    }

    fn structure(&mut self, name: &[u8]) -> Option<()> {
        let slots = self.number()?;
        self.list(slots, 1)?;
        let words = match name {
            b"bvh" => 16,
            b"cwbvh" => 20,
            b"bvh8" => 56,
            _ => 0,
        };
        if words > 0 {
            match self.number()? {
                // A tree of one leaf has its root alone.
                0 if name == b"bvh" => self.pass(8)?,
                nodes => self.list(nodes, words)?,
            }
        }
        self.seal()
    }

    fn pass(&mut self, length: usize) -> Option<()> {
        for &byte in self.bytes.get(self.at..self.at.checked_add(length)?)? {
            self.sum = (self.sum ^ u64::from(byte)).wrapping_mul(0x100_0000_01B3);
        }
        self.at += length;
        Some(())
    }

    fn number(&mut self) -> Option<usize> {
        let number = self.bytes.get(self.at..)?.first_chunk().copied().map(u32::from_le_bytes)?;
        self.pass(4)?;
        usize::try_from(number).ok()
    }

    fn numbers<const N: usize>(&mut self) -> Option<[usize; N]> {
        let mut numbers = [0; N];
        for number in &mut numbers {
            *number = self.number()?;
        }
        Some(numbers)
    }

    fn name(&mut self) -> Option<Vec<u8>> {
        let length = usize::from(*self.bytes.get(self.at)?);
        self.pass(1 + length)?;
        Some(self.bytes[self.at - length..self.at].to_vec())
    }

    fn list(&mut self, length: usize, words: usize) -> Option<()> {
        let size = length.checked_mul(4 * words)?;
        if size == 0 {
            return Some(());
        }
        let first = self.at + 8;
        let list = self.bytes.get(first..first.checked_add(size)?).filter(|_| size <= PIECE)?;
        let mut sum = twox_hash::XxHash64::with_seed(0);
        sum.write(list);
        self.bytes[self.at..first].copy_from_slice(&sum.finish().to_le_bytes());
        self.pass(8)?;
        self.at += size;
        Some(())
    }

    fn seal(&mut self) -> Option<()> {
        let sum = std::mem::replace(&mut self.sum, FNV);
        self.bytes.get_mut(self.at..self.at + 8)?.copy_from_slice(&sum.to_le_bytes());
        self.at += 8;
        Some(())
    }
}
