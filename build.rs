//! Notes what a report must say of the build: compiler, commit, flags. Knows nothing else.

use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=Cargo.toml");
    println!("cargo::rerun-if-changed=src");
    // A commit, or a change of branch, is a line in this log. It is not there outside of git.
    if let Some(log) = output("git", &["rev-parse", "--git-path", "logs/HEAD"]) {
        println!("cargo::rerun-if-changed={log}");
    }
    let compiler = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    tell("SRT_COMPILER", output(&compiler, &["--version"]));
    tell("SRT_COMMIT", commit());
    tell("SRT_PROFILE", std::env::var("PROFILE").ok());
    let flags = std::env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    tell("SRT_FLAGS", Some(flags.replace('\x1f', " ")));
    tell("SRT_FEATURES", std::env::var("CARGO_CFG_TARGET_FEATURE").ok());
}

/// The commit, with `-dirty` behind it if a file that git knows has changed.
fn commit() -> Option<String> {
    // Below somebody else's repository the package is a copy, and that commit is not its own.
    if !output("git", &["rev-parse", "--show-prefix"])?.is_empty() {
        return None;
    }
    let commit = output("git", &["rev-parse", "HEAD"])?;
    let changed = output("git", &["status", "--porcelain", "--untracked-files=no"])?;
    Some(if changed.is_empty() { commit } else { commit + "-dirty" })
}

/// What a command prints, if it can be run and ends well.
fn output(program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}

fn tell(name: &str, value: Option<String>) {
    if let Some(value) = value {
        println!("cargo::rustc-env={name}={value}");
    }
}
