//! A mesh as a scene with a camera, and the place of a light.

use std::path::Path;
use std::sync::Arc;

use glam::{DAffine3, DVec3, Vec3};
use srt::assets::{MeshData, load_meshes};
use srt::description::{
    Camera, Material, MeshReference, Normals, Object, Options, SceneDescription, Shape,
};
use srt::math::Color;
use srt::scene::Scene;

/// The scene of a mesh, seen in a square picture, and a point that lights it.
///
/// Halls are seen from inside and lit below their ceiling; all else from (1, 0.6, 1.5) at 1.7 of its
/// radius, with the light behind the eye and above.
pub(crate) fn scene_of(name: &str, size: u32) -> Result<(Scene, Vec3), String> {
    let reference = MeshReference::new(name);
    let meshes = load_meshes(&[reference], Path::new(""))
        .map_err(|errors| errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))?;
    let View { eye, target, up, fovy_degrees, light } = if name.starts_with("generate:hall") {
        View::of_hall()
    } else {
        View::of_object(&meshes[0])
    };
    let camera = Camera {
        eye,
        direction: target - eye,
        up,
        distance: (target - eye).length(),
        fovy_degrees,
        width: size,
        height: size,
    };
    let scene = Scene::new(&description(name, camera), meshes);
    let scene = scene.map_err(|errors| format!("{name}: {}", errors[0]))?;
    Ok((scene, light.as_vec3()))
}

struct View {
    eye: DVec3,
    target: DVec3,
    up: DVec3,
    fovy_degrees: f64,
    light: DVec3,
}

impl View {
    fn of_hall() -> Self {
        Self {
            eye: DVec3::new(-0.95, -0.05, 0.35),
            target: DVec3::new(0.5, 0.0, 0.35),
            up: DVec3::Z,
            fovy_degrees: 70.0,
            light: DVec3::new(0.0, 0.0, 0.7),
        }
    }

    fn of_object(mesh: &Arc<MeshData>) -> Self {
        let bounds = mesh.bounds();
        let center = bounds.center().as_dvec3();
        let radius = 0.5 * bounds.size().as_dvec3().length();
        Self {
            eye: center + 1.7 * radius * DVec3::new(1.0, 0.6, 1.5).normalize(),
            target: center,
            up: DVec3::Y,
            fovy_degrees: 50.0,
            light: center + 3.0 * radius * DVec3::new(-0.4, 1.0, 0.9).normalize(),
        }
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
