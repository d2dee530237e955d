//! All structures return the same hits, to the bit.
//!
//! The definition is `none`: every primitive, every ray. Every other structure must return the
//! same `(t, object, primitive, u, v)` and the same occlusion for rays of all kinds, on meshes of
//! all kinds, at scales from 10⁻⁶ to 10⁶. More than a million rays are compared.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

mod families;
mod scenes;

use glam::Vec3;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};
use srt::accel::{
    Accel, Allowed, Answers, BuildConfig, BuildOptions, Bvh8, Exhaustive, Indexed, OptionInfo,
    Quality, Scratch, Tracer,
};
use srt::assets::MeshData;
use srt::assets::generate::{MeshKind, generate};
use srt::conformance::adversarial_rays::{bundles_around, rays_at, rays_cut_at_hits};
use srt::conformance::axis_grids::grids_over;
use srt::conformance::nasty_meshes::{self, Mesh};
use srt::math::{Hit, Random, Ray};
use srt::scene::{STRUCTURES, Structure};
use srt::shapes::{TriangleMesh, TriangleSet};

/// How many of so many rays are traced: all on the best instruction set that the machine has, and a third where
/// `SRT_ISA` forces one, since the same tests run on all of them.
fn for_this_isa(rays: usize) -> usize {
    if std::env::var_os("SRT_ISA").is_some() { rays / 3 } else { rays }
}

