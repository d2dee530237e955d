//! Reports of sample records: every form, with the same numbers in all of them.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

mod html;
mod sample;
