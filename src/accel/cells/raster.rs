//! A box that is parted evenly along its axes: the cells of a grid.

use std::ops::Range;

use glam::Vec3A;

use crate::math::Aabb;

/// The most cells along an axis.
pub(in super::super) const MOST_CELLS: u32 = 1 << 15;

/// The planes between cells along an axis. They are computed where they are needed, always by the one
/// formula of [`plane`](Self::plane), which does not fall as the number grows.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Axis {
    low: f32,
    high: f32,
    /// The width of a cell, rounded.
    width: f32,
    /// How many cells there are, at least one.
    pub(in super::super) cells: u32,
}

impl Axis {
    fn new(low: f32, high: f32, cells: u32) -> Self {
        Self { low, high, width: (high - low) / cells as f32, cells }
    }

    /// The plane below a cell, or above the last.
    #[inline(always)]
    pub(in super::super) fn plane(&self, number: u32) -> f32 {
        if number == self.cells {
            self.high
        } else {
            (self.low + number as f32 * self.width).min(self.high)
        }
    }

    /// About the cell in which a coordinate lies; one of the cells in any case.
    #[inline(always)]
    pub(in super::super) fn near(&self, at: f32) -> u32 {
        // What is not a number, of boxes without a width, becomes 0.
        (((at - self.low) / self.width) as u32).min(self.cells - 1)
    }

    /// The closed cells that touch a closed interval, which lies between the first plane and the last.
    fn touched(&self, low: f32, high: f32) -> Range<u32> {
        let mut first = self.near(low);
        while first > 0 && self.plane(first) >= low {
            first -= 1;
        }
        while self.plane(first + 1) < low {
            first += 1;
        }
        let mut last = self.near(high).max(first);
        while last > first && self.plane(last) > high {
            last -= 1;
        }
        while last + 1 < self.cells && self.plane(last + 1) <= high {
            last += 1;
        }
        first..last + 1
    }
}

/// The cells of a box.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Raster(pub(in super::super) [Axis; 3]);

impl Raster {
    /// So many cells along each axis.
    pub(in super::super) fn new(bounds: &Aabb, cells: [u32; 3]) -> Self {
        Self(std::array::from_fn(|axis| Axis::new(bounds.min[axis], bounds.max[axis], cells[axis])))
    }

    /// About so many cells, which are about as wide as high and deep (Cleary, Wyvill: *Analysis of an
    /// algorithm for fast ray tracing using uniform space subdivision*, 1988): never more than twice as
    /// many, and at least one.
    pub(in super::super) fn of_about(bounds: &Aabb, cells: f64) -> Self {
        let size = bounds.size().to_array().map(f64::from);
        // Along an axis that is shorter than a cell there is one.
        let mut axes: Vec<usize> = (0..3).filter(|&axis| size[axis] > 0.0).collect();
        let mut counts = [1; 3];
        while let Some(shortest) =
            axes.iter().copied().reduce(|a, b| if size[b] < size[a] { b } else { a })
        {
            let volume: f64 = axes.iter().map(|&axis| size[axis]).product();
            let a_length = (cells / volume).powf(1.0 / axes.len() as f64);
            if size[shortest] * a_length >= 1.0 {
                for &axis in &axes {
                    counts[axis] = (size[axis] * a_length).min(f64::from(MOST_CELLS)) as u32;
                }
                break;
            }
            axes.retain(|&axis| axis != shortest);
        }
        Self::new(bounds, counts)
    }

    /// The same box with no more than so many cells along an axis.
    pub(in super::super) fn of_at_most(&self, most: u32) -> Self {
        let fewer = |Axis { low, high, cells, .. }: Axis| Axis::new(low, high, cells.min(most));
        Self(self.0.map(fewer))
    }

    /// The box that is parted.
    pub(in super::super) fn bounds(&self) -> Aabb {
        let [x, y, z] = self.0;
        Aabb { min: Vec3A::new(x.low, y.low, z.low), max: Vec3A::new(x.high, y.high, z.high) }
    }

    /// How many cells there are.
    pub(in super::super) fn count(&self) -> usize {
        self.0.iter().map(|axis| axis.cells as usize).product()
    }

    /// What the number of a cell grows by along each axis.
    #[inline(always)]
    pub(in super::super) fn strides(&self) -> [u32; 3] {
        [1, self.0[0].cells, self.0[0].cells * self.0[1].cells]
    }

    /// The closed cells that touch the part of a closed box that lies in this one, by their places
    /// along each axis.
    pub(in super::super) fn touched(&self, bounds: &Aabb) -> [Range<u32>; 3] {
        std::array::from_fn(|number| {
            let axis = &self.0[number];
            axis.touched(bounds.min[number].max(axis.low), bounds.max[number].min(axis.high))
        })
    }

