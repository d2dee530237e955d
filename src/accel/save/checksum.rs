//! XXH64, by Yann Collet: a checksum as fast as memory. Of changes to the bytes, all but about one in 2⁶⁴ change it.
//!
//! Its description is `doc/xxhash_spec.md` of <https://github.com/Cyan4973/xxHash>. The seed is 0.

const PRIMES: [u64; 5] = [
    0x9E37_79B1_85EB_CA87,
    0xC2B2_AE3D_27D4_EB4F,
    0x1656_67B1_9E37_79F9,
    0x85EB_CA77_C2B2_AE63,
    0x27D4_EB2F_1656_67C5,
];

/// Sums that are added to side by side.
const LANES: usize = 4;

/// The checksum of bytes.
pub(super) fn xxh64(bytes: &[u8]) -> u64 {
    let [one, two, three, four, five] = PRIMES;
    let (stripes, mut rest) = bytes.as_chunks::<{ 8 * LANES }>();
    let mut hash = if stripes.is_empty() {
        five
    } else {
        let mut sums = [one.wrapping_add(two), two, 0, 0_u64.wrapping_sub(one)];
        for stripe in stripes {
            for (sum, word) in sums.iter_mut().zip(stripe.as_chunks().0) {
                *sum = round(*sum, u64::from_le_bytes(*word));
            }
        }
        let turns = [1, 7, 12, 18];
        let turned = sums.iter().zip(turns).map(|(sum, turn)| sum.rotate_left(turn));
        let joined = turned.fold(0, u64::wrapping_add);
        sums.iter()
            .fold(joined, |hash, &sum| (hash ^ round(0, sum)).wrapping_mul(one).wrapping_add(four))
    };
    hash = hash.wrapping_add(bytes.len() as u64);
    while let Some((word, behind)) = rest.split_first_chunk() {
        hash ^= round(0, u64::from_le_bytes(*word));
        hash = hash.rotate_left(27).wrapping_mul(one).wrapping_add(four);
        rest = behind;
    }
    if let Some((word, behind)) = rest.split_first_chunk() {
        hash ^= u64::from(u32::from_le_bytes(*word)).wrapping_mul(one);
        hash = hash.rotate_left(23).wrapping_mul(two).wrapping_add(three);
        rest = behind;
    }
    for &byte in rest {
        hash ^= u64::from(byte).wrapping_mul(five);
        hash = hash.rotate_left(11).wrapping_mul(one);
    }
    hash = (hash ^ (hash >> 33)).wrapping_mul(two);
    hash = (hash ^ (hash >> 29)).wrapping_mul(three);
    hash ^ (hash >> 32)
}

fn round(sum: u64, word: u64) -> u64 {
    let [one, two, ..] = PRIMES;
    sum.wrapping_add(word.wrapping_mul(two)).rotate_left(31).wrapping_mul(one)
}

/// FNV-1a with 64 bits, for the few bytes that come one by one. A changed byte always changes it.
pub(super) struct Fnv(pub(super) u64);

impl Fnv {
    pub(super) const NEW: Self = Self(0xCBF2_9CE4_8422_2325);

    pub(super) fn add(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01B3);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn checksums_are_those_of_the_reference() {
        assert_eq!(xxh64(b""), 0xEF46_DB37_51D8_E999);
        assert_eq!(xxh64(b"a"), 0xD24E_C4F1_A98C_6E5B);
        assert_eq!(xxh64(b"abc"), 0x44BC_2CF5_AD77_0999);
        // Longer than a stripe, with a rest of each kind.
        let text = b"Nobody inspects the spammish repetition";
        assert_eq!(xxh64(text), 0xFBCE_A83C_8A37_8BF1);
    }

    #[test]
    fn fnv_is_that_of_the_reference() {
        // From the reference implementation of Fowler, Noll and Vo.
        let of = |text: &str| {
            let mut checksum = Fnv::NEW;
            checksum.add(text.as_bytes());
            checksum.0
        };
        assert_eq!(of(""), 0xCBF2_9CE4_8422_2325);
        assert_eq!(of("a"), 0xAF63_DC4C_8601_EC8C);
        assert_eq!(of("foobar"), 0x8594_4171_F739_67E8);
    }

    #[test]
    fn each_bit_counts_wherever_it_is() {
        let bytes: Vec<u8> = (0..77).collect();
        for bit in 0..8 * bytes.len() {
            let mut other = bytes.clone();
            other[bit / 8] ^= 1 << (bit % 8);
            assert_ne!(xxh64(&other), xxh64(&bytes), "bit {bit}");
        }
    }
}
