//! What stands in the world: a cell, or all cells over a mesh, under the transform of an instance.

use std::ops::Range;
use std::sync::Arc;

use glam::Vec3A;

use crate::accel::{Bounded, Bvh, Indexed, NoPacks, Primitives, Query, RegionForm};
use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, Hit, Padding, Ray, RayToObject, Transform};

use super::solids::{Solid, Solids};

/// The cells over a mesh.
type MeshCells = Arc<Indexed<Solids, Bvh>>;

/// A cell, or the cells over a mesh.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    bounds: Aabb,
    what: What,
}

#[derive(Clone, Debug)]
enum What {
    Cell(Solid),
    Mesh(MeshCells, Option<RayToObject>),
}

impl Placed {
    /// A cell in the world.
    pub(super) fn solid(form: RegionForm) -> Self {
        let solid = Solid(form);
        Self { bounds: solid.bounds(), what: What::Cell(solid) }
    }

    /// The cells over a mesh that is under a transform; `None` if there are none.
    pub(super) fn mesh(mesh: &MeshCells, transform: Option<&Transform>) -> Option<Self> {
        let own = mesh.primitives().total_bounds();
        let to_object = transform.map(Transform::ray_to_object);
        let what = What::Mesh(Arc::clone(mesh), to_object);
        let bounds = transform.map_or(own, |transform| transform.bounds_to_world(&own));
        (!own.is_empty()).then_some(Self { bounds, what })
    }

    /// The first cell that a ray enters.
    fn hit(&self, id: u32, ray: &Ray, box_ray: &BoxRay) -> Option<Hit> {
        let hit = match &self.what {
            What::Cell(solid) => {
                let (t, light) = solid.entered(ray, box_ray)?;
                Hit { t, object: id, prim: 0, u: light, v: 0.0 }
            }
            What::Mesh(cells, to_object) => {
                let own = to_object.map_or(*ray, |to_object| to_object.apply(ray));
                Hit { object: id, ..cells.hit(&own) }
            }
        };
        (hit.t <= ray.t_max && hit.prim != Hit::MISS.prim).then_some(hit)
    }
}

/// What stands in the world, in slot order, each with its id.
#[derive(Clone, Debug)]
pub(super) struct PlacedList {
    all: Vec<(Placed, u32)>,
    padding: Padding,
}

impl PlacedList {
    /// Things whose ids are their places.
    pub(super) fn new(all: Vec<Placed>) -> Self {
        let bounds = all.iter().map(|placed| placed.bounds).fold(Aabb::EMPTY, Aabb::union);
        Self { all: all.into_iter().zip(0..).collect(), padding: Padding::of_bounds(&bounds) }
    }
}

impl Bounded for PlacedList {
    fn count(&self) -> u32 {
        self.all.len() as u32
    }

    fn bounds(&self, slot: u32) -> Aabb {
        self.all[slot as usize].0.bounds
    }

    fn mean_point(&self) -> Vec3A {
        self.total_bounds().center()
    }
}

impl Primitives for PlacedList {
    type Packs = NoPacks;

    fn packs(&self) -> &NoPacks {
        &NoPacks
    }

    fn padding(&self) -> Padding {
        self.padding
    }

    fn reorder(&mut self, order: &[u32]) {
        let in_order = order.iter().filter_map(|&from| self.all.get(from as usize).cloned());
        self.all = in_order.collect();
    }

    fn test<Q: Query, C: Counters>(
        &self,
        query: &Q,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        answer: &mut Q::Answer,
        _: &mut C,
    ) {
        for (placed, id) in &self.all[slots.start as usize..slots.end as usize] {
            let shorter = Ray { t_max: query.end(ray, answer), ..*ray };
            let Some(hit) = placed.hit(*id, &shorter, box_ray) else { continue };
            if query.accepts(ray, &hit) {
                query.record(answer, &hit);
            }
        }
    }
}
