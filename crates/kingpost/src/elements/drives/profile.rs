//! Histories: a number from -1 to 1 over time, piecewise linear.

use crate::dynamics::Clock;

/// A pulse: up, hold, through zero to the reverse, hold, and back to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulse {
    /// Time of a ramp between zero and full, s; the way from full to full reverse takes two.
    pub rise_s: f64,
    /// Time at full, s.
    pub hold_s: f64,
    /// Time at full reverse, s.
    pub reverse_s: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    start_s: f64,
    start: f64,
    slope_per_s: f64,
}

/// A piecewise linear history.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// In order of time; the first begins at 0, each ends where the next begins.
    pieces: Vec<Piece>,
    edges: Vec<f64>,
}

impl Profile {
    /// One, always: the motor as the paper switches it on.
    pub fn constant() -> Self {
        Self { pieces: vec![Piece { start_s: 0.0, start: 1.0, slope_per_s: 0.0 }], edges: Vec::new() }
    }

    /// A pulse from time 0.
    pub fn pulse(pulse: Pulse) -> Self {
        let Pulse { rise_s, hold_s, reverse_s } = pulse;
        let stretches = [
            (rise_s, 0.0, 1.0),
            (hold_s, 1.0, 1.0),
            (2.0 * rise_s, 1.0, -1.0),
            (reverse_s, -1.0, -1.0),
            (rise_s, -1.0, 0.0),
        ];
        let (mut pieces, mut time) = (Vec::new(), 0.0);
        for (length_s, start, end) in stretches {
            if length_s > 0.0 {
                pieces.push(Piece { start_s: time, start, slope_per_s: (end - start) / length_s });
                time += length_s;
            }
        }
        pieces.push(Piece { start_s: time, start: 0.0, slope_per_s: 0.0 });
        let edges = pieces.iter().map(|p| p.start_s).filter(|&t| t > 0.0).collect();
        Self { pieces, edges }
    }

    fn piece(&self, clock: Clock) -> &Piece {
        let after = self.pieces.partition_point(|p| p.start_s <= clock.middle_s);
        &self.pieces[after.max(1) - 1]
    }

    /// The value.
    pub fn value(&self, clock: Clock) -> f64 {
        let piece = self.piece(clock);
        piece.start + piece.slope_per_s * (clock.time_s - piece.start_s)
    }

    /// Its rate, 1/s.
    pub fn slope_per_s(&self, clock: Clock) -> f64 {
        self.piece(clock).slope_per_s
    }

    /// The first edge after a time, s; infinite where there is none.
    pub fn next_edge_s(&self, after_s: f64) -> f64 {
        let first = self.edges.partition_point(|&edge| edge <= after_s);
        self.edges.get(first).copied().unwrap_or(f64::INFINITY)
    }

    /// Where one piece ends and the next begins, s, in order.
    pub fn edges(&self) -> &[f64] {
        &self.edges
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(time_s: f64) -> Clock {
        Clock { time_s, middle_s: time_s + 1e-9 }
    }

    #[test]
    fn a_pulse_rises_holds_reverses_and_rests() {
        let profile = Profile::pulse(Pulse { rise_s: 0.25, hold_s: 0.5, reverse_s: 0.5 });
        let points = [
            (0.0, 0.0),
            (0.125, 0.5),
            (0.25, 1.0),
            (0.7, 1.0),
            (1.0, 0.0),
            (1.25, -1.0),
            (1.6, -1.0),
            (1.875, -0.5),
            (3.0, 0.0),
        ];
        for (time, value) in points {
            assert!((profile.value(at(time)) - value).abs() < 1e-12, "at {time} s");
        }
        assert_eq!(profile.edges(), [0.25, 0.75, 1.25, 1.75, 2.0]);
    }

    #[test]
    fn an_edge_belongs_to_the_interval_that_is_stepped() {
        let profile = Profile::pulse(Pulse { rise_s: 0.0, hold_s: 1.0, reverse_s: 1.0 });
        assert_eq!(profile.value(Clock { time_s: 1.0, middle_s: 0.95 }), 1.0);
        assert_eq!(profile.value(Clock { time_s: 1.0, middle_s: 1.05 }), -1.0);
    }
}
