//! A scene's pictures: rendered by all that have the time, compared, and coloured by cost.

use std::time::Duration;

use crate::image_io::Picture;
use crate::render::Settings;

use super::budget::Budget;
use super::entrant::Entrant;
use super::plan::fit;
use super::scene::Work;
use super::{pictures, proof};

/// The least side of a picture that proves anything.
const LEAST_SIDE: u32 = 8;

/// The file of a scene's picture.
pub(crate) fn picture_name(scene: &str) -> String {
    format!("{scene}.png")
}

/// The file of a structure's heatmap of a scene. The marks between a structure's options mean
/// something else in addresses of pages; dots are in no name of a structure.
pub(crate) fn heatmap_name(scene: &str, structure: &str) -> String {
    format!("{scene}-heatmap-{}.png", structure.replace([':', ',', '='], "."))
}

impl Work<'_> {
    /// View samples of the picture.
    pub(super) fn samples(&self) -> f64 {
        let settings = self.settings();
        f64::from(settings.width)
            * f64::from(settings.height)
            * f64::from(settings.samples_per_pixel())
    }

    /// Renders the picture with all structures that have the time, and compares.
    pub(super) fn render(&mut self, budget: Budget) {
        let budget = picture_budget(budget);
        let settings = self.settings();
        let estimates = self.estimates(self.samples());
        let fit = pictures::that_fit(&self.with_builds(&estimates), budget.left());
        self.note_missing(&fit, &estimates, "picture");
        let all =
            pictures::measure(&mut self.entrants, &fit, &settings, &self.stage, budget.share(0.5));
        self.compare_pictures(&all);
        self.compare_small_pictures(&fit, &estimates, budget.share(0.3));
    }

    /// Times of pictures with those of the builds before them: a round of the picture builds anew.
    pub(super) fn with_builds(&self, pictures: &[Option<Duration>]) -> Vec<Option<Duration>> {
        let with_build = |(entrant, time): (&Entrant<'_>, &Option<Duration>)| {
            Some((*time)?.saturating_add(entrant.report()?.time))
        };
        self.entrants.iter().zip(pictures).map(with_build).collect()
    }

    /// Compares the pictures, and keeps the reference's.
    fn compare_pictures(&mut self, all: &[Option<Picture>]) {
        let Some(proof) = &mut self.outcome.record.proof else { return };
        let named = |name: &str| self.entrants.iter().position(|e| e.structure.name == name);
        let reference = named(&proof.reference).and_then(|i| all[i].clone());
        let held = self.entrants.iter().zip(all).filter(|(e, _)| !e.structure.peer);
        let any = || held.filter_map(|(_, picture)| picture.clone()).next();
        let Some(reference) = reference.or_else(any) else { return };
        let mut differing = Vec::new();
        for entry in &mut proof.structures {
            if let Some(own) = named(&entry.structure).and_then(|i| all[i].as_ref()) {
                proof::check_picture(&reference, own, entry);
                if entry.picture_equal == Some(false) {
                    let index = named(&entry.structure);
                    differing.extend(index.map(|i| (i, entry.differing_pixels)));
                }
            }
        }
        for (index, pixels) in differing {
            self.entrants[index].fail(format!("its picture differs in {pixels} pixels"));
        }
        let file = picture_name(&self.input.name);
        self.outcome.record.picture = Some(pictures::picture_file(file.clone(), &reference));
        self.outcome.pictures.push((file, reference));
    }

    /// Structures that have no time for the whole picture render a small one, and so does the
    /// reference.
    fn compare_small_pictures(
        &mut self,
        fit: &[usize],
        estimates: &[Option<Duration>],
        budget: Budget,
    ) {
        let held = |i: &usize| !self.entrants[*i].structure.peer && !fit.contains(i);
        let left: Vec<usize> = (0..self.entrants.len()).filter(held).collect();
        for (done, &index) in left.iter().enumerate() {
            let Some(time) = estimates[index] else { continue };
            let share = budget.share(1.0 / (left.len() - done) as f64).left();
            let samples = self.samples() * share.as_secs_f64() / time.as_secs_f64().max(1e-9);
            let settings = smaller(&self.settings(), samples / 1.5);
            let name = self.entrants[index].structure.name;
            let Some(proof) = &self.outcome.record.proof else { return };
            let reference = self.entrants.iter().position(|e| e.structure.name == proof.reference);
            let Some(reference) = reference.filter(|&i| i != index) else { continue };
            if settings.width.min(settings.height) < LEAST_SIDE {
                continue;
            }
            let render = |this: &mut Self, i: usize| {
                pictures::render_once(&mut this.entrants[i], &settings, &this.stage)
            };
            let (Some(expected), Some(own)) = (render(self, reference), render(self, index)) else {
                continue;
            };
            self.note_small(name, &settings);
            let Some(proof) = &mut self.outcome.record.proof else { return };
            if let Some(entry) = proof.structures.iter_mut().find(|e| e.structure == name) {
                proof::check_picture(&expected, &own, entry);
                // The hash is that of the whole picture, which it did not render.
                entry.picture_hash = None;
                if entry.picture_equal == Some(false) {
                    let pixels = entry.differing_pixels;
                    self.entrants[index].fail(format!("its picture differs in {pixels} pixels"));
                }
            }
        }
    }

    fn note_small(&mut self, name: &str, settings: &Settings) {
        self.outcome.notes.push(format!(
            "{}: `{name}` was compared on a picture of {} × {} pixels.",
            self.input.name, settings.width, settings.height,
        ));
    }

    pub(super) fn draw_heatmaps(&mut self, budget: Budget) {
        let settings = pictures::heat_settings(&self.settings());
        let samples = f64::from(settings.width) * f64::from(settings.height);
        let estimates = self.estimates(samples);
        let mut fit = pictures::that_fit(&estimates, budget.share(0.2).left());
        self.note_missing(&fit, &estimates, "heatmap");
        // Peers count no tests.
        fit.retain(|&i| !self.entrants[i].structure.peer);
        let (scale, maps) = pictures::heatmaps(&mut self.entrants, &fit, &settings, &self.stage);
        self.outcome.record.heat_scale = scale;
        for (index, picture) in maps {
            let entrant = &mut self.entrants[index];
            let file = heatmap_name(&self.input.name, entrant.structure.name);
            entrant.record.heatmap = Some(pictures::picture_file(file.clone(), &picture));
            self.outcome.pictures.push((file, picture));
        }
    }

    /// One sentence of all that had no time for a picture.
    fn note_missing(&mut self, fit: &[usize], estimates: &[Option<Duration>], what: &str) {
        let missing = |(index, entrant): (usize, &Entrant<'_>)| {
            let time = estimates[index].filter(|_| !fit.contains(&index))?;
            Some(format!("`{}` (about {})", entrant.structure.name, in_words(time)))
        };
        let missing: Vec<String> = self.entrants.iter().enumerate().filter_map(missing).collect();
        if !missing.is_empty() {
            self.outcome.notes.push(format!(
                "{}: no {what} for want of time: {}.",
                self.input.name,
                missing.join(", "),
            ));
        }
    }
}

/// A time that was estimated, with two figures.
fn in_words(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    let (value, unit) = if seconds < 1.0 { (seconds * 1e3, "ms") } else { (seconds, "s") };
    if value < 10.0 { format!("{value:.1} {unit}") } else { format!("{value:.0} {unit}") }
}

/// What rendering may take of what is left of a scene's time.
pub(super) fn picture_budget(budget: Budget) -> Budget {
    budget.share(0.45)
}

/// The picture at one ray through each pixel's centre, of about so many pixels.
fn smaller(picture: &Settings, samples: f64) -> Settings {
    let (width, height) = (f64::from(picture.width), f64::from(picture.height));
    let side = (samples / (width * height)).sqrt() * width.max(height);
    let [width, height] = fit([picture.width, picture.height], (side as u32).max(1));
    Settings { width, height, aa: 0, ..picture.clone() }
}
