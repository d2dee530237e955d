//! How area lights are sampled.

/// How area lights are sampled. The default leaves less noise in the same time by the study in
/// `docs/sampling.md`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sampling {
    /// Jittered samples that are made once, shuffled for each pixel and light, and assigned to the
    /// pixel's view samples: together they cover the light evenly.
    #[default]
    Shuffled,
    /// Samples made on the fly, for each view sample separately.
    Independent,
}

impl Sampling {
    /// All methods.
    pub const ALL: [Self; 2] = [Self::Shuffled, Self::Independent];

    /// The name on the command line and in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Shuffled => "shuffled",
            Self::Independent => "independent",
        }
    }

    /// A line of help.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::Shuffled => "made once, then shuffled for each pixel and light",
            Self::Independent => "made on the fly for each sample of a pixel",
        }
    }
}
