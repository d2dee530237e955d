//! The verdict, the terminal's table, and Markdown's sentences.

use std::collections::BTreeSet;

use serde_json::Value;
use srt::analysis::{Analysis, OverallFigures};
use srt::record::{BlockSample, Comparison, RayClass, Status};
use srt::report::{Pictures, Report};

use crate::sample;

#[test]
fn the_verdict_is_one_sentence() {
    assert_eq!(
        Report::new(&sample::full()).verdict(),
        "bvh traces mirror rays 1.02\u{a0}× (95\u{a0}%\u{a0}1.01–1.03) as fast as cwbvh, in the geometric \
         mean of 2 scenes (0.925–1.13\u{a0}×), by 164\u{a0}k rays; no difference in 7.36\u{a0}M compared rays and 1 of 2 whole pictures; not compared in a whole \
         picture: hall (no picture from none)."
    );
    let mut partial = sample::partial();
    partial.conformance.clear();
    assert_eq!(
        Report::new(&partial).verdict(),
        "Stopped early: RESULTS DIFFER: cwbvh disagrees with none on bunny in 12 pixels and 3 hits, \
         so its speed cannot be compared."
    );
    assert_eq!(
        Report::new(&sample::minimal()).verdict(),
        "nothing was traced; no results were compared."
    );
}

/// A statement that runs differ by 5 % leaves no finding of 3 % certain, however narrow the run's own interval is.
#[test]
fn intervals_include_what_is_stated_to_differ_between_runs() {
    let mut comparison = sample::full();
    let row = |comparison: &Comparison| {
        let text = Report::new(comparison).markdown();
        text.lines().find(|line| line.contains("Between runs")).map(str::to_owned)
    };
    let of_one_run = row(&comparison).unwrap();
    assert!(of_one_run.contains("they are for this run alone"), "{of_one_run}");
    comparison.run.between_runs = 0.05;
    let of_any_run = row(&comparison).unwrap();
    assert!(of_any_run.contains("a standard deviation of 5.0\u{a0}%, as stated"), "{of_any_run}");
    let verdict = Report::new(&comparison).verdict();
    assert!(verdict.contains("are not told apart by view rays: 1.02\u{a0}×"), "{verdict}");
}

#[test]
fn the_verdict_of_few_rounds_claims_no_interval() {
    let mut comparison = sample::full();
    comparison.scenes.truncate(1);
    comparison.scenes[0].proof = None;
    for class in comparison.scenes[0].structures.iter_mut().flat_map(|own| &mut own.classes) {
        class.rounds.truncate(2);
    }
    let text = Report::new(&comparison).verdict();
    let nothing = "the passes are too few, or their intervals too wide, for any statement;";
    assert!(text.starts_with(nothing), "{text}");
    let end = "; not compared in a whole picture: bunny (no picture from none, ball, bvh, cwbvh).";
    assert!(text.ends_with(end), "{text}");
    comparison.sweeps.clear();
    let text = Report::new(&comparison).verdict();
    assert!(text.ends_with("; no results were compared."), "{text}");
}

/// Rounds of older records are no passes: eight of them have an interval of their median, but none that holds for all
/// comparisons from which the verdict was chosen.
#[test]
fn a_verdict_that_few_rounds_support_says_so() {
    let mut comparison = sample::full();
    comparison.scenes.truncate(1);
    for class in comparison.scenes[0].structures.iter_mut().flat_map(|own| &mut own.classes) {
        class.passes.clear();
        class.rounds.truncate(6);
    }
    let text = Report::new(&comparison).verdict();
    assert!(text.contains("× (too few rounds for an interval)"), "{text}");
}

