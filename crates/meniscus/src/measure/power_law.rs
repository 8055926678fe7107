//! The fit of a power law to a series of measurements: y = a (t - t_0)^n.

use super::estimate::{Estimate, student_t};
use super::fit_error::{FitError, check};

/// A fitted power law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLaw {
    /// t_0, s, as given.
    pub start: f64,
    /// a, in the unit of the values over s^n.
    pub factor: f64,
    /// n.
    pub exponent: Estimate,
    /// How many samples with independent errors would tell the exponent as sharply.
    pub effective_samples: f64,
}

impl PowerLaw {
    /// Fits positive values (any unit) measured at these times (s, rising, all after `start`):
    /// the straight line of least squares through their logarithms.
    ///
    /// What a simulation leaves over is no white noise: each residual remembers the one before,
    /// with the correlation r, so that the interval of the exponent is that of
    /// N (1 - r) / (1 + r) samples (Bayley and Hammersley 1946, J. R. Stat. Soc. Suppl. 8, 184).
    /// That holds for noise that forgets within the window; a bend of the whole
    /// curve is told by other windows, not by the interval.
    ///
    /// # Errors
    /// [`FitError`] for columns of different length, fewer than twelve samples, a value that is
    /// not finite or not positive, times that do not rise or do not come after `start`.
    ///
    /// ```
    /// use meniscus::measure::PowerLaw;
    /// let times: Vec<f64> = (1..50).map(|i| 0.02 + 0.001 * f64::from(i)).collect();
    /// let radii: Vec<f64> = times.iter().map(|t| 1.3 * (t - 0.02).sqrt()).collect();
    /// let fit = PowerLaw::fit(&times, &radii, 0.02)?;
    /// assert!((fit.exponent.value - 0.5).abs() < 1e-12);
    /// assert!((fit.factor - 1.3).abs() < 1e-12);
    /// # Ok::<(), meniscus::measure::FitError>(())
    /// ```
    pub fn fit(times: &[f64], values: &[f64], start: f64) -> Result<PowerLaw, FitError> {
        check(times, values)?;
        let samples = || times.iter().zip(values);
        let positive = |(t, y): (&f64, &f64)| *t > start && *y > 0.0;
        if let Some(index) = samples().position(|sample| !positive(sample)) {
            return Err(FitError::NotPositive { index });
        }
        let n = times.len() as f64;
        let logarithms: Vec<(f64, f64)> =
            samples().map(|(t, y)| ((t - start).ln(), y.ln())).collect();
        let mean = |of: &dyn Fn(&(f64, f64)) -> f64| logarithms.iter().map(of).sum::<f64>() / n;
        let (x0, y0) = (mean(&|p| p.0), mean(&|p| p.1));
        let spread = mean(&|p| (p.0 - x0).powi(2));
        let exponent = mean(&|p| (p.0 - x0) * (p.1 - y0)) / spread;
        let left: Vec<f64> = logarithms
            .iter()
            .map(|(x, y)| y - y0 - exponent * (x - x0))
            .collect();
        let squares = left.iter().map(|e| e * e).sum::<f64>();
        let neighbours = left.windows(2).map(|pair| pair[0] * pair[1]).sum::<f64>();
        let memory = if squares > 0.0 {
            neighbours / squares
        } else {
            0.0
        };
        // Two parameters are fitted; Student's expansion holds from four on.
        let memory = memory.clamp(0.0, 1.0);
        let effective_samples = (n * (1.0 - memory) / (1.0 + memory)).max(6.0);
        let freedom = effective_samples - 2.0;
        Ok(PowerLaw {
            start,
            factor: (y0 - exponent * x0).exp(),
            exponent: Estimate {
                value: exponent,
                half_width: student_t(freedom) * (squares / n / (spread * freedom)).sqrt(),
            },
            effective_samples,
        })
    }

    /// y(t) for a time in s after the start, in the unit of the values.
    pub fn at(&self, time: f64) -> f64 {
        self.factor * (time - self.start).powf(self.exponent.value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::samples::Random;

    #[test]
    fn nineteen_of_twenty_intervals_hold_the_truth_of_noise_with_a_memory() {
        for memory in [0.0_f64, 0.6, 0.9] {
            let mut random = Random(3);
            let (mut held, trials) = (0, 1000);
            for _ in 0..trials {
                let mut noise = 0.0;
                let (times, values): (Vec<f64>, Vec<f64>) = (0..400)
                    .map(|i| {
                        noise = memory * noise
                            + 0.02 * (1.0 - memory * memory).sqrt() * random.normal();
                        let t = 1.0 + 0.01 * f64::from(i);
                        (t, 2.0 * t.powf(0.4) * f64::exp(noise))
                    })
                    .unzip();
                let n = PowerLaw::fit(&times, &values, 0.0).unwrap().exponent;
                held += i32::from((n.value - 0.4).abs() < n.half_width);
            }
            // 950 expected; the memory as estimated from 400 samples is a little short.
            assert!((900..=980).contains(&held), "{memory}: {held}");
        }
    }

    #[test]
    fn what_is_no_power_law_is_told_with_its_place() {
        let times: Vec<f64> = (0..20).map(f64::from).collect();
        let mut values = vec![1.0; 20];
        let fit = |values: &[f64], start| PowerLaw::fit(&times, values, start);
        assert_eq!(fit(&values, 0.0), Err(FitError::NotPositive { index: 0 }));
        // A constant is a power law of exponent zero, known without doubt.
        let flat = fit(&values, -1.0).unwrap();
        assert_eq!((flat.exponent.value, flat.exponent.half_width), (0.0, 0.0));
        assert_eq!((flat.factor, flat.at(7.0)), (1.0, 1.0));
        values[7] = -2.0;
        assert_eq!(fit(&values, -1.0), Err(FitError::NotPositive { index: 7 }));
        values[3] = f64::NAN;
        assert_eq!(fit(&values, -1.0), Err(FitError::NotFinite { index: 3 }));
    }
}
