//! Structures are saved and loaded: what was saved is loaded again, and whatever else the bytes
//! hold, loading ends with an error or with a structure that returns the hits of its primitives.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use std::io::{self, Read};
use std::ops::{ControlFlow, Range};

use srt::accel::{
    Accel, Answers, Bounded, BoundingBall, Build, BuildConfig, BuildOptions, Built, Bvh, Bvh8,
    CompressedWideBvh, Decoder, Encoder, Exhaustive, Indexed, LoadError, Portable, Quality,
    Scratch, Slots, StructureShape, Tracer,
};
use srt::conformance::adversarial_rays::{bundles_around, rays_at, rays_cut_at_hits};
use srt::conformance::nasty_meshes::{self, Mesh};
use srt::counters::Counters;
use srt::glam::Vec3;
use srt::math::{BoxRay, Hit, Ray};
use srt::shapes::{TriangleMesh, TriangleSet};

type Triangles<A> = Indexed<TriangleSet, A>;

fn built<A: Portable>(mesh: &Mesh, quality: Quality) -> Triangles<A> {
    let config = BuildConfig { quality, ..BuildConfig::default() };
    Indexed::build(TriangleMesh::new(&mesh.positions, &mesh.triangles), &config)
}

fn saved<A: Portable>(index: &Triangles<A>) -> Vec<u8> {
    let mut bytes = Vec::new();
    index.save(&mut bytes).unwrap();
    bytes
}

fn load<A: Portable>(bytes: &[u8]) -> Result<Triangles<A>, LoadError> {
    Indexed::load(bytes)
}

fn trace(tracer: &dyn Tracer, rays: &[Ray]) -> (Vec<Hit>, Vec<bool>) {
    let (mut hits, mut blocked) = (vec![Hit::MISS; rays.len()], vec![false; rays.len()]);
    let scratch = &mut Scratch::default();
    tracer.trace(rays, Answers::ClosestHit(&mut hits), scratch, None);
    tracer.trace(rays, Answers::AnyHit(&mut blocked), scratch, None);
    (hits, blocked)
}

fn assert_same(a: &dyn Tracer, b: &dyn Tracer, rays: &[Ray]) {
    let (a, b) = (trace(a, rays), trace(b, rays));
    for (ray, (a, b)) in rays.iter().zip(a.0.iter().zip(&b.0)) {
        assert!(a.same_bits(b), "{ray:?}: {a:?} and {b:?}");
    }
    assert_eq!(a.1, b.1);
}

/// Rays of all kinds at a mesh; there is something to aim at even where it is empty.
fn rays_of_all_kinds(mesh: &Mesh, count: usize) -> Vec<Ray> {
    let target = if mesh.triangles.is_empty() { nasty_meshes::single() } else { mesh.clone() };
    let mut rays = rays_at(&target, count, 17);
    rays.extend(bundles_around(&rays[..count / 64]));
    let (hits, _) = trace(&built::<Exhaustive>(mesh, Quality::Medium), &rays);
    rays.extend(rays_cut_at_hits(&rays.clone(), &hits));
    rays
}

/// What a structure looks like, but for the memory that it was built in.
fn shape<A: Portable>(index: &Triangles<A>) -> StructureShape {
    StructureShape { bytes: 0, ..index.shape() }
}

fn check_round_trip<A: Portable>() {
    let mut meshes = nasty_meshes::all();
    meshes.push(nasty_meshes::empty("empty"));
    // With debug assertions, obvhs does not build a compressed tree as deep as that of this mesh.
    let is_too_deep = |mesh: &&Mesh| {
        cfg!(debug_assertions) && A::NAME == CompressedWideBvh::NAME && mesh.name == "nested"
    };
    for mesh in meshes.iter().filter(|mesh| !is_too_deep(mesh)) {
        let rays = rays_of_all_kinds(mesh, 416);
        for quality in [Quality::Fastest, Quality::Medium, Quality::Slow] {
            let index = built::<A>(mesh, quality);
            let bytes = saved(&index);
            let loaded = load::<A>(&bytes).unwrap();
            assert_eq!(shape(&index), shape(&loaded), "{}", mesh.name);
            assert_eq!(index.tree(), loaded.tree(), "{}", mesh.name);
            assert_eq!(bytes, saved(&loaded), "{}", mesh.name);
            assert_same(&index, &loaded, &rays);
        }
    }
}

#[test]
fn none_is_loaded_as_it_was_saved() {
    check_round_trip::<Exhaustive>();
}

