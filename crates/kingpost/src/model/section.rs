//! Cross-sections of beams along x.

use crate::scalar::Scalar;

/// The cross-section of a beam along x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section<S = f64> {
    /// Area A, m^2.
    pub area: S,
    /// Second moments about y (integral of z^2) and about z (integral of y^2), m^4.
    pub second_moments: [S; 2],
    /// Torsion constant J, m^4.
    pub torsion_constant: S,
    /// Shear compliances per force along y and along z: 1 / (k A), 1/m^2; 0 if shear is neglected.
    pub shear_compliances: [S; 2],
}

impl<S: Scalar> Section<S> {
    /// Returns the section of a round tube, or of a round bar if the wall is half of the diameter. The shear
    /// coefficient is that of Cowper 1966, J. Appl. Mech. 33(2), for Poisson's ratio nu: `k = 6 (1 + nu) (1 +
    /// m^2)^2 / ((7 + 6 nu) (1 + m^2)^2 + (20 + 12 nu) m^2)`, where m is the ratio of inner to outer
    /// diameter.
    ///
    /// ```
    /// use kingpost::model::Section;
    /// let bar = Section::circular_tube(2.0_f64, 1.0, 0.3);
    /// assert!((bar.second_moments[0] - core::f64::consts::PI / 4.0).abs() < 1e-15);
    /// assert!((1.0 / (bar.shear_compliances[0] * bar.area) - 6.0 * 1.3 / (7.0 + 6.0 * 0.3)).abs() < 1e-15);
    /// ```
    pub fn circular_tube(outer_diameter: S, wall: S, poissons_ratio: S) -> Self {
        let constant = S::constant;
        let (outer, nu) = (outer_diameter * constant(0.5), poissons_ratio);
        let inner = outer - wall;
        let (outer_2, inner_2) = (outer * outer, inner * inner);
        let area = constant(core::f64::consts::PI) * (outer_2 - inner_2);
        let second_moment = area * (outer_2 + inner_2) * constant(0.25);
        let m_2 = inner_2 / outer_2;
        let square = (S::ONE + m_2) * (S::ONE + m_2);
        let above = constant(6.0) * (S::ONE + nu) * square;
        let below = (constant(7.0) + constant(6.0) * nu) * square + (constant(20.0) + constant(12.0) * nu) * m_2;
        Self {
            area,
            second_moments: [second_moment; 2],
            torsion_constant: second_moment + second_moment,
            shear_compliances: [below / (above * area); 2],
        }
    }

    /// Returns the section of a rectangular tube of uniform wall, with its width along y and its height along
    /// z: torsion constant by Bredt, `2 t b^2 h^2 / (b + h)` with b and h between the walls' middles; shear
    /// areas `A b / (b + h)` along y and `A h / (b + h)` along z (EN 1993-1-1, 6.2.6).
    ///
    /// ```
    /// use kingpost::model::Section;
    /// let box_girder = Section::rectangular_tube(1.0_f64, 2.0, 0.01);
    /// assert!((box_girder.area - (2.0 - 0.98 * 1.98)).abs() < 1e-15);
    /// assert!(box_girder.second_moments[0] > box_girder.second_moments[1]);
    /// ```
    pub fn rectangular_tube(width: S, height: S, wall: S) -> Self {
        let two_walls = wall + wall;
        let (inner_width, inner_height) = (width - two_walls, height - two_walls);
        let area = width * height - inner_width * inner_height;
        let second = |b: S, h: S, inner_b: S, inner_h: S| {
            (b * h * h * h - inner_b * inner_h * inner_h * inner_h) * S::constant(1.0 / 12.0)
        };
        let (b, h) = (width - wall, height - wall);
        let both = width + height;
        Self {
            area,
            second_moments: [
                second(width, height, inner_width, inner_height),
                second(height, width, inner_height, inner_width),
            ],
            torsion_constant: two_walls * b * b * h * h / (b + h),
            shear_compliances: [both / (area * width), both / (area * height)],
        }
    }
}
