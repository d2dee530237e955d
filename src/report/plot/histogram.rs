//! Histograms of several structures, below each other on one axis.

use maud::{Markup, html};

use super::axis::{Axis, AxisKind};
use super::{Drawing, Form, LEAST_AREA, Look, NARROW, Plot, WIDTH, at, marker, text_width};

const LEFT: f64 = 120.0;
const RIGHT: f64 = 20.0;
/// The height of a name in the narrow form.
const HEAD: f64 = 20.0;
/// Bars that are narrower have no number on them.
const LEAST_LABELLED: f64 = 24.0;
/// From the left: where a name begins, right of its marker.
const NAME: f64 = 24.0;
const TOP: f64 = 8.0;
const PANEL: f64 = 84.0;
const GAP: f64 = 18.0;
const BOTTOM: f64 = 46.0;
/// The largest size with a bar of its own; larger ones share the last bar.
const SIZES: usize = 16;

/// The histogram of a structure.
pub(in crate::report) struct Bars {
    /// The look of the structure.
    pub(in crate::report) look: Look,
    /// The name of the structure.
    pub(in crate::report) name: String,
    /// Entry n: how many leaves have n primitives.
    pub(in crate::report) counts: Vec<u64>,
}

/// Draws shares of leaves by size; `None` without any leaf.
pub(in crate::report) fn histogram(title: &str, all: &[Bars]) -> Option<Plot> {
    let all: Vec<&Bars> = all.iter().filter(|bars| bars.counts.iter().any(|&n| n > 0)).collect();
    let longest = all.iter().map(|bars| bars.counts.len()).max()?;
    let columns = longest.min(SIZES + 2);
    let shares: Vec<Vec<f64>> = all.iter().map(|bars| shares(&bars.counts)).collect();
    let largest = shares.iter().flatten().copied().fold(0.0, f64::max);
    Plot::of(title, &meaning(&all, &shares), |form| {
        let names = text_width(all.iter().map(|bars| bars.name.as_str()));
        let (left, right, head) = match form {
            Form::Wide => {
                let left = LEFT.max(NAME + 12.0 + names);
                (left, (WIDTH - RIGHT).max(left + LEAST_AREA), 0.0)
            }
            // The name stands above.
            Form::Narrow => (8.0, NARROW - 8.0, HEAD),
        };
        let x = Axis::new(AxisKind::Linear, (0.0, columns as f64), (left, right));
        let step = PANEL + GAP + head;
        let bottom = TOP + all.len() as f64 * step - GAP;
        let content = html! {
            @for ((bars, shares), panel) in all.iter().zip(&shares).zip(0u32..) {
                @let top = TOP + f64::from(panel) * step;
                @let name = if form == Form::Wide { top + PANEL / 2.0 } else { top + HEAD / 2.0 };
                (marker(bars.look, 12.0, name))
                text class="name" x=(NAME) y=(at(name + 4.0)) { (bars.name) }
                (draw(bars, shares, largest, &x, (left, right), top + head))
            }
            @for column in 0..columns {
                text class="tick" x=(at(x.at(column as f64 + 0.5))) y=(at(bottom + 16.0)) text-anchor="middle" { (size_name(column)) }
            }
            text class="axis" x=(at((left + right) / 2.0)) y=(at(bottom + 37.0)) text-anchor="middle" { "primitives in a leaf" }
        };
        Some(Drawing { size: (right + RIGHT.min(left), bottom + BOTTOM), content })
    })
}

fn draw(
    bars: &Bars,
    shares: &[f64],
    largest: f64,
    x: &Axis,
    (left, right): (f64, f64),
    top: f64,
) -> Markup {
    let y = Axis::new(AxisKind::Linear, (0.0, largest * 1.25), (top + PANEL, top));
    let class = format!("bar {}", bars.look.color_class());
    html! {
        line class="grid" x1=(at(left)) x2=(at(right)) y1=(at(top + PANEL)) y2=(at(top + PANEL)) {}
        @for (column, &share) in shares.iter().enumerate() {
            @if share > 0.0 {
                @let start = x.at(column as f64 + 0.12);
                @let height = (top + PANEL - y.at(share)).max(0.6);
                @let width = x.at(column as f64 + 0.88) - start;
                g {
                    title { (bars.name) ", " (size_name(column)) ": " (percent(share)) }
                    rect class=(class) x=(at(start)) y=(at(top + PANEL - height)) width=(at(width)) height=(at(height)) {}
                }
                @if width >= LEAST_LABELLED { text class="tick" x=(at(x.at(column as f64 + 0.5))) y=(at(top + PANEL - height - 4.0)) text-anchor="middle" { (percent(share)) } }
            }
        }
    }
}

/// Shares of the leaves by size; those of many primitives together.
fn shares(counts: &[u64]) -> Vec<f64> {
    let total: f64 = counts.iter().map(|&n| n as f64).sum();
    let mut shares = vec![0.0; counts.len().min(SIZES + 2)];
    for (size, &n) in counts.iter().enumerate() {
        shares[size.min(SIZES + 1)] += n as f64 / total;
    }
    shares
}

fn size_name(column: usize) -> String {
    if column > SIZES { format!("> {SIZES}") } else { column.to_string() }
}

fn percent(share: f64) -> String {
    if share < 0.005 { "< 1\u{a0}%".to_owned() } else { format!("{:.0}\u{a0}%", share * 100.0) }
}

fn meaning(all: &[&Bars], shares: &[Vec<f64>]) -> String {
    let of = |(bars, shares): (&&Bars, &Vec<f64>)| {
        let sizes: Vec<String> = shares
            .iter()
            .enumerate()
            .filter(|(_, share)| **share > 0.0)
            .map(|(size, &share)| format!("{}: {}", size_name(size), percent(share)))
            .collect();
        format!("{}, leaves of {}", bars.name, sizes.join(", "))
    };
    all.iter().zip(shares).map(of).collect::<Vec<_>>().join("; ")
}
