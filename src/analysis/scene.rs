//! Figures of a scene and of the structures over it.

use serde::Serialize;

use super::class::{ClassFigures, class_figures, hit_share, quotient};
use super::costs::compare_costs;
use super::statistics::{BetweenRuns, BreakEven, Cost, estimate, paired_ratio};
use crate::record::{Estimate, Memory, PictureRound, RayClass, SceneRecord, StructureRecord};

/// The figures of all structures over a scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SceneFigures {
    /// The name of the scene.
    pub scene: String,
    /// The structure that ratios are taken to: the record's base, or the first measured structure if the base was not
    /// measured.
    pub base: Option<String>,
    /// The structures, in the record's order.
    pub structures: Vec<StructureFigures>,
}

/// The figures of a structure over a scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StructureFigures {
    /// The name of the structure.
    pub structure: String,
    /// Wall time of the build on one thread, in nanoseconds.
    pub build_one_thread_ns: Option<Estimate>,
    /// Wall time of the build on all threads, in nanoseconds.
    pub build_all_threads_ns: Option<Estimate>,
    /// Bytes of the index per triangle in memory; absent without meshes.
    pub bytes_per_triangle: Option<f64>,
    /// Bytes of the index and of the triangles together, per triangle in memory: what can be compared with a peer,
    /// whose index may hold the triangles.
    pub total_bytes_per_triangle: Option<f64>,
    /// References from leaves to primitives, per primitive.
    pub references_per_primitive: Option<f64>,
    /// Wall time of build and rendering on all threads, in nanoseconds.
    pub picture_ns: Option<Estimate>,
    /// Wall time of the builds within these rounds, in nanoseconds.
    pub picture_build_ns: Option<Estimate>,
    /// Wall time of the renderings within these rounds, in nanoseconds.
    pub picture_render_ns: Option<Estimate>,
    /// How many times as fast as the base is with build and rendering.
    pub picture_speedup: Option<Estimate>,
    /// Own time of the picture's mean ray in nanoseconds: the estimates of the classes of
    /// [`RayClass::RENDERED`], weighted by their recorded rays; absent if the interval of one is missing or too wide,
    /// or if another structure of the scene traced a class that this one did not.
    pub mean_ray_ns: Option<f64>,
    /// From how many of these rays on it is faster than the base, all on one thread, builds included; absent if one of
    /// these times has no interval.
    pub break_even: Option<BreakEven>,
    /// Whether it is dominated by no other structure: by none whose build or mean ray is faster, and the other of both
    /// not slower, as far as intervals tell them apart.
    pub on_pareto_front: bool,
    /// The classes of rays that were traced; none if it failed, though the record has what it traced before.
    pub classes: Vec<ClassFigures>,
}

impl SceneFigures {
    /// Computes the figures of a scene.
    pub(super) fn of(scene: &SceneRecord, base: &str, between_runs: BetweenRuns) -> Self {
        let base = base_of(scene, base);
        let figures = |own| StructureFigures::of(scene, own, base, between_runs);
        let mut structures: Vec<_> = scene.structures.iter().map(figures).collect();
        compare_costs(scene, &mut structures, base, between_runs);
        let base = base.map(|base| base.name.clone());
        Self { scene: scene.name.clone(), base, structures }
    }

    /// The structure of a name.
    #[must_use]
    pub fn structure(&self, name: &str) -> Option<&StructureFigures> {
        self.structures.iter().find(|structure| structure.structure == name)
    }

    /// How many times as fast as the base a structure of the scene is: the geometric mean over the classes that the
    /// base traced. `None` if one of them has no ratio that supports a statement.
    #[must_use]
    pub fn mean_speedup(&self, structure: &StructureFigures) -> Option<f64> {
        let base = self.structure(self.base.as_deref()?)?;
        if base.structure == structure.structure {
            return Some(1.0);
        }
        let mut logarithms = 0.0;
        for class in &base.classes {
            let ratio = structure.class(class.class)?.speedup?;
            logarithms += ratio.supports_a_statement().then(|| ratio.value.ln())?;
        }
        let mean = logarithms / base.classes.len() as f64;
        mean.is_finite().then(|| mean.exp())
    }

