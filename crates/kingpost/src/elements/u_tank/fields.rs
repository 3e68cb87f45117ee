//! U-tanks: anti-roll and anti-heeling tanks.

use kingpost_derive::fields;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{Name, NonNegative, Positive, yes};

/// Two columns of liquid at the sides of a ship and a duct between them, all of rectangular sections. The liquid is a
/// separate body with the tank's name, and its flow is a degree of freedom: the mass of the carrying body must not
/// contain the liquid.
#[fields]
pub struct UTank<S = f64> {
    /// Whether the liquid flows; if not, it is frozen, and its mass stays.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body that carries the tank.
    pub body: Name,
    /// Middle of the duct in the body's drawing frame, m. The columns are to port and to starboard of it.
    pub position_m: [S; 3],
    /// Distance between the middles of the columns along the body's y axis, m.
    pub column_distance_m: Positive<S>,
    /// Inner length of a column along the body's x axis, m.
    pub column_length_m: Positive<S>,
    /// Inner breadth of a column along the body's y axis, m: less than `column_distance_m`.
    pub column_breadth_m: Positive<S>,
    /// Top of the columns above the middle of the duct, m.
    pub column_height_m: Positive<S>,
    /// Level of the liquid at rest above the middle of the duct, m: above the duct's top and below the columns' top.
    pub level_m: Positive<S>,
    /// Inner height of the duct, m.
    pub duct_height_m: Positive<S>,
    /// Inner length of the duct along the body's x axis, m; without it, that of the columns.
    pub duct_length_m: Option<Positive<S>>,
    /// Density of the liquid, kg/m^3; without it, the sea's density.
    pub density_kg_m3: Option<Positive<S>>,
    /// Linear damping over the critical damping of the liquid in a ship at rest.
    #[serde(default)]
    pub damping_ratio: NonNegative<S>,
    /// Pressure loss in bends and valve over the dynamic pressure in the duct, rho u^2 / 2.
    #[serde(default)]
    pub loss_coefficient: NonNegative<S>,
    /// Level in the port column above `level_m` at the start, m; the starboard level is below `level_m` by the same
    /// amount.
    #[serde(default = "no_rise::<S>")]
    pub initial_rise_m: S,
    /// A pump in the duct: an input with the tank's name, from -1 to 1, positive towards port.
    pub pump: Option<UTankPump<S>>,
}

fn no_rise<S: Leaf>() -> S {
    S::literal(0.0)
}

/// A reversible pump whose pressure falls linearly with the flow that it drives. Its largest power is a quarter of the
/// product of its limits.
#[fields]
pub struct UTankPump<S = f64> {
    /// Pressure at zero flow, Pa.
    pub pressure_limit_pa: Positive<S>,
    /// Flow at zero pressure, m^3/s.
    pub flow_limit_m3_s: Positive<S>,
}
