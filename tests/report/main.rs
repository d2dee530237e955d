//! Reports of sample records: every form, with the same numbers in all of them.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

mod any_values;
mod baseline;
mod html;
mod looks;
mod same_numbers;
mod sample;
mod sampling_numbers;
mod schema;
mod text;
