//! Field of linear waves: elevation, pressure, velocity and acceleration of the water.

use core::f64::consts::TAU;

use super::components::WaveComponent;
use super::ramp::ramp;
use super::stretching::{StretchedHeight, Stretching};
use super::water::Water;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A sum of regular waves that starts from rest.
///
/// Linear theory over a level bottom (Newman, *Marine Hydrodynamics*, 1977, ch. 6; Faltinsen, *Sea Loads
/// on Ships and Offshore Structures*, 1990, table 2.1). With the phase of a component
/// q = k x cos b + k y sin b - w t + phase, and C and D the decay with depth,
///
/// ```text
/// elevation            a cos q
/// dynamic pressure     rho g a C cos q               C = cosh k(z + h) / cosh kh, deep: e^kz
/// velocity along b     a (g k / w) C cos q           D = sinh k(z + h) / cosh kh, deep: e^kz
/// velocity upward      a (g k / w) D sin q
/// acceleration         the velocity's derivative with respect to t at a fixed point
/// ```
///
/// All of them are multiplied by [`WaveField::ramp`], whose own rate is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct WaveField<S = f64> {
    waves: Vec<WaveComponent<S>>,
    water: Water,
    ramp_s: f64,
    stretching: Stretching,
    pub(super) amplitudes_m: Vec<S>,
    /// Sum of the amplitudes: no crest is higher and no trough is deeper, m.
    pub(super) highest_m: S,
    pub(super) turns: PhaseTurns<S>,
    /// k of each wave, 1/m.
    pub(super) wave_numbers_per_m: Vec<S>,
    /// The least k of each block of waves, 1/m.
    pub(super) least_wave_numbers_per_m: Vec<S>,
    /// Period of each wave, s.
    pub(super) periods_s: Vec<S>,
    /// 1 / (1 + e^-2kh) of each wave.
    pub(super) bottom_scales: Vec<S>,
    /// Number of times that the waves have been replaced.
    realisation: u64,
}

/// Coefficients of the waves' phases, in turns of 2 pi rad, in one array for each coefficient, so that a loop
/// over the waves becomes SIMD code.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PhaseTurns<S> {
    pub(super) x_per_m: Vec<S>,
    pub(super) y_per_m: Vec<S>,
    pub(super) time_per_s: Vec<S>,
    pub(super) phase: Vec<S>,
}

/// Motion and pressure of the water at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaveKinematics<S = f64> {
    /// Elevation of the surface above the point, m.
    pub elevation_m: S,
    /// Pressure above that of still water, Pa.
    pub dynamic_pressure_pa: S,
    /// Velocity of the water, world, m/s.
    pub velocity_m_s: Vector3<S>,
    /// Local acceleration of the water, world, m/s^2.
    pub acceleration_m_s2: Vector3<S>,
}

/// Returns the least wave number of some waves, 1/m.
fn least_wave_number<S: Scalar>(waves: &[WaveComponent<S>]) -> S {
    let first = waves[0].wave_number_per_m;
    waves
        .iter()
        .fold(first, |least, wave| wave.wave_number_per_m.select_less(least, || wave.wave_number_per_m, || least))
}

/// Number of waves whose sines are computed together.
pub(super) const BLOCK: usize = 16;

impl<S: Scalar> WaveField<S> {
    /// Creates the field of these waves in this water, with amplitudes that grow from 0 over the ramp time;
    /// with 0 s the waves have their full amplitudes from the start.
    pub fn new(waves: &[WaveComponent<S>], water: Water, ramp_s: f64) -> Self {
        let turn = S::constant(1.0 / TAU);
        let of_each = |f: &dyn Fn(&WaveComponent<S>) -> S| waves.iter().map(f).collect::<Vec<S>>();
        let turns = PhaseTurns {
            x_per_m: of_each(&|wave| wave.wave_number_per_m * wave.direction_rad.sin_cos().1 * turn),
            y_per_m: of_each(&|wave| wave.wave_number_per_m * wave.direction_rad.sin_cos().0 * turn),
            time_per_s: of_each(&|wave| wave.angular_frequency_rad_s * turn),
            phase: of_each(&|wave| wave.phase_rad * turn),
        };
        let double_depth = S::constant(-2.0 * water.depth_m.unwrap_or(0.0));
        let bottom_scales = of_each(&|wave| S::ONE / (S::ONE + (double_depth * wave.wave_number_per_m).exp()));
        let amplitudes_m = of_each(&|wave| wave.amplitude_m);
        Self {
            waves: waves.to_vec(),
            water,
            ramp_s,
            stretching: Stretching::default(),
            highest_m: sum_of_sizes(&amplitudes_m),
            amplitudes_m,
            turns,
            wave_numbers_per_m: of_each(&|wave| wave.wave_number_per_m),
            least_wave_numbers_per_m: waves.chunks(BLOCK).map(least_wave_number).collect(),
            periods_s: of_each(&|wave| S::constant(TAU) / wave.angular_frequency_rad_s),
            bottom_scales,
            realisation: 0,
        }
    }

