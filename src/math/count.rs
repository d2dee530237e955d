//! Numbers of things as people write them.

/// Reads a number of things: digits alone, or with `k` or `M` behind them for thousands or
/// millions. Too large ones saturate, so that a check of the range still refuses them.
///
/// ```
/// use srt::math::read_count;
///
/// assert_eq!(["70000", "70k", "1M"].map(read_count), [Some(70_000), Some(70_000), Some(1_000_000)]);
/// assert_eq!(["", "k", "-5", "1.5k"].map(read_count), [None; 4]);
/// ```
#[must_use]
pub fn read_count(text: &str) -> Option<u32> {
    let (digits, unit) = match text.strip_suffix(['k', 'K']) {
        Some(digits) => (digits, 1_000),
        None => text.strip_suffix(['m', 'M']).map_or((text, 1), |digits| (digits, 1_000_000)),
    };
    // Rust's own parser would also take `+3`.
    let fine = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
    fine.then(|| digits.parse().unwrap_or(u32::MAX).saturating_mul(unit))
}
