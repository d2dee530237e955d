//! One scene: all structures, one step after the other.

use std::time::Duration;

use crate::accel::{BuildConfig, Tracer};
use crate::image_io::Picture;
use crate::record::{Proof, RayClass, SceneRecord, StructureProof};
use crate::render::Settings;
use crate::scene::{Scene, Structure, structure_named};

use super::budget::Budget;
use super::entrant::Entrant;
use super::plan::{Plan, SceneInput};
use super::progress::Progress;
use super::record_rays::{Limits, Recording, record};
use super::{
    Pools, agreement, builds, extra_rays, picture_steps, pictures, proof, quality, replay,
};

/// What all steps of a scene share.
pub(super) struct Stage<'a> {
    pub(super) scene: &'a Scene,
    pub(super) plan: &'a Plan,
    pub(super) pools: &'a Pools,
    /// The structure that ratios are taken to, where it has time.
    pub(super) base: &'a str,
    pub(super) cancelled: &'a (dyn Fn() -> bool + Sync),
}

/// What came of a scene.
pub(super) struct SceneOutcome {
    pub(super) record: SceneRecord,
    /// Pictures by the names of their files.
    pub(super) pictures: Vec<(String, Picture)>,
    /// What a reader should know of it.
    pub(super) notes: Vec<String>,
}

/// The scene while it is being compared.
pub(super) struct Work<'a> {
    pub(super) stage: Stage<'a>,
    pub(super) input: &'a SceneInput,
    pub(super) entrants: Vec<Entrant<'a>>,
    recording: Recording,
    /// For each structure, the time of a ray of each class of the recording.
    ray_times: Vec<Vec<Option<Duration>>>,
    pub(super) outcome: SceneOutcome,
}

/// Compares structures in a scene.
pub(super) fn compare_scene(
    input: &SceneInput,
    structures: &[Structure],
    plan: &Plan,
    pools: &Pools,
    budget: Budget,
    progress: &Progress<'_>,
) -> SceneOutcome {
    let cancelled = || progress.cancelled();
    let base = base_name(structures);
    let stage = Stage { scene: &input.scene, plan, pools, base, cancelled: &cancelled };
    let mut work = Work {
        stage,
        input,
        entrants: structures.iter().map(Entrant::new).collect(),
        recording: Recording::default(),
        ray_times: Vec::new(),
        outcome: empty(input),
    };
    for (what, step) in steps() {
        if progress.cancelled() {
            work.entrants.iter_mut().for_each(Entrant::stop);
            break;
        }
        progress.step(&format!("{}: {what}", input.name), budget);
        step(&mut work, budget);
    }
    if progress.cancelled() {
        work.entrants.iter_mut().for_each(Entrant::stop);
    }
    let mut outcome = work.outcome;
    outcome.record.structures = work.entrants.into_iter().map(|entrant| entrant.record).collect();
    outcome
}

/// The structure that ratios are taken to: `none` if it is among them, else the first.
pub(super) fn base_name(structures: &[Structure]) -> &'static str {
    let none = structures.iter().find(|structure| structure.name == "none");
    none.or(structures.first()).map_or("", |base| base.name)
}

/// A step of a scene, and what it is called.
type Step<'a> = (&'static str, fn(&mut Work<'a>, Budget));

/// What is done in a scene: first what proves, then what measures.
fn steps<'a>() -> [Step<'a>; 8] {
    [
        ("building", |work, _| builds::build_all(&mut work.entrants, &work.stage)),
        ("recording rays", Work::record),
        ("comparing hits", Work::prove_hits),
        ("rendering", Work::render),
        ("drawing heatmaps", Work::draw_heatmaps),
        ("measuring overlap", Work::measure_overlap),
        ("timing builds", |work, budget| {
            builds::measure(&mut work.entrants, &work.stage, budget.share(0.25));
        }),
        ("timing rays", Work::replay),
    ]
}

fn empty(input: &SceneInput) -> SceneOutcome {
    let record = SceneRecord {
        name: input.name.clone(),
        path: input.path.clone(),
        hash: input.hash.clone(),
        objects: input.scene.objects.len() as u64,
        triangles: input.scene.triangle_count(),
        stored_triangles: input.scene.stored_triangle_count(),
        lights: input.scene.lights.len() as u64,
        ..SceneRecord::default()
    };
    SceneOutcome { record, pictures: Vec::new(), notes: Vec::new() }
}

