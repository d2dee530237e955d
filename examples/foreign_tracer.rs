//! The whole command `srt` with another program's library beside the structures (`brute_force/`):
//! its own formula, its own index, rays in and hits out. It renders, and is compared as a peer.
//!
//! `cargo run --release --example foreign_tracer -- compare scenes/paper-boats.sce --accel bvh,brute`

mod brute_force;

use std::process::ExitCode;

use srt::scene::Structure;

fn main() -> ExitCode {
    let brute = Structure::foreign::<brute_force::BruteForce>("brute", "a list, tested in doubles");
    srt::cli::run_with(&[brute])
}
