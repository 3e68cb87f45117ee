//! Hydrostatics of the hulls of a scenario with the crane in its present position: draught, heel and trim at
//! rest, metacentric height (with hanging loads at their suspension points and free surfaces of slack tanks),
//! and righting arms.
//!
//! ```no_run
//! # fn of(scenario: &kingpost::Scenario) -> Result<(), kingpost::hydrostatics::HydrostaticsError> {
//! let report = scenario.hydrostatic_report()?;
//! for hull in &report.hulls {
//!     println!("{}: GM {:.2} m", hull.body, hull.metacentric_height_m[0]);
//! }
//! # Ok(())
//! # }
//! ```

mod floating;
mod free_surface;
mod hanging;
mod in_current;
mod liquids;
mod righting;
mod unsuspended;
mod wave_data;

pub use hanging::HangingLoad;
pub use liquids::FreeSurface;
pub use righting::{LargestArm, RightingArmCurve, RightingArmPoint, Side};

use crate::dynamics::Kinematics;
use crate::elements::Hull;
use crate::model::Model;
use crate::scenario::{BuiltScenario, Scenario, ScenarioError};
use crate::sea::database::Database;
use crate::sea::hull::StabilityError;
use crate::simulation::{Setup, Simulation};
use floating::LoadedHull;
use hanging::Restraints;
use liquids::Liquids;
use serde::Serialize;
use thiserror::Error;

/// The hulls of a scenario, and warnings.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HydrostaticReport {
    /// One for each hull in the water.
    pub hulls: Vec<HullAfloat>,
    /// Warnings.
    pub warnings: Vec<String>,
}

/// A hull at rest in still water, with all bodies that its joints carry. The first number of a pair is for
/// heel (across the ship), the second for trim (along the ship).
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HullAfloat {
    /// Name of the force in the scenario.
    pub force: String,
    /// The body that is the hull.
    pub body: String,
    /// Mass of the hull and all that its joints carry, kg.
    pub mass_kg: f64,
    /// Mass of the water that it displaces, kg.
    pub displacement_kg: f64,
    /// V, m^3.
    pub displacement_m3: f64,
    /// Depth of the keel below the database's origin, m; the keel is the point `draught_m` of the database below the
    /// origin, in hull axes.
    pub draught_m: f64,
    /// The draught of the database, m.
    pub database_draught_m: f64,
    /// Heel to starboard, rad.
    pub heel_rad: f64,
    /// Trim by the bow, rad.
    pub trim_rad: f64,
    /// KB, m: all heights above the keel are along the hull's z.
    pub keel_to_buoyancy_m: f64,
    /// BM, `I / V`, m.
    pub metacentric_radius_m: [f64; 2],
    /// KM, `KB + BM`, m.
    pub keel_to_metacentre_m: [f64; 2],
    /// KG, m, with every load and the liquid in slack tanks in their present position.
    pub keel_to_gravity_m: f64,
    /// KG, m, with hanging loads at their suspension points, plus the reduction of GM by free surfaces.
    pub fluid_keel_to_gravity_m: [f64; 2],
    /// GM with every load fixed in its present position, m.
    pub solid_metacentric_height_m: [f64; 2],
    /// GM, m, with hanging loads at their suspension points, less the reduction by free surfaces.
    pub metacentric_height_m: [f64; 2],
    /// The hanging loads.
    pub hanging: Vec<HangingLoad>,
    /// The free surfaces of slack tanks, U-tanks and free-flooding tanks.
    pub free_surfaces: Vec<FreeSurface>,
    /// GZ to the side of the list; `None` without a mesh.
    pub righting_arm: Option<RightingArmCurve>,
    /// Whether volume, KB and BM are computed from the floating mesh; otherwise they follow from the
    /// waterplane at the database's draught, moved along the hull's z.
    pub by_mesh: bool,
    /// Whether this position is computed with the mesh's buoyancy, like the run; otherwise with linear
    /// buoyancy. The righting arms always use the mesh, so with linear buoyancy they can pass through zero at
    /// another heel.
    pub rests_by_mesh: bool,
}

/// Reason why a report is not possible.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum HydrostaticsError {
    /// The scenario does not build.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// A hull does not float.
    #[error("forces.{force}.hydrodynamics: {error}")]
    Hull {
        /// Name of the force.
        force: String,
        /// The reason.
        error: StabilityError,
    },
}

impl Scenario {
    /// Returns the floating position and stability of the hulls at rest in still water, with the crane in its
    /// position at the start of a run.
    ///
    /// # Errors
    /// As [`Self::hydrostatic_report_at`].
    pub fn hydrostatic_report(&self) -> Result<HydrostaticReport, HydrostaticsError> {
        self.clone().build()?.hydrostatic_report()
    }

