//! The default command: a scene → a picture. The work is `render`'s; this file reads the scene,
//! puts the options and the scene's own together, shows progress, and writes.

use super::exit::{Exit, Failure, Outcome};
use super::interrupt::Interrupt;
use super::options::{RenderOptions, Stats};
use super::output::{OutputError, print};
use super::pending::{Traced, encode, trace};
use super::render_args::RenderArguments;
use super::report::Report;
use super::terminal::tell;
use super::{source, summary};

/// Renders; a rendering that Ctrl-C ended is written only if the options say so.
pub(super) fn run(arguments: RenderArguments) -> Outcome {
    let options = RenderOptions::new(arguments)?;
    let source = source::read(&options.scene).map_err(Failure::new)?;
    // Until here Ctrl-C ends the process at once, and nothing is lost.
    let interrupt = Interrupt::install().map_err(Failure::new)?;
    let Traced { picture, report } = trace(&source, &options, &interrupt).map_err(Failure::new)?;
    if report.partial && !options.keep_partial {
        tell("interrupted; nothing was written (see --keep-partial)");
        return Ok(Exit::Interrupted);
    }
    let bytes = encode(&picture, options.format).map_err(Failure::new)?;
    options.output.write(|to| to.write_all(&bytes))?;
    conclude(&report, options.stats, options.quiet)
}

/// Tells what it took.
fn conclude(report: &Report, stats: Option<Stats>, quiet: bool) -> Outcome {
    if let Some(stats) = stats {
        print_stats(report, stats)?;
    }
    if !quiet {
        tell(summary::line(report));
    }
    Ok(if report.partial { Exit::Interrupted } else { Exit::Fine })
}

fn print_stats(report: &Report, stats: Stats) -> Result<(), Failure> {
    let json = || report.to_json().map_err(Failure::new);
    match stats {
        Stats::Table => tell(summary::table(report)),
        Stats::Json { to_stderr: true } => tell(json()?.trim_end()),
        Stats::Json { to_stderr: false } => match print(&json()?) {
            // The picture is written; whoever wanted figures has seen enough.
            Ok(()) | Err(OutputError::BrokenPipe) => {}
            Err(error) => return Err(error.into()),
        },
    }
    Ok(())
}
