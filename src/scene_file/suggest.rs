//! Suggestions for an unknown command.

use super::action::Row;
use super::command::SceneCommand;
use super::commands::{GROUPS, rows};

/// The command that an unknown word was probably meant to be.
///
/// Another name for it counts first, then the spelling: one slip in three letters, swapped
/// neighbours being one. Then what the word abbreviates, if that is a single command.
pub(super) fn did_you_mean(word: &str) -> Option<&'static Row> {
    // What is much longer than any keyword resembles none, and would take long to compare.
    if word.len() > 40 {
        return None;
    }
    let word = word.to_lowercase();
    let is_called = |c: &SceneCommand| c.keyword == word || c.also_called.contains(&word.as_str());
    rows().find(|row| is_called(&row.command)).or_else(|| {
        let distance = |keyword: &str| strsim::damerau_levenshtein(&word, keyword);
        let slips = (word.chars().count() / 3).max(1);
        rows()
            .filter(|row| row.command.keyword.len() > 1)
            .map(|row| (distance(row.command.keyword), row))
            .filter(|(slipped, row)| *slipped <= slips && *slipped < row.command.keyword.len())
            .min_by_key(|(slipped, _)| *slipped)
            .map(|(_, row)| row)
            .or_else(|| abbreviated(&word))
    })
}

/// The one command that a word of at least three letters abbreviates: it begins as the command does, and its letters
/// are in the command in their order.
fn abbreviated(word: &str) -> Option<&'static Row> {
    let abbreviates = |keyword: &str| {
        let mut letters = keyword.chars();
        keyword.chars().next() == word.chars().next()
            && word.chars().all(|letter| letters.any(|other| other == letter))
    };
    let mut found = rows().filter(|row| abbreviates(row.command.keyword));
    let first = found.next().filter(|_| word.chars().count() >= 3)?;
    found.next().is_none().then_some(first)
}

/// All commands, a line for each group.
pub(super) fn list_of_commands() -> String {
    let lines = GROUPS.map(|group| {
        let keywords: Vec<_> = group.rows.iter().map(|row| row.command.keyword).collect();
        format!("    {:<11}{}", format!("{}:", group.name), keywords.join(" "))
    });
    format!("the commands are\n{}", lines.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_other_names_and_capitals_are_understood() {
        let meant = |word| did_you_mean(word).map(|row| row.command.keyword);
        assert_eq!(meant("balll"), Some("ball"));
        assert_eq!(meant("blal"), Some("ball"));
        assert_eq!(meant("Ball"), Some("ball"));
        assert_eq!(meant("sphere"), Some("ball"));
        assert_eq!(meant("trainlge"), Some("triangle"));
        assert_eq!(meant("pushmatrix"), Some("push_matrix"));
        assert_eq!(meant("c"), Some("ca"));
        assert_eq!(meant("plight"), Some("pointlight"));
        assert_eq!(meant("cyl"), Some("cylinder"));
        assert_eq!(meant("pmatrix"), None, "it abbreviates two commands");
        assert_eq!(meant("texture"), None);
        assert_eq!(meant("v"), None);
        assert_eq!(meant("€"), None);
    }
}
