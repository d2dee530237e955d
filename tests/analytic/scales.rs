//! Neither dark specks nor leaks of light, from a thousandth to a million, near the origin and far.

use glam::DVec3;
use srt::math::Color;

use super::common::{depths, picture_of, scene};
use super::view::View;

/// A place to put a scene: everything is scaled, then moved.
#[derive(Clone, Copy, Debug)]
struct Place {
    scale: f64,
    offset: DVec3,
}

/// All scales, about the origin and a thousand times the size of things away from it.
fn places() -> Vec<Place> {
    let far = DVec3::new(800.0, -500.0, 330.0);
    let scales = [1e-3, 1.0, 1e3, 1e6];
    let offsets = [DVec3::ZERO, far / 100.0, far];
    scales.into_iter().flat_map(|s| offsets.map(|o| Place { scale: s, offset: s * o })).collect()
}

impl Place {
    fn point(&self, p: DVec3) -> DVec3 {
        self.offset + self.scale * p
    }

    fn view(&self, eye: DVec3, dir: DVec3) -> View {
        let eye = self.point(eye);
        View { eye, dir, up: DVec3::Z, fovy_degrees: 60.0, width: 128, height: 96 }
    }

    /// A scene with one light at `light`, in which `objects` are scaled and moved.
    fn text(&self, view: &View, light: DVec3, objects: &str) -> String {
        let (light, o, s) = (self.point(light), self.offset, self.scale);
        format!(
            "{}ca 0.25 0.25 0.25\npointlight {:e} {:e} {:e} 0.5 0.5 0.5\n\
             translate {:e} {:e} {:e}\nscale {s:e} {s:e} {s:e}\n{objects}\n",
            view.commands(),
            light.x,
            light.y,
            light.z,
            o.x,
            o.y,
            o.z
        )
    }
}

/// The pixels of a picture that are not as they should be.
#[derive(Default)]
struct Wrong {
    count: u32,
    first: Option<(usize, f64, f64)>,
}

impl Wrong {
    fn unless(&mut self, right: bool, pixel: usize, got: f64, expected: f64) {
        if !right {
            self.count += 1;
            self.first.get_or_insert((pixel, got, expected));
        }
    }

    fn report(&self, objects: &str, place: Place) -> Option<String> {
        let (pixel, got, expected) = self.first?;
        let count = self.count;
        Some(format!(
            "{objects}\n  at {place:?}: {count} pixels, the first is {pixel}: {got}, not {expected}"
        ))
    }
}

/// Convex things: what faces the light is lit.
const CONVEX: [&str; 7] = [
    "ball 1 0 0 0",
    "scale 1 0.3 1.2\nball 1 0 0 0",
    "translate 0 0 -1\nscale 0.8 0.8 2\ncylinder",
    "rotate 50 1 1 0\nscale 1.2 0.5 0.2\ncylinder",
    "object_flat generate:icosphere:320",
    "rotate 20 1 0 0\nscale 1.2 0.4 1\nobject_flat generate:icosphere:5000",
    "triangle -9 -9 -1  9 -9 -1  9 9 -1\ntriangle -9 -9 -1  9 9 -1  -9 9 -1",
];

/// Things with an inside.
const CLOSED: [&str; 6] = [
    "ball 2 0 0 0",
    "scale 2 3 2.5\nball 1 0 0 0",
    "translate 0 0 -1.5\nscale 2 2 3\ncylinder",
    "scale 2 2 2\nobject_flat generate:icosphere:320",
    "rotate 30 1 2 3\nscale 2 3 2.5\nobject_phong generate:icosphere:2000",
    BOX,
];

const BOX: &str = "
triangle -2 -2 -2  2 -2 -2  2 2 -2
triangle -2 -2 -2  2 2 -2  -2 2 -2
triangle -2 -2 2  2 -2 2  2 2 2
triangle -2 -2 2  2 2 2  -2 2 2
triangle -2 -2 -2  2 -2 -2  2 -2 2
triangle -2 -2 -2  2 -2 2  -2 -2 2
triangle -2 2 -2  2 2 -2  2 2 2
triangle -2 2 -2  2 2 2  -2 2 2
triangle -2 -2 -2  -2 2 -2  -2 2 2
triangle -2 -2 -2  -2 2 2  -2 -2 2
triangle 2 -2 -2  2 2 -2  2 2 2
triangle 2 -2 -2  2 2 2  2 -2 2";

