//! The hulls in the sea.

mod coupling;

use crate::elements::hull::{
    AddedMass, Carried, CoefficientFrame, FloatingMesh, HullFrame, Hydrostatics, LinearLimits, MeanAttitude,
    MeshInWaves, Plan, QuadraticTerms, Radiation, WaveCoordinates, WaveExcitation, WaveForceSwitches, added_inertia,
};
use crate::elements::{AnyElement, AnyWatcher, Hull, MeanHeading};
use crate::model::{JointKind, Model};
use crate::scalar::Scalar;
use crate::scenario::assembly::assemble::{Assemble, Surroundings};
use crate::scenario::assembly::rigid_bodies::from_centre;
use crate::scenario::assembly::{FieldError, known, still_water};
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Force as ForceSchema, Hydrostatics as HydrostaticsSchema, Scenario};
use crate::sea::database::{Attitude, Database};
use crate::sea::hull::{HullMesh, LinearHydrostatics};
use crate::sea::waves::WaveField;
use crate::spatial::{Frame, SpatialInertia, Vector3, rotation_from_roll_pitch_yaw};
use crate::world::World;
use coupling::{CoupledForce, interaction, place_in};
use indexmap::IndexMap;
use std::sync::Arc;

/// Adds the added mass of the water to the model, and returns the loads of the water.
pub fn build<S: Quantity>(
    scenario: &Scenario<S>,
    mut model: Model<S>,
    world: &World<S>,
) -> Result<(Model<S>, Vec<AnyElement<S>>), FieldError> {
    let mut hulls: Vec<Hull<S>> = Vec::new();
    let mut coupled: Vec<CoupledForce<'_, S>> = Vec::new();
    for (name, force) in &scenario.forces {
        let Some(given) = hydrodynamics_of(force).filter(|given| given.enabled) else { continue };
        let Some(data) = scenario.files.hydrodynamic_data(&given.database) else { continue };
        let place = place_in(name, given, data)?;
        let Some(database) = scenario.files.database(&given.database, given.name_in_database()) else { continue };
        let hull = hull(scenario, &model, world, name, given, database)?;
        if let Some(added) = &hull.added_mass {
            model = model.with_added_inertia(hull.frame.body, added.in_body);
        }
        coupled.push(CoupledForce { name, given, place, origin_m: hull.frame.origin.0.map(Scalar::value) });
        hulls.push(hull);
    }
    let interactions = interactions(scenario, &model, coupled, &mut hulls)?;
    let hulls = hulls.into_iter().map(|hull| -> AnyElement<S> { Box::new(hull) });
    Ok((model, hulls.chain(interactions).collect()))
}

