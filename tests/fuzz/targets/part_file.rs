//! The contents of a file of parts, to which the right hash is added → parts, and a film of them.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sha2::{Digest, Sha256};
use srt::film::Film;
use srt::part_file::PartFile;
use srt_fuzz::{CountingAllocator, peak};

#[global_allocator]
static ALLOCATOR: CountingAllocator = CountingAllocator;

/// What reading may take whatever the size, for messages.
const ALWAYS: usize = 1 << 16;

/// And for each byte: an entry of the table is larger in memory than in the file.
const FOR_EACH_BYTE: usize = 6;

/// A larger picture is not put together: it takes time, and no more of the program.
const MOST_PIXELS: u64 = 1 << 16;

fuzz_target!(|data: &[u8]| {
    // As they are: without a right hash nothing is read.
    if let Ok(file) = PartFile::decode(data) {
        assert_eq!(written(&file), data);
    }
    let mut bytes = data.to_vec();
    bytes.extend(Sha256::digest(data));
    let (decoded, used) = peak(|| PartFile::decode(&bytes));
    assert!(used <= ALWAYS + FOR_EACH_BYTE * bytes.len(), "{used} bytes for {}", bytes.len());
    srt_fuzz::count(decoded.is_ok());
    match decoded {
        Ok(file) => check(file, &bytes),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
});

/// It is written as it was read; a film takes each part or says why not, and has as many samples as it took.
fn check(file: PartFile, bytes: &[u8]) {
    assert_eq!(written(&file), bytes);
    assert_eq!(file.origin.difference(&file.origin), None);
    let settings = &file.origin.settings;
    if settings.region().pixels() > MOST_PIXELS {
        return;
    }
    let film = Film::new(settings.region(), settings.film_samples());
    for part in file.parts {
        let before = film.coverage();
        match film.take(part) {
            Ok(()) => assert!(film.coverage().samples >= before.samples),
            Err(error) => {
                assert!(!error.to_string().is_empty());
                assert_eq!(film.coverage(), before);
            }
        }
    }
    assert!(film.coverage().samples <= film.coverage().all_samples);
}

fn written(file: &PartFile) -> Vec<u8> {
    let mut bytes = Vec::new();
    file.write(&mut bytes).expect("memory takes all bytes");
    assert_eq!(bytes.len() as u64, file.length());
    bytes
}
