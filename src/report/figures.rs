//! From the analysis to plots.

use super::Report;
use super::numbers::{COUNT, TIME};
use super::plot::{
    Bars, Dot, DotGroup, Ends, Lane, LanePlot, Look, Looks, Plot, XyPlot, XySeries, dot_plot,
    histogram,
};
use crate::analysis::statistics::{BreakEven, Cost};
use crate::analysis::{
    Analysis, ClassFigures, NoiseFigures, Pairing, SceneFigures, StructureFigures, SweepCurve,
    SweepFigures,
};
use crate::record::{Estimate, RayClass, SceneRecord};

/// All plots of a report, with the names of files for them.
pub(super) fn all(report: &Report<'_>) -> Vec<(String, Plot)> {
    let looks = &report.looks();
    let (comparison, analysis) = (report.comparison, &report.analysis);
    let mut plots = Vec::new();
    let mut add = |name: String, plot: Option<Plot>| plots.extend(plot.map(|plot| (name, plot)));
    for (what, plot) in [
        ("rays", speed_by_scene(looks, report)),
        ("builds", builds_by_scene(looks, report)),
        ("memory", memory_by_scene(looks, report)),
    ] {
        add(format!("all-scenes-{what}"), plot);
    }
    for (scene, own) in comparison.scenes.iter().zip(&analysis.scenes) {
        for (what, plot) in [
            ("speedup", speedups(looks, own)),
            ("rates", rates(looks, own)),
            ("leaves", leaves(looks, scene)),
            ("build-and-trace", pareto(looks, own)),
            ("break-even", break_even(looks, own)),
        ] {
            add(format!("{}-{what}", scene.name), plot);
        }
    }
    for sweep in &analysis.sweeps {
        for class in sweep.classes() {
            add(format!("growth-{}-{}", sweep.mesh, class.name()), growth(looks, sweep, class));
        }
    }
    for scene in noise_scenes(analysis) {
        add(format!("{scene}-noise"), noise(analysis, scene));
    }
    plots
}

/// How many times as fast as the base each structure is in each scene: the geometric mean of the classes of rays.
pub(super) fn speed_by_scene(looks: &Looks, report: &Report<'_>) -> Option<Plot> {
    let base = &report.comparison.base;
    let value = |scene: &SceneFigures, structure: &StructureFigures| {
        (scene.base.as_ref() == Some(base)).then(|| scene.mean_speedup(structure)).flatten()
    };
    LanePlot {
        title: format!("All scenes: speed-up over {base}"),
        label: format!("times as fast as {base}, mean of the classes (logarithmic)"),
        units: &[],
        line_at: Some(1.0),
        ..lanes(looks, report, value)?
    }
    .draw()
}

/// The time of each build, on all threads, by scene.
pub(super) fn builds_by_scene(looks: &Looks, report: &Report<'_>) -> Option<Plot> {
    let value = |_: &SceneFigures, own: &StructureFigures| {
        own.build_all_threads_ns.or(own.build_one_thread_ns).map(|estimate| estimate.value)
    };
    LanePlot {
        title: "All scenes: builds".to_owned(),
        label: "build, all threads (logarithmic)".to_owned(),
        units: TIME,
        ..lanes(looks, report, value)?
    }
    .draw()
}

/// The memory of each structure by scene: of the index, and of the primitives in it, which some structures copy.
pub(super) fn memory_by_scene(looks: &Looks, report: &Report<'_>) -> Option<Plot> {
    let value = |scene: &SceneFigures, own: &StructureFigures| {
        let scene = report.comparison.scenes.iter().find(|own| own.name == scene.scene)?;
        let memory = scene.structure(&own.structure)?.memory.as_ref()?;
        let things = scene.objects + scene.stored_triangles;
        (things > 0).then(|| memory.total_bytes() as f64 / things as f64)
    };
    LanePlot {
        title: "All scenes: memory".to_owned(),
        label: "bytes for each object and each triangle in memory (logarithmic)".to_owned(),
        ..lanes(looks, report, value)?
    }
    .draw()
}

