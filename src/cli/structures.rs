//! What `--accel` may name: the structures of the library, and those that a program of one's own
//! adds ([`run_with`](super::run_with)).

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, CommandFactory, FromArgMatches};

use super::args::{self, Arguments};
use super::exit::Failure;
use crate::scene::{PEERS, STRUCTURES, Structure};

/// All that can be named, in the order in which help lists them.
#[derive(Clone, Debug)]
pub(crate) struct Structures(Vec<Structure>);

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
        let accel = |arg: clap::Arg| arg.value_parser(self.parser());
        Arguments::command()
            .mut_arg("accel", accel)
            .mut_subcommand("compare", |compare| compare.mut_arg("accel", accel))
    }

    /// What this process was told.
    pub(crate) fn arguments(&self) -> Arguments {
        let matches = self.command().try_get_matches();
        let read = matches.and_then(|mut matches| Arguments::from_arg_matches_mut(&mut matches));
        let mut arguments = read.unwrap_or_else(|error| self.explained(error).exit());
        if let Some(args::Command::Compare(compare)) = &mut arguments.command
            && compare.accel.is_empty()
        {
            // Yardsticks are measured only when they are asked for.
            compare.accel = self.0.iter().copied().filter(|one| !one.peer).collect();
        }
        arguments
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

    /// Takes the name of one; the help says what each is.
    pub(crate) fn parser(&self) -> impl TypedValueParser<Value = Structure> {
        let values = self.0.iter().map(|one| PossibleValue::new(one.name).help(one.summary));
        let all = self.0.clone();
        PossibleValuesParser::new(values.collect::<Vec<_>>()).try_map(move |name| {
            let found = all.iter().copied().find(|one| one.name == name);
            found.ok_or_else(|| format!("there is no structure `{name}`"))
        })
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

    #[test]
    fn what_is_added_can_be_named_wherever_the_librarys_can() {
        let structures = Structures::with(&[MINE]).unwrap();
        let read = |typed: &[&str]| {
            let mut matches = structures.command().try_get_matches_from(typed).unwrap();
            Arguments::from_arg_matches_mut(&mut matches).unwrap()
        };
        assert_eq!(read(&["srt", "a.sce", "a.png", "--accel", "mine"]).render.accel.name, "mine");
        assert_eq!(read(&["srt", "a.sce", "a.png"]).render.accel.name, "bvh8");
        let compare = read(&["srt", "compare", "a.sce", "--accel", "none,mine"]);
        let Some(args::Command::Compare(compare)) = compare.command else { panic!("{compare:?}") };
        assert_eq!(compare.accel.iter().map(|one| one.name).collect::<Vec<_>>(), ["none", "mine"]);
        let help = structures.command().render_long_help().to_string();
        assert!(help.contains("mine") && help.contains("one of one's own"), "{help}");
    }

    #[test]
    fn a_name_can_be_typed_and_be_part_of_a_files() {
        for name in ["", "a,b", "../a", "a b", "gitter-ä"] {
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
