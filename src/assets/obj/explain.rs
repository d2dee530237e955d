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
        what: reason.to_owned(),
        help: "a mesh is made of `v x y z`, `vn x y z` and `f a b c` lines".to_owned(),
    };
    lines(text).find_map(|line| fault_of(&line)).unwrap_or_else(unexplained)
}

fn fault_of(line: &ObjLine<'_>) -> Option<Fault> {
    let content = line.content();
    let (keyword, values) = split_keyword(&content);
    let (what, help) = match keyword {
        "v" => (position_fault(values)?, "a vertex is `v x y z`, three finite numbers"),
        "vn" => (numbers_fault(values)?, "a normal is `vn x y z`, three numbers"),
        _ => return None,
    };
    Some(Fault { line: line.number, text: line.shown(), what, help: help.to_owned() })
}

/// What is wrong with the values of `v x y z [w | r g b]`.
fn position_fault(values: &str) -> Option<String> {
    numbers_fault(values).or_else(|| {
        let words: Vec<_> = values.split_ascii_whitespace().collect();
        let not_finite = words.iter().take(3).find_map(|word| finite_fault(word));
        not_finite.or_else(|| match words[3..] {
            [w] => weight_fault(&words[..3], w),
            [_, _] => Some("five values: neither a vertex, nor one with w or with a colour".into()),
            _ => None,
        })
    })
}

/// What is wrong with the first three values as numbers.
fn numbers_fault(values: &str) -> Option<String> {
    let mut words = values.split_ascii_whitespace();
    for found in 0..3 {
        match words.next() {
            Some(word) if word.parse::<f32>().is_err() => {
                return Some(format!("`{word}` is not a number"));
            }
            Some(_) => {}
            None => return Some(format!("three numbers expected, {found} found")),
        }
    }
    None
}

fn finite_fault(word: &str) -> Option<String> {
    if word.parse::<f32>().is_ok_and(f32::is_finite) {
        return None;
    }
    Some(
        if word.parse::<f64>().is_ok_and(f64::is_finite)
            || word.contains(|c: char| c.is_ascii_digit())
        {
            format!("the coordinate {word} is too large: at most 3.4e38 fits")
        } else {
            format!("the coordinate {word} is not finite")
        },
    )
}

/// What is wrong with a fourth value, by which the others are divided.
fn weight_fault(coordinates: &[&str], w: &str) -> Option<String> {
    let Ok(weight) = w.parse::<f32>() else {
        return Some(format!("`{w}` is not a number"));
    };
    let finite = |word: &&str| word.parse::<f32>().is_ok_and(|x| (x / weight).is_finite());
    let fine = weight != 0.0 && coordinates.iter().all(finite);
    (!fine).then(|| format!("the coordinates divided by w = {w} are not finite"))
}
