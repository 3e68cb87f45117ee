//! The incident waves' own pressure on a hull's mesh.

use super::FloatingMesh;
use crate::scalar::Scalar;
use crate::sea::hull::{FloatingPosition, LocalWater};
use crate::sea::waves::WaveField;
use crate::spatial::{Frame, Wrench};

/// A mesh under the surface of the waves where it is: what they add to its buoyancy in still water, the
/// nonlinear Froude-Krylov force. To first order in the waves it is the database's, so the rest of the
/// excitation is then diffraction alone.
#[derive(Clone, Debug)]
pub struct MeshInWaves<S = f64> {
    floating: FloatingMesh<S>,
    field: WaveField<S>,
    real: Vec<S>,
    imaginary: Vec<S>,
}

impl<S: Scalar> MeshInWaves<S> {
    /// For this mesh in these waves.
    pub fn new(floating: FloatingMesh<S>, field: WaveField<S>) -> Self {
        let waves = vec![S::ZERO; field.len()];
        Self { floating, field, real: waves.clone(), imaginary: waves }
    }

    /// Force (N) and moment (N m) beside that of still water, about the hull's origin in its axes.
    pub fn pressure(&mut self, hull_in_world: &Frame<S>, specific_weight: S, time_s: f64) -> Wrench<S> {
        let Self { floating: FloatingMesh { mesh, wetted }, field, real, imaginary } = self;
        let still = wetted.buoyancy(mesh, &FloatingPosition::of(hull_in_world)).wrench(specific_weight);
        let in_waves = wetted.pressure_wrench(mesh, hull_in_world, specific_weight, |point| {
            let [elevation, dynamic_pressure] = field.elevation_and_pressure(point, time_s, real, imaginary);
            LocalWater { elevation, dynamic_pressure }
        });
        in_waves - still
    }
}
