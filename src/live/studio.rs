//! What all who look at a scene share.

use std::sync::{Arc, Condvar, Mutex, MutexGuard, OnceLock, PoisonError, Weak};

use rayon::ThreadPool;

use crate::accel::BuildConfig;
use crate::description::Camera;
use crate::render::Settings;
use crate::scene::{Scene, Structure};

use super::inbox::Inbox;
use super::session::Session;
use super::turns::Turns;
use super::worlds::Worlds;

/// More at a time are not let in: each has pictures of its own in memory.
const MOST_SESSIONS: usize = 16;

/// A scene, as it is to be looked at.
pub struct Show {
    /// What it is called.
    pub name: String,
    /// What is traced.
    pub scene: Scene,
    /// The camera as the scene has it; the size of its picture is that of the settings.
    pub camera: Camera,
    /// How it is rendered. The whole picture is shown, so there is no crop.
    pub settings: Settings,
    /// What is doubtful in it, as text; empty if nothing is.
    pub warnings: String,
}

/// A show, and the structures that were built over its scene.
pub(super) struct Staged {
    pub(super) show: Show,
    pub(super) worlds: Arc<Worlds>,
    /// What decides the hits of rays, once it was asked for.
    geometry: OnceLock<[u8; 32]>,
}

/// What is on, and what is wrong with what was to follow it.
#[derive(Clone)]
pub(super) struct Stage {
    /// The last good one.
    pub(super) staged: Arc<Staged>,
    /// What is wrong with the scene as it was saved last.
    pub(super) error: Option<Arc<str>>,
}

/// A scene with the structures that can trace it, and all who look at it.
pub struct Studio {
    /// What there is to choose from, the one to begin with first.
    pub(super) structures: Vec<Structure>,
    pub(super) build: BuildConfig,
    /// The threads that build and render.
    pub(super) pool: ThreadPool,
    pub(super) turns: Turns,
    stage: Mutex<Stage>,
    lookers: Mutex<Vec<Weak<Inbox>>>,
    came_or_left: Condvar,
}

/// Why nobody else can look.
#[derive(Debug, thiserror::Error)]
pub enum StudioError {
    /// There are as many as there may be.
    #[error("{MOST_SESSIONS} pages are looked at already: close one")]
    Full,
    /// The system has no thread left.
    #[error("cannot start a thread: {0}")]
    Thread(#[from] std::io::Error),
}

impl Studio {
    /// A studio with a scene.
    ///
    /// # Panics
    /// If there is no structure, or only a crop is to be shown.
    #[must_use]
    pub fn new(
        show: Show,
        structures: Vec<Structure>,
        build: BuildConfig,
        pool: ThreadPool,
    ) -> Arc<Self> {
        assert!(!structures.is_empty(), "a structure to begin with");
        Arc::new(Self {
            structures,
            build,
            pool,
            turns: Turns::default(),
            stage: Mutex::new(Stage { staged: Arc::new(Staged::new(show)), error: None }),
            lookers: Mutex::default(),
            came_or_left: Condvar::new(),
        })
    }

    /// Shows the scene as it was saved again. Structures are built anew only if other rays hit, or hit elsewhere: other
    /// materials, lights and cameras do not change that.
    ///
    /// # Panics
    /// If only a crop is to be shown.
    pub fn replace(&self, show: Show) {
        let staged = Staged::new(show).after(&self.stage().staged);
        *self.lock_stage() = Stage { staged: Arc::new(staged), error: None };
        self.announce();
    }

    /// Says what is wrong with the scene as it was saved again; the last good one stays.
    pub fn explain(&self, error: &str) {
        self.lock_stage().error = Some(error.into());
        self.announce();
    }

    /// Begins to look. `changed` is called from any thread when there is something new to see, and must not wait.
    ///
    /// # Errors
    /// If too many look already, or the system has no thread left.
    pub fn open(
        self: &Arc<Self>,
        changed: impl Fn() + Send + Sync + 'static,
    ) -> Result<Session, StudioError> {
        let mut lookers = self.lock_lookers();
        lookers.retain(|other| other.strong_count() > 0);
        if lookers.len() >= MOST_SESSIONS {
            return Err(StudioError::Full);
        }
        let (session, inbox) = Session::begin(self, Box::new(changed))?;
        lookers.push(inbox);
        self.came_or_left.notify_all();
        Ok(session)
    }

    /// Waits until somebody looks.
    pub fn wait_for_lookers(&self) {
        let nobody = |lookers: &mut Vec<Weak<Inbox>>| {
            lookers.retain(|other| other.upgrade().is_some_and(|inbox| !inbox.is_closed()));
            lookers.is_empty()
        };
        drop(self.came_or_left.wait_while(self.lock_lookers(), nobody));
    }

    /// Does work on the threads that build and render, and waits for it.
    pub fn on_threads<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        self.pool.install(work)
    }

    /// What is on.
    pub(super) fn stage(&self) -> Stage {
        self.lock_stage().clone()
    }

    fn announce(&self) {
        self.lock_lookers().iter().filter_map(Weak::upgrade).for_each(|inbox| inbox.put_news());
    }

    fn lock_stage(&self) -> MutexGuard<'_, Stage> {
        self.stage.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn lock_lookers(&self) -> MutexGuard<'_, Vec<Weak<Inbox>>> {
        self.lookers.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Staged {
    fn new(show: Show) -> Self {
        assert!(show.settings.crop.is_none(), "the whole picture is shown");
        Self { show, worlds: Arc::default(), geometry: OnceLock::new() }
    }

    /// The same, with the structures of the one before it where its rays hit the same.
    fn after(self, before: &Self) -> Self {
        let is_same = self.geometry() == before.geometry();
        let worlds = if is_same { Arc::clone(&before.worlds) } else { self.worlds };
        Self { worlds, ..self }
    }

    fn geometry(&self) -> &[u8; 32] {
        self.geometry.get_or_init(|| self.show.scene.geometry_hash())
    }
}
