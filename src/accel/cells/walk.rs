//! The cells of a grid that a ray meets, in the order in which it enters them.
//!
//! After Amanatides, Woo: *A Fast Voxel Traversal Algorithm for Ray Tracing*, 1987, a step goes along
//! the axis whose next plane comes first. But the intervals of cells are closed and padded, so a ray is
//! often in several at once: it enters a cell before it leaves the one before it, and where it runs in a
//! plane, or hits an edge or a corner, it is in two, four or eight for long. A walk from cell to cell
//! would lose all but one of them. So what is kept of each axis is a *run*: the cells that the ray is in
//! along that axis, mostly one.
//!
//! # Every cell is visited whose interval meets the search, once
//! Along an axis, number cells in the order of the ray. When it enters cell `i`, `E(i)`, and when it
//! leaves it, `L(i)`, do not fall as `i` grows, and `E(i + 1) ≤ L(i)`: [`PlaneRay`]. The interval of a
//! cell of the grid is from the latest `E` to the earliest `L` of the three axes. The search is from `t0`,
//! where it begins in the grid, to its end. A cell that it meets is visited at `t`, the larger of `t0` and
//! its latest `E`:
//! * At `t0` the run of an axis is all `i` with `E(i) ≤ t0 ≤ L(i)`, which are neighbours since neither
//!   falls. All cells of the three runs are visited.
//! * After that the next `E` of all axes is a step: its cell joins the run of its axis, what was left
//!   before `E` goes from the runs of the others, and what is visited is that cell with all of theirs. Each
//!   of these has entered and not left at `E`. Of equal `E` one step comes first, and the cells that
//!   joined last see the others in the runs, so a cell is visited with the last of its three steps.
//! * No run is empty at a step at `t`. Its last cell `i` has `L(i) ≥ E(i + 1) ≥ t`, because that step is yet
//!   to come; the last of the axis has `L ≥ t`, because the walk ends where the ray leaves the grid.
//!
//! Steps come in ascending order, so the first behind the end of the search ends the walk.

use std::ops::ControlFlow;

use super::raster::Axis;
use super::{PlaneRay, Raster};

/// The cells along an axis that a ray is in.
#[derive(Clone, Copy)]
struct Run {
    /// The first and the last of them, in the order of the ray.
    oldest: u32,
    newest: u32,
    /// When the ray leaves the oldest, and when it enters the one behind the newest.
    leaves: f32,
    enters: f32,
}

/// A ray along an axis.
struct Line<'a> {
    number: usize,
    axis: Axis,
    ray: &'a PlaneRay,
}

impl Line<'_> {
    /// The plane before a cell in the order of the ray.
    #[inline(always)]
    fn plane(&self, place: u32) -> f32 {
        let upwards = self.ray.upwards[self.number];
        self.axis.plane(if upwards { place } else { self.axis.cells - place })
    }

    #[inline(always)]
    fn enters(&self, place: u32) -> f32 {
        if place == self.axis.cells {
            return f32::INFINITY;
        }
        self.ray.enters(self.number, self.plane(place))
    }

    #[inline(always)]
    fn leaves(&self, place: u32) -> f32 {
        self.ray.leaves(self.number, self.plane(place + 1))
    }

    /// The run at a time when the ray is in the grid.
    #[inline(always)]
    fn run_at(&self, t: f32) -> Run {
        let cell = self.axis.near(self.ray.coordinate(self.number, t));
        let mut newest =
            if self.ray.upwards[self.number] { cell } else { self.axis.cells - 1 - cell };
        while newest > 0 && self.enters(newest) > t {
            newest -= 1;
        }
        while self.enters(newest + 1) <= t {
            newest += 1;
        }
        let mut oldest = newest;
        while oldest > 0 && self.leaves(oldest - 1) >= t {
            oldest -= 1;
        }
        Run { oldest, newest, leaves: self.leaves(oldest), enters: self.enters(newest + 1) }
    }
}

