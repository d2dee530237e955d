//! A command as data: its keyword, the values it takes, and its help.
//!
//! Does not know what a command does; [`action`](super::action) joins the two.

use std::fmt;

use super::precision::is_zero;

/// A command of the scene format.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneCommand {
    /// The word that begins its line.
    pub keyword: &'static str,
    /// The values that follow the keyword, all of them required.
    pub values: &'static [Value],
    /// Its meaning, in a line.
    pub summary: &'static str,
    /// A line as one would write it.
    pub example: &'static str,
    /// What other programs, or people, call it: for "did you mean".
    pub also_called: &'static [&'static str],
}

/// One value of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// What usage and messages call it.
    pub name: &'static str,
    /// What it may be.
    pub kind: ValueKind,
}

/// What a value may be. All numbers must be finite, in single precision too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ValueKind {
    /// Any number.
    Number,
    /// Any number; one above 1 is warned of.
    Reflectance,
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
    /// What is scattered: [`ScatterRecipe`](crate::scatter::ScatterRecipe).
    Scatter,
    /// Another command with its values, to the end of the line.
    Command,
}

/// A point or a vector.
pub(super) const XYZ: &[Value] = &[number("x"), number("y"), number("z")];

/// A colour. Any finite number will do: lights may be brighter than 1, and the original accepts
/// lights that darken.
pub(super) const RGB: &[Value] = &[number("r"), number("g"), number("b")];

/// What a surface does to light. The original accepts any finite number.
pub(super) const REFLECTANCE: &[Value] = &[
    value("r", ValueKind::Reflectance),
    value("g", ValueKind::Reflectance),
    value("b", ValueKind::Reflectance),
];

/// A value that may be any number.
pub(super) const fn number(name: &'static str) -> Value {
    value(name, ValueKind::Number)
}

/// A value of a kind.
pub(super) const fn value(name: &'static str, kind: ValueKind) -> Value {
    Value { name, kind }
}

impl SceneCommand {
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
        self.values.iter().any(|v| v.kind == ValueKind::Name)
    }

    /// Whether its values may be others in every frame: numbers that need not be whole, as far as its kind goes.
    pub(super) fn takes_numbers(&self) -> bool {
        let is_number = |value: &Value| {
            use ValueKind::{Command, Name, Scatter, Whole};
            !matches!(value.kind, Whole(..) | Name | Scatter | Command)
        };
        !self.values.is_empty() && self.values.iter().all(is_number)
    }

    /// How it is written, for the help of an error.
    pub(super) fn how_to_write(&self) -> String {
        if self.values.is_empty() {
            return format!("write `{}` on a line of its own", self.keyword);
        }
        format!("write `{}`, for example `{}`", self.usage(), self.example)
    }
}

impl ValueKind {
    /// What is wrong with a finite number as a value of this kind: "must be …".
    pub(super) fn complaint(self, number: f64) -> Option<String> {
        let right = match self {
            Self::Number | Self::Reflectance | Self::Name | Self::Scatter | Self::Command => true,
            Self::Positive => number > 0.0 && !is_zero(number),
            Self::NotNegative => number >= 0.0,
            Self::ScaleFactor => !is_zero(number),
            Self::Share => (0.0..=1.0).contains(&number),
            Self::FieldOfView => number > 0.0 && !is_zero(number) && number < 180.0,
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

impl fmt::Display for ValueKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number | Self::Reflectance => f.write_str("any number"),
            Self::Positive => f.write_str("greater than 0"),
            Self::NotNegative => f.write_str("0 or more"),
            Self::ScaleFactor => f.write_str("other than 0"),
            Self::Share => f.write_str("from 0 to 1"),
            Self::FieldOfView => f.write_str("between 0 and 180 degrees"),
            Self::Whole(low, high) => write!(f, "a whole number from {low} to {high}"),
            Self::Name => f.write_str("the name of a file"),
            Self::Scatter => f.write_str("KIND:COUNT[:SEED]"),
            Self::Command => f.write_str("a command with its values"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_accept_their_bounds_and_nothing_beyond() {
        let accepts = |kind: ValueKind, number: f64| kind.complaint(number).is_none();
        let whole = ValueKind::Whole(1, 9);
        assert!(accepts(ValueKind::Positive, 1e-30) && !accepts(ValueKind::Positive, 0.0));
        assert!(!accepts(ValueKind::Positive, 1e-60));
        assert!(accepts(ValueKind::NotNegative, -0.0) && !accepts(ValueKind::NotNegative, -1e-9));
        assert!(accepts(ValueKind::ScaleFactor, -2.0) && !accepts(ValueKind::ScaleFactor, 0.0));
        assert!(accepts(ValueKind::Share, 1.0) && !accepts(ValueKind::Share, 1.0001));
        assert!(accepts(ValueKind::FieldOfView, 179.9) && !accepts(ValueKind::FieldOfView, 180.0));
        assert!(accepts(whole, 9.0) && !accepts(whole, 2.5));
        assert!(!accepts(whole, 0.0) && !accepts(whole, 10.0));
    }
}
