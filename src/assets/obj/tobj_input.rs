//! OBJ text in the form in which tobj reads it correctly.
//!
//! A reader that passes on the lines that matter, most of them as slices of the text itself:
//! * `v`, `vn` and `f` without comments; nothing else, so there is one model, and vertices that
//!   groups share stay shared. Texture coordinates are left out with the rest.
//! * `v` without colours.
//! * Faces with an index that is 0, no number, or before the first vertex, and with fewer than three
//!   corners, end the reading with a [`Fault`]; and so do those with an index past the last vertex,
//!   once the last is known.
//! * In a file that has normals, corners that have none refer to one more normal of length 0,
//!   written after the last line.

use std::fmt::Write as _;
use std::io::{self, BufRead, Read};

use super::Fault;
use super::corner::parse_corner;
use super::lines::{Lines, ObjLine, lines, split_keyword};

/// A reader of OBJ text for tobj; see the module.
pub(super) struct TobjInput<'a> {
    text: &'a str,
    lines: Lines<'a>,
    counts: VertexCounts,
    /// The largest index in any face, and that face, for positions and for normals.
    furthest: [(usize, Option<ObjLine<'a>>); 2],
    /// How many normals the text has, once a corner without one needs it.
    all_normals: Option<usize>,
    needs_zero_normal: bool,
    ended: bool,
    fault: Option<Fault>,
    current: Current<'a>,
}

/// How many vertices and normals there were so far.
#[derive(Clone, Copy, Default)]
struct VertexCounts {
    positions: usize,
    normals: usize,
}

/// The bytes that tobj reads next.
enum Current<'a> {
    /// A part of the text.
    Text(&'a [u8]),
    /// A rewritten line, and how much of it has been read.
    Rewritten(String, usize),
}

/// What to do with a line.
enum LineUse<'a> {
    Skip,
    Keep(&'a str),
    Rewrite(String),
}

impl<'a> TobjInput<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self {
            text,
            lines: lines(text),
            counts: VertexCounts::default(),
            furthest: [(0, None), (0, None)],
            all_normals: None,
            needs_zero_normal: false,
            ended: false,
            fault: None,
            current: Current::Text(b""),
        }
    }

    /// The line that ended the reading, if one did.
    pub(super) fn into_fault(self) -> Option<Fault> {
        self.fault
    }

    /// Finds the next line that matters; `None` at the end.
    fn next_line(&mut self) -> Result<Option<Current<'a>>, Fault> {
        while let Some(line) = self.lines.next() {
            match self.use_of(&line)? {
                LineUse::Skip => {}
                LineUse::Keep(text) => return Ok(Some(Current::Text(text.as_bytes()))),
                LineUse::Rewrite(text) => return Ok(Some(Current::Rewritten(text, 0))),
            }
        }
        if self.ended {
            return Ok(None);
        }
        self.ended = true;
        self.check_furthest()?;
        let last = if self.needs_zero_normal { "\nvn 0 0 0\n" } else { "" };
        Ok(Some(Current::Rewritten(last.to_owned(), 0)))
    }

    fn use_of(&mut self, line: &ObjLine<'a>) -> Result<LineUse<'a>, Fault> {
        let content = line.content();
        let (keyword, values) = split_keyword(&content);
        let kept = match keyword {
            "v" => {
                self.counts.positions += 1;
                without_color(&content)
            }
            "vn" => {
                self.counts.normals += 1;
                &content
            }
            "f" => {
                if self.check_face(values, line)? {
                    return Ok(LineUse::Rewrite(self.with_zero_normals(values)));
                }
                &content
            }
            _ => return Ok(LineUse::Skip),
        };
        // Blanks around the words do no harm; a comment, colours and joined lines do.
        let plain = kept.len() == line.raw.trim_ascii().len();
        Ok(if plain { LineUse::Keep(line.raw) } else { LineUse::Rewrite(format!("{kept}\n")) })
    }

    /// Checks the corners of a face; whether one lacks a normal that the file has for others.
    fn check_face(&mut self, corners: &str, line: &ObjLine<'a>) -> Result<bool, Fault> {
        let (mut number, mut lacks) = (0, false);
        for corner in corners.split_ascii_whitespace() {
            number += 1;
            let [position, normal] =
                parse_corner(corner).map_err(|what| at(line, Some(corner), what))?;
            let Some(position) = position else {
                let what = format!("the corner `{corner}` has no vertex");
                return Err(at(line, Some(corner), what));
            };
            self.check_index(position, Index::Position, corner, line)?;
            match normal {
                Some(normal) => self.check_index(normal, Index::Normal, corner, line)?,
                None => lacks = true,
            }
        }
        if number < 3 {
            let what = format!("a face needs three corners, here {}", been(number));
            return Err(at(line, None, what));
        }
        Ok(lacks && self.all_normals() > 0)
    }

    fn check_index(
        &mut self,
        index: i64,
        of: Index,
        corner: &str,
        line: &ObjLine<'a>,
    ) -> Result<(), Fault> {
        let before = of.count(self.counts);
        if index == 0 {
            let what = format!("the {} index is 0: indices start at 1", of.name());
            return Err(at(line, Some(corner), what));
        }
        let back = index.unsigned_abs() as usize;
        if index < 0 && back > before {
            let what = format!(
                "the {} index {index} points {back} back, where there {} so far",
                of.name(),
                been(before)
            );
            return Err(at(line, Some(corner), what));
        }
        let furthest = &mut self.furthest[of as usize];
        if index > 0 && back > furthest.0 {
            *furthest = (back, Some(line.clone()));
        }
        Ok(())
    }

    /// Whether the largest index of all faces has its vertex or normal.
    fn check_furthest(&self) -> Result<(), Fault> {
        for of in [Index::Position, Index::Normal] {
            let (index, line) = &self.furthest[of as usize];
            let count = of.count(self.counts);
            if let Some(line) = line.as_ref().filter(|_| *index > count) {
                let name = of.name();
                let what = format!(
                    "the {name} index {index} is out of range: there {} in the file",
                    been(count)
                );
                let content = line.content();
                let corner = content.split_ascii_whitespace().skip(1).find(|corner| {
                    let indices = parse_corner(corner).unwrap_or_default();
                    indices[of as usize] == i64::try_from(*index).ok()
                });
                return Err(at(line, corner, what));
            }
        }
        Ok(())
    }

    /// The face with the normal of length 0 at corners that have none.
    fn with_zero_normals(&mut self, corners: &str) -> String {
        self.needs_zero_normal = true;
        let zero = self.all_normals() + 1;
        let mut face = String::from("f");
        for corner in corners.split_ascii_whitespace() {
            let mut fields = corner.split('/');
            let position = fields.next().unwrap_or_default();
            let _ = match fields.nth(1).filter(|normal| !normal.is_empty()) {
                Some(normal) => write!(face, " {position}//{normal}"),
                None => write!(face, " {position}//{zero}"),
            };
        }
        face.push('\n');
        face
    }

    /// How many normals the whole text has; counted once, when first needed.
    fn all_normals(&mut self) -> usize {
        let text = self.text;
        *self.all_normals.get_or_insert_with(|| {
            lines(text).filter(|line| split_keyword(&line.content()).0 == "vn").count()
        })
    }
}

