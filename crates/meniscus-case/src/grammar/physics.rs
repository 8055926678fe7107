//! What is solved.

use std::ops::Range;

use meniscus::scheme::{
    AdaptiveSmoothing, BodyForce, DensityDiffusion, DensityForm, DiffusionForm, Integrator,
    PressureForm, SurfaceTension, TimeStep, ViscosityForm,
};

use super::motion::swing;
use super::surface_tension::SURFACE_TENSION;
use crate::read::{Choice, Context, Node, Sign};
use crate::units;

/// The choices of a scheme that are physics.
pub(crate) struct Physics {
    pub density: DensityForm,
    pub adaptive_smoothing: Option<AdaptiveSmoothing>,
    /// Where it stands.
    pub adaptive_smoothing_span: Range<usize>,
    pub density_diffusion: Option<DensityDiffusion>,
    pub pressure: PressureForm,
    pub artificial_viscosity: f64,
    pub viscosity: ViscosityForm,
    pub body_force: Option<BodyForce>,
    pub velocity_smoothing: f64,
    pub surface_tension: Option<SurfaceTension>,
    /// Where the model of surface tension stands.
    pub surface_tension_span: Range<usize>,
    pub damping: f64,
    pub integrator: Integrator,
    pub time_step: TimeStep,
}

/// The model of surface tension where a case names none: that which takes sigma and contact angle for one liquid,
/// and knows no other fluid.
fn usual_model(context: &Context) -> &'static str {
    match context {
        _ if context.describing => "'capillary-pressure'",
        _ if context.van_der_waals.get() || !context.has_surface_tension.get() => "'none'",
        _ if context.fluids.get() > 1 => "'continuum'",
        _ => "'capillary-pressure'",
    }
}

pub(super) fn physics(node: &mut Node<'_>) -> Physics {
    let mut surface_tension_span = 0..0;
    let mut adaptive_smoothing_span = 0..0;
    let context = node.context;
    let own = node.context.van_der_waals.get();
    let or_own = |usual: &'static str, of_own: &'static str| if own { of_own } else { usual };
    node.table(|fields| {
        let surface_tension = fields.or(
            "surface_tension",
            usual_model(context),
            "Model of surface tension, where a fluid has any.",
            |node| {
                surface_tension_span = node.span();
                node.choice("surface tension model", SURFACE_TENSION)
            },
        );
        // What a model needs to be what it promises.
        let balanced = matches!(surface_tension, Some(SurfaceTension::Balanced(_)));
        let capillary = matches!(surface_tension, Some(SurfaceTension::CapillaryPressure(_)));
        let or_model = |usual: &'static str, of_balanced, of_capillary| {
            if balanced {
                of_balanced
            } else if capillary {
                of_capillary
            } else {
                usual
            }
        };
        Physics {
            density: fields.or(
                "density",
                or_model(
                    or_own("'continuity'", "'summation'"),
                    "'corrected'",
                    "'continuity'",
                ),
                "How density is found.",
                |node| {
                    let names = [
                        ("continuity", DensityForm::Continuity),
                        ("number", DensityForm::Number),
                        ("corrected", DensityForm::Corrected),
                        ("summation", DensityForm::Summation),
                    ];
                    node.name_of("density form", &names)
                },
            ),
            adaptive_smoothing: fields.optional(
                "adaptive_smoothing",
                "Smoothing lengths that follow density, by adaptive kernel estimation.",
                |node| {
                    adaptive_smoothing_span = node.span();
                    adaptive_smoothing(node)
                },
            ),
            adaptive_smoothing_span: adaptive_smoothing_span.clone(),
            density_diffusion: fields.or(
                "density_diffusion",
                "'none'",
                "Diffusion of density, against noise of pressure.",
                |node| node.choice("density diffusion", DENSITY_DIFFUSION),
            ),
            pressure: fields.or(
                "pressure",
                or_model(
                    "'over-density-squared'",
                    "'over-density-product'",
                    "'over-density-product'",
                ),
                "Form of the pressure gradient.",
                |node| {
                    let names = [
                        ("over-density-squared", PressureForm::OverDensitySquared),
                        ("over-density-product", PressureForm::OverDensityProduct),
                        ("hu-adams", PressureForm::HuAdams),
                    ];
                    node.name_of("pressure form", &names)
                },
            ),
            artificial_viscosity: fields.or(
                "artificial_viscosity",
                or_model(or_own("0.1", "0.0"), "0.1", "0.0"),
                "alpha of the artificial viscosity.",
                |node| node.number(Sign::NotNegative),
            ),
            viscosity: fields.or(
                "viscosity",
                or_model(
                    or_own("'monaghan-cleary'", "'stress'"),
                    "'stress'",
                    "'stress-and-rest'",
                ),
                "Form of the viscous force, where a fluid has viscosity.",
                |node| {
                    let names = [
                        ("monaghan-cleary", ViscosityForm::MonaghanCleary),
                        ("morris", ViscosityForm::Morris),
                        ("stress", ViscosityForm::Stress),
                        ("stress-and-rest", ViscosityForm::StressAndRest),
                    ];
                    node.name_of("viscosity form", &names)
                },
            ),
            velocity_smoothing: fields.or(
                "velocity_smoothing",
                "0.0",
                "epsilon of XSPH: particles move with their surroundings.",
                velocity_smoothing,
            ),
            surface_tension,
            surface_tension_span: surface_tension_span.clone(),
            body_force: fields.optional(
                "body_force",
                "Acceleration of gravity or of the frame: a vector, or one that changes with time.",
                |node| {
                    node.either(
                        node.is_list(),
                        |node| BodyForce::Constant(node.vector(&units::ACCELERATION, Sign::Any)),
                        |node| node.choice("body force", BODY_FORCE),
                    )
                },
            ),
            damping: fields.or(
                "damping",
                "'0 /s'",
                "Rate of a drag that brings a flow to rest.",
                |node| node.quantity(&units::RATE, Sign::NotNegative),
            ),
            integrator: fields.or(
                "integrator",
                "'symplectic'",
                "How the flow is marched in time.",
                |node| node.name_of("integrator", &[("symplectic", Integrator::Symplectic)]),
            ),
            time_step: fields.or(
                "time_step",
                "'adaptive'",
                "\"adaptive\", or a fixed time step.",
                |node| {
                    node.either(
                        node.is_quantity(),
                        |node| TimeStep::Fixed(node.quantity(&units::TIME, Sign::Positive)),
                        |node| node.choice("time step", TIME_STEP),
                    )
                },
            ),
        }
    })
}

