//! The tables of a scene: proof, structures, rays, time to the picture.

use super::{Cell, Table};
use crate::analysis::statistics::BreakEven;
use crate::analysis::{ClassFigures, SceneFigures, StructureFigures};
use crate::record::{
    Memory, PeerAgreement, Proof, RecordedRays, SceneRecord, ShapeRecord, Status, StructureProof,
    StructureRecord,
};
use crate::report::numbers;

/// Whether results differed, and in how much they were compared.
pub(in crate::report) fn proof_table(proof: &Proof) -> Table {
    let heads = [
        "Structure",
        "Picture",
        "#Pixels compared",
        "#Differing pixels",
        "#Largest difference",
        "#Rays checked",
        "#Differing hits",
    ];
    let reference = &proof.reference;
    let witness_note = proof.witness.as_ref().map(|witness| {
        format!(
            "{reference} had time for some of the rays only, and {witness} agrees with it on all of \
             them. The other structures were compared with {witness}."
        )
    });
    let peer_note = (!proof.peers.is_empty()).then(|| PEER_NOTE.to_owned());
    let notes: Vec<String> = witness_note.into_iter().chain(peer_note).collect();
    let mut table = Table::new("Proof", notes.join(" "), &heads);
    table.rows = proof.structures.iter().map(|entry| proof_row(entry, reference)).collect();
    table.rows.extend(proof.peers.iter().map(peer_row));
    table
}

/// How the rows of peers are to be read.
const PEER_NOTE: &str = "Structures without a remark test primitives by the same formula, srt's, whoever built \
                         their tree. “As shipped” is a peer: another library with its own triangles and search. Its \
                         formulas differ from srt's, so its hits and pictures differ in their last bits. Its \
                         result for a ray agrees if it has the same primitive or nearly the same distance.";

/// What is said of a peer in every table, beside its name or in its place.
const AS_SHIPPED: &str = "as shipped";

/// A structure's name, and of a peer that it is as shipped, where others have the same formula.
pub(in crate::report) fn structure_name(scene: &SceneRecord, structure: &str) -> Cell {
    let is_peer = scene.structure(structure).is_some_and(|own| own.peer);
    Cell { spread: is_peer.then(|| AS_SHIPPED.to_owned()), ..Cell::text(structure) }
}

fn peer_row(entry: &PeerAgreement) -> Vec<Cell> {
    let differing = entry.rays_checked.saturating_sub(entry.rays_agreeing);
    vec![
        Cell::text(&entry.structure),
        Cell::text(agreement(entry)),
        Cell::nothing(),
        Cell::nothing(),
        Cell::nothing(),
        Cell::text(numbers::whole(entry.rays_checked)),
        Cell::text(format!("{} disagree", numbers::whole(differing))),
    ]
}

/// In how much a structure's results were compared without a difference: `120 k rays, 300 × 200 pixels`; `None` if
/// nothing was compared.
pub(in crate::report) fn compared_without_difference(entry: &StructureProof) -> Option<String> {
    let rays =
        (entry.rays_checked > 0).then(|| format!("{} rays", numbers::count(entry.rays_checked)));
    let pixels = match entry.picture_equal {
        // Older records have no size.
        Some(true) => Some(entry.picture_size.map_or_else(
            || "a picture".to_owned(),
            |size| format!("{} pixels", numbers::size(size)),
        )),
        _ => None,
    };
    let parts: Vec<String> = rays.into_iter().chain(pixels).collect();
    (!parts.is_empty()).then(|| parts.join(", "))
}

/// How a peer agrees, in words.
pub(in crate::report) fn agreement(entry: &PeerAgreement) -> String {
    // Rounded down, so that 100 % means all.
    let percent = entry.share().map(|share| (share * 1e6).floor() / 1e4);
    percent.map_or_else(|| AS_SHIPPED.to_owned(), |p| format!("{AS_SHIPPED}: {p} % agree"))
}

