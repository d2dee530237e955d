//! Rays as the formula of triangles sees them: space is sheared so that they run along one axis.

use crate::accel::{PACK, PackHits};
use crate::math::{LaneFormula, Lanes, Lanes3, Mask as _, Ray, sub};
use crate::simd::{Row as _, Simd, splat3};

use super::triangle::scaled_hit;

/// A factor that makes a reciprocal of every number but zero finite.
const LARGE: f32 = (1u64 << 40) as f32;

/// An axis of space: its place among three.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Axis {
    X,
    Y,
    Z,
}

/// The order in which the formula takes the axes of a ray: the last is the one along which it moves
/// most, its *dominant* axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Axes([Axis; 3]);

/// A place for each dominant axis, and one more, so that every number cut to its bits is a place.
static DOMINANT: [Axes; 4] = [
    Axes([Axis::Y, Axis::Z, Axis::X]),
    Axes([Axis::Z, Axis::X, Axis::Y]),
    Axes::OF_SPACE,
    Axes::OF_SPACE,
];

impl Axes {
    /// The order of the axes of space.
    const OF_SPACE: Self = Self([Axis::X, Axis::Y, Axis::Z]);

    /// The place in [`DOMINANT`] of the axis along which a ray in this direction moves most.
    #[inline(always)]
    fn dominant(dir: &[f32; 3]) -> u32 {
        // Bits of absolute values are in their order. By arithmetic: which axis it is cannot be foreseen.
        let (x, y, z) = (size_bits(dir[0]), size_bits(dir[1]), size_bits(dir[2]));
        let not_x = u32::from(x < y) | u32::from(x < z);
        let is_z = not_x & u32::from(y < z);
        not_x + is_z
    }

    /// The order for rays that move most along the axis of this place.
    #[inline(always)]
    fn of_dominant(place: u32) -> Self {
        const { assert!(DOMINANT.len() == 4) }
        DOMINANT[place as usize & 3]
    }

    /// Three values, one an axis of space, in this order.
    #[inline(always)]
    pub(super) fn arrange<T: Copy>(self, of_axes: &[T; 3]) -> [T; 3] {
        let [x, y, z] = self.0;
        [of_axes[x as usize], of_axes[y as usize], of_axes[z as usize]]
    }

    /// A point, by its coordinates, in this order and in every lane.
    #[inline(always)]
    fn splat<L: Lanes>(self, coordinate: impl Fn(Axis) -> f32) -> Lanes3<L> {
        let [x, y, z] = self.0;
        [L::splat(coordinate(x)), L::splat(coordinate(y)), L::splat(coordinate(z))]
    }

    /// The order in a word: two bits for each axis, a byte apart, the first the lowest.
    #[inline(always)]
    const fn word(self) -> u32 {
        let [x, y, z] = self.0;
        x as u32 | (y as u32) << 8 | (z as u32) << 16
    }

    /// The order that a word holds.
    #[inline(always)]
    fn of_word(word: u32) -> Self {
        // The last axis is the dominant one.
        Self::of_dominant(word >> 16)
    }
}

#[inline(always)]
fn size_bits(x: f32) -> u32 {
    x.abs().to_bits()
}

/// The lanes whose direction is dominated by the first axis, and of the others those dominated by the second.
#[inline(always)]
fn lanes_by_first_axes<L: Lanes>(dir: &Lanes3<L>) -> [L::Mask; 2] {
    let (x, y, z) = (dir[0].abs(), dir[1].abs(), dir[2].abs());
    [y.le(x) & z.le(x), z.le(y)]
}

/// For each axis the lanes whose direction is dominated by it, as bits; those above the last lane are
/// of no meaning.
#[inline(always)]
fn lanes_by_dominant_axis<L: Lanes>(dir: Lanes3<L>) -> [u32; 3] {
    let [of_x, of_y] = lanes_by_first_axes(&dir);
    let (of_x, of_y) = (of_x.bits(), !of_x.bits() & of_y.bits());
    [of_x, of_y, !(of_x | of_y)]
}

