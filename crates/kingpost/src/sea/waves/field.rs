//! The field of linear waves: elevation, pressure, velocity and acceleration of the water.

use super::components::WaveComponent;
use super::water::Water;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// A sum of regular waves with a beginning.
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
    components: Vec<FieldComponent<S>>,
    water: Water,
    ramp_s: f64,
}

/// A component with what is computed once.
#[derive(Clone, Copy, Debug, PartialEq)]
struct FieldComponent<S> {
    wave: WaveComponent<S>,
    /// Cosine and sine of the direction.
    heading: [S; 2],
    /// g k / w, 1/s.
    speed_per_amplitude: S,
}

/// What the water does at a point.
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

impl<S: Scalar> WaveField<S> {
    /// The field of these waves in this water, growing from rest over this time; 0 for waves that are
    /// there at once.
    pub fn new(components: &[WaveComponent<S>], water: Water, ramp_s: f64) -> Self {
        let gravity = S::constant(water.gravity_m_s2);
        let prepare = |&wave: &WaveComponent<S>| {
            let (sin, cos) = wave.direction_rad.sin_cos();
            let speed_per_amplitude = gravity * wave.wave_number_per_m / wave.angular_frequency_rad_s;
            FieldComponent { wave, heading: [cos, sin], speed_per_amplitude }
        };
        Self { components: components.iter().map(prepare).collect(), water, ramp_s }
    }

    /// Still water.
    pub fn calm(water: Water) -> Self {
        Self::new(&[], water, 0.0)
    }

    /// Number of waves.
    pub fn len(&self) -> usize {
        self.components.len()
    }

    /// Whether the water is still.
    pub fn is_empty(&self) -> bool {
        self.components.is_empty()
    }

    /// The waves, in the order of [`Self::phasors`].
    pub fn components(&self) -> impl ExactSizeIterator<Item = &WaveComponent<S>> {
        self.components.iter().map(|component| &component.wave)
    }

    /// The water.
    pub fn water(&self) -> &Water {
        &self.water
    }

    /// What the amplitudes are multiplied by at this time: 0 before 0, 1 after the ramp, and
    /// s^3 (10 - 15 s + 6 s^2) with s = t / ramp between, whose first two derivatives are 0 at both ends.
    pub fn ramp(&self, time_s: f64) -> f64 {
        if time_s >= self.ramp_s {
            return 1.0;
        }
        let s = (time_s / self.ramp_s).max(0.0);
        s * s * s * (10.0 - s * (15.0 - 6.0 * s))
    }

    /// Elevation of the surface, m, at a point (x, y), world, m.
    pub fn elevation_m(&self, [x, y]: [S; 2], time_s: f64) -> S {
        let mut sum = S::ZERO;
        for component in &self.components {
            sum += component.wave.amplitude_m * component.phase([x, y], time_s).sin_cos().1;
        }
        sum * S::constant(self.ramp(time_s))
    }

    /// The complex elevation a e^(i q) of every wave at a point (x, y), world, m, the ramp included, in
    /// the order of [`Self::components`]: a load whose transfer function is X is the sum of
    /// Re{X a e^(i q)}.
    ///
    /// # Panics
    /// When a slice has not the length of the field.
    pub fn phasors(&self, [x, y]: [S; 2], time_s: f64, real: &mut [S], imaginary: &mut [S]) {
        assert_eq!((real.len(), imaginary.len()), (self.len(), self.len()), "one entry a wave");
        let ramp = S::constant(self.ramp(time_s));
        for (component, (real, imaginary)) in self.components.iter().zip(real.iter_mut().zip(imaginary)) {
            let (sin, cos) = component.phase([x, y], time_s).sin_cos();
            let amplitude = component.wave.amplitude_m * ramp;
            (*real, *imaginary) = (amplitude * cos, amplitude * sin);
        }
    }

