//! Quantities with their units: "72.7 mN/m", "1 mPa s", "1000 kg/m³", "1.5 dx".
//!
//! A small table, and not a units library, because a case file needs what
//! those do not give: an angle is not a bare number, `dx` is a length that the
//! case itself defines, and every wrong unit is answered by the right one.
//! Decimal prefixes are applied to the digits as written, so that "0.05 mm"
//! and "5e-5 m" are the same double.

use std::f64::consts::PI;

/// Exponents of metre, kilogram, second and radian.
pub(crate) type Dimension = [i32; 4];

/// A kind of quantity that a case file holds.
#[derive(Debug, PartialEq)]
pub(crate) struct Kind {
    /// "length"
    pub name: &'static str,
    pub dimension: Dimension,
    /// The SI unit, in which a bare number is read.
    pub si: &'static str,
    /// How one is written.
    pub example: &'static str,
}

macro_rules! kinds {
    ($($constant:ident $name:literal $dimension:tt $si:literal $example:literal)*) => {
        $(pub(crate) const $constant: Kind =
            Kind { name: $name, dimension: $dimension, si: $si, example: $example };)*
        /// All kinds, to name what was found.
        const KINDS: &[Kind] = &[$($constant),*];
    };
}

kinds! {
    LENGTH              "length"              [1, 0, 0, 0]   "m"       "0.05 mm"
    TIME                "time"                [0, 0, 1, 0]   "s"       "25 ms"
    MASS                "mass"                [0, 1, 0, 0]   "kg"      "1 g"
    ANGLE               "angle"               [0, 0, 0, 1]   "rad"     "45 deg"
    NUMBER              "number"              [0, 0, 0, 0]   "1"       "0.5"
    RATE                "rate"                [0, 0, -1, 0]  "1/s"     "4000 /s"
    SPEED               "speed"               [1, 0, -1, 0]  "m/s"     "5 m/s"
    ANGULAR_VELOCITY    "angular velocity"    [0, 0, -1, 1]  "rad/s"   "10 rad/s"
    ACCELERATION        "acceleration"        [1, 0, -2, 0]  "m/s^2"   "9.81 m/s^2"
    DENSITY             "density"             [-3, 1, 0, 0]  "kg/m^3"  "1000 kg/m^3"
    PRESSURE            "pressure"            [-1, 1, -2, 0] "Pa"      "100 Pa"
    SURFACE_TENSION     "surface tension"     [0, 1, -2, 0]  "N/m"     "72.7 mN/m"
    VISCOSITY           "dynamic viscosity"   [-1, 1, -1, 0] "Pa s"    "1 mPa s"
    KINEMATIC_VISCOSITY "kinematic viscosity" [2, 0, -1, 0]  "m^2/s"   "1 mm^2/s"
    FORCE               "force"               [1, 1, -2, 0]  "N"       "1 mN"
    ENERGY              "energy"              [2, 1, -2, 0]  "J"       "1 uJ"
    AREA                "area"                [2, 0, 0, 0]   "m^2"     "1 mm^2"
    VOLUME              "volume"              [3, 0, 0, 0]   "m^3"     "1 mm^3"
}

/// "a length", "an angle", or the base units of something without a name.
pub(crate) fn name_of(dimension: Dimension) -> String {
    if let Some(kind) = KINDS.iter().find(|kind| kind.dimension == dimension) {
        return with_article(kind.name);
    }
    let units: Vec<String> = ["m", "kg", "s", "rad"]
        .iter()
        .zip(dimension)
        .filter(|(_, exponent)| *exponent != 0)
        .map(|(unit, exponent)| if exponent == 1 { unit.to_string() } else { format!("{unit}^{exponent}") })
        .collect();
    format!("in {}", units.join(" "))
}

/// "a length", "an angle".
pub(crate) fn with_article(name: &str) -> String {
    let article = if name.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
    format!("{article} {name}")
}

/// A unit that may stand in a quantity: its value is `factor` times ten to the
/// power `exponent`, in SI.
struct Unit {
    name: &'static str,
    dimension: Dimension,
    exponent: i32,
    factor: f64,
    prefixed: bool,
}

