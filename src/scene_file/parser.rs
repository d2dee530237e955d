//! Line after line: finds each line's command, reads its values, and carries it out.
//!
//! An error in one line is the error of that line alone. What the line was probably meant to open or
//! close is opened or closed all the same, so that its absence is not reported as well.

use std::collections::HashSet;

use crate::description::Span;

use super::action::{Action, KeyPlace, Row, SceneAction};
use super::builder::SceneBuilder;
use super::command::SceneCommand;
use super::commands;
use super::diagnostic::{Diagnostic, quoted};
use super::header::{self, FirstLine};
use super::keys::{Arguments, Key, OpenTrack, Track, goes_on_with_nothing};
use super::lexer::{self, Word};
use super::repeat::OpenRepeats;
use super::suggest::{did_you_mean, list_of_commands};
use super::text::{TextLine, lines};
use super::values::{self, Values};
use super::{Invalid, Parsed};

/// How strictly a scene is read.
#[derive(Clone, Debug, Default)]
pub struct ParseOptions {
    /// Unknown commands are skipped with a warning, as in the course's loader, and are no errors.
    pub lenient: bool,
    /// How many bytes of memory a `repeat` may take, if that is known.
    pub memory: Option<u64>,
    /// The frame, of a scene that moves.
    pub frame: u32,
}

/// Reads a whole scene. What is wrong comes in no particular order.
pub(super) fn read(source: &str, options: &ParseOptions) -> Result<Parsed, Invalid> {
    let mut parser = Parser { lenient: options.lenient, ..Parser::default() };
    parser.scene.limit_memory(options.memory);
    parser.scene.begin_at(options.frame);
    let header = header::check(source);
    parser.scene.report_all(header.diagnostic);
    if header.first_line == FirstLine::NoScene {
        return Err(parser.scene.into_invalid());
    }
    let is_missing = header.first_line == FirstLine::Missing;
    let mut lines = lines(source).skip(usize::from(!is_missing));
    for line in &mut lines {
        // A first line in another place was reported already.
        if is_missing && header::begins_scene(line) {
            continue;
        }
        parser.line(line);
        if parser.end.is_some() {
            break;
        }
    }
    if let Some((first, _)) = lines.find_map(lexer::keyword) {
        let warning = Diagnostic::warning(first.span(), "what follows `end` is not read")
            .with_label("the first line of it");
        parser.scene.report(warning);
    }
    parser.finish(source)
}

#[derive(Default)]
struct Parser<'s> {
    scene: SceneBuilder,
    repeats: OpenRepeats<'s>,
    /// The keys that the last lines were.
    track: OpenTrack<'s>,
    /// The commands that were read, or that an erroneous line was meant to be.
    written: HashSet<&'static str>,
    /// The place of `end`, once it was read.
    end: Option<Span>,
    lenient: bool,
    /// The list of all commands is help for one error; it would be noise in every one.
    commands_listed: bool,
}

impl<'s> Parser<'s> {
    fn line(&mut self, line: TextLine<'s>) {
        let Some((keyword, rest)) = lexer::keyword(line) else { return };
        match commands::find(keyword.text) {
            Some(Row { command, action: Action::Key(place) }) => {
                self.key(command, *place, keyword, rest);
            }
            row => {
                self.end_track();
                match row {
                    Some(row) => self.command(row, keyword, rest),
                    None => self.unknown(keyword, rest),
                }
            }
        }
    }

    /// A line of `at` or `to`: a frame, then another command.
    fn key(
        &mut self,
        own: &'static SceneCommand,
        place: KeyPlace,
        keyword: Word<'s>,
        rest: TextLine<'s>,
    ) {
        if place == KeyPlace::First {
            self.end_track();
        }
        let read = self.read_key(own, keyword, rest);
        let joined = match (read, place) {
            (Ok(Some((row, action, key))), KeyPlace::First) => {
                let begun = key.values.keyword();
                let track = Track::begin(&row.command, key);
                self.track = OpenTrack::Open { action, begun, track };
                Ok(())
            }
            (Ok(Some((row, _, key))), KeyPlace::Later) => {
                self.track.go_on(keyword, &row.command, key).map_err(|wrong| vec![wrong])
            }
            // What is skipped in a lenient reading has no keys.
            (Ok(None), _) => Err(Vec::new()),
            (Err(mut wrong), KeyPlace::Later) if matches!(self.track, OpenTrack::Closed) => {
                wrong.push(goes_on_with_nothing(keyword));
                Err(wrong)
            }
            (Err(wrong), _) => Err(wrong),
        };
        if let Err(wrong) = joined {
            self.scene.report_all(wrong);
            self.track = OpenTrack::Wrong;
        }
    }

    /// What a line of `at` or `to` says; `None` where its command is unknown and not to be read.
    fn read_key(
        &mut self,
        own: &'static SceneCommand,
        keyword: Word<'s>,
        rest: TextLine<'s>,
    ) -> Result<Option<(&'static Row, SceneAction, Key<'s>)>, Vec<Diagnostic>> {
        let words = lexer::values(rest);
        let [frame, inner, words @ ..] = &words[..] else {
            return Err(vec![values::too_few(own, keyword, &words)]);
        };
        let Some(row) = commands::find(inner.text) else {
            let (unknown, meant) = self.unknown_command(*inner);
            if let Some(row) = meant {
                self.written.insert(row.command.keyword);
            }
            self.scene.report(unknown);
            return if self.lenient { Ok(None) } else { Err(Vec::new()) };
        };
        self.written.insert(row.command.keyword);
        let Action::Scene(action) = row.action else { return Err(vec![has_no_keys(*inner)]) };
        if !action.is_keyed || !row.command.takes_numbers() {
            return Err(vec![has_no_keys(*inner)]);
        }
        let number = values::number(own, &own.values[0], *frame);
        let read = values::read(&row.command, *inner, words, commands::is_keyword);
        match (number, read) {
            (Ok(number), Ok(values)) => {
                self.scene.report_all(values::doubtful(&row.command, &values));
                Ok(Some((row, action, Key { frame: number, at: frame.span(), values })))
            }
            (number, read) => {
                Err(number.err().into_iter().chain(read.err().into_iter().flatten()).collect())
            }
        }
    }