#[test]
fn the_verdict_names_what_failed_first() {
    let mut comparison = sample::full();
    comparison.scenes.truncate(1);
    let row = &mut comparison.scenes[0].structures[1];
    row.status = Status::Failed { message: "it panicked: no leaf".to_owned() };
    row.classes.clear();
    comparison.scenes[0].proof.as_mut().unwrap().structures.remove(1);
    let text = Report::new(&comparison).verdict();
    assert!(text.starts_with("ball FAILED in bunny: it panicked: no leaf; bvh traces "), "{text}");
    let end = "; no difference in 3.02\u{a0}M compared rays and the whole picture.";
    assert!(text.ends_with(end), "{text}");
}

#[test]
fn what_failed_in_a_sweep_is_named_and_has_a_row() {
    let mut comparison = sample::full();
    let sweep = &mut comparison.sweeps[0];
    sweep.points.retain(|point| point.structure != "ball");
    sweep.dropped[1].failed = true;
    sweep.dropped[1].triangles = 1_000;
    sweep.dropped[1].reason = "its results differ: a ray".to_owned();
    let failed = "ball FAILED in the sweep, in hall with 1.00\u{a0}k triangles: its results \
                  differ: a ray; bvh traces ";
    assert!(
        Report::new(&comparison).verdict().starts_with(failed),
        "{}",
        Report::new(&comparison).verdict()
    );
    let row = "| – | ball | – | – | 0 | at 1.00\u{a0}k triangles: its results differ: a ray |";
    let text = Report::new(&comparison).markdown();
    assert!(text.contains(row), "{text}");
    comparison.scenes.clear();
    assert!(Report::new(&comparison).verdict().starts_with("ball FAILED in the sweep"));
}

#[test]
fn the_verdict_is_about_scenes_with_enough_rounds() {
    let mut comparison = sample::full();
    for class in comparison.scenes[0].structures.iter_mut().flat_map(|own| &mut own.classes) {
        class.rounds.truncate(2);
    }
    let text = Report::new(&comparison).verdict();
    assert!(text.contains(" as fast as bvh, in hall, by ") && !text.contains("bunny,"), "{text}");
}

#[test]
fn a_single_structure_is_compared_with_nothing() {
    let mut comparison = sample::full();
    comparison.scenes[0].structures.truncate(1);
    comparison.scenes.truncate(1);
    let text = Report::new(&comparison).verdict();
    assert!(text.starts_with("no two structures traced the same rays;"), "{text}");
}

#[test]
fn structures_that_are_equally_fast_are_called_so() {
    let mut comparison = sample::full();
    comparison.scenes.truncate(1);
    let classes = comparison.scenes[0].structures[2].classes.clone();
    comparison.scenes[0].structures[3].classes = classes;
    let text = Report::new(&comparison).verdict();
    let start = "bvh and cwbvh are not told apart by view rays: 1.00\u{a0}× ";
    assert!(text.starts_with(start), "{text}");
}

#[test]
fn what_weakens_the_verdict_stands_beside_it() {
    let mut comparison = sample::full();
    comparison.run.machine.load_at_start = Some([3.5, 1.0, 1.0]);
    for structure in &mut comparison.scenes[0].structures {
        structure.classes[1].rounds.truncate(2);
    }
    let report = Report::new(&comparison);
    let weak = "What weakens this: the machine was busy at the start (load 3.50); 4 of 42 ratios \
                have too few passes or too wide an interval; 2 of 42 measurements are of samples \
                of the rays.";
    assert!(report.terminal().contains(weak), "{}", report.terminal());
    assert!(report.markdown().contains(weak) && report.html(&Pictures::new()).contains(weak));
}

