//! Whether a Markdown page has no HTML in it, and tables whose rows all have the same number of cells.

/// Checks a page.
///
/// # Panics
/// If there is HTML in it, or a table that is broken.
pub(crate) fn check(page: &str) {
    let mut lines = page.split('\n');
    let mut cells = None;
    while let Some(line) = lines.next() {
        let fence = line.len() - line.trim_start_matches('`').len();
        if fence >= 3 && line.ends_with("sh") {
            // Code, to a line of as many backticks.
            lines.find(|line| line.len() >= fence && line.bytes().all(|b| b == b'`'));
            continue;
        }
        let text = without_code(line);
        assert!(!text.contains(['<', '>']), "HTML in {line:?}");
        let own = line.starts_with('|').then(|| bars(&text));
        if let (Some(above), Some(own)) = (cells, own) {
            assert_eq!(own, above, "another number of cells in {line:?}");
        }
        cells = own;
    }
}

/// A line without its code, as CommonMark has it: from some backticks to as many.
fn without_code(line: &str) -> String {
    let mut text = String::new();
    let mut rest = line;
    while let Some(c) = rest.chars().next() {
        let run = rest.len() - rest.trim_start_matches('`').len();
        if run > 0 {
            let behind = &rest[run..];
            rest = code_end(behind, run).map_or(behind, |end| &behind[end..]);
        } else {
            // What is escaped by a backslash goes with it.
            let more = rest[c.len_utf8()..].chars().next().filter(|_| c == '\\');
            let length = c.len_utf8() + more.map_or(0, char::len_utf8);
            text.push_str(&rest[..length]);
            rest = &rest[length..];
        }
    }
    text
}

/// Behind the first run of exactly so many backticks.
fn code_end(text: &str, run: usize) -> Option<usize> {
    let mut at = 0;
    loop {
        at += text[at..].find('`')?;
        let own = text[at..].len() - text[at..].trim_start_matches('`').len();
        at += own;
        if own == run {
            return Some(at);
        }
    }
}

/// The bars between cells: those that no backslash escapes.
fn bars(text: &str) -> usize {
    let mut escaped = false;
    let is_bar = |c: char| {
        let is_bar = c == '|' && !escaped;
        escaped = c == '\\' && !escaped;
        is_bar
    };
    text.chars().map(is_bar).filter(|&is_bar| is_bar).count()
}
