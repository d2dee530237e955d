//! Answers before times.

use srt::accel::Tracer;
use srt::scene::Structure;

use crate::rays::RaySet;
use crate::rounds::answers;

/// The share of its rays that a peer may answer otherwise.
const LARGEST_SHARE: f64 = 1e-4;

/// Holds all answers against the guide's: those of structures must be equal, those of peers
/// must agree but for few.
pub(crate) fn check(
    structures: &[&Structure],
    worlds: &[&dyn Tracer],
    guide: &dyn Tracer,
    set: &RaySet,
) -> Result<(), String> {
    let (hits, blocked) = answers(guide, set.class, &set.rays);
    for (structure, world) in structures.iter().zip(worlds) {
        let own = answers(*world, set.class, &set.rays);
        let differing_hits = hits.iter().zip(&own.0).filter(|(a, b)| match structure.peer {
            true => !a.agrees(b),
            false => !a.same_bits(b),
        });
        let differing_blocked = blocked.iter().zip(&own.1).filter(|(a, b)| a != b);
        let differing = differing_hits.count() + differing_blocked.count();
        let share = differing as f64 / set.rays.len().max(1) as f64;
        let allowed = if structure.peer { LARGEST_SHARE } else { 0.0 };
        if share > allowed {
            let (name, class) = (structure.name, set.class);
            let of = set.rays.len();
            return Err(format!("`{name}`: {differing} of {of} {class:?} rays differ"));
        }
    }
    Ok(())
}
