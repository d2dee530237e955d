//! `srt report`: a record → the report again, in all its forms.

use std::fs;
use std::path::Path;

use super::compare_args::ReportArguments;
use super::exit::{Exit, Outcome};
use super::output::print;
use super::result_folder::{PictureFiles, ResultFolder, read_record};
use crate::record::Comparison;
use crate::report::terminal;

/// Writes the report again.
pub(super) fn run(arguments: &ReportArguments) -> Outcome {
    let own_folder = match arguments.record.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let comparison = read_record(&arguments.record)?;
    let folder = ResultFolder::prepare(arguments.out.as_deref().unwrap_or(own_folder))?;
    folder.write(&comparison, &pictures(&comparison, own_folder))?;
    if !arguments.quiet {
        print(&terminal::write(&comparison))?;
    }
    Ok(Exit::Fine)
}

/// The pictures that a record names, as far as they are there: a report says which are missing.
///
/// A record may come from anywhere, so a name that leads out of its folder is not followed.
fn pictures(comparison: &Comparison, folder: &Path) -> PictureFiles {
    let of_structures = |scene: &crate::record::SceneRecord| {
        let heatmaps = scene.structures.iter().filter_map(|structure| structure.heatmap.clone());
        scene.picture.clone().into_iter().chain(heatmaps).collect::<Vec<_>>()
    };
    let named = comparison.scenes.iter().flat_map(of_structures).map(|picture| picture.file);
    let inside = |name: &String| {
        Path::new(name).components().all(|part| matches!(part, std::path::Component::Normal(_)))
    };
    let read = |name: String| Some((name.clone(), fs::read(folder.join(&name)).ok()?));
    named.filter(inside).filter_map(read).collect()
}
