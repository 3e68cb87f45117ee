//! Warns of a hull outside the range of linear hydrodynamics: small angles, small heave, a dry deck.

use crate::elements::watcher::{Exceeded, Extreme, Warning, Watcher, significant};

/// Heel or trim beyond which a run warns, degrees.
const LARGEST_ANGLE_DEG: f64 = 20.0;
/// Heave beyond which a run warns, as a share of the draught.
const LARGEST_HEAVE: f64 = 0.5;
/// Share of the hull's height below its top within which points belong to the deck edge.
const DECK: f64 = 1e-3;

/// Watches a hull with linear hydrodynamics.
#[derive(Clone, Debug)]
pub struct LinearLimits {
    body: String,
    draught_m: f64,
    /// The edge of the deck from the body's centre of mass, body axes, m.
    deck_m: Vec<[f64; 3]>,
    start_m: Option<f64>,
    heel_deg: Extreme,
    trim_deg: Extreme,
    rise_m: Extreme,
    /// Largest depth of the deck's edge under still water, m, and the time when it first went under.
    under_m: f64,
    under_since_s: Option<f64>,
}

impl LinearLimits {
    /// Returns the watcher of a body with data for a draught (m). The hull's points are relative to the centre of mass
    /// in body axes, m; there are none if the data have no mesh.
    pub fn new(body: &str, draught_m: f64, points_m: &[[f64; 3]]) -> Self {
        let heights = || points_m.iter().map(|point| point[2]);
        let (top, bottom) = (heights().fold(f64::NEG_INFINITY, f64::max), heights().fold(f64::INFINITY, f64::min));
        let is_on_edge = |point: &&[f64; 3]| point[2] > top - DECK * (top - bottom);
        Self {
            body: body.to_owned(),
            draught_m,
            deck_m: points_m.iter().filter(is_on_edge).copied().collect(),
            start_m: None,
            heel_deg: Extreme::default(),
            trim_deg: Extreme::default(),
            rise_m: Extreme::default(),
            under_m: 0.0,
            under_since_s: None,
        }
    }

    fn of_angle(&self, code: &'static str, verb: &str, angle: Extreme) -> Option<Warning> {
        let Extreme { value, time_s } = angle;
        let text = || {
            format!(
                "it {verb} to {value:.2} deg, at {} s: linear hydrodynamics are for small angles (warned of beyond \
                 {LARGEST_ANGLE_DEG} deg)",
                significant(time_s, 6)
            )
        };
        let numbers = Exceeded { value, bound: LARGEST_ANGLE_DEG, unit: "deg" };
        (value.abs() > LARGEST_ANGLE_DEG).then(|| Warning::exceeded(code, time_s, &self.body, numbers, text()))
    }

    fn of_heave(&self) -> Option<Warning> {
        let Extreme { value, time_s } = self.rise_m;
        let text = || {
            format!(
                "it {} by {:.2} m, at {} s: linear hydrodynamics are for heave much smaller than the draught, {} m (warned of beyond half)",
                if value > 0.0 { "rose" } else { "sank" },
                value.abs(),
                significant(time_s, 6),
                significant(self.draught_m, 6)
            )
        };
        let numbers = Exceeded { value, bound: LARGEST_HEAVE * self.draught_m, unit: "m" };
        let beyond = value.abs() > numbers.bound;
        beyond.then(|| Warning::exceeded("large_heave", time_s, &self.body, numbers, text()))
    }

    fn of_deck(&self) -> Option<Warning> {
        self.under_since_s.map(|time_s| {
            let text = format!(
                "the edge of its deck went {:.2} m under still water, first at {} s: linear hydrostatics do not model the deck; hydrostatics: mesh does",
                self.under_m,
                significant(time_s, 6)
            );
            let numbers = Exceeded { value: self.under_m, bound: 0.0, unit: "m" };
            Warning::exceeded("deck_edge_under_water", time_s, &self.body, numbers, text)
        })
    }
}

impl Watcher for LinearLimits {
    fn columns(&self) -> Vec<String> {
        ["roll", "pitch", "position.z"].map(|column| format!("{}.{column}", self.body)).to_vec()
    }

    fn see(&mut self, time_s: f64, values: &[f64]) {
        let [roll, pitch, z] = [values[0], values[1], values[2]];
        self.heel_deg.see(time_s, roll.to_degrees());
        self.trim_deg.see(time_s, pitch.to_degrees());
        self.rise_m.see(time_s, z - *self.start_m.get_or_insert(z));
        let ((sin_roll, cos_roll), (sin_pitch, cos_pitch)) = (libm::sincos(roll), libm::sincos(pitch));
        let up = [-sin_pitch, cos_pitch * sin_roll, cos_pitch * cos_roll];
        let height = |point: &[f64; 3]| z + up.iter().zip(point).map(|(up, x)| up * x).sum::<f64>();
        let lowest = self.deck_m.iter().map(height).fold(f64::INFINITY, f64::min);
        if lowest < 0.0 {
            self.under_m = self.under_m.max(-lowest);
            self.under_since_s = self.under_since_s.or(Some(time_s));
        }
    }

    fn warnings(&self) -> Vec<Warning> {
        let angles = [
            self.of_angle("large_heel", "heeled", self.heel_deg),
            self.of_angle("large_trim", "trimmed", self.trim_deg),
        ];
        angles.into_iter().chain([self.of_heave(), self.of_deck()]).flatten().collect()
    }
}
