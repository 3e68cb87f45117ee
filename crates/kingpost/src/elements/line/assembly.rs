//! Lines with mass: their ends, sections and seabed.

use super::{ClumpWeight, DynamicLine, LineGround, LinePart, LineSection, RestingLine};
use crate::dynamics::LinkKinematics;
use crate::elements::lines::assembly::{LARGEST_STRAIN, end};
use crate::elements::ropes::assembly::at_start::check_path;
use crate::elements::ropes::assembly::{Laid, lay};
use crate::elements::ropes::{Drum, Station};
use crate::elements::{AnyElement, Context, of_kind_mut};
use crate::model::Attachment;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, RopeStation};
use crate::simulation::Setup;
use crate::spatial::{Frame, Vector3};

/// Largest number of elements of a line: its cost is linear in them, but each has twelve states.
const MOST_ELEMENTS: usize = 2000;

/// Largest number of points along a line: each is a column of the results.
const MOST_POINTS: usize = 200;

/// Speed at which the friction of the seabed is at half of sqrt(2) of its limit, m/s: a hundredth of the speeds at which a
/// line is dragged along the seabed.
const SLIDING_SPEED_M_S: f64 = 0.01;

/// Steepest slope of a seabed: steeper is a wall, on which nothing rests.
const STEEPEST_RAD: f64 = core::f64::consts::FRAC_PI_3;

/// Penetration of an end into the seabed at the start that counts as lying on it, as a share of the depth: rounding.
const ON_SEABED: f64 = 1e-9;

impl<S: Quantity> Assemble<S> for schema::DynamicLine<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        let field = |field: &str| format!("forces.{name}.line.{field}");
        let laid = laid(self, &field, &at)?;
        let parts = parts(self, &field)?;
        if self.points_along == 1 || self.points_along > MOST_POINTS {
            let allowed = format!("2 to {MOST_POINTS}, or 0 for none");
            return Err(FieldError::new(field("points_along"), self.points_along, allowed));
        }
        let ground = self.seabed.as_ref().map(|seabed| ground(seabed, &parts, at.world.depth, &field)).transpose()?;
        let line = match (laid, self.enabled) {
            (Some(LaidLine::Between(ends)), true) => DynamicLine::new(name, ends, &parts),
            (Some(LaidLine::Free([first, nowhere])), true) => DynamicLine::ending_free(name, first, nowhere, &parts),
            (Some(LaidLine::Over(stations, drum)), true) => DynamicLine::over(name, &stations, drum, &parts),
            _ => return Ok(Vec::new()),
        };
        let line = with_clumps(line, self, &field)?.clamped(clamps(self, &parts, &field)?);
        Ok(vec![Box::new(DynamicLine { ground, points_along: self.points_along, ..line })])
    }
}

/// Returns the directions of clamped ends: their sections have bending stiffness, and no section of a path has.
fn clamps<S: Quantity>(
    line: &schema::DynamicLine<S>,
    parts: &[LinePart<S>],
    field: &dyn Fn(&str) -> String,
) -> Result<[Option<Vector3<S>>; 2], FieldError> {
    let bends = |part: &LinePart<S>| part.section.bending_stiffness.all(|stiffness| stiffness > 0.0);
    if let Some(k) = parts.iter().position(bends).filter(|_| !line.path.is_empty()) {
        let found = parts[k].section.bending_stiffness;
        let allowed = "0: a line that is paid out over a path has no bending stiffness";
        return Err(FieldError::new(field(&format!("sections.{k}.bending_stiffness_N_m2")), found, allowed));
    }
    let given = [("first", &line.first_direction, 0), ("second", &line.second_direction, parts.len() - 1)];
    if line.second_free && line.second_direction.is_some() {
        return Err(FieldError::new(field("second_direction"), "a direction", "none at a free end"));
    }
    for (which, direction, k) in given {
        if direction.is_some() && !bends(&parts[k]) {
            let allowed = format!("none, or sections.{k}.bending_stiffness_N_m2 > 0");
            return Err(FieldError::new(field(&format!("{which}_direction")), "a direction", allowed));
        }
    }
    Ok(given.map(|(_, direction, _)| direction.map(|direction| Vector3(direction.get()).direction())))
}

