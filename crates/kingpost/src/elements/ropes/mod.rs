//! Ropes over sheaves: hoists, luffing ropes, slings; and tugger lines, which are a type of their own.

pub(crate) mod assembly;
mod drum;
pub(crate) mod fields;
mod inextensible;
mod leads;
mod load_chart;
mod longitudinal;
mod path;
mod release;
mod station;
mod stretch;
mod tugger_line;
mod weight;

pub use drum::{Drum, Layers};
pub use inextensible::Inextensible;
pub use load_chart::LoadChart;
pub use longitudinal::LoadedBar;
pub use path::{PathLength, RopePath};
pub use station::{Efficiency, Round, Station};
pub use tugger_line::TuggerLine;
pub use weight::RopeWeight;

use crate::dynamics::Loads;
use crate::elements::{
    AnyElement, AnyWatcher, Context, Crossing, Declaration, DrawnLine, Element, ElementState, Event, Holding,
    LineStyle, Output, PresentSupport, Support, of_kind,
};
use crate::scalar::Scalar;
use crate::spatial::Vector3;
use release::is_off;

/// A rope without inertia over a [`RopePath`], which pulls and never pushes: elastic, or inextensible if it has no
/// stiffness.
///
/// For an elastic rope, with the length l of the path, the unstretched length L on it, the stretch e = l - L and 1/k =
/// L/EA + 1/k_s, where k_s is the stiffness in series with it (that of the crane, as in the *simple wire coupling* of
/// SIMO),
///
/// ```text
/// taut: T = k (e + tau e'),       slack: T = 0
/// V = k e^2 / 2,       -dV/dL = k e + (k e)^2 / (2 EA)
/// ```
///
/// T is the tension at the last end; where no event has chosen between taut and slack, it is max(k (e + tau e'), 0)
/// where e > 0, else 0. A [`Drum`] that turns by theta pays out R theta, with R its radius. Its torque is R times the
/// tension at the first end, with the friction of the sheaves and of the drum, plus R (k e)^2 / (2 EA): the wound rope
/// stores strain energy, and without this term rope paid out under tension would gain or lose energy. Damping and
/// friction become heat.
#[derive(Clone, Debug)]
pub struct Rope<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Its path.
    pub path: RopePath<S>,
    /// The drum at its first end.
    pub drum: Option<Drum<S>>,
    /// L at the start, m.
    pub unstretched_length: S,
    /// EA, N; infinite if the rope itself does not stretch.
    pub axial_stiffness: S,
    /// 1/k_s, m/N.
    pub series_compliance: S,
    /// tau, s.
    pub damping_time: S,
    /// Tension at which it parts, N.
    pub breaking_load: Option<S>,
    /// Its load at rest; `None` if unknown.
    pub carries: Option<RestingLoad<S>>,
    /// Whether an input with its name releases it and hooks it on again.
    pub can_be_released: bool,
    /// Whether it is released at the start.
    pub begins_released: bool,
    /// Its weight; without it, the rope is weightless.
    pub weight: Option<RopeWeight<S>>,
    /// The crane's load chart for the rope; `None` if unknown.
    pub load_chart: Option<LoadChart<S>>,
    /// The constraint of an inextensible rope, instead of elasticity.
    pub inextensible: Option<Inextensible<S>>,
}

impl<S: Scalar> Rope<S> {
    /// Returns the ropes among the elements.
    pub fn among(elements: &[AnyElement<S>]) -> impl Iterator<Item = &Self> {
        of_kind(elements)
    }
}

/// The load of a rope at rest.
#[derive(Clone, Debug)]
pub struct RestingLoad<S = f64> {
    /// The mass whose weight equals the tension of one fall at rest in air, kg.
    pub mass_on_a_fall: S,
    /// Number of falls that pull on the load together.
    pub falls: u32,
    /// The bodies of the load.
    pub bodies: Vec<usize>,
}

