//! Simulated structures by a simulated clock: what they cost is known, so it can be seen whether the estimates of every
//! budget agree with it, and with each other.

use std::cell::Cell;

use super::*;
use crate::analysis::Analysis;
use crate::compare::block_sample::Sample;
use crate::compare::class_rounds::{Work, round_shares};
use crate::math::Random;
use crate::record::{
    ClassRecord, Comparison, Estimate, RayClass, Run, SceneRecord, StructureRecord,
};

thread_local! {
    static NOW: Cell<Duration> = const { Cell::new(Duration::ZERO) };
}

fn clock() -> Duration {
    NOW.get()
}

fn pass(time: Duration) {
    NOW.set(NOW.get() + time);
}

/// A structure over a scene: what each ray costs it, in nanoseconds.
struct Simulated {
    name: &'static str,
    costs: Vec<f64>,
}

/// A scene of which a third of the picture is background and a part is fine: costs of neighbours are alike, and those
/// of some parts are far above the mean.
fn scene(seed: u64, rays: usize, none: f64) -> Vec<Simulated> {
    let mut random = Random::new(&[seed]);
    let mut difficulty = 1.0;
    let difficulties: Vec<f64> = (0..rays)
        .map(|ray| {
            if ray % 512 == 0 {
                let u = f64::from(random.next_f32());
                difficulty = if u < 0.3 { 0.15 } else { 0.6 / (1.05 - u) };
            }
            difficulty * (0.8 + 0.4 * f64::from(random.next_f32()))
        })
        .collect();
    // A linear search costs nearly the same everywhere; trees differ in how much they suffer where it is fine.
    let structures = [
        ("none", none, 0.05),
        ("ball", none / 9.0, 0.3),
        ("bvh", 420.0, 0.8),
        ("cwbvh", 310.0, 0.9),
        ("bvh8", 140.0, 1.0),
    ];
    let simulated = |(name, ns, power): (&'static str, f64, f64)| Simulated {
        name,
        costs: difficulties.iter().map(|d| ns * d.powf(power)).collect(),
    };
    structures.map(simulated).into()
}

/// The time that all builds of a simulated scene take.
const BUILDS: Duration = Duration::from_millis(60);

/// A scene as it is measured: each structure is slower or faster by up to four percent wherever it is built, and for a
/// second or so by what else the machine does.
struct Simulation<'a> {
    structures: &'a [Simulated],
    /// The structure of each task.
    tasks: Vec<usize>,
    random: Random,
    place: Vec<f64>,
    drift: f64,
}

impl Measured for Simulation<'_> {
    fn build_anew(&mut self) {
        pass(BUILDS);
        self.place = self.structures.iter().map(|_| around_one(&mut self.random, 0.04)).collect();
        self.drift = around_one(&mut self.random, 0.05);
    }

    fn trace(&mut self, _: usize, task: usize, blocks: &[Block]) -> Option<Round> {
        let structure = self.tasks[task];
        let costs = &self.structures[structure].costs;
        // A search of everything suffers less from its neighbours than trees do.
        let drift = if structure == 0 { 1.0 } else { self.drift };
        let factor = self.place[structure] * drift * around_one(&mut self.random, 0.01);
        let cost =
            |range: &std::ops::Range<usize>| factor * costs[range.clone()].iter().sum::<f64>();
        let timed: f64 = blocks.iter().map(|block| cost(&block.timed)).sum();
        let warmup: f64 = blocks.iter().map(|block| cost(&block.warmup)).sum();
        pass(Duration::from_nanos((timed + warmup) as u64));
        Some(Round { wall_ns: timed as u64, ..Round::default() })
    }
}

/// A factor that is evenly spread from `1 - reach` to `1 + reach`.
fn around_one(random: &mut Random, reach: f64) -> f64 {
    1.0 + reach * (2.0 * f64::from(random.next_f32()) - 1.0)
}

