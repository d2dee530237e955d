//! Changes to text of a command a line that leave most lines whole: most changes of single bytes would be refused.

use libfuzzer_sys::fuzzer_mutate;
use srt::math::Random;

/// Numbers at the ends of ranges, and some that are fine nearly anywhere.
const NUMBERS: [&str; 20] = [
    "0", "1", "-1", "2", "3", "0.5", ".25", "-0.125", "4.0", "1e-3", "1e-9", "1e-30", "1e-38",
    "-1e-45", "1e3", "1e9", "1e12", "3e38", "1e39", "90",
];

/// Some changes to the lines of a text; now and then one of the fuzzer's own, to bytes. Lines of `known` are put in,
/// and a text may begin anew as `start`.
pub fn mutate(
    data: &mut [u8],
    (size, max_size, seed): (usize, usize, u32),
    start: &str,
    known: &[&str],
) -> usize {
    let mut random = Random::new(&[u64::from(seed)]);
    if random.below(4) == 0 {
        return fuzzer_mutate(data, size, max_size);
    }
    let text = match random.below(4) {
        0 => start.to_owned(),
        _ => String::from_utf8_lossy(&data[..size]).into_owned(),
    };
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for _ in 0..=random.below(6) {
        change(&mut lines, known, &mut random);
    }
    let text = lines.join("\n") + "\n";
    if text.len() > max_size {
        return fuzzer_mutate(data, size, max_size);
    }
    data[..text.len()].copy_from_slice(text.as_bytes());
    text.len()
}

fn change(lines: &mut Vec<String>, known: &[&str], random: &mut Random) {
    let new = known[random.below(known.len() as u32) as usize].to_owned();
    if lines.is_empty() {
        return lines.push(new);
    }
    let length = lines.len() as u32;
    let [chosen, other] = [(); 2].map(|()| random.below(length) as usize);
    match random.below(8) {
        0 => drop(lines.remove(chosen)),
        1 => lines.swap(chosen, other),
        2 => lines.insert(chosen, lines[other].clone()),
        3 | 4 => lines.push(new),
        _ => change_word(&mut lines[chosen], random),
    }
}

/// Puts a number in place of a word that is not the first.
fn change_word(line: &mut String, random: &mut Random) {
    let mut words: Vec<&str> = line.split_whitespace().collect();
    if words.len() > 1 {
        let chosen = 1 + random.below(words.len() as u32 - 1) as usize;
        words[chosen] = NUMBERS[random.below(NUMBERS.len() as u32) as usize];
        *line = words.join(" ");
    }
}