/// The only mode: the state of the rope. Only events change it, so that one force law holds throughout a step. If the
/// lanes of a run begin in different modes, the mode follows from the stretch until the first event in any lane. A rope
/// whose damper cancels all of its pull goes slack while it is still stretched; as it shortens, the remaining energy of
/// the spring becomes heat.
const BY_STRETCH: i64 = 0;
const TAUT: i64 = 1;
const SLACK: i64 = 2;
const PARTED: i64 = 3;
const RELEASED: i64 = 4;
/// Negative stretch at which a taut rope goes slack, m: rounding.
const ROUNDING_M: f64 = 1e-10;
/// Events, in the order of [`Rope::declare`].
const EVENTS: [Event; 8] = [
    Event { code: "goes_slack", what: "goes slack", crossing: Crossing::Falling },
    Event { code: "comes_taut", what: "comes taut", crossing: Crossing::Rising },
    Event { code: "hauled_in_to_end", what: "is hauled in to its end", crossing: Crossing::Falling },
    Event {
        code: "leaves_valid_path",
        what: "wraps a sheave or drum beyond the valid angle, or two neighbouring places of its path overlap",
        crossing: Crossing::Falling,
    },
    Event {
        code: "paid_out_to_innermost_layer",
        what: "is paid out to the innermost layer of its drum",
        crossing: Crossing::Falling,
    },
    Event { code: "released", what: "is released", crossing: Crossing::Rising },
    Event { code: "hooked_on", what: "is hooked on", crossing: Crossing::Falling },
    Event { code: PARTING, what: "parts", crossing: Crossing::Rising },
];
const GOES_SLACK: usize = 0;
const COMES_TAUT: usize = 1;
const HAULED_IN: usize = 2;
const LEAVES_RANGE: usize = 3;
const INNERMOST_LAYER: usize = 4;
const IS_RELEASED: usize = 5;
const IS_HOOKED_ON: usize = 6;
const PARTS: usize = 7;
/// Code of the event and of the warning of a rope that reaches its breaking load.
pub const PARTING: &str = "parts";
/// Share of L at the start below which a rope counts as hauled in to its end. Below this length its stiffness stays
/// constant.
const SHORTEST: f64 = 1e-3;
/// Number of points through which the last leg is drawn.
const POINTS_OF_LAST_LEG: usize = 17;

