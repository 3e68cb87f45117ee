//! Ships that must be held in position.

use crate::elements::{HOLD_IT, Hull};
use crate::scenario::assembly::FieldError;
use crate::scenario::ties::{stations, tied_to_the_world};
use crate::simulation::Setup;

/// Checks that a hull with `wave_pressure` is held in position. The mean pressure over the mesh is only one
/// part of the second-order drift force. The other parts, which partly balance it, are not modelled, so a
/// free hull would drift away and turn.
pub fn check(setup: &Setup) -> Result<(), FieldError> {
    let kept = tied_to_the_world(&setup.model, stations(&setup.elements));
    let mut pressed = Hull::among(&setup.elements).filter(|hull| hull.wave_pressure.is_some());
    if let Some(hull) = pressed.find(|hull| !kept[hull.frame.body]) {
        let found = format!(
            "true, but nothing holds {} in surge, sway and yaw: the mean of the waves' pressure, a part of their drift, would carry it away",
            setup.model.bodies[hull.frame.body].name
        );
        let field = format!("forces.{}.hydrodynamics.wave_pressure", hull.name);
        return Err(FieldError::new(field, found, format!("a ship that is held ({HOLD_IT}), or wave_pressure: false")));
    }
    Ok(())
}
