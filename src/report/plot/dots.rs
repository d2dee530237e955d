//! A dot plot on a logarithmic axis: groups of measurements, each in a row with its interval.

use maud::{Markup, html};

use super::axis::{Axis, tick_label};
use super::{
    Drawing, Form, LEAST_AREA, Look, NARROW, Plot, WIDTH, at, marker_with_value, text_width,
};
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
/// The height of a second line of the label.
const LABEL: f64 = 17.0;

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
) -> Option<Plot> {
    let groups: Vec<&DotGroup> = groups.iter().filter(|group| !group.dots.is_empty()).collect();
    Plot::of(title, &meaning(&groups, unit), |form| {
        let dots = || groups.iter().flat_map(|group| &group.dots);
        let layout = Layout::of(form, dots().map(|dot| dot.name.as_str()));
        let axis = Axis::around(dots().flat_map(ends).chain(line_at), layout.area)?;
        let bottom = TOP + groups.iter().map(|group| layout.height(group)).sum::<f64>();
        let content = html! {
            (layout.grid(&axis, bottom, axis_label))
            @if let Some(value) = line_at {
                line class="base" x1=(at(axis.at(value))) x2=(at(axis.at(value))) y1=(TOP) y2=(at(bottom)) {}
            }
            @for (group, top) in groups.iter().zip(layout.tops(&groups)) {
                text class="group" x="6" y=(at(top + ROW * 0.72)) { (group.name) }
                @for (dot, row) in group.dots.iter().zip(0u32..) {
                    (layout.draw(dot, &axis, layout.first_row(top) + (f64::from(row) + 0.5) * layout.row, unit))
                }
            }
        };
        Some(Drawing { size: (layout.width, bottom + layout.below()), content })
    })
}

/// Where things stand in a form of the plot.
struct Layout {
    form: Form,
    width: f64,
    /// The ends of the axis.
    area: (f64, f64),
    /// The height of a measurement.
    row: f64,
}

impl Layout {
    fn of<'a>(form: Form, names: impl Iterator<Item = &'a str>) -> Self {
        match form {
            Form::Wide => {
                let left = LEFT.max(GROUP_NAME + text_width(names));
                let right = (WIDTH - RIGHT).max(left + LEAST_AREA);
                Self { form, width: right + RIGHT, area: (left, right), row: ROW }
            }
            // The name and the number stand above the interval.
            Form::Narrow => {
                Self { form, width: NARROW, area: (12.0, NARROW - 12.0), row: 2.0 * ROW }
            }
        }
    }

    /// The height of what is below the axis.
    fn below(&self) -> f64 {
        BOTTOM + if self.form == Form::Narrow { LABEL } else { 0.0 }
    }

    fn grid(&self, axis: &Axis, bottom: f64, label: &str) -> Markup {
        let middle = (self.area.0 + self.area.1) / 2.0;
        // A long label takes two lines where there is no room for one.
        let (label, rest) = match label.split_once(", with") {
            Some((label, rest)) if self.form == Form::Narrow => {
                (label, Some(format!("with{rest}")))
            }
            _ => (label, None),
        };
        html! {
            @for tick in axis.ticks() {
                @let x = at(axis.at(tick));
                line class="grid" x1=(x) x2=(x) y1=(TOP) y2=(at(bottom)) {}
                text class="tick" x=(x) y=(at(bottom + 17.0)) text-anchor="middle" { (tick_label(tick, &[])) }
            }
            text class="axis" x=(at(middle)) y=(at(bottom + 37.0)) text-anchor="middle" { (label) }
            @if let Some(rest) = rest {
                text class="axis" x=(at(middle)) y=(at(bottom + 37.0 + LABEL)) text-anchor="middle" { (rest) }
            }
        }
    }

    /// The height of a group, with what is left free around it.
    fn height(&self, group: &DotGroup) -> f64 {
        group.dots.len() as f64 * self.row + GROUP_GAP + self.first_row(0.0)
    }

    /// The top of a group's first row: in the narrow form its name has a line of its own.
    fn first_row(&self, top: f64) -> f64 {
        if self.form == Form::Narrow { top + ROW } else { top }
    }

    /// The top of each group.
    fn tops(&self, groups: &[&DotGroup]) -> Vec<f64> {
        let mut top = TOP + GROUP_GAP / 2.0;
        let next = |group: &&DotGroup| {
            let own = top;
            top += self.height(group);
            own
        };
        groups.iter().map(next).collect()
    }

    /// A measurement about a height.
    fn draw(&self, dot: &Dot, axis: &Axis, y: f64, unit: &str) -> Markup {
        let (left, right) = self.area;
        let value = words(dot.value, unit);
        let told = format!("{}: {value}", dot.name);
        match self.form {
            Form::Wide => html! {
                text class="name" x=(at(left - 12.0)) y=(at(y + 4.0)) text-anchor="end" { (dot.name) }
                (interval(dot, axis, y))
                (marker_with_value(dot.look, axis.at(dot.value.value), y, &told))
                text class="value" x=(at(right + 10.0)) y=(at(y + 4.0)) { (value) }
            },
            Form::Narrow => html! {
                text class="name" x=(at(left)) y=(at(y - ROW / 4.0)) { (dot.name) }
                text class="value" x=(at(right)) y=(at(y - ROW / 4.0)) text-anchor="end" { (value) }
                (interval(dot, axis, y + ROW / 2.0))
                (marker_with_value(dot.look, axis.at(dot.value.value), y + ROW / 2.0, &told))
            },
        }
    }
}

fn interval(dot: &Dot, axis: &Axis, y: f64) -> Markup {
    let class = format!("line {}", dot.look.color_class());
    html! {
        @if let Some(interval) = dot.value.interval {
            line class=(class) x1=(at(axis.clamped(interval.low))) x2=(at(axis.clamped(interval.high))) y1=(at(y)) y2=(at(y)) {}
        }
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