/// What an index of a corner refers to.
#[derive(Clone, Copy)]
enum Index {
    Position,
    Normal,
}

impl Index {
    fn name(self) -> &'static str {
        match self {
            Self::Position => "vertex",
            Self::Normal => "normal",
        }
    }

    fn count(self, counts: VertexCounts) -> usize {
        match self {
            Self::Position => counts.positions,
            Self::Normal => counts.normals,
        }
    }
}

/// `v x y z` of `v x y z r g b`; the line itself where there are fewer values.
fn without_color(content: &str) -> &str {
    let mut words = content.split_ascii_whitespace();
    let Some(z) = words.by_ref().nth(3) else { return content };
    if words.count() < 3 {
        return content;
    }
    let end = z.as_ptr() as usize + z.len() - content.as_ptr() as usize;
    &content[..end]
}

fn at(line: &ObjLine<'_>, corner: Option<&str>, what: String) -> Fault {
    let help = "a face is `f` and three or more corners, each `v`, `v/vt`, `v//vn` or `v/vt/vn`, \
                counted from 1, or from the last one back: -1, -2, …";
    line.fault(corner, what, help)
}

/// "are none", "is 1", "are 2".
fn been(count: usize) -> String {
    match count {
        0 => "are none".to_owned(),
        1 => "is 1".to_owned(),
        n => format!("are {n}"),
    }
}

impl BufRead for TobjInput<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        while self.fault.is_none() && self.rest().is_empty() {
            match self.next_line() {
                Ok(Some(next)) => self.current = next,
                Ok(None) => break,
                Err(fault) => self.fault = Some(fault),
            }
        }
        if self.fault.is_some() {
            return Err(io::ErrorKind::InvalidData.into());
        }
        Ok(self.rest())
    }

    fn consume(&mut self, amount: usize) {
        match &mut self.current {
            Current::Text(text) => *text = &text[amount..],
            Current::Rewritten(_, read) => *read += amount,
        }
    }
}

impl TobjInput<'_> {
    fn rest(&self) -> &[u8] {
        match &self.current {
            Current::Text(text) => text,
            Current::Rewritten(text, read) => &text.as_bytes()[*read..],
        }
    }
}

impl Read for TobjInput<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.fill_buf()?.read(buffer)?;
        self.consume(read);
        Ok(read)
    }
}
