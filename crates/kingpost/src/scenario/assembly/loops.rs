//! Closed loops: their attachments, and checks that their constraints are independent and can be satisfied at
//! the start.

use super::super::schema::{self, Scenario};
use super::flexible::carrier_in_model;
use super::{FieldError, known};
use crate::dynamics::forward::Workspace;
use crate::dynamics::loops::{LoopSolver, Projection, Row};
use crate::dynamics::{LinkKinematics, Loads, TemporaryConstraint};
use crate::elements::connection::fields::Connection;
use crate::model::{Attachment, Constraint, Loop, Model, RotationAxis};
use crate::scenario::leaf::Quantity;
use crate::simulation::Setup;
use crate::spatial::{Frame, Vector3, rotation_from_roll_pitch_yaw};

/// Ends of a loop.
pub(crate) struct Ends<S> {
    pub(crate) first: Attachment<S>,
    pub(crate) second: Attachment<S>,
}

/// Returns the model with the enabled loops between enabled bodies, without those that can be released.
pub fn build<S: Quantity>(scenario: &Scenario<S>, model: Model<S>) -> Result<Model<S>, FieldError> {
    let loops = some(scenario, &model, |given| given.connection.is_none())?;
    Ok(model.with_loops(loops))
}

/// Returns the enabled loops between enabled bodies that meet a condition.
fn some<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    meets: impl Fn(&schema::Loop<S>) -> bool,
) -> Result<Vec<Loop<S>>, FieldError> {
    let mut loops = Vec::new();
    for (name, given) in scenario.loops.iter().filter(|(_, given)| meets(given)) {
        let Some(Ends { first, second }) = ends(scenario, model, name, given)? else { continue };
        let named = |(name, constraint): (&'static str, Constraint<S>)| (name.to_owned(), constraint);
        let constraints = constraints(given).into_iter().map(named).collect();
        loops.push(Loop { name: name.to_string(), first, second, constraints });
    }
    Ok(loops)
}

/// Returns the ends of a loop; `None` if it, or one of its bodies, is disabled.
pub(crate) fn ends<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    name: &str,
    given: &schema::Loop<S>,
) -> Result<Option<Ends<S>>, FieldError> {
    let ends = [("first", &given.first), ("second", &given.second)];
    for (which, end) in ends {
        let bodies = scenario.bodies.keys().map(|body| body.as_str());
        known(&format!("loops.{name}.{which}.body"), &end.body, bodies.chain([schema::WORLD]))?;
    }
    if given.constraints.is_empty() {
        return Err(FieldError::new(format!("loops.{name}.constraints"), "an empty list", "at least one constraint"));
    }
    let there =
        |(_, end): &(&str, &schema::Attachment<S>)| end.named_body().is_none_or(|body| model.body(body).is_some());
    if !given.enabled || !ends.iter().all(there) {
        return Ok(None);
    }
    let place = |(which, end): (&str, &schema::Attachment<S>)| {
        attachment(scenario, model, &format!("loops.{name}.{which}.position_m"), end)
    };
    Ok(Some(Ends { first: place(ends[0])?, second: place(ends[1])? }))
}

/// Returns an attachment relative to the centre of mass of its body.
fn attachment<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    field: &str,
    given: &schema::Attachment<S>,
) -> Result<Attachment<S>, FieldError> {
    let (body, centre) = carrier_in_model(scenario, model, given.named_body(), field, given.position_m)?;
    let position = Vector3(given.position_m) - centre;
    let rotation = rotation_from_roll_pitch_yaw(Vector3(given.orientation_rad));
    Ok(Attachment::on(body, Frame { rotation, position }))
}

/// Returns the constraints as types of the engine, with their names.
pub(crate) fn constraints<S: Quantity>(given: &schema::Loop<S>) -> Vec<(&'static str, Constraint<S>)> {
    let turn = |constraint: &schema::Constraint<S>| match constraint {
        schema::Constraint::Roll => Some(RotationAxis::Roll),
        schema::Constraint::Pitch => Some(RotationAxis::Pitch),
        schema::Constraint::Yaw => Some(RotationAxis::Yaw),
        _ => None,
    };
    let turns: Vec<RotationAxis> = given.constraints.iter().filter_map(turn).collect();
    let constraint = |constraint: &schema::Constraint<S>| {
        let meant = match constraint {
            schema::Constraint::X => Constraint::Offset(0),
            schema::Constraint::Y => Constraint::Offset(1),
            schema::Constraint::Z => Constraint::Offset(2),
            schema::Constraint::Roll => Constraint::rotation(RotationAxis::Roll, &turns),
            schema::Constraint::Pitch => Constraint::rotation(RotationAxis::Pitch, &turns),
            schema::Constraint::Yaw => Constraint::rotation(RotationAxis::Yaw, &turns),
            schema::Constraint::Distance(given) => Constraint::Distance(given.length_m.get()),
        };
        (constraint.name(), meant)
    };
    given.constraints.iter().map(constraint).collect()
}

