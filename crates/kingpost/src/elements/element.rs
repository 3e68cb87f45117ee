//! The trait of all elements: parts that act on the model or read it.

use super::{
    AnyWatcher, Context, Declaration, Occurrence, PresentSupport, RandomDrag, RegularWaves, ShownWaves, Support,
};
use crate::dynamics::{Clock, Kinematics, Loads, TemporaryConstraint};
use crate::scalar::Scalar;
use crate::world::World;
use core::any::Any;
use core::fmt::Debug;

/// An element that acts on the model or reads it: a force, a drive, a sensor, a controller.
///
/// An element [declares](Self::declare) once its states, inputs, outputs and events; the [`Layout`](super::Layout) of
/// all elements gives them their places. In every call it gets only its own entries, from 0, in the order of its
/// declaration. (Drake's and Simpack's *force element*; an event as the *zero-crossing function* of the FMI standard
/// 3.0, sec. 3.2.)
///
/// | when | call |
/// | --- | --- |
/// | a run begins | [`begin`](Self::begin) |
/// | every evaluation of the right-hand side | [`loads`](Self::loads), [`prescribe`](Self::prescribe), [`rates`](Self::rates) |
/// | after every step | [`event_indicators`](Self::event_indicators); if an indicator changes sign, [`handle_event`](Self::handle_event) at that time |
/// | every step begins | [`update_controls`](Self::update_controls), if it steers inputs |
/// | its own ticks, k times its sampling period | [`sample`](Self::sample) |
/// | its numbers or one of its inputs are changed | [`renew`](Self::renew) |
/// | a step of an explicit scheme | [`advancing`](Self::advancing), before the right-hand side of every stage |
/// | a row of results | [`outputs`](Self::outputs), [`potential_energy`](Self::potential_energy) |
/// | a run begins to watch its rows for warnings | [`watchers`](Self::watchers), once |
/// | a picture | [`draw`](Self::draw) |
/// | it holds constraints | [`holding`](Self::holding), in every evaluation and after every step |
/// | an equilibrium is sought | [`loads`](Self::loads) in another [`EvaluationMode`](super::EvaluationMode), [`settling`](Self::settling) |
pub trait Element<S: Scalar = f64>: Debug + Send + Sync + Boxed<S> {
    /// Returns its name in the scenario; empty if no declared entry needs a name.
    fn name(&self) -> &str {
        ""
    }

    /// Declares its states, inputs, outputs and events.
    fn declare(&self) -> Declaration {
        Declaration::default()
    }

    /// Writes its states, numbers and modes at the start of a run; without this call they are zero.
    fn begin(&mut self, _at: &Context<'_, S>, _own: &mut ElementState<'_, S>) {}

