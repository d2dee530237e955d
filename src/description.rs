//! The scene as written: validated plain data, with the place in the file that each entity came from.
//!
//! Made by [`scene_file`](crate::scene_file) or by hand; turned into what is traced by
//! [`scene`](crate::scene). Lengths are in the scene's own unit, angles in degrees as written,
//! colours linear. Every number is finite as written, and within the bounds that its field states.

use std::fmt;
use std::ops::Range;

use glam::{DAffine3, DVec3};

use crate::math::Color;
use crate::shapes::Single;

/// The bytes of the scene's text that an entity was read from. Empty for entities made by hand.
pub type Span = Range<usize>;

/// The contents of a scene file.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneDescription {
    /// How the scene is seen.
    pub camera: Camera,
    /// How it is rendered, unless the command line overrides it.
    pub options: Options,
    /// The materials that objects refer to, each different from all before it.
    pub materials: Vec<Material>,
    /// The meshes that objects refer to, each once with each deformation.
    pub meshes: Vec<MeshReference>,
    /// The objects in the order of the file; an object's index is its id in every hit.
    pub objects: Vec<Object>,
    /// The lights in the order of the file.
    pub lights: Vec<Light>,
}

/// The camera: an eye, an orthonormal frame and an image rectangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// The eye, **e**.
    pub eye: DVec3,
    /// The direction of view, −**w**; of any length but 0.
    pub direction: DVec3,
    /// Fixes the upward direction; not parallel to `direction`.
    pub up: DVec3,
    /// Distance from the eye to the image plane; positive.
    pub distance: f64,
    /// Full vertical field of view in degrees; between 0 and 180, both excluded.
    pub fovy_degrees: f64,
    /// Width of the picture in pixels; from 1 to [`Camera::MAX_SIDE`].
    pub width: u32,
    /// Height of the picture in pixels; from 1 to [`Camera::MAX_SIDE`].
    pub height: u32,
}

impl Camera {
    /// The most pixels along one side of a picture: what a TGA file can state.
    pub const MAX_SIDE: u32 = 65_535;
}

/// The rendering options of a scene file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// How many bounces (mirror or refraction) a view ray may take; at most
    /// [`Options::MAX_RECURSION`].
    pub max_recursion: u32,
    /// 0: one ray through the pixel's centre; n > 0: n × n jittered samples a pixel; at most
    /// [`Options::MAX_AA`].
    pub aa: u32,
    /// What a ray that hits nothing sees.
    pub background: Color,
}

impl Default for Options {
    /// The options of a scene file that sets none.
    fn default() -> Self {
        Self { max_recursion: 1, aa: 0, background: Color::ZERO }
    }
}

impl Options {
    /// The most bounces that a view ray may take.
    pub const MAX_RECURSION: u32 = 1_000;
    /// The most samples along one side of a pixel.
    pub const MAX_AA: u32 = 256;
}

/// How a surface reflects and transmits light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// `ca`: the ambient light's colour.
    pub ambient_light: Color,
    /// `cr`: diffuse and ambient reflectance.
    pub reflectance: Color,
    /// `cp`: specular reflectance; black means neither highlight nor mirror.
    pub specular: Color,
    /// `shininess`: the Phong exponent; not negative.
    pub shininess: f32,
    /// `alpha`: opacity from 0 (clear) to 1 (opaque).
    pub alpha: f32,
    /// `ri`: index of refraction of the inside; positive.
    pub refractive_index: f32,
}

impl Default for Material {
    /// The material of the outermost level of a scene file.
    fn default() -> Self {
        Self {
            ambient_light: Color::splat(0.1),
            reflectance: Color::ONE,
            specular: Color::ZERO,
            shininess: 1.0,
            alpha: 1.0,
            refractive_index: 1.0,
        }
    }
}

/// A mesh file, by the name that the scene gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshReference {
    /// As written: a path relative to the folder of the scene, or `generate:KIND:TRIANGLES[:SEED]`.
    pub name: String,
    /// What is done to it before it is traced.
    pub deformation: Deformation,
    /// Where the scene names it first.
    pub span: Span,
}

impl MeshReference {
    /// A reference made by hand.
    #[must_use]
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), deformation: Deformation::default(), span: 0..0 }
    }
}

