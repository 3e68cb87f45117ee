//! Bodies whose motion in waves is prescribed by RAOs.

use crate::elements::drives::WaveMotion;
use crate::elements::hull::assembly::check_coverage;
use crate::model::Model;
use crate::scenario::assembly::FieldError;
use crate::scenario::assembly::still_water;
use crate::scenario::leaf::Quantity;
use crate::scenario::schema::{self, Scenario};
use crate::sea::raos::{MotionResponse, OtherUnit, RaoTable};
use crate::sea::waves::{WaveComponent, WaveField, wave_number};
use crate::world::World;

/// Mode of each coordinate of the joint: x, y, z, yaw, pitch, roll.
const MODE_OF: [usize; 6] = [0, 1, 2, 5, 4, 3];

/// Returns the motions of the enabled bodies that RAOs prescribe.
pub fn build<S: Quantity>(
    scenario: &Scenario<S>,
    model: &Model<S>,
    world: &World<S>,
) -> Result<Vec<WaveMotion<S>>, FieldError> {
    let mut motions = Vec::new();
    for (name, body) in &scenario.bodies {
        let (schema::Joint::MovedByWaves(given), Some(index)) = (&body.joint, model.body(name)) else { continue };
        let field = format!("bodies.{name}.joint.moved_by_waves");
        let Some(table) = scenario.files.raos(&given.raos) else { continue };
        let table = table.whole_circle(given.symmetric).map_err(|error| {
            FieldError::new(format!("{field}.raos"), format!("{}: {}", error.field, error.found), error.allowed)
        })?;
        still_water::gravity(scenario)?;
        check_coverage(&format!("{field}.raos"), table.band_rad_s(), world)?;
        if let Some(OtherUnit { found, allowed, .. }) = other_unit(&table, world).filter(|unit| unit.is_sure) {
            return Err(FieldError::new(format!("{field}.raos"), found, allowed));
        }
        let waves = world.waves.iter().flat_map(WaveField::components);
        let node = &model.tree.nodes[index];
        motions.push(WaveMotion {
            velocities: node.velocities,
            positions: node.positions,
            waves: waves.map(|wave| response(&table, given, wave)).collect(),
        });
    }
    Ok(motions)
}

/// Returns the unit that a table's rotations probably have if it differs from the one in its file; judged by
/// the longest waves, in the world's water.
pub fn other_unit<S: Quantity>(table: &RaoTable, world: &World<S>) -> Option<OtherUnit> {
    table.other_unit(wave_number(table.band_rad_s()[0], &world.plain_water()))
}

/// Returns the complex amplitude X a of each coordinate in a wave, at the origin of the vessel's axes: the
/// motion at the RAOs' own origin r is transferred as that of a rigid body, `X(0) = X(r) - theta x r`; the
/// wave's phase is that at the phase origin.
fn response<S: Quantity>(
    table: &RaoTable,
    given: &schema::MovedByWaves<S>,
    wave: &WaveComponent<S>,
) -> (f64, [[S; 2]; 6]) {
    let WaveComponent { angular_frequency_rad_s, wave_number_per_m, direction_rad, phase_rad, .. } = wave.plain();
    let amplitude_m = wave.amplitude_m;
    let carried = carried_to_axes(
        &table.at(angular_frequency_rad_s, S::constant(direction_rad) - given.heading_rad),
        table.origin_m,
    );
    let r = table.phase_origin_m.map(S::constant);
    let (sin, cos) = given.heading_rad.sin_cos();
    let place = [given.position_m[0] + cos * r[0] - sin * r[1], given.position_m[1] + sin * r[0] + cos * r[1]];
    let (along_y, along_x) = libm::sincos(direction_rad);
    let along = place[0] * S::constant(along_x) + place[1] * S::constant(along_y);
    let (sin, cos) = (S::constant(wave_number_per_m) * along + S::constant(phase_rad)).sin_cos();
    let of_wave = |[re, im]: [S; 2]| [re * cos - im * sin, re * sin + im * cos].map(|x| amplitude_m * x);
    (angular_frequency_rad_s, MODE_OF.map(|mode| of_wave(carried[mode])))
}

fn carried_to_axes<S: Quantity>(at: &MotionResponse<S>, origin_m: [f64; 3]) -> MotionResponse<S> {
    let ([x, y, z], [roll, pitch, yaw]) = (origin_m.map(S::constant), [at[3], at[4], at[5]]);
    let minus = |k: usize, turn: &dyn Fn(usize) -> S| [0, 1].map(|part| at[k][part] - turn(part));
    [
        minus(0, &|part| pitch[part] * z - yaw[part] * y),
        minus(1, &|part| yaw[part] * x - roll[part] * z),
        minus(2, &|part| roll[part] * y - pitch[part] * x),
        roll,
        pitch,
        yaw,
    ]
}
