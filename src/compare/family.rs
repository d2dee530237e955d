//! Families of scenes of growing size: what a sweep is about.

use std::fmt;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use crate::assets::generate::{MeshKind, Recipe, generate};
use crate::description::{
    Camera, Light, Material, MeshReference, Normals, Object, Options, SceneDescription, Shape,
};
use crate::math::Color;
use crate::scatter::{MOST_SCATTERED, ScatterKind, ScatterRecipe, ScatteredNormals, scatter};
use crate::scene::{Scene, SceneError};

/// Side of the picture whose rays are recorded.
const SIDE: u32 = 200;

/// Scenes that differ in size alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// One mesh of so many triangles.
    Mesh(MeshKind),
    /// So many objects, at most [`MOST_SCATTERED`].
    Scattered(ScatterKind),
}

impl Family {
    /// All families, in the order in which they are listed.
    pub const ALL: [Self; 13] = [
        Self::Mesh(MeshKind::Icosphere),
        Self::Mesh(MeshKind::TorusKnot),
        Self::Mesh(MeshKind::Terrain),
        Self::Mesh(MeshKind::Hall),
        Self::Mesh(MeshKind::Soup),
        Self::Mesh(MeshKind::Scan),
        Self::Mesh(MeshKind::Stadium),
        Self::Mesh(MeshKind::Hair),
        Self::Mesh(MeshKind::Box),
        Self::Scattered(ScatterKind::Balls),
        Self::Scattered(ScatterKind::Mixed),
        Self::Scattered(ScatterKind::Knots),
        Self::Scattered(ScatterKind::City),
    ];

    /// Its name on the command line and in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Mesh(kind) => kind.name(),
            Self::Scattered(kind) => kind.name(),
        }
    }

    /// Its description, in a line.
    #[must_use]
    pub fn description(self) -> &'static str {
        match self {
            Self::Mesh(kind) => kind.description(),
            Self::Scattered(kind) => kind.description(),
        }
    }

    /// What its size counts.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Mesh(_) => "triangles",
            Self::Scattered(_) => "objects",
        }
    }

    /// A scene of about a size, its materials half a mirror, seen from where all of it is before the eye.
    ///
    /// # Errors
    /// If it cannot be traced.
    pub fn scene(self, size: u32, seed: u64) -> Result<Scene, Vec<SceneError>> {
        let View { eye, target, light, fovy_degrees } = self.view();
        let mut description = SceneDescription {
            camera: Camera {
                eye,
                direction: target - eye,
                up: DVec3::Z,
                distance: 1.0,
                fovy_degrees,
                width: SIDE,
                height: SIDE,
            },
            options: Options { max_recursion: 1, aa: 0, background: Color::ZERO },
            materials: vec![Material { specular: Color::splat(0.3), ..Material::default() }],
            meshes: Vec::new(),
            objects: Vec::new(),
            lights: vec![Light::Point { position: light, color: Color::ONE }],
        };
        let mut meshes = Vec::new();
        match self {
            Self::Mesh(kind) => {
                description.meshes.push(MeshReference::new(kind.name()));
                meshes.push(Arc::new(generate(kind, size, seed)));
                let shape = Shape::Mesh { mesh: 0, normals: Normals::Flat };
                description.objects.push(Object::new(shape, DAffine3::IDENTITY));
            }
            Self::Scattered(kind) => {
                let mesh = kind.mesh().map(|(name, normals)| {
                    description.meshes.push(MeshReference::new(name));
                    let recipe = Recipe::parse(name).and_then(Result::ok);
                    meshes.extend(recipe.map(|r| Arc::new(generate(r.kind, r.triangles, r.seed))));
                    let interpolated = normals == ScatteredNormals::Interpolated;
                    let normals = if interpolated { Normals::Interpolated } else { Normals::Flat };
                    Shape::Mesh { mesh: 0, normals }
                });
                let recipe = ScatterRecipe { kind, count: size.min(MOST_SCATTERED), seed };
                description.objects = scatter(recipe)
                    .filter_map(|scattered| {
                        let placed = scattered.under(&DAffine3::IDENTITY);
                        let shape = placed.shape.map(Shape::Single).or(mesh)?;
                        Some(Object::new(shape, placed.transform))
                    })
                    .collect();
            }
        }
        Scene::new(&description, meshes)
    }

    /// The size of a scene of this family.
    pub(super) fn size_of(self, scene: &Scene) -> u64 {
        match self {
            Self::Mesh(_) => scene.triangle_count(),
            Self::Scattered(_) => scene.objects.len() as u64,
        }
    }

    fn view(self) -> View {
        match self {
            // Seen from inside, lit below the ceiling.
            Self::Mesh(MeshKind::Hall) => View {
                eye: DVec3::new(-0.95, -0.05, 0.35),
                target: DVec3::new(0.5, 0.0, 0.35),
                light: DVec3::Z * 0.7,
                fovy_degrees: 70.0,
            },
            // The teapot from near by, with the stands behind.
            Self::Mesh(MeshKind::Stadium) => View {
                eye: DVec3::new(0.012, -0.028, 0.012),
                target: DVec3::new(0.0, 0.0, 0.006),
                light: DVec3::new(-0.3, -0.2, 0.6),
                fovy_degrees: 48.0,
            },
            // Its strands are thin, and it is small.
            Self::Mesh(MeshKind::Hair) => View {
                eye: DVec3::new(0.2, -1.9, 0.6),
                target: DVec3::ZERO,
                light: DVec3::new(-3.0, -2.0, 4.0),
                fovy_degrees: 38.0,
            },
            // From above the edge, towards the middle.
            Self::Scattered(ScatterKind::City) => View {
                eye: DVec3::new(0.3, -1.3, 0.6),
                target: DVec3::ZERO,
                light: DVec3::new(-3.0, -2.0, 4.0),
                fovy_degrees: 55.0,
            },
            _ => View {
                eye: DVec3::new(0.3, -3.2, 1.4),
                target: DVec3::ZERO,
                light: DVec3::new(-3.0, -2.0, 4.0),
                fovy_degrees: 38.0,
            },
        }
    }
}

impl fmt::Display for Family {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// From where a family is seen.
struct View {
    eye: DVec3,
    target: DVec3,
    light: DVec3,
    fovy_degrees: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::BuildConfig;
    use crate::render::{RayClass, Settings, Silent, render};
    use crate::scene::structure_named;

    #[test]
    fn every_family_is_in_view_and_as_large_as_it_is_said_to_be() {
        for family in Family::ALL {
            let scene = family.scene(2_000, 1).unwrap();
            assert!((1_900..2_100).contains(&family.size_of(&scene)), "{family}");
            let world = structure_named("bvh").unwrap().build(&scene, &BuildConfig::default());
            let settings = Settings { width: 40, height: 40, ..Settings::of_scene(&scene) };
            let rendering = render(&scene, &*world, &settings, &Silent);
            let view = rendering.stats.class(RayClass::View);
            assert!(10 * view.hits > view.rays, "{family}: {view:?}");
        }
    }

    #[test]
    fn every_kind_is_in_a_family_of_its_own_name() {
        let kinds = MeshKind::ALL.map(Family::Mesh).into_iter();
        let all: Vec<_> = kinds.chain(ScatterKind::ALL.map(Family::Scattered)).collect();
        assert_eq!(all, Family::ALL);
        let mut names: Vec<_> = all.iter().map(|family| family.name()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), all.len());
    }
}
