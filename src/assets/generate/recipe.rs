//! Names of generated meshes: `generate:KIND:TRIANGLES[:SEED]`.

use std::fmt;

use thiserror::Error;

use super::{MAX_TRIANGLES, MeshKind, read_count};

const PREFIX: &str = "generate:";

/// What a name of the form `generate:KIND:TRIANGLES[:SEED]` describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Recipe {
    /// What to generate.
    pub kind: MeshKind,
    /// Of about how many triangles; from 1 to [`MAX_TRIANGLES`].
    pub triangles: u32,
    /// The seed; 0 where none is written.
    pub seed: u64,
}

/// A name that starts with `generate:` and is not that of a generated mesh.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum RecipeError {
    /// No generator of that name.
    #[error("there is no generator `{name}`")]
    UnknownKind {
        /// The name.
        name: String,
    },
    /// Not a number of triangles that can be generated.
    #[error("`{count}` is not a number of triangles")]
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
    #[error("`{name}` is not the name of a generated mesh")]
    WrongParts {
        /// The whole name.
        name: String,
    },
}

impl RecipeError {
    /// What would be right.
    #[must_use]
    pub fn help(&self) -> String {
        match self {
            Self::UnknownKind { name } => {
                let distance = |kind: &MeshKind| strsim::osa_distance(kind.name(), name);
                match MeshKind::ALL
                    .into_iter()
                    .min_by_key(distance)
                    .filter(|kind| distance(kind) <= 2)
                {
                    Some(kind) => format!("did you mean `{kind}`? The kinds are {}", kinds()),
                    None => format!("the kinds are {}", kinds()),
                }
            }
            Self::BadCount { .. } => {
                format!("write a whole number from 1 to {MAX_TRIANGLES}, such as 70000, 70k or 1M")
            }
            Self::BadSeed { .. } => format!("write a whole number from 0 to {}", u64::MAX),
            Self::WrongParts { .. } => {
                format!("write `generate:KIND:TRIANGLES[:SEED]`, KIND one of {}", kinds())
            }
        }
    }
}

impl fmt::Display for Recipe {
    /// The name that [`parse`](Self::parse) reads.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{PREFIX}{}:{}", self.kind, self.triangles)?;
        if self.seed == 0 { Ok(()) } else { write!(f, ":{}", self.seed) }
    }
}

impl Recipe {
    /// What it takes to make the mesh in memory, as measured, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let of_triangle = match self.kind {
            // None of its triangles share vertices.
            MeshKind::Soup => 72,
            // Few do.
            MeshKind::Hair => 50,
            MeshKind::Icosphere
            | MeshKind::TorusKnot
            | MeshKind::Terrain
            | MeshKind::Hall
            | MeshKind::Scan
            | MeshKind::Stadium
            | MeshKind::Box => 38,
        };
        of_triangle * u64::from(self.triangles)
    }

    /// The mesh of a name; `None` if it does not start with `generate:`.
    #[must_use]
    pub fn parse(name: &str) -> Option<Result<Self, RecipeError>> {
        let parts: Vec<_> = name.strip_prefix(PREFIX)?.split(':').collect();
        Some(match parts[..] {
            [kind, triangles] => Self::of_parts(kind, triangles, "0"),
            [kind, triangles, seed] => Self::of_parts(kind, triangles, seed),
            _ => Err(RecipeError::WrongParts { name: name.to_owned() }),
        })
    }

    fn of_parts(kind: &str, triangles: &str, seed: &str) -> Result<Self, RecipeError> {
        let unknown = || RecipeError::UnknownKind { name: kind.to_owned() };
        let count = read_count(triangles).filter(|n| (1..=MAX_TRIANGLES).contains(n));
        Ok(Self {
            kind: MeshKind::from_name(kind).ok_or_else(unknown)?,
            triangles: count
                .ok_or_else(|| RecipeError::BadCount { count: triangles.to_owned() })?,
            seed: seed.parse().map_err(|_| RecipeError::BadSeed { seed: seed.to_owned() })?,
        })
    }
}

fn kinds() -> String {
    MeshKind::ALL.map(MeshKind::name).join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        let recipe = |kind, triangles, seed| Some(Ok(Recipe { kind, triangles, seed }));
        assert_eq!(Recipe::parse("generate:hall:5000"), recipe(MeshKind::Hall, 5000, 0));
        assert_eq!(Recipe::parse("generate:torus-knot:1:9"), recipe(MeshKind::TorusKnot, 1, 9));
        assert_eq!(Recipe::parse("generate:soup:1k"), recipe(MeshKind::Soup, 1_000, 0));
        assert_eq!(Recipe::parse("generate:soup:2M:3"), recipe(MeshKind::Soup, 2_000_000, 3));
        assert_eq!(Recipe::parse("meshes/generate.obj"), None);
    }

    #[test]
    fn errors_of_wrong_names_suggest_what_would_be_right() {
        let error = |name: &str| {
            let error = Recipe::parse(name).unwrap().unwrap_err();
            (error.to_string(), error.help())
        };
        let kinds = "icosphere, torus-knot, terrain, hall, soup, scan, stadium, hair, box";
        assert_eq!(
            error("generate:icospere:100"),
            (
                "there is no generator `icospere`".to_owned(),
                format!("did you mean `icosphere`? The kinds are {kinds}")
            )
        );
        assert_eq!(error("generate:elephant:100").1, format!("the kinds are {kinds}"));
        for bad in ["0", "-1", "1e6", "", "100000001", "99999999999"] {
            assert_eq!(
                error(&format!("generate:hall:{bad}")),
                (
                    format!("`{bad}` is not a number of triangles"),
                    "write a whole number from 1 to 100000000, such as 70000, 70k or 1M".to_owned()
                )
            );
        }
        assert_eq!(error("generate:hall:100:x").0, "`x` is not a seed");
        for bad in ["generate:", "generate:hall", "generate:hall:1:2:3"] {
            assert_eq!(error(bad).0, format!("`{bad}` is not the name of a generated mesh"));
        }
    }
}
