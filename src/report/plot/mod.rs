//! Plots as SVG, drawn by hand: within a page, or files by themselves.
//!
//! Colours and dashes are classes of a style sheet, so that a plot follows light, dark and print. Every
//! structure has a marker and a written name beside its colour. Plots grow with the number of structures and the length
//! of their names. Crates that plot write fixed colours and measure text with fonts of their own, hence none here.

mod axis;
mod dots;
mod histogram;
mod lanes;
mod look;
mod marker;
mod xy;

use maud::{Markup, PreEscaped, Render, html};

pub(super) use axis::{Axis, AxisKind, tick_label};
pub(super) use dots::{Dot, DotGroup, dot_plot};
pub(super) use histogram::{Bars, histogram};
pub(super) use lanes::{Lane, LanePlot};
pub(super) use look::{Look, Looks};
pub(super) use xy::{Ends, XyPlot, XySeries};

use marker::{marker, marker_with_value};

/// The width of a plot, in units of the drawing: about pixels. Long names make it wider.
const WIDTH: f64 = 900.0;

/// The width of a plot's narrow form, for phones.
const NARROW: f64 = 360.0;

/// The least width of the area between the names and numbers on both sides.
const LEAST_AREA: f64 = 320.0;

/// A plot is drawn twice, and the page's style shows the form that fits.
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

/// The style that plots need, and the colours of the page around them.
pub(super) const STYLE: &str = include_str!("style.css");

/// A plot in both forms with its heading, and its meaning in words for those who cannot see it.
pub(super) struct Plot {
    title: String,
    meaning: String,
    wide: Drawing,
    narrow: Drawing,
}

impl Plot {
    /// Draws both forms; `None` if there is nothing to draw.
    fn of(title: &str, meaning: &str, draw: impl Fn(Form) -> Option<Drawing>) -> Option<Self> {
        let (wide, narrow) = (draw(Form::Wide)?, draw(Form::Narrow)?);
        Some(Self { title: title.to_owned(), meaning: meaning.to_owned(), wide, narrow })
    }

    /// A file by itself, with its heading and its style in it.
    pub(super) fn file(&self) -> String {
        /// The height of the heading.
        const HEAD: f64 = 34.0;
        let (width, height) = self.wide.size;
        let (width, height) = (at(width), at(height + HEAD));
        let drawing = html! {
            svg xmlns="http://www.w3.org/2000/svg" viewBox=(format!("0 0 {width} {height}")) width=(width) height=(height) {
                title { (self.title) }
                desc { (self.meaning) }
                style { (PreEscaped(STYLE)) }
                rect class="page" width="100%" height="100%" {}
                text class="title" x="12" y="23" { (self.title) }
                g transform=(format!("translate(0 {HEAD})")) { (self.wide.content) }
            }
        };
        format!("{}\n", drawing.into_string())
    }

    /// A form of it within a page.
    fn svg(&self, form: &str, drawing: &Drawing) -> Markup {
        let (title, meaning) = (&self.title, &self.meaning);
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
}

/// A part of a page whose style has [`STYLE`].
impl Render for Plot {
    fn render(&self) -> Markup {
        html! {
            figure class="plot" {
                figcaption { (self.title) }
                div class="scroll" tabindex="0" {
                    (self.svg("wide", &self.wide))
                    (self.svg("narrow", &self.narrow))
                }
            }
        }
    }
}

/// A coordinate, in tenths.
fn at(coordinate: f64) -> String {
    format!("{coordinate:.1}")
}