    /// The classes that any structure traced, in the order of reports.
    #[must_use]
    pub fn classes(&self) -> Vec<RayClass> {
        let traced = |class: &RayClass| self.structures.iter().any(|s| s.class(*class).is_some());
        RayClass::ALL.into_iter().filter(traced).collect()
    }
}

impl StructureFigures {
    fn of(
        scene: &SceneRecord,
        own: &StructureRecord,
        base: Option<&StructureRecord>,
        between_runs: BetweenRuns,
    ) -> Self {
        let triangles = stored(scene);
        let estimate = |rounds: &[f64]| estimate(rounds).map(|own| between_runs.widen(own));
        let base_class = |class| base.and_then(|base| base.class(class));
        let measured = own.classes.iter().filter(|_| !own.has_failed());
        let classes = measured.map(|class| ClassFigures {
            hit_share: hit_share(scene, class.class),
            ..class_figures(class, base_class(class.class), between_runs)
        });
        let picture_rounds = picture_ns(own);
        let shape = own.shape.as_ref();
        let per_triangle = |bytes: fn(&Memory) -> u64| {
            let memory = own.memory.as_ref()?;
            quotient(bytes(memory) as f64, triangles as f64)
        };
        Self {
            structure: own.name.clone(),
            build_one_thread_ns: estimate(&floats(&own.build.one_thread_ns)),
            build_all_threads_ns: estimate(&floats(&own.build.all_threads_ns)),
            bytes_per_triangle: per_triangle(|memory| memory.index_bytes),
            total_bytes_per_triangle: per_triangle(Memory::total_bytes),
            references_per_primitive: shape
                .and_then(|shape| quotient(shape.references as f64, shape.primitives as f64)),
            picture_build_ns: estimate(&picture_part(own, |round| round.build_ns)),
            picture_render_ns: estimate(&picture_part(own, |round| round.render_ns)),
            picture_ns: estimate(&picture_rounds),
            picture_speedup: base.and_then(|base| {
                let ratio = paired_ratio(&picture_ns(base), &picture_rounds)?;
                Some(if std::ptr::eq(base, own) { ratio } else { between_runs.widen(ratio) })
            }),
            mean_ray_ns: None,
            break_even: None,
            on_pareto_front: false,
            classes: classes.collect(),
        }
    }

    /// A class of rays.
    #[must_use]
    pub fn class(&self, class: RayClass) -> Option<&ClassFigures> {
        self.classes.iter().find(|figures| figures.class == class)
    }

    /// Build and mean ray on one thread, if both are known.
    #[must_use]
    pub fn cost(&self) -> Option<Cost> {
        Some(Cost { build_ns: self.build_one_thread_ns?.value, ray_ns: self.mean_ray_ns? })
    }
}

/// The triangles that structures index: each mesh has one index for all of its objects. None without meshes, whatever
/// single triangles there are: an index over objects has no bytes per triangle.
fn stored(scene: &SceneRecord) -> u64 {
    let has_meshes = |row: &StructureRecord| {
        row.peer || row.memory.as_ref().is_none_or(|memory| memory.primitive_bytes > 0)
    };
    match scene.structures.iter().any(has_meshes) {
        true if scene.stored_triangles > 0 => scene.stored_triangles,
        true => scene.triangles,
        false => 0,
    }
}

/// The structure of the name if it traced any rays and did not fail, or the first structure of which that is true.
fn base_of<'a>(scene: &'a SceneRecord, name: &str) -> Option<&'a StructureRecord> {
    let traced = |structure: &&StructureRecord| {
        !structure.has_failed() && structure.classes.iter().any(|class| !class.rounds.is_empty())
    };
    let first = || scene.structures.iter().find(traced);
    scene.structure(name).filter(traced).or_else(first)
}

/// Build and rendering of each round, in nanoseconds.
fn picture_ns(structure: &StructureRecord) -> Vec<f64> {
    picture_part(structure, |round| round.build_ns.saturating_add(round.render_ns))
}

/// A part of each round, in nanoseconds.
fn picture_part(structure: &StructureRecord, part: fn(&PictureRound) -> u64) -> Vec<f64> {
    structure.picture_rounds.iter().map(|round| part(round) as f64).collect()
}

pub(super) fn floats(values: &[u64]) -> Vec<f64> {
    values.iter().map(|&value| value as f64).collect()
}
