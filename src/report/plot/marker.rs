//! Markers: a shape for each structure, so that structures do not differ by colour alone.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use maud::{Markup, html};

use super::{Look, at};

/// How many shapes there are.
pub(super) const MARKERS: usize = 12;

const R: f64 = 4.6;

/// A plus sign of arms of this half width and length.
const ARM: (f64, f64) = (0.4, 1.2);

/// The marker of a look at a place, which tells its value when the pointer is over it.
pub(super) fn marker_with_value(look: Look, x: f64, y: f64, value: &str) -> Markup {
    html! { g { title { (value) } (marker(look, x, y)) } }
}

/// The marker of a look at a place.
pub(super) fn marker(look: Look, x: f64, y: f64) -> Markup {
    let class = format!("mark {}", look.color_class());
    let place = format!("translate({} {})", at(x), at(y));
    let corners = corners(look.marker());
    html! {
        @if corners.is_empty() { circle class=(class) transform=(place) r=(R) {} }
        @else { polygon class=(class) transform=(place) points=(points(&corners)) {} }
    }
}

/// The corners of a shape about the origin, in multiples of [`R`]; none of a disk.
fn corners(shape: usize) -> Vec<(f64, f64)> {
    match shape {
        0 => vec![],
        1 => vec![(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
        2 => vec![(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
        3 => vec![(0.0, -1.15), (1.15, 0.9), (-1.15, 0.9)],
        4 => vec![(0.0, 1.15), (1.15, -0.9), (-1.15, -0.9)],
        5 => vec![(-0.9, -0.5), (0.9, -0.5), (0.9, 0.5), (-0.9, 0.5)],
        6 => vec![(-0.5, -1.1), (0.5, -1.1), (0.5, 1.1), (-0.5, 1.1)],
        7 => plus(),
        8 => plus()
            .into_iter()
            .map(|(x, y)| ((x - y) * FRAC_1_SQRT_2, (x + y) * FRAC_1_SQRT_2))
            .collect(),
        9 => star(),
        10 => vec![(-1.15, 0.0), (0.9, -1.15), (0.9, 1.15)],
        _ => vec![(1.15, 0.0), (-0.9, -1.15), (-0.9, 1.15)],
    }
}

fn plus() -> Vec<(f64, f64)> {
    let (w, l) = ARM;
    let quarter = [(w, -l), (w, -w), (l, -w)];
    let turned = |turns: usize| quarter.map(|corner| (0..turns).fold(corner, |(x, y), _| (-y, x)));
    (0..4).flat_map(turned).collect()
}

/// A star of five points.
fn star() -> Vec<(f64, f64)> {
    let corner = |i: u32| {
        let (radius, angle) =
            (if i.is_multiple_of(2) { 1.4 } else { 0.6 }, PI * f64::from(i) / 5.0);
        (radius * libm::sin(angle), -radius * libm::cos(angle))
    };
    (0..10).map(corner).collect()
}

fn points(corners: &[(f64, f64)]) -> String {
    let corner = |&(x, y): &(f64, f64)| format!("{},{}", at(x * R), at(y * R));
    corners.iter().map(corner).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn no_two_shapes_are_the_same() {
        let shapes: BTreeSet<String> = (0..MARKERS).map(|shape| points(&corners(shape))).collect();
        assert_eq!(shapes.len(), MARKERS);
    }
}
