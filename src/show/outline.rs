//! The lines of a part of space, in the world.

use std::f64::consts::TAU;

use glam::{DAffine3, DVec3, Vec3};

use crate::accel::RegionForm;

/// The straight pieces of a circle.
const PIECES: u32 = 48;

/// Calls `draw` with both ends of each line of a part of space that stands under a transform, seen from an eye: the
/// edges of a box or a polytope; of a ball its contour and the circle about its z axis.
pub(super) fn outline(
    form: &RegionForm,
    transform: &DAffine3,
    eye: DVec3,
    mut draw: impl FnMut(DVec3, DVec3),
) {
    match form {
        RegionForm::Box(bounds) => {
            let corners = bounds
                .corners()
                .map(|corner| transform.transform_point3(Vec3::from(corner).as_dvec3()));
            // Two corners whose numbers differ in one bit have an edge between them.
            for (i, axis) in (0..8usize).flat_map(|i| [1, 2, 4].map(|axis| (i, axis))) {
                if i & axis == 0 {
                    draw(corners[i], corners[i | axis]);
                }
            }
        }
        RegionForm::Polytope(kdop) => {
            for [a, b] in kdop.edges() {
                draw(transform.transform_point3(a), transform.transform_point3(b));
            }
        }
        RegionForm::Ball { center, radius } => {
            let (center, radius) = (center.as_dvec3(), f64::from(*radius));
            let mut circle = |middle: DVec3, radius: f64, across: DVec3| {
                let (a, b) = across.any_orthonormal_pair();
                let at = |i: u32| {
                    let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(PIECES));
                    transform.transform_point3(middle + radius * (cos * a + sin * b))
                };
                (0..PIECES).for_each(|i| draw(at(i), at(i + 1)));
            };
            circle(center, radius, DVec3::Z);
            // Rays from the eye touch the ball in a circle; they do in the ball's own space, too.
            let to_eye = transform.inverse().transform_point3(eye) - center;
            let distance = to_eye.length();
            if distance > radius {
                let share = radius / distance;
                let out = to_eye / distance;
                circle(center + share * radius * out, radius * (1.0 - share * share).sqrt(), out);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3A;

    use super::*;
    use crate::math::Aabb;

    fn lines(form: RegionForm, transform: DAffine3, eye: DVec3) -> Vec<[DVec3; 2]> {
        let mut lines = Vec::new();
        outline(&form, &transform, eye, |a, b| lines.push([a, b]));
        lines
    }

    #[test]
    fn a_box_has_twelve_edges_as_long_as_its_sides() {
        let bounds = Aabb { min: Vec3A::ZERO, max: Vec3A::new(1.0, 2.0, 4.0) };
        let twice = DAffine3::from_scale(DVec3::splat(2.0));
        let edges = lines(RegionForm::Box(bounds), twice, DVec3::ZERO);
        assert_eq!(edges.len(), 12);
        let total: f64 = edges.iter().map(|[a, b]| a.distance(*b)).sum();
        assert!((total - 2.0 * 4.0 * (1.0 + 2.0 + 4.0)).abs() < 1e-9);
    }

    #[test]
    fn the_contour_of_a_ball_is_where_rays_from_the_eye_touch_it() {
        let form = RegionForm::Ball { center: Vec3::new(1.0, 0.0, 0.0), radius: 2.0 };
        let eye = DVec3::new(1.0, -5.0, 0.0);
        let all = lines(form, DAffine3::IDENTITY, eye);
        let contour = &all[PIECES as usize..];
        assert_eq!(contour.len(), PIECES as usize);
        for [point, _] in contour {
            let out = *point - DVec3::X;
            assert!((out.length() - 2.0).abs() < 1e-6, "on the ball");
            assert!(out.dot(*point - eye).abs() < 1e-6, "the ray lies in the tangent plane");
        }
        assert_eq!(lines(form, DAffine3::IDENTITY, DVec3::X).len(), PIECES as usize, "from within");
    }
}
