//! What the machine can do at most: fused multiply-adds, and the triad over
//! arrays that no cache holds.

use std::hint::black_box;

use fearless_simd::{Level, Simd, SimdBase, SimdFloat, dispatch};
use rayon::prelude::*;
use serde::Serialize;

use crate::clock::Crew;
use crate::machine::Machine;

/// Multiply-adds that do not wait for one another: enough for two units of
/// four cycles, few enough for sixteen registers.
const CHAINS: usize = 12;
const ROUNDS: usize = 200_000;

/// The machine's limits for a number of threads.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Peak {
    /// Threads.
    pub threads: usize,
    /// Fused multiply-adds in f64, two flops each, 1e9 flop/s.
    pub gigaflops_f64: f64,
    /// The same in f32.
    pub gigaflops_f32: f64,
    /// a = b + s c, 24 bytes counted for each element, 1e9 byte/s.
    pub gigabytes_per_second: f64,
}

/// Measures them: the best of `samples` samples, over arrays of `elements`.
pub fn measure(crew: &Crew, samples: usize, elements: usize) -> Peak {
    let threads = crew.threads as f64;
    let best = |flops: f64, work: &(dyn Fn() + Sync)| {
        let rate = |_| flops * threads / crew.work_each(work).seconds;
        (0..samples).map(rate).fold(0.0, f64::max) * 1e-9
    };
    let level = Level::new();
    let lanes = dispatch!(level, simd => widths(simd));
    let flops = (2 * CHAINS * ROUNDS) as f64;
    let b = vec![1.0; elements];
    let c = vec![2.0; elements];
    let mut a = vec![0.0; elements];
    let mut triad = || {
        let spent = crew.time(|| {
            let chunk = elements.div_ceil(crew.threads).max(1);
            a.par_chunks_mut(chunk)
                .zip(b.par_chunks(chunk))
                .zip(c.par_chunks(chunk))
                .for_each(|((a, b), c)| {
                    for ((a, b), c) in a.iter_mut().zip(b).zip(c) {
                        *a = b + 3.0 * c;
                    }
                });
            black_box(&a);
        });
        24.0 * elements as f64 / spent.seconds * 1e-9
    };
    Peak {
        threads: crew.threads,
        gigaflops_f64: best(flops * lanes.0 as f64, &|| {
            black_box(dispatch!(level, simd => chains(simd, black_box(1.0))));
        }),
        gigaflops_f32: best(flops * lanes.1 as f64, &|| {
            black_box(dispatch!(level, simd => chains_f32(simd, black_box(1.0))));
        }),
        // The first pass meets pages that are not there yet.
        gigabytes_per_second: (0..=samples).map(|_| triad()).fold(0.0, f64::max),
    }
}

/// Elements of an array of the triad: `least`, or four times the largest
/// cache, but not more than 1 GiB.
pub fn elements(least: usize, machine: &Machine) -> usize {
    let beyond_cache = 4 * machine.largest_cache().unwrap_or(0) / size_of::<f64>();
    beyond_cache.clamp(least, least.max(1 << 27))
}

/// The name of the instructions that the peak, and by default the sweeps, use.
pub fn instructions() -> &'static str {
    match Level::new() {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx512(_) => "AVX-512",
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        Level::Avx2(_) => "AVX2",
        #[cfg(target_arch = "aarch64")]
        Level::Neon(_) => "Neon",
        _ => "the baseline of the architecture",
    }
}

/// Lanes of f64 and of f32.
#[inline(always)]
fn widths<S: Simd>(_: S) -> (usize, usize) {
    (S::f64s::LEN, S::f32s::LEN)
}

macro_rules! chains {
    ($name:ident, $lanes:ident, $Real:ty) => {
        #[inline(always)]
        fn $name<S: Simd>(simd: S, start: $Real) -> $Real {
            let mut chains: [S::$lanes; CHAINS] =
                std::array::from_fn(|k| S::$lanes::splat(simd, start + k as $Real));
            let factor = S::$lanes::splat(simd, start * 0.999);
            let addend = S::$lanes::splat(simd, start * 0.001);
            for _ in 0..ROUNDS {
                for chain in &mut chains {
                    *chain = chain.mul_add(factor, addend);
                }
            }
            let sum = chains.into_iter().reduce(|a, b| a + b);
            sum.map_or(0.0, |sum| sum.as_slice()[0])
        }
    };
}

chains!(chains, f64s, f64);
chains!(chains_f32, f32s, f32);
