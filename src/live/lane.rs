//! A structure and its picture: a coarse one at once, then slices of passes until all samples are there.

use std::ops::Range;
use std::sync::Arc;
use std::time::{Duration, Instant};

use rayon::ThreadPool;

use crate::film::{Film, Piece, doubling_passes};
use crate::image_io::{Format, rgba_bytes};
use crate::render::{
    Image, Kept, Observer, RayClass, RenderStats, Renderer, Scale, Settings, Stage, View,
    heat_picture, legend, picture_for,
};
use crate::scene::{Camera, Structure};

use super::coarse::{coarse, divisor, fill_missing};
use super::studio::Staged;
use super::update::{ClassReport, LaneReport, Pixels};
use super::worlds::BuiltWorld;

/// A slice of a pass takes about this long: then others have their turn, and the picture may be shown.
const SLICE: Duration = Duration::from_millis(50);

/// What was measured of fewer samples says little about more.
const FEW_SAMPLES: u64 = 4096;

/// What is looked at, and from where.
pub(super) struct Sight {
    pub(super) staged: Arc<Staged>,
    pub(super) camera: Camera,
    /// Of the finished picture.
    pub(super) settings: Settings,
}

/// A structure, and how far its picture is.
pub(super) struct Lane {
    pub(super) structure: Structure,
    world: Arc<BuiltWorld>,
    film: Film,
    passes: Vec<Range<u32>>,
    /// What the rays of the film did.
    stats: RenderStats,
    /// What those of the coarse picture did.
    first_stats: RenderStats,
    /// The coarse picture, until the film has all of its pixels.
    coarse: Option<Arc<Pixels>>,
    shown: Arc<Pixels>,
    legend: Option<String>,
    /// Whether the film has more than what is shown.
    is_stale: bool,
    /// The view samples that a sample of the film stands for: in a heatmap, all of a pixel's.
    samples_in_one: u32,
    /// Seconds for a pixel of a coarse picture, and for a sample of a pixel of the film.
    coarse_cost: Option<f64>,
    sample_cost: Option<f64>,
}

impl Lane {
    /// A lane without a picture.
    pub(super) fn new(structure: Structure, world: Arc<BuiltWorld>, settings: &Settings) -> Self {
        Self {
            structure,
            world,
            film: Film::new(settings.region(), settings.film_samples()),
            passes: Vec::new(),
            stats: RenderStats::default(),
            first_stats: RenderStats::default(),
            coarse: None,
            shown: Arc::new(Pixels { serial: 0, width: 0, height: 0, rgba: Vec::new() }),
            legend: None,
            is_stale: false,
            samples_in_one: 1,
            coarse_cost: None,
            sample_cost: None,
        }
    }

    /// What is traced.
    pub(super) fn world(&self) -> &Arc<BuiltWorld> {
        &self.world
    }

    /// Whether all samples are there.
    pub(super) fn is_complete(&self) -> bool {
        self.passes.is_empty()
    }

    /// Whether the film has more than what is shown.
    pub(super) fn is_stale(&self) -> bool {
        self.is_stale
    }

    /// Whether the film has anything.
    pub(super) fn has_samples(&self) -> bool {
        self.film.coverage().samples > 0
    }

    /// The time that the picture took so far.
    pub(super) fn time(&self) -> Duration {
        self.stats.time
    }

    /// The pixels that are shown.
    pub(super) fn shown(&self) -> &Arc<Pixels> {
        &self.shown
    }

    /// Begins another picture, with a coarse one or, if that is as quick, with the first pass. `lanes` do so.
    pub(super) fn begin(
        &mut self,
        sight: &Sight,
        pool: &ThreadPool,
        observer: &dyn Observer,
        lanes: usize,
        serial: u64,
    ) {
        let settings = &sight.settings;
        self.film = Film::new(settings.region(), settings.film_samples());
        self.passes = doubling_passes(self.film.samples());
        self.stats = RenderStats::default();
        self.first_stats = RenderStats::default();
        self.coarse = None;
        self.is_stale = false;
        let counts_all = settings.view == View::Heatmap;
        self.samples_in_one = if counts_all { settings.samples_per_pixel() } else { 1 };
        let divisor = divisor(self.coarse_cost, settings, lanes);
        if divisor == 1 {
            self.render(sight, pool, observer, &self.film.missing(1));
            self.expose(sight, None, serial);
            return;
        }
        let settings = coarse(settings, divisor);
        let film = Film::new(settings.region(), settings.film_samples());
        let stats = trace(&self.world, sight, &settings, pool, observer, &film, &film.missing(1));
        self.coarse_cost = cost(&stats, film.coverage().samples).or(self.coarse_cost);
        let (pixels, legend) = pixels_of(&film, settings.view, None, serial);
        let pixels = Arc::new(pixels);
        (self.shown, self.legend) = (Arc::clone(&pixels), legend);
        self.coarse = Some(pixels);
        self.first_stats = stats;
    }

    /// Renders a slice of the picture.
    pub(super) fn slice(&mut self, sight: &Sight, pool: &ThreadPool, observer: &dyn Observer) {
        let Some(pass) = self.passes.first() else { return };
        let mut pieces = self.film.missing(pass.end);
        let all = pieces.len();
        let time =
            |piece: &Piece| self.sample_cost.map_or(0.0, |cost| cost * samples(piece) as f64);
        let (threads, mut taken) = (pool.current_num_threads(), 0.0);
        // At least a piece for each thread, and as many as fit.
        let fitting = pieces.iter().enumerate().take_while(|&(i, piece)| {
            taken += time(piece);
            i < threads || self.sample_cost.is_some() && taken <= SLICE.as_secs_f64()
        });
        let fitting = fitting.count();
        pieces.truncate(fitting);
        self.render(sight, pool, observer, &pieces);
        let is_over = |pass: &Range<u32>| self.film.missing(pass.end).is_empty();
        if fitting == all && self.passes.first().is_some_and(is_over) {
            self.passes.remove(0);
        }
    }

