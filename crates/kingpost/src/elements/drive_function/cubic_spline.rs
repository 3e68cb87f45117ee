//! Cubic splines over time.

use crate::scalar::Scalar;

/// A curve of cubic pieces through given values at given times, with continuous slope and curvature (de Boor, *A
/// Practical Guide to Splines*, 2001, ch. IV). Its times are plain numbers; its values may carry derivatives.
#[derive(Clone, Debug)]
pub struct CubicSpline<S = f64> {
    times_s: Vec<f64>,
    values: Vec<S>,
    /// Second derivatives at the times, 1/s^2.
    curvatures: Vec<S>,
    period_s: Option<f64>,
}

impl<S: Scalar> CubicSpline<S> {
    /// Returns the spline from rest to rest: constant before the first time and after the last, with zero slope at
    /// both.
    ///
    /// The times, at least two, increase; each has a value.
    ///
    /// ```
    /// use kingpost::elements::CubicSpline;
    /// let turn = CubicSpline::from_rest_to_rest(vec![2.0, 4.0], vec![0.0, 1.0]);
    /// let x: f64 = 0.25;
    /// assert_eq!([1.0, 2.5, 9.0].map(|time| turn.at(time)), [0.0, x * x * (3.0 - 2.0 * x), 1.0]);
    /// ```
    pub fn from_rest_to_rest(times_s: Vec<f64>, values: Vec<S>) -> Self {
        let lengths: Vec<f64> = times_s.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let inner = slopes(&lengths, &values);
        let slopes: Vec<S> = [&[S::ZERO], inner.as_slice(), &[S::ZERO]].concat();
        let right = slopes.windows(2).map(|pair| (pair[1] - pair[0]) * S::constant(6.0)).collect();
        let before = [&[0.0], lengths.as_slice()].concat();
        let after = [lengths.as_slice(), &[0.0]].concat();
        let curvatures = tridiagonal(&before, &diagonal(&before, &after), &after, right);
        Self { times_s, values, curvatures, period_s: None }
    }

    /// Returns a spline that repeats with a period, s: from the last value it continues to the first, one period after
    /// the first time.
    ///
    /// The times, at least three, increase within one period; each has a value.
    ///
    /// ```
    /// use kingpost::elements::CubicSpline;
    /// let wave = CubicSpline::periodic(vec![0.0, 1.0, 2.0, 3.0], vec![0.0, 1.0, 0.0, -1.0], 4.0);
    /// assert!((wave.at(0.5) - wave.at(12.5)).abs() < 1e-14);
    /// assert!((wave.at(0.5) - 0.6875).abs() < 1e-14); // a sine, to 3 %
    /// ```
    pub fn periodic(times_s: Vec<f64>, values: Vec<S>, period_s: f64) -> Self {
        let (first_s, n) = (times_s.first().copied().unwrap_or_default(), times_s.len());
        let ends = times_s.iter().skip(1).copied().chain([first_s + period_s]);
        let after: Vec<f64> = times_s.iter().zip(ends).map(|(start, end)| end - start).collect();
        let before: Vec<f64> = (0..n).map(|i| after[(i + n - 1) % n]).collect();
        let closed = [values.as_slice(), &values[..1]].concat();
        let slopes = slopes(&after, &closed);
        let right = (0..n).map(|i| (slopes[i] - slopes[(i + n - 1) % n]) * S::constant(6.0)).collect();
        let curvatures = cyclic(&before, &diagonal(&before, &after), &after, right);
        Self { times_s, values, curvatures, period_s: Some(period_s) }
    }

    /// Returns the value at a time, s.
    pub fn at(&self, time_s: f64) -> S {
        let (first_s, n) = (self.times_s[0], self.times_s.len());
        let time_s = match self.period_s {
            Some(period_s) => first_s + (time_s - first_s).rem_euclid(period_s),
            None => time_s.clamp(first_s, self.times_s[n - 1]),
        };
        let after = self.times_s.partition_point(|&start| start <= time_s).max(1);
        let (left, right) = (after - 1, after % n);
        if right == 0 && self.period_s.is_none() {
            return self.values[n - 1];
        }
        let end_s = if right == 0 { first_s + self.period_s.unwrap_or_default() } else { self.times_s[right] };
        let length_s = end_s - self.times_s[left];
        let b = (time_s - self.times_s[left]) / length_s;
        let a = 1.0 - b;
        let bend = |share: f64| S::constant((share * share * share - share) * length_s * length_s / 6.0);
        self.values[left] * S::constant(a)
            + self.values[right] * S::constant(b)
            + self.curvatures[left] * bend(a)
            + self.curvatures[right] * bend(b)
    }
}

/// Returns twice the sum of the intervals before and after each time; at an end there is only one.
fn diagonal(before: &[f64], after: &[f64]) -> Vec<f64> {
    before.iter().zip(after).map(|(one, other)| 2.0 * (one + other)).collect()
}

/// Returns the slopes of the chords between neighbouring values.
fn slopes<S: Scalar>(lengths: &[f64], values: &[S]) -> Vec<S> {
    values.windows(2).zip(lengths).map(|(pair, length)| (pair[1] - pair[0]) * S::constant(1.0 / length)).collect()
}

