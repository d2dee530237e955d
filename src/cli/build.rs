//! `srt build`: a scene with its meshes and the structure over them in one file, for many that start at once.

use std::io::{IsTerminal, Write, stdout};
use std::time::Instant;

use super::args::BuildArguments;
use super::exit::{CommandResult, Exit, Failure};
use super::fingerprint;
use super::inputs::{refuse_to_replace, refuse_to_replace_a_mesh};
use super::load::{Described, LoadError, SceneFile, print_load_error};
use super::origin::{program, scene_hash};
use super::output::Output;
use super::terminal::print_message;
use super::work::{build_config, pool_of, threads};
use crate::built_file::BuiltScene;
use crate::report::numbers;
use crate::scene::SaveError;

/// Builds and writes.
pub(super) fn run(arguments: &BuildArguments) -> CommandResult {
    let BuildArguments { scene: path, output, accel, quiet, .. } = arguments;
    if !accel.can_be_saved() {
        return Err(Failure::new(format_args!(
            "`{}` cannot be saved: choose another --accel, as `bvh8`",
            accel.name
        )));
    }
    let output = Output::prepare(output)?;
    if output.is_stdout() && stdout().is_terminal() {
        return Err(Failure::new(
            "a built scene does not print well on a terminal: redirect standard output, or name a file",
        ));
    }
    refuse_to_replace(&output, "the file", "the scene", path)?;
    let pool = pool_of(threads(arguments.threads)?)?;
    let start = Instant::now();
    let (file, described) = match pool.install(|| described(arguments)) {
        Ok(read) => read,
        Err(error) => {
            print_load_error(&error);
            return Ok(Exit::Trouble);
        }
    };
    let loaded = &described.loaded;
    refuse_to_replace_a_mesh(&output, "the file", loaded)?;
    if !quiet && !loaded.warnings.is_empty() {
        print_message(&loaded.warnings);
    }
    let built = built(arguments, &file, &described)?;
    let mut bytes = 0;
    let mut unsaved = None;
    let write = |to: &mut dyn Write| {
        let to = &mut Counted { to, bytes: &mut bytes };
        built.write(&program(), to)?;
        loaded.scene.write(to)?;
        match accel.save(&loaded.scene, &build_config(arguments.build), to) {
            Err(SaveError::Unwritable(error)) => Err(error),
            Err(error) => {
                unsaved = Some(Failure::new(format_args!("`{}`: {error}", accel.name)));
                Err(std::io::ErrorKind::Other.into())
            }
            Ok(()) => Ok(()),
        }
    };
    let written = pool.install(|| output.write(write));
    if let Some(failure) = unsaved {
        return Err(failure);
    }
    written?;
    if !quiet {
        let text = format!(
            "built the scene with {}, {} objects and {} triangles in memory: {} in {}",
            accel.name,
            numbers::count(loaded.scene.objects.len() as u64),
            numbers::count(loaded.scene.stored_triangle_count()),
            numbers::bytes(bytes),
            numbers::duration(start.elapsed().as_secs_f64()),
        );
        print_message(text.replace(['\u{a0}', '\u{202f}'], " "));
    }
    Ok(Exit::Fine)
}

fn described(arguments: &BuildArguments) -> Result<(SceneFile, Described), LoadError> {
    let mut file = SceneFile::read(&arguments.scene, arguments.lenient)?;
    let described = match arguments.frame {
        Some(frame) => file.described(frame)?,
        None => file.usual_frame()?,
    };
    Ok((file, described))
}

/// All that is written but the compiled scene and its structure.
fn built(
    arguments: &BuildArguments,
    file: &SceneFile,
    Described { loaded, description, keyed_frames }: &Described,
) -> Result<BuiltScene, Failure> {
    let source = file.source();
    let fingerprint = fingerprint::of_source(source, description)
        .map_err(|error| Failure::new(format_args!("cannot read a mesh again: {error}")))?;
    let lenient = source.built().is_some_and(|built| built.scene.lenient);
    Ok(BuiltScene {
        structure: arguments.accel.name.to_owned(),
        quality: arguments.build.name().to_owned(),
        lenient: arguments.lenient || lenient,
        moves: keyed_frames.is_some(),
        frame: loaded.frame,
        hash: scene_hash(loaded),
        fingerprint,
        text: source.bytes().to_vec(),
        meshes: loaded.scene.meshes().to_vec(),
    })
}

/// Counts what is written.
struct Counted<'a> {
    to: &'a mut dyn Write,
    bytes: &'a mut u64,
}

impl Write for Counted<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let written = self.to.write(bytes)?;
        *self.bytes += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.to.flush()
    }
}
