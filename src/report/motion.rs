//! The record of a scene that moves → text, Markdown, CSV, JSON and a page.

mod page;

use std::fmt::Write;

use serde::Serialize;

use super::numbers::{self, NOTHING};
use super::tables::{Cell, Table};
use super::{markdown_table, terminal_table};
use crate::analysis::motion::{StrategyFigures, motion_figures};
use crate::analysis::statistics::BreakEven;
use crate::record::{FramePicture, Motion, StrategyRecord};

/// A record and what follows from it, ready to be written in every form.
#[derive(Clone, Debug)]
pub struct MotionReport<'a> {
    motion: &'a Motion,
    figures: Vec<StrategyFigures>,
}

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    motion: &'a Motion,
    derived: &'a [StrategyFigures],
}

impl<'a> MotionReport<'a> {
    /// Analyses a record.
    #[must_use]
    pub fn new(motion: &'a Motion) -> Self {
        Self { motion, figures: motion_figures(motion) }
    }

    /// The record's own fields and, in `derived`, what follows from them.
    ///
    /// # Errors
    /// None that a record can cause.
    pub fn json(&self) -> Result<String, serde_json::Error> {
        let document = Document { motion: self.motion, derived: &self.figures };
        Ok(super::json::pretty(&serde_json::to_string(&document)?) + "\n")
    }

    /// A line for each structure, strategy and frame that was measured: nanoseconds of the update, and of the rays of
    /// each class.
    #[must_use]
    pub fn csv(&self) -> String {
        let classes = self.motion.rays.iter().map(|rays| rays.class.name());
        let heads: String =
            classes.map(|class| format!(",{class}_rays,{class}_trace_ns")).collect();
        let mut text = format!("structure,strategy,frame,update_ns{heads}\n");
        for own in &self.motion.strategies {
            for (place, update) in own.updates.iter().enumerate() {
                let frame = self.motion.frames[0] as usize + 1 + place;
                let name = quoted(&own.structure);
                let _ = write!(text, "{name},{},{frame},{}", own.strategy.name(), update.own_ns());
                for (rays, times) in self.motion.rays.iter().zip(&own.trace_ns) {
                    let of = |list: &[u64]| list.get(place).copied().unwrap_or_default();
                    let _ = write!(text, ",{},{}", of(&rays.rays), of(times));
                }
                text.push('\n');
            }
        }
        text
    }

    /// A Markdown page.
    #[must_use]
    pub fn markdown(&self) -> String {
        let table = markdown_table(&self.table());
        let lines = self.lines().join("\n\n");
        format!("# srt animates\n\n{}\n\n{table}\n{lines}\n", self.headline())
    }

    /// A self-contained HTML page: the pictures as a flip-book, the table, and the times frame by frame.
    #[must_use]
    pub fn html(&self, pictures: &[FramePicture]) -> String {
        page::write(self, pictures)
    }

    /// Text for a terminal.
    #[must_use]
    pub fn terminal(&self) -> String {
        let table = terminal_table(&self.table());
        format!("{}\n\n{table}\n{}\n", self.headline(), self.lines().join("\n"))
    }

    /// What moved.
    fn headline(&self) -> String {
        let Motion { scene, frames: [first, last], objects, triangles, moved, .. } = self.motion;
        let measured = moved.len() as u32;
        let mean = |of: fn(&crate::record::Moved) -> u64| {
            moved.iter().map(of).sum::<u64>() / u64::from(measured.max(1))
        };
        let some = |n: u64, thing: &str| {
            format!("{} {thing}{}", numbers::count(n), if n == 1 { "" } else { "s" })
        };
        let frames = match measured {
            0 => "no frame measured".to_owned(),
            n => format!("frames {} to {}", first + 1, first + n),
        };
        let partial = if self.motion.run.partial {
            format!(" (stopped; {last} was to be the last)")
        } else {
            String::new()
        };
        format!(
            "{scene}, {frames}{partial}, built for frame {first}: {} and {}; in a frame {} and {} move",
            some(*objects, "object"),
            some(*triangles, "triangle"),
            some(mean(|moved| moved.objects), "object"),
            some(mean(|moved| moved.triangles), "triangle"),
        )
    }

