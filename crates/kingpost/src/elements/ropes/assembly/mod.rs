//! Ropes and tugger lines: their paths.

pub(crate) mod at_start;
pub(crate) mod load_chart;
pub(crate) mod resting_load;

use crate::elements::ropes::{Drum, Efficiency, Inextensible, Layers, RopePath, RopeWeight, Round, Station};
use crate::elements::{AnyElement, Rope, TuggerLine};
use crate::model::{Attachment, Model};
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::attachments::attachment;
use crate::scenario::assembly::hinges::hinge;
use crate::scenario::assembly::{FieldError, known};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, PaysOut, RopePoint, RopeStation, Scenario};
use crate::scenario::wording::NOTHING;
use crate::spatial::{Frame, Vector3};

/// Largest number of falls of one leg.
const MOST_FALLS: u32 = 100;

impl<S: Quantity> Assemble<S> for schema::Rope<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(build(at.scenario, name, self, at.model)?.into_iter().collect())
    }
}

/// Returns a rope, if it is enabled and every body on its path exists.
fn build<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::Rope<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    if given.can_be_released && scenario.drives.contains_key(name) {
        let found = format!("true, with an input {name} that drives.{name} also has");
        let allowed = "a name for the rope that no drive has";
        return Err(FieldError::new(format!("forces.{name}.rope.can_be_released"), found, allowed));
    }
    check_begins_released(name, given)?;
    let Laid { stations, drum } = lay(scenario, &format!("forces.{name}.rope"), &given.path, model)?;
    let weight = weight(&format!("forces.{name}.rope"), given)?;
    let carries = resting_load::build(scenario, &format!("forces.{name}.rope"), given, model)?;
    let load_chart =
        given.load_chart.as_ref().map(|chart| load_chart::build(scenario, name, chart, model)).transpose()?;
    let (Some(stations), true) = (stations, given.enabled) else { return Ok(None) };
    let load_chart = load_chart.flatten();
    let path = RopePath::new(stations);
    let gives_way = given.axial_stiffness_n.is_some() || given.series_stiffness_n_per_m.is_some();
    if !gives_way {
        check_inextensible(&format!("forces.{name}.rope"), given)?;
    }
    Ok(Some(Box::new(Rope {
        name: name.to_owned(),
        inextensible: (!gives_way).then(|| Inextensible::new(&path)),
        path,
        drum,
        unstretched_length: given.unstretched_length_m.map_or(S::ZERO, |length| length.get()),
        axial_stiffness: given.axial_stiffness_n.map_or(S::constant(f64::INFINITY), |stiffness| stiffness.get()),
        series_compliance: given.series_stiffness_n_per_m.map_or(S::ZERO, |stiffness| S::ONE / stiffness.get()),
        damping_time: given.damping_time_s.get(),
        breaking_load: given.breaking_load_n.map(|load| load.get()),
        carries,
        load_chart,
        weight,
        can_be_released: given.can_be_released,
        begins_released: given.begins_released,
    })))
}

/// Checks that a rope that begins released can be released and has a length, which does not follow from its path at the
/// start.
fn check_begins_released<S: Quantity>(name: &str, given: &schema::Rope<S>) -> Result<(), FieldError> {
    let field = |field| format!("forces.{name}.rope.{field}");
    if given.begins_released && !given.can_be_released {
        return Err(FieldError::new(field("begins_released"), true, "false, or can_be_released: true"));
    }
    if given.begins_released && given.unstretched_length_m.is_none() {
        let allowed = "a length, for a rope that begins released";
        return Err(FieldError::new(field("unstretched_length_m"), NOTHING, allowed));
    }
    Ok(())
}

