//! The table of contents.

use maud::{Markup, html};

use super::Page;

/// Links to all sections.
pub(super) fn contents(page: &Page<'_>) -> Markup {
    let comparison = page.report.comparison;
    html! {
        nav aria-label="Contents" {
            @if !comparison.conformance.is_empty() { a href="#conformance" { "Conformance" } }
            @if comparison.scenes.len() > 1 && !page.report.analysis.overall.is_empty() { a href="#overall" { "All scenes" } }
            @if comparison.baseline.is_some() { a href="#baseline" { "Against the baseline" } }
            @if !comparison.scenes.is_empty() { a href="#proof" { "Proof" } }
            a href="#run" { "How it was measured" }
            @for (i, scene) in comparison.scenes.iter().enumerate() {
                a href=(format!("#scene-{i}")) { (scene.name) }
            }
            @for (i, sweep) in comparison.sweeps.iter().enumerate() {
                a href=(format!("#growth-{i}")) { "Growth: " (sweep.mesh) }
            }
            @if comparison.sampling.is_some() { a href="#sampling" { "Sampling" } }
            a href="#limits" { "Limits and bias" }
        }
    }
}