    /// Adds its loads, and the power of those that are not conservative.
    fn loads(&mut self, _at: &Context<'_, S>, _loads: &mut Loads<S>) {}

    /// Writes the rates of its continuous states.
    fn rates(&mut self, _at: &Context<'_, S>, _rates: &mut [S]) {}

    /// Writes rates and accelerations of the coordinates that it prescribes, m or rad and s; called if
    /// [`Declaration::prescribes`].
    fn prescribe(&self, _world: &World<S>, _clock: Clock, _rates: &mut [S], _accelerations: &mut [S]) {}

    /// Returns the energy that it stores, J.
    fn potential_energy(&mut self, _at: &Context<'_, S>) -> S {
        S::ZERO
    }

    /// Appends its outputs, in the order of its declaration.
    fn outputs(&mut self, _at: &Context<'_, S>, _out: &mut Vec<S>) {}

    /// Appends the points of its lines in the world, x, y and z (m) of each, in the order of its declaration.
    fn draw(&mut self, _at: &Context<'_, S>, _points: &mut Vec<S>) {}

    /// Returns the next time after `after_s` at which its law changes form, s: a step ends at that time. Infinity if
    /// there is none.
    fn next_edge_s(&self, _after_s: f64, _modes: &[i64]) -> f64 {
        f64::INFINITY
    }

    /// Sets its discrete numbers and modes at a sampling time.
    fn sample(&mut self, _at: &Context<'_, S>, _own: &mut ElementState<'_, S>) {}

    /// Reads its [columns](Declaration::reads) at the start of a step and sets the inputs that it
    /// [steers](Declaration::steers), both in the order of its declaration; it may change its numbers and modes.
    /// Returns texts for the table of events.
    ///
    /// # Errors
    /// The reason why the run ends.
    fn update_controls(
        &mut self,
        _at: &Context<'_, S>,
        _read: &[S],
        _own: &mut ElementState<'_, S>,
        _inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        Ok(Vec::new())
    }

    /// Writes the values at the end of the step of [steered](Declaration::steers) inputs that vary within the step, in
    /// the order of its declaration. Called after [`update_controls`](Element::update_controls), whose values are in
    /// `inputs` at the call.
    fn at_end(&self, _at: &Context<'_, S>, _inputs: &mut [S]) {}

    /// Writes the indicator of each event, in the order of the declaration. A change of sign of an indicator is an
    /// event.
    fn event_indicators(&mut self, _at: &Context<'_, S>, values: &mut [S]) {
        values.fill(S::ONE);
    }

    /// Responds to an event at the located time: it may change its states, numbers and modes, and the velocities `v` of
    /// the whole model, as an impact does.
    fn handle_event(&mut self, _event: usize, _at: &Context<'_, S>, _own: &mut ElementState<'_, S>, _v: &mut [S]) {}

    /// Sets its modes again after its numbers or one of its inputs were changed, because a threshold may have been
    /// crossed.
    fn renew(&mut self, _at: &Context<'_, S>, _own: &mut ElementState<'_, S>) {}

    /// Returns the role of the element while an equilibrium is sought, in addition to its loads; `None` if it has none.
    fn settling(&self) -> Option<&dyn Settling<S>> {
        None
    }

    /// Returns the role of [`settling`](Self::settling), mutable: it takes over a load.
    fn settling_mut(&mut self) -> Option<&mut dyn Settling<S>> {
        None
    }

    /// Returns the role of an element that [holds](Declaration::holds) constraints; `None` if it holds none.
    fn holding(&self) -> Option<&dyn Holding<S>> {
        None
    }

    /// Returns the role of [`holding`](Self::holding), mutable, for evaluation.
    fn holding_mut(&mut self) -> Option<&mut dyn Holding<S>> {
        None
    }

    /// Returns the role of an element whose states an explicit scheme does not integrate; `None` if it does.
    fn advancing(&mut self) -> Option<&mut dyn Advancing<S>> {
        None
    }

    /// Returns the watchers that check every row of a run and warn.
    fn watchers(&self) -> Vec<AnyWatcher> {
        Vec::new()
    }

    /// Returns the supports that do not depend on the positions: bodies that it carries, ties, keeps in place or
    /// afloat.
    fn supports(&self) -> Vec<Support> {
        Vec::new()
    }

    /// Returns the supports at these positions, at rest.
    fn present_supports(&mut self, _at: &Context<'_, S>) -> Vec<PresentSupport<S>> {
        Vec::new()
    }

    /// Returns its response to regular waves about rest; `None` if waves do not act on it.
    fn regular_waves(&self) -> Option<Box<dyn RegularWaves<S> + '_>> {
        None
    }

    /// Returns the outputs that depend directly on the incident waves about rest, with the bodies at these positions:
    /// the index of each in the order of writing, and its dependence on the waves. Other outputs depend on the waves
    /// only through the motions.
    fn shown_waves(&self, _bodies: &Kinematics<S>) -> Vec<(usize, ShownWaves<S>)> {
        Vec::new()
    }

    /// Lets its states that [`AtRest`](super::EvaluationMode::AtRest) finds anew at every instant move about rest, or not: for
    /// natural modes and linear responses.
    fn move_about_rest(&mut self, _moves: bool) {}

    /// Returns its drag in a linear response to a random sea; `None` if it has none there.
    fn random_drag(&self) -> Option<&dyn RandomDrag<S>> {
        None
    }

    /// Returns the drag of [`random_drag`](Self::random_drag), mutable.
    fn random_drag_mut(&mut self) -> Option<&mut dyn RandomDrag<S>> {
        None
    }

    /// Returns a warning of effects that the element leaves out and that are not small at the start of a run, with their
    /// size; `loads` are those of all elements.
    fn left_out(&mut self, _at: &Context<'_, S>, _loads: &Loads<S>) -> Option<String> {
        None
    }

    /// Returns a text on the effects of this element that a linearization about rest neglects, such as drag quadratic
    /// in the speed; `None` if it neglects none.
    fn left_out_at_rest(&self) -> Option<&'static str> {
        None
    }

    /// Returns its linear feedback, from the columns that it reads to the inputs that it [steers](Declaration::steers),
    /// for small motions; `None` if it has no feedback, or no linear one.
    fn linear_law(&self) -> Option<LinearLaw> {
        None
    }

    /// Returns the index, among the inputs that it [steers](Declaration::steers), of the input to which it passes on
    /// the command `command` without delay, possibly with additions; `None` if there is none.
    fn passes_to(&self, _command: usize) -> Option<usize> {
        None
    }

    /// Returns the coordinates that it moves to given positions at a time, with their first index in q; `None` if it
    /// moves none. The positions are those of the waves with which it was built: in another sea, the moved body would
    /// jump.
    fn given_positions(&self, _world: &World<S>, _time_s: f64) -> Option<(usize, [S; 6])> {
        None
    }
}

/// A linear feedback `u = G y + H (sum of y T)` of small motions, held between two samples; the sum is over the samples so far.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearLaw {
    /// G: a row for each input that is steered, a column for each column that is read, in SI units.
    pub gains: Vec<Vec<f64>>,
    /// H, per second; without rows if there is no integral.
    pub integral_gains: Vec<Vec<f64>>,
    /// The sampling period T, s.
    pub period_s: f64,
}

/// Advice in the warning about a ship that nothing holds in position.
pub const HOLD_IT: &str = "hold it, by soft_hold, spring_line, catenary_line or dynamic_positioning";

/// An element of any kind.
pub type AnyElement<S = f64> = Box<dyn Element<S>>;

/// The entries of an element, which may change between two steps.
#[derive(Debug)]
pub struct ElementState<'a, S = f64> {
    /// Continuous states.
    pub states: &'a mut [S],
    /// Discrete numbers.
    pub numbers: &'a mut [S],
    /// Modes.
    pub modes: &'a mut [i64],
    /// Index of a further event of the element, caused by its response to an event or by a change from outside. The
    /// element sets it; the event is recorded with the time.
    pub also: Option<usize>,
}

/// An element that determines a holding force while an equilibrium is sought, like integral action.
pub trait Settling<S: Scalar = f64> {
    /// Returns the trim, the holding force with which a run begins.
    fn trim(&self) -> &[S];

