//! Small random displacements, the same for ever.
//!
//! The generator is SplitMix64 (Steele, Lea, Flood 2014, OOPSLA, fig. 1):
//! its stream is fixed by the paper, so a seed gives the same particles with
//! every version and on every machine.

/// SplitMix64.
pub(super) struct SplitMix64(pub u64);

impl SplitMix64 {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [-1, 1).
    pub(super) fn symmetric(&mut self) -> f64 {
        // The upper 53 bits fill a double's digits exactly.
        (self.next() >> 11) as f64 * (2.0 / (1u64 << 53) as f64) - 1.0
    }
}

#[cfg(test)]
mod tests {
    use super::SplitMix64;

    #[test]
    fn the_stream_is_the_published_one() {
        // First outputs for seed 1234567, as listed by several independent implementations.
        let mut random = SplitMix64(1_234_567);
        let expected = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
        ];
        assert_eq!([random.next(), random.next(), random.next()], expected);
    }

    #[test]
    fn values_fill_their_interval_evenly() {
        let mut random = SplitMix64(7);
        let n = 100_000;
        let values: Vec<f64> = (0..n).map(|_| random.symmetric()).collect();
        assert!(values.iter().all(|v| (-1.0..1.0).contains(v)));
        // Mean 0 and variance 1/3; four standard errors of each.
        let mean = values.iter().sum::<f64>() / f64::from(n);
        let variance = values.iter().map(|v| v * v).sum::<f64>() / f64::from(n);
        assert!(mean.abs() < 4.0 * (1.0 / 3.0 / f64::from(n)).sqrt());
        assert!((variance - 1.0 / 3.0).abs() < 4.0 * (4.0 / 45.0 / f64::from(n)).sqrt());
    }
}
