//! Notes what a report must say of the build: compiler, sources, flags; compiles tinybvh where it is asked for. Knows
//! nothing else.
//!
//! What changes with every commit is left to the running program, or each commit would compile the
//! crate anew. The library by itself writes no reports, and its build notes nothing.

#[cfg(feature = "program")]
#[path = "src/compare/sources.rs"]
mod sources;

#[cfg(feature = "tinybvh")]
#[path = "src/tinybvh/compile.rs"]
mod tinybvh;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    #[cfg(feature = "program")]
    program::note_build();
    #[cfg(feature = "tinybvh")]
    if let Err(error) = tinybvh::compile() {
        println!("cargo::error={}", error.replace('\n', " "));
        std::process::exit(1);
    }
}

#[cfg(feature = "program")]
mod program {
    use std::path::Path;
    use std::process::Command;

    use super::sources;

    /// Notes compiler, sources, profile and flags, as far as they can be found out.
    pub(super) fn note_build() {
        for source in sources::SOURCES {
            println!("cargo::rerun-if-changed={source}");
        }
        let compiler = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
        set("SRT_COMPILER", output(&compiler, &["--version"]));
        set("SRT_SOURCES", sources::fingerprint(Path::new(".")).ok());
        set("SRT_PROFILE", std::env::var("PROFILE").ok());
        let flags = std::env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
        set("SRT_FLAGS", Some(flags.replace('\x1f', " ")));
        set("SRT_FEATURES", std::env::var("CARGO_CFG_TARGET_FEATURE").ok());
    }

    /// What a command prints, if it can be run and ends well.
    fn output(program: &str, arguments: &[&str]) -> Option<String> {
        let output = Command::new(program).args(arguments).output().ok()?;
        let text = String::from_utf8(output.stdout).ok()?;
        output.status.success().then(|| text.trim().to_owned())
    }

    /// Sets a variable that the crate reads while it is compiled.
    fn set(name: &str, value: Option<String>) {
        if let Some(value) = value {
            println!("cargo::rustc-env={name}={value}");
        }
    }
}
