//! The load of a rope at rest, and the warning of a load whose weight is not that on the rope.

use crate::dynamics::LinkKinematics;
use crate::elements::ropes::RestingLoad;
use crate::elements::{Context, PresentSupport, Rope, Support, significant};
use crate::model::Model;
use crate::scenario::assembly::{FieldError, flexible, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, RopeStation, Scenario};
use crate::simulation::{Setup, Simulation};

/// Largest deviation of the dynamic amplification factor of a load at rest from 1 without a warning: rope and slings
/// that have no mass in the model weigh less than this share of the load.
const LARGEST_DEVIATION: f64 = 0.1;
/// Largest vertical acceleration of a load that counts as at rest, as a share of gravity: it changes the factor by half
/// of the deviation that is warned of.
const AT_REST: f64 = 0.05;

/// Returns the load of a rope; `None` if none of the carried bodies exists.
pub fn build<S: Quantity>(
    scenario: &Scenario<S>,
    field: &str,
    given: &schema::Rope<S>,
    model: &Model<S>,
) -> Result<Option<RestingLoad<S>>, FieldError> {
    let falls = falls(given);
    let (mut mass, mut bodies) = (S::ZERO, Vec::new());
    for (i, carried) in given.carries.iter().enumerate() {
        known(&format!("{field}.carries.{i}.body"), &carried.body, scenario.bodies.keys().map(|body| body.as_str()))?;
        let share = carried.share.get() * S::constant(1.0 / f64::from(falls));
        // A flexible body consists of several bodies of the model.
        let is_part = |body: &usize| flexible::owner(&model.bodies[*body].name).0 == &*carried.body;
        for body in (0..model.bodies.len()).filter(is_part) {
            mass += model.bodies[body].mass * share;
            bodies.push(body);
        }
    }
    Ok((!bodies.is_empty()).then_some(RestingLoad { mass_on_a_fall: mass, falls, bodies }))
}

/// Returns the number of falls between the carried bodies and the others on the path, or that at the end of the rope if
/// the load hangs below its hook.
fn falls<S: Quantity>(given: &schema::Rope<S>) -> u32 {
    let falls_to = |station: &RopeStation<S>| if let RopeStation::Point(point) = station { point.falls } else { 1 };
    let is_load = |station: &RopeStation<S>| given.carries.iter().any(|carried| station.on().1 == Some(&carried.body));
    let legs = given.path.windows(2).filter(|ends| is_load(&ends[0]) != is_load(&ends[1]));
    match legs.map(|ends| falls_to(&ends[1])).sum() {
        0 => given.path.last().map_or(1, falls_to),
        falls => falls,
    }
}

/// Warns of ropes whose load hangs freely at rest at the start of a run and does not weigh what the rope carries.
pub fn warnings(setup: &Setup, simulation: &mut Simulation) -> Vec<String> {
    let gravity = setup.world.gravity;
    let held = held(setup);
    let loads = Rope::among(&setup.elements).filter_map(|rope| Some((rope, rope.carries.as_ref()?)));
    let hanging = loads.filter(|(_, load)| gravity > 0.0 && !load.bodies.iter().any(|body| held.contains(body)));
    let warning = |(rope, load): (&Rope, &RestingLoad)| {
        let accelerations = load.bodies.iter().map(|&body| format!("{}.acceleration.z", setup.model.bodies[body].name));
        let columns: Vec<String> = [format!("{}.rope_daf", rope.name)].into_iter().chain(accelerations).collect();
        let (mut readings, mut values) = (simulation.readings(&columns), Vec::new());
        simulation.read(&mut readings, &mut values);
        let [factor, accelerations @ ..] = values.as_slice() else { return None };
        let rests = accelerations.iter().all(|acceleration| acceleration.abs() <= AT_REST * gravity);
        let is_taut = factor.is_finite() && *factor > 0.0;
        (rests && is_taut && (factor - 1.0).abs() > LARGEST_DEVIATION).then(|| text(&rope.name, load, *factor, gravity))
    };
    hanging.filter_map(warning).collect()
}

fn text(name: &str, load: &RestingLoad, factor: f64, gravity: f64) -> String {
    let falls = f64::from(load.falls);
    let given = load.mass_on_a_fall * falls * gravity / 1e3;
    let on = if load.falls == 1 { String::new() } else { format!(" on {} falls", load.falls) };
    format!(
        "{name}: rope_daf is {} with its load hanging at rest, where it should be 1 (warned of beyond {:.0} %): the rope \
         pulls with {} kN{on}, and forces.{name}.rope.carries gives {} kN; name every body that hangs on it, and as share \
         the part of the body's weight that all falls carry together",
        significant(factor, 3),
        100.0 * LARGEST_DEVIATION,
        significant(given * factor, 3),
        significant(given, 3)
    )
}

/// Returns the bodies that do not hang freely: they stand, are held, tied or in the water.
fn held(setup: &Setup) -> Vec<usize> {
    let Setup { model, world, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    let at = Context::at_rest(world, model, &links, (q, v));
    let mut held: Vec<usize> = Vec::new();
    for element in &mut elements.clone() {
        held.extend(element.supports().into_iter().filter_map(|support| match support {
            Support::Tie(body) | Support::Afloat(body) => Some(body),
            _ => None,
        }));
        for support in element.present_supports(&at) {
            match support {
                PresentSupport::Contact(pair) => held.extend(pair.into_iter().flatten()),
                PresentSupport::Displaced { body, mass, .. } if mass > 0.0 => held.push(body),
                _ => {}
            }
        }
    }
    held
}