/// Fastens the clump weights and buoys to the ends of the sections.
fn with_clumps<S: Quantity>(
    mut line: DynamicLine<S>,
    given: &schema::DynamicLine<S>,
    field: &dyn Fn(&str) -> String,
) -> Result<DynamicLine<S>, FieldError> {
    let mut element = 0;
    for (k, section) in given.sections.iter().enumerate() {
        element += section.elements;
        let Some(clump) = &section.clump_weight else { continue };
        if k + 1 == given.sections.len() && !given.second_free {
            let allowed = "none at the end of the last section: give its mass and volume to the body there";
            return Err(FieldError::new(field(&format!("sections.{k}.clump_weight")), "a clump weight", allowed));
        }
        let clump = ClumpWeight {
            mass: clump.mass_kg.get(),
            volume: clump.volume_m3.get(),
            drag_area: clump.drag_area_m2.get(),
            added_mass: clump.added_mass.get(),
        };
        line = line.with_clump(element, clump);
    }
    Ok(line)
}

/// The places of a line.
enum LaidLine<S> {
    /// Its two ends.
    Between([Attachment<S>; 2]),
    /// Its first end, and a place in the world instead of the free one.
    Free([Attachment<S>; 2]),
    /// The stations of a path, and the drum at its beginning.
    Over(Vec<Station<S>>, Option<Drum<S>>),
}

/// Returns the places of a line; `None` if a body does not exist.
fn laid<S: Quantity>(
    line: &schema::DynamicLine<S>,
    field: &dyn Fn(&str) -> String,
    at: &Surroundings<'_, S>,
) -> Result<Option<LaidLine<S>>, FieldError> {
    let (first, second) = match (&line.first, &line.second, line.path.is_empty()) {
        (Some(first), Some(second), true) if !line.second_free => (first, second),
        (None, None, false) if !line.second_free => return over(line, field, at),
        (Some(first), None, true) if line.second_free => {
            let nowhere = at.model.attachment(None, Frame::translation(Vector3::zero()));
            let first = end(at.scenario, at.model, &field("first"), first)?;
            return Ok(first.map(|first| LaidLine::Free([first, nowhere])));
        }
        (first, second, bare) => {
            let found = [
                ("first", first.is_some()),
                ("second", second.is_some()),
                ("second_free", line.second_free),
                ("path", !bare),
            ];
            let given: Vec<&str> = found.iter().filter(|(_, given)| *given).map(|(name, _)| *name).collect();
            let found = if given.is_empty() { "neither ends nor a path".to_owned() } else { given.join(" and ") };
            return Err(FieldError::new(
                field("first"),
                found,
                "first, with second or second_free, or a path instead of both",
            ));
        }
    };
    if first.body == second.body {
        return Err(FieldError::new(field("second.body"), &second.body, "another body than that of the first end"));
    }
    let ends = [("first", first), ("second", second)];
    let [first, second] = ends.map(|(which, pin)| end(at.scenario, at.model, &field(which), pin));
    Ok(first?.zip(second?).map(|(first, second)| LaidLine::Between([first, second])))
}

/// Returns the stations of a line over a path.
fn over<S: Quantity>(
    line: &schema::DynamicLine<S>,
    field: &dyn Fn(&str) -> String,
    at: &Surroundings<'_, S>,
) -> Result<Option<LaidLine<S>>, FieldError> {
    for (k, station) in line.path.iter().enumerate() {
        if let RopeStation::Point(point) = station
            && point.falls != 1
        {
            let found = format!("{} falls", point.falls);
            return Err(FieldError::new(field(&format!("path.{k}.point.falls")), found, "1: a line has one fall"));
        }
    }
    let of = field("path");
    let of = of.trim_end_matches(".path");
    let Laid { stations, drum } = lay(at.scenario, of, &line.path, at.model)?;
    Ok(stations.map(|stations| LaidLine::Over(stations, drum)))
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
        bending_stiffness: given.bending_stiffness_n_m2.get(),
        added_mass: [given.added_mass_across.get(), given.added_mass_along.get()],
        drag: [given.drag_across.get(), given.drag_along.get()],
    };
    LinePart { unstretched_length: given.unstretched_length_m.get(), section, elements: given.elements }
}