#[test]
fn a_ratio_that_is_too_wide_is_called_so_and_is_in_no_chart_and_no_mean() {
    let mut comparison = sample::full();
    comparison.scenes.truncate(1);
    let all = Report::new(&comparison).html(&Pictures::new());
    let own = &mut comparison.scenes[0].structures[3].classes[0];
    own.sample = Some(BlockSample { blocks: 2, rays_per_block: 8, of_rays: 307_200 });
    own.rounds.truncate(6);
    own.passes = vec![1; 6];
    for (round, n) in own.rounds.iter_mut().zip(0..) {
        round.wall_ns = if n % 2 == 0 { 1_000_000 } else { 900_000_000 };
        round.cpu_ns = None;
    }
    let report = Report::new(&comparison);
    assert!(report.markdown().contains("| too wide ("), "{}", report.markdown());
    assert!(report.terminal().contains("too wide"));
    let figures = Analysis::of(&comparison);
    let mean = |own: &&OverallFigures| own.structure == "cwbvh" && own.class == RayClass::View;
    assert_eq!(figures.overall.iter().find(mean), None);
    let own = figures.scenes[0].structure("cwbvh").unwrap();
    assert_eq!((own.mean_ray_ns, own.break_even, own.on_pareto_front), (None, None, false));
    let dots = |page: &str| page.matches("<text class=\"value\"").count();
    assert_eq!(
        dots(&report.html(&Pictures::new())),
        dots(&all) - 4,
        "speed-up and rate, in both forms"
    );
}

#[test]
fn the_verdict_counts_the_pictures_that_were_proved_equal() {
    let mut comparison = sample::full();
    comparison.scenes.truncate(1);
    let end = "; no difference in 4.46\u{a0}M compared rays and the whole picture.";
    assert!(Report::new(&comparison).verdict().ends_with(end));
    // A picture without a hash is not the whole one.
    comparison.scenes[0].proof.as_mut().unwrap().structures[1].picture_hash = None;
    let text = Report::new(&comparison).verdict();
    let end = "; no difference in 4.46\u{a0}M compared rays; not compared in a whole picture: bunny (a \
               smaller one from ball).";
    assert!(text.ends_with(end), "{text}");
    let smaller = comparison.scenes[0].clone();
    comparison.scenes.extend([smaller.clone(), smaller.clone(), smaller]);
    assert!(Report::new(&comparison).verdict().ends_with("(a smaller one from ball) and 1 more."));
}

#[test]
fn the_mean_over_scenes_is_geometric_and_has_their_number() {
    let mut comparison = sample::full();
    comparison.base = "bvh".to_owned();
    let analysis = Analysis::of(&comparison);
    let ratio = |scene: usize| {
        let own = analysis.scenes[scene].structure("cwbvh").unwrap();
        own.class(RayClass::View).unwrap().speedup.unwrap().value
    };
    let is_own = |own: &&OverallFigures| own.structure == "cwbvh" && own.class == RayClass::View;
    let mean = analysis.overall.iter().find(is_own).unwrap();
    assert_eq!(mean.scenes, 2);
    assert!((mean.speedup - (ratio(0) * ratio(1)).sqrt()).abs() < 1e-12);
    let none = analysis.overall.iter().find(|own| own.structure == "none").unwrap();
    assert_eq!(none.scenes, 1, "it was too slow for the other");
    let own = analysis.scenes[0].structure("cwbvh").unwrap();
    let ratios = own.classes.iter().map(|class| class.speedup.unwrap().value.ln());
    let expected = (ratios.sum::<f64>() / own.classes.len() as f64).exp();
    let found = analysis.scenes[0].mean_speedup(own).unwrap();
    assert!((found - expected).abs() < 1e-12 * expected, "{found} {expected}");
    let text = Report::new(&comparison).markdown();
    assert!(text.contains("### All scenes together") && text.contains("(2 scenes)"), "{text}");
    assert!(text.contains("### What was compared"));
    comparison.scenes.truncate(1);
    assert!(!Report::new(&comparison).markdown().contains("All scenes together"));
}

#[test]
fn a_baseline_is_in_every_form() {
    let comparison = sample::full();
    let page = Report::new(&comparison).html(&Pictures::new());
    for text in [page, Report::new(&comparison).markdown()] {
        assert!(text.contains("Against the baseline") && text.contains("SLOWER"), "{text}");
        assert!(text.contains("The two runs traced different rays."), "{text}");
        assert!(text.contains("1 of 2 measurements changed by more than 10.0"), "{text}");
    }
}

