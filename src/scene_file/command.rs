//! What a command is: a keyword, the values it takes, and what it does.
//!
//! The commands themselves stand in [`table`](super::table).

use std::fmt;

use super::builder::Builder;
use super::values::Values;

/// A command of the scene format: one row of [`COMMANDS`](super::COMMANDS).
#[derive(Clone, Copy)]
pub struct Command {
    /// The word that begins its line.
    pub keyword: &'static str,
    /// What it belongs to.
    pub group: Group,
    /// The values that follow the keyword, all of them required.
    pub values: &'static [Value],
    /// What it says, in a line.
    pub summary: &'static str,
    /// A line as one would write it.
    pub example: &'static str,
    /// What other programs, or people, call it: for "did you mean".
    pub also_called: &'static [&'static str],
    pub(super) apply: fn(&mut Builder, &Values<'_>),
}

/// What a command belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// How the scene is seen. Every one of these is required.
    Camera,
    /// How it is rendered.
    Options,
    /// Saves and restores material and transform, or ends the scene.
    Structure,
    /// The material in force.
    Material,
    /// The transform in force.
    Transform,
    /// Something that rays hit.
    Object,
    /// Something that gives light.
    Light,
}

/// One value of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// What usage and messages call it.
    pub name: &'static str,
    /// What it may be.
    pub kind: Kind,
}

/// What a value may be. All numbers must be finite, in single precision too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Any number.
    Number,
    /// A number greater than 0.
    Positive,
    /// A number that is not less than 0.
    NotNegative,
    /// A number other than 0, which would make the transform singular.
    ScaleFactor,
    /// A number from 0 to 1.
    Share,
    /// An angle between 0 and 180 degrees, both excluded.
    FieldOfView,
    /// A whole number from the first to the second, both included.
    Whole(u32, u32),
    /// The name of a file.
    Name,
}

impl Command {
    /// The keyword and the names of its values: `ball radius x y z`.
    #[must_use]
    pub fn usage(&self) -> String {
        format!("{} {}", self.keyword, self.value_names()).trim_end().to_owned()
    }

    /// The names of its values: `radius x y z`.
    #[must_use]
    pub fn value_names(&self) -> String {
        self.values.iter().map(|v| v.name).collect::<Vec<_>>().join(" ")
    }

    /// Whether one of its values names a file.
    pub(super) fn takes_name(&self) -> bool {
        self.values.iter().any(|v| v.kind == Kind::Name)
    }

    /// How it is written, for the help of an error.
    pub(super) fn how_to_write(&self) -> String {
        if self.values.is_empty() {
            return format!("`{}` stands on a line of its own", self.keyword);
        }
        format!("write `{}`, for example `{}`", self.usage(), self.example)
    }
}

impl Kind {
    /// What is wrong with a finite number as a value of this kind: "must be …".
    pub(super) fn complaint(self, number: f64) -> Option<String> {
        // What single precision cannot tell from 0 counts as 0.
        let is_zero = is_nothing(number);
        let right = match self {
            Self::Number | Self::Name => true,
            Self::Positive => number > 0.0 && !is_zero,
            Self::NotNegative => number >= 0.0,
            Self::ScaleFactor => !is_zero,
            Self::Share => (0.0..=1.0).contains(&number),
            Self::FieldOfView => number > 0.0 && !is_zero && number < 180.0,
            Self::Whole(low, high) => {
                number.fract() == 0.0 && (f64::from(low)..=f64::from(high)).contains(&number)
            }
        };
        let must = match self {
            Self::ScaleFactor => "must not be 0, which would make the transform singular".into(),
            _ => format!("must be {self}"),
        };
        (!right).then_some(must)
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number => f.write_str("any number"),
            Self::Positive => f.write_str("greater than 0"),
            Self::NotNegative => f.write_str("0 or more"),
            Self::ScaleFactor => f.write_str("other than 0"),
            Self::Share => f.write_str("from 0 to 1"),
            Self::FieldOfView => f.write_str("between 0 and 180 degrees"),
            Self::Whole(low, high) => write!(f, "a whole number from {low} to {high}"),
            Self::Name => f.write_str("the name of a file"),
        }
    }
}

/// Whether a number is 0, or so small that single precision has no normal number for it.
pub(super) fn is_nothing(number: f64) -> bool {
    number.abs() < f64::from(f32::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_accept_their_bounds_and_nothing_beyond() {
        let accepts = |kind: Kind, number: f64| kind.complaint(number).is_none();
        assert!(accepts(Kind::Positive, 1e-30) && !accepts(Kind::Positive, 0.0));
        assert!(!accepts(Kind::Positive, 1e-60));
        assert!(accepts(Kind::NotNegative, -0.0) && !accepts(Kind::NotNegative, -1e-9));
        assert!(accepts(Kind::ScaleFactor, -2.0) && !accepts(Kind::ScaleFactor, 0.0));
        assert!(accepts(Kind::Share, 1.0) && !accepts(Kind::Share, 1.0001));
        assert!(accepts(Kind::FieldOfView, 179.9) && !accepts(Kind::FieldOfView, 180.0));
        assert!(accepts(Kind::Whole(1, 9), 9.0) && !accepts(Kind::Whole(1, 9), 2.5));
        assert!(!accepts(Kind::Whole(1, 9), 0.0) && !accepts(Kind::Whole(1, 9), 10.0));
    }
}
