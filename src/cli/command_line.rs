//! The command's definition with the structures of this program, and what it reads from the command
//! line of this process.

use std::ffi::OsString;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, CommandFactory, FromArgMatches};

use super::args::{self, Arguments};
use super::exit::Failure;
use super::near::nearest;
use super::output::Output;
use super::structures::Structures;

/// The command, whose `--accel` takes these structures.
pub(crate) fn command(structures: &Structures) -> Command {
    let one = |arg: Arg| structures.explained_in(arg.value_parser(structures.parser()));
    let list = |arg: Arg| structures.explained_in(arg.value_parser(structures.list_parser()));
    Arguments::command()
        .mut_arg("accel", one)
        // A view is of the whole picture.
        .mut_subcommand("view", |view| {
            view.mut_arg("accel", one).mut_arg("crop", |crop| crop.hide(true))
        })
        .mut_subcommand("part", |part| part.mut_arg("accel", one))
        .mut_subcommand("show", |show| show.mut_arg("accel", one))
        .mut_subcommand("build", |build| build.mut_arg("accel", one))
        .mut_subcommand("animate", |animate| animate.mut_arg("accel", list))
        .mut_subcommand("compare", |compare| compare.mut_arg("accel", list))
        .mut_subcommand("conformance", |check| check.mut_arg("accel", list))
}

/// The arguments of this process; `None` where help or the version was wanted, and printed. Ends the
/// process where the arguments are wrong.
///
/// # Errors
/// If standard output does not take the help.
pub(crate) fn arguments(structures: &Structures) -> Result<Option<Arguments>, Failure> {
    let matches = command(structures).try_get_matches();
    let read = matches.and_then(|mut matches| Arguments::from_arg_matches_mut(&mut matches));
    let typed: Vec<OsString> = std::env::args_os().skip(1).collect();
    let mut arguments = match read.map_err(|error| explained(structures, &typed, error)) {
        Ok(arguments) => arguments,
        Err(help) if !help.use_stderr() => return print_help(&help).map(|()| None),
        Err(error) => error.exit(),
    };
    match &mut arguments.command {
        Some(args::Command::Compare(compare)) if compare.accel.is_empty() => {
            compare.accel = vec![structures.compared_by_default()];
        }
        Some(args::Command::Conformance(check)) if check.accel.is_empty() => {
            check.accel = vec![structures.checked_by_default()];
        }
        _ => {}
    }
    Ok(Some(arguments))
}

/// Prints what clap takes for an error, too: its own `exit` would not notice that it could not be printed. Only clap
/// colours it as the terminal wants, so it writes to standard output by itself.
fn print_help(help: &clap::Error) -> Result<(), Failure> {
    Output::stdout().write(|_| help.print()).map_err(Failure::from)
}

/// An error of clap's in words that fit: it takes a word too many for the name of a subcommand, behind a scene and an
/// output as well, where none can be.
fn explained(structures: &Structures, typed: &[OsString], error: clap::Error) -> clap::Error {
    let Some(ContextValue::String(word)) = error.get(ContextKind::InvalidSubcommand) else {
        return error;
    };
    let mut root = command(structures);
    root.build();
    // The subcommand that the word is behind; all are before it.
    let is_help = typed.first().is_some_and(|first| first == "help");
    let end = typed.iter().rposition(|own| *own == word.as_str()).unwrap_or(typed.len());
    let names = typed[..end].iter().skip(usize::from(is_help));
    let within = names.fold(&root, |within, name| within.find_subcommand(name).unwrap_or(within));
    if !is_help && within.get_name() == root.get_name() {
        return root.clone().error(
            ErrorKind::UnknownArgument,
            format_args!("unexpected argument `{word}`: a rendering takes a scene and an output"),
        );
    }
    let known = within.get_subcommands().map(Command::get_name);
    let hint =
        nearest(word, known).map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
    root.clone()
        .error(ErrorKind::InvalidSubcommand, format_args!("there is no subcommand `{word}`{hint}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::{Bvh, Exhaustive};
    use crate::scene::Structure;

    const MINE: Structure = Structure::new::<Exhaustive, Bvh>("mine", "one of your own");

    fn read(structures: &Structures, typed: &[&str]) -> Result<Arguments, String> {
        let matches = command(structures).try_get_matches_from(typed);
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
        let named = |typed: &[&str]| {
            read(&structures, typed).unwrap().render.work.accel.map(|accel| accel.name)
        };
        assert_eq!(named(&["srt", "a.sce", "a.png", "--accel", "mine"]), Some("mine"));
        assert_eq!(
            named(&["srt", "a.sce", "a.png", "--accel", "mine:leaf=4"]),
            Some("mine:leaf=4")
        );
        assert_eq!(named(&["srt", "a.sce", "a.png"]), None);
        assert_eq!(compared("none,mine").unwrap(), ["none", "mine"]);
        let typed = ["srt", "animate", "a.sce", "--frames", "0..9", "--accel", "bvh,mine"];
        let read = read(&structures, &typed).unwrap();
        let Some(args::Command::Animate(animate)) = read.command else { panic!("{read:?}") };
        assert_eq!(animate.structures()[1].name, "mine");
        let help = command(&structures).render_long_help().to_string();
        assert!(help.contains("mine") && help.contains("one of your own"), "{help}");
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
}
