//! Notes what a report must say of the build: compiler, sources, flags. Knows nothing else.
//!
//! What changes with every commit is left to the running program, or each commit would compile the
//! crate anew.

use std::path::Path;
use std::process::Command;

#[path = "src/compare/sources.rs"]
mod sources;

fn main() {
    for source in sources::SOURCES {
        println!("cargo::rerun-if-changed={source}");
    }
    let compiler = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    tell("SRT_COMPILER", output(&compiler, &["--version"]));
    tell("SRT_SOURCES", sources::fingerprint(Path::new(".")).ok());
    tell("SRT_PROFILE", std::env::var("PROFILE").ok());
    let flags = std::env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    tell("SRT_FLAGS", Some(flags.replace('\x1f', " ")));
    tell("SRT_FEATURES", std::env::var("CARGO_CFG_TARGET_FEATURE").ok());
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