impl<S: Scalar> Element<S> for Rope<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number = |variable, description, unit| Output::number(variable, description, "rope", &self.name, unit);
        let leads = [
            number(
                "rope_offlead",
                "offlead of a rope: its angle to the vertical in the plane of the boom, positive outward",
                &["rad"],
            ),
            number(
                "rope_sidelead",
                "sidelead of a rope: its angle to the plane of the boom, positive along the sheave's axis",
                &["rad"],
            ),
        ];
        let leads = leads.into_iter().filter(|_| self.path.has_leads());
        let amplification = self.carries.as_ref().map(|_| {
            let what =
                "dynamic amplification factor of a rope: its tension over its tension with the load at rest in air";
            number("rope_daf", what, &["1"])
        });
        let points = 2 * self.path.stations().len().saturating_sub(2) + POINTS_OF_LAST_LEG;
        let holds = self.inextensible.is_some();
        Declaration {
            holds: usize::from(holds),
            goes_alone: holds,
            modes: vec!["condition".to_owned()],
            numbers: vec!["snaps".to_owned()],
            inputs: self.lever().into_iter().collect(),
            outputs: [
                number("rope_tension", "tension of a rope at its last end", &["N"]),
                number("rope_first_tension", "tension of a rope at its first end, or its drum", &["N"]),
                number(
                    "rope_length",
                    "unstretched length of a rope between its ends, or from its drum to its end",
                    &["m"],
                ),
                number("rope_pay_out_rate", "rate at which a drum pays out rope", &["m/s"]),
                number(
                    "rope_stretch",
                    "length of a rope's path beyond its unstretched length; negative: slack",
                    &["m"],
                ),
                number("rope_snaps", "times that a rope came taut after it was slack", &["1"]),
            ]
            .into_iter()
            .chain(leads)
            .chain(amplification)
            .chain(self.load_chart.iter().flat_map(|_| LoadChart::<S>::outputs(&self.name)))
            .collect(),
            lines: vec![DrawnLine::thin(&self.name, LineStyle::Line, points)],
            events: EVENTS[..if self.breaking_load.is_some() { PARTS + 1 } else { PARTS }].to_vec(),
            ..Declaration::default()
        }
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        own.numbers[0] = S::ZERO;
        self.hang(at, own);
    }

    fn renew(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        if own.modes[0] == PARTED {
            return;
        }
        if let Some(mode) = self.hook_or_release(at, own) {
            own.modes[0] = mode;
            return;
        }
        self.hang(at, own);
        if own.modes[0] == TAUT {
            self.pull_or_part(at, own);
        }
    }

    /// Adds the forces at all stations, the torque on the drum, and the heat.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let now = self.stretched(at);
        self.weigh(at, &now, loads);
        if self.inextensible.is_some() {
            return;
        }
        let [first, mut power] = self.path.pull(now.tension, now.rate, |station, wrench| {
            loads.wrenches.extend(station.on_body(at, wrench));
        });
        if let Some(drum) = &self.drum {
            let held = first * self.path.ratio_at_drum(now.paid_out.rate) + now.carried;
            loads.force[drum.coordinate] += now.paid_out.per_angle * held;
            power += now.paid_out.rate * held;
        }
        let stored = now.elastic * now.rate - now.carried * now.paid_out.rate;
        loads.power.dissipated += -(power + stored);
    }

    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let now = self.stretched(at);
        self.energy_of_weight(at, &now) + now.elastic * now.stretch * S::constant(0.5)
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let now = self.stretched(at);
        let ([first, last], _) = self.tensions(at, &now);
        out.extend([last, first, now.unstretched, now.paid_out.rate, now.stretch]);
        out.push(at.numbers.first().copied().unwrap_or(S::ZERO));
        out.extend(self.path.leads().into_iter().flatten());
        let of_rest = |weight: S| weight.select_below(f64::MIN_POSITIVE, || S::ZERO, || last / weight);
        out.extend(self.carries.as_ref().map(|load| of_rest(load.mass_on_a_fall * at.world.gravity)));
        out.extend(self.on_chart(at, &now).into_iter().flatten());
    }

    fn left_out(&mut self, at: &Context<'_, S>, loads: &Loads<S>) -> Option<String> {
        self.inertia_left_out(at, loads)
    }

    fn watchers(&self) -> Vec<AnyWatcher> {
        self.load_chart.iter().map(|chart| chart.watcher(&self.name)).collect()
    }

    fn event_indicators(&mut self, at: &Context<'_, S>, values: &mut [S]) {
        let now = self.stretched(at);
        let (mode, pull) = (self.condition(at), self.pull_length(&now));
        let holds = self.inextensible.is_some();
        let of_event = |event| match (event, self.breaking_load) {
            (GOES_SLACK, _) if mode == TAUT && holds => now.tension,
            (COMES_TAUT, _) if mode == SLACK && holds => now.stretch - S::constant(ROUNDING_M),
            (GOES_SLACK, _) if mode == TAUT => pull + S::constant(ROUNDING_M),
            (GOES_SLACK | COMES_TAUT, _) if mode == BY_STRETCH => pull,
            (GOES_SLACK, _) => S::ONE,
            (COMES_TAUT, _) if mode == SLACK => pull,
            (HAULED_IN, _) => now.unstretched - self.shortest(),
            (LEAVES_RANGE, _) => now.range_left,
            (INNERMOST_LAYER, _) => now.paid_out.left,
            (IS_HOOKED_ON, _) if mode == RELEASED => self.out_of_reach(at, now.stretch),
            (IS_HOOKED_ON, _) => S::ONE,
            (PARTS, Some(load)) if !is_off(mode) => self.tensions(at, &now).1 - load,
            _ => -S::ONE,
        };
        values.iter_mut().enumerate().for_each(|(event, value)| *value = of_event(event));
    }

    fn handle_event(&mut self, event: usize, at: &Context<'_, S>, own: &mut ElementState<'_, S>, _v: &mut [S]) {
        match event {
            GOES_SLACK => own.modes[0] = SLACK,
            COMES_TAUT => {
                own.numbers[0] += S::ONE;
                self.pull_or_part(at, own);
            }
            IS_HOOKED_ON => own.modes[0] = SLACK,
            PARTS => own.modes[0] = PARTED,
            _ => {}
        }
    }

    /// Draws the legs: straight, except for the last leg of a slack rope, which sags. A flat parabola that is longer
    /// than its chord d by e has the sag sqrt(3/8 d e).
    fn draw(&mut self, at: &Context<'_, S>, points: &mut Vec<S>) {
        let now = self.stretched(at);
        let last = self.path.stations().len().saturating_sub(2);
        let slack = now.stretch.select_below(0.0, || -now.stretch, || S::ZERO);
        for (k, [from, to]) in self.path.straights().enumerate() {
            if k < last {
                points.extend(from.0.into_iter().chain(to.0));
                continue;
            }
            let way = if is_off(self.condition(at)) { Vector3::zero() } else { to - from };
            let sag = (S::constant(0.375) * way.norm() * slack).sqrt();
            for i in 0..POINTS_OF_LAST_LEG {
                let share = S::constant(i as f64 / (POINTS_OF_LAST_LEG - 1) as f64);
                let point = from + way * share;
                points.extend([point[0], point[1], point[2] - S::constant(4.0) * share * (S::ONE - share) * sag]);
            }
        }
    }

    fn supports(&self) -> Vec<Support> {
        let legs = self.path.attached_bodies();
        let station = legs.iter().find(|[first, second]| first != second).copied().map(Support::Station);
        legs.into_iter().map(Support::Carries).chain(station).collect()
    }

    fn present_supports(&mut self, at: &Context<'_, S>) -> Vec<PresentSupport<S>> {
        if self.tension_here(at).value() <= 0.0 {
            return Vec::new();
        }
        let legs = self.path.stations().windows(2);
        legs.map(|ends| PresentSupport::Line([ends[0].centre, ends[1].centre])).collect()
    }

    fn holding(&self) -> Option<&dyn Holding<S>> {
        self.inextensible.is_some().then_some(self)
    }

    fn holding_mut(&mut self) -> Option<&mut dyn Holding<S>> {
        self.inextensible.is_some().then_some(self)
    }
}
