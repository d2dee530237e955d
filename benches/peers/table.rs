//! What was measured, as tables.

use srt::analysis::statistics::median;
use srt::compare::measure::RaySet;
use srt::record::RayClass;
use srt::report::{Cell, Table, markdown_table};

/// Ratios of all meshes and classes to the first structure.
pub(crate) struct Ratios {
    names: Vec<String>,
    classes: Vec<RayClass>,
    /// The lines of the current mesh.
    lines: Vec<Line>,
    /// Medians: class and, for each structure, the ratio.
    medians: Vec<(RayClass, Vec<f64>)>,
}

/// A class of the current mesh, with a rate and a ratio for each structure.
struct Line {
    class: RayClass,
    rays: usize,
    million_per_second: Vec<f64>,
    ratios: Vec<Spread>,
}

/// A median, and the values below which 10 % and 90 % lie.
struct Spread {
    low: f64,
    median: f64,
    high: f64,
}

impl Ratios {
    pub(crate) fn new(names: &[String], classes: &[RayClass]) -> Self {
        Self { names: names.to_vec(), classes: classes.to_vec(), lines: vec![], medians: vec![] }
    }

    /// Adds the seconds of each structure in each round.
    pub(crate) fn add(&mut self, set: &RaySet, times: &[Vec<f64>]) {
        let rate =
            |times: &Vec<f64>| set.rays.len() as f64 / 1e6 / median(times).unwrap_or(f64::NAN);
        let ratio = |own: &Vec<f64>| {
            spread(times[0].iter().zip(own).map(|(base, own)| base / own).collect())
        };
        let line = Line {
            class: set.class,
            rays: set.rays.len(),
            million_per_second: times.iter().map(rate).collect(),
            ratios: times.iter().map(ratio).collect(),
        };
        self.medians.push((line.class, line.ratios.iter().map(|ratio| ratio.median).collect()));
        self.lines.push(line);
    }

    /// Prints the current mesh; the next one begins.
    pub(crate) fn print_mesh(&mut self) {
        let ratio = format!("#× {}", self.names[0]);
        let heads = ["class", "#rays", "structure", "#million rays/s", &ratio, "10–90 %"];
        let mut table = Table::new("", "", &heads);
        for line in self.lines.drain(..) {
            let figures = line.million_per_second.iter().zip(&line.ratios);
            for (name, (rate, Spread { low, median, high })) in self.names.iter().zip(figures) {
                let cells = [
                    line.class.name().to_owned(),
                    line.rays.to_string(),
                    name.clone(),
                    format!("{rate:.2}"),
                    format!("{median:.2}"),
                    format!("{low:.2}–{high:.2}"),
                ];
                table.rows.push(cells.map(Cell::text).into());
            }
        }
        print!("{}", markdown_table(&table));
    }

    /// Prints the geometric means over all meshes.
    pub(crate) fn print_means(&self) {
        println!("\n## Geometric means over all meshes, × {}\n", self.names[0]);
        let mut heads = vec!["structure".to_owned()];
        heads.extend(self.classes.iter().map(|class| format!("#{}", class.name())));
        heads.extend(["#all", "#smallest"].map(str::to_owned));
        let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
        let mut table = Table::new("", "", &heads);
        for (index, name) in self.names.iter().enumerate() {
            let of = |wanted: Option<RayClass>| -> Vec<f64> {
                let fits = |class: &RayClass| wanted.is_none_or(|wanted| wanted == *class);
                let fitting = self.medians.iter().filter(|(class, _)| fits(class));
                fitting.map(|(_, ratios)| ratios[index]).collect()
            };
            let mut means: Vec<_> =
                self.classes.iter().map(|&class| geometric_mean(&of(Some(class)))).collect();
            means.push(geometric_mean(&of(None)));
            means.push(of(None).into_iter().fold(f64::INFINITY, f64::min));
            let means = means.iter().map(|mean| Cell::text(format!("{mean:.2}")));
            table.rows.push(std::iter::once(Cell::text(name)).chain(means).collect());
        }
        print!("{}", markdown_table(&table));
    }
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