/// A row for each scene in which structures have values; nothing for a single one.
fn lanes(
    looks: &Looks,
    report: &Report<'_>,
    value: impl Fn(&SceneFigures, &StructureFigures) -> Option<f64>,
) -> Option<LanePlot> {
    let scenes = &report.analysis.scenes;
    let mut names: Vec<&str> = Vec::new();
    for structure in scenes.iter().flat_map(|scene| &scene.structures) {
        if !names.contains(&structure.structure.as_str()) {
            names.push(&structure.structure);
        }
    }
    let lane = |scene: &SceneFigures| Lane {
        name: scene.scene.clone(),
        values: (0..)
            .zip(&names)
            .filter_map(|(place, name)| Some((place, value(scene, scene.structure(name)?)?)))
            .filter(|(_, value)| value.is_finite() && *value > 0.0)
            .collect(),
    };
    let lanes: Vec<Lane> = scenes.iter().map(lane).filter(|lane| !lane.values.is_empty()).collect();
    (lanes.len() > 1).then(|| LanePlot {
        title: String::new(),
        label: String::new(),
        units: &[],
        line_at: None,
        key: names.iter().map(|name| (looks.get(name), (*name).to_owned())).collect(),
        lanes,
    })
}

/// How many times as fast as the base each structure is, by class.
pub(super) fn speedups(looks: &Looks, scene: &SceneFigures) -> Option<Plot> {
    let base = scene.base.as_deref()?;
    let groups =
        groups(
            looks,
            scene,
            |structure, class| {
                if structure.structure == base { None } else { class.speedup }
            },
        );
    let title = format!("{}: speed-up over {base}", scene.scene);
    let label = format!("times as fast as {base}, per ray, with 95 % intervals (logarithmic)");
    dot_plot(&title, &label, "\u{a0}×", Some(1.0), &groups)
}

/// Millions of rays per second of each structure, by class.
pub(super) fn rates(looks: &Looks, scene: &SceneFigures) -> Option<Plot> {
    let groups = groups(looks, scene, |_, class| class.million_rays_per_second);
    let title = format!("{}: million rays per second", scene.scene);
    let label = "million rays per second, with 95 % intervals (logarithmic)";
    dot_plot(&title, label, "", None, &groups)
}

fn groups(
    looks: &Looks,
    scene: &SceneFigures,
    value: impl Fn(&StructureFigures, &ClassFigures) -> Option<Estimate>,
) -> Vec<DotGroup> {
    let dot = |structure: &StructureFigures, class: RayClass| {
        Some(Dot {
            look: looks.get(&structure.structure),
            name: structure.structure.clone(),
            value: value(structure, structure.class(class)?)
                .filter(Estimate::supports_a_statement)?,
        })
    };
    let group = |class: RayClass| DotGroup {
        name: format!("{} rays", class.name()),
        dots: scene.structures.iter().filter_map(|s| dot(s, class)).collect(),
    };
    scene.classes().into_iter().map(group).collect()
}

/// Build against the mean ray, with the Pareto front.
pub(super) fn pareto(looks: &Looks, scene: &SceneFigures) -> Option<Plot> {
    let with_cost = || scene.structures.iter().filter_map(|s| Some((s, s.cost()?)));
    let place = |cost: Cost| (cost.build_ns, cost.ray_ns);
    let series = with_cost().map(|(structure, cost)| {
        let front = if structure.on_pareto_front { " (front)" } else { "" };
        points(
            looks,
            &structure.structure,
            format!("{}{front}", structure.structure),
            vec![place(cost)],
        )
    });
    let mut front: Vec<(f64, f64)> =
        with_cost().filter(|(s, _)| s.on_pareto_front).map(|(_, cost)| place(cost)).collect();
    front.sort_by(|a, b| a.0.total_cmp(&b.0));
    XyPlot {
        title: format!("{}: build against trace", scene.scene),
        meaning:
            "Each structure's build time and the time of the picture's mean ray, both on one thread. \
                  Less is better in both. The dotted line is the Pareto front: what no other dominates \
                  as far as intervals tell them apart."
                .to_owned(),
        x: Ends::logarithmic("build, one thread (logarithmic)", TIME),
        y: Ends::logarithmic("mean ray of the picture (logarithmic)", TIME),
        series: series.collect(),
        path: stairs(&front),
        rings: Vec::new(),
        ring_meaning: "",
    }
    .draw()
}