/// Refuses options that need an elastic rope: a damper; a breaking load, because snap loads break ropes; and friction
/// at sheaves and drum, which depends on the tension.
fn check_inextensible<S: Quantity>(of: &str, given: &schema::Rope<S>) -> Result<(), FieldError> {
    let allowed = |what| {
        format!("{what} for a rope without axial_stiffness_N and series_stiffness_N_per_m, which does not stretch")
    };
    if !given.damping_time_s.get().all(|time| time == 0.0) {
        return Err(FieldError::new(format!("{of}.damping_time_s"), given.damping_time_s.get(), allowed("0")));
    }
    if let Some(load) = &given.breaking_load_n {
        return Err(FieldError::new(format!("{of}.breaking_load_N"), load.get(), allowed("none")));
    }
    for (i, station) in given.path.iter().enumerate() {
        let efficiencies = match station {
            RopeStation::Point(_) => continue,
            RopeStation::Sheave(sheave) => [&sheave.efficiency_hoisting, &sheave.efficiency_lowering],
            RopeStation::Drum(drum) => [&drum.efficiency_hoisting, &drum.efficiency_lowering],
        };
        let named = ["hoisting", "lowering"].into_iter().zip(efficiencies);
        for (way, efficiency) in named.map(|(way, efficiency)| (way, efficiency.get())) {
            if !efficiency.all(|efficiency| efficiency == 1.0) {
                let field = format!("{of}.path.{i}.{}.efficiency_{way}", station.on().0);
                return Err(FieldError::new(field, efficiency, allowed("1")));
            }
        }
    }
    Ok(())
}

/// Returns the weight of a rope. A rope that displaces water but has no mass is an error: it would float up.
fn weight<S: Quantity>(of: &str, given: &schema::Rope<S>) -> Result<Option<RopeWeight<S>>, FieldError> {
    let diameter = given.diameter_m.as_ref().map(|diameter| diameter.get());
    match (&given.mass_kg_per_m, diameter) {
        (None, Some(_)) => {
            Err(FieldError::new(format!("{of}.mass_kg_per_m"), "none", "a mass for a rope with a diameter_m"))
        }
        (mass, diameter) => Ok(mass
            .as_ref()
            .map(|mass| RopeWeight { mass_per_length: mass.get(), diameter: diameter.unwrap_or(S::ZERO) })),
    }
}

impl<S: Quantity> Assemble<S> for schema::TuggerLine<S> {
    fn assemble(&self, name: &str, at: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(tugger(at.scenario, name, self, at.model)?.into_iter().collect())
    }
}

/// Returns a tugger line, if it is enabled and every body on its path exists.
fn tugger<S: Quantity>(
    scenario: &Scenario<S>,
    name: &str,
    given: &schema::TuggerLine<S>,
    model: &Model<S>,
) -> Result<Option<AnyElement<S>>, FieldError> {
    let field = format!("forces.{name}.tugger_line");
    if let Some(RopeStation::Drum(_)) = given.path.first() {
        let allowed = "a point: a constant-tension winch needs no drum";
        return Err(FieldError::new(format!("{field}.path.0"), "a drum", allowed));
    }
    let Laid { stations, .. } = lay(scenario, &field, &given.path, model)?;
    let (Some(stations), true) = (stations, given.enabled) else { return Ok(None) };
    let (tension, largest) = (given.tension_n.get(), given.largest_tension_n.map(|largest| largest.get()));
    if let Some(largest) = largest.filter(|largest| !(*largest - tension).all(|more| more >= 0.0)) {
        let allowed = format!("at least tension_N, {tension} N");
        return Err(FieldError::new(format!("{field}.largest_tension_N"), largest, allowed));
    }
    let (path, damping) = (RopePath::new(stations), given.damping_n_s_per_m.get());
    Ok(Some(Box::new(TuggerLine { name: name.to_owned(), path, tension, damping, largest })))
}

/// A path with its stations.
pub(crate) struct Laid<S> {
    /// `None` if a body does not exist.
    pub stations: Option<Vec<Station<S>>>,
    pub drum: Option<Drum<S>>,
}

