//! The JSON: it reads back equal, and every field is documented.

use std::collections::BTreeSet;

use serde_json::Value;
use srt::report::{Report, read_json};

use crate::sample;

const SCHEMA: &str = include_str!("../../docs/report-schema.md");

#[test]
fn every_record_reads_back_as_it_was_written() {
    for record in [sample::full(), sample::minimal(), sample::partial()] {
        let text = Report::new(&record).json().unwrap();
        assert_eq!(read_json(&text).unwrap(), record);
        assert!(text.ends_with("}\n"));
    }
}

#[test]
fn what_is_no_record_is_an_error_with_a_reason() {
    let error = |text: &str| read_json(text).unwrap_err().to_string();
    assert!(error("no json").starts_with("not a record of a comparison: expected"));
    assert!(error("{}").contains("missing field `schema_version`"));
    assert!(error("{\"schema_version\": 1}").contains("missing field `run`"));
    let future = error("{\"schema_version\": 3, \"something\": []}");
    assert_eq!(
        future,
        "the record has schema version 3; this version of srt reads versions 1 to 2"
    );
    let whole = Report::new(&sample::full()).json().unwrap();
    for end in [1, whole.len() / 3, whole.len() - 10] {
        let end = (0..=end).rev().find(|&i| whole.is_char_boundary(i)).unwrap();
        assert!(read_json(&whole[..end]).is_err());
    }
}

#[test]
fn fields_of_later_versions_are_ignored() {
    let text = Report::new(&sample::minimal()).json().unwrap();
    let text = text.replacen('{', "{\"of_the_future\": [1, {\"a\": 2}], ", 1);
    assert_eq!(read_json(&text).unwrap(), sample::minimal());
}

#[test]
fn older_names_of_fields_are_read() {
    let mut record = sample::full();
    record.scenes[0].structures[1].peer = true;
    let text = Report::new(&record).json().unwrap();
    let older =
        text.replace("\"peer\":", "\"yardstick\":").replace("\"peers\":", "\"yardsticks\":");
    assert_eq!(older.matches("yardstick").count(), 8 + 2, "eight structures, two proofs");
    assert_eq!(read_json(&older).unwrap(), record);
}

#[test]
fn every_field_is_documented_and_every_documented_field_is_there() {
    let mut paths = BTreeSet::new();
    for record in [sample::full(), sample::partial()] {
        let value = serde_json::from_str(&Report::new(&record).json().unwrap()).unwrap();
        collect("", &value, &mut paths);
    }
    let documented: BTreeSet<String> = SCHEMA
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split('`').next())
        .map(str::to_owned)
        .collect();
    let missing: Vec<_> = paths.difference(&documented).collect();
    assert!(missing.is_empty(), "not in docs/report-schema.md: {missing:#?}");
    let stale: Vec<_> = documented.difference(&paths).collect();
    assert!(stale.is_empty(), "in docs/report-schema.md, but in no record: {stale:#?}");
}

/// The paths of all fields; entries of a list share one. An estimate is one field.
fn collect(path: &str, value: &Value, paths: &mut BTreeSet<String>) {
    match value {
        Value::Object(fields) if fields.contains_key("value") => {}
        Value::Object(fields) => {
            for (name, value) in fields {
                let dot = if path.is_empty() { "" } else { "." };
                let path = format!("{path}{dot}{name}");
                paths.insert(path.clone());
                collect(&path, value, paths);
            }
        }
        Value::Array(entries) if entries.iter().any(Value::is_object) => {
            entries.iter().for_each(|entry| collect(&format!("{path}[]"), entry, paths));
        }
        _ => {}
    }
}
