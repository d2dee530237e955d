//! Objects that fill a space evenly, each independent of all others.

use std::f64::consts::TAU;

use glam::{DAffine3, DMat3, DQuat, DVec3};

use super::{Form, Scattered};
use crate::math::{Color, Random};

/// Separate the random streams of the kinds from other uses of the same numbers.
const BALLS: u64 = 0x0062_616C_6C73;
const MIXED: u64 = 0x006D_6978_6564;
const KNOTS: u64 = 0x006B_6E6F_7473;

/// The radius of the smallest balls, as a share of what each would have if all filled the space alike, and how many
/// times as large the largest are.
const SMALLEST: f64 = 0.3;
const LARGEST: f64 = 6.0;

/// The colours in turn: warm ones, a few cold ones, and chalk.
const TINTS: [Color; 6] = [
    Color::new(0.90, 0.30, 0.16),
    Color::new(0.96, 0.62, 0.18),
    Color::new(0.92, 0.86, 0.74),
    Color::new(0.18, 0.52, 0.56),
    Color::new(0.20, 0.30, 0.58),
    Color::new(0.62, 0.20, 0.34),
];

/// A ball within the unit ball. Radii follow a power law, as those of bubbles in a foam do.
pub(super) fn ball(count: u32, seed: u64, index: u32) -> Scattered {
    let mut random = Random::new(&[BALLS, seed, u64::from(index)]);
    // P(radius > x) falls as x⁻³, so that each size fills about as much of the space.
    let u = 1.0 - f64::from(random.next_f32());
    let radius = (SMALLEST * share(count) * libm::cbrt(u).recip().min(LARGEST)).min(0.5);
    let center = (1.0 - radius) * in_ball(&mut random);
    Scattered { form: Form::Ball { center, radius }, tint: tint(&mut random) }
}

/// A ball, an ellipsoid, a cylinder or a triangle within the cube.
pub(super) fn mixed(count: u32, seed: u64, index: u32) -> Scattered {
    let mut random = Random::new(&[MIXED, seed, u64::from(index)]);
    let reach = (0.9 * share(count)).min(0.5);
    let size = reach * between(&mut random, 0.4, 1.0);
    let center = (1.0 - reach) * in_cube(&mut random);
    let turned = DMat3::from_quat(rotation(&mut random));
    let scaled = |scale: DVec3| DAffine3 {
        matrix3: turned * DMat3::from_diagonal(size * scale),
        translation: center,
    };
    let form = match index % 4 {
        0 => Form::Ball { center, radius: 0.6 * size },
        1 => {
            let thin = between(&mut random, 0.2, 0.5);
            Form::Ellipsoid(scaled(DVec3::new(0.9, between(&mut random, 0.3, 0.7), thin)))
        }
        2 => {
            // Twice as long as its half is far from the centre.
            let thin = between(&mut random, 0.1, 0.3);
            let middle = DAffine3::from_translation(DVec3::new(0.0, 0.0, -0.5));
            Form::Cylinder(scaled(DVec3::new(thin, thin, 1.6)) * middle)
        }
        _ => {
            let corner = |turn: f64| {
                let (sin, cos) = libm::sincos(TAU * turn);
                center + turned * (size * DVec3::new(cos, sin, 0.0))
            };
            let bend = between(&mut random, 0.2, 0.45);
            Form::Triangle([0.0, bend, 0.65].map(corner))
        }
    };
    Scattered { form, tint: tint(&mut random) }
}

/// An instance within the cube.
pub(super) fn instance(count: u32, seed: u64, index: u32) -> Scattered {
    let mut random = Random::new(&[KNOTS, seed, u64::from(index)]);
    let reach = (0.8 * share(count)).min(0.5);
    let scale = DMat3::from_diagonal(DVec3::splat(reach * between(&mut random, 0.5, 0.95)));
    let turned = DMat3::from_quat(rotation(&mut random));
    let translation = (1.0 - reach) * in_cube(&mut random);
    let form = Form::Instance(DAffine3 { matrix3: turned * scale, translation });
    Scattered { form, tint: tint(&mut random) }
}

/// Half the side of the cube that each of so many has to itself.
fn share(count: u32) -> f64 {
    libm::cbrt(f64::from(count)).recip()
}

fn tint(random: &mut Random) -> Color {
    TINTS[random.below(TINTS.len() as u32) as usize]
}

fn between(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * f64::from(random.next_f32())
}

/// A point of [−1, 1)³.
fn in_cube(random: &mut Random) -> DVec3 {
    let mut coordinate = || between(random, -1.0, 1.0);
    DVec3::new(coordinate(), coordinate(), coordinate())
}

/// A point of the unit ball.
fn in_ball(random: &mut Random) -> DVec3 {
    loop {
        let point = in_cube(random);
        if point.length_squared() <= 1.0 {
            return point;
        }
    }
}

/// A rotation, uniform among all (K. Shoemake, *Uniform random rotations*, Graphics Gems III, 1992).
fn rotation(random: &mut Random) -> DQuat {
    let u = f64::from(random.next_f32());
    let (low, high) = ((1.0 - u).sqrt(), u.sqrt());
    let (s1, c1) = libm::sincos(TAU * f64::from(random.next_f32()));
    let (s2, c2) = libm::sincos(TAU * f64::from(random.next_f32()));
    DQuat::from_xyzw(low * s1, low * c1, high * s2, high * c2).normalize()
}
