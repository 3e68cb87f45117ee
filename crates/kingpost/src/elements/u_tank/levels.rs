//! Warns of a U-tank whose liquid reaches the top of a column or the duct.

use crate::elements::watcher::{Extreme, Warning, Watcher, significant};

/// Watches the levels of a U-tank.
#[derive(Clone, Debug)]
pub struct ColumnLevels {
    name: String,
    /// Top of the columns and of the duct, m.
    ends: [f64; 2],
    highest: Extreme,
    /// Below the top of the duct, m.
    lowest: Extreme,
}

impl ColumnLevels {
    /// For the tank of this name; `ends` are the top of its columns and of its duct above the middle of the duct, m.
    pub fn new(name: &str, ends: [f64; 2]) -> Self {
        Self { name: name.to_owned(), ends, highest: Extreme::default(), lowest: Extreme::default() }
    }
}

impl Watcher for ColumnLevels {
    fn columns(&self) -> Vec<String> {
        ["level_port", "level_starboard"].map(|level| format!("{}.{level}", self.name)).to_vec()
    }

    fn see(&mut self, time_s: f64, levels: &[f64]) {
        for level in levels {
            self.highest.see(time_s, (level - self.ends[0]).max(0.0));
            self.lowest.see(time_s, (self.ends[1] - level).max(0.0));
        }
    }

    fn warnings(&self) -> Vec<Warning> {
        let [top, duct] = self.ends.map(|end| significant(end, 4));
        let of = |extreme: Extreme, text: String| {
            (extreme.value > 0.0).then(|| Warning { time_s: extreme.time_s, name: self.name.clone(), text })
        };
        let at = |extreme: Extreme| significant(extreme.time_s, 6);
        let high = format!("its liquid reached the top of a column, {top} m, at {} s", at(self.highest));
        let low = format!("air reached its duct, whose top is at {duct} m, at {} s", at(self.lowest));
        [of(self.highest, high), of(self.lowest, low)].into_iter().flatten().collect()
    }
}
