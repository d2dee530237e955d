//! The binary tree in bytes.

use std::io;

use crate::accel::save::Nodes;
use crate::accel::{Bounded, Decoder, Encoder, LoadError, Portable, Slots};

use super::{Bvh, Child, Node, planes_of};

impl Portable for Bvh {
    const NAME: &'static str = "bvh";

    fn write(&self, out: &mut Encoder<'_>) -> io::Result<()> {
        out.u32(self.nodes.len() as u32)?;
        if self.nodes.is_empty() {
            return write_child(self.root.unwrap_or_default(), out);
        }
        for node in &self.nodes {
            for (side, &child) in node.children.iter().enumerate() {
                out.aabb(&node.child_bounds(side))?;
                write_child(child, out)?;
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
        if count == 0 {
            let root = read_child(order, input)?;
            let root = (root.count > 0).then_some(root);
            return match root.is_none() && primitives.count() > 0 {
                true => Err(LoadError::invalid("there are primitives, and no nodes")),
                false => Ok(Self { nodes: Vec::new(), root, paths: None }),
            };
        }
        let mut nodes = input.list(count, |input| read_node(order, input))?;
        nodes.shrink_to_fit();
        let mut family = Nodes::new(nodes.len());
        for (index, node) in nodes.iter().enumerate() {
            for child in node.children.iter().filter(|child| child.count == 0) {
                family.add(index, child.first as usize)?;
            }
        }
        family.finish()?;
        Ok(Self { nodes, root: Some(Child { first: 0, count: 0 }), paths: None })
    }
}

fn write_child(child: Child, out: &mut Encoder<'_>) -> io::Result<()> {
    out.u32(child.count)?;
    out.u32(child.first)
}

/// A leaf of slots that exist, or a node that need not.
fn read_child(order: &[u32], input: &mut Decoder<'_>) -> Result<Child, LoadError> {
    let child = Child { count: input.u32()?, first: input.u32()? };
    let end = u64::from(child.first) + u64::from(child.count);
    if child.count > 0 && end > order.len() as u64 {
        return Err(LoadError::invalid(format!("there is no slot {}", end - 1)));
    }
    Ok(child)
}

fn read_node(order: &[u32], input: &mut Decoder<'_>) -> Result<Node, LoadError> {
    let (left, left_child) = (input.aabb()?, read_child(order, input)?);
    let (right, right_child) = (input.aabb()?, read_child(order, input)?);
    Ok(Node { planes: planes_of(&left, &right), children: [left_child, right_child] })
}
