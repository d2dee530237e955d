//! The lines of an OBJ file, as the format defines them: a backslash at the end joins two, `#` starts
//! a comment.

use std::borrow::Cow;
use std::ops::Range;

use super::Fault;

/// How much of a line is shown in an error.
const SHOWN: usize = 200;

/// A line of the format: one line of text, or several that backslashes join.
#[derive(Clone, Debug)]
pub(super) struct ObjLine<'a> {
    /// The number of its first line of text, from 1.
    pub(super) number: usize,
    /// As written, with its line end.
    pub(super) raw: &'a str,
    /// Whether it is more than one line of text.
    joined: bool,
}

impl<'a> ObjLine<'a> {
    /// Its content: joined, without a comment and without blanks around it.
    pub(super) fn content(&self) -> Cow<'a, str> {
        if self.joined {
            let text = self.raw.replace("\\\r\n", " ").replace("\\\n", " ");
            Cow::Owned(without_comment(&text).to_owned())
        } else {
            Cow::Borrowed(without_comment(self.raw))
        }
    }

    /// What is wrong with it, and with which of its words, if it is with one.
    pub(super) fn fault(&self, word: Option<&str>, what: String, help: &str) -> Fault {
        let text = self.shown();
        let wrong = word.and_then(|word| place_of(word, &text));
        Fault { line: self.number, text, wrong, what, help: help.to_owned() }
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

/// Where a word stands first behind the keyword of a line. What is checked first is found first, so that
/// the first of several that are equal is the one that is meant.
fn place_of(word: &str, line: &str) -> Option<Range<usize>> {
    let place = |found: &str| {
        let start = found.as_ptr() as usize - line.as_ptr() as usize;
        start..start + found.len()
    };
    without_comment(line).split_ascii_whitespace().skip(1).find(|found| *found == word).map(place)
}

fn without_comment(text: &str) -> &str {
    // Most lines have none, and are long enough for the search of bytes to pay.
    let end = if text.as_bytes().contains(&b'#') { text.find('#') } else { None };
    text[..end.unwrap_or(text.len())].trim_ascii()
}

/// The first word of a line's content, and what follows it.
pub(super) fn split_keyword(content: &str) -> (&str, &str) {
    let end = content.bytes().position(|b| b.is_ascii_whitespace()).unwrap_or(content.len());
    content.split_at(end)
}

/// The lines of a text, in order.
#[derive(Clone, Debug)]
pub(super) struct Lines<'a> {
    rest: &'a str,
    /// The number of the line at the start of the rest.
    number: usize,
}

/// All lines of a text.
pub(super) fn lines(text: &str) -> Lines<'_> {
    Lines { rest: text.strip_prefix('\u{feff}').unwrap_or(text), number: 1 }
}

impl<'a> Iterator for Lines<'a> {
    type Item = ObjLine<'a>;

    fn next(&mut self) -> Option<ObjLine<'a>> {
        let (rest, number) = (self.rest, self.number);
        let mut end = 0;
        while end < rest.len() {
            end = rest[end..].find('\n').map_or(rest.len(), |at| end + at + 1);
            self.number += 1;
            if !goes_on(&rest.as_bytes()[..end]) {
                break;
            }
        }
        let (raw, tail) = rest.split_at(end);
        self.rest = tail;
        (end > 0).then_some(ObjLine { number, raw, joined: self.number > number + 1 })
    }
}

/// Whether a line that ends here is joined with the next one.
fn goes_on(line: &[u8]) -> bool {
    line.ends_with(b"\\\n") || line.ends_with(b"\\\r\n")
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
