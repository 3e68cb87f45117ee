//! Change of the waves during a run.

use super::errors::check_array;
use super::{InputError, Simulation, stage};
use crate::sea::waves::WaveComponent;
use crate::spatial::Symmetric3;

impl Simulation {
    /// Returns the regular waves whose sum is the sea; none in calm water.
    pub fn waves(&self) -> Vec<WaveComponent> {
        self.plant.world.waves.as_ref().map_or_else(Vec::new, |waves| waves.components().copied().collect())
    }

    /// Returns the complex elevation a e^(i q) of each wave at a point (x, y) of the world, m, and a time, s,
    /// with the ramp applied: real and imaginary parts.
    pub fn wave_phasors(&self, point: [f64; 2], time_s: f64) -> [Vec<f64>; 2] {
        let Some(waves) = &self.plant.world.waves else { return [Vec::new(), Vec::new()] };
        let (mut real, mut imaginary) = (vec![0.0; waves.len()], vec![0.0; waves.len()]);
        waves.phasors(point, time_s, &mut real, &mut imaginary);
        [real, imaginary]
    }

    /// Gives the elements with [random drag](crate::elements::RandomDrag) its mean at rest in a random sea, like
    /// [`Plant::set_spreads`](crate::plant::Plant::set_spreads).
    pub fn set_spreads(&mut self, spreads: &[Vec<Symmetric3>]) {
        self.plant.set_spreads(spreads);
    }

    /// Replaces the amplitude (m) and phase (rad) of each wave, in the order of [`Self::waves`], and
    /// continues from the present state: for a forecast when the coming waves are not known. Frequencies and
    /// directions stay.
    ///
    /// Motion, states and the memory of radiated waves are kept; the integrator restarts. The sea is not part
    /// of a snapshot: a restored run continues in the sea that was set last, and so does a run after a reset.
    /// A replay does not contain it.
    ///
    /// # Errors
    /// The arrays do not have one finite number per wave, or the waves prescribe the motion of a body.
    /// Nothing changes then.
    pub fn set_waves(&mut self, amplitudes_m: &[f64], phases_rad: &[f64]) -> Result<(), InputError> {
        let count = self.plant.world.waves.as_ref().map_or(0, |waves| waves.len());
        check_array("amplitudes_m", amplitudes_m, count)?;
        check_array("phases_rad", phases_rad, count)?;
        if self.plant.keeps_waves() {
            return Err(InputError::MovedByWaves);
        }
        let before = self.plant.totals(stage(self.interval(), &self.state));
        self.plant.set_waves(amplitudes_m, phases_rad);
        self.plant.book_jump(&before, 0.0, self.time_s(), &mut self.state);
        self.state.memory.fill(0.0);
        Ok(())
    }
}