    /// The linear field at a point, world, m. It is defined up to the still water and down to the
    /// bottom; a point beyond gets the values there, so that short waves do not grow above it.
    pub fn linear_kinematics(&self, point: Vector3<S>, time_s: f64) -> WaveKinematics<S> {
        let [x, y, z] = point.0;
        let (gravity, ramp) = (S::constant(self.water.gravity_m_s2), S::constant(self.ramp(time_s)));
        let mut pressure_head = S::ZERO;
        let mut sum = WaveKinematics::zero();
        for component in &self.components {
            let (sin, cos) = component.phase([x, y], time_s).sin_cos();
            let [c, d] = self.decay(component.wave.wave_number_per_m, z);
            let amplitude = component.wave.amplitude_m * ramp;
            let [forward, left] = component.heading;
            sum.elevation_m += amplitude * cos;
            pressure_head += amplitude * c * cos;
            let speed = amplitude * component.speed_per_amplitude;
            let along = speed * c * cos;
            sum.velocity_m_s += Vector3::new(along * forward, along * left, speed * d * sin);
            let rate = amplitude * gravity * component.wave.wave_number_per_m;
            let along = rate * c * sin;
            sum.acceleration_m_s2 += Vector3::new(along * forward, along * left, -rate * d * cos);
        }
        sum.dynamic_pressure_pa = pressure_head * S::constant(self.water.density_kg_m3) * gravity;
        sum
    }

    /// The field up to the moving surface by Wheeler's stretching: the linear field at
    /// (z - elevation) / (1 + elevation / h), which is 0 at the surface and -h at the bottom (Wheeler,
    /// *Journal of Petroleum Technology* 22, 1970, p. 359; DNV-RP-C205, sec. 3.3). The pressure at the
    /// surface, static and dynamic, is then zero. A point above the surface gets the values there.
    pub fn kinematics(&self, point: Vector3<S>, time_s: f64) -> WaveKinematics<S> {
        let [x, y, z] = point.0;
        let elevation = self.elevation_m([x, y], time_s);
        let below_surface = z - elevation;
        let stretched = match self.water.depth_m {
            Some(depth_m) => below_surface / (S::ONE + elevation / S::constant(depth_m)),
            None => below_surface,
        };
        self.linear_kinematics(Vector3::new(x, y, stretched), time_s)
    }

    /// Pressure above that of the air, Pa, at a point below the moving surface: static, and dynamic by
    /// Wheeler's stretching; zero above the surface.
    pub fn pressure_pa(&self, point: Vector3<S>, time_s: f64) -> S {
        let field = self.kinematics(point, time_s);
        let weight = S::constant(self.water.density_kg_m3 * self.water.gravity_m_s2);
        point[2].select_less(field.elevation_m, || field.dynamic_pressure_pa - weight * point[2], || S::ZERO)
    }

    /// cosh k(z + h) / cosh kh and sinh k(z + h) / cosh kh, both e^kz over infinite depth, written with
    /// exponentials of negative numbers only.
    fn decay(&self, wave_number: S, z: S) -> [S; 2] {
        let above_bottom = |depth_m: f64| S::constant(-depth_m);
        let lowest = above_bottom(self.water.depth_m.unwrap_or(f64::INFINITY));
        let z = z.clipped(lowest, S::ZERO);
        let deep = (wave_number * z).exp();
        let Some(depth_m) = self.water.depth_m else {
            return [deep, deep];
        };
        let double = S::constant(-2.0) * wave_number;
        let from_bottom = (double * (z + S::constant(depth_m))).exp();
        let scale = deep / (S::ONE + (double * S::constant(depth_m)).exp());
        [scale * (S::ONE + from_bottom), scale * (S::ONE - from_bottom)]
    }
}

impl<S: Scalar> FieldComponent<S> {
    /// k x cos b + k y sin b - w t + phase, rad.
    #[inline]
    fn phase(&self, [x, y]: [S; 2], time_s: f64) -> S {
        let along = x * self.heading[0] + y * self.heading[1];
        let turned = self.wave.angular_frequency_rad_s * S::constant(time_s);
        self.wave.wave_number_per_m * along - turned + self.wave.phase_rad
    }
}

impl<S: Scalar> WaveKinematics<S> {
    fn zero() -> Self {
        Self {
            elevation_m: S::ZERO,
            dynamic_pressure_pa: S::ZERO,
            velocity_m_s: Vector3::zero(),
            acceleration_m_s2: Vector3::zero(),
        }
    }
}
