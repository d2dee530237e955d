//! The penumbra of an edge: as wide, and at each place as bright, as the visible part of the light.

use glam::DVec3;
use srt::render::Settings;

use super::common::{picture, scene};
use super::view::View;

/// Half the side of the light, its height, and that of the edge.
const HALF: f64 = 1.0;
const LIGHT: f64 = 8.0;
const EDGE: f64 = 2.0;

#[test]
fn a_penumbra_is_as_wide_as_geometry_says() {
    // From below the edge straight down.
    let view = View {
        eye: DVec3::new(0.0, 0.0, 1.5),
        dir: DVec3::NEG_Z,
        up: DVec3::Y,
        fovy_degrees: 5.0,
        width: 200,
        height: 12,
    };
    let text = |with_edge: bool| {
        let edge = if with_edge {
            format!("triangle 0 -99 {EDGE}  0 99 {EDGE}  -999 0 {EDGE}\n")
        } else {
            String::new()
        };
        format!(
            "{}ca 0 0 0
             triangle -99 -99 0  99 -99 0  99 99 0
             triangle -99 -99 0  99 99 0  -99 99 0
             {edge}translate 0 0 {LIGHT}
             arealight {HALF} 1 1 1\n",
            view.commands()
        )
    };
    let render = |with_edge: bool| {
        let scene = scene(&text(with_edge));
        picture(&scene, &Settings { light_samples: 16, ..Settings::of_scene(&scene) })
    };
    let (shaded, open) = (render(true), render(false));
    let half_width = HALF * EDGE / (LIGHT - EDGE);
    let mut inside = 0;
    for (i, dir) in view.directions().into_iter().enumerate() {
        let x = view.eye.x - view.eye.z / dir.z * dir.x;
        // A point sees the part of the light beyond u = −x·(H − k)/k.
        let visible = (0.5 + 0.5 * x / half_width).clamp(0.0, 1.0);
        let share = f64::from(shaded.pixels[i].x / open.pixels[i].x);
        if x.abs() > half_width * 1.0001 {
            assert_eq!(share, visible, "outside of the penumbra, at {x}");
        } else {
            inside += 1;
            // Two of sixteen strata at most are cut by the edge.
            assert!((share - visible).abs() < 0.07, "at {x}: {share}, not {visible}");
        }
    }
    assert!(inside > 500, "{inside}");
}
