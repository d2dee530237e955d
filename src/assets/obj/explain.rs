//! The line of an OBJ file that tobj refused: runs only once something is known to be wrong.
//!
//! Faces are checked while they are read, so what is left are the numbers of `v` and `vn`.

use super::Fault;
use super::lines::{ObjLine, lines, split_keyword};

/// The first line with invalid numbers, or, if there is none, `reason` at the first line.
pub(super) fn explain(text: &str, reason: &str) -> Fault {
    let unexplained = || Fault {
        line: 1,
        text: lines(text).next().map(|line| line.shown()).unwrap_or_default(),
        wrong: None,
        what: reason.to_owned(),
        help: "a mesh is made of `v x y z`, `vn x y z` and `f a b c` lines".to_owned(),
    };
    lines(text).find_map(|line| fault_of(&line)).unwrap_or_else(unexplained)
}

fn fault_of(line: &ObjLine<'_>) -> Option<Fault> {
    let content = line.content();
    let (keyword, values) = split_keyword(&content);
    let (Complaint { what, word }, help) = match keyword {
        "v" => (position_fault(values)?, "a vertex is `v x y z`, three finite numbers"),
        "vn" => (numbers_fault(values)?, "a normal is `vn x y z`, three numbers"),
        _ => return None,
    };
    Some(line.fault(word, what, help))
}

/// What is wrong with a line, and the word of it that is, if it is one.
struct Complaint<'a> {
    word: Option<&'a str>,
    what: String,
}

impl<'a> Complaint<'a> {
    fn about(word: &'a str, what: String) -> Self {
        Self { word: Some(word), what }
    }
}

/// What is wrong with the values of `v x y z [w | r g b]`.
fn position_fault(values: &str) -> Option<Complaint<'_>> {
    numbers_fault(values).or_else(|| {
        let words: Vec<_> = values.split_ascii_whitespace().collect();
        let not_finite = words.iter().take(3).find_map(|word| finite_fault(word));
        not_finite.or_else(|| match words[3..] {
            [w] => weight_fault(&words[..3], w),
            [_, _] => Some(Complaint {
                word: None,
                what: "five values: neither a vertex, nor one with w or with a colour".into(),
            }),
            _ => None,
        })
    })
}

/// What is wrong with the first three values as numbers.
fn numbers_fault(values: &str) -> Option<Complaint<'_>> {
    let mut words = values.split_ascii_whitespace();
    for found in 0..3 {
        match words.next() {
            Some(word) if word.parse::<f32>().is_err() => {
                return Some(Complaint::about(word, format!("`{word}` is not a number")));
            }
            Some(_) => {}
            None => {
                let what = format!("three numbers expected, {found} found");
                return Some(Complaint { word: None, what });
            }
        }
    }
    None
}

fn finite_fault(word: &str) -> Option<Complaint<'_>> {
    if word.parse::<f32>().is_ok_and(f32::is_finite) {
        return None;
    }
    let what = if word.parse::<f64>().is_ok_and(f64::is_finite)
        || word.contains(|c: char| c.is_ascii_digit())
    {
        format!("the coordinate {word} is too large: at most 3.4e38 fits")
    } else {
        format!("the coordinate {word} is not finite")
    };
    Some(Complaint::about(word, what))
}

/// What is wrong with a fourth value, by which the others are divided.
fn weight_fault<'a>(coordinates: &[&str], w: &'a str) -> Option<Complaint<'a>> {
    let Ok(weight) = w.parse::<f32>() else {
        return Some(Complaint::about(w, format!("`{w}` is not a number")));
    };
    let finite = |word: &&str| word.parse::<f32>().is_ok_and(|x| (x / weight).is_finite());
    let fine = weight != 0.0 && coordinates.iter().all(finite);
    let what = || format!("the coordinates divided by w = {w} are not finite");
    (!fine).then(|| Complaint::about(w, what()))
}