/// Returns the interactions, one for each database of several hulls.
fn interactions<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    coupled: Vec<CoupledForce<'_, S>>,
    hulls: &mut [Hull<S>],
) -> Result<Vec<AnyElement<S>>, FieldError> {
    let mut by_file: IndexMap<&str, Vec<(usize, CoupledForce<'_, S>)>> = IndexMap::new();
    for (hull, force) in coupled.into_iter().enumerate() {
        by_file.entry(&*force.given.database).or_default().push((hull, force));
    }
    let mut interactions: Vec<AnyElement<S>> = Vec::new();
    for (file, coupled) in by_file {
        let data = scenario.files.hydrodynamic_data(file);
        let Some(coupling) = data.and_then(|data| data.coupling()) else { continue };
        let (places, coupled): (Vec<usize>, Vec<CoupledForce<'_, S>>) = coupled.into_iter().unzip();
        let own: Vec<&Hull<S>> = places.iter().map(|&place| &hulls[place]).collect();
        interactions.push(Box::new(interaction(scenario, model, coupling, &coupled, &own)?));
        let bodies: Vec<usize> = own.iter().map(|hull| hull.frame.body).collect();
        for place in places {
            let body = hulls[place].frame.body;
            hulls[place].feels = bodies.iter().copied().filter(|other| *other != body).collect();
        }
    }
    Ok(interactions)
}

/// Returns one hull.
fn hull<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    world: &World<S>,
    name: &str,
    given: &schema::Hydrodynamics<S>,
    database: &Arc<Database>,
) -> Result<Hull<S>, FieldError> {
    let field = |rest: &str| format!("forces.{name}.hydrodynamics.{rest}");
    let body = floating_body(scenario, model, &field("body"), &given.body)?;
    still_water::gravity(scenario)?;
    check_water(&field("database"), database, world)?;
    let origin = from_centre(scenario, &given.body, Vector3(given.origin_m));
    let coefficients = CoefficientFrame { body, in_body: Frame::translation(origin).times(&attitude(database)) };
    let radiation = radiation(given, &field("radiation"), database)?;
    let added = || AddedMass::new(&database.added_mass_infinite, radiation.as_ref(), &coefficients);
    let added_mass = given.added_mass.then(added);
    let excitation = excitation(given, &field, database, world)?;
    let hydrostatics = hydrostatics(given, &field("hydrostatics"), database)?;
    let waves = world.waves.as_ref().filter(|_| excitation.is_some());
    Ok(Hull {
        name: name.to_string(),
        frame: HullFrame { body, origin },
        wave_pressure: wave_pressure(given, &field("wave_pressure"), &hydrostatics, waves)?,
        hydrostatics,
        coordinates: WaveCoordinates {
            coefficients,
            carried: carried(model, body),
            cutoff_rad_s: given.slow_motion_cutoff_rad_s.get(),
        },
        radiation,
        added_mass,
        plan: Plan::of(&database.hull, origin.0.map(Scalar::value)),
        watchers: watchers(given, database, origin.0.map(Scalar::value), excitation.is_some()),
        feels: Vec::new(),
        quadratic_terms: QuadraticTerms {
            of_slow_motion: excitation.is_some(),
            munk_by_table: has_current_table(scenario, given),
        },
        wave_data: given.excitation.then(|| Arc::clone(database)),
        excitation,
    })
}

/// Returns the axes of a database's coefficients, relative to those of the upright hull.
fn attitude<S: Scalar>(database: &Database) -> Frame<S> {
    let Some(Attitude { roll_rad, pitch_rad, height_m }) = database.hull.attitude else { return Frame::identity() };
    let rotation = rotation_from_roll_pitch_yaw(Vector3([roll_rad, pitch_rad, 0.0].map(S::constant)));
    Frame { rotation, position: Vector3([0.0, 0.0, height_m].map(S::constant)) }.inverse()
}

/// Returns all bodies that a hull carries, each with its share of the total mass.
fn carried<S: Scalar>(model: &Model<S>, hull: usize) -> Carried<S> {
    let bodies = model.carried(hull);
    let mass = bodies.iter().fold(S::ZERO, |sum, &body| sum + model.bodies[body].mass);
    let share = |&body: &usize| (body, model.bodies[body].mass / mass);
    Carried { shares: bodies.iter().skip(1).map(share).collect() }
}

fn hydrodynamics_of<S>(force: &ForceSchema<S>) -> Option<&schema::Hydrodynamics<S>> {
    if let ForceSchema::Hydrodynamics(water) = force { Some(water) } else { None }
}

/// Whether a table of current coefficients acts on a hull.
fn has_current_table<S>(scenario: &Scenario<S>, given: &schema::Hydrodynamics<S>) -> bool {
    scenario.forces.values().any(|force| match force {
        ForceSchema::CurrentLoad(load) => load.enabled && load.body == given.body,
        _ => false,
    })
}

/// Checks that the body of a hull has a floating joint.
fn floating_body<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    field: &str,
    name: &str,
) -> Result<usize, FieldError> {
    known(field, name, scenario.bodies.keys().map(|body| body.as_str()))?;
    let body = model.body(name).filter(|&body| matches!(model.joints[body].kind, JointKind::Floating(_)));
    body.ok_or_else(|| FieldError::new(field, name, "a body that is enabled and has a floating joint"))
}

/// Returns the contribution of the radiation memory to a body's inertia in slow motions, in body axes about the centre
/// of mass.
pub(crate) fn memory_of_slow_motions<S: Quantity>(scenario: &Scenario<S>, body: &str) -> SpatialInertia<S> {
    let hulls = scenario.forces.values().filter_map(hydrodynamics_of);
    let remembers = |given: &&schema::Hydrodynamics<S>| given.enabled && given.radiation && *given.body == *body;
    hulls.filter(remembers).fold(SpatialInertia::default(), |sum, given| {
        let Some(database) = scenario.files.database(&given.database, given.name_in_database()) else { return sum };
        let Some(fitted) = &database.radiation else { return sum };
        let origin = from_centre(scenario, body, Vector3(given.origin_m));
        let axes = Frame::translation(origin).times(&attitude(database));
        sum + added_inertia(&Radiation::new(fitted).added_mass()).to_parent(&axes)
    })
}

