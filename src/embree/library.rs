//! Embree's library, found and loaded as the program runs: none is needed to build it.

use std::ffi::{c_char, c_int, c_uint, c_void};
use std::sync::OnceLock;

use super::EmbreeError;
use super::ffi::{
    Arguments, RTCDevice, RTCErrorFunction, RTCGeometry, RTCMemoryMonitorFunction, RTCRay,
    RTCRay16, RTCRayHit, RTCRayHit16, RTCScene, Valid,
};

/// A version of Embree, whose interfaces differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Version {
    /// 3, as it is in Debian 12.
    Three,
    /// 4.
    Four,
}

impl Version {
    /// The variable of the environment that may name the library's file.
    fn variable(self) -> &'static str {
        match self {
            Self::Three => "SRT_EMBREE3",
            Self::Four => "SRT_EMBREE4",
        }
    }

    /// Where the library is looked for: a file of the user's alone, or what the system has.
    fn places(self) -> Vec<String> {
        if let Some(file) = std::env::var(self.variable()).ok().filter(|file| !file.is_empty()) {
            return vec![file];
        }
        let number = self.number();
        if cfg!(windows) {
            vec![format!("embree{number}.dll")]
        } else if cfg!(target_os = "macos") {
            vec![format!("libembree{number}.{number}.dylib"), format!("libembree{number}.dylib")]
        } else {
            vec![format!("libembree{number}.so.{number}"), format!("libembree{number}.so")]
        }
    }

    fn number(self) -> u32 {
        match self {
            Self::Three => 3,
            Self::Four => 4,
        }
    }
}

/// A query for single rays: of version 3 by scene, arguments, rays, of version 4 by scene, rays, arguments.
type Single = unsafe extern "C" fn(RTCScene, *mut c_void, *mut c_void);
/// The same for a packet.
type Packet = unsafe extern "C" fn(*const c_int, RTCScene, *mut c_void, *mut c_void);

/// Declares the functions that are used, by their names in the manual.
macro_rules! functions {
    ($($name:ident: $symbol:literal, $kind:ty;)*) => {
        /// A library that was loaded, and stays.
        pub(super) struct Library {
            version: Version,
            $(pub(super) $name: $kind,)*
            /// What the functions are part of.
            _loaded: libloading::Library,
        }

        impl Library {
            fn of(version: Version, loaded: libloading::Library) -> Result<Self, libloading::Error> {
                Ok(Self {
                    version,
                    // SAFETY: the types are those of Embree's headers for functions of these names.
                    $($name: *unsafe { loaded.get::<$kind>($symbol) }?,)*
                    _loaded: loaded,
                })
            }
        }
    };
}

functions! {
    new_device: b"rtcNewDevice", unsafe extern "C" fn(*const c_char) -> RTCDevice;
    release_device: b"rtcReleaseDevice", unsafe extern "C" fn(RTCDevice);
    device_error: b"rtcGetDeviceError", unsafe extern "C" fn(RTCDevice) -> c_int;
    device_property: b"rtcGetDeviceProperty", unsafe extern "C" fn(RTCDevice, c_int) -> isize;
    set_error_function: b"rtcSetDeviceErrorFunction",
        unsafe extern "C" fn(RTCDevice, RTCErrorFunction, *mut c_void);
    set_memory_monitor: b"rtcSetDeviceMemoryMonitorFunction",
        unsafe extern "C" fn(RTCDevice, RTCMemoryMonitorFunction, *mut c_void);
    new_scene: b"rtcNewScene", unsafe extern "C" fn(RTCDevice) -> RTCScene;
    release_scene: b"rtcReleaseScene", unsafe extern "C" fn(RTCScene);
    set_build_quality: b"rtcSetSceneBuildQuality", unsafe extern "C" fn(RTCScene, c_int);
    set_scene_flags: b"rtcSetSceneFlags", unsafe extern "C" fn(RTCScene, c_int);
    attach: b"rtcAttachGeometryByID", unsafe extern "C" fn(RTCScene, RTCGeometry, c_uint);
    commit_scene: b"rtcCommitScene", unsafe extern "C" fn(RTCScene);
    new_geometry: b"rtcNewGeometry", unsafe extern "C" fn(RTCDevice, c_int) -> RTCGeometry;
    release_geometry: b"rtcReleaseGeometry", unsafe extern "C" fn(RTCGeometry);
    commit_geometry: b"rtcCommitGeometry", unsafe extern "C" fn(RTCGeometry);
    new_buffer: b"rtcSetNewGeometryBuffer",
        unsafe extern "C" fn(RTCGeometry, c_int, c_uint, c_int, usize, usize) -> *mut c_void;
    intersect1: b"rtcIntersect1", Single;
    occluded1: b"rtcOccluded1", Single;
    intersect16: b"rtcIntersect16", Packet;
    occluded16: b"rtcOccluded16", Packet;
}

