//! The one contract of everything that acts on the model or reads it.

use super::{AnyWatcher, Context, Declaration, RegularWaves, ShownWaves};
use crate::dynamics::{Clock, Kinematics, Loads, Restraint};
use crate::scalar::Scalar;
use crate::world::World;
use core::any::Any;
use core::fmt::Debug;

/// A force, a drive, a sensor, a controller: whatever acts on the model or reads it.
///
/// An element [declares](Self::declare) once what it keeps, takes, gives and watches; the [`Layout`](super::Layout) of
/// all elements places it. In every call it sees its own entries alone, from 0, in the order that it declared them in.
/// (Drake's and Simpack's *force element*; an event as the *zero-crossing function* of the FMI standard 3.0, sec. 3.2.)
///
/// | when | call |
/// | --- | --- |
/// | a run begins | [`begin`](Self::begin) |
/// | every evaluation of the right-hand side | [`loads`](Self::loads), [`prescribe`](Self::prescribe), [`rates`](Self::rates) |
/// | after every step | [`witness`](Self::witness); where one changes sign, [`respond`](Self::respond) at that time |
/// | every step begins | [`steer`](Self::steer), where it steers inputs |
/// | its own ticks, k times its sampling period | [`sample`](Self::sample) |
/// | its numbers or an input of its own are changed | [`renew`](Self::renew) |
/// | a row of results | [`outputs`](Self::outputs), [`potential_energy`](Self::potential_energy) |
/// | what a row shows is to be warned of | [`watchers`](Self::watchers), once |
/// | a picture | [`draw`](Self::draw) |
/// | it holds a constraint | [`holding`](Self::holding), in every evaluation and after every step |
/// | an equilibrium is sought | [`loads`](Self::loads) in another [`Situation`](super::Situation), [`settling`](Self::settling) |
pub trait Element<S: Scalar = f64>: Debug + Send + Sync + Boxed<S> {
    /// Its name in the scenario; empty where it declares nothing that needs one.
    fn name(&self) -> &str {
        ""
    }

    /// What it keeps, takes, gives and watches.
    fn declare(&self) -> Declaration {
        Declaration::default()
    }

    /// Writes its states, numbers and modes where a run begins; they are zero before.
    fn begin(&mut self, _at: &Context<'_, S>, _own: &mut Own<'_, S>) {}