/// The answers of a structure.
fn trace(tracer: &dyn Tracer, rays: &[Ray]) -> (Vec<Hit>, Vec<bool>) {
    let mut hits = vec![Hit::MISS; rays.len()];
    let mut blocked = vec![false; rays.len()];
    tracer.trace(rays, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
    tracer.trace(rays, Answers::AnyHit(&mut blocked), &mut Scratch::default(), None);
    (hits, blocked)
}

/// Fails with the first ray whose answers differ.
fn assert_equal(what: &str, tracer: &dyn Tracer, rays: &[Ray], expected: &(Vec<Hit>, Vec<bool>)) {
    let (hits, blocked) = trace(tracer, rays);
    for (i, ray) in rays.iter().enumerate() {
        assert!(
            hits[i].same_bits(&expected.0[i]) && blocked[i] == expected.1[i],
            "{what}: ray {i} {ray:?}\n  got      {:?}, blocked {}\n  expected {:?}, blocked {}",
            hits[i],
            blocked[i],
            expected.0[i],
            expected.1[i],
        );
    }
}

fn indexed<A: Accel>(mesh: &Mesh, quality: Quality) -> Indexed<TriangleSet, A> {
    let config = BuildConfig { quality, ..BuildConfig::default() };
    Indexed::build(TriangleMesh::new(&mesh.positions, &mesh.triangles), &config)
}

/// All structures of the table but the first, which is `none`, over a mesh, by name.
fn structures(mesh: &Mesh, qualities: &[Quality]) -> Vec<(String, Box<dyn Tracer>)> {
    let (none, others) = STRUCTURES.split_first().unwrap();
    assert_eq!(none.name, "none");
    let of = |structure: &Structure, quality: Quality| {
        (format!("{} {}", structure.name, quality.name()), over(structure, mesh, quality))
    };
    others.iter().flat_map(|one| qualities.iter().map(move |&quality| of(one, quality))).collect()
}

/// A structure of the table over a mesh.
fn over(structure: &Structure, mesh: &Mesh, quality: Quality) -> Box<dyn Tracer> {
    let config = BuildConfig { quality, ..BuildConfig::default() };
    let mesh = TriangleMesh::new(&mesh.positions, &mesh.triangles);
    structure.index(mesh, &config).expect("the table has no peers")
}

/// Compares all structures with `none` on one mesh; returns how many rays were compared.
fn compare_on(mesh: &Mesh, qualities: &[Quality], count: usize) -> usize {
    let none = indexed::<Exhaustive>(mesh, Quality::Medium);
    let structures = structures(mesh, qualities);
    let adversarial = rays_at(mesh, count, 99);
    let expected = trace(&none, &adversarial);
    let cut = rays_cut_at_hits(&adversarial, &expected.0);
    let expected_of_cut = trace(&none, &cut);
    let bundles = bundles_around(&adversarial[..count / 64]);
    let expected_of_bundles = trace(&none, &bundles);
    for (rays, expected) in
        [(&adversarial, &expected), (&cut, &expected_of_cut), (&bundles, &expected_of_bundles)]
    {
        assert_all_equal(mesh, &structures, rays, expected);
    }
    adversarial.len() + cut.len() + bundles.len()
}

/// Fails with the first ray to which the structures give other answers than `none`.
fn assert_all_equal(
    mesh: &Mesh,
    structures: &[(String, Box<dyn Tracer>)],
    rays: &[Ray],
    expected: &(Vec<Hit>, Vec<bool>),
) {
    for (hit, blocked) in expected.0.iter().zip(&expected.1) {
        assert_eq!(hit.is_hit(), *blocked, "{}: closest and any hit disagree", mesh.name);
    }
    for (name, structure) in structures {
        assert_equal(&format!("{}: {name}", mesh.name), structure.as_ref(), rays, expected);
    }
}

#[test]
fn meshes_of_all_kinds_at_all_scales() {
    let rays = for_this_isa(36_000);
    // The scale changes how numbers round; the quality, what the tree looks like. Trees of all
    // qualities are compared at one scale, and those of one quality at all.
    let (all, one) = ([Quality::Fastest, Quality::Medium, Quality::Slowest], [Quality::Medium]);
    let places: [(f32, Vec3, &[Quality]); 4] = [
        (1.0, Vec3::ZERO, &all),
        (1e6, Vec3::ZERO, &one),
        (1e-6, Vec3::ZERO, &one),
        (1e3, Vec3::splat(1e6), &one),
    ];
    let meshes = nasty_meshes::all();
    let cases: Vec<_> = meshes.iter().flat_map(|mesh| places.map(|place| (mesh, place))).collect();
    let compared: usize = cases
        .par_iter()
        .with_max_len(1)
        .map(|&(mesh, (scale, offset, qualities))| {
            compare_on(&mesh.moved(scale, offset), qualities, rays)
        })
        .sum();
    println!("{compared} rays compared, 0 differ");
    assert!(compared >= for_this_isa(1_000_000), "only {compared} rays were compared");
}

/// Directions of any finite length, as long as `t` is a number at all: where it is below the normal
/// numbers, a step of it is a long way.
#[test]
fn rays_of_any_finite_length() {
    const LENGTHS: [f32; 8] = [1e-38, 1e-25, 1e15, 1e25, 1e30, 1e35, 1e37, 2e38];
    let meshes = [nasty_meshes::lattice(), nasty_meshes::soup(), nasty_meshes::single()];
    let mut below_normal = 0;
    for (mesh, scale) in meshes.iter().flat_map(|mesh| [1.0, 1e-3, 1e-9, 1e6].map(|s| (mesh, s))) {
        let mesh = mesh.moved(scale, Vec3::ZERO);
        let none = indexed::<Exhaustive>(&mesh, Quality::Medium);
        let structures = structures(&mesh, &[Quality::Medium]);
        let mut rays = rays_at(&mesh, 4_000, 5);
        for (i, ray) in rays.iter_mut().enumerate() {
            ray.dir = LENGTHS[i / 12 % 8] * ray.dir.as_dvec3().normalize_or_zero().as_vec3();
            assert!(ray.check().is_ok());
        }
        let expected = trace(&none, &rays);
        let cut = rays_cut_at_hits(&rays, &expected.0);
        let hits = expected.0.iter().filter(|hit| hit.is_hit());
        below_normal += hits.filter(|hit| hit.t < f32::MIN_POSITIVE).count();
        assert_all_equal(&mesh, &structures, &rays, &expected);
        assert_all_equal(&mesh, &structures, &cut, &trace(&none, &cut));
    }
    assert!(below_normal > 1_000, "{below_normal}");
}

#[test]
fn grids_along_the_axes() {
    let places =
        [(1.0, Vec3::ZERO), (1e6, Vec3::ZERO), (1e-6, Vec3::ZERO), (1e3, Vec3::splat(1e6))];
    let meshes = nasty_meshes::all();
    let cases: Vec<_> = meshes.iter().flat_map(|mesh| places.map(|place| (mesh, place))).collect();
    let side = for_this_isa(24).max(16);
    let hits: usize = cases
        .par_iter()
        .with_max_len(1)
        .map(|&(mesh, (scale, offset))| {
            let mesh = mesh.moved(scale, offset);
            let structures = structures(&mesh, &[Quality::Medium]);
            let none = indexed::<Exhaustive>(&mesh, Quality::Medium);
            let grids = grids_over(&mesh, side, 23);
            let expected = trace(&none, &grids);
            assert_all_equal(&mesh, &structures, &grids, &expected);
            let cut = rays_cut_at_hits(&grids, &expected.0);
            assert_all_equal(&mesh, &structures, &cut, &trace(&none, &cut));
            cut.len()
        })
        .sum();
    println!("{hits} rays along an axis hit");
    assert!(hits > for_this_isa(100_000), "only {hits} rays hit");
}

#[test]
fn closest_hits_are_hits_of_the_triangle_they_name() {
    // The oracle itself against the closed form: the point lies on the ray and in the plane.
    let mesh = nasty_meshes::soup();
    let none = indexed::<Exhaustive>(&mesh, Quality::Medium);
    let rays = rays_at(&mesh, 5_000, 5);
    let (hits, _) = trace(&none, &rays);
    let mut checked = 0;
    for (ray, hit) in rays.iter().zip(&hits).filter(|(_, hit)| hit.is_hit()) {
        let [a, b, c] =
            mesh.triangles[hit.prim as usize].map(|i| mesh.positions[i as usize].as_dvec3());
        let on_ray = ray.origin.as_dvec3() + f64::from(hit.t) * ray.dir.as_dvec3();
        let inside = a + f64::from(hit.u) * (b - a) + f64::from(hit.v) * (c - a);
        let normal = (b - a).cross(c - a).normalize();
        let cosine = normal.dot(ray.dir.as_dvec3().normalize()).abs();
        if cosine > 0.1 && ray.origin.length() < 10.0 {
            assert!((on_ray - inside).length() < 1e-4, "{ray:?} {hit:?}");
            checked += 1;
        }
    }
    assert!(checked > 500, "{checked}");
}

#[test]
fn a_deep_tree_after_a_shallow_one_on_the_same_thread() {
    // The kernels keep their stacks from call to call, and a deeper tree needs higher ones.
    let soup = nasty_meshes::soup();
    let few = Mesh { triangles: soup.triangles[..3].to_vec(), ..nasty_meshes::soup() };
    for mesh in [&few, &soup, &few] {
        let rays = rays_at(mesh, 2_000, 11);
        let expected = trace(&indexed::<Exhaustive>(mesh, Quality::Medium), &rays);
        let tree = indexed::<Bvh8>(mesh, Quality::Medium);
        assert_equal("bvh8", &tree, &rays, &expected);
    }
}

#[test]
fn a_tree_too_deep_for_the_stacks_of_the_kernels() {
    // Each triangle's box holds all smaller ones, so that clustering takes them in one by one: a
    // chain. On the way to its end all leaves but one wait on the stack, of which `bvh8`'s kernels
    // have 128 entries. Deeper trees are searched by streams of rays, and one by one.
    let mesh = nasty_meshes::nested();
    let options = BuildOptions::of::<Bvh8>("builder=ploc").unwrap();
    let config = BuildConfig { quality: Quality::Fastest, options, ..BuildConfig::default() };
    let set = TriangleSet::new(&mesh.positions, &mesh.triangles);
    let tree = Indexed::<_, Bvh8>::build(set, &config);
    let shape = tree.shape();
    println!("{shape:?}");
    assert_eq!(u64::from(shape.depth), shape.nodes, "a chain");
    assert!(shape.leaves > 128, "{} leaves", shape.leaves);
    let none = indexed::<Exhaustive>(&mesh, Quality::Medium);
    let rays = rays_at(&mesh, 20_000, 17);
    let bundles = bundles_around(&rays[..1_000]);
    for rays in [&rays, &bundles] {
        let expected = trace(&none, rays);
        assert!(expected.1.iter().filter(|&&blocked| blocked).count() > rays.len() / 4);
        assert_equal("bvh8", &tree, rays, &expected);
        for (ray, hit) in rays.iter().zip(&expected.0) {
            let alone = tree.hit(ray);
            assert!(alone.same_bits(hit), "{ray:?}: {alone:?}, expected {hit:?}");
        }
    }
}

/// Beyond the caches of a core waves have more rays, and beyond those of a processor they prefetch.
#[test]
fn meshes_larger_than_caches() {
    for (triangles, megabytes, count) in [(320_000, 8, 1_200), (1_800_000, 32, 300)] {
        let MeshData { positions, triangles, .. } = generate(MeshKind::Terrain, triangles, 1);
        let mesh = Mesh { name: "terrain", positions, triangles };
        let (tree, none) = (
            indexed::<Bvh8>(&mesh, Quality::Medium),
            indexed::<Exhaustive>(&mesh, Quality::Medium),
        );
        assert!(tree.bytes() + tree.primitives().bytes() > megabytes << 20);
        let mut random = Random::new(&[43, megabytes]);
        let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
        let rays: Vec<Ray> = (0..for_this_isa(count))
            .map(|_| Ray::new(Vec3::new(2.0, 2.0, 1.0) * point(), point()))
            .collect();
        let expected = trace(&none, &rays);
        let hits = expected.0.iter().filter(|hit| hit.is_hit()).count();
        assert!(hits > rays.len() / 8 && hits < rays.len(), "{hits} hits");
        assert_equal("bvh8", &tree, &rays, &expected);
    }
}

#[test]
fn an_empty_mesh_is_never_hit() {
    let mesh = nasty_meshes::empty("empty");
    let rays = [Ray::new(Vec3::ZERO, Vec3::X)];
    for structure in STRUCTURES {
        let tracer = over(structure, &mesh, Quality::Medium);
        assert_eq!(trace(tracer.as_ref(), &rays), (vec![Hit::MISS], vec![false]));
    }
}

/// All values of an option that has few; of a number, the ends and some between.
fn values(option: &OptionInfo) -> Vec<String> {
    match option.allowed {
        Allowed::Words(words) => words.iter().map(|word| (*word).to_owned()).collect(),
        Allowed::Numbers(least, most) => {
            let mut some = vec![least, least + 1, least.midpoint(most), most];
            some.dedup();
            some.iter().map(ToString::to_string).collect()
        }
    }
}

/// The structure with every value of each option, and with every pair of values of two.
fn with_options(structure: &Structure) -> Vec<Structure> {
    let given: Vec<Vec<String>> = structure
        .offered_options()
        .map(|option| values(option).iter().map(|v| format!("{}={v}", option.name)).collect())
        .collect();
    let mut texts: Vec<String> = given.concat();
    for (i, one) in given.iter().enumerate() {
        for other in &given[i + 1..] {
            texts.extend(one.iter().flat_map(|a| other.iter().map(move |b| format!("{a},{b}"))));
        }
    }
    texts.iter().map(|text| structure.with_options(text).unwrap()).collect()
}

#[test]
fn options_change_no_hit() {
    let meshes = [nasty_meshes::lattice(), nasty_meshes::soup(), nasty_meshes::single()];
    let chosen: Vec<Structure> = STRUCTURES.iter().flat_map(with_options).collect();
    assert!(chosen.len() > 30, "only {} choices", chosen.len());
    meshes.par_iter().for_each(|mesh| {
        let rays = rays_at(mesh, for_this_isa(1_500), 31);
        let none = indexed::<Exhaustive>(mesh, Quality::Medium);
        let expected = trace(&none, &rays);
        for structure in &chosen {
            for quality in [Quality::Fastest, Quality::Medium, Quality::Slowest] {
                let what = format!("{}: {} {}", mesh.name, structure.name, quality.name());
                assert_equal(&what, over(structure, mesh, quality).as_ref(), &rays, &expected);
            }
        }
    });
}

/// Several leaves refer to a triangle, each by a part of its box.
#[test]
fn boxes_that_are_cut_change_no_hit() {
    let offers = |structure: &&Structure| structure.with_options("builder=sbvh").is_ok();
    let cut: Vec<Structure> = STRUCTURES
        .iter()
        .filter(offers)
        .map(|one| one.with_options("builder=sbvh").unwrap())
        .collect();
    assert_eq!(cut.len(), 3, "bvh, cwbvh and bvh8");
    let mut meshes = nasty_meshes::all();
    for kind in [MeshKind::Hall, MeshKind::Hair, MeshKind::Soup] {
        let MeshData { positions, triangles, .. } = generate(kind, 1_500, 1);
        meshes.push(Mesh { name: kind.name(), positions, triangles });
    }
    let copies = meshes.par_iter().map(|mesh| {
        let mut copies = 0;
        for (scale, offset) in [(1.0, Vec3::ZERO), (1e-6, Vec3::ZERO), (1e3, Vec3::splat(1e6))] {
            let mesh = mesh.moved(scale, offset);
            let rays = rays_at(&mesh, for_this_isa(3_000), 37);
            let none = indexed::<Exhaustive>(&mesh, Quality::Medium);
            let expected = trace(&none, &rays);
            let rays_cut = rays_cut_at_hits(&rays, &expected.0);
            let expected_of_cut = trace(&none, &rays_cut);
            for structure in &cut {
                let what = format!("{}: {}", mesh.name, structure.name);
                let tree = over(structure, &mesh, Quality::Medium);
                assert_equal(&what, tree.as_ref(), &rays, &expected);
                assert_equal(&what, tree.as_ref(), &rays_cut, &expected_of_cut);
            }
            let options = BuildOptions::of::<Bvh8>("builder=sbvh").unwrap();
            let config = BuildConfig { options, ..BuildConfig::default() };
            let set = TriangleSet::new(&mesh.positions, &mesh.triangles);
            let shape = Indexed::<_, Bvh8>::build(set, &config).shape();
            let slots = (0..).zip(&shape.leaf_sizes).map(|(size, leaves)| size * leaves);
            copies += slots.sum::<u64>() - mesh.triangles.len() as u64;
        }
        copies
    });
    let copies: u64 = copies.sum();
    assert!(copies > 500, "{copies}");
}
