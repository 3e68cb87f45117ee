//! Access for callers: reads and sets state, snapshots and inputs; returns poses and matrices.

use super::errors::check_array;
use super::{Input, InputError, Setup, Simulation, Watching, stage};
use crate::dynamics::moving_frame::{Equations, MovingFrame, Naming, Symbols};
use crate::model::MotionType;
use crate::plant::{Number, Plant, Tangent};
use crate::spatial::{Frame, Quaternion};
use crate::state::{SnapshotError, State};

/// Largest gap of a closed loop in a state that a caller sets, m or rad: the next step closes it.
pub(super) const LARGEST_GAP_GIVEN: f64 = 1e-6;

impl Simulation {
    /// Gives an implicit scheme exact derivatives, from the same setup over dual numbers; otherwise it uses
    /// differences.
    pub fn differentiate_with(&mut self, setup: Setup<Number>) {
        let Setup { model, world, elements, q, v, .. } = setup;
        let mut plant = Plant::new(model, world, elements);
        plant.watch_loops(&q, &v);
        self.plant.differentiate_with(Tangent::new(plant));
    }

    /// Creates a simulation at time 0.
    pub fn new(setup: Setup) -> Self {
        let form = setup.settings.form;
        let of_elements = setup.elements.iter().flat_map(|element| element.watchers());
        let watchers = setup.watchers.iter().cloned().chain(of_elements).collect();
        let mut simulation = Self::recursive(setup);
        simulation.watching = Watching::new(watchers, &simulation.channels);
        simulation.plant.set_form(form);
        simulation
    }

    /// Returns position (m) and unit quaternion (w, x, y, z) of every body, world; seven numbers per body.
    pub fn poses(&mut self) -> Vec<f64> {
        let bodies = self.plant.body_kinematics(&self.state.q, &self.state.v);
        let pose = |frame: &Frame| {
            let [x, y, z] = frame.position.0;
            let [w, a, b, c] = Quaternion::from_matrix(&frame.rotation).0;
            [x, y, z, w, a, b, c]
        };
        bodies.world.iter().flat_map(pose).collect()
    }

    /// Returns the elevation of the incident waves at the present time, m, at every grid point of x and y,
    /// world, m: first all points of the first x.
    pub fn surface(&self, x: &[f64], y: &[f64]) -> Vec<f64> {
        self.plant.world.elevations_m(x, y, self.time_s())
    }

    /// Replaces q, v and, if given, s. Without s the ledger restarts. The rate of a prescribed coordinate
    /// applies only until the next step, which sets the prescribed value.
    pub fn set_state(&mut self, q: &[f64], v: &[f64], s: Option<&[f64]>) -> Result<(), InputError> {
        let mut next = self.state.clone();
        next.q = q.to_vec();
        next.v = v.to_vec();
        self.check_motion(&next)?;
        for first in self.plant.model.quaternions() {
            let quaternion = &mut next.q[first..first + 4];
            let unit = Quaternion::from_slice(quaternion).normalized();
            quaternion.copy_from_slice(&unit.0);
        }
        if let Some((constraint, found)) = self.plant.loop_gap(&next.q, v).filter(|(_, gap)| *gap >= LARGEST_GAP_GIVEN)
        {
            let constraint = self.plant.model.constraint_names().swap_remove(constraint);
            return Err(InputError::OpenLoop { constraint, found, allowed: LARGEST_GAP_GIVEN });
        }
        let inputs = self.state.d[..self.plant.layout().inputs.len()].to_vec();
        self.plant.begin(self.time_s(), &inputs, &mut next);
        if let Some(s) = s {
            check_array("s", s, self.state.s.len())?;
            next.s.copy_from_slice(s);
        }
        next.memory.fill(0.0);
        self.state = next;
        self.watching.begin_anew();
        self.limits.begin_anew();
        Ok(())
    }

    /// Returns an error unless q and v are a valid motion of this model.
    fn check_motion(&self, state: &State) -> Result<(), InputError> {
        let State { q, v, .. } = state;
        let model = &self.plant.model;
        check_array("q", q, model.position_count)?;
        check_array("v", v, model.velocity_count)?;
        let entry = |name, index, found, allowed| Err(InputError::Entry { name, index, found, allowed });
        if let Some(i) = (0..v.len()).find(|&i| model.modes[i] == MotionType::Held && v[i] != 0.0) {
            return entry("v", i, v[i], "0, for a coordinate that is held");
        }
        for first in model.quaternions() {
            let norm = libm::sqrt(q[first..first + 4].iter().map(|x| x * x).sum());
            // Six significant digits, as in files.
            if (norm - 1.0).abs() > 1e-6 {
                return entry("length of the quaternion that begins at q", first, norm, "1");
            }
        }
        Ok(())
    }

