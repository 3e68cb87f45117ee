//! Growth of the added mass with the share of the volume under water.

use crate::scalar::Scalar;

/// phi over s, from phi(0) = 0: proportional, or a smooth curve through points without overshoot (the monotone cubic of
/// Fritsch and Butland, *SIAM J. Sci. Stat. Comput.* 5, 1984, 300-304, with slopes that are harmonic means).
#[derive(Clone, Debug, Default)]
pub struct AddedMassGrowth<S = f64> {
    /// s, phi and dphi/ds at the points; empty for phi = s.
    points: Vec<[S; 3]>,
}

/// Error in the points of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct GrowthError {
    /// `shares` or `factors`.
    pub column: &'static str,
    /// Row of the error; `None` for an error of the whole column.
    pub row: Option<usize>,
    /// The value found.
    pub found: String,
    /// Range or form that is allowed.
    pub allowed: String,
}

impl<S: Scalar> AddedMassGrowth<S> {
    /// Returns phi = s.
    pub fn in_proportion() -> Self {
        Self { points: Vec::new() }
    }

    /// Returns the curve through points whose shares go from 0 to 1.
    ///
    /// # Errors
    /// [`GrowthError`], for the first point that is wrong.
    pub fn new(shares: &[S], factors: &[S]) -> Result<Self, GrowthError> {
        let error = |column, row, found: String, allowed: &str| {
            Err(GrowthError { column, row, found, allowed: allowed.to_owned() })
        };
        if shares.len() < 2 {
            return error("shares", None, format!("{} numbers", shares.len()), "at least two: 0 and 1");
        }
        if factors.len() != shares.len() {
            let allowed = format!("{}, one for each share", shares.len());
            return error("factors", None, format!("{} numbers", factors.len()), &allowed);
        }
        let last = shares.len() - 1;
        for (row, share) in shares.iter().enumerate() {
            let (is_end, expected) = (row == 0 || row == last, if row == 0 { 0.0 } else { 1.0 });
            let rises = row == 0 || (*share - shares[row - 1]).all(|step| step > 0.0);
            if !rises || !share.all(|share| share.is_finite() && (!is_end || share == expected)) {
                let allowed = "increasing numbers, the first 0, the last 1";
                return error("shares", Some(row), share.value().to_string(), allowed);
            }
        }
        for (row, factor) in factors.iter().enumerate() {
            if !factor.all(|x| x.is_finite() && x >= 0.0 && (row > 0 || x == 0.0)) {
                return error("factors", Some(row), factor.value().to_string(), "numbers from 0 up, the first 0");
            }
        }
        Ok(Self { points: with_slopes(shares, factors) })
    }

    /// Returns phi and its rate, for s and its rate.
    pub fn at(&self, share: S, rate: S) -> [S; 2] {
        let Some([_, last, _]) = self.points.last() else { return [share, rate] };
        let mut found = [*last, S::ZERO];
        for pair in self.points.windows(2).rev() {
            let [[x0, y0, d0], [x1, y1, d1]] = [pair[0], pair[1]];
            let width = x1 - x0;
            let (t, three) = ((share - x0) / width, S::constant(3.0));
            let chord = (y1 - y0) / width;
            // y0 + width (d0 t + c t^2 + e t^3)
            let c = three * chord - d0 - d0 - d1;
            let e = d0 + d1 - chord - chord;
            let value = y0 + width * t * (d0 + t * (c + t * e));
            let slope = d0 + t * (c + c + three * e * t);
            let after = found;
            found = core::array::from_fn(|k| share.select_less(x1, || [value, slope][k], || after[k]));
        }
        [found[0], found[1] * rate]
    }
}

/// Returns the points with slopes: the harmonic mean of the neighbouring chords' slopes if both have the same sign,
/// otherwise 0; at the ends the chord's slope.
fn with_slopes<S: Scalar>(shares: &[S], factors: &[S]) -> Vec<[S; 3]> {
    let width = |k: usize| shares[k + 1] - shares[k];
    let chord = |k: usize| (factors[k + 1] - factors[k]) / width(k);
    let last = shares.len() - 1;
    let slope = |k: usize| match k {
        0 => chord(0),
        k if k == last => chord(last - 1),
        k => {
            let (before, after, [h0, h1]) = (chord(k - 1), chord(k), [width(k - 1), width(k)]);
            let weight = (h0 + S::constant(2.0) * h1) / (S::constant(3.0) * (h0 + h1));
            let mean = || before * after / (after * weight + before * (S::ONE - weight));
            (before * after).select_below(f64::MIN_POSITIVE, || S::ZERO, mean)
        }
    };
    (0..=last).map(|k| [shares[k], factors[k], slope(k)]).collect()
}