fn hydrostatics<S: Quantity>(
    given: &schema::Hydrodynamics<S>,
    field: &str,
    database: &Database,
) -> Result<Hydrostatics<S>, FieldError> {
    match given.hydrostatics {
        HydrostaticsSchema::None => Ok(Hydrostatics::None),
        HydrostaticsSchema::Linear => {
            let (hull, plane) = (&database.hull, &database.hull.waterplane);
            Ok(Hydrostatics::Linear(LinearHydrostatics {
                volume: hull.volume_m3,
                centre_of_buoyancy: Vector3(hull.centre_of_buoyancy_m),
                waterplane_area: plane.area_m2,
                first_moments: plane.first_moments_m3,
                second_moments: plane.second_moments_m4,
            }))
        }
        HydrostaticsSchema::Mesh => {
            let Some(mesh) = &database.hull.mesh else {
                return Err(FieldError::new(field, "mesh, with a database without a mesh", "linear, or none"));
            };
            let mesh = HullMesh::new(mesh.vertices_m.clone(), mesh.triangles.clone());
            let mesh = mesh.map_err(|error| FieldError::new(field, error, "a closed mesh whose normals point out"))?;
            Ok(Hydrostatics::Mesh(Box::new(FloatingMesh::new(mesh))))
        }
    }
}

/// Returns the watchers of linear hydrodynamics: for the attitude of the coefficients, small motions, and the heading
/// of a hull in waves.
fn watchers<S>(
    given: &schema::Hydrodynamics<S>,
    database: &Database,
    origin: [f64; 3],
    in_waves: bool,
) -> Vec<AnyWatcher> {
    let mut watchers: Vec<AnyWatcher> = Vec::new();
    if given.hydrostatics != HydrostaticsSchema::Mesh {
        let mesh = database.hull.mesh.as_ref().map_or(&[][..], |mesh| &mesh.vertices_m);
        let points: Vec<[f64; 3]> = mesh.iter().map(|point| core::array::from_fn(|k| point[k] + origin[k])).collect();
        watchers.push(Box::new(LinearLimits::new(&given.body, database.hull.draught_m, &points)));
    }
    if given.added_mass || given.radiation || given.excitation {
        watchers.push(Box::new(MeanAttitude::new(&given.body, database.hull.attitude)));
    }
    if in_waves {
        watchers.push(Box::new(MeanHeading::new(&given.body)));
    }
    watchers
}

/// Returns the mesh for the wave pressure on the hull.
fn wave_pressure<S: Quantity>(
    given: &schema::Hydrodynamics<S>,
    field: &str,
    hydrostatics: &Hydrostatics<S>,
    waves: Option<&WaveField<S>>,
) -> Result<Option<Box<MeshInWaves<S>>>, FieldError> {
    match (hydrostatics, waves) {
        _ if !given.wave_pressure => Ok(None),
        (Hydrostatics::Mesh(floating), Some(waves)) => {
            Ok(Some(Box::new(MeshInWaves::new((**floating).clone(), waves))))
        }
        (Hydrostatics::Mesh(_), None) => Ok(None),
        _ => Err(FieldError::new(field, "true, without hydrostatics: mesh", "hydrostatics: mesh")),
    }
}

fn radiation<S>(
    given: &schema::Hydrodynamics<S>,
    field: &str,
    database: &Database,
) -> Result<Option<Radiation>, FieldError> {
    match &database.radiation {
        _ if !given.radiation => Ok(None),
        Some(fitted) => Ok(Some(Radiation::new(fitted))),
        None => Err(FieldError::new(field, "true, with a database without a radiation model", "false")),
    }
}

/// Returns an error unless the database was computed for the world's water.
fn check_water<S: Quantity>(field: &str, database: &Database, world: &World<S>) -> Result<(), FieldError> {
    let (water, infinite) = (&database.water, f64::INFINITY);
    same(field, "density of", water.density_kg_m3, "kg/m^3", world.water_density)?;
    same(field, "gravity of", water.gravity_m_s2, "m/s^2", world.gravity)?;
    same(field, "depth of", water.depth_m.unwrap_or(infinite), "m", world.depth.unwrap_or(S::constant(infinite)))
}