/// Changes the initial positions so that the loops are closed, and the initial velocities so that they stay
/// closed: also those that are released later.
///
/// # Errors
/// A gap larger than the scenario allows, a constraint that depends on others or that no coordinate affects,
/// a loop that cannot be closed.
pub fn close<S: Quantity>(scenario: &Scenario<S>, setup: &mut Setup<S>) -> Result<(), FieldError> {
    let loops = some(scenario, &setup.model, |given| given.connection.as_ref().is_none_or(Connection::begins_closed))?;
    if loops.is_empty() {
        return Ok(());
    }
    let Setup { model, q, v, .. } = setup;
    let model = &model.clone().with_loops(loops);
    let (mut links, mut work, mut loads) = (LinkKinematics::new(model), Workspace::new(model), Loads::new(model));
    let mut solver = LoopSolver::new(model, 0);
    // Ropes are initialised after the loops are closed.
    let hold = &mut |_: &LinkKinematics<S>, _: &[S], _: &[S], _: &mut [TemporaryConstraint<S>]| {};
    let mut on = Projection { model, links: &mut links, work: &mut work, loads: &mut loads, hold };
    solver.begin_at(&mut on, q, v);
    check_start(scenario, model, solver.rows())?;
    let closed = solver.assemble(&mut on, q, v);
    check_independence(model, &solver)?;
    if closed {
        return Ok(());
    }
    let (name, gaps) = gaps(model, solver.rows()).into_iter().next().unwrap_or_default();
    let found = format!("a loop that stays open by {gaps} at the closest position of its joints");
    Err(FieldError::new(format!("loops.{name}"), found, "lengths and a start from which the loop closes"))
}

/// Removes the velocities with which closed loops would open.
///
/// # Errors
/// A constraint that depends on others or that no coordinate affects.
pub(crate) fn rest_in_loops<S: Quantity>(model: &Model<S>, q: &[S], v: &mut [S]) -> Result<(), FieldError> {
    let (mut links, mut work, mut loads) = (LinkKinematics::new(model), Workspace::new(model), Loads::new(model));
    let mut solver = LoopSolver::new(model, 0);
    let hold = &mut |_: &LinkKinematics<S>, _: &[S], _: &[S], _: &mut [TemporaryConstraint<S>]| {};
    let mut on = Projection { model, links: &mut links, work: &mut work, loads: &mut loads, hold };
    solver.begin_at(&mut on, q, v);
    check_independence(model, &solver)?;
    solver.strike(&mut on, q, v);
    Ok(())
}

/// Checks that the gap at the start is not larger than the scenario allows.
fn check_start<S: Quantity>(scenario: &Scenario<S>, model: &Model<S>, rows: &[Row<S>]) -> Result<(), FieldError> {
    let mut rows = rows.iter();
    for closed in &model.loops {
        let allowed = scenario.loops[closed.name.as_str()].start_gap_m.get();
        let own: Vec<Row<S>> = rows.by_ref().take(closed.constraints.len()).copied().collect();
        if !own.iter().all(|row| row.residual.all(|gap| gap.abs() <= allowed)) {
            let gaps = worded(closed, &own);
            let allowed = format!("at most {allowed} m or rad: start_gap_m");
            return Err(FieldError::new(
                format!("loops.{}", closed.name),
                format!("a gap at the start of {gaps}"),
                allowed,
            ));
        }
    }
    Ok(())
}

/// Checks that each constraint is independent of those before it and that some coordinate affects it.
fn check_independence<S: Quantity>(model: &Model<S>, solver: &LoopSolver<S>) -> Result<(), FieldError> {
    let Some(dependent) = solver.factor().dependent() else { return Ok(()) };
    let all = model.constraint_names();
    let (closed, own) = model
        .loops
        .iter()
        .flat_map(|closed| (0..closed.constraints.len()).map(move |own| (closed, own)))
        .nth(dependent)
        .expect("a pivot is of a constraint");
    let others: Vec<&str> = solver.factor().depends_on(dependent).into_iter().map(|i| all[i].as_str()).collect();
    let why = match others.as_slice() {
        [] => "which no free coordinate can change".to_owned(),
        others => format!("which depends on {}", others.join(", ")),
    };
    let found = format!("{}, {why}", closed.constraints[own].0);
    let allowed = "independent constraints: omit this one";
    Err(FieldError::new(format!("loops.{}.constraints.{own}", closed.name), found, allowed))
}

/// Returns the open loops with their gaps.
fn gaps<S: Quantity>(model: &Model<S>, rows: &[Row<S>]) -> Vec<(String, String)> {
    let mut rows = rows.iter();
    let mut open = Vec::new();
    for closed in &model.loops {
        let own: Vec<Row<S>> = rows.by_ref().take(closed.constraints.len()).copied().collect();
        // m and rad: one nanometre. It exceeds the rounding of positions up to 1e6 m, and is far below the
        // accuracy of a drawing.
        if !own.iter().all(|row| row.residual.all(|gap| gap.abs() < 1e-9)) {
            open.push((closed.name.clone(), worded(closed, &own)));
        }
    }
    open
}

/// Returns the gap as text: `0.2500 m in x, -0.0100 rad in roll`.
fn worded<S: Quantity>(closed: &Loop<S>, rows: &[Row<S>]) -> String {
    let one = |((name, constraint), row): (&(String, Constraint<S>), &Row<S>)| {
        format!("{:.4} {} in {name}", row.residual, constraint.unit())
    };
    closed.constraints.iter().zip(rows).map(one).collect::<Vec<_>>().join(", ")
}
