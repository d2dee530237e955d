//! One thread for all: an execution waits for no other, and the same inputs reach the same edges in each run.

/// Makes the thread that calls the only one that rayon works on.
///
/// # Panics
/// If rayon works already.
pub fn work_on_this_thread() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread();
    pool.build_global().expect("the first pool");
}
