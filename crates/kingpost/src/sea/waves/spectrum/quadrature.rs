//! Integrals over frequency.

use super::Band;

/// Points and weights of the Gauss-Legendre rule of order 8 on (-1, 1) (Abramowitz & Stegun, table
/// 25.4, n = 4).
const RULE: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    (-0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

/// Largest ratio of the ends of a sub-interval: a quarter of the width of a JONSWAP peak.
const LONGEST_RATIO: f64 = 1.02;

/// Returns the sub-intervals of a band: it is divided at the nodes, and each part into equal ratios of at
/// most 1.02. A part that starts at 0 is not divided.
pub(crate) fn sub_intervals(nodes: &[f64], band: Band) -> Vec<f64> {
    let inside = nodes.iter().copied().filter(|&w| w > band.lowest_rad_s && w < band.highest_rad_s);
    let mut ends = vec![band.lowest_rad_s];
    let longest = libm::log(LONGEST_RATIO);
    for next in inside.chain([band.highest_rad_s]) {
        let start = ends[ends.len() - 1];
        if start > 0.0 && next > start {
            let pieces = libm::ceil(libm::log(next / start) / longest).max(1.0);
            let ratio = if pieces > 1.0 { libm::pow(next / start, 1.0 / pieces) } else { 1.0 };
            for piece in 1..pieces as usize {
                ends.push(start * libm::pow(ratio, piece as f64));
            }
        }
        if next > start {
            ends.push(next);
        }
    }
    ends
}

/// Returns the integral of a function over one interval.
pub(crate) fn over_interval(start: f64, end: f64, function: impl Fn(f64) -> f64) -> f64 {
    let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
    RULE.iter().map(|&(point, weight)| weight * function(middle + half * point)).sum::<f64>() * half
}

/// Returns the integral over a band of a function that is smooth between the nodes.
pub(crate) fn integral(nodes: &[f64], band: Band, function: impl Fn(f64) -> f64) -> f64 {
    sub_intervals(nodes, band).windows(2).map(|ends| over_interval(ends[0], ends[1], &function)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rule is exact for polynomials up to degree 7, on each side of a kink at a node.
    #[test]
    fn polynomials_are_integrated_to_rounding() {
        let band = Band { lowest_rad_s: 0.0, highest_rad_s: 3.0 };
        let kinked = |w: f64| w.powi(7) + (w - 1.0).max(0.0).powi(3);
        let exact = 3.0_f64.powi(8) / 8.0 + 2.0_f64.powi(4) / 4.0;
        assert!((integral(&[1.0], band, kinked) / exact - 1.0).abs() < 1e-13);
    }

    /// Integral of w^-3 over [1, 10^4], with an error of order 8 in the ratio less one, 0.02.
    #[test]
    fn long_tails_are_integrated() {
        let band = Band { lowest_rad_s: 1.0, highest_rad_s: 1e4 };
        assert!((integral(&[], band, |w| w.powi(-3)) / (0.5 * (1.0 - 1e-8)) - 1.0).abs() < 1e-12);
    }
}
