//! What files are called in a pack: relative to the nearest folder that holds them all.

use thiserror::Error;

/// A file that a scene names and that no pack can hold.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum NameError {
    /// A pack is unpacked elsewhere, where an absolute path would name another file.
    #[error("`{0}` is an absolute path, which names another file on another machine")]
    Absolute(String),
    /// The path leads above the root of all files.
    #[error("`{0}` leads out of all folders")]
    Outside(String),
}

/// What a scene and the files that it names are called in a pack.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Located {
    /// The scene.
    pub scene: String,
    /// The others, in their order.
    pub files: Vec<String>,
}

/// Finds the names. `folder` is the absolute path of the scene's folder, with `/` between its parts, `scene` the name
/// of its file there, and `files` are the paths that the scene gives, relative to that folder.
///
/// # Errors
/// If a path is absolute, or leads above the root.
pub fn locate(folder: &str, scene: &str, files: &[&str]) -> Result<Located, NameError> {
    let mut up = 0;
    for file in files {
        if file.starts_with('/') {
            return Err(NameError::Absolute((*file).to_owned()));
        }
        up = up.max(levels_up(file));
    }
    let parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
    let outside = || files.iter().find(|file| levels_up(file) > parts.len());
    if let Some(file) = outside() {
        return Err(NameError::Outside((*file).to_owned()));
    }
    let kept = parts[parts.len() - up..].join("/");
    let named = |file: &str| resolve(&kept, file).unwrap_or_default();
    Ok(Located { scene: named(scene), files: files.iter().map(|file| named(file)).collect() })
}

/// How many folders above its start a relative path reaches.
fn levels_up(path: &str) -> usize {
    let (mut depth, mut up) = (0_usize, 0);
    for part in path.split('/') {
        match part {
            "" | "." => {}
            ".." if depth == 0 => up += 1,
            ".." => depth -= 1,
            _ => depth += 1,
        }
    }
    up
}

/// A path that is relative to a folder, without `.` and `..`; `None` if it leads out of the pack or is absolute.
pub(super) fn resolve(folder: &str, path: &str) -> Option<String> {
    if path.starts_with('/') {
        return None;
    }
    let mut parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
    for part in path.split('/') {
        match part {
            "" | "." => {}
            ".." => drop(parts.pop()?),
            _ => parts.push(part),
        }
    }
    Some(parts.join("/"))
}
