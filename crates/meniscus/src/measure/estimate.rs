//! A number with its uncertainty.

/// A measured number and half the width of its 95 % confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// The truth lies within `value` plus or minus this in 95 of 100 such measurements.
    pub half_width: f64,
}

impl Estimate {
    /// The mean of measurements that know nothing of each other, of one normal distribution; none of fewer than
    /// five.
    pub fn of_independent(values: &[f64]) -> Option<Self> {
        let n = values.len() as f64;
        if n < 5.0 {
            return None;
        }
        let value = values.iter().sum::<f64>() / n;
        let variance = values.iter().map(|v| (v - value).powi(2)).sum::<f64>() / (n - 1.0);
        Some(Self {
            value,
            half_width: student_t(n - 1.0) * (variance / n).sqrt(),
        })
    }

    /// A function of this number, to first order: its value and its derivative there.
    pub(crate) fn propagate(self, value: f64, derivative: f64) -> Estimate {
        Estimate {
            value,
            half_width: (derivative * self.half_width).abs(),
        }
    }
}

/// The 97.5 % point of Student's t distribution, by the expansion of Cornish and
/// Fisher (Abramowitz and Stegun, 26.7.5): within 0.3 % from 4 degrees of freedom on.
pub(crate) fn student_t(degrees_of_freedom: f64) -> f64 {
    let z: f64 = 1.959_963_984_540_054;
    let (z3, z5, z7, z9) = (z.powi(3), z.powi(5), z.powi(7), z.powi(9));
    let inverse = 1.0 / degrees_of_freedom;
    let g1 = (z3 + z) / 4.0;
    let g2 = (5.0 * z5 + 16.0 * z3 + 3.0 * z) / 96.0;
    let g3 = (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / 384.0;
    let g4 = (79.0 * z9 + 776.0 * z7 + 1482.0 * z5 - 1920.0 * z3 - 945.0 * z) / 92160.0;
    z + inverse * (g1 + inverse * (g2 + inverse * (g3 + inverse * g4)))
}

#[cfg(test)]
mod tests {
    use super::student_t;

    #[test]
    fn points_of_the_t_distribution_from_tables() {
        for (degrees, table) in [
            (4.0, 2.776),
            (5.0, 2.571),
            (10.0, 2.228),
            (30.0, 2.042),
            (1e6, 1.960),
        ] {
            assert!((student_t(degrees) / table - 1.0).abs() < 3e-3, "{degrees}");
        }
    }
}
