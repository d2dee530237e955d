//! `repeat`: the lines up to its `end_repeat` are read once and carried out many times.
//!
//! Transform and material carry over from one iteration to the next and past the last; scopes that
//! an iteration opens it closes. Values are checked as they are read, so what is wrong with them is
//! reported once. What goes wrong in an iteration ends the repetition.

use crate::description::{Light, Object, Span};

use super::action::{Addition, SceneAction};
use super::builder::SceneBuilder;
use super::diagnostic::Diagnostic;
use super::keys::Arguments;

/// The most iterations of one `repeat`, and the most objects and lights of a scene with `repeat` or `scatter`.
pub(super) const MOST_ENTITIES: u32 = 1 << 24;

/// The most commands and iterations that a `repeat` and those within it may carry out.
const MOST_STEPS: u64 = 1 << 28;

/// How deep repeats nest.
const DEEPEST: usize = 32;

/// The repeats that are being read, the innermost last.
#[derive(Default)]
pub(super) struct OpenRepeats<'s>(Vec<Repeat<'s>>);

/// Lines that are carried out several times.
struct Repeat<'s> {
    /// The `repeat` with its number.
    opened: Span,
    count: u32,
    steps: Vec<RepeatStep<'s>>,
}

enum RepeatStep<'s> {
    Command(SceneAction, Arguments<'s>),
    Repeat(Repeat<'s>),
}

impl<'s> OpenRepeats<'s> {
    /// Carries a command out, or keeps it where it is to be repeated.
    pub(super) fn act(
        &mut self,
        scene: &mut SceneBuilder,
        action: SceneAction,
        arguments: Arguments<'s>,
    ) {
        match self.0.last_mut() {
            Some(repeat) => repeat.steps.push(RepeatStep::Command(action, arguments)),
            None => arguments.apply(action, scene),
        }
    }

    /// Begins to repeat.
    pub(super) fn begin(&mut self, opened: Span, count: u32) {
        self.0.push(Repeat { opened, count, steps: Vec::new() });
    }

    /// Ends the lines of the innermost `repeat`, and carries out what is complete.
    pub(super) fn end(&mut self, scene: &mut SceneBuilder, here: Span) {
        let Some(repeat) = self.0.pop() else {
            scene.report(
                Diagnostic::error(here, "`end_repeat` ends nothing")
                    .with_label("no `repeat` is open here")
                    .with_help("remove it, or add the `repeat` that it should end"),
            );
            return;
        };
        if self.0.len() >= DEEPEST {
            let message = format!("`repeat` nests more than {DEEPEST} deep");
            scene.report(
                Diagnostic::error(repeat.opened, message)
                    .with_label("this one is too deep")
                    .with_help("repeat fewer lines more often"),
            );
        } else if let Some(around) = self.0.last_mut() {
            around.steps.push(RepeatStep::Repeat(repeat));
        } else {
            match repeat.check(scene) {
                Ok(()) => repeat.run(scene, &here),
                Err(too_much) => scene.report(too_much),
            }
        }
    }

    /// Reports what is open when the scene ends.
    pub(super) fn report_unclosed(&mut self, scene: &mut SceneBuilder, end: &Span) {
        for repeat in self.0.drain(..) {
            scene.report(
                Diagnostic::error(repeat.opened, "`repeat` is never ended")
                    .with_label("begins here")
                    .with_related(end.clone(), "the scene ends here")
                    .with_help("add an `end_repeat` on a line of its own"),
            );
        }
    }
}

/// The memory that objects and lights take as they are read, and compiled for tracing.
fn bytes(objects: usize, lights: usize) -> u64 {
    /// An object as it is traced, and its share of growing lists, as measured.
    const COMPILED: usize = 100;
    let of_objects = objects.saturating_mul(size_of::<Object>() + COMPILED);
    of_objects.saturating_add(lights.saturating_mul(2 * size_of::<Light>())) as u64
}

/// What a repeat carries out in all. Counts saturate.
#[derive(Clone, Copy, Default)]
struct Totals {
    /// Commands and iterations.
    steps: u64,
    objects: u64,
    lights: u64,
}

impl Totals {
    fn of_command(action: SceneAction, arguments: &Arguments<'_>) -> Self {
        let (objects, lights) = match action.adds {
            Addition::Nothing => (0, 0),
            Addition::Object => (1, 0),
            Addition::Scattered => (arguments.scattered().map_or(0, |what| what.count.into()), 0),
            Addition::Light => (0, 1),
        };
        Self { steps: 1, objects, lights }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            steps: self.steps.saturating_add(other.steps),
            objects: self.objects.saturating_add(other.objects),
            lights: self.lights.saturating_add(other.lights),
        }
    }

    fn times(self, count: u32) -> Self {
        let times = |n: u64| n.saturating_mul(u64::from(count));
        Self { steps: times(self.steps), objects: times(self.objects), lights: times(self.lights) }
    }

    fn entities(self) -> u64 {
        self.objects.saturating_add(self.lights)
    }

    /// Makes room for all of it, for the command at a place.
    fn make_room(self, scene: &mut SceneBuilder, place: &Span) -> Result<(), Diagnostic> {
        let in_all = self.entities().saturating_add(scene.entity_count() as u64);
        if in_all > u64::from(MOST_ENTITIES) || self.steps > MOST_STEPS {
            return Err(self.excess(place, in_all));
        }
        let (objects, lights) = (self.objects as usize, self.lights as usize);
        let memory = scene.memory().filter(|&memory| memory < bytes(objects, lights));
        if memory.is_some() {
            return Err(lack_of_memory(place, objects, lights, memory));
        }
        scene.reserve(objects, lights).map_err(|_| lack_of_memory(place, objects, lights, None))
    }

    fn excess(self, place: &Span, in_all: u64) -> Diagnostic {
        let message = if in_all > u64::from(MOST_ENTITIES) {
            format!("this makes {} objects and lights", self.entities())
        } else {
            format!("this takes {} commands and iterations", self.steps)
        };
        let help = format!(
            "a scene with `repeat` or `scatter` has at most {MOST_ENTITIES} objects and lights, and a `repeat` \
             takes at most {MOST_STEPS} commands and iterations"
        );
        Diagnostic::error(place.clone(), message).with_label("too many").with_help(help)
    }
}

