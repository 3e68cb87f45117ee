//! The weight of a rope, without its inertia.
//!
//! Its legs are taken as straight, between the centres of its stations, and its mass as spread evenly over the length l
//! of its path; the rope on the sheaves is left out. With the weight per length w(z), in air above the still water line
//! z = 0 and less the displaced water below, W(z) its integral from 0, the falls n_i and the distance d_i of leg i,
//! and the length L that lies on the path, L0 of it at the start,
//!
//! ```text
//! V = L W_mean - (L - L0) W(z_first),   W_mean = sum n_i d_i <W>_i / l,   <W>_i = mean of W over leg i
//! T(z) = T_mean + (L / l) (W(z) - W_mean)
//! ```
//!
//! where T_mean is the mean tension, which stretches the rope, and z_first the height of the drum, from which the rope
//! is paid out. The forces are -dV/dx, and a drum holds -dV/dL = W(z_first) - W_mean in addition to T_first: below a
//! drum at rest a rope with a load M pulls with M g at its last end and with M g + w L at the drum (Irvine, *Cable
//! Structures*, 1981, ch. 1: tension of a taut cable changes by w per height).

use super::release::is_off;
use super::stretch::Stretched;
use super::{Rope, RopePath, Station};
use crate::dynamics::Loads;
use crate::elements::Context;
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};
use core::f64::consts::FRAC_PI_4;

/// Mass and size of a rope per length.
#[derive(Clone, Copy, Debug)]
pub struct RopeWeight<S = f64> {
    /// kg/m.
    pub mass_per_length: S,
    /// Diameter of the circular section that displaces the same volume of water as the rope, m.
    pub diameter: S,
}

/// w, N/m.
#[derive(Clone, Copy, Debug)]
struct PerLength<S> {
    in_air: S,
    in_water: S,
}

/// The distribution of a rope's weight over its path.
#[derive(Clone, Copy, Debug)]
pub(super) struct WeightOnPath<S> {
    per_length: PerLength<S>,
    /// L / l.
    density: S,
    /// W_mean, N.
    mean: S,
}

impl<S: Scalar> RopeWeight<S> {
    fn per_length(&self, at: &Context<'_, S>) -> PerLength<S> {
        let area = self.diameter * self.diameter * S::constant(FRAC_PI_4);
        let in_air = self.mass_per_length * at.world.gravity;
        PerLength { in_air, in_water: in_air - at.world.water_density * at.world.gravity * area }
    }

    fn hanging(&self, at: &Context<'_, S>, path: &RopePath<S>, now: &Stretched<S>) -> WeightOnPath<S> {
        let per_length = self.per_length(at);
        let length = now.unstretched + now.stretch;
        let of_leg = |k: usize| {
            let (way, falls) = path.line(k);
            way.norm() * falls * per_length.mean(path.heights(k))
        };
        let sum = (0..path.stations().len() - 1).fold(S::ZERO, |sum, k| sum + of_leg(k));
        WeightOnPath { per_length, density: now.unstretched / length, mean: sum / length }
    }
}

impl<S: Scalar> PerLength<S> {
    /// Returns w(z), N/m.
    fn at(&self, height: S) -> S {
        height.select_below(0.0, || self.in_water, || self.in_air)
    }

    /// Returns W(z), N.
    fn integral(&self, height: S) -> S {
        self.at(height) * height
    }

    /// Returns the mean of W between two heights, N.
    fn mean(&self, [from, to]: [S; 2]) -> S {
        let half = S::constant(0.5);
        let on_one_side = || self.integral(from + to) * half;
        let across = || (self.integral(to) * to - self.integral(from) * from) * half / (to - from);
        (from * to).select_below(0.0, across, on_one_side)
    }

    /// Returns the derivatives of the mean with respect to both heights, N/m.
    fn slopes(&self, [from, to]: [S; 2]) -> [S; 2] {
        let product = from * to;
        let on_one_side = || self.at(from + to) * S::constant(0.5);
        let mean = self.mean([from, to]);
        let of =
            |end: S, other: S| product.select_below(0.0, || (self.integral(end) - mean) / (end - other), on_one_side);
        [of(from, to), of(to, from)]
    }
}