impl Work<'_> {
    pub(super) fn settings(&self) -> Settings {
        self.stage.plan.picture.settings(self.stage.scene)
    }

    /// Records the rays, and takes a quick look at how long each structure needs for them.
    fn record(&mut self, budget: Budget) {
        let Stage { scene, plan, pools, cancelled, .. } = self.stage;
        // Any structure that keeps the contract will do, so a known one traces.
        let Some(guide) = structure_named("bvh") else { return };
        let guide = pools.all.install(|| guide.build(scene, &BuildConfig::default()));
        let guide: &dyn Tracer = &*guide;
        let limits = Limits {
            per_class: plan.rays_per_class,
            traced: (budget.left().as_secs_f64() * 100_000.0).clamp(1e5, 2e6) as u64,
        };
        let settings = self.settings();
        let seed = settings.seed;
        self.recording = pools.one.install(|| record(scene, guide, &settings, limits, cancelled));
        if plan.classes.contains(&RayClass::Diffuse)
            && let Some(view) = self.recording.sets.iter().find(|set| set.class == RayClass::View)
        {
            let diffuse = extra_rays::diffuse(scene, guide, &view.rays, seed);
            self.recording.sets.push(diffuse);
        }
        if plan.classes.contains(&RayClass::Random) {
            let count = plan.rays_per_class.min(50_000);
            self.recording.sets.push(extra_rays::random(scene, count, seed));
        }
        self.recording.sets.retain(|set| !set.rays.is_empty());
        let sets = &self.recording.sets;
        let probe_all = |entrant: &mut Entrant<'_>| replay::probe_all(entrant, sets);
        self.ray_times = self.entrants.iter_mut().map(probe_all).collect();
    }

    /// Measures end-point overlaps, if there is time left: they are no part of what is compared.
    fn measure_overlap(&mut self, budget: Budget) {
        if budget.is_spent() {
            self.outcome.notes.push(format!(
                "{}: there was no time left to measure end-point overlaps.",
                self.input.name
            ));
            return;
        }
        quality::add_overlap(&mut self.entrants, &self.stage);
    }

    /// How long each structure needs for so many view samples and all that follows.
    pub(super) fn estimates(&self, samples: f64) -> Vec<Option<Duration>> {
        let threads = self.stage.plan.threads;
        let times = self.ray_times.iter().zip(&self.entrants);
        times
            .map(|(times, entrant)| {
                let times = entrant.is_fit().then_some(times)?;
                pictures::estimate(&self.recording, times, samples, threads)
            })
            .collect()
    }

    /// Compares all answers with the reference's: `none`, if it has time for a picture; else the
    /// first structure that has, of this program if there is one; else the quickest.
    fn prove_hits(&mut self, budget: Budget) {
        let fit = pictures::that_fit(
            &self.with_builds(&self.estimates(self.samples())),
            picture_steps::picture_budget(budget).left(),
        );
        let held = |i: &usize| !self.entrants[*i].structure.peer;
        let none = fit.iter().copied().find(|&i| self.entrants[i].structure.name == "none");
        // A structure of this program rather than one that somebody is trying out.
        let unknown =
            |i: &usize| structure_named(self.entrants[*i].structure.base_name()).is_none();
        let quick = || fit.iter().copied().filter(held).min_by_key(unknown);
        let is_fit = |i: &usize| held(i) && self.entrants[*i].is_fit();
        // Where no one has time for a picture, the quickest answers most rays.
        let time = |i: &usize| replay::time_of_all(&self.ray_times[*i], &self.recording.sets);
        let all = || (0..self.entrants.len()).filter(is_fit);
        let any = || all().min_by_key(|i| (unknown(i), time(i)));
        let Some(reference) = none.or_else(quick).or_else(any) else { return };
        let classes = self.recording.sets.len().max(1) as f64;
        let lanes = 2.0 * self.entrants.len() as f64;
        let share = budget.left().mul_f64(0.1 / lanes / classes).max(proof::LEAST_SHARE);
        let times = &self.ray_times;
        let sets = &self.recording.sets;
        let expected =
            proof::expected(&mut self.entrants[reference], sets, &times[reference], share);
        let thin = expected.iter().any(|class| !class.is_whole());
        let (mut proofs, mut peers) = (Vec::new(), Vec::new());
        for (entrant, times) in self.entrants.iter_mut().zip(times) {
            let structure = entrant.structure.name.to_owned();
            if (self.stage.cancelled)() {
                break;
            }
            if entrant.structure.peer {
                peers.extend(agreement::check(entrant, &expected, times, share));
                continue;
            }
            let mut proof = StructureProof { structure, ..StructureProof::default() };
            proof::check_rays(entrant, &expected, times, share, &mut proof);
            if let Some(text) = &proof.first_difference {
                entrant.fail(format!("its answers differ: {text}"));
            }
            if proof.rays_checked > 0 {
                proofs.push(proof);
            }
        }
        let name = self.entrants[reference].structure.name.to_owned();
        let mut proof = Proof { reference: name, witness: None, structures: proofs, peers };
        if thin && !(self.stage.cancelled)() {
            self.prove_by_witness(reference, &mut proof, share);
        }
        self.outcome.record.proof = Some(proof);
    }

    /// Compares all answers with those of a structure that agreed with the reference on the few
    /// rays for which that had time, and has time for all. Few rays meet few primitives, and
    /// whoever loses some of the others would not be caught by them.
    fn prove_by_witness(&mut self, reference: usize, proof: &mut Proof, share: Duration) {
        let sets = &self.recording.sets;
        let is_quick = |&i: &usize| {
            sets.iter().zip(&self.ray_times[i]).all(|(set, time)| {
                let all = |time: Duration| time.as_secs_f64() * set.rays.len() as f64;
                time.is_some_and(|time| all(time) <= share.as_secs_f64())
            })
        };
        let agreed = |name: &str| proof.structure(name).is_some_and(|own| own.rays_checked > 0);
        let of_srt = |structure: &Structure| {
            !structure.peer && structure_named(structure.base_name()).is_some()
        };
        let witness = (0..self.entrants.len())
            .filter(|&i| i != reference && self.entrants[i].is_fit() && is_quick(&i))
            .filter(|&i| of_srt(self.entrants[i].structure))
            .find(|&i| agreed(self.entrants[i].structure.name));
        let Some(witness) = witness else { return };
        let times = &self.ray_times;
        let expected = proof::expected(&mut self.entrants[witness], sets, &times[witness], share);
        for (index, (entrant, times)) in self.entrants.iter_mut().zip(times).enumerate() {
            let name = entrant.structure.name;
            let entry = proof.structures.iter_mut().find(|entry| entry.structure == name);
            let Some(entry) = entry.filter(|_| index != reference && index != witness) else {
                continue;
            };
            let mut own = StructureProof::default();
            proof::check_rays(entrant, &expected, times, share, &mut own);
            // The rays that the reference answered are among these.
            entry.rays_checked = entry.rays_checked.max(own.rays_checked);
            entry.differing_hits = entry.differing_hits.max(own.differing_hits);
            if let Some(text) = own.first_difference {
                entrant.fail(format!("its answers differ: {text}"));
                entry.first_difference.get_or_insert(text);
            }
        }
        proof.witness = Some(self.entrants[witness].structure.name.to_owned());
    }

    /// Replays every class.
    fn replay(&mut self, budget: Budget) {
        let classes = &self.stage.plan.classes;
        let wanted: Vec<usize> = (0..self.recording.sets.len())
            .filter(|&i| classes.contains(&self.recording.sets[i].class))
            .collect();
        for (done, &index) in wanted.iter().enumerate() {
            if (self.stage.cancelled)() {
                return;
            }
            let times: Vec<_> = self.ray_times.iter().map(|times| times[index]).collect();
            let share = budget.share(1.0 / (wanted.len() - done) as f64);
            let set = &self.recording.sets[index];
            replay::replay(&mut self.entrants, set, &times, &self.stage, share);
        }
    }
}
