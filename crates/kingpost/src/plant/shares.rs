//! How the extra states s and the discrete states d are shared among ledger, drives and forces.
//!
//! s: the ledger's entries, then the states of the drives, then those of the forces. d: the table of
//! inputs, then what the forces hold over a step.

use super::Plant;
use crate::dynamics::{Clock, LinkKinematics, Moment};
use crate::elements::Force;
use crate::elements::drives::Drive;
use crate::integrate::Stage;
use crate::model::Model;
use crate::scalar::Scalar;

/// Numbers of entries.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shares {
    /// Of s: the ledger's.
    pub(super) ledger: usize,
    /// Of s: the drives'.
    pub(super) drives: usize,
    /// Of s: the forces'.
    pub(super) forces: usize,
    /// Of d: the forces'.
    pub(super) held: usize,
}

/// What drives and forces see at a stage whose kinematics stands.
pub(super) struct Moments<'a, S> {
    pub(super) of_drives: Moment<'a, S>,
    pub(super) of_forces: Moment<'a, S>,
}

impl Shares {
    /// Length of s.
    pub(super) fn extras(self) -> usize {
        self.ledger + self.drives + self.forces
    }

    pub(super) fn moments<'a, S: Copy>(
        self,
        model: &'a Model<S>,
        links: &'a LinkKinematics<S>,
        at: Stage<'a, S>,
    ) -> Moments<'a, S> {
        let Stage { time_s, interval, .. } = at;
        let clock = Clock { time_s, middle_s: interval.middle_s() };
        let (drives, forces) =
            at.s.get(self.ledger..).unwrap_or_default().split_at_checked(self.drives).unwrap_or_default();
        let (inputs, held) = at.d.split_at(at.d.len().saturating_sub(self.held));
        let of_drives = Moment { clock, model, links, q: at.q, v: at.v, held: inputs, states: drives };
        Moments { of_drives, of_forces: Moment { held, states: forces, ..of_drives } }
    }

    /// Writes the rates of the states of drives and forces; returns the ledger's, which are left.
    pub(super) fn state_rates<'a, S: Scalar>(
        self,
        plant: &Plant<S>,
        at: Stage<'_, S>,
        s_dot: &'a mut [S],
    ) -> &'a mut [S] {
        let (ledger, rest) = s_dot.split_at_mut(self.ledger);
        let (drives, forces) = rest.split_at_mut(self.drives);
        let moments = self.moments(&plant.model, &plant.links, at);
        let Moment { held, states, .. } = moments.of_drives;
        for (state, rate) in plant.drives.iter().filter_map(|drive| drive.cylinder()?.state_rate(held, states)) {
            drives[state] = rate;
        }
        for hull in plant.forces.iter().filter_map(Force::hull) {
            hull.state_rates(&moments.of_forces, forces);
        }
        for positioning in plant.forces.iter().filter_map(Force::dynamic_positioning) {
            positioning.state_rates(&moments.of_forces, forces);
        }
        ledger
    }
}

impl<S: Scalar> Plant<S> {
    /// Number of discrete states that forces hold.
    pub fn held_count(&self) -> usize {
        self.forces.iter().map(Force::held_count).sum()
    }

    /// Number of extra states of the drives, which stand behind the ledger's.
    pub fn drive_state_count(&self) -> usize {
        self.shares().drives
    }

    /// For an equilibrium: takes the waves out of the sea, and holds what moves as prescribed.
    pub fn set_at_rest(&mut self, at_rest: bool) {
        self.at_rest = at_rest;
        self.forces.iter_mut().filter_map(Force::hull_mut).for_each(|hull| hull.calm = at_rest);
    }

    /// As [`set_at_rest`](Self::set_at_rest), and lets dynamic positioning hold its ship without delay.
    pub fn set_settling(&mut self, settling: bool) {
        self.set_at_rest(settling);
        let positioning = self.forces.iter_mut().filter_map(Force::dynamic_positioning_mut);
        positioning.for_each(|positioning| positioning.settling = settling);
        if let Some(tangent) = self.tangent_mut() {
            tangent.set_settling(settling);
        }
    }

    /// While an equilibrium is sought: the first dynamic positioning whose thrusters have not what holds its ship, and how
    /// much of what the one most in use has it takes.
    pub fn overloaded(&mut self, q: &[S], v: &[S]) -> Option<(&str, S)> {
        self.links.update(&self.model, q, v);
        let positioning = self.forces.iter().filter_map(Force::dynamic_positioning);
        let mut used = positioning.map(|station| (&*station.name, station.utilisation(&self.model, &self.links)));
        used.find(|(_, utilisation)| !utilisation.all(|utilisation| utilisation <= 1.0))
    }

    /// The integrals that dynamic positioning begins with, in the order of the forces.
    pub fn biases(&self) -> Vec<[S; 3]> {
        self.forces.iter().filter_map(Force::dynamic_positioning).map(|positioning| positioning.bias).collect()
    }

    /// Sets these.
    pub fn set_biases(&mut self, biases: &[[S; 3]]) {
        let positioning = self.forces.iter_mut().filter_map(Force::dynamic_positioning_mut);
        positioning.zip(biases).for_each(|(positioning, bias)| positioning.bias = *bias);
    }

    /// While an equilibrium is sought: hands what holds ships to the integrals of their dynamic positioning. Returns how
    /// far the ship that is furthest off still is, m or rad.
    pub fn take_over(&mut self, q: &[S], v: &[S]) -> S {
        self.links.update(&self.model, q, v);
        let Self { model, links, forces, .. } = self;
        let off = forces.iter_mut().filter_map(Force::dynamic_positioning_mut);
        let off = off.map(|positioning| positioning.take_over(model, links));
        let off = off.fold(S::ZERO, |most, off| most.select_less(off, || off, || most));
        let biases = self.biases();
        if let Some(tangent) = self.tangent_mut() {
            tangent.set_biases(&biases);
        }
        off
    }

    /// Appends to the inputs what forces hold where a run begins.
    pub fn first_held(&mut self, q: &[S], v: &[S], d: &mut Vec<S>) {
        let inputs = d.len();
        d.resize(inputs + self.held_count(), S::ZERO);
        self.links.update(&self.model, q, v);
        for hull in self.forces.iter().filter_map(Force::hull) {
            hull.first_held(&self.model, &self.links, &mut d[inputs..]);
        }
    }

    /// After a step of this length: what forces hold over the next.
    pub fn hold(&mut self, step_s: f64, q: &[S], v: &[S], d: &mut [S]) {
        let held = self.held_count();
        if held == 0 {
            return;
        }
        self.links.update(&self.model, q, v);
        let first = d.len() - held;
        for hull in self.forces.iter().filter_map(Force::hull) {
            hull.hold(&self.model, &self.links, step_s, &mut d[first..]);
        }
    }

    /// Names of the extra states behind the ledger's.
    pub fn state_names(&self) -> Vec<String> {
        let kept = self.drives.iter().filter(|drive| drive.has_state()).filter_map(Drive::cylinder);
        let of_drives = kept.map(|cylinder| format!("{}.wanted_length", cylinder.name));
        let of = |hull: &crate::elements::Hull<S>| {
            let names = hull.radiation.iter().flat_map(crate::elements::hull::Radiation::state_names);
            names.map(|name| format!("{}.{name}", hull.name)).collect::<Vec<_>>()
        };
        let hulls = self.forces.iter().filter_map(Force::hull).flat_map(of);
        let positioning = self.forces.iter().filter_map(Force::dynamic_positioning);
        of_drives.chain(hulls).chain(positioning.flat_map(|positioning| positioning.state_names())).collect()
    }
}