    /// Returns the state as bytes.
    pub fn snapshot(&self) -> Vec<u8> {
        self.state.snapshot(self.fingerprint)
    }

    /// Restores the state from a snapshot of a simulation with the same setup; the run continues bitwise
    /// identically. On an error nothing changes.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SnapshotError> {
        let mut next = self.state.clone();
        next.restore(bytes, self.fingerprint)?;
        self.take_state(&next);
        Ok(())
    }

    /// Continues from the state of another simulation with the same layout.
    pub(crate) fn take_state(&mut self, from: &State) {
        self.state.copy_from(from);
        self.steering.forget_after(self.state.steps);
        self.watch.forget_after(self.state.steps);
        self.watching.begin_anew();
        self.limits.begin_anew();
    }

    /// Returns all inputs with their present values.
    pub fn inputs(&self) -> Vec<Input> {
        let layout = self.plant.layout();
        let now = |(i, (input, value)): (usize, (&Input, &f64))| Input {
            value: *value,
            signal: layout.set_by(i).map(str::to_owned),
            ..input.clone()
        };
        layout.inputs.iter().zip(&self.state.d).enumerate().map(now).collect()
    }

    /// Sets an input, with effect from the next step.
    pub fn set_input(&mut self, name: &str, value: f64) -> Result<(), InputError> {
        let inputs = &self.plant.layout().inputs;
        let Some(i) = inputs.iter().position(|input| input.name == name) else {
            let names: Vec<&str> = inputs.iter().map(|input| input.name.as_str()).collect();
            let allowed = if names.is_empty() { "none: no drive has a lever".to_owned() } else { names.join(", ") };
            return Err(InputError::Unknown { found: name.to_owned(), allowed });
        };
        let Input { lower, upper, .. } = inputs[i];
        if let Some(signal) = self.plant.layout().set_by(i) {
            return Err(InputError::Wired { name: name.to_owned(), signal: signal.to_owned() });
        }
        if !(lower..=upper).contains(&value) {
            return Err(InputError::Range { name: name.to_owned(), found: value, lower, upper });
        }
        let time_s = self.time_s();
        self.plant.set_input(i, value, time_s, &mut self.state);
        self.note_brought_about(time_s, self.state.steps);
        self.steering.moved(self.state.steps, i, value);
        Ok(())
    }

    /// Returns the names of the free coordinates: the rows of M*, N* and F*.
    pub fn coordinates(&self) -> Vec<String> {
        let names = self.plant.model.coordinate_names();
        self.plant.model.free_coordinates().into_iter().map(|i| names[i].clone()).collect()
    }

    /// Returns the SI unit of each free coordinate: m for a translation, rad for a rotation.
    pub fn coordinate_units(&self) -> Vec<&'static str> {
        let turns = self.plant.model.turning_coordinates();
        self.plant.model.free_coordinates().into_iter().map(|i| if turns[i] { "rad" } else { "m" }).collect()
    }

    /// Returns the accelerations of the free coordinates at the present state, with the generalized forces
    /// `tau` (N or N m per free coordinate) added.
    pub fn acceleration(&mut self, tau: Option<&[f64]>) -> Result<Vec<f64>, InputError> {
        let free = self.plant.model.free_coordinates();
        let mut everywhere = vec![0.0; self.state.v.len()];
        if let Some(tau) = tau {
            check_array("tau", tau, free.len())?;
            free.iter().zip(tau).for_each(|(&i, tau)| everywhere[i] = *tau);
        }
        let at = stage(self.interval(), &self.state);
        self.plant.acceleration(at, Some(&everywhere), &mut self.v_dot);
        Ok(free.iter().map(|&i| self.v_dot[i]).collect())
    }

    /// Returns every matrix of the moving frame method at the present state.
    pub fn moving_frame(&mut self) -> MovingFrame {
        let at = stage(self.interval(), &self.state);
        self.plant.matrices(at)
    }

    /// Returns every matrix of the moving frame method at the present state, with labels and units, and the
    /// formulas of the matrices.
    pub fn equations(&mut self) -> Equations {
        let matrices = self.moving_frame().named(self.model());
        Equations { matrices, formulas: Symbols::new(self.model(), Naming::Numbers).matrices() }
    }

    /// Returns M* by rows (kg, kg m, kg m^2).
    pub fn mass_matrix(&mut self) -> Vec<f64> {
        self.moving_frame().m_star.as_slice().to_vec()
    }

    /// Returns N* q', the velocity-dependent terms (N, N m).
    pub fn bias_force(&mut self) -> Vec<f64> {
        self.moving_frame().bias_force().as_slice().to_vec()
    }
}
