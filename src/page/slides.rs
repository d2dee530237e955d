//! Pictures that are shown one after the other: with the script by a slider, its buttons, the arrow keys, or played;
//! without it, and on paper, all of them in rows.

use maud::{Markup, html};

/// The sheet; it takes the colours `--page`, `--ink`, `--rule`, `--box` and `--link`.
pub(crate) const STYLE: &str = include_str!("slides.css");

/// The script, for one row of slides in a page.
pub(crate) const SCRIPT: &str = include_str!("slides.js");

/// The controls and the slides, `figure`s whose captions have a `strong` title; `thing` is what one is called.
/// If they can be `played`, each is shown for so many milliseconds.
pub(crate) fn slides(thing: &str, played: Option<u32>, figures: &[Markup]) -> Markup {
    html! {
        // Shown by the script.
        div class="controls" hidden {
            @if let Some(milliseconds) = played {
                button type="button" data-play=(milliseconds) aria-pressed="false" { "Play" }
            }
            button type="button" data-step="-1" aria-label=(format!("the {thing} before")) { "←" }
            input type="range" min="0" max=(figures.len().saturating_sub(1)) value="0" aria-label=(thing);
            button type="button" data-step="1" aria-label=(format!("the next {thing}")) { "→" }
            button type="button" data-all="" aria-pressed="false" { "All" }
        }
        div class="slides" { @for figure in figures { (figure) } }
    }
}
