//! The recorded rays of a class through all structures, in interleaved rounds on one thread.
//!
//! Where a structure would take too long for all rays, it traces as many of them, evenly spread,
//! as its share of the budget allows. For the ratio, the quicker of it and the base then traces the
//! rays of the slower too, in every round. Where not even a few rays fit, it sits the class out and
//! its row says so.

use std::time::Duration;

use crate::accel::Tracer;
use crate::counters::Counts;
use crate::math::Ray;
use crate::record::{ClassRecord, CommonRays, Round};

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
///
/// `known` is what a ray of another class took it. A structure of which a single ray takes longer
/// than a look may is not asked again: it tests nearly everything for rays of any class, and every
/// one of them would cost more than a small budget has.
pub(super) fn probe(
    entrant: &mut Entrant<'_>,
    set: &RaySet,
    known: Option<Duration>,
) -> Option<Duration> {
    if known.is_some_and(|known| known >= PROBE_TIME) {
        return known.filter(|_| entrant.is_fit());
    }
    entrant.attempt(|tracer| {
        let mut count = 1;
        loop {
            let rays = spread(&set.rays, count);
            // The quicker of two looks, unless the first took long: caches were cold, or another
            // program had the processor.
            let first = look(tracer, set, &rays);
            let again = || look(tracer, set, &rays);
            let time = if first >= PROBE_TIME { first } else { first.min(again()) };
            if time >= PROBE_TIME || rays.len() == set.rays.len() {
                return time.div_f64(rays.len().max(1) as f64);
            }
            count *= 4;
        }
    })
}

/// A structure's [`probe`]s of some classes, one after the other: each knows those before it.
pub(super) fn probe_all(entrant: &mut Entrant<'_>, sets: &[RaySet]) -> Vec<Option<Duration>> {
    let mut known = None;
    let probe = |set| {
        let time = probe(entrant, set, known);
        known = known.max(time);
        time
    };
    sets.iter().map(probe).collect()
}

/// How long a structure needs for all recorded rays, by what was probed; without end, if it was not.
pub(super) fn time_of_all(times: &[Option<Duration>], sets: &[RaySet]) -> Duration {
    let of_class = |(time, set): (&Option<Duration>, &RaySet)| {
        time.as_ref()?.checked_mul(u32::try_from(set.rays.len()).ok()?)
    };
    let all = times.iter().zip(sets).map(of_class);
    all.sum::<Option<Duration>>().unwrap_or(Duration::MAX)
}

/// What a look may take longer on the wall than of its own, at most.
const MOST_WAITING: u64 = 4;

/// The time of some rays. What other programs take of the processor now, they will take of the
/// rounds too, but a single interruption of a short look is not taken for the rule.
fn look(tracer: &dyn Tracer, set: &RaySet, rays: &[Ray]) -> Duration {
    let work = || trace(tracer, set.query, rays, &mut Answers::default(), None);
    let round = timed(work).1;
    Duration::from_nanos(round.wall_ns.min(round.own_ns().saturating_mul(MOST_WAITING)))
}

/// A structure's part in the rounds of a class.
struct Lane {
    entrant: usize,
    rays: Vec<Ray>,
    /// The rays of other lanes that it traces too, for ratios on equal rays: of one lane only,
    /// unless it is the base's.
    too: Vec<Common>,
    answers: Answers,
}

/// Rays that the base's lane and another have in common, where one of them has more.
struct Common {
    /// The other lane, which is not the base's.
    lane: usize,
    rays: Vec<Ray>,
}

/// Lets the lane that has more rays than its partner trace the partner's too, for each pair of the
/// base's lane and another.
fn pair_with_base(lanes: &mut [Lane], base: usize) {
    for lane in (0..lanes.len()).filter(|&lane| lane != base) {
        let (own, of_base) = (lanes[lane].rays.len(), lanes[base].rays.len());
        let (more, fewer) = if own > of_base { (lane, base) } else { (base, lane) };
        if own != of_base {
            let rays = lanes[fewer].rays.clone();
            lanes[more].too.push(Common { lane, rays });
        }
    }
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
        lanes.push(Lane { entrant: index, rays, too: Vec::new(), answers: Answers::default() });
    }
    let named = |lane: &Lane| entrants[lane.entrant].structure.name == stage.base;
    let base = lanes.iter().position(named).unwrap_or_default();
    pair_with_base(&mut lanes, base);
    let repeat = Repeat { rule, budget, cancelled: &|| (stage.cancelled)() };
    let mut hardware = Hardware::of_this_thread();
    let rounds = interleaved(lanes.len(), &repeat, |lane| {
        let Lane { entrant, rays, too, answers } = &mut lanes[lane];
        let entrant = &mut entrants[*entrant];
        entrant.attempt(|tracer| {
            // The counters are set going outside of what is timed.
            let work = || timed(|| trace(tracer, set.query, rays, answers, None));
            let (((), round), counts) = hardware.count(work);
            let common: Vec<Round> = too
                .iter()
                .map(|common| timed(|| trace(tracer, set.query, &common.rays, answers, None)).1)
                .collect();
            (RoundOfLane { all: Round { hardware: counts, ..round }, common }, round.own_ns())
        })
    });
    for (lane, own) in lanes.iter().enumerate() {
        let all = rounds[lane].iter().map(|round| round.all).collect();
        let common = common_rays(&lanes, &rounds, lane, base);
        note(&mut entrants[own.entrant], set, &own.rays, all, common);
    }
}

/// A round of a lane: with all its rays, and with the rays of other lanes.
struct RoundOfLane {
    all: Round,
    common: Vec<Round>,
}

/// What a lane and the base's did with the rays that both traced, where these are not all.
fn common_rays(
    lanes: &[Lane],
    rounds: &[Vec<RoundOfLane>],
    lane: usize,
    base: usize,
) -> Option<CommonRays> {
    let of = |tracing: usize| {
        let place = lanes[tracing].too.iter().position(|common| common.lane == lane)?;
        Some(rounds[tracing].iter().map(|round| round.common[place]).collect())
    };
    let all = |tracing: usize| rounds[tracing].iter().map(|round| round.all).collect();
    if lane == base || lanes[lane].rays.len() == lanes[base].rays.len() {
        return None;
    }
    let rays = lanes[lane].rays.len().min(lanes[base].rays.len()) as u64;
    let (own, base) = match of(lane) {
        Some(own) => (own, all(base)),
        None => (all(lane), of(base)?),
    };
    Some(CommonRays { rays, own, base })
}

/// Counts what the rays test, and adds the class to the structure's row.
fn note(
    entrant: &mut Entrant<'_>,
    set: &RaySet,
    rays: &[Ray],
    rounds: Vec<Round>,
    common: Option<CommonRays>,
) {
    if rounds.is_empty() {
        return;
    }
    let counted = entrant.attempt(|tracer| {
        let (mut answers, mut counts) = (Answers::default(), Counts::default());
        trace(tracer, set.query, rays, &mut answers, Some(&mut counts));
        (answers.hit_count(set.query), counts)
    });
    let tests = counted.filter(|_| !entrant.structure.peer).map(|(_, counts)| counts);
    entrant.record.classes.push(ClassRecord {
        class: set.class,
        rays: rays.len() as u64,
        hits: counted.map_or(0, |(hits, _)| hits),
        boxes: tests.map(|counts| counts.boxes),
        primitives: tests.map(|counts| counts.primitives),
        rounds,
        common,
    });
}
