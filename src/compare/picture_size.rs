//! Pictures of the same shape and another size.

/// The size of the same shape whose longer side is at most `largest` pixels.
pub(super) fn fit(size: [u32; 2], largest: u32) -> [u32; 2] {
    let longer = size[0].max(size[1]).max(1);
    if longer <= largest {
        return size;
    }
    let scaled = |side: u32| u64::from(side) * u64::from(largest) / u64::from(longer);
    size.map(|side| scaled(side).max(1) as u32)
}

/// The size of the same shape with about `pixels` pixels; no larger than it was.
pub(super) fn fit_pixels(size: [u32; 2], pixels: f64) -> [u32; 2] {
    let [width, height] = size.map(f64::from);
    let longer = (pixels / (width * height)).sqrt() * width.max(height);
    fit(size, (longer as u32).max(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_keep_their_shape() {
        assert_eq!(fit([480, 320], 300), [300, 200]);
        assert_eq!(fit([100, 50], 300), [100, 50]);
        assert_eq!(fit([65_535, 1], 300), [300, 1]);
    }

    #[test]
    fn about_so_many_pixels_are_never_more_than_there_were() {
        assert_eq!(fit_pixels([400, 300], 1_200.0), [40, 30]);
        assert_eq!(fit_pixels([400, 300], 1e9), [400, 300]);
        assert_eq!(fit_pixels([400, 300], 0.0), [1, 1]);
    }
}
