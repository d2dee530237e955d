//! The thread of a session: what commands change, and what is rendered next.

use std::collections::VecDeque;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::accel::{Answers, Scratch};
use crate::math::Hit;
use crate::render::{Observer, Scale, Settings, View};
use crate::scene::{Camera, Structure};

use super::Studio;
use super::command::{Command, Numbered, view_named};
use super::inbox::{Inbox, Mail};
use super::lane::{Lane, Sight};
use super::orbit::Orbit;
use super::session::Outbox;
use super::studio::Staged;
use super::update::Report;
use super::worlds::BuiltWorld;

/// Between two pictures on the way there is at least this time, and so many times that which showing one takes.
const BETWEEN_PICTURES: Duration = Duration::from_millis(150);
const TIMES_SHOWING: u32 = 8;

/// After the first picture of a movement the threads rest for so long: a browser on the same processors draws it then.
const REST: Duration = Duration::from_millis(16);

/// The picture after a movement is finished in spite of the next movement, or fast hands would never see one; but one
/// that takes longer than this is not worth that.
const PATIENCE: Duration = Duration::from_secs(1);

/// What a session looks at, and what it has of it.
pub(super) struct Worker {
    studio: Arc<Studio>,
    inbox: Arc<Inbox>,
    outbox: Arc<Outbox>,
    /// What is on; none before the first look at the stage.
    staged: Option<Arc<Staged>>,
    error: Option<Arc<str>>,
    /// The structures side by side.
    wanted: Vec<Structure>,
    view: View,
    orbit: Option<Orbit>,
    sight: Option<Sight>,
    lanes: Vec<Lane>,
    /// The last command that was carried out.
    answers: u64,
    /// What of it could not be done.
    refusal: Option<String>,
    /// How many pictures there were.
    serial: u64,
    next_picture: Instant,
}

impl Worker {
    /// A worker that has not looked yet.
    pub(super) fn new(studio: Arc<Studio>, inbox: Arc<Inbox>, outbox: Arc<Outbox>) -> Self {
        let stage = studio.stage();
        Self {
            wanted: vec![studio.structures[0]],
            view: stage.staged.show.settings.view,
            studio,
            inbox,
            outbox,
            staged: None,
            error: None,
            orbit: None,
            sight: None,
            lanes: Vec::new(),
            answers: 0,
            refusal: None,
            serial: 0,
            next_picture: Instant::now(),
        }
    }

    /// Works until the session is over. Sleeps while there is nothing to do.
    pub(super) fn run(mut self) {
        loop {
            // A structure from outside the crate may panic: then another can be chosen.
            match catch_unwind(AssertUnwindSafe(|| self.step())) {
                Ok(ControlFlow::Continue(())) => {}
                Ok(ControlFlow::Break(())) => return,
                Err(_) => self.give_up(),
            }
        }
    }

    /// Carries out what has arrived, and renders a slice; or waits for something to arrive.
    fn step(&mut self) -> ControlFlow<()> {
        let is_new = self.staged.is_none();
        let has_work = is_new || self.lanes.iter().any(|lane| !lane.is_complete());
        let Mail { commands, closed, arrivals } = self.inbox.take(has_work);
        if closed {
            return ControlFlow::Break(());
        }
        let has_mail = !commands.is_empty();
        let (is_other_scene, is_other_error) = self.follow();
        let is_other_sight = self.obey(commands);
        if is_other_scene || is_other_sight {
            self.begin(arrivals);
        } else if has_mail || is_other_error {
            self.show(None);
        }
        self.refine(arrivals);
        ControlFlow::Continue(())
    }

    /// What is left after a panic: a scene that nothing traces.
    fn give_up(&mut self) {
        self.lanes.clear();
        self.refusal = Some("a structure failed: the terminal says why. Choose another".to_owned());
        if let (None, Some(staged)) = (&self.orbit, &self.staged) {
            self.orbit = Some(Orbit::new(staged.show.camera.clone(), 1.0));
        }
        self.show(None);
    }

    /// Takes over what is on now: whether that is another scene, and whether another error.
    fn follow(&mut self) -> (bool, bool) {
        let stage = self.studio.stage();
        let is_other_error = stage.error != self.error;
        self.error = stage.error;
        if self.staged.as_ref().is_some_and(|own| Arc::ptr_eq(own, &stage.staged)) {
            return (false, is_other_error);
        }
        let keeps_worlds = |own: &Arc<Staged>| Arc::ptr_eq(&own.worlds, &stage.staged.worlds);
        if !self.staged.as_ref().is_some_and(keeps_worlds) {
            self.lanes.clear();
        }
        self.staged = Some(Arc::clone(&stage.staged));
        self.refusal = None;
        let wanted = std::mem::take(&mut self.wanted);
        if let Err(refusal) = self.choose(&stage.staged, wanted) {
            self.refusal = Some(refusal);
            // What every scene can be traced with, unless there is no memory for it.
            let structures = &self.studio.structures;
            let first = structures.iter().find(|one| !one.peer).unwrap_or(&structures[0]);
            if let Err(refusal) = self.choose(&stage.staged, vec![*first]) {
                self.refusal = Some(refusal);
            }
        }
        let show = &stage.staged.show;
        let world = self.lanes.first().map(Lane::world);
        let distance = world.map_or(1.0, |world| distance_ahead(&stage.staged, world));
        self.orbit = Some(match &self.orbit {
            Some(orbit) => orbit.carried_to(show.camera.clone(), distance),
            None => Orbit::new(show.camera.clone(), distance),
        });
        (true, is_other_error)
    }

