//! What an unknown command was meant to be.

use super::command::{Command, Group};
use super::table::COMMANDS;

/// The command that an unknown word was probably meant to be.
///
/// Another name for it counts first, then the spelling: one slip in three letters, swapped
/// neighbours being one.
pub(super) fn did_you_mean(word: &str) -> Option<&'static Command> {
    // What is much longer than any keyword resembles none, and would take long to compare.
    if word.len() > 40 {
        return None;
    }
    let word = word.to_lowercase();
    let is_other_name = |c: &&Command| c.keyword == word || c.also_called.contains(&word.as_str());
    COMMANDS.iter().find(is_other_name).or_else(|| {
        let distance = |c: &Command| strsim::damerau_levenshtein(&word, c.keyword);
        let slips = (word.chars().count() / 3).max(1);
        COMMANDS
            .iter()
            .filter(|c| c.keyword.len() > 1)
            .map(|c| (distance(c), c))
            .filter(|(distance, c)| *distance <= slips && *distance < c.keyword.len())
            .min_by_key(|(distance, _)| *distance)
            .map(|(_, command)| command)
    })
}

/// All commands, a line for each group.
pub(super) fn list_of_commands() -> String {
    let groups = [
        (Group::Camera, "camera"),
        (Group::Options, "options"),
        (Group::Structure, "structure"),
        (Group::Material, "material"),
        (Group::Transform, "transform"),
        (Group::Object, "objects"),
        (Group::Light, "lights"),
    ];
    let lines = groups.map(|(group, name)| {
        let keywords: Vec<_> =
            COMMANDS.iter().filter(|c| c.group == group).map(|c| c.keyword).collect();
        format!("    {:<11}{}", format!("{name}:"), keywords.join(" "))
    });
    format!("the commands are\n{}", lines.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_other_names_and_capitals_are_understood() {
        let meant = |word| did_you_mean(word).map(|c| c.keyword);
        assert_eq!(meant("balll"), Some("ball"));
        assert_eq!(meant("blal"), Some("ball"));
        assert_eq!(meant("Ball"), Some("ball"));
        assert_eq!(meant("sphere"), Some("ball"));
        assert_eq!(meant("trainlge"), Some("triangle"));
        assert_eq!(meant("pushmatrix"), Some("push_matrix"));
        assert_eq!(meant("c"), Some("ca"));
        assert_eq!(meant("texture"), None);
        assert_eq!(meant("v"), None);
        assert_eq!(meant("€"), None);
    }
}
