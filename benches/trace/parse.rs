//! Parsing a scene of a thousand objects.

use std::hint::black_box;

use criterion::{Criterion, Throughput};
use srt::scene_file::{ParseOptions, parse};

use crate::table::Row;

pub(crate) fn group(criterion: &mut Criterion, rows: &mut Vec<Row>) {
    let object = "{\n  translate 1 2 3\n  rotate 30 0 0 1\n  cr .5 .5 .5\n  ball 1 0 0 0\n}\n";
    let camera = "eyepos 0 -5 0\neyedir 0 1 0\neyeup 0 0 1\nwdist 1\nfovy_deg 40\nnx 9\nny 9\n";
    let scene = format!("sce1.0\n{camera}{}end\n", object.repeat(1000));
    let lines = scene.lines().count() as u64;
    let options = ParseOptions::default();
    let parsed = parse(&scene, &options).expect("the scene is valid");
    assert_eq!(parsed.description.objects.len(), 1000);
    let mut group = criterion.benchmark_group("parse");
    group.throughput(Throughput::Elements(lines));
    group.bench_function("scene", |b| b.iter(|| parse(black_box(&scene), &options)));
    group.finish();
    rows.push(Row::new("parse", "scene", None, lines, "lines"));
}
