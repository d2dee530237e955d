//! A mesh as scenes with a camera each, and the place of a light.

use std::path::Path;
use std::sync::Arc;

use glam::{DAffine3, DVec3, Vec3};
use srt::assets::{MeshData, load_meshes};
use srt::description::{
    Camera, Material, MeshReference, Normals, Object, Options, SceneDescription, Shape,
};
use srt::math::Color;
use srt::scene::Scene;

/// The scene of a mesh, seen in square pictures from two places, and a point that lights it.
///
/// Halls are seen from inside and lit below their ceiling. All else lies on a ground of two large triangles, so that
/// many secondary rays leave the scene at once; it is seen from (1, 0.6, 1.5) at 1.7 of its radius, and from nearer by,
/// lower and from behind, with the light above and to the left.
pub(crate) fn scenes_of(name: &str, size: u32, ground: bool) -> Result<Vec<(Scene, Vec3)>, String> {
    let reference = MeshReference::new(name);
    let mut meshes = load_meshes(&[reference], Path::new(""))
        .map_err(|errors| errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))?;
    let hall = name.starts_with("generate:hall");
    let views = if hall { View::of_hall() } else { View::of_object(&meshes[0]) };
    if ground && !hall {
        meshes[0] = Arc::new(on_ground(&meshes[0]));
    }
    let scene_of = |View { eye, target, up, fovy_degrees, light }| {
        let camera = Camera {
            eye,
            direction: target - eye,
            up,
            distance: (target - eye).length(),
            fovy_degrees,
            width: size,
            height: size,
        };
        let scene = Scene::new(&description(name, camera), meshes.clone());
        let scene = scene.map_err(|errors| format!("{name}: {}", errors[0]))?;
        Ok((scene, light.as_vec3()))
    };
    views.into_iter().map(scene_of).collect()
}

/// The mesh on a square of two triangles, ten times as wide as it is large.
fn on_ground(mesh: &MeshData) -> MeshData {
    let bounds = mesh.bounds();
    let (center, half) = (bounds.center(), 5.0 * bounds.size().max_element());
    let corner = |x: f32, z: f32| Vec3::new(center.x + x * half, bounds.min.y, center.z + z * half);
    let first = mesh.positions.len() as u32;
    let mut positions = mesh.positions.clone();
    positions.extend([corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)]);
    let mut triangles = mesh.triangles.clone();
    triangles.extend([[0, 1, 2], [0, 2, 3]].map(|corners| corners.map(|corner| first + corner)));
    MeshData::with_averaged_normals(positions, triangles)
}

struct View {
    eye: DVec3,
    target: DVec3,
    up: DVec3,
    fovy_degrees: f64,
    light: DVec3,
}

impl View {
    fn of_hall() -> [Self; 2] {
        let from = |eye, target| Self {
            eye,
            target,
            up: DVec3::Z,
            fovy_degrees: 70.0,
            light: DVec3::new(0.0, 0.0, 0.7),
        };
        [
            from(DVec3::new(-0.95, -0.05, 0.35), DVec3::new(0.5, 0.0, 0.35)),
            from(DVec3::new(0.6, 0.15, 0.15), DVec3::new(-0.5, -0.1, 0.4)),
        ]
    }

    fn of_object(mesh: &Arc<MeshData>) -> [Self; 2] {
        let bounds = mesh.bounds();
        let center = bounds.center().as_dvec3();
        let radius = 0.5 * bounds.size().as_dvec3().length();
        let from = |distance: f64, direction: DVec3| Self {
            eye: center + distance * radius * direction.normalize(),
            target: center,
            up: DVec3::Y,
            fovy_degrees: 50.0,
            light: center + 3.0 * radius * DVec3::new(-0.4, 1.0, 0.9).normalize(),
        };
        [from(1.7, DVec3::new(1.0, 0.6, 1.5)), from(1.2, DVec3::new(-1.2, 0.25, -0.8))]
    }
}

fn description(name: &str, camera: Camera) -> SceneDescription {
    SceneDescription {
        camera,
        options: Options { max_recursion: 0, aa: 0, background: Color::ZERO },
        materials: vec![Material::default()],
        meshes: vec![MeshReference::new(name)],
        objects: vec![Object::new(
            Shape::Mesh { mesh: 0, normals: Normals::Flat },
            DAffine3::IDENTITY,
        )],
        lights: vec![],
    }
}
