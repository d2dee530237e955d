//! Points and lines on two axes, with the name of each series beside its end.

use maud::{Markup, html};

use super::axis::{Axis, AxisKind, tick_label};
use super::{
    Drawing, Form, LEAST_AREA, Look, NARROW, Plot, WIDTH, at, marker, marker_with_value, text_width,
};
use crate::report::numbers::{self, Unit};

const LEFT: f64 = 76.0;
const RIGHT: f64 = 210.0;
const TOP: f64 = 10.0;
const HEIGHT: f64 = 360.0;
const BOTTOM: f64 = 50.0;
/// The least distance of names below each other.
const NAME: f64 = 17.0;
/// In the narrow form.
const NARROW_LEFT: f64 = 66.0;
const NARROW_HEIGHT: f64 = 260.0;
/// From the right end of the x axis to the names.
const NAME_LEFT: f64 = 30.0;

/// The text at an axis.
pub(in crate::report) struct Ends {
    /// The quantity, with its unit.
    pub(in crate::report) label: &'static str,
    /// Units of the numbers at it; empty for plain numbers.
    pub(in crate::report) units: &'static [Unit],
    /// How it is divided.
    pub(in crate::report) kind: AxisKind,
}

impl Ends {
    /// Of an axis of equal factors.
    pub(in crate::report) fn logarithmic(label: &'static str, units: &'static [Unit]) -> Self {
        Self { label, units, kind: AxisKind::Logarithmic }
    }

    /// An axis over some numbers.
    fn around(&self, values: impl Iterator<Item = f64>, places: (f64, f64)) -> Option<Axis> {
        match self.kind {
            AxisKind::Logarithmic => Axis::around(values, places),
            AxisKind::Linear => {
                let finite = values.filter(|value| value.is_finite());
                let range = finite.fold(None, |range: Option<(f64, f64)>, value| {
                    Some(range.map_or((value, value), |(a, b)| (a.min(value), b.max(value))))
                })?;
                Some(Axis::new(AxisKind::Linear, range, places))
            }
        }
    }
}

/// A structure's points and line.
pub(in crate::report) struct XySeries {
    /// The look of the structure.
    pub(in crate::report) look: Look,
    /// The name beside it.
    pub(in crate::report) name: String,
    /// The points, drawn as markers.
    pub(in crate::report) points: Vec<(f64, f64)>,
    /// The interval of y at each point, where there is one.
    pub(in crate::report) intervals: Vec<Option<(f64, f64)>>,
    /// The corners of a line.
    pub(in crate::report) line: Vec<(f64, f64)>,
    /// Whether the line is a fit, which is always dashed, or joins measurements.
    pub(in crate::report) fit: bool,
}

/// A plot on two axes.
pub(in crate::report) struct XyPlot {
    /// The heading.
    pub(in crate::report) title: String,
    /// What it shows, for those who cannot see it.
    pub(in crate::report) meaning: String,
    /// The axis to the right.
    pub(in crate::report) x: Ends,
    /// The axis upwards.
    pub(in crate::report) y: Ends,
    /// The series.
    pub(in crate::report) series: Vec<XySeries>,
    /// The corners of a line that belongs to no series, such as a Pareto front.
    pub(in crate::report) path: Vec<(f64, f64)>,
    /// Places with a ring around them.
    pub(in crate::report) rings: Vec<(f64, f64)>,
    /// What a ring means.
    pub(in crate::report) ring_meaning: &'static str,
}

impl XyPlot {
    /// Draws it; `None` if there is nothing that its axes can show.
    pub(in crate::report) fn draw(&self) -> Option<Plot> {
        Plot::of(&self.title, &self.meaning, |form| self.draw_in(form))
    }

    fn draw_in(&self, form: Form) -> Option<Drawing> {
        let all = || self.series.iter().flat_map(|s| s.points.iter().chain(&s.line));
        let names = RIGHT.max(NAME_LEFT + text_width(self.series.iter().map(|s| s.name.as_str())));
        let (left, right, height) = match form {
            Form::Wide => {
                let right = (WIDTH - names).max(LEFT + LEAST_AREA);
                (LEFT, right, HEIGHT.max(self.series.len() as f64 * NAME))
            }
            Form::Narrow => (NARROW_LEFT, NARROW - 8.0, NARROW_HEIGHT),
        };
        let bottom = TOP + height;
        let x = self.x.around(all().map(|p| p.0), (left, right))?;
        let intervals = self.series.iter().flat_map(|s| s.intervals.iter().flatten());
        let heights = all().map(|p| p.1).chain(intervals.flat_map(|i| [i.0, i.1]));
        let y = self.y.around(heights, (bottom, TOP))?;
        // The key of the rings is below the axis, in the narrow form above the names.
        let key = if self.rings.is_empty() { 0.0 } else { NAME };
        let below = bottom + BOTTOM + key;
        let (size, key_at) = match form {
            Form::Wide => ((right + names, below), (left + 12.0, bottom + BOTTOM + 4.0)),
            Form::Narrow => {
                let names = self.series.len() as f64 * NAME;
                ((NARROW, below + names), (NARROW_LEFT, bottom + BOTTOM + 4.0))
            }
        };
        let content = html! {
            (self.grid(&x, &y, (left, right), bottom))
            @if self.path.len() > 1 { polyline class="front" points=(corners(&self.path, &x, &y)) {} }
            @for series in &self.series { (self.draw_series(series, &x, &y)) }
            @for ring in &self.rings {
                circle class="ring" cx=(at(x.at(ring.0))) cy=(at(y.at(ring.1))) r="9" {}
            }
            @if !self.rings.is_empty() { (self.ring_key(key_at)) }
            @match form {
                Form::Wide => { (name_column(&self.series, &y, (right, bottom))) }
                Form::Narrow => { (name_list(&self.series, below)) }
            }
        };
        Some(Drawing { size, content })
    }

