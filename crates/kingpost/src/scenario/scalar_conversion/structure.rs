//! The structure of a scenario: everything except its continuous numbers.

use super::super::over::{Numbers, OverScalar};
use super::super::schema::Scenario;
use super::super::writing::ToValue;
use serde_json::Value;

/// Replaces each number by 0, and collects the numbers in their order.
#[derive(Default)]
struct Blanks {
    numbers: Vec<f64>,
}

impl Numbers<f64> for Blanks {
    fn number(&mut self, value: f64) -> f64 {
        self.numbers.push(value);
        0.0
    }
}

impl Scenario {
    /// Returns the scenario without its continuous numbers and without the fields at these paths, as text. Runs with
    /// the same structure can run in lanes, and one run can continue with the numbers of another.
    pub(crate) fn structure(&self, without: &[&str]) -> String {
        let mut whole = self.over(&mut Blanks::default()).to_value();
        for path in without {
            remove(&mut whole, path);
        }
        whole.to_string()
    }

    /// Returns the [structure](Self::structure) with every field, and the continuous numbers in the order of their
    /// declarations.
    #[cfg(not(target_family = "wasm"))]
    pub(super) fn structure_and_numbers(&self) -> (String, Vec<f64>) {
        let mut blanks = Blanks::default();
        let structure = self.over(&mut blanks).to_value().to_string();
        (structure, blanks.numbers)
    }
}

/// Removes a field that is not within a list; nothing if there is none.
fn remove(whole: &mut Value, path: &str) {
    let Some((above, name)) = path.rsplit_once('.') else { return };
    let fields = above.split('.').try_fold(whole, |at, field| at.get_mut(field));
    if let Some(fields) = fields.and_then(Value::as_object_mut) {
        fields.remove(name);
    }
}
