//! Forces between the hulls of one database: added mass and radiated waves.

use super::coordinates::{Seen, States};
use super::{HullSpacing, Radiation, WaveCoordinates, of_modes};
use crate::dynamics::Loads;
use crate::elements::{AnyWatcher, Context, Declaration, Element, Output, VectorFrame};
use crate::scalar::Scalar;
use crate::sea::database::SixBySix;
use crate::spatial::{CrossInertia, Frame, Matrix3, Wrench};

/// Hulls that feel each other through the water, to first order in the motions.
///
/// With w the rates along the axes of each hull's wave loads ([`SeaAxes`](super::SeaAxes)), hull i has, in addition to its own
/// forces,
///
/// ```text
/// F_i = -sum_j (A_ij w_j' + integral_0^t K_ij(t - tau) w_j(tau) dtau)
/// ```
///
/// with the added mass at infinite frequency A and the memory K of the database (W. E. Cummins, *Schiffstechnik* 9, 1962, with
/// the rows and columns of all hulls). Each hull keeps the states of the waves that it
/// radiates; here they act on the others. Each hull's axes are its own, so a hull that drifts or turns a little takes its
/// coefficients with it. The momentum of the water, `A_ij` times the velocity of hull j, turns with hull i as that of its own
/// added mass does ([`AddedMass`](super::AddedMass)). The attraction of hulls that move slowly side by side, the derivative of A
/// with respect to their places, is left out.
#[derive(Clone, Debug)]
pub struct HullInteraction<S: Scalar = f64> {
    hulls: Vec<CoupledHull<S>>,
    added_mass: Vec<AddedBetween<S>>,
    /// By the hull on which the waves act and the hull that radiates them.
    memory: Vec<([usize; 2], Radiation)>,
    spacings: Vec<HullSpacing>,
    /// Kinetic energies, by hull.
    energies: Vec<S>,
    /// The hulls at the moment of the last evaluation.
    seen: Vec<Seen<S>>,
    forces: Vec<[S; 6]>,
}

/// A hull among others.
#[derive(Clone, Debug)]
pub struct CoupledHull<S = f64> {
    /// Name of its force in the scenario.
    pub name: String,
    /// The coordinates of its wave loads.
    pub coordinates: WaveCoordinates<S>,
    /// Whether waves act on it.
    pub in_waves: bool,
    /// Whether it has the memory of radiated waves: its added mass is then that of its average attitude.
    pub remembers: bool,
}

/// Added mass between two hulls, in the axes of their coefficients.
#[derive(Clone, Copy, Debug)]
struct AddedBetween<S> {
    /// The first before the second.
    pair: [usize; 2],
    /// At infinite frequency: the inertia for fast motions.
    infinite: CrossInertia<S>,
    /// At frequency zero: the inertia for slow motions, including the contribution of the radiation memory.
    slow: CrossInertia<S>,
}

impl<S: Scalar> HullInteraction<S> {
    /// Returns the interaction of these hulls.
    ///
    /// # Arguments
    /// * `added_mass` - By the hulls, the first before the second, if it acts.
    /// * `memory` - By the hull on which the waves act and the hull that radiates them, if it acts.
    /// * `spacings` - Watchers of the distances.
    pub fn new(
        hulls: Vec<CoupledHull<S>>,
        added_mass: &[([usize; 2], SixBySix)],
        memory: Vec<([usize; 2], Radiation)>,
        spacings: Vec<HullSpacing>,
    ) -> Self {
        let remembered = |pair: [usize; 2]| {
            let own = memory.iter().find(|(of, _)| *of == pair);
            own.map_or([[0.0; 6]; 6], |(_, radiation)| radiation.added_mass())
        };
        let between = |(pair, block): &([usize; 2], SixBySix)| {
            let (there, back) = (remembered(*pair), remembered([pair[1], pair[0]]));
            let slow: SixBySix =
                core::array::from_fn(|i| core::array::from_fn(|j| block[i][j] + 0.5 * (there[i][j] + back[j][i])));
            AddedBetween { pair: *pair, infinite: cross_inertia(block), slow: cross_inertia(&slow) }
        };
        let added_mass = added_mass.iter().map(between).collect();
        let (seen, forces) = (Vec::with_capacity(hulls.len()), vec![[S::ZERO; 6]; hulls.len()]);
        let energies = vec![S::ZERO; hulls.len()];
        Self { hulls, added_mass, memory, spacings, energies, seen, forces }
    }

