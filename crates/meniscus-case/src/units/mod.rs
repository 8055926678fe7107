//! Quantities with their units: "72.7 mN/m", "1 mPa s", "1000 kg/m³", "1.5 dx".
//!
//! A small table, and not a units library, because a case file needs what
//! those do not give: an angle is not a bare number, `dx` is a length that the
//! case itself defines, and every wrong unit is answered by the right one.
//! Decimal prefixes are applied to the digits as written, so that "0.05 mm"
//! and "5e-5 m" are the same double.
//!
//! - `kind`: lengths, times, densities, ...
//! - `table`: the units
//! - `parse`: reading a number and its unit

mod kind;
mod parse;
mod table;

#[cfg(test)]
mod tests;

pub(crate) use kind::*;
pub(crate) use parse::{Quantity, QuantityError, parse};
