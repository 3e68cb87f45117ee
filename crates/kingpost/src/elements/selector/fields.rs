//! Fields of a selector.

use kingpost_derive::fields;

use crate::scenario::schema::{LocalName, SetsInputs, SignalName};

/// Passes the commands of one of several branches to inputs. Another controller, or the operation, sets the command of a
/// branch, `name.branch.input`; those of the branches that are not selected go nowhere.
#[fields]
pub struct Selector {
    /// The branch that passes.
    pub selected: LocalName,
    /// The branches.
    pub branches: Vec<LocalName>,
    /// The inputs that it sets.
    pub steers: Vec<SelectorTarget>,
}

/// An input that a selector sets.
#[fields]
pub struct SelectorTarget {
    /// The input.
    pub to: SignalName,
}

impl SetsInputs for Selector {
    fn targets(&self) -> Vec<(String, &str)> {
        self.steers.iter().enumerate().map(|(k, steer)| (format!("steers.{k}.to"), &*steer.to)).collect()
    }
}