    /// What a ring means.
    fn ring_key(&self, (left, y): (f64, f64)) -> Markup {
        html! {
            circle class="ring" cx=(at(left)) cy=(at(y)) r="6" {}
            text class="axis" x=(at(left + 14.0)) y=(at(y + 4.0)) { (self.ring_meaning) }
        }
    }

    fn grid(&self, x: &Axis, y: &Axis, (left, right): (f64, f64), bottom: f64) -> Markup {
        html! {
            @for tick in x.ticks() {
                @let place = at(x.at(tick));
                line class="grid" x1=(place) x2=(place) y1=(TOP) y2=(at(bottom)) {}
                text class="tick" x=(place) y=(at(bottom + 18.0)) text-anchor="middle" { (tick_label(tick, self.x.units)) }
            }
            @for tick in y.ticks() {
                @let place = y.at(tick);
                line class="grid" x1=(at(left)) x2=(at(right)) y1=(at(place)) y2=(at(place)) {}
                text class="tick" x=(at(left - 8.0)) y=(at(place + 4.0)) text-anchor="end" { (tick_label(tick, self.y.units)) }
            }
            text class="axis" x=(at((left + right) / 2.0)) y=(at(bottom + 40.0)) text-anchor="middle" { (self.x.label) }
            text class="axis" transform=(format!("translate(14 {}) rotate(-90)", at((TOP + bottom) / 2.0))) text-anchor="middle" { (self.y.label) }
        }
    }

    /// A point's series and coordinates.
    fn words(&self, series: &XySeries, point: (f64, f64)) -> String {
        let x = numbers::in_units(point.0, self.x.units);
        let y = numbers::in_units(point.1, self.y.units);
        format!("{}: {x}, {y}", series.name)
    }

    fn draw_series(&self, series: &XySeries, x: &Axis, y: &Axis) -> Markup {
        let fit = if series.fit { " fit" } else { "" };
        let line = format!("line {}{fit}", series.look.line_classes());
        let interval_line = format!("line {}", series.look.color_class());
        html! {
            @if series.line.len() > 1 {
                polyline class=(line) points=(corners(&series.line, x, y)) {}
            }
            @for (point, interval) in series.points.iter().zip(&series.intervals) {
                @let place = at(x.at(point.0));
                @if let Some((low, high)) = interval {
                    line class=(interval_line) x1=(place) x2=(place) y1=(at(y.at(*low))) y2=(at(y.at(*high))) {}
                }
            }
            @for point in &series.points {
                (marker_with_value(series.look, x.at(point.0), y.at(point.1), &self.words(series, *point)))
            }
        }
    }
}

/// Names below the plot, in their order.
fn name_list(series: &[XySeries], top: f64) -> Markup {
    html! {
        @for (series, line) in series.iter().zip(0u32..) {
            @let y = top + (f64::from(line) + 0.3) * NAME;
            (marker(series.look, NARROW_LEFT, y))
            text class="name" x=(at(NARROW_LEFT + 14.0)) y=(at(y + 4.0)) { (series.name) }
        }
    }
}

/// Names right of the plot, at the height of each series' end, moved apart where they are close.
fn name_column(series: &[XySeries], y: &Axis, (right, bottom): (f64, f64)) -> Markup {
    let end = |s: &XySeries| s.points.last().or(s.line.last()).map(|p| y.at(p.1));
    let mut named: Vec<(f64, &XySeries)> =
        series.iter().filter_map(|s| Some((end(s)?, s))).collect();
    named.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut floor = TOP + 6.0;
    for (place, _) in &mut named {
        *place = place.max(floor);
        floor = *place + NAME;
    }
    // What was pushed below the plot comes back up, and pushes those above it.
    let mut ceiling = bottom;
    for (place, _) in named.iter_mut().rev() {
        *place = place.min(ceiling);
        ceiling = *place - NAME;
    }
    let left = right + 18.0;
    html! {
        @for (place, series) in named {
            (marker(series.look, left, place))
            text class="name" x=(at(right + NAME_LEFT)) y=(at(place + 4.0)) { (series.name) }
        }
    }
}

fn corners(line: &[(f64, f64)], x: &Axis, y: &Axis) -> String {
    let corner = |p: &(f64, f64)| format!("{},{}", at(x.clamped(p.0)), at(y.clamped(p.1)));
    line.iter().map(corner).collect::<Vec<_>>().join(" ")
}
