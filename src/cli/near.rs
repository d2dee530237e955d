//! The known word that a typed one was probably meant to be.

/// The nearest of some words, if it is near: one slip in three letters, swapped neighbours being one.
pub(crate) fn nearest<'a>(
    typed: &str,
    known: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    // What is long resembles none, and would take long to compare.
    if typed.len() > 40 {
        return None;
    }
    let slips = (typed.chars().count() / 3).max(1);
    let distance = |known: &&str| strsim::damerau_levenshtein(typed, known);
    known.into_iter().min_by_key(distance).filter(|near| distance(near) <= slips)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_in_three_letters_is_near() {
        let known = ["check", "compare", "mesh"];
        assert_eq!(nearest("chek", known), Some("check"));
        assert_eq!(nearest("comapre", known), Some("compare"));
        assert_eq!(nearest("rendr", known), None);
        assert_eq!(nearest(&"mesh".repeat(20), known), None);
        assert_eq!(nearest("mesh", []), None);
    }
}
