//! The times at which rows are recorded.

use super::Settings;

/// Recording times of a run, counted in steps.
#[derive(Clone, Debug)]
pub(crate) struct Recording {
    settings: Settings,
    /// Number of the last step of the run.
    last: u64,
    /// Number of recording times that have passed.
    passed: f64,
}

/// Rounding error of a quotient of two times, in steps: its value for a run of 1e7 steps.
const ROUNDING: f64 = 1e-9;

impl Recording {
    /// Creates the recording times of a run from this time; its row is already recorded.
    pub(crate) fn new(settings: Settings, time_s: f64) -> Self {
        let last = libm::ceil(settings.duration_s / settings.step_s - ROUNDING) as u64;
        let mut recording = Self { settings, last, passed: 0.0 };
        recording.passed = recording.passed_at(time_s);
        recording
    }

    fn passed_at(&self, time_s: f64) -> f64 {
        libm::floor(time_s / self.settings.record_every_s + ROUNDING)
    }

    /// Returns whether a run is at its end after this number of steps.
    pub(crate) fn is_over(&self, steps: u64) -> bool {
        steps >= self.last
    }

    /// Returns the step, after `steps`, at which the next row is due: at a recording time or at the end.
    pub(crate) fn due(&self, steps: u64) -> u64 {
        let Settings { record_every_s, step_s, .. } = self.settings;
        let due = libm::ceil((self.passed + 1.0) * record_every_s / step_s - ROUNDING) as u64;
        due.clamp(steps + 1, self.last)
    }

    /// Notes that the row at this time is recorded.
    pub(crate) fn written(&mut self, time_s: f64) {
        self.passed = self.passed_at(time_s).max(self.passed + 1.0);
    }
}
