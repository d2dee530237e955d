//! A torus knot and its rays, and the check that all structures give equal results.

use std::sync::Arc;

use glam::{DAffine3, DVec3, Vec3};
use srt::accel::BuildConfig;
use srt::assets::generate::{MeshKind, generate};
use srt::compare::measure::{FirstHits, RaySet, view_rays};
use srt::description::{
    Camera, Material, MeshReference, Normals, Object, Options, SceneDescription, Shape,
};
use srt::math::Color;
use srt::scene::{Scene, TracedWorld, structure_named};

/// Side of the picture in pixels: each gets a view ray.
const SIDE: u32 = 200;

/// Primitive tests that an iteration of a linear structure may take; it traces fewer rays.
const LINEAR_TESTS: u64 = 20_000_000;

const LIGHT: Vec3 = Vec3::new(-3.0, -2.0, 4.0);

const SEED: u64 = 1;

/// A knot of about so many triangles.
pub(crate) struct Knot {
    pub(crate) scene: Scene,
    pub(crate) triangles: u64,
    /// View rays, and from what they hit shadow, mirror and diffuse rays.
    pub(crate) sets: Vec<RaySet>,
    /// `none`, whose results are right.
    none: Box<dyn TracedWorld>,
}

impl Knot {
    pub(crate) fn new(triangles: u32) -> Self {
        let scene = scene(triangles);
        let build = |name| {
            let structure = structure_named(name).expect("it is a structure");
            structure.build(&scene, &BuildConfig::default())
        };
        let view = view_rays(&scene);
        let hits = FirstHits::new(&scene, &*build("bvh"), &view);
        let (shadow, mirror, diffuse) =
            (hits.shadow_rays(LIGHT), hits.mirror_rays(), hits.diffuse_rays(SEED));
        let none = build("none");
        let sets = vec![view, shadow, mirror, diffuse];
        Self { triangles: scene.triangle_count(), sets, none, scene }
    }

    /// Rays of a class that linear structures trace in an iteration.
    pub(crate) fn linear_rays(&self) -> usize {
        ((LINEAR_TESTS / self.triangles) as usize).max(16)
    }

    /// Compares results with those of `none`, on as many rays as that can trace.
    ///
    /// # Panics
    /// If a bit of them differs: what is wrong is not measured.
    pub(crate) fn check(&self, world: &dyn TracedWorld) {
        for set in &self.sets {
            let set = set.spread(self.linear_rays());
            let (mut expected, mut results) = (set.results(), set.results());
            expected.trace(&*self.none, &set.rays);
            results.trace(world, &set.rays);
            let differing = results.count_differing(&expected);
            assert_eq!(differing, 0, "{} rays: other hits than `none`", set.class.name());
        }
    }
}

fn scene(triangles: u32) -> Scene {
    let mesh = Arc::new(generate(MeshKind::TorusKnot, triangles, 1));
    Scene::new(&description(), vec![mesh]).expect("the scene can be traced")
}

/// A mesh seen from the front, without a light.
pub(crate) fn description() -> SceneDescription {
    SceneDescription {
        camera: Camera {
            eye: DVec3::new(0.3, -3.2, 1.4),
            direction: DVec3::new(-0.3, 3.2, -1.4),
            up: DVec3::Z,
            distance: 1.0,
            fovy_degrees: 38.0,
            width: SIDE,
            height: SIDE,
        },
        options: Options { max_recursion: 0, aa: 0, background: Color::ZERO },
        materials: vec![Material::default()],
        meshes: vec![MeshReference::new("knot")],
        objects: vec![Object::new(
            Shape::Mesh { mesh: 0, normals: Normals::Flat },
            DAffine3::IDENTITY,
        )],
        lights: vec![],
    }
}
