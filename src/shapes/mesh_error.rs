//! What can be wrong with the triangles of a mesh.

use glam::Vec3;

use crate::math::{Aabb, SizeRange};

/// Why there is no [`TriangleMesh`](super::TriangleMesh): the first triangle that is wrong, and how.
#[derive(Clone, Debug, thiserror::Error, PartialEq)]
pub enum MeshError {
    /// An index beyond the vertices.
    #[error("triangle {triangle} names vertex {vertex}, and there are {vertices}, counted from 0")]
    NoVertex {
        /// Which triangle.
        triangle: usize,
        /// What it names.
        vertex: u32,
        /// How many there are.
        vertices: usize,
    },
    /// A corner with a NaN or an infinity.
    #[error("triangle {triangle} has a corner that is not finite: vertex {vertex} at {position}")]
    NotFinite {
        /// Which triangle.
        triangle: usize,
        /// Which vertex.
        vertex: u32,
        /// Where it is.
        position: Vec3,
    },
    /// All together reach too far, or are too small, for products of their lengths in single precision.
    #[error(
        "the triangles reach to {largest:e}, and the longest side of their box is {side:e}: coordinates \
         may be up to {:e}, and that side must be at least {:e}",
        SizeRange::TRIANGLES.largest,
        SizeRange::TRIANGLES.smallest
    )]
    OutOfRange {
        /// The largest coordinate.
        largest: f32,
        /// The longest side of the box around them.
        side: f32,
    },
    /// Another number of triangles than those that are to be moved. That the same vertices make each triangle is not
    /// looked at.
    #[error("{triangles} triangles are none that have moved: there were {before}")]
    OtherTriangles {
        /// How many there are.
        triangles: usize,
        /// How many there were.
        before: usize,
    },
    /// More than ids can name.
    #[error("{triangles} triangles are too many: 2^32 - 1 is the most")]
    TooMany {
        /// How many.
        triangles: usize,
    },
}

impl MeshError {
    /// What is wrong with the first of some triangles that is.
    ///
    /// # Panics
    /// If nothing is wrong with any.
    pub(super) fn of_first(positions: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        let mut each = triangles.iter().enumerate();
        let first = each.find_map(|(i, corners)| Self::of(positions, i, corners));
        first.expect("a corner is missing or not finite")
    }

    /// What is wrong with all of them, by the box around them: it is out of
    /// [`SizeRange::TRIANGLES`]. Those that lie in one point are hit by nothing, and that is right.
    pub(super) fn of_bounds(bounds: &Aabb) -> Option<Self> {
        let (largest, side) = (bounds.largest_coordinate(), bounds.size().max_element());
        let is_point = side == 0.0 && f64::from(largest) <= SizeRange::TRIANGLES.largest;
        let is_fine = bounds.is_empty() || is_point || SizeRange::TRIANGLES.holds_for(bounds);
        (!is_fine).then_some(Self::OutOfRange { largest, side })
    }

    fn of(positions: &[Vec3], triangle: usize, corners: &[u32; 3]) -> Option<Self> {
        let vertices = positions.len();
        corners.iter().find_map(|&vertex| match positions.get(vertex as usize) {
            None => Some(Self::NoVertex { triangle, vertex, vertices }),
            Some(&position) if !position.is_finite() => {
                Some(Self::NotFinite { triangle, vertex, position })
            }
            Some(_) => None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::TriangleSet;

    const POSITIONS: [Vec3; 4] = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];

    fn refused(positions: &[Vec3], triangles: &[[u32; 3]]) -> String {
        TriangleSet::try_new(positions, triangles).unwrap_err().to_string()
    }

    #[test]
    fn the_first_wrong_triangle_is_named() {
        let mut positions = POSITIONS;
        assert_eq!(
            refused(&positions, &[[0, 1, 2], [0, 1, 4], [5, 0, 0]]),
            "triangle 1 names vertex 4, and there are 4, counted from 0"
        );
        positions[3].y = f32::NAN;
        assert_eq!(
            refused(&positions, &[[0, 1, 2], [0, 1, 2], [0, 3, 1]]),
            "triangle 2 has a corner that is not finite: vertex 3 at [0, NaN, 1]"
        );
        positions[3].y = f32::NEG_INFINITY;
        assert!(refused(&positions, &[[3, 1, 2]]).contains("-inf"));
        positions[3] = Vec3::splat(f32::MAX);
        positions[2] = Vec3::splat(f32::MIN);
        assert!(refused(&positions, &[[2, 3, 0]]).contains("reach to 3.4028235e38"));
    }

    #[test]
    fn what_is_too_far_away_or_too_small_is_refused_with_the_range() {
        let at = |scale: f32, offset: f32| {
            let place = |p: Vec3| scale * p + Vec3::splat(offset);
            TriangleSet::try_new(&POSITIONS.map(place), &[[0, 1, 2], [1, 2, 3]])
        };
        for (scale, offset) in [(1e12, 0.0), (1.0, 1e5), (1.1e-10, 0.0), (0.0, 1e9)] {
            assert!(at(scale, offset).is_ok(), "{scale:e} {offset:e}");
        }
        for (scale, offset) in
            [(1.1e12, 0.0), (1e15, 0.0), (1e19, 0.0), (0.9e-10, 0.0), (1e-23, 0.0)]
        {
            assert!(matches!(at(scale, offset), Err(MeshError::OutOfRange { .. })), "{scale:e}");
        }
        assert!(at(0.0, 1e13).is_err() && at(1e9, 2e12).is_err());
        assert_eq!(
            at(2e12, 0.0).unwrap_err().to_string(),
            "the triangles reach to 2e12, and the longest side of their box is 2e12: coordinates may \
             be up to 1e12, and that side must be at least 1e-10"
        );
    }

    #[test]
    fn vertices_that_no_triangle_names_may_be_anything() {
        let positions = [Vec3::NAN, Vec3::X, Vec3::Y, Vec3::Z];
        let set = TriangleSet::try_new(&positions, &[[1, 2, 3]]).unwrap();
        assert_eq!(set.triangle_count(), 1);
    }

    #[test]
    #[should_panic(expected = "triangle 0 names vertex 7")]
    fn new_panics_with_the_same_words() {
        let _ = TriangleSet::new(&POSITIONS, &[[0, 1, 7]]);
    }
}
