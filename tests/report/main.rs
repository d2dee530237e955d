//! Reports of sample records: every form, with the same numbers in all of them.

mod baseline;
mod html;
mod same_numbers;
mod sample;
mod schema;
mod text;