const fn unit(name: &'static str, dimension: Dimension, exponent: i32, factor: f64, prefixed: bool) -> Unit {
    Unit { name, dimension, exponent, factor, prefixed }
}

const UNITS: &[Unit] = &[
    unit("m", LENGTH.dimension, 0, 1.0, true),
    unit("g", MASS.dimension, -3, 1.0, true),
    unit("s", TIME.dimension, 0, 1.0, true),
    unit("rad", ANGLE.dimension, 0, 1.0, true),
    unit("N", FORCE.dimension, 0, 1.0, true),
    unit("Pa", PRESSURE.dimension, 0, 1.0, true),
    unit("J", ENERGY.dimension, 0, 1.0, true),
    unit("W", [2, 1, -3, 0], 0, 1.0, true),
    unit("Hz", RATE.dimension, 0, 1.0, true),
    unit("P", VISCOSITY.dimension, -1, 1.0, true),
    unit("St", KINEMATIC_VISCOSITY.dimension, -4, 1.0, true),
    unit("bar", PRESSURE.dimension, 5, 1.0, true),
    unit("dyn", FORCE.dimension, -5, 1.0, true),
    unit("L", VOLUME.dimension, -3, 1.0, true),
    unit("l", VOLUME.dimension, -3, 1.0, true),
    unit("min", TIME.dimension, 0, 60.0, false),
    unit("h", TIME.dimension, 0, 3600.0, false),
    unit("deg", ANGLE.dimension, 0, PI / 180.0, false),
    unit("°", ANGLE.dimension, 0, PI / 180.0, false),
    unit("rpm", ANGULAR_VELOCITY.dimension, 0, PI / 30.0, false),
];

const PREFIXES: &[(&str, i32)] = &[
    ("n", -9),
    ("u", -6),
    ("µ", -6),
    ("μ", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
];

/// A value in SI and what it measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quantity {
    pub value: f64,
    pub dimension: Dimension,
}

/// Why a text is not a quantity.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum QuantityError {
    /// It does not start with a number.
    Number,
    /// The number is too large for a double, or written as not finite.
    NotFinite,
    /// No such unit; the nearest that there is.
    Unit { found: String, nearest: Option<String> },
    /// The unit cannot be read from here on.
    Syntax(String),
    /// `dx` before the spacing is known.
    Spacing,
}

/// Reads a number and its unit. A unit `dx` stands for `spacing`, where one is known.
pub(crate) fn parse(text: &str, spacing: Option<f64>) -> Result<Quantity, QuantityError> {
    let text = text.trim();
    let digits = number_length(text);
    let (number, unit) = text.split_at(digits);
    if number.is_empty() {
        let word = text.trim_start_matches(['+', '-']).to_ascii_lowercase();
        let endless = word.starts_with("inf") || word.starts_with("nan");
        return Err(if endless { QuantityError::NotFinite } else { QuantityError::Number });
    }
    let mut total = Scale { dimension: [0; 4], exponent: 0, factor: 1.0 };
    total.multiply_by_expression(unit, spacing)?;

    // Let the decimal prefix join the digits before they are rounded.
    let (mantissa, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let exponent: i32 = exponent.parse().map_err(|_| QuantityError::NotFinite)?;
    let value: f64 = format!("{mantissa}e{}", exponent.saturating_add(total.exponent))
        .parse()
        .map_err(|_| QuantityError::Number)?;
    let value = value * total.factor;
    if !value.is_finite() {
        return Err(QuantityError::NotFinite);
    }
    Ok(Quantity { value, dimension: total.dimension })
}

/// Bytes of the number that the text starts with.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let count = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let mut end = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let whole = count(end);
    end += whole;
    let mut fraction = 0;
    if bytes.get(end) == Some(&b'.') {
        fraction = count(end + 1);
        // "5." is a number, "." is none.
        end += if whole + fraction > 0 { 1 + fraction } else { 0 };
    }
    if whole + fraction == 0 {
        return 0;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let power = count(end + 1 + sign);
        if power > 0 {
            end += 1 + sign + power;
        }
    }
    end
}

struct Scale {
    dimension: Dimension,
    exponent: i32,
    factor: f64,
}

