//! A mesh in the place of a scene: the text of a scene around it, by which all commands take an OBJ file.

use std::fmt::Write;
use std::path::Path;

use glam::DVec3;

use crate::assets::generate::Recipe;
use crate::math::{Aabb, SizeRange};

/// The whole mesh is in view where the picture's smaller side has this angle.
const FOVY_DEGREES: f64 = 36.0;

/// Width and height of the picture.
const SIZE: [u32; 2] = [480, 320];

/// A mesh whose coordinates are no larger than this has its camera and its lights in the range that is traced: they are
/// up to 4 √3 times as far from its middle.
pub(super) const MOST_REACH: f64 = 1e8;

/// A mesh that was named where a scene is expected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NamedMesh<'a> {
    /// A file, by its name in its folder.
    File(&'a str),
    /// `generate:KIND:TRIANGLES`.
    Generated(&'a str),
}

impl<'a> NamedMesh<'a> {
    /// The mesh that a path names: a file called `*.obj`, or a recipe.
    pub(super) fn of(path: &'a Path) -> Option<Self> {
        if let Some(text) = path.to_str().filter(|text| Recipe::parse(text).is_some()) {
            return Some(Self::Generated(text));
        }
        let is_obj = path.extension()?.eq_ignore_ascii_case("obj");
        // A scene cannot hold the name of a file with a quote in it.
        let name = path.file_name()?.to_str().filter(|name| is_obj && !name.contains('"'));
        name.map(Self::File)
    }

    /// What a scene calls it.
    pub(super) fn name(self) -> &'a str {
        match self {
            Self::File(name) | Self::Generated(name) => name,
        }
    }

    /// A scene of it alone, within a box, seen from the front and a little from above. Files mostly have their `y` axis
    /// upwards, and generated meshes their `z` axis. `None` if its camera or its lights would be too far away.
    pub(super) fn scene(self, bounds: &Aabb) -> Option<String> {
        let [low, high] =
            [bounds.min, bounds.max].map(|corner| glam::Vec3::from(corner).as_dvec3());
        let (middle, radius) = (0.5 * (low + high), 0.5 * (high - low).length());
        let radius = if radius > 0.0 { radius } else { 1.0 };
        // To the right, upwards and to the front, as seen from the eye.
        let turned = |right: f64, up: f64, front: f64| match self {
            Self::File(_) => DVec3::new(right, up, front),
            Self::Generated(_) => DVec3::new(right, 0.0 - front, up),
        };
        let to_eye = turned(0.35, 0.45, 1.0).normalize();
        let eye = middle + radius / (0.5 * FOVY_DEGREES).to_radians().sin() * to_eye;
        let light = middle + 4.0 * radius * turned(-0.7, 1.0, 0.8);
        let fill = middle + 4.0 * radius * turned(1.0, 0.3, 0.6);
        if ![low, high, eye, light, fill].iter().all(|place| SizeRange::WORLD.holds_at(*place)) {
            return None;
        }
        let lines = [("eyepos", eye), ("eyedir", -to_eye), ("eyeup", turned(0.0, 1.0, 0.0))];
        let mut text = "sce1.0\n".to_owned();
        let _ = writeln!(text, "# A mesh by itself, in the middle of the picture.");
        for (keyword, vector) in lines {
            let _ = writeln!(text, "{keyword} {}", numbers(vector));
        }
        let [width, height] = SIZE;
        let _ = writeln!(text, "wdist 1\nfovy_deg {FOVY_DEGREES}\nnx {width}\nny {height}");
        let _ = writeln!(text, "max_recursion 1\naasample 2\nbackground 0.30 0.34 0.40");
        let _ = writeln!(text, "pointlight {} 0.85 0.82 0.76", numbers(light));
        let _ = writeln!(text, "pointlight {} 0.20 0.22 0.26", numbers(fill));
        let _ =
            writeln!(text, "ca 0.22 0.22 0.22\ncr 0.70 0.68 0.64\ncp 0.12 0.12 0.12\nshininess 40");
        let _ = writeln!(text, "object_phong \"{}\"\nend", self.name());
        Some(text)
    }
}

fn numbers(vector: DVec3) -> String {
    format!("{} {} {}", vector.x, vector.y, vector.z)
}

#[cfg(test)]
mod tests {
    use glam::Vec3A;

    use super::*;
    use crate::scene_file::{ParseOptions, parse};

    #[test]
    fn files_and_recipes_are_told_from_scenes() {
        let of = |path: &'static str| NamedMesh::of(Path::new(path));
        assert_eq!(of("a/b c.OBJ"), Some(NamedMesh::File("b c.OBJ")));
        assert_eq!(of("generate:hall:1k"), Some(NamedMesh::Generated("generate:hall:1k")));
        for other in ["a.sce", "obj", "-", "a\"b.obj", "a.obj/b", ""] {
            assert_eq!(of(other), None, "{other}");
        }
    }

    #[test]
    fn all_of_the_box_is_in_view() {
        let boxes = [
            (Vec3A::new(-1.0, -2.0, -3.0), Vec3A::new(3.0, 5.0, 4.0)),
            (Vec3A::splat(1e6), Vec3A::new(1e6, 1e6, 1.1e6)),
            (Vec3A::splat(1e-7), Vec3A::splat(2e-7)),
            (Vec3A::ZERO, Vec3A::ZERO),
            (Vec3A::splat(-MOST_REACH as f32), Vec3A::splat(MOST_REACH as f32)),
        ];
        for mesh in [NamedMesh::File("a.obj"), NamedMesh::Generated("generate:hall:1k")] {
            for (min, max) in boxes {
                let text = mesh.scene(&Aabb { min, max }).unwrap();
                let parsed = parse(&text, &ParseOptions::default()).expect(&text);
                let camera = parsed.description.camera;
                let tangent = (0.5 * camera.fovy_degrees).to_radians().tan();
                for corner in 0..8 {
                    let side = |axis: usize| if corner >> axis & 1 == 0 { min } else { max }[axis];
                    let corner = DVec3::from_array([0, 1, 2].map(|axis| f64::from(side(axis))));
                    let to_corner = corner - camera.eye;
                    let ahead = to_corner.dot(camera.direction.normalize());
                    let aside = (to_corner - ahead * camera.direction.normalize()).length();
                    assert!(ahead > 0.0 && aside <= 1.001 * tangent * ahead, "{text}");
                }
            }
        }
    }

    #[test]
    fn a_mesh_that_reaches_too_far_has_no_scene() {
        for reach in [1e9, 1e20, f32::MAX] {
            for min in [Vec3A::ZERO, Vec3A::splat(-reach), Vec3A::splat(0.5 * reach)] {
                let bounds = Aabb { min, max: Vec3A::splat(reach) };
                assert_eq!(NamedMesh::File("a.obj").scene(&bounds), None, "{bounds:?}");
            }
        }
    }
}
