//! Lanes: a row for each scene, in which every structure has a marker on one logarithmic axis.

use maud::{Markup, html};

use super::axis::{Axis, tick_label};
use super::{
    Drawing, Form, LEAST_AREA, Look, NARROW, Plot, WIDTH, at, marker, marker_with_value, text_width,
};
use crate::report::numbers::{self, Unit};

const ROW: f64 = 30.0;
const LEFT: f64 = 120.0;
const RIGHT: f64 = 20.0;
const TOP: f64 = 8.0;
const BOTTOM: f64 = 46.0;
/// The height of a name above its row in the narrow form.
const HEAD: f64 = 18.0;
/// The height of a line of the key.
const KEY: f64 = 18.0;
/// Neighbours in the key stand at heights so far apart in a row, so that equal values do not hide each other.
const APART: f64 = 6.0;

/// A scene.
pub(in crate::report) struct Lane {
    /// Its name.
    pub(in crate::report) name: String,
    /// The structures, by their places in the key, and their values.
    pub(in crate::report) values: Vec<(usize, f64)>,
}

/// Lanes on one axis.
pub(in crate::report) struct LanePlot {
    /// The heading.
    pub(in crate::report) title: String,
    /// The text at the axis.
    pub(in crate::report) label: String,
    /// Units of the numbers at the axis; empty for plain numbers.
    pub(in crate::report) units: &'static [Unit],
    /// A value to mark with a line.
    pub(in crate::report) line_at: Option<f64>,
    /// All structures.
    pub(in crate::report) key: Vec<(Look, String)>,
    /// The rows, from the top.
    pub(in crate::report) lanes: Vec<Lane>,
}

impl LanePlot {
    /// Draws it; `None` without a positive value.
    pub(in crate::report) fn draw(&self) -> Option<Plot> {
        Plot::of(&self.title, &self.meaning(), |form| self.draw_in(form))
    }

    fn draw_in(&self, form: Form) -> Option<Drawing> {
        let names = text_width(self.lanes.iter().map(|lane| lane.name.as_str()));
        let (left, right, head) = match form {
            Form::Wide => {
                let left = LEFT.max(names + 20.0);
                (left, (WIDTH - RIGHT).max(left + LEAST_AREA), 0.0)
            }
            Form::Narrow => (12.0, NARROW - 12.0, HEAD),
        };
        let values = self.lanes.iter().flat_map(|lane| lane.values.iter().map(|value| value.1));
        let axis = Axis::around(values.chain(self.line_at), (left, right))?;
        let step = ROW + head;
        let bottom = TOP + self.lanes.len() as f64 * step;
        let (key, lines) = self.key(left, right, bottom + BOTTOM + KEY / 2.0);
        let content = html! {
            @for tick in axis.ticks() {
                @let x = at(axis.at(tick));
                line class="grid" x1=(x) x2=(x) y1=(TOP) y2=(at(bottom)) {}
                text class="tick" x=(x) y=(at(bottom + 17.0)) text-anchor="middle" { (tick_label(tick, self.units)) }
            }
            text class="axis" x=(at((left + right) / 2.0)) y=(at(bottom + 37.0)) text-anchor="middle" { (self.label) }
            @if let Some(value) = self.line_at {
                line class="base" x1=(at(axis.at(value))) x2=(at(axis.at(value))) y1=(TOP) y2=(at(bottom)) {}
            }
            @for (lane, place) in self.lanes.iter().zip(0u32..) {
                @let top = TOP + f64::from(place) * step;
                @let middle = top + head + ROW / 2.0;
                line class="grid" x1=(at(left)) x2=(at(right)) y1=(at(middle)) y2=(at(middle)) {}
                @match form {
                    Form::Wide => { text class="name" x=(at(left - 12.0)) y=(at(middle + 4.0)) text-anchor="end" { (lane.name) } }
                    Form::Narrow => { text class="name" x=(at(left)) y=(at(top + HEAD - 4.0)) { (lane.name) } }
                }
                @for &(structure, value) in &lane.values {
                    @let (look, name) = &self.key[structure];
                    @let y = middle + [-1.0, 0.0, 1.0][structure % 3] * APART;
                    (marker_with_value(*look, axis.at(value), y, &format!("{}, {name}: {}", lane.name, self.words(value))))
                }
            }
            (key)
        };
        let width = if form == Form::Wide { right + RIGHT } else { NARROW };
        Some(Drawing { size: (width, bottom + BOTTOM + lines * KEY), content })
    }

    /// The names of the structures beside their markers, and how many lines they take.
    fn key(&self, left: f64, right: f64, top: f64) -> (Markup, f64) {
        const BEFORE: f64 = 16.0;
        const BEHIND: f64 = 16.0;
        let (mut x, mut line) = (left, 0u32);
        let mut places = Vec::new();
        for (_, name) in &self.key {
            let width = BEFORE + text_width([name.as_str()]) + BEHIND;
            if x > left && x + width > right {
                (x, line) = (left, line + 1);
            }
            places.push((x, top + f64::from(line) * KEY));
            x += width;
        }
        let markup = html! {
            @for ((look, name), (x, y)) in self.key.iter().zip(places) {
                (marker(*look, x + 5.0, y))
                text class="name" x=(at(x + BEFORE)) y=(at(y + 4.0)) { (name) }
            }
        };
        (markup, f64::from(line + 1))
    }

    fn words(&self, value: f64) -> String {
        numbers::in_units(value, self.units)
    }

    fn meaning(&self) -> String {
        let of_lane = |lane: &Lane| {
            let value = |&(structure, value): &(usize, f64)| {
                format!("{} {}", self.key[structure].1, self.words(value))
            };
            let values: Vec<String> = lane.values.iter().map(value).collect();
            format!("{}: {}", lane.name, values.join(", "))
        };
        self.lanes.iter().map(of_lane).collect::<Vec<_>>().join("; ")
    }
}