    /// Returns the field of the same waves with this stretching.
    pub fn with_stretching(self, stretching: Stretching) -> Self {
        Self { stretching, ..self }
    }

    /// Returns the stretching: the method by which kinematics continue to the moving surface.
    pub fn stretching(&self) -> Stretching {
        self.stretching
    }

    /// Replaces amplitude, m, and phase, rad, of each wave; frequencies and directions stay.
    ///
    /// # Panics
    /// If a slice does not have one entry per wave.
    pub fn set_realisation(&mut self, amplitudes_m: &[S], phases_rad: &[S]) {
        assert_eq!((amplitudes_m.len(), phases_rad.len()), (self.len(), self.len()), "one entry a wave");
        for (wave, (amplitude, phase)) in self.waves.iter_mut().zip(amplitudes_m.iter().zip(phases_rad)) {
            (wave.amplitude_m, wave.phase_rad) = (*amplitude, *phase);
        }
        self.amplitudes_m.copy_from_slice(amplitudes_m);
        self.highest_m = sum_of_sizes(amplitudes_m);
        let turns = phases_rad.iter().map(|phase| *phase * S::constant(1.0 / TAU));
        self.turns.phase.iter_mut().zip(turns).for_each(|(to, turns)| *to = turns);
        self.realisation += 1;
    }

    /// Returns how many times the waves have been replaced: values computed from the waves are valid for one
    /// of these numbers.
    pub fn realisation(&self) -> u64 {
        self.realisation
    }

    /// Returns still water.
    pub fn calm(water: Water) -> Self {
        Self::new(&[], water, 0.0)
    }

    /// Returns the number of waves.
    pub fn len(&self) -> usize {
        self.waves.len()
    }

    /// Returns whether the water is still.
    pub fn is_empty(&self) -> bool {
        self.waves.is_empty()
    }

    /// Returns the frequency below which this share of the variance of the elevation lies, rad/s; `None` without waves.
    ///
    /// ```
    /// use kingpost::sea::waves::{Water, WaveComponent, WaveField};
    /// let water = Water::default();
    /// let waves = [0.5, 1.0].map(|omega| WaveComponent::in_water(&water, 1.0, omega, 0.0, 0.0));
    /// let field = WaveField::new(&waves, water, 0.0);
    /// assert_eq!((field.frequency_at(0.4), field.frequency_at(0.6)), (Some(0.5), Some(1.0)));
    /// ```
    pub fn frequency_at(&self, share: f64) -> Option<f64> {
        let plain = |wave: &WaveComponent<S>| (wave.angular_frequency_rad_s.value(), wave.amplitude_m.value());
        let mut waves: Vec<(f64, f64)> = self.waves.iter().map(plain).collect();
        waves.sort_by(|one, other| one.0.total_cmp(&other.0));
        let total: f64 = waves.iter().map(|(_, amplitude)| amplitude * amplitude).sum();
        let mut sum = 0.0;
        let reaches = |&&(_, amplitude): &&(f64, f64)| {
            sum += amplitude * amplitude;
            sum >= share * total
        };
        waves.iter().find(reaches).map(|(frequency, _)| *frequency).filter(|_| total > 0.0)
    }

    /// Returns the waves, in the order of [`Self::phasors`].
    pub fn components(&self) -> impl ExactSizeIterator<Item = &WaveComponent<S>> {
        self.waves.iter()
    }

    /// Returns the water.
    pub fn water(&self) -> &Water {
        &self.water
    }

    /// Returns the factor of the amplitudes at this time: [`ramp`].
    pub fn ramp(&self, time_s: f64) -> f64 {
        let [share, ..] = self.ramp_and_rates(time_s);
        share
    }

    /// Returns the factor of the amplitudes at this time, with its first and second rate.
    pub fn ramp_and_rates(&self, time_s: f64) -> [f64; 3] {
        ramp(time_s, self.ramp_s)
    }

