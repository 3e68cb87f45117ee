//! The coordinates along which the water acts on a hull, from the states that the hull keeps.

use super::carried::{Carried, CarriedFilter};
use super::place::{CoefficientFrame, LowFrequencyFrame, SeaAxes};
use super::slow_filter::SlowFilter;
use crate::elements::{Context, EvaluationMode};
use crate::scalar::Scalar;
use crate::spatial::Twist;

/// The coordinates of a hull's wave loads.
#[derive(Clone, Debug)]
pub struct WaveCoordinates<S = f64> {
    /// Axes of radiation, added mass and excitation: the hull's axes in the attitude for which the coefficients were
    /// computed.
    pub coefficients: CoefficientFrame<S>,
    /// The bodies that the ship carries.
    pub carried: Carried<S>,
    /// Cut-off of the filter of the slow frame, rad/s.
    pub cutoff_rad_s: f64,
}

impl<S: Scalar> WaveCoordinates<S> {
    /// Returns the average position of the hull; while an equilibrium is sought, its present position.
    pub fn low_frequency_frame(&self, at: &Context<'_, S>) -> LowFrequencyFrame<S> {
        match at.evaluation {
            EvaluationMode::Settling => LowFrequencyFrame::of(&self.coefficients.frame(at.model, at.links)),
            _ => SlowFilter::read(at.states).frame(),
        }
    }

    /// Returns the horizontal deviation of the ship's centre of mass from its mean position relative to the hull, m,
    /// and the rate of this deviation.
    pub fn off(&self, at: &Context<'_, S>, slow: &LowFrequencyFrame<S>) -> [[S; 2]; 2] {
        if at.evaluation == EvaluationMode::Settling {
            return [[S::ZERO; 2]; 2];
        }
        let centre = self.carried.centre(at, self.coefficients.body, slow);
        CarriedFilter::read(States::of(at.states).carried).off(centre, self.cutoff_rad_s)
    }

    /// Returns the hull at the moment of a context with its states.
    pub(super) fn seen(&self, at: &Context<'_, S>) -> Seen<S> {
        let slow = self.low_frequency_frame(at);
        let off = self.off(at, &slow);
        let axes = SeaAxes::of(&self.coefficients, &self.coefficients.frame(at.model, at.links), &slow, off[0]);
        Seen { slow, off, axes, twist: at.links.body_twist(at.model, self.coefficients.body) }
    }
}

/// A hull at one moment, for the wave loads.
#[derive(Clone, Debug)]
pub(super) struct Seen<S> {
    /// The slow frame.
    pub slow: LowFrequencyFrame<S>,
    /// [`WaveCoordinates::off`].
    pub off: [[S; 2]; 2],
    /// The axes of the loads.
    pub axes: SeaAxes<S>,
    /// Twist of the body about its centre of mass, in its axes.
    pub twist: Twist<S>,
}

/// States of a hull, or their rates: those of the position filter, of the filter of the carried bodies, and of
/// radiation.
pub(super) struct States<T> {
    pub place: T,
    pub carried: T,
    pub radiation: T,
}

impl<'a, S: Scalar> States<&'a [S]> {
    pub fn of(states: &'a [S]) -> Self {
        let (place, rest) = states.split_at(SlowFilter::<S>::LEN);
        let (carried, radiation) = rest.split_at(CarriedFilter::<S>::LEN);
        Self { place, carried, radiation }
    }
}

impl<'a, S: Scalar> States<&'a mut [S]> {
    pub fn of_mut(states: &'a mut [S]) -> Self {
        let (place, rest) = states.split_at_mut(SlowFilter::<S>::LEN);
        let (carried, radiation) = rest.split_at_mut(CarriedFilter::<S>::LEN);
        Self { place, carried, radiation }
    }
}
