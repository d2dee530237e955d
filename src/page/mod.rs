//! What all pages of HTML share: the head, and what a page may load and run.
//!
//! A page that is a file is complete in itself: pictures and plots are in it, it has no font and no external link, and
//! its content security policy forbids loading anything and running any script but its own. It is readable without
//! that script. A page that is served has files beside it, and may load those alone.

mod policy;
pub(crate) mod slides;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{DOCTYPE, Markup, PreEscaped, html};

pub(crate) use self::policy::served_policy;

/// A page without its content.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Page<'a> {
    /// What the window and the list of open pages say.
    pub(crate) title: &'a str,
    /// Where style and script are.
    pub(crate) parts: Parts<'a>,
}

/// Where the style and the script of a page are.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Parts<'a> {
    /// In the page, which is a file.
    Within {
        /// The version of srt that wrote it.
        version: &'a str,
        /// The sheets, in their order.
        styles: &'a [&'a str],
        /// What runs behind the content.
        script: &'a str,
    },
    /// Beside the page, which is served; the policy goes with it as a header.
    Beside {
        /// The address of the sheet.
        style: &'a str,
        /// The address of the module that is run.
        script: &'a str,
    },
}

impl Page<'_> {
    /// The page with the content of its body.
    pub(crate) fn with(&self, body: Markup) -> String {
        let whole = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    @if let Parts::Within { version, script, .. } = self.parts {
                        meta http-equiv="Content-Security-Policy" content=(policy::file_policy(script));
                        meta name="generator" content=(format!("srt {version}"));
                    }
                    link rel="icon" href="data:,";
                    title { (self.title) }
                    @match self.parts {
                        Parts::Within { styles, .. } => { style { @for sheet in styles { (PreEscaped(sheet)) } } }
                        Parts::Beside { style, script } => {
                            link rel="stylesheet" href=(style);
                            script type="module" src=(script) {}
                        }
                    }
                }
                body {
                    (body)
                    @if let Parts::Within { script, .. } = self.parts { script { (PreEscaped(script)) } }
                }
            }
        };
        whole.into_string()
    }
}

/// A picture within the page, from its bytes as PNG; `alt` says what it shows.
pub(crate) fn picture(png: &[u8], [width, height]: [u32; 2], alt: &str) -> Markup {
    let address = format!("data:image/png;base64,{}", STANDARD.encode(png));
    html! { img src=(address) width=(width) height=(height) alt=(alt); }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_may_run_its_own_script_alone_and_load_nothing() {
        let parts = Parts::Within { version: "1", styles: &["a{}", "b{}"], script: "1;" };
        let page = Page { title: "a < b", parts }.with(html! { p { "text" } });
        for part in [
            "<title>a &lt; b</title><style>a{}b{}</style>",
            "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-",
            "<p>text</p><script>1;</script></body>",
        ] {
            assert!(page.contains(part), "{part}: {page}");
        }
        let other =
            Page { title: "", parts: Parts::Within { version: "1", styles: &[], script: "2;" } };
        let hash = |page: &str| page.split("sha256-").nth(1).map(|rest| rest[..44].to_owned());
        assert!(hash(&page).is_some() && hash(&page) != hash(&other.with(html! {})));
    }

    #[test]
    fn a_page_that_is_served_names_its_files() {
        let parts = Parts::Beside { style: "a.css", script: "a.js" };
        let page = Page { title: "a", parts }.with(html! { p {} });
        assert!(page.contains(r#"<link rel="stylesheet" href="a.css">"#), "{page}");
        assert!(
            page.contains(r#"<script type="module" src="a.js">"#) && !page.contains("http-equiv")
        );
    }
}
