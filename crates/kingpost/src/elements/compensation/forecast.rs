//! A forecast of the heave of a point.

use super::estimate::{Estimator, sensor_changes};
use super::lever::{NEXT_TICK, SENSOR_OUT, modes};
use crate::dynamics::Loads;
use crate::elements::ticks::{Due, due};
use crate::elements::{Context, Declaration, Delay, Element, ElementState, Occurrence, Output, significant};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Predicts the heave h of a point at lead times tau_k up to a horizon, from the motion that a unit measures. Each h(t + tau_k) is
/// a result of the [`FilterBank`](super::FilterBank), whose weights approximate `e^(i w tau_k) / (i w)` in the band.
///
/// The error of a forecast is what it differed by so far: at some leads the forecasts are kept, and compared with the heave at
/// their time. Between these leads the standard deviation e is interpolated, from 0 at no lead. The bound
///
/// ```text
/// max over k of |h(t + tau_k)| + m e(tau_k),    m = margin
/// ```
///
/// is small only in a lull that can be foreseen: as tau_k exceeds what the past tells, h fades to 0 and e becomes the standard
/// deviation of the heave.
#[derive(Clone, Debug)]
pub struct HeaveForecast<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Estimator of the heave; its [results](super::Prediction::results) are the h(t + tau_k), the first at no lead.
    pub estimator: Estimator<S>,
    /// The point.
    pub point: Attachment<S>,
    /// tau_k, s, rising from 0.
    pub leads_s: Vec<f64>,
    /// Indices of the leads whose errors are measured, and each lead in samples. The last is the horizon.
    pub scored: [(usize, usize); SCORED],
    /// m.
    pub margin: S,
    /// Samples that its filters need to settle, and samples after which it is ready.
    pub settles: [i64; 2],
    /// Share of the variance of the heave, with the spectrum of its filters, that its error has at the horizon.
    pub error_share: f64,
}

/// Number of leads whose errors are measured.
pub const SCORED: usize = 4;
/// Shares of the variance above which the forecast of the horizon is of little use.
const LITTLE_USE: f64 = 0.5;
/// Numbers: the outputs; mean squares of the errors; then the kept forecasts, and those of the estimator.
const HEAVE: usize = 0;
const ERROR: usize = 1;
const BOUND: usize = 2;
const SQUARES: usize = 3;
const KEPT: usize = SQUARES + SCORED;
/// Modes after those of a compensation: samples taken; then the oldest kept forecast of each scored lead.
const TAKEN: usize = 2;
const HEADS: usize = 3;
/// z of the world.
const UPWARD: usize = 2;

