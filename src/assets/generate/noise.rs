//! Fractal noise over the plane and in space: the same on every platform.

use glam::DVec3;

use crate::math::hash_u64;

/// Octaves of noise; the last has features of 1/2⁹ of the first.
const OCTAVES: u64 = 10;

/// Octaves of noise in space.
const OCTAVES_IN_SPACE: u64 = 4;

/// The sum of octaves of value noise, each of half the amplitude and half the size of the one
/// before; within (−1, 1), with features of size 1 and less.
///
/// Each octave is turned by the angle of the 3-4-5 triangle against the one before, which hides the
/// axes of the lattice and needs neither sine nor cosine.
pub(super) fn fractal(seed: u64, x: f64, y: f64) -> f64 {
    let (mut x, mut y, mut amplitude, mut sum) = (x, y, 0.5, 0.0);
    for octave in 0..OCTAVES {
        sum += amplitude * value_noise(hash_u64(seed ^ hash_u64(octave)), x, y);
        (x, y) = (2.0 * (0.8 * x - 0.6 * y), 2.0 * (0.6 * x + 0.8 * y));
        amplitude *= 0.5;
    }
    sum
}

/// The same in space, of fewer octaves, each turned against the one before about a diagonal.
pub(super) fn fractal_in_space(seed: u64, mut point: DVec3) -> f64 {
    let (mut amplitude, mut sum) = (0.5, 0.0);
    for octave in 0..OCTAVES_IN_SPACE {
        sum += amplitude * value_noise_in_space(hash_u64(seed ^ hash_u64(octave)), point);
        let DVec3 { x, y, z } = point;
        // Twice a rotation whose entries are thirds of whole numbers.
        point = DVec3::new(2.0 * x - y + 2.0 * z, 2.0 * x + 2.0 * y - z, 2.0 * y + 2.0 * z - x);
        point *= 2.0 / 3.0;
        amplitude *= 0.5;
    }
    sum
}

/// Random values at the points of a lattice in space, within [−1, 1), and smooth between them.
fn value_noise_in_space(key: u64, point: DVec3) -> f64 {
    let level = point.z.floor();
    let slice = |level: f64| {
        let key = hash_u64(key.wrapping_add(hash_u64(level as i64 as u64)));
        value_noise(key, point.x, point.y)
    };
    mix(slice(level), slice(level + 1.0), fade(point.z - level))
}

/// Random values at the points of a lattice, within [−1, 1), and smooth between them.
fn value_noise(key: u64, x: f64, y: f64) -> f64 {
    let (column, row) = (x.floor(), y.floor());
    let (s, t) = (fade(x - column), fade(y - row));
    let corner = |dx: i64, dy: i64| lattice(key, column as i64 + dx, row as i64 + dy);
    let low = mix(corner(0, 0), corner(1, 0), s);
    let high = mix(corner(0, 1), corner(1, 1), s);
    mix(low, high, t)
}

fn lattice(key: u64, column: i64, row: i64) -> f64 {
    let bits = hash_u64(hash_u64(key ^ column as u64).wrapping_add(row as u64));
    (bits >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

/// From 0 to 1 with no slope and no curvature at either end (K. Perlin, *Improving noise*, 2002).
fn fade(t: f64) -> f64 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

fn mix(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_continuous_bounded_and_differs_by_seed() {
        let mut largest = 0.0f64;
        for i in 0..2000 {
            let x = f64::from(i) * 0.0123 - 10.0;
            let here = fractal(1, x, 0.7);
            assert!((fractal(1, x + 1e-9, 0.7) - here).abs() < 1e-6);
            largest = largest.max(here.abs());
        }
        assert!((0.2..1.0).contains(&largest));
        assert_ne!(fractal(1, 0.3, 0.4), fractal(2, 0.3, 0.4));
        let in_space = |x: f64| fractal_in_space(1, DVec3::new(0.4, x, 0.7 * x));
        for i in 0..2000 {
            let x = f64::from(i) * 0.0123 - 10.0;
            assert!((in_space(x + 1e-9) - in_space(x)).abs() < 1e-6);
            assert!(in_space(x).abs() < 1.0);
        }
    }
}
