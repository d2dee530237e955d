//! `repeat`: the lines up to its `end_repeat` are read once and carried out many times.
//!
//! The transform, and the material, go on from one turn to the next and behind the last; scopes that
//! a turn opens it closes. What a line means is checked as it is read, so what is wrong with it is
//! told once; what is wrong in a turn is told of the first such turn, which is the last.

use crate::description::{Light, Object, Span};

use super::builder::Builder;
use super::command::{Command, Group};
use super::diagnostic::Diagnostic;
use super::scopes;
use super::values::Values;

/// The most turns of one `repeat`, and the most objects and lights of a scene that repeats.
pub(super) const MOST_OBJECTS: u32 = 1 << 24;

/// The most commands that a `repeat` and those within it may carry out.
const MOST_COMMANDS: u64 = 1 << 28;

/// How deep repeats nest.
const DEEPEST: usize = 32;

/// The repeats that are being read, the innermost last.
#[derive(Default)]
pub(super) struct Recorder<'s> {
    open: Vec<Block<'s>>,
}

/// What a `repeat` carries out.
struct Block<'s> {
    /// The `repeat` with its number.
    opened: Span,
    turns: u32,
    steps: Vec<Step<'s>>,
}

enum Step<'s> {
    Command(&'static Command, Values<'s>),
    Repeat(Block<'s>),
}

/// The commands of the table that [`Recorder::act`] itself acts on.
pub(super) fn acted_on_by_the_recorder(_: &mut Builder, _: &Values<'_>) {}

impl<'s> Recorder<'s> {
    /// Carries a command out, or keeps it where it is to be repeated.
    pub(super) fn act(
        &mut self,
        builder: &mut Builder,
        command: &'static Command,
        values: Values<'s>,
    ) {
        match command.keyword {
            "repeat" => self.begin(values.span.clone(), values.whole(0)),
            "end_repeat" => self.end(builder, values.keyword),
            "end" => {
                self.report_unclosed(builder, &values.keyword);
                (command.apply)(builder, &values);
            }
            _ => match self.open.last_mut() {
                Some(block) => block.steps.push(Step::Command(command, values)),
                None => (command.apply)(builder, &values),
            },
        }
    }

    /// Begins to repeat.
    pub(super) fn begin(&mut self, opened: Span, turns: u32) {
        self.open.push(Block { opened, turns, steps: Vec::new() });
    }

    fn end(&mut self, builder: &mut Builder, here: Span) {
        let Some(block) = self.open.pop() else {
            builder.report(
                Diagnostic::error(here, "`end_repeat` ends nothing")
                    .with_label("no `repeat` is open here")
                    .with_help("remove it, or add the `repeat` that it should end"),
            );
            return;
        };
        if self.open.len() >= DEEPEST {
            let message = format!("`repeat` nests more than {DEEPEST} deep");
            builder.report(
                Diagnostic::error(block.opened, message)
                    .with_label("this one is too deep")
                    .with_help("repeat fewer lines more often"),
            );
        } else if let Some(around) = self.open.last_mut() {
            around.steps.push(Step::Repeat(block));
        } else if let Some(excess) = block.excess(builder).or_else(|| block.lack(builder)) {
            builder.report(excess);
        } else {
            block.run(builder, &here);
        }
    }

    /// Reports what is open when the scene ends.
    pub(super) fn report_unclosed(&mut self, builder: &mut Builder, end: &Span) {
        for block in self.open.drain(..) {
            builder.report(
                Diagnostic::error(block.opened, "`repeat` is never ended")
                    .with_label("begins here")
                    .with_related(end.clone(), "the scene ends here")
                    .with_help("add an `end_repeat` on a line of its own"),
            );
        }
    }
}

/// Whether a command adds something to the scene.
fn makes_something(command: &Command) -> bool {
    matches!(command.group, Group::Object | Group::Light)
}

impl Block<'_> {
    /// How many commands of a kind are carried out.
    fn count(&self, is_counted: &impl Fn(&Command) -> bool) -> u64 {
        let of_step = |step: &Step<'_>| match step {
            Step::Command(command, _) => u64::from(is_counted(command)),
            Step::Repeat(block) => block.count(is_counted),
        };
        let once = self.steps.iter().map(of_step).fold(0, u64::saturating_add);
        once.saturating_mul(u64::from(self.turns))
    }

    /// What is wrong if it makes, or takes, too much. Asked before anything is carried out.
    fn excess(&self, builder: &Builder) -> Option<Diagnostic> {
        let objects = self.count(&makes_something);
        let in_all = objects.saturating_add(builder.entity_count() as u64);
        // A repeat without a command takes its turns all the same.
        let commands = self.count(&|_| true).saturating_add(self.turn_count());
        let message = if in_all > u64::from(MOST_OBJECTS) {
            format!("this makes {objects} objects and lights")
        } else if commands > MOST_COMMANDS {
            format!("this takes {commands} commands and turns")
        } else {
            return None;
        };
        let help = format!(
            "a scene that repeats has at most {MOST_OBJECTS} objects and lights, and a `repeat` \
             takes at most {MOST_COMMANDS} commands and turns"
        );
        Some(Diagnostic::error(self.opened.clone(), message).with_label("too many").with_help(help))
    }

    /// What is wrong if there is no memory for what it makes. Makes room for it before anything is
    /// carried out, so that no turn asks for memory that
    /// is not there, where the system tells.
    fn lack(&self, builder: &mut Builder) -> Option<Diagnostic> {
        let objects = self.count(&|command| matches!(command.group, Group::Object)) as usize;
        let lights = self.count(&|command| matches!(command.group, Group::Light)) as usize;
        builder.reserve(objects, lights).err()?;
        let bytes = objects * size_of::<Object>() + lights * size_of::<Light>();
        let message = format!(
            "this makes {} objects and lights, more than the memory can hold",
            objects + lights
        );
        let help = format!(
            "to read them takes {} MB: repeat fewer times, or let the program use more memory",
            bytes.div_ceil(1_000_000)
        );
        Some(Diagnostic::error(self.opened.clone(), message).with_label("too many").with_help(help))
    }

    /// How many turns it and those within it take.
    fn turn_count(&self) -> u64 {
        let of_step = |step: &Step<'_>| match step {
            Step::Command(..) => 0,
            Step::Repeat(block) => block.turn_count(),
        };
        let once = self.steps.iter().map(of_step).fold(1, u64::saturating_add);
        once.saturating_mul(u64::from(self.turns))
    }

    /// Carries it out, up to the first turn in which something is wrong.
    fn run(&self, builder: &mut Builder, ended: &Span) {
        let before = builder.diagnostics.len();
        for _ in 0..self.turns {
            scopes::begin_turn(builder, self.opened.clone());
            for step in &self.steps {
                match step {
                    Step::Command(command, values) => (command.apply)(builder, values),
                    Step::Repeat(block) => block.run(builder, ended),
                }
            }
            scopes::end_turn(builder, ended);
            if builder.diagnostics[before..].iter().any(Diagnostic::is_error) {
                return;
            }
        }
    }
}
