//! Following: primitives have moved, and a tree of boxes follows them in one of several ways.
//!
//! * *Refit*: the boxes follow; nodes and slots stay as they are. After Wald, Boulos, Shirley: *Ray Tracing Deformable
//!   Scenes Using Dynamic Bounding Volume Hierarchies*, 2007.
//! * *Rotate* (`rotate.rs`): then parts of the tree that are near each other change their places where boxes become
//!   smaller by it.
//! * *Partial* (`partial.rs`): then those parts are built anew that have become much worse than they were when they
//!   were built.
//!
//! The boxes of leaves are made anew from those of their primitives, as a build makes them, and those above are the
//! unions of what is below, to the bit. So a tree that has followed keeps the contract of [`Accel`](super::Accel) as a
//! new one does; only how well it parts the primitives becomes worse as they move. Where few have moved, only the paths
//! from their leaves to the root are gone up.

mod partial;
mod paths;
mod rotate;

use std::ops::Range;

use crate::math::Aabb;
use crate::parallel::for_chunks;

use self::paths::Paths;
use super::{PACK, Packs, Primitives};

/// How a structure follows primitives that have moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Update {
    /// Boxes follow.
    Refit,
    /// Boxes follow, and neighbours in the tree change places where that makes boxes smaller.
    Rotate,
    /// Boxes follow, and parts of the tree that have become much worse are built anew.
    Partial,
}

impl Update {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Refit, Self::Rotate, Self::Partial];

    /// What was done with a structure that has followed so.
    #[must_use]
    pub fn participle(self) -> &'static str {
        match self {
            Self::Refit => "refitted",
            Self::Rotate => "refitted with rotations",
            Self::Partial => "partly rebuilt",
        }
    }
}

/// Which primitives have moved.
#[derive(Clone, Copy, Debug)]
pub enum Moved<'a> {
    /// Any of them.
    All,
    /// Those in some slots, in any order: all slots of each, where leaves share primitives. Empty slots mean nothing;
    /// [`Indexed::refit`](super::Indexed::refit) panics at slots that there are not.
    Slots(&'a [u32]),
}

/// What became of a structure that has followed.
#[derive(Clone, Debug, PartialEq)]
pub struct Followed {
    /// The box around all primitives.
    pub bounds: Aabb,
    /// For each slot from now on, the slot in which its primitive stands as yet, or
    /// [`NONE`](crate::math::NONE) where it stays empty; `None` if all stay where they are. Each primitive is to keep a
    /// slot: [`Indexed::refit`](super::Indexed::refit) panics if one does not.
    pub order: Option<Vec<u32>>,
}

impl Followed {
    /// All primitives stay in their slots.
    #[must_use]
    pub fn in_place(bounds: Aabb) -> Self {
        Self { bounds, order: None }
    }
}

/// What a node has below it.
pub(super) enum Below {
    /// The node of an index, which is larger than that of the node itself.
    Node(usize),
    /// A leaf.
    Slots(Range<u32>),
}

/// A node of a tree of boxes, with a lane for each child.
pub(super) trait FitNode: Clone + Send + Sync {
    /// How many lanes there are; at most [`WIDEST`].
    const WIDTH: usize;

    /// What a lane refers to.
    type Child: Copy;

    /// The node of an index, as a child.
    fn inner(index: usize) -> Self::Child;

    /// A leaf as a child; slots are counted in blocks of so many.
    fn leaf(slots: Range<u32>, block: usize) -> Self::Child;

    /// What a lane refers to.
    fn child(&self, lane: usize) -> Self::Child;

    /// What a lane has below it; slots are counted in blocks of so many. `None` for an empty lane.
    fn below(&self, lane: usize, block: usize) -> Option<Below>;

    /// The box of a child.
    fn child_bounds(&self, lane: usize) -> Aabb;

    /// Puts a child with its box into a lane.
    fn put(&mut self, lane: usize, child: Self::Child, bounds: &Aabb);

    /// Gives a child its box.
    fn fit(&mut self, lane: usize, bounds: &Aabb) {
        self.put(lane, self.child(lane), bounds);
    }

    /// What follows from the boxes of all children.
    fn settle(&mut self) {}

    /// The box around all children.
    fn bounds(&self) -> Aabb {
        (0..Self::WIDTH).map(|lane| self.child_bounds(lane)).fold(Aabb::EMPTY, Aabb::union)
    }
}

/// The most lanes of a node.
pub(super) const WIDEST: usize = 8;

/// Nodes that a thread takes together.
const CHUNK: usize = 1 << 9;

/// A part of a tree that was built anew.
pub(super) struct Grown<N> {
    /// The root is the first, and children stand behind their parents. None if all is one leaf.
    pub(super) nodes: Vec<N>,
    /// For each slot the place of its primitive among those that it was built over, or none.
    pub(super) order: Vec<u32>,
}

