//! An object of a scene as rays of the world meet it: its box, and the way to its own space.

use crate::accel::Query;
use crate::math::{Aabb, BoxRay, Padding, Ray, RayToObject, ones};
use crate::simd::{Kernel, LANES, Row, Simd, dispatch};

use super::ray_group::RayGroup;

/// Where an object is.
#[derive(Clone, Copy, Debug)]
pub struct Instance<'a> {
    /// What takes rays to its own space, if that is not the world's.
    pub to_object: Option<&'a RayToObject>,
    /// Its box in the world: hits count by the interval of it.
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

    /// A ray up to `t_max` in the object's own space: what a mesh's structure searches. With it, where the
    /// object's box begins: no hit counts earlier. A ray that does not meet the box before `t_max` ends
    /// before it begins, so that nothing counts. `box_ray` is the ray with the padding of the instance.
    #[inline(always)]
    #[must_use]
    pub fn enter(&self, ray: &Ray, box_ray: &BoxRay, t_max: f32) -> (Ray, f32) {
        let (t_max, begin) = match box_ray.begin(&self.bounds, [ray.t_min, t_max]) {
            Some(begin) => (t_max, begin),
            None => (f32::MIN, f32::MIN),
        };
        (self.own_ray(&Ray { t_max, ..*ray }), begin)
    }

    /// [`enter`](Self::enter) for many rays: those that meet the box replace what is in `entered`.
    /// `which` has the rays' places in both slices.
    pub fn enter_many<Q: Query>(
        &self,
        query: &Q,
        (rays, which): (&[Ray], &[u32]),
        answers: &[Q::Answer],
        entered: &mut Entered,
    ) {
        entered.rays.clear();
        entered.places.clear();
        entered.begins.clear();
        dispatch(EnterMany { instance: self, query, rays, which, answers, entered });
    }
}

/// Rays of a slice that meet an object's box.
#[derive(Debug, Default)]
pub struct Entered {
    /// The rays in the object's own space.
    pub rays: Vec<Ray>,
    /// Their places in the slice.
    pub places: Vec<u32>,
    /// Where the box begins.
    pub begins: Vec<f32>,
}

struct EnterMany<'a, Q: Query> {
    instance: &'a Instance<'a>,
    query: &'a Q,
    rays: &'a [Ray],
    which: &'a [u32],
    answers: &'a [Q::Answer],
    entered: &'a mut Entered,
}

impl<Q: Query> Kernel for EnterMany<'_, Q> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { instance, query, rays, which, answers, entered } = self;
        let mut records = [[0.0; 8]; LANES];
        let (mut begins, mut ends) = ([0.0; LANES], [0.0; LANES]);
        for places in which.chunks(LANES) {
            let group = RayGroup::<S>::load(instance, query, (rays, places), answers, &mut records);
            let [begin, _] = group.reach.in_box;
            let [_, end] = group.reach.of_ray;
            begin.store(&mut begins);
            end.store(&mut ends);
            for lane in ones(group.meets()) {
                let ray = Ray { t_max: ends[lane % LANES], ..rays[places[lane] as usize] };
                entered.rays.push(instance.own_ray(&ray));
                entered.places.push(places[lane]);
                entered.begins.push(begins[lane % LANES]);
            }
        }
    }
}
