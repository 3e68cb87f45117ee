//! Warns of a tank whose liquid reaches the top, or falls to a level at which air enters.

use crate::elements::watcher::{Extreme, Warning, Watcher, significant};

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
        let of = |(extreme, end): (Extreme, &LevelEnd)| {
            let (level, time) = (significant(end.level, 4), significant(extreme.time_s, 6));
            let text = format!("{}, {level} m, at {time} s", end.warning);
            (extreme.value > 0.0).then(|| Warning { time_s: extreme.time_s, name: self.name.clone(), text })
        };
        [self.highest, self.lowest].into_iter().zip(&self.ends).filter_map(of).collect()
    }
}
