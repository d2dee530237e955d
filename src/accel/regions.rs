//! The parts of space that a structure tests rays against, shown for pictures. No ray goes through here.

use std::ops::Range;

use glam::Vec3;

use crate::math::Aabb;

use super::{KDop, Tree};

/// The parts of space of a structure, those that hold others before these: nodes of trees and cells of grids.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Regions {
    all: Vec<Region>,
    /// What the leaves hold, leaf by leaf.
    slots: Vec<u32>,
}

/// A part of space that a ray is tested against before what is in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// Its form.
    pub form: RegionForm,
    /// Steps from the root, or from the whole of a grid, which are at level 0.
    pub level: u32,
    /// The places of what it holds in [`Regions::held`]; `None` if it is parted further.
    held: Option<Range<usize>>,
}

/// The form of a part of space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RegionForm {
    /// A box.
    Box(Aabb),
    /// A ball.
    Ball {
        /// Its centre.
        center: Vec3,
        /// Its radius.
        radius: f32,
    },
    /// What lies between parallel planes.
    Polytope(KDop),
}

impl Region {
    /// Whether it is not parted further. It may be empty: a cell in which nothing lies.
    #[must_use]
    pub fn is_leaf(&self) -> bool {
        self.held.is_some()
    }

    /// How many primitives a leaf holds; 0 if it is none.
    #[must_use]
    pub fn count(&self) -> usize {
        self.held.as_ref().map_or(0, Range::len)
    }
}

impl Regions {
    /// Appends a part that is parted further.
    pub fn push_inner(&mut self, form: RegionForm, level: u32) {
        self.all.push(Region { form, level, held: None });
    }

    /// Appends a leaf with the slots of what it holds.
    pub fn push_leaf(
        &mut self,
        form: RegionForm,
        level: u32,
        slots: impl IntoIterator<Item = u32>,
    ) {
        let first = self.slots.len();
        self.slots.extend(slots);
        self.all.push(Region { form, level, held: Some(first..self.slots.len()) });
    }

    /// The nodes of a tree of boxes.
    #[must_use]
    pub fn of_tree(tree: &Tree) -> Self {
        Self::of_tree_with(tree, |slots| slots)
    }

    /// The nodes of a tree whose leaves have lists in the place of slots.
    pub(super) fn of_tree_with<I: IntoIterator<Item = u32>>(
        tree: &Tree,
        slots: impl Fn(Range<u32>) -> I,
    ) -> Self {
        let mut regions = Self::default();
        // The ends of the nodes that the walk is in.
        let mut open: Vec<usize> = Vec::new();
        for (place, node) in tree.nodes().iter().enumerate() {
            while open.last().is_some_and(|&end| end <= place) {
                open.pop();
            }
            let (form, level) = (RegionForm::Box(node.bounds), open.len() as u32);
            if node.children == 0 {
                regions.push_leaf(form, level, slots(node.slots.clone()));
            } else {
                regions.push_inner(form, level);
            }
            open.push(node.end);
        }
        regions
    }

    /// All of them.
    #[must_use]
    pub fn all(&self) -> &[Region] {
        &self.all
    }

    /// The slots of the primitives that a leaf holds; none if it is no leaf.
    #[must_use]
    pub fn held(&self, region: &Region) -> &[u32] {
        region.held.clone().map_or(&[], |held| &self.slots[held])
    }

    /// How many levels there are.
    #[must_use]
    pub fn levels(&self) -> u32 {
        self.all.iter().map(|region| region.level + 1).max().unwrap_or(0)
    }

    #[cfg(feature = "program")]
    /// Puts other numbers in the place of slots: ids of primitives.
    pub(crate) fn rename(&mut self, id: impl Fn(u32) -> u32) {
        self.slots.iter_mut().for_each(|slot| *slot = id(*slot));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_of_a_tree_are_steps_from_its_root() {
        // A chain: each node has a leaf and, but for the last, another node. Numbers below 3 are nodes.
        let tree = Tree::of(0u32, |&node, children| {
            if node < 3 {
                children.extend([node + 10, node + 1]);
                return (Aabb::EMPTY, 0..0);
            }
            (Aabb::EMPTY, node..node + 2)
        });
        let regions = Regions::of_tree(&tree);
        let levels: Vec<u32> = regions.all().iter().map(|region| region.level).collect();
        assert_eq!(levels, [0, 1, 1, 2, 2, 3, 3]);
        assert_eq!(regions.levels(), 4);
        let leaves: Vec<&[u32]> = regions.all().iter().map(|region| regions.held(region)).collect();
        assert_eq!(leaves, [&[][..], &[10, 11], &[], &[11, 12], &[], &[12, 13], &[3, 4]]);
        let inner = regions.all().iter().filter(|region| !region.is_leaf()).count();
        assert_eq!((inner, regions.all()[1].count()), (3, 2));
    }
}