impl Scale {
    /// Units joined by a space, `*`, `.` or `·`, or by `/` for the one that follows.
    fn multiply_by_expression(&mut self, text: &str, spacing: Option<f64>) -> Result<(), QuantityError> {
        let mut rest = text.trim_start();
        let mut sign = 1;
        let mut factor_due = false;
        while !rest.is_empty() {
            if let Some(after) = rest.strip_prefix('/') {
                if factor_due {
                    return Err(QuantityError::Syntax(rest.into()));
                }
                (sign, factor_due, rest) = (-1, true, after.trim_start());
            } else if let Some(after) = rest.strip_prefix(['*', '.', '·', '⋅']) {
                if factor_due {
                    return Err(QuantityError::Syntax(rest.into()));
                }
                (factor_due, rest) = (true, after.trim_start());
            } else {
                let length = rest.find(|c: char| !(c.is_alphabetic() || c == '°')).unwrap_or(rest.len());
                let (name, after) = rest.split_at(length);
                // The 1 of "4000 1/s".
                let (name, after) = match after.strip_prefix('1') {
                    Some(after) if name.is_empty() => ("1", after),
                    _ => (name, after),
                };
                if name.is_empty() {
                    return Err(QuantityError::Syntax(rest.into()));
                }
                let (power, after) = power(after)?;
                self.multiply(name, sign * power, spacing)?;
                (sign, factor_due, rest) = (1, false, after.trim_start());
            }
        }
        if factor_due { Err(QuantityError::Syntax(text.trim().into())) } else { Ok(()) }
    }

    fn multiply(&mut self, name: &str, power: i32, spacing: Option<f64>) -> Result<(), QuantityError> {
        if name == "1" {
            return Ok(());
        }
        let (unit, prefix, factor) = if name == "dx" {
            (&UNITS[0], 0, spacing.ok_or(QuantityError::Spacing)?)
        } else {
            let (unit, prefix) = look_up(name)
                .ok_or_else(|| QuantityError::Unit { found: name.into(), nearest: nearest_unit(name) })?;
            (unit, prefix, unit.factor)
        };
        for (sum, exponent) in self.dimension.iter_mut().zip(unit.dimension) {
            *sum += exponent * power;
        }
        self.exponent += (unit.exponent + prefix) * power;
        self.factor *= factor.powi(power);
        Ok(())
    }
}

/// The exponent that a unit is raised to: `^-2`, `**2`, `²`, `2`, or one.
fn power(text: &str) -> Result<(i32, &str), QuantityError> {
    const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    let plain: String = text
        .chars()
        .map_while(|c| match c {
            '⁻' => Some('-'),
            c => SUPERSCRIPTS.chars().position(|s| s == c).and_then(|d| char::from_digit(d as u32, 10)),
        })
        .collect();
    let (digits, rest) = if !plain.is_empty() {
        let length = text.chars().take(plain.chars().count()).map(char::len_utf8).sum();
        (plain, &text[length..])
    } else {
        let (marked, after) = match text.strip_prefix('^').or_else(|| text.strip_prefix("**")) {
            Some(after) => (true, after),
            None => (false, text),
        };
        let sign = usize::from(marked && after.starts_with('-'));
        let length = sign + after[sign..].bytes().take_while(u8::is_ascii_digit).count();
        if length == 0 && !marked {
            return Ok((1, text));
        }
        (after[..length].to_string(), &after[length..])
    };
    match digits.parse() {
        Ok(power) if (-9..=9).contains(&power) => Ok((power, rest)),
        _ => Err(QuantityError::Syntax(text.into())),
    }
}

fn look_up(name: &str) -> Option<(&'static Unit, i32)> {
    if let Some(unit) = UNITS.iter().find(|unit| unit.name == name) {
        return Some((unit, 0));
    }
    PREFIXES.iter().find_map(|(prefix, exponent)| {
        let rest = name.strip_prefix(prefix)?;
        UNITS.iter().find(|unit| unit.prefixed && unit.name == rest).map(|unit| (unit, *exponent))
    })
}

