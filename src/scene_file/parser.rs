//! Line after line: finds each line's command, reads its values, lets it act.
//!
//! An error in one line is the error of that line alone. What the line was probably meant to do to
//! the structure of the scene is done all the same, so that its absence is not reported as well.

use crate::description::{SceneDescription, Span};

use super::builder::Builder;
use super::command::Command;
use super::diagnostic::{Diagnostic, quoted};
use super::header::{self, Verdict};
use super::lexer::{self, Word};
use super::repeat::Recorder;
use super::suggest::{did_you_mean, list_of_commands};
use super::text::{Line, lines};
use super::values;
use super::{ParseOptions, table};

/// Reads a whole scene. What is wrong comes in no particular order.
pub(super) fn read(
    source: &str,
    options: &ParseOptions,
) -> (Option<SceneDescription>, Vec<Diagnostic>) {
    let mut parser = Parser {
        builder: Builder::new(),
        recorder: Recorder::default(),
        lenient: options.lenient,
        commands_listed: false,
    };
    let header = header::check(source);
    parser.builder.diagnostics.extend(header.diagnostic);
    if header.verdict == Verdict::NoScene {
        return (None, parser.builder.diagnostics);
    }
    let mut lines = lines(source).skip(usize::from(header.verdict != Verdict::Missing));
    for line in &mut lines {
        // A first line that stands elsewhere was reported already.
        if header.verdict == Verdict::Missing && header::begins_scene(line) {
            continue;
        }
        parser.line(line);
        if parser.builder.end.is_some() {
            break;
        }
    }
    if let Some((first, _)) = lines.find_map(lexer::keyword) {
        let warning = Diagnostic::warning(first.span(), "what follows `end` is not read")
            .with_label("the first line of it");
        parser.builder.report(warning);
    }
    let end = parser.builder.end.take().unwrap_or_else(|| end_of(source));
    parser.recorder.report_unclosed(&mut parser.builder, &end);
    parser.builder.finish(end)
}

/// Where a scene without `end` ends: behind its last word.
fn end_of(source: &str) -> Span {
    let end = source.trim_end().len();
    end..end
}

struct Parser<'s> {
    builder: Builder,
    recorder: Recorder<'s>,
    lenient: bool,
    /// The list of all commands is help for one error; it would be noise in every one.
    commands_listed: bool,
}

impl<'s> Parser<'s> {
    fn line(&mut self, line: Line<'s>) {
        let Some((keyword, rest)) = lexer::keyword(line) else { return };
        match table::find(keyword.text) {
            Some(command) => self.command(command, keyword, rest),
            None => self.unknown(keyword),
        }
    }

    fn command(&mut self, command: &'static Command, keyword: Word<'s>, rest: Line<'s>) {
        self.builder.seen.insert(command.keyword);
        let words = if command.takes_name() { lexer::names(rest) } else { lexer::values(rest) };
        match values::read(command, keyword, &words) {
            Ok(values) => self.recorder.act(&mut self.builder, command, values),
            Err(wrong) => {
                self.builder.diagnostics.extend(wrong);
                self.recover(command, keyword, &words);
            }
        }
    }

    /// Opens and closes what an erroneous line opens and closes.
    fn recover(&mut self, command: &'static Command, keyword: Word<'s>, words: &[Word<'s>]) {
        self.open_or_close(command, keyword);
        for word in words.iter().skip(command.values.len()) {
            if let Some(brace) = table::find(word.text).filter(|c| matches!(c.keyword, "{" | "}")) {
                self.act_without_values(brace, *word);
            }
        }
    }

    fn unknown(&mut self, keyword: Word<'s>) {
        let meant = did_you_mean(keyword.text);
        let question = meant.map(|c| format!(", did you mean `{}`?", c.keyword));
        let message =
            format!("unknown command {}{}", quoted(keyword.text), question.unwrap_or_default());
        let mut diagnostic = if self.lenient {
            Diagnostic::warning(keyword.span(), message).with_label("this line is not read")
        } else {
            Diagnostic::error(keyword.span(), message).with_label("no command has this name")
        };
        if let Some(command) = meant {
            diagnostic =
                diagnostic.with_help(format!("`{}`: {}", command.usage(), command.summary));
        } else if !std::mem::replace(&mut self.commands_listed, true) {
            diagnostic = diagnostic.with_help(list_of_commands());
        }
        self.builder.report(diagnostic);
        if let Some(command) = meant.filter(|_| !self.lenient) {
            self.builder.seen.insert(command.keyword);
            self.open_or_close(command, keyword);
        }
    }

    /// Acts as a command that may open or close something, though its line is wrong.
    fn open_or_close(&mut self, command: &'static Command, keyword: Word<'s>) {
        if command.keyword == "repeat" {
            self.recorder.begin(keyword.span(), 1);
        } else if command.values.is_empty() {
            self.act_without_values(command, keyword);
        }
    }

    fn act_without_values(&mut self, command: &'static Command, word: Word<'s>) {
        if let Ok(values) = values::read(command, word, &[]) {
            self.recorder.act(&mut self.builder, command, values);
        }
    }
}
