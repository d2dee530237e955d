//! Plots as inline SVG, drawn by hand.
//!
//! Colours are classes that the page's style sheet fills in, so that a plot follows light, dark and
//! print; every structure has a marker and a written name beside its colour. Text stays text.
//! Crates that plot write fixed colours and measure text with fonts of their own, hence none here.

mod axis;
mod dots;
mod histogram;
mod marker;
mod xy;

use maud::{Markup, html};

pub(super) use axis::{Axis, AxisKind, tick_label};
pub(super) use dots::{Dot, Group, dot_plot};
pub(super) use histogram::{Bars, histogram};
pub(super) use marker::marker;
pub(super) use xy::{Ends, XyPlot, XySeries};

/// The width of all plots, in units of the drawing: about pixels.
const WIDTH: f64 = 900.0;

/// A drawing with its heading, and its meaning in words for those who cannot see it.
fn figure(title: &str, meaning: &str, height: f64, drawing: &Markup) -> Markup {
    html! {
        figure class="plot" {
            figcaption { (title) }
            div class="scroll" tabindex="0" {
                svg xmlns="http://www.w3.org/2000/svg" role="img" aria-label=(format!("{title}. {meaning}"))
                    viewBox=(format!("0 0 {WIDTH} {height}")) width=(WIDTH) height=(height) {
                    title { (title) }
                    desc { (meaning) }
                    (drawing)
                }
            }
        }
    }
}

/// A coordinate, in tenths.
fn at(coordinate: f64) -> String {
    format!("{coordinate:.1}")
}

/// The class that gives the colour of a series.
fn color(series: usize) -> String {
    format!("s{}", series % 7)
}
