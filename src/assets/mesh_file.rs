//! A mesh from the bytes of its file, and what is wrong with these.

use std::path::{Path, PathBuf};

use super::error::LoadFailure;
use super::{AssetError, FileLine, MeshData, Problem, obj, read_file};

/// So many bytes are looked at to find the first statement of a file, behind its remarks.
const OBJ_BEGIN: usize = 1 << 16;

/// The mesh in the bytes of a Wavefront OBJ file, which errors call by `path`. Reads no file.
///
/// ```
/// use srt::assets::read_obj;
///
/// let name = std::path::Path::new("corner.obj");
/// let mesh = read_obj(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec(), name).unwrap();
/// assert_eq!(mesh.triangles, [[0, 1, 2]]);
/// let error = read_obj(b"v 0 0 0\nf 1 2 3\n".to_vec(), name).unwrap_err();
/// assert_eq!(error.place.unwrap().line, 2);
/// ```
///
/// # Errors
/// As of [`load_meshes`](super::load_meshes), of the only reference.
pub fn read_obj(bytes: Vec<u8>, path: &Path) -> Result<MeshData, Box<AssetError>> {
    mesh_of_bytes(bytes, path).map_err(|failure| Box::new(failure.for_reference(0)))
}

pub(super) fn read_mesh(path: &Path) -> Result<MeshData, Box<LoadFailure>> {
    let bytes = read_file(path).map_err(|error| LoadFailure::unreadable(path, &error))?;
    mesh_of_bytes(bytes, path)
}

pub(super) fn mesh_of_bytes(bytes: Vec<u8>, path: &Path) -> Result<MeshData, Box<LoadFailure>> {
    if let Some(format) = other_format(path, &bytes) {
        let help = "meshes are read as Wavefront OBJ: convert it".to_owned();
        return Err(LoadFailure::new(
            Problem::OtherFormat { path: path.to_owned(), format },
            Some(help),
        ));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let line = first_bad_line(error.as_bytes(), error.utf8_error().valid_up_to());
        Box::new(LoadFailure {
            problem: Problem::NotText { path: path.to_owned() },
            place: Some(FileLine { path: path.to_owned(), ..line }),
            help: Some("a mesh file is Wavefront OBJ, in UTF-8".to_owned()),
        })
    })?;
    let mesh = obj::read(&text).map_err(|fault| {
        let problem = Problem::Malformed { path: path.to_owned(), what: fault.what };
        let place = FileLine {
            path: path.to_owned(),
            line: fault.line,
            text: fault.text,
            wrong: fault.wrong,
        };
        Box::new(LoadFailure { problem, place: Some(place), help: Some(fault.help) })
    })?;
    if !mesh.triangles.is_empty() {
        return Ok(mesh);
    }
    let path = path.to_owned();
    let (problem, help) = match mesh.dropped {
        0 => (
            Problem::NoFaces { path, empty: text.trim().is_empty() },
            "a mesh is a Wavefront OBJ file: `v x y z` lines, then `f a b c` lines",
        ),
        dropped => (
            Problem::OnlyDegenerate { path, dropped },
            "the corners of each face lie on one line, or in one point, in single precision: \
             look at the vertices that the faces name, and at the digits they are written with",
        ),
    };
    Err(LoadFailure::new(problem, Some(help.to_owned())))
}

/// What the format of a mesh is in which a file is, where it begins like one of the common other formats. Binary STL
/// begins with anything, but states its length.
pub(crate) fn other_format(path: &Path, bytes: &[u8]) -> Option<&'static str> {
    let is_stl = || {
        let named = path.extension().is_some_and(|name| name.eq_ignore_ascii_case("stl"));
        let count = bytes.get(80..84)?.first_chunk().copied().map(u32::from_le_bytes)?;
        Some(named && bytes.len() as u64 == 84 + 50 * u64::from(count))
    };
    match bytes {
        _ if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r") => Some("PLY"),
        _ if bytes.starts_with(b"glTF") => Some("glTF"),
        _ if bytes.starts_with(b"solid ") || bytes.starts_with(b"solid\n") => Some("STL"),
        _ if is_stl() == Some(true) => Some("STL"),
        _ => None,
    }
}

/// Whether a text begins as an OBJ file does: its first statement is one of a mesh, and a scene's never is.
pub(crate) fn begins_as_obj(bytes: &[u8]) -> bool {
    const STATEMENTS: [&[u8]; 8] = [b"v", b"vn", b"vt", b"o", b"g", b"mtllib", b"usemtl", b"f"];
    let begin = &bytes[..bytes.len().min(OBJ_BEGIN)];
    let mut lines = begin.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    let first = lines.find(|line| !line.is_empty() && !line.starts_with(b"#"));
    let word = first.and_then(|line| line.split(u8::is_ascii_whitespace).next());
    word.is_some_and(|word| STATEMENTS.contains(&word))
}

/// The line that contains the byte at `offset`, up to that byte; the path is left empty.
fn first_bad_line(bytes: &[u8], offset: usize) -> FileLine {
    let line = 1 + bytes[..offset].iter().filter(|&&b| b == b'\n').count();
    let start = bytes[..offset].iter().rposition(|&b| b == b'\n').map_or(0, |at| at + 1);
    let mut text: String =
        String::from_utf8_lossy(&bytes[start..offset]).chars().take(200).collect();
    // In a longer line the byte is not shown.
    let wrong = (text.len() == offset - start).then(|| {
        text.push(char::REPLACEMENT_CHARACTER);
        offset - start..text.len()
    });
    FileLine { path: PathBuf::new(), line, text, wrong }
}
