//! Estimate of a point's motion along one axis for a compensation: measured or predicted.

use super::measurement::{Measured, Measurement};
use super::predictor::FilterBank;
use crate::elements::{ElementState, Occurrence};
use crate::scalar::Scalar;

/// Estimates velocity and position of a point along axes of the world.
#[derive(Clone, Debug)]
pub struct Estimator<S = f64> {
    /// Source of the measured motion.
    pub measurement: Measurement<S>,
    /// Prediction; `None` to use the measured motion.
    pub prediction: Option<Prediction<S>>,
    /// Sampling period T_s, s.
    pub period_s: f64,
}

/// The weights of a filter bank for each result.
#[derive(Clone, Debug)]
pub struct Prediction<S = f64> {
    /// The bank.
    pub bank: FilterBank,
    /// k, 1/s: rate at which the measured position corrects the measured velocity; 0 if both are exact. With the
    /// measured position x and velocity v, the complementary filter `s (v + k x) / (s + k)` uses v at frequencies above
    /// k and the rate of x below k, so that neither a bias nor the slow noise of v is integrated (Fossen, 2021, sec.
    /// 13.2).
    pub correction: f64,
    /// Weights of each result, for the linear and for the angular part of the measured velocity: the velocity to command to
    /// each drive, or the height at each lead time.
    pub results: Vec<[Vec<S>; 2]>,
    /// Weights of the position, for the linear and for the angular part of the measured velocity. If the second is
    /// absent, the position due to the body's rotation is measured: with a lever arm that changes with the motion, the
    /// integral of its velocity would drift.
    pub position: Vec<Vec<S>>,
    /// Age of the measurement, s.
    pub age: S,
    /// Factor on a velocity from one tick to the next while the sensor is out: the velocity decays at the middle
    /// frequency of the band.
    pub fades: f64,
}

/// A point's motion along an axis.
#[derive(Clone, Debug)]
pub struct Estimate<S> {
    /// The [results](Prediction::results) of the prediction; without one, the measured velocity from the ship's motion, m/s.
    pub results: Vec<S>,
    /// Its position, m.
    pub position: S,
}

/// Numbers of an axis: the contribution of the crane's own motion to a predicted position; the position integrated from
/// each part of the velocity; then the states of both banks.
const BY_CRANE: usize = 0;
const LED_TO: usize = 1;
const BANKS: usize = 3;
/// The parts of a velocity.
const LINEAR: usize = 0;
const ANGULAR: usize = 1;

impl<S: Scalar> Estimator<S> {
    /// Returns the estimator for a lever arm that changes with the motion: it measures the position due to the body's
    /// rotation.
    pub fn with_measured_arms(mut self) -> Self {
        if let Some(prediction) = &mut self.prediction {
            prediction.position.truncate(ANGULAR);
        }
        self
    }

    /// Names of the numbers of an axis.
    pub fn number_names(&self, axis: &str) -> Vec<String> {
        let own = ["by_crane", "led_to_linear", "led_to_angular"].map(str::to_owned);
        let states = |bank| (0..FilterBank::STATES).map(move |state| format!("bank_{bank}_{state}"));
        let banks = ["linear", "angular"].into_iter().flat_map(states).filter(|_| self.prediction.is_some());
        own.into_iter().chain(banks).map(|name| format!("{axis}{name}")).collect()
    }

    /// Returns the number of the numbers of an axis.
    pub fn numbers(&self) -> usize {
        if self.prediction.is_some() { BANKS + 2 * FilterBank::STATES } else { BANKS }
    }

    /// Takes a sample of an axis and returns the estimate; `begins` is true at the first sample.
    pub fn take(&self, measured: &Measured<S>, axis: usize, begins: bool, numbers: &mut [S]) -> Estimate<S> {
        let position = measured.positions[0][axis] + measured.positions[1][axis];
        let Some(prediction) = &self.prediction else {
            // A held velocity would move the load away: without its sensor the compensation commands the position only.
            let velocity = measured.velocities[0][axis] + measured.velocities[1][axis];
            let velocity = if measured.delivers { velocity } else { S::ZERO };
            return Estimate { results: vec![velocity], position };
        };
        let mut results = vec![S::ZERO; prediction.results.len()];
        let ahead = if measured.delivers { prediction.age * measured.velocities[1][axis] } else { S::ZERO };
        let is_measured = prediction.position.len() == ANGULAR;
        let mut predicted = if is_measured { measured.positions[ANGULAR][axis] + ahead } else { numbers[BY_CRANE] };
        for bank in [LINEAR, ANGULAR] {
            let sample = self.corrected(prediction, measured, (bank, axis, begins), numbers);
            let states = &mut numbers[BANKS + bank * FilterBank::STATES..][..FilterBank::STATES];
            prediction.bank.take(states, sample);
            for (result, weights) in results.iter_mut().zip(&prediction.results) {
                *result += FilterBank::read(&weights[bank], states);
            }
            predicted += prediction.position.get(bank).map_or(S::ZERO, |weights| FilterBank::read(weights, states));
        }
        numbers[BY_CRANE] += S::constant(self.period_s) * measured.by_crane[axis];
        let exact = matches!(self.measurement, Measurement::Ideal);
        Estimate { results, position: if exact { position } else { predicted } }
    }

    /// Returns the measured velocity, corrected by the measured position; while the sensor is out, the last one,
    /// decaying.
    fn corrected(
        &self,
        prediction: &Prediction<S>,
        measured: &Measured<S>,
        (bank, axis, begins): (usize, usize, bool),
        numbers: &mut [S],
    ) -> S {
        let last = numbers[BANKS + (bank + 1) * FilterBank::STATES - 1];
        let (half, correction) = (S::constant(0.5 * self.period_s), S::constant(prediction.correction));
        // The crane's own motion also changes the position due to the body's rotation.
        let by_crane = if bank == ANGULAR { measured.by_crane[axis] } else { S::ZERO };
        let velocity =
            if measured.delivers { measured.velocities[bank][axis] } else { last * S::constant(prediction.fades) };
        let led_to = &mut numbers[LED_TO + bank];
        if begins {
            *led_to = measured.positions[bank][axis];
            return velocity;
        }
        *led_to += half * (last + velocity + by_crane + by_crane);
        if !measured.delivers {
            return velocity;
        }
        let pull = correction * (measured.positions[bank][axis] - *led_to);
        *led_to += S::constant(self.period_s) * pull;
        velocity + pull
    }
}

impl<S: Copy> Estimate<S> {
    /// Returns the velocity for a drive; without a prediction it is the same for all drives.
    pub fn velocity_for(&self, drive: usize) -> S {
        self.results.get(drive).copied().unwrap_or(self.results[0])
    }
}

/// Returns the event text if the sensor drops out or returns. The mode `out` holds its last state.
pub(super) fn sensor_changes<S>(delivers: bool, out: usize, own: &mut ElementState<'_, S>) -> Vec<Occurrence> {
    let was_out = core::mem::replace(&mut own.modes[out], i64::from(!delivers)) == 1;
    let event = |code, what: &str| vec![Occurrence { code, what: what.to_owned() }];
    match (was_out, delivers) {
        (false, false) => event("sensor_lost", "continues without its sensor, which has dropped out"),
        (true, true) => event("sensor_found", "uses its sensor again"),
        _ => Vec::new(),
    }
}
