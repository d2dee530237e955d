//! The chapter on sampling: Markdown and CSV have the numbers of the JSON. `same_numbers` compares HTML and Markdown.

use std::collections::HashMap;

use serde_json::Value;
use srt::report::Report;

use crate::same_numbers::{
    assert_estimate, assert_printed, csv_estimate, derived, markdown_rows, same,
};
use crate::sample;

fn list<'a>(derived: &'a Value, name: &str) -> Vec<&'a Value> {
    derived[name].as_array().unwrap().iter().collect()
}

fn of_pairing<'a>(noise: &[&'a Value], pairing: &str) -> Vec<&'a Value> {
    noise.iter().copied().filter(|own| own["pairing"] == pairing).collect()
}

#[test]
fn markdown_prints_the_figures_of_the_json() {
    let comparison = sample::full();
    let text = Report::new(&comparison).markdown();
    let derived = derived(&comparison);
    let rows = |title: &str| {
        let (_, table) = text.split_once(&format!("\n### {title}\n")).unwrap();
        markdown_rows(table.split("\n#").next().unwrap())
    };
    let shares = rows("Share of a frame");
    assert_eq!(shares.len(), 4);
    for (row, own) in shares.iter().zip(list(&derived, "shares")) {
        assert_eq!((&row[0], &row[1]), (&text_of(own, "scene"), &text_of(own, "sampling")));
        let percent = own["share"].as_f64().unwrap() * 100.0;
        assert_printed(row[5].trim_end_matches("\u{a0}%"), &percent.into());
    }
    let noise = list(&derived, "noise");
    for (title, pairing, count) in [
        ("Noise that is left by equal samples", "equal_samples", 16),
        ("Noise that is left after equal time", "equal_time", 12),
    ] {
        let (rows, own) = (rows(title), of_pairing(&noise, pairing));
        assert_eq!((rows.len(), own.len()), (count, count), "{title}");
        for (row, own) in rows.iter().zip(own) {
            assert_eq!((&row[0], &row[1]), (&text_of(own, "scene"), &text_of(own, "sampling")));
            assert_printed(&row[2], &own["pixel_samples"]);
            assert_printed(&row[3], &own["light_samples"]);
            assert_estimate(&row[5], &own["rmse"]);
            match own["ratio"].is_null() {
                true => assert_eq!((row[6].as_str(), row[1].as_str()), ("–", "independent")),
                false => assert_estimate(&row[6], &own["ratio"]),
            }
        }
    }
}

fn text_of(value: &Value, field: &str) -> String {
    value[field].as_str().unwrap().to_owned()
}

#[test]
fn csv_has_every_figure_of_the_json() {
    let comparison = sample::full();
    let derived = derived(&comparison);
    let text = Report::new(&comparison).sampling_csv().unwrap();
    let mut lines = text.lines();
    let heads: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<HashMap<&str, &str>> =
        lines.map(|line| heads.iter().copied().zip(line.split(',')).collect()).collect();
    let of = |what: &str| rows.iter().filter(|row| row["what"] == what).collect::<Vec<_>>();
    let (costs, shares, noise) = (of("cost"), of("share"), of("noise"));
    assert_eq!((costs.len(), shares.len(), noise.len()), (2, 4, 28));
    for (row, own) in costs.iter().zip(list(&derived, "operations")) {
        assert_eq!(row["operation"], own["operation"]);
        csv_estimate(row, "ns", &own["ns"]);
    }
    for (row, own) in shares.iter().zip(list(&derived, "shares")) {
        assert_eq!(row["scene"], own["scene"]);
        same(row["share"], &own["share"]);
    }
    for (row, own) in noise.iter().zip(list(&derived, "noise")) {
        assert_eq!(
            (row["scene"], row["sampling"]),
            (&*text_of(own, "scene"), &*text_of(own, "sampling"))
        );
        assert_eq!(format!("equal_{}", row["equal"]), own["pairing"]);
        csv_estimate(row, "ns", &own["ns"]);
        csv_estimate(row, "rmse", &own["rmse"]);
        same(row["pixel_samples"], &own["pixel_samples"]);
        same(row["ratio"], &own["ratio"]["value"]);
    }
    assert!(Report::new(&sample::partial()).sampling_csv().is_none());
}
