//! What the fuzz targets of srt share. A target is a file in `targets/`; `docs/fuzzing.md` describes them.

mod checksums;
mod csv;
mod depth;
mod floats;
mod html;
mod json;
mod lines;
mod markdown;
mod memory;
mod reports;
pub mod small_scene;
mod threads;

pub use checksums::right_checksums;
pub use depth::{count, is_one_of};
pub use floats::mutate as mutate_floats;
pub use json::mutate as mutate_json;
pub use lines::mutate as mutate_lines;
pub use memory::{CountingAllocator, peak};
pub use reports::check_every_form;
pub use threads::work_on_this_thread;
