//! Warns of a tank whose liquid reaches the top, or falls to a level at which air enters.

use crate::elements::watcher::{Exceeded, Extreme, Warning, Watcher, significant};

/// Watches the levels in a tank.
#[derive(Clone, Debug)]
pub struct TankLevels {
    name: String,
    columns: Vec<String>,
    ends: [LevelEnd; 2],
    highest: Extreme,
    /// Largest depth below the lower end, m.
    lowest: Extreme,
}

/// An end of the range of a level.
#[derive(Clone, Debug)]
pub struct LevelEnd {
    /// The level there, m.
    pub level: f64,
    /// Code of the warning.
    pub code: &'static str,
    /// Beginning of the warning's text, before level and time.
    pub warning: &'static str,
}

impl TankLevels {
    /// Returns the watcher of the outputs `variables` of the tank with this name; the upper end is the first of `ends`.
    pub fn new(name: &str, variables: &[&str], ends: [LevelEnd; 2]) -> Self {
        let columns = variables.iter().map(|variable| format!("{name}.{variable}")).collect();
        Self { name: name.to_owned(), columns, ends, highest: Extreme::default(), lowest: Extreme::default() }
    }
}

impl Watcher for TankLevels {
    fn columns(&self) -> Vec<String> {
        self.columns.clone()
    }

    fn see(&mut self, time_s: f64, levels: &[f64]) {
        let [upper, lower] = &self.ends;
        for level in levels {
            self.highest.see(time_s, (level - upper.level).max(0.0));
            self.lowest.see(time_s, (lower.level - level).max(0.0));
        }
    }

    fn warnings(&self) -> Vec<Warning> {
        let of = |beyond: Extreme, end: &LevelEnd, sign: f64| {
            let Extreme { value, time_s } = beyond;
            let text = || format!("{}, {} m, at {} s", end.warning, significant(end.level, 4), significant(time_s, 6));
            let numbers = Exceeded { value: end.level + sign * value, bound: end.level, unit: "m" };
            (value > 0.0).then(|| Warning::exceeded(end.code, time_s, &self.name, numbers, text()))
        };
        let [upper, lower] = &self.ends;
        [of(self.highest, upper, 1.0), of(self.lowest, lower, -1.0)].into_iter().flatten().collect()
    }
}