/// Three rows, one an axis of space, in the order of each lane, by [`lanes_by_first_axes`]. Without a branch: of eight
/// rays each axis is mostly that of some, so there is nothing to foresee.
#[inline(always)]
fn arranged<L: Lanes>(&[x, y, z]: &Lanes3<L>, [of_x, of_y]: [L::Mask; 2]) -> Lanes3<L> {
    [
        y.select_where(of_x, z.select_where(of_y, x)),
        z.select_where(of_x, x.select_where(of_y, y)),
        x.select_where(of_x, y.select_where(of_y, z)),
    ]
}

/// A ray, or one in each lane, its axes in the order of [`Axes`].
#[derive(Clone, Copy, Debug)]
pub(super) struct ShearedRay<L> {
    origin: Lanes3<L>,
    /// How far it moves along the first two axes for a unit of the last.
    slopes: [L; 2],
    /// Two factors of 1/direction along the last axis.
    along: [L; 2],
}

impl<L: Lanes> ShearedRay<L> {
    /// The ray from an origin in a direction, both in the order of their axes. `inv_dir` is 1/direction
    /// along the last axis, and of no meaning where that is too small to have a finite one.
    #[inline(always)]
    fn new(origin: Lanes3<L>, dir: Lanes3<L>, inv_dir: L) -> Self {
        let one = L::splat(1.0);
        let mut along = [inv_dir, one];
        // A NaN, too: `inv_dir` may have been cut to a number.
        let all = u32::MAX >> (32 - L::Mask::LANES);
        let tiny = L::splat(f32::MIN_POSITIVE).le(dir[2].abs()).bits() ^ all;
        if tiny != 0 {
            // A power of two changes nothing but the range.
            let factor = L::splat(LARGE);
            along =
                [(one / (dir[2] * factor)).select(tiny, along[0]), factor.select(tiny, along[1])];
        }
        let slopes = [dir[0] * along[0] * along[1], dir[1] * along[0] * along[1]];
        Self { origin, slopes, along }
    }

    /// Where a corner of a triangle, in the order of the axes, lies as seen from the ray's origin when
    /// space is sheared so that the ray runs along the last axis. It depends on the corner and the ray
    /// alone: triangles that share a corner see it in the same place, to the bit.
    #[inline(always)]
    pub(super) fn see(&self, corner: Lanes3<L>) -> Lanes3<L> {
        let [x, y, z] = sub(corner, self.origin);
        [x - self.slopes[0] * z, y - self.slopes[1] * z, z]
    }

    /// The parameter at which the ray is at a distance along the last axis.
    #[inline(always)]
    pub(super) fn parameter(&self, distance: L) -> L {
        distance * self.along[0] * self.along[1]
    }
}

/// A ray that meets triangles: sheared, with its dominant axis.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub struct TriangleRay {
    /// Origin, slopes, the factors of 1/direction; then the order of axes in a word, as bits.
    values: [f32; 8],
}

impl TriangleRay {
    /// A ray; `inv_dir` is 1/direction, along each axis.
    #[inline(always)]
    pub(super) fn new(ray: &Ray, inv_dir: &[f32; 3]) -> Self {
        let (origin, dir): (&[f32; 3], &[f32; 3]) = (ray.origin.as_ref(), ray.dir.as_ref());
        let dominant = Axes::dominant(dir);
        let axes = Axes::of_dominant(dominant);
        let [.., along] = axes.arrange(inv_dir);
        let sheared = ShearedRay::new(axes.arrange(origin), axes.arrange(dir), along);
        let ShearedRay { origin: [x, y, z], slopes: [p, q], along: [a, b] } = sheared;
        Self { values: [x, y, z, p, q, a, b, f32::from_bits(axes.word())] }
    }

