//! Velocity terms of the added mass in current and waves.
//!
//! The added mass A is part of the inertia of the hull's body, which obeys Kirchhoff's equations with the body's twist
//! nu: the force of the water is `-(A nu' + nu x* A nu)`. This module adds, as a load, the difference of the actual
//! force from this one.

use super::{CoefficientFrame, Hull, Radiation, SeaAxes, SlowFilter, WaveCoordinates};
use crate::dynamics::Loads;
use crate::elements::Context;
use crate::scalar::Scalar;
use crate::sea::database::SixBySix;
use crate::spatial::{Matrix3, SpatialInertia, Symmetric3, Twist, Vector3, Wrench};

/// Choice of the velocity in the quadratic terms of the added mass, and whether these terms contain Munk's yaw moment.
///
/// With the wave-frequency velocity these terms would be only a part of the second-order force. Alone they would have a
/// mean as large as the drift force, and would roll a slender ship at the difference frequencies as much as the waves
/// do. In waves they therefore take the slow velocity, and `wave_drift` gives the whole second-order force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuadraticTerms {
    /// Whether the terms take the slow velocity, because waves act.
    pub of_slow_motion: bool,
    /// Whether `-(v x p)_z`, the moment that turns a hull in oblique motion across the flow, is already in the yaw
    /// moments of a table of current coefficients.
    pub munk_by_table: bool,
}

impl QuadraticTerms {
    /// Returns `nu x* p` of the momentum p of the water, without Munk's yaw moment if a table contains it.
    pub(super) fn of<S: Scalar>(self, twist: &Twist<S>, momentum: &Wrench<S>) -> Wrench<S> {
        let mut terms = twist.cross_momentum(momentum);
        if self.munk_by_table {
            terms.moment -= Vector3::new(S::ZERO, S::ZERO, twist.linear.cross(momentum.force)[2]);
        }
        terms
    }
}

/// The velocity of a hull relative to the water, and the part of its rate that is due to its rotation.
pub(super) struct ThroughWater<S> {
    pub relative: Twist<S>,
    pub turned: Twist<S>,
}

impl<S: Scalar> WaveCoordinates<S> {
    /// Returns the velocity nu_r and `omega x R^T u` in the axes of the body, about its centre of mass.
    pub(super) fn in_stream(&self, at: &Context<'_, S>, twist: &Twist<S>) -> ThroughWater<S> {
        let stream = at.links.to_body_axes(at.model, self.coefficients.body, at.world.surface_current());
        let relative = Twist { linear: twist.linear - stream, ..*twist };
        let turned = Twist { linear: twist.angular.cross(stream), angular: Vector3::zero() };
        ThroughWater { relative, turned }
    }

    /// Returns the velocity of the slow frame, in its axes, and `omega x v` of it.
    pub(super) fn slowly(&self, at: &Context<'_, S>) -> ThroughWater<S> {
        let [x, y, turning] = SlowFilter::read(at.states).output_rates(self.cutoff_rad_s);
        let (moving, angular) = (Vector3::new(x, y, S::ZERO), Vector3::new(S::ZERO, S::ZERO, turning));
        let level = self.low_frequency_frame(at).rotation();
        let relative = Twist { linear: level.transpose_times(moving - at.world.surface_current()), angular };
        let turned = Twist { linear: angular.cross(relative.linear), angular: Vector3::zero() };
        ThroughWater { relative, turned }
    }
}

/// The added mass of a hull about the origin of its coefficients, in their axes.
#[derive(Clone, Copy, Debug)]
pub struct AddedMass<S = f64> {
    /// At infinite frequency: the inertia for fast motions.
    infinite: SpatialInertia<S>,
    /// At frequency zero: the inertia for slow motions, including the contribution of the radiation memory.
    slow: SpatialInertia<S>,
    /// At infinite frequency about the body's centre of mass, in its axes, as in the model.
    pub in_body: SpatialInertia<S>,
}

