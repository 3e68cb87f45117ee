//! The path of a rope over points, sheaves and a drum: its length, and the forces of the rope's tension on the bodies.
//!
//! Leg i leads from station i to the next, in n_i parallel falls. With the centres c_i of the stations, the way w_i =
//! c_(i+1) - c_i, d_i = |w_i|, u_i = w_i / d_i, the sheaves' radii R_i and axes a_i, about which the rope turns on its
//! path from its first end to its last,
//!
//! ```text
//! l = sum over legs of n_i [sqrt(d_i^2 - rho_i^2) + rho_i asin(rho_i / d_i)],
//!     plus the sum over sheaves and drum of R_i beta_i
//! rho_i = R_i - (a_i . a_(i+1)) R_(i+1),  R_i if the second station is a point,
//!     -R_(i+1) if the first is,  0 if both are
//! beta_i = atan2(a_i . (u_(i-1) x u_i), u_(i-1) . u_i),  from -90 to 270 degrees
//! ```
//!
//! This is the length of a belt if its legs lie in the planes of the sheaves, and a smooth function of centres and axes
//! if not. beta is evaluated as 90 degrees plus an atan2 between -180 and 180. Forces and moments are the derivatives
//! of l times the tension, so they are consistent with the energy on any path.

use super::station::{Round, Station, StationMotion};
use crate::elements::Context;
use crate::scalar::Scalar;
use crate::spatial::{Twist, Vector3, Wrench};
use core::f64::consts::FRAC_PI_2;

/// Largest wrap angle from the middle of its range, rad: 175 degrees.
const FARTHEST: f64 = 175.0 * core::f64::consts::PI / 180.0;

/// The stations of a rope in order, with working memory for their evaluation.
#[derive(Clone, Debug)]
pub struct RopePath<S = f64> {
    /// At least two. The last is a point; the first is a point or a drum.
    stations: Vec<Station<S>>,
    /// The wrap, if the first station is a drum.
    pub(super) drum: Option<Wrap<S>>,
    pub(super) places: Vec<PlacedStation<S>>,
    legs: Vec<Leg<S>>,
}

/// The wrap of the rope on a drum at the start of a run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wrap<S> {
    /// The direction from which the wrap angle is measured, in the axes of the body that carries the drum.
    pub from: Vector3<S>,
    /// Length from this direction to the point where the rope leaves the drum, m.
    pub length: S,
}

/// A station at the present positions; vectors in world axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlacedStation<S> {
    pub motion: StationMotion<S>,
    pub axis: Vector3<S>,
    /// For a drum: the direction from which the wrap angle is measured.
    pub from: Vector3<S>,
    /// Moments on the station's body per tension of the legs before and after it, m.
    pub moments: [Vector3<S>; 2],
}

/// A leg between two stations; vectors in world axes.
#[derive(Clone, Copy, Debug)]
struct Leg<S> {
    /// Unit vector between the centres.
    along: Vector3<S>,
    /// Between the centres, m.
    distance: S,
    /// The axis about which the rope is rotated from the line of centres, by the angle with this sine and cosine.
    axis: Vector3<S>,
    sine: S,
    cosine: S,
    /// The sum of both radii, m.
    radii: S,
    /// Derivative of the path's length with respect to the position of the station after it.
    gradient: Vector3<S>,
    /// Contribution of the leg to the rate of the path's length, m/s.
    rate: S,
}

/// Length of a path.
#[derive(Clone, Copy, Debug)]
pub struct PathLength<S> {
    /// Length from the first end, or from the point where the rope leaves its drum, to the last end, m; all falls of a
    /// leg count.
    pub length: S,
    /// Its rate, m/s.
    pub rate: S,
    /// Smallest margin of the path: of the wrap angle to the ends of its range less 5 degrees at every sheave and drum,
    /// rad, and of the gaps between sheaves over the distance of their centres. Below 0 the path is no longer valid.
    pub range_left: S,
}

impl<S: Scalar> RopePath<S> {
    /// Returns a path over at least two stations.
    pub fn new(stations: Vec<Station<S>>) -> Self {
        let zero = Vector3::zero();
        let motion = StationMotion { centre: zero, velocity: zero, angular_velocity: zero };
        let place = PlacedStation { motion, axis: zero, from: zero, moments: [zero; 2] };
        let (distance, sine, cosine, rate) = (S::ONE, S::ZERO, S::ONE, S::ZERO);
        let leg = Leg { along: zero, distance, axis: zero, sine, cosine, radii: S::ZERO, gradient: zero, rate };
        let (places, legs) = (vec![place; stations.len()], vec![leg; stations.len().saturating_sub(1)]);
        Self { stations, drum: None, places, legs }
    }

