//! The sea and the hulls in it.

use super::super::schema::{self, Force as ForceSchema, Hydrostatics as HydrostaticsSchema, Scenario};
use super::damping::{current, from_centre};
use super::waves::{self, Wave};
use super::{FieldError, gravity_of, known};
use crate::elements::hull::{
    Excitation, FloatingMesh, HullFrame, Hydrostatics, LinearLimits, MeshInWaves, Parts, QuadraticTerms, Radiation,
};
use crate::elements::{AnyElement, Hull};
use crate::model::{JointKind, Model};
use crate::scalar::Scalar;
use crate::scenario::leaf::Quantity;
use crate::sea::database::{Database, SixBySix};
use crate::sea::hull::{HullMesh, LinearHydrostatics};
use crate::sea::waves::{Water, WaveField};
use crate::spatial::{Frame, Matrix3, SpatialInertia, Symmetric3, Vector3};

/// The model with the water's inertia, and the water's loads.
pub fn build<S: Quantity>(
    scenario: &Scenario<S>,
    mut model: Model<S>,
) -> Result<(Model<S>, Vec<AnyElement<S>>), FieldError> {
    let mut hulls: Vec<AnyElement<S>> = Vec::new();
    for (name, force) in &scenario.forces {
        let Some(given) = hydrodynamics_of(force).filter(|given| given.enabled) else { continue };
        let field = |rest: &str| format!("forces.{name}.hydrodynamics.{rest}");
        let body = floating_body(scenario, &model, &field("body"), &given.body)?;
        let Some(database) = scenario.files.database(&given.database) else { continue };
        let sea = Sea::of(scenario, &field("database"), database)?;
        let origin = from_centre(scenario, &given.body, Vector3(given.origin_m));
        if given.added_mass {
            let added = inertia(&database.added_mass_infinite).to_parent(&Frame::translation(origin));
            model = model.with_added_inertia(body, added);
        }
        let excitation = sea.excitation(given, &field, database)?;
        let hydrostatics = hydrostatics(given, &field("hydrostatics"), database)?;
        let hull = Hull {
            name: name.to_string(),
            frame: HullFrame { body, origin },
            specific_weight: sea.specific_weight,
            wave_pressure: wave_pressure(given, &field("wave_pressure"), &hydrostatics, excitation.as_ref())?,
            hydrostatics,
            radiation: radiation(given, &field("radiation"), database)?,
            current: sea.current,
            limits: limits(given, database, origin.0.map(Scalar::value)),
            quadratic_terms: QuadraticTerms {
                of_slow_motion: excitation.is_some(),
                munk_by_table: has_current_table(scenario, given),
            },
            cutoff_rad_s: given.slow_motion_cutoff_rad_s.get(),
            wave_data: given.excitation.then(|| std::sync::Arc::clone(database)),
            excitation,
        };
        hulls.push(Box::new(hull));
    }
    Ok((model, hulls))
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

/// A hull floats: its body's joint leaves it to the water.
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

/// The whole 6x6 of added mass, force first in the database, moment first here.
fn inertia<S: Scalar>(added: &SixBySix) -> SpatialInertia<S> {
    let entry = |i: usize, j: usize| S::constant(0.5 * (added[i][j] + added[j][i]));
    let block = |row: usize, column: usize| Matrix3::from_fn(|i, j| entry(row + i, column + j));
    SpatialInertia {
        angular: Symmetric3::from_upper(&block(3, 3)),
        coupling: block(3, 0),
        linear: Symmetric3::from_upper(&block(0, 0)),
    }
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
                return Err(FieldError::new(field, "mesh, with a database that holds none", "linear, or none"));
            };
            let mesh = HullMesh::new(mesh.vertices_m.clone(), mesh.triangles.clone());
            let mesh = mesh.map_err(|error| FieldError::new(field, error, "a closed mesh whose normals point out"))?;
            Ok(Hydrostatics::Mesh(Box::new(FloatingMesh::new(mesh))))
        }
    }
}

