//! Converts the pins of a scenario to attachments of the model.

use crate::model::{Attachment, Model};
use crate::scenario::assembly::flexible::carrier_in_model;
use crate::scenario::assembly::{FieldError, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::spatial::{Frame, Vector3};

/// Returns the attachment of a pin, relative to the centre of mass of its body; `field` is the path of the
/// pin's position, beside which its body is named.
pub(crate) fn attachment<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    field: &str,
    pin: &schema::Pin<S>,
) -> Result<Attachment<S>, FieldError> {
    if let Some(body) = pin.named_body() {
        let of_body = format!("{}body", field.trim_end_matches("position_m"));
        known(&of_body, body, scenario.bodies.keys().map(|name| name.as_str()))?;
    }
    let (body, centre) = carrier_in_model(scenario, model, pin.named_body(), field, pin.position_m)?;
    Ok(model.attachment(body, Frame::translation(Vector3(pin.position_m) - centre)))
}