    /// Sets the trim, of the same length as [`trim`](Self::trim).
    fn set_trim(&mut self, trim: &[S]);

    /// Transfers the holding force to the trim; returns the remaining deviation, m or rad.
    fn take_over(&mut self, at: &Context<'_, S>) -> S;

    /// Returns the holding force over the limit of the element.
    fn utilisation(&self, at: &Context<'_, S>) -> S;
}

/// An element that advances its states itself in explicit schemes, implicitly, from the start of a step to each stage, where
/// [`loads`](Element::loads) and [`rates`](Element::rates) are then called in [`EvaluationMode::Stepping`]: its own stiff
/// motions do not limit the step. The contexts have no entries of the element.
///
/// [`EvaluationMode::Stepping`]: super::EvaluationMode::Stepping
pub trait Advancing<S: Scalar = f64> {
    /// Begins a step at its start, with the states there.
    fn begin_step(&mut self, at: &Context<'_, S>, states: &[S]);

    /// Writes the states at a stage.
    ///
    /// # Errors
    /// The iteration that does not converge.
    fn advance(&mut self, at: &Context<'_, S>, states: &mut [S]) -> Result<(), NotAdvanced>;

    /// Completes the states at the end of the step, to which it was advanced and where the scheme has integrated
    /// [`rates`](Element::rates). Returns the heat and the work from outside of the step, without those of the loads, J.
    fn end_step(&mut self, at: &Context<'_, S>, states: &mut [S]) -> [S; 2];
}

/// An iteration of an [`Advancing`] element that does not converge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotAdvanced {
    /// Last move, m.
    pub move_m: f64,
    /// Largest move that is allowed, m.
    pub allowed_m: f64,
    /// Number of iterations.
    pub iterations: usize,
}

/// An element that holds [constraints](Declaration::holds) in some of its modes: an inextensible rope, a connection.
pub trait Holding<S: Scalar = f64> {
    /// Whether it holds, by its modes.
    fn holds(&self, modes: &[i64]) -> bool;

    /// Writes its constraints at the present positions. While the motion is corrected, the context has no entries of the
    /// element: it then holds what it held at the last evaluation with them.
    fn restrain(&mut self, at: &Context<'_, S>, held: &mut [TemporaryConstraint<S>]);

    /// Receives the multipliers of its constraints from the solution for the accelerations, N or N m; none if it does not hold.
    fn carry(&mut self, multipliers: &[S]);

    /// Receives the impulses of its constraints in an impact, N s or N m s, and enters them in its discrete numbers.
    fn strike(&mut self, _impulses: &[S], _numbers: &mut [S]) {}

    /// Releases a one-sided constraint, because its force would be negative.
    fn let_go(&mut self, _modes: &mut [i64]) {}
}

/// Methods that every element gets from being `Clone` and `'static`, by a blanket implementation.
pub trait Boxed<S: Scalar> {
    /// Returns a boxed copy.
    fn boxed_clone(&self) -> Box<dyn Element<S>>;

    /// Returns the element as `Any`, for a downcast to its type.
    fn as_any(&self) -> &dyn Any;

    /// Returns the element as mutable `Any`, for a downcast to its type.
    fn as_any_mut(&mut self) -> &mut dyn Any;
}

impl<S: Scalar, T: Element<S> + Clone + 'static> Boxed<S> for T {
    fn boxed_clone(&self) -> Box<dyn Element<S>> {
        Box::new(self.clone())
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn as_any_mut(&mut self) -> &mut dyn Any {
        self
    }
}

impl<S: Scalar> Clone for Box<dyn Element<S>> {
    fn clone(&self) -> Self {
        (**self).boxed_clone()
    }
}

/// Returns the elements of one kind among all.
pub fn of_kind<S: Scalar, T: 'static>(elements: &[Box<dyn Element<S>>]) -> impl Iterator<Item = &T> {
    elements.iter().filter_map(|element| (**element).as_any().downcast_ref())
}

/// Returns the elements of one kind among all, mutable.
pub fn of_kind_mut<S: Scalar, T: 'static>(elements: &mut [Box<dyn Element<S>>]) -> impl Iterator<Item = &mut T> {
    elements.iter_mut().filter_map(|element| (**element).as_any_mut().downcast_mut())
}
