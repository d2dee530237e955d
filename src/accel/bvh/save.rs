//! The binary tree in bytes.

use std::io;

use crate::accel::refit::Memory;
use crate::accel::save::{Nodes, box_of, is_plainly_sound, words_of};
use crate::accel::{Bounded, Decoder, Encoder, LoadError, Portable, Slots};

use super::{Bvh, Child, Node, planes_of};

impl Portable for Bvh {
    const NAME: &'static str = "bvh";

    fn write(&self, out: &mut Encoder<'_>) -> io::Result<()> {
        out.u32(self.nodes.len() as u32)?;
        if self.nodes.is_empty() {
            let Child { first, count } = self.root.unwrap_or_default();
            out.u32(count)?;
            return out.u32(first);
        }
        out.list(&self.nodes, to_words)
    }

    fn read(
        primitives: &impl Bounded,
        Slots { order, .. }: Slots<'_>,
        input: &mut Decoder<'_>,
    ) -> Result<Self, LoadError> {
        let count = input.u32()?;
        if count == 0 {
            let root = Child { count: input.u32()?, first: input.u32()? };
            expect_slots(root, order)?;
            let root = (root.count > 0).then_some(root);
            return match root.is_none() && primitives.count() > 0 {
                true => Err(LoadError::invalid("there are primitives, and no nodes")),
                false => Ok(Self { nodes: Vec::new(), root, memory: Memory::default() }),
            };
        }
        let nodes = input.list(count, "nodes", of_words)?;
        let mut family = Nodes::new(nodes.len());
        for (index, node) in nodes.iter().enumerate() {
            for &child in &node.children {
                match child.count {
                    0 => family.add(index, child.first as usize)?,
                    _ => expect_slots(child, order)?,
                }
            }
        }
        family.finish()?;
        Ok(Self { nodes, root: Some(Child { first: 0, count: 0 }), memory: Memory::default() })
    }

    fn is_plainly_sound(&self, primitives: &impl Bounded, order: &[u32]) -> bool {
        !self.nodes.is_empty() && is_plainly_sound(&self.nodes, 1, primitives, order)
    }
}

/// Of each side its box, then how many slots a leaf has and the first of them, or 0 and a node.
fn to_words(node: &Node) -> [u32; 16] {
    let side = |side: usize| {
        let Child { first, count } = node.children[side];
        let [a, b, c, d, e, f] = words_of(&node.child_bounds(side));
        [a, b, c, d, e, f, count, first]
    };
    let sides = [side(0), side(1)];
    std::array::from_fn(|place| sides[place / 8][place % 8])
}

fn of_words(words: [u32; 16]) -> Node {
    let side = |first: usize| box_of(std::array::from_fn(|place| words[first + place]));
    let child = |at: usize| Child { count: words[at], first: words[at + 1] };
    Node { planes: planes_of(&side(0), &side(8)), children: [child(6), child(14)] }
}

/// The slots of a leaf must exist.
fn expect_slots(child: Child, order: &[u32]) -> Result<(), LoadError> {
    let end = u64::from(child.first) + u64::from(child.count);
    match child.count > 0 && end > order.len() as u64 {
        true => Err(LoadError::invalid(format!("there is no slot {}", end - 1))),
        false => Ok(()),
    }
}
