//! A platform that stays level and at its height: three driven joints below a crane's pedestal.

use super::chain::DrivenChain;
use super::estimate::{Estimate, Estimator, sensor_changes};
use super::lever::{self, Lever, NEXT_TICK, SENSOR_OUT};
use super::measurement::Measured;
use crate::elements::lines::place;
use crate::elements::ticks::{Due, due};
use crate::elements::{Components, Context, Declaration, Element, ElementState, Occurrence, Output, VectorFrame};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Twist, Vector3};

/// Steers the speeds of the joints below a platform at every multiple of its period, so that it stays level and its
/// point at its height. With the upward axis n of the platform (world axes), its horizontal angular velocity omega and
/// the vertical velocity v_z of its point from the ship's motion, and the Jacobian J of the joints' rates x' (rows a:
/// horizontal angular velocity, row z: vertical velocity),
///
/// ```text
/// J_a x' = -f omega - g (-n_y, n_x),    J_z x' = -f v_z - g (z - z_0)
/// ```
///
/// by damped least squares, within the speed limits of the drives. z_0 is the height when the compensation was switched
/// on; the tilt is always controlled to 0. omega, n and the point are ideal or from a motion reference unit, whose
/// angles are absolute; with a prediction, omega and v_z are predicted over all delays and the lag of each drive, and
/// the tilt over the age of the measurement. Platforms of this kind stand on three cylinders or in a gimbal
/// (MacGregor's three-axis compensated crane, Barge Master); the joints here may be any chain of three or more.
#[derive(Clone, Debug)]
pub struct PlatformCompensation<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Estimator of the ship's motion, with its sampling period.
    pub estimator: Estimator<S>,
    /// The joints between ship and platform, with their drives.
    pub chain: DrivenChain<S>,
    /// The point of the platform, with the platform's axes.
    pub top: Attachment<S>,
    /// The body whose attitude is measured: the unit's.
    pub base: Option<usize>,
    /// f.
    pub feed_forward: S,
    /// g, 1/s.
    pub gain: S,
    /// Whether it is switched on at the start.
    pub begins_on: bool,
}

/// Numbers: whether it was on; the utilisation; z_0, estimated and exact; then the numbers of the estimator, for both
/// tilts and the height.
const WAS_ON: usize = 0;
const UTILISATION: usize = 1;
const ZERO: usize = 2;
const TRUE_ZERO: usize = 3;
const ESTIMATE: usize = 4;
/// Names of the controlled quantities: tilt about x and y, height.
const KEPT: [&str; 3] = ["tilt_x", "tilt_y", "height"];
const HEIGHT: usize = 2;
const UPWARD: usize = 2;

impl<S: Scalar> Element<S> for PlatformCompensation<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let own = ["was_on", "utilisation", "zero_height", "true_zero_height"].map(str::to_owned);
        let estimates = KEPT.iter().flat_map(|kept| self.estimator.number_names(&format!("{kept}_")));
        Declaration {
            numbers: own.into_iter().chain(estimates).collect(),
            modes: lever::modes(),
            inputs: vec![lever::lever(&self.name, self.begins_on)],
            outputs: self.shown(),
            reads: self.estimator.measurement.columns(),
            steers: self.chain.joints.iter().map(|joint| joint.drive.clone()).collect(),
            ..Declaration::default()
        }
    }

    fn update_controls(
        &mut self,
        at: &Context<'_, S>,
        read: &[S],
        own: &mut ElementState<'_, S>,
        inputs: &mut [S],
    ) -> Result<Vec<Occurrence>, String> {
        let due = due(at.clock.time_s, self.estimator.period_s, &mut own.modes[NEXT_TICK]);
        let Some(Due { is_first: begins, .. }) = due else { return Ok(Vec::new()) };
        let columns = self.chain.jacobian(at, &self.top);
        let driven = self.chain.driven(at, &columns);
        let point = self.estimator.measurement.measure(at, &self.top, driven.linear, read);
        let happened = sensor_changes(point.delivers, SENSOR_OUT, own);
        let tilt = self.tilt(at, &driven, point.delivers, read);
        let size = self.estimator.numbers();
        let mut take = |kept: usize, measured: &Measured<S>, axis: usize| {
            let numbers = &mut own.numbers[ESTIMATE + kept * size..][..size];
            self.estimator.take(measured, axis, begins, numbers)
        };
        let estimates = [take(0, &tilt, 0), take(1, &tilt, 1), take(HEIGHT, &point, UPWARD)];
        self.reset(at, begins, &estimates[HEIGHT], own.numbers);
        self.command(at, &columns, (&estimates, &tilt), (own.numbers, inputs));
        Ok(happened)
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let upward = self.rotation(at).column(2);
        let begun = lever::begun(at);
        out.extend([-upward[1], upward[0], begun * (self.height(at) - at.numbers[TRUE_ZERO])]);
        out.push(at.numbers[UTILISATION]);
    }

    fn left_out_at_rest(&self) -> Option<&'static str> {
        Some("the response leaves out the commands of the platform's compensation; a run contains them")
    }
}

