//! Many objects by rule: a kind, a number and a seed → shapes, each with its place and its tint.
//!
//! What a generated mesh is to triangles, this is to objects: balls, shapes of all kinds, instances of one mesh, and
//! towns of boxes, from a handful to millions. An object is a function of (kind, number of objects, seed, its index)
//! and of nothing else, and the same to the bit on every platform.

mod city;
mod cloud;
mod recipe;

use std::fmt;

use glam::{DAffine3, DVec3, Vec3};

use crate::math::Color;
use crate::shapes::{Ball, Cylinder, Single, Triangle};

pub use recipe::{ScatterError, ScatterRecipe};

/// The kinds of objects that are scattered. All lie within [−1, 1]³.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ScatterKind {
    /// Balls in the unit ball: most of them small, a few large, some within others.
    Balls,
    /// Balls, ellipsoids, cylinders and triangles in the cube, a quarter of each.
    Mixed,
    /// Instances of one mesh in the cube, each turned in its own way.
    Knots,
    /// A town of boxes, instances of one mesh, z up: quarters of blocks, blocks of towers, towers of up to four boxes.
    City,
}

/// How normals of scattered meshes are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScatteredNormals {
    /// One a face.
    Flat,
    /// Interpolated.
    Interpolated,
}

impl ScatterKind {
    /// All kinds, in the order in which they are listed.
    pub const ALL: [Self; 4] = [Self::Balls, Self::Mixed, Self::Knots, Self::City];

    /// Its name in scenes and on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Balls => "balls",
            Self::Mixed => "mixed",
            Self::Knots => "knots",
            Self::City => "city",
        }
    }

    /// Its description, in a line.
    #[must_use]
    pub fn description(self) -> &'static str {
        match self {
            Self::Balls => "balls: most of them small, a few large, some within others",
            Self::Mixed => "balls, ellipsoids, cylinders and triangles, turned every way",
            Self::Knots => "instances of one knot of 600 triangles, turned every way",
            Self::City => {
                "a town of boxes: instances within instances, in clusters of three scales"
            }
        }
    }

    /// The kind of this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// The mesh that its objects are instances of, by name, and how its normals are taken; `None` where its objects are
    /// shapes.
    #[must_use]
    pub fn mesh(self) -> Option<(&'static str, ScatteredNormals)> {
        match self {
            Self::Balls | Self::Mixed => None,
            Self::Knots => Some(("generate:torus-knot:600", ScatteredNormals::Interpolated)),
            Self::City => Some(("generate:box:12", ScatteredNormals::Flat)),
        }
    }
}

impl fmt::Display for ScatterKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// One of many objects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scattered {
    form: Form,
    /// What the reflectance of its material is multiplied by; from 0 to 1.
    pub tint: Color,
}

/// What it is, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    Ball {
        center: DVec3,
        radius: f64,
    },
    /// The unit ball, transformed.
    Ellipsoid(DAffine3),
    /// The canonical cylinder, transformed.
    Cylinder(DAffine3),
    Triangle([DVec3; 3]),
    /// The mesh of its kind, transformed.
    Instance(DAffine3),
}

/// An object in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// Its shape in its own space; `None` for the mesh of its kind.
    pub shape: Option<Single>,
    /// From its own space to the world's.
    pub transform: DAffine3,
}

impl Scattered {
    /// The object under a transform that acts on all of them.
    #[must_use]
    pub fn under(&self, outer: &DAffine3) -> Placed {
        let placed = |shape, transform| Placed { shape, transform };
        match self.form {
            Form::Ball { center, radius } => {
                let (ball, transform) = Ball::transformed(center, radius, outer);
                placed(Some(Single::Ball(ball)), transform)
            }
            Form::Ellipsoid(own) => {
                let (ball, transform) = Ball::transformed(DVec3::ZERO, 1.0, &(*outer * own));
                placed(Some(Single::Ball(ball)), transform)
            }
            Form::Cylinder(own) => placed(Some(Single::Cylinder(Cylinder)), *outer * own),
            Form::Triangle(corners) => {
                let corners: [Vec3; 3] = corners.map(|c| outer.transform_point3(c).as_vec3());
                placed(Some(Single::Triangle(Triangle::new(corners))), DAffine3::IDENTITY)
            }
            Form::Instance(own) => placed(None, *outer * own),
        }
    }
}

/// The most objects that are scattered.
pub const MOST_SCATTERED: u32 = 1 << 24;

/// The objects of a recipe, one after the other.
///
/// ```
/// use srt::scatter::{ScatterKind, ScatterRecipe, scatter};
///
/// let recipe = ScatterRecipe { kind: ScatterKind::Balls, count: 1000, seed: 1 };
/// assert_eq!(scatter(recipe).count(), 1000);
/// ```
pub fn scatter(recipe: ScatterRecipe) -> impl ExactSizeIterator<Item = Scattered> {
    let ScatterRecipe { kind, count, seed } = recipe;
    let town = city::Town::of(count);
    (0..count).map(move |index| match kind {
        ScatterKind::Balls => cloud::ball(count, seed, index),
        ScatterKind::Mixed => cloud::mixed(count, seed, index),
        ScatterKind::Knots => cloud::instance(count, seed, index),
        ScatterKind::City => town.part(seed, index),
    })
}

#[cfg(test)]
mod tests;