impl<S: Scalar> Element<S> for HeaveForecast<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number =
            |variable, description, unit| Output::number(variable, description, "controller", &self.name, unit);
        let squares = (0..SCORED).map(|k| format!("mean_square_{k}"));
        let kept = (0..self.kept()).map(|k| format!("kept_{k}"));
        let own = ["heave", "error", "bound"].into_iter().map(str::to_owned).chain(squares).chain(kept);
        let heads = (0..SCORED).map(|k| format!("oldest_{k}"));
        Declaration {
            numbers: own.chain(self.estimator.number_names("")).collect(),
            modes: modes().into_iter().chain(["taken".to_owned()]).chain(heads).collect(),
            outputs: vec![
                number("predicted_heave", "largest heave that a forecast predicts up to its horizon", &["m"]),
                number(
                    "predicted_heave_error",
                    "standard deviation of the error of a forecast of the heave at its horizon, as measured so far",
                    &["m"],
                ),
                number(
                    "predicted_heave_bound",
                    "largest heave up to the horizon of a forecast, with its margin of standard deviations of the error",
                    &["m"],
                ),
                number(
                    "forecast_ready",
                    "1 once a forecast has settled and has measured its error, 0 before and while its sensor is out",
                    &["1"],
                ),
            ],
            reads: self.estimator.measurement.columns(),
            ..Declaration::default()
        }
    }

    fn update_controls(
        &mut self,
        at: &Context<'_, S>,
        read: &[S],
        own: &mut ElementState<'_, S>,
        _inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        let due = due(at.clock.time_s, self.estimator.period_s, &mut own.modes[NEXT_TICK]);
        let Some(Due { is_first, .. }) = due else { return Ok(Vec::new()) };
        let measured = self.estimator.measurement.measure(at, &self.point, Vector3::zero(), read);
        let happened = sensor_changes(measured.delivers, SENSOR_OUT, own);
        let first = KEPT + self.kept();
        let found = self.estimator.take(&measured, UPWARD, is_first, &mut own.numbers[first..]);
        own.modes[TAKEN] = if measured.delivers { own.modes[TAKEN] + 1 } else { 0 };
        self.score(&found.results, own);
        self.foresee(&found.results, own);
        Ok(happened)
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let ready = at.modes[TAKEN] >= self.settles[1];
        out.extend([HEAVE, ERROR, BOUND].map(|number| at.numbers[number]));
        out.push(if ready { S::ONE } else { S::ZERO });
    }

    fn left_out(&mut self, _at: &Context<'_, S>, _loads: &Loads<S>) -> Option<String> {
        let horizon_s = self.leads_s.last()?;
        (self.error_share > LITTLE_USE).then(|| {
            format!(
                "foresees little: {} s ahead its error has {} % of the standard deviation of the heave that its periods describe; \
                 peak_period_s or a nearer horizon_s lowers it",
                significant(*horizon_s, 3),
                significant(100.0 * libm::sqrt(self.error_share), 2)
            )
        })
    }
}

impl<S: Scalar> HeaveForecast<S> {
    /// Returns the number of forecasts that it keeps.
    fn kept(&self) -> usize {
        self.scored.iter().map(|(_, samples)| samples).sum()
    }

    /// Compares the forecasts kept for this sample with its heave, and keeps new ones. Their mean squares are those of all samples
    /// since it has settled.
    fn score(&self, heave: &[S], own: &mut ElementState<'_, S>) {
        let mut first_number = KEPT;
        for (k, (lead, samples)) in self.scored.into_iter().enumerate() {
            let ring = Delay { first_number, mode: HEADS + k, ticks: samples };
            first_number += samples;
            let miss = ring.pass(own, heave[lead]) - heave[0];
            let compared = own.modes[TAKEN] - self.settles[0] - samples as i64;
            if compared > 0 {
                let square = &mut own.numbers[SQUARES + k];
                *square += (miss * miss - *square) * S::constant(1.0 / compared as f64);
            }
        }
    }

    /// Sets the outputs.
    fn foresee(&self, heave: &[S], own: &mut ElementState<'_, S>) {
        let numbers = &mut *own.numbers;
        // The root of 0 has no derivative.
        let deviations = [0, 1, 2, 3].map(|k| (numbers[SQUARES + k] + S::constant(f64::MIN_POSITIVE)).sqrt());
        let larger = |a: S, b: S| a.select_less(b, || b, || a);
        let (mut most, mut bound) = (S::ZERO, S::ZERO);
        for (lead, heave) in heave.iter().enumerate() {
            let size = heave.select_below(0.0, || -*heave, || *heave);
            most = larger(most, size);
            bound = larger(bound, size + self.margin * self.deviation(lead, &deviations));
        }
        numbers[HEAVE] = most;
        numbers[ERROR] = deviations[SCORED - 1];
        numbers[BOUND] = bound;
    }

    /// Returns the standard deviation of the error at a lead, interpolated.
    fn deviation(&self, lead: usize, at_scored: &[S; SCORED]) -> S {
        let after = self.scored.iter().position(|(scored, _)| *scored >= lead).unwrap_or(SCORED - 1);
        let (from_s, from) = match after.checked_sub(1) {
            Some(before) => (self.leads_s[self.scored[before].0], at_scored[before]),
            None => (0.0, S::ZERO),
        };
        let to_s = self.leads_s[self.scored[after].0];
        from + (at_scored[after] - from) * S::constant((self.leads_s[lead] - from_s) / (to_s - from_s))
    }
}