/// Returns the stations of a path; `of` is the field that has it.
pub(crate) fn lay<S: Quantity>(
    scenario: &Scenario<S>,
    of: &str,
    path: &[RopeStation<S>],
    model: &Model<S>,
) -> Result<Laid<S>, FieldError> {
    let field = |rest: String| format!("{of}.{rest}");
    check_order(path, &field)?;
    let mut stations = Vec::new();
    let mut drum = None;
    for (i, station) in path.iter().enumerate() {
        let place = Placing { scenario, model, field: field(format!("path.{i}.{}", station.on().0)) };
        let found = match station {
            RopeStation::Point(point) => place.point(point)?,
            RopeStation::Sheave(sheave) => place.sheave(sheave)?,
            RopeStation::Drum(given) => place.drum(given)?.map(|(station, found)| {
                drum = Some(found);
                station
            }),
        };
        stations.push(found);
    }
    check_falls(path, &field)?;
    check_bodies(path, &field)?;
    Ok(Laid { stations: stations.into_iter().collect(), drum })
}

/// Checks that a rope begins at a point or a drum and ends at a point, with no drum between.
fn check_order<S: Quantity>(path: &[RopeStation<S>], field: &impl Fn(String) -> String) -> Result<(), FieldError> {
    if path.len() < 2 {
        return Err(FieldError::new(field("path".to_owned()), format!("{} places", path.len()), "at least two"));
    }
    let last = path.len() - 1;
    for (i, station) in path.iter().enumerate() {
        let allowed = match (i, station) {
            (0, RopeStation::Sheave(_)) => "a point or a drum, where a rope begins",
            (i, RopeStation::Sheave(_) | RopeStation::Drum(_)) if i == last => "a point, where a rope ends",
            (i, RopeStation::Drum(_)) if i > 0 => "a point or a sheave: a drum can only be where the rope begins",
            _ => continue,
        };
        return Err(FieldError::new(field(format!("path.{i}")), format!("a {}", station.on().0), allowed));
    }
    Ok(())
}

/// Checks that several falls run between points only: a sheave guides a single fall.
fn check_falls<S: Quantity>(path: &[RopeStation<S>], field: &impl Fn(String) -> String) -> Result<(), FieldError> {
    if let Some(RopeStation::Point(RopePoint { falls, .. })) = path.first()
        && *falls != 1
    {
        let allowed = "1: falls run to a point from the point before, and this is the first point";
        return Err(FieldError::new(field("path.0.point.falls".to_owned()), falls, allowed));
    }
    for (i, pair) in path.windows(2).enumerate() {
        let RopeStation::Point(point) = &pair[1] else { continue };
        let at = || field(format!("path.{}.point.falls", i + 1));
        if !(1..=MOST_FALLS).contains(&point.falls) {
            return Err(FieldError::new(at(), point.falls, format!("a number from 1 to {MOST_FALLS}")));
        }
        if point.falls > 1 && !matches!(pair[0], RopeStation::Point(_)) {
            let found = format!("{} from a {}", point.falls, pair[0].on().0);
            return Err(FieldError::new(at(), found, "1: several falls run between two points"));
        }
    }
    Ok(())
}

/// Refuses a rope whose stations are all on one body: it would have no effect.
fn check_bodies<S: Quantity>(path: &[RopeStation<S>], field: &impl Fn(String) -> String) -> Result<(), FieldError> {
    let Some(first) = path.first().and_then(|station| station.on().1) else { return Ok(()) };
    if path.iter().any(|station| station.on().1 != Some(first)) {
        return Ok(());
    }
    let allowed = "places on two bodies, or on a body and world";
    Err(FieldError::new(field("path".to_owned()), format!("places that are all on {first}"), allowed))
}

/// A drum and its station; `None` if the drum's joint does not exist.
type OnDrum<S> = Option<(Station<S>, Drum<S>)>;

/// Context for reading a station, with the station's field.
struct Placing<'a, S> {
    scenario: &'a Scenario<S>,
    model: &'a Model<S>,
    field: String,
}

