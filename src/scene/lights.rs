//! Lights in the world, in single precision.

use glam::Vec3;

use crate::description;
use crate::math::Color;

/// A light in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// Light from one point.
    Point {
        /// Where it is.
        position: Vec3,
        /// What it emits.
        color: Color,
    },
    /// Light from a parallelogram. Every point of it emits the whole colour, so a mean over
    /// samples is the light of all of it.
    Area {
        /// A corner.
        corner: Vec3,
        /// From the corner along one side.
        side_u: Vec3,
        /// From the corner along the other side.
        side_v: Vec3,
        /// What it emits.
        color: Color,
    },
}

impl Light {
    /// The light of a description, rounded to single precision.
    #[must_use]
    pub fn new(light: &description::Light) -> Self {
        match *light {
            description::Light::Point { position, color } => {
                Self::Point { position: position.as_vec3(), color }
            }
            description::Light::Area { center, half_u, half_v, color } => Self::Area {
                corner: (center - half_u - half_v).as_vec3(),
                side_u: (2.0 * half_u).as_vec3(),
                side_v: (2.0 * half_v).as_vec3(),
                color,
            },
        }
    }

    /// What it emits.
    #[must_use]
    pub fn color(&self) -> Color {
        match *self {
            Self::Point { color, .. } | Self::Area { color, .. } => color,
        }
    }
}
