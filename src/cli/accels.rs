//! `srt accels`: the structures that this program has, and what each can be told.

use std::fmt::Write as _;

use super::exit::{CommandResult, Exit, Failure};
use super::output::Output;
use super::structures::{Structures, values_in_words};
use crate::scene::Structure;

/// Prints them, the options of each below it.
pub(super) fn run(structures: &Structures) -> CommandResult {
    let text = table(structures);
    Output::stdout().write(|to| to.write_all(text.as_bytes())).map_err(Failure::from)?;
    Ok(Exit::Fine)
}

fn table(structures: &Structures) -> String {
    let width = structures.all().iter().map(|one| one.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for one in structures.all() {
        // Text takes what is written to it.
        let _ = writeln!(text, "{:width$}  {}{}", one.name, one.summary, when(one));
        let _ = writeln!(text, "{:width$}    {}", "", manner(one));
        if let Some(found) = found(one) {
            let _ = writeln!(text, "{:width$}    {found}", "");
        }
        for option in one.offered_options() {
            let (name, values) = (option.name, values_in_words(option));
            let (summary, default) = (option.summary, option.default);
            let _ =
                writeln!(text, "{:width$}    {name}={values}: {summary} [default: {default}]", "");
        }
    }
    text
}

/// In which of the two manners rays meet primitives in it, and where it is from.
fn manner(one: &Structure) -> String {
    let manner = if one.peer { "as shipped" } else { "same formula" };
    let source = if one.source.is_empty() { "" } else { "; from " };
    format!("{manner}{source}{}", one.source)
}

/// Which library would be loaded for it, or why none.
fn found(one: &Structure) -> Option<String> {
    match one.loaded() {
        Ok(library) => library.map(|library| format!("found: {library}")),
        Err(error) => Some(format!("not found: {error}")),
    }
}

/// Where a comparison has it.
fn when(one: &Structure) -> &'static str {
    if one.on_request && !one.peer { " (compared if it is named)" } else { "" }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::{Bvh, Exhaustive};

    #[test]
    fn each_has_a_line_and_one_for_each_option() {
        const MINE: Structure = Structure::new::<Bvh, Exhaustive>("mine", "one of your own");
        let text = table(&Structures::with(&[MINE]).unwrap());
        for one in crate::scene::STRUCTURES.iter().chain(crate::scene::PEERS).chain([&MINE]) {
            let line = text.lines().find(|line| line.starts_with(&format!("{} ", one.name)));
            assert!(line.is_some_and(|line| line.contains(one.summary)), "{}: {text}", one.name);
        }
        let options = crate::scene::STRUCTURES.iter().chain(crate::scene::PEERS).chain([&MINE]);
        let options: usize = options.map(|one| one.offered_options().count()).sum();
        assert_eq!(text.matches(" [default: ").count(), options);
        assert!(text.contains("    builder=sah|"), "{text}");
        for one in crate::scene::STRUCTURES.iter().chain(crate::scene::PEERS).chain([&MINE]) {
            let mut lines =
                text.lines().skip_while(|line| !line.starts_with(&format!("{} ", one.name)));
            let below = lines.nth(1).unwrap().trim();
            let manner = if one.peer { "as shipped" } else { "same formula" };
            let source = if one.source.is_empty() { "" } else { "; from " };
            assert_eq!(below, format!("{manner}{source}{}", one.source));
            assert_eq!(one.source.is_empty(), ["none", "mine"].contains(&one.name), "{}", one.name);
        }
    }
}
