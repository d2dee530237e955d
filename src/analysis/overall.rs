//! One figure for each structure and class over all scenes.

use serde::Serialize;

use super::SceneFigures;
use crate::record::RayClass;

/// How many times as fast as the base a structure is over all scenes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OverallFigures {
    /// The structure.
    pub structure: String,
    /// The class of rays.
    pub class: RayClass,
    /// The geometric mean of the scenes' ratios: of ratios, the only mean that does not depend on the base (Fleming,
    /// Wallace: *How not to lie with statistics*, CACM 29(3), 1986).
    pub speedup: f64,
    /// The number of these scenes: those whose ratio for this class has an interval that supports a statement.
    pub scenes: u32,
}

/// The means over the scenes whose ratios are to the record's base.
pub(super) fn overall(scenes: &[SceneFigures], base: &str) -> Vec<OverallFigures> {
    let with_base: Vec<_> =
        scenes.iter().filter(|scene| scene.base.as_deref() == Some(base)).collect();
    let mut names: Vec<&str> = Vec::new();
    for structure in with_base.iter().flat_map(|scene| &scene.structures) {
        if !names.contains(&structure.structure.as_str()) {
            names.push(&structure.structure);
        }
    }
    let mean = |structure: &str, class: RayClass| {
        let ratio = |scene: &&SceneFigures| {
            let speedup = scene.structure(structure)?.class(class)?.speedup?;
            // The base's ratio to itself is exactly 1, however few its rounds are.
            let known = scene.base.as_deref() == Some(structure) || speedup.supports_a_statement();
            known.then_some(speedup.value)
        };
        let ratios: Vec<f64> = with_base.iter().filter_map(ratio).collect();
        let logarithms: f64 = ratios.iter().map(|ratio| ratio.ln()).sum();
        let speedup = (logarithms / ratios.len() as f64).exp();
        let structure = structure.to_owned();
        let scenes = u32::try_from(ratios.len()).unwrap_or(u32::MAX);
        (!ratios.is_empty()).then_some(OverallFigures { structure, class, speedup, scenes })
    };
    let of_structure = |&name| RayClass::ALL.into_iter().filter_map(move |class| mean(name, class));
    names.iter().flat_map(of_structure).collect()
}
