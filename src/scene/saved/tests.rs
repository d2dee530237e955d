use super::*;
use crate::description::{MeshReference, SceneDescription};

/// A scene of every shape, with transforms, and lights of both kinds.
fn scene() -> Scene {
    let (ball, place) = Ball::transformed(DVec3::X, 2.0, &DAffine3::IDENTITY);
    let triangle = Triangle { corners: [Vec3::ZERO, Vec3::X, Vec3::Y] };
    let turned = DAffine3::from_rotation_z(0.3) * DAffine3::from_scale(DVec3::new(1.0, 2.0, 3.0));
    let mesh = |normals| Shape::Mesh { mesh: 0, normals };
    let objects = [
        (Single::Ball(ball).into(), place),
        (mesh(Normals::Flat), turned),
        (Single::Cylinder(Cylinder).into(), turned),
        (Single::Triangle(triangle).into(), DAffine3::IDENTITY),
        (mesh(Normals::Interpolated), DAffine3::IDENTITY),
    ];
    let color = Color::new(0.1, 0.2, 0.3);
    let glass = Material { alpha: 0.25, refractive_index: 1.5, ..Material::default() };
    let description = SceneDescription {
        camera: description::Camera {
            eye: DVec3::new(0.1, -5.0, 0.2),
            direction: DVec3::Y,
            up: DVec3::Z,
            distance: 1.0,
            fovy_degrees: 40.0,
            width: 40,
            height: 30,
        },
        options: Options { max_recursion: 3, aa: 2, background: color },
        materials: vec![Material::default(), glass],
        meshes: vec![MeshReference::new("a.obj")],
        objects: objects
            .into_iter()
            .enumerate()
            .map(|(place, (shape, transform))| description::Object {
                material: place % 2,
                ..description::Object::new(shape, transform)
            })
            .collect(),
        lights: vec![
            description::Light::Point { position: DVec3::ONE, color },
            description::Light::Area {
                center: DVec3::Z,
                half_u: DVec3::X,
                half_v: DVec3::Y,
                color,
            },
        ],
    };
    let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
    let mesh = MeshData::with_averaged_normals(positions, vec![[0, 1, 2]]);
    Scene::new(&description, vec![Arc::new(mesh)]).unwrap()
}

fn written(scene: &Scene) -> Vec<u8> {
    let mut bytes = Vec::new();
    scene.write(&mut bytes).unwrap();
    bytes
}

fn read(scene: &Scene, mut bytes: &[u8]) -> Result<Scene, LoadError> {
    let size = bytes.len() as u64;
    Scene::read(scene.meshes().to_vec(), &mut bytes, size)
}

#[test]
fn what_is_written_is_read_and_nothing_behind_it() {
    let scene = scene();
    let mut bytes = written(&scene);
    let length = bytes.len();
    bytes.extend(b"the structure");
    let mut rest = &bytes[..];
    let again = Scene::read(scene.meshes().to_vec(), &mut rest, 1 << 20).unwrap();
    assert_eq!(rest, b"the structure");
    assert_eq!(again.geometry_hash(), scene.geometry_hash());
    assert_eq!(
        (&again.materials, &again.lights, again.options),
        (&scene.materials, &scene.lights, scene.options)
    );
    let of_objects = |scene: &Scene| {
        let of = |object: &Object| (object.shape, object.material, object.corners);
        scene.objects.iter().map(of).collect::<Vec<_>>()
    };
    assert_eq!(of_objects(&again), of_objects(&scene));
    assert_eq!(again.camera.description(), scene.camera.description());
    assert!(written(&again) == bytes[..length], "the same bytes");
}

#[test]
fn every_byte_counts() {
    let scene = scene();
    let bytes = written(&scene);
    for place in 0..bytes.len() {
        for change in [0x01, 0x80] {
            let mut altered = bytes.clone();
            altered[place] ^= change;
            assert!(read(&scene, &altered).is_err(), "byte {place}");
        }
        assert!(read(&scene, &bytes[..place]).is_err(), "{place} bytes");
    }
}

/// What was made to be read: the checksums are right, and the scene is not.
#[test]
fn a_scene_that_names_what_is_not_there_is_refused() {
    let error = |change: &dyn Fn(&mut Scene)| {
        let mut wrong = scene();
        change(&mut wrong);
        read(&scene(), &written(&wrong)).unwrap_err().to_string()
    };
    let is = |what: &str| format!("a saved structure is not valid: {what}");
    let not_there = is("an object names what is not there");
    assert_eq!(error(&|scene| scene.objects[0].material = 2), not_there);
    assert_eq!(error(&|scene| scene.objects[1].transform = 2), not_there);
    let mesh = Shape::Mesh { mesh: 1, normals: Normals::Flat };
    assert_eq!(error(&|scene| scene.objects[1].shape = mesh), not_there);
    assert_eq!(error(&|scene| scene.objects[1].corners[0].x = f32::NAN), not_there);
    assert_eq!(
        error(&|scene| scene.options.aa = Options::MAX_AA + 1),
        is("an option is out of its range")
    );
    let flat = DAffine3::from_scale(DVec3::new(1.0, 0.0, 1.0));
    assert_eq!(
        error(&|scene| scene.transforms = Transforms::of_invertible(vec![flat; 2])),
        is("a transform has no inverse")
    );
}
