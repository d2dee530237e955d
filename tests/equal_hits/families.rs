//! Every family of generated scenes, small, in every structure.

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};
use srt::compare::Family;

use crate::for_this_isa;
use crate::scenes::compare;

#[test]
fn scenes_of_every_family() {
    let compared: usize = Family::ALL
        .par_iter()
        .with_max_len(1)
        .map(|family| {
            // Each object may be a mesh of hundreds of triangles.
            let size = if family.unit() == "objects" { 150 } else { 1_500 };
            let scene = family.scene(size, 5).expect("the family can be traced");
            compare(&scene, 5, for_this_isa(1_500))
        })
        .sum();
    println!("{compared} rays compared, 0 differ");
    assert!(compared > for_this_isa(20_000), "only {compared} rays were compared");
}
