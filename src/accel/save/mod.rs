//! Structures to bytes and back, each by its own [`Portable`], primitives by [`PortablePrimitives`].
//!
//! The bytes are described in `docs/library.md`. They may come from anywhere: whatever they hold,
//! loading ends with an error or with a structure that returns the hits of its primitives. Knows
//! no files, and neither the nodes of a structure nor a formula.

mod check;
mod checksum;
mod encoding;
mod error;

use std::io::{self, Read, Write};

use crate::math::NONE;

use super::order::in_32_bits;
use super::{Accel, Bounded, Indexed, Order, Packs, Primitives};

pub(super) use check::{Nodes, is_plainly_sound};
pub use encoding::{Decoder, Encoder};
pub(super) use encoding::{box_of, words_of};
pub use error::LoadError;

/// What saved structures begin with. Not text, and no transfer as text leaves it as it is.
const MAGIC: [u8; 8] = *b"\x89srt\r\n\x1a\n";

/// The version of all that is saved. Others are not read.
const VERSION: u32 = 3;

/// The slots of primitives over which a structure is loaded.
#[derive(Clone, Copy, Debug)]
pub struct Slots<'a> {
    /// Slot `i` holds primitive `order[i]`, or nothing where that is [`NONE`].
    pub order: &'a [u32],
    /// How many slots a single ray is tested with at once: see [`Packs::GRAIN`].
    pub grain: u32,
}

/// A structure that can be saved and loaded, together with [`PortablePrimitives`]. Its order is a
/// permutation: one that copies primitives ([`Order::References`]) is not written.
pub trait Portable: Accel {
    /// The name by which bytes are known to hold this structure; at most 255 bytes.
    const NAME: &'static str;

    /// How far, as a share of the primitives' largest coordinate, a box that [`Accel::tree`] shows
    /// may end within what it encloses: 0, but where boxes are stored with less precision than
    /// `f32` and tested with a wider padding.
    const SLACK: f32 = 0.0;

    /// Writes what [`read`](Self::read) needs.
    ///
    /// # Errors
    /// If the bytes cannot be written.
    fn write(&self, out: &mut Encoder<'_>) -> io::Result<()>;

    /// Reads the structure over primitives that are in its order already.
    ///
    /// All that a search relies on is to be checked, but for what [`Indexed::load`] checks of each
    /// [`Accel::tree`]: that its leaves hold each primitive once, and that its boxes enclose what
    /// is below them. So `tree` must come to an end, whatever was read, and needs slots that exist.
    ///
    /// # Errors
    /// If the bytes end too early or are not such a structure.
    fn read(
        primitives: &impl Bounded,
        slots: Slots<'_>,
        input: &mut Decoder<'_>,
    ) -> Result<Self, LoadError>;

    /// Whether it is seen quickly that leaves hold each primitive once, and that boxes enclose what
    /// is below them. Where it is not, [`Accel::tree`] is looked at, which takes longer.
    fn is_plainly_sound(&self, primitives: &impl Bounded, order: &[u32]) -> bool {
        let _ = (primitives, order);
        false
    }
}

/// Primitives that can be saved and loaded, together with a [`Portable`] structure over them.
pub trait PortablePrimitives: Primitives + Sized {
    /// The name by which bytes are known to hold these primitives; at most 255 bytes.
    const NAME: &'static str;

    /// The id of the primitive in a slot; [`NONE`] if it is empty.
    fn id(&self, slot: u32) -> u32;

