//! Bodies that move with the waves by their RAOs.

use super::super::schema::{self, Scenario};
use super::reading::{Gathered, Reading};
use super::water::{check_coverage, gravity, sea_of, water_of};
use super::{FieldError, waves};
use crate::elements::drives::WaveMotion;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::sea::raos::{RaoTable, Response};
use crate::sea::waves::WaveComponent;

/// Mode of each coordinate of the joint: x, y, z, yaw, pitch, roll.
const MODE_OF: [usize; 6] = [0, 1, 2, 5, 4, 3];

/// The motions of the bodies that move so and are there.
pub fn build<S: Gathered>(scenario: &Reading<Scenario>, model: &Model<S>) -> Result<Vec<WaveMotion<S>>, FieldError> {
    let mut motions = Vec::new();
    for (name, body) in &scenario.first().bodies {
        let (schema::Joint::MovedByWaves(given), Some(index)) = (&body.joint, model.body(name)) else { continue };
        let field = format!("bodies.{name}.joint.moved_by_waves");
        let Some(table) = scenario.first().files.raos(&given.raos) else { continue };
        let table = table.whole_circle(given.symmetric).map_err(|error| {
            FieldError::new(format!("{field}.raos"), format!("{}: {}", error.field, error.found), error.allowed)
        })?;
        let sea = sea_of(scenario.first()).unwrap_or_default();
        let water = water_of(&sea, gravity(scenario.first())?)?;
        let waves = waves::build::<S>(scenario, &water)?;
        check_coverage(&format!("{field}.raos"), table.band_rad_s(), &waves)?;
        let node = &model.tree.nodes[index];
        motions.push(WaveMotion {
            velocities: node.velocities,
            positions: node.positions,
            waves: waves.iter().map(|wave| response(&table, given, wave)).collect(),
            ramp_s: sea.ramp_s.get(),
        });
    }
    Ok(motions)
}

/// X a of each coordinate in a wave, at the origin of the vessel's axes: what moves at the RAOs' own origin r is carried over
/// as a rigid body, `X(0) = X(r) - theta x r`; the wave's phase is that at the origin of the phases.
fn response<S: Scalar>(table: &RaoTable, given: &schema::MovedByWaves, wave: &WaveComponent<S>) -> (f64, [[S; 2]; 6]) {
    let (omega, direction) = (wave.angular_frequency_rad_s.value(), wave.direction_rad.value());
    let carried = carried_to_axes(&table.at(omega, direction - given.heading_rad), table.origin_m);
    let r = table.phase_origin_m;
    let (sin, cos) = libm::sincos(given.heading_rad);
    let place = [given.position_m[0] + cos * r[0] - sin * r[1], given.position_m[1] + sin * r[0] + cos * r[1]];
    let (along_y, along_x) = libm::sincos(direction);
    let phase = wave.wave_number_per_m.value() * (place[0] * along_x + place[1] * along_y) + wave.phase_rad.value();
    let (sin, cos) = libm::sincos(phase);
    let of_wave =
        |[re, im]: [f64; 2]| [re * cos - im * sin, re * sin + im * cos].map(|x| wave.amplitude_m * S::constant(x));
    (omega, MODE_OF.map(|mode| of_wave(carried[mode])))
}

fn carried_to_axes(at: &Response, [x, y, z]: [f64; 3]) -> Response {
    let [roll, pitch, yaw] = [at[3], at[4], at[5]];
    let minus = |k: usize, turn: &dyn Fn(usize) -> f64| [0, 1].map(|part| at[k][part] - turn(part));
    [
        minus(0, &|part| pitch[part] * z - yaw[part] * y),
        minus(1, &|part| yaw[part] * x - roll[part] * z),
        minus(2, &|part| roll[part] * y - pitch[part] * x),
        roll,
        pitch,
        yaw,
    ]
}
