//! Recorded rays and files of rays: one made of the other, with the answers of a tree.
//!
//! All structures of the program give equal hits, so the answers are those of any of them; the one that traces during
//! a recording is here anyway.

use std::fmt;

use crate::accel::{BuildConfig, QueryKind, Tracer};
use crate::math::Ray;
use crate::ray_file::{ClassRays, RayAnswers, RayFile};
use crate::record::{RayClass, RecordedRays};
use crate::scene::{BuildError, Scene};

use super::proof::describe;
use super::record_rays::{RECORDING_STRUCTURE, RaySet};
use super::trace::trace;
use crate::sealed::hexadecimal;

/// Rays for a scene as a file, with their answers. Each class is there once at most, or nobody reads the file.
///
/// # Errors
/// If there is too little memory for the tree.
pub fn answered_rays(
    scene: &Scene,
    classes: Vec<(RayClass, QueryKind, Vec<Ray>)>,
) -> Result<RayFile, BuildError> {
    let tracer = RECORDING_STRUCTURE.try_build(scene, &BuildConfig::default())?;
    let set = |(class, query, rays)| RaySet { class, rays, query };
    let sets: Vec<RaySet> = classes.into_iter().map(set).collect();
    Ok(file_of(scene, &*tracer, &sets))
}

/// Sets as a file, with the answers of a tracer.
pub(super) fn file_of(scene: &Scene, tracer: &dyn Tracer, sets: &[RaySet]) -> RayFile {
    let class = |set: &RaySet| {
        let mut results = set.results();
        trace(tracer, &set.rays, &mut results, None);
        ClassRays { class: set.class, rays: set.rays.clone(), answers: results }
    };
    RayFile { geometry: scene.geometry_hash(), classes: sets.iter().map(class).collect() }
}

/// The sets of a file.
pub(super) fn sets_of(file: &RayFile) -> Vec<RaySet> {
    file.classes.iter().map(set_of).collect()
}

fn set_of(own: &ClassRays) -> RaySet {
    let rays = own.rays.clone();
    match own.answers {
        RayAnswers::ClosestHit(_) => RaySet::closest_hit(own.class, rays),
        RayAnswers::AnyHit(_) => RaySet::any_hit(own.class, rays),
    }
}

/// The rays of a file in the record.
pub(super) fn record_of(file: &RayFile, replayed: bool) -> RecordedRays {
    RecordedRays {
        hash: hexadecimal(&file.hash()),
        geometry: hexadecimal(&file.geometry),
        replayed,
    }
}

/// Answers of a file that are not those of this program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WrongAnswers {
    /// How many.
    pub count: usize,
    /// Of how many rays.
    pub rays: usize,
    /// The first ray, and both answers: the file's is what was got.
    pub first: String,
}

impl fmt::Display for WrongAnswers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { count, rays, first } = self;
        write!(f, "{count} of its {rays} answers are not those of this program: {first}")
    }
}

/// Compares the answers of a file with those of this program, bit for bit; `None` if they are equal.
///
/// # Errors
/// If there is too little memory for the tree.
pub fn wrong_answers(scene: &Scene, file: &RayFile) -> Result<Option<WrongAnswers>, BuildError> {
    let tracer = RECORDING_STRUCTURE.try_build(scene, &BuildConfig::default())?;
    let (mut count, mut rays, mut first) = (0, 0, None);
    for own in &file.classes {
        let set = set_of(own);
        let mut results = set.results();
        trace(&*tracer, &set.rays, &mut results, None);
        let stated = &own.answers;
        let differing: Vec<usize> = results.differing(stated).collect();
        if let Some(&place) = differing.first() {
            let ray = &set.rays[place];
            first = first
                .or_else(|| Some(describe(&set, ray, &results.get(place), &stated.get(place))));
        }
        count += differing.len();
        rays += set.rays.len();
    }
    Ok(first.map(|first| WrongAnswers { count, rays, first }))
}
