//! Numbers as people read them: SI prefixes, significant digits, a real minus.

/// A unit with the prefix that suits a magnitude.
#[derive(Clone, Debug, PartialEq)]
pub struct ScaledUnit {
    /// What one of it is in the plain unit, as in 1e-3 for mm.
    pub factor: f64,
    /// As printed, `mm`; empty for a plain number.
    pub unit: String,
    /// Where a power of ten stands in for a prefix: that power.
    power: Option<i32>,
    /// Without prefix or power.
    plain: String,
}

/// Symbols before which a prefix may stand. The kilogram and powers are left
/// out: their prefix would not be the factor.
const PREFIXABLE: [&str; 11] = ["m", "s", "g", "N", "Pa", "J", "W", "Hz", "K", "V", "A"];

const PREFIXES: [(i32, &str); 10] = [
    (-15, "f"),
    (-12, "p"),
    (-9, "n"),
    (-6, "µ"),
    (-3, "m"),
    (0, ""),
    (3, "k"),
    (6, "M"),
    (9, "G"),
    (12, "T"),
];

/// The unit in which a quantity of at most `largest` reads well: with an SI
/// prefix where the unit takes one, else with a power of ten where the
/// number is very large or small.
pub fn scaled_unit(unit: &str, largest: f64) -> ScaledUnit {
    let plain = pretty_unit(unit);
    let mut scaled = ScaledUnit {
        factor: 1.0,
        unit: plain.clone(),
        power: None,
        plain,
    };
    if !in_reach(largest) {
        return scaled;
    }
    let plain = &scaled.plain;
    let thousands = 3 * exponent(largest).div_euclid(3);
    let prefix = PREFIXES.iter().find(|(power, _)| *power == thousands);
    match prefix.filter(|_| takes_prefix(plain)) {
        Some((_, prefix)) => scaled.unit = format!("{prefix}{plain}"),
        None if (1e-2..1e5).contains(&largest.abs()) => return scaled,
        None => {
            let power = format!("10{}", superscript(thousands));
            scaled.unit = if plain.is_empty() {
                format!("×{power}")
            } else {
                format!("{power} {plain}")
            };
            scaled.power = Some(thousands);
        }
    }
    scaled.factor = 10_f64.powi(thousands);
    scaled
}

impl ScaledUnit {
    /// A value (in the plain unit) to `digits` significant digits, with this
    /// unit behind it.
    pub fn value(&self, value: f64, digits: usize) -> String {
        if self.power.is_some() {
            behind(significant(value, digits), &self.plain)
        } else {
            behind(significant(value / self.factor, digits), &self.unit)
        }
    }

    /// A value with its uncertainty, that to two digits and the value to the
    /// same place, with this unit behind them.
    pub fn uncertain(&self, value: f64, uncertainty: f64) -> String {
        if !value.is_finite() || !in_reach(uncertainty) {
            return self.value(value, 4);
        }
        let (value, uncertainty) = (value / self.factor, uncertainty.abs() / self.factor);
        let decimals = places_below(1 - exponent(uncertainty)).min(12);
        let text = format!(
            "{} ± {}",
            fixed(value, decimals),
            fixed(uncertainty, decimals)
        );
        match self.power {
            // The power of ten multiplies both numbers.
            Some(power) => {
                let text = format!("({text}) × 10{}", superscript(power));
                behind(text, &self.plain)
            }
            None => behind(text, &self.unit),
        }
    }
}

fn behind(number: String, unit: &str) -> String {
    if unit.is_empty() {
        number
    } else {
        format!("{number} {unit}")
    }
}

/// Whether a prefix before the unit multiplies the whole of it.
fn takes_prefix(unit: &str) -> bool {
    let end = unit.find(|c: char| !c.is_alphabetic());
    let (symbol, rest) = unit.split_at(end.unwrap_or(unit.len()));
    PREFIXABLE.contains(&symbol) && (rest.is_empty() || rest.starts_with(['/', '·', ' ']))
}

/// The unit with raised exponents: `kg/m^3` becomes `kg/m³`.
pub fn pretty_unit(unit: &str) -> String {
    let mut out = String::new();
    let mut raised = false;
    for letter in unit.chars() {
        raised = match letter {
            '^' => true,
            '-' | '0'..='9' if raised => {
                out.push(raise(letter));
                true
            }
            '*' => {
                out.push('·');
                false
            }
            _ => {
                out.push(letter);
                false
            }
        };
    }
    out
}

/// A number with its unit to `digits` significant digits: `72.7 mN/m`.
pub fn with_unit(value: f64, unit: &str, digits: usize) -> String {
    scaled_unit(unit, value).value(value, digits)
}

/// A number with its uncertainty and unit: `72.41 ± 0.35 mN/m`.
pub fn with_uncertainty(value: f64, uncertainty: f64, unit: &str) -> String {
    let largest = value.abs().max(uncertainty.abs());
    scaled_unit(unit, largest).uncertain(value, uncertainty)
}