#[test]
fn what_faces_the_light_is_lit() {
    let light = DVec3::new(3.0, -4.0, 5.0);
    let mut all = Vec::new();
    for place in places() {
        let view = place.view(DVec3::new(0.0, -4.0, 1.0), DVec3::new(0.0, 4.0, -1.0));
        for objects in CONVEX {
            let scene = scene(&place.text(&view, light, objects));
            let colors = picture_of(&scene, srt::render::View::Color);
            let normals = picture_of(&scene, srt::render::View::Normal);
            let depths = depths(&scene);
            let mut hits = 0;
            let mut wrong = Wrong::default();
            for (i, dir) in view.directions().into_iter().enumerate() {
                if depths[i].is_nan() {
                    continue;
                }
                hits += 1;
                let point = view.eye + f64::from(depths[i]) * dir;
                let normal = (2.0 * normals.pixels[i] - Color::ONE).as_dvec3();
                let cosine = normal.dot((place.point(light) - point).normalize()).max(0.0);
                let (got, expected) = (f64::from(colors.pixels[i].x), 0.25 + 0.5 * cosine);
                wrong.unless((got - expected).abs() < 2e-3, i, got, expected);
            }
            assert!(hits > 500, "{objects} at {place:?}: {hits}");
            all.extend(wrong.report(objects, place));
        }
    }
    assert!(all.is_empty(), "\n{}", all.join("\n"));
}

#[test]
fn what_the_light_sees_is_lit() {
    // The eye is where the light is, so no shadow can be seen.
    let eye = DVec3::new(2.0, -5.0, 4.0);
    let floor = "triangle -9 -9 -1  9 -9 -1  9 9 -1\ntriangle -9 -9 -1  9 9 -1  -9 9 -1";
    let mut all = Vec::new();
    for place in places() {
        let view = place.view(eye, -eye);
        for objects in CONVEX {
            let text = format!("{floor}\n{objects}");
            let scene = scene(&place.text(&view, eye, &text));
            let colors = picture_of(&scene, srt::render::View::Color);
            let normals = picture_of(&scene, srt::render::View::Normal);
            let mut wrong = Wrong::default();
            for (i, dir) in view.directions().into_iter().enumerate() {
                if colors.pixels[i] == Color::ZERO {
                    continue; // past the end of the floor
                }
                let normal = (2.0 * normals.pixels[i] - Color::ONE).as_dvec3();
                let (got, expected) = (f64::from(colors.pixels[i].x), 0.25 - 0.5 * normal.dot(dir));
                wrong.unless((got - expected).abs() < 2e-3, i, got, expected);
            }
            all.extend(wrong.report(objects, place));
        }
    }
    assert!(all.is_empty(), "\n{}", all.join("\n"));
}

#[test]
fn no_light_gets_into_what_is_closed() {
    let mut all = Vec::new();
    for place in places() {
        let view = place.view(DVec3::new(0.1, -0.5, 0.2), DVec3::new(0.1, 1.0, -0.3));
        for objects in CLOSED {
            for light in [DVec3::new(3.0, -7.0, 5.0), DVec3::new(0.0, 0.0, 6.0)] {
                let scene = scene(&place.text(&view, light, objects));
                let picture = picture_of(&scene, srt::render::View::Color);
                let mut wrong = Wrong::default();
                for (i, &pixel) in picture.pixels.iter().enumerate() {
                    let dark = pixel == Color::splat(0.25);
                    wrong.unless(dark, i, f64::from(pixel.x), 0.25);
                }
                all.extend(wrong.report(objects, place));
            }
        }
    }
    assert!(all.is_empty(), "\n{}", all.join("\n"));
}
