//! What single precision can hold of the numbers, vectors and transforms of a scene.
//!
//! Scenes are read in double precision and traced in single precision.

use glam::{DAffine3, DVec3};

/// The smallest height of a triangle over its base, relative to its edges, that double precision
/// distinguishes from 0.
const SMALLEST_SINE: f64 = 1e-12;

/// Whether a number is 0, or so small that single precision has no normal number for it.
pub(super) fn is_zero(number: f64) -> bool {
    number.abs() < f64::from(f32::MIN_POSITIVE)
}

/// Whether a vector is too short to have a direction.
pub(super) fn is_zero_vector(v: DVec3) -> bool {
    is_zero(v.abs().max_element())
}

/// Whether a point is finite in single precision.
pub(super) fn holds_point(point: DVec3) -> bool {
    point.as_vec3().is_finite()
}

/// Whether a transform is finite in single precision.
pub(super) fn holds_transform(matrix: &DAffine3) -> bool {
    let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis, matrix.translation];
    columns.iter().all(|&column| holds_point(column))
}

/// Whether the corners lie on a line, as written or in single precision.
pub(super) fn is_degenerate(corners: [DVec3; 3]) -> bool {
    let has_no_area = |[a, b, c]: [DVec3; 3]| !has_area(b - a, c - a);
    let rounded = corners.map(|corner| corner.as_vec3().as_dvec3());
    has_no_area(corners) || has_no_area(rounded)
}

/// Whether two vectors span a parallelogram with an area.
pub(super) fn has_area(u: DVec3, v: DVec3) -> bool {
    let longest = |w: DVec3| w.abs().max_element();
    // Scaled first, so that no product overflows or is lost.
    let cross = (u / longest(u)).cross(v / longest(v));
    // NaN, from a vector of length 0, has no area.
    cross.length() > SMALLEST_SINE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_on_a_line_are_degenerate_at_every_scale() {
        for scale in [1e-30, 1.0, 1e30] {
            let at = |x: f64, y: f64| DVec3::new(x, y, 1.0) * scale;
            assert!(is_degenerate([at(0.0, 0.0), at(1.0, 0.1), at(3.0, 0.3)]));
            assert!(is_degenerate([at(0.0, 0.0), at(0.0, 0.0), at(3.0, 0.3)]));
            assert!(!is_degenerate([at(0.0, 0.0), at(1.0, 0.0), at(3.0, 1e-6)]));
        }
    }

    #[test]
    fn what_single_precision_makes_degenerate_is_degenerate() {
        let near = |x: f64, y: f64| DVec3::new(1e6 + x, y, 0.0);
        assert!(is_degenerate([near(0.0, 0.0), near(1e-3, 1.0), near(-1e-3, 2.0)]));
    }
}
