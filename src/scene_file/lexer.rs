//! A line of a scene → its keyword and its values.
//!
//! Finds where words and comments begin and end; does not know what any word means.
//!
//! # Comments
//! A comment begins with `#` or `//` and ends with its line. Before and behind numbers it begins
//! wherever these characters are, also within a word, as in the course's loader: `1.5//e` is the
//! number 1.5. In a line that names a file it begins only where a word does, since `//` and `#` may
//! be part of a path: `meshes//bunny.obj` and `bunny#2.obj` are names.
//!
//! # Names
//! A name is one word, or anything between double quotes: `"my bunny.obj"`, `"//server/bunny.obj"`.
//! A quote within the quotes cannot be written.

use crate::description::Span;

use super::text::TextLine;

/// A word and where it begins in the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Word<'s> {
    pub(super) text: &'s str,
    pub(super) start: usize,
}

impl Word<'_> {
    pub(super) fn span(&self) -> Span {
        self.start..self.end()
    }

    pub(super) fn end(&self) -> usize {
        self.start + self.text.len()
    }
}

/// The keyword of a line and what follows it; `None` for a line without a command.
pub(super) fn keyword(line: TextLine<'_>) -> Option<(Word<'_>, TextLine<'_>)> {
    let line = trim_start(line);
    let length = match line.text.chars().next()? {
        // A brace is a word by itself even where something follows it without a space.
        '{' | '}' => 1,
        _ => without_comment(line.text).find(char::is_whitespace).unwrap_or(line.text.len()),
    };
    let length = length.min(without_comment(line.text).len());
    let (keyword, rest) = line.text.split_at(length);
    let rest = TextLine { text: rest, start: line.start + length };
    (length > 0).then_some((Word { text: keyword, start: line.start }, rest))
}

/// Whether a word is a brace.
pub(super) fn is_brace(word: &str) -> bool {
    matches!(word, "{" | "}")
}

/// The words before a comment, in a line that names no file.
pub(super) fn values<'s>(rest: TextLine<'s>) -> Vec<Word<'s>> {
    split(TextLine { text: without_comment(rest.text), ..rest }, |text| {
        text.find(char::is_whitespace).unwrap_or(text.len())
    })
}

/// The words before a comment, in a line that names a file. Quotes stay on.
pub(super) fn names<'s>(rest: TextLine<'s>) -> Vec<Word<'s>> {
    split(rest, |text| {
        if begins_comment(text) {
            return 0;
        }
        match text.strip_prefix('"') {
            Some(inner) => inner.find('"').map_or(text.trim_end().len(), |end| end + 2),
            None => text.find(char::is_whitespace).unwrap_or(text.len()),
        }
    })
}

/// Cuts words off until the length of the next one is 0.
fn split<'s>(mut rest: TextLine<'s>, word_length: impl Fn(&str) -> usize) -> Vec<Word<'s>> {
    // Room for the values of a triangle, the most that any command takes.
    let mut words = Vec::with_capacity(9);
    loop {
        rest = trim_start(rest);
        let length = word_length(rest.text);
        if length == 0 {
            return words;
        }
        let (text, behind) = rest.text.split_at(length);
        words.push(Word { text, start: rest.start });
        rest = TextLine { text: behind, start: rest.start + length };
    }
}

fn trim_start(line: TextLine<'_>) -> TextLine<'_> {
    let text = line.text.trim_start();
    TextLine { text, start: line.start + line.text.len() - text.len() }
}

fn without_comment(text: &str) -> &str {
    let end = text.find('#').into_iter().chain(text.find("//")).min();
    &text[..end.unwrap_or(text.len())]
}

fn begins_comment(text: &str) -> bool {
    text.starts_with('#') || text.starts_with("//")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(text: &str) -> TextLine<'_> {
        TextLine { text, start: 100 }
    }

    fn texts<'s>(words: &[Word<'s>]) -> Vec<&'s str> {
        words.iter().map(|w| w.text).collect()
    }

    #[test]
    fn a_line_is_a_keyword_and_the_rest() {
        let (word, rest) = keyword(line("\t ball 1  2")).unwrap();
        assert_eq!((word.text, word.span()), ("ball", 102..106));
        assert_eq!(texts(&values(rest)), ["1", "2"]);
        assert_eq!(values(rest)[1].span(), 110..111);
        for nothing in ["", "  \t", "# ball", "  // ball", "#", "//"] {
            assert_eq!(keyword(line(nothing)), None, "{nothing}");
        }
    }

    #[test]
    fn comments_end_keywords_and_numbers() {
        assert_eq!(keyword(line("end// here")).unwrap().0.text, "end");
        assert_eq!(keyword(line("}#")).unwrap().0.text, "}");
        assert_eq!(keyword(line("{ball")).unwrap().0.text, "{");
        assert_eq!(texts(&values(line(" 1 2.5//e 3"))), ["1", "2.5"]);
        assert_eq!(texts(&values(line(" 1 2# e # 3"))), ["1", "2"]);
        assert_eq!(texts(&values(line(" 1/2"))), ["1/2"]);
    }

    #[test]
    fn names_keep_what_looks_like_a_comment_inside_them() {
        assert_eq!(texts(&names(line(" a//b#c.obj // d"))), ["a//b#c.obj"]);
        assert_eq!(texts(&names(line(" \"a b // c.obj\" # d"))), ["\"a b // c.obj\""]);
        assert_eq!(texts(&names(line(" \"a b "))), ["\"a b"]);
        assert_eq!(texts(&names(line(" a b"))), ["a", "b"]);
        assert_eq!(texts(&names(line("#a"))), [""; 0]);
    }
}
