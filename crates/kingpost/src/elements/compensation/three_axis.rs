//! Compensation in three axes: slewing and luffing hold the crane's tip over a point of the world, and the winch holds
//! the load's height.

use super::chain::DrivenChain;
use super::estimate::{Estimate, Estimator, sensor_changes};
use super::lever::{self, Lever, NEXT_TICK, SENSOR_OUT, reached, share};
use crate::elements::lines::place;
use crate::elements::ropes::Drum;
use crate::elements::ticks::{Due, due};
use crate::elements::{
    Components, Context, Declaration, Element, ElementState, Input, Occurrence, Output, VectorFrame,
};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::{Twist, Vector3};

/// Steers the speeds of the joints below a crane's tip and of its winch at every multiple of its period, so that the
/// tip stays over a point of the world and the load at its height. With the tip's position p, its velocity v from the
/// ship's motion, the Jacobian J of the joints' rates x' (rows h: horizontal, row z: vertical), the rope L paid out, n
/// falls and the operator's velocity u (horizontal, and u_z down),
///
/// ```text
/// e  = p - p_0 - integral of u             horizontal
/// J_h x'_wanted = u - f v_h - g e          by damped least squares, within the speed limits of the drives
/// e_z = p_z - p_z0 + integral of u_z - (L - L_0) / n
/// L'_wanted / n = f v_z + J_z x'_wanted + g e_z + u_z,    within the speed limit of the winch
/// ```
///
/// so the winch compensates the change of height due to luffing. p_0 and L_0 are p and L when the compensation was
/// switched on. v and p are ideal or from a motion reference unit ([`Measurement`](super::Measurement)), and predicted
/// for the lag of each drive ([`Prediction`](super::Prediction)). If a drive is at its limit, all joints are slowed by
/// the same factor, and u is reduced to the part that the drives reach, so that they do not catch up afterwards
/// (back-calculation: Astrom & Hagglund, *Advanced PID Control*, 2006, sec. 3.5).
///
/// Liebherr, MacGregor and Royal IHC build cranes whose own drives compensate three axes. Resolved motion rate control
/// is by Whitney (*IEEE Trans. Man-Machine Systems* 10, 1969, pp. 47-53).
#[derive(Clone, Debug)]
pub struct ThreeAxisCompensation<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Estimator of p and v, with its sampling period.
    pub estimator: Estimator<S>,
    /// The joints between ship and tip, with their drives.
    pub chain: DrivenChain<S>,
    /// The point from which the rope hangs down to the load.
    pub tip: Attachment<S>,
    /// n.
    pub falls: S,
    /// The drum of the winch.
    pub drum: Drum<S>,
    /// The drive of the winch.
    pub winch: String,
    /// Set-point of the winch in the scenario, rad/s: the controller's command replaces it.
    pub winch_speed: S,
    /// The speed limit of the winch, rad/s.
    pub winch_limit: S,
    /// f.
    pub feed_forward: S,
    /// g, 1/s.
    pub gain: S,
    /// Whether it is switched on at the start.
    pub begins_on: bool,
}

/// Numbers: whether it was on; L_0; the utilisation; for x, y and z each: p_0, estimated and exact, the integral of the
/// operator's velocity, and the ship's velocity at the tip; then the numbers of the estimator, for each axis.
const WAS_ON: usize = 0;
const PAID_OUT: usize = 1;
const UTILISATION: usize = 2;
const ZERO: usize = 3;
const TRUE_ZERO: usize = 6;
const OPERATED: usize = 9;
const VELOCITY: usize = 12;
const ESTIMATE: usize = 15;
const AXES: [&str; 3] = ["x", "y", "z"];
const HORIZONTAL: [usize; 2] = [0, 1];
const UPWARD: usize = 2;

impl<S: Scalar> Element<S> for ThreeAxisCompensation<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let own = ["was_on", "zero_paid_out", "utilisation"].map(str::to_owned).into_iter();
        let each = ["zero", "true_zero", "operated", "velocity"].into_iter();
        let each = each.flat_map(|what| AXES.map(|axis| format!("{what}_{axis}")));
        let estimates = AXES.iter().flat_map(|axis| self.estimator.number_names(&format!("{axis}_")));
        let drives = self.chain.joints.iter().map(|joint| joint.drive.clone());
        Declaration {
            numbers: own.chain(each).chain(estimates).collect(),
            modes: lever::modes(),
            inputs: self.inputs(),
            outputs: self.shown(),
            reads: self.estimator.measurement.columns(),
            steers: drives.chain([self.winch.clone()]).collect(),
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
        let columns = self.chain.jacobian(at, &self.tip);
        let driven = self.chain.driven(at, &columns).linear;
        let measured = self.estimator.measurement.measure(at, &self.tip, driven, read);
        let happened = sensor_changes(measured.delivers, SENSOR_OUT, own);
        let size = self.estimator.numbers();
        let estimates = [0, 1, 2].map(|axis| {
            let numbers = &mut own.numbers[ESTIMATE + axis * size..][..size];
            self.estimator.take(&measured, axis, begins, numbers)
        });
        self.reset(at, begins, &estimates, own.numbers);
        self.command(at, &columns, &estimates, (own.numbers, inputs));
        Ok(happened)
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let begun = lever::begun(at);
        let moved = self.position(at) - three(at.numbers, TRUE_ZERO);
        let [x, y, down] = three(at.numbers, OPERATED).0;
        let paid_out = (self.drum.paid_out(at).length - at.numbers[PAID_OUT]) / self.falls;
        out.extend([moved[0] - x, moved[1] - y, moved[2] + down - paid_out].map(|off| begun * off));
        out.extend(three(at.numbers, VELOCITY).0);
        out.push(at.numbers[UTILISATION]);
    }

    fn left_out_at_rest(&self) -> Option<&'static str> {
        Some("the response leaves out the commands of the three-axis compensation; a run contains them")
    }
}

