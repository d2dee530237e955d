//! What is in a scene, in words: what `srt check` prints of a valid one.

use std::fmt::Write;

use crate::assets::MeshData;
use crate::description::{Camera, Light, SceneDescription, Shape};
use crate::math::Aabb;
use crate::scene::Scene;
use crate::shapes::Single;

/// Describes a scene, given as written and as traced.
///
/// `keyed_frames` are the first and the last frame of all keys, if it moves.
pub(crate) fn describe(
    scene: &SceneDescription,
    traced: &Scene,
    keyed_frames: Option<[f64; 2]>,
) -> String {
    let lines = [
        ("objects", objects(scene)),
        ("triangles", triangles(traced)),
        ("lights", lights(&scene.lights)),
        ("materials", scene.materials.len().to_string()),
        ("bounds", corners(traced.bounds())),
        ("camera", camera(&scene.camera)),
        ("picture", picture(scene)),
    ];
    let mut text = String::new();
    for (name, value) in lines {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {name:<11}{value}");
    }
    for (reference, mesh) in scene.meshes.iter().zip(traced.meshes()) {
        let deformation = match reference.deformation.to_string() {
            none if none.is_empty() => none,
            deformation => format!(" ({deformation})"),
        };
        let name = &reference.name;
        let _ = writeln!(text, "  {:<11}{name}{deformation}: {}", "mesh", size(mesh));
    }
    if let Some([first, last]) = keyed_frames {
        let _ =
            writeln!(text, "  {:<11}keys from frame {first} to {last}; this is frame 0", "motion");
    }
    text
}

/// `12 triangles, 8 vertices`.
fn size(mesh: &MeshData) -> String {
    let (triangles, vertices) = (mesh.triangles.len(), mesh.positions.len());
    let vertices = match vertices {
        1 => "1 vertex".to_owned(),
        n => format!("{n} vertices"),
    };
    format!("{}, {vertices}", counted(triangles, "triangle"))
}

fn objects(scene: &SceneDescription) -> String {
    let names = Single::NAMES.into_iter().chain([Shape::MESH]);
    let mut kinds: Vec<(usize, &str)> = names.map(|name| (0, name)).collect();
    for object in &scene.objects {
        let name = object.shape.name();
        match kinds.iter_mut().find(|(_, kind)| *kind == name) {
            Some((count, _)) => *count += 1,
            None => kinds.push((1, name)),
        }
    }
    enumerate(&kinds)
}

fn lights(lights: &[Light]) -> String {
    let areas = lights.iter().filter(|light| matches!(light, Light::Area { .. })).count();
    enumerate(&[(lights.len() - areas, "point light"), (areas, "area light")])
}

/// Triangles as they are traced: those of a mesh count for each object that names it.
fn triangles(traced: &Scene) -> String {
    let count = traced.triangle_count();
    match traced.meshes().len() {
        0 => count.to_string(),
        1 => format!("{count}, with those of 1 mesh file"),
        files => format!("{count}, with those of {files} mesh files"),
    }
}

fn corners(bounds: Aabb) -> String {
    if bounds.is_empty() {
        return "none".to_owned();
    }
    let (low, high) = (bounds.min.to_array(), bounds.max.to_array());
    format!("{} to {}", point(low.map(f64::from)), point(high.map(f64::from)))
}

fn camera(camera: &Camera) -> String {
    format!(
        "eye {}, direction {}, up {}, {}° high",
        point(camera.eye.to_array()),
        point(camera.direction.to_array()),
        point(camera.up.to_array()),
        camera.fovy_degrees,
    )
}

fn picture(scene: &SceneDescription) -> String {
    let samples = match scene.options.aa {
        0 => "1 sample a pixel".to_owned(),
        n => format!("{n} × {n} samples a pixel"),
    };
    let Camera { width, height, .. } = scene.camera;
    let bounces = match scene.options.max_recursion {
        0 => "no bounces".to_owned(),
        1 => "at most 1 bounce".to_owned(),
        n => format!("at most {n} bounces"),
    };
    format!("{width} × {height}, {samples}, {bounces}")
}

