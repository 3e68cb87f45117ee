//! Ropes at the start of a run: their geometry, length and load.

use crate::dynamics::LinkKinematics;
use crate::elements::ropes::RopePath;
use crate::elements::{Context, HeaveCompensation, Rope, TuggerLine, of_kind, of_kind_mut};
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::leaf::Quantity;
use crate::simulation::Setup;
use crate::world::World;

/// Strain at the start above which a length is an error: steel parts at a much smaller strain.
const LARGEST_STRAIN: f64 = 0.05;

/// Largest shortage of an inextensible rope's length relative to its path, m: rounding of a length in a file.
const SHORT_BY_ROUNDING_M: f64 = 1e-9;

/// Largest wrap angle of a sheave at the start, degrees: a larger angle means that the axis points in the wrong
/// direction. During the run the angle may be larger.
const LARGEST_WRAP_DEG: f64 = 200.0;

/// Smallest length of a path, m: the computed length is not exactly 0 if all stations coincide.
const LEAST_LENGTH_M: f64 = 1e-6;

/// Wrap angle below which a rope runs straight past a sheave, degrees.
const ROUNDING_DEG: f64 = 1.0;

/// Takes the lengths at the start of the run, with loops closed.
///
/// # Errors
/// Sheaves that overlap or that the rope does not touch; a rope that is shorter than its path by more than it can
/// stretch.
pub fn begin<S: Quantity>(setup: &mut Setup<S>) -> Result<(), FieldError> {
    let Setup { model, world, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    at_rest(world, model, &links, (q, v), |at| {
        of_kind_mut::<S, HeaveCompensation<S>>(elements).for_each(|controller| controller.hoist.begin(at));
        of_kind_mut::<S, Rope<S>>(elements).try_for_each(|rope| begin_one(rope, at))?;
        of_kind_mut::<S, TuggerLine<S>>(elements).try_for_each(|line| {
            line.path.begin(at);
            check_path(&mut line.path, at, &format!("forces.{}.tugger_line", line.name))
        })
    })
}

/// Checks a path at the start of a run: its stations, its length, and the sides on which it touches sheaves.
pub(crate) fn check_path<S: Quantity>(path: &mut RopePath<S>, at: &Context<'_, S>, of: &str) -> Result<(), FieldError> {
    check_apart(path, at, of)?;
    check_length(path, at, of)?;
    check_sides(path, of)
}

fn begin_one<S: Quantity>(rope: &mut Rope<S>, at: &Context<'_, S>) -> Result<(), FieldError> {
    let of = format!("forces.{}.rope", rope.name);
    check_apart(&mut rope.path, at, &of)?;
    let length = rope.begin_at(at);
    check_length(&mut rope.path, at, &of)?;
    check_sides(&mut rope.path, &of)?;
    if rope.unstretched_length.vanishes() {
        rope.unstretched_length = length;
    }
    if rope.begins_released {
        return Ok(());
    }
    if rope.inextensible.is_some() {
        return check_inextensible(rope, length, &of);
    }
    let strain = rope.tension_at_rest(length - rope.unstretched_length) / rope.axial_stiffness;
    if !strain.all(|strain| strain <= LARGEST_STRAIN) {
        let found = format!("{} m, on a path of {length:.4} m: a strain of {strain:.3}", rope.unstretched_length);
        let allowed = format!("a length at which the rope stretches by {LARGEST_STRAIN} at most");
        return Err(FieldError::new(format!("{of}.unstretched_length_m"), found, allowed));
    }
    Ok(())
}

/// Checks that an inextensible rope is as long as its path or longer.
fn check_inextensible<S: Quantity>(rope: &Rope<S>, length: S, of: &str) -> Result<(), FieldError> {
    if (length - rope.unstretched_length).all(|short| short <= SHORT_BY_ROUNDING_M) {
        return Ok(());
    }
    let (field, found) = (format!("{of}.unstretched_length_m"), format!("{} m", rope.unstretched_length));
    let allowed = format!(
        "at least {length} m, the length of its path, for a rope that does not stretch; without this field, that length"
    );
    Err(FieldError::new(field, found, allowed))
}

/// Checks that no two stations of the path overlap, and that a drum's axis is not along the rope.
fn check_apart<S: Quantity>(path: &mut RopePath<S>, at: &Context<'_, S>, of: &str) -> Result<(), FieldError> {
    if let Some((leg, [distance, radii])) = path.overlap(at) {
        let found = format!("a place {distance:.4} m from the place before it");
        let allowed = format!("a distance above {radii:.4} m, the sum of both radii");
        return Err(FieldError::new(format!("{of}.path.{}", leg + 1), found, allowed));
    }
    if path.drum_is_along(at) {
        let (found, allowed) = ("an axis along the rope", "a joint whose axis is across the rope");
        return Err(FieldError::new(format!("{of}.path.0.drum.joint"), found, allowed));
    }
    Ok(())
}

fn check_length<S: Quantity>(path: &mut RopePath<S>, at: &Context<'_, S>, of: &str) -> Result<(), FieldError> {
    let length = path.extent(at).length;
    if length.all(|length| length >= LEAST_LENGTH_M) {
        return Ok(());
    }
    let allowed = format!("one of at least {LEAST_LENGTH_M} m");
    Err(FieldError::new(format!("{of}.path"), format!("a path of {length:.4} m"), allowed))
}

/// Checks that the rope touches every sheave, on the side given by its axis.
fn check_sides<S: Quantity>(path: &mut RopePath<S>, of: &str) -> Result<(), FieldError> {
    for (i, wrap) in path.wraps() {
        let degrees = wrap * S::constant(180.0 / core::f64::consts::PI);
        if !degrees.all(|degrees| (-ROUNDING_DEG..=LARGEST_WRAP_DEG).contains(&degrees)) {
            let found = format!("a rope that turns by {degrees:.1} degrees about the axis");
            let allowed =
                format!("0 to {LARGEST_WRAP_DEG} degrees; on the other side of the sheave, the opposite axis");
            return Err(FieldError::new(format!("{of}.path.{i}.sheave.axis"), found, allowed));
        }
    }
    Ok(())
}

/// Checks that at the start no rope carries more than its breaking load.
pub fn check_loads(setup: &Setup) -> Result<(), FieldError> {
    let Setup { model, world, elements, q, v, .. } = setup;
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    for rope in of_kind::<f64, Rope>(elements) {
        let Some(load) = rope.breaking_load else { continue };
        let tension = at_rest(world, model, &links, (q, v), |at| rope.clone().tension_here(at));
        if tension > load {
            let (name, allowed) = (&rope.name, format!("more than {tension:.0} N, which it carries at the start"));
            return Err(FieldError::new(format!("forces.{name}.rope.breaking_load_N"), load, allowed));
        }
    }
    Ok(())
}

/// Calls a function with the context of a model at rest, for an element without states, inputs, numbers and modes.
pub(crate) fn at_rest<S: Quantity, R>(
    world: &World<S>,
    model: &Model<S>,
    links: &LinkKinematics<S>,
    (q, v): (&[S], &[S]),
    see: impl FnOnce(&Context<'_, S>) -> R,
) -> R {
    see(&Context::at_rest(world, model, links, (q, v)))
}
