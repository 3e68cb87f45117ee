//! The water on a lifted object.

use kingpost_derive::fields;

use crate::scenario::schema::flow::ten_metres;

use crate::scenario::leaf::Leaf;
use crate::scenario::schema::{BoxShape, CylinderShape, Fraction, Name, NonNegative, Positive, SphereShape, yes};

/// The water on an object that is lowered through the surface and is small compared with the waves: buoyancy, drag,
/// slamming, and added mass that grows with immersion. A long or composed body may have several such forces.
#[fields]
pub struct Submerged<S = f64> {
    /// Whether the element acts.
    #[serde(default = "yes")]
    pub enabled: bool,
    /// The body.
    pub body: Name,
    /// Centre of the solid in the body's drawing frame, m; without it, the centre of mass.
    pub position_m: Option<[S; 3]>,
    /// The solid that the surface of the sea cuts; its axes are the body's.
    pub shape: SubmergedShape<S>,
    /// V: volume of water that the whole object displaces, m^3, if it is less than the solid's volume, for example for
    /// a frame.
    pub displaced_volume_m3: Option<Positive<S>>,
    /// Its added mass.
    #[serde(default)]
    pub added_mass: SubmergedAddedMass<S>,
    /// Slamming by a coefficient; without it, slamming by the growth of the added mass.
    pub slamming: Option<SubmergedSlamming<S>>,
    /// Drag.
    #[serde(default)]
    pub drag: SubmergedDrag<S>,
    /// Drag of the wind on the dry part.
    pub wind: Option<SubmergedWind<S>>,
    /// Water inside, which enters and drains through holes.
    pub entrained_water: Option<EntrainedWater<S>>,
}

/// Water that an object holds inside, in an upright space of constant section about the centre of the solid, with holes
/// in its floor and open at the top. It enters and drains by Torricelli's law. The object carries the weight of the
/// water above the level of the sea.
#[fields]
pub struct EntrainedWater<S = f64> {
    /// Volume of water that it holds when full, m^3; not part of the displaced volume.
    pub volume_m3: Positive<S>,
    /// Height of the space along the body's z axis, m.
    pub height_m: Positive<S>,
    /// A_h: area of the holes, m^2.
    pub hole_area_m2: Positive<S>,
    /// C_d: discharge coefficient, the flow through the holes over the product of their area and Torricelli's speed;
    /// about 0.6 for sharp edges.
    #[serde(default = "sharp_edges::<S>")]
    pub discharge_coefficient: Fraction<S>,
    /// Share of the volume that is water at the start; without it, the level of the sea.
    pub initial_filling: Option<Fraction<S>>,
}

fn sharp_edges<S: Leaf>() -> Fraction<S> {
    Fraction::literal(0.61)
}

/// A plain solid.
#[fields]
pub enum SubmergedShape<S = f64> {
    /// A box.
    Box(BoxShape<S>),
    /// A circular cylinder.
    Cylinder(CylinderShape<S>),
    /// A sphere.
    Sphere(SphereShape<S>),
}

/// Added mass rho C_A V_R by axis, of the fully submerged object; `growth` gives the share at partial immersion.
#[fields(default)]
pub struct SubmergedAddedMass<S = f64> {
    /// C_A along x, y and z of the body (DNV-RP-N103, appendix A).
    pub coefficients: [NonNegative<S>; 3],
    /// V_R: reference volume of the coefficients, m^3; without it, the volume of the solid.
    pub reference_volume_m3: Option<Positive<S>>,
    /// Added moments of inertia about x, y and z through the solid's centre, kg m^2.
    pub moments_kg_m2: [NonNegative<S>; 3],
    /// Open area over total area of the plates, from 0 to 0.5: it reduces the coefficients.
    pub perforation: Fraction<S>,
    /// Growth of the added mass with immersion; without it, in proportion to the share of the volume under water.
    pub growth: Option<SubmergedGrowth<S>>,
}

impl<S: Leaf> Default for SubmergedAddedMass<S> {
    fn default() -> Self {
        let none = [NonNegative::literal(0.0); 3];
        Self {
            coefficients: none,
            reference_volume_m3: None,
            moments_kg_m2: none,
            perforation: Fraction::literal(0.0),
            growth: None,
        }
    }
}

/// Added mass over immersion: a smooth curve through points. Immersion is the share of the volume under water, given as
/// shares or by depths of the upright object.
#[fields]
pub struct SubmergedGrowth<S = f64> {
    /// Shares of the volume, increasing from 0 to 1; give either shares or depths.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub shares: Vec<f64>,
    /// Depths of the upright object's bottom below the surface, m, increasing from 0 to the height of the solid.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub depths_m: Vec<f64>,
    /// Share of the added mass at each share or depth, the first 0.
    pub factors: Vec<S>,
}

/// Slamming force 1/2 rho C_S A_S w^2 normal to the surface, at the solid's centre, while the surface cuts the solid
/// and the centre sinks relative to the surface with the speed w. It replaces the force of the growing added mass,
/// whose coefficient is 2 / (rho A_S) dA/dh.
#[fields]
pub struct SubmergedSlamming<S = f64> {
    /// C_S; by DNV-RP-N103, sec. 4.3.5, at least 3 for smooth circular cylinders and 5 otherwise, unless tests or
    /// theory give another value.
    pub coefficient: NonNegative<S>,
    /// A_S: reference area of the coefficient, m^2; without it, the solid's projected area along z.
    pub area_m2: Option<Positive<S>>,
}

/// Drag s (1/2 rho C_D A_p |u_r| + c) u_r by axis, where s is the share of the volume under water and u_r the velocity
/// of the water relative to the centre of the wet part.
#[fields(default)]
pub struct SubmergedDrag<S = f64> {
    /// C_D along x, y and z of the body, in oscillating flow (DNV-RP-N103, appendix B).
    pub coefficients: [NonNegative<S>; 3],
    /// A_p: reference areas of the coefficients across x, y and z, m^2; without them, the solid's projected areas.
    pub areas_m2: Option<[Positive<S>; 3]>,
    /// c along x, y and z of the body, N s/m.
    pub linear_n_s_m: [NonNegative<S>; 3],
}

impl<S: Leaf> Default for SubmergedDrag<S> {
    fn default() -> Self {
        let none = [NonNegative::literal(0.0); 3];
        Self { coefficients: none, areas_m2: None, linear_n_s_m: none }
    }
}

/// Drag of the wind on the dry share of the volume.
#[fields]
pub struct SubmergedWind<S = f64> {
    /// C_D along x, y and z of the body.
    pub coefficients: [NonNegative<S>; 3],
    /// Reference areas of the coefficients across x, y and z, m^2; without them, the solid's projected areas.
    pub areas_m2: Option<[Positive<S>; 3]>,
    /// Height above the still water at which the wind speed is taken, m.
    #[serde(default = "ten_metres::<S>")]
    pub height_m: Positive<S>,
}