    /// Writes the primitives in the order of their ids: primitive `i` is in slot `slots[i]`.
    ///
    /// # Errors
    /// If the bytes cannot be written.
    fn write(&self, slots: &[u32], out: &mut Encoder<'_>) -> io::Result<()>;

    /// Reads so many primitives as they were before any reordering.
    ///
    /// # Errors
    /// If the bytes end too early, or are not primitives that can be traced.
    fn read(count: u32, input: &mut Decoder<'_>) -> Result<Self, LoadError>;
}

impl<P: PortablePrimitives, A: Portable> Indexed<P, A> {
    /// Writes the primitives and the structure, so that [`load`](Self::load) need not build it
    /// again. The same structure gives the same bytes on every machine.
    ///
    /// Some of the bytes are written in small pieces: give a file as a [`BufWriter`](io::BufWriter).
    ///
    /// # Errors
    /// If they cannot be written, or the structure copies primitives ([`io::ErrorKind::Unsupported`]).
    pub fn save(&self, mut out: impl Write) -> io::Result<()> {
        let out = &mut Encoder::new(&mut out);
        out.bytes(&MAGIC)?;
        out.u32(VERSION)?;
        out.name(A::NAME)?;
        out.name(P::NAME)?;
        let primitives = self.primitives();
        let order: Vec<u32> = (0..primitives.slots()).map(|slot| primitives.id(slot)).collect();
        out.u32(primitives.count())?;
        primitives.write(&slots_of(&order, primitives.count()), out)?;
        self.write_structure(&order, out)?;
        out.checksum()
    }

    /// Reads what [`save`](Self::save) has written, and nothing behind it. The build time of what
    /// is loaded is 0. Where it follows primitives, parts that are rebuilt are built as by default.
    ///
    /// The bytes are checked, so they need not be trusted: what is loaded returns the hits of its
    /// primitives, as if it had been built over them. Some are read in small pieces: give a file as a
    /// [`BufReader`](io::BufReader).
    ///
    /// # Errors
    /// If the bytes cannot be read, are of another structure, other primitives or another version,
    /// end too early, were damaged, or are not a structure over the primitives before it.
    pub fn load(mut input: impl Read) -> Result<Self, LoadError> {
        let input = &mut Decoder::new(&mut input);
        if input.array()? != MAGIC {
            return Err(LoadError::NotSaved);
        }
        match input.u32()? {
            VERSION => {}
            version => return Err(LoadError::Version { version }),
        }
        expect_name(input, "structure", A::NAME)?;
        expect_name(input, "primitives", P::NAME)?;
        let count = input.u32()?;
        let mut primitives = P::read(count, input)?;
        if primitives.count() != count {
            return Err(LoadError::invalid(format!("there are not {count} primitives")));
        }
        let arrange = |order: &[u32]| {
            primitives.reorder(order);
            Ok(primitives)
        };
        let loaded = Self::read_structure(count, arrange, input)?;
        input.checksum()?;
        Ok(loaded)
    }
}

impl<P: Primitives, A: Portable> Indexed<P, A> {
    /// Writes the primitive of each slot, and the structure.
    ///
    /// # Errors
    /// If they cannot be written, or the order copies primitives ([`io::ErrorKind::Unsupported`]).
    pub(crate) fn write_structure(&self, order: &[u32], out: &mut Encoder<'_>) -> io::Result<()> {
        let filled = order.iter().filter(|&&id| id != NONE).count();
        if filled > self.primitives().count() as usize {
            return Err(io::Error::new(
                io::ErrorKind::Unsupported,
                "a structure whose leaves share primitives cannot be saved: choose another builder, as `builder=sah`",
            ));
        }
        out.u32(in_32_bits(order.len()))?;
        out.list(order, |&id| [id])?;
        self.accel().write(out)
    }

    /// Reads what [`write_structure`](Self::write_structure) has written, over so many primitives.
    /// `arrange` gives them in the order of their slots.
    pub(crate) fn read_structure(
        count: u32,
        arrange: impl FnOnce(&[u32]) -> Result<P, LoadError>,
        input: &mut Decoder<'_>,
    ) -> Result<Self, LoadError> {
        let slots = input.u32()?;
        let order = input.list(slots, "slots", |[id]| id)?;
        let grain = <P::Packs as Packs>::GRAIN;
        let order = Order::Permutation(order);
        if let Some(fault) = order.fault(count, grain) {
            return Err(LoadError::invalid(fault));
        }
        let order = order.slots();
        let primitives = arrange(order)?;
        let accel = A::read(&primitives, Slots { order, grain }, input)?;
        if !accel.is_plainly_sound(&primitives, order)
            && let Some(tree) = accel.tree()
        {
            let slack = A::SLACK * primitives.padding().largest;
            check::tree(&tree, &primitives, order, slack)?;
        }
        Ok(Self::loaded(primitives, accel))
    }
}

/// The slot of each primitive.
fn slots_of(order: &[u32], count: u32) -> Vec<u32> {
    let mut slots = vec![NONE; count as usize];
    for (slot, &id) in (0..).zip(order).filter(|&(_, &id)| id != NONE) {
        slots[id as usize] = slot;
    }
    slots
}

fn expect_name(
    input: &mut Decoder<'_>,
    what: &'static str,
    expected: &'static str,
) -> Result<(), LoadError> {
    let found = input.name()?;
    if found == expected { Ok(()) } else { Err(LoadError::Other { what, found, expected }) }
}

/// Refuses slots that are empty before others are filled: for structures that offer the first so
/// many.
pub(super) fn expect_dense(order: &[u32], count: u32) -> Result<(), LoadError> {
    match order.iter().take(count as usize).position(|&id| id == NONE) {
        None => Ok(()),
        Some(slot) => Err(LoadError::invalid(format!("slot {slot} is empty"))),
    }
}
