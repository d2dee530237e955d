//! The record of a comparison as it grows, part by part: with what was measured before it was stopped.

use std::time::Instant;

use super::ComparisonResult;
use super::observer::Observer;
use super::plan::Plan;
use super::resume::{Before, STUDY, sweep_name};
use super::sampling_study::Study;
use super::scene::SceneResult;
use crate::record::{Comparison, SceneRecord, Sweep};

/// The record as it grows, part by part.
pub(super) struct RecordSoFar<'a> {
    plan: &'a Plan,
    observer: &'a dyn Observer,
    start: Instant,
    /// What was measured of each scene of the plan.
    scenes: Vec<Option<SceneRecord>>,
    /// Everything else.
    result: ComparisonResult,
    seconds_before: f64,
}

impl<'a> RecordSoFar<'a> {
    /// A record with what was measured before.
    pub(super) fn new(
        plan: &'a Plan,
        mut comparison: Comparison,
        observer: &'a dyn Observer,
        before: &Before<'_>,
        start: Instant,
    ) -> Self {
        let scenes: Vec<Option<SceneRecord>> =
            plan.scenes.iter().map(|input| before.scene(input).cloned()).collect();
        let done = &mut comparison.run.done;
        done.extend(scenes.iter().flatten().map(|scene| scene.name.clone()));
        if let Some(sweep) = plan.sweep.as_ref().and_then(|own| before.sweep(own.family.name())) {
            done.push(sweep_name(&sweep.mesh));
            comparison.sweeps.push(sweep.clone());
        }
        if let Some(study) = before.study().filter(|_| plan.sampling_study) {
            done.push(STUDY.to_owned());
            comparison.sampling = Some(study.clone());
        }
        let general = general_notes();
        let old_notes = before.notes().iter().filter(|note| !general.contains(note));
        comparison.notes.extend(old_notes.cloned());
        if let Some(begun) = before.run() {
            let now = std::mem::replace(&mut comparison.run.date, begun.date.clone());
            comparison.run.machine.load_at_start = begun.machine.load_at_start;
            comparison
                .notes
                .push(format!("The comparison was stopped, and gone on with at {now}."));
        }
        let result = ComparisonResult { comparison, pictures: Vec::new() };
        Self { plan, observer, start, scenes, result, seconds_before: before.seconds() }
    }

    /// What came of a scene, if it was begun.
    pub(super) fn add_scene(&mut self, name: &str, result: Option<SceneResult>) {
        let Some(result) = result else { return };
        let place = self.plan.scenes.iter().position(|scene| scene.name == *name);
        if let Some(slot) = place.and_then(|place| self.scenes.get_mut(place)) {
            *slot = Some(result.record);
        }
        self.result.pictures.extend(result.pictures);
        self.add_notes(result.notes);
        self.part_done(name.to_owned());
    }

    /// What came of the sweep, if it was begun.
    pub(super) fn add_sweep(&mut self, sweep: Option<Sweep>) {
        let Some(sweep) = sweep else { return };
        let name = sweep_name(&sweep.mesh);
        self.result.comparison.sweeps.push(sweep);
        self.part_done(name);
    }

    /// What came of the study, if it was begun.
    pub(super) fn add_study(&mut self, study: Option<Study>) {
        let Some(study) = study else { return };
        self.result.comparison.sampling = Some(study.chapter);
        self.add_notes(study.notes);
        self.part_done(STUDY.to_owned());
    }

    /// Notes, each once.
    fn add_notes(&mut self, notes: Vec<String>) {
        let all = &mut self.result.comparison.notes;
        for note in notes {
            if !all.contains(&note) {
                all.push(note);
            }
        }
    }

    /// Tells the observer of a part, unless it was cancelled: then the part is not done.
    fn part_done(&mut self, name: String) {
        if self.observer.cancelled() {
            return;
        }
        self.result.comparison.run.done.push(name);
        self.observer.part_done(&self.so_far(true));
    }

    /// All that was measured; what was measured before a stop is kept.
    fn so_far(&self, partial: bool) -> ComparisonResult {
        let mut result = self.result.clone();
        let run = &mut result.comparison.run;
        run.partial = partial;
        run.elapsed_seconds = self.seconds_before + self.start.elapsed().as_secs_f64();
        result.comparison.scenes = self.scenes.iter().flatten().cloned().collect();
        result.comparison.notes.extend(general_notes());
        result
    }

    /// All of it.
    pub(super) fn finish(self) -> ComparisonResult {
        self.so_far(self.observer.cancelled())
    }
}

fn general_notes() -> Vec<String> {
    vec![
        "Rays were replayed on one thread, in calls of 1024 as a renderer's waves send them, or of a \
         block where these are smaller."
            .into(),
        "The rays of a scene are the same whatever the budget. A structure that had no time for all \
         of them in every round traced a random, stratified sample of blocks of consecutive rays, \
         drawn anew for each round. Its times are estimates for all recorded rays, and their \
         intervals include the choice of the blocks."
            .into(),
    ]
}
