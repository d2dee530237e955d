//! A picture with its depths, and lines drawn over it: full where they are before all surfaces, faint where they are
//! hidden.

use glam::DVec3;

use crate::image_io::Picture;
use crate::math::Color;
use crate::scene::Camera;

/// How much of a line covers what is behind it: where it is seen, and where it is hidden.
const SEEN: f32 = 0.95;
const HIDDEN: f32 = 0.16;
/// A line that lies in a surface is seen: it may be farther by this share.
const SLACK: f64 = 1.002;
/// Nothing nearer to the eye than this share of the distance to the image plane is drawn.
const NEAR: f64 = 1e-3;

/// What lines are drawn on.
pub(super) struct Canvas<'a> {
    camera: &'a Camera,
    /// How many times as far as the image plane the surfaces are, row by row from the top; NaN where there is none.
    depths: &'a [f64],
    picture: Picture,
}

impl<'a> Canvas<'a> {
    /// The picture with its depths, both of the size of the camera.
    pub(super) fn new(picture: Picture, depths: &'a [f64], camera: &'a Camera) -> Self {
        Self { camera, depths, picture }
    }

    /// What was drawn.
    pub(super) fn into_picture(self) -> Picture {
        self.picture
    }

    /// Draws a line between two points of the world.
    pub(super) fn line(&mut self, from: DVec3, to: DVec3, color: Color) {
        let [mut a, mut b] = [from, to].map(|point| self.camera.project(point));
        if a.z < NEAR && b.z < NEAR {
            return;
        }
        // What is behind the eye is cut off. Along a line these three coordinates go evenly.
        let cut = |inside: DVec3, outside: DVec3| {
            inside + (inside.z - NEAR) / (inside.z - outside.z) * (outside - inside)
        };
        if a.z < NEAR {
            a = cut(b, a);
        } else if b.z < NEAR {
            b = cut(a, b);
        }
        let Some([a, b]) = self.within(a, b) else { return };
        let [start, end] = [a, b].map(|p| (p / p.z).truncate());
        let along = end - start;
        let steps = (along.abs().max_element().ceil()).max(1.0);
        let is_steep = along.y.abs() > along.x.abs();
        for step in 0..=steps as u32 {
            let share = f64::from(step) / steps;
            let place = start + share * along;
            // 1/z goes evenly in the picture.
            let depth = 1.0 / ((1.0 - share) / a.z + share / b.z);
            // The pixels on both sides share the line by how near they are (X. Wu, *An efficient antialiasing
            // technique*, 1991).
            let (main, aside) = if is_steep { (place.y, place.x) } else { (place.x, place.y) };
            let (main, low) = (main.round(), aside.floor());
            for (aside, share) in [(low, 1.0 - (aside - low)), (low + 1.0, aside - low)] {
                let (x, y) = if is_steep { (aside, main) } else { (main, aside) };
                self.dot(x, y, depth, share as f32, color);
            }
        }
    }

    /// The part of a line that lies in the picture, with a margin; both ends are as [`Camera::project`] gives them.
    fn within(&self, a: DVec3, b: DVec3) -> Option<[DVec3; 2]> {
        let (width, height) = (f64::from(self.camera.width), f64::from(self.camera.height));
        let (mut first, mut last) = (0.0f64, 1.0f64);
        let sides: [fn(DVec3, f64, f64) -> f64; 4] = [
            |p, _, _| p.x + p.z,
            |p, width, _| width * p.z - p.x,
            |p, _, _| p.y + p.z,
            |p, _, height| height * p.z - p.y,
        ];
        for side in sides {
            let (at_a, at_b) = (side(a, width, height), side(b, width, height));
            if at_a < 0.0 && at_b < 0.0 {
                return None;
            }
            let crossing = at_a / (at_a - at_b);
            if at_a < 0.0 {
                first = first.max(crossing);
            } else if at_b < 0.0 {
                last = last.min(crossing);
            }
        }
        (first < last).then(|| [a + first * (b - a), a + last * (b - a)])
    }

    /// Covers a share of a pixel, whose row counts from the bottom.
    fn dot(&mut self, x: f64, y: f64, depth: f64, share: f32, color: Color) {
        let (width, height) = (self.camera.width, self.camera.height);
        if x < 0.0 || y < 0.0 || x >= f64::from(width) || y >= f64::from(height) {
            return;
        }
        let place = (height as usize - 1 - y as usize) * width as usize + x as usize;
        let is_hidden = self.depths[place] * SLACK < depth;
        let cover = share * if is_hidden { HIDDEN } else { SEEN };
        let pixel = &mut self.picture.pixels[place];
        *pixel = pixel.lerp(color, cover);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description;

    fn camera() -> Camera {
        Camera::new(&description::Camera {
            eye: DVec3::ZERO,
            direction: DVec3::Y,
            up: DVec3::Z,
            distance: 1.0,
            fovy_degrees: 90.0,
            width: 20,
            height: 20,
        })
        .unwrap()
    }

    fn drawn(depth: f64, from: DVec3, to: DVec3) -> Picture {
        let camera = camera();
        let depths = vec![depth; 400];
        let mut canvas = Canvas::new(Picture::new(20, 20), &depths, &camera);
        canvas.line(from, to, Color::ONE);
        canvas.into_picture()
    }

    fn light(picture: &Picture) -> f32 {
        picture.pixels.iter().map(|pixel| pixel.x).sum()
    }

    #[test]
    fn a_line_is_full_before_a_surface_and_faint_behind_it() {
        let [from, to] = [-1.0, 1.0].map(|x| DVec3::new(x, 4.0, 0.0));
        let (before, behind) = (drawn(5.0, from, to), drawn(3.0, from, to));
        let ratio = light(&before) / light(&behind);
        assert!((ratio - SEEN / HIDDEN).abs() < 1e-3, "{ratio}");
        // A quarter of the way across at four times the distance of a picture of ±1: five pixels.
        assert!((light(&before) / SEEN - 6.0).abs() < 0.6, "{}", light(&before));
        assert!((light(&drawn(f64::NAN, from, to)) - light(&before)).abs() < 1e-6, "no surface");
    }

    #[test]
    fn what_is_behind_the_eye_or_beside_the_picture_is_cut_off() {
        let ahead = DVec3::new(0.0, 4.0, 0.0);
        assert_eq!(light(&drawn(9.0, -ahead, DVec3::new(1.0, -2.0, 0.0))), 0.0);
        assert_eq!(light(&drawn(9.0, DVec3::new(9.0, 4.0, 0.0), DVec3::new(9.0, 4.0, 3.0))), 0.0);
        // From the middle of the picture to behind the eye, past the right side.
        let half = drawn(9.0, ahead, DVec3::new(4.0, -4.0, 0.0));
        assert!((light(&half) / SEEN - 10.0).abs() < 1.0, "{}", light(&half));
        let huge = drawn(9.0, DVec3::new(-1e9, 4.0, 0.0), DVec3::new(1e9, 4.0, 0.0));
        assert!((light(&huge) / SEEN - 20.0).abs() < 1e-2, "{}", light(&huge));
    }
}
