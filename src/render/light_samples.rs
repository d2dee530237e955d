//! Where on an area light a view sample's shadow rays go.
//!
//! A sample is a point of the unit square. With m × m light samples for each of a pixel's n × n
//! view samples, a pixel takes (n·m)² samples of each light.
//!
//! *Shuffled*: tables of (n·m)² jittered points are made once. A pixel picks a table for each
//! light, and a random order of its view samples; each block of n × n neighbouring cells then gives
//! one point to each view sample. So every view sample covers the light by m × m strata, and all
//! of a pixel's together by (n·m)². With m = 1 this is the course's way: one set, shuffled, of
//! which the i-th view sample takes the i-th, and hands it on to the rays that follow it.
//!
//! *Independent*: m × m jittered points, made for each view sample and light on its own.

use crate::math::Random;

use super::Sampling;

/// How many tables there are: enough that neighbouring pixels do not repeat each other's noise.
const TABLES: u64 = 32;

/// Keeps the streams of random numbers apart.
const TABLE_STREAM: u64 = 0x7461_626C;
const ORDER_STREAM: u64 = 0x6F72_6465;

/// The samples of area lights for a rendering.
pub struct LightSamples {
    sampling: Sampling,
    seed: u64,
    view_side: usize,
    light_side: usize,
    /// The tables one behind the other, each block-wise apart: the m × m points of view sample 0,
    /// then of view sample 1, …
    tables: Vec<[f32; 2]>,
}

/// The samples of one light that are dealt to the view samples of a batch.
#[derive(Default)]
pub struct Dealt {
    /// For each view sample, where in the tables its points begin; empty if they are made on the
    /// fly.
    firsts: Vec<u32>,
}

impl Dealt {
    /// Forgets what was dealt.
    pub fn clear(&mut self) {
        self.firsts.clear();
    }
}

impl LightSamples {
    /// Makes what a method makes once: for aa × aa view samples a pixel, each of which takes
    /// light_samples × light_samples points of each area light. 0 is taken as 1.
    #[must_use]
    pub fn new(sampling: Sampling, seed: u64, aa: u32, light_samples: u32) -> Self {
        let (view_side, light_side) = (aa.max(1) as usize, light_samples.max(1) as usize);
        let tables = match sampling {
            Sampling::Shuffled => (0..TABLES)
                .flat_map(|i| {
                    let mut random = Random::new(&[seed, TABLE_STREAM, i]);
                    let table = jittered(view_side * light_side, &mut random);
                    dealt(&table, view_side, light_side)
                })
                .collect(),
            Sampling::Independent => Vec::new(),
        };
        Self { sampling, seed, view_side, light_side, tables }
    }

    /// Samples a view sample takes of each area light.
    #[must_use]
    pub fn per_view_sample(&self) -> usize {
        self.light_side * self.light_side
    }

    /// Deals samples of a light to the view samples of a pixel, behind those of the pixels before:
    /// a table, in a random order (Fisher-Yates).
    pub fn deal(&self, pixel: u64, light: usize, dealt: &mut Dealt) {
        if self.sampling == Sampling::Independent {
            return;
        }
        let mut random = Random::new(&[self.seed, ORDER_STREAM, pixel, light as u64]);
        let views = self.view_side * self.view_side;
        let table = random.below(TABLES as u32) * (views * self.per_view_sample()) as u32;
        let before = dealt.firsts.len();
        let places = 0..views as u32;
        dealt.firsts.extend(places.map(|place| table + place * self.per_view_sample() as u32));
        let order = &mut dealt.firsts[before..];
        for last in (1..order.len()).rev() {
            order.swap(last, random.below(last as u32 + 1) as usize);
        }
    }

