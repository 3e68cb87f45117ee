//! The supply of a line: a drum and sheaves, over which it runs to its first end.
//!
//! Between the drum and the first end the line is without mass and does not stretch, and its length l follows from its path
//! (`ropes/path.rs`). With the length P that the drum has paid out since the start, the length of the first part is
//! `L = L_0 + P - (l - l_0)`. The mass of what was let out since then, with its weight, is taken from the first place of the path,
//! where the rest of it is stored; the moment of inertia of a drum stays.
//!
//! Material jumps from that place, with the velocity v_f, to the first end, with v_1, which accelerates it: the thrust
//! `mu L' (v_f - v_1)` acts on the first end. Energy is conserved with the force `mu |v_1 - v_f|^2 / 2` along L, with which the line
//! is drawn outwards, as by the centrifugal force on what is between the two.

use super::feed::LineFeed;
use crate::dynamics::Loads;
use crate::elements::lines::{place, pull_at, velocity};
use crate::elements::ropes::{Drum, RopePath, Round, Station};
use crate::elements::{Context, Crossing, Event};
use crate::scalar::Scalar;
use crate::spatial::{Frame, Matrix3, SpatialInertia, Symmetric3, Vector3};

/// Share of the length at the start below which the first part is no longer shortened.
const SHORTEST: f64 = 1e-3;

/// Events of a line that is paid out, in the order of its [indicators](LineSupply::indicators).
pub(super) const EVENTS: [Event; 4] = [
    Event { code: "hauled_in_to_end", what: "is hauled in to its end", crossing: Crossing::Falling },
    Event {
        code: "paid_out_to_innermost_layer",
        what: "is paid out to the innermost layer of its drum",
        crossing: Crossing::Falling,
    },
    Event {
        code: "leaves_valid_path",
        what: "wraps a sheave or drum beyond the valid angle, or two neighbouring places of its path overlap",
        crossing: Crossing::Falling,
    },
    Event {
        code: "lets_out_mass_of_first_body",
        what: "has let out more than the mass of its drum, or of the body at the first place of its path, which contains the wire there",
        crossing: Crossing::Falling,
    },
];

/// A drum and sheaves from which a line is paid out.
#[derive(Clone, Debug)]
pub struct LineSupply<S = f64> {
    /// The path, without the last end of the line: its last station is the first end, taken as a point. `None` if the line
    /// leaves its first station directly.
    inboard: Option<RopePath<S>>,
    /// The whole path, for its checks at the start.
    pub(super) whole: RopePath<S>,
    /// The first station.
    from: Station<S>,
    /// The drum there; without it, the end of the line is fixed there.
    pub(super) drum: Option<Drum<S>>,
    /// The sheave at the first end.
    tip: Option<Round<S>>,
    /// Length of the first part at the start, m.
    at_start: S,
    /// Length of the path at the start, m.
    inboard_at_start: S,
}

/// The supply of a line at a moment.
#[derive(Clone, Copy, Debug)]
pub struct Supplied<S> {
    /// Length of the first part, m.
    pub length: S,
    /// Its rate, m/s.
    pub rate: S,
    /// Length left until the first part is hauled in, m.
    pub left: S,
    /// Angle left until the innermost layer of the drum, rad.
    pub layers_left: S,
    /// Margin of the wraps at the sheaves, as of a rope's path, rad.
    pub range_left: S,
    /// Rate of the drum, m/s, and its derivative along the drum's coordinate, m.
    drum: [S; 2],
    /// Height of the first station, world, m.
    height: S,
}

impl<S: Scalar> LineSupply<S> {
    /// Creates a supply along the stations of a path, of which the last is the last end of the line.
    pub fn new(stations: &[Station<S>], drum: Option<Drum<S>>, length: S) -> Self {
        let whole = RopePath::new(stations.to_vec());
        let tip = if stations.len() > 2 { stations[stations.len() - 2].round } else { None };
        Self {
            inboard: whole.up_to_tip(),
            whole,
            from: stations[0].clone(),
            drum,
            tip,
            at_start: length,
            inboard_at_start: S::ZERO,
        }
    }

    /// Takes the start of a run as the reference of drum and path. Returns the path to the last end of the line.
    pub fn begin(&mut self, at: &Context<'_, S>) -> &mut RopePath<S> {
        if let Some(drum) = &mut self.drum {
            drum.start = at.q[drum.position];
        }
        if let Some(path) = &mut self.inboard {
            path.begin(at);
            self.inboard_at_start = path.extent(at).length;
        }
        self.whole.begin(at);
        &mut self.whole
    }

