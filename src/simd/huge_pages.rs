//! Large pages for what rays jump about in.

use std::mem::MaybeUninit;

/// Bytes of a large page, on most machines; a multiple of the size of small ones on all.
#[cfg(target_os = "linux")]
const LARGE: usize = 1 << 21;

/// Asks the system for large pages where a table is about to be written, so that fewer addresses
/// are to be translated. What is smaller than such a page, or a system that grants none, stays as
/// it is.
pub(crate) fn ask_for_huge_pages<T>(room: &mut [MaybeUninit<T>]) {
    #[cfg(target_os = "linux")]
    {
        use rustix::mm::{Advice, madvise};
        let room = room.as_mut_ptr_range();
        let (start, end) = (room.start.cast::<u8>(), room.end.addr() / LARGE * LARGE);
        let skipped = start.addr().next_multiple_of(LARGE) - start.addr();
        if start.addr() + skipped >= end {
            return;
        }
        // SAFETY: the bytes from `start + skipped` to `end` lie within the room, which is borrowed
        // to be written; the advice changes in which pages they lie, and nothing that is read.
        let granted = unsafe {
            madvise(start.add(skipped).cast(), end - start.addr() - skipped, Advice::LinuxHugepage)
        };
        // A system without them works as before.
        let _ = granted;
    }
    #[cfg(not(target_os = "linux"))]
    let _ = room;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn room_of_any_size_can_be_asked_for_and_written() {
        for count in [0, 1, 1000, 1 << 20] {
            let mut values: Vec<u64> = Vec::with_capacity(count);
            ask_for_huge_pages(values.spare_capacity_mut());
            values.extend(0..count as u64);
            assert!(values.iter().copied().eq(0..count as u64));
        }
    }
}
