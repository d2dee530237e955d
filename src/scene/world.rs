//! A scene with a structure over it, on two levels.

mod saved;

use std::convert::Infallible;
use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::accel::{
    Accel, Answers, BuildConfig, BuildStages, Indexed, Moved, OptionInfo, Regions, Scratch,
    StructureShape, Tracer, Update,
};
use crate::assets::MeshData;
use crate::counters::Counts;
use crate::description::Shape;
use crate::math::{Aabb, NONE, Ray};
use crate::shapes::{
    EndPointOverlap, OVERLAP_SAMPLES, TriangleMesh, TriangleSet, end_point_overlap,
};

use super::{Object, ObjectList, Scene, SceneChange, WorldRegions};

/// A scene indexed by `O` over its objects and by `T` over the triangles of each mesh.
#[derive(Clone, Debug)]
pub struct World<O, T> {
    objects: Indexed<ObjectList<T>, O>,
    meshes: Vec<Arc<Indexed<TriangleSet, T>>>,
    /// The mesh, if that is the only object and stands in the world's own space: it is searched
    /// itself. Its hits need no test of the object's box, which holds the boxes of all triangles and
    /// is tested with no less padding.
    only_mesh: Option<Arc<Indexed<TriangleSet, T>>>,
    build_time: Duration,
    stages: BuildStages,
}

/// What building a world took and gave.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BuildReport {
    /// Wall time from the compiled scene to the first ray, packing of triangles included.
    pub time: Duration,
    /// What it was spent on, of all meshes together; the index over the objects is one stage. Empty
    /// where the structure does not report them.
    pub stages: BuildStages,
    /// The structure over the objects.
    pub objects: StructureShape,
    /// The structures over the meshes' triangles, added up, each mesh once.
    pub meshes: StructureShape,
    /// Triangles in all meshes, each mesh once.
    pub triangles: u64,
    /// Bytes of the triangles as they are traced, each mesh once.
    pub triangle_bytes: u64,
}

/// What the renderer needs of a world: rays to hits, and what the structure is.
pub trait TracedWorld: Tracer {
    /// What building it took and gave.
    fn build_report(&self) -> BuildReport;

    /// Follows a scene that has moved, from the frame that it was built or refitted for, in some way. Whether that was
    /// possible; if it was not, it must be built anew. The answers are those of a world that is built for the scene as
    /// it is, bit for bit.
    fn refit(&mut self, change: &SceneChange<'_>, update: Update) -> bool {
        let _ = (change, update);
        false
    }

    /// The parts of space that rays are tested against, for pictures; none of a peer, which does not show them.
    fn regions(&self) -> WorldRegions {
        WorldRegions::default()
    }

    /// The end-point overlap of the trees over the meshes, added up, each mesh once; `None` where
    /// there is no tree or no mesh. Of large meshes some triangles are chosen, by `seed`.
    fn end_point_overlap(&self, seed: u64) -> Option<EndPointOverlap>;
}

impl<O: Accel, T: Accel> World<O, T> {
    /// Indexes a scene.
    #[must_use]
    pub fn build(scene: &Scene, config: &BuildConfig) -> Self {
        let start = Instant::now();
        let mut stages = BuildStages::default();
        let meshes: Vec<_> = scene
            .meshes()
            .iter()
            .map(|mesh| {
                let mesh =
                    stages.time("mesh", || TriangleMesh::new(&mesh.positions, &mesh.triangles));
                let indexed = Indexed::build(mesh, config);
                stages.merge(indexed.build_stages());
                Arc::new(indexed)
            })
            .collect();
        // One object a leaf: an object can be a whole mesh, and a box is cheaper than its ball.
        let options = config.options.without(OptionInfo::LEAF);
        let config = BuildConfig { max_leaf: 1, options, ..*config };
        let over_objects = Instant::now();
        let objects = Indexed::build(ObjectList::new(scene, &meshes), &config);
        stages.add("objects", over_objects.elapsed() - objects.check_time());
        let only_mesh = only_mesh(scene).map(|mesh| Arc::clone(&meshes[mesh]));
        let check_time =
            objects.check_time() + meshes.iter().map(|mesh| mesh.check_time()).sum::<Duration>();
        Self { objects, meshes, only_mesh, build_time: start.elapsed() - check_time, stages }
    }
}

