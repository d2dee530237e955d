//! `srt conformance`: whether structures give equal hits. What is compared, and how, is for
//! [`conformance`](crate::conformance) to say.

use std::io::IsTerminal;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::compare_args::ConformanceArguments;
use super::exit::{CommandResult, Exit};
use super::interrupt::Interrupt;
use super::output::print;
use super::terminal::print_error;
use crate::compare::catch_panic;
use crate::conformance::Limits;
use crate::scene::Structure;

const TEMPLATE: &str = "{bar:32} {percent:>3} %  {msg}";

/// Checks every structure, also after one that fails; the worst decides how the command ends. A signal
/// ends it with what is known.
pub(super) fn run(arguments: &ConformanceArguments, interrupt: &Interrupt) -> CommandResult {
    let mut worst = Exit::Fine;
    for structure in arguments.structures() {
        let (exit, text) = interrupt.cancellable(|| check(&structure, arguments, interrupt));
        match exit {
            Exit::Trouble => print_error(text),
            Exit::Fine | Exit::Interrupted(_) if arguments.quiet => {}
            _ => print(&format!("{}: {text}\n", structure.name))?,
        }
        if exit.code() > worst.code() {
            worst = exit;
        }
        if exit == interrupt.exit() {
            break;
        }
    }
    Ok(worst)
}

/// What one structure came to, and that in words.
fn check(
    structure: &Structure,
    arguments: &ConformanceArguments,
    interrupt: &Interrupt,
) -> (Exit, String) {
    let bar = bar(structure.name, arguments.quiet);
    let progress = |done: usize, of: usize| {
        bar.set_length(of as u64);
        bar.set_position(done as u64);
    };
    let cancelled = || interrupt.is_requested();
    let limits = Limits { time: arguments.budget, cancelled: &cancelled, progress: &progress };
    let checked = catch_panic(|| structure.check(&limits));
    bar.finish_and_clear();
    match checked {
        Ok(Some(Ok(summary))) if interrupt.is_requested() => {
            (interrupt.exit(), summary.to_string())
        }
        Ok(Some(Ok(summary))) => (Exit::Fine, summary.to_string()),
        Ok(Some(Err(difference))) => (Exit::Negative, difference.to_string()),
        Err(message) => (Exit::Negative, message),
        Ok(None) => (
            Exit::Trouble,
            format!(
                "`{}` is another program's: its hits need not be equal; `srt compare` says how \
                 many agree",
                structure.name
            ),
        ),
    }
}

/// Nothing is shown if `quiet` or if standard error is no terminal.
fn bar(name: &'static str, quiet: bool) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
    if !quiet && std::io::stderr().is_terminal() {
        let style =
            ProgressStyle::with_template(TEMPLATE).unwrap_or_else(|_| ProgressStyle::default_bar());
        bar.set_draw_target(ProgressDrawTarget::stderr());
        bar.set_style(style.progress_chars("█▉▊▋▌▍▎▏ "));
        bar.set_message(name);
    }
    bar
}

#[cfg(test)]
mod tests {
    use std::ops::{ControlFlow, Range};

    use super::super::structures::StructureList;
    use super::*;
    use crate::accel::{Accel, Bounded, Build, Built, Exhaustive};
    use crate::counters::Counters;
    use crate::math::{BoxRay, Ray};

    /// Loses the last primitive, or panics.
    struct Wrong<const PANICS: bool>(u32);

    impl<const PANICS: bool> Accel for Wrong<PANICS> {
        fn build(primitives: &impl Bounded, _: &mut Build<'_>) -> Built<Self> {
            assert!(!PANICS, "out of luck");
            Built { accel: Self(primitives.count().saturating_sub(1)), order: None }
        }

        fn traverse<C: Counters>(
            &self,
            _: &Ray,
            _: &BoxRay,
            counters: &mut C,
            mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
        ) {
            let _ = leaf(0..self.0, counters);
        }

        fn bytes(&self) -> u64 {
            0
        }
    }

    #[test]
    fn what_is_wrong_is_told_and_ends_with_1() {
        let losing = Structure::new::<Exhaustive, Wrong<false>>("losing", "loses a triangle");
        let arguments = |accel| ConformanceArguments { accel, budget: None, quiet: true };
        let (none, free) = (arguments(vec![]), Interrupt::default());
        let (exit, text) = check(&losing, &none, &free);
        assert_eq!(exit, Exit::Negative);
        assert!(text.starts_with("mesh `") && text.contains("` times 1e0"), "{text}");
        assert!(text.contains("\n  expected Hit"), "{text}");
        let panicking = Structure::new::<Exhaustive, Wrong<true>>("panicking", "panics");
        let expected =
            "it panicked: mesh `lattice` times 1e0 plus [0, 0, 0], built `fastest`: out of luck";
        assert_eq!(check(&panicking, &none, &free).1, expected);
        let accel = vec![StructureList(vec![panicking, losing])];
        let exit = run(&arguments(accel), &free).unwrap();
        assert_eq!(exit, Exit::Negative);
    }

    #[test]
    fn the_template_is_valid() {
        assert!(ProgressStyle::with_template(TEMPLATE).is_ok());
    }
}
