//! Which colour, marker and dashes a structure has.
//!
//! A look follows from the structure's name, so a structure looks the same in every report. The built-in structures
//! and peers have fixed looks of their own. Any other name is hashed to one of the remaining looks. Two names of one
//! report never share a look while there are looks left: 84 in all.

use std::collections::{BTreeMap, BTreeSet};

use super::marker::MARKERS;

/// Colours, as classes `s0`, `s1`, … of the style sheet.
const COLORS: usize = 7;

/// Patterns of dashes, as classes `d1`, `d2`, … of the style sheet; 0 is a solid line.
const DASHES: usize = 6;

/// Looks that no built-in structure has.
const FREE: usize = COLORS * (MARKERS - ROWS);

/// Rows of looks that built-in structures have.
const ROWS: usize = 2;

/// The names with fixed looks: place n has colour n, marker n and a solid line.
const FIXED: [&str; COLORS] = ["none", "ball", "bvh", "cwbvh", "bvh8", "embree", "embree16"];

/// More of them, in the row behind: place n has colour n, the marker after n and dashes.
const FIXED_DASHED: [&str; 6] = ["kdtree", "grid", "grid2", "octree", "balls", "kdop"];

/// How a structure is drawn. Colour and marker together identify it; where a line is drawn without markers, structures
/// of the same colour differ by their dashes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(in crate::report) struct Look {
    color: usize,
    marker: usize,
    dash: usize,
}

impl Look {
    /// The look of a colour in a row. The first rows are those of the fixed looks.
    fn new(row: usize, color: usize) -> Self {
        let dash = if row == 0 { 0 } else { 1 + (row - 1) % DASHES };
        Self { color, marker: (color + row) % MARKERS, dash }
    }

    /// The look of series n of a plot that does not show structures.
    pub(in crate::report) fn of_series(n: usize) -> Self {
        Self::new(0, n % COLORS)
    }

    /// A look that no built-in structure has; neighbours differ in colour.
    fn free(slot: usize) -> Self {
        Self::new(ROWS + slot / COLORS, slot % COLORS)
    }

    /// The number of the marker, below [`MARKERS`].
    pub(super) fn marker(self) -> usize {
        self.marker
    }

    /// The class that sets the colour of lines and areas.
    pub(super) fn color_class(self) -> String {
        format!("s{}", self.color)
    }

    /// The classes that set colour and dashes of a line.
    pub(super) fn line_classes(self) -> String {
        format!("s{} d{}", self.color, self.dash)
    }
}

/// The looks of all structures of a report.
#[derive(Clone, Debug)]
pub(in crate::report) struct Looks(BTreeMap<String, Look>);

impl Looks {
    /// Gives every name a look. The order of the names does not matter.
    ///
    /// Each name takes the look that it is hashed to. Of several names with the same one, the first in alphabetical
    /// order keeps it; each of the others takes the next look that no name of the report is hashed to or has taken.
    pub(in crate::report) fn of<'a>(names: impl IntoIterator<Item = &'a str>) -> Self {
        let names: BTreeSet<&str> = names.into_iter().collect();
        let mut looks = BTreeMap::new();
        let (mut taken, mut displaced) = ([false; FREE], Vec::new());
        for name in names {
            match fixed(name) {
                Some(look) => _ = looks.insert(name.to_owned(), look),
                None if taken[slot(name)] => displaced.push(name),
                None => {
                    taken[slot(name)] = true;
                    looks.insert(name.to_owned(), Look::free(slot(name)));
                }
            }
        }
        for name in displaced {
            let own = slot(name);
            let next = (0..FREE).map(|step| (own + step) % FREE).find(|&slot| !taken[slot]);
            // More names than looks: the look is shared.
            let slot = next.unwrap_or(own);
            taken[slot] = true;
            looks.insert(name.to_owned(), Look::free(slot));
        }
        Self(looks)
    }

    /// The look of one of the names.
    pub(in crate::report) fn get(&self, name: &str) -> Look {
        let other = || fixed(name).unwrap_or_else(|| Look::free(slot(name)));
        self.0.get(name).copied().unwrap_or_else(other)
    }
}

fn fixed(name: &str) -> Option<Look> {
    let place = |row, names: &[&str]| {
        names.iter().position(|own| *own == name).map(|color| Look::new(row, color))
    };
    place(0, &FIXED).or_else(|| place(1, &FIXED_DASHED))
}