    /// Returns the path up to the station before its last end, taken as a point; `None` if the path has only two
    /// stations.
    pub fn up_to_tip(&self) -> Option<Self> {
        let (_, before) = self.stations.split_last()?;
        let (tip, rest) = before.split_last()?;
        let end = Station { round: None, ..tip.clone() };
        (!rest.is_empty()).then(|| Self::new(rest.iter().cloned().chain([end]).collect()))
    }

    /// Returns the stations, in order.
    pub fn stations(&self) -> &[Station<S>] {
        &self.stations
    }

    /// Returns the pairs of bodies that the legs connect.
    pub fn attached_bodies(&self) -> Vec<[Option<usize>; 2]> {
        self.stations.windows(2).map(|ends| [ends[0].centre.body, ends[1].centre.body]).collect()
    }

    /// Returns the axis of a station, a unit vector in the world, at the positions of the last
    /// [`extent`](Self::extent).
    pub(super) fn axis(&self, station: usize) -> Vector3<S> {
        self.places[station].axis
    }

    /// Returns the centre of a station in the world, m, at the positions of the last [`extent`](Self::extent).
    pub(super) fn centre(&self, station: usize) -> Vector3<S> {
        self.places[station].motion.centre
    }

    /// Returns the vector between the centres of a leg's stations, m, and its falls, at the positions of the last
    /// [`extent`](Self::extent).
    pub(super) fn line(&self, leg: usize) -> (Vector3<S>, S) {
        let Leg { along, distance, .. } = self.legs[leg];
        (along * distance, self.stations[leg + 1].falls)
    }

    /// Returns the heights of the centres of a leg's stations, m, at the positions of the last
    /// [`extent`](Self::extent).
    pub(super) fn heights(&self, leg: usize) -> [S; 2] {
        [leg, leg + 1].map(|station| self.centre(station)[2])
    }

    /// Sets the reference of the wrap on the drum at the start of a run.
    pub fn begin(&mut self, at: &Context<'_, S>) {
        let Some(drum) = self.stations[0].round else { return };
        self.stand(at);
        let across = self.legs[0].along.cross(self.places[0].axis);
        let from = self.stations[0].to_body(at, across * (S::ONE / across.norm()));
        let angle = S::constant(FRAC_PI_2) + self.legs[0].lean();
        self.drum = Some(Wrap { from, length: angle * drum.radius });
    }

    /// Returns the first leg between overlapping stations: its number, the distance of the centres and the sum of the
    /// radii, m.
    pub fn overlap(&mut self, at: &Context<'_, S>) -> Option<(usize, [S; 2])> {
        self.stand(at);
        let mut legs = self.legs.iter().enumerate().map(|(k, leg)| (k, [leg.distance, leg.radii]));
        legs.find(|(_, [distance, radii])| !(*distance - *radii).all(|apart| apart > 0.0))
    }

    /// Returns the wrap angles at the sheaves, each with the number of the station, rad; call after
    /// [`extent`](Self::extent).
    pub fn wraps(&mut self) -> Vec<(usize, S)> {
        let inner = 1..self.legs.len();
        let of = |i: usize| {
            let round = self.stations[i].round?;
            let (before, behind) = (self.legs[i - 1], self.legs[i]);
            let sense = before.axis.dot(self.places[i].axis);
            let lean = behind.lean() - before.lean() * sense;
            Some((i, self.turn(i, &round) + S::constant(FRAC_PI_2) + lean))
        };
        inner.filter_map(of).collect()
    }

    /// Whether the axis of the drum points along the rope, which then cannot leave the drum on either side.
    pub fn drum_is_along(&mut self, at: &Context<'_, S>) -> bool {
        self.stand(at);
        let across = self.legs[0].along.cross(self.places[0].axis).norm_squared();
        // The limit is the square of a sine: within 1 mrad of the axis.
        self.stations[0].round.is_some() && !across.all(|across| across > 1e-6)
    }

    /// Returns length and rate at the present positions.
    pub fn extent(&mut self, at: &Context<'_, S>) -> PathLength<S> {
        self.stand(at);
        self.measure()
    }

