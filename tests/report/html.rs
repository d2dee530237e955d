//! The page: whole, self-contained, and nothing of the record lost on it.

use std::collections::BTreeMap;
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest, Sha256};
use srt::report::Report;

use crate::sample;

/// The page of a record; it is also kept as a file for a look in a browser.
pub(crate) fn page(name: &str, comparison: &srt::record::Comparison) -> String {
    let page = Report::new(comparison).html(&sample::pictures(comparison));
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("report");
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join(format!("{name}.html")), &page).unwrap();
    page
}

#[test]
fn the_page_loads_nothing_and_runs_what_sorts_its_tables_alone() {
    let page = page("full", &sample::full());
    let script = page.split_once("<script>").unwrap().1.split_once("</script>").unwrap().0;
    let hash = STANDARD.encode(Sha256::digest(script));
    assert!(page.contains(&format!(
        "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-{hash}'"
    )));
    assert_eq!(page.matches("<script").count(), 1);
    for foreign in ["<link rel=\"stylesheet", "src=\"http", "@import", "url("] {
        assert!(!page.contains(foreign), "{foreign}");
    }
    let sources = page.matches("src=\"").count();
    assert_eq!(sources, page.matches("src=\"data:image/png;base64,").count());
    assert_eq!(sources, 9, "two pictures and seven heatmaps");
}

#[test]
fn every_plot_is_there_and_named() {
    let page = page("full", &sample::full());
    let scene = [
        "speed-up over",
        "million rays per second",
        "share of leaves by size",
        "build against trace",
        "when a slower build pays off",
    ];
    for title in scene {
        assert_eq!(page.matches(&format!(": {title}")).count() / 5, 2, "{title}");
    }
    assert!(page.contains("hall: view rays against triangles"));
    assert!(
        page.contains("bunny: noise against time") && page.contains("hall: noise against time")
    );
    assert_eq!(
        page.matches("<svg").count(),
        page.matches("role=\"img\" aria-label=").count()
            + page.matches(" bar\" role=\"img\"").count()
    );
    assert!(!page.contains("NaN") && !page.contains("inf"), "a number went wrong");
}

#[test]
fn text_of_the_record_is_escaped() {
    let page = page("partial", &sample::partial());
    assert!(page.contains("memory &lt;here&gt;") && page.contains("&lt;16 &amp; more&gt;"));
    assert!(page.contains("Partial."));
    assert!(page.contains("origin (0, 1, 5)"));
}

#[test]
fn sentences_begin_with_capitals_and_names_in_them_are_set_as_names() {
    let mut comparison = sample::full();
    comparison.notes.push("hall: `none` & `ball` had no time.".to_owned());
    let page = Report::new(&comparison).html(&sample::pictures(&comparison));
    assert!(page.contains("<code>none</code> &amp; <code>ball</code> had no time."));
    assert!(page.contains("<p class=\"subtitle\">No difference in "));
}

#[test]
fn a_record_of_nothing_is_a_page() {
    let page = page("minimal", &sample::minimal());
    assert!(page.contains("nothing was traced") && page.ends_with("</html>"));
}

#[test]
fn a_missing_picture_is_reported() {
    let page = Report::new(&sample::full()).html(&BTreeMap::new());
    assert!(page.contains("pictures/bunny.png") && page.contains("is missing"));
}

/// The plots as files by themselves: those of the page, each with its heading and its style.
#[test]
fn plots_are_files_too() {
    let comparison = sample::full();
    let page = page("full", &comparison);
    let plots: BTreeMap<String, String> = Report::new(&comparison).plots().into_iter().collect();
    assert_eq!(plots.len(), page.matches("<figure class=\"plot\">").count());
    let names = ["all-scenes-builds", "all-scenes-memory", "bunny-rates", "hall-speedup"];
    assert!(names.iter().all(|name| plots.contains_key(&format!("{name}.svg"))));
    for (name, text) in &plots {
        assert!(text.starts_with("<svg xmlns=") && text.ends_with("</svg>\n"), "{name}");
        assert!(text.contains("<style>") && text.contains("class=\"title\""), "{name}");
        assert!(!text.contains("NaN") && !text.contains("inf"), "{name}");
        for opened in ["svg", "g", "text", "title"] {
            let count = |mark: &str| text.matches(mark).count();
            let begun = count(&format!("<{opened}>")) + count(&format!("<{opened} "));
            assert_eq!(begun, count(&format!("</{opened}>")), "{name}: {opened}");
        }
    }
}
