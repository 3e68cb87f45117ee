//! A soft hold: springs and dampers in the horizontal plane, like those that keep a model in position in a wave basin.

pub(crate) mod assembly;
pub(crate) mod fields;

use crate::dynamics::Loads;
use crate::elements::dynamic_positioning::Planar;
use crate::elements::hull::HullFrame;
use crate::elements::{Components, Context, Declaration, Element, Output, Support, VectorFrame};
use crate::scalar::Scalar;
use crate::spatial::{Matrix3, Vector3, Wrench};
use core::f64::consts::TAU;

/// Springs and dampers in surge, sway and yaw between a point of a body and a fixed position in the world.
///
/// With d the displacement of the point from its held position, along the held heading and to port (m), and delta the
/// heading relative to the held heading, from -pi to pi (rad),
///
/// ```text
/// F = -k d - c d',      M = -k_psi delta - c_psi delta'
/// ```
///
/// F is horizontal. M is a pure yaw moment: with `delta' = g.omega` it acts along g, so it does no work on roll and
/// pitch, like the moments of linear theory ([`SeaAxes`](super::hull::SeaAxes)). `(k d^2 + k_psi delta^2) / 2` is
/// stored, `c d'^2 + c_psi delta'^2` is heat; d' is relative to the earth.
#[derive(Clone, Debug)]
pub struct SoftHold<S = f64> {
    /// Name of the force in the scenario.
    pub name: String,
    /// The body, and the point that is held.
    pub place: HullFrame<S>,
    /// Position where the point is held: x and y of the world, m.
    pub position: [S; 2],
    /// Cosine and sine of the heading that is held.
    pub heading: [S; 2],
    /// k of surge, sway and yaw: N/m, N/m, N m/rad.
    pub stiffness: Planar<S>,
    /// c of surge, sway and yaw: N s/m, N s/m, N m s/rad.
    pub damping: Planar<S>,
}

/// Deviation of a body from its held position and heading.
struct Off<S> {
    /// d and delta.
    deviation: Planar<S>,
    /// d' and delta'.
    rate: Planar<S>,
    /// g, body axes.
    yaw: Vector3<S>,
    /// Rotation from body to world axes.
    rotation: Matrix3<S>,
}

impl<S: Scalar> Element<S> for SoftHold<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let deviation = "surge and sway deviation of a ship on a soft hold from its held position, and heading relative to the held heading";
        let planar = |variable, description, units| Output {
            components: Components::Planar,
            frame: VectorFrame::Heading,
            units,
            ..Output::number(variable, description, "hold", &self.name, &["N"])
        };
        let outputs = vec![
            planar("hold_deviation", deviation, &["m", "m", "rad"]),
            planar("hold_force", "force and yaw moment of a soft hold on its ship", &["N", "N", "N m"]),
        ];
        Declaration { outputs, ..Declaration::default() }
    }

    /// Adds the springs and the dampers, and the heat of the dampers.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let off = self.off(at);
        let [surge, sway, yaw] = self.force(&off);
        let [cos, sin] = self.heading;
        let world = Vector3::new(cos * surge - sin * sway, sin * surge + cos * sway, S::ZERO);
        let wrench = Wrench { moment: off.yaw * yaw, force: off.rotation.transpose_times(world) };
        for (c, rate) in self.damping.into_iter().zip(off.rate) {
            loads.power.dissipated += c * rate * rate;
        }
        loads.wrenches.push((self.place.body, self.place.about_centre(&wrench)));
    }

    /// Returns the stored energy, J.
    fn potential_energy(&mut self, at: &Context<'_, S>) -> S {
        let each = self.stiffness.into_iter().zip(self.off(at).deviation);
        each.fold(S::ZERO, |sum, (k, off)| sum + k * off * off) * S::constant(0.5)
    }

    /// Appends deviation and force along the present heading of the body.
    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let off = self.off(at);
        let (sin, cos) = off.deviation[2].sin_cos();
        for [surge, sway, yaw] in [off.deviation, self.force(&off)] {
            out.extend([cos * surge + sin * sway, cos * sway - sin * surge, yaw]);
        }
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Station([Some(self.place.body), None])]
    }
}

impl<S: Scalar> SoftHold<S> {
    /// Returns `k = m (2 pi / T)^2` and `c = 2 zeta m 2 pi / T` for a mass (kg, or kg m^2) that oscillates with the
    /// period T (s) and the damping ratio zeta.
    ///
    /// ```
    /// use kingpost::elements::SoftHold;
    /// let [k, c] = SoftHold::<f64>::spring_and_damper(6.0e6, 120.0, 0.2);
    /// assert_eq!([k.round(), c.round()], [16449.0, 125664.0]);
    /// ```
    pub fn spring_and_damper(mass: S, period_s: S, damping_ratio: S) -> [S; 2] {
        let omega = S::constant(TAU) / period_s;
        [mass * omega * omega, S::constant(2.0) * damping_ratio * mass * omega]
    }

    fn off(&self, at: &Context<'_, S>) -> Off<S> {
        let motion = self.place.motion(at);
        let (position, rotation) = (motion.frame.position, motion.frame.rotation);
        let [cos, sin] = self.heading;
        let along = |x: S, y: S| [cos * x + sin * y, cos * y - sin * x];
        let [surge, sway] = along(position[0] - self.position[0], position[1] - self.position[1]);
        let velocity = rotation * motion.twist.linear;
        let [surge_rate, sway_rate] = along(velocity[0], velocity[1]);
        let [ahead, aside] = along(rotation.0[0][0], rotation.0[1][0]);
        // The rate of the yaw angle; the third row is the vertical in body axes.
        let [_, y, z] = rotation.row(2).0;
        let level = S::ONE / (y * y + z * z);
        let yaw = Vector3::new(S::ZERO, y * level, z * level);
        Off {
            deviation: [surge, sway, aside.atan2(ahead)],
            rate: [surge_rate, sway_rate, yaw.dot(motion.twist.angular)],
            yaw,
            rotation,
        }
    }

    /// Returns force and moment, along the held heading.
    fn force(&self, off: &Off<S>) -> Planar<S> {
        core::array::from_fn(|k| -(self.stiffness[k] * off.deviation[k] + self.damping[k] * off.rate[k]))
    }
}
