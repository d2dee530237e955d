//! What was measured, as tables.

use srt::analysis::statistics::median;

use crate::rays::{Class, RaySet};

/// Ratios of all meshes and classes to the first structure.
pub(crate) struct Ratios {
    names: Vec<String>,
    classes: Vec<Class>,
    /// The rows of the mesh at hand.
    rows: Vec<Row>,
    /// Medians: class and, for each structure, the ratio.
    medians: Vec<(Class, Vec<f64>)>,
}

struct Row {
    class: Class,
    rays: usize,
    million_per_second: Vec<f64>,
    ratios: Vec<Spread>,
}

/// A median, and the places below which 10 % and 90 % lie.
struct Spread {
    low: f64,
    median: f64,
    high: f64,
}

impl Ratios {
    pub(crate) fn new(names: &[String], classes: &[Class]) -> Self {
        Self { names: names.to_vec(), classes: classes.to_vec(), rows: vec![], medians: vec![] }
    }

    /// Takes the seconds of each structure in each round.
    pub(crate) fn add(&mut self, set: &RaySet, times: &[Vec<f64>]) {
        let rate =
            |times: &Vec<f64>| set.rays.len() as f64 / 1e6 / median(times).unwrap_or(f64::NAN);
        let ratio = |own: &Vec<f64>| {
            spread(times[0].iter().zip(own).map(|(base, own)| base / own).collect())
        };
        let row = Row {
            class: set.class,
            rays: set.rays.len(),
            million_per_second: times.iter().map(rate).collect(),
            ratios: times.iter().map(ratio).collect(),
        };
        self.medians.push((row.class, row.ratios.iter().map(|ratio| ratio.median).collect()));
        self.rows.push(row);
    }

    /// Prints the mesh at hand, and goes on to the next.
    pub(crate) fn print_mesh(&mut self) {
        println!("| class | rays | structure | million rays/s | × {} | 10–90 % |", self.names[0]);
        println!("|---|--:|---|--:|--:|---|");
        for row in self.rows.drain(..) {
            let figures = row.million_per_second.iter().zip(&row.ratios);
            for (name, (rate, Spread { low, median, high })) in self.names.iter().zip(figures) {
                let class = label(row.class);
                println!(
                    "| {class} | {} | {name} | {rate:.2} | {median:.2} | {low:.2}–{high:.2} |",
                    row.rays
                );
            }
        }
    }

    /// Prints the geometric means over all meshes.
    pub(crate) fn print_means(&self) {
        let classes: Vec<_> = self.classes.iter().map(|&class| label(class)).collect();
        println!("\n## Geometric means over all meshes, × {}\n", self.names[0]);
        println!("| structure | {} | all | smallest |", classes.join(" | "));
        println!("|---|{}", "--:|".repeat(classes.len() + 2));
        for (index, name) in self.names.iter().enumerate() {
            let of = |wanted: Option<Class>| -> Vec<f64> {
                let fits = |class: &Class| wanted.is_none_or(|wanted| wanted == *class);
                let fitting = self.medians.iter().filter(|(class, _)| fits(class));
                fitting.map(|(_, ratios)| ratios[index]).collect()
            };
            let mut cells: Vec<_> =
                self.classes.iter().map(|&class| geometric_mean(&of(Some(class)))).collect();
            cells.push(geometric_mean(&of(None)));
            cells.push(of(None).into_iter().fold(f64::INFINITY, f64::min));
            let cells: Vec<_> = cells.iter().map(|cell| format!("{cell:.2}")).collect();
            println!("| {name} | {} |", cells.join(" | "));
        }
    }
}

fn label(class: Class) -> String {
    format!("{class:?}").to_lowercase()
}

fn geometric_mean(values: &[f64]) -> f64 {
    (values.iter().map(|value| value.ln()).sum::<f64>() / values.len() as f64).exp()
}

fn spread(mut values: Vec<f64>) -> Spread {
    values.sort_unstable_by(f64::total_cmp);
    let at = |q: f64| {
        let place = q * values.len().saturating_sub(1) as f64;
        values.get(place.round() as usize).copied().unwrap_or(f64::NAN)
    };
    Spread { low: at(0.1), median: median(&values).unwrap_or(f64::NAN), high: at(0.9) }
}
