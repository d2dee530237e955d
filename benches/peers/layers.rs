//! The cost of the layers around a structure: the scene's objects, and the call through a table of
//! functions.

use srt::accel::{BuildConfig, Bvh8, Indexed, Tracer};
use srt::analysis::statistics::median;
use srt::compare::measure::RaySet;
use srt::scene::{Scene, TracedWorld, structure_named};
use srt::shapes::{TriangleMesh, TriangleSet};

use crate::rays::seconds;

/// `bvh8` over a scene of one mesh, and over the triangles of the mesh by themselves.
pub(crate) struct Layers {
    world: Box<dyn TracedWorld>,
    triangles: Indexed<TriangleSet, Bvh8>,
}

impl Layers {
    pub(crate) fn new(scene: &Scene) -> Result<Self, String> {
        let structure = structure_named("bvh8").ok_or("there is no `bvh8`")?;
        let config = BuildConfig::default();
        let mesh = &scene.meshes()[0];
        let triangles = TriangleMesh::new(&mesh.positions, &mesh.triangles);
        Ok(Self {
            world: structure.build(scene, &config),
            triangles: Indexed::build(triangles, &config),
        })
    }

    /// Prints the median ratio of the scene's time to that of the triangles alone.
    pub(crate) fn measure(&self, set: &RaySet, rounds: usize) {
        let tracers: [&dyn Tracer; 2] = [&*self.world, &self.triangles];
        let times = seconds(&tracers, set, rounds);
        let ratios: Vec<_> = times[0].iter().zip(&times[1]).map(|(a, b)| a / b).collect();
        let ratio = median(&ratios).unwrap_or(f64::NAN);
        let class = set.class.name();
        println!("The scene over its triangles alone, {class}: {ratio:.3} of the time.\n");
    }
}
