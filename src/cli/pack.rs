//! `srt pack`: a scene with all its files in one file, for another machine.

use std::borrow::Cow;
use std::fs;
use std::io::{IsTerminal, stdout};
use std::path::{MAIN_SEPARATOR, Path};

use sha2::{Digest, Sha256};

use super::args::PackArguments;
use super::exit::{CommandResult, Exit, Failure};
use super::fingerprint;
use super::inputs::{refuse_to_replace, refuse_to_replace_a_mesh};
use super::load::{SceneFile, print_load_error};
use super::mesh_scene::NamedMesh;
use super::output::Output;
use super::source::{Source, folder_of, is_stdin};
use super::terminal::print_message;
use crate::pack::{Located, Pack, locate};
use crate::report::numbers;
use crate::sealed::hexadecimal;

/// Packs a scene that is valid.
pub(super) fn run(arguments: &PackArguments) -> CommandResult {
    let PackArguments { scene: path, output, lenient, quiet } = arguments;
    let output = Output::prepare(output)?;
    if output.is_stdout() && stdout().is_terminal() {
        return Err(Failure::new(
            "a pack does not print well on a terminal: redirect standard output, or name a file",
        ));
    }
    refuse_to_replace(&output, "the pack", "the scene", path)?;
    let mut file = match SceneFile::read(path, *lenient) {
        Ok(file) => file,
        Err(error) => {
            print_load_error(&error);
            return Ok(Exit::Trouble);
        }
    };
    if file.source().built().is_some() {
        let path = path.display();
        return Err(Failure::new(format_args!(
            "`{path}` is a built scene, and has no mesh files: pack the scene that it was built from"
        )));
    }
    let described = match file.described(0) {
        Ok(described) => described,
        Err(error) => {
            print_load_error(&error);
            return Ok(Exit::Trouble);
        }
    };
    refuse_to_replace_a_mesh(&output, "the pack", &described.loaded)?;
    if !quiet && !described.loaded.warnings.is_empty() {
        print_message(&described.loaded.warnings);
    }
    let mut names: Vec<&str> = Vec::new();
    for name in fingerprint::files(&described.description) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let bytes = packed(path, file.source(), &names)?;
    output.write(|to| to.write_all(&bytes))?;
    if !quiet {
        let files = names.len();
        let text = format!(
            "packed the scene and {files} {}, {}; SHA-256 {}",
            if files == 1 { "file" } else { "files" },
            numbers::bytes(bytes.len() as u64),
            hexadecimal(&Sha256::digest(&bytes)),
        );
        print_message(text.replace(['\u{a0}', '\u{202f}'], " "));
    }
    Ok(Exit::Fine)
}

/// The bytes of the pack of a scene and of the files that it names.
fn packed(path: &Path, source: &Source, names: &[&str]) -> Result<Vec<u8>, Failure> {
    let Located { scene, files } = located(path, source, names)?;
    let read = |name: &&str| {
        source
            .file(name)
            .map_err(|error| Failure::new(format_args!("cannot read `{name}` again: {error}")))
    };
    let contents: Vec<Cow<'_, [u8]>> = names.iter().map(read).collect::<Result<_, _>>()?;
    let mut members = vec![(scene.as_str(), source.bytes())];
    for (name, contents) in files.iter().zip(&contents) {
        // Two names may mean one file.
        if members.iter().all(|(other, _)| *other != name.as_str()) {
            members.push((name, contents));
        }
    }
    let mut bytes = Vec::new();
    Pack::write(&members, &mut bytes)
        .map_err(|error| Failure::new(format_args!("cannot pack the scene: {error}")))?;
    Ok(bytes)
}

/// What the scene and its files are called in a pack.
fn located(path: &Path, source: &Source, names: &[&str]) -> Result<Located, Failure> {
    if let Some(located) = source.located(names) {
        return Ok(located);
    }
    let stdin = is_stdin(path);
    let folder = if stdin { Path::new("") } else { folder_of(path) };
    let here = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let folder = fs::canonicalize(here).map_err(|error| {
        Failure::new(format_args!("cannot find the folder `{}`: {error}", here.display()))
    })?;
    let folder = folder.to_string_lossy().replace(MAIN_SEPARATOR, "/");
    let name = match NamedMesh::of(path) {
        // The mesh has its own name.
        Some(NamedMesh::File(name)) => Some(Cow::Owned(format!("{name}.sce"))),
        Some(NamedMesh::Generated(_)) => None,
        None if stdin => None,
        None => path.file_name().map(|name| name.to_string_lossy()),
    };
    locate(&folder, &name.unwrap_or(Cow::Borrowed("scene.sce")), names).map_err(|error| {
        Failure::new(format_args!(
            "cannot pack the scene: {error}; name its meshes relative to the scene"
        ))
    })
}
