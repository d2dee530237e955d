//! From the scene as written to the scene as traced.

use std::collections::HashSet;
use std::sync::Arc;

use glam::{DAffine3, DVec3, Vec3};
use rayon::prelude::*;

use crate::assets::MeshData;
use crate::description::{self, SceneDescription, Shape};
use crate::math::{Aabb, NONE, SizeRange, Transform};
use crate::shapes::Triangle;

use super::{Camera, Light, Object, Scene, SceneError, Transforms, range};

/// The range of all that is in the world.
const WORLD: SizeRange = SizeRange::WORLD;

impl Scene {
    /// Compiles a description with its meshes, which are in the order of
    /// [`SceneDescription::meshes`].
    ///
    /// # Errors
    /// All objects, lights and cameras of which the transform or frame is degenerate, or that leave
    /// the range in which the formulas hold in single precision: coordinates up to 10⁹, sizes from
    /// 10⁻⁹ ([`SizeRange`] says why). Of objects from one place in the text, the
    /// first.
    ///
    /// # Panics
    /// If an object refers to a mesh or a material that is not there.
    pub fn new(
        description: &SceneDescription,
        meshes: Vec<Arc<MeshData>>,
    ) -> Result<Self, Vec<SceneError>> {
        let mesh_bounds: Vec<Aabb> = meshes.iter().map(|mesh| stored_bounds(mesh)).collect();
        let Compiled { objects, transforms, mut errors } =
            compile_objects(description, &mesh_bounds);
        errors.extend(lights_out_of_range(&description.lights));
        let camera = match Camera::new(&description.camera) {
            Ok(camera) if errors.is_empty() => camera,
            Ok(_) => return Err(errors),
            Err(error) => {
                errors.push(error);
                return Err(errors);
            }
        };
        Ok(Self {
            camera,
            options: description.options,
            materials: description.materials.clone(),
            objects,
            lights: description.lights.iter().map(Light::new).collect(),
            meshes,
            transforms,
        })
    }
}

/// The box around a mesh's triangles as they are traced: its corners may differ in the last bit
/// from the file's, and the box of an object must contain its primitives' own boxes.
fn stored_bounds(mesh: &MeshData) -> Aabb {
    let corners = |triangle: &[u32; 3]| triangle.map(|i| mesh.positions[i as usize]);
    let bounds = |triangle| Triangle::new(corners(triangle)).bounds();
    let chunks = mesh.triangles.par_chunks(1 << 13);
    chunks
        .map(|chunk| chunk.iter().map(bounds).fold(Aabb::EMPTY, Aabb::union))
        .reduce(|| Aabb::EMPTY, Aabb::union)
}

/// The objects that can be traced, and what is wrong with the others.
#[derive(Default)]
struct Compiled {
    objects: Vec<Object>,
    transforms: Transforms,
    errors: Vec<SceneError>,
}

fn compile_objects(description: &SceneDescription, mesh_bounds: &[Aabb]) -> Compiled {
    let count = description.objects.len();
    let mut compiled = Compiled { objects: Vec::with_capacity(count), ..Compiled::default() };
    // Ids and places of objects to be checked again; those in error leave a gap in the ids.
    let mut doubtful = Vec::new();
    let mut errors = Vec::new();
    // Of the many objects of one line in a `repeat`, one is enough.
    let mut reported = HashSet::new();
    let mut is_first = |id: usize| reported.insert(description.objects[id].span.start);
    for (id, object) in description.objects.iter().enumerate() {
        match compile_object(id, object, mesh_bounds, &mut compiled.transforms) {
            Ok((object, holds_anywhere)) => {
                if !holds_anywhere {
                    doubtful.push((id, compiled.objects.len()));
                }
                compiled.objects.push(object);
            }
            Err(error) if is_first(id) => errors.push((id, error)),
            Err(_) => {}
        }
    }
    let reach = reach(description, &compiled.objects);
    for (object, place) in doubtful {
        let holds =
            holds_in_own_space(&compiled.objects[place], &compiled.transforms, mesh_bounds, reach);
        if !holds && is_first(object) {
            errors.push((object, SceneError::OutOfRange { object }));
        }
    }
    errors.sort_by_key(|&(id, _)| id);
    compiled.errors = errors.into_iter().map(|(_, error)| error).collect();
    compiled
}

