//! The meshes that a description names, from files or generated, deformed or not → data in memory.
//!
//! Reads files, as `cli` and, for its machine and its sources, `compare` do; no other layer does.
//! Knows nothing of tracing: a mesh leaves here as plain arrays with every index in range, every
//! normal of unit length and no degenerate triangle.

mod deform;
mod error;
mod file_reader;
pub mod generate;
mod load;
mod memory;
mod mesh_data;
mod mesh_file;
mod normals;
mod obj;
mod read;
mod source;

pub use error::{AssetError, FileLine, Problem};
pub use file_reader::FileReader;
pub use load::{LoadedMeshes, MeshLoader, check_meshes, load_each_mesh, load_meshes};
pub use memory::{MemoryShortage, available_memory, expect_memory};
pub use mesh_data::MeshData;
pub use mesh_file::read_obj;
pub(crate) use mesh_file::{begins_as_obj, other_format};
pub use read::{read_file, read_stream};
pub use source::MeshFiles;
