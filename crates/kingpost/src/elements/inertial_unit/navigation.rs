//! Strapdown navigation: the estimate of an inertial unit's motion, and its correction by innovations.

use super::gains::{Design, KalmanGains};
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3, exp, log_of_part_turn, roll_pitch_yaw};

/// Measurements of accelerometers and gyroscopes over a sample: mean values, body axes.
#[derive(Clone, Copy, Debug)]
pub struct Increments<S> {
    /// Acceleration less that of gravity, m/s^2.
    pub specific_force: Vector3<S>,
    /// Angular velocity, rad/s.
    pub rate: Vector3<S>,
}

/// A body's attitude and the velocity of a point of it, world axes.
#[derive(Clone, Copy, Debug)]
pub struct Moving<S> {
    /// From body axes to those of the world.
    pub rotation: Matrix3<S>,
    /// m/s.
    pub velocity: Vector3<S>,
}

impl<S: Scalar> Moving<S> {
    /// Returns the exact increments from an earlier motion to this one, over a time T:
    ///
    /// ```text
    /// omega = log(R_0^T R_1) / T,    f = exp(-omega T / 2) R_0^T ((v_1 - v_0) / T + g z)
    /// ```
    ///
    /// like those that a unit outputs after its internal integration at a high rate (Savage, "Strapdown inertial
    /// navigation integration algorithm design", *J. Guidance, Control, and Dynamics* 21(1), 1998, p. 19; (2), p. 208).
    pub fn since(&self, before: &Self, gravity: S, period_s: f64) -> Increments<S> {
        let per_period = S::constant(1.0 / period_s);
        let turn = log_of_part_turn(&(before.rotation.transpose() * self.rotation));
        let middle = before.rotation * exp(turn * S::constant(0.5));
        let acceleration = (self.velocity - before.velocity) * per_period;
        let specific_force = middle.transpose_times(acceleration + Vector3([S::ZERO, S::ZERO, gravity]));
        Increments { specific_force, rate: turn * per_period }
    }
}

/// Estimate of the unit's motion and of the errors of its sensors.
#[derive(Clone, Copy, Debug)]
pub struct Navigation<S> {
    /// Attitude and velocity.
    pub moving: Moving<S>,
    /// Displacement from the mean position, world axes, m.
    pub displacement: Vector3<S>,
    /// Error of the accelerometers along the vertical, m/s^2.
    pub acceleration_error: S,
    /// Errors of the gyroscopes, body axes, rad/s.
    pub rate_errors: Vector3<S>,
    /// States of the motion in waves along each axis of the world: its integral (m s) and the motion (m).
    pub waves: [[S; 2]; 3],
}

/// Number of stored numbers of an estimate, and of a motion.
pub const NUMBERS: usize = 25;
pub const OF_MOVING: usize = 12;

impl<S: Scalar> Navigation<S> {
    /// Returns the estimate after a long time at rest, for the attitude and velocity `truth`. At rest the gyroscopes
    /// measure only their errors. The vertical error of the accelerometers is estimated; their horizontal error tilts
    /// the estimated horizon by this error over g.
    pub fn settled(truth: Moving<S>, at_rest: &Increments<S>, gravity: S) -> Self {
        let seen = truth.rotation * at_rest.specific_force;
        let size = seen.norm();
        let per_size = size.select_below(f64::MIN_POSITIVE, || S::ZERO, || S::ONE / size);
        let tilt = seen.cross(Vector3([S::ZERO, S::ZERO, S::ONE])) * per_size;
        Self {
            acceleration_error: size - gravity,
            rate_errors: at_rest.rate,
            ..Self::without_errors(Moving { rotation: exp(tilt) * truth.rotation, ..truth })
        }
    }

    /// Returns the estimate of a unit without errors at its mean position.
    pub fn without_errors(moving: Moving<S>) -> Self {
        Self {
            moving,
            displacement: Vector3::zero(),
            acceleration_error: S::ZERO,
            rate_errors: Vector3::zero(),
            waves: [[S::ZERO; 2]; 3],
        }
    }

