//! Asking the caches for what will be read soon.

/// Bytes of a cache line.
#[cfg(target_arch = "x86_64")]
const LINE: usize = 64;

/// The cache of a core that memory is asked into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cache {
    /// The first: for what is read next.
    First,
    /// The second, which can wait for more lines of memory at a time than the first: for what is read after much else.
    Second,
}

/// Loads the cache lines of a value ahead of their use: that of its first byte, and of each byte that is a multiple of
/// a line's length behind it. So of a value that does not begin where a line does, the last line may be left out.
/// Does nothing where the processor has no such instruction.
#[inline(always)]
pub(crate) fn prefetch<T>(value: &T, into: Cache) {
    #[cfg(target_arch = "x86_64")]
    {
        use std::arch::x86_64::{_MM_HINT_T0, _MM_HINT_T1, _mm_prefetch};
        let start = std::ptr::from_ref(value).cast::<i8>();
        let mut offset = 0;
        while offset < size_of::<T>() {
            // SAFETY: every x86-64 processor has the instruction; the address lies within the value.
            unsafe {
                match into {
                    Cache::First => _mm_prefetch::<_MM_HINT_T0>(start.add(offset)),
                    Cache::Second => _mm_prefetch::<_MM_HINT_T1>(start.add(offset)),
                }
            }
            offset += LINE;
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (value, into);
}