    /// Carries commands out, in their order: whether they change what is seen.
    fn obey(&mut self, commands: VecDeque<Numbered>) -> bool {
        let mut is_other = false;
        for Numbered { id, command } in commands {
            self.refusal = None;
            self.answers = id;
            match self.carry_out(command) {
                Ok(()) => is_other = true,
                Err(refusal) => self.refusal = Some(refusal),
            }
        }
        is_other
    }

    fn carry_out(&mut self, command: Command) -> Result<(), String> {
        let (Some(staged), Some(orbit)) = (self.staged.clone(), &mut self.orbit) else {
            return Ok(());
        };
        let before = orbit.clone();
        match command {
            Command::Turn(by) => orbit.turn(by),
            Command::Pan(by) => orbit.pan(by),
            Command::Zoom(by) => orbit.zoom(by),
            Command::Reset => orbit.reset(),
            Command::Structures(names) => {
                let find = |name: &String| find(&self.studio.structures, name);
                let structures = names.iter().map(find).collect::<Result<Vec<_>, _>>()?;
                check_view(self.view, &structures)?;
                return self.choose(&staged, structures);
            }
            Command::View(name) => {
                let view = view_named(&name).unwrap_or_default();
                check_view(view, &self.wanted)?;
                self.view = view;
                return Ok(());
            }
        }
        if let Err(error) = Camera::new(&orbit.camera()) {
            *orbit = before;
            return Err(error.to_string());
        }
        Ok(())
    }

    /// Takes structures, and builds those that are new; if one cannot be built, all stays as it was.
    fn choose(&mut self, staged: &Arc<Staged>, structures: Vec<Structure>) -> Result<(), String> {
        let mut worlds = Vec::new();
        for structure in &structures {
            let own = self.lanes.iter().find(|lane| lane.structure.name == structure.name);
            worlds.push(match own {
                Some(lane) => Arc::clone(lane.world()),
                None => {
                    self.show(Some(format!("building {}", structure.name)));
                    let _turn = self.studio.turns.wait();
                    let studio = &self.studio;
                    let build = || staged.worlds.get(structure, &staged.show.scene, &studio.build);
                    studio.pool.install(build)?
                }
            });
        }
        let settings = &staged.show.settings;
        let mut kept = std::mem::take(&mut self.lanes);
        for (structure, world) in structures.iter().zip(worlds) {
            let place = kept.iter().position(|lane| lane.structure.name == structure.name);
            // A lane of its own for each place, with what was measured of the structure.
            let lane = place.map(|place| kept.remove(place));
            self.lanes.push(lane.unwrap_or_else(|| Lane::new(*structure, world, settings)));
        }
        self.wanted = structures;
        Ok(())
    }

    /// Begins the pictures of what is seen now.
    fn begin(&mut self, arrivals: u64) {
        let (Some(staged), Some(orbit)) = (&self.staged, &self.orbit) else { return };
        let settings = Settings { view: self.view, ..staged.show.settings.clone() };
        // Of the scene itself, where nobody moved it: a camera was checked when it was moved.
        let camera = Camera::new(&orbit.camera()).unwrap_or(staged.show.scene.camera.clone());
        let sight = Sight { staged: Arc::clone(staged), camera, settings };
        let patience = Some(Instant::now() + PATIENCE);
        let watch = Watch { inbox: &self.inbox, arrivals, patience };
        let count = self.lanes.len();
        for lane in &mut self.lanes {
            let _turn = self.studio.turns.wait();
            self.serial += 1;
            lane.begin(&sight, &self.studio.pool, &watch, count, self.serial);
        }
        self.sight = Some(sight);
        self.show(None);
        self.inbox.rest(REST);
        self.next_picture = Instant::now() + BETWEEN_PICTURES;
    }

    /// Renders a slice of the picture that took the least time so far, so that structures race for equal times.
    fn refine(&mut self, arrivals: u64) {
        let Some(sight) = &self.sight else { return };
        let unfinished = self.lanes.iter_mut().filter(|lane| !lane.is_complete());
        let Some(lane) = unfinished.min_by_key(|lane| lane.time()) else { return };
        {
            let watch = Watch { inbox: &self.inbox, arrivals, patience: None };
            let _turn = self.studio.turns.wait();
            lane.slice(sight, &self.studio.pool, &watch);
        }
        let is_complete = lane.is_complete();
        if is_complete || Instant::now() >= self.next_picture {
            self.expose();
        }
    }

