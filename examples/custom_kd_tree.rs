//! A space partition of your own, from outside the crate: a kd-tree (`kd_tree/mod.rs`), checked
//! against no structure at all, and measured beside the library's structures by the command:
//!
//! ```sh
//! cargo run --release --example custom_kd_tree -- compare scenes/normals.sce --accel none,bvh,kd-tree
//! ```
//!
//! Without arguments it checks the kd-tree, and two that each break a rule for cells: of these the
//! first ray that loses its hit is printed.

#![allow(clippy::print_stdout, reason = "an example prints what it finds")]

mod kd_tree;

use std::process::ExitCode;

use srt::conformance::check;
use srt::scene::Structure;

use kd_tree::KdTree;

fn main() -> ExitCode {
    if std::env::args().len() > 1 {
        let structure = Structure::new::<KdTree, KdTree>("kd-tree", "cells cut in two by planes");
        return srt::cli::run_with(&[structure]);
    }
    for (name, result) in [
        ("kd-tree", check::<KdTree>()),
        ("planes without the padding", check::<KdTree<false, false>>()),
        ("an end in the first cell with a hit", check::<KdTree<true, true>>()),
    ] {
        match result {
            Ok(summary) => println!("{name}: {summary}"),
            Err(difference) => println!("{name}: {difference}"),
        }
    }
    ExitCode::SUCCESS
}
