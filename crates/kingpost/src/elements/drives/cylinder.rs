//! A hydraulic cylinder between two pins: it keeps its length, or moves to a target length at a limited speed.

use crate::dynamics::loops::Row;
use crate::dynamics::{LinkKinematics, Loads};
use crate::elements::{
    Context, Declaration, DrawnLine, Element, ElementState, EvaluationMode, Input, LineStyle, Output, Settling,
    StateDeclaration, Support, hunt_crossley,
};
use crate::model::{Attachment, Constraint, Model};
use crate::scalar::Scalar;

/// A force along the line between two pins, positive where it pushes them apart: with the length L and the target
/// length L_wanted,
///
/// ```text
/// F = F_0 + k (L_wanted - L) - c L',   clipped to what the pressures allow, -F_pull <= F <= F_push
/// ```
///
/// F_0 is 0, except for a cylinder with a lever in a run that begins at an equilibrium: F_0 then carries the load at
/// the length that the lever has set.
///
/// L_wanted changes no faster than the speed limit and stays within the stroke. There is a stop at both ends of the
/// stroke ([`hunt_crossley`]). The work of the force is the drive's; the stops store energy and make heat. Barrel and
/// rod have no mass: add their mass to the bodies if it is not negligible.
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
    /// Largest rate of the target length, m/s.
    pub speed_limit: S,
    /// Its target.
    pub aim: Aim<S>,
    /// Length at the start, m.
    pub start: S,
    /// Whether it has a lever and holds the load from the start of a run that begins at an equilibrium.
    pub holds: bool,
    /// F_0: force that holds the length at that equilibrium, N.
    pub hold: [S; 1],
    /// Time at which the target length stops moving, s: a step ends there.
    pub arrival_s: Option<f64>,
}

/// The target of a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Aim<S = f64> {
    /// Keeps the length at the start.
    Hold,
    /// Moves to this length, m, from the start on.
    Length(S),
    /// A lever: the rate of the target length, which is a state, is its input, from -1 to 1, times the speed limit.
    Lever,
}

/// The forces of a cylinder.
struct Forces<S> {
    line: Row<S>,
    drive: S,
    stops: S,
    heat: S,
}

impl<S: Scalar> Element<S> for Cylinder<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number = |variable, description, unit| Output::number(variable, description, "cylinder", &self.name, unit);
        let by_lever = self.aim == Aim::Lever;
        Declaration {
            states: by_lever.then(|| StateDeclaration::new("wanted_length", "m")).into_iter().collect(),
            inputs: by_lever.then(|| Input::lever(&self.name, -1.0, 0.0)).into_iter().collect(),
            outputs: vec![
                number("cylinder_length", "length of a cylinder between its pins", &["m"]),
                number("cylinder_rate", "rate of a cylinder's length", &["m/s"]),
                number("cylinder_force", "force of a cylinder, positive when it pushes, stops included", &["N"]),
                number(
                    "cylinder_effort_utilisation",
                    "force of a cylinder without its stops, over its push or pull limit",
                    &["1"],
                ),
            ],
            lines: self.lines(),
            keeps_states: true,
            ..Declaration::default()
        }
    }

    /// Sets the target length to the present length, m.
    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        own.states.fill(self.length(at.model, at.links));
    }

    /// Adds the force, its work and its heat.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let Forces { line, drive, stops, heat } = self.forces(at);
        loads.power.drives += drive * line.rate;
        loads.power.dissipated += heat;
        for (attachment, in_root) in [(&self.first, &line.on_first), (&self.second, &line.on_second)] {
            loads.add_on_link(at.model, at.links, attachment.body, &(*in_root * (drive + stops)));
        }
    }

    /// Writes the rate of the target length: the lever's share of the speed limit, 0 at the ends of the stroke.
    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        let (Some(rate), [lever], [wanted]) = (rates.first_mut(), at.inputs, at.states) else { return };
        let speed = self.speed_limit * *lever;
        let up = || wanted.select_less(self.stroke[1], || speed, || S::ZERO);
        let down = || self.stroke[0].select_less(*wanted, || speed, || S::ZERO);
        *rate = speed.select_below(0.0, down, up);
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let Forces { line, drive, stops, .. } = self.forces(at);
        out.extend([line.residual, line.rate, drive + stops, self.share_of_limit(drive)]);
    }

    /// Draws the barrel from the first pin, the rod from within the barrel to the second pin, and both pins.
    fn draw(&mut self, at: &Context<'_, S>, points: &mut Vec<S>) {
        let place = |pin: &Attachment<S>| {
            let point = pin.in_body.position;
            pin.body.map_or(point, |body| at.links.body_frame(at.model, body).point(point))
        };
        let (first, second) = (place(&self.first), place(&self.second));
        let barrel = S::constant(BARREL_LENGTH) * self.stroke[0] / self.length(at.model, at.links);
        let along = |share: S| first + (second - first) * share;
        for point in [first, along(barrel), along(barrel * S::constant(0.5)), second, first, second] {
            points.extend(point.0);
        }
    }

    fn supports(&self) -> Vec<Support> {
        let ends = [self.first.body, self.second.body];
        let ties = ends.into_iter().flatten().map(Support::Tie);
        [Support::Carries(ends), Support::Station(ends)].into_iter().chain(ties).collect()
    }

    fn next_edge_s(&self, after_s: f64, _modes: &[i64]) -> f64 {
        self.arrival_s.filter(|arrival| *arrival > after_s).unwrap_or(f64::INFINITY)
    }

    fn settling(&self) -> Option<&dyn Settling<S>> {
        self.holds.then_some(self)
    }

    fn settling_mut(&mut self) -> Option<&mut dyn Settling<S>> {
        if self.holds { Some(self) } else { None }
    }

    /// Returns the energy in the stops, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let square =
            self.depths(self.length(at.model, at.links)).iter().fold(S::ZERO, |sum, depth| sum + *depth * *depth);
        self.stop_stiffness * square * S::constant(0.5)
    }
}