/// The mesh that is all of a scene, in the world's own space.
fn only_mesh(scene: &Scene) -> Option<usize> {
    match scene.objects[..] {
        [Object { shape: Shape::Mesh { mesh, .. }, transform: NONE, .. }] => Some(mesh),
        _ => None,
    }
}

impl<O: Accel, T: Accel> World<O, T> {
    /// Lets the meshes that have changed follow, then the objects. `None` if a mesh cannot be traced where it is now,
    /// or is held by another world too.
    fn follow(&mut self, change: &SceneChange<'_>, update: Update) -> Option<()> {
        let Self { objects, meshes, only_mesh: only, .. } = self;
        // Each mesh is held in three places: it is changed where it stands, once nothing else holds it.
        *only = None;
        let mut held = Vec::new();
        let slots = objects.primitives_mut().slots_of(&change.objects);
        objects.primitives_mut().swap_meshes(&mut held);
        held.clear();
        for &mesh in &change.meshes {
            let MeshData { positions, triangles, .. } = &*change.after.meshes()[mesh];
            let indexed = Arc::get_mut(&mut meshes[mesh])?;
            let change = |set: &mut TriangleSet| set.move_to(positions, triangles);
            indexed.refit(update, Moved::All, change, TriangleSet::settle).ok()?;
        }
        objects.primitives_mut().swap_meshes(&mut meshes.clone());
        *only = only_mesh(change.after).map(|mesh| Arc::clone(&meshes[mesh]));
        if !slots.is_empty() {
            let move_objects = |list: &mut ObjectList<T>| {
                list.move_to(change, &slots);
                Ok(())
            };
            let settle = |list: &mut ObjectList<T>, bounds: &Aabb| {
                list.settle(bounds);
                Ok(())
            };
            let moved = Moved::Slots(&slots);
            objects.refit::<Infallible>(update, moved, move_objects, settle).ok()?;
        }
        Some(())
    }
}

impl<O: Accel, T: Accel> Tracer for World<O, T> {
    fn trace(
        &self,
        rays: &[Ray],
        answers: Answers<'_>,
        scratch: &mut Scratch,
        counts: Option<&mut Counts>,
    ) {
        match &self.only_mesh {
            Some(mesh) => mesh.trace(rays, answers, scratch, counts),
            None => self.objects.trace(rays, answers, scratch, counts),
        }
    }

    fn is_one_by_one(&self) -> bool {
        self.only_mesh.as_ref().map_or(O::ONE_BY_ONE, |mesh| mesh.is_one_by_one())
    }
}

impl<O: Accel, T: Accel> TracedWorld for World<O, T> {
    fn refit(&mut self, change: &SceneChange<'_>, update: Update) -> bool {
        let offered = O::UPDATES.contains(&update) && T::UPDATES.contains(&update);
        offered && self.follow(change, update).is_some()
    }

    fn build_report(&self) -> BuildReport {
        let mut meshes = StructureShape::default();
        let (mut triangles, mut triangle_bytes) = (0, 0);
        for mesh in &self.meshes {
            meshes.merge(&mesh.shape());
            triangles += u64::from(mesh.primitives().triangle_count());
            triangle_bytes += mesh.primitives().bytes();
        }
        BuildReport {
            time: self.build_time,
            stages: self.stages.clone(),
            objects: self.objects.shape(),
            meshes,
            triangles,
            triangle_bytes,
        }
    }

    fn regions(&self) -> WorldRegions {
        let mut objects = Regions::default();
        if self.only_mesh.is_none() {
            objects = self.objects.regions();
            objects.rename(|slot| self.objects.primitives().id_of(slot));
        }
        WorldRegions { objects, meshes: self.meshes.iter().map(|mesh| mesh.regions()).collect() }
    }

    fn end_point_overlap(&self, seed: u64) -> Option<EndPointOverlap> {
        let of_mesh = |mesh: &Arc<Indexed<TriangleSet, T>>| {
            let tree = mesh.tree()?;
            Some(end_point_overlap(&tree, mesh.primitives(), OVERLAP_SAMPLES, seed))
        };
        self.meshes.iter().filter_map(of_mesh).reduce(EndPointOverlap::and)
    }
}

#[cfg(test)]
mod tests;
