//! Sessions of `srt::live` without a page: what is told, and what is to be seen then.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use std::ops::{ControlFlow, Range};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use rayon::ThreadPoolBuilder;
use serde_json::Value;
use srt::accel::{Accel, Bounded, Build, BuildConfig, Built, Bvh, Exhaustive};
use srt::counters::Counters;
use srt::description::{Camera, Light, Material, Object, Options, SceneDescription};
use srt::glam::{DAffine3, DVec3, Vec3};
use srt::image_io::rgba_bytes;
use srt::live::{Seen, Session, Show, Studio};
use srt::math::{BoxRay, Color, Ray};
use srt::render::{Image, Settings, Silent, View, render};
use srt::scene::{Scene, Structure, structure_named};
use srt::shapes::{Ball, Single};

/// Longer than anything takes.
const TOO_LONG: Duration = Duration::from_secs(60);

/// A ball of some radius in the light.
fn show(radius: f32) -> Show {
    let camera = Camera {
        eye: DVec3::new(0.0, -5.0, 0.5),
        direction: DVec3::Y,
        up: DVec3::Z,
        distance: 1.0,
        fovy_degrees: 40.0,
        width: 50,
        height: 34,
    };
    let ball = Single::Ball(Ball { center: Vec3::ZERO, radius });
    let light = Light::Point { position: DVec3::new(3.0, -4.0, 5.0), color: Color::ONE };
    let description = SceneDescription {
        camera: camera.clone(),
        options: Options { aa: 3, ..Options::default() },
        materials: vec![Material::default()],
        meshes: Vec::new(),
        objects: vec![Object::new(ball, DAffine3::IDENTITY)],
        lights: vec![light],
    };
    let scene = Scene::new(&description, Vec::new()).unwrap();
    let settings = Settings::of_scene(&scene);
    Show { name: "ball".to_owned(), scene, camera, settings, warnings: String::new() }
}

/// What a rendering in one go shows.
fn rendered(show: &Show, view: View) -> Vec<u8> {
    let world = structure_named("none").unwrap().build(&show.scene, &BuildConfig::default());
    let settings = Settings { view, ..show.settings.clone() };
    match render(&show.scene, &*world, &settings, &Silent).image {
        Image::Color(picture) => rgba_bytes(&picture),
        Image::Scalar { .. } => panic!("numbers have no colours of their own"),
    }
}

/// Falls over whenever it is to be built.
struct Broken;

impl Accel for Broken {
    fn build(_: &impl Bounded, _: &mut Build<'_>) -> Built<Self> {
        panic!("broken on purpose")
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

/// Counts how often it is built.
struct Counted(Exhaustive);

static BUILDS: AtomicUsize = AtomicUsize::new(0);

impl Accel for Counted {
    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        BUILDS.fetch_add(1, Ordering::Relaxed);
        let built = Exhaustive::build(primitives, build);
        Built { accel: Self(built.accel), order: built.order }
    }

    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        self.0.traverse(ray, box_ray, counters, leaf);
    }

    fn bytes(&self) -> u64 {
        self.0.bytes()
    }
}

/// One who looks.
struct Looker {
    session: Session,
    news: Receiver<()>,
    seen: Seen,
    /// The pixels that were seen last, structure by structure.
    pictures: Vec<Vec<u8>>,
    id: u64,
}

fn studio(structures: &[Structure]) -> Arc<Studio> {
    let pool = ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    Studio::new(show(1.0), structures.to_vec(), BuildConfig::default(), pool)
}

impl Looker {
    fn new(studio: &Arc<Studio>) -> Self {
        let (sender, news) = channel();
        let session = studio.open(move || _ = sender.send(())).unwrap();
        Self { session, news, seen: Seen::default(), pictures: Vec::new(), id: 0 }
    }

