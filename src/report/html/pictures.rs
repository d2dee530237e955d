//! The picture and the heatmaps of a scene, on one scale with a colour bar.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use colorous::INFERNO;
use maud::{Markup, html};

use super::Page;
use crate::record::{HeatScale, PictureFile, SceneRecord, Spacing};
use crate::report::Pictures;
use crate::report::numbers::{self, COUNT};
use crate::report::plot::{Axis, AxisKind, tick_label};

/// Stops of the colour bar's gradient.
const STOPS: u32 = 120;

/// All pictures of a scene side by side, and the colour bar below.
pub(super) fn strip(page: &Page<'_>, scene: &SceneRecord) -> Markup {
    let heatmaps: Vec<_> =
        scene.structures.iter().filter_map(|s| Some((&s.name, s.heatmap.as_ref()?))).collect();
    html! {
        @if scene.picture.is_some() || !heatmaps.is_empty() {
            div class="strip" {
                @if let Some(picture) = &scene.picture {
                    (figure(page.pictures, picture, "the picture", &format!("{}, rendered", scene.name)))
                }
                @for (name, heatmap) in &heatmaps {
                    (figure(page.pictures, heatmap, name, &format!("Tests for each pixel of {} with {name}", scene.name)))
                }
            }
            @if let Some(scale) = scene.heat_scale.filter(|_| !heatmaps.is_empty()) { (bar(scale)) }
        }
    }
}

fn figure(pictures: &Pictures, picture: &PictureFile, caption: &str, meaning: &str) -> Markup {
    html! {
        figure {
            @if let Some(bytes) = pictures.get(&picture.file) {
                img src=(format!("data:image/png;base64,{}", STANDARD.encode(bytes)))
                    width=(picture.width) height=(picture.height) alt=(meaning);
            } @else {
                p class="missing" { "The file " code { (picture.file) } " is missing." }
            }
            figcaption { (caption) }
        }
    }
}

/// The scale of the heatmaps' colours.
fn bar(scale: HeatScale) -> Markup {
    let kind = match scale.spacing {
        Spacing::Linear => AxisKind::Linear,
        Spacing::Logarithmic => AxisKind::Logarithmic,
    };
    let axis = Axis::new(kind, (scale.low, scale.high), (24.0, 876.0));
    let spacing = if kind == AxisKind::Linear { "linear" } else { "logarithmic" };
    let label = format!("box and primitive tests per view sample, {spacing}; one scale for all");
    let ends = (numbers::about(scale.low), numbers::about(scale.high));
    html! {
        div class="scroll" tabindex="0" {
            svg class="bar" role="img" shape-rendering="crispEdges" viewBox="0 0 900 58" width="900" height="58"
                aria-label=(format!("Colour scale from {} to {}: {label}", ends.0, ends.1)) {
                title { (label) }
                @for stop in 0..STOPS {
                    @let width = 852.0 / f64::from(STOPS);
                    @let color = INFERNO.eval_rational(stop as usize, STOPS as usize);
                    rect x=(24.0 + f64::from(stop) * width) y="2" width=(width + 0.5) height="16" fill=(format!("#{color:x}")) {}
                }
                @for tick in axis.ticks() {
                    text class="tick" x=(format!("{:.1}", axis.at(tick))) y="34" text-anchor="middle" { (tick_label(tick, COUNT)) }
                }
                text class="axis" x="450" y="53" text-anchor="middle" { (label) }
            }
        }
    }
}
