//! The JSON of a record → a report in every form.
#![no_main]

use libfuzzer_sys::{fuzz_mutator, fuzz_target};
use srt::report::read_json;

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    srt_fuzz::mutate_json(data, size, max_size, seed)
});

fuzz_target!(|data: &[u8]| {
    let record = read_json(&String::from_utf8_lossy(data));
    match &record {
        Ok(record) => srt_fuzz::check_every_form(record),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
    srt_fuzz::count(record.is_ok());
});
