//! A cube whose faces are divided evenly.

use glam::DVec3;

use super::MeshData;
use super::grid::CellGrid;

/// The cube [−1, 1]³ of 12·k² triangles, k such that it is nearest to the requested number. Faces share no vertices, so
/// their normals are flat.
pub(super) fn generate(triangles: u32) -> MeshData {
    let k = divisions(triangles);
    let face = CellGrid { columns: k, rows: k, closed_columns: false, closed_rows: false };
    let (mut positions, mut split) = (Vec::new(), Vec::new());
    for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
        // The other two axes in the order in which their cross product is this one.
        let (a, b) = (DVec3::new(axis.z, axis.x, axis.y), DVec3::new(axis.y, axis.z, axis.x));
        for (out, a, b) in [(axis, a, b), (-axis, b, a)] {
            split.extend(face.triangles(positions.len() as u32));
            positions
                .extend(face.vertices(&|u, v| out + (2.0 * u - 1.0) * a + (2.0 * v - 1.0) * b));
        }
    }
    MeshData::with_averaged_normals(positions, split)
}

/// The k whose 12·k² is nearest to the number of triangles; at least 1.
fn divisions(triangles: u32) -> u32 {
    let low = (f64::from(triangles) / 12.0).sqrt().floor() as u32;
    let miss = |k: u32| (12 * k * k).abs_diff(triangles);
    if low == 0 || miss(low) > miss(low + 1) { low + 1 } else { low }
}