impl<S: Quantity> Placing<'_, S> {
    /// Returns a point on a body or in the world; `None` if the body does not exist.
    fn centre(&self, body: &schema::Name, position_m: [S; 3]) -> Result<Option<Attachment<S>>, FieldError> {
        let bodies = self.scenario.bodies.keys().map(|body| body.as_str());
        known(&format!("{}.body", self.field), body, bodies.chain([schema::WORLD]))?;
        let pin = schema::Pin { body: body.clone(), position_m };
        if pin.named_body().is_some_and(|body| self.model.body(body).is_none()) {
            return Ok(None);
        }
        attachment(self.scenario, self.model, &format!("{}.position_m", self.field), &pin).map(Some)
    }

    fn point(&self, given: &schema::RopePoint<S>) -> Result<Option<Station<S>>, FieldError> {
        let falls = S::constant(f64::from(given.falls));
        let centre = self.centre(&given.body, given.position_m)?;
        Ok(centre.map(|centre| Station { centre, round: None, falls }))
    }

    fn sheave(&self, given: &schema::Sheave<S>) -> Result<Option<Station<S>>, FieldError> {
        let efficiency = self.efficiency(given.efficiency_hoisting.get(), given.efficiency_lowering.get())?;
        let round = Round { axis: Vector3(given.axis.get()).direction(), radius: given.radius_m.get(), efficiency };
        let centre = self.centre(&given.body, given.position_m)?;
        Ok(centre.map(|centre| Station { centre, round: Some(round), falls: S::ONE }))
    }

    fn efficiency(&self, hoisting: S, lowering: S) -> Result<Efficiency<S>, FieldError> {
        for (which, efficiency) in [("hoisting", hoisting), ("lowering", lowering)] {
            if !efficiency.all(|efficiency| efficiency > 0.0) {
                let field = format!("{}.efficiency_{which}", self.field);
                return Err(FieldError::new(field, efficiency, "a number above 0, up to 1"));
            }
        }
        Ok(Efficiency { hoisting, lowering })
    }

    /// Returns a drum, which is on the body that carries its joint.
    fn drum(&self, given: &schema::RopeDrum<S>) -> Result<OnDrum<S>, FieldError> {
        let (field, joint) = (format!("{}.joint", self.field), given.joint.as_str());
        let efficiency = self.efficiency(given.efficiency_hoisting.get(), given.efficiency_lowering.get())?;
        let Some((node, hinge)) = hinge(self.scenario, &field, joint, self.model)? else { return Ok(None) };
        let sign = match given.pays_out {
            PaysOut::WithPositiveRate => S::ONE,
            PaysOut::WithNegativeRate => -S::ONE,
        };
        let radius = given.radius_m.get();
        let round = Round { axis: hinge.placement().rotation * hinge.axis() * sign, radius, efficiency };
        let centre = self.model.attachment(node.parent, Frame::translation(hinge.placement().position));
        let layers = given.layers.as_ref().map(|layers| self.layers(radius, layers)).transpose()?;
        let coordinate = node.velocities;
        let drum = Drum { position: node.positions, coordinate, sense: sign, radius, start: S::ZERO, layers };
        Ok(Some((Station { centre, round: Some(round), falls: S::ONE }, drum)))
    }

    fn layers(&self, radius: S, given: &schema::DrumLayers<S>) -> Result<Layers<S>, FieldError> {
        let above = radius - given.innermost_radius_m.get();
        if !above.all(|above| above >= 0.0) {
            let field = format!("{}.layers.innermost_radius_m", self.field);
            let allowed = format!("at most radius_m: {radius}");
            return Err(FieldError::new(field, given.innermost_radius_m.get(), allowed));
        }
        let thinning = given.height_m.get() / (given.turns_per_layer.get() * S::constant(core::f64::consts::TAU));
        Ok(Layers { thinning, innermost_from: above / thinning })
    }
}
