//! Reports of sample records: every form, with the same numbers in all of them.

mod html;
mod sample;
