//! A rope that does not stretch: its path cannot become longer than the rope.
//!
//! With the length l of the path and the length L of the rope on it, the taut rope holds the constraint
//!
//! ```text
//! phi = L - l = 0,   T = lambda >= 0
//! ```
//!
//! with a row of J from the forces of a unit tension. It goes slack when T would become negative. When the path is as
//! long as the rope again it comes taut with an impact, v+ = v - M*^-1 J^T (J M*^-1 J^T)^-1 J v, after which l' = L':
//! the energy of the motion along the rope becomes heat, as in a stiff rope whose damper leaves no rebound (Pfeiffer
//! & Glocker, *Multibody Dynamics with Unilateral Contacts*, 1996, ch. 8, with a coefficient of restitution of 0).
//! This is the limit of a rope without compliance.

use super::path::{PlacedStation, Wrap};
use super::release::is_off;
use super::station::StationMotion;
use super::{ROUNDING_M, Rope, RopePath, Round, SLACK, Station, TAUT};
use crate::dynamics::TemporaryConstraint;
use crate::elements::ropes::Efficiency;
use crate::elements::{Context, Holding};
use crate::model::Attachment;
use crate::scalar::{Dual, Scalar};
use crate::spatial::{Frame, Vector3};

/// A number with its time derivative.
type Rated<S> = Dual<1, S>;

/// Largest rate of l - L, m/s, at which a rope counts as just taut: rounding.
const ROUNDING_M_S: f64 = 1e-9;

/// Data that an inextensible rope needs in addition to its path.
#[derive(Clone, Debug)]
pub struct Inextensible<S = f64> {
    /// Copy of the path over numbers with time derivatives, so that the derivative of the length's rate is its second
    /// derivative.
    rated: RopePath<Rated<S>>,
    /// T from the last solution for the accelerations, N.
    pub(super) tension: S,
}

impl<S: Scalar> Inextensible<S> {
    /// Returns the data for a path, with a copy of its stations.
    pub fn new(path: &RopePath<S>) -> Self {
        let stations = path.stations().iter().map(|station| Station {
            centre: Attachment { body: None, in_body: Frame::identity(), link: None, in_link: Frame::identity() },
            round: station.round.map(|round| Round {
                axis: still(round.axis),
                radius: Dual::still(round.radius),
                efficiency: Efficiency { hoisting: Dual::ONE, lowering: Dual::ONE },
            }),
            falls: Dual::still(station.falls),
        });
        Self { rated: RopePath::new(stations.collect()), tension: S::ZERO }
    }

    /// l'' if every station's point x accelerates by omega x x' and no angular velocity changes, m/s^2; `path` has been
    /// evaluated at the present positions.
    fn bias_acceleration(&mut self, path: &RopePath<S>) -> S {
        let own = &mut self.rated;
        own.drum = path.drum.map(|wrap| Wrap { from: still(wrap.from), length: Dual::still(wrap.length) });
        for (own, place) in own.places.iter_mut().zip(&path.places) {
            let StationMotion { centre, velocity, angular_velocity: omega } = place.motion;
            let turning = |vector: Vector3<S>| rated(vector, omega.cross(vector));
            let motion = StationMotion {
                centre: rated(centre, velocity),
                velocity: turning(velocity),
                angular_velocity: still(omega),
            };
            *own = PlacedStation {
                motion,
                axis: turning(place.axis),
                from: turning(place.from),
                moments: [Vector3::zero(); 2],
            };
        }
        own.lay();
        own.measure().rate.derivative[0]
    }
}

fn still<S: Scalar>(vector: Vector3<S>) -> Vector3<Rated<S>> {
    Vector3(vector.0.map(Dual::still))
}

fn rated<S: Scalar>(vector: Vector3<S>, rate: Vector3<S>) -> Vector3<Rated<S>> {
    Vector3(core::array::from_fn(|k| Dual { value: vector[k], derivative: [rate[k]] }))
}

impl<S: Scalar> Rope<S> {
    /// Returns the mode of an inextensible rope at the start of a run: taut if the path is as long as the rope and its
    /// length does not change. If the ends move apart, the rope comes taut immediately, as an event.
    pub(super) fn held_at_start(&mut self, at: &Context<'_, S>) -> i64 {
        let now = self.laid(at);
        let longer = now.stretch.all(|stretch| stretch > ROUNDING_M);
        let just_taut = now.stretch.all(|stretch| stretch >= -ROUNDING_M)
            && now.rate.all(|rate| (-ROUNDING_M_S..=ROUNDING_M_S).contains(&rate));
        if longer || just_taut { TAUT } else { SLACK }
    }
}

impl<S: Scalar> Holding<S> for Rope<S> {
    fn holds(&self, modes: &[i64]) -> bool {
        self.inextensible.is_some() && modes.first() == Some(&TAUT)
    }

    fn restrain(&mut self, at: &Context<'_, S>, held: &mut [TemporaryConstraint<S>]) {
        let [held] = held else { return };
        let now = self.laid(at);
        let Self { path, inextensible, drum, .. } = self;
        held.clear();
        held.residual = -now.stretch;
        held.rate = -now.rate;
        held.bias_acceleration =
            inextensible.as_mut().map_or(S::ZERO, |own| now.paid_out.bias_acceleration - own.bias_acceleration(path));
        let [first, _] = path.pull(S::ONE, S::ZERO, |station, wrench| {
            held.wrenches.extend(station.on_body(at, wrench));
        });
        held.along.extend(drum.map(|drum| (drum.coordinate, now.paid_out.per_angle * first)));
    }

    fn carry(&mut self, multipliers: &[S]) {
        let tension = multipliers.first().copied().unwrap_or(S::ZERO);
        self.inextensible.iter_mut().for_each(|own| own.tension = tension);
    }

    fn let_go(&mut self, modes: &mut [i64]) {
        if !is_off(modes[0]) {
            modes[0] = SLACK;
        }
    }
}