impl<S: Scalar> AddedMass<S> {
    /// Returns the added mass from that at infinite frequency, and from the radiation memory if it acts.
    pub fn new(infinite: &SixBySix, radiation: Option<&Radiation>, on: &CoefficientFrame<S>) -> Self {
        let remembered = radiation.map_or([[0.0; 6]; 6], Radiation::added_mass);
        let slow: SixBySix = core::array::from_fn(|i| core::array::from_fn(|j| infinite[i][j] + remembered[i][j]));
        let (infinite, slow) = (added_inertia(infinite), added_inertia(&slow));
        Self { infinite, slow, in_body: infinite.to_parent(&on.in_body) }
    }
}

/// Returns a database's full 6x6 added mass, in which forces come first, as an inertia, in which moments come first.
pub fn added_inertia<S: Scalar>(added: &SixBySix) -> SpatialInertia<S> {
    let entry = |i: usize, j: usize| S::constant(0.5 * (added[i][j] + added[j][i]));
    let block = |row: usize, column: usize| Matrix3::from_fn(|i, j| entry(row + i, column + j));
    SpatialInertia {
        angular: Symmetric3::from_upper(&block(3, 3)),
        coupling: block(3, 0),
        linear: Symmetric3::from_upper(&block(0, 0)),
    }
}

impl<S: Scalar> Hull<S> {
    /// Returns the load about the body's centre of mass, in its axes, that corrects Kirchhoff's terms for nu to those
    /// in current and waves; changes of the inertia go to `loads`.
    pub(super) fn in_flowing_water(
        &self,
        at: &Context<'_, S>,
        axes: &SeaAxes<S>,
        off_rate: [S; 2],
        loads: &mut Loads<S>,
    ) -> Wrench<S> {
        match &self.added_mass {
            None => Wrench::zero(),
            Some(added) if self.quadratic_terms.of_slow_motion => self.in_waves(added, at, axes, off_rate, loads),
            Some(added) if self.radiation.is_some() => {
                let listing = axes.listing(&added.infinite, &self.coordinates.coefficients);
                loads.added_inertia.push((self.frame.body, listing - added.in_body));
                self.in_current(&listing, &axes.listing(&added.slow, &self.coordinates.coefficients), at)
            }
            Some(added) => self.in_current(&added.in_body, &added.in_body, at),
        }
    }

    /// Returns the load in a current u, constant in the world: the relative velocity is `nu_r = nu - R^T u`, with
    /// `d(R^T u)/dt = -omega x R^T u`, so `F = -(A (nu' + omega x R^T u) + nu_r x* A_0 nu_r)`. A hull that drifts with
    /// the current moves like one in still water. The term with A_0, the added mass of slow motions, turns a hull that
    /// is towed obliquely; it does no work.
    fn in_current(&self, added: &SpatialInertia<S>, slow: &SpatialInertia<S>, at: &Context<'_, S>) -> Wrench<S> {
        let twist = at.links.body_twist(at.model, self.frame.body);
        let ThroughWater { relative, turned } = self.coordinates.in_stream(at, &twist);
        let quadratic = self.quadratic_terms.of(&relative, &slow.times(&relative));
        twist.cross_momentum(&added.times(&twist)) - added.times(&turned) - quadratic
    }

    /// Returns the load in waves. To first order A refers to the axes of the wave loads, w = T nu, and wave-frequency
    /// motions have no quadratic terms: `F = -T^T (A (T nu' + T' nu) + Q)`. The inertia becomes `T^T A T`; its
    /// Kirchhoff terms are subtracted. For the slow velocity `Q(nu) = nu x* A_0 nu - A_0 (omega x v)`, since w' is the
    /// acceleration in the world.
    fn in_waves(
        &self,
        added: &AddedMass<S>,
        at: &Context<'_, S>,
        axes: &SeaAxes<S>,
        off_rate: [S; 2],
        loads: &mut Loads<S>,
    ) -> Wrench<S> {
        let seen = axes.inertia_in_body(&added.infinite);
        loads.added_inertia.push((self.frame.body, seen - added.in_body));
        let ThroughWater { relative, turned } = self.coordinates.slowly(at);
        let quadratic = self.quadratic_terms.of(&relative, &added.slow.times(&relative)) - added.slow.times(&turned);
        let twist = at.links.body_twist(at.model, self.frame.body);
        let to_first_order = added.infinite.times(&axes.drift(&twist, off_rate));
        twist.cross_momentum(&seen.times(&twist)) - axes.wrench_to_body(&(to_first_order + quadratic))
    }
}
