//! The contract of everything that acts on the model or reads it.

use super::{AnyWatcher, Context, Declaration, PresentSupport, RegularWaves, ShownWaves, Support};
use crate::dynamics::{Clock, Kinematics, Loads, UnilateralConstraint};
use crate::scalar::Scalar;
use crate::world::World;
use core::any::Any;
use core::fmt::Debug;

/// A force, a drive, a sensor, a controller: whatever acts on the model or reads it.
///
/// An element [declares](Self::declare) once its states, inputs, outputs and events; the [`Layout`](super::Layout) of
/// all elements gives them their places. In every call it sees only its own entries, from 0, in the order of its
/// declaration. (Drake's and Simpack's *force element*; an event as the *zero-crossing function* of the FMI standard
/// 3.0, sec. 3.2.)
///
/// | when | call |
/// | --- | --- |
/// | a run begins | [`begin`](Self::begin) |
/// | every evaluation of the right-hand side | [`loads`](Self::loads), [`prescribe`](Self::prescribe), [`rates`](Self::rates) |
/// | after every step | [`event_indicators`](Self::event_indicators); where one changes sign, [`handle_event`](Self::handle_event) at that time |
/// | every step begins | [`update_controls`](Self::update_controls), where it steers inputs |
/// | its own ticks, k times its sampling period | [`sample`](Self::sample) |
/// | its numbers or an input of its own are changed | [`renew`](Self::renew) |
/// | a row of results | [`outputs`](Self::outputs), [`potential_energy`](Self::potential_energy) |
/// | what a row shows is to be warned of | [`watchers`](Self::watchers), once |
/// | a picture | [`draw`](Self::draw) |
/// | it holds a constraint | [`holding`](Self::holding), in every evaluation and after every step |
/// | an equilibrium is sought | [`loads`](Self::loads) in another [`EvaluationMode`](super::EvaluationMode), [`settling`](Self::settling) |
pub trait Element<S: Scalar = f64>: Debug + Send + Sync + Boxed<S> {
    /// Its name in the scenario; empty if it declares nothing that needs a name.
    fn name(&self) -> &str {
        ""
    }

    /// Its states, inputs, outputs and events.
    fn declare(&self) -> Declaration {
        Declaration::default()
    }

    /// Writes its states, numbers and modes at the start of a run; they are zero before.
    fn begin(&mut self, _at: &Context<'_, S>, _own: &mut ElementState<'_, S>) {}

