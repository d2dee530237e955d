//! A structure looks the same in all plots of all reports, and no two of a report look alike.

use std::collections::{BTreeMap, BTreeSet};

use srt::scene::STRUCTURES;

use crate::{html, sample};

/// The built-in structures, the peers, and others up to so many.
fn names(count: usize) -> Vec<String> {
    let own = STRUCTURES.iter().map(|structure| structure.name.to_owned());
    let peers = ["embree", "embree16"].map(str::to_owned);
    let others = (0..).map(|n| format!("bvh8:builder={n}"));
    own.chain(peers).chain(others).take(count).collect()
}

fn page(names: &[String]) -> String {
    let comparison = sample::with_structures(names.iter().map(String::as_str));
    html::page(&format!("structures-{}", names.len()), &comparison)
}

/// The colours and shapes of the markers beside each structure's name, over all plots of a page.
fn looks(page: &str) -> BTreeMap<String, BTreeSet<(String, String)>> {
    let mut looks: BTreeMap<String, BTreeSet<(String, String)>> = BTreeMap::new();
    for mark in page.split(" class=\"mark ").skip(1) {
        let (color, rest) = mark.split_once('"').unwrap();
        let (_, shape) = rest.split_once("transform=\"").unwrap();
        let (shape, rest) = shape.split_once('>').unwrap();
        let (_, shape) = shape.split_once('"').unwrap();
        // In dot plots the name stands before the marker.
        let next = rest.split_once('>').unwrap().1.strip_prefix("<text class=\"name\"");
        let Some((_, name)) = next.and_then(|text| text.split_once('>')) else { continue };
        let name = name.split(['<', ' ']).next().unwrap().trim_end_matches(',');
        let look = (color.to_owned(), shape.to_owned());
        looks.entry(name.to_owned()).or_default().insert(look);
    }
    looks
}

#[test]
fn twenty_four_structures_have_twenty_four_looks() {
    let names = names(24);
    let looks = looks(&page(&names));
    assert!(looks.keys().eq(names.iter().collect::<BTreeSet<_>>()), "{:?}", looks.keys());
    assert!(looks.values().all(|own| own.len() == 1), "one look in all plots: {looks:?}");
    let different: BTreeSet<_> = looks.values().collect();
    assert_eq!(different.len(), 24, "{looks:?}");
}

#[test]
fn a_structure_keeps_its_look_whatever_is_compared_with_it() {
    let all = names(24);
    let (many, built_in) = (looks(&page(&all)), STRUCTURES.len() + 2);
    let reversed: Vec<String> = all[..built_in].iter().rev().cloned().collect();
    let few = looks(&page(&reversed));
    assert!(few.len() == built_in && few.iter().all(|(name, look)| many[name] == *look));
    let own = |names: &[&str]| {
        looks(&page(&names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>()))
    };
    assert_eq!(own(&["grid", "bvh"])["grid"], own(&["none", "ball", "kdtree", "grid"])["grid"]);
}

#[test]
fn plots_hold_all_names() {
    let page = page(&names(40));
    for svg in page.split("<svg ").skip(1).filter(|svg| svg.contains("class=\"name\"")) {
        let number = |text: &str| text.split('"').next().unwrap().parse::<f64>().unwrap();
        let (_, size) = svg.split_once("viewBox=\"0 0 ").unwrap();
        let size: Vec<f64> = size.split(['"', ' ']).take(2).map(|n| n.parse().unwrap()).collect();
        let places: Vec<(f64, f64)> = svg
            .split("<text class=\"name\" x=\"")
            .skip(1)
            .map(|text| (number(text), number(text.split_once("y=\"").unwrap().1)))
            .collect();
        assert!(places.len() >= 40);
        assert!(
            places.iter().all(|(x, y)| (0.0..size[0]).contains(x) && (8.0..size[1]).contains(y))
        );
        let column = places[0].0;
        let mut heights: Vec<f64> =
            places.iter().filter(|place| place.0 == column).map(|place| place.1).collect();
        heights.sort_by(f64::total_cmp);
        let least = heights.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::MAX, f64::min);
        assert!(least > 14.0, "names overlap: {least}");
    }
}