#[test]
fn what_does_not_conform_is_named_first() {
    let mut comparison = sample::full();
    comparison.conformance = sample::partial().conformance;
    let report = Report::new(&comparison);
    let verdict = report.verdict();
    let claim = "kd-tree DOES NOT CONFORM and is not timed: it gives other hits than no structure at mesh \
                 nested; mine DOES NOT CONFORM and is not timed: it panicked: out of | luck; ";
    assert!(verdict.starts_with(claim), "{verdict}");
    assert!(
        verdict.contains(" rays 95") || verdict.contains("× (95"),
        "the others are compared: {verdict}"
    );
    let page = report.html(&Pictures::new());
    for text in [report.markdown().replace('\\', ""), page] {
        assert!(text.contains("DIFFERS at mesh nested"), "{text}");
        assert!(text.contains("traced alone: Ray { origin: Vec3(0.25, 1.0, 5.0)"), "{text}");
        assert!(text.contains("expected Hit { t: 0.5, object: 0, prim: 7"), "{text}");
    }
    let stopped = Report::new(&sample::partial()).verdict();
    assert!(stopped.starts_with("Stopped early: kd-tree DOES NOT CONFORM"), "{stopped}");
    assert!(stopped.contains("out of | luck. RESULTS DIFFER: "), "{stopped}");
}

#[test]
fn the_verdict_without_scenes_is_about_growth() {
    let mut comparison = sample::full();
    comparison.scenes.clear();
    let text = Report::new(&comparison).verdict();
    let parts = [
        "traces view rays of hall with ",
        " triangles fastest, in ",
        " each; its cost grows \
                 with the power ",
        " of the number of triangles; no difference in 123\u{a0}k compared rays.",
    ];
    assert!(parts.iter().all(|part| text.contains(part)), "{text}");
}

#[test]
fn the_terminal_has_a_line_for_each_structure() {
    insta::assert_snapshot!(Report::new(&sample::full()).terminal());
    insta::assert_snapshot!(Report::new(&sample::partial()).terminal());
}

#[test]
fn markdown_lists_what_is_doubtful() {
    let mut comparison = sample::full();
    comparison.run.machine.governor = Some("powersave".to_owned());
    comparison.run.machine.load_at_start = Some([3.5, 1.0, 1.0]);
    comparison.run.commit = Some("abc-dirty".to_owned());
    comparison.scenes[0].structures[0].status = Status::TooSlow { after_seconds: 0.5 };
    let text = Report::new(&comparison).markdown();
    for sentence in [
        "The governor was powersave, not performance",
        "its load was 3.50",
        "The sources had changed since the named commit",
        "none was not measured in hall; ratios there are to ball.",
        "The hall was generated with seed 1.",
        "too slow for 500\u{a0}ms",
        "at 1.00\u{a0}M triangles: a round would take more",
    ] {
        assert!(text.contains(sentence), "{sentence}");
    }
    assert!(!Report::new(&sample::full()).markdown().contains("The governor was"));
}

#[test]
fn text_of_the_record_breaks_no_table() {
    let text = Report::new(&sample::partial()).markdown();
    assert!(text.contains("failed: the build ran out of \\| memory &lt;here&gt;"));
    assert!(text.contains("**Partial:"));
}

