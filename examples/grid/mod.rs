//! A loose grid: the structure that the examples bring from outside the crate.

use std::ops::{ControlFlow, Range};

use srt::accel::{Accel, Bounded, Build, Built, Order, Tree};
use srt::counters::Counters;
use srt::math::{Aabb, BoxRay, Ray};

/// The cells of a grid in which the centre of any primitive lies: the box around these primitives,
/// and their slots.
pub(crate) struct Grid {
    cells: Vec<(Aabb, Range<u32>)>,
}

impl Accel for Grid {
    fn build(primitives: &impl Bounded, _: &mut Build<'_>) -> Built<Self> {
        // About as many cells as there are primitives in each.
        let side = f64::from(primitives.count()).powf(1.0 / 6.0).ceil() as f32;
        let all = primitives.total_bounds();
        let cell_of = |primitive: u32| {
            let place = (primitives.bounds(primitive).center() - all.min) / all.size();
            (side * place).to_array().map(|x| x.min(side - 1.0) as u32)
        };
        let mut order: Vec<u32> = (0..primitives.count()).collect();
        order.sort_by_cached_key(|&primitive| cell_of(primitive));
        let (mut cells, mut first) = (Vec::new(), 0);
        for cell in order.chunk_by(|&a, &b| cell_of(a) == cell_of(b)) {
            let boxes = cell.iter().map(|&primitive| primitives.bounds(primitive));
            let end = first + cell.len() as u32;
            cells.push((boxes.fold(Aabb::EMPTY, Aabb::union), first..end));
            first = end;
        }
        Built { accel: Self { cells }, order: Some(Order::Permutation(order)) }
    }

    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        let mut end = ray.end();
        for (bounds, slots) in &self.cells {
            counters.boxes(1);
            let (near, far) = box_ray.interval(bounds);
            // Inclusive: a box that begins at the end may hold a tie.
            if near.max(ray.t_min) <= far.min(end) {
                match leaf(slots.clone(), counters) {
                    ControlFlow::Continue(t) => end = t,
                    ControlFlow::Break(()) => return,
                }
            }
        }
    }

    fn bytes(&self) -> u64 {
        size_of_val(&self.cells[..]) as u64
    }

    /// The grid as a tree of two levels: for statistics.
    fn tree(&self) -> Option<Tree> {
        let all = self.cells.iter().fold(Aabb::EMPTY, |all, (bounds, _)| all.union(*bounds));
        Some(Tree::of(((all, 0..0), &self.cells[..]), |(node, below), children| {
            children.extend(below.iter().map(|cell| (cell.clone(), &self.cells[..0])));
            node.clone()
        }))
    }
}
