//! The slides of a structure → one self-contained page of HTML, for a lecture or for paper.
//!
//! It has no font and no external link, and its content security policy forbids loading anything, and running any
//! script but the one of the slider. Without scripts, and on paper, all slides stand in rows.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use sha2::{Digest, Sha256};

use crate::image_io::{EncodeError, Format, encode};
use crate::math::Color;
use crate::scene::BuildReport;

use super::slides::{LevelFacts, Slide, Which};

const STYLE: &str = include_str!("style.css");
const SCRIPT: &str = include_str!("slider.js");

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
    let pictures: Vec<String> = slides
        .iter()
        .map(|slide| encode(&slide.picture, Format::Png).map(|bytes| STANDARD.encode(bytes)))
        .collect::<Result<_, _>>()?;
    Ok(document(facts, slides, &pictures).into_string())
}

/// What the page may load: nothing; and run: the script whose hash this is.
fn policy() -> String {
    let hash = STANDARD.encode(Sha256::digest(SCRIPT));
    format!(
        "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-{hash}'"
    )
}

fn document(facts: &Facts<'_>, slides: &[Slide], pictures: &[String]) -> Markup {
    let title = format!("{} over {}", facts.structure, facts.scene);
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta http-equiv="Content-Security-Policy" content=(policy());
                meta name="generator" content=(format!("srt {}", env!("CARGO_PKG_VERSION")));
                link rel="icon" href="data:,";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                header {
                    h1 { code { (facts.structure) } " over " (facts.scene) }
                    p class="quiet" { (facts.summary) }
                }
                main {
                    // Shown by the script.
                    div class="controls" hidden {
                        button type="button" data-step="-1" aria-label="the slide before" { "←" }
                        input type="range" min="0" max=(slides.len().saturating_sub(1)) value="0" aria-label="slide";
                        button type="button" data-step="1" aria-label="the next slide" { "→" }
                        button type="button" data-all="" aria-pressed="false" { "All" }
                    }
                    div class="slides" {
                        @for (slide, picture) in slides.iter().zip(pictures) { (figure(slide, picture)) }
                    }
                    (table(slides))
                    (shape(facts))
                }
                footer class="quiet" {
                    "Lines are the edges of the parts of space that rays are tested against; they are faint where a "
                    "surface is before them. Made by srt " (env!("CARGO_PKG_VERSION")) "."
                }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    }
}

fn figure(slide: &Slide, picture: &str) -> Markup {
    html! {
        figure {
            img src=(format!("data:image/png;base64,{picture}")) width=(slide.picture.width)
                height=(slide.picture.height) alt=(format!("{}: {}", slide.title, slide.caption));
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