    /// From numbers of an element.
    pub fn read(numbers: &[S]) -> Self {
        let column = |first: usize| Vector3::from_slice(&numbers[first..]);
        Self {
            moving: Moving::read(numbers),
            displacement: column(12),
            acceleration_error: numbers[15],
            rate_errors: column(16),
            waves: [0, 1, 2].map(|axis| [numbers[19 + 2 * axis], numbers[20 + 2 * axis]]),
        }
    }

    /// To numbers of an element.
    pub fn write(&self, numbers: &mut [S]) {
        self.moving.write(numbers);
        self.displacement.write_to(&mut numbers[12..]);
        numbers[15] = self.acceleration_error;
        self.rate_errors.write_to(&mut numbers[16..]);
        numbers[19..NUMBERS].copy_from_slice(self.waves.as_flattened());
    }

    /// Returns the measured angular velocity less its estimated error.
    pub fn rate(&self, measured: &Increments<S>) -> Vector3<S> {
        measured.rate - self.rate_errors
    }

    /// Advances the estimate by one sample.
    pub fn advance(&mut self, measured: &Increments<S>, gravity: S, design: &Design) {
        let (period, half) = (S::constant(design.period_s), S::constant(0.5 * design.period_s));
        let rate = self.rate(measured);
        let rotation = self.moving.rotation;
        let along = rotation * exp(rate * half) * measured.specific_force;
        let acceleration = along - Vector3([S::ZERO, S::ZERO, gravity + self.acceleration_error]);
        self.displacement += (self.moving.velocity + acceleration * half) * period;
        self.moving.velocity += acceleration * period;
        self.moving.rotation = rotation * exp(rate * period);
        self.waves = self.waves.map(|waves| design.waves.onward(waves));
    }

    /// Returns the offset of the mean position from the estimated position without the motion in waves, m.
    pub fn from_mean(&self, mean: Vector3<S>) -> Vector3<S> {
        mean - self.displacement + Vector3(self.waves.map(|[_, motion]| motion))
    }

    /// Corrects the estimate by an innovation, m, along the axes of the world. A tilt about y moves the point along x,
    /// a tilt about x against y.
    pub fn correct(&mut self, innovation: Vector3<S>, by: &KalmanGains) {
        let (level, vertical) = (by.level.map(S::constant), by.vertical.map(S::constant));
        let [x, y, z] = innovation.0;
        let along = |gain: usize| Vector3([level[gain] * x, level[gain] * y, vertical[gain] * z]);
        let about = |gain: usize| Vector3([-(level[gain] * y), level[gain] * x, S::ZERO]);
        self.displacement += along(0);
        self.moving.velocity += along(1);
        self.acceleration_error += vertical[2] * z;
        self.turn(about(2), about(3));
        let gains = [[level[4], level[5]], [level[4], level[5]], [vertical[3], vertical[4]]];
        for ((waves, gains), along) in self.waves.iter_mut().zip(gains).zip(innovation.0) {
            (0..2).for_each(|state| waves[state] += gains[state] * along);
        }
    }

    /// Corrects the heading by a measured one, rad.
    pub fn correct_heading(&mut self, measured: S, design: &Design) {
        let (sine, cosine) = (measured - roll_pitch_yaw(&self.moving.rotation)[2]).sin_cos();
        let innovation = sine.atan2(cosine);
        let [angle, rate] = design.heading.map(|gain| Vector3([S::ZERO, S::ZERO, S::constant(gain) * innovation]));
        self.turn(angle, rate);
    }

    /// Rotates the attitude by an angle vector, rad, and adds to the errors of the rates, rad/s, both in world axes.
    fn turn(&mut self, by: Vector3<S>, rates: Vector3<S>) {
        self.moving.rotation = exp(by) * self.moving.rotation;
        self.rate_errors += self.moving.rotation.transpose_times(rates);
    }
}

