//! Runs that start at an equilibrium.

use super::super::schema::Scenario;
use super::FieldError;
use crate::elements::{AnyElement, EvaluationMode, Settling};
use crate::integrate::{Interval, Stage, System};
use crate::model::{Model, MotionType, Node};
use crate::plant::Plant;
use crate::scalar::Scalar;
use crate::scenario::leaf::Quantity;
use crate::simulation::{Setup, Simulation};
use crate::state::State;

const FIELD: &str = "simulation.begin_at_equilibrium";

/// Moves a setup to its equilibrium if the scenario asks for it; its velocities do not change.
pub fn settle(scenario: &Scenario, setup: &mut Setup) -> Result<(), FieldError> {
    if !scenario.simulation.begin_at_equilibrium {
        return Ok(());
    }
    let mut simulation = Simulation::new(setup.clone());
    let refused = |why: String| {
        let allowed = "true, for a model with an equilibrium near its initial position; else false";
        FieldError::new(FIELD, format!("true, and {why}"), allowed)
    };
    let (found, trims) = simulation.settle_with_trims().map_err(|error| refused(error.to_string()))?;
    if let Some(instability) = found.instability {
        return Err(refused(format!("an equilibrium that is not stable: {instability}")));
    }
    setup.q.copy_from_slice(&simulation.state().q);
    settling(&mut setup.elements).zip(trims).for_each(|(settling, trim)| settling.set_trim(&trim));
    Ok(())
}

/// Moves a setup over another scalar to the equilibria of the plain setups: one for each lane, or a single
/// one with its derivatives.
pub fn follow<S: Quantity>(alone: &[&Setup], setup: &mut Setup<S>) -> Result<(), FieldError> {
    for i in free_positions(&setup.model) {
        setup.q[i] = S::of_each(|k| alone[k].q[i]);
    }
    for (i, settling) in settling(&mut setup.elements).enumerate() {
        let entry = |entry: usize| S::of_each(|k| trim_of(&alone[k].elements, i, entry));
        let trim: Vec<S> = (0..settling.trim().len()).map(entry).collect();
        settling.set_trim(&trim);
    }
    if S::HAS_DERIVATIVES {
        differentiate(alone[0], setup)?;
    }
    Ok(())
}

/// Returns the elements that determine a holding force.
fn settling<S: Scalar>(elements: &mut [AnyElement<S>]) -> impl Iterator<Item = &mut dyn Settling<S>> {
    elements.iter_mut().filter_map(|element| element.settling_mut())
}

/// Returns an entry of the holding force that an element has determined.
fn trim_of(elements: &[AnyElement], which: usize, entry: usize) -> f64 {
    let mut trims = elements.iter().filter_map(|element| Some(element.settling()?.trim()));
    trims.nth(which).map_or(0.0, |trim| trim[entry])
}

/// Returns the indices in q of the free coordinates.
fn free_positions<S: Scalar>(model: &Model<S>) -> Vec<usize> {
    let of = |node: &Node<S>| {
        let rates = node.kind.velocity_count();
        let (quaternion, turns) = node.kind.quaternion().unwrap_or((node.kind.position_count(), rates));
        let free = |k: usize| model.modes[node.velocities + k] == MotionType::Free;
        let turned = if (turns..rates).any(free) { quaternion..quaternion + 4 } else { 0..0 };
        (0..turns).filter(|k| free(*k)).chain(turned).map(|k| node.positions + k).collect::<Vec<_>>()
    };
    model.tree.nodes.iter().flat_map(of).collect()
}

/// Number of transfers of the holding force to integrals: each reduces the errors of the derivatives to about
/// a hundredth.
const HANDOVERS: usize = 12;

/// Number of Newton steps without integrals: each reduces the errors of the derivatives to those of the compliance, which is
/// of forward differences, at most a thousandth.
const NEWTON_STEPS: usize = 4;

/// Takes more Newton steps: their value is 0, and their derivatives are those of the equilibrium (implicit function theorem).
fn differentiate<S: Scalar>(plain: &Setup, setup: &mut Setup<S>) -> Result<(), FieldError> {
    let compliance = Simulation::new(plain.clone()).compliance();
    let compliance = compliance.ok_or_else(|| {
        FieldError::new(FIELD, "true, for a model that nothing holds in position", "false, for a derivative")
    })?;
    let mut plant = Plant::new(setup.model.clone(), setup.world.clone(), setup.elements.clone());
    let still = vec![S::ZERO; setup.v.len()];
    let inputs: Vec<S> = plant.layout().inputs.iter().map(|input| S::constant(input.value)).collect();
    let mut state = State { q: setup.q.clone(), v: still.clone(), ..State::default() };
    // Friction is initialised as at the start of a run: a new search would take the present position as that
    // without friction.
    plant.begin(0.0, &inputs, &mut state);
    plant.set_evaluation_mode(EvaluationMode::Settling);
    plant.follow_restraints(0.0, &state, &mut setup.q);
    let State { s, d, m, .. } = state;
    let (mut v_dot, mut s_dot) = (still.clone(), vec![S::ZERO; s.len()]);
    let interval = Interval { start_s: 0.0, end_s: plain.settings.step_s };
    plant.watch_loops(&setup.q, &still);
    let free = plant.model.free_coordinates();
    let (mut xi, mut moved) = (still.clone(), setup.q.clone());
    let rounds = if plant.trims().is_empty() { NEWTON_STEPS } else { HANDOVERS };
    for _ in 0..rounds {
        let at = Stage { time_s: 0.0, interval, q: &setup.q, v: &still, s: &s, d: &d, m: &m };
        plant.rates(at, &mut v_dot, &mut s_dot);
        for (row, i) in free.iter().enumerate() {
            let along = free.iter().enumerate();
            xi[*i] = along.fold(S::ZERO, |sum, (column, j)| sum + S::constant(compliance[(row, column)]) * v_dot[*j]);
        }
        plant.retract(&setup.q, &xi, &mut moved);
        setup.q.copy_from_slice(&moved);
        plant.take_over(&setup.q, &still, &s);
    }
    let trims = plant.trims();
    settling(&mut setup.elements).zip(trims).for_each(|(settling, trim)| settling.set_trim(&trim));
    Ok(())
}
