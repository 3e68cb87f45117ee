//! Finds the columns that follow small motions in proportion.

use super::not_linear::NotLinear;
use super::rows::Rows;
use crate::results::Channel;
use nalgebra::DVector;

/// Derivatives below this share of the value are rounding.
const NO_SLOPE: f64 = 1e-11;
/// Changes below this share of the value are rounding.
const ROUNDING: f64 = 1e-10;
/// Changes below this share of the largest value beside it are rounding: of a joint that carries nothing, say.
const ROUNDING_BESIDE: f64 = 1e-13;
/// Changes below this are rounding, whatever the unit.
const LEAST: f64 = 1e-13;
/// Share of the derivative below which a deviation from it is ignored.
const BESIDE: f64 = 0.1;
/// Where a motion is halved, a change of second order falls to a quarter and one of first order to a half: the border
/// between them.
const BETWEEN: f64 = 0.35;

/// Marks the columns that do not follow in proportion. Rows at rest are compared with those where states and forces are
/// changed by each of the probes and against it, whole and by half.
pub(super) fn mark(rows: &mut Rows, probes: &[Vec<f64>]) {
    let flat: Vec<bool> = (0..rows.mean.len()).map(|column| is_flat(rows, column)).collect();
    let rounding = rounding(rows);
    let mut found: Vec<Option<NotLinear>> = (0..rows.mean.len()).map(|column| without_numbers(rows, column)).collect();
    for probe in probes {
        let by_slopes = &rows.derivatives * DVector::from_column_slice(probe);
        let mut moved = |share: f64| rows.changed_by(&probe.iter().map(|x| share * x).collect::<Vec<_>>());
        let [more, less, half_more, half_less] = [1.0, -1.0, 0.5, -0.5].map(&mut moved);
        for column in 0..rows.mean.len() {
            let rest = rows.mean[column];
            let whole = parts(more[column], less[column], rest);
            let half = parts(half_more[column], half_less[column], rest);
            let rounding = rounding[column];
            let seen = match flat[column] {
                true => of_flat(whole, half, rounding),
                false => of_sloped(whole, half, by_slopes[column], rounding),
            };
            found[column] = found[column].or(seen);
        }
    }
    for (known, found) in rows.not_linear.iter_mut().zip(found) {
        *known = known.or(found);
    }
}

/// Changes of each column that are rounding.
fn rounding(rows: &Rows) -> Vec<f64> {
    let of_channel = |channel: &Channel| {
        let values = &rows.mean[channel.offset..][..channel.len];
        let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let beside = ROUNDING_BESIDE * largest + LEAST;
        values.iter().map(|value| ROUNDING * value.abs() + beside).collect::<Vec<_>>()
    };
    rows.channels().list.iter().flat_map(of_channel).collect()
}

/// Returns the part that changes its sign with the motion, and the size of the part that does not.
fn parts(more: f64, less: f64, rest: f64) -> [f64; 2] {
    [0.5 * (more - less), (0.5 * (more + less) - rest).abs()]
}

fn is_flat(rows: &Rows, column: usize) -> bool {
    rows.derivatives.row(column).amax() <= NO_SLOPE * rows.mean[column].abs()
}

fn without_numbers(rows: &Rows, column: usize) -> Option<NotLinear> {
    let slopes = rows.derivatives.row(column);
    let has_numbers = rows.mean[column].is_finite() && slopes.iter().all(|slope| slope.is_finite());
    (!has_numbers).then_some(NotLinear::NotSmooth)
}

/// Classifies a column without a slope: it stays, or moves in the second order, or its slope is not known.
fn of_flat([odd, even]: [f64; 2], [odd_half, even_half]: [f64; 2], rounding: f64) -> Option<NotLinear> {
    let (whole, half) = (odd.abs().max(even), odd_half.abs().max(even_half));
    match () {
        () if whole <= rounding => None,
        () if half > BETWEEN * whole => Some(NotLinear::NotSmooth),
        () => Some(NotLinear::SecondOrder),
    }
}

/// Classifies a column with a slope: whether it has another one to either side, or all over.
fn of_sloped(
    [odd, even]: [f64; 2],
    [odd_half, even_half]: [f64; 2],
    by_slope: f64,
    rounding: f64,
) -> Option<NotLinear> {
    let first_order = |whole: f64, half: f64| whole > BESIDE * by_slope.abs() && half > BETWEEN * whole;
    let kink = first_order(even, even_half);
    let other_slope = first_order((odd - by_slope).abs(), (odd_half - 0.5 * by_slope).abs());
    (by_slope.abs() > rounding / BESIDE && (kink || other_slope)).then_some(NotLinear::NotSmooth)
}
