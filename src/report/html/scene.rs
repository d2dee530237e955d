//! The chapter of a scene.

use maud::{Markup, html};

use super::table::{bare, table};
use super::{Page, pictures};
use crate::analysis::SceneFigures;
use crate::record::SceneRecord;
use crate::report::plot::Plot;
use crate::report::{figures, numbers, tables};

/// Pictures, tables, plots and raw rounds of a scene.
pub(super) fn section(page: &Page<'_>, scene: &SceneRecord, own: &SceneFigures) -> Markup {
    let number = page
        .report
        .comparison
        .scenes
        .iter()
        .position(|s| std::ptr::eq(s, scene))
        .unwrap_or_default();
    html! {
        section class="scene" id=(format!("scene-{number}")) {
            h2 { (scene.name) }
            p {
                (numbers::things(scene.objects, "object")) ", " (numbers::things(scene.triangles, "triangle")) ", "
                (numbers::things(scene.lights, "light")) ", from " code { (scene.path) } "."
            }
            p class="hash" { "Scene: SHA-256 " code { (scene.hash) } }
            @if let Some(rays) = &scene.rays {
                p class="hash" { (tables::rays_in_words(rays)) " SHA-256 " code { (rays.hash) } ", for geometry with SHA-256 " code { (rays.geometry) } }
            }
            (pictures::strip(page, scene))
            @if let Some(proof) = &scene.proof { (table(&tables::proof_table(proof))) }
            @if let Some(picture) = &scene.picture { p class="hash" { "Pixels of the reference: SHA-256 " code { (picture.hash) } } }
            (table(&tables::ray_table(scene, own)))
            @let hardware = tables::hardware_table(scene, own);
            @if !hardware.rows.is_empty() { (table(&hardware)) }
            (plots([figures::speedups(&page.looks, own), figures::rates(&page.looks, own)]))
            (table(&tables::structure_table(scene, own)))
            (table(&tables::stage_table(scene, page.report.comparison.run.options.threads)))
            (plots([figures::leaves(&page.looks, scene), figures::pareto(&page.looks, own)]))
            (table(&tables::picture_table(scene, own)))
            (plots([figures::break_even(&page.looks, own), None]))
            (rounds(scene))
        }
    }
}

fn plots(plots: [Option<Plot>; 2]) -> Markup {
    html! { @for plot in plots.into_iter().flatten() { (plot) } }
}

fn rounds(scene: &SceneRecord) -> Markup {
    let all = tables::round_table(scene);
    html! {
        @if !all.rows.is_empty() {
            details {
                summary { (all.title) " of " (scene.name) }
                div class="rounds" { (bare(&all)) }
            }
        }
    }
}
