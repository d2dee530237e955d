//! What `--accel` may name: the structures of the library, and those that a program of your own
//! adds ([`run_with`](super::run_with)), each with options of its own.
//! Knows no other option of the command.

use std::ffi::OsStr;
use std::fmt::Write;

use clap::builder::{PossibleValue, PossibleValuesParser, StringValueParser, TypedValueParser};
use clap::{Arg, Command};

use super::exit::Failure;
use super::near::nearest;
use crate::accel::{Allowed, OptionError, OptionInfo};
use crate::scene::{PEERS, STRUCTURES, Structure};

/// All that can be named, in the order in which the help lists them.
#[derive(Clone, Debug)]
pub(crate) struct Structures(Vec<Structure>);

/// Some of them, as named between commas.
#[derive(Clone, Debug)]
pub(crate) struct StructureList(pub(crate) Vec<Structure>);

impl StructureList {
    /// Those of several lists.
    pub(crate) fn joined(lists: &[Self]) -> Vec<Structure> {
        lists.iter().flat_map(|list| &list.0).copied().collect()
    }
}

impl Structures {
    /// Those of the library and some more.
    pub(crate) fn with(extra: &[Structure]) -> Result<Self, Failure> {
        if let Some(one) = extra.iter().find(|one| !is_name(one.name)) {
            return Err(Failure::new(format_args!(
                "a structure cannot be called `{}`: a name is of the letters A–Z and a–z, digits, \
                 `_` and `-`",
                one.name
            )));
        }
        let mut all = [STRUCTURES, extra].concat();
        all.extend(PEERS);
        let twice =
            (1..all.len()).find(|&i| all[..i].iter().any(|other| other.name == all[i].name));
        match twice {
            Some(i) => {
                Err(Failure::new(format_args!("two structures are called `{}`", all[i].name)))
            }
            None => Ok(Self(all)),
        }
    }

    /// All of them.
    pub(super) fn all(&self) -> &[Structure] {
        &self.0
    }

    /// The argument, with the options of all structures in its long help.
    pub(crate) fn explained_in(&self, arg: Arg) -> Arg {
        let short = arg.get_help().map(ToString::to_string).unwrap_or_default();
        arg.long_help(format!("{short}\n\n{}", self.options_in_words()))
    }

    /// What options there are, a line each.
    fn options_in_words(&self) -> String {
        let mut text =
            "A structure's options follow its name: NAME:OPTION=VALUE,OPTION=VALUE\n".to_owned();
        for one in &self.0 {
            for option in one.offered_options() {
                let values = values_in_words(option);
                let (of, name, summary, default) =
                    (one.name, option.name, option.summary, option.default);
                // Text takes what is written to it.
                let _ = write!(text, "\n  {of}:{name}={values}  {summary} [default: {default}]");
            }
        }
        text
    }

    /// Those that a comparison takes where none is named.
    pub(crate) fn compared_by_default(&self) -> StructureList {
        StructureList(self.0.iter().copied().filter(|one| !one.on_request).collect())
    }

    /// Those that are held to equal hits where none is named: all but the peers.
    pub(crate) fn checked_by_default(&self) -> StructureList {
        StructureList(self.0.iter().copied().filter(|one| !one.peer).collect())
    }

    /// Takes one, with its options.
    pub(crate) fn parser(&self) -> impl TypedValueParser<Value = Structure> + use<> {
        StructureParser(self.clone())
    }

    /// Takes several, with commas between them. What has the form `OPTION=VALUE` belongs to the one
    /// before it.
    pub(crate) fn list_parser(&self) -> impl TypedValueParser<Value = StructureList> + use<> {
        ListParser(self.clone())
    }

    /// The one that a text names, with its options.
    pub(crate) fn find(&self, text: &str) -> Result<Structure, String> {
        let (name, options) = parts(text);
        let found = self.0.iter().find(|one| one.name == name);
        let found = found.ok_or_else(|| format!("there is no structure `{name}`"))?;
        match options {
            None => Ok(*found),
            Some(options) => found.with_options(options).map_err(|error| in_words(&error)),
        }
    }

    /// The names, as the parser of clap's own that words the errors of unknown ones.
    fn names(&self) -> PossibleValuesParser {
        let value = |one: &Structure| PossibleValue::new(one.name).help(one.summary);
        PossibleValuesParser::new(self.0.iter().map(value).collect::<Vec<_>>())
    }
}