/// What a tree follows: primitives with their boxes.
pub(super) trait Leader<N: FitNode>: Sync {
    /// Slots from the beginning of one block to that of the next, as [`FitNode::below`] counts them.
    fn block(&self) -> usize;

    /// Leaves begin at multiples of so many slots.
    fn grain(&self) -> usize;

    /// The box around the primitives of a leaf.
    fn bounds(&self, slots: Range<u32>) -> Aabb;

    /// Brings slots into the order in which a build over them gets their primitives.
    fn sort(&self, slots: &mut [u32]);

    /// Builds a part anew, over the primitives in some slots.
    fn grow(&self, slots: &[u32]) -> Grown<N>;

    /// The boxes of the leaves of some nodes.
    fn fit_leaves(&self, nodes: &mut [N]) {
        fit_leaves_one_by_one(self, nodes);
    }

    /// The boxes of inner children, from the last node to the first.
    fn fit_inner(&self, nodes: &mut [N]) {
        for index in (0..nodes.len()).rev() {
            for lane in 0..N::WIDTH {
                if let Some(Below::Node(child)) = nodes[index].below(lane, self.block()) {
                    let bounds = nodes[child].bounds();
                    nodes[index].fit(lane, &bounds);
                }
            }
        }
    }
}

/// The boxes of the leaves of some nodes.
pub(super) fn fit_leaves_one_by_one<N: FitNode>(
    leader: &(impl Leader<N> + ?Sized),
    nodes: &mut [N],
) {
    for node in nodes {
        for lane in 0..N::WIDTH {
            if let Some(Below::Slots(slots)) = node.below(lane, leader.block()) {
                node.fit(lane, &leader.bounds(slots));
            }
        }
    }
}

/// The box around the primitives in some slots.
pub(super) fn bounds_of(primitives: &impl Primitives, slots: Range<u32>) -> Aabb {
    slots.map(|slot| primitives.bounds(slot)).fold(Aabb::EMPTY, Aabb::union)
}

/// Brings slots into the order of their primitives' ids, as a build gets them: of equal hits in a pack the first lane
/// is then the first primitive. Primitives that are not in packs show no ids, and may stand in any order.
pub(super) fn sort_by_id<P: Primitives>(primitives: &P, slots: &mut [u32]) {
    if const { <P::Packs as Packs>::GRAIN > 1 } {
        let id = |&slot: &u32| primitives.packs().id(slot as usize / PACK, slot as usize % PACK);
        slots.sort_by_cached_key(id);
    } else {
        slots.sort_unstable();
    }
}

/// What a tree remembers to follow its primitives, each once it was needed.
#[derive(Clone, Debug, Default)]
pub(super) struct Memory {
    /// The way up.
    paths: Option<Paths>,
    /// What each node and all below it cost when they were built: see `partial.rs`.
    built: Option<Vec<f32>>,
}

impl Memory {
    /// The memory that it takes.
    pub(super) fn bytes(&self) -> usize {
        let built = self.built.as_ref().map_or(0, Vec::capacity);
        self.paths.as_ref().map_or(0, Paths::bytes) + size_of::<f32>() * built
    }
}

/// Lets a tree of at least one node follow. The root is the first node.
pub(super) fn follow<N: FitNode>(
    update: Update,
    moved: Moved<'_>,
    (nodes, memory): (&mut Vec<N>, &mut Memory),
    leader: &dyn Leader<N>,
) -> Followed {
    /// For so many slots a node it is no more work to go through all.
    const MANY: usize = 4;
    if update == Update::Partial && memory.built.is_none() {
        memory.built = Some(partial::costs(nodes, leader.block()));
    }
    match moved {
        Moved::Slots(slots) if MANY * slots.len() < nodes.len() => {
            let paths = memory.paths.get_or_insert_with(|| Paths::of(nodes, leader.block()));
            let changed = paths.follow(nodes, slots, leader);
            if update == Update::Rotate && rotate::some(nodes, &changed, paths, leader.block()) {
                memory.built = None;
            }
        }
        Moved::Slots(_) | Moved::All => {
            for_chunks(nodes, CHUNK, &|_, nodes| leader.fit_leaves(nodes));
            leader.fit_inner(nodes);
            if update == Update::Rotate && rotate::all(nodes, leader.block()) {
                *memory = Memory::default();
            }
            for_chunks(nodes, CHUNK, &|_, nodes| nodes.iter_mut().for_each(N::settle));
        }
    }
    let bounds = nodes[0].bounds();
    let mut order = None;
    if update == Update::Partial
        && let Some(built) = &mut memory.built
    {
        order = partial::regrow(nodes, built, leader);
        if order.is_some() {
            memory.paths = None;
        }
    }
    Followed { bounds, order }
}
