//! `srt check`: validates scenes without rendering, and lists what is in them. The other layers decide
//! what is valid: whatever they refuse to render is invalid here.

use std::path::Path;

use super::args::CheckArguments;
use super::exit::{CommandResult, Exit, Failure};
use super::frames::LAST_FRAME;
use super::inventory;
use super::load::{Described, LoadError, SceneFile, print_load_error};
use super::output::print;
use super::source;
use super::terminal::print_message;

/// The most frames of a scene that moves which are looked at.
const MOST_FRAMES: u64 = 5_000;

/// And the most objects and triangles in all of them: some seconds.
const MOST_WORK: u64 = 100_000_000;

/// Checks every scene, also after one that is not valid; the worst decides how the command ends.
pub(super) fn run(arguments: &CheckArguments) -> CommandResult {
    if arguments.scenes.iter().filter(|path| source::is_stdin(path)).count() > 1 {
        return Err(Failure::new("`-` is named twice, and standard input can be read only once"));
    }
    let mut worst = Exit::Fine;
    for path in &arguments.scenes {
        let exit = check(path, arguments.lenient)?;
        if exit.code() > worst.code() {
            worst = exit;
        }
    }
    Ok(worst)
}

fn check(path: &Path, lenient: bool) -> CommandResult {
    let read = SceneFile::read(path, lenient);
    let read = read.and_then(|mut file| Ok((file.usual_frame()?, file)));
    let error = match read {
        Ok((described, mut file)) => match wrong_frame(path, &mut file, &described) {
            None => return show(path, &described),
            Some((frame, error)) => {
                print_load_error(&error);
                print_message(format_args!("in frame {frame}"));
                error
            }
        },
        Err(error) => {
            print_load_error(&error);
            error
        }
    };
    Ok(match error {
        LoadError::Invalid { .. } => Exit::Negative,
        LoadError::Source(error) if error.is_of_contents() => Exit::Negative,
        LoadError::Source(_) => Exit::Trouble,
    })
}

/// The first frame in which a scene that moves is wrong, and why, of those from its first key to its last.
fn wrong_frame(
    path: &Path,
    file: &mut SceneFile,
    described: &Described,
) -> Option<(u32, LoadError)> {
    let keys = described.keyed_frames.filter(|_| file.built_frame().is_none())?;
    let scene = &described.loaded.scene;
    let (frames, all) = frames(keys, scene.objects.len() as u64 + scene.stored_triangle_count());
    for &frame in frames.iter().filter(|&&frame| frame != described.loaded.frame) {
        if let Err(error) = file.described(frame) {
            return Some((frame, error));
        }
    }
    if (frames.len() as u64) < all {
        let (path, some) = (source::name(path), frames.len());
        print_message(format_args!("note: {path}: {some} of its {all} frames were looked at"));
    }
    None
}

/// The frames of a scene of so many objects and triangles that are looked at, evenly spread from the first key to the
/// last where they are not all; and how many there are.
fn frames(keys: [f64; 2], size: u64) -> (Vec<u32>, u64) {
    let whole = |frame: f64| frame.clamp(0.0, f64::from(LAST_FRAME)) as u64;
    let (first, last) = (whole(keys[0].floor()), whole(keys[1].ceil()));
    let steps = last - first;
    let taken = steps.min((MOST_WORK / size.max(1)).clamp(2, MOST_FRAMES) - 1);
    let frame = |step: u64| first + steps * step / taken.max(1);
    ((0..=taken).map(|step| frame(step) as u32).collect(), steps + 1)
}

fn show(path: &Path, described: &Described) -> CommandResult {
    let Described { loaded, keyed_frames, description } = described;
    if !loaded.warnings.is_empty() {
        print_message(&loaded.warnings);
    }
    let text = inventory::describe(description, &loaded.scene, *keyed_frames);
    print(&format!("{}: valid\n{text}", source::name(path)))?;
    Ok(Exit::Fine)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_all_or_spread_evenly() {
        assert_eq!(frames([0.0, 4.0], 1_000), (vec![0, 1, 2, 3, 4], 5));
        assert_eq!(frames([1.5, 3.5], 1_000), (vec![1, 2, 3, 4], 4));
        assert_eq!(frames([7.0, 7.0], 0), (vec![7], 1));
        assert_eq!(frames([-9.0, 1e300], u64::MAX), (vec![0, LAST_FRAME], 100_000_000));
        let (some, all) = frames([0.0, 100.0], MOST_WORK / 11);
        assert_eq!((some, all), ((0..=10).map(|step| 10 * step).collect(), 101));
        assert_eq!(frames([0.0, 1e6], 1).0.len() as u64, MOST_FRAMES);
    }
}