/// Makes room for the objects that a command scatters.
///
/// # Errors
/// If they are too many, or take too much memory.
pub(super) fn make_room(
    scene: &mut SceneBuilder,
    objects: u32,
    command: &Span,
) -> Result<(), Diagnostic> {
    Totals { objects: objects.into(), ..Totals::default() }.make_room(scene, command)
}

/// `available` is how much there is, where that is known.
fn lack_of_memory(
    place: &Span,
    objects: usize,
    lights: usize,
    available: Option<u64>,
) -> Diagnostic {
    let megabytes = |bytes: u64| bytes.div_ceil(1_000_000);
    let available = available.map_or_else(String::new, |available| {
        format!(", and {} MB are available", megabytes(available))
    });
    let message = format!(
        "this makes {} objects and lights, more than the memory can hold",
        objects + lights
    );
    let help = format!(
        "to read them takes {} MB{available}: make fewer, or let the program use more \
         memory",
        megabytes(bytes(objects, lights))
    );
    Diagnostic::error(place.clone(), message).with_label("too many").with_help(help)
}

impl Repeat<'_> {
    /// What it carries out in all.
    fn totals(&self) -> Totals {
        // A repeat without a command takes its iterations all the same.
        let iteration = Totals { steps: 1, ..Totals::default() };
        let of_step = |step: &RepeatStep<'_>| match step {
            RepeatStep::Command(action, arguments) => Totals::of_command(*action, arguments),
            RepeatStep::Repeat(repeat) => repeat.totals(),
        };
        self.steps.iter().map(of_step).fold(iteration, Totals::plus).times(self.count)
    }

    /// Makes room for what it adds before anything is carried out, so that a lack of memory is an
    /// error here, where the system reports it, and not in an iteration.
    ///
    /// # Errors
    /// If it adds or takes too much.
    fn check(&self, scene: &mut SceneBuilder) -> Result<(), Diagnostic> {
        self.totals().make_room(scene, &self.opened)
    }

    /// Carries it out, up to the first iteration in which something is wrong.
    fn run(&self, scene: &mut SceneBuilder, ended: &Span) {
        let errors_before = scene.error_count();
        for _ in 0..self.count {
            scene.begin_iteration(self.opened.clone());
            for step in &self.steps {
                match step {
                    RepeatStep::Command(action, arguments) => arguments.apply(*action, scene),
                    RepeatStep::Repeat(repeat) => repeat.run(scene, ended),
                }
            }
            scene.end_iteration(ended);
            if scene.error_count() > errors_before {
                return;
            }
        }
    }
}
