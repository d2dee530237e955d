//! What makes a tree that was read one that returns the right hits.

use rayon::prelude::*;

use crate::accel::refit::{Below, FitNode};
use crate::accel::{Bounded, Tree};
use crate::math::{Aabb, NONE};

use super::LoadError;

/// Checks that the leaves hold each primitive once, and that the box of each node, but for a slack,
/// encloses the boxes of all primitives below it.
pub(super) fn tree(
    tree: &Tree,
    primitives: &impl Bounded,
    order: &[u32],
    slack: f32,
) -> Result<(), LoadError> {
    let nodes = tree.nodes();
    let mut slots = Slots { order, offered: vec![false; order.len()], count: 0 };
    // The box around all that is below each node. Children stand behind their parents.
    let mut contents = vec![Aabb::EMPTY; nodes.len()];
    for (index, node) in nodes.iter().enumerate().rev() {
        let mut around = Aabb::EMPTY;
        for slot in node.slots.clone() {
            slots.offer(slot)?;
            around = around.union(primitives.bounds(slot));
        }
        let mut child = index + 1;
        while child < node.end {
            around = around.union(contents[child]);
            child = nodes[child].end;
        }
        // No ray is tested against the root.
        if index > 0 && !encloses(&node.bounds, &around, slack) {
            return Err(LoadError::invalid("a box does not enclose what is below it"));
        }
        contents[index] = around;
    }
    match slots.count == primitives.count() {
        true => Ok(()),
        false => Err(LoadError::invalid("a primitive is in no leaf")),
    }
}

/// Whether [`tree`] would find nothing, seen node by node: each leaf's box encloses its primitives,
/// and that of an inner child the boxes of all its own children. Of trees that were built this is so.
///
/// Boxes are looked at only if leaves offer as many slots as there are primitives: leaves that all name the same many
/// slots would take a time that grows with the square of their number.
pub(in crate::accel) fn is_plainly_sound<N: FitNode>(
    nodes: &[N],
    block: usize,
    primitives: &impl Bounded,
    order: &[u32],
) -> bool {
    let leaves = |node: &N| {
        let count = |lane: usize| match node.below(lane, block) {
            Some(Below::Slots(slots)) => slots.len() as u64,
            _ => 0,
        };
        (0..N::WIDTH).map(count).sum::<u64>()
    };
    if nodes.par_iter().map(leaves).sum::<u64>() != u64::from(primitives.count()) {
        return false;
    }
    let enclose = || {
        nodes.par_iter().all(|node| {
            (0..N::WIDTH).all(|lane| {
                let around = match node.below(lane, block) {
                    None => return true,
                    Some(Below::Node(index)) => nodes[index].bounds(),
                    Some(Below::Slots(slots)) => {
                        slots.map(|slot| primitives.bounds(slot)).fold(Aabb::EMPTY, Aabb::union)
                    }
                };
                encloses(&node.child_bounds(lane), &around, 0.0)
            })
        })
    };
    let hold_each_once = || {
        let mut slots = Slots { order, offered: vec![false; order.len()], count: 0 };
        let below = nodes.iter().flat_map(|node| {
            (0..N::WIDTH).filter_map(|lane| match node.below(lane, block) {
                Some(Below::Slots(range)) => Some(range),
                _ => None,
            })
        });
        below.flatten().all(|slot| slots.offer(slot).is_ok()) && slots.count == primitives.count()
    };
    let (sound, whole) = rayon::join(enclose, hold_each_once);
    sound && whole
}

/// False where anything is NaN or infinite.
fn encloses(outer: &Aabb, inner: &Aabb, slack: f32) -> bool {
    let finite = outer.min.is_finite() && outer.max.is_finite();
    finite && (outer.min - slack).cmple(inner.min).all() && inner.max.cmple(outer.max + slack).all()
}

/// Slots that leaves offer.
struct Slots<'a> {
    order: &'a [u32],
    offered: Vec<bool>,
    count: u32,
}

impl Slots<'_> {
    fn offer(&mut self, slot: u32) -> Result<(), LoadError> {
        match self.order.get(slot as usize) {
            None => return Err(LoadError::invalid(format!("there is no slot {slot}"))),
            Some(&NONE) => return Err(LoadError::invalid(format!("slot {slot} is empty"))),
            Some(_) => {}
        }
        if std::mem::replace(&mut self.offered[slot as usize], true) {
            return Err(LoadError::invalid(format!("slot {slot} is in two leaves")));
        }
        self.count += 1;
        Ok(())
    }
}

