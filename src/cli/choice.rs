//! Options that take the name of one thing of a set.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// Takes the name of one of a set of things.
pub(super) fn named<T: Copy + Send + Sync + 'static>(
    all: &'static [T],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    one_of(all, name, move |thing| PossibleValue::new(name(thing)))
}

/// Takes the name of one of a set of things; the help describes each.
pub(super) fn described<T: Copy + Send + Sync + 'static>(
    all: &'static [T],
    name: fn(T) -> &'static str,
    summary: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    one_of(all, name, move |thing| PossibleValue::new(name(thing)).help(summary(thing)))
}

fn one_of<T: Copy + Send + Sync + 'static>(
    all: &'static [T],
    name: fn(T) -> &'static str,
    value: impl Fn(T) -> PossibleValue,
) -> impl TypedValueParser<Value = T> {
    let values: Vec<PossibleValue> = all.iter().map(|&thing| value(thing)).collect();
    PossibleValuesParser::new(values).try_map(move |typed| {
        let found = all.iter().copied().find(|&thing| name(thing) == typed);
        found.ok_or_else(|| format!("there is no `{typed}`"))
    })
}
