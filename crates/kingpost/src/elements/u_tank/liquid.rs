//! The liquid of a U-tank as a rigid body on a hinge.

use crate::scalar::Scalar;
use crate::spatial::{SpatialInertia, Symmetric3};

/// The geometry of a U-tank with rectangular sections, m, and the density of its liquid, kg/m^3.
#[derive(Clone, Copy, Debug)]
pub struct UTankGeometry<S = f64> {
    /// Between the middles of the columns.
    pub distance: S,
    /// Columns along x and y.
    pub column: [S; 2],
    /// Level at rest above the middle of the duct.
    pub level: S,
    /// Duct along x and z.
    pub duct: [S; 2],
    /// rho, kg/m^3.
    pub density: S,
}

/// Constants of the geometry for the equations of motion.
///
/// With the rise y of the level in the port column from rest, the kinetic energy of one-dimensional flow in a tank that
/// moves with the twist V is (Holden & Fossen, *Ocean Engineering* 45, 2012, pp. 22-37; Lloyd, *Seakeeping*, 1989, ch.
/// 13)
///
/// ```text
/// T = V . M V / 2 + y' V . c + m_t y'^2 / 2
/// c = rho A integral (t, r x t) ds,    m_t = rho A^2 integral ds / A(s)
/// ```
///
/// M is the inertia of the frozen liquid, A the area of a column, t the tangent of the path from the starboard surface to the
/// port surface. With the column of motion `s = M^-1 c`
///
/// ```text
/// T = (V + s y') . M (V + s y') / 2 + (m_t - c . s) y'^2 / 2
/// ```
///
/// which is the energy of a rigid body on a joint with the column s, and of a rotor. For a tank that is symmetric about
/// its middle, s is a rotation about an axis along x: the liquid is a pendulum that hangs from a hinge at the height
/// `arm` above its centre.
#[derive(Clone, Copy, Debug)]
pub struct UTankLiquid<S = f64> {
    /// Area of a column, m^2.
    pub area: S,
    /// Area of a column over that of the duct.
    pub contraction: S,
    /// Mass, kg.
    pub mass: S,
    /// Inertia about its centre, kg m^2.
    pub inertia: SpatialInertia<S>,
    /// Moment of inertia about x through its centre, kg m^2.
    pub moment_about_x: S,
    /// Height of its centre above the middle of the duct, m.
    pub centre: S,
    /// Height of the hinge above its centre, m.
    pub arm: S,
    /// Angle of the pendulum per metre of level, rad/m.
    pub turn: S,
    /// m_t, kg.
    pub flow_mass: S,
    /// rho A, kg/m: mass that changes sides per metre of level.
    pub column_mass: S,
}

impl<S: Scalar> UTankGeometry<S> {
    /// Returns the constants of the liquid's equations of motion.
    pub fn liquid(&self) -> UTankLiquid<S> {
        let Self { distance, column: [length, breadth], level, duct: [duct_length, duct_height], density } = *self;
        let half = S::constant(0.5);
        let (area, duct_area) = (length * breadth, duct_length * duct_height);
        let (depth, span) = (level + duct_height * half, distance - breadth);
        let columns = density * area * depth * S::constant(2.0);
        let between = density * duct_area * span;
        let mass = columns + between;
        let column_centre = (level - duct_height * half) * half;
        let centre = columns * column_centre / mass;
        let about_centre = |mass: S, edges: [S; 3], [y, z]: [S; 2]| {
            let square = edges.map(|edge| edge * edge * S::constant(1.0 / 12.0));
            [square[1] + square[2] + y * y + z * z, square[0] + square[2] + z * z, square[0] + square[1] + y * y]
                .map(|radius| mass * radius)
        };
        let moments = about_centre(columns, [length, breadth, depth], [distance * half, column_centre - centre]);
        let of_duct = about_centre(between, [duct_length, span, duct_height], [S::ZERO, centre]);
        let moments = [0, 1, 2].map(|k| moments[k] + of_duct[k]);
        let column_mass = density * area;
        // c about the liquid's centre: along y, and about x.
        let (along, about) = (column_mass * distance, column_mass * distance * (level + centre));
        let turn = about / moments[0];
        UTankLiquid {
            area,
            contraction: area / duct_area,
            mass,
            inertia: SpatialInertia::rigid(mass, Symmetric3::diagonal(moments)),
            moment_about_x: moments[0],
            centre,
            arm: along / (mass * turn),
            turn,
            flow_mass: column_mass * (level + level + distance * area / duct_area),
            column_mass,
        }
    }
}

impl<S: Scalar> UTankLiquid<S> {
    /// Returns the inertia of the rotor on the hinge, `(m_t - c . s) / turn^2`, kg m^2: never negative, by the
    /// Cauchy-Schwarz inequality.
    pub fn rotor_inertia(&self) -> S {
        self.flow_mass / (self.turn * self.turn) - (self.mass * self.arm * self.arm + self.moment_about_x)
    }

    /// Returns the stiffness against a level, `2 rho g A`, N/m, in an upright tank.
    pub fn stiffness(&self, gravity: S) -> S {
        self.column_mass * gravity * S::constant(2.0)
    }

    /// Returns the vector from the pendulum's centre of mass to the true centre of the liquid, along y and z (m), and
    /// its derivative with respect to the angle. The centre moves by `rho A / m` times `distance y` along y and `y^2`
    /// along z.
    pub fn beyond_the_arc(&self, angle: S) -> [[S; 2]; 2] {
        let (sin, cos) = angle.sin_cos();
        let rise = self.column_mass / (self.mass * self.turn * self.turn);
        [
            [self.arm * (angle - sin), rise * angle * angle - self.arm * (S::ONE - cos)],
            [self.arm * (S::ONE - cos), rise * angle * S::constant(2.0) - self.arm * sin],
        ]
    }
}