    /// Eight rays, a ray in each lane, each with its own dominant axis.
    #[inline(always)]
    pub(super) fn eight<S: Simd>(
        origin: &Lanes3<S::F8>,
        dir: &Lanes3<S::F8>,
        inv_dir: &Lanes3<S::F8>,
        rays: &mut [Self; PACK],
    ) {
        let by_axis @ [of_x, of_y] = lanes_by_first_axes(dir);
        let [_, _, along] = arranged(inv_dir, by_axis);
        let (origin, dir) = (arranged(origin, by_axis), arranged(dir, by_axis));
        let sheared = ShearedRay::new(origin, dir, along);
        let ShearedRay { origin: [x, y, z], slopes: [p, q], along: [a, b] } = sheared;
        let word = |dominant: usize| f32::from_bits(DOMINANT[dominant].word());
        let [by_x, by_y, by_z] = [word(0), word(1), word(2)];
        let axes = S::F8::splat(by_x)
            .select_where(of_x, S::F8::splat(by_y).select_where(of_y, S::F8::splat(by_z)));
        let records = S::transpose_eight([x, y, z, p, q, a, b, axes]);
        for i in 0..PACK {
            records[i].store(&mut rays[i].values);
        }
    }

    /// The order of its axes.
    #[inline(always)]
    pub(super) fn axes(&self) -> Axes {
        Axes::of_word(self.values[7].to_bits())
    }

    /// The numbers of its axes in their order, each of two bits.
    #[inline(always)]
    pub(super) fn rows(&self) -> [usize; 3] {
        let word = self.values[7].to_bits() as usize;
        [word & 3, word >> 8 & 3, word >> 16 & 3]
    }

    /// As a ray in each lane of a vector.
    #[inline(always)]
    pub(super) fn splat<L: Lanes>(&self) -> ShearedRay<L> {
        let [x, y, z, p, q, a, b, _] = self.values;
        ShearedRay {
            origin: [L::splat(x), L::splat(y), L::splat(z)],
            slopes: [L::splat(p), L::splat(q)],
            along: [L::splat(a), L::splat(b)],
        }
    }
}

impl From<&Ray> for TriangleRay {
    fn from(ray: &Ray) -> Self {
        Self::new(ray, &ray.dir.to_array().map(|dir| 1.0 / dir))
    }
}

impl Default for TriangleRay {
    /// A place without a ray.
    fn default() -> Self {
        Self { values: [0.0; 8] }
    }
}

/// A ray in each lane, each with its own dominant axis.
#[derive(Clone, Copy, Debug)]
pub struct TriangleRays<L> {
    axes: MixedAxes,
    sheared: ShearedRay<L>,
}

/// The axes of several rays: those of one of them, and of the others the lanes in which theirs differ.
/// Coherent rays mostly have the same.
#[derive(Clone, Copy, Debug)]
struct MixedAxes {
    usual: Axes,
    others: [(Axes, u32); 2],
    differ: bool,
}

impl MixedAxes {
    #[inline(always)]
    fn of<L: Lanes>(dir: &Lanes3<L>) -> Self {
        let all = u32::MAX >> (32 - L::Mask::LANES);
        let of_axes = lanes_by_dominant_axis(*dir);
        let lanes = [of_axes[0] & all, of_axes[1] & all, of_axes[2] & all];
        let usual = if lanes[0] & 1 != 0 { 0 } else { 1 + usize::from(lanes[1] & 1 == 0) };
        let other = |by: usize| (DOMINANT[(usual + by) % 3], lanes[(usual + by) % 3]);
        let differ = lanes[usual % 3] != all;
        Self { usual: DOMINANT[usual % 3], others: [other(1), other(2)], differ }
    }

