//! Whether a page is made of the report's own elements alone: a stricter grammar than that of HTML, which no text that
//! got through unescaped would keep.

/// The elements of a page.
const ELEMENTS: [&str; 59] = [
    "a",
    "body",
    "caption",
    "circle",
    "code",
    "dd",
    "defs",
    "desc",
    "details",
    "div",
    "dl",
    "dt",
    "em",
    "figcaption",
    "figure",
    "footer",
    "g",
    "h1",
    "h2",
    "h3",
    "h4",
    "head",
    "header",
    "html",
    "img",
    "li",
    "line",
    "link",
    "main",
    "meta",
    "nav",
    "ol",
    "p",
    "path",
    "polygon",
    "polyline",
    "pre",
    "rect",
    "script",
    "section",
    "small",
    "span",
    "strong",
    "style",
    "sub",
    "summary",
    "sup",
    "svg",
    "table",
    "tbody",
    "td",
    "text",
    "th",
    "thead",
    "time",
    "title",
    "tr",
    "tspan",
    "ul",
];

/// Those that have no end.
const VOID: [&str; 3] = ["img", "link", "meta"];

/// Those whose contents are no markup.
const RAW: [&str; 2] = ["script", "style"];

/// Attributes whose values are numbers, and never `NaN` or `inf`.
const PLACES: [&str; 13] =
    ["cx", "cy", "d", "height", "points", "r", "viewBox", "width", "x", "x1", "x2", "y", "y1"];

/// Checks a page.
///
/// # Panics
/// If it has an element that is not of a report, one that is not closed, or text that is not escaped.
pub(crate) fn check(page: &str) {
    let mut rest = page.strip_prefix("<!DOCTYPE html>").expect("a page of HTML");
    let mut open: Vec<&str> = Vec::new();
    while let Some(at) = rest.find('<') {
        check_text(&rest[..at]);
        let end = at + rest[at..].find('>').expect("a tag ends");
        let tag = &rest[at + 1..end];
        rest = &rest[end + 1..];
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name), "`</{name}>` closes what is not open");
            continue;
        }
        let name = &tag[..tag.find(' ').unwrap_or(tag.len())];
        assert!(ELEMENTS.contains(&name), "an element `{name}`");
        check_attributes(name, &tag[name.len()..]);
        if RAW.contains(&name) {
            rest = &rest[rest.find("</").expect("an element ends")..];
        }
        if !VOID.contains(&name) {
            open.push(name);
        }
    }
    check_text(rest);
    assert!(open.is_empty(), "not closed: {open:?}");
}

/// No end of a tag, and no `&` but of an escape.
fn check_text(text: &str) {
    assert!(!text.contains('>'), "{text:?}");
    for (at, _) in text.match_indices('&') {
        let escapes = ["&amp;", "&lt;", "&gt;", "&quot;"];
        assert!(escapes.iter().any(|escape| text[at..].starts_with(escape)), "{text:?}");
    }
}

/// ` name="value"` any number of times, or ` name` alone; nothing that runs or loads anything.
fn check_attributes(element: &str, attributes: &str) {
    let mut rest = attributes;
    while let Some(attribute) = rest.strip_prefix(' ') {
        let is_name = |c: char| c.is_ascii_alphanumeric() || c == '-';
        let end = attribute.find(|c| !is_name(c)).unwrap_or(attribute.len());
        let (name, behind) = attribute.split_at(end);
        assert!(!name.is_empty() && !name.starts_with("on"), "{attributes:?} of `{element}`");
        rest = behind;
        if let Some(quoted) = behind.strip_prefix("=\"") {
            let (value, behind) = quoted.split_once('"').expect("a value ends");
            check_text(value);
            if PLACES.contains(&name) {
                assert!(!value.contains(['N', 'n']), "{value:?} is no place in a plot");
            }
            if matches!(name, "href" | "src") {
                let own = value.starts_with('#') || value.starts_with("data:");
                assert!(own, "{value:?} is loaded from elsewhere");
            }
            rest = behind;
        }
    }
    assert!(rest.is_empty(), "{attributes:?} of `{element}`");
}