    /// A row for each structure and strategy.
    fn table(&self) -> Table {
        let mut heads = vec!["structure".to_owned(), "strategy".to_owned()];
        heads.extend(["#update", "#quartiles"].map(str::to_owned));
        let classes = self.motion.rays.iter();
        heads.extend(classes.map(|rays| format!("#{}, ns/ray", rays.class.name())));
        heads.extend(["#SAH", "#total", "less time than a rebuild", "proof"].map(str::to_owned));
        let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
        let mut table = Table::new("", "", &heads);
        let rows = self.motion.strategies.iter().zip(&self.figures);
        table.rows = rows.map(|(record, figures)| row(record, figures)).collect();
        table
    }

    /// What else there is to say: what is proved, with what it was measured, and how to read it.
    fn lines(&self) -> Vec<String> {
        let run = &self.motion.run;
        let machine = &run.machine;
        let mut lines = vec![
            self.proof(),
            format!(
                "on {}, {} cores, {}; updates on {}, rays on one, the median of {}, interleaved",
                machine.cpu,
                machine.cores,
                machine.instruction_set,
                numbers::things(u64::from(run.options.threads), "thread"),
                numbers::things(u64::from(run.rounds.at_least), "round"),
            ),
            "update: median over the frames; ns/ray: mean over the frames; SAH: cost of the trees in the last frame as a \
             share of that of a rebuild; total: updates and recorded rays of all frames"
                .to_owned(),
        ];
        for own in self.motion.strategies.iter().filter(|own| own.rebuilt > 0) {
            lines.push(format!(
                "{} with {} had to be built anew in {} of {} frames: what was there was not what moved",
                own.structure,
                own.strategy.name(),
                own.rebuilt,
                own.updates.len(),
            ));
        }
        lines
    }

    /// How much was compared.
    fn proof(&self) -> String {
        let Motion { strategies, compared_with_none, differ_from_none, moved, .. } = self.motion;
        let frames = numbers::things(moved.len() as u64, "frame");
        let Some(first) = strategies.first() else { return "nothing was compared".to_owned() };
        let rays = numbers::count(first.compared);
        let differing: u64 = strategies.iter().map(|own| own.differing).sum();
        let name = format!("{} with {}", first.structure, first.strategy.name());
        let none = match (*compared_with_none, *differ_from_none) {
            (0, _) => {
                "none of these rays was compared with `none`: it would take too long".to_owned()
            }
            (compared, 0) => {
                format!("no difference from `none` in {} of them", numbers::count(compared))
            }
            (compared, differ) => {
                format!(
                    "{} of {} of them DIFFER from `none`",
                    numbers::count(differ),
                    numbers::count(compared)
                )
            }
        };
        match differing {
            0 => format!("no difference from {name} in {rays} rays over {frames}; {none}"),
            n => format!(
                "{} answers DIFFER from {name}, of {rays} rays over {frames}; {none}",
                numbers::count(n)
            ),
        }
    }

    /// Whether no answer differs.
    #[must_use]
    pub fn holds(&self) -> bool {
        let equal = self.motion.strategies.iter().all(|own| own.differing == 0);
        equal && self.motion.differ_from_none == 0
    }
}

