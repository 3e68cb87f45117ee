//! The incident waves at one point, as rotating phasors.

use crate::scalar::Scalar;
use crate::sea::waves::WaveComponent;

/// Stages of a step whose rotations are kept.
const KEPT: usize = 4;

/// `a e^(i (k.x - w t + epsilon))` of every component at a point that is constant over a step.
///
/// Sines and cosines are taken once a step; within it each phasor turns by `e^(-i w tau)`, which is
/// the same every step and kept. What a phasor is depends on the time, the step's begin and the
/// point only: what is kept changes no bit.
#[derive(Clone, Debug)]
pub struct Phasors<S = f64> {
    waves: Vec<Wave<S>>,
    /// Step's begin and the point that `base` is for.
    key: Option<(f64, [S; 2])>,
    base: Vec<[S; 2]>,
    rotations: [Rotation; KEPT],
    next: usize,
}

/// A component as it is at the world's origin at time 0. Its frequency, direction and phase are no
/// scalars: a sea has one realisation.
#[derive(Clone, Copy, Debug)]
struct Wave<S> {
    amplitude_m: S,
    omega_rad_s: f64,
    wave_vector_per_m: [f64; 2],
    phase_rad: f64,
}

impl<S: Scalar> Wave<S> {
    fn of(component: &WaveComponent<S>) -> Self {
        let (sin, cos) = libm::sincos(component.direction_rad.value());
        let k = component.wave_number_per_m.value();
        Self {
            amplitude_m: component.amplitude_m,
            omega_rad_s: component.angular_frequency_rad_s.value(),
            wave_vector_per_m: [k * cos, k * sin],
            phase_rad: component.phase_rad.value(),
        }
    }
}

/// `e^(-i w tau)` of every component.
#[derive(Clone, Debug)]
struct Rotation {
    tau_s: f64,
    turns: Vec<[f64; 2]>,
}

impl<S: Scalar> Phasors<S> {
    /// For these waves.
    pub fn new<'a>(waves: impl Iterator<Item = &'a WaveComponent<S>>) -> Self {
        let waves: Vec<Wave<S>> = waves.map(Wave::of).collect();
        let none = Rotation { tau_s: f64::NAN, turns: vec![[0.0; 2]; waves.len()] };
        let base = vec![[S::ZERO; 2]; waves.len()];
        Self { waves, key: None, base, rotations: core::array::from_fn(|_| none.clone()), next: 0 }
    }

    /// Calls `each` with every component's index and phasor at a time of the step that begins at
    /// `start_s`, at a point of the water plane (m, world).
    pub fn at(&mut self, start_s: f64, time_s: f64, position: [S; 2], mut each: impl FnMut(usize, [S; 2])) {
        if self.key != Some((start_s, position)) {
            self.begin(start_s, position);
        }
        let turns = &self.rotations[self.rotation(time_s - start_s)].turns;
        for (i, (base, turn)) in self.base.iter().zip(turns).enumerate() {
            let [cos, sin] = turn.map(S::constant);
            each(i, [base[0] * cos - base[1] * sin, base[0] * sin + base[1] * cos]);
        }
    }

    fn begin(&mut self, start_s: f64, position: [S; 2]) {
        for (wave, base) in self.waves.iter().zip(&mut self.base) {
            let [kx, ky] = wave.wave_vector_per_m.map(S::constant);
            let phase = kx * position[0] + ky * position[1];
            let (sin, cos) = (phase + S::constant(wave.phase_rad - wave.omega_rad_s * start_s)).sin_cos();
            *base = [wave.amplitude_m * cos, wave.amplitude_m * sin];
        }
        self.key = Some((start_s, position));
    }

    /// Index of the rotation by a time, computed where it is not kept.
    fn rotation(&mut self, tau_s: f64) -> usize {
        if let Some(kept) = self.rotations.iter().position(|rotation| rotation.tau_s == tau_s) {
            return kept;
        }
        let place = self.next;
        self.next = (place + 1) % KEPT;
        let rotation = &mut self.rotations[place];
        rotation.tau_s = tau_s;
        for (wave, turn) in self.waves.iter().zip(&mut rotation.turns) {
            let (sin, cos) = libm::sincos(-wave.omega_rad_s * tau_s);
            *turn = [cos, sin];
        }
        place
    }
}
