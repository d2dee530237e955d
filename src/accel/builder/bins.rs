//! Primitives sorted into bins by their centres along each axis.

use glam::Vec4;

use crate::math::{Lanes as _, Mask as _};
use crate::simd::{Row as _, Simd};

use super::reference::{Centers, Reference};
use super::sweep::{Best, LONGEST, Line, NOTHING, Sweep, with_one};

/// The most bins along an axis.
pub(super) const BINS: usize = LONGEST;

/// So many primitives are sorted into all bins, fewer into half of them.
const MANY: usize = 192;

/// Added to 2²³, a small number is rounded to whole ones and stands in the lowest bits.
const ROUND: f32 = 8_388_608.0;

/// The axis along which a box is the widest.
#[inline(always)]
pub(super) fn widest_axis(&[low, high]: &Centers) -> usize {
    let [x, y, z, _] = (high - low).to_array();
    if x >= y && x >= z {
        0
    } else if y >= z {
        1
    } else {
        2
    }
}

/// Where along the axes the bins of a node lie.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    origin: Vec4,
    /// Bins per length; 0 along an axis on which all centres are one.
    scale: Vec4,
    bins: usize,
    centers: Centers,
    /// The only axis with bins, if it is one.
    only: Option<usize>,
}

impl Grid {
    /// Over the box around so many centres, along all axes or the widest alone.
    #[inline(always)]
    pub(super) fn new(centers: Centers, count: usize, widest: bool) -> Self {
        let bins = if count < MANY { BINS / 2 } else { BINS };
        let size = centers[1] - centers[0];
        let scale = Vec4::splat((bins - 1) as f32) / size;
        // Sizes too small to divide by pass for none.
        let scale = Vec4::select(scale.cmplt(Vec4::splat(f32::INFINITY)), scale, Vec4::ZERO);
        let only = widest.then(|| widest_axis(&centers));
        Self { origin: centers[0], scale, bins, centers, only }
    }

    /// The bin of a centre along each axis: the nearest whole number.
    #[inline(always)]
    fn places(&self, center: Vec4) -> [usize; 3] {
        let [x, y, z, _] = ((center - self.origin) * self.scale + Vec4::splat(ROUND)).to_array();
        [x.to_bits() as usize % BINS, y.to_bits() as usize % BINS, z.to_bits() as usize % BINS]
    }

    /// The bin of a primitive along an axis, by the same rounding.
    #[inline(always)]
    fn place(&self, reference: &Reference, axis: usize) -> usize {
        let (center, axis) = (reference.center_along(axis), axis % 3);
        ((center - self.origin[axis]) * self.scale[axis] + ROUND).to_bits() as usize % BINS
    }

    /// The box around twice the centres of the primitives in the bins on either side of a place: as
    /// far as the grid and the boxes around the primitives tell.
    #[inline(always)]
    pub(super) fn halves(&self, best: &Best) -> [Centers; 2] {
        let axis = best.axis % 3;
        let (origin, behind) = (self.origin[axis], (best.last as f32 + 0.5) / self.scale[axis]);
        let (plane, rounding) = (origin + behind, 2.0 * f32::EPSILON * (origin.abs() + behind));
        let [mut left, mut right] = best.halves.map(|half| half.centers(&self.centers));
        left[1][axis] = left[1][axis].min(plane + rounding);
        right[0][axis] = right[0][axis].max(plane - rounding);
        [left, right]
    }

    /// What tells on which side of the place behind bin `last` along an axis a centre lies.
    #[inline(always)]
    pub(super) fn side(&self, axis: usize, last: usize) -> Side {
        let limit = ROUND + last as f32;
        Side { axis, origin: self.origin[axis % 3], scale: self.scale[axis % 3], limit }
    }
}

/// A place between two bins.
#[derive(Clone, Copy)]
pub(super) struct Side {
    axis: usize,
    origin: f32,
    scale: f32,
    /// The last bin before it.
    limit: f32,
}

impl Side {
    /// Where a primitive lies along the axis, by the same rounding as [`Grid::places`].
    #[inline(always)]
    pub(super) fn place(&self, reference: &Reference) -> f32 {
        (reference.center_along(self.axis) - self.origin) * self.scale + ROUND
    }

