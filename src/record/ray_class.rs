//! What rays are sent for: the one definition that rendering, measuring and reports share.

use serde::{Deserialize, Serialize};

/// What a ray is sent for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RayClass {
    /// From the eye through a pixel.
    View,
    /// From a surface to a light: whether anything is between.
    Shadow,
    /// From a surface in the mirror direction.
    Mirror,
    /// Through a surface.
    Refraction,
    /// From a surface in a random direction: the first bounce of diffuse light.
    Diffuse,
    /// Uniformly random through the scene's box.
    Random,
    /// Parallel, along an axis of the scene's box: as a height field is probed.
    Probe,
}

impl RayClass {
    /// All classes, in the order of reports.
    pub const ALL: [Self; 7] = [
        Self::View,
        Self::Shadow,
        Self::Mirror,
        Self::Refraction,
        Self::Diffuse,
        Self::Random,
        Self::Probe,
    ];

    /// The classes that a rendering sends: the first of [`ALL`](Self::ALL).
    pub const RENDERED: [Self; 4] = [Self::View, Self::Shadow, Self::Mirror, Self::Refraction];

    /// The name in reports, as in the record.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::View => "view",
            Self::Shadow => "shadow",
            Self::Mirror => "mirror",
            Self::Refraction => "refraction",
            Self::Diffuse => "diffuse",
            Self::Random => "random",
            Self::Probe => "probe",
        }
    }
}
