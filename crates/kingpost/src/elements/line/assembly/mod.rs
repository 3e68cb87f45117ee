//! Lines with mass: their ends, sections and seabed.

mod branches;

use super::{ClumpWeight, DynamicLine, LineGround, LinePart, LineSection, RestingLine};
use crate::dynamics::LinkKinematics;
use crate::elements::lines::assembly::{LARGEST_STRAIN, end};
use crate::elements::ropes::assembly::at_start::check_path;
use crate::elements::ropes::assembly::{Laid, lay};
use crate::elements::ropes::{Drum, Station};
use crate::elements::{AnyElement, Context, Element, of_kind_mut};
use crate::model::Attachment;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, RopeStation};
use crate::simulation::Setup;
use crate::spatial::Vector3;

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
        let line = line(self, name, at)?;
        // A branch is a part of the line on which it hangs.
        let elements = line.filter(|_| self.second_on.is_none());
        Ok(elements.into_iter().map(|line| Box::new(line) as _).collect())
    }
}

/// Returns a line with those that are fastened to it; `None` if it is disabled or a body does not exist.
fn line<S: Quantity>(
    given: &schema::DynamicLine<S>,
    name: &str,
    at: Surroundings<'_, S>,
) -> Result<Option<DynamicLine<S>>, FieldError> {
    let field = |field: &str| format!("forces.{name}.line.{field}");
    let laid = laid(given, name, &at)?;
    let parts = parts(given, &field)?;
    if given.points_along == 1 || given.points_along > MOST_POINTS {
        let allowed = format!("2 to {MOST_POINTS}, or 0 for none");
        return Err(FieldError::new(field("points_along"), given.points_along, allowed));
    }
    let ground = given.seabed.as_ref().map(|seabed| ground(seabed, &parts, at.world.depth, &field)).transpose()?;
    let (Some(laid), true) = (laid, given.enabled) else { return Ok(None) };
    let line = match laid {
        LaidLine::Between(ends) => DynamicLine::new(name, ends, &parts),
        LaidLine::Free(first) => DynamicLine::ending_free(name, first, &parts),
        LaidLine::Over(stations, drum) => DynamicLine::over(name, &stations, drum, &parts),
    };
    let line = with_clumps(line, given, &field)?.clamped(clamps(given, &parts, &field)?);
    let line = line.with_points_along(given.points_along);
    let mut line = ground.into_iter().fold(line, DynamicLine::on);
    for (branch, section, given) in branches::branches_of(at.scenario, name) {
        let to_end = parts.iter().take(section + 1).map(|part| part.elements).sum();
        if let Some(branch) = self::line(given, branch, at)? {
            line = line.with_branch(to_end, branch);
        }
    }
    Ok(Some(line))
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
    let not_held = [
        (line.second_free, "none at a free end"),
        (line.second_on.is_some(), "none on another line: it turns freely there"),
    ];
    if let Some((_, allowed)) = not_held.into_iter().find(|(is_so, _)| *is_so && line.second_direction.is_some()) {
        return Err(FieldError::new(field("second_direction"), "a direction", allowed));
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
            let allowed = match given.second_on {
                Some(_) => {
                    "none at the end of the last section: give it to the section of the line to which it is fastened"
                }
                None => "none at the end of the last section: give its mass and volume to the body there",
            };
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
    /// Its first end: the second one is free, or on another line.
    Free(Attachment<S>),
    /// The stations of a path, and the drum at its beginning.
    Over(Vec<Station<S>>, Option<Drum<S>>),
}

/// Returns the places of a line; `None` if a body does not exist.
fn laid<S: Quantity>(
    line: &schema::DynamicLine<S>,
    name: &str,
    at: &Surroundings<'_, S>,
) -> Result<Option<LaidLine<S>>, FieldError> {
    let field = |field: &str| format!("forces.{name}.line.{field}");
    let found = [
        ("first", line.first.is_some()),
        ("second", line.second.is_some()),
        ("second_free", line.second_free),
        ("second_on", line.second_on.is_some()),
        ("path", !line.path.is_empty()),
    ];
    let given: Vec<&str> = found.iter().filter(|(_, given)| *given).map(|(name, _)| *name).collect();
    let (Some(first), [_, second]) = (&line.first, &given[..]) else {
        if given == ["path"] {
            return over(line, &field, at);
        }
        let found = if given.is_empty() { "neither ends nor a path".to_owned() } else { given.join(" and ") };
        let allowed = "first, with one of second, second_free and second_on, or a path instead of both ends";
        return Err(FieldError::new(field("first"), found, allowed));
    };
    let Some(second) = line.second.as_ref().filter(|_| *second == "second") else {
        if let Some(on) = &line.second_on {
            branches::check(at.scenario, name, line, on)?;
        }
        let first = end(at.scenario, at.model, &field("first"), first)?;
        return Ok(first.map(LaidLine::Free));
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
        let of = format!("forces.{}.line", line.name());
        if let Some(path) = line.begin_supply(&at) {
            check_path(path, &at, &of)?;
        }
        line.clone().at_rest(&at).iter().try_for_each(check_rest)?;
    }
    Ok(())
}

fn check_rest<S: Quantity>(rest: &RestingLine<S>) -> Result<(), FieldError> {
    let of = format!("forces.{}.line", rest.name);
    if rest.strain.all(f64::is_nan) {
        let allowed = "a shape that the search finds: check lengths, masses, buoys and the places of the ends";
        return Err(FieldError::new(format!("{of}.sections"), "no shape at rest", allowed));
    }
    for (which, place) in &rest.ends {
        let Some(ground) = &rest.ground else { continue };
        let under = ground.under(*place);
        if !(under / ground.depth).all(|share| share <= ON_SEABED) {
            let found = format!("an end that starts {under} m below the seabed");
            return Err(FieldError::new(format!("{of}.{which}"), found, "an end above the seabed, or no seabed"));
        }
    }
    if rest.strain.all(|strain| strain <= LARGEST_STRAIN) {
        return Ok(());
    }
    let RestingLine { unstretched_length, distance, strain, .. } = rest;
    let found = format!("{unstretched_length} m between ends {distance:.1} m apart, a strain of {strain:.3}");
    let allowed = format!("a strain of {LARGEST_STRAIN} at most: check lengths, masses and stiffness");
    Err(FieldError::new(format!("{of}.sections.0.unstretched_length_m"), found, allowed))
}
