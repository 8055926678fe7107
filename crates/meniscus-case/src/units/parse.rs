//! Reading a number and its unit.

use super::kind::{Dimension, LENGTH};
use super::table::{look_up, nearest_unit};

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
    Unit {
        found: String,
        nearest: Option<String>,
    },
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
        return Err(if endless {
            QuantityError::NotFinite
        } else {
            QuantityError::Number
        });
    }
    let mut total = Scale {
        dimension: [0; 6],
        exponent: 0,
        factor: 1.0,
    };
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
    Ok(Quantity {
        value,
        dimension: total.dimension,
    })
}

/// Bytes of the number that the text starts with.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let count = |from: usize| {
        bytes[from..]
            .iter()
            .take_while(|b| b.is_ascii_digit())
            .count()
    };
    let mut end = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let whole = count(end);
    end += whole;
    let mut fraction = 0;
    if bytes.get(end) == Some(&b'.') {
        fraction = count(end + 1);
        // "5." is a number, "." is none.
        end += if whole + fraction > 0 {
            1 + fraction
        } else {
            0
        };
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
    fn multiply_by_expression(
        &mut self,
        text: &str,
        spacing: Option<f64>,
    ) -> Result<(), QuantityError> {
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
                let length = rest
                    .find(|c: char| !(c.is_alphabetic() || c == '°'))
                    .unwrap_or(rest.len());
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
        if factor_due {
            Err(QuantityError::Syntax(text.trim().into()))
        } else {
            Ok(())
        }
    }

    fn multiply(
        &mut self,
        name: &str,
        power: i32,
        spacing: Option<f64>,
    ) -> Result<(), QuantityError> {
        if name == "1" {
            return Ok(());
        }
        let (dimension, exponent, factor) = if name == "dx" {
            (LENGTH.dimension, 0, spacing.ok_or(QuantityError::Spacing)?)
        } else {
            let (unit, prefix) = look_up(name).ok_or_else(|| QuantityError::Unit {
                found: name.into(),
                nearest: nearest_unit(name),
            })?;
            (unit.dimension, unit.exponent + prefix, unit.factor)
        };
        for (sum, one) in self.dimension.iter_mut().zip(dimension) {
            *sum += one * power;
        }
        self.exponent += exponent * power;
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
            c => SUPERSCRIPTS
                .chars()
                .position(|s| s == c)
                .and_then(|d| char::from_digit(d as u32, 10)),
        })
        .collect();
    let (digits, rest) = if !plain.is_empty() {
        let length = text
            .chars()
            .take(plain.chars().count())
            .map(char::len_utf8)
            .sum();
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