impl<S: Scalar> PlatformCompensation<S> {
    fn shown(&self) -> Vec<Output> {
        let offset = Output {
            components: Components::Axis,
            frame: VectorFrame::World,
            ..Output::number(
                "platform_offset",
                "x and y: sine of a platform's tilt about the world's axes; z: height error of its point, positive: too high",
                "controller",
                &self.name,
                &["1"],
            )
        };
        vec![Output { units: &["1", "1", "m"], ..offset }, lever::utilisation(&self.name)]
    }

    fn rotation(&self, at: &Context<'_, S>) -> Matrix3<S> {
        at.links.attachment_frame(at.model, &self.top).rotation
    }

    fn height(&self, at: &Context<'_, S>) -> S {
        place(&self.top, at.model, at.links)[UPWARD]
    }

    /// Returns tilt and angular velocity in the form of a measured point: its "position" is (-n_y, n_x, 0), its
    /// "velocity" omega.
    fn tilt(&self, at: &Context<'_, S>, driven: &Twist<S>, delivers: bool, read: &[S]) -> Measured<S> {
        let rotation = self.rotation(at);
        let tilted = |upward: Vector3<S>| Vector3([-upward[1], upward[0], S::ZERO]);
        let measured = |position, velocity, by_crane| Measured {
            positions: [Vector3::zero(), position],
            velocities: [Vector3::zero(), velocity],
            by_crane,
            delivers,
        };
        let (Some(base), Some(attitude)) = (self.base, self.estimator.measurement.attitude(read)) else {
            let Some(body) = self.top.body else { return measured(Vector3::zero(), Vector3::zero(), Vector3::zero()) };
            let turning = at.links.body_frame(at.model, body).rotation * at.links.body_twist(at.model, body).angular;
            return measured(tilted(rotation.column(2)), turning - driven.angular, driven.angular);
        };
        // Rotation from world axes to world axes by the measured attitude.
        let known = attitude.rotation * at.links.body_frame(at.model, base).rotation.transpose();
        let turning = attitude.rotation * attitude.angular;
        measured(tilted(known * rotation.column(2)), turning, known * driven.angular)
    }

    fn reset(&self, at: &Context<'_, S>, begins: bool, height: &Estimate<S>, numbers: &mut [S]) {
        let lever = Lever::at(at.inputs[0], begins, numbers[WAS_ON]);
        lever.renew(&mut numbers[ZERO], height.position);
        lever.renew(&mut numbers[TRUE_ZERO], self.height(at));
        numbers[WAS_ON] = lever.on;
    }

    /// Sets the speeds of the drives, rad/s or m/s.
    fn command(
        &self,
        at: &Context<'_, S>,
        columns: &[Twist<S>],
        (estimates, tilt): (&[Estimate<S>; 3], &Measured<S>),
        (numbers, inputs): (&mut [S], &mut [S]),
    ) {
        let row = |of: fn(&Twist<S>) -> S| columns.iter().map(of).collect::<Vec<S>>();
        let rows =
            [row(|column| column.angular[0]), row(|column| column.angular[1]), row(|column| column.linear[UPWARD])];
        // The measured tilt is absolute but delayed.
        let age = self.estimator.prediction.as_ref().map_or(S::ZERO, |prediction| prediction.age);
        let known = self.in_known_axes(at, &rows);
        let wanted = |kept: usize, drive: usize| {
            let error = if kept == HEIGHT {
                estimates[HEIGHT].position - numbers[ZERO]
            } else {
                tilt.positions[1][kept] + age * tilt.velocities[1][kept]
            };
            -(numbers[WAS_ON] * (self.feed_forward * estimates[kept].velocity_for(drive) + self.gain * error))
        };
        let rate = |drive: usize| self.chain.rates(&known, &[0, 1, 2].map(|kept| wanted(kept, drive)))[drive];
        let free: Vec<S> = (0..columns.len()).map(rate).collect();
        let given = self.chain.within_limits(&free);
        for ((input, rate), joint) in inputs.iter_mut().zip(given).zip(&self.chain.joints) {
            *input = rate - joint.set_point;
        }
        numbers[UTILISATION] = self.chain.utilisation(&free);
    }

    /// Returns the angular rows in the axes of the measured tilt: without a measured yaw, level axes that yaw with the
    /// unit's body.
    fn in_known_axes(&self, at: &Context<'_, S>, rows: &[Vec<S>; 3]) -> Vec<Vec<S>> {
        let Some(yaw) = self.base.filter(|_| !self.estimator.measurement.has_yaw()) else { return rows.to_vec() };
        let forward = at.links.body_frame(at.model, yaw).rotation.column(0);
        let level = (forward[0] * forward[0] + forward[1] * forward[1]).sqrt();
        let [cosine, sine] = [forward[0] / level, forward[1] / level];
        let turned = |[a, b]: [S; 2]| rows[0].iter().zip(&rows[1]).map(|(x, y)| a * *x + b * *y).collect();
        vec![turned([cosine, sine]), turned([-sine, cosine]), rows[2].clone()]
    }
}