    /// Returns the floating position and stability of the hulls at the equilibrium of a simulation in still
    /// water, with held and prescribed coordinates at their present values. If there is no equilibrium, or
    /// the water carries no body, the list of hulls is empty and a warning gives the reason.
    ///
    /// # Errors
    /// A hull whose weight is more than the whole hull displaces.
    pub fn hydrostatic_report_at(&self, simulation: &Simulation) -> Result<HydrostaticReport, HydrostaticsError> {
        self.hydrostatic_report_of(&self.setup()?, simulation)
    }

    /// Reports the floating position and stability of the hulls for a setup of the scenario.
    fn hydrostatic_report_of(
        &self,
        setup: &Setup,
        simulation: &Simulation,
    ) -> Result<HydrostaticReport, HydrostaticsError> {
        let mut report = HydrostaticReport::default();
        let hulls: Vec<Hull> = Hull::among(&setup.elements).cloned().collect();
        let hulls = hulls.iter().filter_map(|hull| Some((hull, self.database_of(&hull.name)?)));
        let hulls: Vec<(&Hull, &Database)> = hulls.collect();
        if hulls.is_empty() {
            return Ok(report);
        }
        let (model, world) = (setup.model.clone(), &setup.world);
        let liquids = &Liquids::of(&setup.elements);
        let restraints_at = |q: &[f64]| Restraints::of(Setup { q: q.to_vec(), ..setup.clone() });
        let (now, restraints) = (kinematics(&model, &simulation.state().q), &restraints_at(&simulation.state().q));
        let mut sunk: Vec<&str> = Vec::new();
        for &(hull, database) in &hulls {
            let floating = LoadedHull { hull, database, model: &model, at: &now, world, liquids, restraints };
            report.warnings.extend(floating.current_warnings());
            match floating.check_capacity() {
                Err(error) if restraints.floats_alone(&model, hull.frame.body) => return Err(error),
                Err(error) => {
                    let body = &model.bodies[hull.frame.body].name;
                    report.warnings.push(format!("no hydrostatics of {body}, which does not float by itself: {error}"));
                    sunk.push(&hull.name);
                }
                Ok(()) => {}
            }
        }
        let mut simulation = simulation.clone();
        match simulation.settle() {
            Ok(found) => {
                let instability = found.instability.map(|why| format!("the equilibrium is not stable: {why}"));
                report.warnings.extend(instability);
            }
            Err(error) => {
                report.warnings.push(format!("no hydrostatics: {error}"));
                return Ok(report);
            }
        }
        let at_rest = kinematics(&model, &simulation.state().q);
        let restraints = &restraints_at(&simulation.state().q);
        for (hull, database) in hulls.into_iter().filter(|(hull, _)| !sunk.contains(&hull.name.as_str())) {
            let floating = LoadedHull { hull, database, model: &model, at: &at_rest, world, liquids, restraints };
            let (afloat, mut warnings) = floating.describe();
            if let Some(afloat) = afloat.as_ref().filter(|_| self.drifts(&hull.name)) {
                warnings.extend(floating.drift_warnings(afloat.keel_to_gravity_m));
            }
            warnings.extend(floating.direction_warnings());
            warnings.extend(afloat.iter().flat_map(|afloat| floating.unsuspended(afloat)));
            report.hulls.extend(afloat);
            report.warnings.extend(warnings);
        }
        Ok(report)
    }

    /// Returns whether the mean drift of the hull's database acts on it.
    fn drifts(&self, force: &str) -> bool {
        self.hydrodynamics(force).is_some_and(|given| given.wave_drift)
    }
}

impl BuiltScenario {
    /// Returns the floating position and stability of the hulls, like [`Scenario::hydrostatic_report`].
    ///
    /// # Errors
    /// Fails where [`Scenario::hydrostatic_report`] does.
    pub fn hydrostatic_report(&self) -> Result<HydrostaticReport, HydrostaticsError> {
        self.hydrostatic_report_at(&Simulation::new(self.setup().clone()))
    }

    /// Returns the floating position and stability of the hulls with the crane in its position in a
    /// simulation, like [`Scenario::hydrostatic_report_at`].
    ///
    /// # Errors
    /// Fails where [`Scenario::hydrostatic_report_at`] does.
    pub fn hydrostatic_report_at(&self, simulation: &Simulation) -> Result<HydrostaticReport, HydrostaticsError> {
        self.scenario().hydrostatic_report_of(self.setup(), simulation)
    }
}

/// Returns the JSON Schema of [`HydrostaticReport`].
#[cfg(feature = "schema")]
pub fn json_schema() -> serde_json::Value {
    crate::scenario::json_schema::published::<HydrostaticReport>()
}

fn kinematics(model: &Model, q: &[f64]) -> Kinematics {
    let mut at = Kinematics::new(&model.tree);
    at.update(&model.tree, q, &vec![0.0; model.velocity_count]);
    at
}
