//! Whether an order of slots is one: each primitive in one slot.

use crate::math::NONE;

/// Panics unless each of `count` primitives has one slot; the message names the first that has not.
/// Slots may be empty only where primitives are tested several at once.
pub(super) fn assert_whole(order: &[u32], count: u32, grain: u32) {
    if let Some(fault) = fault(order, count, grain) {
        panic!("{fault}");
    }
}

/// What is wrong with an order, if something is.
pub(super) fn fault(order: &[u32], count: u32, lanes: u32) -> Option<String> {
    let empty = || order.iter().position(|&primitive| primitive == NONE).filter(|_| lanes == 1);
    misnamed(order, count).or_else(|| {
        let slot = empty()?;
        Some(format!(
            "the order leaves slot {slot} empty, of primitives that are tested one by one"
        ))
    })
}

/// Which primitive an order does not name once, if there is one.
fn misnamed(order: &[u32], count: u32) -> Option<String> {
    let mut named = vec![false; count as usize];
    let mut twice = None;
    for &primitive in order.iter().filter(|&&primitive| primitive != NONE) {
        match named.get_mut(primitive as usize) {
            None => {
                return Some(format!(
                    "the order names primitive {primitive}, and there are {count}, counted from 0"
                ));
            }
            Some(named) if *named => twice = twice.or(Some(primitive)),
            Some(named) => *named = true,
        }
    }
    let never = named.iter().position(|&named| !named);
    Some(match (twice, never) {
        (None, None) => return None,
        (Some(twice), None) => format!("the order names primitive {twice} twice"),
        (None, Some(never)) => format!("the order names primitive {never} never"),
        (Some(twice), Some(never)) => {
            format!("the order names primitive {twice} twice and {never} never")
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slots_are_empty_among_several_lanes() {
        assert_whole(&[1, NONE, 0], 2, 4);
    }

    #[test]
    #[should_panic(expected = "the order leaves slot 1 empty")]
    fn no_slot_is_empty_where_there_are_no_lanes() {
        assert_whole(&[1, NONE, 0], 2, 1);
    }

    #[test]
    fn each_primitive_has_one_slot() {
        assert_eq!(misnamed(&[2, NONE, 0, 1, NONE], 3), None);
        assert_eq!(misnamed(&[], 0), None);
        let fault = |order: &[u32]| misnamed(order, 5).unwrap();
        assert_eq!(fault(&[0, 1, 2, 2, 3]), "the order names primitive 2 twice and 4 never");
        assert_eq!(fault(&[0, 1, 3, 2]), "the order names primitive 4 never");
        assert_eq!(fault(&[0, 1, 2, 3, 4, 1]), "the order names primitive 1 twice");
        assert!(fault(&[0, 5]).starts_with("the order names primitive 5, and there are 5"));
    }
}
