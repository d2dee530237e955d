//! The picture and the heatmaps of a scene, on one scale with a colour bar.

use colorous::INFERNO;
use maud::{Markup, html};

use super::Page;
use crate::page;
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
                (page::picture(bytes, [picture.width, picture.height], meaning))
            } @else {
                p class="missing" { "The file " code { (picture.file) } " is missing." }
            }
            figcaption { (caption) }
        }
    }
}

/// The scale of the heatmaps' colours, for wide pages and for phones.
fn bar(scale: HeatScale) -> Markup {
    let spacing = match scale.spacing {
        Spacing::Linear => "linear",
        Spacing::Logarithmic => "logarithmic",
    };
    let label = format!("box and primitive tests per view sample, {spacing}; one scale for all");
    html! {
        figure class="bar" {
            (drawn_bar(scale, &label, "wide", 900.0))
            (drawn_bar(scale, &label, "narrow", 400.0))
            figcaption { (label) }
        }
    }
}

/// The colours with their ticks, so many units wide.
fn drawn_bar(scale: HeatScale, label: &str, form: &str, width: f64) -> Markup {
    let kind = match scale.spacing {
        Spacing::Linear => AxisKind::Linear,
        Spacing::Logarithmic => AxisKind::Logarithmic,
    };
    let (first, last) = (24.0, width - 24.0);
    let axis = Axis::new(kind, (scale.low, scale.high), (first, last));
    let step = (last - first) / f64::from(STOPS);
    let ends = (numbers::about(scale.low), numbers::about(scale.high));
    html! {
        svg class=(format!("{form} bar")) role="img" shape-rendering="crispEdges"
            viewBox=(format!("0 0 {width} 38")) width=(width) height="38"
            aria-label=(format!("Colour scale from {} to {}: {label}", ends.0, ends.1)) {
            title { (label) }
            @for stop in 0..STOPS {
                @let color = INFERNO.eval_rational(stop as usize, STOPS as usize);
                rect x=(format!("{:.2}", first + f64::from(stop) * step)) y="2" width=(format!("{:.2}", step + 0.5))
                    height="16" fill=(format!("#{color:x}")) {}
            }
            @for tick in axis.ticks() {
                text class="tick" x=(format!("{:.1}", axis.at(tick))) y="34" text-anchor="middle" { (tick_label(tick, COUNT)) }
            }
        }
    }
}
