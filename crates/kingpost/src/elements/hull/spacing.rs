//! The place of one hull relative to another, against the place in their database.

use super::Plan;
use crate::elements::watcher::{Exceeded, Warning, Watcher, significant};

/// Share of the gap between two hulls by which their mean distance may differ from that of the data: the resonance of the
/// water in the gap moves with its width.
const LARGEST_SHARE_OF_GAP: f64 = 0.25;
/// Share of the longer hull by which it may differ however wide the gap is: a wave as long as the hull is then 22 degrees out
/// of phase.
const LARGEST_SHARE_OF_LENGTH: f64 = 1.0 / 16.0;
/// Difference of their mean relative heading beyond which a run warns, degrees.
const LARGEST_TURN_DEG: f64 = 5.0;

/// A hull's origin on its body and its place in the database.
#[derive(Clone, Debug)]
pub struct SpacedHull {
    /// The body.
    pub body: String,
    /// The rectangle around its waterline.
    pub plan: Plan,
    /// The data's origin from the body's centre of mass, body axes, m.
    pub origin_m: [f64; 3],
    /// x, y (m) and heading (rad) in the common frame of the database.
    pub place: [f64; 3],
}

/// Watches the mean place of the second of two hulls relative to the first.
///
/// ```
/// use kingpost::elements::Watcher;
/// use kingpost::elements::hull::{HullSpacing, Plan, SpacedHull};
/// let plan = Plan { along: [-50.0, 50.0], across: [-10.0, 10.0] };
/// let hull = |body: &str, y: f64| SpacedHull { body: body.into(), plan, origin_m: [0.0; 3], place: [0.0, y, 0.0] };
/// let mut watcher = HullSpacing::new([hull("ship", 0.0), hull("barge", 24.0)]);
/// watcher.see(0.0, &[5.0, 0.0, 0.0, 5.0, 26.0, 0.0]);
/// assert!(watcher.warnings()[0].text.contains("2 m from the place"));
/// ```
#[derive(Clone, Debug)]
pub struct HullSpacing {
    hulls: [SpacedHull; 2],
    rows: u64,
    /// Sums of the differences along and across the first hull, m, and in heading, rad.
    sums: [f64; 3],
    last_s: f64,
}

impl HullSpacing {
    /// Returns the watcher of two hulls.
    pub fn new(hulls: [SpacedHull; 2]) -> Self {
        Self { hulls, rows: 0, sums: [0.0; 3], last_s: 0.0 }
    }

    /// Returns the largest difference of the mean distance without a warning, m.
    fn bound_m(&self) -> f64 {
        let [first, second] = &self.hulls;
        let at = |hull: &SpacedHull| {
            let ([x, y, heading], [u, v, _]) = (hull.place, hull.origin_m);
            let (sin, cos) = libm::sincos(heading);
            // The plan is about the centre of mass.
            [x - cos * u + sin * v, y - sin * u - cos * v, heading]
        };
        let gap = first.plan.distance_to(at(first), &second.plan, at(second));
        let length = first.plan.length().max(second.plan.length());
        let of_length = LARGEST_SHARE_OF_LENGTH * length;
        // Rectangles around hulls that reach around each other overlap.
        if gap > 0.0 { of_length.min(LARGEST_SHARE_OF_GAP * gap) } else { of_length }
    }
}

/// Returns the second place in the axes of the first.
fn relative([x, y, heading]: [f64; 3], [other_x, other_y, other_heading]: [f64; 3]) -> [f64; 3] {
    let ((sin, cos), [dx, dy]) = (libm::sincos(heading), [other_x - x, other_y - y]);
    [cos * dx + sin * dy, cos * dy - sin * dx, other_heading - heading]
}

impl Watcher for HullSpacing {
    fn columns(&self) -> Vec<String> {
        let of =
            |hull: &SpacedHull| ["position.x", "position.y", "yaw"].map(|column| format!("{}.{column}", hull.body));
        self.hulls.iter().flat_map(of).collect()
    }