fn proof_row(entry: &StructureProof, reference: &str) -> Vec<Cell> {
    let picture = match entry.picture_equal {
        _ if entry.structure == reference => "the reference",
        Some(true) => "no difference",
        Some(false) => "DIFFERS",
        None => "not compared",
    };
    // Empty cells for what was not compared; the reference is not compared with anything.
    let is_other = entry.structure != reference;
    let pixels = (is_other && entry.picture_equal.is_some()).then_some(entry);
    let rays = (entry.rays_checked > 0).then_some(entry);
    vec![
        Cell::text(&entry.structure),
        Cell::text(picture),
        Cell::of(pixels.and_then(|entry| entry.picture_size), numbers::size),
        Cell::of(pixels, |entry| numbers::whole(entry.differing_pixels)),
        Cell::of(pixels, |entry| numbers::exact(entry.largest_difference)),
        Cell::of(rays, |entry| numbers::whole(entry.rays_checked)),
        Cell::of(rays.filter(|_| is_other), |entry| numbers::whole(entry.differing_hits)),
    ]
}

/// Builds, memory and shapes of the structures.
pub(in crate::report) fn structure_table(scene: &SceneRecord, figures: &SceneFigures) -> Table {
    let heads = [
        "Structure",
        "Status",
        "#Build, 1 thread",
        "#Build, all threads",
        "#Memory",
        "#Bytes/triangle",
        "#Peak resident",
        "#Nodes",
        "#Leaves",
        "#Depth",
        "#Refs/primitive",
        "#SAH cost",
        "#EPO",
    ];
    let note = format!(
        "Memory is that of the index and of the triangles of meshes, which some structures copy; \
         of a library it is all that it keeps. Below a time is the 95 % interval of \
         its median. SAH cost is the expected cost of a ray by the surface area heuristic. EPO is \
         the end-point overlap: the cost of the boxes around a ray's end point that do not belong \
         to the surface there. A test costs 1.{}",
        overlap_note(scene)
    );
    let mut table = Table::new("Structures", note, &heads);
    let rows = scene.structures.iter().zip(&figures.structures);
    let row = |(own, figures)| structure_row(scene, own, figures);
    table.rows = rows.map(row).collect();
    table
}

fn structure_row(
    scene: &SceneRecord,
    record: &StructureRecord,
    figures: &StructureFigures,
) -> Vec<Cell> {
    let memory = record.memory.as_ref();
    let shape = record.shape.as_ref();
    vec![
        structure_name(scene, &record.name),
        Cell::text(status(&record.status)),
        Cell::time(figures.build_one_thread_ns),
        Cell::time(figures.build_all_threads_ns),
        Cell::of(memory.map(Memory::total_bytes), numbers::bytes),
        Cell::of(figures.total_bytes_per_triangle, numbers::figures),
        Cell::of(memory.and_then(|memory| memory.peak_resident_bytes), numbers::bytes),
        Cell::of(shape.map(|shape| shape.nodes), numbers::whole),
        Cell::of(shape.map(|shape| shape.leaves), numbers::whole),
        Cell::of(shape.map(|shape| shape.depth), |depth| depth.to_string()),
        Cell::of(figures.references_per_primitive, numbers::figures),
        Cell::of(shape.and_then(|shape| shape.sah_cost), numbers::figures),
        shape.and_then(overlap).unwrap_or_else(Cell::nothing),
    ]
}

/// End-point overlap, with its standard error where it was estimated.
fn overlap(shape: &ShapeRecord) -> Option<Cell> {
    let epo = shape.epo?;
    let places = numbers::decimals(epo, 5);
    let spread = shape.epo_standard_error.map(|error| format!("± {error:.places$}"));
    Some(Cell { text: numbers::figures(epo), spread })
}

