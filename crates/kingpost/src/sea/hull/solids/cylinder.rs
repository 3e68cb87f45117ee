//! A circular cylinder cut by a plane.
//!
//! The components of the plane's normal along the axis and across it are c and s. A strip along the axis, at
//! the distance xi = -R cos(theta) from it up the slope, is wet over the share f of its length L; f falls
//! linearly from 1 at xi_a = (l - c L/2) / s to 0 at xi_b = (l + c L/2) / s. If the plane cuts no end, f is
//! between 0 and 1 for all strips, and the integrals are those of a wall-sided body. Otherwise the strips are
//! summed over theta by the Gauss-Legendre rule of 16 points, which is exact to rounding for the integrands
//! sin^2 and cos of theta over at most pi.

use super::Below;
use crate::scalar::Scalar;
use crate::spatial::Vector3;
use core::f64::consts::PI;

/// A cylinder about its centre, along one of the axes, to be cut by a plane.
pub(super) struct CutCylinder<S> {
    pub radius: S,
    pub length: S,
    pub axis: usize,
}

/// Half of the points of the rule on (-1, 1), and their weights (Abramowitz & Stegun, table 25.4, n = 16).
const RULE: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
    (0.458_016_777_657_227_4, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_7, 0.149_595_988_816_576_74),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.865_631_202_387_831_7, 0.095_158_511_682_492_78),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_096),
];

/// Smallest distance of the strips' ends, as a share of the radius, at which the shares are integrated
/// exactly. Below it they are evaluated at the rule's points, because the rounding of the exact integrals
/// would be larger than the error of the rule.
const NARROW: f64 = 1e-6;
/// Square of a slope below which the slope counts as 0.
const LEVEL: f64 = 1e-300;

/// Normal of the plane in the cylinder's axes, with the cylinder's axis upward.
struct Slope<S> {
    /// Component c along the axis, not negative, and the direction of the axis for which this holds.
    along: S,
    upward: S,
    /// Component s across the axis.
    across: S,
    /// Unit vector up the slope; 0 if the plane is perpendicular to the axis.
    direction: Vector3<S>,
}

impl<S: Scalar> CutCylinder<S> {
    /// Returns the part below n . r = l.
    pub fn below(&self, normal: Vector3<S>, level: S) -> Below<S> {
        let slope = self.slope(normal);
        let half = slope.along * self.length * S::constant(0.5);
        let size = level.select_below(0.0, || -level, || level);
        let room = half - size - slope.across * self.radius;
        if room.all(|room| room >= 0.0) {
            return self.between_ends(&slope, level);
        }
        let cut = self.through_ends(&slope, level);
        if room.all(|room| room < 0.0) {
            return cut;
        }
        let between = self.between_ends(&slope, level);
        let pick = |cut: S, between: S| room.select_below(0.0, || cut, || between);
        let pick3 = |a: Vector3<S>, b: Vector3<S>| Vector3(core::array::from_fn(|k| pick(a[k], b[k])));
        Below {
            volume: pick(cut.volume, between.volume),
            first_moment: pick3(cut.first_moment, between.first_moment),
            area: pick(cut.area, between.area),
            area_moment: pick3(cut.area_moment, between.area_moment),
        }
    }

    fn slope(&self, normal: Vector3<S>) -> Slope<S> {
        let mut radial = normal;
        radial[self.axis] = S::ZERO;
        let square = radial.norm_squared();
        let is_level = square.select_below(LEVEL, || S::ONE, || S::ZERO);
        let across = square.select_below(LEVEL, || S::ZERO, || square).sqrt();
        let divisor = is_level.select_below(0.5, || across, || S::ONE);
        let along = normal[self.axis];
        Slope {
            along: along.select_below(0.0, || -along, || along),
            upward: along.select_below(0.0, || -S::ONE, || S::ONE),
            across,
            direction: Vector3(radial.0.map(|x| x / divisor)),
        }
    }