/// Returns the ground, with the stiffness and damping of the mean diameter, at its depth or that of the sea.
fn ground<S: Quantity>(
    seabed: &schema::LineSeabed<S>,
    parts: &[LinePart<S>],
    of_sea: Option<S>,
    field: &dyn Fn(&str) -> String,
) -> Result<LineGround<S>, FieldError> {
    let nowhere = || FieldError::new(field("seabed.depth_m"), "none", "a depth, here or in sea.depth_m");
    let depth = seabed.depth_m.map(|depth| depth.get()).or(of_sea).ok_or_else(nowhere)?;
    let slope = seabed.slope_rad.get();
    if !slope.all(|slope| slope <= STEEPEST_RAD) {
        return Err(FieldError::new(
            field("seabed.slope_rad"),
            slope,
            format!("0 to {STEEPEST_RAD:.4}, which is 60 degrees"),
        ));
    }
    let [(sin, cos), (aside, ahead)] = [slope, seabed.slope_direction_rad].map(|angle| angle.sin_cos());
    let sum = |of: &dyn Fn(&LinePart<S>) -> S| parts.iter().fold(S::ZERO, |sum, part| sum + of(part));
    let length = sum(&|part| part.unstretched_length);
    let diameter = sum(&|part| part.unstretched_length * part.section.diameter) / length;
    Ok(LineGround {
        depth,
        normal: Vector3::new(sin * ahead, sin * aside, cos),
        stiffness_per_length: seabed.stiffness_n_per_m3.get() * diameter,
        damping_time: seabed.damping_time_s.get(),
        friction: seabed.friction.get(),
        sliding_speed: S::constant(SLIDING_SPEED_M_S),
    })
}

/// Takes the start of the run as the reference of drums and paths, and checks that lines have a shape at rest there, above the
/// seabed at their ends and without a strain that no material has.
pub fn begin<S: Quantity>(setup: &mut Setup<S>) -> Result<(), FieldError> {
    let Setup { model, world, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    let at = Context::at_rest(world, model, &links, (q, v));
    for line in of_kind_mut::<S, DynamicLine<S>>(elements) {
        let of = format!("forces.{}.line", line.name);
        if let Some(path) = line.begin_supply(&at) {
            check_path(path, &at, &of)?;
        }
        let rest = line.clone().at_rest(&at);
        check_rest(line, &rest, &of)?;
    }
    Ok(())
}

fn check_rest<S: Quantity>(line: &DynamicLine<S>, rest: &RestingLine<S>, of: &str) -> Result<(), FieldError> {
    if rest.strain.all(f64::is_nan) {
        let allowed = "a shape that the search finds: check lengths, masses, buoys and the places of the ends";
        return Err(FieldError::new(format!("{of}.sections"), "no shape at rest", allowed));
    }
    let held = line.held_nodes().zip(line.end_fields()).zip(rest.ends);
    for ((_, which), end) in held {
        let Some(ground) = line.ground else { continue };
        let under = ground.under(end);
        if !(under / ground.depth).all(|share| share <= ON_SEABED) {
            let found = format!("an end that starts {under} m below the seabed");
            return Err(FieldError::new(format!("{of}.{which}"), found, "an end above the seabed, or no seabed"));
        }
    }
    if rest.strain.all(|strain| strain <= LARGEST_STRAIN) {
        return Ok(());
    }
    let found = format!(
        "{} m between ends {:.1} m apart, a strain of {:.3}",
        line.unstretched_length(),
        (rest.ends[1] - rest.ends[0]).norm(),
        rest.strain
    );
    let allowed = format!("a strain of {LARGEST_STRAIN} at most: check lengths, masses and stiffness");
    Err(FieldError::new(format!("{of}.sections.0.unstretched_length_m"), found, allowed))
}