/// Which of the free looks a name is hashed to, by FNV-1a: the same in every version and on every machine.
fn slot(name: &str) -> usize {
    let hash = name.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    (hash % FREE as u64) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    const STYLE: &str = super::super::STYLE;

    fn names(count: usize) -> Vec<String> {
        let others = (0..).map(|n| format!("bvh8:builder={n}"));
        FIXED.iter().map(|&name| name.to_owned()).chain(others).take(count).collect()
    }

    fn looks(names: &[String]) -> Looks {
        Looks::of(names.iter().map(String::as_str))
    }

    #[test]
    fn no_two_names_share_colour_and_marker_while_there_are_looks() {
        for count in [2, 24, FREE + FIXED.len()] {
            let (names, mut pairs) = (names(count), BTreeSet::new());
            let looks = looks(&names);
            pairs.extend(names.iter().map(|name| looks.get(name)).map(|l| (l.color, l.marker)));
            assert_eq!(pairs.len(), count);
        }
        let names = names(FREE + FIXED.len() + 10);
        let all: BTreeSet<Look> = names.iter().map(|name| looks(&names).get(name)).collect();
        assert_eq!(all.len(), FREE + FIXED.len(), "beyond that, looks are shared");
    }

    #[test]
    fn built_in_names_keep_their_looks_beside_any_others() {
        let (names, alone) = (names(60), Looks::of(["bvh"]));
        for (number, name) in FIXED.into_iter().enumerate() {
            let own = Look { color: number, marker: number, dash: 0 };
            assert_eq!((looks(&names).get(name), alone.get(name)), (own, own), "{name}");
        }
        let fixed: BTreeSet<Look> =
            FIXED.iter().chain(&FIXED_DASHED).map(|name| alone.get(name)).collect();
        assert_eq!(fixed.len(), FIXED.len() + FIXED_DASHED.len());
        assert!((0..FREE).all(|slot| !fixed.contains(&Look::free(slot))));
    }

    #[test]
    fn a_name_loses_its_look_to_a_name_with_the_same_one_alone() {
        let names = names(40);
        let (all, mut kept) = (looks(&names), 0);
        for name in &names[FIXED.len()..] {
            let alone = Looks::of([name.as_str()]).get(name);
            let has_twin = |other: &&String| slot(other) == slot(name) && *other != name;
            let twins: Vec<&String> = names[FIXED.len()..].iter().filter(has_twin).collect();
            let is_first = twins.iter().all(|twin| name < *twin);
            assert_eq!(all.get(name) == alone, is_first, "{name}");
            kept += usize::from(is_first);
        }
        assert!((20..33).contains(&kept), "{kept}: some collide, most do not");
        let mut reversed = names.clone();
        reversed.reverse();
        assert!(names.iter().all(|name| looks(&reversed).get(name) == all.get(name)));
    }

    /// The value of a variable in each block of the style sheet that sets it: light, dark, print.
    fn variable(name: &str) -> Vec<[f64; 3]> {
        let value = |text: &str| {
            let digits: Vec<char> = text.chars().take_while(char::is_ascii_hexdigit).collect();
            let digit = |i: usize| f64::from(digits[i].to_digit(16).unwrap());
            match digits.len() {
                3 => [0, 1, 2].map(|i| digit(i) * 17.0),
                _ => [0, 2, 4].map(|i| digit(i) * 16.0 + digit(i + 1)),
            }
        };
        STYLE.split(&format!("--{name}: #")).skip(1).map(value).collect()
    }

    /// The contrast of two colours by the Web Content Accessibility Guidelines 2.1.
    fn contrast(a: [f64; 3], b: [f64; 3]) -> f64 {
        let linear = |c: f64| {
            let c = c / 255.0;
            if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        };
        let luminance = |[r, g, b]: [f64; 3]| {
            0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b) + 0.05
        };
        let ratio = luminance(a) / luminance(b);
        ratio.max(1.0 / ratio)
    }

    #[test]
    fn colours_are_legible_in_light_and_dark_and_on_paper() {
        let pages = variable("page");
        assert_eq!(pages.len(), 3);
        for color in 0..COLORS {
            let values = variable(&format!("c{color}"));
            assert_eq!(values.len(), 3, "c{color}");
            for (value, page) in values.into_iter().zip(&pages) {
                let contrast = contrast(value, *page);
                assert!(contrast >= 3.0, "c{color} on {page:?}: {contrast:.2}");
            }
            assert!(STYLE.contains(&format!(".s{color} {{")), "s{color}");
        }
        assert!((1..=DASHES).all(|dash| STYLE.contains(&format!("svg .d{dash} {{"))));
    }
}
