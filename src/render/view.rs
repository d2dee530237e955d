//! What a rendering shows of a scene.

/// What a pixel shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum View {
    /// The picture.
    #[default]
    Color,
    /// The shading normal n at the first hit: (n + 1)/2 as a colour.
    Normal,
    /// The distance of the first hit along the view ray, in the scene's unit.
    Depth,
    /// The object that was hit: a colour for each.
    Object,
    /// The primitive that was hit: a colour for each.
    Primitive,
    /// The leaf of the structure that the ray enters first: a colour for each.
    Cells,
    /// How many boxes and primitives all of a pixel's rays tested.
    Heatmap,
}

impl View {
    /// All views.
    pub const ALL: [Self; 7] = [
        Self::Color,
        Self::Normal,
        Self::Depth,
        Self::Object,
        Self::Primitive,
        Self::Cells,
        Self::Heatmap,
    ];

    /// The name on the command line and in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Color => "color",
            Self::Normal => "normal",
            Self::Depth => "depth",
            Self::Object => "object",
            Self::Primitive => "primitive",
            Self::Cells => "cells",
            Self::Heatmap => "heatmap",
        }
    }

    /// Whether it shows the structure, and not the scene: it is another one with another structure.
    #[must_use]
    pub fn shows_structure(self) -> bool {
        matches!(self, Self::Cells | Self::Heatmap)
    }

    /// A line of help.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::Color => "the shaded scene",
            Self::Normal => "the normal of the surface",
            Self::Depth => "the distance from the eye",
            Self::Object => "which object was hit, a colour each",
            Self::Primitive => "which primitive was hit, a colour each",
            Self::Cells => "which leaf of the structure a ray enters first, a colour each",
            Self::Heatmap => "how many boxes and primitives the rays tested",
        }
    }
}
