//! Builds the setup of a simulation from a scenario, with every check that needs several fields.

pub(crate) mod assemble;
pub(crate) mod attachments;
pub(crate) mod axes;
pub(crate) mod bodies;
pub(crate) mod capacity;
pub(crate) mod columns;
pub(crate) mod controllers;
pub(crate) mod equilibrium;
pub(crate) mod finite;
pub(crate) mod flexible;
pub(crate) mod hinges;
pub(crate) mod limits;
pub(crate) mod liquids;
pub(crate) mod loops;
pub(crate) mod rigid_bodies;
pub(crate) mod sea_spectra;
pub(crate) mod station;
pub(crate) mod still_water;
pub(crate) mod view;
pub(crate) mod watchers;
pub(crate) mod wave_motion;
pub(crate) mod waves;
pub(crate) mod wind_and_current;
pub(crate) mod wires;
pub(crate) mod world;

use crate::dynamics::LinkKinematics;
use crate::dynamics::moving_frame::Variation;
use crate::dynamics::pivots::massless_coordinate;
use crate::elements::connection::assembly as connections;
use crate::elements::contact::assembly as contacts;
use crate::elements::drives::assembly as drives;
use crate::elements::drives::assembly::cylinders;
use crate::elements::dynamic_positioning::assembly as positioning;
use crate::elements::hull::assembly as water;
use crate::elements::line::assembly as line;
use crate::elements::lines::assembly as lines;
use crate::elements::operation::assembly as operation;
use crate::elements::ropes::assembly::at_start as ropes_at_start;
use crate::elements::{AnyElement, Layout};
use crate::integrate::Tolerances;
use crate::model::Model;
use crate::plant::Form;
use crate::results::Channels;
pub use crate::scenario::error::FieldError;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, EquationForm, Integrator, Name, Scenario};
use crate::simulation::{MOST_DENSE, SchemeName, Settings, Setup, Simulation};
use crate::spatial::Frame;
use assemble::{Assemble, Surroundings};
use indexmap::IndexMap;
pub use sea_spectra::{SeaSpectrum, SeaWaves, read_sea_waves};

/// Largest number of values that one run records, 8 bytes each: more do not fit in the memory of an ordinary
/// machine.
const MOST_NUMBERS: f64 = 2.5e8;

/// Largest number of steps of one run: beyond it the time is no longer exact.
const MOST_STEPS: f64 = 1e15;

/// Builds the model, forces, drives, settings and initial state, and checks all numbers.
pub fn build(scenario: &Scenario) -> Result<Setup, FieldError> {
    let mut setup = open(scenario)?;
    positioning::check_stability(scenario)?;
    setup.fingerprint = scenario.fingerprint();
    check_recording(&setup)?;
    check_size(&setup)?;
    check_mass_matrix(scenario, &setup)?;
    station::check(&setup)?;
    loops::close(scenario, &mut setup)?;
    connections::begin(&mut setup)?;
    cylinders::begin(&mut setup)?;
    ropes_at_start::begin(&mut setup)?;
    line::begin(&mut setup)?;
    contacts::begin(&mut setup)?;
    capacity::check(scenario, &setup)?;
    equilibrium::settle(scenario, &mut setup)?;
    ropes_at_start::check_loads(&setup)?;
    contacts::check_rest(&setup)?;
    setup.watchers = watchers::of(&setup);
    check_numbers(scenario, &setup)?;
    Ok(setup)
}

/// Builds the setup over another scalar, for one scenario or several with the same structure; `alone` are their
/// separate setups.
///
/// # Errors
/// A field whose number determines the structure of the run, but differs between lanes or has a derivative.
pub fn assemble<S: Quantity>(scenario: &Scenario<S>, alone: &[&Setup]) -> Result<Setup<S>, FieldError> {
    let mut setup = open(scenario)?;
    loops::close(scenario, &mut setup)?;
    connections::begin(&mut setup)?;
    cylinders::begin(&mut setup)?;
    ropes_at_start::begin(&mut setup)?;
    line::begin(&mut setup)?;
    contacts::begin(&mut setup)?;
    if scenario.simulation.begin_at_equilibrium {
        equilibrium::follow(alone, &mut setup)?;
        loops::close(scenario, &mut setup)?;
    }
    Ok(setup)
}

