//! The table of structures: a new one is a file in `accel/` and a line here.

use crate::accel::{
    BallTree, BoundingBall, Bvh, Bvh8, CompressedWideBvh, Exhaustive, Grid, KDopTree, KdTree,
    Octree, TwoLevelGrid,
};

use super::Structure;
#[cfg(feature = "embree")]
use super::embree::Embree;
#[cfg(feature = "libraries")]
use super::libraries::{ObvhsBvh2, ObvhsCwBvh, Parry, Svenstaro};
#[cfg(feature = "tinybvh")]
use super::tinybvh::TinyBvh;

/// All structures that give equal hits: those that every comparison has, the simplest first, and then those
/// that it has on request.
///
/// A `static`: a crate that names a constant compiles all that it refers to, every kernel of every structure, again.
pub static STRUCTURES: &[Structure] = &[
    Structure::portable::<Exhaustive, Exhaustive>("none", "test every object and every triangle"),
    Structure::portable::<Exhaustive, BoundingBall>("ball", "one bounding ball around each mesh")
        .with_source("Clark 1976; Rubin, Whitted 1980"),
    Structure::portable::<Bvh, Bvh>("bvh", "obvhs's binary tree over objects and triangles")
        .with_source(
            "Kay, Kajiya 1986; Meister, Bittner 2018; \
             builds of obvhs 0.4, https://github.com/DGriffin91/obvhs",
        ),
    Structure::portable::<CompressedWideBvh, CompressedWideBvh>(
        "cwbvh",
        "obvhs's compressed eight-wide tree over objects and triangles",
    )
    .with_source(
        "Ylitie, Karras, Laine 2017; \
         builds of obvhs 0.4, https://github.com/DGriffin91/obvhs",
    ),
    Structure::portable::<Bvh8, Bvh8>(
        "bvh8",
        "an eight-wide tree over objects and triangles: many rays at once",
    )
    .with_source(
        "Dammertz, Hanika, Keller 2008; Fuetterling et al. 2015; \
         Ylitie, Karras, Laine 2017",
    ),
    Structure::new::<KdTree, KdTree>("kdtree", "a kd-tree over objects and triangles")
        .with_source("MacDonald, Booth 1990; Wald, Havran 2006")
        .on_request(),
    Structure::new::<Grid, Grid>("grid", "a uniform grid over objects and triangles")
        .with_source(
            "Fujimoto, Tanaka, Iwata 1986; Amanatides, Woo 1987; \
             Cleary, Wyvill 1988",
        )
        .on_request(),
    Structure::new::<TwoLevelGrid, TwoLevelGrid>(
        "grid2",
        "a grid of grids over objects and triangles",
    )
    .with_source("Jevans, Wyvill 1989; Kalojanov, Billeter, Slusallek 2011")
    .on_request(),
    Structure::new::<Octree, Octree>("octree", "an octree over objects and triangles")
        .with_source("Glassner 1984; Revelles, Ureña, Lastra 2000")
        .on_request(),
    Structure::new::<BallTree, BallTree>("balls", "a tree of balls over objects and triangles")
        .with_source("Rubin, Whitted 1980; Weghorst, Hooper, Greenberg 1984")
        .on_request(),
    Structure::new::<KDopTree, KDopTree>(
        "kdop",
        "a tree of polytopes of 14 sides over objects and triangles",
    )
    .with_source("Klosowski et al. 1998")
    .on_request(),
];

/// What the structures are measured against, where the program was built with it.
pub static PEERS: &[Structure] = &[
    #[cfg(feature = "embree")]
    Structure::foreign::<Embree<false, false>>(
        "embree",
        "Intel's Embree 3, ray by ray: a peer, for scenes of triangles",
    )
    .with_source("https://www.embree.org"),
    #[cfg(feature = "embree")]
    Structure::foreign::<Embree<false, true>>(
        "embree16",
        "Intel's Embree 3, in packets of 16 rays: a peer, for scenes of triangles",
    )
    .with_source("https://www.embree.org"),
    #[cfg(feature = "embree")]
    Structure::foreign::<Embree<true, false>>(
        "embree4",
        "Intel's Embree 4, ray by ray: a peer, for scenes of triangles",
    )
    .with_source("https://www.embree.org"),
    #[cfg(feature = "embree")]
    Structure::foreign::<Embree<true, true>>(
        "embree4x16",
        "Intel's Embree 4, in packets of 16 rays: a peer, for scenes of triangles",
    )
    .with_source("https://www.embree.org"),
    #[cfg(feature = "libraries")]
    Structure::foreign::<ObvhsBvh2>(
        "obvhs2",
        "obvhs 0.4 as it is shipped, binary: a peer, for scenes of triangles",
    )
    .with_source("https://github.com/DGriffin91/obvhs"),
    #[cfg(feature = "libraries")]
    Structure::foreign::<ObvhsCwBvh>(
        "obvhs8",
        "obvhs 0.4 as it is shipped, compressed eight-wide: a peer, for scenes of triangles",
    )
    .with_source("https://github.com/DGriffin91/obvhs"),
    #[cfg(feature = "libraries")]
    Structure::foreign::<Parry>("parry", "parry3d 0.31: a peer, for scenes of triangles")
        .with_source("https://parry.rs"),
    #[cfg(feature = "libraries")]
    Structure::foreign::<Svenstaro>(
        "svenstaro",
        "bvh 0.13 by svenstaro: a peer, for scenes of triangles",
    )
    .with_source("https://github.com/svenstaro/bvh"),
    // The version is that of the header that was compiled.
    #[cfg(feature = "tinybvh")]
    Structure::foreign::<TinyBvh>(
        "tinybvh",
        concat!(env!("SRT_TINYBVH"), "'s BVH8_CPU, for AVX2: a peer, for scenes of triangles"),
    )
    .with_source("https://github.com/jbikker/tinybvh"),
];

/// The structure, or the peer, of a name.
#[must_use]
pub fn structure_named(name: &str) -> Option<&'static Structure> {
    STRUCTURES.iter().chain(PEERS).find(|structure| structure.name == name)
}
