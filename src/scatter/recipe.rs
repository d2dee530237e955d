//! What is scattered, in a word: `KIND:COUNT[:SEED]`.

use std::fmt;

use thiserror::Error;

use super::{MOST_SCATTERED, ScatterKind};

/// What a word of the form `KIND:COUNT[:SEED]` describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ScatterRecipe {
    /// What is scattered.
    pub kind: ScatterKind,
    /// How many objects; from 1 to [`MOST_SCATTERED`].
    pub count: u32,
    /// The seed; 0 where none is written.
    pub seed: u64,
}

/// A word that says of nothing how it is scattered.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ScatterError {
    /// No kind of that name.
    #[error("nothing that is scattered is called `{name}`")]
    UnknownKind {
        /// The name.
        name: String,
    },
    /// Not a number of objects that can be scattered.
    #[error("`{count}` is not a number of objects")]
    BadCount {
        /// What is written in its place.
        count: String,
    },
    /// Not a number.
    #[error("`{seed}` is not a seed")]
    BadSeed {
        /// What is written in its place.
        seed: String,
    },
    /// Parts are missing, or there are too many.
    #[error("`{text}` does not say what is scattered")]
    WrongParts {
        /// The whole word.
        text: String,
    },
}

impl ScatterError {
    /// What would be right.
    #[must_use]
    pub fn help(&self) -> String {
        let kinds = || ScatterKind::ALL.map(ScatterKind::name).join(", ");
        match self {
            Self::UnknownKind { name } => {
                let distance = |kind: &ScatterKind| strsim::osa_distance(kind.name(), name);
                let near = ScatterKind::ALL.into_iter().min_by_key(distance);
                match near.filter(|kind| distance(kind) <= 2) {
                    Some(kind) => format!("did you mean `{kind}`? The kinds are {}", kinds()),
                    None => format!("the kinds are {}", kinds()),
                }
            }
            Self::BadCount { .. } => {
                format!("write a whole number from 1 to {MOST_SCATTERED}, such as 20000, 20k or 1M")
            }
            Self::BadSeed { .. } => format!("write a whole number from 0 to {}", u64::MAX),
            Self::WrongParts { .. } => {
                format!("write `scatter KIND:COUNT[:SEED]`, KIND one of {}", kinds())
            }
        }
    }
}

impl fmt::Display for ScatterRecipe {
    /// The word that [`parse`](Self::parse) reads.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.kind, self.count)?;
        if self.seed == 0 { Ok(()) } else { write!(f, ":{}", self.seed) }
    }
}

impl ScatterRecipe {
    /// Reads a word.
    ///
    /// ```
    /// use srt::scatter::ScatterRecipe;
    ///
    /// assert_eq!(ScatterRecipe::parse("city:20k:7")?.to_string(), "city:20000:7");
    /// # Ok::<(), srt::scatter::ScatterError>(())
    /// ```
    ///
    /// # Errors
    /// If it is none of that form, its kind is unknown, or a number is none or out of range.
    pub fn parse(text: &str) -> Result<Self, ScatterError> {
        let parts: Vec<_> = text.split(':').collect();
        let (kind, count, seed) = match parts[..] {
            [kind, count] => (kind, count, "0"),
            [kind, count, seed] => (kind, count, seed),
            _ => return Err(ScatterError::WrongParts { text: text.to_owned() }),
        };
        let unknown = || ScatterError::UnknownKind { name: kind.to_owned() };
        let bad_count = || ScatterError::BadCount { count: count.to_owned() };
        Ok(Self {
            kind: ScatterKind::from_name(kind).ok_or_else(unknown)?,
            count: crate::math::read_count(count)
                .filter(|n| (1..=MOST_SCATTERED).contains(n))
                .ok_or_else(bad_count)?,
            seed: seed.parse().map_err(|_| ScatterError::BadSeed { seed: seed.to_owned() })?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_read() {
        let recipe = |kind, count, seed| Ok(ScatterRecipe { kind, count, seed });
        assert_eq!(ScatterRecipe::parse("balls:20k"), recipe(ScatterKind::Balls, 20_000, 0));
        assert_eq!(ScatterRecipe::parse("city:1M:9"), recipe(ScatterKind::City, 1_000_000, 9));
        assert_eq!(ScatterRecipe::parse("mixed:1"), recipe(ScatterKind::Mixed, 1, 0));
    }

    #[test]
    fn errors_suggest_what_would_be_right() {
        let error = |text: &str| {
            let error = ScatterRecipe::parse(text).unwrap_err();
            (error.to_string(), error.help())
        };
        let kinds = "balls, mixed, knots, city";
        assert_eq!(
            error("bals:10"),
            (
                "nothing that is scattered is called `bals`".to_owned(),
                format!("did you mean `balls`? The kinds are {kinds}")
            )
        );
        assert_eq!(error("trees:10").1, format!("the kinds are {kinds}"));
        for bad in ["0", "-1", "1e6", "", "16777217"] {
            assert_eq!(
                error(&format!("balls:{bad}")),
                (
                    format!("`{bad}` is not a number of objects"),
                    "write a whole number from 1 to 16777216, such as 20000, 20k or 1M".to_owned()
                )
            );
        }
        assert_eq!(error("balls:10:x").0, "`x` is not a seed");
        for bad in ["balls", "", "balls:1:2:3"] {
            assert_eq!(error(bad).0, format!("`{bad}` does not say what is scattered"));
        }
    }
}
