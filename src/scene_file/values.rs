//! The words behind a keyword → values of the kinds that its command takes.
//!
//! Checks each value by itself: how many there are, whether they are numbers, and within their
//! bounds. Whether they make sense together is for the command's action to check.

use glam::DVec3;

use crate::description::Span;
use crate::math::Color;
use crate::scatter::{ScatterError, ScatterRecipe};

use super::command::{SceneCommand, Value, ValueKind};
use super::diagnostic::{Diagnostic, counted, quoted};
use super::lexer::Word;
use super::precision::{is_zero, is_zero_vector};

/// A command's values, as many and of such kinds as the command takes.
#[derive(Debug)]
pub(super) struct Values<'s> {
    keyword: Span,
    spans: Vec<Span>,
    numbers: Vec<f64>,
    name: &'s str,
    scattered: Option<ScatterRecipe>,
}

impl Values<'_> {
    /// From the keyword to the last value.
    pub(super) fn span(&self) -> Span {
        self.keyword.start..self.spans.last().unwrap_or(&self.keyword).end
    }

    /// The span of the keyword.
    pub(super) fn keyword(&self) -> Span {
        self.keyword.clone()
    }

    /// From one value to a later one.
    pub(super) fn span_of(&self, first: usize, last: usize) -> Span {
        self.spans[first].start..self.spans[last].end
    }

    /// The file's name, for a command that takes one.
    pub(super) fn name(&self) -> &str {
        self.name
    }

    /// What is scattered, for a command that scatters.
    pub(super) fn scattered(&self) -> Option<ScatterRecipe> {
        self.scattered
    }

    /// The number at an index among the numbers; an index beyond those of the command is a slip in
    /// its action.
    pub(super) fn number(&self, index: usize) -> f64 {
        self.numbers[index]
    }

    /// The number at an index as single precision, which it is known to fit.
    pub(super) fn single(&self, index: usize) -> f32 {
        self.numbers[index] as f32
    }

    /// The whole number at an index, whose bounds were checked.
    pub(super) fn whole(&self, index: usize) -> u32 {
        self.numbers[index] as u32
    }

    /// Three numbers from an index on.
    pub(super) fn vector(&self, index: usize) -> DVec3 {
        DVec3::new(self.number(index), self.number(index + 1), self.number(index + 2))
    }

    /// Three numbers from an index on, as a colour.
    pub(super) fn color(&self, index: usize) -> Color {
        self.vector(index).as_vec3()
    }

    /// These values on the way to others of the same command, a share of the way from them; exactly these for 0.
    /// The places are of these.
    pub(super) fn towards(&self, other: &Self, share: f64) -> Self {
        // Rounding leads beyond neither end, so that what lies between two bounds stays there.
        let between = |(&a, &b): (&f64, &f64)| (a + share * (b - a)).clamp(a.min(b), a.max(b));
        Self {
            keyword: self.keyword.clone(),
            spans: self.spans.clone(),
            numbers: self.numbers.iter().zip(&other.numbers).map(between).collect(),
            name: self.name,
            scattered: self.scattered,
        }
    }

    /// Three numbers from an index on, if they are a vector with a direction.
    pub(super) fn nonzero_vector(&self, index: usize) -> Option<DVec3> {
        Some(self.vector(index)).filter(|vector| !is_zero_vector(*vector))
    }
}

/// Reads the values of a command. `is_keyword` recognizes the commands of the format, for the help
/// where there are too many words.
///
/// # Errors
/// All that is wrong with them, unless their number is; then that alone.
pub(super) fn read<'s>(
    command: &SceneCommand,
    keyword: Word<'s>,
    words: &[Word<'s>],
    is_keyword: impl Fn(&str) -> bool,
) -> Result<Values<'s>, Vec<Diagnostic>> {
    check_count(command, keyword, words, is_keyword).map_err(|wrong| vec![wrong])?;
    let mut wrong = Vec::new();
    let mut values = Values {
        keyword: keyword.span(),
        spans: words.iter().map(Word::span).collect(),
        numbers: Vec::with_capacity(words.len()),
        name: "",
        scattered: None,
    };
    for (value, word) in command.values.iter().zip(words) {
        let read = match value.kind {
            ValueKind::Name => name(*word).map(|name| values.name = name),
            ValueKind::Scatter => scatter(*word).map(|recipe| values.scattered = Some(recipe)),
            _ => number(command, value, *word).map(|number| values.numbers.push(number)),
        };
        wrong.extend(read.err());
    }
    if wrong.is_empty() { Ok(values) } else { Err(wrong) }
}

