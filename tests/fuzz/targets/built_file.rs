//! A built scene whose checksums are made right → meshes, a compiled scene and a structure over it, which gives the
//! hits of none at all.
#![no_main]

use libfuzzer_sys::{fuzz_mutator, fuzz_target};
use srt::accel::{Answers, BuildConfig, Scratch};
use srt::built_file::{BuiltScene, Program};
use srt::math::{Hit, Ray};
use srt::scene::{Scene, TracedWorld, structure_named};
use srt_fuzz::{CountingAllocator, peak, right_checksums};

#[global_allocator]
static ALLOCATOR: CountingAllocator = CountingAllocator;

/// What reading may take whatever the size, for messages and buffers of all threads.
const ALWAYS: usize = 1 << 18;

/// And for each byte: an element of a list is larger in memory than in the file, and lists grow by doubling.
const FOR_EACH_BYTE: usize = 24;

/// Rays along each side of the picture.
const SIDE: u32 = 6;

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    srt_fuzz::mutate_floats(data, size, max_size, seed)
});

fuzz_target!(init: srt_fuzz::work_on_this_thread(), |data: &[u8]| {
    let program = Program { version: "fuzz".to_owned(), sources: [0; 32] };
    let read = |bytes: &[u8]| {
        let (built, used) = peak(|| read(&program, bytes));
        assert!(used <= ALWAYS + FOR_EACH_BYTE * bytes.len(), "{used} bytes for {}", bytes.len());
        built.map_err(|error| assert!(!error.is_empty())).ok()
    };
    // As they are: what is read without an error has the right checksums.
    let mut right = data.to_vec();
    right_checksums(&mut right);
    if read(data).is_some() {
        assert!(right == data, "a wrong checksum was taken");
    }
    let built = read(&right);
    srt_fuzz::count(built.is_some());
    if let Some((scene, world)) = built {
        compare(&scene, &*world);
    }
});

/// The scene and the structure over it, or what is wrong.
fn read(program: &Program, bytes: &[u8]) -> Result<(Scene, Box<dyn TracedWorld>), String> {
    let (mut input, size) = (bytes, bytes.len() as u64);
    let built = BuiltScene::read(program, &mut input, size).map_err(|error| error.to_string())?;
    let scene = Scene::read(built.meshes, &mut input, size).map_err(|error| error.to_string())?;
    let structure = structure_named(&built.structure).ok_or("there is no such structure")?;
    let world = structure.load(&scene, &mut input, size).map_err(|error| error.to_string())?;
    if input.is_empty() { Ok((scene, world)) } else { Err("it is longer".to_owned()) }
}

/// The structure gives the hits of none: closest ones, and whether there are any.
fn compare(scene: &Scene, world: &dyn TracedWorld) {
    let none = structure_named("none").expect("it is in the table");
    let Ok(none) = none.try_build(scene, &BuildConfig::default()) else { return };
    let camera = scene.camera.resized(SIDE, SIDE);
    let place = |i: u32| (f64::from(i % SIDE), f64::from(i / SIDE));
    let rays: Vec<Ray> = (0..SIDE * SIDE).map(|i| camera.ray(place(i).0, place(i).1)).collect();
    // Rays that are out of range, here or in an object's own space, have no defined hits.
    let in_range = |ray: &Ray| {
        let own = scene.objects.iter().filter_map(|object| scene.transform_of(object));
        let own: Vec<Ray> = own.map(|transform| transform.ray_to_object().apply(ray)).collect();
        let small = |v: glam::Vec3| v.is_finite() && v.abs().max_element() < 1e12;
        ray.check().is_ok() && own.iter().all(|own| small(own.origin) && small(own.dir))
    };
    let rays: Vec<Ray> = rays.into_iter().filter(in_range).collect();
    let trace = |world: &dyn TracedWorld| {
        let (mut hits, mut blocked) = (vec![Hit::MISS; rays.len()], vec![false; rays.len()]);
        let scratch = &mut Scratch::default();
        world.trace(&rays, Answers::ClosestHit(&mut hits), scratch, None);
        world.trace(&rays, Answers::AnyHit(&mut blocked), scratch, None);
        (hits, blocked)
    };
    let (hits, expected) = (trace(world), trace(&*none));
    assert!(hits.0.iter().zip(&expected.0).all(|(a, b)| a.same_bits(b)), "{hits:?} {expected:?}");
    assert_eq!(hits.1, expected.1);
}
