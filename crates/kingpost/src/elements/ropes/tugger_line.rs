//! A line whose winch sets its tension: tugger lines and tag lines.

use super::RopePath;
use crate::dynamics::Loads;
use crate::elements::{Context, Crossing, Declaration, DrawnLine, Element, Event, LineStyle, Output, Support};
use crate::scalar::Scalar;

/// A line over a [`RopePath`] whose winch, at its first end, pays out and hauls in so that the tension T at its last
/// end depends only on the rate of the path's length l:
///
/// ```text
/// T = T_0 + c l',   0 <= T <= T_max
/// ```
///
/// With c = 0 the tension is constant at any speed of the load; with c > 0 the tension is higher while the winch pays
/// out than while it hauls in, which damps a swing. V = T_0 l; all other work is the winch's. Friction acts at the
/// sheaves.
#[derive(Clone, Debug)]
pub struct TuggerLine<S = f64> {
    /// Name in the results.
    pub name: String,
    /// Its path, without a drum.
    pub path: RopePath<S>,
    /// T_0, N.
    pub tension: S,
    /// c, N s/m.
    pub damping: S,
    /// T_max, N; `None` for no limit.
    pub largest: Option<S>,
}

const LEAVES_RANGE: Event = Event {
    code: "leaves_valid_path",
    what: "wraps a sheave beyond the valid angle, or two neighbouring places of its path overlap",
    crossing: Crossing::Falling,
};

impl<S: Scalar> Element<S> for TuggerLine<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let number =
            |variable, description, unit| Output::number(variable, description, "tugger_line", &self.name, unit);
        let points = 2 * (self.path.stations().len() - 1);
        Declaration {
            outputs: vec![
                number("winch_tension", "tension of a tugger line at its winch", &["N"]),
                number("tugger_length", "length of a tugger line from its winch to its end", &["m"]),
                number("tugger_pay_out_rate", "rate at which the winch of a tugger line pays out", &["m/s"]),
            ],
            lines: vec![DrawnLine::thin(&self.name, LineStyle::Line, points)],
            events: vec![LEAVES_RANGE],
            ..Declaration::default()
        }
    }

    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let rate = self.path.extent(at).rate;
        let [at_winch, power] = self.path.pull(self.tension_at(rate), S::ZERO, |station, wrench| {
            loads.wrenches.extend(station.on_body(at, wrench));
        });
        // V contains the work of T_0; the winch supplies the rest, the energy lost to friction included.
        let given = (self.tension - at_winch) * rate;
        loads.power.drives += given;
        loads.power.dissipated += given - (power + self.tension * rate);
    }

    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        self.tension * self.path.extent(at).length
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let extent = self.path.extent(at);
        let [at_winch, _] = self.path.pull(self.tension_at(extent.rate), S::ZERO, |_, _| {});
        out.extend([at_winch, extent.length, extent.rate]);
    }

    fn event_indicators(&mut self, at: &Context<'_, S>, values: &mut [S]) {
        values.fill(self.path.extent(at).range_left);
    }

    fn draw(&mut self, at: &Context<'_, S>, points: &mut Vec<S>) {
        self.path.extent(at);
        points.extend(self.path.straights().flatten().flat_map(|point| point.0));
    }

    fn supports(&self) -> Vec<Support> {
        self.path.attached_bodies().into_iter().map(Support::Carries).collect()
    }
}

impl<S: Scalar> TuggerLine<S> {
    /// Returns T at this rate of the path's length, N.
    fn tension_at(&self, rate: S) -> S {
        let tension = self.tension + self.damping * rate;
        let pulls = tension.select_below(0.0, || S::ZERO, || tension);
        self.largest.map_or(pulls, |largest| pulls.select_less(largest, || pulls, || largest))
    }
}
