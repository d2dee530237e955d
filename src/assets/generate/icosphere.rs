//! The unit ball, from an icosahedron whose faces are split in k² triangles each.

use std::collections::HashMap;

use glam::{DVec3, Vec3};

use super::MeshData;

/// A mesh of 20·k² triangles and 10·k² + 2 vertices, k such that it is nearest to the requested
/// number. The faces are divided evenly while flat and then projected to the ball, where the normals
/// are the positions.
pub(super) fn generate(triangles: u32) -> MeshData {
    let k = frequency(triangles);
    let mut ball =
        Subdivision { k, positions: corners().map(DVec3::as_vec3).to_vec(), edges: HashMap::new() };
    let mut split = Vec::with_capacity(20 * (k * k) as usize);
    for face in faces() {
        ball.split_face(face, &mut split);
    }
    MeshData {
        normals: ball.positions.clone(),
        positions: ball.positions,
        normal_indices: split.clone(),
        triangles: split,
        dropped: 0,
    }
}

/// The k whose 20·k² is nearest to the number of triangles; at least 1.
fn frequency(triangles: u32) -> u32 {
    let low = (f64::from(triangles) / 20.0).sqrt().floor() as u32;
    let miss = |k: u32| (20 * k * k).abs_diff(triangles);
    if low == 0 || miss(low) > miss(low + 1) { low + 1 } else { low }
}

/// The corners of the icosahedron: (0, ±1, ±φ) and its cyclic permutations, at distance 1.
fn corners() -> [DVec3; 12] {
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    std::array::from_fn(|i| {
        let one = if i & 1 == 0 { 1.0 } else { -1.0 };
        let phi = if i & 2 == 0 { golden } else { -golden };
        let corner = match i / 4 {
            0 => DVec3::new(0.0, one, phi),
            1 => DVec3::new(one, phi, 0.0),
            _ => DVec3::new(phi, 0.0, one),
        };
        corner.normalize()
    })
}

/// The 20 triples of mutually nearest corners, counterclockwise seen from outside.
fn faces() -> Vec<[usize; 3]> {
    let p = corners();
    let near = |a: usize, b: usize| p[a].dot(p[b]) > 0.4; // neighbours have 1/√5, others less
    let mut faces = Vec::with_capacity(20);
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(c, a) {
                    let outward = (p[b] - p[a]).cross(p[c] - p[a]).dot(p[a]) > 0.0;
                    faces.push(if outward { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    faces
}

struct Subdivision {
    k: u32,
    positions: Vec<Vec3>,
    /// The first of the k − 1 vertices between two corners, from the smaller corner on.
    edges: HashMap<(usize, usize), u32>,
}

impl Subdivision {
    fn split_face(&mut self, face: [usize; 3], triangles: &mut Vec<[u32; 3]>) {
        let k = self.k;
        let edges = [0, 1, 2].map(|i| self.edge(face[i], face[(i + 1) % 3]));
        let inside = self.inside(face);
        // i steps from the first corner towards the second, j towards the third.
        let vertex = |i: u32, j: u32| match (i, j) {
            (0, 0) => face[0] as u32,
            (i, 0) if i == k => face[1] as u32,
            (0, j) if j == k => face[2] as u32,
            (i, 0) => edges[0].vertex(i, k),
            (i, j) if i + j == k => edges[1].vertex(j, k),
            (0, j) => edges[2].vertex(k - j, k),
            // Rows j = 1, 2, … of k − 2, k − 3, … vertices each.
            (i, j) => inside + (j - 1) * (k - 1) - j * (j - 1) / 2 + i - 1,
        };
        for j in 0..k {
            for i in 0..k - j {
                triangles.push([vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)]);
                if i + j + 1 < k {
                    triangles.push([vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]);
                }
            }
        }
    }

    /// The edge between two corners; its vertices are made when it is first used.
    fn edge(&mut self, from: usize, to: usize) -> Edge {
        let (low, high) = (from.min(to), from.max(to));
        let (k, positions) = (self.k, &mut self.positions);
        let first = *self.edges.entry((low, high)).or_insert_with(|| {
            let first = positions.len() as u32;
            let [a, b] = [low, high].map(|i| corners()[i]);
            let at = |i: u32| (a * f64::from(k - i) + b * f64::from(i)).normalize();
            positions.extend((1..k).map(|i| at(i).as_vec3()));
            first
        });
        Edge { first, turned: from != low }
    }

    /// Makes the vertices inside a face, row by row; gives the index of the first.
    fn inside(&mut self, face: [usize; 3]) -> u32 {
        let first = self.positions.len() as u32;
        let k = self.k;
        let [a, b, c] = face.map(|i| corners()[i]);
        for j in 1..k {
            for i in 1..k - j {
                let [wa, wb, wc] = [k - i - j, i, j].map(f64::from);
                self.positions.push((a * wa + b * wb + c * wc).normalize().as_vec3());
            }
        }
        first
    }
}

/// The vertices between two corners, in the direction of a face.
#[derive(Clone, Copy)]
struct Edge {
    first: u32,
    turned: bool,
}

impl Edge {
    /// The vertex `i` of `k` steps along, neither the first nor the last.
    fn vertex(self, i: u32, k: u32) -> u32 {
        self.first + if self.turned { k - i } else { i } - 1
    }
}