    /// Returns length and rate for the stations as placed.
    pub(super) fn measure(&mut self) -> PathLength<S> {
        let mut length = self.drum.map_or(S::ZERO, |wrap| -wrap.length);
        for (k, leg) in self.legs.iter_mut().enumerate() {
            let (behind, lean) = (&self.stations[k + 1], leg.lean());
            length += leg.distance * (leg.cosine + leg.sine * lean) * behind.falls;
            leg.gradient = leg.along * (leg.cosine * behind.falls);
            if let (Some(_), Some(behind)) = (self.stations[k].round, behind.round) {
                let moment = self.places[k].axis.cross(self.places[k + 1].axis) * (lean * behind.radius);
                self.places[k].moments[1] += moment;
                self.places[k + 1].moments[0] += -moment;
            }
        }
        let (mut rate, mut range_left) = (S::ZERO, S::constant(FARTHEST));
        for i in 0..self.legs.len() {
            if let Some(round) = self.stations[i].round {
                let from_middle = self.turn(i, &round);
                length += round.radius * (from_middle + S::constant(FRAC_PI_2));
                let left = S::constant(FARTHEST) - from_middle.select_below(0.0, || -from_middle, || from_middle);
                range_left = left.select_less(range_left, || left, || range_left);
            }
        }
        for leg in self.legs.iter().filter(|leg| leg.radii != S::ZERO) {
            let gap = S::ONE - leg.radii / leg.distance;
            range_left = gap.select_less(range_left, || gap, || range_left);
        }
        for (leg, ends) in self.legs.iter_mut().zip(self.places.windows(2)) {
            let [(first, behind_first), (second, before_second)] =
                [(ends[0].motion, ends[0].moments[1]), (ends[1].motion, ends[1].moments[0])];
            leg.rate = leg.gradient.dot(second.velocity - first.velocity)
                - first.angular_velocity.dot(behind_first)
                - second.angular_velocity.dot(before_second);
            rate += leg.rate;
        }
        PathLength { length, rate, range_left }
    }

    /// Returns the length, m, and its rate, m/s, for these velocities of the stations instead of the actual ones.
    pub fn length_and_rate_by(&mut self, at: &Context<'_, S>, velocities: &[Twist<S>]) -> [S; 2] {
        self.stand(at);
        for (place, twist) in self.places.iter_mut().zip(velocities) {
            (place.motion.velocity, place.motion.angular_velocity) = (twist.linear, twist.angular);
        }
        let PathLength { length, rate, .. } = self.measure();
        [length, rate]
    }

    /// Computes the positions of the stations, and the legs.
    fn stand(&mut self, at: &Context<'_, S>) {
        for (place, station) in self.places.iter_mut().zip(&self.stations) {
            let axis = station.round.map_or(Vector3::zero(), |round| station.to_world(at, round.axis));
            *place = PlacedStation {
                motion: station.motion(at),
                axis,
                from: Vector3::zero(),
                moments: [Vector3::zero(); 2],
            };
        }
        if let Some(wrap) = self.drum {
            self.places[0].from = self.stations[0].to_world(at, wrap.from);
        }
        self.lay();
    }

    /// Computes the legs between the stations as placed.
    pub(super) fn lay(&mut self) {
        for (k, leg) in self.legs.iter_mut().enumerate() {
            let ends = [k, k + 1].map(|i| (self.stations[i].round.map(|round| round.radius), self.places[i].axis));
            let radii = ends.iter().fold(S::ZERO, |sum, (radius, _)| sum + radius.unwrap_or(S::ZERO));
            let (rho, axis) = match ends {
                [(Some(first), a), (Some(second), b)] => (first - a.dot(b) * second, a),
                [(Some(radius), axis), (None, _)] => (radius, axis),
                [(None, _), (Some(radius), axis)] => (-radius, axis),
                [(None, _), (None, _)] => (S::ZERO, Vector3::zero()),
            };
            let way = self.places[k + 1].motion.centre - self.places[k].motion.centre;
            let distance = at_least_something(way.norm_squared()).sqrt();
            // Between overlapping sheaves there is no straight rope.
            let sine = (rho / distance).clipped(-S::ONE, S::ONE);
            let cosine = at_least_something(S::ONE - sine * sine).sqrt();
            *leg = Leg { along: way * (S::ONE / distance), distance, axis, sine, cosine, radii, ..*leg };
        }
    }

    /// Returns beta of a round station less 90 degrees, adds R times its derivatives to the adjacent legs, and stores
    /// the moments of the station.
    fn turn(&mut self, i: usize, round: &Round<S>) -> S {
        let (axis, behind) = (self.places[i].axis, self.legs[i].along);
        let before = match (i.checked_sub(1), self.drum) {
            (Some(k), _) => self.legs[k].along,
            (None, Some(_)) => self.places[0].from,
            (None, None) => return S::constant(-FRAC_PI_2),
        };
        let (cosine, sine) = (before.dot(behind), axis.dot(before.cross(behind)));
        let scale = round.radius / at_least_something(cosine * cosine + sine * sine);
        let by_behind = (axis.cross(before) * cosine - before * sine) * scale;
        let by_before = (behind.cross(axis) * cosine - behind * sine) * scale;
        self.legs[i].turns_with(by_behind);
        self.places[i].moments[1] += behind.cross(by_behind);
        // The direction from which the wrap on a drum is measured is fixed in the station's body.
        if let Some(k) = i.checked_sub(1) {
            self.legs[k].turns_with(by_before);
            self.places[i].moments[0] += before.cross(by_before);
        }
        (-cosine).atan2(sine)
    }

