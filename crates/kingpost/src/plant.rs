//! The right-hand side: model, forces and drives put together for an integrator.

use crate::drives::{Clock, Drive};
use crate::dynamics::moving_frame::{MovingFrame, Variation};
use crate::dynamics::{Kinematics, LinkKinematics, Loads, energy, forward, inverse::InverseDynamics};
use crate::forces::Force;
use crate::integrate::{Interval, Sizes, Stage, System};
use crate::ledger::{self, Entries, JointLoad};
use crate::model::{JointKind, Model};
use crate::spatial::Vector3;

/// Which form of the equations of motion is solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// The recursion: fast, allocates nothing.
    #[default]
    Recursive,
    /// The matrices of the moving frame method, with this variation of the angular velocity.
    MovingFrame(Variation),
}

/// Model, forces and drives, with the working memory to evaluate them.
#[derive(Clone, Debug)]
pub struct Plant {
    /// The mechanical model.
    pub model: Model,
    /// Loads on bodies.
    pub forces: Vec<Force>,
    /// What moves the joints.
    pub drives: Vec<Drive>,
    /// The form of the equations.
    pub form: Form,
    /// Whether the ledger's integrals are stepped.
    pub keeps_ledger: bool,
    /// The point that angular momentum is about, m, world.
    pub centre: Vector3,
    links: LinkKinematics,
    bodies: Kinematics,
    loads: Loads,
    work: forward::Workspace,
    inverse: InverseDynamics,
    rotation_rates: Vec<bool>,
}

impl Plant {
    /// Puts a plant together; `q` is where the run begins.
    pub fn new(model: Model, forces: Vec<Force>, drives: Vec<Drive>, q: &[f64]) -> Self {
        let rotation_rates = model
            .tree
            .nodes
            .iter()
            .flat_map(|node| {
                let floating = matches!(node.kind, JointKind::Floating(_));
                (0..node.kind.velocity_count()).map(move |i| floating && i >= 3)
            })
            .collect();
        Self {
            centre: ledger::reference_point(&model, q),
            links: LinkKinematics::new(&model),
            bodies: Kinematics::new(&model.tree),
            loads: Loads::new(&model),
            work: forward::Workspace::new(&model),
            inverse: InverseDynamics::new(&model),
            rotation_rates,
            model,
            forces,
            drives,
            form: Form::default(),
            keeps_ledger: true,
        }
    }

    /// Kinematics of the links and loads at a stage.
    fn evaluate_loads(&mut self, at: Stage<'_>) {
        let middle_s = 0.5 * (at.interval.start_s + at.interval.end_s);
        let clock = Clock { time_s: at.time_s, middle_s };
        self.links.update(&self.model, at.q, at.v);
        self.loads.clear();
        for force in &self.forces {
            force.apply(&self.model, &self.links, at.v, &mut self.loads);
        }
        for drive in &self.drives {
            drive.apply(clock, at.q, at.v, at.d, &mut self.loads);
        }
    }

    /// Accelerations of all coordinates under the loads that were evaluated last.
    fn accelerate(&mut self, q: &[f64], v: &[f64], v_dot: &mut [f64]) {
        match self.form {
            Form::Recursive => {
                forward::forward_dynamics(&self.model, &self.links, v, &self.loads, &mut self.work, v_dot);
            }
            Form::MovingFrame(variation) => {
                let matrices = MovingFrame::assemble(&self.model, q, v, &self.loads, variation);
                v_dot.copy_from_slice(&self.loads.acceleration);
                let solved = matrices.acceleration();
                for (k, &i) in matrices.free.iter().enumerate() {
                    v_dot[i] = solved.as_ref().map_or(f64::NAN, |a| a[k]);
                }
                self.bodies.update(&self.model.tree, q, v);
                self.inverse.update(&self.model, &self.bodies, v, v_dot, &self.loads);
            }
        }
    }

