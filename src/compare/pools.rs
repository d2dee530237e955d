//! The threads of a comparison.

use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

/// One thread, on which rays are timed, and all threads, which build and render.
pub(super) struct Pools {
    pub(super) one: ThreadPool,
    pub(super) all: ThreadPool,
}

impl Pools {
    /// Starts one thread for the first pool and `threads` for the second.
    ///
    /// # Errors
    /// If the system grants fewer: the number of threads that could not be started, and why.
    pub(super) fn start(threads: usize) -> Result<Self, (usize, ThreadPoolBuildError)> {
        Ok(Self { one: pool(1)?, all: pool(threads)? })
    }
}

fn pool(threads: usize) -> Result<ThreadPool, (usize, ThreadPoolBuildError)> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    pool.map_err(|error| (threads, error))
}
