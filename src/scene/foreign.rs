//! Scenes traced by another program's library: what such a library has to offer, and the world that
//! is made of it.
//!
//! A library sees triangles in the world and rays, and nothing of a scene. Its formulas are its own:
//! its hits are close to those of the structures, and not equal to them. So it is compared as a peer
//! ([`Structure::foreign`](super::Structure::foreign)).

use std::borrow::Cow;
use std::error::Error;
use std::time::{Duration, Instant};

use glam::Vec3;

use crate::accel::{
    Answers, BuildConfig, BuildStages, OptionInfo, Scratch, StructureShape, Tracer,
};
use crate::counters::Counts;
use crate::description::Shape;
use crate::math::Ray;
use crate::shapes::{EndPointOverlap, Single};

use super::{BuildError, BuildReport, Object, Scene, TracedWorld};

/// The triangles of an object, in the world.
#[derive(Clone, Debug)]
pub struct TriangleObject<'a> {
    /// Its vertices.
    pub positions: Cow<'a, [Vec3]>,
    /// Three of the vertices each, by index; every index is in range.
    pub triangles: &'a [[u32; 3]],
}

/// The memory that a library takes, in bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ForeignBytes {
    /// Of the index.
    pub index: u64,
    /// Of the triangles, as far as they are kept beside the index.
    pub triangles: u64,
}

/// A library that builds an index from triangles and traces rays through it.
///
/// An object's place in the list is its id: `Hit::object`; a triangle's place in its object is
/// `Hit::prim`; `u` and `v` are the weights of its second and third vertex.
pub trait ForeignTracer: Send + Sync + Sized {
    /// The options that a build looks for in [`BuildConfig::options`], each of its own name.
    const OPTIONS: &'static [OptionInfo] = &[];

    /// The bytes that a build takes for each triangle, roughly: where there are not as many, none is begun.
    const BUILD_BYTES: u64 = 40;

    /// Of a library that is loaded as the program runs, the name and the version of what there is; nothing of one that
    /// is part of the program.
    ///
    /// # Errors
    /// In the library's own words, if there is none.
    fn loaded() -> Result<Option<String>, Box<dyn Error + Send + Sync>> {
        Ok(None)
    }

    /// Builds the index over all objects, which come one after the other: of objects with a
    /// transform, the positions are made as they come. An object may have no triangle, and there may
    /// be no object.
    ///
    /// # Errors
    /// In the library's own words, if it cannot.
    fn build<'a>(
        objects: impl ExactSizeIterator<Item = TriangleObject<'a>>,
        build: &ForeignBuild<'_>,
    ) -> Result<Self, Box<dyn Error + Send + Sync>>;

    /// Answers the query that the kind of `answers` stands for, for each ray, between its `t_min` and its `t_max`,
    /// which may be infinite: [`Ray::end`] is not.
    /// The slices have one length. Called from several threads at once.
    fn trace(&self, rays: &[Ray], answers: Answers<'_>);

    /// What the library takes of the memory, as far as it can be known.
    fn bytes(&self) -> ForeignBytes {
        ForeignBytes::default()
    }
}

/// How a library is to build.
#[derive(Clone, Copy, Debug)]
pub struct ForeignBuild<'a> {
    /// What the caller chose.
    pub config: &'a BuildConfig,
    /// The threads that it may build with.
    pub threads: usize,
}

/// A scene of triangles and meshes in a library.
///
/// Objects with a transform are baked: their vertices go to the world by the transform in `f64`, and
/// are rounded once. A mesh that many objects share is stored for each of them. Balls and cylinders
/// are refused.
pub(super) struct ForeignWorld<F> {
    library: F,
    triangles: u64,
    build_time: Duration,
}

impl<F: ForeignTracer> ForeignWorld<F> {
    /// Hands a scene to the library, which builds on as many threads as the current rayon pool has.
    pub(super) fn build(scene: &Scene, config: &BuildConfig) -> Result<Self, BuildError> {
        let start = Instant::now();
        refuse_other_forms(scene)?;
        let objects = scene.objects.iter().map(|object| baked(scene, object));
        let build = ForeignBuild { config, threads: rayon::current_num_threads() };
        let library = F::build(objects, &build)
            .map_err(|error| BuildError::Library { text: error.to_string() })?;
        Ok(Self { library, triangles: scene.triangle_count(), build_time: start.elapsed() })
    }
}

/// An error if there is anything but triangles.
fn refuse_other_forms(scene: &Scene) -> Result<(), BuildError> {
    let other = |(object, own): (usize, &Object)| match own.shape {
        Shape::Single(Single::Triangle(_)) | Shape::Mesh { .. } => None,
        Shape::Single(single) => Some(BuildError::Unsupported { object, shape: single.name() }),
    };
    scene.objects.iter().enumerate().find_map(other).map_or(Ok(()), Err)
}

/// An object's triangles, in the world.
fn baked<'a>(scene: &'a Scene, object: &Object) -> TriangleObject<'a> {
    let of_triangle = &[[0, 1, 2]];
    let (positions, triangles): (Cow<'a, [Vec3]>, &'a [[u32; 3]]) = match object.shape {
        Shape::Single(Single::Triangle(own)) => (own.corners.to_vec().into(), of_triangle),
        Shape::Mesh { mesh, .. } => {
            let mesh = &scene.meshes()[mesh];
            (mesh.positions[..].into(), &mesh.triangles)
        }
        Shape::Single(_) => (Cow::default(), &[]),
    };
    let Some(transform) = scene.transform_of(object) else {
        return TriangleObject { positions, triangles };
    };
    let to_world = |p: &Vec3| transform.world_from_object.transform_point3(p.as_dvec3()).as_vec3();
    TriangleObject { positions: positions.iter().map(to_world).collect(), triangles }
}

impl<F: ForeignTracer> Tracer for ForeignWorld<F> {
    /// Nothing is counted: a library does not show what it tests.
    fn trace(&self, rays: &[Ray], answers: Answers<'_>, _: &mut Scratch, _: Option<&mut Counts>) {
        let length = match &answers {
            Answers::ClosestHit(hits) => hits.len(),
            Answers::AnyHit(blocked) => blocked.len(),
        };
        assert_eq!(rays.len(), length, "an answer for each ray");
        self.library.trace(rays, answers);
    }
}

impl<F: ForeignTracer> TracedWorld for ForeignWorld<F> {
    fn build_report(&self) -> BuildReport {
        let ForeignBytes { index, triangles } = self.library.bytes();
        BuildReport {
            time: self.build_time,
            stages: BuildStages::default(),
            objects: StructureShape::default(),
            meshes: StructureShape { bytes: index, ..StructureShape::default() },
            triangles: self.triangles,
            triangle_bytes: triangles,
        }
    }

    /// A library shows no tree.
    fn end_point_overlap(&self, _: u64) -> Option<EndPointOverlap> {
        None
    }
}
