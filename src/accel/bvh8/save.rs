//! The tree of eight children in bytes.
//!
//! What follows from the boxes is computed anew: the order in which rays meet the children, and how
//! high a stack must be.

use std::io;

use rayon::prelude::*;

use crate::accel::refit::Memory;
use crate::accel::save::{Nodes, is_plainly_sound};
use crate::accel::{Bounded, Decoder, Encoder, LoadError, PACK, Portable, Slots};
use crate::math::NONE;

use super::node::{Child, Node, WIDTH};
use super::{Bvh8, Height};

impl Portable for Bvh8 {
    const NAME: &'static str = "bvh8";

    fn write(&self, out: &mut Encoder<'_>) -> io::Result<()> {
        out.u32(self.nodes.len() as u32)?;
        out.list(&self.nodes, Node::stored_words)
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
        let nodes = input.list(count, "nodes", Node::of_words)?;
        let faults = nodes.par_iter().enumerate();
        if let Some(what) = faults.find_map_first(|(index, node)| fault(node, index, order, block))
        {
            return Err(LoadError::invalid(what));
        }
        let mut family = Nodes::new(nodes.len());
        for (index, node) in nodes.iter().enumerate() {
            for (_, child) in node.present().filter(|(_, child)| !child.is_leaf()) {
                family.add(index, child.index())?;
            }
        }
        family.finish()?;
        let height = Height::of(&nodes);
        Ok(Self { nodes, block, height, memory: Memory::default() })
    }

    fn is_plainly_sound(&self, primitives: &impl Bounded, order: &[u32]) -> bool {
        is_plainly_sound(&self.nodes, self.block, primitives, order)
    }
}

/// What is wrong with a node, as far as it is seen without the others.
fn fault(node: &Node, index: usize, order: &[u32], block: usize) -> Option<String> {
    let count = node.present().count();
    let are_first = node.present().all(|(lane, _)| lane < count);
    if count == 0 || !are_first {
        return Some(format!("node {index} has no children, or others behind none"));
    }
    node.present().find_map(|(_, child)| {
        let (first, count) = (child.block() * block, child.count() as usize);
        // The primitives of a pack stand in ascending order: see `Layout::leaf` in `collapse.rs`.
        let is_leaf_of =
            |slots: &[u32]| (block == 1 || slots.is_sorted()) && !slots.contains(&NONE);
        let is_right = match child.is_leaf() {
            true => order.get(first..first + count).is_some_and(is_leaf_of) && count <= WIDTH,
            false => child.index() < Child::LIMIT,
        };
        (!is_right).then(|| format!("a child of node {index} is no leaf of slots, and no node"))
    })
}
