//! The picture of few pixels that is there at once, while there is no better one.

use std::time::Duration;

use crate::film::Crop;
use crate::render::{Settings, View};

use super::update::Pixels;

/// Rendering the coarse pictures of all structures may take this long: with the way to the screen it is still at once.
const AT_ONCE: Duration = Duration::from_millis(20);

/// How many times fewer columns and rows a coarse picture may have.
const DIVISORS: [u32; 10] = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32];

/// Where nothing was measured yet.
const FIRST_DIVISOR: u32 = 8;

/// The least divisor by which the picture is there at once beside those of other structures; `cost` is what a pixel was
/// measured to take, in seconds.
pub(super) fn divisor(cost: Option<f64>, settings: &Settings, lanes: usize) -> u32 {
    // The coarse pixels of a heatmap have one sample, those of the picture have all.
    let least = if settings.view == View::Heatmap { 2 } else { 1 };
    let Some(cost) = cost else { return FIRST_DIVISOR };
    let time = AT_ONCE.as_secs_f64() / lanes.max(1) as f64;
    let takes = |divisor: u32| {
        let [width, height] = size(settings, divisor);
        cost * f64::from(width) * f64::from(height)
    };
    let fits = |divisor: &u32| *divisor >= least && takes(*divisor) <= time;
    DIVISORS.into_iter().find(fits).unwrap_or(DIVISORS[DIVISORS.len() - 1])
}

/// The settings of the coarse picture: one ray through the centre of each pixel.
pub(super) fn coarse(settings: &Settings, divisor: u32) -> Settings {
    let [width, height] = size(settings, divisor);
    Settings { width, height, aa: 0, ..settings.clone() }
}

fn size(settings: &Settings, divisor: u32) -> [u32; 2] {
    [settings.width, settings.height].map(|side| side.div_ceil(divisor))
}

/// Puts the pixels of a coarse picture where a better one has none.
pub(super) fn fill_missing(
    pixels: &mut Pixels,
    missing: impl Iterator<Item = Crop>,
    coarse: &Pixels,
) {
    let place =
        |x: u32, from: u32, to: u32| (u64::from(x) * u64::from(to) / u64::from(from)) as usize;
    let columns: Vec<usize> =
        (0..pixels.width).map(|x| place(x, pixels.width, coarse.width)).collect();
    for area in missing {
        let within = area.x0 as usize..area.x1 as usize;
        for y in area.y0..area.y1 {
            let row = place(y, pixels.height, coarse.height) * coarse.width as usize;
            let first = y as usize * pixels.width as usize;
            for (x, column) in within.clone().zip(&columns[within.clone()]) {
                let (from, to) = (4 * (row + column), 4 * (first + x));
                pixels.rgba[to..to + 4].copy_from_slice(&coarse.rgba[from..from + 4]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::Sampling;

    fn settings(view: View) -> Settings {
        Settings {
            width: 640,
            height: 361,
            crop: None,
            aa: 4,
            light_samples: 1,
            sampling: Sampling::default(),
            max_recursion: 1,
            seed: 0,
            view,
            count: false,
        }
    }

    #[test]
    fn what_is_slow_gets_fewer_pixels() {
        let color = settings(View::Color);
        let of = |cost, lanes| divisor(cost, &color, lanes);
        assert_eq!((of(None, 1), of(Some(1e-9), 1), of(Some(1.0), 1)), (8, 1, 32));
        // 57,920 pixels of half the size take 17 ms.
        assert_eq!((of(Some(3e-7), 1), of(Some(3e-7), 2)), (2, 3));
        assert_eq!(divisor(Some(1e-9), &settings(View::Heatmap), 1), 2);
        let coarse = coarse(&color, 2);
        assert_eq!((coarse.width, coarse.height, coarse.aa), (320, 181, 0));
    }

    #[test]
    fn missing_areas_are_filled_and_no_others() {
        let picture = |width, height, value| Pixels {
            serial: 0,
            width,
            height,
            rgba: vec![value; 4 * (width * height) as usize],
        };
        let mut fine = picture(5, 4, 9);
        let mut coarse = picture(3, 2, 0);
        coarse.rgba[4 * 5..].fill(7);
        fill_missing(&mut fine, [Crop { x0: 2, y0: 1, x1: 5, y1: 4 }].into_iter(), &coarse);
        let rows: Vec<Vec<u8>> =
            fine.rgba.chunks(20).map(|row| row.iter().step_by(4).copied().collect()).collect();
        assert_eq!(rows, [[9; 5], [9, 9, 0, 0, 0], [9, 9, 0, 0, 7], [9, 9, 0, 0, 7]]);
    }
}
