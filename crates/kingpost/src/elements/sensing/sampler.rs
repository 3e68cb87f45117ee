//! Sampling of a sensor's signals: errors, a delay, and hold of the last value during a drop-out.

use super::errors::{DropOuts, SensorNoise, SignalErrors};
use crate::elements::{Context, Crossing, Declaration, Delay, ElementState, EvaluationMode, Event, Output};
use crate::scalar::Scalar;

/// Samples a fixed list of signals. Its numbers are the first of the element's: the outputs, then a ring buffer for
/// each signal. Its modes are also the first: the head of each buffer, then whether the sensor has dropped out.
#[derive(Clone, Debug)]
pub struct Sampler<S = f64> {
    /// Errors of each signal; `None` for a signal without errors.
    pub errors: Vec<Option<SignalErrors<S>>>,
    /// Its drop-outs; without them it always works.
    pub drop_outs: Option<DropOuts>,
    /// Its random numbers.
    pub noise: SensorNoise,
    /// Sampling period, s.
    pub period_s: f64,
    /// Delay of its outputs, in samples.
    pub delay_samples: usize,
}

/// The mode of a sensor that has dropped out.
const OUT: i64 = 1;
/// Index of its events, in the order of [`Sampler::events`], if it can drop out.
const DROPS_OUT: usize = 0;
const WORKS_AGAIN: usize = 1;

impl<S: Scalar> Sampler<S> {
    /// Returns the number of its signals.
    pub fn count(&self) -> usize {
        self.errors.len()
    }

    /// Returns the number of its numbers, after which the element's own begin.
    pub fn numbers(&self) -> usize {
        self.count() * (1 + self.delay_samples)
    }

    /// Returns the number of its modes, after which the element's own begin.
    pub fn modes(&self) -> usize {
        self.status_mode() + usize::from(self.drop_outs.is_some())
    }

    /// Returns the declaration of a sensor with this name, these signals and these outputs; if the sensor can drop out,
    /// its status is the last output.
    pub fn declaration(&self, name: &str, signals: &[&str], outputs: Vec<Output>) -> Declaration {
        Declaration {
            numbers: self.number_names(signals),
            modes: self.mode_names(signals),
            outputs: outputs.into_iter().chain(self.status(name)).collect(),
            events: self.events(),
            goes_alone: self.drop_outs.is_some(),
            period_s: Some(self.period_s),
            delay_samples: self.delay_samples,
            ..Declaration::default()
        }
    }

    /// Returns the names of its numbers, for these names of signals.
    fn number_names(&self, signals: &[&str]) -> Vec<String> {
        let late = |name: &&str| (0..self.delay_samples).map(|tick| format!("{name}_{tick}")).collect::<Vec<_>>();
        signals.iter().map(ToString::to_string).chain(signals.iter().flat_map(late)).collect()
    }

    /// Returns the names of its modes.
    fn mode_names(&self, signals: &[&str]) -> Vec<String> {
        let heads = signals.iter().filter(|_| self.delay_samples > 0).map(|name| format!("{name}_oldest"));
        heads.chain(self.drop_outs.map(|_| "drop_out".to_owned())).collect()
    }

    /// Returns its status as an output, if it can drop out.
    fn status(&self, name: &str) -> Option<Output> {
        let what = "1 while a sensor delivers new samples, 0 while it holds its last sample";
        self.drop_outs.map(|_| Output::number("sensor_status", what, "sensor", name, &["1"]))
    }

    /// Returns its events, if it can drop out: samples cause them, not indicators.
    fn events(&self) -> Vec<Event> {
        let of = |code, what| Event { code, what, crossing: Crossing::Rising };
        self.drop_outs
            .map_or_else(Vec::new, |_| vec![of("drops_out", "drops out"), of("delivers_again", "delivers again")])
    }

    /// Fills the outputs and the buffers at the start with the first values, with bias and noise.
    pub fn begin(&self, own: &mut ElementState<'_, S>, values: &[S]) {
        for (signal, value) in values.iter().enumerate() {
            let value = self.with_errors(signal, *value, 0);
            own.numbers[signal] = value;
            own.numbers[self.count() + signal * self.delay_samples..][..self.delay_samples].fill(value);
        }
    }

    /// Takes one sample: `own.numbers[..count]` become the outputs of the sensor.
    pub fn take(&self, time_s: f64, own: &mut ElementState<'_, S>, values: &[S]) {
        let sample = self.sample_at(time_s);
        let delivers = self.delivers(sample, own);
        for (mode, value) in values.iter().enumerate() {
            let first_number = self.count() + mode * self.delay_samples;
            let ring = Delay { first_number, mode, ticks: self.delay_samples };
            let value = ring.pass(own, self.with_errors(mode, *value, sample));
            if delivers {
                own.numbers[mode] = value;
            }
        }
    }

    /// Whether it works, by its modes.
    pub fn works(&self, modes: &[i64]) -> bool {
        self.drop_outs.is_none() || modes[self.status_mode()] != OUT
    }

    /// Appends its outputs, exact values in a [mode](EvaluationMode::Unsampled) without sampling; then its status if it
    /// can drop out.
    pub fn outputs<Exact: AsRef<[S]>>(&self, at: &Context<'_, S>, out: &mut Vec<S>, exact: impl FnOnce() -> Exact) {
        let count = self.count();
        if at.evaluation == EvaluationMode::Unsampled {
            out.extend_from_slice(&exact().as_ref()[..count]);
        } else {
            out.extend_from_slice(&at.numbers[..count]);
        }
        let status = if self.works(at.modes) { S::ONE } else { S::ZERO };
        out.extend(self.drop_outs.map(|_| status));
    }

    fn status_mode(&self) -> usize {
        if self.delay_samples > 0 { self.count() } else { 0 }
    }

    /// Returns a signal with its errors at a time, before its delay.
    pub fn now(&self, time_s: f64, signal: usize, value: S) -> S {
        self.with_errors(signal, value, self.sample_at(time_s))
    }

    /// Returns the number of the sample at a time.
    pub fn sample_at(&self, time_s: f64) -> u64 {
        libm::round(time_s / self.period_s) as u64
    }

    fn with_errors(&self, signal: usize, value: S, sample: u64) -> S {
        self.errors[signal].map_or(value, |errors| errors.on(value, &self.noise, signal, sample))
    }

    /// Determines whether it works at this sample, and records a change.
    fn delivers(&self, sample: u64, own: &mut ElementState<'_, S>) -> bool {
        let Some(DropOuts { mean_interval_s, mean_duration_s }) = self.drop_outs else { return true };
        let (mode, drawn) = (self.status_mode(), self.noise.uniform(sample));
        let was_out = own.modes[mode] == OUT;
        let mean_s = if was_out { mean_duration_s } else { mean_interval_s };
        if drawn < self.period_s / mean_s {
            own.modes[mode] = if was_out { 0 } else { OUT };
            own.also = Some(if was_out { WORKS_AGAIN } else { DROPS_OUT });
        }
        own.modes[mode] != OUT
    }
}
