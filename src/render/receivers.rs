//! Surfaces on which light falls, sixteen at a time: a lane each. At 4 × 4 samples, those of one
//! pixel.

use glam::{Vec3, Vec4};

use crate::math::ones;
use crate::simd::LANES;

use super::finish::Finish;
use super::optics::Exponent;

/// A number for each lane.
pub(super) type Row = [f32; LANES];

/// x, y and z of a vector for each lane.
pub(super) type Rows3 = [Row; 3];

/// Up to sixteen surfaces that follow each other in a wave, laid out for lanes.
#[derive(Clone, Debug)]
pub(super) struct Receivers {
    pub(super) origin: Rows3,
    /// The origins again, as rays have them: with a beginning of 0.
    pub(super) starts: [Vec4; LANES],
    pub(super) normal: Rows3,
    pub(super) geometric_normal: Rows3,
    /// Directions from where they are seen; unit vectors where there are highlights.
    pub(super) view_dir: Rows3,
    /// Bits of lanes: that have a surface,
    pub(super) present: u32,
    /// whose surface lets no light through,
    pub(super) opaque: u32,
    /// whose surface sends on light from all sides,
    pub(super) matte: u32,
    /// whose surface has highlights.
    pub(super) shining: u32,
    /// How sharp the highlights are in each lane,
    pub(super) exponents: [Exponent; LANES],
    /// and in all that have them, if these agree.
    pub(super) exponent: Option<Exponent>,
}

/// One of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Receiver<'a> {
    pub(super) finish: &'a Finish,
    pub(super) origin: Vec3,
    pub(super) normal: Vec3,
    pub(super) geometric_normal: Vec3,
    pub(super) view_dir: Vec3,
}

impl Receivers {
    /// No surfaces.
    pub(super) const NONE: Self = Self {
        origin: [[0.0; LANES]; 3],
        starts: [Vec4::ZERO; LANES],
        normal: [[0.0; LANES]; 3],
        geometric_normal: [[0.0; LANES]; 3],
        view_dir: [[0.0; LANES]; 3],
        present: 0,
        opaque: 0,
        matte: 0,
        shining: 0,
        exponents: [Exponent::Whole(0); LANES],
        exponent: None,
    };

    /// Lays out up to [`LANES`] surfaces. What stood in other lanes is left there.
    pub(super) fn lay_out<'a>(&mut self, surfaces: impl Iterator<Item = Receiver<'a>>) {
        (self.present, self.opaque, self.matte, self.shining) = (0, 0, 0, 0);
        for (lane, surface) in surfaces.enumerate().take(LANES) {
            self.set(lane, &surface);
        }
        self.exponent = self.common_exponent();
    }

    #[inline]
    fn set(&mut self, lane: usize, surface: &Receiver<'_>) {
        for (rows, vector) in [
            (&mut self.origin, surface.origin),
            (&mut self.normal, surface.normal),
            (&mut self.geometric_normal, surface.geometric_normal),
            (&mut self.view_dir, surface.view_dir),
        ] {
            [rows[0][lane], rows[1][lane], rows[2][lane]] = vector.to_array();
        }
        self.starts[lane] = surface.origin.extend(0.0);
        let finish = surface.finish;
        self.present |= 1 << lane;
        self.opaque |= u32::from(finish.opaque) << lane;
        self.matte |= u32::from(finish.matte) << lane;
        self.shining |= u32::from(finish.shines) << lane;
        self.exponents[lane] = finish.exponent;
    }

    fn common_exponent(&self) -> Option<Exponent> {
        let mut shining = ones(self.shining).map(|lane| self.exponents[lane]);
        let first = shining.next()?;
        shining.all(|exponent| exponent == first).then_some(first)
    }
}
