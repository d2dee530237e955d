//! Triangles that Embree indexes.

use std::ffi::{c_int, c_uint};

use glam::Vec3;

use super::EmbreeError;
use super::device::Device;
use super::ffi::{
    RTC_BUFFER_TYPE_INDEX, RTC_BUFFER_TYPE_VERTEX, RTC_BUILD_QUALITY_HIGH, RTC_FORMAT_FLOAT3,
    RTC_FORMAT_UINT3, RTC_GEOMETRY_TYPE_TRIANGLE, RTC_SCENE_FLAG_NONE, RTCGeometry, RTCScene,
};
use super::library::{Library, Version};

/// Triangles while they are gathered.
pub struct Builder(TriangleScene);

/// Triangles, indexed; they do not change any more.
pub struct TriangleScene {
    // Fields are dropped in this order: the scene before its device.
    scene: OwnedScene,
    device: Device,
    /// Bytes of the vertices and indices.
    triangle_bytes: u64,
}

/// A scene of Embree's, released when it goes.
struct OwnedScene(&'static Library, RTCScene);

// SAFETY: committed scenes may be traced from any thread, by several at once (manual, chapter
// "Embree API"), and nothing but `Builder`, which is held exclusively, changes one.
unsafe impl Send for OwnedScene {}
// SAFETY: as above.
unsafe impl Sync for OwnedScene {}

impl Drop for OwnedScene {
    fn drop(&mut self) {
        // SAFETY: the scene is valid and is not used again.
        unsafe { (self.0.release_scene)(self.1) };
    }
}

/// A geometry of Embree's, released when it goes; a scene that it is attached to holds it too.
struct OwnedGeometry(&'static Library, RTCGeometry);

impl Drop for OwnedGeometry {
    fn drop(&mut self) {
        // SAFETY: the geometry is valid and is not used again through this handle.
        unsafe { (self.0.release_geometry)(self.1) };
    }
}

impl Builder {
    /// No triangles yet.
    ///
    /// # Errors
    /// If this version of Embree is not installed, or has no device for this machine.
    pub fn new(version: Version) -> Result<Self, EmbreeError> {
        let library = Library::get(version)?;
        let device = Device::new(library, 1)?;
        // SAFETY: the device is valid.
        let scene = unsafe { (library.new_scene)(device.raw()) };
        device.check()?;
        let scene = OwnedScene(library, scene);
        // SAFETY: the scene is valid: its making was checked.
        unsafe {
            (library.set_build_quality)(scene.1, RTC_BUILD_QUALITY_HIGH);
            (library.set_scene_flags)(scene.1, RTC_SCENE_FLAG_NONE);
        }
        device.check()?;
        Ok(Self(TriangleScene { scene, device, triangle_bytes: 0 }))
    }

    /// Which library of a version is there: its version in full, as `3.13.5`.
    ///
    /// # Errors
    /// As of [`new`](Self::new).
    pub fn found(version: Version) -> Result<String, EmbreeError> {
        let device = Device::new(Library::get(version)?, 1)?;
        let [major, minor, patch] = device.version();
        device.check()?;
        Ok(format!("{major}.{minor}.{patch}"))
    }

    /// Adds the triangles of an object, whose hits will name `object` and the triangle's place in
    /// the list.
    ///
    /// # Errors
    /// If Embree refuses them, for want of memory or because the object was there already.
    ///
    /// # Panics
    /// If an index is out of range.
    pub fn add(
        &mut self,
        object: u32,
        positions: impl ExactSizeIterator<Item = Vec3>,
        triangles: &[[u32; 3]],
    ) -> Result<(), EmbreeError> {
        if triangles.is_empty() {
            return Ok(());
        }
        let in_range = |corner: &u32| (*corner as usize) < positions.len();
        assert!(triangles.as_flattened().iter().all(in_range), "indices are in range");
        let Self(TriangleScene { scene, device, .. }) = self;
        let library = device.library();
        // SAFETY: the device is valid.
        let geometry = unsafe { (library.new_geometry)(device.raw(), RTC_GEOMETRY_TYPE_TRIANGLE) };
        device.check()?;
        let geometry = OwnedGeometry(library, geometry);
        let corners = positions.map(|p| p.to_array());
        fill(device, &geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, corners)?;
        let indices = triangles.iter().copied();
        fill(device, &geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, indices)?;
        // SAFETY: geometry and scene are valid and of the same device; both buffers are filled,
        // and all indices are in range.
        unsafe {
            (library.commit_geometry)(geometry.1);
            (library.attach)(scene.1, geometry.1, object as c_uint);
        }
        device.check()
    }

    /// Indexes them, on so many threads.
    ///
    /// # Errors
    /// If Embree fails, for want of memory.
    pub fn build(self, threads: usize) -> Result<TriangleScene, EmbreeError> {
        let Self(mut triangles) = self;
        // All of a process's builds have as many threads as the device that asks for the most, of
        // those that are there. So the devices that stay ask for one, and only for a build is there
        // one that asks for more.
        let library = triangles.device.library();
        let with_threads = Device::new(library, threads)?;
        triangles.triangle_bytes = triangles.device.bytes();
        // SAFETY: the scene is valid, and nobody else has it.
        unsafe { (library.commit_scene)(triangles.scene.1) };
        drop(with_threads);
        triangles.device.check()?;
        Ok(triangles)
    }
}

/// Makes a buffer of rows of three and fills it.
fn fill<T: Copy>(
    device: &Device,
    geometry: &OwnedGeometry,
    kind: c_int,
    format: c_int,
    rows: impl ExactSizeIterator<Item = [T; 3]>,
) -> Result<(), EmbreeError> {
    let (stride, count) = (size_of::<[T; 3]>(), rows.len());
    // SAFETY: the geometry is valid.
    let buffer = unsafe { (geometry.0.new_buffer)(geometry.1, kind, 0, format, stride, count) };
    device.check()?;
    let buffer = buffer.cast::<[T; 3]>();
    for (i, row) in rows.take(count).enumerate() {
        // SAFETY: Embree made the buffer for `count` rows, aligned to 16 bytes; i < count.
        unsafe { buffer.add(i).write(row) };
    }
    Ok(())
}

impl TriangleScene {
    /// Bytes of the vertices and indices, from which the index was built.
    #[must_use]
    pub fn triangle_bytes(&self) -> u64 {
        self.triangle_bytes
    }

    /// Bytes of the index, whose leaves hold the triangles once more, as they are traced.
    #[must_use]
    pub fn index_bytes(&self) -> u64 {
        self.device.bytes().saturating_sub(self.triangle_bytes)
    }

    /// The library, and its committed scene.
    pub(super) fn parts(&self) -> (&'static Library, RTCScene) {
        (self.scene.0, self.scene.1)
    }
}
