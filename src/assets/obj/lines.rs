//! The lines of an OBJ file, as the format means them: a backslash at the end joins two, `#` starts
//! a remark.

use std::borrow::Cow;

/// How much of a line is shown in an error.
const SHOWN: usize = 200;

/// A line of meaning: one line of text, or several that backslashes join.
#[derive(Clone, Debug)]
pub(super) struct Line<'a> {
    /// The number of its first line of text, from 1.
    pub(super) number: usize,
    /// As written, with its line end.
    pub(super) raw: &'a str,
}

impl<'a> Line<'a> {
    /// What it says: joined, without a remark and without blanks around it.
    pub(super) fn content(&self) -> Cow<'a, str> {
        let joined = if is_joined(self.raw) {
            Cow::Owned(self.raw.replace("\\\r\n", " ").replace("\\\n", " "))
        } else {
            Cow::Borrowed(self.raw)
        };
        match joined {
            Cow::Borrowed(text) => Cow::Borrowed(without_remark(text)),
            Cow::Owned(text) => Cow::Owned(without_remark(&text).to_owned()),
        }
    }

    /// Its first line of text, to be shown in an error.
    pub(super) fn shown(&self) -> String {
        let first = self.raw.lines().next().unwrap_or_default().trim_end();
        match first.char_indices().nth(SHOWN) {
            Some((end, _)) => format!("{}…", &first[..end]),
            None => first.to_owned(),
        }
    }
}

fn is_joined(raw: &str) -> bool {
    // The last line end is the line's own, so another one before it was joined.
    raw.trim_end_matches(['\n', '\r']).contains('\n')
}

fn without_remark(text: &str) -> &str {
    text.split('#').next().unwrap_or_default().trim()
}

/// The first word of a line's content, and what follows it.
pub(super) fn split_keyword(content: &str) -> (&str, &str) {
    content.split_once(|c: char| c.is_ascii_whitespace()).unwrap_or((content, ""))
}

/// All lines of a text, in order.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let mut rest = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut next_number = 1;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let number = next_number;
        let mut end = 0;
        loop {
            let start = end;
            end = rest[start..].find('\n').map_or(rest.len(), |at| start + at + 1);
            next_number += 1;
            let line = rest[start..end].trim_end_matches(['\n', '\r']);
            if end == rest.len() || !line.ends_with('\\') {
                break;
            }
        }
        let (raw, tail) = rest.split_at(end);
        rest = tail;
        Some(Line { number, raw })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_joined_stripped_and_numbered() {
        let text = "\u{feff}v 1 2 3 # up\r\nf 1 \\\r\n 2 \\\n 3\n\n# end\nvn 0 0 1";
        let found: Vec<_> = lines(text).map(|l| (l.number, l.content().into_owned())).collect();
        let expected = [(1, "v 1 2 3"), (2, "f 1   2   3"), (5, ""), (6, ""), (7, "vn 0 0 1")];
        assert_eq!(found, expected.map(|(n, s)| (n, s.to_owned())));
        assert_eq!(lines(text).nth(1).map(|l| l.shown()), Some("f 1 \\".to_owned()));
    }

    #[test]
    fn a_very_long_line_is_cut_where_it_is_shown() {
        let text = "é".repeat(1000);
        assert_eq!(lines(&text).next().map(|l| l.shown().chars().count()), Some(SHOWN + 1));
    }
}