    fn tell(&mut self, command: &str) {
        self.id += 1;
        self.session.tell(&format!(r#"{{"id": {}, "do": {command}}}"#, self.id)).unwrap();
    }

    /// Looks until something is seen that answers the last command.
    fn until(&mut self, wanted: impl Fn(&Value) -> bool) -> Value {
        loop {
            self.news.recv_timeout(TOO_LONG).expect("news");
            let Some(update) = self.session.update(&mut self.seen) else { continue };
            let (length, rest) = update.split_first_chunk().unwrap();
            let (json, mut pixels) = rest.split_at(u32::from_le_bytes(*length) as usize);
            let report: Value = serde_json::from_slice(json).unwrap();
            let lanes = report["lanes"].as_array().unwrap();
            self.pictures.resize(lanes.len(), Vec::new());
            for (lane, picture) in lanes.iter().zip(&mut self.pictures) {
                let (own, others) =
                    pixels.split_at(lane["picture_bytes"].as_u64().unwrap() as usize);
                if !own.is_empty() {
                    *picture = own.to_vec();
                }
                pixels = others;
            }
            if report["answers"] == self.id && wanted(&report) {
                return report;
            }
        }
    }

    fn finished(&mut self) -> Value {
        self.until(|report| report["complete"] == true)
    }
}

fn library() -> Vec<Structure> {
    ["bvh8", "none", "bvh"].map(|name| *structure_named(name).unwrap()).to_vec()
}

#[test]
fn a_finished_picture_is_that_of_a_rendering_in_one_go() {
    let mut looker = Looker::new(&studio(&library()));
    let report = looker.finished();
    assert_eq!(
        (report["width"].as_u64(), report["lanes"][0]["samples"].as_f64()),
        (Some(50), Some(9.0))
    );
    assert!(looker.pictures[0] == rendered(&show(1.0), View::Color));
    for view in [View::Normal, View::Object] {
        looker.tell(&format!(r#"{{"view": "{}"}}"#, view.name()));
        looker.finished();
        assert!(looker.pictures[0] == rendered(&show(1.0), view), "{}", view.name());
    }
    looker.tell(r#"{"view": "heatmap"}"#);
    let report = looker.finished();
    assert_eq!(report["lanes"][0]["samples"], 9.0, "its tests are those of all samples");
    assert!(report["lanes"][0]["legend"].as_str().unwrap().starts_with("heatmap: black is"));
}

#[test]
fn heatmaps_that_race_have_one_scale() {
    let mut looker = Looker::new(&studio(&library()));
    looker.tell(r#"{"view": "heatmap"}"#);
    looker.finished();
    let alone = looker.pictures[0].clone();
    looker.tell(r#"{"structures": ["bvh8", "none"]}"#);
    let report = looker.finished();
    let [a, b] = [0, 1].map(|i| report["lanes"][i]["legend"].as_str().unwrap());
    assert!(a == b && a.ends_with("in steps of equal factors"), "{a}\n{b}");
    looker.tell(r#"{"structures": ["bvh8"]}"#);
    looker.finished();
    assert!(looker.pictures[0] == alone, "and alone their own");
}

#[test]
fn what_was_seen_is_not_sent_again() {
    let mut looker = Looker::new(&studio(&library()));
    looker.finished();
    assert!(looker.session.update(&mut looker.seen).is_none());
    looker.tell(r#"{"structures": ["nothing"]}"#);
    let report = looker.finished();
    assert_eq!(report["lanes"][0]["picture_bytes"], 0, "the picture is the same");
    assert_eq!(report["refusal"], "there is no structure `nothing`");
    let again = looker.session.update(&mut Seen::default()).unwrap();
    assert!(again.len() > 4 * 50 * 34, "who has seen nothing gets all");
}

#[test]
fn a_scene_is_replaced_and_an_error_leaves_it() {
    let studio = studio(&library());
    let [mut first, mut second] = [(); 2].map(|()| Looker::new(&studio));
    first.finished();
    studio.explain("error: no ball");
    let report = first.until(|report| report["error"] == "error: no ball");
    assert_eq!(
        (&report["complete"], report["lanes"][0]["picture_bytes"].as_u64()),
        (&Value::Bool(true), Some(0))
    );
    studio.replace(show(0.5));
    for looker in [&mut first, &mut second] {
        looker.until(|report| report["complete"] == true && report["error"].is_null());
        while looker.pictures[0] != rendered(&show(0.5), View::Color) {
            looker.until(|report| report["complete"] == true);
        }
    }
}

#[test]
fn what_hits_the_same_is_not_built_again() {
    let counted = Structure::new::<Counted, Exhaustive>("counted", "counts its builds");
    let studio = studio(&[counted]);
    let [mut first, mut second] = [(); 2].map(|()| Looker::new(&studio));
    first.finished();
    second.finished();
    assert_eq!(BUILDS.load(Ordering::Relaxed), 1, "for both");
    let green = |radius| {
        let mut show = show(radius);
        show.scene.materials[0].reflectance = Color::new(0.1, 0.7, 0.2);
        show
    };
    for (radius, builds) in [(1.0, 1), (0.7, 2)] {
        studio.replace(green(radius));
        let expected = rendered(&green(radius), View::Color);
        while first.pictures[0] != expected {
            first.finished();
        }
        assert_eq!(BUILDS.load(Ordering::Relaxed), builds, "{radius}");
    }
}

#[test]
fn a_structure_that_fails_leaves_the_others() {
    let broken = Structure::new::<Broken, Exhaustive>("broken", "falls over");
    let mine = Structure::new::<Bvh, Exhaustive>("mine", "one from outside");
    let mut looker = Looker::new(&studio(&[broken, mine]));
    let report = looker.until(|report| !report["refusal"].is_null());
    assert!(report["refusal"].as_str().unwrap().starts_with("a structure failed"), "{report}");
    assert_eq!(report["lanes"].as_array().unwrap().len(), 0);
    looker.tell(r#"{"structures": ["mine"]}"#);
    looker.finished();
    assert!(looker.pictures[0] == rendered(&show(1.0), View::Color));
    looker.tell(r#"{"turn": [0.1, 0.3]}"#);
    assert_eq!(looker.finished()["moved"], true);
}