fn row(record: &StrategyRecord, figures: &StrategyFigures) -> Vec<Cell> {
    let or_dash = |text: Option<String>| Cell::text(text.unwrap_or_else(|| NOTHING.to_owned()));
    let mut row = vec![
        Cell::text(record.structure.clone()),
        Cell::text(record.strategy.name()),
        or_dash(figures.update_ns.map(numbers::time)),
        or_dash(
            figures
                .quartiles_ns
                .map(|[low, high]| format!("{} – {}", numbers::time(low), numbers::time(high))),
        ),
    ];
    row.extend(figures.ray_ns.iter().map(|(_, ns)| or_dash(ns.map(numbers::figures))));
    row.push(or_dash(figures.sah_share.map(|share| format!("{share:.2}"))));
    row.push(Cell::text(numbers::time(figures.total_ns)));
    row.push(or_dash(figures.break_even.map(break_even_in_words)));
    row.push(Cell::text(if record.differing == 0 { "equal" } else { "DIFFERS" }));
    row
}

fn break_even_in_words(point: BreakEven) -> String {
    match point {
        BreakEven::Always => "always".to_owned(),
        BreakEven::Never => "never".to_owned(),
        BreakEven::NotToldApart => "not told apart".to_owned(),
        BreakEven::After { rays } => format!("from {} rays a frame on", numbers::about(rays)),
        BreakEven::Until { rays } => format!("up to {} rays a frame", numbers::about(rays)),
    }
}

/// A field of a CSV line.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{MotionRays, Moved, RayClass, Round, Strategy};

    fn motion() -> Motion {
        let record = |structure: &str, strategy, update, trace| StrategyRecord {
            structure: structure.to_owned(),
            strategy,
            updates: vec![Round { wall_ns: update, ..Round::default() }; 4],
            trace_ns: vec![vec![trace; 4]],
            sah_costs: [Some(trace as f64), None],
            rebuilt: 0,
            compared: 4_000,
            differing: 0,
        };
        let mut motion = Motion {
            scene: "a.sce".to_owned(),
            frames: [5, 9],
            objects: 3,
            triangles: 24_000,
            moved: vec![Moved { objects: 1, triangles: 24_000, is_same_scene: true }; 4],
            rays: vec![MotionRays { class: RayClass::View, rays: vec![1_000; 4] }],
            strategies: vec![
                record("bvh8", Strategy::Rebuild, 9_000_000, 100_000),
                record("bvh8:leaf=4,builder=sah", Strategy::Refit, 1_000_000, 120_000),
            ],
            compared_with_none: 400,
            ..Motion::default()
        };
        motion.strategies[1].structure = "bvh8".to_owned();
        motion
    }

    #[test]
    fn the_table_has_what_a_frame_costs_and_where_the_strategies_break_even() {
        let motion = motion();
        let report = MotionReport::new(&motion);
        let text = report.terminal();
        for part in [
            "a.sce, frames 6 to 9, built for frame 5: 3 objects and 24.0 k triangles; in a frame 1 object and",
            "9.00",
            "120",
            "1.20",
            "up to",
            "no difference from bvh8 with rebuild in 4.00",
            "over 4\u{a0}frames; no difference from `none` in 400 of them",
        ] {
            let plain = |text: &str| text.replace(['\u{a0}', '\u{202f}'], " ");
            assert!(plain(&text).contains(&plain(part)), "{part}: {text}");
        }
        assert!(report.holds());
        assert!(report.markdown().contains("| structure | strategy |"));
        let csv = report.csv();
        assert_eq!(csv.lines().count(), 9);
        assert!(csv.contains("bvh8,refit,9,1000000,1000,120000\n"), "{csv}");
        let json: serde_json::Value = serde_json::from_str(&report.json().unwrap()).unwrap();
        assert_eq!(json["derived"][1]["break_even"]["when"], "until");
        assert_eq!(serde_json::from_value::<Motion>(json).unwrap(), motion);
    }

    #[test]
    fn a_difference_is_said() {
        let mut motion = motion();
        motion.strategies[1].differing = 7;
        motion.differ_from_none = 2;
        let report = MotionReport::new(&motion);
        assert!(!report.holds());
        let text = report.terminal();
        assert!(text.contains("7 answers DIFFER") && text.contains("DIFFERS"), "{text}");
        assert!(text.contains("2 of 400 of them DIFFER from `none`"), "{text}");
    }
}