    /// Returns the elevation of the surface, m, at a point (x, y), world, m.
    pub fn elevation_m(&self, point: [S; 2], time_s: f64) -> S {
        let (mut sum, mut real, mut imaginary) = (S::ZERO, [S::ZERO; BLOCK], [S::ZERO; BLOCK]);
        for first in (0..self.waves.len()).step_by(BLOCK) {
            let count = BLOCK.min(self.waves.len() - first);
            self.unit_phasors(first, point, time_s, &mut real[..count], &mut imaginary[..count]);
            for (amplitude, cos) in self.amplitudes_m[first..].iter().zip(&real[..count]) {
                sum += *amplitude * *cos;
            }
        }
        sum * S::constant(self.ramp(time_s))
    }

    /// Writes the complex elevation a e^(i q) of every wave at a point (x, y), world, m, with the ramp
    /// applied, in the order of [`Self::components`]: a load with the transfer function X is the sum of Re{X
    /// a e^(i q)}.
    ///
    /// # Panics
    /// If a slice does not have one entry per wave.
    pub fn phasors(&self, point: [S; 2], time_s: f64, real: &mut [S], imaginary: &mut [S]) {
        assert_eq!((real.len(), imaginary.len()), (self.waves.len(), self.waves.len()), "one entry a wave");
        self.unit_phasors(0, point, time_s, real, imaginary);
        let ramp = S::constant(self.ramp(time_s));
        for ((real, imaginary), amplitude) in real.iter_mut().zip(imaginary).zip(&self.amplitudes_m) {
            let amplitude = *amplitude * ramp;
            *real = *real * amplitude;
            *imaginary = *imaginary * amplitude;
        }
    }

    /// Writes e^(i q) of as many waves as the slices are long, from the wave `first` on.
    pub(super) fn unit_phasors(&self, first: usize, [x, y]: [S; 2], time_s: f64, real: &mut [S], imaginary: &mut [S]) {
        let (time, count) = (S::constant(time_s), real.len());
        let range = first..first + count;
        let (kx, ky) = (&self.turns.x_per_m[range.clone()], &self.turns.y_per_m[range.clone()]);
        let (f, phase) = (&self.turns.time_per_s[range.clone()], &self.turns.phase[range]);
        let imaginary = &mut imaginary[..count];
        for i in 0..count {
            let turns = kx[i] * x + ky[i] * y - f[i] * time + phase[i];
            (imaginary[i], real[i]) = turns.sin_cos_of_turns();
        }
    }

    /// Returns the linear field at a point, world, m. The field is defined from the bottom to the still water
    /// level; a point outside this range gets the values at its end, so that short waves do not grow above
    /// the level.
    pub fn linear_kinematics(&self, point: Vector3<S>, time_s: f64) -> WaveKinematics<S> {
        let [x, y, z] = point.0;
        self.kinematics_at([x, y], Stretching::Vertical.height(z, S::ZERO, self.water.depth_m), time_s)
    }

    /// Returns the linear field over (x, y), continued from its height in still water.
    fn kinematics_at(&self, [x, y]: [S; 2], height: StretchedHeight<S>, time_s: f64) -> WaveKinematics<S> {
        let (mut real, mut imaginary) = ([S::ZERO; BLOCK], [S::ZERO; BLOCK]);
        let (mut elevation, mut head) = (S::ZERO, S::ZERO);
        let (mut velocity, mut acceleration) = (Vector3::zero(), Vector3::zero());
        for (block, waves) in self.waves.chunks(BLOCK).enumerate() {
            let first = BLOCK * block;
            self.unit_phasors(first, [x, y], time_s, &mut real[..waves.len()], &mut imaginary[..waves.len()]);
            for (i, wave) in waves.iter().enumerate() {
                let (a, cos, sin) = (wave.amplitude_m, real[i], imaginary[i]);
                let [kx, ky] = self.wave_vector(first + i);
                let [c, d] = self.decay(first + i, height);
                let upward = wave.wave_number_per_m * d;
                elevation += a * cos;
                head += a * c * cos;
                velocity += Vector3::new(kx * c * cos, ky * c * cos, upward * sin) * (a / wave.angular_frequency_rad_s);
                acceleration += Vector3::new(kx * c * sin, ky * c * sin, -upward * cos) * a;
            }
        }
        let ramp = S::constant(self.ramp(time_s));
        let gravity = S::constant(self.water.gravity_m_s2) * ramp;
        WaveKinematics {
            elevation_m: elevation * ramp,
            dynamic_pressure_pa: head * gravity * S::constant(self.water.density_kg_m3),
            velocity_m_s: velocity * gravity,
            acceleration_m_s2: acceleration * gravity,
        }
    }

