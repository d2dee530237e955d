//! Surfaces over a rectangle of cells: two triangles a cell, open or closed either way.

use glam::{DVec3, Vec3};
use rayon::prelude::*;

/// A rectangle of cells. A closed direction shares the vertices of its first and last line.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellGrid {
    /// Cells along the first parameter; at least 3 if it is closed.
    pub(super) columns: u32,
    /// Cells along the second parameter; at least 3 if it is closed.
    pub(super) rows: u32,
    /// Whether the first parameter wraps around.
    pub(super) closed_columns: bool,
    /// Whether the second does.
    pub(super) closed_rows: bool,
}

impl CellGrid {
    /// An open grid of about `triangles` triangles, `aspect` times as many columns as rows.
    pub(super) fn open(triangles: u32, aspect: f64) -> Self {
        let [columns, rows] = cells(triangles, aspect, 1, 1);
        Self { columns, rows, closed_columns: false, closed_rows: false }
    }

    /// A tube of about `triangles` triangles: columns around, rows along.
    pub(super) fn tube(triangles: u32, aspect: f64) -> Self {
        let [columns, rows] = cells(triangles, aspect, 3, 1);
        Self { columns, rows, closed_columns: true, closed_rows: false }
    }

    /// A tube whose ends are joined.
    pub(super) fn torus(triangles: u32, aspect: f64) -> Self {
        let [columns, rows] = cells(triangles, aspect, 3, 3);
        Self { columns, rows, closed_columns: true, closed_rows: true }
    }

    /// How many triangles it has.
    pub(super) fn triangle_count(&self) -> u32 {
        2 * self.columns * self.rows
    }

    /// Vertices in a row.
    fn stride(&self) -> u32 {
        self.columns + u32::from(!self.closed_columns)
    }

    /// Its vertices, row by row: `surface` of the two parameters, each from 0 to 1.
    pub(super) fn vertices(&self, surface: &(dyn Fn(f64, f64) -> DVec3 + Sync)) -> Vec<Vec3> {
        let parameter = |i: u32, cells: u32| f64::from(i) / f64::from(cells);
        let lines = self.rows + u32::from(!self.closed_rows);
        let row = |j: u32| {
            let v = parameter(j, self.rows);
            (0..self.stride()).map(move |i| surface(parameter(i, self.columns), v).as_vec3())
        };
        (0..lines).into_par_iter().flat_map_iter(row).collect()
    }

    /// Its triangles, row by row, for vertices that start at index `first`.
    ///
    /// Seen from the side to which (first × second parameter) points they turn counterclockwise.
    pub(super) fn triangles(&self, first: u32) -> impl Iterator<Item = [u32; 3]> {
        let (grid, stride) = (*self, self.stride());
        let next =
            |i: u32, cells: u32, closed: bool| if closed && i + 1 == cells { 0 } else { i + 1 };
        (0..grid.rows).flat_map(move |j| {
            let low = first + j * stride;
            let high = first + next(j, grid.rows, grid.closed_rows) * stride;
            (0..grid.columns).flat_map(move |i| {
                let right = next(i, grid.columns, grid.closed_columns);
                [[low + i, low + right, high + right], [low + i, high + right, high + i]]
            })
        })
    }
}

/// Columns and rows of about `triangles`/2 cells: the columns first, then what rows they leave.
fn cells(triangles: u32, aspect: f64, least_columns: u32, least_rows: u32) -> [u32; 2] {
    let cells = f64::from(triangles) / 2.0;
    let columns = ((cells * aspect).sqrt().round() as u32).max(least_columns);
    let rows = ((cells / f64::from(columns)).round() as u32).max(least_rows);
    [columns, rows]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_directions_share_their_seam() {
        for (grid, vertices) in [
            (CellGrid { columns: 4, rows: 3, closed_columns: false, closed_rows: false }, 20),
            (CellGrid { columns: 4, rows: 3, closed_columns: true, closed_rows: false }, 16),
            (CellGrid { columns: 4, rows: 3, closed_columns: true, closed_rows: true }, 12),
        ] {
            assert_eq!(grid.vertices(&|u, v| DVec3::new(u, v, 0.0)).len(), vertices);
            let triangles: Vec<_> = grid.triangles(0).collect();
            assert_eq!(triangles.len(), grid.triangle_count() as usize);
            let largest = triangles.iter().flatten().max().copied();
            assert_eq!(largest, Some(vertices as u32 - 1));
        }
    }
}
