//! The place of an object in the world, and the rays that come to it.

use crate::math::{Aabb, BoxRay, Hit, Padding, Ray, RayToObject};
use crate::simd::{Kernel, LANES, Mask, Row, Simd, dispatch, ones};

use super::ray_group::Group;

/// Where an object is, as rays of the world see it.
#[derive(Clone, Copy, Debug)]
pub struct Place<'a> {
    /// What takes rays to its own space, if that is not the world's.
    pub to_object: Option<&'a RayToObject>,
    /// Its box in the world: a hit counts only within the interval of it.
    pub bounds: Aabb,
    /// The padding of that box.
    pub padding: Padding,
    /// The object's id in its hits.
    pub object: u32,
}

/// What a ray knows so far: its best hit, or whether it is blocked.
pub trait SoFar: Copy {
    /// How far hits count, if the search goes on.
    fn end(&self, ray: &Ray) -> f32;
    /// Notes a hit within that.
    fn note(&mut self, hit: &Hit);
}

impl SoFar for Hit {
    #[inline(always)]
    fn end(&self, _: &Ray) -> f32 {
        self.t
    }
    #[inline(always)]
    fn note(&mut self, hit: &Hit) {
        if hit.precedes(self) {
            *self = *hit;
        }
    }
}

impl SoFar for bool {
    #[inline(always)]
    fn end(&self, ray: &Ray) -> f32 {
        ray.t_max
    }
    #[inline(always)]
    fn note(&mut self, _: &Hit) {
        *self = true;
    }
}

impl Place<'_> {
    /// The ray in the object's own space.
    #[inline(always)]
    pub(super) fn own_ray(&self, ray: &Ray) -> Ray {
        self.to_object.map_or(*ray, |to_object| to_object.apply(ray))
    }

    /// The part of a ray that is in the object's box, in the object's own space: what a mesh's
    /// structure is asked. It may be empty; then nothing counts. `box_ray` is the ray with the
    /// place's padding.
    #[inline(always)]
    #[must_use]
    pub fn own_part(&self, ray: &Ray, box_ray: &BoxRay, t_max: f32) -> Ray {
        let (near, far) = box_ray.interval(&self.bounds);
        self.own_ray(&Ray { t_min: ray.t_min.max(near), t_max: far.min(t_max), ..*ray })
    }

    /// [`own_part`](Self::own_part) of many rays, where it is not empty, and the places of these
    /// rays, in place of what is in `own` and `entered`. `which` has the rays' places in both slices.
    pub fn own_parts(
        &self,
        rays: &[Ray],
        which: &[u32],
        so_far: &[impl SoFar],
        own: &mut Vec<Ray>,
        entered: &mut Vec<u32>,
    ) {
        own.clear();
        entered.clear();
        dispatch(OwnParts { place: self, rays, which, so_far, own, entered });
    }
}

struct OwnParts<'a, A> {
    place: &'a Place<'a>,
    rays: &'a [Ray],
    which: &'a [u32],
    so_far: &'a [A],
    own: &'a mut Vec<Ray>,
    entered: &'a mut Vec<u32>,
}

impl<A: SoFar> Kernel for OwnParts<'_, A> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { place, rays, which, so_far, own, entered } = self;
        let mut records = [[0.0; 8]; LANES];
        let (mut begins, mut ends) = ([0.0; LANES], [0.0; LANES]);
        for places in which.chunks(LANES) {
            let group = Group::<S>::load(place, rays, places, so_far, &mut records);
            group.begin.store(&mut begins);
            group.end.store(&mut ends);
            for lane in ones(group.begin.le(group.end).bits()) {
                let ray = &rays[places[lane] as usize];
                let part = Ray { t_min: begins[lane % LANES], t_max: ends[lane % LANES], ..*ray };
                own.push(place.own_ray(&part));
                entered.push(places[lane]);
            }
        }
    }
}
