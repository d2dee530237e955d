//! How much memory there is, so that what does not fit is refused with figures before the work, and not
//! by the system in the middle of it.

use std::fmt;
use std::fs;
use std::path::PathBuf;

/// Less than this is not looked into: it takes longer to ask than to make it.
const ALWAYS_FITS: u64 = 256 << 20;

/// Something takes more memory than there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("it takes about {} of memory, and {} is available", Bytes(*needed), Bytes(*available))]
pub struct MemoryShortage {
    /// What it would take, in bytes: an estimate.
    pub needed: u64,
    /// What there was, in bytes.
    pub available: u64,
}

/// Whether so many bytes of memory can be had, as far as the system tells.
///
/// # Errors
/// If there are fewer.
pub fn expect_memory(needed: u64) -> Result<(), MemoryShortage> {
    if needed <= ALWAYS_FITS {
        return Ok(());
    }
    match available_memory() {
        Some(available) if available < needed => Err(MemoryShortage { needed, available }),
        _ => Ok(()),
    }
}

/// The memory that this process may still take, in bytes: the least of what the machine has free, what
/// the control group may use, and what is left of the process's address space (`ulimit -v`). Linux tells;
/// elsewhere it is not known.
#[must_use]
pub fn available_memory() -> Option<u64> {
    [of_machine(), of_control_group(), of_address_space()].into_iter().flatten().min()
}

fn of_machine() -> Option<u64> {
    Some(1024 * number_behind("/proc/meminfo", "MemAvailable:")?)
}

/// Of the group's limit, what it does not use; files that the system holds in memory can be given up.
fn of_control_group() -> Option<u64> {
    let groups = fs::read_to_string("/proc/self/cgroup").ok()?;
    groups.lines().filter_map(left_in_group).min()
}

/// What is left in the group of a line as `0::/a` (version 2) or `4:memory:/a` (version 1).
fn left_in_group(line: &str) -> Option<u64> {
    let mut parts = line.splitn(3, ':').skip(1);
    let (controllers, group) = (parts.next()?, parts.next()?);
    let (root, limit, usage) = match controllers {
        "" => ("/sys/fs/cgroup", "memory.max", "memory.current"),
        _ if controllers.split(',').any(|own| own == "memory") => {
            ("/sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory.usage_in_bytes")
        }
        _ => return None,
    };
    // Within a container its own group is the root.
    let within = PathBuf::from(format!("{root}{group}"));
    let folder = if within.is_dir() { within } else { PathBuf::from(root) };
    let number = |name: &str| fs::read_to_string(folder.join(name)).ok()?.trim().parse().ok();
    let (limit, usage): (u64, u64) = (number(limit)?, number(usage)?);
    let files = number_behind(&folder.join("memory.stat").to_string_lossy(), "inactive_file ");
    Some(limit.saturating_sub(usage.saturating_sub(files.unwrap_or(0))))
}

fn of_address_space() -> Option<u64> {
    let limit = number_behind("/proc/self/limits", "Max address space ")?;
    let taken = number_behind("/proc/self/status", "VmSize:")?;
    Some(limit.saturating_sub(1024 * taken))
}

/// The number that follows some words at the beginning of a line.
fn number_behind(path: &str, words: &str) -> Option<u64> {
    let text = fs::read_to_string(path).ok()?;
    let rest = text.lines().find_map(|line| line.strip_prefix(words))?;
    rest.split_whitespace().next()?.parse().ok()
}

/// Bytes in words: `4.2 GB`.
pub(crate) struct Bytes(pub(crate) u64);

impl fmt::Display for Bytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let megabytes = self.0 as f64 / 1e6;
        if megabytes < 1e3 {
            write!(f, "{megabytes:.0} MB")
        } else {
            write!(f, "{:.1} GB", megabytes / 1e3)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_is_refused_with_figures() {
        assert_eq!(expect_memory(1 << 20), Ok(()));
        let shortage = MemoryShortage { needed: 4_200_000_000, available: 120_000_000 };
        let text = "it takes about 4.2 GB of memory, and 120 MB is available";
        assert_eq!(shortage.to_string(), text);
        if let Some(available) = available_memory() {
            assert!(expect_memory(u64::MAX).is_err_and(|shortage| shortage.needed == u64::MAX));
            assert!(available > 1 << 20);
        }
    }

    #[test]
    fn other_controllers_have_no_memory() {
        assert_eq!(left_in_group("8:pids:/"), None);
        assert_eq!(left_in_group("nonsense"), None);
    }
}
