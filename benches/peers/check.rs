//! Results before times.

use srt::accel::Tracer;
use srt::compare::measure::RaySet;
use srt::scene::Structure;

/// The share of its rays on which a peer may disagree.
const LARGEST_SHARE: f64 = 1e-4;

/// Compares all results with those of the reference: those of structures must be equal, those of
/// peers must agree on nearly all rays.
pub(crate) fn check(
    structures: &[&Structure],
    worlds: &[&dyn Tracer],
    reference: &dyn Tracer,
    set: &RaySet,
) -> Result<(), String> {
    let (mut expected, mut results) = (set.results(), set.results());
    expected.trace(reference, &set.rays);
    for (structure, world) in structures.iter().zip(worlds) {
        results.trace(*world, &set.rays);
        let is_peer = structure.peer;
        let differing = match is_peer {
            true => results.count_disagreeing(&expected),
            false => results.count_differing(&expected),
        };
        let share = differing as f64 / set.rays.len().max(1) as f64;
        let allowed = if is_peer { LARGEST_SHARE } else { 0.0 };
        if share > allowed {
            let (name, class, of) = (structure.name, set.class.name(), set.rays.len());
            return Err(format!("`{name}`: {differing} of {of} {class} rays differ"));
        }
    }
    Ok(())
}
