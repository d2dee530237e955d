//! A structure that panics gets a row of the report with the panic's message; the program goes on.

use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::conformance::message_of;

/// Runs a part of a structure's work; a panic becomes its message.
///
/// All callers drop what the work was changing, so half-changed state is never used.
pub(crate) fn catch_panic<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work))
        .map_err(|payload| format!("it panicked: {}", message_of(&*payload)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panics_become_messages() {
        assert_eq!(catch_panic(|| 7), Ok(7));
        let number = 3;
        let message = catch_panic(|| panic!("leaf {number} is lost")).unwrap_err();
        assert_eq!(message, "it panicked: leaf 3 is lost");
    }
}
