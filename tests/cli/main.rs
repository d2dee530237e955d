//! The command end to end, as a shell sees it.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

mod animate;
mod arguments;
mod built;
mod check;
mod compare;
mod conformance;
mod diff;
#[cfg(target_os = "linux")]
mod faults;
mod frames;
#[cfg(unix)]
mod interrupt;
mod mesh;
mod meshes_as_scenes;
mod outputs;
mod packs;
mod parts;
mod rays;
#[cfg(unix)]
mod refine;
mod rendering;
mod show;
mod stats;
mod support;
mod tone;