/// How a mesh is deformed in its own space: it is twisted, then a wave runs through it, then it is blown apart.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deformation {
    /// By how many degrees it is turned about the z axis for each unit of z.
    pub twist: f64,
    /// What lifts it along z.
    pub wave: Wave,
    /// How far its triangles are moved apart, as a share of their distance from the origin; not negative.
    pub explosion: f64,
}

/// A wave along x that lifts points along z by amplitude · sin 2π(x / length − phase).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// By how much, at most.
    pub amplitude: f64,
    /// From crest to crest; positive.
    pub length: f64,
    /// How far it has run along x, in wavelengths.
    pub phase: f64,
}

impl Default for Wave {
    /// None.
    fn default() -> Self {
        Self { amplitude: 0.0, length: 1.0, phase: 0.0 }
    }
}

impl Deformation {
    /// Whether it leaves a mesh as it is.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.twist == 0.0 && self.wave.amplitude == 0.0 && self.explosion == 0.0
    }

    /// Bits that are equal for deformations that are equal, and for all that leave a mesh as it is.
    #[must_use]
    pub fn key(&self) -> [u64; 5] {
        if self.is_none() {
            return [0; 5];
        }
        let Self { twist, wave: Wave { amplitude, length, phase }, explosion } = *self;
        // Adding 0 turns −0 into 0, which equals it but has other bits.
        [twist, amplitude, length, phase, explosion].map(|x| (x + 0.0).to_bits())
    }
}

impl fmt::Display for Deformation {
    /// As a scene has it: `twist 90, explode 0.5`; empty where there is none.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Wave { amplitude, length, phase } = self.wave;
        let parts = [
            (self.twist != 0.0).then(|| format!("twist {}", self.twist)),
            (amplitude != 0.0).then(|| format!("wave {amplitude} {length} {phase}")),
            (self.explosion != 0.0).then(|| format!("explode {}", self.explosion)),
        ];
        f.write_str(&parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
    }
}

/// Something that rays can hit.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Its shape, in object space.
    pub shape: Shape,
    /// Object space to world space; invertible.
    pub transform: DAffine3,
    /// Index into [`SceneDescription::materials`].
    pub material: usize,
    /// The command that made it.
    pub span: Span,
}

impl Object {
    /// An object made by hand, of the first material.
    #[must_use]
    pub fn new(shape: impl Into<Shape>, transform: DAffine3) -> Self {
        Self { shape: shape.into(), transform, material: 0, span: 0..0 }
    }
}

/// What an object is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// One primitive. A ball whose transform keeps its form, and every triangle, are in world space,
    /// and the object's transform is the identity: they were transformed as they were read, in double
    /// precision (see [`Ball::transformed`](crate::shapes::Ball::transformed)).
    Single(Single),
    /// A mesh of triangles.
    Mesh {
        /// Index into [`SceneDescription::meshes`].
        mesh: usize,
        /// How its faces are shaded.
        normals: Normals,
    },
}

impl Shape {
    /// What a mesh is called in messages.
    pub const MESH: &'static str = "mesh";

    /// The noun that messages use for it, after `a`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Single(single) => single.name(),
            Self::Mesh { .. } => Self::MESH,
        }
    }
}

impl From<Single> for Shape {
    fn from(single: Single) -> Self {
        Self::Single(single)
    }
}

/// Which normals shade a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Normals {
    /// `object_flat`: one normal a face.
    Flat,
    /// `object_phong`: the vertices' normals, interpolated over each face.
    Interpolated,
}

/// Something that gives light.
#[derive(Clone, Debug, PartialEq)]
pub enum Light {
    /// Light from one point.
    Point {
        /// Where it is, in world space.
        position: DVec3,
        /// What it emits.
        color: Color,
    },
    /// Light from a parallelogram: the square [−h, h]² of the plane z = 0, transformed.
    Area {
        /// Its centre in world space.
        center: DVec3,
        /// From the centre to the middle of one side: the image of (h, 0, 0).
        half_u: DVec3,
        /// From the centre to the middle of the next side: the image of (0, h, 0).
        half_v: DVec3,
        /// What the whole of it emits.
        color: Color,
    },
}
