//! A device of Embree's: its threads, its memory, and what it complains of.

use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::ptr;
use std::sync::Mutex;
use std::sync::atomic::{AtomicI64, Ordering};

use super::EmbreeError;
use super::ffi::{RTC_DEVICE_PROPERTY_VERSION, RTC_ERROR_NONE, RTCDevice};
use super::library::Library;

/// A device, which all of a scene's objects belong to.
pub(super) struct Device {
    library: &'static Library,
    raw: RTCDevice,
    /// What the device's callbacks write to; boxed, so that it stays where the device knows it.
    reports: Box<Reports>,
}

/// What a device has reported.
#[derive(Default)]
struct Reports {
    bytes: AtomicI64,
    error: Mutex<Option<String>>,
}

// SAFETY: Embree's devices may be used from any thread, by several at once (manual, chapter
// "Embree API"); what its callbacks write to is synchronized.
unsafe impl Send for Device {}
// SAFETY: as above.
unsafe impl Sync for Device {}

impl Device {
    /// A device that wants so many threads for builds.
    pub(super) fn new(library: &'static Library, threads: usize) -> Result<Self, EmbreeError> {
        let config = CString::new(format!("threads={threads}")).unwrap_or_default();
        // SAFETY: the text ends with a zero and outlives the call.
        let raw = unsafe { (library.new_device)(config.as_ptr()) };
        if raw.is_null() {
            // SAFETY: without a device, Embree returns this thread's last error.
            let code = unsafe { (library.device_error)(ptr::null_mut()) };
            return Err(EmbreeError::Device { code });
        }
        let reports = Box::<Reports>::default();
        let user = ptr::from_ref(&*reports).cast_mut().cast::<c_void>();
        // SAFETY: the device is valid; `user` is a `Reports`, read through a shared reference only,
        // which lives until after the device is released.
        unsafe {
            (library.set_error_function)(raw, note_error, user);
            (library.set_memory_monitor)(raw, note_bytes, user);
        }
        Ok(Self { library, raw, reports })
    }

    pub(super) fn library(&self) -> &'static Library {
        self.library
    }

    pub(super) fn raw(&self) -> RTCDevice {
        self.raw
    }

    /// The version of the library that is loaded, in three parts.
    pub(super) fn version(&self) -> [isize; 3] {
        // SAFETY: the device is valid, and both versions have this property.
        let all = unsafe { (self.library.device_property)(self.raw, RTC_DEVICE_PROPERTY_VERSION) };
        [all / 10_000, all / 100 % 100, all % 100]
    }

    /// What its objects occupy now.
    pub(super) fn bytes(&self) -> u64 {
        u64::try_from(self.reports.bytes.load(Ordering::Relaxed)).unwrap_or(0)
    }

    /// The first complaint so far, if there was any.
    pub(super) fn check(&self) -> Result<(), EmbreeError> {
        let reports = self.reports.error.lock().map_or(None, |mut error| error.take());
        // SAFETY: the device is valid. It keeps what was not reported to the callback.
        let code = unsafe { (self.library.device_error)(self.raw) };
        match reports {
            Some(text) => Err(EmbreeError::Refused { text }),
            None if code != RTC_ERROR_NONE => Err(EmbreeError::Device { code }),
            None => Ok(()),
        }
    }
}

impl Drop for Device {
    fn drop(&mut self) {
        // SAFETY: the device is valid and is not used again. Objects that hold it keep it alive
        // themselves, and are all released before `reports` is (see `TriangleScene`).
        unsafe { (self.library.release_device)(self.raw) };
    }
}

/// Keeps the first error.
unsafe extern "C" fn note_error(user: *mut c_void, code: c_int, text: *const c_char) {
    // SAFETY: `user` is the `Reports` that was given to the device.
    let reports = unsafe { &*user.cast::<Reports>() };
    let text = if text.is_null() {
        String::new()
    } else {
        // SAFETY: Embree's texts end with a zero and live as long as this call.
        unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned()
    };
    if let Ok(mut error) = reports.error.lock() {
        error.get_or_insert_with(|| format!("error {code}: {text}"));
    }
}

/// Adds what was allocated, or takes away what was freed.
unsafe extern "C" fn note_bytes(user: *mut c_void, bytes: isize, _post: bool) -> bool {
    // SAFETY: `user` is the `Reports` that was given to the device.
    let reports = unsafe { &*user.cast::<Reports>() };
    reports.bytes.fetch_add(bytes as i64, Ordering::Relaxed);
    true
}
