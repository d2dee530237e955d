//! Plots as inline SVG, drawn by hand.
//!
//! Colours and dashes are classes of the page's style sheet, so that a plot follows light, dark and print. Every
//! structure has a marker and a written name beside its colour. Plots grow with the number of structures and the length
//! of their names. Crates that plot write fixed colours and measure text with fonts of their own, hence none here.

mod axis;
mod dots;
mod histogram;
mod look;
mod marker;
mod xy;

use maud::{Markup, html};

pub(super) use axis::{Axis, AxisKind, tick_label};
pub(super) use dots::{Dot, DotGroup, dot_plot};
pub(super) use histogram::{Bars, histogram};
pub(super) use look::{Look, Looks};
pub(super) use xy::{Ends, XyPlot, XySeries};

use marker::{marker, marker_with_value};

/// The width of a plot, in units of the drawing: about pixels. Long names make it wider.
const WIDTH: f64 = 900.0;

/// The width of a plot's narrow form, for phones.
const NARROW: f64 = 360.0;

/// The least width of the area between the names and numbers on both sides.
const LEAST_AREA: f64 = 320.0;

/// A plot is drawn twice, and the page's style shows the one that fits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// Names and numbers beside the plot.
    Wide,
    /// Names and numbers above or below it.
    Narrow,
}

/// A drawing of a width and height.
struct Drawing {
    size: (f64, f64),
    content: Markup,
}

/// The width of a character, about: the page's font is not known here.
const CHARACTER: f64 = 7.0;

/// The width of the longest of some texts, about.
fn text_width<'a>(texts: impl IntoIterator<Item = &'a str>) -> f64 {
    let longest = texts.into_iter().map(|text| text.chars().count()).max();
    longest.unwrap_or_default() as f64 * CHARACTER
}

/// A plot in both forms with its heading, and its meaning in words for those who cannot see it.
fn figure(title: &str, meaning: &str, draw: impl Fn(Form) -> Option<Drawing>) -> Option<Markup> {
    let (wide, narrow) = (draw(Form::Wide)?, draw(Form::Narrow)?);
    Some(html! {
        figure class="plot" {
            figcaption { (title) }
            div class="scroll" tabindex="0" {
                (svg("wide", title, meaning, &wide))
                (svg("narrow", title, meaning, &narrow))
            }
        }
    })
}

fn svg(form: &str, title: &str, meaning: &str, drawing: &Drawing) -> Markup {
    let (width, height) = drawing.size;
    html! {
        svg class=(form) xmlns="http://www.w3.org/2000/svg" role="img" aria-label=(format!("{title}. {meaning}"))
            viewBox=(format!("0 0 {} {}", at(width), at(height))) width=(at(width)) height=(at(height)) {
            title { (title) }
            desc { (meaning) }
            (drawing.content)
        }
    }
}

/// A coordinate, in tenths.
fn at(coordinate: f64) -> String {
    format!("{coordinate:.1}")
}
