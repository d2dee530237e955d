//! The recorded rays of a class through all structures, in interleaved rounds on one thread.
//!
//! Where a structure would take too long for all rays, it traces as many of them, evenly spread,
//! as its share of the budget allows; nanoseconds per ray stay comparable. Where not even a few
//! rays fit, it sits the class out and its row says so.

use std::time::{Duration, Instant};

use crate::accel::Tracer;
use crate::counters::Counts;
use crate::math::Ray;
use crate::record::{ClassRecord, Round};

use super::Stage;
use super::budget::Budget;
use super::clock::timed;
use super::entrant::{Answers, Entrant, trace};
use super::hardware::Hardware;
use super::record_rays::{RaySet, spread};
use super::rounds::{Repeat, interleaved};

/// Fewer rays than this say nothing of a class.
const FEWEST_RAYS: usize = 16;

/// A round may always take this long, even if the budget is spent: a quick structure is not left
/// out because others were slow.
const LEAST_ROUND: Duration = Duration::from_millis(2);

/// A probe ends once it has taken this long.
const PROBE_TIME: Duration = Duration::from_millis(3);

/// How long one of a structure's rays takes, by a quick look; `None` if it fails.
pub(super) fn probe(entrant: &mut Entrant<'_>, set: &RaySet) -> Option<Duration> {
    entrant.attempt(|tracer| {
        let mut count = 4;
        loop {
            let rays = spread(&set.rays, count);
            // The quicker of two: another program may have had the processor meanwhile.
            let time = (0..2).map(|_| look(tracer, set, &rays)).fold(Duration::MAX, Duration::min);
            if time >= PROBE_TIME || rays.len() == set.rays.len() {
                return time.div_f64(rays.len().max(1) as f64);
            }
            count *= 4;
        }
    })
}

fn look(tracer: &dyn Tracer, set: &RaySet, rays: &[Ray]) -> Duration {
    let start = Instant::now();
    trace(tracer, set.query, rays, &mut Answers::default(), None);
    start.elapsed()
}

/// A structure's part in the rounds of a class.
struct Lane {
    entrant: usize,
    rays: Vec<Ray>,
    answers: Answers,
}

/// Measures a class; each structure's row gets it. `ray_times` are the structures' [`probe`]s.
pub(super) fn replay(
    entrants: &mut [Entrant<'_>],
    set: &RaySet,
    ray_times: &[Option<Duration>],
    stage: &Stage<'_>,
    budget: Budget,
) {
    let rule = &stage.plan.rounds;
    let whole_rounds = rule.at_least + rule.warmup + 1; // one more to count
    let share = budget.left().div_f64(f64::from(whole_rounds) * entrants.len().max(1) as f64);
    let share = share.max(LEAST_ROUND);
    let mut lanes = Vec::new();
    for (index, entrant) in entrants.iter_mut().enumerate() {
        let Some(time) = ray_times[index].filter(|_| entrant.is_fit()) else { continue };
        let affordable = share.as_secs_f64() / time.as_secs_f64().max(1e-12);
        if affordable < FEWEST_RAYS.min(set.rays.len()) as f64 {
            entrant.too_slow(share);
            continue;
        }
        let rays = spread(&set.rays, affordable as usize);
        lanes.push(Lane { entrant: index, rays, answers: Answers::default() });
    }
    let repeat = Repeat { rule, budget, cancelled: &|| (stage.cancelled)() };
    let mut hardware = Hardware::of_this_thread();
    let rounds = interleaved(lanes.len(), &repeat, |lane| {
        let Lane { entrant, rays, answers } = &mut lanes[lane];
        let entrant = &mut entrants[*entrant];
        entrant.attempt(|tracer| {
            // The counters are set going outside of what is timed.
            let work = || timed(|| trace(tracer, set.query, rays, answers, None));
            let (((), round), counts) = hardware.count(work);
            (Round { hardware: counts, ..round }, round.wall_ns)
        })
    });
    for (lane, rounds) in lanes.iter().zip(rounds) {
        note(&mut entrants[lane.entrant], set, &lane.rays, rounds);
    }
}

/// Counts what the rays test, and adds the class to the structure's row.
fn note(entrant: &mut Entrant<'_>, set: &RaySet, rays: &[Ray], rounds: Vec<Round>) {
    if rounds.is_empty() {
        return;
    }
    let counted = entrant.attempt(|tracer| {
        let (mut answers, mut counts) = (Answers::default(), Counts::default());
        trace(tracer, set.query, rays, &mut answers, Some(&mut counts));
        (answers.hit_count(set.query), counts)
    });
    let tests = counted.filter(|_| !entrant.structure.yardstick).map(|(_, counts)| counts);
    entrant.record.classes.push(ClassRecord {
        class: set.class,
        rays: rays.len() as u64,
        hits: counted.map_or(0, |(hits, _)| hits),
        boxes: tests.map(|counts| counts.boxes),
        primitives: tests.map(|counts| counts.primitives),
        rounds,
    });
}
