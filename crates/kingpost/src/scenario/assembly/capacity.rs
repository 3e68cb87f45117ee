//! Check that the buoyancy of each hull can carry the weight on it.

use crate::elements::hull::Hydrostatics;
use crate::elements::{AnyElement, Hull, Support};
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::schema::Scenario;
use crate::scenario::ties::floats_freely;
use crate::sea::database::HullAtRest;
use crate::sea::hull::HullMesh;
use crate::simulation::Setup;

/// A hull in the water, and the volume of the whole hull, m^3, if its data give it.
struct InWater<'a> {
    hull: &'a Hull,
    at_rest: &'a HullAtRest,
    largest_m3: Option<f64>,
}

/// Returns an error if hulls that only the water carries weigh more, with all bodies that stand on them or
/// hang from them, than they displace when fully submerged.
pub fn check(scenario: &Scenario, setup: &Setup) -> Result<(), FieldError> {
    let Setup { model, world, elements, .. } = setup;
    let in_water = Hull::among(elements).filter_map(|hull| InWater::of(scenario, hull));
    let in_water: Vec<InWater> = in_water.collect();
    if world.gravity == 0.0 || in_water.is_empty() {
        return Ok(());
    }
    let afloat = FloatingGroups::of(model, elements);
    for first in &in_water {
        let group = afloat.group[first.hull.frame.body];
        let hulls: Vec<&InWater> =
            in_water.iter().filter(|other| afloat.group[other.hull.frame.body] == group).collect();
        let largest_m3: Option<f64> = hulls.iter().map(|hull| hull.largest_m3).sum();
        let Some(largest_m3) = largest_m3.filter(|_| !afloat.is_carried(group)) else { continue };
        let mass = afloat.mass(model, group);
        let displaced_m3 = mass / world.water_density;
        if displaced_m3 >= largest_m3 {
            let tonnes = |volume_m3: f64| volume_m3 * world.water_density / 1000.0;
            let (mass_t, of_data_m3) = (mass / 1000.0, hulls.iter().map(|hull| hull.at_rest.volume_m3).sum());
            let found = format!("a hull that cannot float: {mass_t:.3} t displace {displaced_m3:.3} m3 of water");
            let allowed = format!(
                "less than the {largest_m3:.3} m3 of the whole hull, {:.3} t (the database is of {:.3} t): check the mass of {} \
                 and of all that it carries",
                tonnes(largest_m3),
                tonnes(of_data_m3),
                model.bodies[first.hull.frame.body].name
            );
            return Err(FieldError::new(format!("forces.{}.hydrodynamics", first.hull.name), found, allowed));
        }
    }
    Ok(())
}

impl<'a> InWater<'a> {
    fn of(scenario: &'a Scenario, hull: &'a Hull) -> Option<Self> {
        let database = scenario.database_of(&hull.name)?;
        let buoyant = !matches!(hull.hydrostatics, Hydrostatics::None);
        let largest_m3 = database.hull.mesh.as_ref().filter(|_| buoyant).and_then(|mesh| {
            let mesh = HullMesh::new(mesh.vertices_m.clone(), mesh.triangles.clone());
            mesh.ok().map(|mesh| mesh.volume())
        });
        Some(Self { hull, at_rest: &database.hull, largest_m3 })
    }
}

/// Floating bodies, in groups of connected bodies.
struct FloatingGroups {
    /// The group of each body; `None` for a body that is fixed to the world.
    group: Vec<Option<usize>>,
    /// For each body, whether something other than water and moorings connects its tree to the world.
    is_held: Vec<bool>,
    /// For each body, whether its tree contains a hull.
    has_hull: Vec<bool>,
}

impl FloatingGroups {
    fn of(model: &Model, elements: &[AnyElement]) -> Self {
        let roots: Vec<Option<usize>> = (0..model.bodies.len()).map(|body| floating_root(model, body)).collect();
        let root = |end: Option<usize>| end.and_then(|body| roots[body]);
        let supports: Vec<Vec<Support>> = elements.iter().map(|element| element.supports()).collect();
        let hulls: Vec<usize> = supports.iter().flatten().filter_map(Support::afloat).collect();
        let has_hull = |of: usize| hulls.iter().any(|hull| roots[*hull] == Some(of));
        let (mut group, mut held) = (roots.clone(), Vec::new());
        let loops = model.loops.iter().map(|closed| ([closed.first.body, closed.second.body], false));
        let by_elements = supports.iter().filter(|own| !own.iter().any(|own| own.afloat().is_some())).flat_map(|own| {
            let is_mooring = own.iter().any(|own| own.station().is_some());
            own.iter().filter_map(Support::carries).map(move |tie| (tie, is_mooring))
        });
        for (tie, is_mooring) in loops.chain(by_elements) {
            match tie.map(root) {
                [Some(a), Some(b)] => {
                    let (kept, joined) = (group[a], group[b]);
                    group.iter_mut().filter(|group| **group == joined).for_each(|group| *group = kept);
                }
                [Some(a), None] | [None, Some(a)] if !(is_mooring && has_hull(a)) => held.push(a),
                _ => {}
            }
        }
        let of_root = |test: &dyn Fn(usize) -> bool| roots.iter().map(|root| root.is_some_and(test)).collect();
        Self { group, is_held: of_root(&|root| held.contains(&root)), has_hull: of_root(&has_hull) }
    }

    /// Returns whether something other than the water carries a hull of a group.
    fn is_carried(&self, group: Option<usize>) -> bool {
        group.is_none()
            || (0..self.group.len()).any(|body| self.group[body] == group && self.has_hull[body] && self.is_held[body])
    }

    /// Returns the mass of a group, kg, without loads that the world also carries.
    fn mass(&self, model: &Model, group: Option<usize>) -> f64 {
        let counts = |body: &usize| self.group[*body] == group && !self.is_held[*body];
        (0..self.group.len()).filter(counts).map(|body| model.bodies[body].mass).sum()
    }
}

/// Returns the root of this body's joint tree if the root floats freely, otherwise `None`.
fn floating_root(model: &Model, mut body: usize) -> Option<usize> {
    while let Some(parent) = model.tree.nodes[body].parent {
        body = parent;
    }
    floats_freely(model, body).then_some(body)
}