/// Solves `before[i] x[i-1] + diagonal[i] x[i] + after[i] x[i+1] = right[i]`, without `before[0]` and the last of `after`, by
/// elimination without pivots: the diagonal dominates.
fn tridiagonal<S: Scalar>(before: &[f64], diagonal: &[f64], after: &[f64], mut right: Vec<S>) -> Vec<S> {
    let n = right.len();
    let mut pivots = diagonal.to_vec();
    for i in 1..n {
        let factor = before[i] / pivots[i - 1];
        pivots[i] -= factor * after[i - 1];
        right[i] = right[i] - right[i - 1] * S::constant(factor);
    }
    for i in (0..n).rev() {
        if i + 1 < n {
            right[i] = right[i] - right[i + 1] * S::constant(after[i]);
        }
        right[i] = right[i] * S::constant(1.0 / pivots[i]);
    }
    right
}

/// Solves the cyclic tridiagonal system, in which the first and the last unknown are neighbours, as a tridiagonal
/// matrix plus the product of two vectors (Press et al., *Numerical Recipes*, 3rd ed., 2007, sec. 2.7.2).
fn cyclic<S: Scalar>(before: &[f64], diagonal: &[f64], after: &[f64], right: Vec<S>) -> Vec<S> {
    let last = right.len() - 1;
    let (top, bottom, shift) = (before[0], after[last], -diagonal[0]);
    let mut changed = diagonal.to_vec();
    changed[0] -= shift;
    changed[last] -= top * bottom / shift;
    let mut column = vec![0.0; last + 1];
    (column[0], column[last]) = (shift, bottom);
    let column = tridiagonal(before, &changed, after, column);
    let found = tridiagonal(before, &changed, after, right);
    let share = top / shift;
    let scale = 1.0 / (1.0 + column[0] + share * column[last]);
    let factor = (found[0] + found[last] * S::constant(share)) * S::constant(scale);
    found.iter().zip(column).map(|(value, entry)| *value - factor * S::constant(entry)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The spline reproduces a cubic with the same end slopes: `x^2 (3 - 2 x)` on [0, 1].
    #[test]
    fn the_spline_reproduces_a_cubic_with_zero_end_slopes_on_uneven_times() {
        let times = vec![0.0, 0.13, 0.2, 0.55, 0.9, 1.0];
        let cubic = |x: f64| x * x * (3.0 - 2.0 * x);
        let spline = CubicSpline::from_rest_to_rest(times.clone(), times.iter().map(|x| cubic(*x)).collect());
        for k in 0..=100 {
            let x = f64::from(k) / 100.0;
            assert!((spline.at(x) - cubic(x)).abs() < 1e-15, "at {x}");
        }
        assert_eq!([spline.at(-3.0), spline.at(5.0)], [0.0, 1.0]);
    }

    /// The error of a spline through a smooth periodic function is at most 5/384 h^4 times its largest fourth derivative
    /// (Hall & Meyer, *J. Approx. Theory* 16, 1976, p. 105).
    #[test]
    fn the_error_of_a_periodic_spline_of_a_sine_is_below_and_near_the_bound_of_hall_and_meyer() {
        for n in [8_u32, 16, 32] {
            let period = 7.0;
            let w = core::f64::consts::TAU / period;
            let times: Vec<f64> = (0..n).map(|k| 1.5 + period * f64::from(k) / f64::from(n)).collect();
            let spline = CubicSpline::periodic(times.clone(), times.iter().map(|t| libm::sin(w * t)).collect(), period);
            let largest = (0..1000).map(|k| f64::from(k) * 0.03).map(|t| (spline.at(t) - libm::sin(w * t)).abs());
            let largest = largest.fold(0.0, f64::max);
            let bound = 5.0 / 384.0 * libm::pow(w * period / f64::from(n), 4.0);
            assert!(largest < bound && largest > 0.1 * bound, "{n}: {largest}, {bound}");
        }
    }

    #[test]
    fn value_slope_and_curvature_go_on_at_every_time_and_over_the_period() {
        let times = vec![0.5, 1.1, 2.0, 2.2, 3.7];
        let spline = CubicSpline::periodic(times.clone(), vec![0.3, -1.0, 2.0, 0.1, 0.4], 4.0);
        let h = 1e-4;
        let second = |t: f64, s: f64| spline.at(t) - 2.0 * spline.at(t + s) + spline.at(t + 2.0 * s);
        for (time, value) in times.iter().chain([&4.5]).zip([0.3, -1.0, 2.0, 0.1, 0.4, 0.3]) {
            assert!((spline.at(*time) - value).abs() < 1e-14);
            let slopes = [h, -h].map(|s| (spline.at(time + s) - spline.at(*time)) / s);
            assert!((slopes[0] - slopes[1]).abs() < 100.0 * h, "at {time}: {slopes:?}");
            let bends = [h, -h].map(|s| second(*time, s) / (h * h));
            assert!((bends[0] - bends[1]).abs() < 1000.0 * h, "at {time}: {bends:?}");
        }
    }
}
