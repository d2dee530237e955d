//! A grid of grids: each cell of a coarse grid is parted by how much it holds.
//!
//! * *Idea*: A uniform grid is too coarse where much lies, and too fine where nothing does. A second
//!   level mends the most of it, and there are still no pointers to follow.
//! * *Paper*: Kalojanov, Billeter, Slusallek: *Two-Level Grids for Ray Tracing on GPUs*, 2011; Jevans,
//!   Wyvill: *Adaptive Voxel Subdivision for Ray Tracing*, 1989, for grids in grids.
//! * *Build*: O(n): two passes for each level.
//! * *A ray*: the cells of the coarse grid on its way, and in those that are not empty the cells of
//!   theirs.
//! * *Memory*: 12 bytes a coarse cell, of which there are n / 8; 8 bytes a fine one, `density` for each
//!   reference of a coarse cell; 40 bytes a reference to a triangle, which is a copy.
//! * *It wins*: over a grid, where primitives are not spread evenly, and over a kd-tree by its short
//!   build. Where a grid fits, it loses by what each walk through a few cells costs to begin.
//! * *Picture*: `docs/gallery/cells-grid2.png`.
//!
//! The rules for cells at [`Accel`] make it return the hits of all others: a primitive is listed in each
//! fine cell that its *box* touches, and these cover what they are parts of. `cells/walk.rs` has the proof
//! that a walk visits each cell whose padded interval the ray meets; those of fine cells lie within that of
//! their coarse one.

use std::ops::{ControlFlow, Range};

use rayon::prelude::*;

use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, Ray};

use super::build::boxes_of;
use super::cells::{Boxes, CellLists, Filed, ListBuilder, Mailbox, PlaneRay, Raster, walk};
use super::grid::Cell;
use super::order::in_32_bits;
use super::{
    Accel, Allowed, Bounded, Build, Built, OptionInfo, RegionForm, Regions, StructureShape,
};

/// Coarse cells for each primitive: about the 0.12 of the paper.
const COARSE: f64 = 0.125;

/// The most cells of the coarse grid.
const MOST_CELLS: f64 = (1 << 28) as f64;

/// On either level a primitive has at most so many references in the mean.
const MOST_OF_ONE: u64 = 4;

/// The most cells of a coarse one along an axis.
const MOST_PARTS: u32 = 255;

/// Cells of two sizes.
#[derive(Clone, Debug)]
pub struct TwoLevelGrid {
    /// None without primitives.
    raster: Option<Raster>,
    coarse: Vec<Coarse>,
    cells: Vec<Cell>,
    lists: CellLists,
}

/// A cell of the coarse grid.
#[derive(Clone, Copy, Debug)]
struct Coarse {
    /// The first of its cells.
    first: u32,
    /// How many there are along each axis; 0 where nothing lies.
    parts: [u16; 3],
}

const DENSITY: OptionInfo = OptionInfo {
    name: "density",
    allowed: Allowed::Numbers(1, 64),
    default: "2",
    summary: "fine cells for each triangle in a coarse one",
};

impl Accel for TwoLevelGrid {
    const ONE_BY_ONE: bool = true;

    /// As measured over five kinds of meshes of one and two million triangles, copies included; hair takes 480.
    const BUILD_BYTES: u64 = 300;

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
            let coarse = self.coarse[number as usize];
            if coarse.parts[0] == 0 {
                return ControlFlow::Continue(end);
            }
            let parts = Raster::new(&raster.cell(number as usize), coarse.parts.map(u32::from));
            walk(&parts, &plane_ray, ray.t_min, end, |number| {
                counters.boxes(1);
                let list = self.cells[(coarse.first + number) as usize].list();
                self.lists.offer(list, &mut mailbox, &mut end, counters, &mut leaf)?;
                ControlFlow::Continue(end)
            })
        });
    }

    fn bytes(&self) -> u64 {
        let grids = size_of_val(&self.coarse[..]) + size_of_val(&self.cells[..]);
        (size_of::<Self>() + grids) as u64 + self.lists.bytes()
    }

    /// The whole, the coarse cells that are not empty, and the fine ones.
    fn regions(&self) -> Regions {
        let mut regions = Regions::default();
        let Some(raster) = &self.raster else { return regions };
        regions.push_inner(RegionForm::Box(raster.bounds()), 0);
        let occupied = self.coarse.iter().enumerate().filter(|(_, cell)| cell.parts[0] > 0);
        for (number, coarse) in occupied {
            let bounds = raster.cell(number);
            regions.push_inner(RegionForm::Box(bounds), 1);
            let parts = Raster::new(&bounds, coarse.parts.map(u32::from));
            for number in 0..parts.count() {
                let list = self.cells[coarse.first as usize + number].list();
                if !list.is_empty() {
                    let form = RegionForm::Box(parts.cell(number));
                    regions.push_leaf(form, 2, self.lists.slots(list));
                }
            }
        }
        regions
    }

    /// The nodes are the coarse grid and those in its cells, the leaves the cells that are not empty.
    fn shape(&self) -> StructureShape {
        let inner = self.coarse.iter().filter(|cell| cell.parts[0] > 0).count() as u64;
        let mut shape =
            StructureShape { nodes: 1 + inner, bytes: self.bytes(), ..StructureShape::default() };
        let sizes = self.cells.iter().map(|cell| cell.list().len() as u32);
        sizes.filter(|&size| size > 0).for_each(|size| shape.add_leaf(size, 2));
        shape
    }
}

