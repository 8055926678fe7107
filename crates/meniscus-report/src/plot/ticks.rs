//! Round numbers along an axis.

use crate::number::{exponent, fixed, in_reach, superscript};

/// The ticks of an axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Ticks {
    /// Values with their labels.
    pub labelled: Vec<(f64, String)>,
    /// Values between them that get a short tick alone.
    pub small: Vec<f64>,
}

/// The round number (1, 2 or 5 times a power of ten) not below `x > 0`.
pub(crate) fn round_up(x: f64) -> f64 {
    let power = 10_f64.powi(exponent(x));
    let first = x / power;
    // A hair's breadth for numbers that are round but for rounding.
    let round = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|r| first <= r * (1.0 + 1e-9));
    round.unwrap_or(10.0) * power
}

/// The round number nearest to `x > 0` by ratio.
fn round_near(x: f64) -> f64 {
    let above = round_up(x);
    let below = 1.0 / round_up(1.0 / x);
    if above / x < x / below { above } else { below }
}

/// Ticks at whole multiples of a round step, about `count` of them.
pub(crate) fn linear(low: f64, high: f64, count: f64) -> Ticks {
    let range = high - low;
    if !(range > 0.0 && in_reach(range)) {
        return Ticks::default();
    }
    let step = round_near(range / count.max(1.0));
    let decimals = usize::try_from(-exponent(step)).unwrap_or(0);
    // The ends count although a division put them a hair outside.
    let first = (low / step - 1e-6).ceil() as i64;
    let last = (high / step + 1e-6).floor() as i64;
    // Ends that no f64 parts, or of no magnitude that a power of ten has.
    if !(0..=100).contains(&last.saturating_sub(first)) {
        return Ticks::default();
    }
    let label = |i: i64| (i as f64 * step, fixed(i as f64 * step, decimals));
    Ticks {
        labelled: (first..=last).map(label).collect(),
        small: Vec::new(),
    }
}

/// Ticks for a logarithmic axis from `low > 0`, about `count` at most: at
/// decades where there are two or more, else at 1, 2 and 5 of each, else at
/// the multiples of a round step.
pub(crate) fn logarithmic(low: f64, high: f64, count: f64) -> Ticks {
    if !(in_reach(low) && in_reach(high)) {
        return Ticks::default();
    }
    let inside = |x: f64| x >= low * (1.0 - 1e-9) && x <= high * (1.0 + 1e-9);
    let decades = exponent(low)..=exponent(high);
    let within = |factors: &[f64]| -> Vec<f64> {
        let decade = |e: i32| factors.iter().map(move |f| f * 10_f64.powi(e));
        decades
            .clone()
            .flat_map(decade)
            .filter(|&x| inside(x))
            .collect()
    };
    let small = within(&[2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
    let whole = within(&[1.0]);
    if whole.len() >= 3 {
        let every = (whole.len() as f64 / count).ceil().max(1.0) as usize;
        let shown = whole.iter().step_by(every);
        return Ticks {
            labelled: shown.map(|&x| (x, power_label(x))).collect(),
            small: if every == 1 { small } else { whole },
        };
    }
    let fine = within(&[1.0, 2.0, 5.0]);
    if fine.len() >= 3 {
        let label = |&x: &f64| (x, plain_label(x));
        return Ticks {
            labelled: fine.iter().map(label).collect(),
            small,
        };
    }
    linear(low, high, count)
}

/// A power of ten, in figures where that is short.
fn power_label(x: f64) -> String {
    let power = exponent(x);
    if (-3..=4).contains(&power) {
        plain_label(x)
    } else {
        format!("10{}", superscript(power))
    }
}

/// A number of one digit in figures.
fn plain_label(x: f64) -> String {
    fixed(x, usize::try_from(-exponent(x)).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: &Ticks) -> Vec<&str> {
        ticks.labelled.iter().map(|(_, l)| l.as_str()).collect()
    }

    #[test]
    fn linear_ticks_are_round_and_inside() {
        let ticks = linear(0.0, 2.1, 6.0);
        assert_eq!(labels(&ticks), ["0.0", "0.5", "1.0", "1.5", "2.0"]);
        let ticks = linear(-0.3, 0.3, 4.0);
        assert_eq!(labels(&ticks), ["−0.2", "0.0", "0.2"]);
        let ticks = linear(0.1, 0.3, 2.0);
        assert_eq!(labels(&ticks), ["0.1", "0.2", "0.3"]);
        assert_eq!(linear(1.0, 1.0, 5.0), Ticks::default());
    }

    #[test]
    fn logarithmic_ticks_fall_on_decades_or_between() {
        let ticks = logarithmic(1e-7, 1.0, 8.0);
        assert_eq!(labels(&ticks)[0], "10⁻⁷");
        assert_eq!(labels(&ticks).last(), Some(&"1"));
        assert_eq!(labels(&logarithmic(0.4, 6.0, 8.0)), ["0.5", "1", "2", "5"]);
        let narrow = logarithmic(600.0, 2500.0, 5.0);
        assert_eq!(labels(&narrow), ["1000", "1500", "2000", "2500"]);
    }

    #[test]
    fn round_numbers_stay_what_they_are() {
        for x in [1e-6, 2e-6, 5e3, 1e15] {
            assert_eq!(round_up(x), x);
        }
        assert_eq!(round_up(2.1), 5.0);
    }
}