    fn render(
        &mut self,
        sight: &Sight,
        pool: &ThreadPool,
        observer: &dyn Observer,
        pieces: &[Piece],
    ) {
        let before = self.film.coverage().samples;
        let world = &self.world;
        let stats = trace(world, sight, &sight.settings, pool, observer, &self.film, pieces);
        let coverage = self.film.coverage();
        let rendered = coverage.samples - before;
        self.is_stale |= rendered > 0;
        self.sample_cost = cost(&stats, rendered).or(self.sample_cost);
        if sight.settings.view != View::Heatmap && rendered >= FEW_SAMPLES {
            self.coarse_cost = self.sample_cost;
        }
        let time = self.stats.time + stats.time;
        self.stats.merge(&stats);
        self.stats.time = time;
        if coverage.is_complete() {
            self.passes.clear();
        }
    }

    /// The ends of the scale of what the film has; none if that is colours, or nothing.
    pub(super) fn scale(&self, view: View) -> Option<Scale> {
        match Image::of(&self.film, view) {
            Image::Scalar { values, .. } => Scale::of(&values),
            Image::Color(_) => None,
        }
    }

    /// Shows what the film has; numbers on a scale, or on their own if there is none.
    pub(super) fn expose(&mut self, sight: &Sight, scale: Option<Scale>, serial: u64) {
        let (mut pixels, legend) = pixels_of(&self.film, sight.settings.view, scale, serial);
        if let Some(coarse) = &self.coarse {
            let missing = self.film.missing(1);
            if missing.is_empty() {
                self.coarse = None;
            } else {
                fill_missing(&mut pixels, missing.iter().map(|piece| piece.area), coarse);
            }
        }
        (self.shown, self.legend) = (Arc::new(pixels), legend);
        self.is_stale = false;
    }

    /// The figures.
    pub(super) fn report(&self, threads: usize) -> LaneReport {
        let stats = if self.stats.total_rays() > 0 { &self.stats } else { &self.first_stats };
        let build = &self.world.report;
        let per_second = |rays: u64, seconds: f64| (seconds > 0.0).then(|| rays as f64 / seconds);
        let classes = RayClass::RENDERED.into_iter().filter(|&class| stats.class(class).rays > 0);
        let class_report = |class: RayClass| {
            let rays = stats.class(class).rays;
            let time = stats.thread_times.of(Stage::Tracing(class)).as_secs_f64();
            let rays_per_second = per_second(rays, time / threads as f64);
            ClassReport { name: class.name(), rays, rays_per_second }
        };
        let coverage = self.film.coverage();
        LaneReport {
            structure: self.structure.name,
            base: self.structure.base_name(),
            build_seconds: build.time.as_secs_f64(),
            bytes: build.objects.bytes + build.meshes.bytes + build.triangle_bytes,
            samples: coverage.samples_per_pixel() * f64::from(self.samples_in_one),
            all_samples: self.film.samples() * self.samples_in_one,
            complete: self.is_complete() && coverage.is_complete(),
            legend: self.legend.clone(),
            seconds: self.stats.time.as_secs_f64(),
            rays: stats.total_rays(),
            rays_per_second: per_second(stats.total_rays(), stats.time.as_secs_f64()),
            classes: classes.map(class_report).collect(),
            picture_width: self.shown.width,
            picture_height: self.shown.height,
            picture_bytes: 0,
        }
    }
}

/// The samples of a piece.
fn samples(piece: &Piece) -> u64 {
    piece.area.pixels() * piece.samples.len() as u64
}

/// Renders pieces of a film, and measures the time.
fn trace(
    world: &BuiltWorld,
    sight: &Sight,
    settings: &Settings,
    pool: &ThreadPool,
    observer: &dyn Observer,
    film: &Film,
    pieces: &[Piece],
) -> RenderStats {
    let start = Instant::now();
    let scene = &sight.staged.show.scene;
    let cells = (settings.view == View::Cells).then(|| world.cells(scene));
    let renderer = Renderer::seen_by(&sight.camera, scene, &*world.traced, settings, cells);
    let mut stats = pool.install(|| {
        renderer.render(pieces, Kept::Sums, observer, &|part| {
            let taken = film.take(part);
            debug_assert_eq!(taken, Ok(()), "the pieces are the film's own");
        })
    });
    stats.time = start.elapsed();
    stats
}

/// Seconds for a sample, of so many that were rendered.
fn cost(stats: &RenderStats, rendered: u64) -> Option<f64> {
    (rendered > 0).then(|| stats.time.as_secs_f64() / rendered as f64)
}

/// What a film shows, as a file of bytes would have it, and what its colours mean; numbers on a scale, or on their own.
fn pixels_of(
    film: &Film,
    view: View,
    scale: Option<Scale>,
    serial: u64,
) -> (Pixels, Option<String>) {
    let (picture, scale) = match (Image::of(film, view), scale) {
        (Image::Scalar { width, height, values }, Some(scale)) => {
            (heat_picture(width, height, &values, scale), Some(scale))
        }
        (image, _) => picture_for(image, view, Format::Png),
    };
    let (width, height) = (picture.width, picture.height);
    let pixels = Pixels { serial, width, height, rgba: rgba_bytes(&picture) };
    (pixels, scale.map(|scale| legend(view, scale)))
}
