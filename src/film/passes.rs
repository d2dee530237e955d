//! The samples of a pixel in passes over the whole picture.

use std::ops::Range;

/// The most samples of a pixel in a pass. A tile's samples are held until they are added up, so many at a time: 0.8 MB.
pub const MOST_SAMPLES_OF_A_PASS: u32 = 256;

/// Passes of a picture that is to be seen soon: sample 0, then as many samples as there are already, and no more than
/// [`MOST_SAMPLES_OF_A_PASS`].
#[must_use]
pub fn doubling_passes(samples: u32) -> Vec<Range<u32>> {
    passes(samples, |done| done.clamp(1, MOST_SAMPLES_OF_A_PASS))
}

/// Passes of a picture that is seen at its end: of [`MOST_SAMPLES_OF_A_PASS`] samples.
#[must_use]
pub fn even_passes(samples: u32) -> Vec<Range<u32>> {
    passes(samples, |_| MOST_SAMPLES_OF_A_PASS)
}

/// Passes as long as `length` says of what is done.
fn passes(samples: u32, length: impl Fn(u32) -> u32) -> Vec<Range<u32>> {
    let mut passes = Vec::new();
    let mut done = 0;
    while done < samples {
        let end = done.saturating_add(length(done)).min(samples);
        passes.push(done..end);
        done = end;
    }
    passes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_cover_all_samples_once() {
        assert_eq!(doubling_passes(9), [0..1, 1..2, 2..4, 4..8, 8..9]);
        assert_eq!(even_passes(300), [0..256, 256..300]);
        for samples in [1, 255, 256, 257, 65_536] {
            for passes in [doubling_passes(samples), even_passes(samples)] {
                assert_eq!((passes[0].start, passes[passes.len() - 1].end), (0, samples));
                assert!(passes.windows(2).all(|two| two[0].end == two[1].start));
                assert!(passes.iter().all(|pass| pass.len() <= MOST_SAMPLES_OF_A_PASS as usize));
            }
        }
    }
}
