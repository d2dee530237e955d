//! Meshes made to bring rounding and ties to light.

use crate::math::Random;
use glam::Vec3;

/// Positions and triangles.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// What it is called.
    pub name: &'static str,
    /// Where the vertices are.
    pub positions: Vec<Vec3>,
    /// Three vertices each.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The mesh scaled about the origin, then moved.
    #[must_use]
    pub fn moved(&self, scale: f32, offset: Vec3) -> Self {
        let positions = self.positions.iter().map(|&p| p * scale + offset).collect();
        Self { positions, ..self.clone() }
    }

    /// The corners of a triangle.
    ///
    /// # Panics
    /// If there is none of that number.
    #[must_use]
    pub fn corners(&self, triangle: usize) -> [Vec3; 3] {
        self.triangles[triangle].map(|i| self.positions[i as usize])
    }

    fn push(&mut self, corners: [Vec3; 3]) {
        let first = self.positions.len() as u32;
        self.positions.extend(corners);
        self.triangles.push([first, first + 1, first + 2]);
    }

    fn push_quad(&mut self, corner: Vec3, u: Vec3, v: Vec3) {
        self.push([corner, corner + u, corner + u + v]);
        self.push([corner, corner + u + v, corner + v]);
    }
}

/// All of them but [`terrain`], which takes the longest without a structure.
#[must_use]
pub fn all() -> Vec<Mesh> {
    vec![lattice(), nested(), sheets(), soup(), fan(), single()]
}

/// No triangle at all.
#[must_use]
pub fn empty(name: &'static str) -> Mesh {
    Mesh { name, positions: vec![], triangles: vec![] }
}

fn axis(axis: usize, length: f32) -> Vec3 {
    let mut v = Vec3::ZERO;
    v[axis] = length;
    v
}

/// Axis-parallel quads in shared planes: exact ties, flat boxes, overlapping and duplicate
/// triangles, slivers.
#[must_use]
pub fn lattice() -> Mesh {
    let mut mesh = empty("lattice");
    for a in 0..3 {
        let (b, c) = ((a + 1) % 3, (a + 2) % 3);
        for layer in [-1.0, 0.0, 1.0] {
            for i in 0..4 {
                for j in 0..4 {
                    let corner = axis(a, layer)
                        + axis(b, i as f32 * 0.5 - 1.0)
                        + axis(c, j as f32 * 0.5 - 1.0);
                    mesh.push_quad(corner, axis(b, 0.5), axis(c, 0.5));
                }
            }
        }
        for i in 0..5 {
            let shift = i as f32 / 5.0;
            let corner = axis(b, shift - 1.0) + axis(c, shift * 0.5 - 1.0);
            mesh.push_quad(corner, axis(b, 0.7), axis(c, 0.9));
        }
    }
    let mut random = Random::new(&[7]);
    let originals = mesh.triangles.len() as u32;
    for k in 0..60 {
        let [a, b, c] = mesh.triangles[random.below(originals) as usize];
        mesh.triangles.push([[a, b, c], [b, c, a], [c, b, a]][k % 3]);
    }
    for k in 0..30 {
        let [p, q] = std::array::from_fn(|_| random_point(&mut random));
        let sliver = [(p + q) / 2.0 + Vec3::new(1e-6, 0.0, 1e-7), p + 3.0 * (q - p), p][k % 3];
        mesh.push([p, q, sliver]);
    }
    mesh
}

/// Triangles that grow geometrically about a corner: as deep a tree as one gets.
#[must_use]
pub fn nested() -> Mesh {
    let mut mesh = empty("nested");
    for i in 0..400 {
        let s = 1.1f32.powi(i) * 1e-11;
        mesh.push([
            Vec3::new(s, 0.0, 0.3 * s),
            Vec3::new(0.0, s, 0.1 * s),
            Vec3::new(-0.2 * s, -0.1 * s, s),
        ]);
    }
    mesh
}

/// Quads above one another, apart by a few units in the last place: by the rounding of a hit alone
/// one may seem to lie on the other side of its neighbours, or of a plane between them.
#[must_use]
pub fn sheets() -> Mesh {
    let mut mesh = empty("sheets");
    let mut random = Random::new(&[13]);
    for a in 0..3 {
        let (b, c) = ((a + 1) % 3, (a + 2) % 3);
        for _ in 0..24 {
            let steps = 1 << random.below(6);
            let height = f32::from_bits(0.7f32.to_bits() + random.below(steps));
            let [x, y] = random.next_pair();
            let [width, depth] = random.next_pair();
            let corner = axis(a, height) + axis(b, 0.5 * x) + axis(c, 0.5 * y);
            mesh.push_quad(corner, axis(b, 0.5 * width), axis(c, 0.5 * depth));
        }
    }
    mesh
}

/// Triangles of all sizes anywhere.
#[must_use]
pub fn soup() -> Mesh {
    let mut mesh = empty("soup");
    let mut random = Random::new(&[11]);
    for _ in 0..300 {
        let center = random_point(&mut random);
        let size = 0.02f32.powf(random.next_f32());
        mesh.push(std::array::from_fn(|_| center + size * random_point(&mut random)));
    }
    mesh
}

/// Many triangles about one shared vertex, the flat way and as a cone.
#[must_use]
pub fn fan() -> Mesh {
    let mut mesh = empty("fan");
    for (height, tip) in [(0.0, Vec3::ZERO), (0.4, Vec3::new(0.1, 0.2, 1.0))] {
        let rim = |i: u32| {
            let angle = (i % 90) as f32 * std::f32::consts::TAU / 90.0;
            Vec3::new(angle.cos(), angle.sin(), height)
        };
        for i in 0..90 {
            mesh.push([tip, rim(i), rim(i + 1)]);
        }
    }
    mesh
}

/// One triangle.
#[must_use]
pub fn single() -> Mesh {
    let mut mesh = empty("single");
    mesh.push([Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::new(0.0, 1.0, 0.5)]);
    mesh
}

/// A height field of 20,000 triangles that share vertices: large enough for trees of several levels of wide nodes.
#[must_use]
pub fn terrain() -> Mesh {
    const SIDE: u32 = 100;
    let mut mesh = empty("terrain");
    let mut random = Random::new(&[17]);
    for i in 0..=SIDE {
        for j in 0..=SIDE {
            let [x, y] = [i, j].map(|at| at as f32 / SIDE as f32);
            mesh.positions.push(Vec3::new(x, y, 0.02 * random.next_f32()));
        }
    }
    for i in 0..SIDE {
        for j in 0..SIDE {
            let corner = i * (SIDE + 1) + j;
            let [right, up, across] = [corner + SIDE + 1, corner + 1, corner + SIDE + 2];
            mesh.triangles.extend([[corner, right, across], [corner, across, up]]);
        }
    }
    mesh
}

/// A point in [−1, 1)³.
pub fn random_point(random: &mut Random) -> Vec3 {
    Vec3::from_array(std::array::from_fn(|_| 2.0 * random.next_f32() - 1.0))
}
