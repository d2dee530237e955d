//! The cells of a structure as solids: what `--view cells` shows.
//!
//! A pixel shows the first leaf that its ray enters from outside, each in a colour of its own: a box as a box, a ball
//! as a ball, darker at its rim. A leaf of the structure over a mesh stands where the mesh does; one of the structure
//! over the objects is shown if it holds single shapes alone, since what holds meshes would hide their own. Where a ray
//! hits a surface before it enters a cell, as the wall of a hall that it is in, the surface is grey.

mod placed;
mod solids;
mod things;

use std::sync::Arc;

use glam::Vec3;

use crate::accel::{BuildConfig, Bvh, Indexed, Regions};
use crate::description::Shape;
use crate::math::{CLOSE, Color, Hit, Random, Ray};
use crate::scene::{Scene, TracedWorld};

use self::placed::Placed;
use self::solids::Solid;
use self::things::Things;

/// How much darker the rim of a cell is.
const RIM: f32 = 0.45;

/// The leaves of a structure over a scene, to be looked at.
#[derive(Clone, Debug)]
pub struct CellView {
    placed: Indexed<Things<Placed>, Bvh>,
}

/// What a ray sees of a cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct SeenCell {
    /// Where the ray enters it.
    pub(super) t: f32,
    /// Which one it is.
    id: [u32; 2],
    /// How bright its face is, from 0 to 1.
    light: f32,
}

impl CellView {
    /// The leaves of the structures of a world over its scene.
    #[must_use]
    pub fn new(scene: &Scene, world: &dyn TracedWorld) -> Self {
        let regions = world.regions();
        let config = BuildConfig::default();
        let of_leaves = |regions: &Regions, shown: &dyn Fn(&[u32]) -> bool| {
            let leaves = regions.all().iter().filter(|region| region.is_leaf());
            let shown = leaves.filter(|leaf| leaf.count() > 0 && shown(regions.held(leaf)));
            shown.map(|leaf| leaf.form).collect::<Vec<_>>()
        };
        let meshes: Vec<_> = regions
            .meshes
            .iter()
            .map(|mesh| {
                let solids = of_leaves(mesh, &|_| true).into_iter().map(Solid);
                Arc::new(Indexed::<_, Bvh>::build(Things::new(solids), &config))
            })
            .collect();
        let is_single = |id: &u32| matches!(scene.objects[*id as usize].shape, Shape::Single(_));
        let over_objects = of_leaves(&regions.objects, &|held| held.iter().all(is_single));
        let singles = over_objects.into_iter().map(Placed::solid);
        let instances = scene.objects.iter().filter_map(|object| match object.shape {
            Shape::Mesh { mesh, .. } => {
                let transform = scene.transform_of(object);
                Placed::mesh(meshes.get(mesh)?, transform.as_deref())
            }
            Shape::Single(_) => None,
        });
        let placed = Things::new(singles.chain(instances));
        Self { placed: Indexed::build(placed, &config) }
    }

    /// The first cell that a ray enters.
    pub(super) fn seen(&self, ray: &Ray) -> Option<SeenCell> {
        let hit = self.placed.hit(ray);
        hit.is_hit().then_some(SeenCell { t: hit.t, id: [hit.object, hit.prim], light: hit.u })
    }
}

impl SeenCell {
    /// Whether two rays see the same cell, or none.
    fn is_same(one: Option<&Self>, other: Option<&Self>) -> bool {
        one.map(|cell| cell.id) == other.map(|cell| cell.id)
    }

    /// Its colour; `beside` is what the neighbours see.
    pub(super) fn color(&self, beside: &[Option<Self>]) -> Color {
        let mut random = Random::new(&self.id.map(u64::from));
        let color = Color::from_array(std::array::from_fn(|_| random.next_f32()));
        let is_rim = beside.iter().any(|other| !Self::is_same(Some(self), other.as_ref()));
        let light = self.light * if is_rim { RIM } else { 1.0 };
        // A little grey: large cells stand beside tiny ones.
        let grey = Color::splat(color.element_sum() / 3.0);
        light * (0.3 + 0.7 * color.lerp(grey, 0.35))
    }
}

/// A surface without a cell before it: grey, brighter where it faces the eye.
pub(super) fn surface_color(normal: Vec3, ray: &Ray) -> Color {
    let facing = normal.dot(ray.dir.normalize_or_zero()).abs();
    Color::splat(0.25 + 0.35 * facing)
}

/// Whether a hit lies before a cell is entered. A surface may be a side of its cell: what is as far, but for rounding,
/// is not before it.
pub(super) fn is_before(hit: &Hit, cell: &SeenCell) -> bool {
    hit.is_hit() && hit.t < (1.0 - CLOSE) * cell.t
}
