//! A library of another program's, as small as can be, and the file that brings it to srt.

use std::error::Error;
use std::ops::RangeInclusive;

use srt::accel::Answers;
use srt::glam::DVec3;
use srt::math::{Hit, Ray};
use srt::scene::{ForeignBuild, ForeignBytes, ForeignTracer, TriangleObject};

/// The library: a list of triangles, tested one after the other in double precision.
#[derive(Default)]
struct TriangleList(Vec<[DVec3; 3]>);

/// What the library finds: a place in its list, the parameter and two weights.
struct Found {
    place: usize,
    t: f64,
    u: f64,
    v: f64,
}

impl TriangleList {
    /// Möller, Trumbore: *Fast, Minimum Storage Ray/Triangle Intersection*, 1997.
    fn test(&self, place: usize, origin: DVec3, dir: DVec3) -> Option<Found> {
        let [a, b, c] = self.0[place];
        let (to_b, to_c) = (b - a, c - a);
        let across = dir.cross(to_c);
        let scale = 1.0 / to_b.dot(across);
        let from_a = origin - a;
        let u = scale * from_a.dot(across);
        let around = from_a.cross(to_b);
        let v = scale * dir.dot(around);
        let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
        inside.then(|| Found { place, t: scale * to_c.dot(around), u, v })
    }

    fn closest(&self, origin: DVec3, dir: DVec3, within: RangeInclusive<f64>) -> Option<Found> {
        let found = (0..self.0.len()).filter_map(|place| self.test(place, origin, dir));
        found.filter(|found| within.contains(&found.t)).min_by(|a, b| a.t.total_cmp(&b.t))
    }

    fn any(&self, origin: DVec3, dir: DVec3, within: RangeInclusive<f64>) -> bool {
        let mut found = (0..self.0.len()).filter_map(|place| self.test(place, origin, dir));
        found.any(|found| within.contains(&found.t))
    }
}

/// The library as srt sees it.
#[derive(Default)]
pub(crate) struct BruteForce {
    list: TriangleList,
    /// The object and the triangle in it, for each place of the list.
    ids: Vec<(u32, u32)>,
}

impl ForeignTracer for BruteForce {
    fn build<'a>(
        objects: impl ExactSizeIterator<Item = TriangleObject<'a>>,
        _: &ForeignBuild<'_>,
    ) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let mut all = Self::default();
        for (id, object) in (0..).zip(objects) {
            for (prim, triangle) in (0..).zip(object.triangles) {
                all.list.0.push(triangle.map(|i| object.positions[i as usize].as_dvec3()));
                all.ids.push((id, prim));
            }
        }
        Ok(all)
    }

    fn trace(&self, rays: &[Ray], answers: Answers<'_>) {
        let parts = |ray: &Ray| {
            let within = f64::from(ray.t_min)..=f64::from(ray.end());
            (ray.origin.as_dvec3(), ray.dir.as_dvec3(), within)
        };
        match answers {
            Answers::ClosestHit(hits) => {
                for (ray, hit) in rays.iter().zip(hits) {
                    let (origin, dir, within) = parts(ray);
                    let found = self.list.closest(origin, dir, within);
                    *hit = found.map_or(Hit::MISS, |found| self.hit(&found));
                }
            }
            Answers::AnyHit(blocked) => {
                for (ray, blocked) in rays.iter().zip(blocked) {
                    let (origin, dir, within) = parts(ray);
                    *blocked = self.list.any(origin, dir, within);
                }
            }
        }
    }

    fn bytes(&self) -> ForeignBytes {
        let triangles = size_of_val(&self.list.0[..]) + size_of_val(&self.ids[..]);
        ForeignBytes { index: 0, triangles: triangles as u64 }
    }
}

impl BruteForce {
    fn hit(&self, found: &Found) -> Hit {
        let (object, prim) = self.ids[found.place];
        Hit { t: found.t as f32, object, prim, u: found.u as f32, v: found.v as f32 }
    }
}