/// Calls `visit` with the number of each cell that a ray meets between `begin` and `end`, and which it
/// returns the new end. Breaks where that does.
#[inline(always)]
pub(in super::super) fn walk(
    raster: &Raster,
    ray: &PlaneRay,
    begin: f32,
    mut end: f32,
    mut visit: impl FnMut(u32) -> ControlFlow<(), f32>,
) -> ControlFlow<(), f32> {
    let lines: [Line<'_>; 3] =
        std::array::from_fn(|number| Line { number, axis: raster.0[number], ray });
    let (mut t, mut out) = (begin, f32::INFINITY);
    for line in &lines {
        t = t.max(line.enters(0));
        out = out.min(line.leaves(line.axis.cells - 1));
    }
    // What is not a number meets nothing.
    if !(t <= out && t <= end) {
        return ControlFlow::Continue(end);
    }
    let strides = raster.strides();
    // The number of a cell is the sum of these of its places.
    let number = |axis: usize, place: u32| {
        let last = lines[axis].axis.cells - 1;
        strides[axis] * if ray.upwards[axis] { place } else { last - place }
    };
    let mut runs = [lines[0].run_at(t), lines[1].run_at(t), lines[2].run_at(t)];
    // What is visited next: of each axis these places.
    let mut next = runs.map(|run| [run.oldest, run.newest]);
    loop {
        for z in next[2][0]..=next[2][1] {
            for y in next[1][0]..=next[1][1] {
                for x in next[0][0]..=next[0][1] {
                    end = visit(number(0, x) + number(1, y) + number(2, z))?;
                }
            }
        }
        let axis = match runs.map(|run| run.enters) {
            [x, y, z] if x <= y && x <= z => 0,
            [_, y, z] if y <= z => 1,
            _ => 2,
        };
        t = runs[axis].enters;
        if !(t <= out && t <= end) {
            return ControlFlow::Continue(end);
        }
        for (other, (run, line)) in runs.iter_mut().zip(&lines).enumerate() {
            if other == axis {
                run.newest += 1;
                run.enters = line.enters(run.newest + 1);
                next[other] = [run.newest; 2];
            } else {
                while run.leaves < t {
                    run.oldest += 1;
                    run.leaves = line.leaves(run.oldest);
                }
                next[other] = [run.oldest, run.newest];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::{Vec3, Vec3A};

    use super::*;
    use crate::math::{Aabb, BoxRay, Padding, Random, Ray};

    /// Rays of all kinds through grids of a few cells, many in planes, through edges and corners.
    #[test]
    fn every_cell_whose_interval_meets_the_search_is_visited_once() {
        let mut random = Random::new(&[23]);
        let (mut met, mut together) = (0, 0);
        for number in 0..6_000usize {
            let size = Vec3A::new(1.0, [1.0, 0.5, 0.0][number % 3], 2.0);
            let offset = Vec3A::splat([0.0, -0.5, 1e4][number / 3 % 3]);
            let bounds = Aabb { min: offset, max: offset + size };
            let raster = Raster::new(&bounds, [[4, 3, 5], [1, 2, 7], [8, 1, 1]][number / 9 % 3]);
            let mut point = |free: bool| {
                Vec3::from_array(std::array::from_fn(|axis| {
                    let own = &raster.0[axis];
                    match random.below(if free { 3 } else { 2 }) {
                        2 => bounds.min[axis] + (3.0 * random.next_f32() - 1.0) * size[axis],
                        _ => own.plane(random.below(own.cells + 1)),
                    }
                }))
            };
            let (from, to) = (point(true), point(false));
            let mut dir = to - from;
            let along = [1.0, 0.0, -0.0, 1e-30, 1e-4];
            dir[number % 3] *= along[number / 5 % 5];
            dir[(number + 1) % 3] *= along[number / 25 % 5];
            let ends = [f32::MAX, 1.0, 0.5][number / 7 % 3];
            let ray = Ray::with_interval(from, dir, [0.0, 0.25][number % 2], ends);
            let box_ray = BoxRay::new(&ray, Padding::of_bounds(&bounds));
            let mut visited = vec![0; raster.count()];
            let mut begins = Vec::new();
            let flow =
                walk(&raster, &PlaneRay::new(&ray, &box_ray), ray.t_min, ray.t_max, |cell| {
                    visited[cell as usize] += 1;
                    begins.push(box_ray.interval(&raster.cell(cell as usize)).0.max(ray.t_min));
                    ControlFlow::Continue(ray.t_max)
                });
            assert_eq!(flow, ControlFlow::Continue(ray.t_max));
            assert!(begins.is_sorted(), "{ray:?}: in the order of their begins: {begins:?}");
            for (cell, times) in visited.into_iter().enumerate() {
                let (near, far) = box_ray.interval(&raster.cell(cell));
                let meets = near.max(ray.t_min) <= far.min(ray.t_max);
                assert_eq!(times, u32::from(meets), "{ray:?} in cell {cell} of {raster:?}");
                met += times;
            }
            together += begins.windows(2).filter(|pair| pair[0] == pair[1]).count();
        }
        assert!(met > 20_000 && together > 5_000, "{met} {together}");
    }

    #[test]
    fn what_a_visit_returns_ends_the_walk() {
        let bounds = Aabb { min: Vec3A::ZERO, max: Vec3A::splat(8.0) };
        let raster = Raster::new(&bounds, [8, 1, 1]);
        let ray = Ray::new(Vec3::new(-1.0, 4.0, 4.0), Vec3::X);
        let ray = PlaneRay::new(&ray, &BoxRay::new(&ray, Padding::of_bounds(&bounds)));
        let visits = |answer: ControlFlow<(), f32>| {
            let mut visits = Vec::new();
            let flow = walk(&raster, &ray, 0.0, 100.0, |cell| {
                visits.push(cell);
                if visits.len() >= 3 { answer } else { ControlFlow::Continue(100.0) }
            });
            (visits, flow)
        };
        assert_eq!(visits(ControlFlow::Break(())), (vec![0, 1, 2], ControlFlow::Break(())));
        assert_eq!(
            visits(ControlFlow::Continue(4.5)),
            (vec![0, 1, 2, 3], ControlFlow::Continue(4.5))
        );
    }
}