    /// Every quantity of the bodies at a state, for the results.
    pub fn observe(&mut self, at: Stage<'_>, v_dot: &mut [f64]) -> Observation<'_> {
        self.evaluate_loads(at);
        self.accelerate(at.q, at.v, v_dot);
        self.bodies.update(&self.model.tree, at.q, at.v);
        self.inverse.update(&self.model, &self.bodies, at.v, v_dot, &self.loads);
        Observation { model: &self.model, bodies: &self.bodies, inverse: &self.inverse, loads: &self.loads }
    }

    /// The loads and the matrices of the method at a state.
    pub fn matrices(&mut self, at: Stage<'_>) -> MovingFrame {
        self.evaluate_loads(at);
        let variation = match self.form {
            Form::MovingFrame(variation) => variation,
            Form::Recursive => Variation::Restricted,
        };
        MovingFrame::assemble(&self.model, at.q, at.v, &self.loads, variation)
    }

    /// Accelerations of all coordinates, with `tau` (by coordinate, N or N m) beside the plant's own loads.
    pub fn acceleration(&mut self, at: Stage<'_>, tau: Option<&[f64]>, v_dot: &mut [f64]) {
        self.evaluate_loads(at);
        for (force, tau) in self.loads.force.iter_mut().zip(tau.unwrap_or_default()) {
            *force += tau;
        }
        self.accelerate(at.q, at.v, v_dot);
    }

    /// Kinetic and potential energy, J.
    pub fn energy(&mut self, q: &[f64], v: &[f64]) -> (f64, f64) {
        self.links.update(&self.model, q, v);
        let potential = self.forces.iter().map(|force| force.potential_energy(&self.model, &self.links)).sum();
        self.bodies.update(&self.model.tree, q, v);
        (energy::kinetic_energy(&self.model.tree, &self.bodies), potential)
    }

    /// Linear momentum and angular momentum about `centre`, world.
    pub fn momentum(&mut self, q: &[f64], v: &[f64]) -> (Vector3, Vector3) {
        self.bodies.update(&self.model.tree, q, v);
        energy::momentum(&self.model.tree, &self.bodies, self.centre)
    }

    /// The ledger's entries for a run that begins here.
    pub fn open_ledger(&mut self, q: &[f64], v: &[f64]) -> Vec<f64> {
        let mut s = vec![0.0; ledger::COUNT];
        let ((kinetic, potential), (linear, angular)) = (self.energy(q, v), self.momentum(q, v));
        s[ledger::INITIAL_ENERGY] = kinetic + potential;
        linear.write_to(&mut s[ledger::LINEAR_MOMENTUM..]);
        angular.write_to(&mut s[ledger::ANGULAR_MOMENTUM..]);
        s
    }
}

/// Borrowed results of [`Plant::observe`].
pub struct Observation<'a> {
    /// The model.
    pub model: &'a Model,
    /// Kinematics of `model.tree`.
    pub bodies: &'a Kinematics,
    /// Accelerations and joint wrenches of the bodies.
    pub inverse: &'a InverseDynamics,
    /// The loads.
    pub loads: &'a Loads,
}

impl System for Plant {
    fn sizes(&self) -> Sizes {
        Sizes {
            positions: self.model.position_count,
            velocities: self.model.velocity_count,
            extras: if self.keeps_ledger { ledger::COUNT } else { 0 },
        }
    }

    fn rates(&mut self, at: Stage<'_>, v_dot: &mut [f64], s_dot: &mut [f64]) {
        self.evaluate_loads(at);
        self.accelerate(at.q, at.v, v_dot);
        if !self.keeps_ledger {
            return;
        }
        let Self { model, links, bodies, loads, work, inverse, centre, .. } = self;
        let tree = if self.form == Form::Recursive { &model.links } else { &model.tree };
        let entries = Entries { model, tree, links, v: at.v, loads, centre: *centre };
        match self.form {
            Form::Recursive => entries.rates(
                |i| {
                    let (frame, wrench) = (links.root_in_world[model.roots[i]], work.joint_wrench(i));
                    JointLoad { frame, wrench, along_axis: wrench.dot(&links.axis[i]) }
                },
                s_dot,
            ),
            Form::MovingFrame(_) => entries.rates(
                |i| {
                    let wrench = inverse.joint_wrench[i];
                    let along_axis = tree.nodes[i].kind.axis_twist().map_or(0.0, |axis| wrench.dot(axis));
                    JointLoad { frame: bodies.world[i], wrench, along_axis }
                },
                s_dot,
            ),
        }
    }

    fn retract(&self, q: &[f64], xi: &[f64], out: &mut [f64]) {
        self.model.tree.retract(q, xi, out);
    }

    fn dexp_inverse(&self, xi: &[f64], v: &[f64], out: &mut [f64]) {
        self.model.tree.dexp_inverse(xi, v, out);
    }

    fn is_rotation_rate(&self, coordinate: usize) -> bool {
        self.rotation_rates[coordinate]
    }
}

/// A stage at an instant: the interval that begins there decides which pieces of laws hold.
pub fn instant<'a>(time_s: f64, step_s: f64, q: &'a [f64], v: &'a [f64], d: &'a [f64]) -> Stage<'a> {
    Stage { time_s, interval: Interval { start_s: time_s, end_s: time_s + step_s }, q, v, s: &[], d }
}
