//! Runs work with the best instructions that a level allows.

use fearless_simd::{Level, Simd};

/// Work that is generic over the instruction set. Its `run`, and all that it
/// calls, must be `inline(always)`: only then is it compiled with those instructions.
pub(crate) trait WithSimd {
    fn run<S: Simd>(self, simd: S);
}

/// Runs `work` with AVX-512, AVX2 or the baseline of the architecture.
pub(crate) fn with_simd(level: Level, work: impl WithSimd) {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    match level {
        Level::Avx512(simd) => simd.vectorize(
            #[inline(always)]
            || work.run(simd),
        ),
        Level::Avx2(simd) => simd.vectorize(
            #[inline(always)]
            || work.run(simd),
        ),
        _ => {
            if let Some(simd) = level.as_sse2() {
                simd.vectorize(
                    #[inline(always)]
                    || work.run(simd),
                );
            }
        }
    }
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    fearless_simd::dispatch!(level, simd => work.run(simd));
}
