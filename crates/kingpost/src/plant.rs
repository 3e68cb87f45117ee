//! The right-hand side: model, forces and drives put together for an integrator.

use crate::drives::{Clock, Drive};
use crate::dynamics::moving_frame::{MovingFrame, Variation};
use crate::dynamics::{Kinematics, LinkKinematics, Loads, energy, forward, inverse::InverseDynamics};
use crate::forces::Force;
use crate::integrate::{Interval, Sizes, Stage, System};
use crate::ledger::{self, Entries, JointLoad};
use crate::model::{JointKind, Mode, Model};
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
    links: LinkKinematics,
    bodies: Kinematics,
    loads: Loads,
    work: forward::Workspace,
    inverse: InverseDynamics,
    rotation_rates: Vec<bool>,
}

impl Plant {
    /// Puts a plant together.
    pub fn new(model: Model, forces: Vec<Force>, drives: Vec<Drive>) -> Self {
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
            links: LinkKinematics::new(&model),
            bodies: Kinematics::new(&model.tree),
            loads: Loads::with_room_for(&model, forces.len()),
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
                let given = |(mode, a): (&Mode, &f64)| if *mode == Mode::Prescribed { *a } else { 0.0 };
                let accelerations = self.model.modes.iter().zip(&self.loads.acceleration).map(given);
                v_dot.iter_mut().zip(accelerations).for_each(|(v_dot, given)| *v_dot = given);
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
        let totals = self.totals_here(at.q);
        Observation { model: &self.model, bodies: &self.bodies, inverse: &self.inverse, totals }
    }

    /// Frames and twists of the bodies at a state.
    pub fn body_kinematics(&mut self, q: &[f64], v: &[f64]) -> &Kinematics {
        self.bodies.update(&self.model.tree, q, v);
        &self.bodies
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

    /// Gives prescribed coordinates the rate that they have at the start of an interval.
    pub fn prescribe(&self, interval: Interval, v: &mut [f64]) {
        let middle_s = 0.5 * (interval.start_s + interval.end_s);
        for drive in &self.drives {
            if let Drive::Prescribed(motion) = drive {
                v[motion.coordinate] = motion.rate_at(Clock { time_s: interval.start_s, middle_s });
            }
        }
    }

    /// Energy and momentum at a state.
    pub fn totals(&mut self, q: &[f64], v: &[f64]) -> Totals {
        self.links.update(&self.model, q, v);
        self.bodies.update(&self.model.tree, q, v);
        self.totals_here(q)
    }

    /// The same, where the kinematics stands.
    fn totals_here(&self, q: &[f64]) -> Totals {
        let Self { model, links, bodies, .. } = self;
        let centre = ledger::reference_point(model, q);
        let (linear_momentum, angular_momentum) = energy::momentum(&model.tree, bodies, centre);
        Totals {
            kinetic_energy: energy::kinetic_energy(&model.tree, bodies),
            potential_energy: self.forces.iter().map(|force| force.potential_energy(model, links)).sum(),
            linear_momentum,
            angular_momentum,
        }
    }

    /// The ledger's entries for a run that begins here.
    pub fn open_ledger(&mut self, q: &[f64], v: &[f64]) -> Vec<f64> {
        let mut s = vec![0.0; ledger::COUNT];
        let totals = self.totals(q, v);
        s[ledger::INITIAL_ENERGY] = totals.kinetic_energy + totals.potential_energy;
        totals.linear_momentum.write_to(&mut s[ledger::LINEAR_MOMENTUM..]);
        totals.angular_momentum.write_to(&mut s[ledger::ANGULAR_MOMENTUM..]);
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
    /// Energy and momentum.
    pub totals: Totals,
}

/// Energy and momentum of all bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Totals {
    /// J.
    pub kinetic_energy: f64,
    /// J.
    pub potential_energy: f64,
    /// kg m/s, world.
    pub linear_momentum: Vector3,
    /// N m s about [`ledger::reference_point`], world.
    pub angular_momentum: Vector3,
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
        let Self { model, links, bodies, loads, work, inverse, .. } = self;
        let (has_fixed, centre) = (self.form != Form::Recursive, ledger::reference_point(model, at.q));
        let tree = if has_fixed { &model.tree } else { &model.links };
        let entries = Entries { model, tree, has_fixed, links, v: at.v, loads, centre };
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
        self.model.links.retract(q, xi, out);
    }

    fn dexp_inverse(&self, xi: &[f64], v: &[f64], out: &mut [f64]) {
        self.model.links.dexp_inverse(xi, v, out);
    }

    fn is_rotation_rate(&self, coordinate: usize) -> bool {
        self.rotation_rates[coordinate]
    }
}
