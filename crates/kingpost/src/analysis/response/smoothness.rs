//! Finds the columns that are proportional to small motions.

use super::not_linear::NotLinear;
use super::rows::Rows;
use crate::results::Channel;
use nalgebra::DVector;

/// Largest derivative that counts as rounding, as a share of the value.
const NO_SLOPE: f64 = 1e-11;
/// Largest change that counts as rounding, as a share of the value.
const ROUNDING: f64 = 1e-10;
/// Largest change that counts as rounding, as a share of the largest value of the same channel: for example
/// of the load in an unloaded joint.
const ROUNDING_BESIDE: f64 = 1e-13;
/// Largest change that counts as rounding, whatever the unit.
const LEAST: f64 = 1e-13;
/// Largest deviation from the derivative that is ignored, as a share of the derivative.
const BESIDE: f64 = 0.1;
/// Ratio of the changes at half and at whole motion that separates the first order, 1/2, from the second
/// order, 1/4.
const BETWEEN: f64 = 0.35;

/// Marks the columns that are not proportional to small motions. Rows at rest are compared with rows in which
/// states and forces are changed by each of the probes, in both directions, by the whole and by half.
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

/// Returns the largest change of each column that counts as rounding.
fn rounding(rows: &Rows) -> Vec<f64> {
    let of_channel = |channel: &Channel| {
        let values = &rows.mean[channel.offset..][..channel.len];
        let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let beside = ROUNDING_BESIDE * largest + LEAST;
        values.iter().map(|value| ROUNDING * value.abs() + beside).collect::<Vec<_>>()
    };
    rows.channels().list.iter().flat_map(of_channel).collect()
}

/// Returns the part of a change that is odd in the motion, and the size of the even part.
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

/// Classifies a column without a slope: constant, of second order, or not smooth.
fn of_flat([odd, even]: [f64; 2], [odd_half, even_half]: [f64; 2], rounding: f64) -> Option<NotLinear> {
    let (whole, half) = (odd.abs().max(even), odd_half.abs().max(even_half));
    match () {
        () if whole <= rounding => None,
        () if half > BETWEEN * whole => Some(NotLinear::NotSmooth),
        () => Some(NotLinear::SecondOrder),
    }
}

/// Classifies a column with a slope: not smooth if the slope differs between both directions, or differs from
/// the derivative in both.
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