/// A record with each of its strings that may be any text replaced by markup that is a formula, too.
fn hostile(comparison: &Comparison) -> Comparison {
    fn strings(value: &Value, found: &mut BTreeSet<String>) {
        match value {
            Value::String(text) => drop(found.insert(text.clone())),
            Value::Array(values) => values.iter().for_each(|value| strings(value, found)),
            Value::Object(fields) => fields.values().for_each(|value| strings(value, found)),
            _ => {}
        }
    }
    fn replace(value: &mut Value, old: &str, new: &str) {
        match value {
            Value::String(text) if text == old => *text = new.to_owned(),
            Value::Array(values) => values.iter_mut().for_each(|value| replace(value, old, new)),
            Value::Object(fields) => fields.values_mut().for_each(|value| replace(value, old, new)),
            _ => {}
        }
    }
    let mut value = serde_json::to_value(comparison).unwrap();
    let mut found = BTreeSet::new();
    strings(&value, &mut found);
    for (number, old) in found.iter().enumerate() {
        let mut changed = value.clone();
        replace(&mut changed, old, &format!("=<script>{number}</script>"));
        // What is one of a few words must stay one.
        if serde_json::from_value::<Comparison>(changed.clone()).is_ok() {
            value = changed;
        }
    }
    serde_json::from_value(value).unwrap()
}

#[test]
fn text_of_the_record_is_neither_markup_nor_formula() {
    let comparison = hostile(&sample::full());
    assert!(comparison.scenes[0].path.starts_with("=<script>"));
    let report = Report::new(&comparison);
    let text = report.markdown();
    // Nothing is markup between backticks, of which the strings have none.
    let outside: String = text.split('`').step_by(2).collect();
    assert!(!outside.contains("<script") && text.contains("&lt;script"), "{outside}");
    for table in [report.csv(), report.sampling_csv().unwrap()] {
        assert!(table.contains("'=<script>"));
        assert!(
            table.lines().flat_map(|line| line.split(',')).all(|field| !field.starts_with('='))
        );
    }
    assert!(!report.html(&Pictures::new()).contains("=<script>"));
}

#[test]
fn the_chapter_on_sampling_has_a_verdict() {
    let text = Report::new(&sample::full()).terminal();
    let line = text.lines().last().unwrap();
    assert!(line.starts_with("Sampling: shuffled leaves 0.57"), "{line}");
    assert!(line.contains("× the noise of independent with 16 view samples and 0.5"), "{line}");
    assert!(line.contains("(the median of 2 scenes), and takes 0.2"), "{line}");
    assert!(!Report::new(&sample::partial()).terminal().contains("Sampling"));
}

/// Two manners: srt's formula, or a library as it is shipped.
#[test]
fn every_table_says_of_a_peer_that_it_is_as_shipped() {
    let mut comparison = sample::full();
    let peer = comparison.scenes[0].structures[1].name.clone();
    for scene in &mut comparison.scenes {
        scene.structures[1].peer = true;
        if let Some(proof) = &mut scene.proof {
            proof.structures.retain(|entry| entry.structure != peer);
            for entry in &mut proof.peers {
                entry.structure.clone_from(&peer);
            }
        }
    }
    let report = Report::new(&comparison);
    let (markdown, html) = (report.markdown(), report.html(&Pictures::default()));
    let named = format!("| {peer} (as shipped) |");
    let sections: Vec<&str> = markdown.split("\n### ").collect();
    for title in ["All scenes together", "Rays", "Structures", "Time to the picture"] {
        let of_title: Vec<_> =
            sections.iter().filter(|own| own.starts_with(&format!("{title}\n"))).collect();
        assert!(!of_title.is_empty(), "{title}");
        assert!(of_title.iter().all(|own| own.contains(&named)), "{title}: {of_title:?}");
    }
    for title in ["Proof", "What was compared"] {
        let own = sections.iter().find(|own| own.starts_with(&format!("{title}\n"))).unwrap();
        assert!(own.contains("as shipped: 99.9994 % agree"), "{own}");
    }
    assert!(markdown.contains("the same formula, srt's"), "{markdown}");
    assert!(html.matches("<span class=\"spread\">as shipped</span>").count() > 4);
    assert!(report.terminal().contains("as shipped: 99.9994 % agree"), "{}", report.terminal());
}