    fn see(&mut self, time_s: f64, values: &[f64]) {
        let [first, second] = values.as_chunks::<3>().0 else { return };
        let at = |hull: &SpacedHull, [x, y, yaw]: [f64; 3]| {
            let ((sin, cos), [u, v, _]) = (libm::sincos(yaw), hull.origin_m);
            [x + cos * u - sin * v, y + sin * u + cos * v, yaw]
        };
        let now = relative(at(&self.hulls[0], *first), at(&self.hulls[1], *second));
        let of_data = relative(self.hulls[0].place, self.hulls[1].place);
        let turn = now[2] - of_data[2];
        let turn = libm::atan2(libm::sin(turn), libm::cos(turn));
        self.sums[0] += now[0] - of_data[0];
        self.sums[1] += now[1] - of_data[1];
        self.sums[2] += turn;
        (self.rows, self.last_s) = (self.rows + 1, time_s);
    }

    fn warnings(&self) -> Vec<Warning> {
        if self.rows == 0 {
            return Vec::new();
        }
        let [along, across, turn] = self.sums.map(|sum| sum / self.rows as f64);
        let [SpacedHull { body, .. }, SpacedHull { body: other, .. }] = &self.hulls;
        let (off_m, bound_m, turn_deg) = (libm::hypot(along, across), self.bound_m(), turn.to_degrees());
        let distance = (off_m > bound_m).then(|| {
            let text = format!(
                "was on average {} m from the place relative to {other} for which their database was made, which holds for {} m: \
                 shelter, gap resonance and phases are those of the other place; kingpost hydro with --at computes them for this one",
                significant(off_m, 3),
                significant(bound_m, 2)
            );
            let numbers = Exceeded { value: off_m, bound: bound_m, unit: "m" };
            Warning::exceeded("hull_off_data_place", self.last_s, body, numbers, text)
        });
        let heading = (turn_deg.abs() > LARGEST_TURN_DEG).then(|| {
            let text = format!(
                "was on average turned by {turn_deg:.1} deg relative to {other} from the heading for which their database was made \
                 (warned of beyond {LARGEST_TURN_DEG} deg)"
            );
            let numbers = Exceeded { value: turn_deg, bound: LARGEST_TURN_DEG, unit: "deg" };
            Warning::exceeded("hull_off_data_heading", self.last_s, body, numbers, text)
        });
        distance.into_iter().chain(heading).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Origins off the centres of mass: the places of the data are those of the origins, in any common frame.
    #[test]
    fn hulls_at_the_place_of_their_data_are_not_warned_of() {
        let plan = Plan { along: [-10.0, 10.0], across: [-5.0, 5.0] };
        let hull =
            |body: &str, origin_m: [f64; 3], place: [f64; 3]| SpacedHull { body: body.into(), plan, origin_m, place };
        let (first, second) = ([2.0, -1.0, 0.0], [-3.0, 0.5, 0.0]);
        let mut watcher =
            HullSpacing::new([hull("ship", first, [4.0, 5.0, 0.3]), hull("barge", second, [1.0, 20.0, 2.0])]);
        // The common frame of the data turned by 1.1 rad and moved by (7, -2); bodies at their centres of mass.
        let centre = |[x, y, heading]: [f64; 3], origin: [f64; 3]| {
            let ((sin, cos), yaw) = (libm::sincos(1.1), heading + 1.1);
            let at = [7.0 + cos * x - sin * y, -2.0 + sin * x + cos * y];
            let (sin, cos) = libm::sincos(yaw);
            [at[0] - cos * origin[0] + sin * origin[1], at[1] - sin * origin[0] - cos * origin[1], yaw]
        };
        let [one, other] = [centre([4.0, 5.0, 0.3], first), centre([1.0, 20.0, 2.0], second)];
        watcher.see(0.0, &[one, other].concat());
        assert!(watcher.sums.iter().all(|sum| sum.abs() < 1e-13), "{:?}", watcher.sums);
        assert!(watcher.warnings().is_empty());
        watcher.see(1.0, &[one, [other[0] + 8.0, other[1], other[2] + 0.4]].concat());
        let codes: Vec<&str> = watcher.warnings().iter().map(|warning| warning.code).collect();
        assert_eq!(codes, ["hull_off_data_place", "hull_off_data_heading"]);
    }
}
