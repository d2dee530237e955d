//! All structures are given the same rays: each notes what it is given, ray by ray, and the notes
//! are compared bit for bit.

use std::ops::{ControlFlow, Range};
use std::sync::{Mutex, PoisonError};

use srt::accel::{Accel, Bounded, Build, Built, Bvh, CompressedWideBvh, Exhaustive};
use srt::compare::{Observer, Plan, run};
use srt::counters::Counters;
use srt::math::{BoxRay, Ray};
use srt::record::RayClass;
use srt::scene::Structure;

use crate::plan;

/// A ray's origin, direction and interval, as bits.
type Bits = [u32; 8];

/// What each structure was given, in order.
static NOTES: [Mutex<Vec<Bits>>; 3] = [const { Mutex::new(Vec::new()) }; 3];

fn take(number: usize) -> Vec<Bits> {
    std::mem::take(&mut *NOTES[number].lock().unwrap_or_else(PoisonError::into_inner))
}

/// A structure that notes its rays under a number.
struct Noting<A, const NUMBER: usize>(A);

impl<A: Accel, const NUMBER: usize> Accel for Noting<A, NUMBER> {
    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        let Built { accel, order } = A::build(primitives, build);
        Built { accel: Self(accel), order }
    }

    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        let Ray { origin: o, dir: d, t_min, t_max } = *ray;
        let bits = [o.x, o.y, o.z, d.x, d.y, d.z, t_min, t_max].map(f32::to_bits);
        NOTES[NUMBER].lock().unwrap_or_else(PoisonError::into_inner).push(bits);
        self.0.traverse(ray, box_ray, counters, leaf);
    }

    fn bytes(&self) -> u64 {
        self.0.bytes()
    }
}

/// Throws away what was noted before the rays are replayed.
struct FromReplayOn;

impl Observer for FromReplayOn {
    fn begins(&self, what: &str) {
        if what.ends_with("timing rays") {
            (0..NOTES.len()).for_each(|number| drop(take(number)));
        }
    }
    fn advanced(&self, _: f64) {}
    fn cancelled(&self) -> bool {
        false
    }
}

#[test]
fn every_structure_is_given_the_same_rays_in_every_round() {
    let structures = [
        Structure::new::<Noting<Exhaustive, 0>, Exhaustive>("first", "no structure"),
        Structure::new::<Noting<Bvh, 1>, Bvh>("second", "a tree"),
        Structure::new::<Noting<CompressedWideBvh, 2>, Bvh>("third", "a wide tree"),
    ];
    let mut all = Vec::new();
    for class in RayClass::ALL {
        let plan = Plan { classes: vec![class], ..plan() };
        let result = run(&plan, &structures, &FromReplayOn).unwrap();
        let rows = &result.comparison.scenes[0].structures;
        let notes: Vec<Vec<Bits>> = (0..NOTES.len()).map(take).collect();
        if class == RayClass::Refraction {
            assert!(notes.iter().all(Vec::is_empty), "nothing is transparent");
            continue;
        }
        let rays = rows[0].class(class).unwrap().rays as usize;
        for (row, notes) in rows.iter().zip(&notes) {
            let record = row.class(class).unwrap();
            assert_eq!(record.rays as usize, rays, "{}: all have time for all rays", row.name);
            // One round of each pass warms up, and one counts. Before all rays of a round are timed, the last
            // thousands of them warm the caches: here that is all of them.
            let rounds = 2 * (record.rounds.len() + record.passes.len()) + 1;
            assert_eq!(record.passes.iter().sum::<u64>() as usize, record.rounds.len());
            assert_eq!(notes.len(), rounds * rays, "{class:?} of {}", row.name);
            for round in notes.chunks(rays) {
                assert!(round == &notes[..rays], "{class:?}: {} has other rays", row.name);
            }
        }
        assert!(notes.iter().all(|own| own[..rays] == notes[0][..rays]), "{class:?}: rays differ");
        all.push(notes[0][..rays].to_vec());
    }
    for (i, class) in all.iter().enumerate() {
        assert!(class.len() >= 16 && !all[..i].contains(class), "each class has its own rays");
    }
}
