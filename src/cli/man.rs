//! `srt man`: the man pages, from the definition of the command.

use std::io;
use std::path::Path;

use clap::Command;
use clap_mangen::Man;

use super::args::ManArguments;
use super::exit::{CommandResult, Exit, Failure};
use super::output::{Output, make_folder};

/// Prints `srt.1`, or writes it and the subcommands' pages into a folder.
pub(super) fn run(arguments: &ManArguments, command: Command) -> CommandResult {
    match &arguments.folder {
        None => print(command),
        Some(folder) => write_all(folder, command),
    }
}

fn print(command: Command) -> CommandResult {
    let page = page(command).map_err(Failure::new)?;
    Output::stdout().write(|to| to.write_all(&page)).map_err(Failure::from)?;
    Ok(Exit::Fine)
}

fn write_all(folder: &Path, command: Command) -> CommandResult {
    make_folder(folder)?;
    for (name, page) in pages(command).map_err(Failure::new)? {
        let output = Output::prepare(&folder.join(name)).map_err(Failure::from)?;
        output.write(|to| to.write_all(&page)).map_err(Failure::from)?;
    }
    Ok(Exit::Fine)
}

/// The name and text of every page: `srt.1`, then `srt-check.1` and so on.
fn pages(mut command: Command) -> io::Result<Vec<(String, Vec<u8>)>> {
    command.build();
    let mut pages = vec![("srt.1".to_owned(), page(command.clone())?)];
    add_subcommands("srt", &command, &mut pages)?;
    Ok(pages)
}

/// The pages of a command's subcommands, each with those of its own behind it.
fn add_subcommands(
    name: &str,
    command: &Command,
    pages: &mut Vec<(String, Vec<u8>)>,
) -> io::Result<()> {
    for subcommand in command.get_subcommands().filter(|s| s.get_name() != "help") {
        let name = format!("{name}-{}", subcommand.get_name());
        // The title of a page must live as long as the program.
        let title: &'static str = name.clone().leak();
        pages.push((format!("{name}.1"), page(subcommand.clone().name(title))?));
        add_subcommands(&name, subcommand, pages)?;
    }
    Ok(())
}

fn page(command: Command) -> io::Result<Vec<u8>> {
    let mut page = Vec::new();
    Man::new(command).render(&mut page)?;
    Ok(keep_lines(&String::from_utf8_lossy(&page)).into_bytes())
}

/// Keeps the lines of the last part of the help as they are: it holds examples and lists, which
/// roff would fill and justify as if they were prose.
fn keep_lines(page: &str) -> String {
    let Some((before, extra)) = page.split_once(".SH EXTRA\n") else {
        return page.to_owned();
    };
    let (extra, after) = extra.split_at(extra.find(".SH ").unwrap_or(extra.len()));
    format!("{before}.SH NOTES\n.nf\n{extra}.fi\n{after}")
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::super::args::Arguments;
    use super::*;

    #[test]
    fn every_subcommand_has_a_page() {
        let pages = pages(Arguments::command()).unwrap();
        let names: Vec<&str> = pages.iter().map(|(name, _)| name.as_str()).collect();
        let expected = [
            "srt.1",
            "srt-view.1",
            "srt-show.1",
            "srt-part.1",
            "srt-assemble.1",
            "srt-pack.1",
            "srt-build.1",
            "srt-check.1",
            "srt-compare.1",
            "srt-animate.1",
            "srt-conformance.1",
            "srt-report.1",
            "srt-rays.1",
            "srt-rays-info.1",
            "srt-rays-export.1",
            "srt-rays-import.1",
            "srt-diff.1",
            "srt-mesh.1",
            "srt-accels.1",
            "srt-completions.1",
            "srt-man.1",
        ];
        assert_eq!(names, expected);
        assert!(pages.iter().all(|(_, page)| page.starts_with(b".ie")));
    }

    #[test]
    fn examples_keep_their_lines() {
        let page = keep_lines(".SH NAME\na\n.SH EXTRA\n  b\n  c\n.SH VERSION\nd\n");
        assert_eq!(page, ".SH NAME\na\n.SH NOTES\n.nf\n  b\n  c\n.fi\n.SH VERSION\nd\n");
    }

    #[test]
    fn the_page_lists_the_exit_codes() {
        let page = String::from_utf8(page(Arguments::command()).unwrap()).unwrap();
        for code in ["0 ", "1 ", "2 ", "130 ", "141 "] {
            assert!(page.lines().any(|line| line.trim_start().starts_with(code)), "{code}: {page}");
        }
    }
}