    /// Shows what the films have.
    fn expose(&mut self) {
        let Some(sight) = &self.sight else { return };
        let start = Instant::now();
        let scale = shared_scale(&self.lanes, self.view);
        let has_pixels =
            |lane: &&mut Lane| lane.is_stale() || scale.is_some() && lane.has_samples();
        for lane in self.lanes.iter_mut().filter(has_pixels) {
            self.serial += 1;
            lane.expose(sight, scale, self.serial);
        }
        self.show(None);
        let took = start.elapsed();
        self.next_picture = Instant::now() + BETWEEN_PICTURES.max(TIMES_SHOWING * took);
    }

    /// Hands out pictures and figures; `busy` is what takes a while now.
    fn show(&self, busy: Option<String>) {
        let Some(staged) = &self.staged else { return };
        let show = &staged.show;
        let threads = self.studio.pool.current_num_threads();
        let lanes: Vec<_> = self.lanes.iter().map(|lane| lane.report(threads)).collect();
        let report = Report {
            answers: self.answers,
            scene: show.name.clone(),
            width: show.settings.width,
            height: show.settings.height,
            error: self.error.as_deref().map(str::to_owned),
            warnings: show.warnings.clone(),
            refusal: self.refusal.clone(),
            complete: busy.is_none() && !lanes.is_empty() && lanes.iter().all(|lane| lane.complete),
            busy,
            view: self.view.name(),
            camera: self.orbit.as_ref().map(Orbit::lines).unwrap_or_default(),
            moved: self.orbit.as_ref().is_some_and(Orbit::is_moved),
            lanes,
        };
        let pictures = self.lanes.iter().map(|lane| Arc::clone(lane.shown())).collect();
        self.outbox.put(report, pictures);
    }
}

/// Stops a rendering when something arrives: at once, or when patience is at its end.
struct Watch<'a> {
    inbox: &'a Inbox,
    arrivals: u64,
    patience: Option<Instant>,
}

impl Observer for Watch<'_> {
    fn tile_done(&self, _: u64, _: u64) {}

    fn cancelled(&self) -> bool {
        if self.inbox.arrivals() == self.arrivals {
            return false;
        }
        let is_patient = self.patience.is_some_and(|end| Instant::now() < end);
        !is_patient || self.inbox.is_closed()
    }
}

/// One scale for the heatmaps of structures that race, in steps of equal factors: they may differ by thousands.
fn shared_scale(lanes: &[Lane], view: View) -> Option<Scale> {
    if lanes.len() < 2 || view != View::Heatmap {
        return None;
    }
    let both = |a: Scale, b: Scale| Scale { low: a.low.min(b.low), high: a.high.max(b.high), ..a };
    lanes.iter().filter_map(|lane| lane.scale(view)).reduce(both).map(Scale::logarithmic)
}

/// The structure of a name with options.
fn find(structures: &[Structure], text: &str) -> Result<Structure, String> {
    if let Some(one) = structures.iter().find(|one| one.name == text) {
        return Ok(*one);
    }
    let (name, options) = text.split_once(':').unwrap_or((text, ""));
    let plain = structures.iter().find(|one| one.name == name);
    let plain = plain.ok_or_else(|| format!("there is no structure `{name}`"))?;
    plain.with_options(options).map_err(|error| format!("`{name}`: {error}"))
}

/// A heatmap is of tests that are counted, and cells are shown by those that have them.
fn check_view(view: View, structures: &[Structure]) -> Result<(), String> {
    let peer = structures.iter().find(|one| one.peer);
    match (peer.map(|peer| peer.name), view) {
        (Some(name), View::Heatmap) => Err(format!("`{name}` counts no tests: it has no heatmap")),
        (Some(name), View::Cells) => Err(format!("`{name}` does not show its cells")),
        _ => Ok(()),
    }
}

/// From the eye to what is seen in the middle of the picture, or to the middle of the scene where nothing is.
fn distance_ahead(staged: &Staged, world: &BuiltWorld) -> f64 {
    let (scene, settings) = (&staged.show.scene, &staged.show.settings);
    let camera = scene.camera.resized(settings.width, settings.height);
    let middle = [settings.width, settings.height].map(|side| 0.5 * f64::from(side - 1));
    let ray = camera.ray(middle[0], middle[1]);
    let mut hits = [Hit::MISS];
    world.traced.trace(&[ray], Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
    if hits[0].is_hit() {
        return f64::from(hits[0].t) * f64::from(ray.dir.length());
    }
    let bounds = scene.bounds();
    let center = 0.5 * (bounds.min.as_dvec3() + bounds.max.as_dvec3());
    (center - ray.origin.as_dvec3()).length()
}
