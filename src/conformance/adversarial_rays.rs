//! Rays aimed at where structures go wrong.

use crate::math::{Hit, Random, Ray};
use glam::Vec3;

use super::nasty_meshes::{Mesh, random_point};

/// The classes of rays, taken in turn.
const CLASSES: usize = 12;

/// `count` rays aimed at the triangles of a mesh.
///
/// # Panics
/// If it has none.
#[must_use]
pub fn rays_at(mesh: &Mesh, count: usize, seed: u64) -> Vec<Ray> {
    let low = mesh.positions.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = mesh.positions.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let mut aim = Aim {
        random: Random::new(&[seed]),
        center: (low + high) / 2.0,
        extent: (high - low).length(),
    };
    (0..count)
        .map(|i| {
            let triangle = aim.random.below(mesh.triangles.len() as u32) as usize;
            aim.ray(i % CLASSES, mesh.corners(triangle))
        })
        .collect()
}

/// Rays of a bundle: as many as a structure has in a packet, or a multiple of them.
pub const BUNDLE: usize = 32;

/// A bundle of rays for each of some: itself, twice, and others around it, near and less near. These go
/// together where a structure traces packets, if those before them fill packets.
#[must_use]
pub fn bundles_around(rays: &[Ray]) -> Vec<Ray> {
    let mut random = Random::new(&[7]);
    let mut bundles = Vec::with_capacity(BUNDLE * rays.len());
    for (number, ray) in rays.iter().enumerate() {
        let spread = [0.0, 1e-7, 1e-4, 1e-2, 0.2][number % 5];
        for copy in 0..BUNDLE {
            let mut near = *ray;
            if copy > 1 {
                let length = ray.dir.length().min(1e18);
                near.dir += spread * length * random_point(&mut random);
                if copy % 2 == 0 {
                    near.origin += spread * random_point(&mut random);
                }
                match copy % 5 {
                    0 => near.t_max = 2.0 * random.next_f32(),
                    1 => near.t_max = f32::INFINITY,
                    _ => {}
                }
            }
            bundles.push(near);
        }
    }
    bundles
}

/// Rays that begin, or end, exactly at the hits of others, or one float beside them.
#[must_use]
pub fn rays_cut_at_hits(rays: &[Ray], hits: &[Hit]) -> Vec<Ray> {
    let cut = |(i, (ray, hit)): (usize, (&Ray, &Hit))| {
        hit.is_hit().then(|| match i % 4 {
            0 => Ray { t_max: hit.t, ..*ray },
            1 => Ray { t_max: hit.t.next_down(), ..*ray },
            2 => Ray { t_min: hit.t, ..*ray },
            _ => Ray { t_min: hit.t.next_up(), ..*ray },
        })
    };
    rays.iter().zip(hits).enumerate().filter_map(cut).collect()
}

struct Aim {
    random: Random,
    center: Vec3,
    extent: f32,
}

impl Aim {
    fn ray(&mut self, class: usize, corners: [Vec3; 3]) -> Ray {
        let k = self.random.below(3) as usize;
        let (corner, next) = (corners[k], corners[(k + 1) % 3]);
        let inside = self.inside(corners);
        let target = if self.coin() { corner } else { inside };
        let origin = self.origin();
        match class {
            0 => Ray::new(origin, self.center + self.extent * self.unit() - origin),
            1 => Ray::new(origin, corner - origin), // through a vertex
            2 => Ray::new(origin, corner + self.random.next_f32() * (next - corner) - origin),
            3 => self.along_edge(corner, next),
            4 => self.axis_parallel(target, k, 2.0),
            5 => self.with_component(target, k, 0.0),
            6 => self.in_plane(corners, inside),
            7 => Ray::new(inside, self.unit()), // from the surface
            8 => self.ray_from_afar(target),
            9 => self.axis_parallel(target, k, 1000.0),
            10 => self.of_odd_length(origin, inside),
            _ => {
                let tiny = [1e-18, -1e-18, 1e-12, 1e-8, -1e-25, 1e-40, -1e-45];
                let tiny = tiny[self.random.below(7) as usize];
                self.with_component(target, k, tiny)
            }
        }
    }

    fn coin(&mut self) -> bool {
        self.random.below(2) == 0
    }

    fn unit(&mut self) -> Vec3 {
        random_point(&mut self.random).normalize_or(Vec3::X)
    }

    /// A point inside, on, or outside of the mesh's surroundings.
    fn origin(&mut self) -> Vec3 {
        let distance = [0.3, 1.0, 3.0][self.random.below(3) as usize];
        self.center + distance * self.extent * self.unit()
    }

    fn inside(&mut self, [a, b, c]: [Vec3; 3]) -> Vec3 {
        let [mut u, mut v] = self.random.next_pair();
        if u + v > 1.0 {
            (u, v) = (1.0 - u, 1.0 - v);
        }
        a + u * (b - a) + v * (c - a)
    }

    fn along_edge(&mut self, corner: Vec3, next: Vec3) -> Ray {
        let start = [0.0, 1.0, 2.5, -0.5][self.random.below(4) as usize];
        Ray::new(corner - start * (next - corner), next - corner)
    }

    fn axis_parallel(&mut self, target: Vec3, axis: usize, distance: f32) -> Ray {
        let sign = if self.coin() { 1.0 } else { -1.0 };
        let mut dir = Vec3::from_array(std::array::from_fn(|_| self.zero()));
        dir[axis] = sign;
        let mut origin = target;
        origin[axis] -= sign * self.extent * distance;
        Ray::new(origin, dir)
    }

    /// Zero, of either sign.
    fn zero(&mut self) -> f32 {
        if self.coin() { 0.0 } else { -0.0 }
    }

    /// A ray that hardly moves along one axis, and starts at the target's coordinate there.
    fn with_component(&mut self, target: Vec3, axis: usize, value: f32) -> Ray {
        let mut dir = self.unit();
        dir[axis] = if value == 0.0 { self.zero() } else { value };
        let mut origin = target - self.extent * dir;
        origin[axis] = target[axis];
        Ray::new(origin, dir)
    }

    fn in_plane(&mut self, [a, b, c]: [Vec3; 3], inside: Vec3) -> Ray {
        let [x, y] = self.random.next_pair();
        let dir = ((b - a) * (4.0 * x - 2.0) + (c - a) * (4.0 * y - 2.0)).normalize_or(Vec3::X);
        Ray::new(inside - self.extent * self.random.next_f32() * dir, dir)
    }

    fn ray_from_afar(&mut self, target: Vec3) -> Ray {
        let origin = self.center + 1000.0 * self.extent * self.unit();
        Ray::new(origin, target - origin)
    }

    /// A direction far from unit length, down to where its square leaves the range of floats.
    fn of_odd_length(&mut self, origin: Vec3, target: Vec3) -> Ray {
        let lengths = [1e-6, 1e6, 1e-12, 1e12, 1e-20, 1e15, 1e-36, 1e-40];
        let length = lengths[self.random.below(8) as usize];
        Ray::new(origin, (target - origin).normalize_or(Vec3::X) * length)
    }
}
