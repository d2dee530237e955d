//! Options of a structure's own: what it offers, and what was chosen.
//!
//! A structure lists its options in [`Accel::OPTIONS`]; the command line, its help and the reports
//! read that list. What was chosen travels in [`BuildConfig::options`](super::BuildConfig::options),
//! and a build looks up what it knows.

use std::fmt;

use super::Accel;

/// An option that a structure offers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OptionInfo {
    /// What it is called: lower-case letters, digits and `-`.
    pub name: &'static str,
    /// What it may be.
    pub allowed: Allowed,
    /// What holds where it is not given, in a few words.
    pub default: &'static str,
    /// One line about it.
    pub summary: &'static str,
}

/// The values that an option may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Allowed {
    /// One of some words, of lower-case letters, digits and `-`.
    Words(&'static [&'static str]),
    /// A whole number between two, both included.
    Numbers(u32, u32),
}

/// The value of an option.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Value {
    Word(&'static str),
    Number(u32),
}

/// Options that were given, each once.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct BuildOptions(Vec<(&'static str, Value)>);

/// Why options were not understood.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OptionError {
    /// Not a name, an equals sign and a value.
    #[error("`{text}` is not an option with its value, such as `{example}`")]
    Form {
        /// What was given.
        text: String,
        /// What would be right.
        example: String,
    },
    /// No such option.
    #[error("there is no option `{option}`: {}", one_of(known))]
    Unknown {
        /// What was given.
        option: String,
        /// All that there are.
        known: Vec<&'static str>,
    },
    /// Not a value that the option may have.
    #[error("`{value}` is no value of the option `{option}`: expected {allowed}")]
    Value {
        /// The option.
        option: &'static str,
        /// What was given.
        value: String,
        /// What would be right.
        allowed: Allowed,
    },
    /// An option that was given before.
    #[error("the option `{option}` is given twice")]
    Twice {
        /// The option.
        option: &'static str,
    },
}

impl OptionInfo {
    /// What structures call the option of [`leaf`](Self::leaf).
    pub const LEAF: &'static str = "leaf";

    /// The most primitives in a leaf, from 1 on.
    #[must_use]
    pub const fn leaf(most: u32, default: &'static str) -> Self {
        let summary = "the most triangles in a leaf";
        Self { name: Self::LEAF, allowed: Allowed::Numbers(1, most), default, summary }
    }

    fn read(&self, text: &str) -> Option<Value> {
        match self.allowed {
            Allowed::Words(words) => {
                words.iter().find(|&&word| word == text).map(|&word| Value::Word(word))
            }
            Allowed::Numbers(..) => {
                let digits = text.bytes().all(|byte| byte.is_ascii_digit());
                let number = text.parse().ok().filter(|_| digits).map(Value::Number);
                number.filter(|&number| self.allows(number))
            }
        }
    }

    fn allows(&self, value: Value) -> bool {
        match (self.allowed, value) {
            (Allowed::Words(words), Value::Word(word)) => words.contains(&word),
            (Allowed::Numbers(least, most), Value::Number(number)) => {
                (least..=most).contains(&number)
            }
            _ => false,
        }
    }
}

impl BuildOptions {
    /// None.
    pub const NONE: Self = Self(Vec::new());

    /// Options of a structure, from text as `builder=ploc,leaf=4`.
    ///
    /// ```
    /// use srt::accel::{BuildConfig, BuildOptions, Bvh8};
    ///
    /// let options = BuildOptions::of::<Bvh8>("leaf=4,builder=ploc").unwrap();
    /// assert_eq!(options.to_string(), "builder=ploc,leaf=4");
    /// let config = BuildConfig { options, ..BuildConfig::default() };
    ///
    /// let error = BuildOptions::of::<Bvh8>("leaf=9").unwrap_err();
    /// let text = "`9` is no value of the option `leaf`: expected a whole number from 1 to 8";
    /// assert_eq!(error.to_string(), text);
    /// ```
    ///
    /// # Errors
    /// If an option, or its value, is unknown, or is given twice.
    pub fn of<A: Accel>(text: &str) -> Result<Self, OptionError> {
        Self::read(A::OPTIONS, text)
    }

