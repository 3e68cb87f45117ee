//! The load chart of a crane: its rated load at each radius.

use super::stretch::Stretched;
use super::{Rope, RopePath};
use crate::elements::lines::place;
use crate::elements::watcher::{Exceeded, Extreme, Warning, Watcher, significant};
use crate::elements::{AnyWatcher, Context, Output};
use crate::model::Attachment;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// Rated loads over the radius, compared with the load on a hoisting rope.
///
/// The radius is the distance from the slewing axis to the point where the rope leaves the crane, m. The rated load is
/// linear between the radii of the chart and constant outside; a [watcher](LoadChart::watcher) warns of a radius
/// outside the chart. The hook load is the force of the rope on the load over the acceleration of free fall, kg, as a
/// load indicator shows it: it contains hook block, slings and dynamic effects. (The rated capacity, the hook load and
/// the radius of EN 13852-1.)
#[derive(Clone, Debug)]
pub struct LoadChart<S = f64> {
    /// A point of the slewing axis, on the body that carries the joint.
    pub centre: Attachment<S>,
    /// Unit vector along the slewing axis, in the axes of that body.
    pub axis: Vector3<S>,
    /// Increasing radii, m; at least two.
    pub radii: Vec<f64>,
    /// Rated load at each radius, kg, above 0.
    pub rated_loads: Vec<S>,
}

impl<S: Scalar> LoadChart<S> {
    /// Returns the outputs of a rope with this name and a chart: radius, rated load, hook load, utilisation.
    pub(super) fn outputs(name: &str) -> [Output; 4] {
        let number = |variable, description, unit| Output::number(variable, description, "rope", name, unit);
        [
            number("load_radius", "radius of a crane: from its slewing axis to where the rope leaves it", &["m"]),
            number("rated_load", "rated load of a crane, by its load chart at the radius", &["kg"]),
            number("hook_load", "hook load of a crane: pull of its rope over the acceleration of free fall", &["kg"]),
            number("load_utilisation", "utilisation of a crane: its hook load over its rated load", &["1"]),
        ]
    }

    /// Returns the distance of a point (world, m) from the slewing axis, m.
    fn radius(&self, at: &Context<'_, S>, point: Vector3<S>) -> S {
        let axis = self.centre.body.map_or(self.axis, |body| at.links.body_frame(at.model, body).rotation * self.axis);
        let way = point - place(&self.centre, at.model, at.links);
        let across = way - axis * axis.dot(way);
        // At 0 the square root has no derivative.
        (across.norm_squared() + S::constant(f64::MIN_POSITIVE)).sqrt()
    }

    /// Returns the rated load, kg, at a radius, m.
    pub fn rated_load(&self, radius: S) -> S {
        let rows = self.radii.windows(2).zip(self.rated_loads.windows(2));
        rows.fold(self.rated_loads[0], |sum, (radii, loads)| {
            let width = S::constant(radii[1] - radii[0]);
            let covered = (radius - S::constant(radii[0])).clipped(S::ZERO, width);
            sum + (loads[1] - loads[0]) * (covered / width)
        })
    }

    /// Returns the watcher that warns of a load beyond the chart of the rope with this name.
    pub(super) fn watcher(&self, name: &str) -> AnyWatcher {
        let ends_m = [self.radii[0], self.radii[self.radii.len() - 1]];
        let (load, outside_m) = (Extreme::default(), Extreme::default());
        Box::new(ChartWatcher { rope: name.to_owned(), ends_m, load, load_since_s: None, outside_m, radius_m: 0.0 })
    }
}

impl<S: Scalar> Rope<S> {
    /// Returns radius, rated load, hook load and utilisation, if the rope has a chart; the path has been evaluated at
    /// the present positions.
    pub(super) fn on_chart(&self, at: &Context<'_, S>, now: &Stretched<S>) -> Option<[S; 4]> {
        let chart = self.load_chart.as_ref()?;
        let radius = chart.radius(at, self.path.leaves_crane_at()?);
        let rated = chart.rated_load(radius);
        let (square, gravity) = (self.pull_on_load(at, now).norm_squared(), at.world.gravity);
        // For a slack rope the square root has no derivative.
        let pull = || square.select_below(f64::MIN_POSITIVE, || S::ONE, || square).sqrt();
        let weighs = square.select_below(f64::MIN_POSITIVE, || S::ZERO, pull);
        let hook = gravity.select_below(f64::MIN_POSITIVE, || S::ZERO, || weighs / gravity);
        Some([radius, rated, hook, hook / rated])
    }

