//! The compressed eight-wide tree in bytes: its nodes of 80 bytes, as obvhs lays them out.

use std::io;

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
        for node in &self.nodes {
            out.vec3(node.p)?;
            out.bytes(&node.e)?;
            out.bytes(&[node.imask])?;
            out.u32(node.child_base_idx)?;
            out.u32(node.primitive_base_idx)?;
            out.bytes(&node.child_meta)?;
            for (min, max) in planes(node) {
                out.bytes(min)?;
                out.bytes(max)?;
            }
        }
        Ok(())
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
        let mut nodes = input.list(count, read_node)?;
        nodes.shrink_to_fit();
        let mut family = Nodes::new(nodes.len());
        for (index, node) in nodes.iter().enumerate() {
            check_node(node, index, order, &mut family)?;
        }
        family.finish()?;
        Ok(Self { nodes })
    }
}

/// The planes of the children's boxes, low and high, axis by axis.
fn planes(node: &CwBvhNode) -> [(&[u8; WIDTH], &[u8; WIDTH]); 3] {
    [
        (&node.child_min_x, &node.child_max_x),
        (&node.child_min_y, &node.child_max_y),
        (&node.child_min_z, &node.child_max_z),
    ]
}

fn read_node(input: &mut Decoder<'_>) -> Result<CwBvhNode, LoadError> {
    Ok(CwBvhNode {
        p: input.vec3()?,
        e: input.array()?,
        imask: u8::from_le_bytes(input.array()?),
        child_base_idx: input.u32()?,
        primitive_base_idx: input.u32()?,
        child_meta: input.array()?,
        child_min_x: input.array()?,
        child_max_x: input.array()?,
        child_min_y: input.array()?,
        child_max_y: input.array()?,
        child_min_z: input.array()?,
        child_max_z: input.array()?,
    })
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