fn nearest_unit(name: &str) -> Option<String> {
    let all = UNITS.iter().flat_map(|unit| {
        let prefixes = if unit.prefixed { PREFIXES } else { &[] };
        std::iter::once(unit.name.to_string())
            .chain(prefixes.iter().map(move |(prefix, _)| format!("{prefix}{}", unit.name)))
    });
    // A wrong capital is the likeliest slip, a wrong letter the next.
    all.filter(|unit| strsim::osa_distance(&unit.to_lowercase(), &name.to_lowercase()) <= 1)
        .min_by_key(|unit| {
            (strsim::osa_distance(&unit.to_lowercase(), &name.to_lowercase()), strsim::osa_distance(unit, name))
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn is(text: &str, kind: &Kind, value: f64) {
        assert_eq!(parse(text, Some(2e-5)), Ok(Quantity { value, dimension: kind.dimension }), "{text}");
    }

    #[test]
    fn every_kind_reads_its_own_example_and_si_unit() {
        for kind in KINDS {
            for text in [kind.example.to_string(), format!("1 {}", kind.si)] {
                assert_eq!(parse(&text, None).unwrap().dimension, kind.dimension, "{text}");
            }
            assert_eq!(parse(&format!("1 {}", kind.si), None).unwrap().value, 1.0);
        }
    }

    #[test]
    fn decimal_prefixes_round_once() {
        // Each is the double nearest the decimal fraction, as if written in SI.
        is("0.05 mm", &LENGTH, 5e-5);
        is("72.7 mN/m", &SURFACE_TENSION, 0.0727);
        is("6us", &TIME, 6e-6);
        is("1e3 mm", &LENGTH, 1.0);
        is("75 µm", &LENGTH, 75e-6);
        is("75 μm", &LENGTH, 75e-6);
        is("998.2 kg/m³", &DENSITY, 998.2);
        is("0.9982 g/cm^3", &DENSITY, 998.2);
        is("-9.81 m/s²", &ACCELERATION, -9.81);
        is("9.81 m s^-2", &ACCELERATION, 9.81);
        is("9.81 m s⁻²", &ACCELERATION, 9.81);
        is(".5 bar", &PRESSURE, 5e4);
        is("20 dyn/cm", &SURFACE_TENSION, 0.02);
    }

    #[test]
    fn one_viscosity_in_many_spellings() {
        for text in ["1 mPa s", "1 mPa.s", "1 mPa·s", "1 mPa*s", "1 cP", "0.001 Pa s", "1e-3 kg/m/s", "1e-2 P"] {
            is(text, &VISCOSITY, 1e-3);
        }
    }

    #[test]
    fn rates_angles_and_spacings() {
        is("4000 /s", &RATE, 4000.0);
        is("4000 1/s", &RATE, 4000.0);
        is("4 kHz", &RATE, 4000.0);
        is("180 deg", &ANGLE, PI);
        is("60 rpm", &ANGULAR_VELOCITY, 2.0 * PI);
        is("1.5 dx", &LENGTH, 1.5 * 2e-5);
        is("3 dx^2", &AREA, 3.0 * (2e-5_f64).powi(2));
        assert_eq!(parse("1 dx", None), Err(QuantityError::Spacing));
        assert_eq!(parse("3", None), Ok(Quantity { value: 3.0, dimension: NUMBER.dimension }));
    }

    #[test]
    fn nonsense_is_refused_with_its_reason() {
        let nearest = |text: &str| match parse(text, None) {
            Err(QuantityError::Unit { nearest, .. }) => nearest,
            other => panic!("{text}: {other:?}"),
        };
        assert_eq!(nearest("1 Mn"), Some("MN".into()));
        assert_eq!(nearest("1 pa"), Some("Pa".into()));
        assert_eq!(nearest("1 hz"), Some("Hz".into()));
        assert_eq!(nearest("1 furlong"), None);
        for text in ["", "mm", "abc", "- 3 m", "."] {
            assert_eq!(parse(text, None), Err(QuantityError::Number), "{text}");
        }
        for text in ["inf", "nan m", "-inf s", "1e999 m"] {
            assert_eq!(parse(text, None), Err(QuantityError::NotFinite), "{text}");
        }
        for text in ["1 m/", "1 /", "1 m//s", "1 m^", "1 m^99", "1 m*/s", "1 m,", "1,5 m", "1 m^2.5", "1 (m)"] {
            assert!(matches!(parse(text, None), Err(QuantityError::Syntax(_))), "{text}: {:?}", parse(text, None));
        }
    }
}
