//! `srt assemble`: the parts of a picture → the picture.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::exit::{CommandResult, Exit, Failure};
use super::inputs::refuse_to_replace;
use super::part_args::AssembleArguments;
use super::picture::PictureTarget;
use super::terminal::print_message;
use crate::assets::read_file;
use crate::film::{Division, Film, Share};
use crate::part_file::{Kind, Origin, PartFile};
use crate::render::Image;
use crate::sealed::hexadecimal;

/// So many parts are named at most.
const MOST_NAMED: usize = 20;

/// Puts parts together.
pub(super) fn run(arguments: &AssembleArguments) -> CommandResult {
    let target = PictureTarget::new(&arguments.output, &arguments.picture)?;
    let refuse =
        |part: &PathBuf| refuse_to_replace(&target.output, "the picture", "the part", part);
    arguments.parts.iter().try_for_each(refuse)?;
    let picture = Parts::survey(&arguments.parts)?;
    let settings = &picture.origin.settings;
    target.check_tone(settings.view)?;
    let film = picture.film()?;
    let remarks = target.write(Image::of(&film, settings.view), settings.view)?;
    if !arguments.quiet {
        remarks.print();
        let (region, count) = (settings.region(), picture.count);
        print_message(format_args!(
            "{} × {}, {} samples a pixel, of {count} {} by {}; the picture {}…",
            region.width(),
            region.height(),
            settings.film_samples(),
            if count == 1 { "part" } else { "parts" },
            picture.division.name(),
            hexadecimal(&picture.origin.hash()[..8]),
        ));
    }
    Ok(Exit::Fine)
}

/// The parts of one picture, all of them, by their numbers.
struct Parts<'a> {
    origin: Origin,
    division: Division,
    count: u32,
    paths: BTreeMap<u32, &'a Path>,
}

impl<'a> Parts<'a> {
    /// Reads every file once, so that all that is wrong with any is known before the work; nothing but headers is kept.
    fn survey(paths: &'a [PathBuf]) -> Result<Self, Failure> {
        let mut parts: Option<Self> = None;
        let mut twice = Vec::new();
        for path in paths {
            let (file, division, share) = read(path)?;
            let parts = parts.get_or_insert_with(|| Self {
                origin: file.origin.clone(),
                division,
                count: share.count,
                paths: BTreeMap::new(),
            });
            parts.expect(path, &file.origin, division, share, &paths[0])?;
            if let Some(first) = parts.paths.insert(share.number, path) {
                let (first, second) = (first.display(), path.display());
                twice.push(format!("part {share} is there twice: `{first}` and `{second}`"));
            }
        }
        let parts = parts.ok_or_else(|| Failure::new("no part was named"))?;
        let wrong: Vec<String> = twice.into_iter().chain(parts.missing()).collect();
        if wrong.is_empty() { Ok(parts) } else { Err(Failure::new(wrong.join("; "))) }
    }

    /// Refuses a part of another picture, or of another division of it.
    fn expect(
        &self,
        path: &Path,
        origin: &Origin,
        division: Division,
        share: Share,
        first: &Path,
    ) -> Result<(), Failure> {
        let (path, first) = (path.display(), first.display());
        if let Some(difference) = self.origin.difference(origin) {
            return Err(Failure::new(format_args!(
                "`{path}` is a part of another picture than `{first}`: it has {difference}"
            )));
        }
        if (division, share.count) != (self.division, self.count) {
            let (own, count) = (self.division.name(), self.count);
            return Err(Failure::new(format_args!(
                "`{path}` is part {share} by {}, and `{first}` is one of {count} by {own}: parts are put \
                 together as the picture was divided",
                division.name(),
            )));
        }
        Ok(())
    }

    /// Names the parts that are missing, if any are.
    fn missing(&self) -> Option<String> {
        let count = self.count as usize - self.paths.len();
        let numbers = (1..=self.count).filter(|number| !self.paths.contains_key(number));
        let named: Vec<String> =
            numbers.take(MOST_NAMED).map(|number| number.to_string()).collect();
        let others = match count.saturating_sub(MOST_NAMED) {
            0 => String::new(),
            others => format!(" and {others} others"),
        };
        let [parts, are] = if count == 1 { ["part", "is"] } else { ["parts", "are"] };
        let of = self.count;
        (count > 0).then(|| format!("{parts} {}{others} of {of} {are} missing", named.join(", ")))
    }

    /// All parts on a film, in the order in which their samples are due, so that none waits.
    fn film(&self) -> Result<Film, Failure> {
        let settings = &self.origin.settings;
        let (region, samples) = (settings.region(), settings.film_samples());
        let film = Film::new(region, samples);
        for (&number, &path) in &self.paths {
            let (file, division, share) = read(path)?;
            let expected =
                Share { number, count: self.count }.pieces(self.division, region, samples);
            let same = share.number == number
                && (division, share.count) == (self.division, self.count)
                && file.parts.iter().map(|part| &part.piece).eq(&expected);
            if !same || self.origin.difference(&file.origin).is_some() {
                return Err(trouble(
                    path,
                    &format_args!("its tiles are not those of part {share}"),
                ));
            }
            for part in file.parts {
                film.take(part).map_err(|error| trouble(path, &error))?;
            }
        }
        Ok(film)
    }
}

/// Reads a part.
fn read(path: &Path) -> Result<(PartFile, Division, Share), Failure> {
    let bytes = read_file(path).map_err(|error| trouble(path, &error))?;
    let file = PartFile::decode(&bytes).map_err(|error| trouble(path, &error))?;
    match file.kind {
        Kind::Part { division, share } => Ok((file, division, share)),
        Kind::Checkpoint => Err(trouble(
            path,
            &"it is the checkpoint of a rendering: `srt SCENE OUTPUT --checkpoint FILE --resume` goes on with it",
        )),
    }
}

fn trouble(path: &Path, why: &dyn std::fmt::Display) -> Failure {
    Failure::new(format_args!("cannot read the part `{}`: {why}", path.display()))
}
