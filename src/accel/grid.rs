//! A uniform grid: the box around all primitives, parted evenly into cells.
//!
//! * *Idea*: A ray steps from cell to cell, and is tested with what their lists hold. There is no
//!   hierarchy, so a build is two passes over the primitives.
//! * *Paper*: Fujimoto, Tanaka, Iwata: *ARTS: Accelerated Ray-Tracing System*, 1986; Amanatides, Woo:
//!   *A Fast Voxel Traversal Algorithm for Ray Tracing*, 1987, for the steps; Cleary, Wyvill: *Analysis
//!   of an algorithm for fast ray tracing using uniform space subdivision*, 1988, for the number of
//!   cells.
//! * *Build*: O(n).
//! * *A ray*: O(∛n) cells, most of them empty where the primitives are a surface.
//! * *Memory*: 8 bytes a cell, `density` × n of them; 40 bytes a reference to a triangle, which is a
//!   copy.
//! * *It wins*: where primitives are of one size and spread evenly, and over a kd-tree by its short
//!   build. It loses where they are not: a detailed model in a large hall lies in few cells ("the
//!   teapot in the stadium").
//! * *Picture*: `docs/gallery/cells-grid.png`.
//!
//! The rules for cells at [`Accel`] make it return the hits of all others: a primitive is listed in each
//! cell that its *box* touches, and `cells/walk.rs` has the proof that each cell is visited whose padded
//! interval the ray meets.

use std::ops::{ControlFlow, Range};

use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, Ray};

use super::build::boxes_of;
use super::cells::{Boxes, CellLists, ListBuilder, Mailbox, PlaneRay, Raster, walk};
use super::{
    Accel, Allowed, Bounded, Build, Built, OptionInfo, RegionForm, Regions, StructureShape,
};

/// A primitive has at most so many references in the mean: where large ones would have more, there are
/// fewer cells.
const MOST_OF_ONE: u64 = 16;

/// The most cells of all.
const MOST_CELLS: f64 = (1 << 30) as f64;

/// Cells of one size.
#[derive(Clone, Debug)]
pub struct Grid {
    /// None without primitives.
    raster: Option<Raster>,
    cells: Vec<Cell>,
    lists: CellLists,
}

/// The list of a cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    first: u32,
    count: u32,
}

impl Cell {
    pub(super) fn new(list: &Range<u32>) -> Self {
        Self { first: list.start, count: list.end - list.start }
    }

    #[inline(always)]
    pub(super) fn list(self) -> Range<u32> {
        self.first..self.first + self.count
    }
}

const DENSITY: OptionInfo = OptionInfo {
    name: "density",
    allowed: Allowed::Numbers(1, 64),
    default: "2",
    summary: "cells for each triangle",
};

impl Accel for Grid {
    const ONE_BY_ONE: bool = true;

    /// As measured over five kinds of meshes of one and two million triangles, copies included; hair takes 520.
    const BUILD_BYTES: u64 = 160;

    const OPTIONS: &'static [OptionInfo] = &[DENSITY];

    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        let boxes = build.stages.time("boxes", || boxes_of(primitives));
        Self::over(&boxes, build)
    }

    #[inline]
    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        let Some(raster) = &self.raster else { return };
        let plane_ray = PlaneRay::new(ray, box_ray);
        let (mut mailbox, mut end) = (Mailbox::EMPTY, ray.end());
        let _ = walk(raster, &plane_ray, ray.t_min, ray.end(), |number| {
            counters.boxes(1);
            let list = self.cells[number as usize].list();
            self.lists.offer(list, &mut mailbox, &mut end, counters, &mut leaf)?;
            ControlFlow::Continue(end)
        });
    }

    fn bytes(&self) -> u64 {
        (size_of::<Self>() + size_of_val(&self.cells[..])) as u64 + self.lists.bytes()
    }

    /// The whole, and the cells that are not empty.
    fn regions(&self) -> Regions {
        let mut regions = Regions::default();
        let Some(raster) = &self.raster else { return regions };
        regions.push_inner(RegionForm::Box(raster.bounds()), 0);
        for (number, cell) in self.cells.iter().enumerate().filter(|(_, cell)| cell.count > 0) {
            let form = RegionForm::Box(raster.cell(number));
            regions.push_leaf(form, 1, self.lists.slots(cell.list()));
        }
        regions
    }

    /// One node; its leaves are the cells that are not empty.
    fn shape(&self) -> StructureShape {
        let mut shape =
            StructureShape { nodes: 1, bytes: self.bytes(), ..StructureShape::default() };
        let occupied = self.cells.iter().filter(|cell| cell.count > 0);
        occupied.for_each(|cell| shape.add_leaf(cell.count, 1));
        shape
    }
}

impl Grid {
    fn over(boxes: &[Aabb], build: &mut Build<'_>) -> Built<Self> {
        let Build { config, grain, stages } = build;
        let mut lists = ListBuilder::new(*grain);
        if boxes.is_empty() {
            let (lists, order) = lists.finish();
            return Built { accel: Self { raster: None, cells: Vec::new(), lists }, order };
        }
        let density = config.options.number(&DENSITY).unwrap_or(2);
        let all = Boxes { boxes, ids: None };
        let raster = stages.time("resolution", || {
            let bounds = boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
            let cells = (f64::from(density) * boxes.len() as f64).min(MOST_CELLS);
            all.raster(&bounds, cells, MOST_OF_ONE)
        });
        let cells = stages.time("lists", || {
            all.file(&raster).lists().map(|ids| Cell::new(&lists.add(ids))).collect()
        });
        let (lists, order) = lists.finish();
        Built { accel: Self { raster: Some(raster), cells, lists }, order }
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3A;

    use super::super::builder::Boxes as OnlyBoxes;
    use super::super::{BuildConfig, BuildOptions, BuildStages};
    use super::*;
    use crate::math::Random;

    fn boxes(count: u32, size: f32) -> OnlyBoxes {
        let mut random = Random::new(&[3, u64::from(count)]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
        let corners = (0..count).map(|_| (point(), point()));
        OnlyBoxes(corners.map(|(a, b)| Aabb { min: a, max: a + size * b }).collect())
    }

    fn grid(boxes: &OnlyBoxes, options: &str) -> Grid {
        let options = BuildOptions::of::<Grid>(options).expect("the options are right");
        let config = BuildConfig { options, ..BuildConfig::default() };
        Grid::build(
            boxes,
            &mut Build { config: &config, grain: 4, stages: &mut BuildStages::default() },
        )
        .accel
    }

    #[test]
    fn there_are_as_many_cells_as_the_option_wants() {
        for density in [1, 4, 64] {
            let grid = grid(&boxes(3_000, 0.01), &format!("density={density}"));
            let wanted = 3_000.0 * f64::from(density);
            let share = grid.cells.len() as f64 / wanted;
            assert!((0.7..1.01).contains(&share), "{density}: {share}");
        }
    }

    #[test]
    fn large_primitives_have_no_more_references_than_the_limit() {
        let grid = grid(&boxes(2_000, 9.0), "density=64");
        let references: u64 = grid.cells.iter().map(|cell| u64::from(cell.count)).sum();
        assert!(references <= MOST_OF_ONE * 2_000, "{references}");
        assert!(grid.cells.len() > 1);
    }
}