/// How many triangles end-point overlaps were estimated from.
fn overlap_note(scene: &SceneRecord) -> String {
    let samples = scene.structures.iter().find_map(|own| own.shape.as_ref()?.epo_samples);
    samples.map_or_else(String::new, |samples| {
        format!(
            " EPO was estimated from {}, sampled by area; ± is its standard error.",
            numbers::things(samples, "triangle")
        )
    })
}

/// A status in words.
fn status(status: &Status) -> String {
    match status {
        Status::Ok => "ok".to_owned(),
        Status::Failed { message } => format!("failed: {message}"),
        Status::TooSlow { after_seconds } => {
            format!("too slow for {}", numbers::time(after_seconds * 1e9))
        }
        Status::Stopped => "stopped early".to_owned(),
    }
}

/// The rays, by class.
pub(in crate::report) fn ray_table(scene: &SceneRecord, figures: &SceneFigures) -> Table {
    let heads = [
        "Class",
        "Structure",
        "#× base",
        "#M rays/s",
        "#ns/ray",
        "#Rays",
        "#Hits",
        "#Boxes/ray",
        "#Primitives/ray",
        "#Rounds",
        "#Wall/own time",
    ];
    let mut table = Table::new("Rays", ray_note(figures), &heads);
    for class in figures.classes() {
        let rows = figures.structures.iter().filter_map(|s| Some((s, s.class(class)?)));
        table.rows.extend(
            rows.map(|(structure, class)| {
                ray_row(structure_name(scene, &structure.structure), class)
            }),
        );
    }
    table
}

/// Where the rays come from, before their hash.
pub(in crate::report) fn rays_in_words(rays: &RecordedRays) -> &'static str {
    if rays.replayed { "Rays read from a file:" } else { "Rays written to a file:" }
}

/// How the rows of rays are to be read.
fn ray_note(figures: &SceneFigures) -> String {
    let base = figures.base.as_deref().unwrap_or("none");
    let mut note = format!(
        "Estimates for all recorded rays, each with its 95 % interval, or – if there were too few \
         passes for one. “× base” is how many times as fast as {base} the structure is: the ratio of the \
         estimates. ns/ray does not include waiting for a processor that other programs used."
    );
    let all = || figures.structures.iter().flat_map(|structure| &structure.classes);
    if all().any(ClassFigures::is_sampled) {
        note += " “a of b” rays: each round traced a random sample, drawn anew, and the interval \
                 includes the choice of the sample.";
    }
    if all().any(|class| class.counted_share.is_some_and(|share| share < 1.0)) {
        note += " ≈ marks tests that were counted on a sample of the rays; hits are those of the structure \
                 that was counted on the most.";
    }
    let estimates = |class: &ClassFigures| [class.million_rays_per_second, class.speedup];
    if all().flat_map(estimates).flatten().any(|own| !own.supports_a_statement()) {
        note += " A number whose interval is missing, or reaches beyond half or twice its value, is \
                 in no chart, rank or mean.";
    }
    if all().any(ClassFigures::is_disturbed) {
        note += " † marks rows with a wall time of more than 1.1 times the rounds' own time: they are \
                 less reliable.";
    }
    let parallel = |own: &StructureFigures| {
        let shares = own.classes.iter().filter_map(ClassFigures::processor_share);
        let share = shares.reduce(f64::max)?;
        Some(format!("{} {}", own.structure, numbers::figures(share)))
    };
    let parallel: Vec<String> = figures.structures.iter().filter_map(parallel).collect();
    if !parallel.is_empty() {
        note +=
            &format!(" Processor time over own time, where they differ: {}.", parallel.join(", "));
    }
    note
}

