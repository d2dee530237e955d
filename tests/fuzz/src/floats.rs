//! Changes to the floats of a file whose numbers are words of four bytes: most changes of single bytes are refused as
//! other counts and indices, and of those that are not, most make a float hardly another.

use libfuzzer_sys::fuzzer_mutate;
use srt::math::Random;

/// The most floats that are changed at once.
const MOST: u32 = 3;

/// Places that are looked at for one that has a float, before there is said to be none.
const TRIES: usize = 100;

/// Changes some floats to others, three times in four; otherwise bytes, as the fuzzer does. They may begin anywhere, as
/// names before them may have any length.
pub fn mutate(data: &mut [u8], size: usize, max_size: usize, seed: u32) -> usize {
    let mut random = Random::new(&[u64::from(seed)]);
    if size < 4 || random.below(4) == 0 {
        return fuzzer_mutate(data, size, max_size);
    }
    for _ in 0..=random.below(MOST) {
        let mut place = || random.below(size as u32 - 3) as usize;
        let float =
            |at: usize| f32::from_le_bytes([data[at], data[at + 1], data[at + 2], data[at + 3]]);
        let places = (0..TRIES).map(|_| place());
        let Some((at, old)) = places.map(|at| (at, float(at))).find(|&(_, old)| may_be_float(old))
        else {
            return fuzzer_mutate(data, size, max_size);
        };
        let other = float(place());
        let new = changed(old, other, &mut random);
        data[at..at + 4].copy_from_slice(&new.to_le_bytes());
    }
    size
}

/// Whether four bytes that are read as this are likely to be a coordinate: of small counts and indices, and of most
/// places between two words, they are not.
fn may_be_float(value: f32) -> bool {
    value == 0.0 || (1e-3..1e3).contains(&value.abs())
}

/// Of another magnitude or sign, a little beside it, one from elsewhere in the file, or any.
fn changed(old: f32, other: f32, random: &mut Random) -> f32 {
    let magnitude = 10f32.powi(random.below(77) as i32 - 38);
    match random.below(8) {
        0 => magnitude,
        1 => -magnitude,
        2 => 0.0,
        3 => -old,
        4 => old * (1.0 + random.next_f32()),
        5 => old.next_up(),
        6 => other,
        _ => f32::from_bits(random.next_u64() as u32),
    }
}
