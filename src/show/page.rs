//! The slides of a structure → one self-contained page of HTML, for a lecture or for paper.
//!
//! Without scripts, and on paper, all slides stand in rows.

use maud::{Markup, html};

use crate::image_io::{EncodeError, Format, encode};
use crate::math::Color;
use crate::page::{Page, Parts, picture, slides as in_slides};
use crate::scene::BuildReport;

use super::slides::{LevelFacts, Slide, Which};

const STYLE: &str = include_str!("style.css");

/// What the page says beside the slides.
#[derive(Clone, Copy, Debug)]
pub struct Facts<'a> {
    /// The name of the structure, with its options.
    pub structure: &'a str,
    /// What it is, in a line.
    pub summary: &'a str,
    /// The name of the scene.
    pub scene: &'a str,
    /// How many objects it has.
    pub objects: u64,
    /// What building the structure gave; its times are not shown, so that the page is always the same.
    pub build: &'a BuildReport,
}

/// Writes the page.
///
/// # Errors
/// If a picture is too large to be written.
pub fn page(facts: &Facts<'_>, slides: &[Slide]) -> Result<String, EncodeError> {
    let figures: Vec<Markup> = slides
        .iter()
        .map(|slide| Ok(figure(slide, &encode(&slide.picture, Format::Png)?)))
        .collect::<Result<_, EncodeError>>()?;
    let title = format!("{} over {}", facts.structure, facts.scene);
    let parts = Parts::Within {
        version: env!("CARGO_PKG_VERSION"),
        styles: &[STYLE, in_slides::STYLE],
        script: in_slides::SCRIPT,
    };
    Ok(Page { title: &title, parts }.with(body(facts, slides, &figures)))
}

fn body(facts: &Facts<'_>, slides: &[Slide], figures: &[Markup]) -> Markup {
    html! {
        header {
            h1 { code { (facts.structure) } " over " (facts.scene) }
            p class="quiet" { (facts.summary) }
        }
        main {
            (in_slides::slides("slide", None, figures))
            (table(slides))
            (shape(facts))
        }
        footer class="quiet" {
            "Lines are the edges of the parts of space that rays are tested against; they are faint where a "
            "surface is before them. Made by srt " (env!("CARGO_PKG_VERSION")) "."
        }
    }
}

fn figure(slide: &Slide, png: &[u8]) -> Markup {
    let size = [slide.picture.width, slide.picture.height];
    html! {
        figure {
            (picture(png, size, &format!("{}: {}", slide.title, slide.caption)))
            figcaption {
                strong {
                    @if let Some(level) = &slide.level { (chip(level.color)) }
                    (slide.title)
                }
                @if let Some(level) = &slide.level { " – " (counts(level)) }
                br;
                (slide.caption)
            }
        }
    }
}

fn chip(color: Color) -> Markup {
    let [r, g, b] = color.to_array().map(|c| (255.0 * c).round() as u8);
    html! { span class="chip" style=(format!("background:#{r:02x}{g:02x}{b:02x}")) {} }
}

/// What a level has, in words.
fn counts(level: &LevelFacts) -> String {
    let things = |count: u64, one: &str, many: &str| {
        format!("{count} {}", if count == 1 { one } else { many })
    };
    let inner = (level.inner > 0).then(|| format!("{} parted further", level.inner));
    let leaves = (level.leaves > 0).then(|| things(level.leaves, "leaf", "leaves"));
    inner.into_iter().chain(leaves).collect::<Vec<_>>().join(", ")
}

/// All levels with their numbers.
fn table(slides: &[Slide]) -> Markup {
    let levels: Vec<&LevelFacts> = slides.iter().filter_map(|slide| slide.level.as_ref()).collect();
    html! {
        @for (which, head) in [(Which::Objects, "Over the objects"), (Which::Meshes, "Over the triangles of the meshes")] {
            @let own: Vec<_> = levels.iter().filter(|level| level.which == which).collect();
            @if !own.is_empty() {
                h2 { (head) }
                div class="scroll" tabindex="0" {
                    table {
                        thead {
                            tr {
                                th scope="col" { "Level" }
                                th scope="col" { "Parted further" }
                                th scope="col" { "Leaves" }
                                th scope="col" { "Held by them" }
                                th scope="col" { "A leaf holds" }
                            }
                        }
                        tbody {
                            @for level in own {
                                tr {
                                    td { (chip(level.color)) (level.level) }
                                    td { (level.inner) }
                                    td { (level.leaves) }
                                    td { (level.held) }
                                    td {
                                        @if level.leaves > 0 { (format!("{:.1}", level.held as f64 / level.leaves as f64)) }
                                        @else { "–" }
                                    }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

/// The whole of the structure in numbers.
fn shape(facts: &Facts<'_>) -> Markup {
    let BuildReport { objects, meshes, triangles, .. } = facts.build;
    let kilobytes = |bytes: u64| format!("{} KB", bytes.div_ceil(1000));
    html! {
        h2 { "In all" }
        dl {
            div { dt { "Objects" } dd { (facts.objects) } }
            div { dt { "Triangles in meshes, each mesh once" } dd { (triangles) } }
            @for (shape, over) in [(objects, "over the objects"), (meshes, "over the meshes")] {
                @if shape.nodes + shape.leaves > 0 {
                    div { dt { "Nodes " (over) } dd { (shape.nodes) } }
                    div { dt { "Leaves " (over) } dd { (shape.leaves) } }
                    div { dt { "Deepest leaf " (over) } dd { (shape.depth) } }
                    div { dt { "Index " (over) } dd { (kilobytes(shape.bytes)) } }
                    @if let Some(cost) = shape.sah_cost {
                        div { dt { "Expected tests of a ray " (over) } dd { (format!("{cost:.1}")) } }
                    }
                }
            }
        }
    }
}