fn ray_row(structure: Cell, class: &ClassFigures) -> Vec<Cell> {
    vec![
        Cell::text(class.class.name()),
        structure,
        Cell::compared(class.speedup),
        Cell::compared(class.million_rays_per_second),
        Cell::compared(class.ns_per_ray),
        Cell {
            text: numbers::whole(class.rays),
            spread: class
                .is_sampled()
                .then(|| format!("of {}", numbers::whole(class.recorded_rays))),
        },
        Cell::of(class.hit_share, numbers::percent),
        counted(class, class.boxes_per_ray),
        counted(class, class.primitives_per_ray),
        Cell::of(class.ns_per_ray, |estimate| estimate.rounds.to_string()),
        Cell::of(class.disturbance, |disturbance| {
            let mark = if class.is_disturbed() { " †" } else { "" };
            format!("{}{mark}", numbers::figures(disturbance))
        }),
    ]
}

/// Tests of a ray, marked where they are those of a sample.
fn counted(class: &ClassFigures, per_ray: Option<f64>) -> Cell {
    let mark = if class.counted_share.is_some_and(|share| share < 1.0) { "≈ " } else { "" };
    Cell::of(per_ray, |tests| format!("{mark}{}", numbers::figures(tests)))
}

/// What the processor counted; without rows if the system did not permit it.
pub(in crate::report) fn hardware_table(scene: &SceneRecord, figures: &SceneFigures) -> Table {
    let heads =
        ["Class", "Structure", "#Instructions/cycle", "#Branch misses/ray", "#Cache misses/ray"];
    let note = "Estimates for all recorded rays, each with its 95 % interval. Cache misses are those of the \
                last-level cache.";
    let mut table = Table::new("Hardware counters", note, &heads);
    for class in figures.classes() {
        let rows = figures.structures.iter().filter_map(|s| Some((s, s.class(class)?)));
        let row = |(own, class): (&StructureFigures, _)| {
            hardware_row(structure_name(scene, &own.structure), class)
        };
        table.rows.extend(rows.filter_map(row));
    }
    table
}

fn hardware_row(structure: Cell, class: &ClassFigures) -> Option<Vec<Cell>> {
    let counted =
        [class.instructions_per_cycle, class.branch_misses_per_ray, class.cache_misses_per_ray];
    counted.iter().any(Option::is_some).then(|| {
        let names = [Cell::text(class.class.name()), structure];
        names.into_iter().chain(counted.map(Cell::estimate)).collect()
    })
}

/// Build and rendering together, and from how many rays on a slower build pays off.
pub(in crate::report) fn picture_table(scene: &SceneRecord, figures: &SceneFigures) -> Table {
    let heads = [
        "Structure",
        "#Build",
        "#Render",
        "#Together",
        "#× base",
        "#Rounds",
        "Faster than the base",
    ];
    let note = format!(
        "All threads. A build here follows a rendering, which has left little of the structure's in the \
         caches, and takes longer than the builds of the table of structures, which follow each other. \
         The last column is for one thread, by these builds: the number of the picture's mean rays from \
         which on a structure is faster than {}, build included, as far as intervals tell them apart.",
        figures.base.as_deref().unwrap_or("the base")
    );
    let mut table = Table::new("Time to the picture", note, &heads);
    table.rows = figures.structures.iter().map(|own| picture_row(scene, own)).collect();
    table
}

fn picture_row(scene: &SceneRecord, figures: &StructureFigures) -> Vec<Cell> {
    vec![
        structure_name(scene, &figures.structure),
        Cell::time(figures.picture_build_ns),
        Cell::time(figures.picture_render_ns),
        Cell::time(figures.picture_ns),
        Cell::estimate(figures.picture_speedup),
        Cell::of(figures.picture_ns, |estimate| estimate.rounds.to_string()),
        Cell::of(figures.break_even, break_even),
    ]
}

/// A break-even in words.
fn break_even(when: BreakEven) -> String {
    match when {
        BreakEven::Always => "from the first ray on".to_owned(),
        BreakEven::After { rays } => format!("after {} rays", numbers::about(rays)),
        BreakEven::Until { rays } => format!("only for the first {} rays", numbers::about(rays)),
        BreakEven::Never => "never".to_owned(),
        BreakEven::NotToldApart => "not told apart".to_owned(),
    }
}
