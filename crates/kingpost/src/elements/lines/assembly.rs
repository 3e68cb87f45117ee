//! Mooring lines and hawsers: their ends and properties.

use crate::dynamics::LinkKinematics;
use crate::elements::lines::{Catenary, Span};
use crate::elements::{AnyElement, CatenaryLine, SpringLine, of_kind};
use crate::model::{Attachment, Model};
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::assembly::{FieldError, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::simulation::Setup;
use crate::spatial::Vector3;
use crate::world::World;

impl<S: Quantity> Assemble<S> for schema::SpringLine<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(spring(at.scenario, name, self, at.model)?.into_iter().collect())
    }
}

/// Returns a weightless line, if it is enabled and its bodies exist.
fn spring<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::SpringLine<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = |end: &str| format!("forces.{name}.spring_line.{end}");
    let first = end(scenario, model, &field("first"), &given.first)?;
    let second = end(scenario, model, &field("second"), &given.second)?;
    if given.first.body == given.second.body {
        return Err(FieldError::new(
            field("second.body"),
            &given.second.body,
            "another body than that of the first end",
        ));
    }
    let (Some(first), Some(second), true) = (first, second, given.enabled) else { return Ok(None) };
    Ok(Some(Box::new(SpringLine {
        name: name.to_owned(),
        first,
        second,
        unstretched_length: given.unstretched_length_m.get(),
        axial_stiffness: given.axial_stiffness_n.get(),
        dissipation: given.dissipation_s_per_m.get(),
    })))
}

impl<S: Quantity> Assemble<S> for schema::CatenaryLine<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(catenary(at.scenario, name, self, at.model, at.world)?.into_iter().collect())
    }
}

/// Returns a mooring line, if it is enabled and its body exists.
fn catenary<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::CatenaryLine<S>,
    model: &Model<S>,
    world: &World<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = |field: &str| format!("forces.{name}.catenary_line.{field}");
    if given.fairlead.named_body().is_none() {
        return Err(FieldError::new(
            field("fairlead.body"),
            &given.fairlead.body,
            "a body: the anchor is in the world",
        ));
    }
    let fairlead = end(scenario, model, &field("fairlead"), &given.fairlead)?;
    let depth = world.depth.filter(|_| given.seabed);
    let off = |depth: &S| !((given.anchor_m[2] + *depth) / *depth).all(|off| off.abs() <= SAME_DEPTH);
    if let Some(depth) = depth.filter(off) {
        let allowed = format!("{}, the seabed by sea.depth_m, or seabed: false", -depth);
        return Err(FieldError::new(field("anchor_m.2"), given.anchor_m[2], allowed));
    }
    let (Some(fairlead), true) = (fairlead, given.enabled) else { return Ok(None) };
    Ok(Some(Box::new(CatenaryLine {
        name: name.to_owned(),
        fairlead,
        anchor: Vector3(given.anchor_m),
        line: Catenary {
            unstretched_length: given.unstretched_length_m.get(),
            weight: given.weight_in_water_n_per_m.get(),
            axial_stiffness: given.axial_stiffness_n.get(),
            on_seabed: given.seabed,
        },
    })))
}

/// Largest distance of an anchor from the seabed, as a share of the depth: rounding.
const SAME_DEPTH: f64 = 1e-9;

/// Strain at the start above which a length, a stiffness or a weight is an error: steel parts at a much smaller strain,
/// polyester at 0.12.
pub(crate) const LARGEST_STRAIN: f64 = 0.1;

/// Checks that at the start of a run fairleads are above the seabed, and that no line exceeds the largest strain.
pub fn check_start<S: Quantity>(setup: &Setup<S>) -> Result<(), FieldError> {
    let Setup { model, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    for line in of_kind::<S, CatenaryLine<S>>(elements) {
        let span = line.span(model, &links);
        let up = span.up;
        if line.line.on_seabed && !up.all(|up| up > 0.0) {
            let found = format!("a fairlead that starts {} m below the seabed", -up);
            let allowed = "a fairlead above the seabed, which is flat at the anchor's depth, or seabed: false";
            return Err(FieldError::new(format!("forces.{}.catenary_line.fairlead", line.name), found, allowed));
        }
        check_strain(line, &span)?;
    }
    Ok(())
}

fn check_strain<S: Quantity>(line: &CatenaryLine<S>, span: &Span<S>) -> Result<(), FieldError> {
    let [tension, ..] = line.line.tensions(&line.line.force(span));
    let strain = tension / line.line.axial_stiffness;
    if strain.all(|strain| strain <= LARGEST_STRAIN) {
        return Ok(());
    }
    let Catenary { unstretched_length, weight, axial_stiffness, .. } = &line.line;
    let found = format!(
        "{unstretched_length} m between ends {:.1} m apart, of {weight} N/m and a stiffness of {axial_stiffness} N: a tension of \
         {tension:.0} N, a strain of {strain:.3}",
        (span.across * span.across + span.up * span.up).sqrt(),
    );
    let allowed =
        format!("a strain of {LARGEST_STRAIN} at most: check the length, and the units of weight and stiffness");
    Err(FieldError::new(format!("forces.{}.catenary_line.unstretched_length_m", line.name), found, allowed))
}

/// Returns an end relative to the centre of mass of its body; `None` if the body does not exist.
pub(crate) fn end<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    field: &str,
    pin: &schema::Pin<S>,
) -> Result<Option<Attachment<S>>, FieldError> {
    let bodies = scenario.bodies.keys().map(|body| body.as_str());
    known(&format!("{field}.body"), &pin.body, bodies.chain([schema::WORLD]))?;
    if pin.named_body().is_some_and(|body| model.body(body).is_none()) {
        return Ok(None);
    }
    attachment(scenario, model, &format!("{field}.position_m"), pin).map(Some)
}
