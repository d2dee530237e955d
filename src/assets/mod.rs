//! The files that a description names, and meshes made by rule: → data in memory.
//!
//! With `cli` the only layer that touches files. Knows nothing of tracing.

mod mesh_data;

pub use mesh_data::MeshData;
