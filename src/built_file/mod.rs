//! A scene's text with its meshes as they are traced, for the compiled scene and a structure over it that follow:
//! numbers as they are in memory, so that nothing is parsed. Described in `docs/built-file.md`. Touches no file.

mod error;
mod meshes;

use std::io::{self, Read, Write};
use std::sync::Arc;

use crate::accel::{Decoder, Encoder, LoadError};
use crate::assets::MeshData;
use crate::sealed::Hash;

pub use error::BuiltFileError;

/// What such files begin with. Not text, and no transfer as text leaves it as it is.
const MAGIC: [u8; 8] = *b"\x89srtb\r\n\x1a";

/// The version of the form. Others are not read.
const VERSION: u32 = 1;

/// By which program a file was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Program {
    /// Its version.
    pub version: String,
    /// The hash of its sources.
    pub sources: Hash,
}

/// What a scene was built into.
#[derive(Clone, Debug, PartialEq)]
pub struct BuiltScene {
    /// The structure, with its options.
    pub structure: String,
    /// The quality of its build.
    pub quality: String,
    /// Whether unknown commands were warnings.
    pub lenient: bool,
    /// Whether the scene moves, so that another frame is another scene.
    pub moves: bool,
    /// The frame.
    pub frame: u32,
    /// The hash that files of parts have of the scene.
    pub hash: Hash,
    /// The fingerprint of the scene's file and of the mesh files that it names.
    pub fingerprint: Hash,
    /// The scene's text as it was in its file.
    pub text: Vec<u8>,
    /// The meshes as they are traced, generated and deformed, in the order in which the scene names them. Those that
    /// are the same are one.
    pub meshes: Vec<Arc<MeshData>>,
}

impl BuiltScene {
    /// Whether bytes begin as such a file does; of no more than eight bytes.
    #[must_use]
    pub fn begins(bytes: &[u8]) -> bool {
        bytes.starts_with(&MAGIC)
    }

    /// Writes it; the compiled scene and its structure are to follow.
    ///
    /// # Errors
    /// If it cannot be written, or if the text or a list of a mesh is too long for 32 bits.
    pub fn write(&self, program: &Program, out: &mut dyn Write) -> io::Result<()> {
        let out = &mut Encoder::new(out);
        out.bytes(&MAGIC)?;
        out.u32(VERSION)?;
        out.name(&program.version)?;
        out.bytes(&program.sources)?;
        out.name(&self.structure)?;
        out.name(&self.quality)?;
        out.u32(u32::from(self.lenient))?;
        out.u32(u32::from(self.moves))?;
        out.u32(self.frame)?;
        out.bytes(&self.hash)?;
        out.bytes(&self.fingerprint)?;
        out.checksum()?;
        meshes::write_length(self.text.len(), out)?;
        let words: Vec<[u8; 4]> = self.text.chunks(4).map(word).collect();
        out.list(&words, |&bytes| [u32::from_le_bytes(bytes)])?;
        out.checksum()?;
        meshes::write(&self.meshes, out)
    }

    /// Reads what [`write`](Self::write) has written by the same program, and nothing behind it. `size` is how many
    /// bytes there are at most.
    ///
    /// Whatever the bytes are, what is read are meshes that can be traced, with every index in range.
    ///
    /// # Errors
    /// If they are no such file, one of another program, cut off or altered: what is wrong is named.
    pub fn read(
        program: &Program,
        input: &mut dyn Read,
        size: u64,
    ) -> Result<Self, BuiltFileError> {
        let input = &mut Decoder::of_size(input, size);
        let built = head(program, input)?;
        let text =
            text(input).map_err(|source| BuiltFileError::part("the scene's text", source))?;
        Ok(Self { text, meshes: meshes::read(input)?, ..built })
    }
}

/// All but text and meshes.
fn head(program: &Program, input: &mut Decoder<'_>) -> Result<BuiltScene, BuiltFileError> {
    let in_head = |source| BuiltFileError::part("the head", source);
    if input.array().map_err(in_head)? != MAGIC {
        return Err(BuiltFileError::NotBuilt);
    }
    let version = input.u32().map_err(in_head)?;
    if version != VERSION {
        return Err(BuiltFileError::Version { version });
    }
    let of = Program {
        version: input.name().map_err(in_head)?,
        sources: input.array().map_err(in_head)?,
    };
    let mut rest = || {
        let built = BuiltScene {
            structure: input.name()?,
            quality: input.name()?,
            lenient: input.u32()? != 0,
            moves: input.u32()? != 0,
            frame: input.u32()?,
            hash: input.array()?,
            fingerprint: input.array()?,
            text: Vec::new(),
            meshes: Vec::new(),
        };
        input.checksum()?;
        Ok(built)
    };
    let built = rest().map_err(in_head)?;
    if of != *program {
        return Err(BuiltFileError::OtherProgram { of: of.into(), this: program.clone().into() });
    }
    Ok(built)
}

fn text(input: &mut Decoder<'_>) -> Result<Vec<u8>, LoadError> {
    let length = input.u32()?;
    let words = input.list(length.div_ceil(4), "letters", |[word]| word.to_le_bytes())?;
    input.checksum()?;
    let mut text = words.into_flattened();
    text.truncate(length as usize);
    Ok(text)
}

/// Up to four bytes, and zeros.
fn word(bytes: &[u8]) -> [u8; 4] {
    let mut word = [0; 4];
    word[..bytes.len()].copy_from_slice(bytes);
    word
}

#[cfg(test)]
mod tests;
