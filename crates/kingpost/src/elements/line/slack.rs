//! Warns of a line that becomes slack.

use crate::elements::{Exceeded, Extreme, Warning, Watcher, significant};

/// Share of the largest tension of a run below which an end is slack.
const SLACK: f64 = 1e-6;

/// The slack times of the ends of a line.
#[derive(Clone, Debug)]
pub(super) struct Slack {
    name: String,
    /// Number of its ends that become slack only in a snap: the second one of a mooring line may lie slack on the seabed.
    ends: usize,
    largest: Extreme,
    is_slack: bool,
    times: usize,
    first_s: f64,
}

impl Slack {
    /// Returns the watcher of this number of ends of a line, from the first one.
    pub fn new(name: &str, ends: usize) -> Self {
        Self { name: name.to_owned(), ends, largest: Extreme::default(), is_slack: false, times: 0, first_s: 0.0 }
    }
}

impl Watcher for Slack {
    fn columns(&self) -> Vec<String> {
        ["line_tension", "line_end_tension"][..self.ends]
            .iter()
            .map(|column| format!("{}.{column}", self.name))
            .collect()
    }

    fn see(&mut self, time_s: f64, values: &[f64]) {
        let (least, most) =
            values.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), value| (a.min(*value), b.max(*value)));
        self.largest.see(time_s, most);
        let is_slack = least <= SLACK * self.largest.value && self.largest.value > 0.0;
        if is_slack && !self.is_slack {
            self.times += 1;
            if self.times == 1 {
                self.first_s = time_s;
            }
        }
        self.is_slack = is_slack;
    }

    fn warnings(&self) -> Vec<Warning> {
        if self.times == 0 {
            return Vec::new();
        }
        let often = if self.times == 1 { "once".to_owned() } else { format!("{} times", self.times) };
        let text = format!(
            "becomes slack {often} in the rows, first at {} s, with at most {} N afterwards or before: a snap depends on damping and \
             step, and formulas for a taut line do not hold",
            significant(self.first_s, 6),
            significant(self.largest.value, 4)
        );
        let numbers = Exceeded { value: self.times as f64, bound: 0.0, unit: "1" };
        vec![Warning::exceeded("slack_line", self.first_s, &self.name, numbers, text)]
    }
}