    /// Returns the vector with these components along the upward axis and up the slope.
    fn vector(&self, slope: &Slope<S>, along: S, up: S) -> Vector3<S> {
        let mut vector = slope.direction * up;
        vector[self.axis] = along * slope.upward;
        vector
    }

    /// Returns the part below a plane that cuts no end: wet up to the height (l - s xi) / c along the axis,
    /// with I = pi R^4 / 4 of the circle.
    fn between_ends(&self, slope: &Slope<S>, level: S) -> Below<S> {
        let along = slope.along.select_below(f64::MIN_POSITIVE, || S::ONE, || slope.along);
        let (height, tan, half) = (level / along, slope.across / along, self.length * S::constant(0.5));
        let circle = S::constant(PI) * self.radius * self.radius;
        let second = circle * self.radius * self.radius * S::constant(0.25);
        let axial = (circle * (height * height - half * half) + second * tan * tan) * S::constant(0.5);
        Below {
            volume: circle * (height + half),
            first_moment: self.vector(slope, axial, -(second * tan)),
            area: circle / along,
            area_moment: self.vector(slope, circle * height / along, S::ZERO),
        }
    }

    fn through_ends(&self, slope: &Slope<S>, level: S) -> Below<S> {
        let (radius, length) = (self.radius, self.length);
        let across = slope.across.select_below(f64::MIN_POSITIVE, || S::constant(f64::MIN_POSITIVE), || slope.across);
        let half = slope.along * length * S::constant(0.5);
        let [first, last] = [level - half, level + half].map(|height| self.angle(height, across));
        let width = last - first;
        let narrow = half - across * radius * S::constant(NARROW);
        // Strips that are wet over their whole length, up to the angle of the first strip that is not.
        let (sin, cos) = first.sin_cos();
        let whole = radius * radius * (first - sin * cos) * length;
        let whole_moment = -(radius * radius * radius * sin * sin * sin * S::constant(2.0 / 3.0)) * length;
        let (mut volume, mut up, mut axial) = (whole, whole_moment, S::ZERO);
        let (mut area, mut area_up, mut area_axial) = (S::ZERO, S::ZERO, S::ZERO);
        for (point, weight) in RULE.iter().flat_map(|(point, weight)| [(-point, weight), (*point, weight)]) {
            let share_of_width = S::constant(0.5 * (1.0 + point));
            let (sin, cos) = (first + width * share_of_width).sin_cos();
            let xi = -(radius * cos);
            let by_place = || (level - across * xi + half) / (half + half);
            let fill = narrow.select_below(0.0, || S::ONE - share_of_width, by_place);
            let weight = S::constant(0.5 * weight);
            let chord = S::constant(2.0) * radius * sin;
            let strip = chord * radius * sin * width * weight;
            // For the section: dA = chord dxi / c = chord L df / s.
            let by_angle = || strip / slope.along;
            let section = narrow.select_below(0.0, || chord * length * weight / across, by_angle);
            volume += strip * length * fill;
            up += strip * length * fill * xi;
            axial += strip * length * length * fill * (fill - S::ONE) * S::constant(0.5);
            area += section;
            area_up += section * xi;
            area_axial += section * length * (fill - S::constant(0.5));
        }
        Below {
            volume,
            first_moment: self.vector(slope, axial, up),
            area,
            area_moment: self.vector(slope, area_axial, area_up),
        }
    }

    /// Returns theta for xi = height / s; 0 or pi beyond the cylinder's sides.
    fn angle(&self, height: S, across: S) -> S {
        let (reach, pi) = (across * self.radius, S::constant(PI));
        let inside = || ((reach - height) * (reach + height)).sqrt().atan2(-height);
        let below_top = || height.select_less(reach, inside, || pi);
        (height + reach).select_below(f64::MIN_POSITIVE, || S::ZERO, below_top)
    }
}
