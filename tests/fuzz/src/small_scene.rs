//! Bytes → a small scene and rays into it, with numbers at which formulas and structures could go wrong.
//!
//! Every input is a scene: what it lacks at its end is taken as 0, and what cannot be traced is left out of the scene.

use std::sync::Arc;

use glam::{DAffine3, DMat3, DQuat, DVec3, Vec3};
use srt::assets::MeshData;
use srt::description::{
    Camera, Material, MeshReference, Normals, Object, Options, SceneDescription, Shape,
};
use srt::math::{Color, Ray, SizeRange};
use srt::scene::{Scene, SceneError};
use srt::shapes::{Ball, Cylinder, Single, Triangle};

/// The most objects, and triangles and vertices of a mesh.
const MOST: u8 = 24;

/// The most rays that an input gives; more are made of them.
const MOST_RAYS: u8 = 40;

/// At the ends of ranges, and where products round, vanish or tie.
const NUMBERS: [f32; 32] = [
    0.0,
    1.0,
    0.5,
    2.0,
    3.0,
    0.1,
    1.0 / 3.0,
    0.7,
    1.000_000_1,
    0.999_999_94,
    1e-3,
    1e-6,
    1e-9,
    1e-10,
    1e-12,
    1e-18,
    1e-25,
    1e-30,
    1e-38,
    1e-40,
    1e-45,
    1e3,
    1e5,
    1e6,
    1.6e7,
    1e8,
    9.9e8,
    1e9,
    1e12,
    1e15,
    1e25,
    3e38,
];

/// A scene, and rays that it [`takes`].
#[derive(Debug)]
pub struct SmallScene {
    /// The scene; empty where nothing of it could be traced.
    pub scene: Scene,
    /// The rays.
    pub rays: Vec<Ray>,
    /// A byte for whatever else is to be chosen.
    pub choice: u8,
}

/// Reads an input to its end, and no further.
struct Input<'a> {
    bytes: &'a [u8],
    /// What was read before, so that coordinates can be equal.
    numbers: Vec<f32>,
    points: Vec<Vec3>,
}

impl SmallScene {
    /// The scene of an input; `None` where even an empty one is refused, for its camera.
    #[must_use]
    pub fn new(bytes: &[u8]) -> Option<Self> {
        let mut input = Input { bytes, numbers: Vec::new(), points: Vec::new() };
        let choice = input.byte();
        let meshes = [input.mesh(), input.mesh()];
        let mut objects: Vec<Object> = Vec::new();
        for _ in 0..input.count(MOST) {
            let object = input.object(&objects);
            objects.extend(object);
        }
        let scene = traceable(objects, &meshes)?;
        let rays = (0..1 + input.count(MOST_RAYS - 1)).map(|_| input.ray());
        let rays = rays.filter(|ray| takes(&scene, ray)).collect();
        Some(Self { scene, rays, choice })
    }
}

/// Whether a ray is within the range of rays, in the spaces of all objects: one that is so in the world alone may be
/// infinite where an object is small, and what such a ray hits is not defined.
#[must_use]
pub fn takes(scene: &Scene, ray: &Ray) -> bool {
    let own_spaces = scene.objects.iter().any(|object| scene.transform_of(object).is_some());
    let largest = [ray.origin, ray.dir].map(|vector| f64::from(vector.abs().max_element()));
    let small = largest.into_iter().all(|largest| largest <= SizeRange::TRIANGLES.largest);
    ray.check().is_ok() && (small || !own_spaces)
}

/// The scene of those objects that can be traced.
fn traceable(mut objects: Vec<Object>, meshes: &[Arc<MeshData>]) -> Option<Scene> {
    // A mesh that no object is made of is checked by none, and would be indexed all the same.
    let meshes: Vec<_> = meshes
        .iter()
        .map(|mesh| match SizeRange::TRIANGLES.holds_for(&mesh.bounds()) {
            true => Arc::clone(mesh),
            false => Arc::new(MeshData::default()),
        })
        .collect();
    // Objects of one place in a text are reported once, and these have none.
    (0..).zip(&mut objects).for_each(|(place, object)| object.span = place..place + 1);
    let mut description = SceneDescription {
        camera: Camera {
            eye: DVec3::ZERO,
            direction: DVec3::X,
            up: DVec3::Z,
            distance: 1.0,
            fovy_degrees: 40.0,
            width: 1,
            height: 1,
        },
        options: Options::default(),
        materials: vec![Material { ambient_light: Color::ZERO, ..Material::default() }],
        meshes: meshes.iter().map(|_| MeshReference::new("fuzz.obj")).collect(),
        objects,
        lights: Vec::new(),
    };
    let errors = match Scene::new(&description, meshes.clone()) {
        Ok(scene) => return Some(scene),
        Err(errors) => errors,
    };
    let mut refused: Vec<usize> = errors.iter().filter_map(refused_object).collect();
    refused.sort_unstable();
    assert!(!refused.is_empty(), "{errors:?}");
    refused.iter().rev().for_each(|&object| drop(description.objects.remove(object)));
    // Rays start from fewer places now, so nothing else can have left the range.
    Some(Scene::new(&description, meshes.clone()).expect("what was refused is gone"))
}

fn refused_object(error: &SceneError) -> Option<usize> {
    match *error {
        SceneError::Transform { object, .. } | SceneError::OutOfRange { object } => Some(object),
        _ => None,
    }
}