    fn see(&mut self, at: &Context<'_, S>) {
        self.seen.clear();
        let of = |(k, hull): (usize, &CoupledHull<S>)| hull.coordinates.seen(&at.of_other(k));
        self.seen.extend(self.hulls.iter().enumerate().map(of));
    }

    /// Writes the forces of the waves that the others have radiated.
    fn remember(&mut self, at: &Context<'_, S>) {
        self.forces.fill([S::ZERO; 6]);
        for ([on, by], radiation) in &self.memory {
            let force = radiation.force(States::of(at.of_other(*by).states).radiation);
            self.forces[*on].iter_mut().zip(force).for_each(|(sum, force)| *sum += force);
        }
    }

    fn body(&self, hull: usize) -> usize {
        self.hulls[hull].coordinates.coefficients.body
    }

    /// Adds the inertia between two hulls, and the loads by which the forces of the water differ from those of Kirchhoff's
    /// equations with it.
    fn couple(&self, at: &Context<'_, S>, added: &AddedBetween<S>, loads: &mut Loads<S>) {
        let (pair, in_bodies) = (added.pair, self.in_bodies(added));
        let [on_first, on_second] =
            if self.is_in_waves() { self.in_waves(at, added) } else { self.in_current(at, added, &in_bodies) };
        let [first, second] = pair.map(|hull| &self.seen[hull].twist);
        let on_first = first.cross_momentum(&in_bodies.times(second)) - on_first;
        let on_second = second.cross_momentum(&in_bodies.transpose_times(first)) - on_second;
        self.press(pair[0], on_first, loads);
        self.press(pair[1], on_second, loads);
        loads.added_inertia_between.push((pair.map(|hull| self.body(hull)), in_bodies));
    }

    fn is_in_waves(&self) -> bool {
        self.hulls.iter().any(|hull| hull.in_waves)
    }

    /// Returns the inertia between two bodies: `T_1^T A T_2` in waves, otherwise A at the hulls' average attitudes.
    fn in_bodies(&self, added: &AddedBetween<S>) -> CrossInertia<S> {
        let AddedBetween { pair, infinite, .. } = added;
        if self.is_in_waves() {
            let [first, second] = pair.map(|hull| &self.seen[hull].axes);
            return CrossInertia::from_columns(|twist| first.wrench_to_body(&infinite.times(&second.rates(twist))));
        }
        let [first, second] = pair.map(|hull| self.coefficients_in_body(hull));
        infinite.to_parents(&first, &second)
    }

    /// Returns the axes of a hull's coefficients on its body, without waves.
    fn coefficients_in_body(&self, hull: usize) -> Frame<S> {
        let CoupledHull { coordinates, remembers, .. } = &self.hulls[hull];
        let on = &coordinates.coefficients;
        if *remembers { self.seen[hull].axes.level_in_body(on) } else { on.in_body }
    }

    /// Returns minus the velocity terms of the loads in waves: of the first `T_1^T (A T_2' nu_2 + Q)`, with Q of the slow
    /// velocities as in the hull's own added mass. A table of current coefficients does not contain Munk's moment of this Q.
    fn in_waves(&self, at: &Context<'_, S>, added: &AddedBetween<S>) -> [Wrench<S>; 2] {
        let AddedBetween { pair, infinite, slow } = added;
        let [first, second] = pair.map(|hull| &self.seen[hull]);
        let [by_first, by_second] = [first, second].map(|seen| seen.axes.drift(&seen.twist, seen.off[1]));
        let [one, other] = pair.map(|hull| self.hulls[hull].coordinates.slowly(&at.of_other(hull)));
        let on_first = infinite.times(&by_second) + one.relative.cross_momentum(&slow.times(&other.relative))
            - slow.times(&other.turned);
        let on_second = infinite.transpose_times(&by_first)
            + other.relative.cross_momentum(&slow.transpose_times(&one.relative))
            - slow.transpose_times(&one.turned);
        [first.axes.wrench_to_body(&on_first), second.axes.wrench_to_body(&on_second)]
    }

