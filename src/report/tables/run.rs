//! How, when and on what was measured, as a list of facts.

use crate::record::{Comparison, Machine, Options, Run};
use crate::report::numbers::{self, NOTHING};

/// Names and values, in the order in which they are shown.
pub(in crate::report) fn facts(comparison: &Comparison) -> Vec<(&'static str, String)> {
    let run = &comparison.run;
    let mut facts = machine(&run.machine);
    facts.extend(program(run));
    facts.extend(options(&run.options));
    facts.extend(plan(run));
    facts
}

fn machine(machine: &Machine) -> Vec<(&'static str, String)> {
    let load = |load: &[f64; 3]| {
        let [one, five, fifteen] = load.map(|x| format!("{x:.2}"));
        format!("{one} / {five} / {fifteen} (1, 5, 15 minutes)")
    };
    vec![
        ("Processor", text(&machine.cpu)),
        ("Cores", machine.cores.to_string()),
        ("Memory", machine.memory_bytes.map_or_else(unknown, numbers::bytes)),
        ("System", text(&machine.os)),
        ("Instruction set", text(&machine.instruction_set)),
        ("Governor", machine.governor.clone().unwrap_or_else(unknown)),
        ("Load at the start", machine.load_at_start.as_ref().map_or_else(unknown, load)),
    ]
}

fn program(run: &Run) -> Vec<(&'static str, String)> {
    vec![
        ("Date", text(&run.date)),
        ("srt", text(&run.version)),
        ("Commit", run.commit.clone().unwrap_or_else(unknown)),
        ("Compiler", text(&run.compiler)),
        ("Profile", text(&run.profile)),
        ("Flags", if run.flags.is_empty() { "none".to_owned() } else { run.flags.clone() }),
    ]
}

fn options(options: &Options) -> Vec<(&'static str, String)> {
    let scene = || "each scene's own".to_owned();
    let size = |[width, height]: [u32; 2]| format!("{width} × {height} pixels");
    let samples = |aa: u32| match aa {
        0 => "one ray through each pixel's centre".to_owned(),
        n => format!("{n} × {n} a pixel"),
    };
    vec![
        ("Size", options.size.map_or_else(scene, size)),
        ("View samples", options.aa.map_or_else(scene, samples)),
        ("Light samples", format!("{0} × {0} a light", options.light_samples)),
        ("Recursion", options.max_recursion.map_or_else(scene, |n| n.to_string())),
        ("Sampling", text(&options.sampling)),
        ("Builds", text(&options.build)),
        ("Threads", format!("{} to render, {} to trace", options.threads, options.trace_threads)),
    ]
}

fn plan(run: &Run) -> Vec<(&'static str, String)> {
    let seconds = |seconds: f64| numbers::time(seconds * 1e9);
    let rule = &run.rounds;
    vec![
        ("Seed", run.seed.to_string()),
        ("Budget", run.budget_seconds.map_or_else(|| "no limit".to_owned(), seconds)),
        ("Time taken", seconds(run.elapsed_seconds)),
        (
            "Rounds",
            format!(
                "{} to warm up, then at least {}, and more until the interval is within ± {}",
                rule.warmup,
                rule.at_least,
                numbers::percent(rule.relative_interval)
            ),
        ),
        ("Between runs", between_runs(run.between_runs)),
    ]
}

fn between_runs(deviation: f64) -> String {
    if deviation > 0.0 {
        format!(
            "a standard deviation of {}, as stated, which all intervals of times include",
            numbers::percent(deviation)
        )
    } else {
        "not included in intervals: they are for this run alone".to_owned()
    }
}

fn text(text: &str) -> String {
    if text.is_empty() { unknown() } else { text.to_owned() }
}

fn unknown() -> String {
    NOTHING.to_owned()
}
