//! Neighbours of a scenario, in which one parameter was moved: how a derivative finds its way from
//! a parameter into every number of the model.

use super::build::assemble;
use super::build::reading::{Neighbour, Reading};
use super::error::{FieldError, ScenarioError};
use super::schema::Scenario;
use super::tree::segments;
use super::{units, wording};
use crate::scalar::Dual;
use crate::simulation::Setup;
use core::cell::Cell;
use serde_json::Value;

/// How far a parameter is moved that stands at 0; any other is halved, which keeps its sign.
const FROM_ZERO: f64 = 1.0 / 16.0;

impl Scenario {
    /// What a simulation is made of, with its derivatives along parameters: direction k is the
    /// parameter, or the path of a number, `names[k]`, in the unit of its path.
    ///
    /// ```
    /// # let text = include_str!("../../../../scenarios/paper.yaml");
    /// let scenario = kingpost::scenario::read(text, "paper.yaml", &[])?;
    /// let setup = scenario.setup_along::<1>(&["bodies.arm.mass_kg"])?;
    /// let arm = setup.model.body("arm").unwrap();
    /// assert_eq!(setup.model.bodies[arm].mass.derivative, [1.0]);
    /// # Ok::<(), kingpost::scenario::ScenarioError>(())
    /// ```
    ///
    /// # Errors
    /// A name that is no parameter and no path of a number, or a number that changes the
    /// structure, or when laws change their form, or how the run is stepped.
    ///
    /// # Panics
    /// When there are more than N names.
    pub fn setup_along<const N: usize>(&self, names: &[&str]) -> Result<Setup<Dual<N>>, ScenarioError> {
        assert!(names.len() <= N, "at most as many names as directions");
        let (mut scenarios, mut neighbours) = (Vec::new(), Vec::new());
        for name in names {
            let (scenario, moved) = self.neighbour(name)?;
            scenarios.push(scenario);
            neighbours.push(Neighbour { moved, seen: Cell::new(false) });
        }
        let parts = core::iter::once(self).chain(&scenarios).collect();
        let setup = assemble(&Reading::with_neighbours(parts, &neighbours))?;
        match neighbours.iter().position(|neighbour| !neighbour.seen.get()) {
            Some(k) => Err(FieldError::new(names[k], wording::NO_DERIVATIVE, wording::CONTINUOUS).into()),
            None => Ok(setup),
        }
    }

    /// This scenario with one number moved, and by how much.
    fn neighbour(&self, name: &str) -> Result<(Self, f64), FieldError> {
        let parameter = self.parameters.iter().find(|parameter| parameter.name == name);
        let paths = parameter.map_or_else(|| vec![name.to_owned()], |parameter| parameter.writes.clone());
        let mut whole = serde_json::to_value(self).unwrap_or_default();
        let mut moved = None;
        for path in &paths {
            let (path, factor) = units::si_path(&segments(path));
            let number = whole.pointer_mut(&format!("/{}", path.join("/")));
            let Some((number, value)) = number.and_then(|slot| slot.as_f64().map(|value| (slot, value))) else {
                return Err(FieldError::new(name, wording::NO_NUMBER, wording::CONTINUOUS));
            };
            let by = *moved.get_or_insert(if value == 0.0 { FROM_ZERO } else { -0.5 * value / factor });
            *number = Value::from(value + factor * by);
        }
        let scenario = serde_json::from_value(whole);
        let scenario: Self =
            scenario.map_err(|_| FieldError::new(name, wording::NO_DERIVATIVE, wording::CONTINUOUS))?;
        let scenario = Self { files: self.files.clone(), ..scenario };
        Ok((scenario, moved.unwrap_or(FROM_ZERO)))
    }
}

#[cfg(test)]
mod tests {
    use crate::scenario::read;

    const TEXT: &str = include_str!("../../../../scenarios/paper.yaml");

    fn error(name: &str) -> String {
        let scenario = read(TEXT, "paper.yaml", &[]).expect("the gallery reads");
        scenario.setup_along::<1>(&[name]).map(drop).expect_err("no derivative").to_string()
    }

    #[test]
    fn a_unit_in_a_path_is_a_factor_of_the_derivative() {
        let scenario = read(TEXT, "paper.yaml", &[]).expect("the gallery reads");
        let names = ["bodies.arm.mass_t", "bodies.ship.joint.floating.initial.orientation_deg.2", "crane_x_m"];
        let setup = scenario.setup_along::<3>(&names).expect("the numbers are there");
        let arm = setup.model.body("arm").expect("the arm is there");
        assert!((setup.model.bodies[arm].mass.derivative[0] - 1000.0).abs() < 1e-10);
        // The quaternion of a small turn is half the angle.
        assert!((setup.q[6].derivative[1] - 0.5_f64.to_radians()).abs() < 1e-15);
        assert!(setup.q.iter().all(|q| q.derivative[2] == 0.0));
    }

    #[test]
    fn what_has_no_derivative_is_refused_by_name() {
        assert_eq!(
            error("motor_1"),
            "motor_1: found no number, allowed: a parameter, or the path of a number, that moves the model continuously"
        );
        for name in ["simulation.step_s", "drives.motor_1.motor.pulse.rise_s", "simulation.seed", "nonsense"] {
            assert!(error(name).starts_with(name), "{}", error(name));
        }
    }
}
