//! Description of the sea and of the hulls, for drawing.

use crate::elements::Hull;
use crate::scenario::assembly::waves::cut_off;
use crate::scenario::schema::{self, Scenario};
use crate::sea::database::HullAtRest;
use crate::sea::waves::WaveField;
use crate::simulation::Setup;
use crate::spatial::Vector3;
use crate::world::Wind;
use serde::Serialize;

/// The sea to draw.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SeaDescription {
    /// Density of the water, kg/m^3.
    pub density_kg_m3: f64,
    /// Depth of the still water, m; absent if it is infinite.
    pub depth_m: Option<f64>,
    /// Velocity of the current at the surface, world x and y, m/s.
    pub current_m_s: [f64; 2],
    /// Number of regular waves in the sea; 0 for calm water.
    pub wave_components: usize,
    /// Wave systems whose spectra are cut off.
    pub cut_spectra: Vec<CutSpectrum>,
}

/// The wind to draw.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct WindDescription {
    /// Mean velocity at the reference height, world x and y, m/s.
    pub velocity_m_s: [f64; 2],
    /// Reference height above the still water, m.
    pub height_m: f64,
}

/// A wave spectrum that is partly cut off.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CutSpectrum {
    /// Name of the wave system.
    pub name: String,
    /// Significant wave height of the whole spectrum, m.
    pub significant_height_m: f64,
    /// Share of its energy that is cut off.
    pub energy_cut_off: f64,
}

/// A hull in the water, to draw.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HullDescription {
    /// Name of the force.
    pub name: String,
    /// Its body.
    pub body: String,
    /// The hull's origin, on the waterplane of its data, from the body's centre of mass, body axes, m.
    pub origin_m: [f64; 3],
    /// Draught of its data, m.
    pub draught_m: f64,
    /// Length of its water line, m.
    pub length_m: f64,
    /// Beam of its water line, m.
    pub beam_m: f64,
    /// Whether its buoyancy is linear, for small motions about the draught of its data.
    pub is_linear: bool,
    /// Its mesh, if the data have one.
    pub mesh: Option<MeshDescription>,
}

/// Triangles to draw.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MeshDescription {
    /// From the body's centre of mass, body axes, m.
    pub vertices_m: Vec<[f64; 3]>,
    /// Indices of vertices, counter-clockwise seen from the water.
    pub triangles: Vec<[usize; 3]>,
}

/// Describes the sea, if the scenario has a sea or a hull.
pub fn sea(scenario: &Scenario, setup: &Setup) -> Option<SeaDescription> {
    if scenario.sea.is_none() && Hull::among(&setup.elements).next().is_none() {
        return None;
    }
    let sea = scenario.sea.clone().unwrap_or_default();
    Some(SeaDescription {
        density_kg_m3: sea.density_kg_m3.get(),
        depth_m: sea.depth_m.map(|depth| depth.get()),
        current_m_s: level(setup.world.surface_current()),
        wave_components: setup.world.waves.as_ref().map_or(0, WaveField::len),
        cut_spectra: cut_spectra(scenario),
    })
}

/// Describes the wind, if there is any.
pub fn wind(setup: &Setup) -> Option<WindDescription> {
    let described =
        |wind: &Wind| WindDescription { velocity_m_s: level(wind.along(wind.speed)), height_m: wind.reference_height };
    setup.world.wind.as_ref().map(described)
}

fn level(Vector3([x, y, _]): Vector3) -> [f64; 2] {
    [x, y]
}

fn cut_spectra(scenario: &Scenario) -> Vec<CutSpectrum> {
    let described =
        |(name, significant_height_m, energy_cut_off)| CutSpectrum { name, significant_height_m, energy_cut_off };
    cut_off(scenario).into_iter().map(described).collect()
}

/// Describes the hulls, in the order of results.
pub fn hulls(scenario: &Scenario, setup: &Setup) -> Vec<HullDescription> {
    let described = Hull::among(&setup.elements).filter_map(|hull| {
        let water = scenario.hydrodynamics(&hull.name)?;
        let at_rest = &scenario.database_of(&hull.name)?.hull;
        let is_linear = water.hydrostatics != schema::Hydrostatics::Mesh;
        Some(hull_description(hull, &setup.model.bodies[hull.frame.body].name, at_rest, is_linear))
    });
    described.collect()
}

/// Returns whether the body of this joint is a ship or floats like one.
pub fn floats(joint: &schema::Joint) -> bool {
    matches!(joint, schema::Joint::Floating(_) | schema::Joint::MovedByWaves(_))
}

fn hull_description(hull: &Hull, body: &str, at_rest: &HullAtRest, is_linear: bool) -> HullDescription {
    let origin = hull.frame.origin.0;
    let from_centre = |vertex: &[f64; 3]| core::array::from_fn(|k| vertex[k] + origin[k]);
    HullDescription {
        name: hull.name.clone(),
        body: body.to_owned(),
        origin_m: origin,
        draught_m: at_rest.draught_m,
        length_m: at_rest.length_m,
        beam_m: at_rest.beam_m,
        is_linear,
        mesh: at_rest.mesh.as_ref().map(|mesh| MeshDescription {
            vertices_m: mesh.vertices_m.iter().map(from_centre).collect(),
            triangles: mesh.triangles.clone(),
        }),
    }
}
