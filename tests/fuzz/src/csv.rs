//! Whether text is CSV as RFC 4180 has it, each line with as many fields as the heading.

/// Checks a table.
///
/// # Panics
/// If it is none.
pub(crate) fn check(table: &str) {
    let mut records = records(table);
    let fields = records.next().expect("a table has a heading");
    assert!(fields > 1);
    for (number, own) in (1..).zip(records) {
        assert_eq!(own, fields, "record {number} of {table}");
    }
}

/// The number of fields of each record.
fn records(table: &str) -> impl Iterator<Item = usize> {
    let mut rest = table;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let mut fields = 0;
        loop {
            fields += 1;
            let length = field_length(rest);
            let (_, behind) = rest.split_at(length);
            if let Some(next) = behind.strip_prefix(',') {
                rest = next;
                continue;
            }
            let end = behind.strip_prefix("\r\n").or_else(|| behind.strip_prefix('\n'));
            rest = end.unwrap_or_else(|| panic!("a field is followed by {behind:?}"));
            return Some(fields);
        }
    })
}

/// The bytes of the field that a text begins with, its quotes included.
fn field_length(text: &str) -> usize {
    let Some(quoted) = text.strip_prefix('"') else {
        let end = text.find([',', '\n', '\r']).unwrap_or(text.len());
        assert!(!text[..end].contains('"'), "a quote within {:?}", &text[..end]);
        return end;
    };
    let mut at = 0;
    loop {
        at += quoted[at..].find('"').expect("a quoted field ends") + 1;
        match quoted[at..].strip_prefix('"') {
            Some(_) => at += 1,
            None => return at + 1,
        }
    }
}
