//! A dot plot on a logarithmic axis: groups of measurements, each in a row with its interval.

use maud::{Markup, html};

use super::axis::{Axis, tick_label};
use super::{LEAST_AREA, Look, WIDTH, at, figure, marker, text_width};
use crate::record::Estimate;
use crate::report::numbers;

const ROW: f64 = 19.0;
const GROUP_GAP: f64 = 12.0;
const LEFT: f64 = 200.0;
/// From the left: the names of groups.
const GROUP_NAME: f64 = 110.0;
const RIGHT: f64 = 190.0;
const TOP: f64 = 8.0;
const BOTTOM: f64 = 46.0;

/// Measurements under one name.
pub(in crate::report) struct DotGroup {
    /// The name.
    pub(in crate::report) name: String,
    /// The measurements, from the top.
    pub(in crate::report) dots: Vec<Dot>,
}

/// A measurement.
pub(in crate::report) struct Dot {
    /// The look of the structure.
    pub(in crate::report) look: Look,
    /// The name of the structure.
    pub(in crate::report) name: String,
    /// Median and interval.
    pub(in crate::report) value: Estimate,
}

/// Draws groups below each other; empty ones are left out. `line_at` is a value to mark with a line.
pub(in crate::report) fn dot_plot(
    title: &str,
    axis_label: &str,
    unit: &str,
    line_at: Option<f64>,
    groups: &[DotGroup],
) -> Option<Markup> {
    let groups: Vec<&DotGroup> = groups.iter().filter(|group| !group.dots.is_empty()).collect();
    let dots = || groups.iter().flat_map(|group| &group.dots);
    let left = LEFT.max(GROUP_NAME + text_width(dots().map(|dot| dot.name.as_str())));
    let right = (WIDTH - RIGHT).max(left + LEAST_AREA);
    let axis = Axis::around(dots().flat_map(ends).chain(line_at), (left, right))?;
    let rows = dots().count() as f64;
    let bottom = TOP + rows * ROW + groups.len() as f64 * GROUP_GAP;
    let meaning = meaning(&groups, unit);
    let drawing = html! {
        (grid(&axis, (left + right) / 2.0, bottom, axis_label))
        @if let Some(value) = line_at {
            line class="base" x1=(at(axis.at(value))) x2=(at(axis.at(value))) y1=(TOP) y2=(at(bottom)) {}
        }
        @for (group, top) in groups.iter().zip(tops(&groups)) {
            text class="group" x="6" y=(at(top + ROW * 0.72)) { (group.name) }
            @for (dot, row) in group.dots.iter().zip(0u32..) {
                (draw(dot, &axis, (left, right), top + (f64::from(row) + 0.5) * ROW, unit))
            }
        }
    };
    Some(figure(title, &meaning, (right + RIGHT, bottom + BOTTOM), &drawing))
}

/// The top of each group.
fn tops(groups: &[&DotGroup]) -> Vec<f64> {
    let mut top = TOP + GROUP_GAP / 2.0;
    let next = |group: &&DotGroup| {
        let own = top;
        top += group.dots.len() as f64 * ROW + GROUP_GAP;
        own
    };
    groups.iter().map(next).collect()
}

fn grid(axis: &Axis, middle: f64, bottom: f64, label: &str) -> Markup {
    html! {
        @for tick in axis.ticks() {
            @let x = at(axis.at(tick));
            line class="grid" x1=(x) x2=(x) y1=(TOP) y2=(at(bottom)) {}
            text class="tick" x=(x) y=(at(bottom + 17.0)) text-anchor="middle" { (tick_label(tick, &[])) }
        }
        text class="axis" x=(at(middle)) y=(at(bottom + 37.0)) text-anchor="middle" { (label) }
    }
}

fn draw(dot: &Dot, axis: &Axis, (left, right): (f64, f64), y: f64, unit: &str) -> Markup {
    let x = axis.at(dot.value.value);
    let class = format!("line {}", dot.look.color_class());
    html! {
        text class="name" x=(at(left - 12.0)) y=(at(y + 4.0)) text-anchor="end" { (dot.name) }
        @if let Some(interval) = dot.value.interval {
            line class=(class) x1=(at(axis.clamped(interval.low))) x2=(at(axis.clamped(interval.high))) y1=(at(y)) y2=(at(y)) {}
        }
        (marker(dot.look, x, y))
        text class="value" x=(at(right + 10.0)) y=(at(y + 4.0)) { (words(dot.value, unit)) }
    }
}

fn words(value: Estimate, unit: &str) -> String {
    match numbers::spread(value) {
        Some(spread) => format!("{}{unit} ({spread})", numbers::value(value)),
        None => format!("{}{unit}", numbers::value(value)),
    }
}

fn ends(dot: &Dot) -> impl Iterator<Item = f64> {
    let interval = dot.value.interval.map(|interval| [interval.low, interval.high]);
    std::iter::once(dot.value.value).chain(interval.into_iter().flatten())
}

fn meaning(groups: &[&DotGroup], unit: &str) -> String {
    let group = |group: &&DotGroup| {
        let dots: Vec<String> = group
            .dots
            .iter()
            .map(|dot| format!("{} {}{unit}", dot.name, numbers::value(dot.value)))
            .collect();
        format!("{}: {}", group.name, dots.join(", "))
    };
    groups.iter().map(group).collect::<Vec<_>>().join("; ")
}
