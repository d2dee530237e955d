//! The fourth step: renders the scene's picture with all structures that have the time, in interleaved
//! rounds from the build to the picture, and compares the pictures.

use std::time::Instant;

use crate::compare::budget::Budget;
use crate::compare::candidate::{Candidate, position};
use crate::compare::clock::{nanoseconds, timed};
use crate::compare::context::SceneContext;
use crate::compare::panics::catch_panic;
use crate::compare::picture_size::fit_pixels;
use crate::compare::proof::check_picture;
use crate::compare::render_picture::{colors, render_until, render_whole};
use crate::compare::rounds::interleaved;
use crate::image_io::Picture;
use crate::record::{PictureRound, Proof};
use crate::render::Settings;

use super::picture_times::{PictureTimes, picture_budget, view_samples};
use super::recording::SceneRays;

/// The least side of a picture that proves anything.
const LEAST_SIDE: u32 = 8;

/// Pictures that take more than so many times their budget are cancelled.
const MOST_BUDGETS: u32 = 3;

/// Small pictures take this much longer than their estimates, to be on the safe side.
const MARGIN: f64 = 1.5;

/// What was rendered.
#[derive(Default)]
pub(super) struct Rendered {
    /// The reference's picture.
    pub(super) picture: Option<Picture>,
    /// What a reader should know of it.
    pub(super) notes: Vec<String>,
}

/// Renders, times and compares. Without a proof of equal hits nothing is compared.
pub(super) fn render_all(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    rays: &SceneRays,
    proof: Option<&mut Proof>,
    budget: Budget,
) -> Rendered {
    let budget = picture_budget(budget);
    let settings = context.picture_settings();
    let times =
        PictureTimes::of_builds_and_renderings(context, candidates, rays, &settings, budget);
    let mut rendered = Rendered::default();
    rendered.notes.extend(times.note_missing(candidates, "picture"));
    let pictures = measure(context, candidates, &times.fit, &settings, budget.share(0.5));
    if let Some(proof) = proof {
        rendered.picture = compare_pictures(candidates, pictures, proof);
        let budget = budget.share(0.3);
        let small = compare_small_pictures(context, candidates, &settings, &times, proof, budget);
        rendered.notes.extend(small);
    }
    rendered
}

/// Builds and renders in interleaved rounds with some of the structures; the picture of each.
fn measure(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    fit: &[usize],
    settings: &Settings,
    budget: Budget,
) -> Vec<Option<Picture>> {
    let mut pictures: Vec<Option<Picture>> = vec![None; candidates.len()];
    let repeat = context.rounds_after_warmup(budget);
    let (start, longest) = (Instant::now(), budget.left().saturating_mul(MOST_BUDGETS));
    let stop = || (context.cancelled)() || start.elapsed() > longest;
    let rounds = interleaved(fit.len(), &repeat, |task, _| {
        let candidate = &mut candidates[fit[task]];
        let work = || {
            let build = || candidate.structure.build(context.scene, &context.plan.build);
            let (world, build) = timed(build);
            (render_until(&stop, context.scene, &*world, settings), build)
        };
        match context.pools.all.install(|| catch_panic(work)) {
            Ok((rendering, build)) if rendering.complete => {
                let render_ns = nanoseconds(rendering.stats.time);
                if pictures[fit[task]].is_none() {
                    pictures[fit[task]] = colors(rendering.image);
                }
                let round = PictureRound { build_ns: build.wall_ns, render_ns };
                Some((round, round.build_ns.saturating_add(render_ns)))
            }
            Ok(_) => None,
            Err(message) => {
                candidate.fail(message);
                None
            }
        }
    });
    for (task, rounds) in rounds.into_iter().enumerate() {
        candidates[fit[task]].record.picture_rounds = rounds;
    }
    pictures
}

/// Compares the pictures, and returns the reference's, or the first if the reference has none.
fn compare_pictures(
    candidates: &mut [Candidate<'_>],
    mut pictures: Vec<Option<Picture>>,
    proof: &mut Proof,
) -> Option<Picture> {
    let of_reference = position(candidates, &proof.reference).filter(|&i| pictures[i].is_some());
    let first = || (0..pictures.len()).find(|&i| !candidates[i].is_peer() && pictures[i].is_some());
    let reference = of_reference.or_else(first)?;
    let expected = pictures[reference].clone()?;
    for entry in &mut proof.structures {
        if let Some(index) = position(candidates, &entry.structure)
            && let Some(own) = &pictures[index]
        {
            check_picture(&mut candidates[index], &expected, own, entry);
        }
    }
    pictures[reference].take()
}

/// Structures that have no time for the whole picture render a small one, and so does the
/// reference. Returns a note for each.
fn compare_small_pictures(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    settings: &Settings,
    times: &PictureTimes,
    proof: &mut Proof,
    budget: Budget,
) -> Vec<String> {
    let mut notes = Vec::new();
    let is_left = |i: &usize| !candidates[*i].is_peer() && !times.fit.contains(i);
    let left: Vec<usize> = (0..candidates.len()).filter(is_left).collect();
    for (done, &index) in left.iter().enumerate() {
        let Some(time) = times.times[index] else { continue };
        let share = budget.share(1.0 / (left.len() - done) as f64).left();
        let samples = view_samples(settings) * share.as_secs_f64() / time.as_secs_f64().max(1e-9);
        let settings = smaller(settings, samples / MARGIN);
        let reference = position(candidates, &proof.reference).filter(|&i| i != index);
        let Some(reference) = reference else { continue };
        if settings.width.min(settings.height) < LEAST_SIDE {
            continue;
        }
        let mut render =
            |i: usize| render_whole(context, &mut candidates[i], &settings).and_then(colors);
        let (Some(expected), Some(own)) = (render(reference), render(index)) else { continue };
        let name = candidates[index].name();
        let Settings { width, height, .. } = settings;
        notes.push(format!("`{name}` was compared on a picture of {width} × {height} pixels."));
        if let Some(entry) = proof.structures.iter_mut().find(|e| e.structure == name) {
            check_picture(&mut candidates[index], &expected, &own, entry);
            // The hash is that of the whole picture, which it did not render.
            entry.picture_hash = None;
        }
    }
    notes
}

/// The picture with one ray through each pixel's centre, of about so many pixels.
fn smaller(picture: &Settings, samples: f64) -> Settings {
    let [width, height] = fit_pixels([picture.width, picture.height], samples);
    Settings { width, height, aa: 0, ..picture.clone() }
}