    /// The samples of one light for one path: `key` belongs to the path, `sample` is its view
    /// sample in the batch. `buffer` holds them if they are made on the fly.
    #[inline]
    pub fn points<'a>(
        &'a self,
        dealt: &Dealt,
        light: usize,
        sample: usize,
        key: u64,
        buffer: &'a mut Vec<[f32; 2]>,
    ) -> &'a [[f32; 2]] {
        match self.sampling {
            Sampling::Shuffled => {
                let first = dealt.firsts[sample] as usize;
                &self.tables[first..first + self.per_view_sample()]
            }
            Sampling::Independent => {
                buffer.clear();
                fill_jittered(self.light_side, &mut Random::new(&[key, light as u64]), buffer);
                buffer
            }
        }
    }
}

/// A table of (n·m)² points in the order in which it is dealt out: of each block of n × n cells
/// one point to each view sample.
fn dealt(table: &[[f32; 2]], n: usize, m: usize) -> Vec<[f32; 2]> {
    let mut points = Vec::with_capacity(table.len());
    for place in 0..n * n {
        let (x, y) = (place % n, place / n);
        for (i, j) in (0..m * m).map(|block| (block % m, block / m)) {
            points.push(table[(j * n + y) * n * m + i * n + x]);
        }
    }
    points
}

/// side × side points of the unit square, one at a random place in each cell, row by row.
fn jittered(side: usize, random: &mut Random) -> Vec<[f32; 2]> {
    let mut points = Vec::with_capacity(side * side);
    fill_jittered(side, random, &mut points);
    points
}

fn fill_jittered(side: usize, random: &mut Random, points: &mut Vec<[f32; 2]>) {
    let cell = 1.0 / side as f32;
    for j in 0..side {
        for i in 0..side {
            let [x, y] = random.next_pair();
            points.push([(i as f32 + x) * cell, (j as f32 + y) * cell]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All samples that a pixel takes of light 0.
    fn samples_of_pixel(samples: &LightSamples, pixel: u64, views: u32) -> Vec<Vec<[f32; 2]>> {
        let mut dealt = Dealt::default();
        samples.deal(pixel, 0, &mut dealt);
        (0..views as usize)
            .map(|view| {
                let key = view as u64 + 100 * pixel;
                samples.points(&dealt, 0, view, key, &mut Vec::new()).to_vec()
            })
            .collect()
    }

    fn cells(points: impl IntoIterator<Item = [f32; 2]>, side: usize) -> Vec<u32> {
        let mut count = vec![0; side * side];
        for [x, y] in points {
            count[(y * side as f32) as usize * side + (x * side as f32) as usize] += 1;
        }
        count
    }

    #[test]
    fn shuffled_samples_of_a_pixel_cover_the_light_evenly() {
        let samples = LightSamples::new(Sampling::Shuffled, 1, 4, 3);
        for pixel in 0..20 {
            let views = samples_of_pixel(&samples, pixel, 16);
            assert!(cells(views.iter().flatten().copied(), 12).iter().all(|&n| n == 1));
            for view in views {
                assert!(cells(view, 3).iter().all(|&n| n == 1), "each view sample on its own");
            }
        }
    }

    #[test]
    fn independent_samples_cover_the_light_for_each_view_sample() {
        let samples = LightSamples::new(Sampling::Independent, 1, 4, 3);
        for view in samples_of_pixel(&samples, 5, 16) {
            assert!(cells(view, 3).iter().all(|&n| n == 1));
        }
    }

    #[test]
    fn samples_depend_on_seed_and_pixel_alone() {
        for sampling in [Sampling::Shuffled, Sampling::Independent] {
            let take =
                |seed, pixel| samples_of_pixel(&LightSamples::new(sampling, seed, 2, 2), pixel, 4);
            assert_eq!(take(1, 7), take(1, 7));
            assert_ne!(take(1, 7), take(1, 8));
        }
        let first = LightSamples::new(Sampling::Shuffled, 1, 2, 2);
        let second = LightSamples::new(Sampling::Shuffled, 2, 2, 2);
        assert_ne!(samples_of_pixel(&first, 7, 4), samples_of_pixel(&second, 7, 4));
    }
}