/// Measures a class as a comparison does, within a budget, on a machine of its own.
fn measure(structures: &[Simulated], budget: Duration, seed: u64, machine: u64) -> SceneRecord {
    let rays = structures[0].costs.len();
    let rule = RoundRule { warmup: 1, at_least: 10, relative_interval: 0.02 };
    let budget = Budget::by(clock, budget);
    let mean = |own: &Simulated| own.costs.iter().sum::<f64>() / rays as f64;
    let work = |own| Work { ray_time: Duration::from_nanos(mean(own) as u64), rays };
    let works: Vec<Work> = structures.iter().map(work).collect();
    let build_time = affordable_builds(BUILDS, budget);
    let passes = Passes { rule, budget, cancelled: &|| false, build_time };
    let shares = round_shares(&works, &passes.rule, passes.time_for_rounds());
    let tasks: Vec<(usize, Sample)> = shares
        .iter()
        .enumerate()
        .filter_map(|(i, share)| Some((i, share.samples?.timed)))
        .collect();
    let samples: Vec<(Sample, Duration)> =
        tasks.iter().map(|&(i, sample)| (sample, works[i].ray_time)).collect();
    let mut simulation = Simulation {
        structures,
        tasks: tasks.iter().map(|task| task.0).collect(),
        random: Random::new(&[seed, machine, 77]),
        place: vec![1.0; structures.len()],
        drift: 1.0,
    };
    let mut classes = [ClassRounds::new(rays, seed, &samples)];
    assert!(passes.run(&mut classes, &mut simulation));
    let [class] = classes;
    let mut record = SceneRecord { name: "simulated".to_owned(), ..SceneRecord::default() };
    record.structures = structures.iter().map(|own| row(own.name)).collect();
    for ((index, sample), rounds) in tasks.into_iter().zip(class.rounds) {
        record.structures[index].classes.push(ClassRecord {
            class: RayClass::View,
            rays: sample.timed_rays(rays) as u64,
            sample: sample.record(rays),
            counted_rays: 0,
            hits: 0,
            boxes: None,
            primitives: None,
            rounds,
            passes: class.passes.iter().map(|&rounds| rounds as u64).collect(),
        });
    }
    record
}

fn row(name: &str) -> StructureRecord {
    StructureRecord { name: name.to_owned(), ..StructureRecord::default() }
}

/// The speed-ups over `bvh`, by structure; those that support no statement are left out.
fn speedups(record: SceneRecord) -> Vec<(String, Estimate)> {
    let mut comparison = Comparison::new(Run::default(), "bvh");
    comparison.scenes.push(record);
    let figures = Analysis::of(&comparison).scenes.remove(0);
    let speedup = |own: &crate::analysis::StructureFigures| {
        let speedup = own.class(RayClass::View)?.speedup?;
        speedup.supports_a_statement().then(|| (own.structure.clone(), speedup))
    };
    figures.structures.iter().filter_map(speedup).collect()
}

/// The budgets that users choose, for one scene alone and for one of twenty: intervals overlap in every cell, contain
/// what is true about as often as they claim, and rank no two structures differently.
#[test]
fn the_ratio_is_a_property_of_the_structures_and_not_of_the_budget() {
    let (mut cells, mut covered) = (0, 0);
    for (seed, rays, none) in [(1, 40 * 1024, 9e5), (2, 60 * 1024, 4e4), (3, 12 * 1024, 3e6)] {
        let structures = scene(seed, rays, none);
        let truth = |name: &str| {
            let sum = |own: &Simulated| own.costs.iter().sum::<f64>();
            let own = structures.iter().find(|own| own.name == name).unwrap();
            sum(&structures[2]) / sum(own)
        };
        let mut all: Vec<(f64, Vec<(String, Estimate)>)> = Vec::new();
        for seconds in [15.0, 60.0, 240.0] {
            for share in [1.0, 0.05] {
                // Four classes share a scene's time, and half of it is for pictures and builds.
                let budget = Duration::from_secs_f64(seconds * share / 8.0);
                let start = NOW.get();
                let own = speedups(measure(&structures, budget, seed, (seconds / share) as u64));
                let took = NOW.get() - start;
                assert!(
                    took < budget.mul_f64(1.3) + Duration::from_millis(300),
                    "{took:?} of {budget:?}"
                );
                assert!(own.len() >= 3, "{seconds} s, {share}: {own:?}");
                all.push((seconds * share, own));
            }
        }
        for (budget, own) in &all {
            for (name, speedup) in own.iter().filter(|(name, _)| name != "bvh") {
                let i = speedup.interval.unwrap();
                cells += 1;
                covered += usize::from(i.low <= truth(name) && truth(name) <= i.high);
                for (other_budget, other) in &all {
                    let Some((_, other)) = other.iter().find(|(other, _)| other == name) else {
                        continue;
                    };
                    let o = other.interval.unwrap();
                    assert!(
                        i.low <= o.high && o.low <= i.high,
                        "{name} over bvh, {rays} rays: {speedup:?} with {budget} s, {other:?} with {other_budget} s"
                    );
                }
            }
            let mut ranked: Vec<_> = own.iter().collect();
            ranked.sort_by(|a, b| a.1.value.total_cmp(&b.1.value));
            let names: Vec<&str> = ranked.iter().map(|(name, _)| name.as_str()).collect();
            let expected: Vec<&str> = ["none", "ball", "bvh", "cwbvh", "bvh8"]
                .into_iter()
                .filter(|name| names.contains(name))
                .collect();
            assert_eq!(names, expected, "{budget} s");
        }
    }
    assert!(cells > 50, "{cells}");
    assert!(covered * 100 >= cells * 90, "{covered} of {cells} intervals contain the truth");
}

