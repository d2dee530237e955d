//! The commit that the program was built from, by a query to git when a report is made.
//!
//! A build does not note the commit itself: every commit would then compile everything anew. It
//! notes the fingerprint of its sources, and a commit is named only if the sources that it was
//! built from still lie in their place. A commit that changed none of them names the program as
//! well as the one before it.

use std::path::Path;
use std::process::Command;

use super::sources::{SOURCES, fingerprint};

/// Variables that lead git to another repository than that of a folder.
const ELSEWHERE: [&str; 3] = ["GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE"];

/// The commit whose sources the program was built from, with `-dirty` behind it if they had
/// changed since; `None` if that is not known.
pub(super) fn commit() -> Option<String> {
    commit_of(Path::new(env!("CARGO_MANIFEST_DIR")), option_env!("SRT_SOURCES")?)
}

fn commit_of(root: &Path, built_from: &str) -> Option<String> {
    if fingerprint(root).ok()? != built_from {
        return None;
    }
    // Inside of another repository the package is a copy, and that commit is not its own.
    if !git(root, &["rev-parse", "--show-prefix"])?.is_empty() {
        return None;
    }
    let commit = git(root, &["rev-parse", "HEAD"])?;
    let status = [&["status", "--porcelain", "--"][..], &SOURCES].concat();
    Some(if git(root, &status)?.is_empty() { commit } else { commit + "-dirty" })
}

/// The output of git in a folder; `None` if git is missing or fails.
fn git(root: &Path, arguments: &[&str]) -> Option<String> {
    let mut command = Command::new("git");
    ELSEWHERE.iter().for_each(|name| {
        command.env_remove(name);
    });
    let output = command.arg("-C").arg(root).args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    /// Commits all that is in a folder.
    fn commit_all(root: &Path) {
        for arguments in [
            &["init", "--quiet"][..],
            &["add", "."],
            &["-c", "user.name=a", "-c", "user.email=a@b", "commit", "--quiet", "-m", "a"],
        ] {
            git(root, arguments).unwrap();
        }
    }

    #[test]
    fn a_commit_is_named_only_for_its_own_sources() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        fs::create_dir(root.join("src")).unwrap();
        for file in ["Cargo.lock", "Cargo.toml", "build.rs", "src/lib.rs", "README.md"] {
            fs::write(root.join(file), file).unwrap();
        }
        let built = fingerprint(root).unwrap();
        assert_eq!(commit_of(root, &built), None, "there is no repository");
        commit_all(root);
        let first = commit_of(root, &built).unwrap();
        assert!(first.len() >= 40 && first.bytes().all(|b| b.is_ascii_hexdigit()), "{first}");
        fs::write(root.join("README.md"), "other").unwrap();
        assert_eq!(commit_of(root, &built).as_ref(), Some(&first), "no source has changed");
        commit_all(root);
        assert_ne!(commit_of(root, &built).unwrap(), first, "the same sources under a new commit");

        fs::write(root.join("src/new.rs"), "").unwrap();
        assert_eq!(commit_of(root, &built), None, "built from other sources");
        let rebuilt = fingerprint(root).unwrap();
        assert!(commit_of(root, &rebuilt).unwrap().ends_with("-dirty"));
        commit_all(root);
        assert!(!commit_of(root, &rebuilt).unwrap().ends_with("-dirty"));
        assert_eq!(commit_of(root, &built), None);
    }
}
