//! Lines with mass: their ends, sections and seabed.

use super::{DynamicLine, LineGround, LinePart, LineSection};
use crate::elements::lines::assembly::{LARGEST_STRAIN, end};
use crate::elements::{AnyElement, of_kind};
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema;
use crate::simulation::Setup;

/// Largest number of elements of a line: its cost is linear in them, but each has twelve states.
const MOST_ELEMENTS: usize = 2000;

/// Largest number of points along a line: each is a column of the results.
const MOST_POINTS: usize = 200;

/// Speed at which the friction of the seabed is at half of sqrt(2) of its limit, m/s: a hundredth of the speeds at which a
/// line is dragged along the seabed.
const SLIDING_SPEED_M_S: f64 = 0.01;

/// Penetration of an end into the seabed at the start that counts as lying on it, as a share of the depth: rounding.
const ON_SEABED: f64 = 1e-9;

impl<S: Quantity> Assemble<S> for schema::DynamicLine<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let field = |field: &str| format!("forces.{name}.line.{field}");
        if self.first.body == self.second.body {
            let allowed = "another body than that of the first end";
            return Err(FieldError::new(field("second.body"), &self.second.body, allowed));
        }
        let ends = [("first", &self.first), ("second", &self.second)];
        let [first, second] = ends.map(|(which, pin)| end(at.scenario, at.model, &field(which), pin));
        let (first, second) = (first?, second?);
        let parts = parts(self, &field)?;
        if self.points_along == 1 || self.points_along > MOST_POINTS {
            let allowed = format!("2 to {MOST_POINTS}, or 0 for none");
            return Err(FieldError::new(field("points_along"), self.points_along, allowed));
        }
        let ground = match &self.seabed {
            None => None,
            Some(seabed) => {
                let depth = seabed.depth_m.map(|depth| depth.get()).or(at.world.depth);
                let nowhere = || FieldError::new(field("seabed.depth_m"), "none", "a depth, here or in sea.depth_m");
                Some(ground(seabed, &parts, depth.ok_or_else(nowhere)?))
            }
        };
        let (Some(first), Some(second), true) = (first, second, self.enabled) else { return Ok(Vec::new()) };
        let line = DynamicLine::new(name, [first, second], &parts);
        Ok(vec![Box::new(DynamicLine { ground, points_along: self.points_along, ..line })])
    }
}

/// Returns the parts of a line.
fn parts<S: Quantity>(
    line: &schema::DynamicLine<S>,
    field: &dyn Fn(&str) -> String,
) -> Result<Vec<LinePart<S>>, FieldError> {
    if line.sections.is_empty() {
        return Err(FieldError::new(field("sections"), "none", "at least one"));
    }
    let elements = line.sections.iter().fold(0, |sum: usize, section| sum.saturating_add(section.elements));
    if elements > MOST_ELEMENTS {
        let allowed = format!("at most {MOST_ELEMENTS} together");
        return Err(FieldError::new(field("sections"), format!("{elements} elements"), allowed));
    }
    if let Some(none) = line.sections.iter().position(|section| section.elements == 0) {
        return Err(FieldError::new(field(&format!("sections.{none}.elements")), 0, "at least 1"));
    }
    Ok(line.sections.iter().map(part).collect())
}

fn part<S: Quantity>(given: &schema::DynamicLineSection<S>) -> LinePart<S> {
    let section = LineSection {
        mass_per_length: given.mass_kg_per_m.get(),
        diameter: given.diameter_m.get(),
        axial_stiffness: given.axial_stiffness_n.get(),
        damping_time: given.damping_time_s.get(),
        added_mass: [given.added_mass_across.get(), given.added_mass_along.get()],
        drag: [given.drag_across.get(), given.drag_along.get()],
    };
    LinePart { unstretched_length: given.unstretched_length_m.get(), section, elements: given.elements }
}

/// Returns the ground, with the stiffness and damping of the mean diameter.
fn ground<S: Quantity>(seabed: &schema::LineSeabed<S>, parts: &[LinePart<S>], depth: S) -> LineGround<S> {
    let sum = |of: &dyn Fn(&LinePart<S>) -> S| parts.iter().fold(S::ZERO, |sum, part| sum + of(part));
    let length = sum(&|part| part.unstretched_length);
    let diameter = sum(&|part| part.unstretched_length * part.section.diameter) / length;
    LineGround {
        depth,
        stiffness_per_length: seabed.stiffness_n_per_m3.get() * diameter,
        damping_time: seabed.damping_time_s.get(),
        friction: seabed.friction.get(),
        sliding_speed: S::constant(SLIDING_SPEED_M_S),
    }
}

/// Checks that at the start of a run lines have a shape at rest, above the seabed at their ends and without a strain that no
/// material has.
pub fn check_start<S: Quantity>(setup: &Setup<S>) -> Result<(), FieldError> {
    for line in of_kind::<S, DynamicLine<S>>(&setup.elements) {
        let field = |field: &str| format!("forces.{}.line.{field}", line.name);
        let rest = line.clone().at_rest(&setup.model, &setup.world, (&setup.q, &setup.v));
        for (which, z) in ["first", "second"].iter().zip(rest.ends.map(|end| end[2])) {
            let Some(depth) = line.ground.map(|ground| ground.depth) else { continue };
            let under = -(z + depth) / depth;
            if !under.all(|under| under <= ON_SEABED) {
                let found = format!("an end that starts {} m below the seabed", -(z + depth));
                return Err(FieldError::new(field(which), found, "an end above the seabed, or no seabed"));
            }
        }
        if rest.strain.all(|strain| strain <= LARGEST_STRAIN) {
            continue;
        }
        let found = format!(
            "{} m between ends {:.1} m apart, a strain of {:.3}",
            line.unstretched_length(),
            (rest.ends[1] - rest.ends[0]).norm(),
            rest.strain
        );
        let allowed = format!("a strain of {LARGEST_STRAIN} at most: check lengths, masses and stiffness");
        return Err(FieldError::new(field("sections.0.unstretched_length_m"), found, allowed));
    }
    Ok(())
}
