//! Every kernel on little work, so that an interpreter can run it: the same hits as `none`, to the
//! bit. `tests/equal_hits` does the same with more than a million rays.

use glam::{DAffine3, DVec3, Vec3};

use super::*;
use crate::accel::{Bvh8, Exhaustive};
use crate::assets::MeshData;
use crate::description::{
    self, Camera, Material, MeshReference, Normals, Options, SceneDescription, Shape,
};
use crate::math::{Color, Hit, Random};
use crate::shapes::{Ball, Cylinder, Single, Triangle};
use crate::simd::LARGEST_PACKET;

/// Groups of rays, each as many as the largest packet has; fewer for an interpreter.
const GROUPS: usize = if cfg!(miri) { 8 } else { 64 };

fn point(random: &mut Random) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| 2.0 * random.next_f32() - 1.0))
}

/// Objects and a mesh of small triangles, all over a cube.
fn scene(objects: Vec<(Shape, DAffine3)>) -> Scene {
    scene_of((1, 512), objects)
}

/// The same with so many triangles, by a seed.
fn scene_of((seed, triangles): (u64, u32), objects: Vec<(Shape, DAffine3)>) -> Scene {
    let mut random = Random::new(&[seed]);
    let mut positions = Vec::new();
    for _ in 0..triangles {
        let center = point(&mut random);
        positions.extend([(); 3].map(|()| center + 0.3 * point(&mut random)));
    }
    let corners = (0..triangles).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let object = |(shape, transform)| description::Object::new(shape, transform);
    let description = SceneDescription {
        camera: Camera {
            eye: DVec3::ZERO,
            direction: DVec3::X,
            up: DVec3::Z,
            distance: 1.0,
            fovy_degrees: 40.0,
            width: 1,
            height: 1,
        },
        options: Options { max_recursion: 0, aa: 0, background: Color::ZERO },
        materials: vec![Material::default()],
        meshes: vec![MeshReference::new("cloud")],
        objects: objects.into_iter().map(object).collect(),
        lights: vec![],
    };
    let mesh = MeshData::with_averaged_normals(positions, corners);
    Scene::new(&description, vec![Arc::new(mesh)]).unwrap()
}

fn mesh() -> Shape {
    Shape::Mesh { mesh: 0, normals: Normals::Flat }
}

/// Groups of rays, from those that stay together to those that never were, and a few more: along
/// an axis, with an end, and fewer than a group.
fn rays() -> Vec<Ray> {
    let mut random = Random::new(&[2]);
    let mut rays = Vec::new();
    for group in 0..GROUPS {
        let spread = [0.001, 0.1, 0.4, 2.0][group % 4];
        let origin = 3.0 * point(&mut random);
        let target = 0.5 * point(&mut random);
        for _ in 0..LARGEST_PACKET {
            let aim = target + spread * point(&mut random);
            let end = [f32::MAX, 1.0][random.below(2) as usize];
            rays.push(Ray { t_max: end, ..Ray::new(origin, aim - origin) });
        }
    }
    rays.extend(Vec3::AXES.map(|axis| Ray::new(0.1 * point(&mut random) - 3.0 * axis, axis)));
    rays
}

/// Compares the hits of `bvh8` with those of `none`.
fn compare(scene: &Scene) {
    let config = BuildConfig::default();
    let rays = rays();
    let trace = |world: &dyn Tracer| {
        let (mut hits, mut blocked) = (vec![Hit::MISS; rays.len()], vec![false; rays.len()]);
        world.trace(&rays, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
        world.trace(&rays, Answers::AnyHit(&mut blocked), &mut Scratch::default(), None);
        (hits, blocked)
    };
    let expected = trace(&World::<Exhaustive, Exhaustive>::build(scene, &config));
    let got = trace(&World::<Bvh8, Bvh8>::build(scene, &config));
    for (i, ray) in rays.iter().enumerate() {
        assert!(got.0[i].same_bits(&expected.0[i]), "{ray:?}: {:?}, {:?}", got.0[i], expected.0[i]);
        assert_eq!(got.1[i], expected.1[i], "{ray:?}");
    }
    let hits = got.1.iter().filter(|&&blocked| blocked).count();
    assert!(hits * 8 > rays.len() && hits < rays.len(), "{hits} of {}", rays.len());
}

#[test]
fn packets_diverged_rays_and_waves_find_what_none_finds() {
    compare(&scene(vec![(mesh(), DAffine3::IDENTITY)]));
}

#[test]
fn streams_find_what_none_finds() {
    let mut random = Random::new(&[3]);
    let mut objects = Vec::new();
    for number in 0..12 {
        let place = point(&mut random).as_dvec3();
        let turned = DAffine3::from_axis_angle(place.normalize(), 1.0);
        let transform = DAffine3::from_translation(place)
            * turned
            * DAffine3::from_scale(DVec3::new(0.3, 0.4, 0.5));
        let ball = |center: Vec3, radius| Single::Ball(Ball { center, radius }).into();
        objects.push(match number % 5 {
            0 => (ball(place.as_vec3(), 0.3), DAffine3::IDENTITY),
            1 => (ball(Vec3::ZERO, 1.0), transform),
            2 => (Single::Cylinder(Cylinder).into(), transform),
            3 => {
                let corners = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| place + 0.5 * axis);
                let triangle = Triangle::new(corners.map(|corner| corner.as_vec3()));
                (Single::Triangle(triangle).into(), DAffine3::IDENTITY)
            }
            _ => (mesh(), transform),
        });
    }
    compare(&scene(objects));
}

#[test]
fn what_was_saved_of_other_triangles_is_refused() {
    let of = |seed, triangles| scene_of((seed, triangles), vec![(mesh(), DAffine3::IDENTITY)]);
    let mut bytes = Vec::new();
    World::<Bvh8, Bvh8>::build(&of(1, 64), &BuildConfig::default()).write(&mut bytes).unwrap();
    let read = |scene: &Scene| {
        let read = World::<Bvh8, Bvh8>::read(scene, &mut &bytes[..], bytes.len() as u64);
        read.map(|_| ()).map_err(|error| error.to_string())
    };
    assert_eq!(read(&of(1, 64)), Ok(()));
    for other in [of(2, 64), of(1, 63)] {
        let error = read(&other).unwrap_err();
        assert!(error.contains("it is of 64 triangles, or of others"), "{error}");
    }
}