impl<S: Scalar> ThreeAxisCompensation<S> {
    fn inputs(&self) -> Vec<Input> {
        let fastest = (self.winch_limit * self.drum.radius / self.falls).value();
        let speeds =
            ["x_speed", "y_speed", "lowering_speed"].map(|what| lever::operator_speed(&self.name, what, fastest));
        [lever::lever(&self.name, self.begins_on)].into_iter().chain(speeds).collect()
    }

    fn shown(&self) -> Vec<Output> {
        let vector = |variable, description, unit| Output {
            components: Components::Axis,
            frame: VectorFrame::World,
            ..Output::number(variable, description, "controller", &self.name, unit)
        };
        vec![
            vector(
                "compensation_offset",
                "x and y: offset of the crane's tip from the point that a compensation keeps; z: height error of its rope's end, \
                 for a rope that does not stretch, positive: too high",
                &["m"],
            ),
            vector(
                "compensation_ship_velocity",
                "velocity of the crane's tip from the ship's motion that a compensation uses: measured or predicted",
                &["m/s"],
            ),
            lever::utilisation(&self.name),
        ]
    }

    fn position(&self, at: &Context<'_, S>) -> Vector3<S> {
        place(&self.tip, at.model, at.links)
    }

    /// Takes the present position as the point to keep, at the start and when the compensation is switched on.
    fn reset(&self, at: &Context<'_, S>, begins: bool, estimates: &[Estimate<S>; 3], numbers: &mut [S]) {
        let lever = Lever::at(at.inputs[0], begins, numbers[WAS_ON]);
        let truth = self.position(at);
        let mut renew = |place: usize, value: S| lever.renew(&mut numbers[place], value);
        for axis in 0..3 {
            renew(ZERO + axis, estimates[axis].position);
            renew(TRUE_ZERO + axis, truth[axis]);
            renew(OPERATED + axis, S::ZERO);
        }
        renew(PAID_OUT, self.drum.paid_out(at).length);
        numbers[WAS_ON] = lever.on;
    }

    /// Sets the speeds of the drives, rad/s or m/s: those of the joints, then the winch's.
    fn command(
        &self,
        at: &Context<'_, S>,
        columns: &[Twist<S>],
        estimates: &[Estimate<S>; 3],
        (numbers, inputs): (&mut [S], &mut [S]),
    ) {
        let (on, joints) = (numbers[WAS_ON], &self.chain.joints);
        let rows = HORIZONTAL.map(|axis| columns.iter().map(|column| column.linear[axis]).collect::<Vec<S>>());
        // Wanted velocity of the tip relative to the ship, for the lag of a drive.
        let wanted = |axis: usize, drive: usize| {
            let error = estimates[axis].position - numbers[ZERO + axis] - numbers[OPERATED + axis];
            let correction = self.feed_forward * estimates[axis].velocity_for(drive) + self.gain * error;
            at.inputs[1 + axis] - on * correction
        };
        let rates_for = |drive: usize| self.chain.rates(&rows, &HORIZONTAL.map(|axis| wanted(axis, drive)));
        let free: Vec<S> = (0..joints.len()).map(|drive| rates_for(drive)[drive]).collect();
        let given = self.chain.within_limits(&free);
        for ((input, rate), joint) in inputs.iter_mut().zip(&given).zip(joints) {
            *input = *rate - joint.set_point;
        }
        let winch = joints.len();
        let moved = |row: &[S], rates: &[S]| row.iter().zip(rates).fold(S::ZERO, |sum, (j, rate)| sum + *j * *rate);
        let upward: Vec<S> = columns.iter().map(|column| column.linear[UPWARD]).collect();
        let lifted = moved(&upward, &self.chain.within_limits(&rates_for(winch)));
        let excess = HORIZONTAL.map(|axis| wanted(axis, winch) - moved(&rows[axis], &given));
        let (lowering, lacking, used) = self.pay_out(at, (&estimates[UPWARD], winch), (lifted, numbers));
        inputs[winch] = lowering;
        let excess = [excess[0], excess[1], lacking];
        for axis in 0..3 {
            let operator = at.inputs[1 + axis];
            numbers[OPERATED + axis] += S::constant(self.estimator.period_s) * reached(operator, excess[axis]);
            numbers[VELOCITY + axis] = estimates[axis].velocity_for(winch);
        }
        let most = self.chain.utilisation(&free);
        numbers[UTILISATION] = most.select_less(used, || used, || most);
    }

    /// Returns the speed for the winch's input, rad/s; the lowering speed beyond the winch's limit, m/s; and the wanted
    /// speed over the limit.
    fn pay_out(
        &self,
        at: &Context<'_, S>,
        (upward, winch): (&Estimate<S>, usize),
        (lifted, numbers): (S, &[S]),
    ) -> (S, S, S) {
        let paid_out = self.drum.paid_out(at);
        let per_speed = self.falls / paid_out.per_angle;
        let error = upward.position - numbers[ZERO + UPWARD] + numbers[OPERATED + UPWARD]
            - (paid_out.length - numbers[PAID_OUT]) / self.falls;
        let corrects = self.feed_forward * upward.velocity_for(winch) + lifted + self.gain * error;
        let free = numbers[WAS_ON] * corrects + at.inputs[1 + UPWARD];
        let given = (free * per_speed).clipped(-self.winch_limit, self.winch_limit);
        let used = share(free * per_speed, self.winch_limit);
        (given - self.winch_speed, free - given / per_speed, used)
    }
}

fn three<S: Scalar>(numbers: &[S], first: usize) -> Vector3<S> {
    Vector3::from_slice(&numbers[first..first + 3])
}
