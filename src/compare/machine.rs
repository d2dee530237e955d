//! The machine and the build, as far as the system describes them: Linux names most, elsewhere
//! fields stay absent.

use std::fs;

use crate::record::{Machine, Run};
use crate::simd::Isa;

use super::commit::commit;

/// What is known of the machine now.
#[must_use]
pub fn machine() -> Machine {
    Machine {
        cpu: processor().unwrap_or_else(|| std::env::consts::ARCH.to_owned()),
        cores: std::thread::available_parallelism()
            .map_or(1, |n| u32::try_from(n.get()).unwrap_or(u32::MAX)),
        memory_bytes: kibibytes("/proc/meminfo", "MemTotal:"),
        os: system(),
        instruction_set: instruction_set(),
        governor: text("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor"),
        load_at_start: load(),
    }
}

/// What will disturb measurements on this machine now, as far as the system tells: a sentence each, to be said before
/// they begin.
#[must_use]
pub fn disturbances() -> Vec<String> {
    disturbances_of(&machine())
}

fn disturbances_of(machine: &Machine) -> Vec<String> {
    let load = machine.load_at_start.map(|load| load[0]);
    let busy = load.filter(|load| *load > f64::from(machine.cores)).map(|load| {
        format!(
            "warning: the machine is busy: its load is {load:.1}, on {} cores; times will be less reliable",
            machine.cores
        )
    });
    let governor = machine.governor.as_deref();
    let saving = governor.filter(|name| ["powersave", "conservative"].contains(name));
    let saving = saving.map(|name| {
        format!(
            "warning: the governor of the clock frequency is `{name}`, which saves power: frequencies may change \
             between rounds"
        )
    });
    busy.into_iter().chain(saving).collect()
}

/// How this program was built; the rest of the run is still to be filled in.
pub(super) fn build_of_program() -> Run {
    let noted = |value: Option<&str>| value.unwrap_or_default().to_owned();
    Run {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        commit: commit(),
        sources: option_env!("SRT_SOURCES").map(str::to_owned),
        compiler: noted(option_env!("SRT_COMPILER")),
        profile: noted(option_env!("SRT_PROFILE")),
        flags: noted(option_env!("SRT_FLAGS")),
        machine: machine(),
        ..Run::default()
    }
}

/// The most memory that the process had resident since [`forget_peak`].
pub(super) fn peak_resident_bytes() -> Option<u64> {
    kibibytes("/proc/self/status", "VmHWM:")
}

/// Starts the peak anew; false where the system does not.
pub(super) fn forget_peak() -> bool {
    fs::write("/proc/self/clear_refs", "5").is_ok()
}

/// What the kernels of `bvh8` run with, chosen as the program starts, and what everything else was
/// compiled for.
fn instruction_set() -> String {
    let kernels = Isa::chosen().map_or("unknown", Isa::name);
    format!("{kernels} in the kernels of bvh8, {} elsewhere", compiled_instruction_set())
}

/// The widest of the instruction sets that the program was compiled for.
fn compiled_instruction_set() -> String {
    let compiled = option_env!("SRT_FEATURES").unwrap_or_default();
    let has = |feature: &&str| compiled.split(',').any(|compiled| compiled == *feature);
    let widest = ["avx512f", "avx2", "avx", "sse4.2", "sse2", "neon"].into_iter().find(has);
    match widest {
        Some(name @ ("sse2" | "neon")) => format!("{name} (portable)"),
        Some(name) => name.to_owned(),
        None => "scalar".to_owned(),
    }
}

/// The processor's name, and its family and model: virtual machines leave out of the name which one it is.
fn processor() -> Option<String> {
    let text = text("/proc/cpuinfo")?;
    let field = |word| value_in(&text, word).map(|text| text.trim_start_matches([':', ' ', '\t']));
    let name = field("model name")?;
    let model = field("cpu family").zip(field("model\t"));
    Some(match model {
        Some((family, model)) => format!("{name} (family {family}, model {model})"),
        None => name.to_owned(),
    })
}

fn system() -> String {
    let kernel = text("/proc/sys/kernel/osrelease").unwrap_or_default();
    let name =
        value("/etc/os-release", "PRETTY_NAME=").map(|name| name.trim_matches('"').to_owned());
    let parts = [std::env::consts::OS, &kernel];
    let system = parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ");
    name.map_or(system.clone(), |name| format!("{name}, {system}"))
}

fn load() -> Option<[f64; 3]> {
    let text = text("/proc/loadavg")?;
    let mut numbers = text.split_whitespace().map_while(|word| word.parse().ok());
    Some([numbers.next()?, numbers.next()?, numbers.next()?])
}

/// A small file's text; `None` if there is none.
fn text(path: &str) -> Option<String> {
    let text = fs::read_to_string(path).ok()?;
    let text = text.trim();
    (!text.is_empty()).then(|| text.to_owned())
}

/// What follows a word at the beginning of a line of a file.
fn value(path: &str, word: &str) -> Option<String> {
    value_in(&text(path)?, word).map(str::to_owned)
}

/// What follows a word at the beginning of a line.
fn value_in<'a>(text: &'a str, word: &str) -> Option<&'a str> {
    text.lines().find_map(|line| line.strip_prefix(word)).map(str::trim)
}

/// A line such as `MemTotal:  24000000 kB`, in bytes.
fn kibibytes(path: &str, word: &str) -> Option<u64> {
    let value = value(path, word)?;
    Some(1024 * value.split_whitespace().next()?.parse::<u64>().ok()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_load_above_the_cores_and_a_saving_governor_are_told() {
        let machine = |load, governor: &str| Machine {
            cores: 2,
            load_at_start: Some([load, 0.0, 0.0]),
            governor: Some(governor.to_owned()),
            ..Machine::default()
        };
        assert_eq!(disturbances_of(&machine(1.9, "performance")), [""; 0]);
        let told = disturbances_of(&machine(4.26, "powersave"));
        assert!(told[0].contains("its load is 4.3, on 2 cores"), "{told:?}");
        assert!(told[1].contains("`powersave`"), "{told:?}");
        assert_eq!(disturbances_of(&Machine::default()), [""; 0]);
    }

    #[test]
    fn the_machine_has_a_processor_and_the_build_a_version() {
        let run = build_of_program();
        assert!(run.machine.cores >= 1);
        assert!(!run.machine.cpu.is_empty() && !run.machine.os.is_empty());
        assert_eq!(run.version, env!("CARGO_PKG_VERSION"));
        assert!(run.compiler.starts_with("rustc"), "{}", run.compiler);
    }
}
