//! The centre of mass of a ship with all that it carries, and the average of that centre.

use super::place::LowFrequencyFrame;
use crate::elements::{Context, StateDeclaration};
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Number of filters in series.
const ORDER: usize = 3;

/// The bodies that a hull carries: crane, load and all bodies that hang on them.
#[derive(Clone, Debug, Default)]
pub struct Carried<S = f64> {
    /// Each body, the hull included, with its share of the total mass.
    pub shares: Vec<(usize, S)>,
}

/// The centre of mass of the ship relative to that of its hull, through three first-order filters in series, `1 / (1 +
/// s/w)^3`. That position does not drift, so the lag of the filters is acceptable. For a load that swings at the wave
/// frequency omega the gain is `(w / omega)^3`.
#[derive(Clone, Copy, Debug)]
pub struct CarriedFilter<S> {
    /// Along the level axes of the slow frame after each filter, m.
    stages: [[S; 2]; ORDER],
}

impl<S: Scalar> Carried<S> {
    /// Returns the position of the total centre of mass relative to the hull's, and its rate, along the slow frame's
    /// axes; m, m/s.
    pub fn centre(&self, at: &Context<'_, S>, hull: usize, slow: &LowFrequencyFrame<S>) -> [[S; 2]; 2] {
        if self.shares.is_empty() {
            return [[S::ZERO; 2]; 2];
        }
        let of = |body: usize| {
            let frame = at.links.body_frame(at.model, body);
            (frame.position, frame.rotation * at.links.body_twist(at.model, body).linear)
        };
        let (place, velocity) = of(hull);
        let mut sums = [Vector3::zero(); 2];
        for (body, share) in &self.shares {
            let (there, moving) = of(*body);
            sums[0] += (there - place) * *share;
            sums[1] += (moving - velocity) * *share;
        }
        let level = slow.rotation();
        sums.map(|sum| {
            let [x, y, _] = level.transpose_times(sum).0;
            [x, y]
        })
    }
}

impl<S: Scalar> CarriedFilter<S> {
    /// Number of its states.
    pub const LEN: usize = 2 * ORDER;

    /// Returns the steady state for a constant position.
    pub fn at_rest(centre: [S; 2]) -> Self {
        Self { stages: [centre; ORDER] }
    }

    /// Returns the declarations of its states.
    pub fn declared() -> impl Iterator<Item = StateDeclaration> {
        let of =
            |stage: usize| ["x", "y"].map(|name| StateDeclaration::memory(format!("slow.carried_{name}.{stage}"), "m"));
        (1..=ORDER).flat_map(of)
    }

    /// Reads the filter from its states.
    pub fn read(states: &[S]) -> Self {
        Self { stages: core::array::from_fn(|stage| core::array::from_fn(|k| states[2 * stage + k])) }
    }

    /// Writes the filter to its states.
    pub fn write(&self, states: &mut [S]) {
        states.chunks_exact_mut(2).zip(&self.stages).for_each(|(states, stage)| states.copy_from_slice(stage));
    }

    /// Returns the deviation of the centre from its average, and its rate.
    pub fn off(&self, [centre, rate]: [[S; 2]; 2], cutoff_rad_s: f64) -> [[S; 2]; 2] {
        let [.., before, last] = &self.stages;
        let of_last = |k: usize| S::constant(cutoff_rad_s) * (before[k] - last[k]);
        [core::array::from_fn(|k| centre[k] - last[k]), core::array::from_fn(|k| rate[k] - of_last(k))]
    }

    /// Returns the rates of its states.
    pub fn rates(&self, centre: [S; 2], cutoff_rad_s: f64) -> Self {
        let before = |stage: usize, k: usize| if stage == 0 { centre[k] } else { self.stages[stage - 1][k] };
        let rate = |stage: usize, k: usize| S::constant(cutoff_rad_s) * (before(stage, k) - self.stages[stage][k]);
        Self { stages: core::array::from_fn(|stage| core::array::from_fn(|k| rate(stage, k))) }
    }
}
