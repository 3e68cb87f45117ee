//! Runs that begin at rest where they balance.

use super::super::schema::Scenario;
use super::reading::{Gathered, Reading};
use super::{FieldError, build};
use crate::integrate::{Interval, Stage, System};
use crate::plant::Plant;
use crate::scalar::Scalar;
use crate::simulation::{Setup, Simulation};

const FIELD: &str = "simulation.begin_at_equilibrium";

/// Moves a setup to its equilibrium, where the scenario asks for it.
pub fn settle(scenario: &Scenario, setup: &mut Setup) -> Result<(), FieldError> {
    if !scenario.simulation.begin_at_equilibrium {
        return Ok(());
    }
    let mut simulation = Simulation::new(setup.clone());
    simulation.settle().map_err(|error| {
        let allowed = "true, for a model that comes to rest near where its bodies are put; else false";
        FieldError::new(FIELD, format!("true, and {error}"), allowed)
    })?;
    setup.q.copy_from_slice(&simulation.state().q);
    let free = setup.model.free_coordinates();
    free.into_iter().for_each(|i| setup.v[i] = 0.0);
    Ok(())
}

/// The same over another scalar: the equilibria of the scenarios side by side, or one with its
/// derivatives.
pub fn follow<S: Gathered>(scenario: &Reading<Scenario>, setup: &mut Setup<S>) -> Result<(), FieldError> {
    let built = scenario.all()[..S::WIDTH].iter().map(|scenario| build(scenario));
    let built: Vec<Setup> = built.collect::<Result<_, _>>()?;
    let gathered = |of: fn(&Setup) -> &[f64], i: usize| {
        let numbers: Vec<f64> = built.iter().map(|setup| of(setup)[i]).collect();
        if S::WIDTH > 1 { S::gather(&numbers, &[]) } else { S::constant(numbers[0]) }
    };
    for i in 0..setup.q.len() {
        setup.q[i] = gathered(|setup| &setup.q, i);
    }
    for i in 0..setup.v.len() {
        setup.v[i] = gathered(|setup| &setup.v, i);
    }
    if S::HAS_DERIVATIVES {
        differentiate(&built[0], setup)?;
    }
    Ok(())
}

/// One more of Newton's moves, whose value is nothing and whose derivatives are the equilibrium's
/// (the implicit function theorem).
fn differentiate<S: Scalar>(plain: &Setup, setup: &mut Setup<S>) -> Result<(), FieldError> {
    let compliance = Simulation::new(plain.clone()).compliance();
    let compliance = compliance.ok_or_else(|| {
        FieldError::new(FIELD, "true, where nothing keeps the model in its place", "false, for a derivative")
    })?;
    let mut plant = Plant::new(setup.model.clone(), setup.forces.clone(), setup.drives.clone());
    plant.set_calm(true);
    let s = plant.open_ledger(&setup.q, &setup.v);
    let mut d = setup.inputs.iter().map(|input| S::constant(input.value)).collect();
    plant.first_held(&setup.q, &setup.v, &mut d);
    let (mut v_dot, mut s_dot) = (vec![S::ZERO; setup.v.len()], vec![S::ZERO; s.len()]);
    let interval = Interval { start_s: 0.0, end_s: plain.settings.step_s };
    plant.watch_loops(&setup.q, &setup.v);
    plant.rates(Stage { time_s: 0.0, interval, q: &setup.q, v: &setup.v, s: &s, d: &d }, &mut v_dot, &mut s_dot);
    let free = plant.model.free_coordinates();
    let mut xi = vec![S::ZERO; setup.v.len()];
    for (row, i) in free.iter().enumerate() {
        let along = free.iter().enumerate();
        xi[*i] = along.fold(S::ZERO, |sum, (column, j)| sum + S::constant(compliance[(row, column)]) * v_dot[*j]);
    }
    let mut moved = setup.q.clone();
    plant.retract(&setup.q, &xi, &mut moved);
    setup.q = moved;
    Ok(())
}