/// What linear hydrodynamics hold for, where the hull floats by them.
fn limits<S>(given: &schema::Hydrodynamics<S>, database: &Database, origin: [f64; 3]) -> Option<LinearLimits> {
    let mesh = database.hull.mesh.as_ref().map_or(&[][..], |mesh| &mesh.vertices_m);
    let points: Vec<[f64; 3]> = mesh.iter().map(|point| core::array::from_fn(|k| point[k] + origin[k])).collect();
    let is_linear = given.hydrostatics != HydrostaticsSchema::Mesh;
    is_linear.then(|| LinearLimits::new(&given.body, database.hull.draught_m, &points))
}

/// The mesh in the waves that excite the hull.
fn wave_pressure<S: Quantity>(
    given: &schema::Hydrodynamics<S>,
    field: &str,
    hydrostatics: &Hydrostatics<S>,
    excitation: Option<&Excitation<S>>,
) -> Result<Option<Box<MeshInWaves<S>>>, FieldError> {
    match (hydrostatics, excitation) {
        _ if !given.wave_pressure => Ok(None),
        (Hydrostatics::Mesh(floating), Some(waves)) => {
            Ok(Some(Box::new(MeshInWaves::new((**floating).clone(), waves.field().clone()))))
        }
        (Hydrostatics::Mesh(_), None) => Ok(None),
        _ => Err(FieldError::new(field, "true, with hydrostatics that are not of the mesh", "hydrostatics: mesh")),
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
        None => Err(FieldError::new(field, "true, with a database that holds no model of radiation", "false")),
    }
}

/// The water that a hull floats in, as the scenario has it.
struct Sea<'a, S> {
    scenario: &'a Scenario<S>,
    given: schema::Sea<S>,
    gravity: (S, String),
    specific_weight: S,
    current: Vector3<S>,
}

impl<'a, S: Quantity> Sea<'a, S> {
    fn of(scenario: &'a Scenario<S>, field: &str, database: &Database) -> Result<Self, FieldError> {
        let (given, gravity) = (scenario.sea.clone().unwrap_or_default(), gravity(scenario)?);
        let (water, density) = (&database.water, given.density_kg_m3.get());
        same(field, "density of", water.density_kg_m3, "kg/m^3", density)?;
        same(field, "gravity of", water.gravity_m_s2, "m/s^2", gravity.0)?;
        let infinite = f64::INFINITY;
        let depth = given.depth_m.map_or(S::constant(infinite), |depth| depth.get());
        same(field, "depth of", water.depth_m.unwrap_or(infinite), "m", depth)?;
        Ok(Self { scenario, specific_weight: density * gravity.0, current: current(scenario), gravity, given })
    }

    /// The water as the waves know it. Its density is that of their pressure alone.
    fn water(&self, wave_pressure: bool) -> Result<Water, FieldError> {
        let (density, field) = (self.given.density_kg_m3.get(), "sea.density_kg_m3");
        let density = if wave_pressure { density.same(field)? } else { density.scaled(field)?.0 };
        water_of(&self.given, density, &self.gravity)
    }

    fn excitation(
        &self,
        given: &schema::Hydrodynamics<S>,
        field: &impl Fn(&str) -> String,
        database: &Database,
    ) -> Result<Option<Excitation<S>>, FieldError> {
        if given.wave_drift && database.mean_drift.is_none() {
            let found = "true, with a database that holds no mean drift";
            return Err(FieldError::new(
                field("wave_drift"),
                found,
                "false, or a database that kingpost hydro --loading made",
            ));
        }
        if given.wave_pressure && !database.has_froude_krylov() {
            let found =
                "true, with a database whose excitation is not told apart into Froude-Krylov force and diffraction";
            return Err(FieldError::new(field("wave_pressure"), found, "false"));
        }
        if given.wave_pressure && given.wave_drift {
            let found = "true, with wave_pressure, whose mean over the mesh is a part of the same drift";
            return Err(FieldError::new(field("wave_drift"), found, "one of the two"));
        }
        if !self.given.waves.values().any(schema::Waves::enabled) {
            return Ok(None);
        }
        let water = self.water(given.wave_pressure)?;
        let waves = waves::build(self.scenario, &water)?;
        if waves.is_empty() || !given.excitation {
            return Ok(None);
        }
        check_coverage(&field("database"), database.band_rad_s(), &waves)?;
        let parts = Parts { froude_krylov: !given.wave_pressure, drift: given.wave_drift };
        let waves: Vec<_> = waves.iter().map(Wave::component).collect();
        Ok(Some(Excitation::new(database, WaveField::new(&waves, water, self.given.ramp_s.get()), parts)))
    }
}

