//! Keys: what the values of a command are at some frames. Between two of them the values go evenly from the one to the
//! other; before the first and behind the last they stay as they are.

use crate::description::Span;
use crate::scatter::ScatterRecipe;

use super::action::SceneAction;
use super::builder::SceneBuilder;
use super::command::SceneCommand;
use super::diagnostic::Diagnostic;
use super::lexer::Word;
use super::values::Values;

/// What a command is carried out with.
#[derive(Debug)]
pub(super) enum Arguments<'s> {
    /// The same values in every frame.
    Same(Values<'s>),
    /// Values that depend on the frame.
    Keyed(Track<'s>),
}

/// A command with its keys, in the order of their frames.
#[derive(Debug)]
pub(super) struct Track<'s> {
    command: &'static SceneCommand,
    first: Key<'s>,
    later: Vec<Key<'s>>,
}

/// The values of a command at a frame.
#[derive(Debug)]
pub(super) struct Key<'s> {
    /// The frame.
    pub(super) frame: f64,
    /// Where the frame is written.
    pub(super) at: Span,
    /// The values.
    pub(super) values: Values<'s>,
}

impl Arguments<'_> {
    /// What is scattered, for a command that scatters.
    pub(super) fn scattered(&self) -> Option<ScatterRecipe> {
        match self {
            Self::Same(values) => values.scattered(),
            Self::Keyed(_) => None,
        }
    }

    /// Carries a command out with what its values are now.
    pub(super) fn apply(&self, action: SceneAction, scene: &mut SceneBuilder) {
        match self {
            Self::Same(values) => (action.apply)(scene, values),
            Self::Keyed(track) => match track.now(scene.clock()) {
                Ok(values) => (action.apply)(scene, &values),
                Err(wrong) => scene.report(wrong),
            },
        }
    }
}

impl<'s> Track<'s> {
    /// A command with its first key.
    pub(super) fn begin(command: &'static SceneCommand, first: Key<'s>) -> Self {
        Self { command, first, later: Vec::new() }
    }

    /// The first frame and the last.
    pub(super) fn frames(&self) -> [f64; 2] {
        [self.first.frame, self.last().frame]
    }

    fn last(&self) -> &Key<'s> {
        self.later.last().unwrap_or(&self.first)
    }

    /// Adds a key of the same command.
    ///
    /// # Errors
    /// If its frame does not come after the last one.
    pub(super) fn go_on(&mut self, key: Key<'s>) -> Result<(), Diagnostic> {
        let last = self.last();
        if key.frame > last.frame {
            self.later.push(key);
            return Ok(());
        }
        let message = format!("frame {} does not come after frame {}", key.frame, last.frame);
        Err(Diagnostic::error(key.at, message)
            .with_label("the frame of this key")
            .with_related(last.at.clone(), "that of the key before it")
            .with_help("keys go from early frames to late ones; a line with `at` begins new ones"))
    }

    /// The values at a time, in frames.
    ///
    /// # Errors
    /// If a value between two keys is none that the command takes: a factor of `scale` that passes through 0.
    fn now(&self, time: f64) -> Result<Values<'s>, Diagnostic> {
        let mut before = &self.first;
        for after in &self.later {
            if time < after.frame && time > before.frame {
                let share = (time - before.frame) / (after.frame - before.frame);
                let values = before.values.towards(&after.values, share);
                return self.check(values, time);
            }
            if time < after.frame {
                break;
            }
            before = after;
        }
        Ok(before.values.towards(&before.values, 0.0))
    }

    fn check(&self, values: Values<'s>, time: f64) -> Result<Values<'s>, Diagnostic> {
        for (index, value) in self.command.values.iter().enumerate() {
            if let Some(complaint) = value.kind.complaint(values.number(index)) {
                let keyword = self.command.keyword;
                let what = format!("at frame {time} `{}` of `{keyword}` {complaint}", value.name);
                return Err(Diagnostic::error(values.span_of(index, index), what)
                    .with_label(format!(
                        "on the way from this to the next key it is {}",
                        values.number(index)
                    ))
                    .with_help("add a key between, or choose values that do not pass through it"));
            }
        }
        Ok(values)
    }
}

/// The keys that are being read: `at` begins them, `to` goes on.
#[derive(Debug, Default)]
pub(super) enum OpenTrack<'s> {
    /// None.
    #[default]
    Closed,
    /// Those of a command.
    Open {
        /// What the command does.
        action: SceneAction,
        /// The command's name in the line of `at`.
        begun: Span,
        /// The keys.
        track: Track<'s>,
    },
    /// One of the lines was wrong: it is reported, and what goes on with it need not be.
    Wrong,
}

impl<'s> OpenTrack<'s> {
    /// Goes on with a key of a command.
    ///
    /// # Errors
    /// If there is nothing to go on with, or it is another command, or the frame does not come after the last one.
    pub(super) fn go_on(
        &mut self,
        to: Word<'s>,
        command: &'static SceneCommand,
        key: Key<'s>,
    ) -> Result<(), Diagnostic> {
        let (begun, track) = match self {
            Self::Open { begun, track, .. } => (begun, track),
            Self::Wrong => return Ok(()),
            Self::Closed => return Err(goes_on_with_nothing(to)),
        };
        if track.command.keyword == command.keyword {
            return track.go_on(key);
        }
        let (own, other) = (command.keyword, track.command.keyword);
        let message = format!("`to` goes on with `{other}`, not with `{own}`");
        Err(Diagnostic::error(key.values.keyword(), message)
            .with_label("another command")
            .with_related(begun.clone(), "the keys began with this one")
            .with_help(format!("write `at FRAME {own} …` to begin keys of their own")))
    }
}

/// What is wrong with a `to` that follows no key.
pub(super) fn goes_on_with_nothing(to: Word<'_>) -> Diagnostic {
    Diagnostic::error(to.span(), "`to` goes on with nothing")
        .with_label("no line with `at` or `to` comes just before it")
        .with_help("begin with `at`: `at 0 translate 0 0 0`, then `to 30 translate 1 0 0`")
}
