//! Record → one self-contained HTML file.
//!
//! Pictures are embedded, and plots are inline SVG. Its only script sorts tables, and the page is complete without it.
//! Its style is for light and dark screens, phones and paper.

mod contents;
mod pictures;
mod scene;
pub(super) mod table;

use maud::{Markup, html};

use super::limits::{limits, weaknesses};
use super::plot::{self, Looks};
use super::sampling_verdict::sampling_verdict;
use super::verdict::headline;
use super::{Pictures, Report, figures, tables};
use crate::page::{self, Parts};
use crate::record::Comparison;
use table::{bare, table};

/// The sheet of all reports.
pub(super) const STYLE: &str = include_str!("style.css");
/// Sorts tables.
pub(super) const SCRIPT: &str = include_str!("sort.js");

/// The input of every part of the page.
struct Page<'a> {
    report: &'a Report<'a>,
    pictures: &'a Pictures,
    looks: Looks,
}

/// Writes the page: see [`Report::html`].
pub(super) fn write(report: &Report<'_>, pictures: &Pictures) -> String {
    let page = Page { report, pictures, looks: report.looks() };
    document(&page)
}

fn document(page: &Page<'_>) -> String {
    let Comparison { run, scenes, .. } = page.report.comparison;
    let names: Vec<&str> = scenes.iter().map(|scene| scene.name.as_str()).collect();
    let title = format!("srt compares {}", names.join(", "));
    let parts =
        Parts::Within { version: &run.version, styles: &[plot::STYLE, STYLE], script: SCRIPT };
    page::Page { title: &title, parts }.with(body(page))
}

fn body(page: &Page<'_>) -> Markup {
    html! {
        header { (head(page)) }
        (contents::contents(page))
        main {
            (conformance(page))
            (overall(page))
            (baseline(page))
            (proof(page))
            (run(page))
            @for (scene, figures) in page.report.comparison.scenes.iter().zip(&page.report.analysis.scenes) {
                (scene::section(page, scene, figures))
            }
            (growth(page))
            (sampling(page))
            (bias(page))
        }
        footer {
            "Made by srt " (page.report.comparison.run.version) " from a record of schema version "
            (page.report.comparison.schema_version) ". The JSON, CSV and Markdown files beside this page have the same numbers."
        }
    }
}

fn head(page: &Page<'_>) -> Markup {
    let run = &page.report.comparison.run;
    html! {
        p class="kicker" { "srt compares acceleration structures" }
        // An interval stays in one line.
        @let (claim, rest) = headline(page.report);
        h1 { (claim.replace('–', "\u{2060}–\u{2060}")) }
        @if let Some(rest) = rest { p class="subtitle" { (sentence(&rest)) } }
        @if let Some(weaknesses) = weaknesses(page.report) { p class="subtitle" { (weaknesses) } }
        p class="byline" {
            @if run.date.is_empty() { "No date" } @else { time datetime=(run.date) { (run.date) } }
            @if !run.machine.cpu.is_empty() { " · " (run.machine.cpu) }
            @if let Some(commit) = &run.commit { " · commit " code { (commit) } }
        }
        @if run.partial {
            p class="warning" { strong { "Partial." } " The comparison was stopped before its plan was done. This report shows what was measured until then." }
        }
    }
}

/// The checks of structures that are not srt's own.
fn conformance(page: &Page<'_>) -> Markup {
    let own = tables::conformance_table(page.report.comparison);
    html! {
        @if !own.rows.is_empty() {
            section id="conformance" {
                h2 { (own.title) }
                p class="note" { (own.note) }
                (bare(&own))
                @for own in &page.report.comparison.conformance {
                    @if let Some(fault) = own.fault() {
                        p class="warning" { strong { (own.structure) " does not conform: " } (fault) }
                    }
                }
            }
        }
    }
}

/// The structures over all scenes.
fn overall(page: &Page<'_>) -> Markup {
    let own = tables::overall_table(page.report);
    html! {
        @if !own.rows.is_empty() {
            section id="overall" {
                h2 { (own.title) }
                p class="note" { (own.note) }
                (bare(&own))
                @for plot in [figures::speed_by_scene, figures::builds_by_scene, figures::memory_by_scene] {
                    @if let Some(plot) = plot(&page.looks, page.report) { (plot) }
                }
            }
        }
    }
}

