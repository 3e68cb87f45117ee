//! The structure of a scenario: everything except its continuous numbers.

use super::super::leaf::Blank;
use super::super::schema::Scenario;

impl Scenario {
    /// The scenario without its continuous numbers, as text. Runs with the same structure can run in lanes, and one can
    /// continue as the other.
    pub(crate) fn structure(&self) -> String {
        let blank = self.over::<Blank>(&self.written()).ok();
        blank.and_then(|blank| serde_json::to_string(&blank).ok()).unwrap_or_default()
    }
}
