//! Fields of a selector.

use kingpost_derive::fields;

use crate::scenario::schema::{LocalName, SetsInputs, SignalName};

/// Passes the commands of one of several branches to inputs. Another controller, or the operation, sets the commands of
/// a branch, `name.branch.input`; the commands of the other branches have no effect.
#[fields]
pub struct Selector {
    /// The branch whose commands pass.
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