/// The corners of stairs through points, each step first to the right, then down.
fn stairs(front: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut corners: Vec<(f64, f64)> = Vec::new();
    for &(x, y) in front {
        if let Some(&(_, last)) = corners.last() {
            corners.push((x, last));
        }
        corners.push((x, y));
    }
    corners
}

/// Build and rays together against the number of rays; rings where a slower build has paid off.
pub(super) fn break_even(looks: &Looks, scene: &SceneFigures) -> Option<Plot> {
    let costs: Vec<_> = scene.structures.iter().filter_map(|s| Some((s, s.cost()?))).collect();
    let base = costs.iter().find(|(s, _)| Some(&s.structure) == scene.base.as_ref())?.1;
    costs.iter().find(|(structure, _)| structure.break_even.is_some())?;
    let meetings: Vec<f64> = costs.iter().filter_map(|(s, _)| rays_of(s.break_even?)).collect();
    let (first, last) =
        meetings.iter().fold((1e3_f64, 1e6_f64), |(a, b), &n| (a.min(n / 10.0), b.max(n * 10.0)));
    let total = |cost: Cost, n: f64| cost.build_ns + n * cost.ray_ns;
    let line = |cost: Cost| {
        let step = (last / first).powf(1.0 / 60.0);
        let at = |i: i32| first * step.powi(i);
        (0..=60).map(|i| (at(i), total(cost, at(i)))).collect()
    };
    let series = costs.iter().map(|(structure, cost)| XySeries {
        look: looks.get(&structure.structure),
        name: structure.structure.clone(),
        // A marker at the end, so that lines do not differ by colour alone.
        points: vec![(last, total(*cost, last))],
        intervals: vec![None],
        line: line(*cost),
        fit: false,
    });
    XyPlot {
        title: format!("{}: when a slower build pays off", scene.scene),
        meaning: "Build and rays together on one thread, against the number of the picture's mean rays. A ring \
                  marks where a structure and the base have taken the same time."
            .to_owned(),
        x: Ends::logarithmic("rays (logarithmic)", COUNT),
        y: Ends::logarithmic("build and rays, one thread (logarithmic)", TIME),
        series: series.collect(),
        path: Vec::new(),
        rings: meetings.iter().map(|&n| (n, total(base, n))).collect(),
        ring_meaning: "the same time as the base",
    }
    .draw()
}

fn rays_of(when: BreakEven) -> Option<f64> {
    match when {
        BreakEven::After { rays } | BreakEven::Until { rays } => Some(rays),
        BreakEven::Always | BreakEven::Never | BreakEven::NotToldApart => None,
    }
}

/// Time of a ray against size, with fitted power laws.
pub(super) fn growth(looks: &Looks, sweep: &SweepFigures, class: RayClass) -> Option<Plot> {
    let curves = sweep.curves.iter().filter(|curve| curve.class == class);
    let is_objects = sweep.unit == "objects";
    let label = if is_objects { "objects (logarithmic)" } else { "triangles (logarithmic)" };
    XyPlot {
        title: format!("{}: {} rays against {}", sweep.mesh, class.name(), sweep.unit),
        meaning: format!(
            "Time of a ray against the number of {}. Dashed lines are power laws.",
            sweep.unit
        ),
        x: Ends::logarithmic(label, COUNT),
        y: Ends::logarithmic("time of a ray (logarithmic)", TIME),
        series: curves.map(|curve| curve_series(looks, curve)).collect(),
        path: Vec::new(),
        rings: Vec::new(),
        ring_meaning: "",
    }
    .draw()
}