    /// Returns minus the velocity terms of the loads in a current u: of the first `A omega_2 x R_2^T u + nu_r1 x* A_0 nu_r2`.
    fn in_current(&self, at: &Context<'_, S>, added: &AddedBetween<S>, in_bodies: &CrossInertia<S>) -> [Wrench<S>; 2] {
        let [first, second] = added.pair.map(|hull| self.coefficients_in_body(hull));
        let slow = added.slow.to_parents(&first, &second);
        let [one, other] = added.pair.map(|hull| self.hulls[hull].coordinates.in_stream(at, &self.seen[hull].twist));
        [
            in_bodies.times(&other.turned) + one.relative.cross_momentum(&slow.times(&other.relative)),
            in_bodies.transpose_times(&one.turned)
                + other.relative.cross_momentum(&slow.transpose_times(&one.relative)),
        ]
    }

    /// Adds a load on a hull's body, and its work.
    fn press(&self, hull: usize, load: Wrench<S>, loads: &mut Loads<S>) {
        loads.power.outside += load.dot(&self.seen[hull].twist);
        loads.wrenches.push((self.body(hull), load));
    }
}

impl<S: Scalar> Element<S> for HullInteraction<S> {
    fn declare(&self) -> Declaration {
        Declaration {
            sees: self.hulls.iter().map(|hull| hull.name.clone()).collect(),
            outputs: self.hulls.iter().flat_map(|hull| outputs(&hull.name)).collect(),
            ..Declaration::default()
        }
    }

    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        self.see(at);
        self.remember(at);
        self.added_mass.iter().for_each(|added| self.couple(at, added, loads));
        for hull in 0..self.hulls.len() {
            let load = self.seen[hull].axes.wrench_to_body(&of_modes(self.forces[hull]));
            self.press(hull, load, loads);
        }
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        self.see(at);
        self.remember(at);
        self.energies.fill(S::ZERO);
        for added in &self.added_mass {
            let [first, second] = added.pair.map(|hull| &self.seen[hull].twist);
            let half = self.in_bodies(added).times(second).dot(first) * S::constant(0.5);
            added.pair.iter().for_each(|hull| self.energies[*hull] += half);
        }
        for (forces, energy) in self.forces.iter().zip(&self.energies) {
            out.extend(forces);
            out.push(*energy);
        }
    }

    fn watchers(&self) -> Vec<AnyWatcher> {
        self.spacings.iter().map(|spacing| -> AnyWatcher { Box::new(spacing.clone()) }).collect()
    }
}

/// Returns the outputs for one hull, in the order of writing.
fn outputs(hull: &str) -> [Output; 2] {
    [
        Output::wrench(
            "interaction_force",
            "force of the waves that the other hulls of its database radiate, without added mass, with the moment about the hull's \
             reference point",
            "hull",
            hull,
            VectorFrame::SlowFrame,
        ),
        Output::number(
            "interaction_kinetic_energy",
            "half the kinetic energy of the added mass between the hull and the others, at infinite frequency",
            "hull",
            hull,
            &["J"],
        ),
    ]
}

/// Returns a block of a database, in which forces come first, as an inertia, in which moments come first.
fn cross_inertia<S: Scalar>(block: &SixBySix) -> CrossInertia<S> {
    let part = |row: usize, column: usize| Matrix3::from_fn(|i, j| S::constant(block[row + i][column + j]));
    CrossInertia {
        angular: part(3, 3),
        moment_by_velocity: part(3, 0),
        force_by_turning: part(0, 3),
        linear: part(0, 0),
    }
}