    /// Adds its loads, and the power of those that are not conservative.
    fn loads(&mut self, _at: &Context<'_, S>, _loads: &mut Loads<S>) {}

    /// Writes the rates of its continuous states.
    fn rates(&mut self, _at: &Context<'_, S>, _rates: &mut [S]) {}

    /// Writes rates and accelerations of the coordinates that it prescribes, m or rad and s; asked where
    /// [`Declaration::prescribes`].
    fn prescribe(&self, _world: &World<S>, _clock: Clock, _rates: &mut [S], _accelerations: &mut [S]) {}

    /// Energy that it stores, J.
    fn potential_energy(&mut self, _at: &Context<'_, S>) -> S {
        S::ZERO
    }

    /// Appends its outputs, in the order that it declared them in.
    fn outputs(&mut self, _at: &Context<'_, S>, _out: &mut Vec<S>) {}

    /// Appends the points of its lines in the world, x, y and z (m) of each, in the order that it declared the lines in.
    fn draw(&mut self, _at: &Context<'_, S>, _points: &mut Vec<S>) {}

    /// The next time after `after_s` at which its law changes its form, s: steps end there. Infinite where there is none.
    fn next_edge_s(&self, _after_s: f64, _modes: &[i64]) -> f64 {
        f64::INFINITY
    }

    /// At its tick: sets its discrete numbers and modes.
    fn sample(&mut self, _at: &Context<'_, S>, _own: &mut Own<'_, S>) {}

    /// Where a step begins: sees the columns that it [reads](Declaration::reads) and sets the inputs that it
    /// [steers](Declaration::steers), in the order in which it declared both, and may change its numbers and modes. Returns
    /// what happened, for the table of events.
    ///
    /// # Errors
    /// Why the run ends here.
    fn steer(
        &mut self,
        _at: &Context<'_, S>,
        _read: &[S],
        _own: &mut Own<'_, S>,
        _inputs: &mut [S],
    ) -> Result<Vec<String>, String> {
        Ok(Vec::new())
    }

    /// Writes, for each event in the order of the declaration, the function whose change of sign it is.
    fn witnesses(&mut self, _at: &Context<'_, S>, values: &mut [S]) {
        values.fill(S::ONE);
    }

    /// Answers an event where it was located: may change its states, numbers and modes, and the velocities `v` of the
    /// whole model, as an impact does.
    fn respond(&mut self, _event: usize, _at: &Context<'_, S>, _own: &mut Own<'_, S>, _v: &mut [S]) {}

    /// Sets its modes anew where its numbers or an input of its own were changed: what they were set by may have crossed.
    fn renew(&mut self, _at: &Context<'_, S>, _own: &mut Own<'_, S>) {}

    /// What it does while an equilibrium is sought, beside its loads; `None` where that is nothing.
    fn settling(&self) -> Option<&dyn Settling<S>> {
        None
    }

    /// The same, to let it take over a load.
    fn settling_mut(&mut self) -> Option<&mut dyn Settling<S>> {
        None
    }

    /// The constraint that it holds at times; asked where [`Declaration::holds`].
    fn holding(&self) -> Option<&dyn Holding<S>> {
        None
    }

    /// The same, to evaluate it.
    fn holding_mut(&mut self) -> Option<&mut dyn Holding<S>> {
        None
    }

    /// What watches the rows of a run for what a person should know of it.
    fn watchers(&self) -> Vec<AnyWatcher> {
        Vec::new()
    }

    /// The pairs of bodies of which it may hold one up by the other; `None` is the world.
    fn ties(&self) -> Vec<[Option<usize>; 2]> {
        Vec::new()
    }

    /// The two bodies of which it may keep one in its place by the other, in surge, sway and yaw; `None` among them is the
    /// world.
    fn keeps_station(&self) -> Option<[Option<usize>; 2]> {
        None
    }

    /// How it answers regular waves about rest; `None` where they do not act on it.
    fn regular_waves(&self) -> Option<Box<dyn RegularWaves<S> + '_>> {
        None
    }

    /// Which of its outputs follow the incident waves themselves about rest, by their numbers in the order of writing, where
    /// the bodies are; the others follow them by the motions alone.
    fn shown_waves(&self, _bodies: &Kinematics<S>) -> Vec<(usize, ShownWaves<S>)> {
        Vec::new()
    }

    /// What of it small motions about rest leave out, in words: drag that grows with the square of a speed, say; `None`
    /// where that is nothing.
    fn left_out_at_rest(&self) -> Option<&'static str> {
        None
    }

    /// Whether it holds on to the waves that it was made in: in another sea what it moves would jump.
    fn keeps_waves(&self) -> bool {
        false
    }

    /// The floating body that it keeps afloat: one that lies on its side at rest has capsized.
    fn keeps_afloat(&self) -> Option<usize> {
        None
    }
}

/// What to do for a ship that nothing keeps in its place.
pub const HOLD_IT: &str = "hold it, by soft_hold, spring_line, catenary_line or dynamic_positioning";

/// An element of any kind.
pub type AnyElement<S = f64> = Box<dyn Element<S>>;

/// What an element keeps, to be changed between two steps.
#[derive(Debug)]
pub struct Own<'a, S = f64> {
    /// Continuous states.
    pub states: &'a mut [S],
    /// Discrete numbers.
    pub numbers: &'a mut [S],
    /// Modes.
    pub modes: &'a mut [i64],
    /// One of its events that its answer brings about, or what was changed from outside: set by the element, noted with the
    /// time.
    pub also: Option<usize>,
}

/// An element that holds the model in place with what it finds while an equilibrium is sought, as an integral does.
pub trait Settling<S: Scalar = f64> {
    /// What it has found: a run begins with it.
    fn trim(&self) -> &[S];

    /// Sets that; the length is the one that [`trim`](Self::trim) has.
    fn set_trim(&mut self, trim: &[S]);

    /// Hands what holds the model there over to the trim; returns how far off it still is, m or rad.
    fn take_over(&mut self, at: &Context<'_, S>) -> S;

    /// The share that holding the model there takes of what the element can give.
    fn utilisation(&self, at: &Context<'_, S>) -> S;
}

/// An element that holds a constraint, one way and while its mode says so: an inextensible rope.
pub trait Holding<S: Scalar = f64> {
    /// Whether it holds, by its modes.
    fn holds(&self, modes: &[i64]) -> bool;

    /// Writes the constraint where the bodies are. Sees no entries of its own.
    fn restrain(&mut self, at: &Context<'_, S>, held: &mut Restraint<S>);

    /// Takes what it carries, as the accelerations were found, N; zero where it does not hold.
    fn carry(&mut self, multiplier: S);

    /// Lets go: what it carries would be less than nothing.
    fn let_go(&mut self, modes: &mut [i64]);
}

/// What every element can do because it is `Clone` and `'static`; nothing to write.
pub trait Boxed<S: Scalar> {
    /// A copy in a box.
    fn boxed_clone(&self) -> Box<dyn Element<S>>;

    /// The element as what it is.
    fn as_any(&self) -> &dyn Any;

    /// The same, to be changed.
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

/// The same, to be changed.
pub fn of_kind_mut<S: Scalar, T: 'static>(elements: &mut [Box<dyn Element<S>>]) -> impl Iterator<Item = &mut T> {
    elements.iter_mut().filter_map(|element| (**element).as_any_mut().downcast_mut())
}
