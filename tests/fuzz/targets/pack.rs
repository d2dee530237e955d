//! A tar archive, whose headers get the right checksums and whose list gets the right hashes → a pack; and lines as the
//! names and contents of files → an archive and back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use sha2::{Digest, Sha256};
use srt::pack::Pack;
use srt_fuzz::{CountingAllocator, peak};

#[global_allocator]
static ALLOCATOR: CountingAllocator = CountingAllocator;

/// What reading may take whatever the size, for messages and buffers.
const ALWAYS: usize = 1 << 16;

/// And for each byte: the archive itself, and the names of its list.
const FOR_EACH_BYTE: usize = 8;

/// The size of a header, and of what contents are filled up to.
const BLOCK: usize = 512;

/// Where a header has its magic word, and its checksum, of six digits.
const MAGIC: usize = 257;
const CHECKSUM: usize = 148;

fuzz_target!(|data: &[u8]| {
    let read = |bytes: &[u8]| {
        let (pack, used) = peak(|| Pack::read(bytes.to_vec()));
        assert!(used <= ALWAYS + FOR_EACH_BYTE * bytes.len(), "{used} bytes for {}", bytes.len());
        pack.map_err(|error| assert!(!error.to_string().is_empty())).ok()
    };
    read(data);
    let mut archive = data.to_vec();
    right(&mut archive);
    let pack = read(&archive);
    srt_fuzz::count(pack.is_some());
    if let Some(pack) = pack {
        let names: Vec<&str> = pack.names().collect();
        assert_eq!(names[0], pack.scene().0);
        assert!(names.iter().all(|name| Pack::is_archive(&archive) && !name.is_empty()));
    }
    files(data);
});

/// Gives headers the checksums of their bytes, and lines that look like those of a list the hashes of the members
/// behind it.
fn right(archive: &mut [u8]) {
    let contents: Vec<usize> = (0..archive.len() / BLOCK)
        .map(|block| block * BLOCK)
        .filter(|&at| archive[at + MAGIC..].starts_with(b"ustar"))
        .collect();
    let size = |archive: &[u8], at: usize| {
        let digits = std::str::from_utf8(&archive[at + 124..at + 135]).unwrap_or_default();
        usize::from_str_radix(digits.trim_end_matches('\0'), 8).unwrap_or(0)
    };
    let of_member = |archive: &[u8], at: usize| {
        let start = at + BLOCK;
        let end = start.saturating_add(size(archive, at)).min(archive.len());
        let hash = Sha256::digest(&archive[start..end]);
        hash.iter().map(|byte| format!("{byte:02x}")).collect::<String>()
    };
    let Some((&list, members)) = contents.split_first() else { return };
    let hashes: Vec<String> = members.iter().map(|&at| of_member(archive, at)).collect();
    let end = (list + BLOCK).saturating_add(size(archive, list)).min(archive.len());
    let mut hashes = hashes.iter();
    for line in archive[list + BLOCK..end].split_mut(|&byte| byte == b'\n') {
        if let Some(own) = line.get_mut(..64)
            && let Some(hash) = hashes.next()
        {
            own.copy_from_slice(hash.as_bytes());
        }
    }
    for &at in &contents {
        let header = &mut archive[at..at + BLOCK];
        header[CHECKSUM..CHECKSUM + 8].fill(b' ');
        let sum: u32 = header.iter().map(|&byte| u32::from(byte)).sum();
        header[CHECKSUM..CHECKSUM + 7].copy_from_slice(format!("{sum:06o}\0").as_bytes());
    }
}

/// What can be written is read as it was.
fn files(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let lines: Vec<&str> = text.split('\n').take(16).collect();
    let files: Vec<(&str, &[u8])> =
        lines.chunks_exact(2).map(|pair| (pair[0], pair[1].as_bytes())).collect();
    let mut bytes = Vec::new();
    if files.is_empty() || Pack::write(&files, &mut bytes).is_err() {
        return;
    }
    let pack = Pack::read(bytes).expect("what was written is read");
    assert!(pack.names().eq(files.iter().map(|file| file.0)));
    assert_eq!(pack.scene(), files[0]);
}
