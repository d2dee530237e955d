//! Compact JSON → JSON with lines of readable length.
//!
//! What fits into a line stays in one line: a round, an interval, a list of times. The printer of `serde_json` gives
//! every number a line of its own.

/// Characters of a line, indentation included.
const WIDTH: usize = 100;

/// Lays valid compact JSON out in lines.
pub(in crate::report) fn pretty(compact: &str) -> String {
    let mut out = String::with_capacity(compact.len() * 2);
    value(compact, 0, 0, &mut out);
    out
}

/// One value, which starts in column `column` of a line that is indented by `indent`.
fn value(json: &str, indent: usize, column: usize, out: &mut String) {
    let is_list = json.starts_with(['[', '{']);
    if !is_list || column + spaced_length(json) <= WIDTH {
        spaced(json, out);
        return;
    }
    let (open, inner, close) = (&json[..1], &json[1..json.len() - 1], &json[json.len() - 1..]);
    out.push_str(open);
    let parts = split(inner, b',');
    let scalars = parts.iter().all(|part| !part.contains(['[', '{', '"']));
    if open == "[" && scalars {
        fill(&parts, indent + 2, out);
    } else {
        each_on_a_line(&parts, indent + 2, out);
    }
    new_line(indent, out);
    out.push_str(close);
}

/// Parts below each other.
fn each_on_a_line(parts: &[&str], indent: usize, out: &mut String) {
    for (i, part) in parts.iter().enumerate() {
        new_line(indent, out);
        let colon = split(part, b':');
        if let [key, rest] = colon[..] {
            out.push_str(key);
            out.push_str(": ");
            value(rest, indent, indent + key.len() + 3, out);
        } else {
            value(part, indent, indent + 1, out);
        }
        if i + 1 < parts.len() {
            out.push(',');
        }
    }
}

/// Numbers beside each other, in as many lines as they need.
fn fill(parts: &[&str], indent: usize, out: &mut String) {
    let mut column = WIDTH;
    for (i, part) in parts.iter().enumerate() {
        if column + part.len() + 2 > WIDTH {
            new_line(indent, out);
            column = indent;
        } else {
            out.push(' ');
            column += 1;
        }
        out.push_str(part);
        column += part.len() + 1;
        if i + 1 < parts.len() {
            out.push(',');
        }
    }
}

fn new_line(indent: usize, out: &mut String) {
    out.push('\n');
    out.extend(std::iter::repeat_n(' ', indent));
}

/// Splits at a separator that stands in no list and no string; at the first only if it is a colon.
fn split(json: &str, separator: u8) -> Vec<&str> {
    let (mut parts, mut start) = (Vec::new(), 0);
    for (at, byte, depth) in structure(json) {
        if byte == separator && depth == 0 {
            parts.push(&json[start..at]);
            start = at + 1;
            if separator == b':' {
                break;
            }
        }
    }
    parts.push(&json[start..]);
    parts
}

/// The bytes outside of strings, each with its place and the number of lists around it.
fn structure(json: &str) -> impl Iterator<Item = (usize, u8, usize)> {
    let (mut depth, mut in_string, mut escaped) = (0_usize, false, false);
    json.bytes().enumerate().filter_map(move |(at, byte)| {
        if in_string {
            in_string = escaped || byte != b'"';
            escaped = !escaped && byte == b'\\';
            return None;
        }
        match byte {
            b'"' => in_string = true,
            b'{' | b'[' => depth += 1,
            b'}' | b']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        Some((at, byte, depth))
    })
}

/// Whether a byte gets a space behind it within a line.
fn spaces(byte: u8) -> bool {
    matches!(byte, b',' | b':')
}

fn spaced_length(json: &str) -> usize {
    // Only lists that may fit are examined.
    if json.len() > WIDTH {
        return json.len();
    }
    json.chars().count() + structure(json).filter(|&(_, byte, _)| spaces(byte)).count()
}

/// The value in one line, with spaces behind commas and colons.
fn spaced(json: &str, out: &mut String) {
    let mut start = 0;
    for (at, byte, _) in structure(json) {
        if spaces(byte) {
            out.push_str(&json[start..=at]);
            out.push(' ');
            start = at + 1;
        }
    }
    out.push_str(&json[start..]);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_fits_stays_in_a_line() {
        assert_eq!(pretty(r#"{"a":[1,2],"b":"x,:{\"y"}"#), r#"{"a": [1, 2], "b": "x,:{\"y"}"#);
        assert_eq!(pretty("[]"), "[]");
    }

    #[test]
    fn what_does_not_is_laid_out_and_means_the_same() {
        let long: Vec<u64> = (0..60).map(|i| i * 1_234_567).collect();
        let name = "ä \\ \" , : [ { ".repeat(9);
        let value = serde_json::json!({"rounds": long, "name": [name], "in": {"a": {"b": long}}});
        let text = pretty(&value.to_string());
        assert_eq!(serde_json::from_str::<serde_json::Value>(&text).unwrap(), value);
        let number_lines = text.lines().filter(|line| line.ends_with(|c: char| c.is_numeric()));
        assert!(text.lines().count() < 40 && number_lines.count() > 0, "{text}");
        assert!(text.lines().all(|line| line.chars().count() <= 200));
    }
}
