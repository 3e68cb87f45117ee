//! The response of an element to regular waves, from which that of a whole model is found.

use crate::dynamics::Kinematics;
use crate::scalar::Scalar;
use crate::sea::waves::Water;
use crate::spatial::Twist;

/// An element that regular waves act on in proportion to their amplitude, about rest: a hull with diffraction data, for
/// example.
///
/// Its loads are up to six forces, each along a rate that is linear in the twists of the bodies. All amplitudes are complex,
/// of phases `e^(-i w t)`.
pub trait RegularWaves<S: Scalar = f64> {
    /// The frequencies that its data are for, in rising order, rad/s; empty if it has none and responds at any frequency.
    fn frequencies_rad_s(&self) -> &[f64];

    /// The water that they are for.
    fn water(&self) -> Water;

    /// Its position and heading.
    fn place(&self, bodies: &Kinematics<S>) -> WavePlace<S>;

    /// The rates that its forces act along, from the twists of all bodies.
    fn along(&self, bodies: &Kinematics<S>, twists: &[Twist<S>]) -> [S; 6];

    /// Its forces per metre of wave amplitude, for waves of a frequency (rad/s) in these directions (rad) with a crest
    /// at its place: real and imaginary part of each.
    fn amplitudes(&self, omega: f64, directions_rad: &[f64], place: &WavePlace<S>) -> Vec<[[S; 2]; 6]>;
}

/// Where waves meet an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WavePlace<S = f64> {
    /// x and y in the world, m.
    pub position: [S; 2],
    /// z in the world, m.
    pub height: S,
    /// From the world's x counter-clockwise, rad.
    pub heading: S,
}

/// How an output of an element depends directly on the incident waves about rest; the motions change it besides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShownWaves<S = f64> {
    /// In proportion to their elevation at a place.
    Elevation {
        /// x and y in the world, m.
        place: [S; 2],
        /// The factor on the elevation.
        times: S,
    },
    /// Force with this index, one of those of [`RegularWaves::amplitudes`].
    Force(usize),
    /// Not in proportion to them.
    NotLinear,
}
