//! Warnings about a model, before it runs.

use crate::elements::hull::Hydrostatics;
use crate::elements::ropes::assembly::resting_load;
use crate::elements::{AnyElement, Hull, significant};
use crate::model::Model;
use crate::scenario::assembly::wave_motion::other_unit;
use crate::scenario::describe::{closing_contacts, under_water, units};
use crate::scenario::schema::{Joint, Scenario};
use crate::scenario::ties::{carrying, floats_freely, tied_to_the_world};
use crate::sea::database::Database;
use crate::sea::raos::OtherUnit;
use crate::simulation::{GrowingMode, Setup, Simulation};
use crate::world::World;

/// Largest difference between a hull's mass and the displacement of its data without a warning, as a share of
/// the displacement.
const LARGEST_CHANGE_OF_MASS: f64 = 0.25;
/// Largest number of bodies that the warnings name.
const MOST_NAMED: usize = 5;

/// Returns all warnings.
pub fn of(scenario: &Scenario, model: &Model, world: &World, elements: &[AnyElement]) -> Vec<String> {
    let falling = falls(model, &falling(model, world, elements)).into_iter();
    let of_files = of_databases(scenario, model, world, elements).into_iter().chain(of_raos(scenario, model, world));
    falling.chain(of_files).chain(units::of(scenario)).chain(scenario.overwritten.iter().cloned()).collect()
}

/// Returns a warning for each falling body up to `MOST_NAMED`, and one warning for all others.
fn falls(model: &Model, falling: &[usize]) -> Vec<String> {
    let of = |body: &usize| format!("gravity acts and nothing carries {}: it falls", model.bodies[*body].name);
    let others = falling.len().saturating_sub(MOST_NAMED);
    let rest = (others > 0).then(|| format!("gravity acts and nothing carries {others} more bodies: they fall"));
    falling.iter().take(MOST_NAMED).map(of).chain(rest).collect()
}

/// Warns of effects that elements leave out and that are not small at the start of the run, of loads that are not those of
/// their ropes, of springs under water, of contacts that are too stiff for the step, and of feedback.
pub fn at_start(scenario: &Scenario, setup: &Setup) -> Vec<String> {
    let mut simulation = Simulation::recursive(setup.clone());
    let mut warnings = simulation.left_out();
    warnings.extend(resting_load::warnings(setup, &mut simulation));
    warnings.extend(under_water::warnings(scenario, setup));
    warnings.extend(closing_contacts::warnings(setup));
    warnings.extend(of_feedback(&mut simulation));
    warnings
}

/// Warns of feedback that makes a mode unstable, by the linear check at the start of the run.
fn of_feedback(simulation: &mut Simulation) -> Option<String> {
    let found = simulation.growing_with_feedback()?;
    let GrowingMode { coordinate, period_s, growth_time_s, because_of } = found;
    let mode = period_s.map_or_else(
        || format!("a motion of {coordinate}"),
        |period_s| format!("an oscillation of {coordinate} of period {} s", significant(period_s, 4)),
    );
    let grows = format!("grows e-fold in {} s", significant(growth_time_s, 3));
    Some(match because_of.as_slice() {
        [] => format!("{mode} {grows} by the linear check, with and without feedback"),
        names => format!("{}: {mode} {grows} with these gains, by the linear check", names.join(", ")),
    })
}

/// Warns of implausible numbers in the data of hulls in the water.
fn of_databases(scenario: &Scenario, model: &Model, world: &World, elements: &[AnyElement]) -> Vec<String> {
    let mut warnings = Vec::new();
    for hull in Hull::among(elements) {
        let (Some(given), Some(database)) = (scenario.hydrodynamics(&hull.name), scenario.database_of(&hull.name))
        else {
            continue;
        };
        let (body, file) = (&model.bodies[hull.frame.body].name, &given.database);
        warnings.extend(database.doubts().into_iter().map(|doubt| format!("{body}: {file}: {doubt}")));
        let afloat = world.gravity > 0.0 && floats_freely(model, hull.frame.body);
        let counts = afloat && hull.is_linear() && !matches!(hull.hydrostatics, Hydrostatics::None);
        warnings.extend(of_mass(model, hull, database).filter(|_| counts));
    }
    warnings
}

/// Warns of a hull whose draught is far from that of its data.
fn of_mass(model: &Model, hull: &Hull, database: &Database) -> Option<String> {
    let of_data = database.water.density_kg_m3 * database.hull.volume_m3;
    let mass: f64 = model.carried(hull.frame.body).iter().map(|&body| model.bodies[body].mass).sum();
    ((mass / of_data - 1.0).abs() > LARGEST_CHANGE_OF_MASS).then(|| {
        format!(
            "{}: {:.3} t with what its joints carry, its database is of {:.3} t displaced: {:.1} % apart (warned of beyond {:.0} %)",
            model.bodies[hull.frame.body].name,
            mass / 1000.0,
            of_data / 1000.0,
            100.0 * (mass / of_data - 1.0).abs(),
            100.0 * LARGEST_CHANGE_OF_MASS
        )
    })
}

/// Warns of displacement RAOs whose rotations are probably in another unit.
fn of_raos(scenario: &Scenario, model: &Model, world: &World) -> Vec<String> {
    let mut warnings = Vec::new();
    for (name, body) in &scenario.bodies {
        let (Joint::MovedByWaves(given), Some(_)) = (&body.joint, model.body(name)) else { continue };
        let whole = scenario.files.raos(&given.raos).and_then(|table| table.whole_circle(given.symmetric).ok());
        if let Some(OtherUnit { found, allowed, .. }) = whole.and_then(|table| other_unit(&table, world)) {
            warnings.push(format!("{name}: {}: {found}, where it is {allowed}", given.raos));
        }
    }
    warnings
}

/// Returns the free bodies under gravity that nothing connects to the world: no joint, no closed loop and no
/// element that can carry a body. Damping does not count: it slows a fall but carries nothing.
fn falling(model: &Model, world: &World, elements: &[AnyElement]) -> Vec<usize> {
    if world.gravity == 0.0 {
        return Vec::new();
    }
    let carried = tied_to_the_world(model, carrying(elements));
    (0..model.bodies.len()).filter(|&body| floats_freely(model, body) && !carried[body]).collect()
}