    /// Returns the sum of the rope's forces on the body at the lower end of the leg between crane and load, world, N.
    fn pull_on_load(&self, at: &Context<'_, S>, now: &Stretched<S>) -> Vector3<S> {
        let Some(load) = self.path.load() else { return Vector3::zero() };
        let mut sum = Vector3::zero();
        self.path.pull(now.tension, now.rate, |station, wrench| {
            if station.centre.body == load {
                sum += wrench.force;
            }
        });
        self.weight_on_stations(at, now, |station, wrench| {
            if station.centre.body == load {
                sum += wrench.force;
            }
        });
        sum
    }
}

impl<S: Scalar> RopePath<S> {
    /// Returns the point where the rope leaves the crane, world, m; the path has been evaluated at the present
    /// positions.
    fn leaves_crane_at(&self) -> Option<Vector3<S>> {
        let (leg, runs_up) = self.leaving_leg()?;
        Some(self.straights().nth(leg)?[usize::from(runs_up)])
    }

    /// Returns the body at the load's end of the leg between crane and load; `Some(None)` is the world.
    pub(super) fn load(&self) -> Option<Option<usize>> {
        let (leg, runs_up) = self.leaving_leg()?;
        Some(self.stations()[leg + usize::from(!runs_up)].centre.body)
    }
}

/// Compares a load with its chart in every row.
#[derive(Clone, Debug)]
struct ChartWatcher {
    rope: String,
    /// First and last radius of the chart, m.
    ends_m: [f64; 2],
    /// The largest utilisation.
    load: Extreme,
    /// Time at which it first exceeded 1, s.
    load_since_s: Option<f64>,
    /// Largest distance of the radius from the chart's range, m, and that radius.
    outside_m: Extreme,
    radius_m: f64,
}

impl Watcher for ChartWatcher {
    fn columns(&self) -> Vec<String> {
        ["load_utilisation", "load_radius"].map(|variable| format!("{}.{variable}", self.rope)).to_vec()
    }

    fn see(&mut self, time_s: f64, values: &[f64]) {
        let (utilisation, radius_m) = (values[0], values[1]);
        self.load.see(time_s, utilisation);
        if utilisation > 1.0 {
            self.load_since_s = self.load_since_s.or(Some(time_s));
        }
        let [first, last] = self.ends_m;
        let outside_m = (radius_m - last).max(first - radius_m).max(0.0);
        if outside_m > self.outside_m.value {
            self.outside_m.see(time_s, outside_m);
            self.radius_m = radius_m;
        }
    }

    fn warnings(&self) -> Vec<Warning> {
        let warning = |code, time_s, numbers, text| Warning::exceeded(code, time_s, &self.rope, numbers, text);
        let load = self.load_since_s.map(|since_s| {
            let text = format!(
                "its hook load was {} % of the rated load at {} s, beyond the load chart first at {} s",
                significant(self.load.value * 100.0, 4),
                significant(self.load.time_s, 6),
                significant(since_s, 6)
            );
            let numbers = Exceeded { value: self.load.value, bound: 1.0, unit: "1" };
            warning("load_beyond_chart", since_s, numbers, text)
        });
        let outside = (self.outside_m.value > 0.0).then(|| {
            let text = format!(
                "its load was at a radius of {} m, outside of the load chart, which is for {} to {} m: the rated load was taken \
                 as that at the end of the chart",
                significant(self.radius_m, 4),
                significant(self.ends_m[0], 6),
                significant(self.ends_m[1], 6)
            );
            let bound = self.radius_m.clamp(self.ends_m[0], self.ends_m[1]);
            let numbers = Exceeded { value: self.radius_m, bound, unit: "m" };
            warning("radius_outside_chart", self.outside_m.time_s, numbers, text)
        });
        load.into_iter().chain(outside).collect()
    }
}
