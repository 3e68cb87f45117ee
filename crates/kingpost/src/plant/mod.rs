//! The right-hand side: model, forces and drives put together for an integrator.

mod observation;
mod shares;
mod tangent;

pub use observation::{Observation, Totals};
use shares::{Moments, Shares};
pub use tangent::{Along, DIRECTIONS, Number, Tangent};

use crate::dynamics::loops::{LoopFault, LoopSolver, Projection};
use crate::dynamics::moving_frame::{MovingFrame, Variation};
use crate::dynamics::{Clock, Kinematics, LinkKinematics, Loads, energy, forward, inverse::InverseDynamics};
use crate::elements::drives::{CylinderReading, Drive};
use crate::elements::{Force, LineReading, PositioningReading, ThrusterReading, hull::HullReading};
use crate::integrate::{Interval, Jacobian, Sizes, Stage, System};
use crate::ledger::{self, Entries, JointLoad};
use crate::model::{Mode, Model, Node};
use crate::scalar::Scalar;

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
pub struct Plant<S = f64> {
    /// The mechanical model.
    pub model: Model<S>,
    /// Loads on bodies.
    pub forces: Vec<Force<S>>,
    /// What moves the joints.
    pub drives: Vec<Drive<S>>,
    form: Form,
    /// How the matrices' form solves; that form is there for plain numbers only.
    solve_matrices: Option<SolveMatrices<S>>,
    /// Whether the ledger's integrals are stepped.
    pub keeps_ledger: bool,
    /// Whether there are no waves, and what moves as prescribed is held.
    at_rest: bool,
    links: LinkKinematics<S>,
    bodies: Kinematics<S>,
    loads: Loads<S>,
    work: forward::Workspace<S>,
    inverse: InverseDynamics<S>,
    loops: LoopSolver<S>,
    cylinders: Vec<CylinderReading<S>>,
    hulls: Vec<HullReading<S>>,
    lines: Vec<LineReading<S>>,
    flow_forces: Vec<[S; 6]>,
    positioning: Vec<PositioningReading<S>>,
    thrusters: Vec<ThrusterReading<S>>,
    rotation_rates: Vec<bool>,
    /// Evaluations of the right-hand side so far.
    pub evaluations: u64,
    exact: Option<Exact<S>>,
}

/// Exact derivatives, which are there for plain numbers only.
#[derive(Clone, Debug)]
struct Exact<S> {
    tangent: Box<Tangent>,
    jacobian: DifferentiateExactly<S>,
}