/// Returns the forces of the world's waves on a hull.
fn excitation<S: Quantity>(
    given: &schema::Hydrodynamics<S>,
    field: &impl Fn(&str) -> String,
    database: &Database,
    world: &World<S>,
) -> Result<Option<WaveExcitation<S>>, FieldError> {
    if given.wave_drift && database.mean_drift.is_none() {
        let found = "true, with a database without mean drift";
        let is_alone = database.reach_m == 0.0;
        let allowed = if is_alone { "false, or a database made by kingpost hydro --loading" } else { "false" };
        return Err(FieldError::new(field("wave_drift"), found, allowed));
    }
    if given.wave_pressure && !database.has_froude_krylov() {
        let found = "true, with a database that does not separate Froude-Krylov force and diffraction";
        return Err(FieldError::new(field("wave_pressure"), found, "false"));
    }
    if given.wave_pressure && given.wave_drift {
        let found = "true, with wave_pressure, whose mean contains a part of the same drift";
        return Err(FieldError::new(field("wave_drift"), found, "one of the two"));
    }
    if given.wave_drift_damping && !given.wave_drift {
        return Err(FieldError::new(
            field("wave_drift_damping"),
            "true, without wave_drift",
            "false, or wave_drift: true",
        ));
    }
    let Some(waves) = world.waves.as_ref().filter(|_| given.excitation) else { return Ok(None) };
    check_coverage(&field("database"), database.band_rad_s(), world)?;
    let parts = WaveForceSwitches {
        froude_krylov: !given.wave_pressure,
        drift: given.wave_drift,
        drift_damping: given.wave_drift_damping,
    };
    Ok(Some(WaveExcitation::new(database, waves, parts)))
}

/// Largest relative difference of a database's water properties from the sea's.
const SAME_WATER: f64 = 1e-4;

fn same<S: Quantity>(field: &str, what: &str, found: f64, unit: &str, sea: S) -> Result<(), FieldError> {
    // Infinite depth equals only infinite depth.
    let near = |sea: f64| found.is_finite() && sea.is_finite() && (found - sea).abs() <= SAME_WATER * sea.abs();
    if sea.all(|sea| found == sea || near(sea)) {
        return Ok(());
    }
    let allowed = match found.is_infinite() {
        true => format!("a sea without depth_m, which is infinitely deep, or a database for {sea} {unit}"),
        false => format!("that of the sea, {sea} {unit}"),
    };
    Err(FieldError::new(field, format!("a {what} {found} {unit}"), allowed))
}

/// Share of the waves' energy that may lie outside the frequencies of a table.
const MOST_UNCOVERED: f64 = 0.01;

/// Returns an error if a hull's response table, from `band_rad_s[0]` to `band_rad_s[1]`, does not cover the energy of
/// the waves.
pub(crate) fn check_coverage<S: Quantity>(
    field: &str,
    [lowest, highest]: [f64; 2],
    world: &World<S>,
) -> Result<(), FieldError> {
    let energy = |counts: &dyn Fn(f64) -> bool| {
        let waves = world.waves.iter().flat_map(WaveField::components);
        let counted = waves.filter(|wave| counts(wave.plain().angular_frequency_rad_s));
        counted.fold(S::ZERO, |sum, wave| sum + wave.amplitude_m * wave.amplitude_m)
    };
    let (outside, all) = (energy(&|omega| !(lowest..=highest).contains(&omega)), energy(&|_| true));
    if (S::constant(MOST_UNCOVERED) * all - outside).all(|room| room >= 0.0) {
        return Ok(());
    }
    let share = S::constant(100.0) * outside / all;
    let found = format!("frequencies from {lowest} to {highest} rad/s, with {share:.1} % of the waves' energy outside");
    let allowed = format!(
        "frequencies that leave at most {} % outside: a database with more frequencies, or a narrower band of the sea's spectrum by \
         realisation.lowest_rad_s and realisation.highest_rad_s",
        100.0 * MOST_UNCOVERED
    );
    Err(FieldError::new(field, found, allowed))
}

/// The water on a hull also changes the model, so it is assembled before the forces.
impl<S: Quantity> Assemble<S> for schema::Hydrodynamics<S> {
    fn assemble(&self, _: &str, _: Surroundings<'_, S>) -> Result<Vec<AnyElement<S>>, FieldError> {
        Ok(Vec::new())
    }
}
