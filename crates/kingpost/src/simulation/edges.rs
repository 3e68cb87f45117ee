//! Times at which steps end, because a law changes its form there.

use crate::elements::drives::Drive;
use crate::integrate::Interval;
use crate::scalar::Scalar;

/// Edges of all drives, s, in order.
#[derive(Clone, Debug)]
pub(super) struct Edges {
    times_s: Vec<f64>,
    /// Edges closer than this to the end of an interval fall on it, s.
    slack_s: f64,
}

impl Edges {
    pub(super) fn new<S: Scalar>(drives: &[Drive<S>], step_s: f64) -> Self {
        let mut times_s: Vec<f64> = drives.iter().flat_map(|drive| drive.edges()).copied().collect();
        times_s.sort_by(f64::total_cmp);
        times_s.dedup();
        Self { times_s, slack_s: 1e-9 * step_s }
    }

    /// From a time to the next edge, or to `end_s` where there is none before.
    pub(super) fn interval(&self, start_s: f64, end_s: f64) -> Interval {
        Interval { start_s, end_s: self.next(start_s, end_s).min(end_s) }
    }

    /// The next edge after a time, s; infinite where there is none. One that is close to `end_s`
    /// falls on it.
    pub(super) fn next(&self, start_s: f64, end_s: f64) -> f64 {
        let first = self.times_s.partition_point(|&edge| edge <= start_s + self.slack_s);
        match self.times_s.get(first) {
            Some(&edge) if (edge - end_s).abs() <= self.slack_s => end_s,
            Some(&edge) => edge,
            None => f64::INFINITY,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::drives::{Motor, Profile, Pulse};

    #[test]
    fn intervals_end_at_edges_and_rounding_makes_none() {
        let profile = Profile::pulse(Pulse { start_s: 0.0, rise_s: 0.1, hold_s: 0.2, reverse_s: 0.0 });
        let motor = Drive::Motor(Motor { coordinate: 0, effort: 1.0, profile, input: None });
        let edges = Edges::new(&[motor], 0.08);
        assert_eq!(edges.interval(0.08, 0.16), Interval { start_s: 0.08, end_s: 0.1 });
        assert_eq!(edges.interval(0.1, 0.16), Interval { start_s: 0.1, end_s: 0.16 });
        assert_eq!(edges.interval(0.02, 0.1 + 1e-12).end_s, 0.1 + 1e-12);
        assert_eq!(edges.interval(5.0, 5.08).end_s, 5.08);
        assert_eq!(edges.next(0.0, 0.08), 0.1);
        assert_eq!(edges.next(0.02, 0.1 + 1e-12), 0.1 + 1e-12);
        assert_eq!(edges.next(5.0, 5.08), f64::INFINITY);
    }
}
