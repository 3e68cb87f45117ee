//! The response of an element to regular waves, which is part of the response of the whole model.

use crate::dynamics::Kinematics;
use crate::scalar::Scalar;
use crate::sea::waves::Water;
use crate::spatial::Twist;

/// An element with loads proportional to the amplitude of regular waves, about rest: for example, a hull with
/// diffraction data.
///
/// Its loads are up to six generalised forces, each along a rate that is linear in the twists of the bodies. Amplitudes
/// are complex, with the time dependence `e^(-i w t)`.
pub trait RegularWaves<S: Scalar = f64> {
    /// Returns the frequencies of its data, in increasing order, rad/s; empty if it responds at any frequency.
    fn frequencies_rad_s(&self) -> &[f64];

    /// Returns the water for which its data were computed.
    fn water(&self) -> Water;

    /// Returns its position and heading.
    fn place(&self, bodies: &Kinematics<S>) -> WavePlace<S>;

    /// Returns the rates along which its forces act, from the twists of all bodies.
    fn along(&self, bodies: &Kinematics<S>, twists: &[Twist<S>]) -> [S; 6];

    /// Returns its forces per metre of wave amplitude, real and imaginary part of each, for waves of a frequency
    /// (rad/s) in these directions (rad) with a crest at `place`.
    fn amplitudes(&self, omega: f64, directions_rad: &[f64], place: &WavePlace<S>) -> Vec<[[S; 2]; 6]>;
}

/// Position and heading at which waves act on an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WavePlace<S = f64> {
    /// x and y in the world, m.
    pub position: [S; 2],
    /// z in the world, m.
    pub height: S,
    /// From the world's x counter-clockwise, rad.
    pub heading: S,
}

/// Direct dependence of an element's output on the incident waves about rest, in addition to its dependence through the
/// motions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShownWaves<S = f64> {
    /// Proportional to the elevation of the waves at a point.
    Elevation {
        /// x and y in the world, m.
        place: [S; 2],
        /// The factor on the elevation.
        times: S,
    },
    /// Equal to the force with this index in [`RegularWaves::amplitudes`].
    Force(usize),
    /// Not linear in the waves.
    NotLinear,
}