/// A warning of values that can be used, but hardly were meant: of reflectances above 1.
pub(super) fn doubtful(command: &SceneCommand, values: &Values<'_>) -> Option<Diagnostic> {
    let is_above =
        |&i: &usize| command.values[i].kind == ValueKind::Reflectance && values.numbers[i] > 1.0;
    let above: Vec<_> = (0..values.numbers.len()).filter(is_above).collect();
    let (first, last) = (*above.first()?, *above.last()?);
    let names: Vec<_> = above.iter().map(|&i| command.values[i].name).collect();
    let label = match names[..] {
        [one] => format!("{one} is above 1"),
        [one, other] => format!("{one} and {other} are above 1"),
        _ => format!("{} are above 1", names.join(", ")),
    };
    let message =
        format!("with this `{}` a surface reflects more light than it gets", command.keyword);
    let help = format!("reflectances go from 0 to 1, for example `{}`", command.example);
    let warning = Diagnostic::warning(values.span_of(first, last), message);
    Some(warning.with_label(label).with_help(help))
}

fn check_count(
    command: &SceneCommand,
    keyword: Word<'_>,
    words: &[Word<'_>],
    is_keyword: impl Fn(&str) -> bool,
) -> Result<(), Diagnostic> {
    let takes = command.values.len();
    if words.len() < takes {
        Err(too_few(command, keyword, words))
    } else if words.len() > takes {
        Err(surplus(command, words, is_keyword))
    } else {
        Ok(())
    }
}

/// `ball` takes 4 values (radius x y z), found 3.
fn count_message(command: &SceneCommand, found: usize) -> String {
    let takes = match command.values.len() {
        0 => "no values".to_owned(),
        n => format!("{} ({})", counted(n, "value"), command.value_names()),
    };
    format!("`{}` takes {takes}, found {found}", command.keyword)
}

/// What is wrong where values are missing.
pub(super) fn too_few(command: &SceneCommand, keyword: Word<'_>, words: &[Word<'_>]) -> Diagnostic {
    let end = words.last().unwrap_or(&keyword).end();
    let missing: Vec<_> =
        command.values[words.len()..].iter().map(|v| format!("`{}`", v.name)).collect();
    let (last, before) = missing.split_last().map_or(("", &[][..]), |(l, b)| (l.as_str(), b));
    let label = match before {
        [] => format!("{last} is missing here"),
        _ => format!("{} and {last} are missing here", before.join(", ")),
    };
    Diagnostic::error(end..end, count_message(command, words.len()))
        .with_label(label)
        .with_help(command.how_to_write())
}

