//! Submerged objects, with the coefficients that act on them during upright entry into the water.

use crate::elements::Submerged;
use crate::simulation::Setup;
use crate::spatial::Vector3;
use serde::Serialize;

/// An object that is lowered through the surface.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ObjectInWater {
    /// Name of the force.
    pub name: String,
    /// Its body.
    pub body: String,
    /// Mass of the body and of all that it carries, kg.
    pub mass_kg: f64,
    /// Density of the water, kg/m^3.
    pub density_kg_m3: f64,
    /// Number of objects on the body.
    pub objects_on_body: usize,
    /// Projected area along the body's z axis, m^2.
    pub projected_area_m2: f64,
    /// C_D A_p along x, y and z of the body, m^2.
    pub drag_areas_m2: [f64; 3],
    /// Added mass along x, y and z of the body under water, kg.
    pub added_mass_kg: [f64; 3],
    /// Whether the slamming coefficient is given; otherwise it follows from the growth of the added mass.
    pub slamming_is_given: bool,
    /// Whether the solid is a circular cylinder.
    pub is_cylinder: bool,
    /// Immersions of the upright object: its bottom at the surface, half its height under water, all of it.
    pub immersions: Vec<ImmersionDescription>,
}

/// An upright object at one immersion.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ImmersionDescription {
    /// h: depth of the lowest point, m.
    pub depth_m: f64,
    /// Depth of the centre of the part under water, m.
    pub centre_depth_m: f64,
    /// Displaced volume, m^3.
    pub displaced_volume_m3: f64,
    /// Derivative of the displaced volume with respect to the depth, m^2: the waterplane area.
    pub waterplane_area_m2: f64,
    /// Added mass along z, kg.
    pub added_mass_kg: f64,
    /// C_D A_p along z of the part under water, m^2.
    pub drag_area_m2: f64,
    /// C_S A_S, m^2. If it follows from the growth of the added mass, 2 / rho dA/dh, it is the largest value
    /// from this immersion to the next one.
    pub slamming_area_m2: f64,
}

/// Number of depths over the height at which the slope of the added mass is evaluated to find the largest
/// one.
const STEPS: usize = 200;
/// Immersion of an object at the surface, as a share of its height: its waterplane is then that of its
/// bottom.
const TOUCHES: f64 = 1e-6;

/// Describes the objects, in the order of results.
pub fn objects(setup: &Setup) -> Vec<ObjectInWater> {
    Submerged::among(&setup.elements).map(|object| describe(setup, object)).collect()
}

fn describe(setup: &Setup, object: &Submerged) -> ObjectInWater {
    let (model, density) = (&setup.model, setup.world.water_density);
    let body = object.place.body;
    let on_body = Submerged::among(&setup.elements).filter(|other| other.place.body == body);
    let height = 2.0 * object.solid.reach(UP);
    let at = |share: f64| immersion(density, object, height * share);
    let mut immersions = [TOUCHES, 0.5, 1.0].map(at);
    for (from, share) in [(0, 0.0), (1, 0.5)] {
        let steps = (0..=STEPS / 2).map(|step| at((share + step as f64 / STEPS as f64).clamp(TOUCHES, 1.0 - TOUCHES)));
        immersions[from].slamming_area_m2 = steps.fold(0.0, |most, at| at.slamming_area_m2.max(most));
    }
    immersions[2].slamming_area_m2 = 0.0;
    ObjectInWater {
        name: object.name.clone(),
        body: model.bodies[body].name.clone(),
        mass_kg: model.carried(body).iter().map(|&body| model.bodies[body].mass).sum(),
        density_kg_m3: density,
        objects_on_body: on_body.count(),
        projected_area_m2: object.solid.projected_areas()[2],
        drag_areas_m2: object.drag.areas.0,
        added_mass_kg: object.added_mass.linear.0.map(|volume| density * volume),
        slamming_is_given: object.slamming.is_some(),
        is_cylinder: matches!(object.solid, crate::sea::hull::Solid::Cylinder { .. }),
        immersions: immersions.to_vec(),
    }
}

const UP: Vector3 = Vector3([0.0, 0.0, 1.0]);

fn immersion(density: f64, object: &Submerged, depth: f64) -> ImmersionDescription {
    let half = object.solid.reach(UP);
    let below = object.solid.below(UP, depth - half);
    let share = below.volume / object.solid.volume();
    let (growth, rate) = (&object.added_mass.growth, below.area / object.solid.volume());
    let [factor, slope] = growth.at(share, rate);
    let by_growth = 2.0 * object.added_mass.linear[2] * slope;
    ImmersionDescription {
        depth_m: depth,
        centre_depth_m: depth - half - below.first_moment[2] / below.volume,
        displaced_volume_m3: object.displaced * below.volume,
        waterplane_area_m2: object.displaced * below.area,
        added_mass_kg: density * object.added_mass.linear[2] * factor,
        drag_area_m2: object.drag.areas[2] * share,
        slamming_area_m2: object.slamming.map_or(by_growth, |given| given.area),
    }
}
