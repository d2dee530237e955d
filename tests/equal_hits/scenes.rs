//! Two levels: objects of every form under every kind of transform, in every structure.

use std::ops::Range;
use std::sync::Arc;

use glam::{DAffine3, DQuat, DVec3, Vec3, Vec3Swizzles};
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};
use srt::accel::{BuildConfig, Quality, Update};
use srt::assets::MeshData;
use srt::conformance::adversarial_rays::rays_cut_at_hits;
use srt::conformance::nasty_meshes::{self, Mesh, random_point};
use srt::description::{
    Camera, Material, MeshReference, Normals, Object, Options, SceneDescription, Shape,
};
use srt::math::{Color, Random, Ray};
use srt::scene::{STRUCTURES, Scene, SceneChange};
use srt::shapes::{Ball, Cylinder, Single, Triangle};

use crate::{assert_equal, for_this_isa, trace};

#[test]
fn random_scenes_of_transformed_objects() {
    let scales = [1e-3, 1.0, 1e6];
    let cases: Vec<_> = (0..8).flat_map(|seed| scales.map(|scale| (seed, scale))).collect();
    let compared: usize = cases
        .par_iter()
        .with_max_len(1)
        .map(|&(seed, scale)| {
            // Many objects, and so few that one node holds them all.
            compare(&random_scene(seed, scale, 0..40), seed, for_this_isa(6_000))
                + compare(&random_scene(seed, scale, 11..17), seed, for_this_isa(3_000))
                // A mesh by itself.
                + compare(&random_scene(seed, scale, 3..4), seed, for_this_isa(3_000))
        })
        .sum();
    println!("{compared} rays compared, 0 differ");
    assert!(compared > for_this_isa(250_000), "only {compared} rays were compared");
}

#[test]
fn many_objects_of_all_forms_in_a_deep_tree() {
    [1.0, 1e3].par_iter().for_each(|&scale| {
        compare(&random_scene(77, scale, 0..700), 77, for_this_isa(6_000));
    });
}

#[test]
fn scenes_that_move_after_refits() {
    let cases: Vec<_> =
        (0..6).flat_map(|seed| [1e-3, 1.0, 1e6].map(|scale| (seed, scale))).collect();
    let compared: usize = cases
        .par_iter()
        .with_max_len(1)
        .map(|&(seed, scale)| {
            // Of many objects few move in a frame, so that only paths are gone up.
            compare_frames(seed, scale, 0..300) + compare_frames(seed, scale, 3..4)
        })
        .sum();
    println!("{compared} rays compared, 0 differ");
    assert!(compared > for_this_isa(60_000), "only {compared} rays were compared");
}

/// Lets each structure that can follow a scene through some frames, and compares it in each with `none` as it is built
/// for that frame; returns how many rays.
fn compare_frames(seed: u64, scale: f64, numbers: Range<usize>) -> usize {
    let config = BuildConfig::default();
    let mut scene = random_scene(seed, scale, numbers.clone());
    let ways =
        STRUCTURES.iter().flat_map(|structure| Update::ALL.map(|update| (structure, update)));
    let offered = ways.filter(|(structure, update)| structure.can_follow(*update));
    let mut worlds: Vec<_> = offered
        .map(|(structure, update)| (structure.name, update, structure.build(&scene, &config)))
        .collect();
    let names: Vec<_> = worlds.iter().map(|(name, ..)| *name).collect();
    assert_eq!(names, ["none", "bvh", "bvh", "bvh", "bvh8", "bvh8", "bvh8"]);
    let mut compared = 0;
    for frame in 1..5 {
        let next = random_frame(seed, scale, numbers.clone(), frame);
        let change = SceneChange::between(&scene, &next).expect("it is the same scene");
        assert!(numbers.len() == 1 || change.moved_objects() > 0);
        for (name, update, world) in &mut worlds {
            assert!(world.refit(&change, *update), "{name}, {update:?}, frame {frame}");
        }
        let none = STRUCTURES[0].build(&next, &config);
        let rays = rays_into(&next, seed + frame, for_this_isa(600));
        let expected = trace(none.as_ref(), &rays);
        for (name, update, world) in &worlds {
            let what = format!("scene {seed} times {scale:e}, frame {frame}: {name}, {update:?}");
            assert_equal(&what, world.as_ref(), &rays, &expected);
        }
        compared += rays.len();
        scene = next;
    }
    compared
}

