//! The distance between two hulls without modelled hydrodynamic interaction.

use crate::elements::watcher::{Exceeded, Warning, Watcher, significant};
use crate::sea::database::HullAtRest;

/// The rectangle around a hull's waterline, body axes from the centre of mass, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// From stern to bow.
    pub along: [f64; 2],
    /// From starboard to port.
    pub across: [f64; 2],
}

impl Plan {
    /// Returns the rectangle of a hull with this origin on its body: waterline length and beam, about the centre of the
    /// waterplane.
    pub fn of(hull: &HullAtRest, origin: [f64; 3]) -> Self {
        let centre = hull.waterplane.first_moments_m3.map(|moment| moment / hull.waterplane.area_m2);
        let range = |k: usize, size: f64| [-0.5, 0.5].map(|half| origin[k] + centre[k] + half * size);
        Self { along: range(0, hull.length_m), across: range(1, hull.beam_m) }
    }

    /// Returns the length of the waterline, m.
    pub fn length(&self) -> f64 {
        self.along[1] - self.along[0]
    }

    /// Returns the distance to another rectangle, m, with each body at x and y with a heading (rad); 0 if they overlap.
    pub fn distance_to(&self, here: [f64; 3], other: &Self, there: [f64; 3]) -> f64 {
        distance(&self.corners(here), &other.corners(there))
    }

    /// Returns its corners in order, world, m, for a body at x and y with the heading `yaw`.
    fn corners(&self, [x, y, yaw]: [f64; 3]) -> [[f64; 2]; 4] {
        let (sin, cos) = libm::sincos(yaw);
        let [[stern, bow], [starboard, port]] = [self.along, self.across];
        [[bow, port], [stern, port], [stern, starboard], [bow, starboard]]
            .map(|[along, across]| [x + cos * along - sin * across, y + sin * along + cos * across])
    }
}

/// Watches two hulls that each have their own hydrodynamics, without interaction through the water.
///
/// ```
/// use kingpost::elements::Watcher;
/// use kingpost::elements::hull::{HullGap, Plan};
/// let plan = Plan { along: [-50.0, 50.0], across: [-10.0, 10.0] };
/// let mut watcher = HullGap::new([("ship", plan), ("barge", plan)]);
/// watcher.see(0.0, &[0.0, 0.0, 0.0, 0.0, 25.0, 0.0]);
/// assert!(watcher.warnings()[0].text.starts_with("comes as near as 5 m to barge"));
/// ```
#[derive(Clone, Debug)]
pub struct HullGap {
    hulls: [(String, Plan); 2],
    /// Smallest distance, m, and its time, s.
    least: Option<[f64; 2]>,
}

impl HullGap {
    /// Returns the watcher of two hulls.
    pub fn new(hulls: [(&str, Plan); 2]) -> Self {
        Self { hulls: hulls.map(|(body, plan)| (body.to_owned(), plan)), least: None }
    }
}

impl Watcher for HullGap {
    fn columns(&self) -> Vec<String> {
        let of =
            |(body, _): &(String, Plan)| ["position.x", "position.y", "yaw"].map(|column| format!("{body}.{column}"));
        self.hulls.iter().flat_map(of).collect()
    }

    fn see(&mut self, time_s: f64, values: &[f64]) {
        let [first, second] = values.as_chunks::<3>().0 else { return };
        let gap = self.hulls[0].1.distance_to(*first, &self.hulls[1].1, *second);
        if self.least.is_none_or(|[least, _]| gap < least) {
            self.least = Some([gap, time_s]);
        }
    }

    /// Returns a warning if the hulls come nearer than the length of the longer hull: at a larger distance they hardly
    /// interact.
    fn warnings(&self) -> Vec<Warning> {
        let [(body, own), (other, of_other)] = &self.hulls;
        let bound = own.length().max(of_other.length());
        let near = |[gap, _]: &[f64; 2]| *gap < bound;
        let Some([gap, time_s]) = self.least.filter(near) else { return Vec::new() };
        let how = if gap > 0.0 {
            format!("comes as near as {} m to {other}", significant(gap, 3))
        } else {
            format!(
                "lies across {other}: the rectangles around their waterlines overlap, and nothing keeps the hulls apart"
            )
        };
        let text = format!(
            "{how}; each hull has the hydrodynamics of a single hull: sheltering from waves and resonance of the water in the gap are not modelled"
        );
        let numbers = Exceeded { value: gap, bound, unit: "m" };
        vec![Warning::exceeded("hulls_without_interaction", time_s, body, numbers, text)]
    }
}

/// Returns the distance between two rectangles, m; 0 if they overlap.
fn distance(first: &[[f64; 2]; 4], second: &[[f64; 2]; 4]) -> f64 {
    let edges = |corners: &[[f64; 2]; 4]| -> [[[f64; 2]; 2]; 4] {
        core::array::from_fn(|k| [corners[k], corners[(k + 1) % 4]])
    };
    let both = [(edges(first), second), (edges(second), first)];
    let apart =
        both.iter().any(|(edges, others)| edges.iter().any(|edge| others.iter().all(|at| beyond(edge, at) > 0.0)));
    if !apart {
        return 0.0;
    }
    let pairs = both
        .iter()
        .flat_map(|(edges, others)| edges.iter().flat_map(move |edge| others.iter().map(move |at| to_edge(edge, at))));
    pairs.fold(f64::INFINITY, f64::min)
}

/// Returns the distance of a point outside an edge, for corners in counter-clockwise order, times the edge's length,
/// m^2.
fn beyond([from, to]: &[[f64; 2]; 2], at: &[f64; 2]) -> f64 {
    (to[1] - from[1]) * (at[0] - from[0]) - (to[0] - from[0]) * (at[1] - from[1])
}

/// Returns the distance from a point to an edge, m.
fn to_edge([from, to]: &[[f64; 2]; 2], at: &[f64; 2]) -> f64 {
    let (way, there) = ([to[0] - from[0], to[1] - from[1]], [at[0] - from[0], at[1] - from[1]]);
    let share = (way[0] * there[0] + way[1] * there[1]) / (way[0] * way[0] + way[1] * way[1]);
    let share = share.clamp(0.0, 1.0);
    libm::hypot(there[0] - share * way[0], there[1] - share * way[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: Plan = Plan { along: [-1.0, 1.0], across: [-1.0, 1.0] };

    fn gap(first: [f64; 3], second: [f64; 3]) -> f64 {
        distance(&SQUARE.corners(first), &SQUARE.corners(second))
    }

    #[test]
    fn squares_are_as_far_apart_as_their_nearest_points() {
        let root = core::f64::consts::SQRT_2;
        let eighth = core::f64::consts::FRAC_PI_4;
        for (second, expected) in [
            ([5.0, 0.0, 0.0], 3.0),           // edge to edge
            ([0.0, -5.0, 2.0 * eighth], 3.0), // the same, turned by 90 degrees
            ([4.0, 4.0, 0.0], 2.0 * root),    // corner to corner
            ([5.0, 0.0, eighth], 4.0 - root), // corner to edge
            ([1.5, 0.5, 0.3], 0.0),           // overlapping
            ([0.0, 0.0, eighth], 0.0),        // one across the other
        ] {
            assert!((gap([0.0; 3], second) - expected).abs() < 1e-14, "{second:?}");
            assert!((gap(second, [0.0; 3]) - expected).abs() < 1e-14, "{second:?}");
        }
    }
}
