//! Right-hand side of the equations of motion: combines model, world and elements for an integrator.

mod advancing;
mod between_steps;
mod element_contexts;
mod holding;
mod left_out;
mod observation;
mod sea;
mod settling;
mod tangent;

use element_contexts::ElementContexts;
pub use observation::{Observation, ObservedPart, Totals};
pub use tangent::{Along, DIRECTIONS, Number, Tangent};

use crate::dynamics::loops::{LoopFault, LoopSolver};
use crate::dynamics::moving_frame::{MovingFrame, Variation};
use crate::dynamics::{
    Clock, Kinematics, LinkKinematics, Loads, TemporaryConstraint, energy, forward, inverse::InverseDynamics,
};
use crate::elements::{AnyElement, EvaluationMode, Layout, Watched};
use crate::integrate::{Interval, Jacobian, Sizes, Stage, StepError, System};
use crate::ledger::{self, Entries, JointLoad};
use crate::model::{Model, MotionType, Node};
use crate::scalar::Scalar;
use crate::state::State;
use crate::world::World;
use core::ops::Range;
use nalgebra::DMatrix;

/// The form of the equations of motion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// The recursive form: fast, without allocation.
    #[default]
    Recursive,
    /// The matrices of the moving frame method, with this variation of the angular velocity.
    MovingFrame(Variation),
}

/// Model, world and elements, with the working memory for their evaluation.
#[derive(Clone, Debug)]
pub struct Plant<S: Scalar = f64> {
    /// The mechanical model.
    pub model: Model<S>,
    /// The world outside the model.
    pub world: World<S>,
    elements: Vec<AnyElement<S>>,
    /// Indices of everything that the elements declare.
    layout: Layout,
    form: Form,
    /// Solver of the matrix form; it exists for plain numbers only.
    solve_matrices: Option<SolveMatrices<S>>,
    evaluation: EvaluationMode,
    links: LinkKinematics<S>,
    bodies: Kinematics<S>,
    loads: Loads<S>,
    work: forward::Workspace<S>,
    inverse: InverseDynamics<S>,
    loops: LoopSolver<S>,
    /// Outputs of the elements, one after another.
    outputs: Vec<S>,
    /// Rates that elements prescribe together with the accelerations; a stage does not need them.
    prescribed_rates: Vec<S>,
    /// Working memory for accelerations.
    scratch: Vec<S>,
    /// State before an element changes it.
    seen: State<S>,
    /// Events caused by a response or by a change from outside.
    also: Vec<Watched>,
    rotation_rates: Vec<bool>,
    /// Number of evaluations of the right-hand side.
    pub evaluations: u64,
    exact: Option<Exact<S>>,
}

/// Exact derivatives; they exist for plain numbers only.
#[derive(Clone, Debug)]
struct Exact<S: Scalar> {
    tangent: Box<Tangent>,
    jacobian: DifferentiateExactly<S>,
}

