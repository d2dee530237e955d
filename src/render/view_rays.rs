//! From a pixel to the rays of its samples.

use std::ops::Range;

use glam::{DVec2, Vec2, Vec3};

use crate::math::{Random, Ray, unit_pair};
use crate::scene::Camera;

use super::Settings;

/// A pixel of the whole picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pixel {
    /// Column from the left.
    pub(super) x: u32,
    /// Row from the top.
    pub(super) y: u32,
}

impl Pixel {
    /// What a pixel's random numbers depend on.
    pub(super) fn key(self) -> u64 {
        u64::from(self.y) << 32 | u64::from(self.x)
    }
}

/// The view rays of a rendering.
pub(super) struct ViewRays {
    camera: Camera,
    seed: u64,
    /// For each sample of a pixel the lower left corner of its cell, from the pixel's centre.
    cells: Vec<Vec2>,
    /// The side of a cell; 0 if there is one sample, in the centre.
    cell_side: f32,
    /// From the centre of a pixel to those to the right and above.
    steps: [Vec3; 2],
}

impl ViewRays {
    pub(super) fn new(camera: Camera, settings: &Settings) -> Self {
        let n = settings.aa;
        let corner = |k: u32| k as f32 / n as f32 - 0.5;
        let cells = match n {
            0 => vec![Vec2::ZERO],
            _ => (0..n * n).map(|k| Vec2::new(corner(k % n), corner(k / n))).collect(),
        };
        let cell_side = if n == 0 { 0.0 } else { 1.0 / n as f32 };
        let steps = camera.steps();
        Self { camera, seed: settings.seed, cells, cell_side, steps }
    }

    /// For some samples of a pixel, by their numbers, the random key, and the ray through a random place in the
    /// sample's cell.
    ///
    /// The way from the pixel's centre is added in `f32`: it is so short that its error is far
    /// below that of the direction's last rounding.
    #[inline]
    pub(super) fn of_pixel(
        &self,
        pixel: Pixel,
        samples: Range<u32>,
    ) -> impl Iterator<Item = (u64, Ray)> {
        let center = self.through_center(pixel);
        let [right, up] = self.steps;
        let mut keys = Random::new(&[self.seed, pixel.key()]);
        keys.skip(samples.start.into());
        self.cells[samples.start as usize..samples.end as usize].iter().map(move |&cell| {
            let key = keys.next_u64();
            let place = cell + Vec2::from_array(unit_pair(key)) * self.cell_side;
            (key, Ray { dir: center.dir + (place.x * right + place.y * up), ..center })
        })
    }

    /// The ray through the centre of a pixel.
    pub(super) fn through_center(&self, pixel: Pixel) -> Ray {
        let center = self.center(pixel);
        self.camera.ray(center.x, center.y)
    }

    /// Where the camera has the centre of a pixel: rows count from the bottom there.
    fn center(&self, pixel: Pixel) -> DVec2 {
        let below = f64::from(self.camera.height) - 1.0 - f64::from(pixel.y);
        DVec2::new(f64::from(pixel.x), below)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description;
    use crate::render::{Sampling, View};
    use glam::DVec3;

    fn view_rays(aa: u32) -> ViewRays {
        let (width, height) = (8, 4);
        let camera = Camera::new(&description::Camera {
            eye: DVec3::ZERO,
            direction: DVec3::Y,
            up: DVec3::Z,
            distance: 1.0,
            fovy_degrees: 90.0,
            width,
            height,
        })
        .unwrap();
        let settings = Settings {
            width,
            height,
            crop: None,
            aa,
            light_samples: 1,
            sampling: Sampling::default(),
            max_recursion: 0,
            seed: 5,
            view: View::default(),
            count: false,
        };
        ViewRays::new(camera, &settings)
    }

    /// Where a ray crosses the picture, in pixels from its upper left corner.
    fn place(ray: &Ray) -> DVec2 {
        let dir = ray.dir.as_dvec3() / f64::from(ray.dir.y);
        DVec2::new(4.0 + 2.0 * dir.x, 2.0 - 2.0 * dir.z)
    }

    #[test]
    fn one_sample_goes_through_the_centre() {
        let rays = view_rays(0);
        let pixel = Pixel { x: 6, y: 1 };
        let (_, ray) = rays.of_pixel(pixel, 0..1).next().unwrap();
        assert!(place(&ray).distance(DVec2::new(6.5, 1.5)) < 1e-6);
        assert_eq!(ray, rays.through_center(pixel));
        assert_eq!(rays.of_pixel(pixel, 0..1).count(), 1);
    }

    #[test]
    fn each_sample_has_its_cell() {
        for pixel in [Pixel { x: 0, y: 0 }, Pixel { x: 7, y: 3 }] {
            let corner = DVec2::new(f64::from(pixel.x), f64::from(pixel.y));
            let mut cells: Vec<_> = view_rays(3)
                .of_pixel(pixel, 0..9)
                .map(|(_, ray)| ((place(&ray) - corner) * 3.0).floor().to_array())
                .map(|cell| cell.map(|c| c as i32))
                .collect();
            cells.sort_unstable();
            let expected: Vec<_> = (0..3).flat_map(|i| (0..3).map(move |j| [i, j])).collect();
            assert_eq!(cells, expected);
        }
    }

    #[test]
    fn samples_do_not_depend_on_those_beside_them() {
        let (rays, pixel) = (view_rays(3), Pixel { x: 4, y: 2 });
        let all: Vec<_> = rays.of_pixel(pixel, 0..9).collect();
        for (start, end) in [(0, 1), (2, 5), (8, 9), (0, 9), (4, 4)] {
            let some: Vec<_> = rays.of_pixel(pixel, start..end).collect();
            assert_eq!(some, all[start as usize..end as usize]);
        }
    }
}
