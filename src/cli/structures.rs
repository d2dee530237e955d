//! What `--accel` may name: the structures of the library, and those that a program of one's own
//! adds ([`run_with`](super::run_with)), each with options of its own.

use std::ffi::OsStr;
use std::fmt::Write;

use clap::builder::{PossibleValue, PossibleValuesParser, StringValueParser, TypedValueParser};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, CommandFactory, FromArgMatches};

use super::args::{self, Arguments};
use super::exit::Failure;
use crate::accel::{Allowed, OptionError};
use crate::scene::{PEERS, STRUCTURES, Structure};

/// All that can be named, in the order in which help lists them.
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

    /// The command's definition, with these structures.
    pub(crate) fn command(&self) -> Command {
        let list = |arg: Arg| self.explained_in(arg.value_parser(self.list_parser()));
        Arguments::command()
            .mut_arg("accel", |arg| self.explained_in(arg.value_parser(self.parser())))
            .mut_subcommand("compare", |compare| compare.mut_arg("accel", list))
            .mut_subcommand("conformance", |check| check.mut_arg("accel", list))
    }

    /// The argument, with the options of all structures in its long help.
    fn explained_in(&self, arg: Arg) -> Arg {
        let short = arg.get_help().map(ToString::to_string).unwrap_or_default();
        arg.long_help(format!("{short}\n\n{}", self.options_in_words()))
    }

    /// What options there are, a line each.
    fn options_in_words(&self) -> String {
        let mut text =
            "A structure's options follow its name: NAME:OPTION=VALUE,OPTION=VALUE\n".to_owned();
        for one in &self.0 {
            for option in one.offered_options() {
                let values = match option.allowed {
                    Allowed::Words(words) => words.join("|"),
                    Allowed::Numbers(least, most) => format!("{least}..{most}"),
                };
                let (of, name, summary, default) =
                    (one.name, option.name, option.summary, option.default);
                // Text takes what is written to it.
                let _ = write!(text, "\n  {of}:{name}={values}  {summary} [default: {default}]");
            }
        }
        text
    }

    /// What this process was told.
    pub(crate) fn arguments(&self) -> Arguments {
        let matches = self.command().try_get_matches();
        let read = matches.and_then(|mut matches| Arguments::from_arg_matches_mut(&mut matches));
        let mut arguments = read.unwrap_or_else(|error| self.explained(error).exit());
        let named = match &mut arguments.command {
            Some(args::Command::Compare(compare)) => Some(&mut compare.accel),
            Some(args::Command::Conformance(check)) => Some(&mut check.accel),
            _ => None,
        };
        if let Some(named) = named.filter(|named| named.is_empty()) {
            *named = vec![self.own()];
        }
        arguments
    }

    /// All but peers, which take part only where they are named.
    fn own(&self) -> StructureList {
        StructureList(self.0.iter().copied().filter(|one| !one.peer).collect())
    }

    /// An error of clap's in words that fit: what it takes for a subcommand behind a scene and an
    /// output is one word too many.
    fn explained(&self, error: clap::Error) -> clap::Error {
        match error.get(ContextKind::InvalidSubcommand) {
            Some(ContextValue::String(word)) => self.command().error(
                ErrorKind::UnknownArgument,
                format_args!(
                    "unexpected argument `{word}`: a rendering takes a scene and an output"
                ),
            ),
            _ => error,
        }
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
    fn find(&self, text: &str) -> Result<Structure, String> {
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
    let slips = (typed.chars().count() / 3).max(1);
    let distance = |known: &&&str| strsim::damerau_levenshtein(typed, known);
    // What is long resembles none, and would take long to compare.
    let near = known.iter().filter(|_| typed.len() <= 40).min_by_key(distance);
    match near.filter(|near| distance(near) <= slips) {
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

    const MINE: Structure = Structure::new::<Exhaustive, Bvh>("mine", "one of one's own");

    fn read(structures: &Structures, typed: &[&str]) -> Result<Arguments, String> {
        let matches = structures.command().try_get_matches_from(typed);
        let read = matches.and_then(|mut matches| Arguments::from_arg_matches_mut(&mut matches));
        read.map_err(|error| error.to_string())
    }

    fn compared(list: &str) -> Result<Vec<&'static str>, String> {
        let structures = Structures::with(&[MINE]).unwrap();
        let read = read(&structures, &["srt", "compare", "a.sce", "--accel", list])?;
        let Some(args::Command::Compare(compare)) = read.command else { panic!("{read:?}") };
        Ok(compare.structures().iter().map(|one| one.name).collect())
    }

    #[test]
    fn what_is_added_can_be_named_wherever_the_librarys_can() {
        let structures = Structures::with(&[MINE]).unwrap();
        let named = |typed: &[&str]| read(&structures, typed).unwrap().render.accel.name;
        assert_eq!(named(&["srt", "a.sce", "a.png", "--accel", "mine"]), "mine");
        assert_eq!(named(&["srt", "a.sce", "a.png", "--accel", "mine:leaf=4"]), "mine:leaf=4");
        assert_eq!(named(&["srt", "a.sce", "a.png"]), "bvh8");
        assert_eq!(compared("none,mine").unwrap(), ["none", "mine"]);
        let help = structures.command().render_long_help().to_string();
        assert!(help.contains("mine") && help.contains("one of one's own"), "{help}");
        assert!(help.contains("mine:leaf=1..") && help.contains("bvh8:builder=sah|ploc"), "{help}");
    }

    #[test]
    fn options_in_a_list_belong_to_the_structure_before_them() {
        assert_eq!(
            compared("none,bvh8:leaf=4,builder=ploc,bvh,bvh8,cwbvh:leaf=2,mine:leaf=3").unwrap(),
            ["none", "bvh8:builder=ploc,leaf=4", "bvh", "bvh8", "cwbvh:leaf=2", "mine:leaf=3"]
        );
        assert_eq!(compared("bvh,leaf=2,none").unwrap(), ["bvh:leaf=2", "none"]);
    }

    #[test]
    fn what_is_wrong_is_said_with_what_would_be_right() {
        let error = |list: &str| compared(list).unwrap_err();
        for (list, parts) in [
            ("none,bhv:leaf=4", &["'bhv'", "none", "cwbvh"][..]),
            ("bvh8:builer=sah", &["`builer`", "did you mean `builder`?", "`leaf`"]),
            ("bvh8:builder=plco", &["`plco`", "`sah`, `ploc`", "did you mean `ploc`?"]),
            ("none,bvh8:leaf=9,bvh", &["'bvh8:leaf=9'", "`9`", "a whole number from 1 to 8"]),
            ("bvh8:leaf", &["`leaf` is not an option with its value"]),
            ("none:leaf=1", &["no option `leaf`", "has none"]),
            ("bvh8:leaf=1,leaf=2", &["`leaf` is given twice"]),
            ("", &["a value is required", "none"]),
        ] {
            let text = error(list);
            assert!(parts.iter().all(|part| text.contains(part)), "{list}: {text}");
        }
    }

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
        let bvh = Structure::new::<Exhaustive, Bvh>("bvh", "another");
        let refused = |extra: &[Structure]| Structures::with(extra).unwrap_err().to_string();
        assert_eq!(refused(&[MINE, bvh]), "two structures are called `bvh`");
        assert_eq!(refused(&[MINE, MINE]), "two structures are called `mine`");
    }
}
