//! How far a drop spreads that hits a wall.

use meniscus::scheme::Adhesion;
use meniscus::{Vector, theory};
use meniscus_case::Case;
use meniscus_output::Series;

use super::{Findings, exact, window};
use crate::numbers::effective_viscosity;

/// Largest width over the drop's diameter; in 3D, for a drop that moves, beside what correlations say of its
/// Weber and Reynolds numbers at the start, artificial viscosity counted.
pub(super) fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let (Some(_), Some(body)) = (case.measure.spreading, case.bodies.first()) else {
        return;
    };
    let Some((time, width)) = window(series, "spread", 0.0, case.end_time) else {
        return;
    };
    let widest = (0..width.len())
        .filter(|&k| width[k].is_finite())
        .max_by(|&a, &b| width[a].total_cmp(&width[b]));
    let Some(widest) = widest else {
        findings
            .complaints
            .push("no spreading: the series has no width".into());
        return;
    };
    let diameter = 2.0 * theory::equivalent_radius(body.volume, case.dimension);
    let factor = exact(width[widest] / diameter);
    let fluid = &case.fluids[body.fluid];
    let particles = case.particles::<3>();
    let speed = (particles.iter().find(|p| p.body == 0))
        .map_or(Vector::ZERO, |particle| particle.velocity)
        .norm();
    let weber = fluid.density * speed * speed * diameter / fluid.surface_tension;
    let reynolds = speed * diameter / effective_viscosity(case, body.fluid);
    let sound = case.dimension == 3 && weber.is_finite() && reynolds.is_finite() && speed > 0.0;
    let name = "largest width over the drop's diameter";
    if !sound {
        findings.add("spread-factor", name, "", None, factor);
    } else {
        let laan = theory::spreading_laan(weber, reynolds);
        findings.add(
            "spread-factor",
            name,
            "",
            Some(("Laan et al. 2014", laan)),
            factor,
        );
        let roisman = theory::spreading_roisman(weber, reynolds);
        let beside = Some(("Roisman 2009", roisman));
        findings.add("spread-factor-roisman", "the same", "", beside, factor);
        let angle = (case.scheme.walls.iter()).find_map(|wall| match wall.adhesion {
            Adhesion::ContactAngle(angle) => Some(angle),
            _ => None,
        });
        if let Some(angle) = angle {
            let found = theory::spreading_pasandideh_fard(weber, reynolds, angle);
            let beside = Some(("Pasandideh-Fard et al. 1996", found));
            findings.add(
                "spread-factor-pasandideh-fard",
                "the same",
                "",
                beside,
                factor,
            );
        }
    }
    let name = "time of the largest width";
    findings.add("spread-time", name, "s", None, exact(time[widest]));
}
