//! What decides the hits of rays in a scene, as a hash: other materials, lights and cameras do not change it.

use sha2::{Digest, Sha256};

use crate::assets::MeshData;
use crate::description::Shape;
use crate::shapes::{Ball, Cylinder, Single, Triangle};

use super::{Object, Scene};

/// The numbers of shapes in the hash.
const BALL: u8 = 0;
const CYLINDER: u8 = 1;
const TRIANGLE: u8 = 2;
const MESH: u8 = 3;

impl Scene {
    /// SHA-256 of the geometry: the objects in their order, then the meshes, as `docs/ray-files.md` lists them.
    #[must_use]
    pub fn geometry_hash(&self) -> [u8; 32] {
        let mut hash = Hasher(Sha256::new());
        hash.count(self.objects.len());
        for object in &self.objects {
            hash.object(self, object);
        }
        hash.count(self.meshes().len());
        for mesh in self.meshes() {
            hash.mesh(mesh);
        }
        hash.0.finalize().into()
    }
}

/// Takes numbers, all little-endian.
struct Hasher(Sha256);

impl Hasher {
    fn object(&mut self, scene: &Scene, object: &Object) {
        match object.shape {
            Shape::Single(Single::Ball(Ball { center, radius })) => {
                self.0.update([BALL]);
                self.floats(&[center.x, center.y, center.z, radius]);
            }
            Shape::Single(Single::Cylinder(Cylinder)) => self.0.update([CYLINDER]),
            Shape::Single(Single::Triangle(Triangle { corners })) => {
                self.0.update([TRIANGLE]);
                corners.iter().for_each(|corner| self.floats(&corner.to_array()));
            }
            Shape::Mesh { mesh, .. } => {
                self.0.update([MESH]);
                self.count(mesh);
            }
        }
        let transform = scene.transform_of(object);
        self.0.update([u8::from(transform.is_some())]);
        if let Some(transform) = transform {
            for number in transform.world_from_object.to_cols_array() {
                self.0.update(number.to_le_bytes());
            }
        }
    }

    fn mesh(&mut self, mesh: &MeshData) {
        self.count(mesh.positions.len());
        mesh.positions.iter().for_each(|position| self.floats(&position.to_array()));
        self.count(mesh.triangles.len());
        for corner in mesh.triangles.iter().flatten() {
            self.0.update(corner.to_le_bytes());
        }
    }

    fn count(&mut self, count: usize) {
        self.0.update((count as u64).to_le_bytes());
    }

    fn floats(&mut self, numbers: &[f32]) {
        numbers.iter().for_each(|number| self.0.update(number.to_le_bytes()));
    }
}