/// A plain number to `digits` significant digits, with a power of ten where
/// it is very large or small.
pub fn significant(value: f64, digits: usize) -> String {
    if value.is_nan() {
        return "not a number".to_owned();
    }
    if value.is_infinite() {
        return if value > 0.0 { "∞" } else { "−∞" }.to_owned();
    }
    if value.abs() < 1e-300 {
        return "0".to_owned();
    }
    let digits = digits.max(1) as i32;
    let exponent = exponent(value);
    if (-4..6).contains(&exponent) {
        fixed(value, places_below(digits - 1 - exponent))
    } else {
        let mantissa = value / 10_f64.powi(exponent);
        format!(
            "{} × 10{}",
            fixed(mantissa, places_below(digits - 1)),
            superscript(exponent)
        )
    }
}

/// A number with a fixed count of decimals and a real minus sign.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        // A zero has no sign, however it came about.
        Some(rest) if rest.bytes().all(|b| b == b'0' || b == b'.') => rest.to_owned(),
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}

/// Whether a number is one that powers of ten can scale: not zero, not
/// infinite, nor at the end of what an f64 holds.
pub(crate) fn in_reach(value: f64) -> bool {
    (1e-300..1e300).contains(&value.abs())
}

/// Power of ten of the first digit of a number that is in reach.
pub(crate) fn exponent(value: f64) -> i32 {
    let guess = value.abs().log10().floor() as i32;
    // The logarithm may fall on the wrong side at a power of ten itself.
    if value.abs() >= 10_f64.powi(guess + 1) {
        guess + 1
    } else {
        guess
    }
}

fn places_below(places: i32) -> usize {
    usize::try_from(places).unwrap_or(0)
}

/// A whole number as an exponent, raised.
pub(crate) fn superscript(number: i32) -> String {
    number.to_string().chars().map(raise).collect()
}

fn raise(letter: char) -> char {
    match letter {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_prefix_suits_the_magnitude_and_only_units_that_take_one() {
        let unit = |unit, largest| scaled_unit(unit, largest).unit;
        assert_eq!(unit("s", 2.1e-3), "ms");
        assert_eq!(unit("m", 5e-5), "µm");
        assert_eq!(unit("N/m", 0.0727), "mN/m");
        assert_eq!(unit("Pa·s", 1e-3), "mPa·s");
        assert_eq!(unit("Pa", 2900.0), "kPa");
        assert_eq!(unit("m/s", 3.0), "m/s");
        assert_eq!(unit("m^2", 3e-9), "10⁻⁹ m²");
        assert_eq!(unit("kg/m^3", 1000.0), "kg/m³");
        assert_eq!(unit("kg", 1e-9), "10⁻⁹ kg");
        assert_eq!(unit("1/s", 2e6), "10⁶ 1/s");
        assert_eq!(unit("", 0.3), "");
        assert_eq!(unit("s", 0.0), "s");
        assert_eq!(unit("m", 1e-3), "mm");
        assert_eq!(unit("m", 1e-20), "10⁻²¹ m");
    }

    #[test]
    fn the_factor_is_the_prefix() {
        assert_eq!(scaled_unit("m", 5e-5).factor, 1e-6);
        assert_eq!(scaled_unit("m^2", 3e-9).factor, 1e-9);
    }

    #[test]
    fn numbers_read_as_in_print() {
        assert_eq!(with_unit(0.0727, "N/m", 3), "72.7 mN/m");
        assert_eq!(with_unit(-1.5e-6, "m/s", 2), "−1.5 µm/s");
        assert_eq!(with_unit(0.0, "m", 3), "0 m");
        assert_eq!(with_unit(3.1e-17, "m", 2), "3.1 × 10⁻¹⁷ m");
        assert_eq!(with_unit(2.5e-9, "m^2", 2), "2.5 × 10⁻⁹ m²");
        assert_eq!(with_unit(f64::NAN, "m", 3), "not a number m");
        assert_eq!(significant(0.012_345, 3), "0.0123");
        assert_eq!(significant(1.0e-9, 2), "1.0 × 10⁻⁹");
        assert_eq!(significant(-12_345.6, 4), "−12346");
        assert_eq!(significant(f64::NEG_INFINITY, 4), "−∞");
    }

    #[test]
    fn the_uncertainty_sets_the_last_digit() {
        assert_eq!(
            with_uncertainty(0.072_413_9, 3.5e-4, "N/m"),
            "72.41 ± 0.35 mN/m"
        );
        assert_eq!(with_uncertainty(0.9961, 0.0042, ""), "0.9961 ± 0.0042");
        assert_eq!(
            with_uncertainty(2e-12, 1e-13, "m^2"),
            "(2.00 ± 0.10) × 10⁻¹² m²"
        );
        assert_eq!(with_uncertainty(0.5, 0.0, "s"), "500.0 ms");
        assert_eq!(with_uncertainty(1e-5, 2e-3, "s"), "0.0 ± 2.0 ms");
    }
}
