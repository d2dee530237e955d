//! Changes to JSON that leave it JSON: most changes of single bytes would only be refused by its parser.

use libfuzzer_sys::fuzzer_mutate;
use serde_json::{Number, Value};
use srt::math::Random;

const NUMBERS: [f64; 14] = [
    0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    3.0,
    1e-9,
    1e9,
    1e19,
    1e300,
    -1e300,
    1e-300,
    f64::MAX,
    f64::MIN_POSITIVE,
];

/// Markup, separators of tables, and what controls a terminal.
const TEXTS: [&str; 22] = [
    "",
    "none",
    "bvh",
    "bvh8",
    "view",
    "shadow",
    "mirror",
    "a.png",
    "../a.png",
    "-dirty",
    "<script>alert(1)</script>",
    "\"><img src=x onerror=alert(1)>",
    "</td></table>",
    "-->",
    "]]>",
    "a|b\nc",
    "\"a\",b\r\n",
    "`` ` ``",
    "\\|",
    "![a](javascript:b)",
    "\u{1b}[2J\u{7}",
    "é\u{202e}&#60;",
];

/// Changes to one of the JSON texts in `data`, which are a line each; now and then one of the fuzzer's own, to bytes.
pub fn mutate(data: &mut [u8], size: usize, max_size: usize, seed: u32) -> usize {
    let mut random = Random::new(&[u64::from(seed)]);
    if random.below(8) > 0 {
        if let Some(text) =
            mutated(&data[..size], &mut random).filter(|text| text.len() <= max_size)
        {
            data[..text.len()].copy_from_slice(text.as_bytes());
            return text.len();
        }
    }
    fuzzer_mutate(data, size, max_size)
}

fn mutated(data: &[u8], random: &mut Random) -> Option<String> {
    let lines = std::str::from_utf8(data).ok()?.split('\n').filter(|line| !line.is_empty());
    let mut values: Vec<Value> = lines.map(serde_json::from_str).collect::<Result<_, _>>().ok()?;
    let chosen = pick(values.len(), random)?;
    for _ in 0..=random.below(3) {
        let mut nth = random.below(nodes(&values[chosen]));
        visit(&mut values[chosen], &mut nth, random);
    }
    let texts: Vec<String> = values.iter().map(Value::to_string).collect();
    Some(texts.join("\n"))
}

fn pick(length: usize, random: &mut Random) -> Option<usize> {
    (length > 0).then(|| random.below(length as u32) as usize)
}

/// How many values there are in a value, itself included.
fn nodes(value: &Value) -> u32 {
    let within: u32 = match value {
        Value::Array(list) => list.iter().map(nodes).sum(),
        Value::Object(fields) => fields.values().map(nodes).sum(),
        _ => 0,
    };
    1 + within
}

/// Changes the `nth` value; whether it was there.
fn visit(value: &mut Value, nth: &mut u32, random: &mut Random) -> bool {
    if *nth == 0 {
        change(value, random);
        return true;
    }
    *nth -= 1;
    match value {
        Value::Array(list) => list.iter_mut().any(|own| visit(own, nth, random)),
        Value::Object(fields) => fields.values_mut().any(|own| visit(own, nth, random)),
        _ => false,
    }
}

fn change(value: &mut Value, random: &mut Random) {
    match value {
        Value::Null => {
            *value =
                [Value::from(1), Value::from(0.5), text(random)][random.below(3) as usize].clone()
        }
        Value::Bool(flag) => *flag = !*flag,
        Value::Number(number) => *number = other_number(number, random),
        Value::String(_) if random.below(8) > 0 => *value = text(random),
        Value::String(_) => *value = Value::Null,
        Value::Array(list) => change_list(list, random),
        Value::Object(fields) => {
            let keys: Vec<String> = fields.keys().cloned().collect();
            let Some(key) = pick(keys.len(), random).map(|i| &keys[i]) else { return };
            match random.below(4) {
                0 => drop(fields.remove(key)),
                _ => drop(fields.insert(key.clone(), Value::Null)),
            }
        }
    }
}

fn text(random: &mut Random) -> Value {
    TEXTS[random.below(TEXTS.len() as u32) as usize].into()
}

fn other_number(number: &Number, random: &mut Random) -> Number {
    let whole = number.as_u64();
    let new = match (random.below(8), whole) {
        (0, Some(n)) => Some(n.wrapping_add(1).into()),
        (1, Some(n)) => Some(n.wrapping_sub(1).into()),
        (2, Some(n)) => Some(n.wrapping_mul(2).into()),
        (3, Some(n)) => Some((n / 2).into()),
        (4, Some(_)) => Some(u64::MAX.into()),
        (5, Some(_)) => Some(u64::from(random.below(20)).into()),
        (0..=5, None) => {
            let factor = [0.5, 2.0, 1.001, -1.0, 1e-3, 1e3][random.below(6) as usize];
            Number::from_f64(number.as_f64().unwrap_or(1.0) * factor)
        }
        (_, whole) => {
            let number = NUMBERS[random.below(NUMBERS.len() as u32) as usize];
            // A count that is written as a float would be refused.
            match whole {
                Some(_) if number >= 0.0 => Some((number as u64).into()),
                _ => Number::from_f64(number),
            }
        }
    };
    new.unwrap_or_else(|| 0.into())
}

fn change_list(list: &mut Vec<Value>, random: &mut Random) {
    let Some(chosen) = pick(list.len(), random) else { return };
    match random.below(6) {
        0 => drop(list.remove(chosen)),
        1 => list.clear(),
        2 => list.truncate(chosen),
        3 => list.swap(0, chosen),
        _ => {
            let copy = list[chosen].clone();
            for _ in 0..=random.below(3) {
                list.insert(chosen, copy.clone());
            }
        }
    }
}
