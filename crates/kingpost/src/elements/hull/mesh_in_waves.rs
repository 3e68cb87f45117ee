//! The pressure of the incident waves on a hull's mesh.

use super::FloatingMesh;
use crate::scalar::Scalar;
use crate::sea::hull::LocalWater;
use crate::sea::waves::{WaveField, WavesAtPoints};
use crate::spatial::{Frame, Wrench};

/// The nonlinear Froude-Krylov force: the difference between the pressure force on the mesh under the wave surface and
/// its buoyancy in still water. To first order it equals the database's Froude-Krylov force, so with it the linear
/// excitation contains only diffraction.
#[derive(Clone, Debug)]
pub struct MeshInWaves<S = f64> {
    floating: FloatingMesh<S>,
    waves: WavesAtPoints<S>,
}

impl<S: Scalar> MeshInWaves<S> {
    /// Returns the working memory for this mesh in these waves.
    pub fn new(floating: FloatingMesh<S>, field: &WaveField<S>) -> Self {
        Self { floating, waves: WavesAtPoints::new(field) }
    }

    /// Returns force (N) and moment (N m) in addition to `still`, the buoyancy of the same mesh in still water; all
    /// about the hull's origin in its axes.
    pub fn pressure(
        &mut self,
        field: &WaveField<S>,
        hull_in_world: &Frame<S>,
        specific_weight: S,
        time_s: f64,
        still: &Wrench<S>,
    ) -> Wrench<S> {
        let Self { floating: FloatingMesh { mesh, wetted }, waves } = self;
        waves.set_time(field, time_s);
        let highest_m = waves.highest_m();
        let in_waves = wetted.pressure_wrench_below(mesh, hull_in_world, specific_weight, highest_m, |point| {
            let [elevation, dynamic_pressure] = waves.at(field, point);
            LocalWater { elevation, dynamic_pressure }
        });
        in_waves - *still
    }
}
