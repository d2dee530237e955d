//! A tree by [parry3d](https://parry.rs) 0.31, the collision library of the Rapier engine.
//!
//! Its binned builder, the default and the one that its meshes take: from the top, in eight bins along the axis on
//! which centres lie farthest apart, by the volumes of boxes (after Wald: *On fast Construction of SAH-based Bounding
//! Volume Hierarchies*, 2007). It has clusters, too, which take a time that grows with the square of the number of
//! boxes that are equal, so they are not offered. It builds on one thread, and its tree is read by its own walk, node
//! by node.

use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use parry3d::bounding_volume;
use parry3d::math::Vector;
use parry3d::partitioning::{Bvh, BvhBuildStrategy, BvhNodeIndex, TraversalAction};

use super::super::BuildStages;
use super::Boxed;
use super::walked::{self, FORK};

/// The library calls itself for each level. A level of its tree has 7/8 of the length of the one above, or less, along
/// one of the axes, and so no tree is deeper than 3400 levels, for which this is enough.
const STACK: usize = 64 << 20;

/// So many primitives at the most make a tree that any thread's stack is enough for.
const FEW: usize = 128;

/// Builds a tree over at least one primitive.
pub(super) fn build(primitives: &dyn Boxed, stages: &mut BuildStages) -> Bvh2 {
    walked::build(primitives, walk_with_room, stages)
}

/// The walk, built where there is a stack for it.
fn walk_with_room(boxes: &[Aabb]) -> Vec<u32> {
    if boxes.len() <= FEW {
        return walk(boxes);
    }
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().name("parry".to_owned()).stack_size(STACK);
        match thread.spawn_scoped(scope, || walk(boxes)) {
            Ok(thread) => thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            // Without a thread on the stack at hand, which is enough for usual trees.
            Err(_) => walk(boxes),
        }
    })
}

/// The nodes of the library's tree.
fn walk(boxes: &[Aabb]) -> Vec<u32> {
    let leaf = |(index, bounds): (usize, &Aabb)| {
        let [min, max] = walked::shown(bounds).map(Vector::from_array);
        (index, bounding_volume::Aabb::new(min, max))
    };
    let tree = Bvh::from_iter(BvhBuildStrategy::Binned, boxes.iter().enumerate().map(leaf));
    let mut walk = Vec::with_capacity(2 * boxes.len() - 1);
    let mut open = Vec::new();
    let enter = |of: Option<BvhNodeIndex>, open: &mut Vec<_>| {
        // Of a node both below it are shown, and what is below those is left alone.
        let first = open.len();
        tree.traverse_indexed(of, |node, index| {
            if of == Some(index) {
                return TraversalAction::Continue;
            }
            open.push((node.leaf_data(), index));
            TraversalAction::Prune
        });
        // The left one last, to be taken first.
        open[first..].reverse();
    };
    if boxes.len() > 1 {
        walk.push(FORK);
    }
    enter(None, &mut open);
    while let Some((primitive, index)) = open.pop() {
        walk.push(primitive.unwrap_or(FORK));
        if primitive.is_none() {
            enter(Some(index), &mut open);
        }
    }
    walk
}
