//! The sides of boxes along the axes, sorted once.
//!
//! A cell has the sides of the boxes that touch it in six lists: low and high ones, axis by axis. If it
//! is cut, each half gets its part of every list, in the same order. That is the O(n) of a level. Wald
//! and Havran clip a triangle to the half, which moves its sides, and merge those in anew. Here boxes
//! are what is referred to, and a box that is clipped to the half has its sides in the planes of the
//! cell, where it is never cut: what lies outside of a cell is left where it is, and nothing is sorted
//! again. (`Bounded::clipped_bounds`, the box around the part of a triangle, would leave cells out that
//! the triangle's own box touches, which the contract forbids: `docs/splits.md`.)

use rayon::prelude::*;

use crate::math::{Aabb, NONE};

/// The lists of so many boxes, or more, are parted by several threads.
const PARALLEL: usize = 1 << 12;

/// One side of a box along an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Side {
    /// Its coordinate.
    pub(super) at: f32,
    /// The place of its primitive among those of the cell.
    of: u32,
}

/// What touches a cell.
#[derive(Debug)]
pub(super) struct Sides {
    /// Primitives in ascending order.
    pub(super) ids: Vec<u32>,
    /// For each axis the low sides in ascending order, and the high ones.
    pub(super) axes: [[Vec<Side>; 2]; 3],
}

impl Sides {
    /// Those of all boxes.
    pub(super) fn of(boxes: &[Aabb]) -> Self {
        let ids: Vec<u32> = (0..boxes.len() as u32).collect();
        let axes = std::array::from_fn(|axis| {
            std::array::from_fn(|end| {
                let corners = boxes.iter().map(|bounds| [bounds.min, bounds.max][end][axis]);
                let mut sides: Vec<Side> =
                    corners.zip(0..).map(|(at, of)| Side { at, of }).collect();
                sides.par_sort_unstable_by(|a, b| a.at.total_cmp(&b.at).then(a.of.cmp(&b.of)));
                sides
            })
        });
        Self { ids, axes }
    }

    /// How many there are.
    pub(super) fn count(&self) -> usize {
        self.ids.len()
    }

    /// Those that touch the half below a plane, and those that touch the one above. What lies in the
    /// plane touches both.
    pub(super) fn cut(self, axis: usize, plane: f32) -> [Self; 2] {
        let [lows, highs] = &self.axes[axis];
        let below = &lows[..lows.partition_point(|low| low.at <= plane)];
        let above = &highs[highs.partition_point(|high| high.at < plane)..];
        let halves = if self.count() < PARALLEL {
            (self.part(below), self.part(above))
        } else {
            rayon::join(|| self.part(below), || self.part(above))
        };
        halves.into()
    }

    /// The part of some primitives, which each have one side among these.
    fn part(&self, some: &[Side]) -> Self {
        // The place of each primitive in the part, if it is there.
        let mut places = vec![NONE; self.count()];
        for side in some {
            places[side.of as usize] = 0;
        }
        let mut ids = Vec::with_capacity(some.len());
        for (place, &id) in places.iter_mut().zip(&self.ids) {
            if *place != NONE {
                *place = ids.len() as u32;
                ids.push(id);
            }
        }
        let axes = self.axes.each_ref().map(|[lows, highs]| {
            [kept(lows, &places, some.len()), kept(highs, &places, some.len())]
        });
        Self { ids, axes }
    }
}

/// The sides of the primitives that have a place.
fn kept(sides: &[Side], places: &[u32], count: usize) -> Vec<Side> {
    // One that is not kept is overwritten by the next: without a branch that could not be predicted.
    let mut kept = vec![Side::default(); count + 1];
    let mut next = 0;
    for side in sides {
        let of = places[side.of as usize];
        kept[next] = Side { of, ..*side };
        next += usize::from(of != NONE);
    }
    kept.truncate(count);
    kept
}

#[cfg(test)]
mod tests {
    use glam::Vec3A;

    use super::*;
    use crate::math::Random;

    #[test]
    fn a_half_has_the_boxes_that_touch_it_in_the_order_of_their_sides() {
        let mut random = Random::new(&[17]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.below(9) as f32));
        let boxes: Vec<Aabb> = (0..300).map(|_| Aabb::of_points([point(), point()])).collect();
        for (axis, plane) in [(0, 4.0), (1, 0.0), (2, 8.0), (0, 3.5)] {
            let halves = Sides::of(&boxes).cut(axis, plane);
            for (above, half) in halves.iter().enumerate() {
                let touches = |&id: &u32| {
                    let bounds = boxes[id as usize];
                    [bounds.min[axis] <= plane, bounds.max[axis] >= plane][above]
                };
                let expected: Vec<u32> = (0..300).filter(touches).collect();
                assert_eq!(half.ids, expected);
                for (axis, [lows, highs]) in half.axes.iter().enumerate() {
                    for (end, sides) in [lows, highs].into_iter().enumerate() {
                        assert_eq!(sides.len(), expected.len());
                        assert!(sides.is_sorted_by_key(|side| side.at));
                        for side in sides {
                            let bounds = boxes[half.ids[side.of as usize] as usize];
                            assert_eq!(side.at, [bounds.min, bounds.max][end][axis]);
                        }
                    }
                }
            }
        }
    }
}