/// The waves of the scenario's sea, where there are any.
pub(super) fn incident_waves<S: Quantity>(scenario: &Scenario<S>) -> Result<Option<WaveField<S>>, FieldError> {
    let Some(sea) = scenario.sea.as_ref().filter(|sea| sea.waves.values().any(schema::Waves::enabled)) else {
        return Ok(None);
    };
    let Ok(gravity) = gravity(scenario) else { return Ok(None) };
    let (density, _) = sea.density_kg_m3.get().scaled("sea.density_kg_m3")?;
    let water = water_of(sea, density, &gravity)?;
    let components: Vec<_> = waves::build(scenario, &water)?.iter().map(Wave::component).collect();
    Ok((!components.is_empty()).then(|| WaveField::new(&components, water, sea.ramp_s.get())))
}

/// The sea's water, whose waves are the scenario's.
pub(super) fn water_of<S: Quantity>(
    sea: &schema::Sea<S>,
    density_kg_m3: f64,
    gravity: &(S, String),
) -> Result<Water, FieldError> {
    let depth = sea.depth_m.map(|depth| depth.get().same("sea.depth_m")).transpose()?;
    let water = Water::new(density_kg_m3, gravity.0.same(&gravity.1)?, depth);
    water.map_err(|error| FieldError::new(format!("sea.{}", error.field), error.found, error.allowed))
}

/// Gravity's acceleration, by which a sea is level, and its field.
pub(super) fn gravity<S: Quantity>(scenario: &Scenario<S>) -> Result<(S, String), FieldError> {
    let acts = scenario.forces.iter().find_map(|(name, force)| {
        let gravity = gravity_of(force).filter(|gravity| gravity.enabled)?;
        Some((gravity.acceleration_m_s2.get(), format!("forces.{name}.gravity.acceleration_m_s2")))
    });
    acts.ok_or_else(|| FieldError::new("forces", "water on a hull, and no gravity", "gravity that is enabled"))
}

/// By how much a database's water may differ from the sea's, relative.
const SAME_WATER: f64 = 1e-4;

fn same<S: Quantity>(field: &str, what: &str, found: f64, unit: &str, sea: S) -> Result<(), FieldError> {
    // Infinite depth is near to no other.
    let near = |sea: f64| found.is_finite() && sea.is_finite() && (found - sea).abs() <= SAME_WATER * sea.abs();
    if sea.all(|sea| found == sea || near(sea)) {
        return Ok(());
    }
    Err(FieldError::new(field, format!("a {what} {found} {unit}"), format!("that of the sea, {sea} {unit}")))
}

/// Share of the waves' energy that may lie outside the frequencies of a table.
const MOST_UNCOVERED: f64 = 0.01;

/// An error where a table of a hull's response, from `band_rad_s[0]` to `band_rad_s[1]`, leaves out what the waves hold.
pub(super) fn check_coverage<S: Quantity>(
    field: &str,
    [lowest, highest]: [f64; 2],
    waves: &[Wave<S>],
) -> Result<(), FieldError> {
    let energy = |counts: &dyn Fn(f64) -> bool| {
        let counted = waves.iter().filter(|wave| counts(wave.of.angular_frequency_rad_s));
        counted.fold(S::ZERO, |sum, wave| sum + wave.amplitude_m * wave.amplitude_m)
    };
    let (outside, all) = (energy(&|omega| !(lowest..=highest).contains(&omega)), energy(&|_| true));
    if (S::constant(MOST_UNCOVERED) * all - outside).all(|room| room >= 0.0) {
        return Ok(());
    }
    let share = S::constant(100.0) * outside / all;
    let found = format!("frequencies from {lowest} to {highest} rad/s, with {share:.1} % of the waves' energy outside");
    let allowed = format!("frequencies that leave at most {} % outside", 100.0 * MOST_UNCOVERED);
    Err(FieldError::new(field, found, allowed))
}
