//! The contents of a file of rays, to which the right hash is added → rays; the same bytes as rays of other programs.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sha2::{Digest, Sha256};
use srt::ray_file::{RayFile, rodent, tinybvh};
use srt_fuzz::{CountingAllocator, peak};

#[global_allocator]
static ALLOCATOR: CountingAllocator = CountingAllocator;

/// What reading may take whatever the size, for messages.
const ALWAYS: usize = 1 << 16;

/// And for each byte: a class may be read into a vector that grew, answers as well as rays.
const FOR_EACH_BYTE: usize = 4;

fuzz_target!(|data: &[u8]| {
    // As they are: without a right hash nothing is read.
    if let Ok(file) = RayFile::decode(data) {
        assert_eq!(file.encode(), data);
    }
    let mut bytes = data.to_vec();
    bytes.extend(Sha256::digest(data));
    let (decoded, used) = peak(|| RayFile::decode(&bytes));
    assert!(used <= ALWAYS + FOR_EACH_BYTE * bytes.len(), "{used} bytes for {}", bytes.len());
    match &decoded {
        Ok(file) => check_file(file, &bytes),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
    srt_fuzz::count(decoded.is_ok());
    check_others(data);
});

/// It is written as it was read, so its hash is that of its rays; each ray is in range and has an answer.
fn check_file(file: &RayFile, bytes: &[u8]) {
    for class in &file.classes {
        assert_eq!(class.rays.len(), class.answers.len());
        assert!(class.rays.iter().all(|ray| ray.check().is_ok()));
    }
    assert_eq!(file.encode(), bytes);
}

/// Rays of other programs are in range, and the same when they are written and read again.
fn check_others(data: &[u8]) {
    let interval = [0.0, 100.0];
    if let Ok(rays) = rodent::decode(data, interval) {
        assert!(rays.iter().all(|ray| ray.check().is_ok()));
        let (bytes, _) = rodent::encode(&rays).expect("all have one interval");
        assert_eq!(bytes, data);
    }
    if let Ok(rays) = tinybvh::decode(data) {
        assert!(rays.iter().all(|ray| ray.check().is_ok()));
        let bytes = tinybvh::encode(&rays).expect("all begin at their origins");
        assert_eq!(tinybvh::decode(&bytes), Ok(rays));
    }
}