impl<S: Scalar> Moving<S> {
    /// From numbers of an element.
    pub fn read(numbers: &[S]) -> Self {
        Self { rotation: Matrix3::from_fn(|i, j| numbers[3 * i + j]), velocity: Vector3::from_slice(&numbers[9..]) }
    }

    /// To numbers of an element.
    pub fn write(&self, numbers: &mut [S]) {
        numbers[..9].copy_from_slice(self.rotation.0.as_flattened());
        self.velocity.write_to(&mut numbers[9..]);
    }
}

#[cfg(test)]
mod tests {
    use super::super::gains::Assumed;
    use super::*;

    const GRAVITY: f64 = 9.80665;
    const PERIOD_S: f64 = 0.02;

    fn design() -> Design {
        Design::new(&Assumed {
            period_s: PERIOD_S,
            acceleration_noise: 0.002,
            rate_noise: 3e-4,
            heading_noise: 2e-3,
            motion_m: 0.3,
            motion_period_s: 9.0,
            receiver: None,
        })
    }

    fn moved(time_s: f64) -> Moving<f64> {
        let angles = Vector3::new(0.3 * libm::sin(0.9 * time_s), 0.2 * libm::cos(0.7 * time_s), 0.1 * time_s);
        let velocity = Vector3::new(libm::sin(time_s), 0.5 * libm::cos(1.3 * time_s), libm::sin(0.8 * time_s));
        Moving { rotation: exp(angles), velocity }
    }

    /// Savage (1998): integration inverts the increments exactly for any motion; displacements then follow by the
    /// trapezoidal rule.
    #[test]
    fn attitude_and_velocity_of_a_unit_without_errors_are_exact() {
        let (design, start) = (design(), moved(0.0));
        let at_rest = Increments {
            specific_force: start.rotation.transpose_times(Vector3::new(0.0, 0.0, GRAVITY)),
            rate: Vector3::zero(),
        };
        let (mut found, mut before) = (Navigation::settled(start, &at_rest, GRAVITY), start);
        let mut by_trapezia = Vector3::zero();
        for k in 1..=5000 {
            let now = moved(PERIOD_S * f64::from(k));
            found.advance(&now.since(&before, GRAVITY, PERIOD_S), GRAVITY, &design);
            by_trapezia += (now.velocity + before.velocity) * (0.5 * PERIOD_S);
            before = now;
        }
        // Rounding of 5000 products of rotations and of sums of 5000 accelerations.
        let turned = log_of_part_turn(&(found.moving.rotation * before.rotation.transpose()));
        assert!(turned.norm() < 1e-12, "{turned:?}");
        assert!((found.moving.velocity - before.velocity).norm() < 1e-10, "{:?}", found.moving.velocity);
        assert!((found.displacement - by_trapezia).norm() < 1e-8, "{:?}", found.displacement);
    }

    /// At rest, the estimate converges from a wrong attitude and without initial estimates of the errors: the roots of
    /// the filter are at 0.02 per second and above, except the slower roots of the errors' random walk.
    #[test]
    fn estimated_gyroscope_errors_and_attitude_converge_at_rest() {
        let (design, errors) = (design(), Vector3::new(1e-4, -2e-4, 1.5e-4));
        let still = Moving { rotation: Matrix3::identity(), velocity: Vector3::zero() };
        let exact = still.since(&still, GRAVITY, PERIOD_S);
        let mut found = Navigation::settled(still, &exact, GRAVITY);
        found.moving.rotation = exp(Vector3::new(0.005, -0.004, 0.003));
        let measured = Increments { rate: exact.rate + errors, ..exact };
        for _ in 0..(3000.0 / PERIOD_S) as usize {
            found.advance(&measured, GRAVITY, &design);
            found.correct(found.from_mean(Vector3::zero()), &design.mean);
            found.correct_heading(0.0, &design);
        }
        assert!((found.rate_errors - errors).norm() < 0.01 * errors.norm(), "{:?}", found.rate_errors);
        let tilt = log_of_part_turn(&found.moving.rotation);
        assert!(tilt.norm() < 1e-4, "{tilt:?}");
    }
}