fn curve_series(looks: &Looks, curve: &SweepCurve) -> XySeries {
    let supported = || curve.values.iter().filter(|value| value.ns_per_ray.supports_a_statement());
    let sizes = || supported().map(|value| value.triangles as f64);
    let ns = || supported().map(|value| value.ns_per_ray);
    let slope = curve.fit.map(|fit| format!(", slope {:.2}", fit.slope)).unwrap_or_default();
    XySeries {
        look: looks.get(&curve.structure),
        name: format!("{}{slope}", curve.structure),
        points: sizes().zip(ns().map(|estimate| estimate.value)).collect(),
        intervals: ns().map(|estimate| estimate.interval.map(|i| (i.low, i.high))).collect(),
        line: curve.fit.map_or_else(Vec::new, |fit| sizes().map(|n| (n, fit.at(n))).collect()),
        fit: true,
    }
}

fn points(looks: &Looks, structure: &str, name: String, points: Vec<(f64, f64)>) -> XySeries {
    XySeries {
        look: looks.get(structure),
        name,
        intervals: vec![None; points.len()],
        points,
        line: Vec::new(),
        fit: false,
    }
}

/// The scenes whose noise was measured, in the record's order.
pub(super) fn noise_scenes(analysis: &Analysis) -> Vec<&str> {
    let mut scenes: Vec<&str> = analysis.noise.iter().map(|own| own.scene.as_str()).collect();
    scenes.dedup();
    scenes
}

/// Noise against time, a line for each sampling method.
pub(super) fn noise(analysis: &Analysis, scene: &str) -> Option<Plot> {
    let is_measured = |own: &&NoiseFigures| own.pairing == Pairing::EqualSamples;
    let measured = || analysis.noise.iter().filter(is_measured);
    let mut methods: Vec<&str> = Vec::new();
    for own in measured() {
        if !methods.contains(&own.sampling.as_str()) {
            methods.push(&own.sampling);
        }
    }
    let series = methods.into_iter().enumerate().map(|(number, method)| {
        let own = measured().filter(|own| own.scene == scene && own.sampling == method);
        let own: Vec<&NoiseFigures> = own.collect();
        let points: Vec<_> = own.iter().map(|own| (own.ns.value, own.rmse.value)).collect();
        XySeries {
            look: Look::of_series(number),
            name: method.to_owned(),
            intervals: own.iter().map(|own| own.rmse.interval.map(|i| (i.low, i.high))).collect(),
            line: points.clone(),
            points,
            fit: false,
        }
    });
    XyPlot {
        title: format!("{scene}: noise against time"),
        meaning: "The noise of frames with growing numbers of view samples against the time of a \
                  frame on one thread, for each sampling method. Less is better in both."
            .to_owned(),
        x: Ends::logarithmic("processor time of a frame (logarithmic)", TIME),
        y: Ends::logarithmic("RMSE to a converged picture (logarithmic)", &[]),
        series: series.collect(),
        path: Vec::new(),
        rings: Vec::new(),
        ring_meaning: "",
    }
    .draw()
}

/// Leaves by size, of those structures that have more than one.
pub(super) fn leaves(looks: &Looks, scene: &SceneRecord) -> Option<Plot> {
    let bars: Vec<Bars> = scene
        .structures
        .iter()
        .filter_map(|structure| Some((structure, structure.shape.as_ref()?)))
        .filter(|(_, shape)| shape.leaves > 1)
        .map(|(structure, shape)| Bars {
            look: looks.get(&structure.name),
            name: structure.name.clone(),
            counts: shape.leaf_sizes.clone(),
        })
        .collect();
    histogram(&format!("{}: share of leaves by size", scene.name), &bars)
}
