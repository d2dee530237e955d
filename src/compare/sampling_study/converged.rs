//! A converged picture: a scene with so many samples that hardly any noise is left.
//!
//! It is the mean of renderings with random numbers of their own. Their light samples are
//! independent, so neither method is compared with itself. The differences among the renderings
//! give the noise of their mean.

use glam::DVec3;

use crate::image_io::Picture;
use crate::math::hash_u64;
use crate::record::ConvergedPicture;
use crate::render::{Sampling, Settings};
use crate::scene::TracedWorld;

use crate::compare::budget::Budget;
use crate::compare::context::SceneContext;
use crate::compare::render_picture::{colors, render_until};

/// View samples along each side of a pixel.
const SIDE: u32 = 8;

/// Light samples along each side of a light, for each view sample.
const LIGHT_SIDE: u32 = 2;

/// Renderings at least: two give an estimate of the noise, four a good enough one.
const FEWEST_PASSES: u32 = 4;

/// Renderings at most: their mean has a hundredth of the variance of one.
const MOST_PASSES: u32 = 100;

/// Makes its random numbers others than those of the frames, which count up from the seed.
const STREAM: u64 = 0x636F_6E76_6572_6765;

/// The mean of the renderings.
pub(super) struct Converged {
    /// Row by row from the top left.
    pub(super) picture: Vec<DVec3>,
    record: ConvergedPicture,
}

impl Converged {
    pub(super) fn record(&self, scene: &str) -> ConvergedPicture {
        ConvergedPicture { scene: scene.to_owned(), ..self.record.clone() }
    }
}

/// Renders on all threads while the budget lasts; `None` if it is cancelled before there are enough
/// renderings.
pub(super) fn render(
    context: &SceneContext<'_>,
    tracer: &dyn TracedWorld,
    frame: &Settings,
    budget: Budget,
) -> Option<Converged> {
    let mut sums = Sums::default();
    for pass in 0..MOST_PASSES {
        if pass >= FEWEST_PASSES && budget.is_spent() {
            break;
        }
        let settings = Settings {
            aa: SIDE,
            light_samples: LIGHT_SIDE,
            sampling: Sampling::Independent,
            seed: hash_u64(frame.seed ^ STREAM).wrapping_add(u64::from(pass)),
            ..frame.clone()
        };
        let work = || render_until(context.cancelled, context.scene, tracer, &settings);
        let rendering = context.pools.all.install(work);
        let Some(picture) = colors(rendering.image).filter(|_| rendering.complete) else { break };
        sums.add(&picture);
    }
    (sums.count >= FEWEST_PASSES).then(|| Converged {
        record: ConvergedPicture {
            scene: String::new(),
            width: frame.width,
            height: frame.height,
            passes: sums.count,
            pixel_samples: SIDE * SIDE,
            light_samples: LIGHT_SIDE * LIGHT_SIDE,
            rmse: sums.noise_of_mean(),
        },
        picture: sums.mean,
    })
}

/// Mean and spread of every pixel (Welford, *Note on a method for calculating corrected sums of
/// squares and products*, 1962).
#[derive(Default)]
struct Sums {
    count: u32,
    mean: Vec<DVec3>,
    /// The sum of squared differences to the mean, over all pixels and channels.
    squares: f64,
}

impl Sums {
    fn add(&mut self, picture: &Picture) {
        self.mean.resize(picture.pixels.len(), DVec3::ZERO);
        self.count += 1;
        for (mean, pixel) in self.mean.iter_mut().zip(&picture.pixels) {
            let pixel = pixel.as_dvec3();
            let before = pixel - *mean;
            *mean += before / f64::from(self.count);
            self.squares += before.dot(pixel - *mean);
        }
    }

    /// The root of the mean variance of a channel's mean.
    fn noise_of_mean(&self) -> f64 {
        let (count, channels) = (f64::from(self.count), 3.0 * self.mean.len() as f64);
        (self.squares / (count - 1.0) / count / channels).sqrt()
    }
}

/// The root of the mean squared difference of a picture to the converged one.
pub(super) fn rmse(picture: &Picture, converged: &[DVec3]) -> f64 {
    let square =
        |(pixel, mean): (&crate::math::Color, &DVec3)| (pixel.as_dvec3() - *mean).length_squared();
    let sum: f64 = picture.pixels.iter().zip(converged).map(square).sum();
    (sum / (3.0 * converged.len() as f64)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Color;

    fn picture(values: [f32; 2]) -> Picture {
        Picture { width: 2, height: 1, pixels: values.map(Color::splat).to_vec() }
    }

    #[test]
    fn the_mean_and_its_noise_are_those_of_the_textbook() {
        let mut sums = Sums::default();
        for values in [[1.0, 5.0], [3.0, 5.0], [5.0, 5.0]] {
            sums.add(&picture(values));
        }
        assert_eq!(sums.mean, [DVec3::splat(3.0), DVec3::splat(5.0)]);
        // Variances of single renderings 4 and 0, of the mean of three 4/3 and 0.
        assert!((sums.noise_of_mean() - (2.0_f64 / 3.0).sqrt()).abs() < 1e-12);
        assert!((rmse(&picture([4.0, 5.0]), &sums.mean) - 0.5_f64.sqrt()).abs() < 1e-12);
    }
}
