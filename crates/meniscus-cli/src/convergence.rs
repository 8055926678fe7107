//! How fast the deviation of a number from theory falls with resolution.

use serde::Deserialize;

use crate::regression::line;
use crate::reproduce::Number;

/// Numbers of one quantity at several resolutions.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Convergence {
    id: String,
    about: String,
    /// Ids of the numbers.
    numbers: Vec<String>,
    /// Resolution of each, such as spacings to the radius.
    resolution: Vec<f64>,
    /// How far from the order of the published numbers still counts as the same.
    tolerance: f64,
}

impl Convergence {
    /// The order of convergence as a number of its own, published and
    /// computed, from `numbers` with the values computed for them.
    ///
    /// # Errors
    /// If the group names a number that there is not, or has not one
    /// resolution for each.
    pub fn judge(
        &self,
        numbers: &[(&Number, Option<f64>)],
    ) -> Result<(Number, Option<f64>), String> {
        let mut members = Vec::new();
        for id in &self.numbers {
            let found = numbers.iter().find(|(number, _)| number.id == *id);
            members
                .push(*found.ok_or_else(|| format!("{}: there is no number \"{id}\"", self.id))?);
        }
        if members.len() != self.resolution.len() || members.len() < 2 {
            return Err(format!(
                "{}: {} numbers with {} resolutions; needed are at least two, and one resolution for each",
                self.id,
                members.len(),
                self.resolution.len()
            ));
        }
        let order = |deviations: Option<Vec<f64>>| order(&self.resolution, &deviations?);
        let published = members
            .iter()
            .map(|(number, _)| Some(number.published? - number.theory?));
        let computed = members
            .iter()
            .map(|(number, value)| Some((*value)? - number.theory?));
        let number = Number {
            published: order(published.collect()),
            ..Number::derived(&self.id, &self.about, self.tolerance)
        };
        Ok((number, order(computed.collect())))
    }
}

/// Minus the slope of ln |deviation| over ln resolution, by least squares.
fn order(resolution: &[f64], deviations: &[f64]) -> Option<f64> {
    let points: Vec<(f64, f64)> = resolution
        .iter()
        .zip(deviations)
        .map(|(r, d)| (r.ln(), d.abs().ln()))
        .collect();
    line(&points).map(|(slope, _)| -slope)
}

#[cfg(test)]
mod tests {
    use super::order;

    #[test]
    fn the_order_of_a_power_is_its_exponent() {
        let resolution = [10.0, 14.0, 25.0];
        let deviations = resolution.map(|r: f64| -3.0 * r.powf(-1.7));
        assert!(order(&resolution, &deviations).is_some_and(|p| (p - 1.7).abs() < 1e-12));
        // One resolution says nothing.
        assert!(order(&[10.0, 10.0], &[0.1, 0.2]).is_none());
    }
}
