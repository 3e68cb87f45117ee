//! Hoists that let rope out to a load: the drum of its winch, or sheaves that a cylinder moves.

use super::chain::joint_twist;
use crate::elements::Context;
use crate::elements::ropes::{Drum, RopePath};
use crate::scalar::Scalar;
use crate::spatial::Twist;

/// Part by which a drive lets rope out.
#[derive(Clone, Debug)]
pub enum Hoist<S = f64> {
    /// The drum, as it turns.
    Drum(Drum<S>),
    /// Sheaves between drum and tip, as they move.
    Sheaves(MovedSheaves<S>),
}

/// Sheaves of a rope that a joint moves. With the length l of the path up to the crane's tip, at the joint's coordinate
/// x, they let out the length `-(l - l_0)` of rope, at `-dl/dx` per x: 2 where one sheave moves along two parallel
/// parts. The operator keeps the control of the drum.
#[derive(Clone, Debug)]
pub struct MovedSheaves<S = f64> {
    path: RopePath<S>,
    joint: usize,
    /// Whether each station moves with the joint.
    moved: Vec<bool>,
}

/// Rope let out by a drive.
#[derive(Clone, Copy, Debug)]
pub struct LetOut<S> {
    /// Length, m; only differences are used.
    pub length: S,
    /// Its derivative with respect to the drive's coordinate, m/rad or 1.
    pub per_position: S,
}

/// Lower bound of the rope let out per coordinate of moved sheaves: the commanded speed stays finite where the sheaves
/// move across the rope.
const LEAST_PER_POSITION: f64 = 1e-2;

impl<S: Scalar> Hoist<S> {
    /// Prepares the path of the rope at the start of a run.
    pub fn begin(&mut self, at: &Context<'_, S>) {
        if let Self::Sheaves(sheaves) = self {
            sheaves.path.begin(at);
        }
    }

    /// Returns the rope that is let out now.
    pub fn let_out(&mut self, at: &Context<'_, S>) -> LetOut<S> {
        match self {
            Self::Drum(drum) => {
                let paid_out = drum.paid_out(at);
                LetOut { length: paid_out.length, per_position: paid_out.per_angle }
            }
            Self::Sheaves(sheaves) => sheaves.let_out(at),
        }
    }

    /// Returns the largest speed at which a drive at this speed lets out rope, m/s.
    pub fn fastest(&self, speed: S) -> S {
        match self {
            Self::Drum(drum) => speed * drum.radius,
            Self::Sheaves(sheaves) => speed * sheaves.parts(),
        }
    }
}

impl<S: Scalar> MovedSheaves<S> {
    /// Returns the moved sheaves of a path up to the tip; `moved` holds for each station whether it moves with this
    /// link's joint. `None` if no station moves, or if the tip moves.
    pub fn new(path: RopePath<S>, joint: usize, moved: Vec<bool>) -> Option<Self> {
        let tip = moved.last().copied().unwrap_or(true);
        (!tip && moved.contains(&true)).then_some(Self { path, joint, moved })
    }

    /// Returns the number of parts of rope whose length the joint changes.
    fn parts(&self) -> S {
        let changes = self.moved.windows(2).map(|ends| ends[0] != ends[1]);
        let legs = self.path.stations()[1..].iter().zip(changes);
        legs.filter(|(_, changes)| *changes).fold(S::ZERO, |sum, (behind, _)| sum + behind.falls)
    }

    fn let_out(&mut self, at: &Context<'_, S>) -> LetOut<S> {
        let moving = self.moved.iter().zip(self.path.stations()).map(|(moves, station)| {
            let place = at.links.attachment_frame(at.model, &station.centre).position;
            if *moves { joint_twist(at, self.joint, place) } else { Twist::zero() }
        });
        let twists: Vec<Twist<S>> = moving.collect();
        let [length, rate] = self.path.length_and_rate_by(at, &twists);
        let per_position = -rate;
        let least = S::constant(LEAST_PER_POSITION);
        let down = || per_position.select_less(-least, || per_position, || -least);
        let up = || least.select_less(per_position, || per_position, || least);
        LetOut { length: -length, per_position: per_position.select_below(0.0, down, up) }
    }
}