    /// Returns the length of the first part and its rate.
    pub fn now(&mut self, at: &Context<'_, S>) -> Supplied<S> {
        let none = (S::ZERO, S::ZERO, S::ONE);
        let (inboard, inboard_rate, range_left) = self.inboard.as_mut().map_or(none, |path| {
            let extent = path.extent(at);
            (extent.length - self.inboard_at_start, extent.rate, extent.range_left)
        });
        let still = (S::ZERO, [S::ZERO; 2], S::ONE);
        let (paid_out, drum, layers_left) = self.drum.map_or(still, |drum| {
            let paid_out = drum.paid_out(at);
            (paid_out.length, [paid_out.rate, paid_out.per_angle], paid_out.left)
        });
        let shortest = self.at_start * S::constant(SHORTEST);
        let length = self.at_start + paid_out - inboard;
        let left = length - shortest;
        let height = place(&self.from.centre, at.model, at.links)[2];
        Supplied {
            length: left.select_below(0.0, || shortest, || length),
            rate: left.select_below(0.0, || S::ZERO, || drum[0] - inboard_rate),
            left,
            layers_left,
            range_left,
            drum,
            height,
        }
    }

    /// Adds the loads on drum and sheaves by the force with which the line draws from its supply, their heat, and the inertia that
    /// left the first station. The line has this mass per length, kg/m. Returns the thrust on the first end, world, N.
    pub fn draw(
        &self,
        now: &Supplied<S>,
        feed: &LineFeed<S>,
        mass_per_length: S,
        at: &Context<'_, S>,
        loads: &mut Loads<S>,
    ) -> Vector3<S> {
        let (weight, half) = (mass_per_length * at.world.gravity, S::constant(0.5));
        let leaves = velocity(&self.from.centre, at);
        let faster = feed.tip - leaves;
        let outward = mass_per_length * half * faster.norm_squared();
        let force = feed.force + feed.of_end + weight * now.height + outward;
        let over_tip = force * self.tip.map_or(S::ONE, |round| round.efficiency.of_rope(now.rate));
        let [mut first, mut power] = self.inboard.as_ref().map_or([over_tip, S::ZERO], |path| {
            path.pull(over_tip, -now.rate, |station, wrench| loads.wrenches.extend(station.on_body(at, wrench)))
        });
        if let Some(drum) = &self.drum {
            let [rate, per_angle] = now.drum;
            first = first * self.from.round.map_or(S::ONE, |round| round.efficiency.of_rope(rate));
            loads.force[drum.coordinate] += per_angle * first;
            power += rate * first;
        }
        loads.power.dissipated += force * now.rate - power;
        let let_out = now.length - self.at_start;
        pull_at(&self.from.centre, Vector3([S::ZERO, S::ZERO, let_out * weight]), at, loads);
        if let Some(body) = self.from.centre.body {
            let linear = Symmetric3::diagonal([-let_out * mass_per_length; 3]);
            let inertia = SpatialInertia { angular: Symmetric3::default(), coupling: Matrix3::zero(), linear };
            let place = Frame::translation(self.from.centre.in_body.position);
            loads.added_inertia.push((body, inertia.to_parent(&place)));
        }
        let kinetic = (leaves.norm_squared() - feed.tip.norm_squared()) * half;
        loads.power.outside += feed.entering + mass_per_length * kinetic * now.rate;
        feed.thrust - faster * (mass_per_length * now.rate)
    }

    /// Returns the body whose mass contains the wire that is stored: the drum, or that of the first place.
    fn store(&self, at: &Context<'_, S>) -> Option<usize> {
        let drum = self.drum.as_ref().and_then(|drum| at.model.owner(drum.coordinate));
        drum.map(|(body, _)| body).or(self.from.centre.body)
    }

    /// Returns the indicators of the [events](EVENTS) of a line with this mass per length, kg/m.
    pub fn indicators(&self, now: &Supplied<S>, mass_per_length: S, at: &Context<'_, S>) -> [S; 4] {
        let stored = |body: usize| at.model.bodies[body].mass + (self.at_start - now.length) * mass_per_length;
        [now.left, now.layers_left, now.range_left, self.store(at).map_or(S::ONE, stored)]
    }

    /// Returns the potential energy of the weight that was let out, J.
    pub fn energy(&self, now: &Supplied<S>, mass_per_length: S, at: &Context<'_, S>) -> S {
        (self.at_start - now.length) * mass_per_length * at.world.gravity * now.height
    }
}
