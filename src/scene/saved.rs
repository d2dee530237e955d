//! A compiled scene in bytes, but for its meshes: what a million objects take to be parsed and compiled is not needed
//! where it was done before.

use std::io::{self, Read, Write};
use std::sync::Arc;

use glam::{DAffine3, DVec3, Vec3};
use rayon::prelude::*;

use crate::accel::{Decoder, Encoder, LoadError};
use crate::assets::MeshData;
use crate::description::{self, Material, Normals, Options, Shape};
use crate::math::{Color, NONE};
use crate::shapes::{Ball, Cylinder, Single, Triangle};

use super::{Camera, Light, Object, Scene, Transforms};

/// The kinds of objects; others are triangles.
const FLAT_MESH: u32 = 0;
const SMOOTH_MESH: u32 = 1;
const BALL: u32 = 2;
const CYLINDER: u32 = 3;
const TRIANGLE: u32 = 4;

/// The kinds of lights.
const POINT_LIGHT: u32 = 0;
const AREA_LIGHT: u32 = 1;

/// So many objects or transforms are converted by a thread at a time, at least.
const AT_ONCE: usize = 1 << 10;

impl Scene {
    /// Writes all but the meshes.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let out = &mut Encoder::new(out);
        write_camera(self.camera.description(), out)?;
        let Options { max_recursion, aa, background } = self.options;
        out.u32(max_recursion)?;
        out.u32(aa)?;
        out.vec3(background)?;
        let transforms = self.transforms.matrices();
        let mut shapes = Vec::new();
        let objects: Vec<_> =
            self.objects.iter().map(|object| words_of_object(object, &mut shapes)).collect();
        let lengths = [&self.materials.len(), &self.lights.len(), &transforms.len()];
        for length in lengths.into_iter().chain([&shapes.len(), &objects.len()]) {
            out.u32(u32::try_from(*length).map_err(io::Error::other)?)?;
        }
        out.checksum()?;
        out.list(&self.materials, words_of_material)?;
        out.list(&self.lights, words_of_light)?;
        out.list(&transforms, words_of_matrix)?;
        out.list(&shapes, |shape: &[f32; 9]| shape.map(f32::to_bits))?;
        out.list(&objects, |object| *object)?;
        out.checksum()
    }

    /// Reads what [`write`](Self::write) has written of a scene of these meshes, and nothing behind it. `size` is how
    /// many bytes there are at most.
    ///
    /// # Errors
    /// If the bytes are no scene, or were altered; if they name what is not there.
    pub fn read(
        meshes: Vec<Arc<MeshData>>,
        input: &mut dyn Read,
        size: u64,
    ) -> Result<Self, LoadError> {
        let input = &mut Decoder::of_size(input, size);
        let camera = read_camera(input)?;
        let camera = Camera::new(&camera).map_err(|error| LoadError::invalid(error.to_string()))?;
        let options =
            Options { max_recursion: input.u32()?, aa: input.u32()?, background: input.vec3()? };
        let mut lengths = [0; 5];
        for length in &mut lengths {
            *length = input.u32()?;
        }
        input.checksum()?;
        if options.max_recursion > Options::MAX_RECURSION || options.aa > Options::MAX_AA {
            return Err(LoadError::invalid("an option is out of its range"));
        }
        let [materials, lights, transforms, shapes, objects] = lengths;
        let materials = input.list(materials, "materials", material_of)?;
        let lights = input.list(lights, "lights", light_of)?;
        let transforms = input.list(transforms, "transforms", matrix_of)?;
        let shapes = input.list(shapes, "shapes", |words: [u32; 9]| words.map(f32::from_bits))?;
        let objects = input.list(objects, "objects", |words| object_of(words, &shapes))?;
        input.checksum()?;
        let are_there = |object: &Object| {
            let is_mesh = |mesh: usize| meshes.get(mesh).is_some();
            object.material < materials.len()
                && (object.transform == NONE || (object.transform as usize) < transforms.len())
                && object.corners.iter().all(|corner| corner.is_finite())
                && object.corners[0].cmple(object.corners[1]).all()
                && !matches!(object.shape, Shape::Mesh { mesh, .. } if !is_mesh(mesh))
        };
        if !objects.par_iter().with_min_len(AT_ONCE).all(are_there) {
            return Err(LoadError::invalid("an object names what is not there"));
        }
        // Whether the inverse is finite in single precision is seen where rays get it.
        let has_inverse = |matrix: &DAffine3| {
            let determinant = matrix.matrix3.determinant();
            matrix.is_finite() && determinant.is_finite() && determinant != 0.0
        };
        if !transforms.par_iter().with_min_len(AT_ONCE).all(has_inverse) {
            return Err(LoadError::invalid("a transform has no inverse"));
        }
        let lights: Option<Vec<_>> = lights.into_iter().collect();
        Ok(Self {
            camera,
            options,
            materials,
            objects,
            lights: lights.ok_or_else(|| LoadError::invalid("there is no such light"))?,
            meshes,
            transforms: Transforms::of_invertible(transforms),
        })
    }
}