    /// The numbers of cells at such places.
    pub(in super::super) fn numbers(
        &self,
        [x, y, z]: [Range<u32>; 3],
    ) -> impl Iterator<Item = usize> {
        let [_, by_y, by_z] = self.strides();
        z.flat_map(move |z| {
            let x = x.clone();
            y.clone().flat_map(move |y| {
                let row = z as usize * by_z as usize + y as usize * by_y as usize;
                x.clone().map(move |x| row + x as usize)
            })
        })
    }

    /// The box of a cell.
    pub(in super::super) fn cell(&self, number: usize) -> Aabb {
        let mut rest = number;
        let places = self.0.map(|axis| {
            let place = rest % axis.cells as usize;
            rest /= axis.cells as usize;
            place as u32
        });
        let corner = |more: u32| {
            Vec3A::from_array(std::array::from_fn(|axis| self.0[axis].plane(places[axis] + more)))
        };
        Aabb { min: corner(0), max: corner(1) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    #[test]
    fn planes_never_fall_and_end_in_the_sides_of_the_box() {
        for (low, high) in [(0.0, 1.0), (-3.0, 7.5), (1e6, 1e6 + 0.5), (2.0, 2.0), (-1e12, 1e12)] {
            for cells in [1, 2, 3, 7, 100, 1_000] {
                let axis = Axis::new(low, high, cells);
                let planes: Vec<f32> = (0..=cells).map(|number| axis.plane(number)).collect();
                assert!(planes.is_sorted(), "{axis:?}");
                assert_eq!((planes[0], planes[cells as usize]), (low, high));
            }
        }
    }

    #[test]
    fn the_cells_that_touch_an_interval_are_found_with_those_that_it_ends_at() {
        let mut random = Random::new(&[5]);
        for (low, high, cells) in
            [(0.0, 1.0, 8), (-3.0, 7.5, 13), (1e6, 1e6 + 0.5, 40), (2.0, 2.0, 3)]
        {
            let axis = Axis::new(low, high, cells);
            for number in 0..500u32 {
                let mut end = || match number % 3 {
                    0 => axis.plane(random.below(cells + 1)),
                    _ => low + random.next_f32() * (high - low),
                };
                let (a, b) = (end(), end());
                let (a, b) = (a.min(b), a.max(b));
                let touches = |&cell: &u32| axis.plane(cell) <= b && axis.plane(cell + 1) >= a;
                assert!((0..cells).filter(touches).eq(axis.touched(a, b)), "{axis:?} {a} {b}");
            }
        }
    }

    #[test]
    fn cells_are_about_cubes_and_as_many_as_wanted() {
        let counts = |size: [f32; 3], cells: f64| {
            let bounds = Aabb { min: Vec3A::ZERO, max: Vec3A::from_array(size) };
            Raster::of_about(&bounds, cells).0.map(|axis| axis.cells)
        };
        assert_eq!(counts([1.0; 3], 1000.5), [10, 10, 10]);
        assert_eq!(counts([4.0, 2.0, 1.0], 64.5), [8, 4, 2]);
        assert_eq!(counts([5.0, 5.0, 0.0], 25.5), [5, 5, 1]);
        assert_eq!(counts([8.0, 1e-3, 0.0], 16.5), [16, 1, 1]);
        assert_eq!(counts([0.0; 3], 16.0), [1; 3]);
        assert_eq!(counts([1.0; 3], 0.5), [1; 3]);
        assert_eq!(counts([1.0, 1e-30, 1e-30], 1e9)[0], MOST_CELLS);
    }

    #[test]
    fn boxes_and_numbers_of_cells_agree() {
        let bounds = Aabb { min: Vec3A::ZERO, max: Vec3A::new(3.0, 2.0, 4.0) };
        let raster = Raster::new(&bounds, [3, 2, 4]);
        let one = Aabb { min: Vec3A::new(1.25, 1.5, 2.5), max: Vec3A::new(1.75, 9.0, 3.0) };
        let touched: Vec<usize> = raster.numbers(raster.touched(&one)).collect();
        assert_eq!(touched, [1 + 3 + 6 * 2, 1 + 3 + 6 * 3]);
        assert_eq!(
            raster.cell(16),
            Aabb { min: Vec3A::new(1.0, 1.0, 2.0), max: Vec3A::new(2.0, 2.0, 3.0) }
        );
        assert!((0..raster.count()).eq(raster.numbers([0..3, 0..2, 0..4])));
    }
}
