//! How `build.rs` compiles tinybvh, which is C++: where its header is found, and with which flags. Knows nothing of
//! the crate, of which it is no part.
//!
//! The header is that of the crate tinybvh-rs, whose Rust is not used, or one of a folder that the variable
//! `TINYBVH_INCLUDE` names.

use std::env;
use std::fs;
use std::path::PathBuf;

use cargo_metadata::{CargoOpt, Metadata, MetadataCommand};

/// The variable that names a folder with another version of the header.
const FOLDER: &str = "TINYBVH_INCLUDE";
/// The crate that has the header, and where.
const WRAPPER: &str = "tinybvh-rs";
const INSIDE: &str = "ffi/tinybvh";
const HEADER: &str = "tiny_bvh.h";
const SHIM: &str = "src/tinybvh/shim.cpp";
/// What the header is compiled for: its eight-wide search needs both. It has constants that are computed as the program
/// starts, so a program with it needs such a processor from then on.
const FLAGS: [&str; 3] = ["-O3", "-mavx2", "-mfma"];
/// What the structure is called where it can be built, and where not: see `scene/structures.rs`.
const NAME: &str = "SRT_TINYBVH";

/// Compiles it for x86-64; elsewhere there is nothing to compile, and the structure says so.
///
/// # Errors
/// If the header is not found, or is none: what is wrong, and what would be right.
pub(super) fn compile() -> Result<(), String> {
    println!("cargo::rerun-if-env-changed={FOLDER}");
    let is_for = |key: &str, value: &str| env::var(key).is_ok_and(|own| own == value);
    // Documentation is made without a network, and links nothing.
    if env::var_os("DOCS_RS").is_some() || !is_for("CARGO_CFG_TARGET_ARCH", "x86_64") {
        println!("cargo::rustc-env={NAME}=tinybvh");
        return Ok(());
    }
    let folder = folder()?;
    let header = folder.join(HEADER);
    println!("cargo::rerun-if-changed={}", header.display());
    let text = fs::read_to_string(&header).map_err(|error| {
        format!("{}: {error}; {FOLDER} is to name a folder with {HEADER}", header.display())
    })?;
    let version = version(&text).ok_or_else(|| {
        format!("{} has no TINY_BVH_VERSION_MAJOR, _MINOR, _SUB", header.display())
    })?;
    println!("cargo::rustc-env={NAME}=tinybvh {version}");
    let mut build = cc::Build::new();
    build.cpp(true).std("c++20").include(&folder).warnings(false);
    if is_for("CARGO_CFG_TARGET_ENV", "msvc") {
        build.flag("/arch:AVX2").opt_level(2);
    } else {
        build.flags(FLAGS);
    }
    build.file(SHIM).compile("srt_tinybvh");
    Ok(())
}

/// The folder of the header.
fn folder() -> Result<PathBuf, String> {
    if let Some(folder) = env::var_os(FOLDER).filter(|folder| !folder.is_empty()) {
        return Ok(folder.into());
    }
    // What a build needs is there while it runs, but cargo asks for the packages of tests and benches, too.
    let found = metadata(&["--offline"]).or_else(|_| metadata(&[]));
    let found = found.and_then(|metadata| {
        let package = metadata.packages.into_iter().find(|own| own.name == WRAPPER);
        let package = package.ok_or_else(|| format!("cargo knows no package {WRAPPER}"))?;
        Ok(package.manifest_path.with_file_name(INSIDE).into())
    });
    found.map_err(|error| {
        format!("{HEADER} is not found: {error}; the variable {FOLDER} may name a folder with it")
    })
}

/// What cargo knows of the packages that this build has.
fn metadata(more: &[&str]) -> Result<Metadata, String> {
    let target = env::var("TARGET").map_err(|error| format!("TARGET: {error}"))?;
    let options =
        ["--locked", "--filter-platform", &target].into_iter().chain(more.iter().copied());
    let mut command = MetadataCommand::new();
    command.features(CargoOpt::NoDefaultFeatures);
    command.features(CargoOpt::SomeFeatures(vec!["tinybvh".to_owned()]));
    command.other_options(options.map(str::to_owned).collect::<Vec<_>>());
    command.exec().map_err(|error| error.to_string())
}

/// The version that the header says it is.
fn version(header: &str) -> Option<String> {
    let number = |part: &str| {
        let name = format!("TINY_BVH_VERSION_{part}");
        let words = header.lines().map(|line| line.split_whitespace().collect::<Vec<_>>());
        let line = words.into_iter().find(|words| words.starts_with(&["#define", &name]))?;
        line.get(2)?.parse::<u32>().ok()
    };
    Some(format!("{}.{}.{}", number("MAJOR")?, number("MINOR")?, number("SUB")?))
}