#[test]
fn a_ball_is_loaded_as_it_was_saved() {
    check_round_trip::<BoundingBall>();
}

#[test]
fn bvh_is_loaded_as_it_was_saved() {
    check_round_trip::<Bvh>();
}

#[test]
fn cwbvh_is_loaded_as_it_was_saved() {
    check_round_trip::<CompressedWideBvh>();
}

#[test]
fn bvh8_is_loaded_as_it_was_saved() {
    check_round_trip::<Bvh8>();
}

/// A few triangles, in several leaves.
fn few() -> Mesh {
    let mut mesh = nasty_meshes::soup();
    mesh.triangles.truncate(20);
    mesh
}

#[test]
fn several_structures_follow_each_other() {
    let mesh = few();
    let (first, second) =
        (built::<Bvh>(&mesh, Quality::Medium), built::<Bvh8>(&mesh, Quality::Medium));
    let bytes = [saved(&first), saved(&second), vec![7]].concat();
    let mut rest = &bytes[..];
    assert_eq!(saved(&Triangles::<Bvh>::load(&mut rest).unwrap()), saved(&first));
    assert_eq!(saved(&Triangles::<Bvh8>::load(&mut rest).unwrap()), saved(&second));
    assert_eq!(rest, [7]);
}

#[test]
fn what_is_something_else_is_called_by_its_name() {
    let error = |bytes: &[u8]| load::<Bvh8>(bytes).unwrap_err().to_string();
    let of_bvh = saved(&built::<Bvh>(&few(), Quality::Medium));
    assert_eq!(error(&of_bvh), "the saved structure is `bvh`, not `bvh8`");
    let mut of_bvh8 = saved(&built::<Bvh8>(&few(), Quality::Medium));
    assert_eq!(error(b"v 0 0 0\nv 1 0 0\n"), "this is not a saved structure");
    assert_eq!(error(&of_bvh8[..5]), "a saved structure ends too early");
    of_bvh8[8] = 4;
    let version = "a saved structure has version 4 of the format, and only 3 can be read";
    assert_eq!(error(&of_bvh8), version);
    let unreadable = Triangles::<Bvh8>::load(Unreadable).unwrap_err();
    assert!(matches!(unreadable, LoadError::Unreadable(_)));
}

struct Unreadable;

impl Read for Unreadable {
    fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
        Err(std::io::Error::other("out of order"))
    }
}

/// The checksum of lists, written anew from its description: XXH64.
fn xxh64(bytes: &[u8]) -> u64 {
    const P: [u64; 5] = [
        11_400_714_785_074_694_791,
        14_029_467_366_897_019_727,
        1_609_587_929_392_839_161,
        9_650_029_242_287_828_579,
        2_870_177_450_012_600_261,
    ];
    let word = |at: usize| u64::from_le_bytes(*bytes[at..].first_chunk().unwrap());
    let round = |sum: u64, word: u64| {
        sum.wrapping_add(word.wrapping_mul(P[1])).rotate_left(31).wrapping_mul(P[0])
    };
    let (mut at, mut hash) = (0, P[4]);
    if bytes.len() >= 32 {
        let mut sums = [P[0].wrapping_add(P[1]), P[1], 0, P[0].wrapping_neg()];
        while at + 32 <= bytes.len() {
            for sum in &mut sums {
                *sum = round(*sum, word(at));
                at += 8;
            }
        }
        let turned = sums.iter().zip([1, 7, 12, 18]).map(|(sum, turn)| sum.rotate_left(turn));
        hash = turned.fold(0, u64::wrapping_add);
        for sum in sums {
            hash = (hash ^ round(0, sum)).wrapping_mul(P[0]).wrapping_add(P[3]);
        }
    }
    hash = hash.wrapping_add(bytes.len() as u64);
    while at + 8 <= bytes.len() {
        hash ^= round(0, word(at));
        hash = hash.rotate_left(27).wrapping_mul(P[0]).wrapping_add(P[3]);
        at += 8;
    }
    if at + 4 <= bytes.len() {
        let word = u32::from_le_bytes(*bytes[at..].first_chunk().unwrap());
        hash ^= u64::from(word).wrapping_mul(P[0]);
        hash = hash.rotate_left(23).wrapping_mul(P[1]).wrapping_add(P[2]);
        at += 4;
    }
    assert_eq!(at, bytes.len(), "lists consist of words");
    hash = (hash ^ (hash >> 33)).wrapping_mul(P[1]);
    hash = (hash ^ (hash >> 29)).wrapping_mul(P[2]);
    hash ^ (hash >> 32)
}

