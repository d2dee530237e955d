//! Figures of a sweep: curves of cost against size, and their slopes.

use serde::Serialize;

use super::class::own_ns_per_ray;
use super::statistics::{BetweenRuns, PowerLaw, log_log_fit};
use crate::record::{Estimate, RayClass, Sweep, SweepPoint};

/// The curves of a family of scenes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SweepFigures {
    /// The family.
    pub mesh: String,
    /// What its sizes count.
    pub unit: String,
    /// One curve for each structure and class, in the order of their first points.
    pub curves: Vec<SweepCurve>,
}

/// A structure and a class of rays at growing sizes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SweepCurve {
    /// The structure.
    pub structure: String,
    /// The class of rays.
    pub class: RayClass,
    /// The measurements, by growing size.
    pub values: Vec<SweepValue>,
    /// The power law fitted to nanoseconds per ray against size, where intervals support a statement.
    pub fit: Option<PowerLaw>,
}

/// A point of a curve.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SweepValue {
    /// The size: triangles of the mesh, or objects.
    pub triangles: u64,
    /// Own time per ray in nanoseconds.
    pub ns_per_ray: Estimate,
    /// The exponent of the power law from the size before to this one: 0 is constant, 1 is linear. Absent for the first
    /// size, and where the interval of either supports no statement.
    pub slope: Option<f64>,
}

impl SweepFigures {
    /// Computes the curves of a sweep. Points without rounds are left out.
    pub(super) fn of(sweep: &Sweep, between_runs: BetweenRuns) -> Self {
        let mut curves: Vec<SweepCurve> = Vec::new();
        for point in &sweep.points {
            let Some(value) = value(point, between_runs) else { continue };
            let same = |c: &SweepCurve| c.structure == point.structure && c.class == point.class;
            if let Some(curve) = curves.iter_mut().find(|curve| same(curve)) {
                curve.values.push(value);
            } else {
                curves.push(SweepCurve {
                    structure: point.structure.clone(),
                    class: point.class,
                    values: vec![value],
                    fit: None,
                });
            }
        }
        for curve in &mut curves {
            curve.values.sort_by_key(|value| value.triangles);
            for place in 1..curve.values.len() {
                curve.values[place].slope =
                    fit(&curve.values[place - 1..=place]).map(|law| law.slope);
            }
            curve.fit = fit(&curve.values);
        }
        Self { mesh: sweep.mesh.clone(), unit: sweep.unit.clone(), curves }
    }

    /// The curve of a structure and class.
    #[must_use]
    pub fn curve(&self, structure: &str, class: RayClass) -> Option<&SweepCurve> {
        self.curves.iter().find(|curve| curve.structure == structure && curve.class == class)
    }

    /// The classes that were traced, in the order of reports.
    #[must_use]
    pub fn classes(&self) -> Vec<RayClass> {
        let traced = |class: &RayClass| self.curves.iter().any(|curve| curve.class == *class);
        RayClass::ALL.into_iter().filter(traced).collect()
    }
}

fn value(point: &SweepPoint, between_runs: BetweenRuns) -> Option<SweepValue> {
    let ns_per_ray =
        own_ns_per_ray(&point.rounds, point.rays, point.sample, &point.passes).estimate()?;
    let ns_per_ray = between_runs.widen(ns_per_ray);
    Some(SweepValue { triangles: point.triangles, ns_per_ray, slope: None })
}

fn fit(values: &[SweepValue]) -> Option<PowerLaw> {
    let supported = values.iter().filter(|value| value.ns_per_ray.supports_a_statement());
    let point = |value: &SweepValue| (value.triangles as f64, value.ns_per_ray.value);
    log_log_fit(&supported.map(point).collect::<Vec<_>>())
}
