//! The interaction of hulls that share a database of several.

use crate::elements::hull::{CoupledHull, Hull, HullInteraction, HullSpacing, Radiation, SpacedHull};
use crate::model::{JointKind, Model};
use crate::scalar::Scalar;
use crate::scenario::assembly::FieldError;
use crate::scenario::schema::{Force, Hydrodynamics, Scenario};
use crate::sea::database::{HullCoupling, HydrodynamicData};
use std::sync::Arc;

/// A hull of a scenario, by the name of its force.
pub struct CoupledForce<'a, S> {
    /// Name of the force.
    pub name: &'a str,
    /// Its fields.
    pub given: &'a Hydrodynamics<S>,
    /// Index of the hull among those of its database.
    pub place: usize,
    /// The database's origin from the centre of mass of its body, body axes, m.
    pub origin_m: [f64; 3],
}

impl<S> CoupledForce<'_, S> {
    fn field(&self, rest: &str) -> String {
        format!("forces.{}.hydrodynamics.{rest}", self.name)
    }
}

/// Returns the index of a force's hull in its data.
///
/// # Errors
/// No hull of this name.
pub fn place_in<S>(force: &str, given: &Hydrodynamics<S>, data: &HydrodynamicData) -> Result<usize, FieldError> {
    let field = format!("forces.{force}.hydrodynamics.hull");
    match (data.coupling(), &given.hull) {
        (None, Some(hull)) => {
            Err(FieldError::new(field, format!("{hull}, with a database of one hull"), "no hull: it has no name there"))
        }
        (None, None) => Ok(0),
        (Some(coupling), asked) => data.hull(given.name_in_database()).map(|(place, _)| place).ok_or_else(|| {
            let found = match asked {
                Some(hull) => hull.to_string(),
                None => format!("no hull, and no hull named {}, in a database of several", given.body),
            };
            FieldError::new(field, found, format!("one of {}", names(coupling)))
        }),
    }
}

fn names(coupling: &HullCoupling) -> String {
    coupling.places.iter().map(|place| place.name.as_str()).collect::<Vec<_>>().join(", ")
}

/// Returns the interaction of the hulls of one database; `hulls` are their elements, in the order of the forces.
///
/// # Errors
/// A hull of the database that is missing, there twice, held, or without forces that the others have.
pub fn interaction<S: Scalar>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    coupling: &Arc<HullCoupling>,
    forces: &[CoupledForce<'_, S>],
    hulls: &[&Hull<S>],
) -> Result<HullInteraction<S>, FieldError> {
    check_forces(scenario, model, coupling, forces, hulls)?;
    let pairs = || (0..forces.len()).flat_map(|i| (0..forces.len()).map(move |j| [i, j])).filter(|[i, j]| i != j);
    let block = |[on, by]: [usize; 2]| &coupling.blocks[forces[on].place][forces[by].place];
    let added = forces[0].given.added_mass;
    let added_mass: Vec<_> = pairs()
        .filter(|[first, second]| added && first < second)
        .map(|pair| {
            // A panel method's blocks are each other's transpose only nearly.
            let [there, back] = [pair, [pair[1], pair[0]]].map(|pair| &block(pair).added_mass_infinite);
            let mean = core::array::from_fn(|i| core::array::from_fn(|j| 0.5 * (there[i][j] + back[j][i])));
            (pair, mean)
        })
        .collect();
    let memory = pairs().filter(|_| forces[0].given.radiation);
    let memory = memory.filter_map(|pair| Some((pair, Radiation::new(block(pair).radiation.as_ref()?)))).collect();
    let coupled = forces.iter().zip(hulls).map(|(force, hull)| CoupledHull {
        name: force.name.to_owned(),
        coordinates: hull.coordinates.clone(),
        in_waves: hull.quadratic_terms.of_slow_motion,
        remembers: hull.radiation.is_some(),
    });
    let spaced = |k: usize| {
        let place = &coupling.places[forces[k].place];
        let [x, y] = place.position_m;
        SpacedHull {
            body: model.bodies[hulls[k].frame.body].name.clone(),
            plan: hulls[k].plan,
            origin_m: forces[k].origin_m,
            place: [x, y, place.heading_rad],
        }
    };
    let spacings = pairs().filter(|[i, j]| i < j).map(|pair| HullSpacing::new(pair.map(spaced))).collect();
    Ok(HullInteraction::new(coupled.collect(), &added_mass, memory, spacings))
}

fn check_forces<S: Scalar>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    coupling: &HullCoupling,
    forces: &[CoupledForce<'_, S>],
    hulls: &[&Hull<S>],
) -> Result<(), FieldError> {
    for (k, (force, hull)) in forces.iter().zip(hulls).enumerate() {
        if let Some(other) = forces[..k].iter().find(|other| other.place == force.place) {
            let found = format!("{}, as forces.{}", coupling.places[force.place].name, other.name);
            return Err(FieldError::new(force.field("hull"), found, "each hull of a database once"));
        }
        if let Some(other) = hulls[..k].iter().find(|other| other.frame.body == hull.frame.body) {
            let found = format!("{}, the body of forces.{}", force.given.body, other.name);
            return Err(FieldError::new(force.field("body"), found, "a body for each hull of a database"));
        }
        check_floats(model, force, hull.frame.body)?;
        check_like(force, &forces[0])?;
    }
    check_complete(scenario, coupling, forces)
}

fn check_floats<S>(model: &Model<S>, force: &CoupledForce<'_, S>, body: usize) -> Result<(), FieldError> {
    match model.joints[body].kind {
        JointKind::Floating(joint) if joint.hold_translation || joint.hold_rotation => {
            let found = format!("{}, whose joint {} is held", force.given.body, model.joints[body].name);
            let allowed = "a body that floats freely: a database of several hulls is for hulls that all move";
            Err(FieldError::new(force.field("body"), found, allowed))
        }
        _ => Ok(()),
    }
}

/// Checks that a hull has the forces that the first has: what one leaves out, no other can feel.
fn check_like<S>(force: &CoupledForce<'_, S>, first: &CoupledForce<'_, S>) -> Result<(), FieldError> {
    let parts = |given: &Hydrodynamics<S>| {
        [("added_mass", given.added_mass), ("radiation", given.radiation), ("excitation", given.excitation)]
    };
    for ((what, own), (_, of_first)) in parts(force.given).into_iter().zip(parts(first.given)) {
        if own != of_first {
            let allowed = format!("{of_first}, as in forces.{}: one for all hulls of the database", first.name);
            return Err(FieldError::new(force.field(what), own, allowed));
        }
    }
    Ok(())
}

fn check_complete<S>(
    scenario: &Scenario<S>,
    coupling: &HullCoupling,
    forces: &[CoupledForce<'_, S>],
) -> Result<(), FieldError> {
    let is_there = |place: usize| forces.iter().any(|force| force.place == place);
    let Some(missing) = (0..coupling.places.len()).find(|place| !is_there(*place)) else { return Ok(()) };
    let (first, missing) = (&forces[0], &coupling.places[missing].name);
    let is_disabled = scenario.forces.values().any(|force| match force {
        Force::Hydrodynamics(given) => {
            let is_this = given.database == first.given.database && given.name_in_database() == missing;
            is_this && !given.enabled
        }
        _ => false,
    });
    let how = if is_disabled { "is disabled" } else { "has no hydrodynamics here" };
    let found = format!("a database of {}, of which {missing} {how}", names(coupling));
    let allowed = "hydrodynamics of every one of its hulls, or a database without that hull";
    Err(FieldError::new(first.field("database"), found, allowed))
}