#[test]
fn a_structure_without_time_for_two_blocks_has_no_part() {
    let rule = RoundRule { warmup: 1, at_least: 10, relative_interval: 0.02 };
    let works = [Duration::from_millis(50), Duration::from_nanos(500)]
        .map(|ray_time| Work { ray_time, rays: 40_960 });
    let shares = round_shares(&works, &rule, Duration::from_millis(1_200));
    assert!(shares[0].samples.is_none(), "{shares:?}");
    assert_eq!(shares[1].samples.unwrap().timed, Sample::Whole, "{shares:?}");
}

#[test]
fn builds_are_repeated_only_where_they_leave_time_for_rays() {
    let budget = Budget::by(clock, Duration::from_secs(8));
    let affordable = |ms| affordable_builds(Duration::from_millis(ms), budget);
    assert_eq!(affordable(500), Some(Duration::from_millis(500)));
    assert_eq!(affordable(501), None);
}

/// Classes that differ: one of a single task whose rounds are equal, one of a task that fails in the third pass.
#[test]
fn classes_end_when_they_have_enough_and_failed_tasks_take_no_part() {
    #[derive(Default)]
    struct Two {
        builds: usize,
        traced: [usize; 2],
    }
    impl Measured for Two {
        fn build_anew(&mut self) {
            self.builds += 1;
        }
        fn trace(&mut self, class: usize, task: usize, _: &[Block]) -> Option<Round> {
            self.traced[class] += 1;
            pass(Duration::from_millis(1));
            let fails = class == 1 && task == 1 && self.builds >= 2;
            // The second class never has a narrow interval.
            let wall_ns = if class == 0 { 1_000 } else { 1_000 << (self.builds % 3) };
            (!fails).then_some(Round { wall_ns, ..Round::default() })
        }
    }
    let task = (Sample::Whole, Duration::from_micros(1));
    let mut classes = [ClassRounds::new(1_000, 1, &[task]), ClassRounds::new(1_000, 2, &[task; 2])];
    let mut two = Two::default();
    let passes = Passes {
        rule: RoundRule { warmup: 1, at_least: 10, relative_interval: 0.02 },
        budget: Budget::by(clock, Duration::from_millis(200)),
        cancelled: &|| false,
        build_time: Some(Duration::ZERO),
    };
    assert!(passes.run(&mut classes, &mut two));
    assert_eq!(classes[0].passes, [2; 5]);
    assert_eq!(two.traced[0], 5 * 3, "two rounds a pass, after one that warms up");
    assert!(classes[1].passes.len() > 20 && two.builds + 1 == classes[1].passes.len());
    assert_eq!(classes[1].rounds[1].len(), 2 * 2, "it failed in the third pass");
    assert_eq!(classes[1].rounds[0].len(), classes[1].passes.iter().sum::<usize>());
}
