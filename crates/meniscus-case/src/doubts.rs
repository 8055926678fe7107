//! What can be run, but not believed: warnings about a case that is in order.

use std::ops::Range;

use meniscus::physics::surface_tension::continuum::Form;
use meniscus::scheme::{DensityForm, SurfaceTension};

use crate::diagnostic::{Diagnostic, Severity};
use crate::grammar::Draft;

/// Spacings to the radius below which the layer that curvature is read in fills a body.
const FINE_ENOUGH: f64 = 8.0;
/// No liquid has more surface tension than this, N/m; liquid metals come near.
const STRONGEST_TENSION: f64 = 3.0;

/// Warnings about a case. `volumes` holds fluid and volume of each body.
pub(crate) fn doubts(draft: &Draft, volumes: &[(usize, f64)]) -> Vec<Diagnostic> {
    let doubt =
        |span: Option<Range<usize>>, message: String, label: String, help: &str| Diagnostic {
            severity: Severity::Warning,
            message,
            label,
            help: Some(help.into()),
            span,
        };
    let mut doubts = Vec::new();
    let model = matches!(
        draft.physics.surface_tension,
        Some(SurfaceTension::JancikHyhlik(_))
    );
    for (body, &(fluid, volume)) in draft.bodies.iter().zip(volumes) {
        let radius = meniscus::theory::equivalent_radius(volume, draft.dimension) / draft.spacing;
        let tension = draft
            .fluids
            .get(fluid)
            .is_some_and(|draft| draft.fluid.surface_tension > 0.0);
        if model && tension && radius < FINE_ENOUGH {
            doubts.push(doubt(
                Some(body.shape_span.clone()),
                format!("surface tension will be too strong: {radius:.1} spacings to the radius"),
                "coarse for its size".into(),
                "at 10 spacings pressure at rest is 22 % high, at 20 it is 7 %, at 40 it is 1 %; take a finer spacing",
            ));
        }
        if model && tension && body.geometry.jitter() > 0.0 {
            doubts.push(doubt(
                Some(body.shape_span.clone()),
                "a jittered start disturbs this model of surface tension".into(),
                format!("jitter {}", body.geometry.jitter()),
                "at a jitter of 0.05 a drop measured 6 % less surface tension, and drifted; leave jitter out",
            ));
        }
    }
    if let Some(SurfaceTension::Continuum(continuum)) = draft.physics.surface_tension
        && continuum.form == Form::Stress
        && (draft.fluids.iter()).all(|draft| draft.fluid.surface_tension > 0.0)
    {
        doubts.push(doubt(
            Some(draft.physics.surface_tension_span.clone()),
            "surface tension as a stress pulls the particles of a free surface together".into(),
            String::new(),
            "it is meant for the surface between two fluids; take form = \"balanced\"",
        ));
    }
    for fluid in &draft.fluids {
        let sigma = fluid.fluid.surface_tension;
        if sigma > STRONGEST_TENSION {
            doubts.push(doubt(
                fluid.surface_tension_span.clone(),
                format!("this surface tension is {sigma} N/m"),
                "stronger than any liquid's".into(),
                "a number without a unit is in N/m; water has 0.0728 N/m, or \"72.8 mN/m\"",
            ));
        }
    }
    let open = draft.periodic[..draft.dimension]
        .iter()
        .any(Option::is_none);
    let dense = (draft.fluids.iter()).all(|draft| draft.van_der_waals.is_none());
    if draft.physics.density == DensityForm::Summation && open && dense {
        doubts.push(doubt(
            None,
            "density by summation is too low within a smoothing length of a free surface".into(),
            String::new(),
            "it is meant for domains filled on all sides; take density = \"continuity\"",
        ));
    }
    doubts
}
