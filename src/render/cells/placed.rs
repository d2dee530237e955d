//! What stands in the world: a cell, or all cells over a mesh, under the transform of an instance.

use std::sync::Arc;

use crate::accel::{Bounded, Bvh, Indexed, RegionForm};
use crate::math::{Aabb, BoxRay, Hit, Ray, RayToObject, Transform};

use super::solids::Solid;
use super::things::{Thing, Things};

/// The cells over a mesh.
type MeshCells = Arc<Indexed<Things<Solid>, Bvh>>;

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
}

impl Thing for Placed {
    fn bounds(&self) -> Aabb {
        self.bounds
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
        (hit.t <= ray.end() && hit.prim != Hit::MISS.prim).then_some(hit)
    }
}
