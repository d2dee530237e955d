//! The whole command `srt` with a structure of your own beside the library's: `--accel loose-grid`
//! renders, draws heatmaps and is compared.
//!
//! `cargo run --release --example srt_with_grid -- compare scenes/normals.sce --accel none,bvh,loose-grid`

mod grid;

use std::process::ExitCode;

use srt::accel::Bvh;
use srt::scene::Structure;

fn main() -> ExitCode {
    let grid =
        Structure::new::<Bvh, grid::Grid>("loose-grid", "a grid of loose cells over triangles");
    srt::cli::run_with(&[grid])
}
