//! A wave: rays of one class that are traced together, each with the path that it continues.

use crate::math::Ray;

use super::path::Path;

#[derive(Default)]
pub(super) struct Wave {
    pub(super) rays: Vec<Ray>,
    pub(super) paths: Vec<Path>,
}

impl Wave {
    pub(super) fn push(&mut self, ray: Ray, path: Path) {
        self.rays.push(ray);
        self.paths.push(path);
    }

    pub(super) fn clear(&mut self) {
        self.rays.clear();
        self.paths.clear();
    }

    pub(super) fn is_empty(&self) -> bool {
        self.rays.is_empty()
    }
}