/// Coordinates with at most six significant digits or so: enough to find them in the scene.
fn point(coordinates: [f64; 3]) -> String {
    let [x, y, z] = coordinates.map(|c| {
        let text = if c.abs() < 1e6 { format!("{c:.4}") } else { format!("{c:.5e}") };
        match text.split_once('.') {
            Some((_, decimals)) if !decimals.contains('e') => {
                text.trim_end_matches('0').trim_end_matches('.').to_owned()
            }
            _ => text,
        }
    });
    format!("({x}, {y}, {z})")
}

/// `3: 1 ball, 2 cylinders`, without the kinds that do not occur.
fn enumerate(kinds: &[(usize, &str)]) -> String {
    let total: usize = kinds.iter().map(|(n, _)| n).sum();
    let named: Vec<String> =
        kinds.iter().filter(|(n, _)| *n > 0).map(|(n, kind)| counted(*n, kind)).collect();
    match total {
        0 => "none".to_owned(),
        _ => format!("{total}: {}", named.join(", ")),
    }
}

/// `1 mesh`, `2 meshes`.
fn counted(n: usize, kind: &str) -> String {
    let ending = match (n, kind.ends_with(['h', 's', 'x'])) {
        (1, _) => "",
        (_, true) => "es",
        (_, false) => "s",
    };
    format!("{n} {kind}{ending}")
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DAffine3, DVec3, Vec3};

    use super::*;
    use crate::description::{Material, MeshReference, Normals, Object, Options};
    use crate::math::Color;
    use crate::shapes::Cylinder;

    fn scene(shapes: Vec<Shape>) -> SceneDescription {
        let object = |shape| Object::new(shape, DAffine3::IDENTITY);
        SceneDescription {
            camera: Camera {
                eye: DVec3::new(0.0, -5.25, 0.0),
                direction: DVec3::Y,
                up: DVec3::Z,
                distance: 1.0,
                fovy_degrees: 40.5,
                width: 16,
                height: 12,
            },
            options: Options { max_recursion: 2, aa: 3, background: Color::ZERO },
            materials: vec![Material::default()],
            meshes: Vec::new(),
            objects: shapes.into_iter().map(object).collect(),
            lights: vec![Light::Point { position: DVec3::ONE, color: Color::ONE }],
        }
    }

    #[test]
    fn a_scene_in_words() {
        let mesh = || Shape::Mesh { mesh: 0, normals: Normals::Flat };
        let mut scene = scene(vec![Single::Cylinder(Cylinder).into(), mesh(), mesh()]);
        scene.objects[0].transform = DAffine3::from_scale(DVec3::new(1.5, 2.0, 3e7));
        scene.meshes = vec![MeshReference::new("a.obj")];
        let triangles = vec![[0, 1, 2]; 7];
        let data = MeshData::with_averaged_normals(vec![Vec3::ZERO, Vec3::X, Vec3::Y], triangles);
        let traced = Scene::new(&scene, vec![Arc::new(data)]).unwrap();
        let expected = "  \
  objects    3: 1 cylinder, 2 meshes
  triangles  14, with those of 1 mesh file
  lights     1: 1 point light
  materials  1
  bounds     (-1.5, -2, 0) to (1.5, 2, 3.00000e7)
  camera     eye (0, -5.25, 0), direction (0, 1, 0), up (0, 0, 1), 40.5° high
  picture    16 × 12, 3 × 3 samples a pixel, at most 2 bounces
  mesh       a.obj: 7 triangles, 3 vertices
";
        assert_eq!(describe(&scene, &traced, None), expected);
    }

    #[test]
    fn an_empty_scene_in_words() {
        let scene = scene(Vec::new());
        let traced = Scene::new(&scene, Vec::new()).unwrap();
        let text = describe(&scene, &traced, Some([0.0, 7.5]));
        assert!(text.contains("motion     keys from frame 0 to 7.5; this is frame 0\n"), "{text}");
        assert!(text.contains("objects    none\n"), "{text}");
        assert!(text.contains("bounds     none\n"), "{text}");
    }
}