impl Input<'_> {
    fn byte(&mut self) -> u8 {
        self.bytes.split_off_first().copied().unwrap_or(0)
    }

    fn count(&mut self, most: u8) -> u8 {
        self.byte() % (most + 1)
    }

    /// A number, most of them from one byte: on a coarse grid, at the end of a range, or one that was read before, or
    /// its neighbour; or any bits.
    fn number(&mut self) -> f32 {
        let byte = self.byte();
        let number = match byte {
            0..128 => f32::from(i16::from(byte) - 64) / 8.0,
            128..192 => {
                let number = NUMBERS[usize::from(byte % 32)];
                if byte < 160 { number } else { -number }
            }
            192..240 => {
                let earlier = self.numbers.len().checked_sub(1 + usize::from(byte % 16));
                let number = earlier.map_or(1.0, |i| self.numbers[i]);
                match byte / 16 % 3 {
                    0 => number,
                    1 => number.next_up(),
                    _ => -number,
                }
            }
            240.. => f32::from_bits(u32::from_le_bytes(std::array::from_fn(|_| self.byte()))),
        };
        self.numbers.push(number);
        number
    }

    fn finite(&mut self) -> f32 {
        let number = self.number();
        if number.is_finite() { number } else { 0.0 }
    }

    /// A point, or one that was read before.
    fn point(&mut self) -> Vec3 {
        let byte = self.byte();
        let earlier = self.points.len().checked_sub(1 + usize::from(byte % 16));
        match earlier {
            Some(i) if byte >= 128 => self.points[i],
            _ => {
                let point = Vec3::from_array(std::array::from_fn(|_| self.finite()));
                self.points.push(point);
                point
            }
        }
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|_| f64::from(self.finite())))
    }

    fn mesh(&mut self) -> Arc<MeshData> {
        let positions: Vec<Vec3> = (0..self.count(MOST)).map(|_| self.point()).collect();
        let corner = |byte: u8| u32::from(byte) % positions.len() as u32;
        let triangles = match positions.len() {
            0 => Vec::new(),
            _ => (0..self.count(MOST)).map(|_| [(); 3].map(|()| corner(self.byte()))).collect(),
        };
        Arc::new(MeshData::with_averaged_normals(positions, triangles))
    }

    /// An object; `None` for a triangle without area, which a scene never has.
    fn object(&mut self, before: &[Object]) -> Option<Object> {
        let byte = self.byte();
        let shape = match byte % 6 {
            0 => {
                let corners = [(); 3].map(|()| self.point());
                let [a, b, c] = corners.map(|corner| corner.as_dvec3());
                let has_area = (b - a).cross(c - a) != DVec3::ZERO;
                let triangle = Triangle::new(corners);
                return has_area
                    .then(|| Object::new(Single::Triangle(triangle), DAffine3::IDENTITY));
            }
            1 => {
                let (center, radius) = (self.point().as_dvec3(), f64::from(self.finite().abs()));
                let transform = self.transform();
                let (ball, transform) = Ball::transformed(center, radius, &transform);
                return Some(Object::new(Single::Ball(ball), transform));
            }
            2 => Shape::from(Single::Cylinder(Cylinder)),
            3 => Shape::Mesh { mesh: 0, normals: Normals::Flat },
            4 => Shape::Mesh { mesh: 1, normals: Normals::Interpolated },
            _ => return before.get(usize::from(byte / 6) % before.len().max(1)).cloned(),
        };
        Some(Object::new(shape, self.transform()))
    }

    fn transform(&mut self) -> DAffine3 {
        let byte = self.byte();
        let simple = |input: &mut Self, kind: u8| match kind {
            0 => DAffine3::IDENTITY,
            1 => DAffine3::from_translation(input.vector()),
            2 => DAffine3::from_scale(DVec3::splat(f64::from(input.finite()))),
            3 => DAffine3::from_scale(input.vector()),
            4 => {
                let axis = input.vector().normalize_or(DVec3::Z);
                DAffine3::from_quat(DQuat::from_axis_angle(axis, f64::from(input.finite())))
            }
            5 => DAffine3::from_mat3(DMat3::from_cols(
                input.vector(),
                input.vector(),
                input.vector(),
            )),
            _ => DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0)),
        };
        match byte {
            0..128 => simple(self, byte % 7),
            _ => simple(self, byte % 7) * simple(self, byte / 7 % 7),
        }
    }

    /// From anywhere to anywhere, to a vertex, along an axis, or cut.
    fn ray(&mut self) -> Ray {
        let byte = self.byte();
        let origin = self.point();
        let mut ray = match byte % 4 {
            0 => Ray::new(origin, Vec3::from_array(std::array::from_fn(|_| self.number()))),
            1 => Ray::new(origin, self.point() - origin),
            2 => {
                let dir = [0.0, -0.0, 1e-38][usize::from(byte / 4 % 3)];
                let mut ray = Ray::new(origin, Vec3::splat(dir));
                ray.dir[usize::from(byte / 12 % 3)] = self.number();
                ray
            }
            _ => {
                let to = (self.point() + self.point() + self.point()) / 3.0;
                Ray::new(origin, to - origin)
            }
        };
        if byte >= 192 {
            (ray.t_min, ray.t_max) = (self.number().abs(), self.number());
        }
        ray
    }
}
