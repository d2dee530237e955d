//! An object of a scene as rays of the world meet it: its box, and the way to its own space.

use crate::accel::Query;
use crate::math::{Aabb, BoxRay, Lanes as _, Mask as _, Padding, Ray, RayToObject, ones};
use crate::simd::{Kernel, LANES, Row, Simd, dispatch};

use super::ray_group::RayGroup;

/// Where an object is.
#[derive(Clone, Copy, Debug)]
pub struct Instance<'a> {
    /// What takes rays to its own space, if that is not the world's.
    pub to_object: Option<&'a RayToObject>,
    /// Its box in the world: a hit counts only within the interval of it.
    pub bounds: Aabb,
    /// The padding of that box.
    pub padding: Padding,
    /// The object's id in its hits.
    pub object: u32,
}

impl Instance<'_> {
    /// The ray in the object's own space.
    #[inline(always)]
    pub(super) fn own_ray(&self, ray: &Ray) -> Ray {
        self.to_object.map_or(*ray, |to_object| to_object.apply(ray))
    }

    /// The part of a ray that is in the object's box, up to `t_max`, in the object's own space: what
    /// a mesh's structure searches. It may be empty; then nothing counts. `box_ray` is the ray with
    /// the padding of the instance.
    #[inline(always)]
    #[must_use]
    pub fn enter(&self, ray: &Ray, box_ray: &BoxRay, t_max: f32) -> Ray {
        let (near, far) = box_ray.interval(&self.bounds);
        self.own_ray(&Ray { t_min: ray.t_min.max(near), t_max: far.min(t_max), ..*ray })
    }

    /// [`enter`](Self::enter) for many rays: those whose part is not empty, with the places of their
    /// rays, replace what is in `own` and `entered`. `which` has the rays' places in both slices.
    pub fn enter_many<Q: Query>(
        &self,
        query: &Q,
        (rays, which): (&[Ray], &[u32]),
        answers: &[Q::Answer],
        own: &mut Vec<Ray>,
        entered: &mut Vec<u32>,
    ) {
        own.clear();
        entered.clear();
        dispatch(EnterMany { instance: self, query, rays, which, answers, own, entered });
    }
}

struct EnterMany<'a, Q: Query> {
    instance: &'a Instance<'a>,
    query: &'a Q,
    rays: &'a [Ray],
    which: &'a [u32],
    answers: &'a [Q::Answer],
    own: &'a mut Vec<Ray>,
    entered: &'a mut Vec<u32>,
}

impl<Q: Query> Kernel for EnterMany<'_, Q> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { instance, query, rays, which, answers, own, entered } = self;
        let mut records = [[0.0; 8]; LANES];
        let (mut begins, mut ends) = ([0.0; LANES], [0.0; LANES]);
        for places in which.chunks(LANES) {
            let group = RayGroup::<S>::load(instance, query, (rays, places), answers, &mut records);
            group.begin.store(&mut begins);
            group.end.store(&mut ends);
            for lane in ones(group.begin.le(group.end).bits()) {
                let ray = &rays[places[lane] as usize];
                let part = Ray { t_min: begins[lane % LANES], t_max: ends[lane % LANES], ..*ray };
                own.push(instance.own_ray(&part));
                entered.push(places[lane]);
            }
        }
    }
}
