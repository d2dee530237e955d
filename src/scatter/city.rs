//! A town of boxes: instances within instances. Towers stand in blocks, blocks in quarters, with streets and avenues
//! between them, so that boxes are in clusters of three scales, and where all is flat beside the middle.

use glam::{DAffine3, DVec3};

use super::{Form, Scattered};
use crate::math::{Color, Random};

/// Separates the random streams from other uses of the same numbers.
const TOWER: u64 = 0x746F_7765_7273;

/// Boxes of a tower: its foot, its shaft, its head and its mast.
const BOXES: u32 = 4;
/// Towers along the side of a block, and blocks along that of a quarter.
const BLOCK: u32 = 4;
const QUARTER: u32 = 4;
/// The width of a street and of an avenue, in plots.
const STREET: f64 = 0.7;
const AVENUE: f64 = 1.2;
/// The height of the highest tower.
const HEIGHT: f64 = 0.3;
/// The colours of towers: plaster, sandstone, brick, slate, glass.
const TINTS: [Color; 5] = [
    Color::new(0.93, 0.90, 0.84),
    Color::new(0.88, 0.78, 0.62),
    Color::new(0.76, 0.48, 0.36),
    Color::new(0.52, 0.56, 0.62),
    Color::new(0.66, 0.80, 0.86),
];

/// How a town of so many boxes is laid out: a square of plots.
#[derive(Clone, Copy, Debug)]
pub(super) struct Town {
    /// Plots along a side.
    side: u32,
    /// The width of a plot.
    plot: f64,
}

impl Town {
    /// The town of so many boxes, at least one.
    pub(super) fn of(boxes: u32) -> Self {
        let towers = boxes.div_ceil(BOXES).max(1);
        let mut side = f64::from(towers).sqrt() as u32;
        while u64::from(side) * u64::from(side) < u64::from(towers) {
            side += 1;
        }
        Self { side, plot: 2.0 / (start_of(side - 1) + 1.0) }
    }

    /// A box.
    pub(super) fn part(&self, seed: u64, index: u32) -> Scattered {
        let tower = index / BOXES;
        let mut random = Random::new(&[TOWER, seed, u64::from(tower)]);
        let mut between = |low: f64, high: f64| low + (high - low) * f64::from(random.next_f32());
        let corner = |plot: u32| start_of(plot) * self.plot - 1.0 + 0.5 * self.plot;
        let place = DVec3::new(corner(tower % self.side), corner(tower / self.side), 0.0);
        // Towards the middle the town grows, most of all at the very middle.
        let middle = 1.0 / (1.0 + 12.0 * place.length_squared());
        let luck = between(0.0, 1.0);
        let height = HEIGHT * middle * (0.16 + 0.84 * luck * luck * luck);
        let width = self.plot * between(0.34, 0.46);
        let slender = between(0.55, 0.85);
        let tint = TINTS[(between(0.0, 1.0) * TINTS.len() as f64) as usize];
        // From below to above, each on top of the one before: half its width, where it begins and ends.
        let (foot, head) = (0.25 * height, 0.85 * height);
        let (half, low, high) = match index % BOXES {
            0 => (width, 0.0, foot),
            1 => (slender * width, foot, head),
            2 => (0.7 * slender * width, head, height),
            _ => (0.06 * width, height, 1.2 * height),
        };
        let size = DVec3::new(half, half, 0.5 * (high - low));
        let own = DAffine3::from_scale(size);
        let up = DAffine3::from_translation(DVec3::Z * (0.5 * (low + high)));
        let form = Form::Instance(DAffine3::from_translation(place) * up * own);
        Scattered { form, tint }
    }
}

/// Where a plot begins along a side, in plots: those before it, with their streets and avenues.
fn start_of(plot: u32) -> f64 {
    let streets = f64::from(plot / BLOCK);
    let avenues = f64::from(plot / (BLOCK * QUARTER));
    f64::from(plot) + STREET * streets + AVENUE * avenues
}