fn adaptive_smoothing(node: &mut Node<'_>) -> AdaptiveSmoothing {
    node.table(|fields| AdaptiveSmoothing {
        k: fields.or("k", "0.9", "Factor on all smoothing lengths.", |node| {
            node.number(Sign::Positive)
        }),
        epsilon: fields.or(
            "epsilon",
            "0.6",
            "Power of density that lengths fall with, 0 to 1.",
            |node| {
                let epsilon = node.number(Sign::NotNegative);
                if epsilon > 1.0 {
                    node.fail(
                        format!("`epsilon` is {epsilon}"),
                        "more than 1",
                        "0.5 to 0.8 are usual, 0 gives one length for all",
                    );
                }
                epsilon
            },
        ),
        grad_h: fields.or(
            "forces",
            "'plain'",
            "\"grad-h\" conserves energy as lengths change, for two more sums.",
            |node| node.name_of("form of forces", &[("plain", false), ("grad-h", true)]),
        ),
    })
}

fn velocity_smoothing(node: &mut Node<'_>) -> f64 {
    let strength = node.number(Sign::NotNegative);
    if strength > 1.0 {
        node.fail(
            format!("`velocity_smoothing` is {strength}"),
            "more than 1",
            "0.3 is usual",
        );
    }
    strength
}

const DENSITY_DIFFUSION: &[Choice<Option<DensityDiffusion>>] = &[
    Choice::new(
        "antuono",
        "delta-SPH, of Antuono and others: all but the linear part of density diffuses.",
        |node| diffusion(node, DiffusionForm::Antuono),
    ),
    Choice::new(
        "fourtakas",
        "All but the density of a liquid at rest under the body force, of Fourtakas and others.",
        |node| diffusion(node, DiffusionForm::Fourtakas),
    ),
    Choice::new(
        "molteni-colagrossi",
        "Of Molteni and Colagrossi; a liquid with weight drifts apart at its surface.",
        |node| diffusion(node, DiffusionForm::MolteniColagrossi),
    ),
    Choice::new("none", "No diffusion.", |node| node.table(|_| None)),
];

fn diffusion(node: &mut Node<'_>, form: DiffusionForm) -> Option<DensityDiffusion> {
    node.table(|fields| {
        let strength = fields.or("strength", "0.1", "delta, at most 0.5.", |node| {
            let strength = node.number(Sign::NotNegative);
            if strength > DensityDiffusion::STRONGEST {
                node.fail(
                    format!("`strength` is {strength}"),
                    format!("more than {}", DensityDiffusion::STRONGEST),
                    "0.1 is usual; much more is unstable",
                );
            }
            strength
        });
        Some(DensityDiffusion { form, strength })
    })
}

const BODY_FORCE: &[Choice<BodyForce>] = &[
    Choice::new(
        "oscillating",
        "mean + amplitude sin(2 pi frequency t + phase)",
        |node| {
            let dimension = node.context.dimension.get().unwrap_or(2);
            let zero = format!("[{}]", vec!["'0 m/s^2'"; dimension].join(", "));
            node.table(|fields| {
                let mean = fields.or("mean", &zero, "The constant part.", |node| {
                    node.vector(&units::ACCELERATION, Sign::Any)
                });
                let about = "The oscillating part.";
                let (amplitude, frequency, phase) = swing(fields, &units::ACCELERATION, about);
                BodyForce::Oscillating {
                    mean,
                    amplitude,
                    frequency,
                    phase,
                }
            })
        },
    ),
    Choice::new("table", "Straight lines between given times.", |node| {
        let rows = node.list(1, |node| {
            node.table(|fields| {
                let time = fields.required("time", "When.", |node| {
                    node.quantity(&units::TIME, Sign::Any)
                });
                let acceleration = fields.required("acceleration", "How much.", |node| {
                    node.vector(&units::ACCELERATION, Sign::Any)
                });
                (time, acceleration)
            })
        });
        if rows.windows(2).any(|pair| pair[1].0 <= pair[0].0) {
            node.fail(
                "times of a table must increase".into(),
                "a time is not after the one before it",
                "sort the rows",
            );
        }
        BodyForce::Table(rows)
    }),
];

const TIME_STEP: &[Choice<TimeStep>] = &[Choice::new(
    "adaptive",
    "The shortest of the acoustic, force, viscous and capillary limits.",
    |node| {
        node.table(|fields| TimeStep::Adaptive {
            safety: fields.or(
                "safety",
                "1.0",
                "Factor on all limits, at most 1.",
                |node| {
                    let safety = node.number(Sign::Positive);
                    if safety > 1.0 {
                        node.fail(
                            format!("`safety` is {safety}"),
                            "more than 1",
                            "a step above its limits is unstable",
                        );
                    }
                    safety
                },
            ),
        })
    },
)];