/// The checksum at the end, written anew from its description: FNV-1a over all bytes before it but
/// those of lists.
fn fnv(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xCBF2_9CE4_8422_2325, |sum, &byte| {
        (sum ^ u64::from(byte)).wrapping_mul(0x100_0000_01B3)
    })
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(*bytes[at..].first_chunk().unwrap())
}

/// Where the number of primitives is.
fn count_at(bytes: &[u8]) -> usize {
    let name_end = 13 + usize::from(bytes[12]);
    name_end + 1 + usize::from(bytes[name_end])
}

/// The bytes of a saved structure with the checksums that they should have, as far as its lists can
/// be found: each of so few elements that it has one checksum.
fn with_checksums(mut bytes: Vec<u8>) -> Vec<u8> {
    let end = bytes.len() - 8;
    let name = bytes[13..13 + usize::from(bytes[12])].to_vec();
    let mut loose = Vec::new();
    let (mut before, mut at) = (0, count_at(&bytes));
    let sizes = [
        36,
        4,
        match &name[..] {
            b"bvh" => 64,
            b"bvh8" => 224,
            b"cwbvh" => 80,
            _ => 0,
        },
    ];
    for (list, size) in sizes.into_iter().enumerate().filter(|(_, size)| *size > 0) {
        let length = u32_at(&bytes, at) as usize;
        // Behind the number of triangles is the mean of their vertices; a single leaf is no list.
        let sum_at = at + 4 + if list == 0 { 12 } else { 0 };
        let list_end = length.checked_mul(size).map(|size| sum_at + 8 + size);
        let Some(list_end) = list_end.filter(|list_end| *list_end <= end && length > 0) else {
            break;
        };
        let sum = xxh64(&bytes[sum_at + 8..list_end]);
        bytes[sum_at..sum_at + 8].copy_from_slice(&sum.to_le_bytes());
        loose.extend_from_slice(&bytes[before..sum_at + 8]);
        (before, at) = (list_end, list_end);
    }
    loose.extend_from_slice(&bytes[before..end]);
    bytes[end..].copy_from_slice(&fnv(&loose).to_le_bytes());
    bytes
}

#[test]
fn the_checksums_are_those_that_are_described() {
    let saved_bytes = [
        saved(&built::<Exhaustive>(&few(), Quality::Medium)),
        saved(&built::<Bvh>(&few(), Quality::Medium)),
        saved(&built::<CompressedWideBvh>(&few(), Quality::Medium)),
        saved(&built::<Bvh8>(&few(), Quality::Medium)),
    ];
    for bytes in saved_bytes {
        assert_eq!(with_checksums(bytes.clone()), bytes);
    }
}

/// Each byte changed in several ways.
fn damaged(bytes: &[u8]) -> impl Iterator<Item = (usize, Vec<u8>)> {
    let changes = [0x01, 0x02, 0x10, 0x80, 0xFF];
    (0..bytes.len()).flat_map(move |place| {
        changes.map(|change| {
            let mut bytes = bytes.to_vec();
            bytes[place] ^= change;
            (place, bytes)
        })
    })
}

fn check_damage<A: Portable>() {
    let bytes = saved(&built::<A>(&few(), Quality::Medium));
    assert!(load::<A>(&bytes).is_ok());
    for (place, bytes) in damaged(&bytes) {
        assert!(load::<A>(&bytes).is_err(), "byte {place}");
    }
    for length in 0..bytes.len() {
        let error = load::<A>(&bytes[..length]).err().unwrap();
        assert!(matches!(error, LoadError::Truncated), "{length} bytes: {error}");
    }
}

#[test]
fn a_changed_byte_or_a_missing_one_is_an_error() {
    check_damage::<Exhaustive>();
    check_damage::<BoundingBall>();
    check_damage::<Bvh>();
    check_damage::<CompressedWideBvh>();
    check_damage::<Bvh8>();
}

/// The same primitives and no structure: the bytes up to the order of slots, which is replaced by
/// that of the ids.
fn without_structure(bytes: &[u8]) -> Triangles<Exhaustive> {
    let name_end = 13 + usize::from(bytes[12]);
    let count_at = count_at(bytes);
    let count = u32_at(bytes, count_at);
    let order_at = count_at + 4 + 12 + 8 + 36 * count as usize;
    let slots = count.next_multiple_of(8);
    let order =
        (0..slots).flat_map(|slot| (if slot < count { slot } else { u32::MAX }).to_le_bytes());
    let mut exhaustive = [&bytes[..12], b"\x04none", &bytes[name_end..order_at]].concat();
    exhaustive.extend(slots.to_le_bytes());
    exhaustive.extend([0; 8]);
    exhaustive.extend(order);
    exhaustive.extend([0; 8]);
    load(&with_checksums(exhaustive)).unwrap()
}

