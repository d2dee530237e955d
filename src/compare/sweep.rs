//! How cost grows with the number of triangles: a family of generated meshes, built and traced.
//!
//! A structure leaves at the size at which not even a few rays of a class fit into its share of
//! the time, and the record says so: linear ones leave first. Slopes are computed from the record.

use std::sync::Arc;
use std::time::Duration;

use glam::{DAffine3, DVec3};

use crate::accel::BuildConfig;
use crate::assets::generate::{MeshKind, generate};
use crate::description::{
    Camera, Light, Material, MeshReference, Normals, Object, Options, SceneDescription, Shape,
};
use crate::math::Color;
use crate::record::{Dropped, Status, StructureProof, Sweep, SweepPoint};
use crate::render::Settings;
use crate::scene::{Scene, SceneError, Structure, structure_named};

use super::budget::Budget;
use super::clock::nanoseconds;
use super::entrant::Entrant;
use super::plan::{Plan, SweepPlan};
use super::progress::Progress;
use super::record_rays::{Limits, RaySet, record};
use super::replay::{probe_all, replay, time_of_all};
use super::scene::{Stage, base_name};
use super::{Pools, proof};

/// Side of the picture whose rays are recorded.
const SIDE: u32 = 200;

/// Comparing hits takes about this share of a size's time.
const SHARE_OF_PROOF: f64 = 0.1;

/// Builds and traces all sizes.
pub(super) fn sweep(
    sweep: &SweepPlan,
    structures: &[Structure],
    plan: &Plan,
    pools: &Pools,
    budget: Budget,
    progress: &Progress<'_>,
) -> Sweep {
    let mut record = Sweep { mesh: sweep.mesh.name().to_owned(), ..Sweep::default() };
    let mut left: Vec<&Structure> = structures.iter().collect();
    for (done, &size) in sweep.sizes.iter().enumerate() {
        if progress.cancelled() || left.is_empty() {
            break;
        }
        progress.step(&format!("{} of {size} triangles", sweep.mesh), budget);
        let Ok(scene) = pools.all.install(|| scene_of(sweep.mesh, size, plan.picture.seed)) else {
            continue;
        };
        let cancelled = || progress.cancelled();
        let base = base_name(structures);
        let stage = Stage { scene: &scene, plan, pools, base, cancelled: &cancelled };
        let share = budget.share(share_of_first(&sweep.sizes[done..]));
        let entrants = measure(&left, &stage, share, &mut record.rays_checked);
        let triangles = scene.triangle_count();
        left.retain(|structure| {
            let own = entrants.iter().find(|entrant| entrant.structure.name == structure.name);
            own.is_none_or(|own| note(&mut record, own, triangles))
        });
    }
    record
}

/// The first size's share of the time for all that are left: larger meshes take longer to make and
/// to build, though not to trace.
fn share_of_first(sizes: &[u32]) -> f64 {
    let weights = sizes.iter().map(|&size| f64::from(size).sqrt());
    let first = weights.clone().next().unwrap_or(1.0);
    first / weights.sum::<f64>()
}

/// One size, traced by the structures that are left.
fn measure<'a>(
    left: &[&'a Structure],
    stage: &Stage<'_>,
    budget: Budget,
    rays_checked: &mut u64,
) -> Vec<Entrant<'a>> {
    let sets = rays(stage, budget);
    let mut entrants: Vec<Entrant<'_>> = left.iter().map(|&s| Entrant::new(s)).collect();
    for entrant in &mut entrants {
        stage.pools.all.install(|| entrant.build(stage.scene, &stage.plan.build));
    }
    let times: Vec<_> = entrants.iter_mut().map(|entrant| probe_all(entrant, &sets)).collect();
    *rays_checked += compare_hits(&mut entrants, &sets, &times, budget);
    for (done, set) in sets.iter().enumerate() {
        if (stage.cancelled)() {
            entrants.iter_mut().for_each(Entrant::stop);
            break;
        }
        let times: Vec<_> = times.iter().map(|times| times[done]).collect();
        let share = budget.share(1.0 / (sets.len() - done) as f64);
        replay(&mut entrants, set, &times, stage, share);
    }
    entrants
}