impl Library {
    /// The library of a version, which is loaded the first time.
    pub(super) fn get(version: Version) -> Result<&'static Self, EmbreeError> {
        static THREE: OnceLock<Result<Library, EmbreeError>> = OnceLock::new();
        static FOUR: OnceLock<Result<Library, EmbreeError>> = OnceLock::new();
        let loaded = match version {
            Version::Three => &THREE,
            Version::Four => &FOUR,
        };
        loaded.get_or_init(|| Self::load(version)).as_ref().map_err(Clone::clone)
    }

    fn load(version: Version) -> Result<Self, EmbreeError> {
        let mut reasons = Vec::new();
        for place in version.places() {
            // SAFETY: what is run as Embree's library is loaded is Embree's own initialization, or
            // that of the file which the user names as such.
            let loaded = unsafe { libloading::Library::new(&place) };
            match loaded.and_then(|loaded| Self::of(version, loaded)) {
                Ok(library) => return Ok(library),
                Err(error) => reasons.push(error.to_string()),
            }
        }
        Err(EmbreeError::NotFound {
            version: version.number(),
            reasons: reasons.join("; "),
            variable: version.variable(),
        })
    }

    /// The closest hit of a ray.
    ///
    /// # Safety
    /// The scene is of this library, and committed.
    #[inline(always)]
    pub(super) unsafe fn intersect(
        &self,
        scene: RTCScene,
        arguments: &mut Arguments,
        ray_hit: &mut RTCRayHit,
    ) {
        // SAFETY: by the caller; the rays are laid out as either version wants them.
        unsafe { self.call(self.intersect1, scene, arguments, (&raw mut *ray_hit).cast()) };
    }

    /// Whether a ray hits anything.
    ///
    /// # Safety
    /// As for [`intersect`](Self::intersect).
    #[inline(always)]
    pub(super) unsafe fn occluded(
        &self,
        scene: RTCScene,
        arguments: &mut Arguments,
        ray: &mut RTCRay,
    ) {
        // SAFETY: as above.
        unsafe { self.call(self.occluded1, scene, arguments, (&raw mut *ray).cast()) };
    }

    /// The closest hits of a packet.
    ///
    /// # Safety
    /// As for [`intersect`](Self::intersect).
    #[inline(always)]
    pub(super) unsafe fn intersect_packet(
        &self,
        valid: &Valid,
        scene: RTCScene,
        arguments: &mut Arguments,
        ray_hit: &mut RTCRayHit16,
    ) {
        let rays = (&raw mut *ray_hit).cast();
        // SAFETY: as above.
        unsafe { self.call_packet(self.intersect16, valid, scene, arguments, rays) };
    }

    /// Which rays of a packet hit anything.
    ///
    /// # Safety
    /// As for [`intersect`](Self::intersect).
    #[inline(always)]
    pub(super) unsafe fn occluded_packet(
        &self,
        valid: &Valid,
        scene: RTCScene,
        arguments: &mut Arguments,
        rays: &mut RTCRay16,
    ) {
        let rays = (&raw mut *rays).cast();
        // SAFETY: as above.
        unsafe { self.call_packet(self.occluded16, valid, scene, arguments, rays) };
    }

    /// # Safety
    /// As for [`intersect`](Self::intersect); the rays are those of the query.
    #[inline(always)]
    unsafe fn call(&self, query: Single, scene: RTCScene, own: &mut Arguments, rays: *mut c_void) {
        // SAFETY: by the caller; arguments and rays are in the order of the version.
        unsafe {
            match self.version {
                Version::Three => query(scene, (&raw mut own.three).cast(), rays),
                Version::Four => query(scene, rays, (&raw mut own.four).cast()),
            }
        }
    }

    /// # Safety
    /// As for [`call`](Self::call).
    #[inline(always)]
    unsafe fn call_packet(
        &self,
        query: Packet,
        valid: &Valid,
        scene: RTCScene,
        own: &mut Arguments,
        rays: *mut c_void,
    ) {
        let valid = valid.0.as_ptr();
        // SAFETY: as above.
        unsafe {
            match self.version {
                Version::Three => query(valid, scene, (&raw mut own.three).cast(), rays),
                Version::Four => query(valid, scene, rays, (&raw mut own.four).cast()),
            }
        }
    }
}