/// How far from the world's origin rays start: the largest coordinate of the objects, the lights
/// and the eye.
fn reach(description: &SceneDescription, objects: &[Object]) -> f64 {
    let of_objects = objects.iter().map(|object| f64::from(object.bounds().largest_coordinate()));
    let of_lights = description.lights.iter().flat_map(ends).map(|p| p.abs().max_element());
    let of_eye = description.camera.eye.abs().max_element();
    of_objects.chain(of_lights).fold(of_eye, f64::max).min(WORLD.largest)
}

/// The points between which a light is.
fn ends(light: &description::Light) -> [DVec3; 4] {
    match *light {
        description::Light::Point { position, .. } => [position; 4],
        description::Light::Area { center: c, half_u: u, half_v: v, .. } => {
            [c - u - v, c - u + v, c + u - v, c + u + v]
        }
    }
}

fn lights_out_of_range(lights: &[description::Light]) -> impl Iterator<Item = SceneError> {
    let beyond = |&light: &usize| !ends(&lights[light]).into_iter().all(|end| WORLD.holds_at(end));
    (0..lights.len()).filter(beyond).map(|light| SceneError::LightOutOfRange { light })
}

fn holds_in_own_space(
    object: &Object,
    transforms: &Transforms,
    mesh_bounds: &[Aabb],
    reach: f64,
) -> bool {
    transforms.get(object.transform).is_none_or(|transform| {
        range::holds_in(&transform, &own_bounds(&object.shape, mesh_bounds), reach)
    })
}

/// The box of a shape in its own space.
fn own_bounds(shape: &Shape, mesh_bounds: &[Aabb]) -> Aabb {
    match shape {
        Shape::Single(single) => single.bounds(),
        Shape::Mesh { mesh, .. } => mesh_bounds[*mesh],
    }
}

