//! A straight line through a number of several drops, over the inverse of their radii. Of the pressure
//! inside, by Laplace, its slope is the surface tension in 2D, and half of it is in 3D; its offset is
//! the pressure that does not depend on size.

use serde::Deserialize;

use crate::reproduce::Number;

/// The finding of a case that is its drop's radius, m.
const RADIUS: &str = "equivalent-radius";

/// Numbers of several cases that should lie on a line.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Regression {
    id: String,
    about: String,
    /// Ids of the numbers; the radii are the `equivalent-radius` of their cases.
    numbers: Vec<String>,
    /// What of the line is asked for.
    part: Part,
    published: Option<f64>,
    theory: Option<f64>,
    /// How far from the published value, or else from theory's, still counts as the same.
    tolerance: f64,
    /// Why it is known to differ, where it does.
    differs: Option<String>,
}

/// A number of a line y = offset + slope / R.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
enum Part {
    Slope,
    Offset,
}

impl Regression {
    /// The slope or offset as a number of its own, and its value, from `numbers` with the values
    /// computed for them and `finding`, which has those of a case by name.
    ///
    /// # Errors
    /// If the group names a number that there is not, or fewer than three.
    pub fn judge(
        &self,
        numbers: &[(&Number, Option<f64>)],
        finding: impl Fn(&str, &str) -> Option<f64>,
    ) -> Result<(Number, Option<f64>), String> {
        let mut points = Vec::new();
        for id in &self.numbers {
            let found = numbers.iter().find(|(number, _)| number.id == *id);
            let (number, value) =
                found.ok_or_else(|| format!("{}: there is no number \"{id}\"", self.id))?;
            let radius = finding(&number.case, RADIUS);
            points.push(
                radius
                    .zip(*value)
                    .map(|(radius, value)| (1.0 / radius, value)),
            );
        }
        if points.len() < 3 {
            return Err(format!(
                "{}: a line needs at least three numbers, found {}",
                self.id,
                points.len()
            ));
        }
        let points: Option<Vec<_>> = points.into_iter().collect();
        let line = points.and_then(|points| line(&points));
        let number = Number {
            published: self.published,
            theory: self.theory,
            differs: self.differs.clone(),
            ..Number::derived(&self.id, &self.about, self.tolerance)
        };
        let value = line.map(|(slope, offset)| match self.part {
            Part::Slope => slope,
            Part::Offset => offset,
        });
        Ok((number, value))
    }
}

/// Slope and offset of the line of least squares; none through points of one abscissa.
pub fn line(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let count = points.len() as f64;
    let mean = |pick: fn(&(f64, f64)) -> f64| points.iter().map(pick).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let variance: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    let slope = covariance / variance;
    slope.is_finite().then_some((slope, y - slope * x))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(id: &str) -> Number {
        Number {
            case: id.into(),
            ..Number::derived(id, "", 0.0)
        }
    }

    #[test]
    fn pressures_of_three_drops_have_laplaces_slope_over_what_they_share() {
        let drops = [("a", 1.0), ("b", 2.0), ("c", 4.0)];
        let kept: Vec<Number> = drops.iter().map(|(id, _)| number(id)).collect();
        let numbers: Vec<_> = (kept.iter().zip(drops))
            .map(|(number, (_, radius))| (number, Some(5.0 + 0.3 / radius)))
            .collect();
        let radius = |case: &str, finding: &str| {
            assert_eq!(finding, "equivalent-radius");
            Some(drops.iter().find(|(id, _)| *id == case)?.1)
        };
        let group = |ids: &[&str], part| Regression {
            id: "line".into(),
            about: String::new(),
            numbers: ids.iter().map(|&id| id.to_owned()).collect(),
            part,
            published: None,
            theory: None,
            tolerance: 0.0,
            differs: None,
        };
        let all = ["a", "b", "c"];
        let slope = group(&all, Part::Slope).judge(&numbers, radius);
        assert!(slope.is_ok_and(|found| (found.1.unwrap_or(0.0) - 0.3).abs() < 1e-12));
        let offset = group(&all, Part::Offset).judge(&numbers, radius);
        assert!(offset.is_ok_and(|found| (found.1.unwrap_or(0.0) - 5.0).abs() < 1e-12));
        // A case that failed leaves no line; two numbers are no regression, a misspelt one is none.
        let none = group(&all, Part::Slope).judge(&numbers, |_, _| None);
        assert!(none.is_ok_and(|found| found.1.is_none()));
        assert!(
            group(&all[..2], Part::Slope)
                .judge(&numbers, radius)
                .is_err()
        );
        assert!(
            group(&["a", "b", "d"], Part::Slope)
                .judge(&numbers, radius)
                .is_err()
        );
    }
}
