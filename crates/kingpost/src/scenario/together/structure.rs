//! What of a scenario decides how its runs are made up.

use super::super::leaf::Blank;
use super::super::schema::Scenario;

impl Scenario {
    /// The scenario without its continuous numbers, as text: runs of which it is the same may go side by side, and one may
    /// go on as the other.
    pub(crate) fn structure(&self) -> String {
        let blank = self.over::<Blank>(&self.written()).ok();
        blank.and_then(|blank| serde_json::to_string(&blank).ok()).unwrap_or_default()
    }
}