    /// Adds its loads, and the power of those that are not conservative.
    fn loads(&mut self, _at: &Context<'_, S>, _loads: &mut Loads<S>) {}

    /// Writes the rates of its continuous states.
    fn rates(&mut self, _at: &Context<'_, S>, _rates: &mut [S]) {}

    /// Writes rates and accelerations of the coordinates that it prescribes, m or rad and s; called if
    /// [`Declaration::prescribes`].
    fn prescribe(&self, _world: &World<S>, _clock: Clock, _rates: &mut [S], _accelerations: &mut [S]) {}

    /// Energy that it stores, J.
    fn potential_energy(&mut self, _at: &Context<'_, S>) -> S {
        S::ZERO
    }

    /// Appends its outputs, in the order of its declaration.
    fn outputs(&mut self, _at: &Context<'_, S>, _out: &mut Vec<S>) {}

    /// Appends the points of its lines in the world, x, y and z (m) of each, in the order of its declaration.
    fn draw(&mut self, _at: &Context<'_, S>, _points: &mut Vec<S>) {}

    /// The next time after `after_s` at which its law changes form, s: a step ends there. Infinite if there is none.
    fn next_edge_s(&self, _after_s: f64, _modes: &[i64]) -> f64 {
        f64::INFINITY
    }

    /// At its sampling time: sets its discrete numbers and modes.
    fn sample(&mut self, _at: &Context<'_, S>, _own: &mut ElementState<'_, S>) {}

    /// At the start of a step: gets the columns that it [reads](Declaration::reads) and sets the inputs that it
    /// [steers](Declaration::steers), both in the order of its declaration; it may change its numbers and modes.
    /// Returns what happened, for the table of events.
    ///
    /// # Errors
    /// The reason why the run ends.
    fn update_controls(
        &mut self,
        _at: &Context<'_, S>,
        _read: &[S],
        _own: &mut ElementState<'_, S>,
        _inputs: &mut [S],
    ) -> Result<Vec<String>, String> {
        Ok(Vec::new())
    }

    /// Writes the values at the end of the step of the inputs that it [steers](Declaration::steers), in the order of its
    /// declaration, where they vary within the step; called after [`update_controls`](Element::update_controls), which has set the values that
    /// the step holds. `inputs` begins with those.
    fn at_end(&self, _at: &Context<'_, S>, _inputs: &mut [S]) {}

    /// Writes the indicator of each event, in the order of the declaration: a change of sign is the event.
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

    /// Returns the role of [`settling`](Self::settling) for changes: it takes over a load.
    fn settling_mut(&mut self) -> Option<&mut dyn Settling<S>> {
        None
    }

    /// The constraint that it holds at times; called if [`Declaration::holds`].
    fn holding(&self) -> Option<&dyn Holding<S>> {
        None
    }

    /// Returns the constraint of [`holding`](Self::holding) for changes: for evaluation.
    fn holding_mut(&mut self) -> Option<&mut dyn Holding<S>> {
        None
    }

    /// The watchers that look at every row of a run and warn.
    fn watchers(&self) -> Vec<AnyWatcher> {
        Vec::new()
    }

    /// Returns the supports of the element in any positions: what it carries, ties, keeps in place or afloat.
    fn supports(&self) -> Vec<Support> {
        Vec::new()
    }

    /// Returns what the element carries at these positions, at rest.
    fn present_supports(&mut self, _at: &Context<'_, S>) -> Vec<PresentSupport<S>> {
        Vec::new()
    }

    /// How it responds to regular waves about rest; `None` if waves do not act on it.
    fn regular_waves(&self) -> Option<Box<dyn RegularWaves<S> + '_>> {
        None
    }

    /// The outputs that depend directly on the incident waves about rest, with the bodies at these places: the number of
    /// each in the order of writing, and how it depends on them. The others depend on the waves only by the motions.
    fn shown_waves(&self, _bodies: &Kinematics<S>) -> Vec<(usize, ShownWaves<S>)> {
        Vec::new()
    }

    /// In words, what a linearization about rest leaves out of this element, such as drag quadratic in the speed; `None`
    /// if it leaves out nothing.
    fn left_out_at_rest(&self) -> Option<&'static str> {
        None
    }

    /// How the inputs that it [steers](Declaration::steers) depend on the columns that it reads, for small motions; `None` if
    /// it feeds nothing back, or not linearly.
    fn linear_law(&self) -> Option<LinearLaw> {
        None
    }

    /// The place among the inputs that it [steers](Declaration::steers) to which it passes its command of this number at once,
    /// alone or with more added; `None` if it does not.
    fn passes_to(&self, _command: usize) -> Option<usize> {
        None
    }

    /// The coordinates that it puts to given positions at a time, by their first index in q; `None` if it moves none. It depends on
    /// the waves that it was built with: in another sea, the body that it moves would jump.
    fn given_positions(&self, _world: &World<S>, _time_s: f64) -> Option<(usize, [S; 6])> {
        None
    }
}

/// A linear feedback `u = G y + H (sum of y T)` of small motions, held between two samples; the sum is over the samples so far.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearLaw {
    /// G: a row for each input that is steered, a column for each column that is read, in SI units.
    pub gains: Vec<Vec<f64>>,
    /// H, per second; without rows if nothing is summed.
    pub integral_gains: Vec<Vec<f64>>,
    /// The sampling period T, s.
    pub period_s: f64,
}

/// The advice for a ship that nothing holds in position.
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
    /// A further event of the element that its response or a change from outside causes. The element sets it; it is
    /// recorded with the time.
    pub also: Option<usize>,
}

/// An element that finds a holding force while an equilibrium is sought, as an integral does.
pub trait Settling<S: Scalar = f64> {
    /// The trim that it has found: a run begins with it.
    fn trim(&self) -> &[S];

    /// Sets the trim, of the same length as [`trim`](Self::trim).
    fn set_trim(&mut self, trim: &[S]);

    /// Transfers the holding force to the trim; returns the remaining deviation, m or rad.
    fn take_over(&mut self, at: &Context<'_, S>) -> S;

    /// The holding force as a share of what the element can give.
    fn utilisation(&self, at: &Context<'_, S>) -> S;
}

/// An element that holds a one-sided constraint while its mode says so: an inextensible rope.
pub trait Holding<S: Scalar = f64> {
    /// Whether it holds, by its modes.
    fn holds(&self, modes: &[i64]) -> bool;

    /// Writes the constraint at the present positions. It sees no entries of its own.
    fn restrain(&mut self, at: &Context<'_, S>, held: &mut UnilateralConstraint<S>);

    /// Receives the force that it carries, from the solution for the accelerations, N; zero if it does not hold.
    fn carry(&mut self, multiplier: S);

    /// Lets go, because the force would be negative.
    fn let_go(&mut self, modes: &mut [i64]);
}

/// Abilities that every element has because it is `Clone` and `'static`; nothing to write.
pub trait Boxed<S: Scalar> {
    /// A copy in a box.
    fn boxed_clone(&self) -> Box<dyn Element<S>>;

    /// The element as `Any`, for its own type.
    fn as_any(&self) -> &dyn Any;

    /// Returns the element as `Any` for changes.
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

/// The elements of one kind among all.
pub fn of_kind<S: Scalar, T: 'static>(elements: &[Box<dyn Element<S>>]) -> impl Iterator<Item = &T> {
    elements.iter().filter_map(|element| (**element).as_any().downcast_ref())
}

/// Returns the elements of one kind among all, for changes.
pub fn of_kind_mut<S: Scalar, T: 'static>(elements: &mut [Box<dyn Element<S>>]) -> impl Iterator<Item = &mut T> {
    elements.iter_mut().filter_map(|element| (**element).as_any_mut().downcast_mut())
}