/// Bytes that were made to be loaded: their checksum is right, and what they say is not.
fn check_forgeries<A: Portable>() {
    let mesh = few();
    let rays = rays_of_all_kinds(&mesh, 128);
    let bytes = saved(&built::<A>(&mesh, Quality::Medium));
    let (mut loaded, mut refused) = (0, 0);
    for (_, bytes) in damaged(&bytes[..bytes.len() - 8]) {
        let bytes = with_checksums([bytes, vec![0; 8]].concat());
        match load::<A>(&bytes) {
            Ok(index) => {
                assert_same(&without_structure(&bytes), &index, &rays);
                assert_eq!(saved(&load::<A>(&saved(&index)).unwrap()), saved(&index));
                loaded += 1;
            }
            Err(_) => refused += 1,
        }
    }
    // A moved vertex that stays within its boxes is one that can be loaded.
    assert!(loaded > 10 && refused > 100, "{loaded} loaded, {refused} refused");
}

#[test]
fn forged_balls_are_errors_or_right() {
    check_forgeries::<BoundingBall>();
}

#[test]
fn forged_binary_trees_are_errors_or_right() {
    check_forgeries::<Bvh>();
}

#[test]
fn forged_compressed_trees_are_errors_or_right() {
    check_forgeries::<CompressedWideBvh>();
}

#[test]
fn forged_wide_trees_are_errors_or_right() {
    check_forgeries::<Bvh8>();
}

/// No structure, but the bytes of a binary tree with a node for each primitive, below each other, and all primitives
/// in a leaf of each node.
struct Repeating(u32);

impl Accel for Repeating {
    fn build(primitives: &impl Bounded, _: &mut Build<'_>) -> Built<Self> {
        Built { accel: Self(primitives.count()), order: None }
    }

    fn traverse<C: Counters>(
        &self,
        _: &Ray,
        _: &BoxRay,
        _: &mut C,
        _: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
    }

    fn bytes(&self) -> u64 {
        0
    }
}

impl Portable for Repeating {
    const NAME: &'static str = Bvh::NAME;

    fn write(&self, out: &mut Encoder<'_>) -> io::Result<()> {
        let &Self(count) = self;
        let [low, high] = [-1e6_f32, 1e6].map(f32::to_bits);
        let side = |slots: u32, first: u32| [low, low, low, high, high, high, slots, first];
        out.u32(count)?;
        out.list(&(1..=count).collect::<Vec<_>>(), |&next| {
            let last = if next < count { side(0, next) } else { side(count, 0) };
            let sides = [side(count, 0), last];
            std::array::from_fn::<_, 16, _>(|word| sides[word / 8][word % 8])
        })
    }

    fn read(_: &impl Bounded, _: Slots<'_>, _: &mut Decoder<'_>) -> Result<Self, LoadError> {
        unreachable!("it is written only")
    }
}

/// To look at all primitives of all leaves would take many minutes.
#[test]
fn leaves_that_repeat_primitives_are_refused_at_once() {
    let count = 1 << 18;
    let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
    let mesh =
        Mesh { name: "repeated", positions: positions.to_vec(), triangles: vec![[0, 1, 2]; count] };
    let bytes = saved(&built::<Repeating>(&mesh, Quality::Medium));
    let error = load::<Bvh>(&bytes).unwrap_err().to_string();
    assert_eq!(error, "a saved structure is not valid: slot 0 is in two leaves");
}

#[test]
fn trees_that_copy_triangles_are_refused() {
    let mesh = nasty_meshes::soup();
    let options = BuildOptions::of::<Bvh8>("builder=sbvh").unwrap();
    let config = BuildConfig { options, ..BuildConfig::default() };
    let set = TriangleSet::new(&mesh.positions, &mesh.triangles);
    let index: Triangles<Bvh8> = Indexed::build(set, &config);
    let error = index.save(&mut Vec::new()).unwrap_err();
    assert_eq!(error.kind(), std::io::ErrorKind::Unsupported);
    assert!(error.to_string().contains("leaves share primitives"), "{error}");
}
