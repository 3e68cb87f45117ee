//! Warnings of gas springs that begin under water.

use crate::dynamics::LinkKinematics;
use crate::elements::{GasSpring, Hull, Submerged, significant};
use crate::scenario::schema::Scenario;
use crate::simulation::Setup;

/// Largest difference between a pressure and that of the water around without a warning, as a share of the latter.
const LARGEST_DIFFERENCE: f64 = 0.05;
/// Absolute pressure of the atmosphere, Pa.
const ATMOSPHERE_PA: f64 = 101_325.0;

/// Warns of gas springs whose joint is under the still waterline at the start, with an outside pressure that is not that
/// of the water there.
pub fn warnings(scenario: &Scenario, setup: &Setup) -> Vec<String> {
    let Setup { model, world, elements, q, v, .. } = setup;
    let has_water =
        scenario.sea.is_some() || Hull::among(elements).next().is_some() || Submerged::among(elements).next().is_some();
    if !has_water {
        return Vec::new();
    }
    let mut links = LinkKinematics::new(model);
    links.update(model, q, v);
    let springs = GasSpring::among(elements);
    let warning = |spring: &GasSpring| {
        let of_joint = |node: &crate::model::Node| {
            (node.velocities..node.velocities + node.kind.velocity_count()).contains(&spring.coordinate)
        };
        let body = model.tree.nodes.iter().position(of_joint)?;
        let depth_m = -links.body_frame(model, body).point(-model.tree.nodes[body].kind.to_child())[2];
        let around_pa = ATMOSPHERE_PA + world.specific_weight() * depth_m;
        let off_pa = around_pa - spring.outside_pressure;
        (depth_m > 0.0 && off_pa.abs() > LARGEST_DIFFERENCE * around_pa).then(|| {
            format!(
                "{}: its gas spring begins {} m under water, where the pressure is {} MPa absolute, and its outside_pressure_Pa is \
                 {} MPa: its force is {} kN too {}; the outside pressure does not follow the depth",
                spring.name,
                significant(depth_m, 3),
                significant(around_pa / 1e6, 3),
                significant(spring.outside_pressure / 1e6, 3),
                significant((off_pa * spring.area).abs() / 1e3, 3),
                if off_pa > 0.0 { "large" } else { "small" },
            )
        })
    };
    springs.filter_map(warning).collect()
}
