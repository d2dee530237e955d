//! The compressed eight-wide tree in bytes: its nodes of 80 bytes, as obvhs lays them out.

use std::io;

use glam::Vec3;
use obvhs::cwbvh::node::CwBvhNode;

use crate::accel::save::Nodes;
use crate::accel::{Bounded, Decoder, Encoder, LoadError, Portable, Slots};

use super::{CompressedWideBvh, WIDTH};

/// A child's byte of meta data: as many primitives as its three highest bits have ones, and where
/// the first of them is in the five lowest; or, with one of the highest bits, 24 and the child's
/// own number for a node.
const COUNT_BITS: u8 = 0b1110_0000;
const NODE: u8 = 0b0011_1000;

impl Portable for CompressedWideBvh {
    const NAME: &'static str = "cwbvh";

    /// What the arithmetic of the grid rounds, when a box is put on it and when it is taken from
    /// it. Rays that meet these boxes have twice the padding, of which 16 ε is to spare.
    const SLACK: f32 = 12.0 * f32::EPSILON;

    fn write(&self, out: &mut Encoder<'_>) -> io::Result<()> {
        out.u32(self.nodes.len() as u32)?;
        out.list(&self.nodes, to_words)
    }

    fn read(
        primitives: &impl Bounded,
        Slots { order, .. }: Slots<'_>,
        input: &mut Decoder<'_>,
    ) -> Result<Self, LoadError> {
        let count = input.u32()?;
        if count == 0 && primitives.count() > 0 {
            return Err(LoadError::invalid("there are primitives, and no nodes"));
        }
        let nodes = input.list(count, "nodes", of_words)?;
        let mut family = Nodes::new(nodes.len());
        for (index, node) in nodes.iter().enumerate() {
            check_node(node, index, order, &mut family)?;
        }
        family.finish()?;
        Ok(Self { nodes })
    }
}

/// The fields of a node, in their order.
fn to_words(node: &CwBvhNode) -> [u32; 20] {
    let [x, y, z] = node.p.to_array().map(f32::to_bits);
    let [e0, e1, e2] = node.e;
    let bytes = [
        &node.child_meta,
        &node.child_min_x,
        &node.child_max_x,
        &node.child_min_y,
        &node.child_max_y,
        &node.child_min_z,
        &node.child_max_z,
    ];
    let mut words = [0; 20];
    let grid = u32::from_le_bytes([e0, e1, e2, node.imask]);
    words[..6].copy_from_slice(&[x, y, z, grid, node.child_base_idx, node.primitive_base_idx]);
    for (words, bytes) in words[6..].chunks_exact_mut(2).zip(bytes) {
        for (word, bytes) in words.iter_mut().zip(bytes.as_chunks().0) {
            *word = u32::from_le_bytes(*bytes);
        }
    }
    words
}

fn of_words(words: [u32; 20]) -> CwBvhNode {
    let bytes = |field: usize| {
        let of = |word: usize| words[6 + 2 * field + word].to_le_bytes();
        let ([a, b, c, d], [e, f, g, h]) = (of(0), of(1));
        [a, b, c, d, e, f, g, h]
    };
    let [e0, e1, e2, imask] = words[3].to_le_bytes();
    CwBvhNode {
        p: Vec3::from_array([words[0], words[1], words[2]].map(f32::from_bits)),
        e: [e0, e1, e2],
        imask,
        child_base_idx: words[4],
        primitive_base_idx: words[5],
        child_meta: bytes(0),
        child_min_x: bytes(1),
        child_max_x: bytes(2),
        child_min_y: bytes(3),
        child_max_y: bytes(4),
        child_min_z: bytes(5),
        child_max_z: bytes(6),
    }
}

/// Checks that the children's meta data are such, and that their slots and nodes exist.
fn check_node(
    node: &CwBvhNode,
    index: usize,
    order: &[u32],
    family: &mut Nodes,
) -> Result<(), LoadError> {
    // Of a node without leaves, no slot is looked at, but numbers are counted from this one.
    if node.primitive_base_idx as usize > order.len() {
        return Err(LoadError::invalid(format!("node {index} has leaves of no slots")));
    }
    let mut next_node = u64::from(node.child_base_idx);
    for child in 0..WIDTH {
        let meta = node.child_meta[child];
        if !node.is_leaf(child) {
            if meta != NODE | child as u8 {
                return Err(LoadError::invalid(format!("node {index} has children of no kind")));
            }
            family.add(index, usize::try_from(next_node).unwrap_or(usize::MAX))?;
            next_node += 1;
        } else if meta != 0 {
            let count = (meta & COUNT_BITS).count_ones();
            let first = u64::from(node.primitive_base_idx) + u64::from(meta & !COUNT_BITS);
            let end = first + u64::from(count);
            let is_unary = matches!(meta & COUNT_BITS, 0b0010_0000 | 0b0110_0000 | 0b1110_0000);
            if !is_unary || end > order.len() as u64 {
                return Err(LoadError::invalid(format!("node {index} has leaves of no slots")));
            }
        }
    }
    Ok(())
}
