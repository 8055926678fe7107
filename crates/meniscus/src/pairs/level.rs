//! Runs work with the best instructions that a level allows.
//!
//! What runs in every step is worth machine code for each instruction set. It
//! is the bulk of the program, so what few will run is not compiled: a kernel
//! known to the compiler only for AVX-512, f32 only where there is AVX2.

use fearless_simd::{Level, Simd};

/// Work that is generic over the instruction set. Its `run`, and all that it
/// calls, must be `inline(always)`: only then is it compiled with those instructions.
pub(crate) trait WithSimd {
    fn run<S: Simd>(self, simd: S);
}

/// Instruction sets that work is compiled for.
pub(crate) trait InstructionSets {
    /// Runs `work` with the best of them that `level` allows, or gives it back if there is none.
    fn run<W: WithSimd>(level: Level, work: W) -> Result<(), W>;
}

/// All of them.
pub(crate) struct Every;

/// Those that fuse a multiplication and an addition.
pub(crate) struct Fused;

/// The widest.
pub(crate) struct Widest;

impl InstructionSets for Every {
    fn run<W: WithSimd>(level: Level, work: W) -> Result<(), W> {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        if let Err(work) = Fused::run(level, work)
            && let Some(simd) = level.as_sse2()
        {
            simd.vectorize(
                #[inline(always)]
                || work.run(simd),
            );
        }
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        fearless_simd::dispatch!(level, simd => work.run(simd));
        Ok(())
    }
}

impl InstructionSets for Fused {
    fn run<W: WithSimd>(level: Level, work: W) -> Result<(), W> {
        match level {
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx2(simd) => {
                simd.vectorize(
                    #[inline(always)]
                    || work.run(simd),
                );
                Ok(())
            }
            _ => Widest::run(level, work),
        }
    }
}

impl InstructionSets for Widest {
    fn run<W: WithSimd>(level: Level, work: W) -> Result<(), W> {
        match level {
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Level::Avx512(simd) => {
                simd.vectorize(
                    #[inline(always)]
                    || work.run(simd),
                );
                Ok(())
            }
            _ => Err(work),
        }
    }
}

/// Whether `level` has instructions of [`Fused`].
pub(crate) fn is_fused(level: Level) -> bool {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    return matches!(level, Level::Avx512(_) | Level::Avx2(_));
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    return false;
}

/// Whether `level` has instructions of [`Widest`].
pub(crate) fn is_widest(level: Level) -> bool {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    return matches!(level, Level::Avx512(_));
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    return false;
}
