//! Free-flooding tanks, and their air pumps.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{Name, NonNegative, Positive, yes};

/// A tank with vertical walls and an opening to the sea in its bottom. The water in the tank is a separate body with
/// the tank's name, and its level is a degree of freedom: the mass of the carrying body must not contain the water. The
/// hydrodynamic data of the hull are those of the closed hull.
#[fields]
pub struct FreeFloodingTank<S = f64> {
    /// Whether the opening is open; if not, the water is frozen at `level_m`, its mass stays, and the pump has no effect.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body that carries the tank.
    pub body: Name,
    /// Middle of the opening in the tank's bottom, in the body's drawing frame, m. The tank extends upwards from this
    /// point.
    pub position_m: [S; 3],
    /// Inner length of the tank along the body's x axis, m.
    pub length_m: Positive<S>,
    /// Inner breadth of the tank along the body's y axis, m.
    pub breadth_m: Positive<S>,
    /// Inner height of the tank, m.
    pub height_m: Positive<S>,
    /// Level of the water at rest above the opening, m: below `height_m`. It should equal the depth of the opening
    /// below the sea surface.
    pub level_m: Positive<S>,
    /// Area of the opening, m^2: at most the area of the bottom.
    pub opening_area_m2: Positive<S>,
    /// Length of the opening, m: thickness of the bottom, or length of the pipe to the sea. End corrections for the
    /// water about both ends are added to it.
    #[serde(default)]
    pub passage_length_m: NonNegative<S>,
    /// Linear damping over the critical damping of the water in a ship at rest.
    #[serde(default)]
    pub damping_ratio: NonNegative<S>,
    /// Pressure loss in the opening over the dynamic pressure rho u^2 / 2 of the flow through it: about 2.6 for a sharp
    /// edge.
    pub loss_coefficient: NonNegative<S>,
    /// Level above `level_m` at the start, m.
    #[serde(default = "no_rise::<S>")]
    pub initial_rise_m: S,
    /// A pump that sets the pressure of the air above the water: an input with the tank's name, from -1 to 1, which presses
    /// the water out if positive and sucks it in if negative. Without a pump the tank is open to the atmosphere.
    pub air_pump: Option<AirPump<S>>,
}

fn no_rise<S: Leaf>() -> S {
    S::literal(0.0)
}

/// A pump that follows the commanded pressure of the air with a first-order lag, as far as its flow allows.
#[fields]
pub struct AirPump<S = f64> {
    /// Largest gauge pressure, positive and negative, Pa: below 101325.
    pub pressure_limit_pa: Positive<S>,
    /// Largest flow, either way, of air at the pressure of the atmosphere, m^3/s.
    pub flow_limit_m3_s: Positive<S>,
    /// Time constant of the pressure's lag behind the command, s.
    #[serde(default = "half_a_second::<S>")]
    pub response_time_s: Positive<S>,
}

fn half_a_second<S: Leaf>() -> Positive<S> {
    Positive::literal(0.5)
}
