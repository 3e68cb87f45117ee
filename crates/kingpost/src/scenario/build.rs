//! Scenario -> what a simulation is made of, with every check that needs more than one field.

mod bodies;
mod drives;

pub use super::error::FieldError;
use super::schema::{EquationForm, Force as ForceSchema, Integrator, Scenario};
use crate::dynamics::moving_frame::Variation;
use crate::forces::{Force, Gravity, JointDamping, ViscousDamping};
use crate::model::Model;
use crate::plant::{Form, Plant, instant};
use crate::simulation::{SchemeName, Settings, Setup};
use crate::spatial::Vector3;

/// Rows that one run may record: more would not fit in the memory of an ordinary machine.
const MOST_ROWS: f64 = 1e7;

/// Builds the model, forces, drives, settings and initial state.
pub fn build(scenario: &Scenario) -> Result<Setup, FieldError> {
    let settings = settings(scenario)?;
    let bodies::Bodies { model, q, mut v, dampings } = bodies::build(scenario)?;
    let mut forces = forces(scenario, &model)?;
    forces.extend(
        dampings.into_iter().map(|(coordinate, damping)| Force::JointDamping(JointDamping { coordinate, damping })),
    );
    let drives::Drives { drives, inputs } = drives::build(scenario, &model, &mut v)?;
    let setup = Setup { model, forces, drives, inputs, settings, q, v };
    check_mass_matrix(scenario, &setup)?;
    Ok(setup)
}

fn settings(scenario: &Scenario) -> Result<Settings, FieldError> {
    let given = &scenario.simulation;
    let (step_s, duration_s) = (given.step_s.get(), given.duration_s.get());
    let record_every_s = given.record_every_s.get();
    if step_s > duration_s {
        let allowed = format!("at most simulation.duration_s, {duration_s}");
        return Err(FieldError::new("simulation.step_s", step_s, allowed));
    }
    let rows = duration_s / record_every_s.max(step_s);
    if rows > MOST_ROWS {
        let allowed = format!("at least {} s, for {MOST_ROWS} rows", duration_s / MOST_ROWS);
        return Err(FieldError::new("simulation.record_every_s", record_every_s, allowed));
    }
    let scheme = match given.integrator {
        Integrator::ForwardEuler => SchemeName::ForwardEuler,
        Integrator::MidpointEuler => SchemeName::MidpointEuler,
        Integrator::Rk4 => SchemeName::RungeKutta4,
    };
    let form = match given.form {
        EquationForm::Recursive => Form::Recursive,
        EquationForm::MovingFrame => Form::MovingFrame(Variation::Restricted),
        EquationForm::MovingFrameWithoutD => Form::MovingFrame(Variation::Naive),
    };
    let rate_limit = given.rate_limit.get();
    Ok(Settings { scheme, step_s, duration_s, record_every_s, rate_limit, form })
}

/// The forces that are on, on bodies that are there.
fn forces(scenario: &Scenario, model: &Model) -> Result<Vec<Force>, FieldError> {
    let mut forces = Vec::new();
    for (name, force) in &scenario.forces {
        match force {
            ForceSchema::Gravity(gravity) => {
                if gravity.enabled {
                    forces.push(Force::Gravity(Gravity { acceleration: gravity.acceleration_m_s2.get() }));
                }
            }
            ForceSchema::ViscousDamping(damping) => {
                let field = format!("forces.{name}.viscous_damping.body");
                known(&field, &damping.body, scenario.bodies.keys().map(|body| body.as_str()))?;
                if let (true, Some(body)) = (damping.enabled, model.body(&damping.body)) {
                    let linear = Vector3(damping.linear_n_s_m.map(|c| c.get()));
                    let angular = Vector3(damping.angular_n_m_s.map(|c| c.get()));
                    forces.push(Force::ViscousDamping(ViscousDamping { body, linear, angular }));
                }
            }
        }
    }
    Ok(forces)
}

/// An error unless `found` is one of `names`.
fn known<'a>(field: &str, found: &str, names: impl Iterator<Item = &'a str>) -> Result<(), FieldError> {
    let names: Vec<&str> = names.collect();
    if names.contains(&found) {
        return Ok(());
    }
    Err(FieldError::new(field, found, format!("one of {}", names.join(", "))))
}

/// M* must be positive definite where the run begins: a coordinate that moves no mass, or masses
/// too far apart for the arithmetic, would give accelerations that are no numbers.
fn check_mass_matrix(scenario: &Scenario, setup: &Setup) -> Result<(), FieldError> {
    let Setup { model, q, v, .. } = setup;
    let mut plant = Plant::new(model.clone(), Vec::new(), Vec::new(), q);
    let m_star = plant.matrices(instant(0.0, setup.settings.step_s, q, v, &[])).m_star;
    let names = model.coordinate_names();
    let free = model.free_coordinates();
    let scale: Vec<f64> = (0..free.len()).map(|i| libm::sqrt(m_star[(i, i)])).collect();
    let allowed = "a mass or an inertia that its joint moves, greater than 0";
    let refuse = |i: usize| {
        let body = model.joints.iter().position(|joint| joint.coordinate_names().contains(&names[free[i]]));
        let body = body.map_or_else(String::new, |body| model.bodies[body].name.clone());
        let inertia =
            if scenario.bodies.get(body.as_str()).is_some_and(|b| b.inertia.is_some()) { "inertia" } else { "shape" };
        let found = format!("no inertia along {}", names[free[i]]);
        FieldError::new(format!("bodies.{body}.{inertia}"), found, allowed)
    };
    if let Some(i) = scale.iter().position(|s| !(s.is_finite() && *s > 0.0)) {
        return Err(refuse(i));
    }
    // Cholesky of the matrix scaled to a unit diagonal: a pivot is what a coordinate moves that
    // those before it do not.
    let n = free.len();
    let mut l = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| l[i * n + k] * l[j * n + k]).sum();
            let rest = m_star[(i, j)] / (scale[i] * scale[j]) - sum;
            if i == j && (rest.is_nan() || rest <= 1e-13) {
                return Err(refuse(i));
            }
            l[i * n + j] = if i == j { libm::sqrt(rest) } else { rest / l[j * n + j] };
        }
    }
    Ok(())
}
