//! `srt part`: a share of a picture, for `srt assemble` to put together with the others.

use std::io::{IsTerminal, stdout};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use super::exit::{CommandResult, Exit, Failure};
use super::inputs::refuse_to_replace_a_mesh;
use super::interrupt::Interrupt;
use super::load::Loaded;
use super::origin::origin;
use super::output::Output;
use super::part_args::PartArguments;
use super::progress::Progress;
use super::structures::Structures;
use super::summary::ray_rate;
use super::terminal::print_message;
use super::work::Work;
use crate::assets::expect_memory;
use crate::film::{Division, Part, Piece, Share};
use crate::part_file::{Kind, PartFile};
use crate::render::{Kept, Renderer, Settings};
use crate::report::numbers;
use crate::sealed::hexadecimal;

/// Renders a part and writes it.
pub(super) fn run(
    arguments: PartArguments,
    structures: &Structures,
    interrupt: &Interrupt,
) -> CommandResult {
    let PartArguments { scene, part: share, by: division, output, work, lenient, quiet } =
        arguments;
    let mut work = Work::new(scene, work, lenient, quiet)?;
    work.refuse_what_differs("`srt part`")?;
    let output = Output::prepare(&output)?;
    if output.is_stdout() && stdout().is_terminal() {
        return Err(Failure::new(
            "a part does not print well on a terminal: redirect standard output, or name a file",
        ));
    }
    work.refuse_to_replace_the_scene(&output)?;
    let pool = work.pool()?;
    let Some(loaded) = work.load(&pool) else { return Ok(Exit::Trouble) };
    refuse_to_replace_a_mesh(&output, "the part", &loaded)?;
    work.adopt(&loaded, structures)?;
    let settings = work.settings(&loaded.scene, false)?;
    let start = Instant::now();
    let (file, rays) =
        pool.install(|| rendered(&work, &loaded, &settings, (division, share), interrupt))?;
    output.write(|to| file.write(to))?;
    if !quiet {
        let seconds = start.elapsed().as_secs_f64();
        let (tiles, hash) = (file.parts.len(), hexadecimal(&file.origin.hash()[..8]));
        let text = format!(
            "part {share} by {}: {tiles} {}, {}, built and rendered in {}, {}; of the picture {hash}…",
            division.name(),
            if tiles == 1 { "tile" } else { "tiles" },
            numbers::bytes(file.length()),
            numbers::duration(seconds),
            ray_rate(rays, seconds),
        );
        print_message(text.replace(['\u{a0}', '\u{202f}'], " "));
    }
    Ok(Exit::Fine)
}

/// The part, with its tiles in the order of the picture, and how many rays it took.
fn rendered(
    work: &Work,
    loaded: &Loaded,
    settings: &Settings,
    (division, share): (Division, Share),
    interrupt: &Interrupt,
) -> Result<(PartFile, u64), Failure> {
    let pieces = share.pieces(division, settings.region(), settings.film_samples());
    expect_memory(pieces.iter().map(bytes).sum()).map_err(|shortage| {
        Failure::new(format_args!(
            "the part is too large: {shortage}; take more parts, or divide by tiles"
        ))
    })?;
    let world = work.build(&loaded.scene, loaded.built.as_ref())?;
    let renderer = Renderer::new(&loaded.scene, &*world, settings);
    let pixels = pieces.iter().map(|piece| piece.area.pixels()).sum();
    let progress = Progress::start(pixels, work.quiet, interrupt.clone());
    let parts = Mutex::new(Vec::with_capacity(pieces.len()));
    let keep = |part| parts.lock().unwrap_or_else(PoisonError::into_inner).push(part);
    let stats = interrupt.with_last_words(progress.last_words(""), || {
        renderer.render(&pieces, Kept::Sums, &progress, &keep)
    });
    let mut parts: Vec<Part> = parts.into_inner().unwrap_or_else(PoisonError::into_inner);
    parts.sort_by_key(|part| (part.piece.area.y0, part.piece.area.x0));
    let origin = origin(loaded, settings);
    let file = PartFile { origin, kind: Kind::Part { division, share }, parts };
    Ok((file, stats.total_rays()))
}

/// The bytes of memory that a piece takes once it is rendered.
fn bytes(piece: &Piece) -> u64 {
    let kept = if piece.samples.start == 0 { 1 } else { piece.samples.len() as u64 };
    12 * piece.area.pixels() * kept
}