/// Compares all structures with the first of the table, `none`; returns how many rays.
pub(super) fn compare(scene: &Scene, seed: u64, count: usize) -> usize {
    let worlds: Vec<_> = STRUCTURES
        .iter()
        .flat_map(|structure| {
            [Quality::Fastest, Quality::Slowest].map(|quality| {
                let config = BuildConfig { quality, ..BuildConfig::default() };
                (structure.name, structure.build(scene, &config))
            })
        })
        .collect();
    let (oracle, none) = &worlds[0];
    assert_eq!(*oracle, "none");
    let rays = rays_into(scene, seed, count);
    let cut = rays_cut_at_hits(&rays, &trace(none.as_ref(), &rays).0);
    for rays in [&rays, &cut] {
        let expected = trace(none.as_ref(), rays);
        let hits = expected.0.iter().filter(|hit| hit.is_hit()).count();
        assert!(hits * 10 > rays.len(), "only {hits} of {} rays hit", rays.len());
        for (name, world) in &worlds[1..] {
            assert_equal(&format!("scene {seed}: {name}"), world.as_ref(), rays, &expected);
        }
    }
    rays.len() + cut.len()
}

/// Objects of all forms, many of them touching, some twice in the same place.
fn random_scene(seed: u64, scale: f64, numbers: Range<usize>) -> Scene {
    random_frame(seed, scale, numbers, 0)
}

/// The same, some frames later: one object in nine has moved, another one in each frame; one of the meshes is deformed
/// in every second frame.
fn random_frame(seed: u64, scale: f64, numbers: Range<usize>, frame: u64) -> Scene {
    let mut random = Random::new(&[seed]);
    let mut objects: Vec<Object> = numbers.map(|i| random_object(i, scale, &mut random)).collect();
    let doubled: Vec<_> = objects.iter().skip(2).step_by(7).cloned().collect();
    objects.extend(doubled);
    for moves in 1..=frame {
        for object in objects.iter_mut().skip(moves as usize % 9).step_by(9) {
            let mut vector = || random_point(&mut random).as_dvec3();
            let place = DAffine3::from_translation(0.4 * scale * vector());
            object.transform =
                place * DAffine3::from_quat(DQuat::from_scaled_axis(vector())) * object.transform;
        }
    }
    let mut meshes = [nasty_meshes::soup(), nasty_meshes::fan()];
    let shift = (frame / 2) as f32;
    for position in &mut meshes[0].positions {
        *position += 0.2 * shift * position.yzx();
    }
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
        meshes: meshes.iter().map(|mesh| MeshReference::new(mesh.name)).collect(),
        objects,
        lights: vec![],
    };
    Scene::new(&description, meshes.iter().map(mesh_data).collect()).unwrap()
}

fn mesh_data(mesh: &Mesh) -> Arc<MeshData> {
    Arc::new(MeshData::with_averaged_normals(mesh.positions.clone(), mesh.triangles.clone()))
}

fn random_object(index: usize, scale: f64, random: &mut Random) -> Object {
    let transform = random_transform(index, scale, random);
    match index % 5 {
        0 => {
            let (ball, transform) = Ball::transformed(DVec3::new(0.1, 0.0, -0.2), 0.6, &transform);
            Object::new(Single::Ball(ball), transform)
        }
        1 => Object::new(Single::Cylinder(Cylinder), transform),
        2 => {
            let corner = |()| (scale * 2.0 * random_point(random).as_dvec3()).as_vec3();
            let triangle = Triangle::new([(); 3].map(corner));
            Object::new(Single::Triangle(triangle), DAffine3::IDENTITY)
        }
        mesh => Object::new(Shape::Mesh { mesh: mesh - 3, normals: Normals::Flat }, transform),
    }
}

/// Nothing, moves, turns, mirrors, even and uneven scales, and shears made of both.
fn random_transform(index: usize, scale: f64, random: &mut Random) -> DAffine3 {
    let mut vector = || random_point(random).as_dvec3();
    let size = DAffine3::from_scale(DVec3::splat(scale));
    let place = DAffine3::from_translation(1.5 * vector());
    let turn = DAffine3::from_quat(DQuat::from_scaled_axis(3.0 * vector()));
    let stretch = DAffine3::from_scale(0.2 + 1.2 * vector().abs());
    let mirror = DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0));
    match index / 5 % 6 {
        0 => size,
        1 => size * place,
        2 => size * place * turn,
        3 => size * place * turn * stretch,
        4 => size * place * mirror * stretch,
        _ => size * place * stretch * turn * stretch,
    }
}

/// Rays from around the scene and from within it, many along the axes.
fn rays_into(scene: &Scene, seed: u64, count: usize) -> Vec<Ray> {
    let mut random = Random::new(&[seed, 1]);
    let bounds = scene.bounds();
    let (center, extent) = (Vec3::from(bounds.center()), bounds.size().length());
    (0..count)
        .map(|i| {
            let distance = [0.2, 0.6, 30.0][i % 3];
            let origin = center + distance * extent * random_point(&mut random);
            let target = center + 0.3 * extent * random_point(&mut random);
            let mut ray = Ray::new(origin, target - origin);
            if i % 4 == 0 {
                let axis = random.below(3) as usize;
                ray.dir = Vec3::splat([0.0, -0.0, 1e-38][i / 4 % 3]);
                ray.dir[axis] = (target - origin)[axis];
                for other in [(axis + 1) % 3, (axis + 2) % 3] {
                    ray.origin[other] = target[other];
                }
            }
            ray
        })
        .collect()
}
