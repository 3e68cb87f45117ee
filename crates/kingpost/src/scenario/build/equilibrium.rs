//! Runs that begin at rest where they balance.

use super::super::schema::Scenario;
use super::FieldError;
use crate::elements::{DynamicPositioning, Force};
use crate::integrate::{Interval, Stage, System};
use crate::model::{Mode, Model, Node};
use crate::plant::Plant;
use crate::scalar::Scalar;
use crate::scenario::leaf::Quantity;
use crate::simulation::{Setup, Simulation};

const FIELD: &str = "simulation.begin_at_equilibrium";

/// Moves a setup to its equilibrium, where the scenario asks for it; its velocities stay.
pub fn settle(scenario: &Scenario, setup: &mut Setup) -> Result<(), FieldError> {
    if !scenario.simulation.begin_at_equilibrium {
        return Ok(());
    }
    let mut simulation = Simulation::new(setup.clone());
    let refused = |why: String| {
        let allowed = "true, for a model that comes to rest near where its bodies are put; else false";
        FieldError::new(FIELD, format!("true, and {why}"), allowed)
    };
    let (found, biases) = simulation.settle_with_biases().map_err(|error| refused(error.to_string()))?;
    if let Some(instability) = found.instability {
        return Err(refused(format!("an equilibrium that is not stable: {instability}")));
    }
    setup.q.copy_from_slice(&simulation.state().q);
    positioning(&mut setup.forces).zip(biases).for_each(|(positioning, bias)| positioning.bias = bias);
    Ok(())
}

/// The same over another scalar: the equilibria of the setups side by side, or one with its
/// derivatives.
pub fn follow<S: Quantity>(alone: &[&Setup], setup: &mut Setup<S>) -> Result<(), FieldError> {
    for i in free_positions(&setup.model) {
        setup.q[i] = S::of_each(|k| alone[k].q[i]);
    }
    for (i, positioning) in positioning(&mut setup.forces).enumerate() {
        positioning.bias = core::array::from_fn(|axis| S::of_each(|k| biases(&alone[k].forces)[i][axis]));
    }
    if S::HAS_DERIVATIVES {
        differentiate(alone[0], setup)?;
    }
    Ok(())
}

fn positioning<S: Scalar>(forces: &mut [Force<S>]) -> impl Iterator<Item = &mut DynamicPositioning<S>> {
    forces.iter_mut().filter_map(Force::dynamic_positioning_mut)
}

fn biases(forces: &[Force]) -> Vec<[f64; 3]> {
    forces.iter().filter_map(Force::dynamic_positioning).map(|positioning| positioning.bias).collect()
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

/// Handovers to the integrals of dynamic positioning: each leaves a hundredth or so of the derivatives' errors.
const HANDOVERS: usize = 12;

/// One more of Newton's moves, whose value is nothing and whose derivatives are the equilibrium's
/// (the implicit function theorem).
fn differentiate<S: Scalar>(plain: &Setup, setup: &mut Setup<S>) -> Result<(), FieldError> {
    let compliance = Simulation::new(plain.clone()).compliance();
    let compliance = compliance.ok_or_else(|| {
        FieldError::new(FIELD, "true, where nothing keeps the model in its place", "false, for a derivative")
    })?;
    let mut plant = Plant::new(setup.model.clone(), setup.forces.clone(), setup.drives.clone());
    plant.set_settling(true);
    let still = vec![S::ZERO; setup.v.len()];
    let s = plant.open_ledger(&setup.q, &still);
    let mut d = setup.inputs.iter().map(|input| S::constant(input.value)).collect();
    plant.first_held(&setup.q, &still, &mut d);
    let (mut v_dot, mut s_dot) = (still.clone(), vec![S::ZERO; s.len()]);
    let interval = Interval { start_s: 0.0, end_s: plain.settings.step_s };
    plant.watch_loops(&setup.q, &still);
    let free = plant.model.free_coordinates();
    let (mut xi, mut moved) = (still.clone(), setup.q.clone());
    let rounds = if plant.biases().is_empty() { 1 } else { HANDOVERS };
    for _ in 0..rounds {
        let at = Stage { time_s: 0.0, interval, q: &setup.q, v: &still, s: &s, d: &d };
        plant.rates(at, &mut v_dot, &mut s_dot);
        for (row, i) in free.iter().enumerate() {
            let along = free.iter().enumerate();
            xi[*i] = along.fold(S::ZERO, |sum, (column, j)| sum + S::constant(compliance[(row, column)]) * v_dot[*j]);
        }
        plant.retract(&setup.q, &xi, &mut moved);
        setup.q.copy_from_slice(&moved);
        plant.take_over(&setup.q, &still);
    }
    let biases = plant.biases();
    positioning(&mut setup.forces).zip(biases).for_each(|(positioning, bias)| positioning.bias = bias);
    Ok(())
}
