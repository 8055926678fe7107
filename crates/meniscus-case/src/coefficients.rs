//! What a case leaves to be measured, and what was.

use std::collections::BTreeMap;

use meniscus::scheme::Adhesion;

use crate::grammar::Draft;
use crate::pairwise;
use crate::read::Echo;

/// Factors on the strength of pairwise forces, or of the cohesion of a van der Waals fluid, that were measured for a
/// case, to be used where its file gives none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Coefficients {
    /// Of cohesion, by the name of a fluid.
    pub cohesion: BTreeMap<String, f64>,
    /// Of adhesion, by the index of a wall.
    pub adhesion: BTreeMap<usize, f64>,
}

/// Which numbers a file states itself; the others were chosen for it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Given {
    /// The sound speed of each fluid. Else it follows from the largest speed of the case.
    pub sound_speed: Vec<bool>,
    /// The strength of the cohesion of each fluid, or there is none to give.
    pub cohesion: Vec<bool>,
    /// The strength of the attraction of each wall, or there is none to give.
    pub adhesion: Vec<bool>,
}

impl Given {
    pub(crate) fn of(draft: &Draft) -> Self {
        let by_tension = pairwise::model(draft).is_some() && !pairwise::has_gamma(draft);
        let fluids = || draft.fluids.iter();
        let has_tension = |fluid: usize| {
            let Some(fluid) = draft.fluids.get(fluid) else {
                return false;
            };
            match &fluid.van_der_waals {
                Some(own) => own.by_tension,
                None => by_tension && fluid.fluid.surface_tension > 0.0,
            }
        };
        let takes_angle = |adhesion| matches!(adhesion, Adhesion::ContactAngle(_));
        Self {
            sound_speed: fluids().map(|f| f.sound_speed_span.is_some()).collect(),
            cohesion: (fluids().enumerate())
                .map(|(index, f)| f.cohesion_factor_span.is_some() || !has_tension(index))
                .collect(),
            adhesion: (draft.walls.iter())
                .map(|wall| {
                    let asked = takes_angle(wall.adhesion) && has_tension(wall.fluid);
                    wall.adhesion_factor_span.is_some() || !asked
                })
                .collect(),
        }
    }

    /// Whether anything is left to be measured.
    pub fn is_complete(&self) -> bool {
        self.cohesion
            .iter()
            .chain(&self.adhesion)
            .all(|given| *given)
    }
}

impl Coefficients {
    /// Puts them where the file gives none.
    pub(crate) fn apply(&self, draft: &mut Draft, echo: &mut Echo) {
        let given = Given::of(draft);
        for (fluid, given) in draft.fluids.iter_mut().zip(&given.cohesion) {
            let name = &fluid.fluid.name;
            if let (Some(&factor), false) = (self.cohesion.get(name), given) {
                echo.insert(
                    &["fluid", name],
                    "cohesion_factor",
                    Echo::Leaf(format!("{factor}")),
                );
                fluid.fluid.cohesion_factor = factor;
            }
        }
        for (index, (wall, given)) in draft.walls.iter_mut().zip(&given.adhesion).enumerate() {
            if let (Some(&factor), false) = (self.adhesion.get(&index), given) {
                let number = index.to_string();
                echo.insert(
                    &["wall", &number],
                    "adhesion_factor",
                    Echo::Leaf(format!("{factor}")),
                );
                wall.adhesion_factor = factor;
            }
        }
    }
}