/// Writes the derivatives for [`System::jacobian`], and returns their cost in plain evaluations.
type DifferentiateExactly<S> = fn(&mut Tangent, base: &[S], xi: &[S], at: Stage<'_, S>, out: &mut Jacobian<S>) -> u64;

/// Solves for the accelerations `v_dot` at q, v under the loads evaluated last.
type SolveMatrices<S> = fn(&mut Plant<S>, q: &[S], v: &[S], v_dot: &mut [S]);

impl<S: Scalar> Plant<S> {
    /// Creates a plant with its equations in the recursive form.
    pub fn new(model: Model<S>, world: World<S>, elements: Vec<AnyElement<S>>) -> Self {
        let turns = |node: &Node<S>| {
            let first = node.kind.quaternion().map_or(usize::MAX, |(_, rates)| rates);
            (0..node.kind.velocity_count()).map(move |k| k >= first)
        };
        let rotation_rates = model.tree.nodes.iter().flat_map(turns).collect();
        let layout = Layout::new(&elements, ledger::COUNT);
        let outputs = layout.outputs.iter().map(|(_, output)| output.len()).sum();
        let mut loads = Loads::with_room_for(&model, 2 * (elements.len() + model.constraint_count()));
        let of = |(element, places): &(usize, Range<usize>)| {
            vec![TemporaryConstraint::new(&layout.names[*element]); places.len()]
        };
        loads.restraints = layout.holding.iter().flat_map(of).collect();
        Self {
            links: LinkKinematics::new(&model),
            bodies: Kinematics::new(&model.tree),
            loops: LoopSolver::new(&model, loads.restraints.len()),
            loads,
            work: forward::Workspace::new(&model),
            inverse: InverseDynamics::new(&model),
            outputs: Vec::with_capacity(outputs),
            prescribed_rates: vec![S::ZERO; model.velocity_count],
            scratch: Vec::new(),
            seen: State::default(),
            also: Vec::new(),
            rotation_rates,
            evaluations: 0,
            model,
            world,
            elements,
            layout,
            form: Form::default(),
            solve_matrices: None,
            exact: None,
            evaluation: EvaluationMode::Running,
        }
    }

    /// Chooses whether the integrals of the ledger are part of s.
    pub fn keep_ledger(&mut self, keeps: bool) {
        self.layout.ledger = if keeps { ledger::COUNT } else { 0 };
    }

    /// Connects inputs to sampled outputs; each pair contains their names.
    pub fn connect(&mut self, wires: &[(String, String)]) {
        self.layout.connect(wires);
    }

    /// Returns the elements of the plant.
    pub fn elements(&self) -> &[AnyElement<S>] {
        &self.elements
    }

    /// Returns the indices of everything that the elements declare.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Evaluates the kinematics of the links and the loads at a stage.
    fn evaluate_loads(&mut self, at: Stage<'_, S>) {
        self.links.update(&self.model, at.q, at.v);
        let Self { model, world, links, elements, layout, evaluation, loads, prescribed_rates, .. } = self;
        loads.clear_but_accelerations();
        let mut contexts = ElementContexts::new(layout, world, model, links, *evaluation, at);
        for (i, element) in elements.iter_mut().enumerate() {
            element.loads(contexts.of(i), loads);
        }
        // At rest, prescribed motions are held.
        if evaluation.runs() {
            for &i in &layout.prescribing {
                elements[i].prescribe(world, contexts.shared.clock, prescribed_rates, &mut loads.acceleration);
            }
        } else {
            loads.acceleration.fill(S::ZERO);
        }
        self.evaluate_restraints(at);
    }

    /// Computes the accelerations of all coordinates under the loads of the last evaluation.
    fn accelerate(&mut self, q: &[S], v: &[S], v_dot: &mut [S]) {
        match self.solve_matrices {
            None => {
                forward::forward_dynamics(&self.model, &self.links, &self.loads, &mut self.work, v_dot);
                if self.constrains() {
                    self.loops.accelerate(&self.model, &self.links, &self.loads, &mut self.work, v_dot);
                    self.loops.apply(&self.model, &self.links, &mut self.loads);
                }
            }
            Some(solve) => {
                solve(self, q, v, v_dot);
                self.bodies.update(&self.model.tree, q, v);
                self.inverse.update(&self.model, &self.bodies, v, v_dot, &self.loads);
            }
        }
        if !self.layout.holding.is_empty() {
            self.hand_out_multipliers();
        }
    }

    /// Returns an observation at a state, for the results.
    pub fn observe(&mut self, at: Stage<'_, S>, extent: &ObservedPart, v_dot: &mut [S]) -> Observation<'_, S> {
        let totals = match extent {
            ObservedPart::Everything => self.observe_forces(at, v_dot),
            ObservedPart::MotionAnd(_) => {
                self.load_restraints(at);
                self.links.update(&self.model, at.q, at.v);
                self.bodies.update(&self.model.tree, at.q, at.v);
                Totals::default()
            }
        };
        let Self { model, world, links, bodies, inverse, loops, elements, layout, evaluation, outputs, .. } = self;
        let mut contexts = ElementContexts::new(layout, world, model, links, *evaluation, at);
        outputs.clear();
        let mut show = |i: usize| elements[i].outputs(contexts.of(i), outputs);
        match extent {
            ObservedPart::Everything => (0..layout.names.len()).for_each(show),
            ObservedPart::MotionAnd(some) => some.iter().for_each(|&i| show(i)),
        }
        Observation { model, bodies, inverse, loops, outputs, totals }
    }

    /// Computes accelerations and joint loads.
    fn observe_forces(&mut self, at: Stage<'_, S>, v_dot: &mut [S]) -> Totals<S> {
        self.evaluate_loads(at);
        self.accelerate(at.q, at.v, v_dot);
        self.bodies.update(&self.model.tree, at.q, at.v);
        self.inverse.update(&self.model, &self.bodies, at.v, v_dot, &self.loads);
        self.totals_here(at)
    }

    /// Returns frames and twists of the bodies at a state.
    pub fn body_kinematics(&mut self, q: &[S], v: &[S]) -> &Kinematics<S> {
        self.bodies.update(&self.model.tree, q, v);
        &self.bodies
    }

    /// Computes the accelerations of all coordinates, with `tau` (for each coordinate, N or N m) added to the
    /// loads of the plant.
    pub fn acceleration(&mut self, at: Stage<'_, S>, tau: Option<&[S]>, v_dot: &mut [S]) {
        self.evaluate_loads(at);
        for (force, tau) in self.loads.force.iter_mut().zip(tau.unwrap_or_default()) {
            *force += *tau;
        }
        self.accelerate(at.q, at.v, v_dot);
    }

    /// Sets the rate of prescribed coordinates at the start of an interval; returns their accelerations.
    pub fn prescribe(&mut self, interval: Interval, v: &mut [S]) -> &[S] {
        let clock = Clock { time_s: interval.start_s, middle_s: interval.middle_s() };
        self.loads.acceleration.fill(S::ZERO);
        for &i in &self.layout.prescribing {
            self.elements[i].prescribe(&self.world, clock, v, &mut self.loads.acceleration);
        }
        &self.loads.acceleration
    }

    /// Discards earlier evaluations before a step.
    pub fn begin_step(&mut self) {
        self.loops.forget_pivots();
    }

    /// Closes the loops after a step, and returns an error if that is not possible. Allocates nothing.
    pub fn close_loops(&mut self, q: &mut [S], v: &mut [S]) -> Result<(), LoopFault> {
        if !self.constrains() {
            return Ok(());
        }
        self.project(|solver, on| solver.close(on, q, v))
    }

    /// Returns energy and momentum at a stage.
    pub fn totals(&mut self, at: Stage<'_, S>) -> Totals<S> {
        self.links.update(&self.model, at.q, at.v);
        self.bodies.update(&self.model.tree, at.q, at.v);
        self.totals_here(at)
    }

    /// Returns energy and momentum at a stage, for the present kinematics.
    fn totals_here(&mut self, at: Stage<'_, S>) -> Totals<S> {
        let Self { model, world, elements, layout, evaluation, links, bodies, .. } = self;
        let centre = ledger::reference_point(model, at.q);
        let (linear_momentum, angular_momentum) = energy::momentum(&model.tree, bodies, centre);
        let mut contexts = ElementContexts::new(layout, world, model, links, *evaluation, at);
        let stored = elements.iter_mut().enumerate().map(|(i, element)| element.potential_energy(contexts.of(i)));
        Totals {
            kinetic_energy: energy::kinetic_energy(&model.tree, bodies) + energy::rotor_energy(model, at.v),
            potential_energy: stored.fold(S::ZERO, |sum, energy| sum + energy),
            linear_momentum,
            angular_momentum,
        }
    }

    /// Computes the rates of the ledger and of the elements' states, after the accelerations.
    fn rates_beside(&mut self, at: Stage<'_, S>, v_dot: &[S], s_dot: &mut [S]) {
        let (s_dot, of_elements) = s_dot.split_at_mut(self.layout.ledger);
        if !of_elements.is_empty() {
            let Self { model, world, elements, layout, evaluation, links, .. } = self;
            let mut contexts = ElementContexts::new(layout, world, model, links, *evaluation, at);
            for (i, element) in elements.iter_mut().enumerate() {
                let own = layout.slices[i].states.clone();
                if !own.is_empty() {
                    element.rates(contexts.of(i), &mut of_elements[own]);
                }
            }
        }
        if s_dot.is_empty() {
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

    fn tangent_mut(&mut self) -> Option<&mut Tangent> {
        self.exact.as_mut().map(|exact| &mut *exact.tangent)
    }
}

impl Plant {
    /// Uses exact derivatives, from the same plant over dual numbers, instead of differences.
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

    /// Returns the loads and the matrices of the moving frame method at a state.
    pub fn matrices(&mut self, at: Stage<'_>) -> MovingFrame {
        self.evaluate_loads(at);
        let variation = match self.form {
            Form::MovingFrame(variation) => variation,
            Form::Recursive => Variation::Restricted,
        };
        MovingFrame::assemble(&self.model, at.q, at.v, &self.loads, variation)
    }

    /// Returns M* and J over the free coordinates at a state.
    pub fn mass_and_constraints(&mut self, at: Stage<'_>) -> (DMatrix<f64>, DMatrix<f64>) {
        self.evaluate_loads(at);
        MovingFrame::mass_and_constraints(&self.model, at.q, at.v, &self.loads)
    }

    /// Computes the accelerations from the matrices; NaN if M* is singular.
    fn solve(&mut self, q: &[f64], v: &[f64], variation: Variation, v_dot: &mut [f64]) {
        let matrices = MovingFrame::assemble(&self.model, q, v, &self.loads, variation);
        let given = |(mode, a): (&MotionType, &f64)| if *mode == MotionType::Prescribed { *a } else { 0.0 };
        let accelerations = self.model.modes.iter().zip(&self.loads.acceleration).map(given);
        v_dot.iter_mut().zip(accelerations).for_each(|(v_dot, given)| *v_dot = given);
        let solved = matrices.solve();
        for (k, &i) in matrices.free.iter().enumerate() {
            v_dot[i] = solved.as_ref().map_or(f64::NAN, |(a, _)| a[k]);
        }
        if let Some((_, multipliers)) = solved.filter(|_| self.constrains()) {
            self.loops.take_over(&self.model, &self.links, &self.loads, multipliers.iter().copied());
            self.loops.apply(&self.model, &self.links, &mut self.loads);
        }
    }
}

impl<S: Scalar> System<S> for Plant<S> {
    fn sizes(&self) -> Sizes {
        Sizes {
            positions: self.model.position_count,
            velocities: self.model.velocity_count,
            extras: self.layout.extras(),
            passive: self.layout.ledger,
        }
    }

    fn rates(&mut self, at: Stage<'_, S>, v_dot: &mut [S], s_dot: &mut [S]) {
        self.evaluations += 1;
        self.evaluate_loads(at);
        self.accelerate(at.q, at.v, v_dot);
        if !s_dot.is_empty() {
            self.rates_beside(at, v_dot, s_dot);
        }
    }

    fn motions(&self) -> &[usize] {
        &self.layout.motions
    }

    fn begin_stages(&mut self, base: Stage<'_, S>) {
        self.begin_advancing(base);
    }

    fn advance(&mut self, at: Stage<'_, S>, s: &mut [S], is_end: bool) -> Result<(), StepError> {
        self.advance_elements(at, s, is_end)
    }

    fn accept(&mut self) {
        self.loops.accept();
    }

    fn reject(&mut self) {
        self.loops.reject();
    }

    /// An error of a loop that cannot be closed is returned after the step.
    fn close(&mut self, q: &mut [S], v: &mut [S]) -> bool {
        let _ = self.close_loops(q, v);
        self.constrains()
    }

    fn retract(&self, q: &[S], xi: &[S], out: &mut [S]) {
        self.model.charts.retract(q, xi, out);
    }

    fn dexp_inverse(&self, xi: &[S], v: &[S], out: &mut [S]) {
        self.model.charts.dexp_inverse(xi, v, out);
    }

    fn is_rotation_rate(&self, coordinate: usize) -> bool {
        self.rotation_rates[coordinate]
    }

    fn is_free(&self, coordinate: usize) -> bool {
        self.model.modes[coordinate] == MotionType::Free
    }

    fn jacobian(&mut self, base: &[S], xi: &[S], at: Stage<'_, S>, out: &mut Jacobian<S>) {
        match &mut self.exact {
            Some(exact) => self.evaluations += (exact.jacobian)(&mut exact.tangent, base, xi, at, out),
            None => out.by_differences(self, base, xi, at),
        }
    }
}