    /// Carries out the command of the keys that the last lines were.
    fn end_track(&mut self) {
        if let OpenTrack::Open { action, track, .. } = std::mem::take(&mut self.track) {
            self.scene.note_keys(track.frames());
            self.repeats.act(&mut self.scene, action, Arguments::Keyed(track));
        }
    }

    fn command(&mut self, row: &'static Row, keyword: Word<'s>, rest: TextLine<'s>) {
        let command = &row.command;
        self.written.insert(command.keyword);
        let words = if command.takes_name() { lexer::names(rest) } else { lexer::values(rest) };
        match values::read(command, keyword, &words, commands::is_keyword) {
            Ok(values) => {
                self.note_mesh(command, &values);
                self.scene.report_all(values::doubtful(command, &values));
                self.carry_out(row.action, values);
            }
            Err(wrong) => {
                self.scene.report_all(wrong);
                self.open_or_close(row, keyword);
                self.braces_among(words.get(command.values.len()..).unwrap_or_default());
            }
        }
    }

    /// Notes the mesh that a command names: the lines of a `repeat` that is wrong are never carried out.
    fn note_mesh(&mut self, command: &SceneCommand, values: &Values<'s>) {
        if command.takes_name() {
            self.scene.note_mesh(values.name(), values.span_of(0, 0));
        }
    }

    /// Carries a command out, or keeps it for the `repeat` around it.
    fn carry_out(&mut self, action: Action, values: Values<'s>) {
        match action {
            Action::Scene(action) => {
                self.repeats.act(&mut self.scene, action, Arguments::Same(values));
            }
            // Its lines are joined as they are read.
            Action::Key(_) => {}
            Action::Repeat => self.repeats.begin(values.span(), values.whole(0)),
            Action::EndRepeat => self.repeats.end(&mut self.scene, values.keyword()),
            Action::End => {
                self.repeats.report_unclosed(&mut self.scene, &values.keyword());
                self.end = Some(values.keyword());
            }
        }
    }

    /// What is wrong with a word where a command should be, and the command that it was meant to be.
    fn unknown_command(&mut self, keyword: Word<'s>) -> (Diagnostic, Option<&'static Row>) {
        let meant = did_you_mean(keyword.text);
        let question = meant.map(|row| format!(", did you mean `{}`?", row.command.keyword));
        let message =
            format!("unknown command {}{}", quoted(keyword.text), question.unwrap_or_default());
        let mut diagnostic = if self.lenient {
            Diagnostic::warning(keyword.span(), message).with_label("this line is not read")
        } else {
            Diagnostic::error(keyword.span(), message).with_label("no command has this name")
        };
        if let Some(Row { command, .. }) = meant {
            diagnostic =
                diagnostic.with_help(format!("`{}`: {}", command.usage(), command.summary));
        } else if !std::mem::replace(&mut self.commands_listed, true) {
            diagnostic = diagnostic.with_help(list_of_commands());
        }
        (diagnostic, meant)
    }

    fn unknown(&mut self, keyword: Word<'s>, rest: TextLine<'s>) {
        let (diagnostic, meant) = self.unknown_command(keyword);
        self.scene.report(diagnostic);
        if let Some(row) = meant.filter(|_| !self.lenient) {
            self.written.insert(row.command.keyword);
            self.open_or_close(row, keyword);
            let names = lexer::names(rest);
            if let Ok(values) = values::read(&row.command, keyword, &names, commands::is_keyword) {
                self.note_mesh(&row.command, &values);
            }
        }
    }

    /// Carries out a command whose line is wrong, where it may open or close something.
    fn open_or_close(&mut self, row: &'static Row, keyword: Word<'s>) {
        if matches!(row.action, Action::Repeat) {
            self.repeats.begin(keyword.span(), 1);
        } else if let Ok(values) = values::read(&row.command, keyword, &[], commands::is_keyword) {
            self.carry_out(row.action, values);
        }
    }

    /// Carries out the braces among words that are too many for a command.
    fn braces_among(&mut self, words: &[Word<'s>]) {
        for word in words.iter().filter(|word| lexer::is_brace(word.text)) {
            if let Some(row) = commands::find(word.text) {
                self.open_or_close(row, *word);
            }
        }
    }

    /// Checks the scene as a whole.
    fn finish(mut self, source: &str) -> Result<Parsed, Invalid> {
        self.end_track();
        let end = self.end.unwrap_or_else(|| end_of(source));
        self.repeats.report_unclosed(&mut self.scene, &end);
        self.scene.report_all(commands::camera::missing(&self.written, &end));
        self.scene.finish(&end)
    }
}

/// What is wrong with keys of a command that is the same in every frame.
fn has_no_keys(command: Word<'_>) -> Diagnostic {
    let message = format!("{} cannot have other values in other frames", quoted(command.text));
    Diagnostic::error(command.span(), message).with_label("the same in every frame").with_help(
        "what can move is the camera's place, direction and angle, the background, materials, \
             transforms, deformations, lights, `ball` and `triangle`",
    )
}

/// Where a scene without `end` ends: behind its last word.
fn end_of(source: &str) -> Span {
    let end = source.trim_end().len();
    end..end
}