fn baseline(page: &Page<'_>) -> Markup {
    html! {
        @if let Some(baseline) = &page.report.comparison.baseline {
            @let own = tables::baseline_table(baseline);
            section id="baseline" {
                h2 { (own.title) }
                @for warning in &baseline.outcome.warnings { p class="warning" { strong { "Warning. " } (warning) } }
                p { (own.note) }
                @if !own.rows.is_empty() { (bare(&own)) }
            }
        }
    }
}

fn proof(page: &Page<'_>) -> Markup {
    let scenes = page.report.comparison.scenes.iter().filter_map(|s| Some((s, s.proof.as_ref()?)));
    html! {
        @if !page.report.comparison.scenes.is_empty() { section id="proof" {
            h2 { "Proof" }
            p { "Structures are compared at equal work only: each must give the reference's picture and hits, bit for bit. Peers, the structures of other libraries, need not. Each scene's chapter has the details." }
            (table(&tables::proof_matrix(page.report.comparison)))
            @for (scene, proof) in scenes {
                @for entry in &proof.structures {
                    @if let Some(difference) = &entry.first_difference {
                        p class="warning" { strong { (entry.structure) " differs in " (scene.name) ". " } "First difference: " (difference) }
                    }
                }
            }
            @for scene in page.report.comparison.scenes.iter().filter(|scene| scene.proof.is_none()) {
                p class="warning" { strong { (scene.name) } " has no proof: its pictures were not compared." }
            }
        } }
    }
}

fn run(page: &Page<'_>) -> Markup {
    html! {
        section id="run" {
            h2 { "How it was measured" }
            pre class="command" tabindex="0" { code { (page.report.comparison.run.command) } }
            dl class="facts" {
                @for (name, value) in tables::facts(page.report.comparison) {
                    div { dt { (name) } dd { (value) } }
                }
            }
        }
    }
}

fn growth(page: &Page<'_>) -> Markup {
    html! {
        @for (i, (sweep, figures)) in page.report.comparison.sweeps.iter().zip(&page.report.analysis.sweeps).enumerate() {
            section id=(format!("growth-{i}")) {
                h2 { "Growth: " (sweep.mesh) }
                p { "The same family of scenes at growing sizes. Dashed lines are power laws fitted to the medians. Their exponents are beside the names." }
                @for class in figures.classes() {
                    @if let Some(plot) = figures::growth(&page.looks, figures, class) { (plot) }
                }
                @for own in tables::growth_tables(sweep, figures) { (table(&own)) }
            }
        }
    }
}

fn sampling(page: &Page<'_>) -> Markup {
    html! {
        @if let Some(chapter) = &page.report.comparison.sampling {
            section id="sampling" {
                h2 { "Sampling" }
                p {
                    @if let Some(verdict) = sampling_verdict(page.report) { (verdict) " " }
                    "The default is " strong { (chapter.default) } "."
                }
                @for scene in figures::noise_scenes(&page.report.analysis) {
                    @if let Some(plot) = figures::noise(&page.report.analysis, scene) { (plot) }
                }
                @for own in tables::sampling_tables(chapter, &page.report.analysis) { (table(&own)) }
            }
        }
    }
}

fn bias(page: &Page<'_>) -> Markup {
    html! {
        section id="limits" {
            h2 { "Limits and bias" }
            ul { @for limit in limits(page.report) { li { (prose(&limit)) } } }
        }
    }
}

/// The rest of the verdict, which follows a semicolon elsewhere, as a sentence of its own. A name of a
/// structure at its beginning stays as it is.
fn sentence(rest: &str) -> String {
    match rest.strip_prefix("no ") {
        Some(rest) => format!("No {rest}"),
        None => rest.to_owned(),
    }
}

/// A sentence in which names stand between backticks.
pub(super) fn prose(text: &str) -> Markup {
    html! {
        @for (i, part) in text.split('`').enumerate() {
            @if i % 2 == 1 { code { (part) } } @else { (part) }
        }
    }
}
