//! Which instruction set runs, chosen once.

use std::ffi::OsStr;
use std::sync::OnceLock;

use super::Simd;
use super::portable::Portable;
#[cfg(target_arch = "x86_64")]
use super::x86;

/// The environment variable that forces an instruction set.
const VARIABLE: &str = "SRT_ISA";

/// An instruction set for which kernels are compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Isa {
    /// What every processor of the target has: SSE2 or NEON.
    Portable,
    /// AVX2 with fused multiply-add.
    Avx2,
    /// AVX-512 with its vector-length, byte-and-word and double-and-quadword parts.
    Avx512,
}

/// Why an instruction set cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum IsaError {
    /// No instruction set has this name.
    #[error("unknown instruction set `{0}` in SRT_ISA: use portable, avx2 or avx512")]
    Unknown(String),
    /// The processor, or the target that the program was compiled for, lacks it.
    #[error("this processor lacks the instruction set `{}` that SRT_ISA names", .0.name())]
    Absent(Isa),
}

impl Isa {
    /// All of them, the narrowest first.
    pub const ALL: [Self; 3] = [Self::Portable, Self::Avx2, Self::Avx512];

    /// The name in `SRT_ISA` and in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Portable => "portable",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
        }
    }

    /// Whether this processor has it.
    #[must_use]
    pub fn is_present(self) -> bool {
        match self {
            Self::Portable => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => x86::has_avx2(),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => x86::has_avx512(),
            #[cfg(not(target_arch = "x86_64"))]
            Self::Avx2 | Self::Avx512 => false,
        }
    }

    /// The widest set that this processor has, or the one that the environment variable `SRT_ISA`
    /// names. The choice is made once and kept.
    ///
    /// # Errors
    /// If `SRT_ISA` names no instruction set, or one that is not present.
    pub fn chosen() -> Result<Self, IsaError> {
        static CHOSEN: OnceLock<Result<Isa, IsaError>> = OnceLock::new();
        CHOSEN.get_or_init(|| Self::from_name(std::env::var_os(VARIABLE).as_deref())).clone()
    }

    fn from_name(name: Option<&OsStr>) -> Result<Self, IsaError> {
        let widest = || Self::ALL.into_iter().rev().find(|isa| isa.is_present());
        let Some(name) = name.filter(|name| !name.is_empty()) else {
            return Ok(widest().unwrap_or(Self::Portable));
        };
        let isa = Self::ALL.into_iter().find(|isa| isa.name() == name);
        let isa = isa.ok_or_else(|| IsaError::Unknown(name.to_string_lossy().into_owned()))?;
        if isa.is_present() { Ok(isa) } else { Err(IsaError::Absent(isa)) }
    }
}

/// A computation that is compiled for each instruction set.
///
/// `run`, and what it calls, must be `#[inline(always)]`: a function of its own would be compiled
/// without the instruction set.
pub trait Kernel {
    /// What it returns.
    type Output;
    /// Computes.
    fn run<S: Simd>(self) -> Self::Output;
}

/// Runs a kernel with the chosen instruction set; with the widest one, if the choice was an error.
#[inline]
pub fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    match chosen_or_widest() {
        // SAFETY: the processor has what was chosen.
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => unsafe { x86::run_avx2(kernel) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => unsafe { x86::run_avx512(kernel) },
        _ => kernel.run::<Portable>(),
    }
}

/// An instruction set that this processor has: looked up once, because kernels can be small.
#[inline]
fn chosen_or_widest() -> Isa {
    static ISA: OnceLock<Isa> = OnceLock::new();
    let choose = || {
        let chosen = Isa::chosen().or_else(|_| Isa::from_name(None));
        chosen.ok().filter(|isa| isa.is_present()).unwrap_or(Isa::Portable)
    };
    *ISA.get_or_init(choose)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_has_its_name_and_no_name_is_the_widest() {
        let of = |name: &str| Isa::from_name(Some(OsStr::new(name)));
        assert_eq!(of("portable"), Ok(Isa::Portable));
        assert_eq!(of(""), Isa::from_name(None));
        assert_eq!(of("sse9"), Err(IsaError::Unknown("sse9".to_owned())));
    }

    #[cfg(unix)]
    #[test]
    fn a_name_that_is_no_text_is_unknown() {
        use std::os::unix::ffi::OsStrExt;
        let error = Isa::from_name(Some(OsStr::from_bytes(b"avx\xff"))).unwrap_err();
        assert_eq!(error, IsaError::Unknown("avx\u{fffd}".to_owned()));
    }
}
