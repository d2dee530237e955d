//! The known libraries as peers, each as it is shipped: its own tree, its own triangles, the fastest way that it
//! documents. One file a library, which says in its head what was chosen.
//!
//! tinybvh is C++ and not among them: `scene/tinybvh.rs` is its file.
//!
//! Their hits are close to those of the structures, not equal to them. What all of them need is here: one list of the
//! triangles of all objects, and the ids and weights that a hit has.

mod obvhs;
mod parry;
mod svenstaro;

use glam::Vec3;

use super::foreign::TriangleObject;
use crate::accel::Answers;
use crate::math::{Hit, Ray};

pub(super) use obvhs::{ObvhsBvh2, ObvhsCwBvh};
pub(super) use parry::Parry;
pub(super) use svenstaro::Svenstaro;

/// The triangles of all objects, one after the other.
#[derive(Default)]
struct Triangles {
    corners: Vec<[Vec3; 3]>,
    /// The place of the first triangle of each object.
    firsts: Vec<u32>,
}

/// What a library found: the place of a triangle in the list, and the parameter.
struct Found {
    place: u32,
    t: f32,
}

impl Triangles {
    /// All of them, in the order of the objects.
    fn of<'a>(objects: impl ExactSizeIterator<Item = TriangleObject<'a>>) -> Self {
        let mut all = Self::default();
        for object in objects {
            all.firsts.push(all.corners.len() as u32);
            let corners = |triangle: &[u32; 3]| triangle.map(|i| object.positions[i as usize]);
            all.corners.extend(object.triangles.iter().map(corners));
        }
        all
    }

    /// Answers rays one by one: `closest` finds the nearest triangle, `any` whether there is one.
    fn answer(
        &self,
        rays: &[Ray],
        answers: Answers<'_>,
        closest: impl Fn(&Ray) -> Option<Found>,
        any: impl Fn(&Ray) -> bool,
    ) {
        match answers {
            Answers::ClosestHit(hits) => {
                for (ray, hit) in rays.iter().zip(hits) {
                    *hit = closest(ray).map_or(Hit::MISS, |found| self.hit(ray, &found));
                }
            }
            Answers::AnyHit(blocked) => {
                for (ray, blocked) in rays.iter().zip(blocked) {
                    *blocked = any(ray);
                }
            }
        }
    }

    /// The ids of a triangle, and the weights of the point where the ray meets it: those of its projection to the
    /// triangle's plane (Ericson: *Real-Time Collision Detection*, 2005, 3.4).
    fn hit(&self, ray: &Ray, found: &Found) -> Hit {
        let &Found { place, t } = found;
        let [a, b, c] = self.corners[place as usize];
        let (to_b, to_c, to_point) = (b - a, c - a, ray.origin + t * ray.dir - a);
        let (bb, bc, cc) = (to_b.dot(to_b), to_b.dot(to_c), to_c.dot(to_c));
        let (pb, pc) = (to_point.dot(to_b), to_point.dot(to_c));
        let scale = 1.0 / (bb * cc - bc * bc);
        let object = self.firsts.partition_point(|&first| first <= place) - 1;
        Hit {
            t,
            object: object as u32,
            prim: place - self.firsts[object],
            u: scale * (cc * pb - bc * pc),
            v: scale * (bb * pc - bc * pb),
        }
    }

    /// The bytes of the list.
    fn bytes(&self) -> u64 {
        size_of_val(&self.corners[..]) as u64
    }
}

/// For libraries whose rays have no smallest parameter: where the ray begins to count, and how far it goes from there.
fn from_start(ray: &Ray) -> (Vec3, f32) {
    (ray.origin + ray.t_min * ray.dir, ray.end() - ray.t_min)
}