fn write_camera(camera: &description::Camera, out: &mut Encoder<'_>) -> io::Result<()> {
    let description::Camera { eye, direction, up, distance, fovy_degrees, width, height } = camera;
    let vectors = [eye, direction, up].into_iter().flat_map(|vector| vector.to_array());
    for number in vectors.chain([*distance, *fovy_degrees]) {
        out.bytes(&number.to_le_bytes())?;
    }
    out.u32(*width)?;
    out.u32(*height)
}

fn read_camera(input: &mut Decoder<'_>) -> Result<description::Camera, LoadError> {
    let mut numbers = [0.0; 11];
    for number in &mut numbers {
        *number = f64::from_le_bytes(input.array()?);
    }
    let vector = |first: usize| DVec3::from_slice(&numbers[first..first + 3]);
    let camera = description::Camera {
        eye: vector(0),
        direction: vector(3),
        up: vector(6),
        distance: numbers[9],
        fovy_degrees: numbers[10],
        width: input.u32()?,
        height: input.u32()?,
    };
    let sides = 1..=description::Camera::MAX_SIDE;
    let fits = numbers.iter().all(|number| number.is_finite())
        && sides.contains(&camera.width)
        && sides.contains(&camera.height);
    if fits { Ok(camera) } else { Err(LoadError::invalid("the camera is out of its range")) }
}

/// Kind, number of the mesh or of the shape, transform, corners of the box, material. What is no mesh is added to the
/// shapes.
fn words_of_object(object: &Object, shapes: &mut Vec<[f32; 9]>) -> [u32; 10] {
    let mut add = |numbers: &[f32]| {
        let mut shape = [0.0; 9];
        shape[..numbers.len()].copy_from_slice(numbers);
        shapes.push(shape);
        shapes.len() as u32 - 1
    };
    let (kind, number) = match object.shape {
        Shape::Mesh { mesh, normals: Normals::Flat } => (FLAT_MESH, mesh as u32),
        Shape::Mesh { mesh, normals: Normals::Interpolated } => (SMOOTH_MESH, mesh as u32),
        Shape::Single(Single::Ball(Ball { center, radius })) => {
            (BALL, add(&[center.x, center.y, center.z, radius]))
        }
        Shape::Single(Single::Cylinder(Cylinder)) => (CYLINDER, 0),
        Shape::Single(Single::Triangle(triangle)) => {
            let [a, b, c] = triangle.corners.map(|corner| corner.to_array());
            (TRIANGLE, add([a, b, c].as_flattened()))
        }
    };
    let [[a, b, c], [d, e, f]] = object.corners.map(|corner| corner.to_array().map(f32::to_bits));
    [kind, number, object.transform, a, b, c, d, e, f, object.material as u32]
}

