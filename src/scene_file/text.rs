//! Lines and columns of a text.
//!
//! A line ends with `\n`, `\r\n` or `\r` alone, as editors have it, so that the line numbers of an
//! error are those that the author sees.

/// A line without its end, and where it begins in the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TextLine<'s> {
    pub(super) text: &'s str,
    pub(super) start: usize,
}

/// The lines of a text, in order. A text that ends with a line end has no empty line behind it.
pub(super) fn lines(source: &str) -> impl Iterator<Item = TextLine<'_>> {
    let mut start = 0;
    std::iter::from_fn(move || {
        let rest = source.get(start..).filter(|rest| !rest.is_empty())?;
        let line = TextLine { text: &rest[..line_length(rest)], start };
        start += line.text.len() + line_end_length(&rest[line.text.len()..]);
        Some(line)
    })
}

/// How many bytes of a text are before its first line end.
fn line_length(text: &str) -> usize {
    text.find(['\n', '\r']).unwrap_or(text.len())
}

/// How many bytes the line end at the beginning of a text has; 0 where there is none.
fn line_end_length(text: &str) -> usize {
    match text.as_bytes() {
        [b'\r', b'\n', ..] => 2,
        [b'\r' | b'\n', ..] => 1,
        _ => 0,
    }
}

/// The line and column of a byte of a text, both counted from 1, columns in characters.
///
/// An offset within a character means that character; one beyond the text means its end. A byte
/// order mark has no column.
#[must_use]
pub fn line_column(source: &str, offset: usize) -> (usize, usize) {
    let (number, line) = line_around(source, offset);
    let before = &line.text[..floor_boundary(line.text, offset - line.start.min(offset))];
    (number, before.trim_start_matches('\u{feff}').chars().count() + 1)
}

/// The number of the line that an offset lies in (its end included), and the line.
pub(super) fn line_around(source: &str, offset: usize) -> (usize, TextLine<'_>) {
    let mut found = (1, TextLine { text: "", start: 0 });
    for (index, line) in lines(source).enumerate() {
        if line.start > offset {
            return found;
        }
        found = (index + 1, line);
    }
    // After a last line end there is one more line, empty, as in an editor.
    if offset >= source.len() && source.ends_with(['\n', '\r']) {
        found = (found.0 + 1, TextLine { text: "", start: source.len() });
    }
    found
}

/// The last character boundary of a text at or before an offset.
pub(super) fn floor_boundary(text: &str, offset: usize) -> usize {
    let mut at = offset.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_line_end_ends_one_line() {
        let found: Vec<_> = lines("a\nb\r\nc\rd\n\n e").map(|l| (l.text, l.start)).collect();
        assert_eq!(found, [("a", 0), ("b", 2), ("c", 5), ("d", 7), ("", 9), (" e", 10)]);
        assert_eq!(lines("").count(), 0);
        assert_eq!(lines("\r\n").count(), 1);
    }

    #[test]
    fn columns_count_characters() {
        let source = "añb\r\n\tx\n";
        assert_eq!(line_column(source, 0), (1, 1));
        assert_eq!(line_column(source, 2), (1, 2)); // within the ñ
        assert_eq!(line_column(source, 3), (1, 3));
        assert_eq!(line_column(source, 5), (1, 4)); // the line end
        assert_eq!(line_column(source, 7), (2, 2));
        assert_eq!(line_column(source, 9), (3, 1));
        assert_eq!(line_column(source, 1000), (3, 1));
        assert_eq!(line_column("", 0), (1, 1));
        assert_eq!(line_column("\u{feff}sce", 3), (1, 1));
    }
}
