//! The tree of eight children in bytes.
//!
//! What follows from the boxes is computed anew: the order in which rays meet the children, and how
//! high a stack must be.

use std::io;

use crate::accel::save::Nodes;
use crate::accel::{Bounded, Decoder, Encoder, LoadError, PACK, Portable, Slots};
use crate::simd::ask_for_huge_pages;

use super::node::{Child, Node, WIDTH};
use super::{Bvh8, stack_need};

impl Portable for Bvh8 {
    const NAME: &'static str = "bvh8";

    fn write(&self, out: &mut Encoder<'_>) -> io::Result<()> {
        out.u32(self.nodes.len() as u32)?;
        for node in &self.nodes {
            out.u32(node.present().count() as u32)?;
            for (lane, child) in node.present() {
                out.aabb(&node.child_bounds(lane))?;
                let (count, first) = match child.is_leaf() {
                    true => (child.count(), (child.block() * self.block) as u32),
                    false => (0, child.index() as u32),
                };
                out.u32(count)?;
                out.u32(first)?;
            }
        }
        Ok(())
    }

    fn read(
        primitives: &impl Bounded,
        Slots { order, grain }: Slots<'_>,
        input: &mut Decoder<'_>,
    ) -> Result<Self, LoadError> {
        let block = if grain > 1 { PACK } else { 1 };
        let count = input.u32()?;
        if (count == 0 && primitives.count() > 0) || count as usize >= Child::LIMIT {
            return Err(LoadError::invalid(format!("there are {count} nodes")));
        }
        let read = input.list(count, |input| read_node(order, block, input))?;
        let mut nodes = Vec::with_capacity(read.len());
        ask_for_huge_pages(nodes.spare_capacity_mut());
        nodes.extend(read);
        let mut family = Nodes::new(nodes.len());
        for (index, node) in nodes.iter().enumerate() {
            for (_, child) in node.present().filter(|(_, child)| !child.is_leaf()) {
                family.add(index, child.index())?;
            }
        }
        family.finish()?;
        let need = stack_need(&nodes);
        Ok(Self { nodes, block, need, paths: None })
    }
}

fn read_node(order: &[u32], block: usize, input: &mut Decoder<'_>) -> Result<Node, LoadError> {
    let children = input.u32()? as usize;
    if !(1..=WIDTH).contains(&children) {
        return Err(LoadError::invalid(format!("a node has {children} children")));
    }
    let mut node = Node::EMPTY;
    for lane in 0..children {
        let bounds = input.aabb()?;
        let (count, first) = (input.u32()? as usize, input.u32()? as usize);
        let child = if count == 0 { inner(first) } else { leaf(first, count, order, block) };
        node.set(lane, child?, &bounds);
    }
    node.sort();
    Ok(node)
}

fn inner(index: usize) -> Result<Child, LoadError> {
    match index < Child::LIMIT {
        true => Ok(Child::node(index)),
        false => Err(LoadError::invalid(format!("there is no node {index}"))),
    }
}

/// A leaf begins with a block, and its primitives stand in ascending order: see
/// [`Layout::leaf`](super::collapse).
fn leaf(first: usize, count: usize, order: &[u32], block: usize) -> Result<Child, LoadError> {
    let slots = first.checked_add(count).and_then(|end| order.get(first..end));
    let fits = count <= WIDTH && first.is_multiple_of(block) && first / block < Child::LIMIT;
    match slots.is_some_and(<[u32]>::is_sorted) && fits {
        true => Ok(Child::leaf(first / block, count)),
        false => Err(LoadError::invalid(format!("slot {first} begins no leaf of {count}"))),
    }
}