/// A cylinder with a lever holds the length that the lever has set under any load.
impl<S: Scalar> Settling<S> for Cylinder<S> {
    fn trim(&self) -> &[S] {
        &self.hold
    }

    fn set_trim(&mut self, trim: &[S]) {
        self.hold.copy_from_slice(trim);
    }

    fn take_over(&mut self, at: &Context<'_, S>) -> S {
        let off = self.length(at.model, at.links) - self.wanted(at);
        self.hold[0] -= self.stiffness * off;
        off.select_below(0.0, || -off, || off)
    }

    fn utilisation(&self, _at: &Context<'_, S>) -> S {
        self.share_of_limit(self.hold[0])
    }
}

/// The barrel's length and radius as shares of the shortest length between the pins; the rod's and the pins' radius as
/// shares of the barrel's.
const BARREL_LENGTH: f64 = 0.88;
const BARREL_RADIUS: f64 = 0.036;
const ROD_RADIUS: f64 = 0.6;
const PIN_RADIUS: f64 = 1.15;

impl<S: Scalar> Cylinder<S> {
    fn lines(&self) -> Vec<DrawnLine> {
        let radius = BARREL_RADIUS * self.stroke[0].value();
        let line = |style, share: f64, points| DrawnLine {
            radius_m: share * radius,
            ..DrawnLine::thin(&self.name, style, points)
        };
        let pin = || line(LineStyle::Pin, PIN_RADIUS, 1);
        vec![line(LineStyle::Barrel, 1.0, 2), line(LineStyle::Rod, ROD_RADIUS, 2), pin(), pin()]
    }

    /// Takes the present length as the length at the start. If the target length arrives at the same time in all lanes,
    /// a step ends there.
    pub fn start_at(&mut self, model: &Model<S>, links: &LinkKinematics<S>) {
        self.start = self.length(model, links);
        if let Aim::Length(length) = self.aim {
            let way = length - self.start;
            let way = way.select_below(0.0, || -way, || way);
            let arrival = way / self.speed_limit;
            let first = arrival.value();
            self.arrival_s = arrival.all(|time| time == first).then_some(first);
        }
    }

    /// Returns the row of J of the distance between the pins.
    fn line(&self, model: &Model<S>, links: &LinkKinematics<S>) -> Row<S> {
        Row::new(model, links, &self.first, &self.second, &Constraint::Distance(S::ZERO))
    }

    /// Returns the length between the pins, m.
    pub fn length(&self, model: &Model<S>, links: &LinkKinematics<S>) -> S {
        self.line(model, links).residual
    }

    /// Returns the target length.
    fn wanted(&self, at: &Context<'_, S>) -> S {
        let aim = match self.aim {
            Aim::Hold => return self.start,
            Aim::Lever => return at.states.first().copied().unwrap_or(self.start),
            Aim::Length(length) => length,
        };
        let reach = self.speed_limit * S::constant(at.clock.time_s);
        self.start + (aim - self.start).clipped(-reach, reach)
    }

    fn forces(&self, at: &Context<'_, S>) -> Forces<S> {
        let line = self.line(at.model, at.links);
        let (length, rate) = (line.residual, line.rate);
        let wanted = self.hold[0] + self.stiffness * (self.wanted(at) - length) - self.damping * rate;
        let is_sought = at.evaluation == EvaluationMode::Settling && self.holds;
        let drive = if is_sought { wanted } else { wanted.clipped(-self.pull_limit, self.push_limit) };
        let [short, long] = self.depths(length);
        let stop = |depth, speed| hunt_crossley(self.stop_stiffness, self.stop_dissipation, depth, speed);
        let ((out, heat_short), (back, heat_long)) = (stop(short, -rate), stop(long, rate));
        Forces { line, drive, stops: out - back, heat: heat_short + heat_long }
    }

    /// Returns a force of the drive over the limit in its direction; 0 without a limit.
    fn share_of_limit(&self, drive: S) -> S {
        let share = |force: S, limit: S| limit.select_below(f64::MIN_POSITIVE, || S::ZERO, || force / limit);
        drive.select_below(0.0, || share(-drive, self.pull_limit), || share(drive, self.push_limit))
    }

    /// Returns the depth of the length beyond each end of the stroke, m.
    fn depths(&self, length: S) -> [S; 2] {
        let [short, long] = [self.stroke[0] - length, length - self.stroke[1]];
        [short, long].map(|beyond| beyond.select_below(0.0, || S::ZERO, || beyond))
    }
}