/// What an option may be: `sah|ploc`, or `1..8`.
pub(super) fn values_in_words(option: &OptionInfo) -> String {
    match option.allowed {
        Allowed::Words(words) => words.join("|"),
        Allowed::Numbers(least, most) => format!("{least}..{most}"),
    }
}

#[derive(Clone)]
struct StructureParser(Structures);

impl TypedValueParser for StructureParser {
    type Value = Structure;

    fn parse_ref(
        &self,
        command: &Command,
        arg: Option<&Arg>,
        value: &OsStr,
    ) -> Result<Structure, clap::Error> {
        let structures = self.0.clone();
        let text = value.to_string_lossy();
        let (name, _) = parts(&text);
        structures.names().parse_ref(command, arg, OsStr::new(name))?;
        StringValueParser::new()
            .try_map(move |text| structures.find(&text))
            .parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        // For help and completions; the iterator of a parser that lives no longer than this call.
        let all: Vec<_> = self.0.names().possible_values()?.collect();
        Some(Box::new(all.into_iter()))
    }
}

#[derive(Clone)]
struct ListParser(Structures);

impl TypedValueParser for ListParser {
    type Value = StructureList;

    fn parse_ref(
        &self,
        command: &Command,
        arg: Option<&Arg>,
        value: &OsStr,
    ) -> Result<StructureList, clap::Error> {
        let one = StructureParser(self.0.clone());
        let text = value.to_string_lossy();
        let parsed = elements(&text)
            .into_iter()
            .map(|element| one.parse_ref(command, arg, OsStr::new(&element)));
        Ok(StructureList(parsed.collect::<Result<_, _>>()?))
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let all: Vec<_> = self.0.names().possible_values()?.collect();
        Some(Box::new(all.into_iter()))
    }
}

/// The name of a structure, and its options.
fn parts(text: &str) -> (&str, Option<&str>) {
    match text.split_once(':') {
        Some((name, options)) => (name, Some(options)),
        None => (text, None),
    }
}

/// The elements of a list, each with its options.
fn elements(text: &str) -> Vec<String> {
    let mut elements: Vec<String> = Vec::new();
    for part in text.split(',') {
        match elements.last_mut() {
            Some(last) if part.contains('=') && !part.contains(':') => {
                let mark = if last.contains(':') { ',' } else { ':' };
                last.push(mark);
                last.push_str(part);
            }
            _ => elements.push(part.to_owned()),
        }
    }
    elements
}

/// What is wrong with an option, and what was probably meant.
fn in_words(error: &OptionError) -> String {
    let (typed, known): (&str, &[&str]) = match error {
        OptionError::Unknown { option, known } => (option, known),
        OptionError::Value { value, allowed: Allowed::Words(words), .. } => (value, words),
        _ => ("", &[]),
    };
    match nearest(typed, known.iter().copied()) {
        Some(near) => format!("{error}; did you mean `{near}`?"),
        None => error.to_string(),
    }
}

/// Whether a name can stand between the commas of `--accel` and in the names of files.
fn is_name(name: &str) -> bool {
    let fits = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    !name.is_empty() && name.chars().all(fits)
}

/// Those of the library.
impl Default for Structures {
    fn default() -> Self {
        Self([STRUCTURES, PEERS].concat())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::{Bvh, Exhaustive};

    #[test]
    fn a_name_can_be_typed_and_be_part_of_a_files() {
        for name in ["", "a,b", "../a", "a b", "gitter-ä", "a:b"] {
            let one = Structure::new::<Exhaustive, Bvh>(name, "another");
            let text = Structures::with(&[one]).unwrap_err().to_string();
            assert!(
                text.starts_with(&format!("a structure cannot be called `{name}`: ")),
                "{text}"
            );
        }
    }

    #[test]
    fn a_name_is_taken_once() {
        let mine = Structure::new::<Exhaustive, Bvh>("mine", "one of your own");
        let bvh = Structure::new::<Exhaustive, Bvh>("bvh", "another");
        let refused = |extra: &[Structure]| Structures::with(extra).unwrap_err().to_string();
        assert_eq!(refused(&[mine, bvh]), "two structures are called `bvh`");
        assert_eq!(refused(&[mine, mine]), "two structures are called `mine`");
    }
}
