//! Going on with a comparison that was stopped: what of its record is still true, part by part.

use std::collections::BTreeMap;

use thiserror::Error;

use super::plan::{Plan, SceneInput};
use super::ray_exchange::record_of;
use crate::ray_file::RayFile;
use crate::record::{Comparison, Conformance, Run, SamplingChapter, SceneRecord, Sweep};

/// The name of the study of sampling among the parts that are done.
pub(super) const STUDY: &str = "sampling study";

/// The name of a sweep among the parts that are done.
pub(super) fn sweep_name(mesh: &str) -> String {
    format!("sweep {mesh}")
}

/// Why a record cannot be gone on with.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("it was begun with another {what}: `{before}`, not `{now}`")]
pub struct ResumeError {
    /// What differs.
    what: &'static str,
    before: String,
    now: String,
}

/// Whether a record is of the same comparison, on the same machine, with the same program. `command` makes a command
/// comparable: what may differ is left out of it.
///
/// # Errors
/// If they are not the same: what differs.
pub fn expect_same(
    old: &Run,
    new: &Run,
    command: impl Fn(&str) -> String,
) -> Result<(), ResumeError> {
    let facts = |run: &Run| {
        [
            ("version of srt", run.version.clone()),
            ("commit", run.commit.clone().unwrap_or_default()),
            ("compiler", run.compiler.clone()),
            ("build profile", format!("{} {}", run.profile, run.flags).trim_end().to_owned()),
            ("fingerprint of the sources", run.sources.clone().unwrap_or_default()),
            ("processor", run.machine.cpu.clone()),
            ("instruction set", run.machine.instruction_set.clone()),
            ("number of cores", run.machine.cores.to_string()),
            ("system", run.machine.os.clone()),
            ("number of threads", run.options.threads.to_string()),
            ("command", command(&run.command)),
        ]
    };
    for ((what, before), (_, now)) in facts(old).into_iter().zip(facts(new)) {
        if before != now {
            return Err(ResumeError { what, before, now });
        }
    }
    Ok(())
}

/// What was measured before.
pub(super) struct Before<'a> {
    record: Option<&'a Comparison>,
    replayed: &'a BTreeMap<String, RayFile>,
}

impl<'a> Before<'a> {
    /// What the plan goes on with.
    pub(super) fn of(plan: &'a Plan) -> Self {
        Self { record: plan.resumed.as_ref(), replayed: &plan.replayed }
    }

    /// A scene that is done and has not changed, nor have the rays that are read from a file.
    pub(super) fn scene(&self, input: &SceneInput) -> Option<&'a SceneRecord> {
        let scenes = &self.done(&input.name)?.scenes;
        let is_same = |scene: &&SceneRecord| {
            let file = self.replayed.get(&input.name);
            let rays = scene.rays.as_ref().filter(|rays| rays.replayed);
            scene.name == input.name
                && scene.hash == input.hash
                && file.map(|file| record_of(file, true)).as_ref() == rays
        };
        scenes.iter().find(is_same)
    }

    /// What the check of conformance showed, if it came to its end: of the same structures, since the command is the
    /// same.
    pub(super) fn conformance(&self) -> Option<&'a [Conformance]> {
        let record = self.record.filter(|record| !record.run.done.is_empty())?;
        Some(&record.conformance)
    }

    /// The sweep, if it is done.
    pub(super) fn sweep(&self, mesh: &str) -> Option<&'a Sweep> {
        self.done(&sweep_name(mesh))?.sweeps.iter().find(|sweep| sweep.mesh == mesh)
    }

    /// The study of sampling, if it is done.
    pub(super) fn study(&self) -> Option<&'a SamplingChapter> {
        self.done(STUDY)?.sampling.as_ref()
    }

    /// The record's notes.
    pub(super) fn notes(&self) -> &'a [String] {
        self.record.map_or(&[], |record| &record.notes)
    }

    /// How it was begun.
    pub(super) fn run(&self) -> Option<&'a Run> {
        self.record.map(|record| &record.run)
    }

    /// How many seconds were spent on it.
    pub(super) fn seconds(&self) -> f64 {
        self.record.map_or(0.0, |record| record.run.elapsed_seconds.max(0.0))
    }

    fn done(&self, part: &str) -> Option<&'a Comparison> {
        self.record.filter(|record| record.run.done.iter().any(|own| own == part))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_differs_is_named() {
        let run = |command: &str, cpu: &str| {
            let mut run = Run { command: command.to_owned(), ..Run::default() };
            run.machine.cpu = cpu.to_owned();
            run
        };
        let without = |command: &str| command.replace(" --resume", "");
        let same = |a: &Run, b: &Run| expect_same(a, b, without).map_err(|e| e.to_string());
        let old = run("srt compare a.sce", "x");
        assert_eq!(same(&old, &run("srt compare a.sce --resume", "x")), Ok(()));
        let other = same(&old, &run("srt compare b.sce --resume", "x")).unwrap_err();
        let expected =
            "it was begun with another command: `srt compare a.sce`, not `srt compare b.sce`";
        assert_eq!(other, expected);
        let other = same(&old, &run("srt compare a.sce", "y")).unwrap_err();
        assert_eq!(other, "it was begun with another processor: `x`, not `y`");
        let mut narrow = old.clone();
        narrow.machine.instruction_set = "portable".to_owned();
        assert!(same(&old, &narrow).unwrap_err().contains("another instruction set"));
        let edited = Run { sources: Some("0123".to_owned()), ..old.clone() };
        assert!(same(&old, &edited).unwrap_err().contains("another fingerprint of the sources"));
    }
}