impl<S: Scalar> WeightOnPath<S> {
    /// Returns the tension at a height less the mean tension, N.
    fn above_mean(&self, height: S) -> S {
        self.density * (self.per_length.integral(height) - self.mean)
    }
}

impl<S: Scalar> Rope<S> {
    /// Returns the distribution, if the rope has weight and has not parted; the path has been evaluated at the present
    /// positions.
    fn hanging(&self, at: &Context<'_, S>, now: &Stretched<S>) -> Option<WeightOnPath<S>> {
        let weight = self.weight.filter(|_| !is_off(self.condition(at)))?;
        Some(weight.hanging(at, &self.path, now))
    }

    /// Adds -dV/dx on the bodies and -dV/dL on the drum.
    pub(super) fn weigh(&self, at: &Context<'_, S>, now: &Stretched<S>, loads: &mut Loads<S>) {
        self.weight_on_stations(at, now, |station, wrench| loads.wrenches.extend(station.on_body(at, wrench)));
        let (Some(drum), Some(hanging)) = (&self.drum, self.hanging(at, now)) else { return };
        let above_mean = hanging.per_length.integral(self.path.centre(0)[2]) - hanging.mean;
        loads.force[drum.coordinate] += now.paid_out.per_angle * above_mean;
    }

    /// Passes on -dV/dx at every station, in world axes.
    pub(super) fn weight_on_stations(
        &self,
        at: &Context<'_, S>,
        now: &Stretched<S>,
        mut hand: impl FnMut(&Station<S>, &Wrench<S>),
    ) {
        let Some(WeightOnPath { per_length, density, mean }) = self.hanging(at, now) else { return };
        let path = &self.path;
        path.pull_freely(-density * mean, &mut hand);
        let up = |force: S| Vector3([S::ZERO, S::ZERO, force]);
        let mut hand = |station: &Station<S>, force: Vector3<S>| {
            hand(station, &Wrench { moment: Vector3::zero(), force });
        };
        for (k, ends) in path.stations().windows(2).enumerate() {
            let (way, falls) = path.line(k);
            let (heights, length) = (path.heights(k), way.norm());
            let along = way * (density * falls * per_length.mean(heights) / length);
            let [by_from, by_to] = per_length.slopes(heights).map(|slope| up(slope * density * falls * length));
            hand(&ends[0], along - by_from);
            hand(&ends[1], -along - by_to);
        }
        if self.drum.is_some() {
            hand(&path.stations()[0], up(now.paid_out.length * per_length.at(path.centre(0)[2])));
        }
    }

    /// Returns V, J.
    pub(super) fn energy_of_weight(&self, at: &Context<'_, S>, now: &Stretched<S>) -> S {
        let Some(hanging) = self.hanging(at, now) else { return S::ZERO };
        now.unstretched * hanging.mean - now.paid_out.length * hanging.per_length.integral(self.path.centre(0)[2])
    }

    /// Returns the tensions at the first and the last end with the weight, and the largest on the path, N, each at
    /// least 0; `tensions` are the tensions at the first and the last end without the weight, N.
    pub(super) fn with_weight(&self, at: &Context<'_, S>, now: &Stretched<S>, tensions: [S; 2]) -> ([S; 2], S) {
        let larger = |a: S, b: S| a.select_less(b, || b, || a);
        let [first, last] = tensions;
        let largest = larger(first, last);
        let Some(hanging) = self.hanging(at, now) else { return (tensions, largest) };
        let end = self.path.stations().len() - 1;
        let here = |station: usize| hanging.above_mean(self.path.centre(station)[2]);
        let ends = [first + here(0), last + here(end)].map(|tension| larger(tension, S::ZERO));
        let highest = (1..=end).fold(here(0), |most, station| larger(most, here(station)));
        (ends, larger(largest + highest, S::ZERO))
    }
}
