//! What a session shows: figures as JSON, and pixels behind them.

use std::sync::Arc;

use serde::Serialize;

/// Pixels as screens take them.
pub(super) struct Pixels {
    /// Different for each picture of a session.
    pub(super) serial: u64,
    pub(super) width: u32,
    pub(super) height: u32,
    /// Red, green, blue and alpha of each pixel, row by row from the top left.
    pub(super) rgba: Vec<u8>,
}

/// All that is shown but the pixels.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Report {
    /// The number of the last command that was carried out.
    pub(super) answers: u64,
    /// What the scene is called.
    pub(super) scene: String,
    /// The size of the whole picture in pixels.
    pub(super) width: u32,
    pub(super) height: u32,
    /// What is wrong with the scene as it was saved last.
    pub(super) error: Option<String>,
    /// What is doubtful in the scene that is shown.
    pub(super) warnings: String,
    /// What of the last command could not be done.
    pub(super) refusal: Option<String>,
    /// What is being done that takes a while.
    pub(super) busy: Option<String>,
    /// What the pixels show.
    pub(super) view: &'static str,
    /// The camera's commands.
    pub(super) camera: String,
    /// Whether the camera is not that of the scene.
    pub(super) moved: bool,
    /// Whether all pictures are finished.
    pub(super) complete: bool,
    /// The structures, side by side.
    pub(super) lanes: Vec<LaneReport>,
}

/// A structure and its picture.
#[derive(Clone, Debug, Serialize)]
pub(super) struct LaneReport {
    /// The structure with its options.
    pub(super) structure: &'static str,
    /// Its name without options.
    pub(super) base: &'static str,
    /// What building it took.
    pub(super) build_seconds: f64,
    /// The structure in memory, with the triangles.
    pub(super) bytes: u64,
    /// The samples of a pixel that are there, on average; 0 while the picture is a coarse one.
    pub(super) samples: f64,
    /// The samples of a pixel when it is finished.
    pub(super) all_samples: u32,
    /// Whether it is finished.
    pub(super) complete: bool,
    /// What the colours mean, where they stand for numbers.
    pub(super) legend: Option<String>,
    /// Wall time of rendering the picture, its coarse one excluded.
    pub(super) seconds: f64,
    /// Rays that were traced in that time, of all classes; of the coarse picture while there is no other.
    pub(super) rays: u64,
    /// The same, a second of wall time; none before there are any.
    pub(super) rays_per_second: Option<f64>,
    /// The classes of rays that were traced.
    pub(super) classes: Vec<ClassReport>,
    /// The picture's own size: smaller than the whole while it is coarse.
    pub(super) picture_width: u32,
    pub(super) picture_height: u32,
    /// The bytes of its pixels in this update.
    pub(super) picture_bytes: usize,
}

/// The rays of a class.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ClassReport {
    pub(super) name: &'static str,
    pub(super) rays: u64,
    /// A second that all threads spend on tracing them; none if that was too short to measure.
    pub(super) rays_per_second: Option<f64>,
}

/// The update for one who has seen pictures of some serials, as [`Session::update`](super::Session::update) says.
pub(super) fn encode(report: &Report, pictures: &[Arc<Pixels>], seen: &[u64]) -> Vec<u8> {
    let is_new = |place: usize, picture: &Pixels| seen.get(place) != Some(&picture.serial);
    let news: Vec<_> = (0..).zip(pictures).filter(|(i, picture)| is_new(*i, picture)).collect();
    let mut report = report.clone();
    for (place, picture) in &news {
        report.lanes[*place].picture_bytes = picture.rgba.len();
    }
    // Numbers, texts and lists have a form in JSON, finite or not.
    let json = serde_json::to_vec(&report).unwrap_or_default();
    let pixels: usize = news.iter().map(|(_, picture)| picture.rgba.len()).sum();
    let mut bytes = Vec::with_capacity(4 + json.len() + pixels);
    bytes.extend((json.len() as u32).to_le_bytes());
    bytes.extend(json);
    for (_, picture) in news {
        bytes.extend(&picture.rgba);
    }
    bytes
}