    /// Whether what lies there comes before it.
    #[inline(always)]
    pub(super) fn is_before(&self, place: f32) -> bool {
        place <= self.limit
    }

    /// The same for all of eight lanes.
    #[inline(always)]
    pub(super) fn lanes_before<S: Simd>(&self, place: f32) -> u32 {
        S::F8::splat(place).le(S::F8::splat(self.limit)).bits()
    }
}

/// The bins along the three axes.
#[derive(Clone)]
pub(super) struct Bins([Line; 3]);

impl Bins {
    pub(super) const EMPTY: Self = Self([[NOTHING; BINS]; 3]);

    /// Empties the bins of a grid and sorts primitives into them.
    #[inline(always)]
    pub(super) fn fill<S: Simd>(&mut self, references: &[Reference], grid: &Grid) {
        self.clear(grid);
        // Neighbours are often in one bin, and wait for each other there: four that are far apart take turns.
        let quarter = references.len() / 4;
        let (a, rest) = references.split_at(quarter);
        let (b, rest) = rest.split_at(quarter);
        let (c, rest) = rest.split_at(quarter);
        let (d, rest) = rest.split_at(quarter);
        for i in 0..quarter {
            self.add::<S>(&a[i], grid);
            self.add::<S>(&b[i], grid);
            self.add::<S>(&c[i], grid);
            self.add::<S>(&d[i], grid);
        }
        for reference in rest {
            self.add::<S>(reference, grid);
        }
    }

    /// The same with one primitive of every so many, at least two.
    #[inline(always)]
    pub(super) fn fill_sample<S: Simd>(
        &mut self,
        references: &[Reference],
        stride: usize,
        grid: &Grid,
    ) {
        self.clear(grid);
        for first in (0..references.len() - stride).step_by(stride) {
            // Steps of one length could follow the rows of a mesh. A product with Knuth's multiplier
            // has all bits in disorder; the upper ones, times the stride, tell which it is.
            let disorder = u64::from((first as u32).wrapping_mul(2_654_435_769));
            self.add::<S>(&references[first + ((disorder * stride as u64) >> 32) as usize], grid);
        }
    }

    #[inline(always)]
    fn clear(&mut self, grid: &Grid) {
        for (axis, line) in self.0.iter_mut().enumerate() {
            if grid.only.is_none_or(|only| only == axis) {
                line[..BINS / 2].fill(NOTHING);
                if grid.bins > BINS / 2 {
                    line[BINS / 2..].fill(NOTHING);
                }
            }
        }
    }

    #[inline(always)]
    fn add<S: Simd>(&mut self, reference: &Reference, grid: &Grid) {
        let bounds = S::F8::load(&reference.0.0);
        if let Some(axis) = grid.only {
            add_to::<S>(&mut self.0[axis % 3], grid.place(reference, axis), bounds);
            return;
        }
        let [low, high] = S::halves(bounds);
        let [x, y, z] = grid.places(high - low);
        let [of_x, of_y, of_z] = &mut self.0;
        add_to::<S>(of_x, x, bounds);
        add_to::<S>(of_y, y, bounds);
        add_to::<S>(of_z, z, bounds);
    }

    /// The cheapest place with primitives on both sides; none if all centres are in one bin.
    #[inline(always)]
    pub(super) fn best<S: Simd>(&self, grid: &Grid, pack_bits: u32, sweep: &mut Sweep) -> Best {
        let mut best = Best::NONE;
        for axis in 0..3 {
            if grid.only.is_some_and(|only| only != axis) {
                continue;
            }
            let line = &self.0[axis];
            if grid.bins > BINS / 2 {
                sweep.weigh::<S, BINS>(line, axis, pack_bits, &mut best);
            } else {
                sweep.weigh::<S, { BINS / 2 }>(line, axis, pack_bits, &mut best);
            }
        }
        best
    }
}

#[inline(always)]
fn add_to<S: Simd>(line: &mut Line, place: usize, bounds: S::F8) {
    let all = S::F8::load(&line[place].0);
    with_one::<S>(all, bounds).store(&mut line[place].0);
}
