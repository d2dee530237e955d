//! The sixth step: the end-point overlap of trees, if there is time left, because structures are not
//! compared by it.

use crate::compare::budget::Budget;
use crate::compare::candidate::Candidate;
use crate::compare::context::SceneContext;
use crate::scene::TracedWorld;

/// Adds the end-point overlap to the forms of trees; a note if there was no time.
pub(super) fn measure(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    budget: Budget,
) -> Option<String> {
    if budget.is_spent() {
        return Some("there was no time left to measure end-point overlaps.".to_owned());
    }
    let seed = context.plan.picture.seed;
    for candidate in candidates {
        let measure =
            |world: &dyn TracedWorld| context.pools.all.install(|| world.end_point_overlap(seed));
        let overlap = candidate.attempt(measure).flatten();
        if let Some((shape, overlap)) = candidate.record.shape.as_mut().zip(overlap) {
            shape.epo = Some(overlap.cost);
            shape.epo_standard_error = overlap.samples.map(|_| overlap.standard_error);
            shape.epo_samples = overlap.samples;
        }
        if (context.cancelled)() {
            break;
        }
    }
    None
}
