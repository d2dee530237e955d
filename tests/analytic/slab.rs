//! A slab of glass moves what is seen through it: a ray leaves it parallel to how it came, shifted
//! by d·sin θ·(1 − cos θ/√(n² − sin² θ)).

use glam::DVec3;

use super::common::{picture_of, scene};
use super::view::View;

const THICKNESS: f64 = 0.8;
const INDEX: f64 = 1.5;

#[test]
fn a_slab_shifts_rays_by_snells_law() {
    let view = View {
        eye: DVec3::new(-3.0, 0.0, 3.0),
        dir: DVec3::new(1.0, 0.0, -0.7),
        up: DVec3::Z,
        fovy_degrees: 45.0,
        width: 320,
        height: 240,
    };
    // The floor is green up to x = 0 and red beyond; the slab lies from z = 0.5 on.
    let text = format!(
        "{}max_recursion 2
         ca 1 1 1
         {{
         cr 0 1 0
         triangle -99 -99 0  0 -99 0  0 99 0
         triangle -99 -99 0  0 99 0  -99 99 0
         cr 1 0 0
         triangle 0 -99 0  99 -99 0  99 99 0
         triangle 0 -99 0  99 99 0  0 99 0
         }}
         alpha 0
         ri {INDEX}
         translate 0 0 0.5
         scale 60 60 {THICKNESS}
         cylinder\n",
        view.commands()
    );
    let picture = picture_of(&scene(&text), srt::render::View::Color);
    let (mut green, mut red, mut moved) = (0, 0, 0);
    for (dir, &pixel) in view.directions().into_iter().zip(&picture.pixels) {
        let (cos, sin) = (-dir.z, dir.truncate().length());
        if cos < 0.1 {
            continue; // towards the horizon, past the end of the slab
        }
        let shift = THICKNESS * sin * (1.0 - cos / (INDEX * INDEX - sin * sin).sqrt());
        // Seen along the floor, against the direction of travel.
        let straight = view.eye.x + view.eye.z / cos * dir.x;
        let x = straight - shift / cos * dir.x / sin;
        if x.abs() < 1e-4 {
            continue;
        }
        moved += usize::from((x < 0.0) != (straight < 0.0));
        green += usize::from(x < 0.0);
        red += usize::from(x > 0.0);
        let seen_green = pixel.y > pixel.x;
        assert_eq!(seen_green, x < 0.0, "x = {x}: {pixel}");
        assert!(pixel.max_element() > 0.4, "the floor is seen: {pixel}");
    }
    assert!(green > 5000 && red > 5000 && moved > 500, "{green} {red} {moved}");
}