impl TwoLevelGrid {
    fn over(boxes: &[Aabb], build: &mut Build<'_>) -> Built<Self> {
        let Build { config, grain, stages } = build;
        let mut lists = ListBuilder::new(*grain);
        if boxes.is_empty() {
            let (lists, order) = lists.finish();
            let accel = Self { raster: None, coarse: Vec::new(), cells: Vec::new(), lists };
            return Built { accel, order };
        }
        let density = f64::from(config.options.number(&DENSITY).unwrap_or(2));
        let all = Boxes { boxes, ids: None };
        let (raster, filed) = stages.time("coarse", || {
            let bounds = boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
            let cells = (COARSE * boxes.len() as f64).min(MOST_CELLS);
            let raster = all.raster(&bounds, cells, MOST_OF_ONE);
            (raster, all.file(&raster))
        });
        let parts: Vec<Option<(Raster, Filed)>> = stages.time("fine", || {
            let parted = |number: usize| {
                let own = Boxes { boxes, ids: Some(filed.list(number)) };
                (own.count() > 0).then(|| {
                    let cells = density * own.count() as f64;
                    let cells = own.raster(&raster.cell(number), cells, MOST_OF_ONE);
                    let cells = cells.of_at_most(MOST_PARTS);
                    (cells, own.file(&cells))
                })
            };
            (0..raster.count()).into_par_iter().map(parted).collect()
        });
        let mut cells = Vec::new();
        let coarse = stages.time("lists", || {
            let place = |part: &Option<(Raster, Filed)>| {
                let first = in_32_bits(cells.len());
                let Some((raster, filed)) = part else { return Coarse { first, parts: [0; 3] } };
                cells.extend(filed.lists().map(|ids| Cell::new(&lists.add(ids))));
                Coarse { first, parts: raster.0.map(|axis| axis.cells as u16) }
            };
            parts.iter().map(place).collect()
        });
        cells.shrink_to_fit();
        let (lists, order) = lists.finish();
        Built { accel: Self { raster: Some(raster), coarse, cells, lists }, order }
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3A;

    use super::super::builder::Boxes as OnlyBoxes;
    use super::super::{BuildConfig, BuildStages};
    use super::*;
    use crate::math::Random;

    #[test]
    fn cells_are_fine_where_much_lies() {
        let mut random = Random::new(&[3]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
        // A thousand in the corner of a hall that has eight.
        let corner = (0..1_000).map(|_| 0.1 * point()).collect::<Vec<_>>();
        let hall = Aabb { min: Vec3A::ZERO, max: Vec3A::ONE }.corners();
        let boxes = corner.iter().chain(&hall).map(|&p| Aabb { min: p, max: p + 0.001 });
        let config = BuildConfig::default();
        let mut build = Build { config: &config, grain: 4, stages: &mut BuildStages::default() };
        let grid = TwoLevelGrid::build(&OnlyBoxes(boxes.collect()), &mut build).accel;
        let parts = |cell: &Coarse| cell.parts.map(usize::from).iter().product::<usize>();
        assert!(parts(&grid.coarse[0]) > 1_000, "{:?}", grid.coarse[0]);
        let empty = grid.coarse.iter().filter(|cell| parts(cell) == 0).count();
        assert!(empty + 30 > grid.coarse.len() && grid.coarse.len() > 60, "{empty}");
        let shape = grid.shape();
        let references: u64 = (0..).zip(&shape.leaf_sizes).map(|(size, n)| size * n).sum();
        assert!((1_008..16 * 1_008).contains(&references), "{references}");
    }
}
