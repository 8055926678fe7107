//! A drop at rest: its pressure, and what still moves.

use meniscus::measure::Estimate;
use meniscus::theory;
use meniscus_case::{Case, Window};
use meniscus_output::Series;

use super::{Findings, mean, of_first_body};
use crate::sample::asked::OUTSIDE;

/// The pressure inside the first body above that around it, the surface tension that Laplace
/// reads from it, and the parasitic currents.
pub(super) fn measure(case: &Case, series: &Series, findings: &mut Findings) {
    let (Some(asked), Some(body)) = (&case.measure.static_pressure, case.bodies.first()) else {
        return;
    };
    let inside = mean(
        series,
        &of_first_body(case, "inner pressure"),
        &asked.window,
    );
    let outside = match asked.outside {
        Some(_) => mean(series, OUTSIDE.0, &asked.window),
        None => Some(Estimate {
            value: 0.0,
            half_width: 0.0,
        }),
    };
    let (Some(inside), Some(outside)) = (inside, outside) else {
        findings
            .complaints
            .push("no static pressure was measured: the series has none in that time".into());
        return;
    };
    let pressure = Estimate {
        value: inside.value - outside.value,
        half_width: inside.half_width.hypot(outside.half_width),
    };
    let fluid = &case.fluids[body.fluid];
    let radius = theory::equivalent_radius(body.volume, case.dimension);
    let jump = theory::pressure_jump(fluid.surface_tension, radius, case.dimension);
    // Walls bend a surface otherwise.
    let round = case.walls.is_empty();
    let laplace = round.then_some(("Laplace", jump));
    let name = match asked.outside {
        Some(_) => "inner pressure (r < R/2), above that outside",
        None => "inner pressure (r < R/2)",
    };
    findings.add("inner-pressure", name, "Pa", laplace, pressure);
    if let Some(virial) = mean(
        series,
        &of_first_body(case, "inner virial pressure"),
        &asked.window,
    ) {
        let total = Estimate {
            value: pressure.value + virial.value,
            half_width: pressure.half_width.hypot(virial.half_width),
        };
        let name = "the same with the virial of pairs";
        findings.add("inner-total-pressure", name, "Pa", laplace, total);
    }
    let by_forces = of_first_body(case, "inner mechanical pressure");
    if let Some(pressure) = mean(series, &by_forces, &asked.window) {
        let name = "inner pressure by all forces of pairs";
        findings.add("inner-mechanical-pressure", name, "Pa", laplace, pressure);
    }
    let factor = theory::surface_tension_from_pressure(1.0, radius, case.dimension);
    let sigma = Estimate {
        value: pressure.value * factor,
        half_width: pressure.half_width * factor,
    };
    let given = Some(("given", fluid.surface_tension));
    let name = "surface tension by inner pressure";
    if round {
        findings.add("sigma-static", name, "N/m", given, sigma);
    }

    let length = asked.window.to - asked.window.from;
    let before = Window {
        from: (asked.window.from - length).max(0.0),
        to: asked.window.from,
    };
    let scale = (2.0 * radius * fluid.density / fluid.surface_tension).sqrt();
    let mut currents = |id: &str, name: &str, over: &Window| {
        if let Some(speed) = mean(series, "largest speed", over).filter(|_| scale.is_finite()) {
            let speed = Estimate {
                value: speed.value * scale,
                half_width: speed.half_width * scale,
            };
            findings.add(id, name, "", Some(("exact", 0.0)), speed);
        }
    };
    let name = "parasitic currents: largest U sqrt(rho D / sigma)";
    currents("parasitic", name, &asked.window);
    if before.to > before.from {
        currents("parasitic-before", "the same, as long before", &before);
    }
}