    /// Three rows, one an axis of space, in the order of each lane.
    #[inline(always)]
    fn arrange<L: Lanes>(&self, rows: &Lanes3<L>) -> Lanes3<L> {
        let mut arranged = self.usual.arrange(rows);
        for (axes, lanes) in self.others {
            if lanes != 0 {
                let [x, y, z] = axes.arrange(rows);
                arranged = [
                    x.select(lanes, arranged[0]),
                    y.select(lanes, arranged[1]),
                    z.select(lanes, arranged[2]),
                ];
            }
        }
        arranged
    }

    /// A point, by its coordinates, in the order of each lane.
    #[inline(always)]
    fn splat<L: Lanes>(&self, coordinate: impl Fn(Axis) -> f32) -> Lanes3<L> {
        let mut arranged = self.usual.splat(&coordinate);
        for (axes, lanes) in self.others {
            let [x, y, z] = axes.splat::<L>(&coordinate);
            arranged = [
                x.select(lanes, arranged[0]),
                y.select(lanes, arranged[1]),
                z.select(lanes, arranged[2]),
            ];
        }
        arranged
    }
}

impl<L: Lanes> TriangleRays<L> {
    /// Rays by their origins and directions; `inv_dir` is 1/direction.
    #[inline(always)]
    pub(super) fn new(origin: &Lanes3<L>, dir: &Lanes3<L>, inv_dir: &Lanes3<L>) -> Self {
        let axes = MixedAxes::of(dir);
        let along = axes.arrange(inv_dir)[2];
        let sheared = ShearedRay::new(axes.arrange(origin), axes.arrange(dir), along);
        Self { axes, sheared }
    }

    /// The formula for a triangle, whose corners are given by their numbers and coordinates.
    #[inline(always)]
    pub(super) fn scaled_hit(&self, coordinate: impl Fn(usize, Axis) -> f32) -> PackHits<L> {
        if !L::FEW_REGISTERS || self.axes.differ {
            return scaled_hit(&self.sheared, self.arrange(coordinate));
        }
        let axes = self.axes.usual.0;
        let corner = |number: usize| {
            [coordinate(number, axes[0]), coordinate(number, axes[1]), coordinate(number, axes[2])]
        };
        let ShearedRay { origin: [x, y, z], slopes: [p, q], along: [a, b] } = self.sheared;
        let one_triangle = OneTriangle([corner(0), corner(1), corner(2)]);
        let ([t, u, v, scale], inside) = L::apply(&one_triangle, &[x, y, z, p, q, a, b]);
        PackHits { inside, t, u, v, scale }
    }

    /// The corners of a triangle, by their numbers and coordinates, in the order of each ray's axes.
    #[inline(always)]
    fn arrange(&self, coordinate: impl Fn(usize, Axis) -> f32) -> [Lanes3<L>; 3] {
        if self.axes.differ {
            let axes = &self.axes;
            [
                axes.splat(|axis| coordinate(0, axis)),
                axes.splat(|axis| coordinate(1, axis)),
                axes.splat(|axis| coordinate(2, axis)),
            ]
        } else {
            let axes = self.axes.usual;
            [
                axes.splat(|axis| coordinate(0, axis)),
                axes.splat(|axis| coordinate(1, axis)),
                axes.splat(|axis| coordinate(2, axis)),
            ]
        }
    }
}

/// The formula for one triangle, by its corners in the order of the rays' axes.
struct OneTriangle([[f32; 3]; 3]);

impl LaneFormula<7, 4> for OneTriangle {
    #[inline(always)]
    fn apply<L: Lanes>(&self, &[x, y, z, p, q, a, b]: &[L; 7]) -> ([L; 4], L::Mask) {
        let ray = ShearedRay { origin: [x, y, z], slopes: [p, q], along: [a, b] };
        let [first, second, third] = self.0;
        let hits = scaled_hit(&ray, [splat3(first), splat3(second), splat3(third)]);
        ([hits.t, hits.u, hits.v, hits.scale], hits.inside)
    }
}

#[cfg(test)]
mod tests;