/// Compares all answers with those of the quickest structure of this program, on as many rays as
/// there is time for, and gives their number. Who differs is not timed.
fn compare_hits(
    entrants: &mut [Entrant<'_>],
    sets: &[RaySet],
    times: &[Vec<Option<Duration>>],
    budget: Budget,
) -> u64 {
    let held = |i: &usize| entrants[*i].is_fit() && !entrants[*i].structure.peer;
    let reference = (0..entrants.len()).filter(held).min_by_key(|i| {
        let known = structure_named(entrants[*i].structure.base_name()).is_some();
        (!known, time_of_all(&times[*i], sets))
    });
    let Some(reference) = reference else { return 0 };
    let lanes = 2.0 * (entrants.len() * sets.len().max(1)) as f64;
    let share = budget.left().mul_f64(SHARE_OF_PROOF / lanes).max(proof::LEAST_SHARE);
    let expected = proof::expected(&mut entrants[reference], sets, &times[reference], share);
    let mut checked = 0;
    for (index, entrant) in entrants.iter_mut().enumerate() {
        if index == reference || entrant.structure.peer {
            continue;
        }
        let mut own = StructureProof::default();
        proof::check_rays(entrant, &expected, &times[index], share, &mut own);
        checked += own.rays_checked;
        if let Some(text) = own.first_difference {
            entrant.fail(format!("its answers differ: {text}"));
        }
    }
    checked
}

/// The rays of a small rendering.
fn rays(stage: &Stage<'_>, budget: Budget) -> Vec<RaySet> {
    let Some(guide) = structure_named("bvh") else { return Vec::new() };
    let Stage { scene, plan, pools, cancelled, .. } = *stage;
    let guide = pools.all.install(|| guide.build(scene, &BuildConfig::default()));
    let limits = Limits {
        per_class: plan.rays_per_class,
        traced: (budget.left().as_secs_f64() * 50_000.0).clamp(5e4, 1e6) as u64,
    };
    let settings = Settings { seed: plan.picture.seed, ..Settings::of_scene(scene) };
    let recording = pools.one.install(|| record(scene, &*guide, &settings, limits, cancelled));
    let mut sets = recording.sets;
    sets.retain(|set| plan.classes.contains(&set.class));
    sets
}

/// Adds what a structure did at a size; whether it goes on to the next.
fn note(record: &mut Sweep, entrant: &Entrant<'_>, triangles: u64) -> bool {
    let report = entrant.report().unwrap_or_default();
    let name = entrant.structure.name;
    for class in &entrant.record.classes {
        record.points.push(SweepPoint {
            triangles,
            structure: name.to_owned(),
            class: class.class,
            rays: class.rays,
            rounds: class.rounds.clone(),
            build_ns: nanoseconds(report.time),
            index_bytes: report.objects.bytes + report.meshes.bytes,
        });
    }
    let reason = match &entrant.record.status {
        Status::Ok => return true,
        Status::Failed { message } => message.clone(),
        Status::TooSlow { after_seconds } => {
            format!(
                "a few rays take longer than its share of the time, {after_seconds:.3} s a round"
            )
        }
        Status::Stopped => "the comparison was stopped".to_owned(),
    };
    let failed = matches!(entrant.record.status, Status::Failed { .. }) && !entrant.structure.peer;
    record.dropped.push(Dropped { structure: name.to_owned(), triangles, reason, failed });
    false
}

/// A mesh of the family, its materials half a mirror, seen from where all of it is before the eye.
fn scene_of(kind: MeshKind, triangles: u32, seed: u64) -> Result<Scene, Vec<SceneError>> {
    // The hall is seen from inside, lit below its ceiling.
    let (eye, target, light) = match kind {
        MeshKind::Hall => {
            (DVec3::new(-0.95, -0.05, 0.35), DVec3::new(0.5, 0.0, 0.35), DVec3::Z * 0.7)
        }
        _ => (DVec3::new(0.3, -3.2, 1.4), DVec3::ZERO, DVec3::new(-3.0, -2.0, 4.0)),
    };
    let description = SceneDescription {
        camera: Camera {
            eye,
            direction: target - eye,
            up: DVec3::Z,
            distance: 1.0,
            fovy_degrees: if kind == MeshKind::Hall { 70.0 } else { 38.0 },
            width: SIDE,
            height: SIDE,
        },
        options: Options { max_recursion: 1, aa: 0, background: Color::ZERO },
        materials: vec![Material { specular: Color::splat(0.3), ..Material::default() }],
        meshes: vec![MeshReference::new(kind.name())],
        objects: vec![Object::new(
            Shape::Mesh { mesh: 0, normals: Normals::Flat },
            DAffine3::IDENTITY,
        )],
        lights: vec![Light::Point { position: light, color: Color::ONE }],
    };
    Scene::new(&description, vec![Arc::new(generate(kind, triangles, seed))])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_family_is_in_view() {
        for kind in MeshKind::ALL {
            let scene = scene_of(kind, 2_000, 1).unwrap();
            let world = structure_named("bvh").unwrap().build(&scene, &BuildConfig::default());
            let settings = Settings { width: 40, height: 40, ..Settings::of_scene(&scene) };
            let stats = crate::render::render(&scene, &*world, &settings, &crate::render::Silent);
            let view = stats.stats.class(crate::render::RayClass::View);
            assert!(10 * view.hits > view.rays, "{kind}: {view:?}");
        }
    }
}
