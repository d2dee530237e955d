//! A torus knot and its rays, and the check that structures answer them alike.

use std::sync::Arc;

use glam::{DAffine3, DVec3, Vec3};
use srt::accel::{Answers, BuildConfig, Scratch, Tracer};
use srt::assets::generate::{MeshKind, generate};
use srt::description::{
    Camera, Material, MeshReference, Normals, Object, Options, SceneDescription, Shape,
};
use srt::math::{Color, Hit, Ray};
use srt::scene::{Scene, TracedWorld, structure_named};

use crate::rays::{RaySet, ray_sets};

/// Rays of a class that trees trace in an iteration.
const RAYS: u32 = 40_000;

/// Primitive tests that an iteration of a linear structure may take; it traces fewer rays.
const LINEAR_TESTS: u64 = 20_000_000;

const LIGHT: Vec3 = Vec3::new(-3.0, -2.0, 4.0);

/// A knot of about so many triangles.
pub(crate) struct Knot {
    pub(crate) scene: Scene,
    pub(crate) triangles: u64,
    pub(crate) sets: Vec<RaySet>,
    /// `none`, whose answers are right.
    none: Box<dyn TracedWorld>,
}

impl Knot {
    pub(crate) fn new(triangles: u32) -> Self {
        let scene = scene(triangles);
        let build = |name| {
            let structure = structure_named(name).expect("it is a structure");
            structure.build(&scene, &BuildConfig::default())
        };
        let sets = ray_sets(&scene, &*build("bvh"), LIGHT, RAYS);
        let none = build("none");
        Self { triangles: scene.triangle_count(), sets, none, scene }
    }

    /// Rays of a class that linear structures trace in an iteration.
    pub(crate) fn linear_rays(&self) -> usize {
        ((LINEAR_TESTS / self.triangles) as usize).max(16)
    }

    /// Compares answers with those of `none`, on as many rays as that can trace.
    ///
    /// # Panics
    /// If a bit of them differs: what is wrong is not measured.
    pub(crate) fn check(&self, world: &dyn TracedWorld, sets: &[RaySet]) {
        for set in sets {
            let rays = spread(&set.rays, self.linear_rays());
            let (expected, got) = (answers(&*self.none, &rays), answers(world, &rays));
            let equal = expected.0.iter().zip(&got.0).all(|(a, b)| a.same_bits(b));
            let equal = equal && expected.1 == got.1;
            assert!(equal, "{} rays: the hits differ from those of `none`", set.class);
        }
    }
}

fn answers(tracer: &(impl Tracer + ?Sized), rays: &[Ray]) -> (Vec<Hit>, Vec<bool>) {
    let (mut hits, mut blocked) = (vec![Hit::MISS; rays.len()], vec![false; rays.len()]);
    tracer.trace(rays, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
    tracer.trace(rays, Answers::AnyHit(&mut blocked), &mut Scratch::default(), None);
    (hits, blocked)
}

/// At most `count` rays, evenly chosen.
pub(crate) fn spread(rays: &[Ray], count: usize) -> Vec<Ray> {
    rays.iter().step_by(rays.len().div_ceil(count)).copied().collect()
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
            width: 200,
            height: 200,
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
