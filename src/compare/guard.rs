//! A structure that panics is a row of the report that says so, and no crash.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// Runs a part of a structure's work; a panic becomes its message.
///
/// What the work was changing is thrown away by all callers, so nothing half-changed is seen.
pub(crate) fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|payload| {
        let text = payload
            .downcast_ref::<String>()
            .map(String::as_str)
            .or_else(|| payload.downcast_ref::<&str>().copied());
        format!("it panicked: {}", text.unwrap_or("without a message"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panics_become_messages() {
        assert_eq!(guarded(|| 7), Ok(7));
        let number = 3;
        let message = guarded(|| panic!("leaf {number} is lost")).unwrap_err();
        assert_eq!(message, "it panicked: leaf 3 is lost");
    }
}