fn surplus(
    command: &SceneCommand,
    words: &[Word<'_>],
    is_keyword: impl Fn(&str) -> bool,
) -> Diagnostic {
    let too_many = &words[command.values.len()..];
    let span = too_many[0].start..too_many[too_many.len() - 1].end();
    let begins_command = too_many.iter().any(|word| is_keyword(word.text));
    let help = if begins_command {
        "every command begins a line of its own; comments begin with `#` or `//`".to_owned()
    } else if command.takes_name() {
        "put a name that contains spaces between double quotes: `\"my mesh.obj\"`".to_owned()
    } else {
        format!("{}; comments begin with `#` or `//`", command.how_to_write())
    };
    Diagnostic::error(span, count_message(command, words.len()))
        .with_label(format!("{} too many", counted(too_many.len(), "value")))
        .with_help(help)
}

/// A finite number that the command takes here.
pub(super) fn number(
    command: &SceneCommand,
    value: &Value,
    word: Word<'_>,
) -> Result<f64, Diagnostic> {
    // Formatted only where something is wrong: this runs for every number of a scene.
    let what = || format!("`{}` of `{}`", value.name, command.keyword);
    let Ok(number) = word.text.parse::<f64>() else {
        return Err(not_a_number(command, value, word).with_help(number_help(command, word)));
    };
    // `1e999` reads as infinity, but its author wrote no such thing.
    let digits = word.text.contains(|c: char| c.is_ascii_digit());
    if !digits {
        return Err(Diagnostic::error(word.span(), format!("{} must be a finite number", what()))
            .with_label(format!("{} is not finite", quoted(word.text)))
            .with_help(command.how_to_write()));
    }
    if !(number as f32).is_finite() {
        return Err(Diagnostic::error(word.span(), format!("{} is too large", what()))
            .with_label("beyond single precision")
            .with_help(format!("numbers go from {:e} to {:e}", f32::MIN, f32::MAX)));
    }
    match value.kind.complaint(number) {
        Some(complaint) => Err(Diagnostic::error(word.span(), format!("{} {complaint}", what()))
            .with_label(out_of_bounds(number))
            .with_help(command.how_to_write())),
        None => Ok(number),
    }
}

fn not_a_number(command: &SceneCommand, value: &Value, word: Word<'_>) -> Diagnostic {
    let message = format!("{} is not a number", quoted(word.text));
    let right = match value.kind {
        ValueKind::Number | ValueKind::Reflectance => "a number".to_owned(),
        ValueKind::Whole(..) => value.kind.to_string(),
        kind => format!("a number {kind}"),
    };
    let what = format!("`{}` of `{}` must be {right}", value.name, command.keyword);
    Diagnostic::error(word.span(), message).with_label(what)
}

/// What would be right in place of something that is not a number.
fn number_help(command: &SceneCommand, word: Word<'_>) -> String {
    if word.text.ends_with(',') {
        "values are separated by spaces alone, without commas".to_owned()
    } else if word.text.replacen(',', ".", 1).parse::<f64>().is_ok() {
        "write a decimal point, not a comma".to_owned()
    } else {
        command.how_to_write()
    }
}

fn out_of_bounds(number: f64) -> String {
    if number != 0.0 && is_zero(number) {
        format!("smaller than {:e} counts as 0", f32::MIN_POSITIVE)
    } else {
        format!("this is {number}")
    }
}

/// What is scattered.
fn scatter(word: Word<'_>) -> Result<ScatterRecipe, Diagnostic> {
    ScatterRecipe::parse(word.text).map_err(|error| {
        let what = match error {
            ScatterError::UnknownKind { .. } => "no such kind",
            ScatterError::BadCount { .. } => "how many",
            ScatterError::BadSeed { .. } => "the seed",
            ScatterError::WrongParts { .. } => "not of the form KIND:COUNT[:SEED]",
        };
        let help = error.help();
        Diagnostic::error(word.span(), error.to_string()).with_label(what).with_help(help)
    })
}

/// The name of a file, without its quotes.
fn name<'s>(word: Word<'s>) -> Result<&'s str, Diagnostic> {
    let Some(inner) = word.text.strip_prefix('"') else {
        return Ok(word.text);
    };
    match inner.strip_suffix('"') {
        Some("") => Err(Diagnostic::error(word.span(), "the name of the file is empty")
            .with_help("write the path of a mesh, relative to the folder of the scene")),
        Some(name) => Ok(name),
        None => Err(Diagnostic::error(word.span(), "the quote is not closed")
            .with_label("opened here")
            .with_help("end the name with `\"` on the same line")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene_file::command::XYZ;

    fn read_number(text: &str) -> Result<f64, String> {
        let command = SceneCommand {
            keyword: "move",
            values: XYZ,
            summary: "",
            example: "move 1 0 0",
            also_called: &[],
        };
        number(&command, &command.values[0], Word { text, start: 0 }).map_err(|e| e.message)
    }

    #[test]
    fn numbers_are_read_in_every_usual_form() {
        let forms = [(".5", 0.5), ("5.", 5.0), ("-0", -0.0), ("1e-3", 1e-3), ("+1", 1.0)];
        for (text, value) in forms {
            assert_eq!(read_number(text).map(f64::to_bits), Ok(f64::to_bits(value)), "{text}");
        }
        assert_eq!(read_number("1E3"), Ok(1000.0));
        assert_eq!(read_number("1e-60"), Ok(1e-60));
    }

    #[test]
    fn what_is_no_finite_number_is_refused() {
        for text in ["x", "1,5", "1e", "0x10", "--1", "1.2.3", "\"1\"", "-"] {
            assert!(read_number(text).unwrap_err().ends_with("is not a number"), "{text}");
        }
        for text in ["nan", "NaN", "inf", "-inf", "infinity"] {
            assert!(read_number(text).unwrap_err().ends_with("finite number"), "{text}");
        }
        for text in ["1e39", "-1e999", "3.5e38"] {
            assert!(read_number(text).unwrap_err().ends_with("too large"), "{text}");
        }
    }
}
