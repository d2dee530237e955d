//! Samples of area lights: the points that shadow rays are sent to.
//!
//! A sample is a point of the unit square. With m × m light samples for each of a pixel's n × n
//! view samples, a pixel takes (n·m)² samples of each light.
//!
//! *Shuffled*: tables of (n·m)² jittered points are made once. For each light, a pixel picks a
//! table and a random permutation of its view samples. Each block of n × n neighbouring cells then
//! gives one point to each view sample. So each view sample is stratified over m × m cells of the
//! light, and the samples of a whole pixel over (n·m)² cells. With m = 1 this is the course's
//! method: one set, shuffled, of which the i-th view sample takes the i-th point. Mirrored and
//! refracted rays use the points of their view sample.
//!
//! *Independent*: m × m jittered points, made for each view sample and light separately.

use std::ops::Range;

use crate::math::Random;

use super::Sampling;

/// How many tables there are: enough that neighbouring pixels do not repeat each other's noise.
const TABLES: u64 = 32;

/// Keys that separate the streams of random numbers.
const TABLE_STREAM: u64 = 0x7461_626C;
const ORDER_STREAM: u64 = 0x6F72_6465;

/// The samples of area lights for a rendering.
pub struct LightSamples {
    sampling: Sampling,
    seed: u64,
    view_side: usize,
    light_side: usize,
    /// All tables, one after the other. In each, the m × m points of one view sample are
    /// contiguous.
    tables: Vec<[f32; 2]>,
}

/// Which samples of one light each view sample of a batch takes.
#[derive(Default)]
pub struct SampleAssignment {
    /// For each view sample the index of its first point in the tables; empty if points are made
    /// on the fly.
    firsts: Vec<u32>,
}

impl SampleAssignment {
    /// Removes all view samples.
    pub fn clear(&mut self) {
        self.firsts.clear();
    }
}

impl LightSamples {
    /// Makes the tables, if the method has any.
    ///
    /// A pixel has `aa × aa` view samples. Each takes `light_samples × light_samples` points of
    /// each area light. 0 is taken as 1.
    #[must_use]
    pub fn new(sampling: Sampling, seed: u64, aa: u32, light_samples: u32) -> Self {
        let (view_side, light_side) = (aa.max(1) as usize, light_samples.max(1) as usize);
        let tables = match sampling {
            Sampling::Shuffled => (0..TABLES)
                .flat_map(|i| {
                    let mut random = Random::new(&[seed, TABLE_STREAM, i]);
                    let table = jittered(view_side * light_side, &mut random);
                    by_view_sample(&table, view_side, light_side)
                })
                .collect(),
            Sampling::Independent => Vec::new(),
        };
        Self { sampling, seed, view_side, light_side, tables }
    }

    /// The number of samples that a view sample takes of each area light.
    #[must_use]
    pub fn per_view_sample(&self) -> usize {
        self.light_side * self.light_side
    }

    /// Assigns samples of a light to the view samples of a pixel: a table, in a random order
    /// (Fisher-Yates). They are appended to those of earlier pixels.
    pub fn assign(&self, pixel: u64, light: usize, assignment: &mut SampleAssignment) {
        let all = 0..(self.view_side * self.view_side) as u32;
        self.assign_some(pixel, light, all, assignment);
    }

    /// The same for some view samples of the pixel alone, by their numbers. They take what they take among all.
    pub(super) fn assign_some(
        &self,
        pixel: u64,
        light: usize,
        views_to_assign: Range<u32>,
        assignment: &mut SampleAssignment,
    ) {
        if self.sampling == Sampling::Independent {
            return;
        }
        let mut random = Random::new(&[self.seed, ORDER_STREAM, pixel, light as u64]);
        let views = self.view_side * self.view_side;
        let table = random.below(TABLES as u32) * (views * self.per_view_sample()) as u32;
        let before = assignment.firsts.len();
        let places = 0..views as u32;
        assignment.firsts.extend(places.map(|place| table + place * self.per_view_sample() as u32));
        let order = &mut assignment.firsts[before..];
        for last in (1..order.len()).rev() {
            order.swap(last, random.below(last as u32 + 1) as usize);
        }
        assignment.firsts.truncate(before + views_to_assign.end as usize);
        assignment.firsts.drain(before..before + views_to_assign.start as usize);
    }

    /// The samples of one light for one path, as points of the unit square.
    ///
    /// `sample` is the index of the path's view sample in the batch, `key` the path's random key.
    /// Samples that are made on the fly are put into `buffer`.
    #[inline]
    pub fn points<'a>(
        &'a self,
        assignment: &SampleAssignment,
        light: usize,
        sample: usize,
        key: u64,
        buffer: &'a mut Vec<[f32; 2]>,
    ) -> &'a [[f32; 2]] {
        match self.sampling {
            Sampling::Shuffled => {
                let first = assignment.firsts[sample] as usize;
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

/// Reorders a table of (n·m)² points, row by row, so that the points of each view sample are
/// contiguous: one of each block of n × n cells.
fn by_view_sample(table: &[[f32; 2]], n: usize, m: usize) -> Vec<[f32; 2]> {
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
        let mut assignment = SampleAssignment::default();
        samples.assign(pixel, 0, &mut assignment);
        (0..views as usize)
            .map(|view| {
                let key = view as u64 + 100 * pixel;
                samples.points(&assignment, 0, view, key, &mut Vec::new()).to_vec()
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