/// Also returns whether its formula holds in its own space for rays from any distance, which is so
/// for nearly all; the others are checked once it is known how far away rays start.
fn compile_object(
    id: usize,
    object: &description::Object,
    mesh_bounds: &[Aabb],
    transforms: &mut Transforms,
) -> Result<(Object, bool), SceneError> {
    let shape = object.shape;
    let transform = (object.transform != DAffine3::IDENTITY)
        .then(|| Transform::new(object.transform))
        .transpose()
        .map_err(|source| SceneError::Transform { object: id, source })?;
    let own = own_bounds(&shape, mesh_bounds);
    let bounds = transform.as_ref().map_or(own, |t| t.bounds_to_world(&own));
    let holds_as_it_is = match &shape {
        Shape::Single(single) if transform.is_none() => single.size() >= WORLD.smallest,
        Shape::Single(_) => true,
        Shape::Mesh { .. } => SizeRange::TRIANGLES.holds_for(&own),
    };
    if !holds_as_it_is || !WORLD.holds_for(&bounds) {
        return Err(SceneError::OutOfRange { object: id });
    }
    let holds_anywhere = transform.as_ref().is_none_or(|t| range::holds_in(t, &own, WORLD.largest));
    let transform = transform.map_or(NONE, |transform| transforms.add(&transform));
    let corners = [bounds.min, bounds.max].map(Vec3::from);
    Ok((Object { shape, transform, corners, material: object.material }, holds_anywhere))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description::{Material, MeshReference, Normals, Options};
    use crate::math::Color;
    use crate::shapes::{Ball, Cylinder, Single};
    use glam::Vec3A;

    const CYLINDER: Shape = Shape::Single(Single::Cylinder(Cylinder));

    fn ball(center: DVec3, radius: f64, transform: DAffine3) -> (Shape, DAffine3) {
        let (ball, transform) = Ball::transformed(center, radius, &transform);
        (Single::Ball(ball).into(), transform)
    }

    /// A scene of objects with transforms, and of one mesh with a vertex that no triangle uses.
    fn compiled(objects: Vec<(Shape, DAffine3)>) -> Result<Scene, Vec<SceneError>> {
        compiled_with(objects, |_| {})
    }

    fn compiled_with(
        objects: Vec<(Shape, DAffine3)>,
        change: impl FnOnce(&mut SceneDescription),
    ) -> Result<Scene, Vec<SceneError>> {
        let object = |(place, (shape, transform))| description::Object {
            span: place..place + 1,
            ..description::Object::new(shape, transform)
        };
        let mut description = SceneDescription {
            camera: description::Camera {
                eye: DVec3::ZERO,
                direction: DVec3::X,
                up: DVec3::Z,
                distance: 1.0,
                fovy_degrees: 40.0,
                width: 4,
                height: 3,
            },
            options: Options { max_recursion: 0, aa: 0, background: Color::ZERO },
            materials: vec![Material::default()],
            meshes: vec![MeshReference::new("a.obj")],
            objects: objects.into_iter().enumerate().map(object).collect(),
            lights: vec![],
        };
        change(&mut description);
        let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::splat(50.0)];
        let mesh = MeshData::with_averaged_normals(positions, vec![[0, 1, 2]]);
        Scene::new(&description, vec![Arc::new(mesh)])
    }

    fn mesh() -> Shape {
        Shape::Mesh { mesh: 0, normals: Normals::Flat }
    }

    fn scale(factor: f64) -> DAffine3 {
        DAffine3::from_scale(DVec3::splat(factor))
    }

    #[test]
    fn vertices_without_triangles_take_no_room() {
        let scene = compiled(vec![(mesh(), DAffine3::IDENTITY)]).unwrap();
        assert_eq!(scene.bounds().max, Vec3A::new(1.0, 1.0, 0.0));
    }

    #[test]
    fn objects_within_the_range_are_taken() {
        let unit_ball = |transform| ball(DVec3::ZERO, 1.0, transform);
        for factor in [1e-8, 1e-3, 1.0, 1e6, 9e8] {
            let scale = scale(factor);
            compiled(vec![unit_ball(scale), (CYLINDER, scale), (mesh(), scale)]).unwrap();
        }
        // A disc as flat as can be.
        let flat = DAffine3::from_scale(DVec3::new(1.0, 1.0, 1e-12));
        compiled(vec![(CYLINDER, flat), unit_ball(flat)]).unwrap();
    }

    #[test]
    fn all_that_is_out_of_range_is_reported_at_once() {
        let far = DAffine3::from_translation(DVec3::X * 2e9);
        let flat = DAffine3::from_scale(DVec3::new(1.0, 0.0, 1.0));
        let objects = vec![
            (CYLINDER, scale(1e38)),
            ball(DVec3::ONE, 1e-10, DAffine3::IDENTITY),
            (mesh(), far),
            (CYLINDER, DAffine3::IDENTITY),
            (CYLINDER, flat),
            (CYLINDER, DAffine3::from_scale(DVec3::new(1.0, 1.0, 1e-25))),
        ];
        let errors = compiled_with(objects, |description| {
            let color = Color::ONE;
            description.lights = vec![
                description::Light::Point { position: DVec3::ONE, color },
                description::Light::Area {
                    center: DVec3::ZERO,
                    half_u: DVec3::X * 1e12,
                    half_v: DVec3::Y,
                    color,
                },
            ];
            description.camera.eye = DVec3::X * -1e20;
        })
        .unwrap_err();
        assert!(matches!(errors[3], SceneError::Transform { object: 4, .. }), "{errors:?}");
        let others: Vec<_> = errors.iter().enumerate().filter(|(i, _)| *i != 3).collect();
        let objects = [0, 1, 2, 5].map(|object| SceneError::OutOfRange { object });
        let rest = [SceneError::LightOutOfRange { light: 1 }, SceneError::CameraOutOfRange];
        let expected: Vec<_> = objects.iter().chain(&rest).collect();
        assert_eq!(others.into_iter().map(|(_, error)| error).collect::<Vec<_>>(), expected);
    }

    #[test]
    fn objects_from_one_place_in_the_text_give_one_error() {
        let objects = vec![ball(DVec3::X * 2e9, 1.0, DAffine3::IDENTITY); 2];
        let at_one_place = |description: &mut SceneDescription| {
            description.objects[1].span = description.objects[0].span.clone();
        };
        let errors = compiled_with(objects.clone(), at_one_place).unwrap_err();
        assert_eq!(errors, [SceneError::OutOfRange { object: 0 }]);
        assert_eq!(compiled(objects).unwrap_err().len(), 2);
    }
}
