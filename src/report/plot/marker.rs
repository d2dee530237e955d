//! Markers: a shape for each structure, so that colour is never the only difference.

use maud::{Markup, html};

use super::{at, color};

const R: f64 = 4.6;

/// The marker of a series at a place.
pub(in crate::report) fn marker(series: usize, x: f64, y: f64) -> Markup {
    let class = format!("mark {}", color(series));
    let path = |points: &[(f64, f64)]| {
        let points: Vec<String> = points
            .iter()
            .map(|(dx, dy)| format!("{},{}", at(x + dx * R), at(y + dy * R)))
            .collect();
        html! { polygon class=(class) points=(points.join(" ")) {} }
    };
    match series % 7 {
        0 => html! { circle class=(class) cx=(at(x)) cy=(at(y)) r=(R) {} },
        1 => path(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)]),
        2 => path(&[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)]),
        3 => path(&[(0.0, -1.15), (1.15, 0.9), (-1.15, 0.9)]),
        4 => path(&[(0.0, 1.15), (1.15, -0.9), (-1.15, -0.9)]),
        5 => path(&[(-0.9, -0.5), (0.9, -0.5), (0.9, 0.5), (-0.9, 0.5)]),
        _ => path(&[(-0.5, -1.1), (0.5, -1.1), (0.5, 1.1), (-0.5, 1.1)]),
    }
}
