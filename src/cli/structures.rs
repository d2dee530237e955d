//! What `--accel` may name: the structures of the library, and those that a program of one's own
//! adds ([`run_with`](super::run_with)). Knows no other option.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use super::exit::Failure;
use crate::scene::{STRUCTURES, Structure, YARDSTICKS};

/// All that can be named, in the order in which the help lists them.
#[derive(Clone, Debug)]
pub(crate) struct Structures(Vec<Structure>);

impl Structures {
    /// Those of the library and some more.
    pub(crate) fn with(extra: &[Structure]) -> Result<Self, Failure> {
        if let Some(one) = extra.iter().find(|one| !is_name(one.name)) {
            return Err(Failure::new(format_args!(
                "a structure cannot be called `{}`: a name consists of the letters A–Z and a–z, \
                 digits, `_` and `-`",
                one.name
            )));
        }
        let mut all = [STRUCTURES, extra].concat();
        all.extend(YARDSTICKS);
        let twice =
            (1..all.len()).find(|&i| all[..i].iter().any(|other| other.name == all[i].name));
        match twice {
            Some(i) => {
                Err(Failure::new(format_args!("two structures are called `{}`", all[i].name)))
            }
            None => Ok(Self(all)),
        }
    }

    /// Those that a comparison takes where none is named: all but the peers.
    pub(crate) fn compared_by_default(&self) -> Vec<Structure> {
        self.0.iter().copied().filter(|one| !one.yardstick).collect()
    }

    /// Takes the name of one; the help describes each.
    pub(crate) fn parser(&self) -> impl TypedValueParser<Value = Structure> {
        let values = self.0.iter().map(|one| PossibleValue::new(one.name).help(one.summary));
        let all = self.0.clone();
        PossibleValuesParser::new(values.collect::<Vec<_>>()).try_map(move |name| {
            let found = all.iter().copied().find(|one| one.name == name);
            found.ok_or_else(|| format!("there is no structure `{name}`"))
        })
    }
}

/// Whether a name can stand between the commas of `--accel` and in the names of files.
fn is_name(name: &str) -> bool {
    let fits = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    !name.is_empty() && name.chars().all(fits)
}

/// Those of the library.
impl Default for Structures {
    fn default() -> Self {
        Self([STRUCTURES, YARDSTICKS].concat())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::{Bvh, Exhaustive};

    #[test]
    fn a_name_can_be_typed_and_be_part_of_a_files() {
        for name in ["", "a,b", "../a", "a b", "gitter-ä"] {
            let one = Structure::new::<Exhaustive, Bvh>(name, "another");
            let text = Structures::with(&[one]).unwrap_err().to_string();
            assert!(
                text.starts_with(&format!("a structure cannot be called `{name}`: ")),
                "{text}"
            );
        }
    }

    #[test]
    fn a_name_is_taken_once() {
        let mine = Structure::new::<Exhaustive, Bvh>("mine", "one of one's own");
        let bvh = Structure::new::<Exhaustive, Bvh>("bvh", "another");
        let refused = |extra: &[Structure]| Structures::with(extra).unwrap_err().to_string();
        assert_eq!(refused(&[mine, bvh]), "two structures are called `bvh`");
        assert_eq!(refused(&[mine, mine]), "two structures are called `mine`");
    }
}