/// Nodes in a table whose root is the first: each of the others is to be the child of one node
/// before it, so that they are a tree.
pub(in crate::accel) struct Nodes {
    has_parent: Vec<bool>,
}

impl Nodes {
    /// So many nodes without parents.
    pub(in crate::accel) fn new(count: usize) -> Self {
        Self { has_parent: vec![false; count] }
    }

    /// Notes that a node is a child of another.
    pub(in crate::accel) fn add(&mut self, parent: usize, child: usize) -> Result<(), LoadError> {
        let Some(has_parent) = self.has_parent.get_mut(child).filter(|_| child > parent) else {
            return Err(LoadError::invalid(format!("node {parent} has node {child} as a child")));
        };
        match std::mem::replace(has_parent, true) {
            true => Err(LoadError::invalid(format!("node {child} has two parents"))),
            false => Ok(()),
        }
    }

    /// Checks that all are below the root.
    pub(in crate::accel) fn finish(&self) -> Result<(), LoadError> {
        match self.has_parent.iter().skip(1).position(|has_parent| !has_parent) {
            None => Ok(()),
            Some(before) => Err(LoadError::invalid(format!("node {} has no parent", before + 1))),
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3A;

    use super::*;

    /// Points along an axis: primitive `i` at `i`.
    struct Points(u32);

    impl Bounded for Points {
        fn count(&self) -> u32 {
            self.0
        }

        fn bounds(&self, index: u32) -> Aabb {
            span(index as f32, index as f32)
        }

        fn mean_point(&self) -> Vec3A {
            Vec3A::ZERO
        }
    }

    fn span(from: f32, to: f32) -> Aabb {
        Aabb { min: Vec3A::new(from, 0.0, 0.0), max: Vec3A::new(to, 0.0, 0.0) }
    }

    /// What is wrong with leaves below a root, over three points in the first of four slots.
    fn error(leaves: &[(Aabb, std::ops::Range<u32>)], slack: f32) -> Option<String> {
        let root = (Aabb::EMPTY, 0..0, leaves);
        let shown = Tree::of(root, |(bounds, slots, below), children| {
            children.extend(below.iter().map(|(bounds, slots)| (*bounds, slots.clone(), &[][..])));
            (*bounds, slots.clone())
        });
        let order = [0, 1, 2, NONE];
        tree(&shown, &Points(3), &order, slack).err().map(|error| error.to_string())
    }

    #[test]
    fn a_tree_holds_each_primitive_once_within_its_boxes() {
        let whole = [(span(0.0, 1.0), 0..2), (span(2.0, 2.0), 2..3)];
        assert_eq!(error(&whole, 0.0), None);
        let fails = |leaves: &[_], slack, what: &str| {
            let error = error(leaves, slack).unwrap();
            assert!(error.ends_with(what), "{error}");
        };
        let [first, second] = whole.clone();
        fails(&whole[..1], 0.0, "a primitive is in no leaf");
        fails(&[first.clone(), (span(0.0, 2.0), 1..3)], 0.0, "slot 1 is in two leaves");
        fails(&[first.clone(), (span(0.0, 4.0), 2..4)], 0.0, "slot 3 is empty");
        fails(&[first.clone(), (span(0.0, 4.0), 4..5)], 0.0, "there is no slot 4");
        let narrow = [(span(0.0, 0.9), 0..2), second.clone()];
        fails(&narrow, 0.0, "a box does not enclose what is below it");
        assert_eq!(error(&narrow, 0.125), None);
        for not_finite in [f32::NAN, f32::INFINITY] {
            let open = [(span(0.0, not_finite), 0..2), second.clone()];
            fails(&open, 0.0, "a box does not enclose what is below it");
        }
    }

    #[test]
    fn nodes_are_a_tree_below_the_first() {
        let error = |result: Result<(), LoadError>| result.err().map(|error| error.to_string());
        let mut nodes = Nodes::new(3);
        nodes.add(0, 1).unwrap();
        assert!(error(nodes.finish()).unwrap().ends_with("node 2 has no parent"));
        nodes.add(1, 2).unwrap();
        assert_eq!(error(nodes.finish()), None);
        assert!(error(nodes.add(0, 2)).unwrap().ends_with("node 2 has two parents"));
        assert!(error(nodes.add(2, 2)).unwrap().ends_with("node 2 has node 2 as a child"));
        assert!(error(nodes.add(2, 3)).unwrap().ends_with("node 2 has node 3 as a child"));
    }
}
