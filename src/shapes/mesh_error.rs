//! What can be wrong with the triangles that a set is to be made of.

use glam::Vec3;

/// Why there is no [`TriangleSet`](super::TriangleSet): the first triangle that is wrong, and how.
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
    /// Corners so far apart that an edge between them is no finite number.
    #[error("triangle {triangle} is too large: its edges leave the range of single precision")]
    TooLarge {
        /// Which triangle.
        triangle: usize,
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
    pub(super) fn of_first(positions: &[Vec3], triangles: &[[u32; 3]]) -> Option<Self> {
        triangles.iter().enumerate().find_map(|(i, corners)| Self::of(positions, i, corners))
    }

    fn of(positions: &[Vec3], triangle: usize, corners: &[u32; 3]) -> Option<Self> {
        let vertices = positions.len();
        for &vertex in corners {
            match positions.get(vertex as usize) {
                None => return Some(Self::NoVertex { triangle, vertex, vertices }),
                Some(&position) if !position.is_finite() => {
                    return Some(Self::NotFinite { triangle, vertex, position });
                }
                Some(_) => {}
            }
        }
        let corners = corners.map(|vertex| positions[vertex as usize]);
        let finite = super::Triangle::new(corners).is_finite();
        (!finite).then_some(Self::TooLarge { triangle })
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
        assert!(refused(&positions, &[[2, 3, 0]]).contains("triangle 0 is too large"));
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
