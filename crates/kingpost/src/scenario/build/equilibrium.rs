//! Runs that begin at rest where they balance.

use super::super::schema::Scenario;
use super::reading::{Gathered, Reading};
use super::{FieldError, build};
use crate::integrate::{Interval, Stage, System};
use crate::model::{Mode, Model, Node};
use crate::plant::Plant;
use crate::scalar::Scalar;
use crate::simulation::{Setup, Simulation};

const FIELD: &str = "simulation.begin_at_equilibrium";

/// Moves a setup to its equilibrium, where the scenario asks for it; its velocities stay.
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
    Ok(())
}

/// The same over another scalar: the equilibria of the scenarios side by side, or one with its
/// derivatives.
pub fn follow<S: Gathered>(scenario: &Reading<Scenario>, setup: &mut Setup<S>) -> Result<(), FieldError> {
    let built = scenario.all()[..S::WIDTH].iter().map(|scenario| build(scenario));
    let built: Vec<Setup> = built.collect::<Result<_, _>>()?;
    for i in free_positions(&setup.model) {
        let numbers: Vec<f64> = built.iter().map(|setup| setup.q[i]).collect();
        setup.q[i] = if S::WIDTH > 1 { S::gather(&numbers, &[]) } else { S::constant(numbers[0]) };
    }
    if S::HAS_DERIVATIVES {
        differentiate(&built[0], setup)?;
    }
    Ok(())
}

/// Entries of q that free coordinates move.
fn free_positions<S: Scalar>(model: &Model<S>) -> Vec<usize> {
    let of = |node: &Node<S>| {
        let rates = node.kind.velocity_count();
        let (quaternion, turns) = node.kind.quaternion().unwrap_or((node.kind.position_count(), rates));
        let free = |k: usize| model.modes[node.velocities + k] == Mode::Free;
        let turned = if (turns..rates).any(free) { quaternion..quaternion + 4 } else { 0..0 };
        (0..turns).filter(|k| free(*k)).chain(turned).map(|k| node.positions + k).collect::<Vec<_>>()
    };
    model.tree.nodes.iter().flat_map(of).collect()
}

/// One more of Newton's moves, whose value is nothing and whose derivatives are the equilibrium's
/// (the implicit function theorem).
fn differentiate<S: Scalar>(plain: &Setup, setup: &mut Setup<S>) -> Result<(), FieldError> {
    let compliance = Simulation::new(plain.clone()).compliance();
    let compliance = compliance.ok_or_else(|| {
        FieldError::new(FIELD, "true, where nothing keeps the model in its place", "false, for a derivative")
    })?;
    let mut plant = Plant::new(setup.model.clone(), setup.forces.clone(), setup.drives.clone());
    plant.set_at_rest(true);
    let still = vec![S::ZERO; setup.v.len()];
    let s = plant.open_ledger(&setup.q, &still);
    let mut d = setup.inputs.iter().map(|input| S::constant(input.value)).collect();
    plant.first_held(&setup.q, &still, &mut d);
    let (mut v_dot, mut s_dot) = (still.clone(), vec![S::ZERO; s.len()]);
    let interval = Interval { start_s: 0.0, end_s: plain.settings.step_s };
    plant.watch_loops(&setup.q, &still);
    plant.rates(Stage { time_s: 0.0, interval, q: &setup.q, v: &still, s: &s, d: &d }, &mut v_dot, &mut s_dot);
    let free = plant.model.free_coordinates();
    let mut xi = still.clone();
    for (row, i) in free.iter().enumerate() {
        let along = free.iter().enumerate();
        xi[*i] = along.fold(S::ZERO, |sum, (column, j)| sum + S::constant(compliance[(row, column)]) * v_dot[*j]);
    }
    let mut moved = setup.q.clone();
    plant.retract(&setup.q, &xi, &mut moved);
    setup.q = moved;
    Ok(())
}