    /// Options of a table, from text; afterwards they stand in the table's order.
    ///
    /// # Errors
    /// As of [`of`](Self::of).
    pub fn read<'a>(
        table: impl IntoIterator<Item = &'a OptionInfo, IntoIter: Clone>,
        text: &str,
    ) -> Result<Self, OptionError> {
        let table = table.into_iter();
        let mut given: Vec<(usize, &'static str, Value)> = Vec::new();
        for text in text.split(',') {
            let known = || table.clone().map(|info| info.name).collect();
            let (option, value) = match (text.split_once('='), table.clone().next()) {
                (Some(parts), _) => parts,
                (None, None) => (text, ""),
                (None, Some(first)) => {
                    let (text, example) = (text.to_owned(), example(first));
                    return Err(OptionError::Form { text, example });
                }
            };
            let found = table.clone().enumerate().find(|(_, info)| info.name == option);
            let Some((place, info)) = found else {
                return Err(OptionError::Unknown { option: option.to_owned(), known: known() });
            };
            if given.iter().any(|&(other, ..)| other == place) {
                return Err(OptionError::Twice { option: info.name });
            }
            let Some(read) = info.read(value) else {
                let (option, allowed) = (info.name, info.allowed);
                return Err(OptionError::Value { option, value: value.to_owned(), allowed });
            };
            given.push((place, info.name, read));
        }
        given.sort_by_key(|&(place, ..)| place);
        Ok(Self(given.into_iter().map(|(_, name, value)| (name, value)).collect()))
    }

    /// Whether none was given.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The word that was given for an option, if that option allows it.
    #[must_use]
    pub fn word(&self, option: &OptionInfo) -> Option<&'static str> {
        self.value(option).and_then(|value| match value {
            Value::Word(word) => Some(word),
            Value::Number(_) => None,
        })
    }

    /// The number that was given for an option, if that option allows it.
    #[must_use]
    pub fn number(&self, option: &OptionInfo) -> Option<u32> {
        self.value(option).and_then(|value| match value {
            Value::Number(number) => Some(number),
            Value::Word(_) => None,
        })
    }

    fn value(&self, option: &OptionInfo) -> Option<Value> {
        let given = self.0.iter().find(|(name, _)| *name == option.name);
        given.map(|&(_, value)| value).filter(|&value| option.allows(value))
    }

    /// These, and of the others those that these do not name.
    #[must_use]
    pub fn or(&self, others: &Self) -> Self {
        let new = |other: &&(_, _)| self.0.iter().all(|own| own.0 != other.0);
        Self(self.0.iter().chain(others.0.iter().filter(new)).copied().collect())
    }

    /// All but one of a name.
    #[must_use]
    pub fn without(&self, name: &str) -> Self {
        Self(self.0.iter().copied().filter(|(own, _)| *own != name).collect())
    }
}

/// An option with a value that it may have.
fn example(option: &OptionInfo) -> String {
    let value = match option.allowed {
        Allowed::Words(words) => Value::Word(words.first().copied().unwrap_or_default()),
        Allowed::Numbers(_, most) => Value::Number(most),
    };
    BuildOptions(vec![(option.name, value)]).to_string()
}

/// What the options of a structure are called, in a few words.
fn one_of(known: &[&str]) -> String {
    match known {
        [] => "this structure has none".to_owned(),
        [one] => format!("expected `{one}`"),
        _ => format!("expected one of `{}`", known.join("`, `")),
    }
}

/// As it is written on the command line and in reports: `builder=ploc,leaf=4`.
impl fmt::Display for BuildOptions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, (name, value)) in self.0.iter().enumerate() {
            let comma = if place == 0 { "" } else { "," };
            match value {
                Value::Word(word) => write!(f, "{comma}{name}={word}")?,
                Value::Number(number) => write!(f, "{comma}{name}={number}")?,
            }
        }
        Ok(())
    }
}

/// In words.
impl fmt::Display for Allowed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Words(words) => f.write_str(&one_of(words).replace("expected ", "")),
            Self::Numbers(least, most) => write!(f, "a whole number from {least} to {most}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &[OptionInfo] = &[
        OptionInfo {
            name: "builder",
            allowed: Allowed::Words(&["sah", "ploc"]),
            default: "sah",
            summary: "who builds",
        },
        OptionInfo { name: "leaf", allowed: Allowed::Numbers(1, 8), default: "8", summary: "many" },
    ];

    #[test]
    fn options_stand_in_the_order_of_their_table() {
        let read = |text| BuildOptions::read(TABLE, text).unwrap();
        let both = read("leaf=4,builder=ploc");
        assert_eq!(both.to_string(), "builder=ploc,leaf=4");
        assert_eq!((both.word(&TABLE[0]), both.number(&TABLE[1])), (Some("ploc"), Some(4)));
        assert_eq!((both.number(&TABLE[0]), both.word(&TABLE[1])), (None, None));
        let one = read("leaf=8");
        assert_eq!((one.word(&TABLE[0]), one.number(&TABLE[1])), (None, Some(8)));
        assert_eq!(one.or(&both).to_string(), "leaf=8,builder=ploc");
        assert_eq!(both.without("builder").to_string(), "leaf=4");
        assert!(BuildOptions::NONE.is_empty() && !one.is_empty());
    }

    #[test]
    fn another_structure_takes_no_value_that_its_own_option_refuses() {
        let four = BuildOptions::read(TABLE, "leaf=4").unwrap();
        assert_eq!(four.number(&OptionInfo { allowed: Allowed::Numbers(1, 3), ..TABLE[1] }), None);
        assert_eq!(four.word(&OptionInfo { allowed: Allowed::Words(&["4"]), ..TABLE[1] }), None);
    }

    #[test]
    fn errors_say_what_would_be_right() {
        let error = |text: &str| BuildOptions::read(TABLE, text).unwrap_err().to_string();
        let form = "is not an option with its value, such as `builder=sah`";
        assert_eq!(error("leaf"), format!("`leaf` {form}"));
        assert_eq!(error(""), format!("`` {form}"));
        assert_eq!(error("leaf=1,"), format!("`` {form}"));
        assert_eq!(
            error("builer=sah"),
            "there is no option `builer`: expected one of `builder`, `leaf`"
        );
        let value = "is no value of the option `leaf`: expected a whole number from 1 to 8";
        for text in ["0", "9", "-1", "+1", "", "many", "99999999999"] {
            assert_eq!(error(&format!("leaf={text}")), format!("`{text}` {value}"));
        }
        let value = "is no value of the option `builder`: expected one of `sah`, `ploc`";
        assert_eq!(error("builder=lbvh"), format!("`lbvh` {value}"));
        assert_eq!(error("leaf=1,leaf=1"), "the option `leaf` is given twice");
        let none = BuildOptions::read(&[], "leaf=1").unwrap_err().to_string();
        assert_eq!(none, "there is no option `leaf`: this structure has none");
    }
}
