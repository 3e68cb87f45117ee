//! The trailing edge of a fin, where water with sideways momentum leaves it.

pub(crate) mod assembly;
pub(crate) mod fields;

use crate::dynamics::{Kinematics, Loads};
use crate::elements::hull::HullFrame;
use crate::elements::submerged::Waters;
use crate::elements::{Components, Context, Declaration, Element, Output, ShownWaves, Support, VectorFrame};
use crate::scalar::Scalar;
use crate::spatial::{Vector3, Wrench};

/// The reactive force at the trailing edge of a fin of the span s, whose chord is along the body's x axis and whose
/// span is along z (Lighthill, "Large-amplitude elongated-body theory of fish locomotion", *Proc. R. Soc. Lond. B* 179,
/// 1971, p. 125),
///
/// ```text
/// F = 1/2 m w^2 x - m u w y,    m = pi/4 rho s^2
/// ```
///
/// with the velocities u along the chord and w across it of the edge through the water. The second term is the momentum
/// m w per length of the water that the edge leaves behind at the speed u; the first is the pressure in the plane of
/// the edge. Together they lose the power 1/2 m w^2 u to the wake. The other part of the reactive force is that of the
/// fin's added mass, which [`super::Submerged`] contains. An edge that moves backwards has no wake. m counts only the
/// share of the span that is under water.
#[derive(Clone, Debug)]
pub struct TrailingEdge<S = f64> {
    /// Name in the results.
    pub name: String,
    /// The body, and the middle of the edge.
    pub place: HullFrame<S>,
    /// s, m.
    pub span: S,
    /// The sea at the edge.
    pub waters: Waters<S>,
}

/// Reaction of the water on the edge at one moment.
struct Reaction<S> {
    /// F, in the body's axes, N.
    force: Vector3<S>,
    /// Velocity of the edge relative to the water, and velocity of the water, in the body's axes, m/s.
    through: Vector3<S>,
    stream: Vector3<S>,
}

/// Smallest slope of the span against the horizontal from which its wet share is computed.
const LEAST_SLOPE: f64 = 0.05;

impl<S: Scalar> Element<S> for TrailingEdge<S> {
    fn name(&self) -> &str {
        &self.name
    }

    fn declare(&self) -> Declaration {
        let description = "reactive force of the water at the trailing edge";
        let force = Output {
            components: Components::Axis,
            frame: VectorFrame::World,
            ..Output::number("trailing_edge_force", description, "wake", &self.name, &["N"])
        };
        let description = "power that the trailing edge loses to its wake";
        let power = Output::number("wake_power", description, "wake", &self.name, &["W"]);
        Declaration { outputs: vec![force, power], ..Declaration::default() }
    }

    /// Adds the force, the power lost to the wake, and the work of the water's flow.
    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let Reaction { force, through, stream } = self.reaction(at);
        loads.power.dissipated -= force.dot(through);
        loads.power.outside += force.dot(stream);
        let wrench = Wrench { moment: Vector3::zero(), force };
        loads.wrenches.push((self.place.body, self.place.about_centre(&wrench)));
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let Reaction { force, through, .. } = self.reaction(at);
        out.extend((self.place.frame(at.model, at.links).rotation * force).0);
        out.push(-force.dot(through));
    }

    fn shown_waves(&self, _bodies: &Kinematics<S>) -> Vec<(usize, ShownWaves<S>)> {
        let written = self.declare().outputs.iter().map(Output::len).sum();
        (0..written).map(|number| (number, ShownWaves::NotLinear)).collect()
    }

    fn left_out_at_rest(&self) -> Option<&'static str> {
        Some("the response leaves out the waves at the trailing edge of a fin; a run contains them")
    }

    fn supports(&self) -> Vec<Support> {
        vec![Support::Carries([Some(self.place.body), None])]
    }
}

impl<S: Scalar> TrailingEdge<S> {
    fn reaction(&mut self, at: &Context<'_, S>) -> Reaction<S> {
        let point = self.waters.point(at, &self.place);
        let slope = point.frame.rotation.row(2)[2];
        let slope = slope.select_below(0.0, || -slope, || slope);
        let height = self.span * slope.select_below(LEAST_SLOPE, || S::constant(LEAST_SLOPE), || slope);
        let wet = (point.depth / height + S::constant(0.5)).clipped(S::ZERO, S::ONE);
        let length = self.span * wet;
        let mass = S::constant(core::f64::consts::FRAC_PI_4) * at.world.water_density * length * length;
        let through = point.velocity - point.stream;
        let (along, across) = (through[0], through[1]);
        let leaving = along.select_below(0.0, || S::ZERO, || along);
        let force = Vector3::new(S::constant(0.5) * mass * across * across, -(mass * leaving * across), S::ZERO);
        Reaction { force, through, stream: point.stream }
    }
}
