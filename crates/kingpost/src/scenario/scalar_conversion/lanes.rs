//! Several scenarios with the same structure as one scenario over lanes.

use super::super::assembly::assemble;
use super::super::error::FieldError;
use super::super::over::{Numbers, OverScalar};
use super::super::schema::Scenario;
use crate::scalar::{LANES, Lanes};
use crate::simulation::Setup;

/// The numbers of each scenario, and how many of them have been used.
struct OfEach<'a> {
    numbers: [&'a [f64]; LANES],
    taken: usize,
}

impl Numbers<Lanes> for OfEach<'_> {
    fn number(&mut self, _: f64) -> Lanes {
        let at = self.taken;
        self.taken += 1;
        Lanes::new(self.numbers.map(|numbers| numbers[at]))
    }
}

/// Returns one setup over lanes of up to [`LANES`] scenarios with the same structure; the last scenario fills
/// the remaining lanes. `alone` are their separate setups.
///
/// # Errors
/// Scenarios with different structure, or a number that differs but must be the same in all of them.
pub(crate) fn side_by_side(scenarios: &[&Scenario], alone: &[&Setup]) -> Result<Setup<Lanes>, FieldError> {
    let (structures, numbers): (Vec<String>, Vec<Vec<f64>>) =
        scenarios.iter().map(|scenario| scenario.structure_and_numbers()).unzip();
    if structures.iter().any(|structure| *structure != structures[0]) {
        return Err(FieldError::new("", "another structure", "one structure for all lanes"));
    }
    let lane = |k: usize| k.min(scenarios.len() - 1);
    let mut of_each = OfEach { numbers: core::array::from_fn(|k| &*numbers[lane(k)]), taken: 0 };
    let setups: [&Setup; LANES] = core::array::from_fn(|k| alone[lane(k)]);
    assemble(&scenarios[0].over(&mut of_each), &setups)
}
