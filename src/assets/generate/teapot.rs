//! A teapot of surfaces by rule: body, lid, spout and handle.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use super::grid::CellGrid;

/// Half its breadth, from the middle to the tip of the spout.
pub(super) const REACH: f64 = 1.6;

/// A part of it: its share of the triangles, and its surface over two parameters, around and along.
pub(super) struct TeapotPart {
    /// Its share among all parts.
    pub(super) weight: u32,
    aspect: f64,
    /// The surface; the body's radius is 1, and it stands on z = 0.
    pub(super) surface: fn(f64, f64) -> DVec3,
}

/// All parts; their weights add up to [`WEIGHT`].
pub(super) const PARTS: [TeapotPart; 3] = [
    TeapotPart { weight: 6, aspect: 1.2, surface: body },
    TeapotPart { weight: 2, aspect: 0.8, surface: spout },
    TeapotPart { weight: 2, aspect: 0.5, surface: handle },
];

/// The weights of all parts.
pub(super) const WEIGHT: u32 = 10;

impl TeapotPart {
    /// Its cells, of about so many triangles.
    pub(super) fn grid(&self, triangles: u32) -> CellGrid {
        let grid = CellGrid::tube(triangles, self.aspect);
        // With fewer rows the handle would lie in a plane.
        CellGrid { rows: grid.rows.max(4), ..grid }
    }
}

/// Foot, belly, shoulder, lid and knob in one profile: radii at heights.
const PROFILE: [(f64, f64); 13] = [
    (0.02, 0.0),
    (0.70, 0.0),
    (0.74, 0.06),
    (0.96, 0.36),
    (1.0, 0.60),
    (0.90, 0.95),
    (0.66, 1.20),
    (0.60, 1.24),
    (0.56, 1.26),
    (0.32, 1.38),
    (0.09, 1.44),
    (0.15, 1.56),
    (0.015, 1.64),
];

/// The body and its lid, about the z axis.
fn body(u: f64, v: f64) -> DVec3 {
    let (radius, z) = profile(v);
    let (sin, cos) = libm::sincos(TAU * u);
    DVec3::new(radius * cos, radius * sin, z)
}

/// The profile at `v` of the way, smooth through all of its points (E. Catmull and R. Rom, *A class of local
/// interpolating splines*, 1974).
fn profile(v: f64) -> (f64, f64) {
    let last = PROFILE.len() - 1;
    let place = v * last as f64;
    let i = (place as usize).min(last - 1);
    let t = place - i as f64;
    let at = |k: usize| PROFILE[k.clamp(1, last + 1) - 1];
    let [a, b, c, d] = [at(i), at(i + 1), at(i + 2), at(i + 3)];
    let spline = |a: f64, b: f64, c: f64, d: f64| {
        0.5 * (2.0 * b
            + (c - a) * t
            + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t
            + (3.0 * b - a - 3.0 * c + d) * t * t * t)
    };
    (spline(a.0, b.0, c.0, d.0).max(0.01), spline(a.1, b.1, c.1, d.1).max(0.0))
}

/// A tube that narrows as it rises, along +x.
fn spout(u: f64, v: f64) -> DVec3 {
    let bend = v * v * (3.0 - 2.0 * v);
    let middle = DVec3::new(0.80 + 0.80 * v, 0.0, 0.42 + 0.86 * bend);
    let slope = DVec3::new(0.80, 0.0, 0.86 * 6.0 * v * (1.0 - v) + 0.25).normalize();
    tube(u, middle, slope, 0.27 - 0.17 * v)
}

/// A bow along −x.
fn handle(u: f64, v: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(PI * (v - 0.5));
    let middle = DVec3::new(-0.85 - 0.62 * cos, 0.0, 0.72 + 0.36 * sin);
    tube(u, middle, DVec3::new(0.62 * sin, 0.0, 0.36 * cos).normalize(), 0.085)
}

/// A circle about a point of the plane y = 0, across a direction in it.
fn tube(u: f64, middle: DVec3, along: DVec3, radius: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(TAU * u);
    middle + radius * (cos * DVec3::Y + sin * along.cross(DVec3::Y))
}