/// Builds the setup over another scalar, with its closed loops still open.
fn open<S: Quantity>(scenario: &Scenario<S>) -> Result<Setup<S>, FieldError> {
    let settings = settings(&scenario.simulation)?;
    let world = world::build(scenario)?;
    let bodies::Bodies { model, mut q, mut v, forces: in_joints } = bodies::build(scenario)?;
    let model = loops::build(scenario, model)?;
    let (model, in_water) = water::build(scenario, model, &world)?;
    let at = Surroundings::new(scenario, &model, &world, (&q, &v));
    let mut elements = assembled(&scenario.forces, at)?;
    elements.extend(in_joints);
    elements.extend(connections::build(scenario, &model)?);
    elements.extend(in_water);
    // Prescribed joints get their initial rates.
    elements.extend(drives::build(scenario, &model, &world, (&q, &mut v))?);
    let at = Surroundings::new(scenario, &model, &world, (&q, &v));
    let sensors = assembled(&scenario.sensors, Surroundings { elements: &elements, ..at })?;
    elements.extend(sensors);
    elements.extend(wind_and_current::anemometers(&world, &model, &elements));
    let controllers = controllers::add(at, &mut elements)?;
    connections::check_inputs(&elements)?;
    let wires = wires::of(scenario, &elements)?;
    for (first, positions) in elements.iter().filter_map(|element| element.given_positions(&world, 0.0)) {
        q[first..first + 6].copy_from_slice(&positions);
    }
    let (watchers, limits) = (Vec::new(), Vec::new());
    let mut setup = Setup { model, world, elements, watchers, limits, wires, settings, q, v, fingerprint: 0 };
    operation::add(scenario, &mut setup, controllers)?;
    setup.limits = limits::of(scenario, &setup)?;
    view::check(scenario, &setup)?;
    lines::check_start(&setup)?;
    Ok(setup)
}

fn settings(given: &schema::SimulationSettings) -> Result<Settings, FieldError> {
    let (step_s, duration_s) = (given.step_s.get(), given.duration_s.get());
    let record_every_s = given.record_every_s.get();
    if step_s > duration_s {
        let allowed = format!("at most simulation.duration_s, {duration_s}");
        return Err(FieldError::new("simulation.step_s", step_s, allowed));
    }
    if duration_s / step_s > MOST_STEPS {
        let allowed = format!("at least {:e} s, for {MOST_STEPS:e} steps", duration_s / MOST_STEPS);
        return Err(FieldError::new("simulation.step_s", step_s, allowed));
    }
    let scheme = scheme(given)?;
    let form = match given.form {
        EquationForm::Recursive => Form::Recursive,
        EquationForm::MovingFrame => Form::MovingFrame(Variation::Restricted),
        EquationForm::MovingFrameWithoutD => Form::MovingFrame(Variation::Naive),
    };
    let rate_limit = given.rate_limit.get();
    Ok(Settings { scheme, step_s, duration_s, record_every_s, rate_limit, form })
}

/// Smallest value of largest_step_s, as a share of the step: with smaller values a step would take too long
/// to compute.
const LEAST_SHARE: f64 = 1e-3;

/// Returns the integrator with its settings.
fn scheme(given: &schema::SimulationSettings) -> Result<SchemeName, FieldError> {
    Ok(match given.integrator {
        Integrator::ForwardEuler => SchemeName::ForwardEuler,
        Integrator::MidpointEuler => SchemeName::MidpointEuler,
        Integrator::SemiImplicitEuler => SchemeName::SemiImplicitEuler,
        Integrator::Rk4 => SchemeName::RungeKutta4,
        Integrator::DormandPrince => {
            let schema::DormandPrinceSettings { absolute_tolerance, relative_tolerance, largest_step_s } =
                given.dormand_prince;
            let least_s = LEAST_SHARE * given.step_s.get();
            if largest_step_s.get() < least_s {
                let allowed = format!("at least {least_s:e} s, a thousandth of simulation.step_s");
                return Err(FieldError::new("simulation.dormand_prince.largest_step_s", largest_step_s.get(), allowed));
            }
            SchemeName::DormandPrince(Tolerances {
                absolute: absolute_tolerance.get(),
                relative: relative_tolerance.get(),
                largest_step_s: largest_step_s.get(),
            })
        }
        Integrator::Newmark => {
            let (beta, gamma) = (given.newmark.beta.get(), given.newmark.gamma.get());
            if beta > 0.5 {
                return Err(FieldError::new("simulation.newmark.beta", beta, "a number from 0 to 0.5"));
            }
            if gamma < 0.5 {
                return Err(FieldError::new("simulation.newmark.gamma", gamma, "a number from 0.5 to 1"));
            }
            SchemeName::Newmark { beta, gamma }
        }
        Integrator::GeneralizedAlpha => {
            SchemeName::GeneralizedAlpha { rho_infinity: given.generalized_alpha.rho_infinity.get() }
        }
        Integrator::ImplicitMidpoint => SchemeName::ImplicitMidpoint,
    })
}

/// Checks that the recorded values fit in memory.
fn check_recording(setup: &Setup) -> Result<(), FieldError> {
    let Settings { duration_s, record_every_s, .. } = setup.settings;
    let columns = Channels::new(&setup.model, &Layout::new(&setup.elements, 0)).columns();
    if setup.settings.rows() * columns as f64 > MOST_NUMBERS {
        let least = libm::ceil(duration_s * columns as f64 / MOST_NUMBERS * 1e3) / 1e3;
        let allowed = format!("at least {least} s, for {MOST_NUMBERS:e} numbers in all");
        return Err(FieldError::new("simulation.record_every_s", record_every_s, allowed));
    }
    Ok(())
}