/// The object of these words; if there is no such kind or shape, one of no material.
fn object_of(words: [u32; 10], shapes: &[[f32; 9]]) -> Object {
    let [kind, number, transform, a, b, c, d, e, f, material] = words;
    let (shape, material) = match shape_of(kind, number as usize, shapes) {
        Some(shape) => (shape, material as usize),
        None => (Single::Cylinder(Cylinder).into(), usize::MAX),
    };
    let corner = |words: [u32; 3]| Vec3::from_array(words.map(f32::from_bits));
    let corners = [corner([a, b, c]), corner([d, e, f])];
    Object { shape, transform, corners, material }
}

fn shape_of(kind: u32, number: usize, shapes: &[[f32; 9]]) -> Option<Shape> {
    Some(match kind {
        FLAT_MESH => Shape::Mesh { mesh: number, normals: Normals::Flat },
        SMOOTH_MESH => Shape::Mesh { mesh: number, normals: Normals::Interpolated },
        BALL => {
            let &[x, y, z, radius, ..] = shapes.get(number)?;
            Single::Ball(Ball { center: Vec3::new(x, y, z), radius }).into()
        }
        CYLINDER => Single::Cylinder(Cylinder).into(),
        TRIANGLE => {
            let shape = shapes.get(number)?;
            let corner = |first: usize| Vec3::from_slice(&shape[first..first + 3]);
            Single::Triangle(Triangle { corners: [corner(0), corner(3), corner(6)] }).into()
        }
        _ => return None,
    })
}

fn words_of_material(material: &Material) -> [u32; 12] {
    let Material { ambient_light: a, reflectance: r, specular: s, .. } = material;
    let Material { shininess, alpha, refractive_index, .. } = *material;
    [a.x, a.y, a.z, r.x, r.y, r.z, s.x, s.y, s.z, shininess, alpha, refractive_index]
        .map(f32::to_bits)
}

fn material_of(words: [u32; 12]) -> Material {
    let numbers = words.map(f32::from_bits);
    let color = |first: usize| Color::from_slice(&numbers[first..first + 3]);
    Material {
        ambient_light: color(0),
        reflectance: color(3),
        specular: color(6),
        shininess: numbers[9],
        alpha: numbers[10],
        refractive_index: numbers[11],
    }
}

/// Kind, colour, then a point, and of an area the two sides.
fn words_of_light(light: &Light) -> [u32; 13] {
    let (kind, vectors) = match *light {
        Light::Point { position, color } => {
            (POINT_LIGHT, [color, position, Vec3::ZERO, Vec3::ZERO])
        }
        Light::Area { corner, side_u, side_v, color } => {
            (AREA_LIGHT, [color, corner, side_u, side_v])
        }
    };
    let numbers = vectors.map(|vector| vector.to_array().map(f32::to_bits));
    std::array::from_fn(|place| match place.checked_sub(1) {
        None => kind,
        Some(number) => numbers[number / 3][number % 3],
    })
}

fn light_of(words: [u32; 13]) -> Option<Light> {
    let vector =
        |first: usize| Vec3::from_array([0, 1, 2].map(|k| f32::from_bits(words[first + k])));
    let color = vector(1);
    match words[0] {
        POINT_LIGHT => Some(Light::Point { position: vector(4), color }),
        AREA_LIGHT => {
            Some(Light::Area { corner: vector(4), side_u: vector(7), side_v: vector(10), color })
        }
        _ => None,
    }
}

/// The columns of a matrix, each number's lower half first.
fn words_of_matrix(matrix: &DAffine3) -> [u32; 24] {
    let columns = matrix.to_cols_array().map(f64::to_bits);
    std::array::from_fn(|place| (columns[place / 2] >> (32 * (place % 2))) as u32)
}

fn matrix_of(words: [u32; 24]) -> DAffine3 {
    let number = |place: usize| u64::from(words[2 * place + 1]) << 32 | u64::from(words[2 * place]);
    DAffine3::from_cols_array(&std::array::from_fn(|place| f64::from_bits(number(place))))
}

#[cfg(test)]
mod tests;
