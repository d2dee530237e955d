//! The camera: from a point of the picture to a ray.

use glam::{DVec3, Vec3};

use crate::description;
use crate::math::{Ray, SizeRange};

use super::SceneError;

/// A pinhole camera with an orthonormal frame (e, u, v, w).
///
/// A point (i, j) of the picture, in pixels from the centre of the lower left one, is seen along
/// **s** − **e** with **s** = **e** + u·**u** + v·**v** − n·**w**; the frame is scaled so that one
/// step in i or j is one pixel.
#[derive(Clone, Debug)]
pub struct Camera {
    /// Width of the picture in pixels.
    pub width: u32,
    /// Height of the picture in pixels.
    pub height: u32,
    eye: Vec3,
    corner: DVec3,
    step_right: DVec3,
    step_up: DVec3,
    description: description::Camera,
}

impl Camera {
    /// Sets up the frame of a camera.
    ///
    /// # Errors
    /// If the direction is zero or parallel to the up vector, or if the eye or the image rectangle
    /// leaves the range of single precision.
    pub fn new(camera: &description::Camera) -> Result<Self, SceneError> {
        const WORLD: SizeRange = SizeRange::WORLD;
        let framed = Self::framed(camera).ok_or(SceneError::Camera)?;
        let near_enough = WORLD.holds_at(camera.eye) && WORLD.holds_at(framed.corner);
        if near_enough && camera.distance >= WORLD.smallest {
            Ok(framed)
        } else {
            Err(SceneError::CameraOutOfRange)
        }
    }

    /// A camera, if it has a frame; that does not depend on the picture's size.
    fn framed(camera: &description::Camera) -> Option<Self> {
        let w = -camera.direction.try_normalize()?;
        let u = camera.up.cross(w).try_normalize()?;
        let v = w.cross(u);
        let (nx, ny) = (f64::from(camera.width), f64::from(camera.height));
        let top = camera.distance * libm::tan(0.5 * camera.fovy_degrees.to_radians());
        let pixel = 2.0 * top / ny;
        // Pixel (−½, −½) is the corner (l, b) of the image rectangle.
        let corner =
            -camera.distance * w - (0.5 * nx - 0.5) * pixel * u - (0.5 * ny - 0.5) * pixel * v;
        Some(Self {
            width: camera.width,
            height: camera.height,
            eye: camera.eye.as_vec3(),
            corner,
            step_right: pixel * u,
            step_up: pixel * v,
            description: camera.clone(),
        })
    }

    /// As it was described.
    pub(super) fn description(&self) -> &description::Camera {
        &self.description
    }

    /// The same view in a picture of another size. The vertical field of view stays.
    #[must_use]
    pub fn resized(&self, width: u32, height: u32) -> Self {
        let camera = description::Camera { width, height, ..self.description.clone() };
        Self::framed(&camera).unwrap_or_else(|| self.clone())
    }

    /// The ray through a point of the picture: i from the left, j from the bottom, in pixels, the
    /// centre of the lower left pixel being (0, 0). Hits count from the eye on.
    #[inline]
    #[must_use]
    pub fn ray(&self, i: f64, j: f64) -> Ray {
        Ray::new(self.eye, (self.corner + i * self.step_right + j * self.step_up).as_vec3())
    }

    /// Where a point is seen: (i·z, j·z, z) with the place (i, j) in the picture, as [`ray`](Self::ray) takes it, and z
    /// how many times as far as the image plane it is, along the direction of view; the ray through (i, j) is there at
    /// t = z. Not divided, because a line stays one, even where it passes behind the eye, with z below 0.
    #[must_use]
    pub fn project(&self, point: DVec3) -> DVec3 {
        let from_eye = point - self.eye.as_dvec3();
        let ahead = self.step_right.cross(self.step_up);
        let z = from_eye.dot(ahead) / self.corner.dot(ahead);
        let along = |step: DVec3| (from_eye - z * self.corner).dot(step) / step.length_squared();
        DVec3::new(along(self.step_right), along(self.step_up), z)
    }

    /// From one point of the picture to those a pixel further to the right and above: what a ray's
    /// direction changes by.
    #[must_use]
    pub fn steps(&self) -> [Vec3; 2] {
        [self.step_right, self.step_up].map(|step| step.as_vec3())
    }

    /// The eye.
    #[must_use]
    pub fn eye(&self) -> Vec3 {
        self.eye
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> description::Camera {
        description::Camera {
            eye: DVec3::new(0.0, -2.0, 1.0),
            direction: DVec3::new(0.0, 3.0, 0.0),
            up: DVec3::new(0.0, 1.0, 5.0),
            distance: 2.0,
            fovy_degrees: 90.0,
            width: 4,
            height: 2,
        }
    }

    #[test]
    fn corners_of_the_picture_are_corners_of_the_image_rectangle() {
        let c = Camera::new(&camera()).unwrap();
        // n = 2, t = 2·tan 45° = 2, r = t·nx/ny = 4.
        let near = |i, j, s: Vec3| (c.ray(i, j).at(1.0) - s).length() < 1e-5;
        assert!(near(-0.5, -0.5, Vec3::new(-4.0, 0.0, -1.0)));
        assert!(near(3.5, 1.5, Vec3::new(4.0, 0.0, 3.0)));
        assert!(near(1.5, 0.5, Vec3::new(0.0, 0.0, 1.0)));
    }

    #[test]
    fn a_point_is_seen_where_the_ray_to_it_passes() {
        let camera = Camera::new(&camera()).unwrap();
        for (i, j, t) in [(0.0, 0.0, 1.0), (3.0, 1.0, 2.5), (-7.0, 0.25, 40.0)] {
            let seen = camera.project(camera.ray(i, j).at(t as f32).as_dvec3());
            let expected = DVec3::new(i * t, j * t, t);
            assert!(seen.distance(expected) < 1e-4 * t, "{seen} {expected}");
        }
        let behind = camera.project(camera.ray(1.0, 1.0).at(-2.0).as_dvec3());
        assert!((behind.z + 2.0).abs() < 1e-5);
    }

    #[test]
    fn a_degenerate_frame_is_refused() {
        let mut parallel = camera();
        parallel.up = DVec3::new(0.0, -1.0, 0.0);
        assert_eq!(Camera::new(&parallel).unwrap_err(), SceneError::Camera);
    }

    #[test]
    fn lengths_that_single_precision_cannot_multiply_are_refused() {
        let with = |eye: f64, distance, fovy_degrees| {
            let eye = DVec3::new(0.0, eye, 0.0);
            Camera::new(&description::Camera { eye, distance, fovy_degrees, ..camera() }).err()
        };
        assert_eq!(with(1e9, 1e-9, 40.0), None);
        assert_eq!(with(1e9, 1e8, 40.0), None);
        for (eye, distance, fovy) in
            [(1e10, 1.0, 40.0), (0.0, 1e-10, 40.0), (0.0, 1e10, 40.0), (0.0, 1.0, 180.0 - 1e-9)]
        {
            assert_eq!(with(eye, distance, fovy), Some(SceneError::CameraOutOfRange));
        }
    }
}