/// Checks that all matrices of the coordinates fit in memory.
fn check_size(setup: &Setup) -> Result<(), FieldError> {
    let (Settings { scheme, form, .. }, count) = (setup.settings, setup.model.velocity_count);
    let by_matrices = [
        (form != Form::Recursive, "simulation.form", "recursive"),
        (scheme.is_implicit(), "simulation.integrator", "an explicit one"),
    ];
    let Some((_, field, other)) = by_matrices.into_iter().find(|(is_so, ..)| *is_so && count > MOST_DENSE) else {
        return Ok(());
    };
    let found = format!("one with matrices, of {count} coordinates");
    Err(FieldError::new(field, found, format!("at most {MOST_DENSE} with matrices; {other} has none")))
}

/// Checks that the first row is finite: values beyond 1e308 overflow, and squares of values beyond 1e154.
fn check_numbers(scenario: &Scenario, setup: &Setup) -> Result<(), FieldError> {
    let mut simulation = Simulation::recursive(setup.clone());
    let mut row = Vec::new();
    simulation.write_row(&mut row);
    let columns = simulation.channels().iter().flat_map(|channel| &channel.columns);
    let bad: Vec<(&String, f64)> = columns.zip(row).filter(|(_, value)| !value.is_finite()).collect();
    // The outputs of elements show best which number is too large: they are searched before those of bodies.
    let owner = |names: Vec<&str>, of: &str| {
        let first = |(column, _): &&(&String, f64)| names.iter().any(|name| column.split('.').next() == Some(name));
        bad.iter().find(first).map(|found| (format!("{of}.{}", found.0.split('.').next().unwrap_or_default()), *found))
    };
    let named = owner(scenario.forces.keys().map(|name| name.as_str()).collect(), "forces")
        .or_else(|| owner(scenario.drives.keys().map(|name| name.as_str()).collect(), "drives"))
        .or_else(|| owner(scenario.sensors.keys().map(|name| name.as_str()).collect(), "sensors"))
        .or_else(|| owner(scenario.controllers.keys().map(|name| name.as_str()).collect(), "controllers"))
        .or_else(|| owner(scenario.bodies.keys().map(|name| name.as_str()).collect(), "bodies"))
        // Only an energy is too large: the one stored in a force.
        .or_else(|| bad.first().map(|found| ("forces".to_owned(), *found)));
    let Some((field, (column, value))) = named else { return Ok(()) };
    let found = format!("numbers that make {column} {value} at the start");
    Err(FieldError::new(field, found, "smaller numbers, with which all outputs are finite"))
}

/// Returns the elements of all entries of a section, in the order of the file.
fn assembled<S: Quantity, K: Assemble<S>>(
    entries: &IndexMap<Name, K>,
    at: Surroundings<'_, S>,
) -> Result<Vec<AnyElement<S>>, FieldError> {
    let mut elements = Vec::new();
    for (name, entry) in entries {
        elements.extend(entry.assemble(name, at)?);
    }
    Ok(elements)
}

/// Returns an error unless `found` is one of `names`.
pub(crate) fn known<'a>(field: &str, found: &str, names: impl Iterator<Item = &'a str>) -> Result<(), FieldError> {
    let names: Vec<&str> = names.collect();
    if names.contains(&found) {
        return Ok(());
    }
    Err(FieldError::new(field, found, format!("one of {}", names.join(", "))))
}

/// Checks that all positions are finite: sums and squares of a joint's numbers can be infinite or NaN.
fn check_places(model: &Model, links: &LinkKinematics) -> Result<(), FieldError> {
    for (body, named) in model.bodies.iter().enumerate() {
        let Frame { rotation, position } = links.body_frame(model, body);
        if !rotation.0.iter().flatten().chain(&position.0).all(|x| x.is_finite()) {
            let field = format!("bodies.{}.joint", flexible::owner(&named.name).0);
            return Err(FieldError::new(field, "a position that is not finite", "finite positions and angles"));
        }
    }
    Ok(())
}

/// Checks that M* is positive definite at the start: a coordinate that moves no mass, or masses of very
/// different size, would give infinite or NaN accelerations.
fn check_mass_matrix(scenario: &Scenario, setup: &Setup) -> Result<(), FieldError> {
    let Setup { model, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    check_places(model, &links)?;
    let Some(coordinate) = massless_coordinate(model, &links, v) else { return Ok(()) };
    let (body, _) = model.owner(coordinate).unwrap_or_default();
    let (name, coordinate) = (&model.bodies[body].name, &model.coordinate_names()[coordinate]);
    let name = flexible::owner(name).0;
    let given = scenario.bodies.get(name).is_some_and(|body| body.inertia.is_some());
    let field = format!("bodies.{name}.{}", if given { "inertia" } else { "shape" });
    if q.iter().chain(v).any(|x| !x.is_finite()) {
        return Err(FieldError::new(
            format!("bodies.{name}.joint"),
            "a position that is not finite",
            "finite positions",
        ));
    }
    let found = format!("an inertia along {coordinate} that is zero to 16 digits");
    Err(FieldError::new(field, found, "a mass or an inertia that its joint moves, greater than 0"))
}
