//! The step before all scenes: whether the structures that are not the program's own keep the contract.
//!
//! The rays of a few scenes rarely meet the edges, ties and roundings that tell structures apart; those of
//! [`conformance`](crate::conformance) are made for that. The program's own structures are left out: its tests hold
//! them to more rays of the same kinds. A structure that does not conform is compared in scenes, and not timed.

use std::time::Instant;

use crate::conformance::{Answer, FirstDifference, Limits, Summary};
use crate::record::{Conformance, ConformanceDifference, ConformanceOutcome};
use crate::scene::Structure;

use super::budget::Budget;
use super::observer::Observer;
use super::panics::catch_panic;
use super::pools::Pools;

/// The share of the whole budget that all checks together may take.
const SHARE: f64 = 0.1;

/// Checks the structures that are not the program's own, on all threads. None is begun after the observer cancels.
pub(super) fn check_conformance(
    structures: &[Structure],
    pools: &Pools,
    budget: Budget,
    observer: &dyn Observer,
) -> Vec<Conformance> {
    let budget = budget.share(SHARE);
    let outsiders: Vec<&Structure> =
        structures.iter().filter(|own| !own.peer && !own.is_of_library()).collect();
    let mut checked = Vec::new();
    for (done, structure) in outsiders.iter().enumerate() {
        if observer.cancelled() {
            break;
        }
        observer.begins(&format!("conformance of {}", structure.name));
        let time = budget.share(1.0 / (outsiders.len() - done) as f64).left();
        let cancelled = || observer.cancelled();
        let limits = Limits { time: Some(time), cancelled: &cancelled, ..Limits::NONE };
        checked.extend(check(structure, pools, &limits));
    }
    checked
}

/// Checks one; `None` for a peer, which need not conform.
fn check(structure: &Structure, pools: &Pools, limits: &Limits<'_>) -> Option<Conformance> {
    let start = Instant::now();
    let result = pools.all.install(|| catch_panic(|| structure.check(limits)));
    let none = Conformance {
        structure: structure.name.to_owned(),
        seconds: start.elapsed().as_secs_f64(),
        ..Conformance::default()
    };
    Some(match result {
        Ok(result) => match result? {
            Ok(Summary { meshes, all_meshes, rays, hits }) => Conformance {
                rays: rays as u64,
                hits: hits as u64,
                meshes_checked: meshes as u64,
                meshes: all_meshes as u64,
                ..none
            },
            Err(difference) => {
                Conformance { outcome: ConformanceOutcome::Differs(in_words(&difference)), ..none }
            }
        },
        Err(message) => Conformance { outcome: ConformanceOutcome::Failed { message }, ..none },
    })
}

/// The difference as plain data. Numbers in words read back as the same bits.
fn in_words(difference: &FirstDifference) -> ConformanceDifference {
    let FirstDifference { mesh, scale, offset, quality, update, question, way, ray, .. } =
        difference;
    let FirstDifference { one_by_one, expected, got, .. } = difference;
    let one_by_one = if *one_by_one { ", triangles tested one by one" } else { "" };
    let answer = |answer: &Answer| answer.to_string();
    ConformanceDifference {
        mesh: (*mesh).to_owned(),
        scale: *scale,
        offset: offset.to_array(),
        build: match update {
            Some(update) => format!("{}, {}{one_by_one}", quality.name(), update.participle()),
            None => format!("{}{one_by_one}", quality.name()),
        },
        way: format!("{way}{question}"),
        ray: format!("{ray:?}"),
        expected: answer(expected),
        got: answer(got),
    }
}

/// Why a structure that does not conform is not timed; `None` for one against which nothing is known.
pub(super) fn reason_not_to_time(checked: &[Conformance], structure: &str) -> Option<String> {
    let own = checked.iter().find(|own| own.structure == structure)?;
    match &own.outcome {
        ConformanceOutcome::Equal => None,
        ConformanceOutcome::Differs(first) => Some(format!(
            "its results differ in the check of conformance, at mesh `{}`",
            first.mesh
        )),
        ConformanceOutcome::Failed { message } => {
            Some(format!("in the check of conformance, {message}"))
        }
    }
}
