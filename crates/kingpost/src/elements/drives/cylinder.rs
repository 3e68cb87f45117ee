//! A hydraulic cylinder between two pins: it keeps a length, or goes to another at a limited speed.

use crate::dynamics::loops::Row;
use crate::dynamics::{LinkKinematics, Loads, Moment};
use crate::elements::hunt_crossley;
use crate::model::{Attachment, Constraint, Model};
use crate::scalar::Scalar;

/// A force along the line between two pins, positive where it pushes them apart: with the length L
/// and the length wanted,
///
/// ```text
/// F = k (L_wanted - L) - c L',   clipped to what the pressures allow, -F_pull <= F <= F_push
/// ```
///
/// L_wanted moves at the limited speed at most, and stays within the stroke. At both ends of the
/// stroke stands a stop, [`hunt_crossley`]'s. The force's work is the drive's; the stops store and
/// heat. The masses of barrel and rod are those of the bodies, if they are to count.
#[derive(Clone, Debug)]
pub struct Cylinder<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Pin on one body.
    pub first: Attachment<S>,
    /// Pin on the other.
    pub second: Attachment<S>,
    /// k, N/m.
    pub stiffness: S,
    /// c, N s/m.
    pub damping: S,
    /// F_push, N.
    pub push_limit: S,
    /// F_pull, N.
    pub pull_limit: S,
    /// Shortest and longest length between the pins, m.
    pub stroke: [S; 2],
    /// Stiffness of the stops, N/m.
    pub stop_stiffness: S,
    /// Dissipation of the stops, s/m.
    pub stop_dissipation: S,
    /// Largest speed of the length wanted, m/s.
    pub speed_limit: S,
    /// What it is after.
    pub aim: Aim<S>,
    /// Length at the start, m.
    pub start: S,
    /// When the length wanted arrives, s: the law changes its form there.
    pub arrival_s: Vec<f64>,
}

/// What a cylinder is after.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Aim<S = f64> {
    /// The length that it has at the start.
    Hold,
    /// This length, from the start on, m.
    Length(S),
    /// What a lever leads to: the input, from -1 to 1, is the share of the speed.
    Lever {
        /// The input.
        input: usize,
        /// The length wanted, among the extra states of the drives.
        state: usize,
    },
}

/// A cylinder at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylinderReading<S = f64> {
    /// Length between the pins, m.
    pub length: S,
    /// Its rate, m/s.
    pub rate: S,
    /// Force, positive where it pushes, stops included, N.
    pub force: S,
}

/// The forces of a cylinder.
struct Forces<S> {
    line: Row<S>,
    drive: S,
    stops: S,
    heat: S,
}

impl<S: Scalar> Cylinder<S> {
    /// Adds the force, and the work and heat that it makes.
    pub fn apply(&self, at: &Moment<'_, S>, loads: &mut Loads<S>) {
        let Forces { line, drive, stops, heat } = self.forces(at);
        loads.power.drives += drive * line.rate;
        loads.power.dissipated += heat;
        for (attachment, in_root) in [(&self.first, &line.on_first), (&self.second, &line.on_second)] {
            loads.add_on_link(at.model, at.links, attachment.body, &(*in_root * (drive + stops)));
        }
    }

    /// Length, rate and force.
    pub fn reading(&self, at: &Moment<'_, S>) -> CylinderReading<S> {
        let Forces { line, drive, stops, .. } = self.forces(at);
        CylinderReading { length: line.residual, rate: line.rate, force: drive + stops }
    }

    /// Energy in the stops, J.
    pub fn potential_energy(&self, model: &Model<S>, links: &LinkKinematics<S>) -> S {
        let square = self.depths(self.length(model, links)).iter().fold(S::ZERO, |sum, depth| sum + *depth * *depth);
        self.stop_stiffness * square * S::constant(0.5)
    }

    /// Takes the length here as that of the start. Where the length wanted arrives at one time in
    /// all lanes, steps end there.
    pub fn begin(&mut self, model: &Model<S>, links: &LinkKinematics<S>) {
        self.start = self.length(model, links);
        if let Aim::Length(length) = self.aim {
            let way = length - self.start;
            let way = way.select_below(0.0, || -way, || way);
            let arrival = way / self.speed_limit;
            let first = arrival.value();
            self.arrival_s = if arrival.all(|time| time == first) { vec![first] } else { Vec::new() };
        }
    }

    /// The first value of the length wanted, where it is an extra state: the length here, m.
    pub fn first_state(&self, model: &Model<S>, links: &LinkKinematics<S>) -> Option<S> {
        matches!(self.aim, Aim::Lever { .. }).then(|| self.length(model, links))
    }

    /// Rate of the length wanted, where it is an extra state, and which: within the stroke the
    /// lever's share of the speed, and no further.
    pub fn state_rate(&self, inputs: &[S], states: &[S]) -> Option<(usize, S)> {
        let Aim::Lever { input, state } = self.aim else { return None };
        let (speed, wanted) = (self.speed_limit * inputs[input], states[state]);
        let up = || wanted.select_less(self.stroke[1], || speed, || S::ZERO);
        let down = || self.stroke[0].select_less(wanted, || speed, || S::ZERO);
        Some((state, speed.select_below(0.0, down, up)))
    }

    /// The line between the pins: the row of J of their distance.
    fn line(&self, model: &Model<S>, links: &LinkKinematics<S>) -> Row<S> {
        Row::new(model, links, &self.first, &self.second, &Constraint::Distance(S::ZERO))
    }

    /// Length between the pins, m.
    pub fn length(&self, model: &Model<S>, links: &LinkKinematics<S>) -> S {
        self.line(model, links).residual
    }

    /// The length wanted.
    fn wanted(&self, at: &Moment<'_, S>) -> S {
        let aim = match self.aim {
            Aim::Hold => return self.start,
            Aim::Lever { state, .. } => return at.states[state],
            Aim::Length(length) => length,
        };
        let reach = self.speed_limit * S::constant(at.clock.time_s);
        self.start + (aim - self.start).clipped(-reach, reach)
    }

    fn forces(&self, at: &Moment<'_, S>) -> Forces<S> {
        let line = self.line(at.model, at.links);
        let (length, rate) = (line.residual, line.rate);
        let wanted = self.stiffness * (self.wanted(at) - length) - self.damping * rate;
        let drive = wanted.clipped(-self.pull_limit, self.push_limit);
        let [short, long] = self.depths(length);
        let stop = |depth, speed| hunt_crossley(self.stop_stiffness, self.stop_dissipation, depth, speed);
        let ((out, heat_short), (back, heat_long)) = (stop(short, -rate), stop(long, rate));
        Forces { line, drive, stops: out - back, heat: heat_short + heat_long }
    }

    /// How far the length is beyond each end of the stroke, m.
    fn depths(&self, length: S) -> [S; 2] {
        let [short, long] = [self.stroke[0] - length, length - self.stroke[1]];
        [short, long].map(|beyond| beyond.select_below(0.0, || S::ZERO, || beyond))
    }
}
