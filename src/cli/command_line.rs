//! The command's definition with the structures of this program, and what it reads from the command
//! line of this process.

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, CommandFactory, FromArgMatches};

use super::args::{self, Arguments};
use super::structures::Structures;

/// The command, whose `--accel` takes these structures.
pub(crate) fn command(structures: &Structures) -> Command {
    let accel = |arg: Arg| arg.value_parser(structures.parser());
    Arguments::command()
        .mut_arg("accel", accel)
        .mut_subcommand("compare", |compare| compare.mut_arg("accel", accel))
}

/// The arguments of this process. Ends it where they are wrong, or for the help.
pub(crate) fn arguments(structures: &Structures) -> Arguments {
    let matches = command(structures).try_get_matches();
    let read = matches.and_then(|mut matches| Arguments::from_arg_matches_mut(&mut matches));
    let mut arguments = read.unwrap_or_else(|error| explained(structures, error).exit());
    if let Some(args::Command::Compare(compare)) = &mut arguments.command
        && compare.accel.is_empty()
    {
        compare.accel = structures.compared_by_default();
    }
    arguments
}

/// An error of clap's in words that fit: after a scene and an output, it takes one word too many for
/// the name of a subcommand.
fn explained(structures: &Structures, error: clap::Error) -> clap::Error {
    match error.get(ContextKind::InvalidSubcommand) {
        Some(ContextValue::String(word)) => command(structures).error(
            ErrorKind::UnknownArgument,
            format_args!("unexpected argument `{word}`: a rendering takes a scene and an output"),
        ),
        _ => error,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::{Bvh, Exhaustive};
    use crate::scene::Structure;

    const MINE: Structure = Structure::new::<Exhaustive, Bvh>("mine", "one of one's own");

    #[test]
    fn what_is_added_can_be_named_wherever_the_librarys_can() {
        let structures = Structures::with(&[MINE]).unwrap();
        let read = |typed: &[&str]| {
            let mut matches = command(&structures).try_get_matches_from(typed).unwrap();
            Arguments::from_arg_matches_mut(&mut matches).unwrap()
        };
        assert_eq!(read(&["srt", "a.sce", "a.png", "--accel", "mine"]).render.accel.name, "mine");
        assert_eq!(read(&["srt", "a.sce", "a.png"]).render.accel.name, "bvh8");
        let compare = read(&["srt", "compare", "a.sce", "--accel", "none,mine"]);
        let Some(args::Command::Compare(compare)) = compare.command else { panic!("{compare:?}") };
        assert_eq!(compare.accel.iter().map(|one| one.name).collect::<Vec<_>>(), ["none", "mine"]);
        let help = command(&structures).render_long_help().to_string();
        assert!(help.contains("mine") && help.contains("one of one's own"), "{help}");
    }
}