    /// Returns k (cos b, sin b) of a wave, 1/m.
    fn wave_vector(&self, i: usize) -> [S; 2] {
        let turn = S::constant(TAU);
        [turn * self.turns.x_per_m[i], turn * self.turns.y_per_m[i]]
    }

    /// Returns the field up to the moving surface, by the field's [`Stretching`]. A point above the surface
    /// gets the values at the surface, or zero, depending on the stretching.
    pub fn kinematics(&self, point: Vector3<S>, time_s: f64) -> WaveKinematics<S> {
        let ([x, y, z], stretching) = (point.0, self.stretching);
        let elevation = self.elevation_m([x, y], time_s);
        let at = self.kinematics_at([x, y], self.height(z, elevation), time_s);
        let moving = |vector: Vector3<S>| Vector3(vector.0.map(|x| stretching.moving(z, x)));
        WaveKinematics {
            elevation_m: elevation,
            dynamic_pressure_pa: stretching.pressure(z, self.specific_weight(), at.dynamic_pressure_pa),
            velocity_m_s: moving(at.velocity_m_s),
            acceleration_m_s2: moving(at.acceleration_m_s2),
        }
    }

    /// Returns the dynamic pressure of [`Self::kinematics`] alone, Pa, if the elevation over the point is
    /// known.
    pub fn dynamic_pressure_pa(&self, point: Vector3<S>, elevation_m: S, time_s: f64) -> S {
        let [x, y, z] = point.0;
        let height = self.height(z, elevation_m);
        let (mut head, mut real, mut imaginary) = (S::ZERO, [S::ZERO; BLOCK], [S::ZERO; BLOCK]);
        for (block, waves) in self.waves.chunks(BLOCK).enumerate() {
            let first = BLOCK * block;
            self.unit_phasors(first, [x, y], time_s, &mut real[..waves.len()], &mut imaginary[..waves.len()]);
            for (i, wave) in waves.iter().enumerate() {
                head += wave.amplitude_m * self.decay(first + i, height)[0] * real[i];
            }
        }
        let gravity = S::constant(self.water.gravity_m_s2) * S::constant(self.ramp(time_s));
        let pressure = head * gravity * S::constant(self.water.density_kg_m3);
        self.stretching.pressure(z, self.specific_weight(), pressure)
    }

    /// Returns the pressure above atmospheric, Pa, at a point: static and dynamic; zero above the moving
    /// surface.
    pub fn pressure_pa(&self, point: Vector3<S>, time_s: f64) -> S {
        let elevation = self.elevation_m([point[0], point[1]], time_s);
        let below = || self.dynamic_pressure_pa(point, elevation, time_s) - self.specific_weight() * point[2];
        point[2].select_less(elevation, below, || S::ZERO)
    }

    fn specific_weight(&self) -> S {
        S::constant(self.water.density_kg_m3 * self.water.gravity_m_s2)
    }

    /// Returns the height in still water whose field applies at the height z, m, for this elevation, m.
    pub(super) fn height(&self, z: S, elevation: S) -> StretchedHeight<S> {
        self.stretching.height(z, elevation, self.water.depth_m)
    }

    /// Returns cosh k(z + h) / cosh kh and sinh k(z + h) / cosh kh of a wave, both e^kz in infinite depth, by
    /// exponentials of negative numbers only: (e^kz +- e^-k(z + 2h)) / (1 + e^-2kh). Above the still water
    /// level each continues along its tangent, which is k times the other.
    fn decay(&self, i: usize, StretchedHeight { z, rise }: StretchedHeight<S>) -> [S; 2] {
        let k = self.waves[i].wave_number_per_m;
        let (down, further) = ((k * z).exp(), k * rise);
        let Some(depth_m) = self.water.depth_m else { return [down + down * further; 2] };
        let up = (-k * (z + S::constant(2.0 * depth_m))).exp();
        let [level, upward] = [down + up, down - up].map(|sum| self.bottom_scales[i] * sum);
        [level + further * upward, upward + further * level]
    }
}

fn sum_of_sizes<S: Scalar>(amplitudes_m: &[S]) -> S {
    amplitudes_m.iter().fold(S::ZERO, |sum, amplitude| sum + amplitude.select_below(0.0, || -*amplitude, || *amplitude))
}