    /// Applies a tension at the last end to the bodies, at the positions of the last [`extent`](Self::extent): each
    /// station gets the wrench, in world axes, of its adjacent legs, whose tensions differ by the friction at the
    /// sheaves. The speed of the rope over a sheave is the rate that the drum pays out less the rate at which the legs
    /// before it lengthen; all legs together lengthen at `stretch_rate`, m/s, faster than the drum pays out. Friction
    /// therefore never adds energy. Returns the tension at the first end, N, and the power given to the bodies, W.
    pub fn pull(&self, tension: S, stretch_rate: S, hand: impl FnMut(&Station<S>, &Wrench<S>)) -> [S; 2] {
        self.hand_on(tension, stretch_rate, |round, speed| round.efficiency.of_rope(speed), hand)
    }

    /// Applies a tension at the last end to the bodies like [`pull`](Self::pull), without friction.
    pub(super) fn pull_freely(&self, tension: S, hand: impl FnMut(&Station<S>, &Wrench<S>)) {
        self.hand_on(tension, S::ZERO, |_, _| S::ONE, hand);
    }

    fn hand_on(
        &self,
        tension: S,
        stretch_rate: S,
        ratio: impl Fn(Round<S>, S) -> S,
        mut hand: impl FnMut(&Station<S>, &Wrench<S>),
    ) -> [S; 2] {
        let (mut power, mut speed) = (S::ZERO, -stretch_rate);
        let (mut behind, mut by_behind) = (tension, Vector3::zero());
        for (i, (station, place)) in self.stations.iter().zip(&self.places).enumerate().rev() {
            let before = behind * station.round.filter(|_| i > 0).map_or(S::ONE, |round| ratio(round, speed));
            let leg = i.checked_sub(1).map(|k| &self.legs[k]);
            let by_before = leg.map_or(Vector3::zero(), |leg| leg.gradient * before);
            let force = by_behind - by_before;
            let moment = place.moments[0] * before + place.moments[1] * behind;
            power += force.dot(place.motion.velocity) + moment.dot(place.motion.angular_velocity);
            hand(station, &Wrench { moment, force });
            speed += leg.map_or(S::ZERO, |leg| leg.rate);
            (behind, by_behind) = (before, by_before);
        }
        [behind, power]
    }

    /// Returns the ratio of the force that the drum holds to the tension of the rope, at a pay-out speed, m/s.
    pub(super) fn ratio_at_drum(&self, paid_out: S) -> S {
        self.stations[0].round.map_or(S::ONE, |drum| drum.efficiency.of_rope(paid_out))
    }

    /// Returns the straight parts of the legs at the positions of the last [`extent`](Self::extent): from the contact
    /// point at the station before to that at the station after, world, m.
    pub fn straights(&self) -> impl Iterator<Item = [Vector3<S>; 2]> + '_ {
        let touches = |i: usize, leg: &Leg<S>| {
            let foot = leg.direction().cross(self.places[i].axis);
            let radius = self.stations[i].round.map_or(S::ZERO, |round| round.radius);
            self.places[i].motion.centre + foot * radius
        };
        self.legs.iter().enumerate().map(move |(k, leg)| [touches(k, leg), touches(k + 1, leg)])
    }
}

impl<S: Scalar> Leg<S> {
    /// Returns the angle from the line of centres to the rope, rad.
    fn lean(&self) -> S {
        self.sine.atan2(self.cosine)
    }

    /// Returns the rope's direction in the plane of its sheaves.
    fn direction(&self) -> Vector3<S> {
        self.along * self.cosine + self.axis.cross(self.along) * self.sine
    }

    /// Adds the derivative with respect to the position of the station after the leg, from the derivative with respect
    /// to the unit vector along the leg.
    fn turns_with(&mut self, by_along: Vector3<S>) {
        self.gradient += (by_along - self.along * self.along.dot(by_along)) * (S::ONE / self.distance);
    }
}

/// Returns a non-negative number, bounded below by the smallest valid divisor.
fn at_least_something<S: Scalar>(x: S) -> S {
    x.select_below(f64::MIN_POSITIVE, || S::constant(f64::MIN_POSITIVE), || x)
}