/// Writes what [`System::jacobian`] asks for, and says how many plain evaluations it was worth.
type DifferentiateExactly<S> = fn(&mut Tangent, base: &[S], xi: &[S], at: Stage<'_, S>, out: &mut Jacobian<S>) -> u64;

/// Solves for the accelerations `v_dot` at q, v under the loads evaluated last.
type SolveMatrices<S> = fn(&mut Plant<S>, q: &[S], v: &[S], v_dot: &mut [S]);

impl<S: Scalar> Plant<S> {
    /// Puts a plant together, its equations in the recursive form.
    pub fn new(model: Model<S>, forces: Vec<Force<S>>, drives: Vec<Drive<S>>) -> Self {
        let turns = |node: &Node<S>| {
            let first = node.kind.quaternion().map_or(usize::MAX, |(_, rates)| rates);
            (0..node.kind.velocity_count()).map(move |k| k >= first)
        };
        let rotation_rates = model.tree.nodes.iter().flat_map(turns).collect();
        Self {
            links: LinkKinematics::new(&model),
            bodies: Kinematics::new(&model.tree),
            loads: Loads::with_room_for(&model, forces.len() + 2 * (drives.len() + model.constraint_count())),
            work: forward::Workspace::new(&model),
            inverse: InverseDynamics::new(&model),
            loops: LoopSolver::new(&model),
            cylinders: Vec::with_capacity(drives.len()),
            hulls: Vec::with_capacity(forces.len()),
            lines: Vec::with_capacity(forces.len()),
            flow_forces: Vec::with_capacity(forces.len()),
            positioning: Vec::new(),
            thrusters: Vec::new(),
            rotation_rates,
            evaluations: 0,
            model,
            forces,
            drives,
            form: Form::default(),
            solve_matrices: None,
            exact: None,
            keeps_ledger: true,
            at_rest: false,
        }
    }

    /// Kinematics of the links and loads at a stage.
    fn evaluate_loads(&mut self, at: Stage<'_, S>) {
        self.links.update(&self.model, at.q, at.v);
        let (shares, at_rest) = (self.shares(), self.at_rest);
        let Self { model, links, forces, drives, loads, .. } = self;
        loads.clear();
        let moments = shares.moments(model, links, at);
        for force in forces.iter_mut() {
            force.apply(&moments.of_forces, loads);
        }
        for drive in
            drives.iter().filter(|drive| !(at_rest && matches!(drive, Drive::Prescribed(_) | Drive::WaveMotion(_))))
        {
            drive.apply(&moments.of_drives, loads);
        }
    }

    /// How s and d are shared.
    fn shares(&self) -> Shares {
        Shares {
            ledger: if self.keeps_ledger { ledger::COUNT } else { 0 },
            drives: self.drives.iter().filter(|drive| drive.has_state()).count(),
            forces: self.forces.iter().map(Force::state_count).sum(),
            held: self.held_count(),
        }
    }

    /// Accelerations of all coordinates under the loads that were evaluated last.
    fn accelerate(&mut self, q: &[S], v: &[S], v_dot: &mut [S]) {
        match self.solve_matrices {
            None => {
                forward::forward_dynamics(&self.model, &self.links, &self.loads, &mut self.work, v_dot);
                if !self.model.loops.is_empty() {
                    self.loops.accelerate(&self.model, &self.links, &mut self.work, v_dot);
                    self.loops.apply(&self.model, &self.links, &mut self.loads);
                }
            }
            Some(solve) => {
                solve(self, q, v, v_dot);
                self.bodies.update(&self.model.tree, q, v);
                self.inverse.update(&self.model, &self.bodies, v, v_dot, &self.loads);
            }
        }
    }

    /// Every quantity of the bodies at a state, for the results.
    pub fn observe(&mut self, at: Stage<'_, S>, v_dot: &mut [S]) -> Observation<'_, S> {
        self.evaluate_loads(at);
        self.accelerate(at.q, at.v, v_dot);
        self.bodies.update(&self.model.tree, at.q, at.v);
        self.inverse.update(&self.model, &self.bodies, at.v, v_dot, &self.loads);
        let totals = self.totals_here(at.q, at.v);
        let shares = self.shares();
        let Self { model, links, bodies, inverse, loops, forces, drives, .. } = self;
        let Self { cylinders, hulls, lines, flow_forces, positioning, thrusters, .. } = self;
        let Moments { of_drives, of_forces } = shares.moments(model, links, at);
        cylinders.clear();
        cylinders.extend(drives.iter().filter_map(Drive::cylinder).map(|cylinder| cylinder.reading(&of_drives)));
        hulls.clear();
        hulls.extend(forces.iter_mut().filter_map(Force::hull_mut).map(|hull| hull.reading(&of_forces)));
        flow_forces.clear();
        flow_forces.extend(forces.iter().filter_map(Force::flow_load).map(|load| load.reading(&of_forces)));
        lines.clear();
        lines.extend(forces.iter().filter_map(|force| force.line_reading(&of_forces)));
        let stations = || forces.iter().filter_map(Force::dynamic_positioning);
        positioning.clear();
        positioning.extend(stations().map(|station| station.reading(&of_forces)));
        thrusters.clear();
        thrusters.extend(stations().flat_map(|station| station.thruster_readings(&of_forces)));
        Observation {
            model,
            bodies,
            inverse,
            loops,
            cylinders,
            hulls,
            lines,
            flow_forces,
            positioning,
            thrusters,
            totals,
        }
    }

    /// Frames and twists of the bodies at a state.
    pub fn body_kinematics(&mut self, q: &[S], v: &[S]) -> &Kinematics<S> {
        self.bodies.update(&self.model.tree, q, v);
        &self.bodies
    }

    /// Accelerations of all coordinates, with `tau` (by coordinate, N or N m) beside the plant's own loads.
    pub fn acceleration(&mut self, at: Stage<'_, S>, tau: Option<&[S]>, v_dot: &mut [S]) {
        self.evaluate_loads(at);
        for (force, tau) in self.loads.force.iter_mut().zip(tau.unwrap_or_default()) {
            *force += *tau;
        }
        self.accelerate(at.q, at.v, v_dot);
    }

    /// Gives prescribed coordinates the rate that they have at the start of an interval.
    pub fn prescribe(&self, interval: Interval, v: &mut [S]) {
        let middle_s = interval.middle_s();
        for drive in &self.drives {
            if let Drive::WaveMotion(motion) = drive {
                v[motion.coordinates()].copy_from_slice(&motion.at(interval.start_s).rates);
            }
            if let Drive::Prescribed(motion) = drive {
                v[motion.coordinate] = motion.rate_at(Clock { time_s: interval.start_s, middle_s });
            }
        }
    }

    /// Begins to watch the closed loops: how far they are from a singular position is measured
    /// against where they stand here.
    pub fn watch_loops(&mut self, q: &[S], v: &[S]) {
        if !self.model.loops.is_empty() {
            let Self { model, links, work, loads, loops, .. } = self;
            loads.clear();
            loops.begin_at(&mut Projection { model, links, work, loads }, q, v);
        }
    }

    /// The constraint that is off by most at a state, and by how much, m or rad; `None` without loops.
    pub fn loop_gap(&mut self, q: &[S], v: &[S]) -> Option<(usize, f64)> {
        self.links.update(&self.model, q, v);
        self.loops.update_rows(&self.model, &self.links);
        let gaps = self.loops.rows().iter().map(|row| row.residual.value().abs()).enumerate();
        gaps.max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// After a step: brings the closed loops back to where they are closed, and tells where that is
    /// not possible. Allocates nothing.
    pub fn close_loops(&mut self, q: &mut [S], v: &mut [S]) -> Result<(), LoopFault> {
        if self.model.loops.is_empty() {
            return Ok(());
        }
        let Self { model, links, work, loads, loops, .. } = self;
        loops.close(&mut Projection { model, links, work, loads }, q, v)
    }

    /// Energy and momentum at a state.
    pub fn totals(&mut self, q: &[S], v: &[S]) -> Totals<S> {
        self.links.update(&self.model, q, v);
        self.bodies.update(&self.model.tree, q, v);
        self.totals_here(q, v)
    }

    /// The same, where the kinematics stands.
    fn totals_here(&mut self, q: &[S], v: &[S]) -> Totals<S> {
        let Self { model, forces, drives, links, bodies, .. } = self;
        let stored = drives.iter().fold(S::ZERO, |sum, drive| sum + drive.potential_energy(model, links));
        let centre = ledger::reference_point(model, q);
        let (linear_momentum, angular_momentum) = energy::momentum(&model.tree, bodies, centre);
        Totals {
            kinetic_energy: energy::kinetic_energy(&model.tree, bodies) + energy::rotor_energy(model, v),
            potential_energy: forces
                .iter_mut()
                .fold(stored, |sum, force| sum + force.potential_energy(model, links, q)),
            linear_momentum,
            angular_momentum,
        }
    }

    fn tangent_mut(&mut self) -> Option<&mut Tangent> {
        self.exact.as_mut().map(|exact| &mut *exact.tangent)
    }

    /// The extra states for a run that begins here: the ledger's entries, those of the drives, those of the forces.
    pub fn open_ledger(&mut self, q: &[S], v: &[S]) -> Vec<S> {
        let mut s = vec![S::ZERO; ledger::COUNT];
        let totals = self.totals(q, v);
        s[ledger::INITIAL_ENERGY] = totals.kinetic_energy + totals.potential_energy;
        totals.linear_momentum.write_to(&mut s[ledger::LINEAR_MOMENTUM..]);
        totals.angular_momentum.write_to(&mut s[ledger::ANGULAR_MOMENTUM..]);
        let cylinders = self.drives.iter().filter_map(Drive::cylinder);
        s.extend(cylinders.filter_map(|cylinder| cylinder.first_state(&self.model, &self.links)));
        let shares = self.shares();
        s.resize(shares.extras(), S::ZERO);
        let of_forces = s.len() - shares.forces;
        for hull in self.forces.iter().filter_map(Force::hull) {
            hull.first_states(&self.model, &self.links, &mut s[of_forces..]);
        }
        for positioning in self.forces.iter().filter_map(Force::dynamic_positioning) {
            positioning.first_states(&self.model, &self.links, &mut s[of_forces..]);
        }
        s
    }
}

impl Plant {
    /// Takes derivatives from the same plant over dual numbers, instead of from differences.
    pub fn differentiate_with(&mut self, tangent: Tangent) {
        self.exact = Some(Exact { tangent: Box::new(tangent), jacobian: Tangent::jacobian });
    }

    /// Chooses the form of the equations of motion.
    pub fn set_form(&mut self, form: Form) {
        self.form = form;
        self.solve_matrices = match form {
            Form::Recursive => None,
            Form::MovingFrame(Variation::Restricted) => {
                Some(|plant, q, v, v_dot| plant.solve(q, v, Variation::Restricted, v_dot))
            }
            Form::MovingFrame(Variation::Naive) => {
                Some(|plant, q, v, v_dot| plant.solve(q, v, Variation::Naive, v_dot))
            }
        };
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

    /// Accelerations by the matrices; not a number where M* is singular.
    fn solve(&mut self, q: &[f64], v: &[f64], variation: Variation, v_dot: &mut [f64]) {
        let matrices = MovingFrame::assemble(&self.model, q, v, &self.loads, variation);
        let given = |(mode, a): (&Mode, &f64)| if *mode == Mode::Prescribed { *a } else { 0.0 };
        let accelerations = self.model.modes.iter().zip(&self.loads.acceleration).map(given);
        v_dot.iter_mut().zip(accelerations).for_each(|(v_dot, given)| *v_dot = given);
        let solved = matrices.solve();
        for (k, &i) in matrices.free.iter().enumerate() {
            v_dot[i] = solved.as_ref().map_or(f64::NAN, |(a, _)| a[k]);
        }
        if let Some((_, multipliers)) = solved.filter(|_| !self.model.loops.is_empty()) {
            self.loops.take_over(&self.model, &self.links, multipliers.iter().copied());
            self.loops.apply(&self.model, &self.links, &mut self.loads);
        }
    }
}

impl<S: Scalar> System<S> for Plant<S> {
    fn sizes(&self) -> Sizes {
        Sizes {
            positions: self.model.position_count,
            velocities: self.model.velocity_count,
            extras: self.shares().extras(),
        }
    }

    fn rates(&mut self, at: Stage<'_, S>, v_dot: &mut [S], s_dot: &mut [S]) {
        self.evaluations += 1;
        self.evaluate_loads(at);
        self.accelerate(at.q, at.v, v_dot);
        let s_dot = self.shares().state_rates(self, at, s_dot);
        if !self.keeps_ledger {
            return;
        }
        let Self { model, links, bodies, loads, work, inverse, form, .. } = self;
        loads.hand_over(|body| {
            let rate = match form {
                Form::Recursive => links.to_body(model, body, |link| work.acceleration(links, link)),
                Form::MovingFrame(_) => inverse.acceleration[body],
            };
            (links.body_twist(model, body), rate)
        });
        let (has_fixed, centre) = (self.form != Form::Recursive, ledger::reference_point(model, at.q));
        let tree = if has_fixed { &model.tree } else { &model.links };
        let entries = Entries { model, tree, has_fixed, links, v: at.v, loads, centre };
        match self.form {
            Form::Recursive => entries.rates(
                |i| JointLoad { frame: *links.root_in_world(model.roots[i]), wrench: work.joint_wrench(links, i) },
                |i, at| work.joint_wrench(links, i).dot(links.axis(i)) + model.rotor_inertia[at] * v_dot[at],
                s_dot,
            ),
            Form::MovingFrame(_) => entries.rates(
                |i| JointLoad { frame: bodies.world[i], wrench: inverse.joint_wrench[i] },
                |i, at| inverse.joint_wrench[i].dot(&bodies.columns[at]) + model.rotor_inertia[at] * v_dot[at],
                s_dot,
            ),
        }
    }

    fn retract(&self, q: &[S], xi: &[S], out: &mut [S]) {
        self.model.links.retract(q, xi, out);
    }

    fn dexp_inverse(&self, xi: &[S], v: &[S], out: &mut [S]) {
        self.model.links.dexp_inverse(xi, v, out);
    }

    fn is_rotation_rate(&self, coordinate: usize) -> bool {
        self.rotation_rates[coordinate]
    }

    fn is_free(&self, coordinate: usize) -> bool {
        self.model.modes[coordinate] == Mode::Free
    }

    fn jacobian(&mut self, base: &[S], xi: &[S], at: Stage<'_, S>, out: &mut Jacobian<S>) {
        match &mut self.exact {
            Some(exact) => self.evaluations += (exact.jacobian)(&mut exact.tangent, base, xi, at, out),
            None => out.by_differences(self, base, xi, at),
        }
    }
}
