//! One corner of a face.

/// More digits than any index has that fits in memory; 10¹⁰ also overflows nothing.
const MOST_DIGITS: usize = 10;

/// The indices of the position and of the normal in `v`, `v/vt`, `v//vn` or `v/vt/vn`.
pub(super) fn parse_corner(corner: &str) -> Result<[Option<i64>; 2], String> {
    let mut fields = [None; 3];
    // As bytes: this runs for every corner of the file, and text is only cut at slashes.
    for (i, field) in corner.as_bytes().split(|&b| b == b'/').enumerate() {
        let slot = fields.get_mut(i).ok_or_else(|| {
            format!("the corner `{corner}` has more than a vertex, a texture and a normal index")
        })?;
        if !field.is_empty() {
            *slot = Some(parse_index(field)?);
        }
    }
    Ok([fields[0], fields[2]])
}

fn parse_index(field: &[u8]) -> Result<i64, String> {
    let (negative, digits) = match field {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    let shown = || String::from_utf8_lossy(field);
    if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) {
        return Err(format!("`{}` is not an index", shown()));
    }
    if digits.len() > MOST_DIGITS {
        return Err(format!("the index {} is out of range", shown()));
    }
    let size = digits.iter().fold(0, |n, &b| 10 * n + i64::from(b - b'0'));
    Ok(if negative { -size } else { size })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_four_forms_are_read() {
        assert_eq!(parse_corner("12"), Ok([Some(12), None]));
        assert_eq!(parse_corner("+1/2"), Ok([Some(1), None]));
        assert_eq!(parse_corner("1//-3"), Ok([Some(1), Some(-3)]));
        assert_eq!(parse_corner("-1/-2/-3"), Ok([Some(-1), Some(-3)]));
        assert_eq!(parse_corner("0000000001/"), Ok([Some(1), None]));
        assert_eq!(parse_corner("//"), Ok([None, None]));
    }

    #[test]
    fn what_is_no_index_is_said() {
        assert_eq!(parse_corner("1.0"), Err("`1.0` is not an index".to_owned()));
        assert_eq!(parse_corner("--1"), Err("`--1` is not an index".to_owned()));
        assert_eq!(parse_corner("1//é"), Err("`é` is not an index".to_owned()));
        let huge = "the index 99999999999 is out of range".to_owned();
        assert_eq!(parse_corner("99999999999"), Err(huge));
    }
}
