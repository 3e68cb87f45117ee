//! Coefficients that depend on the direction of the waves relative to the hull, at any heading.

use crate::scalar::Scalar;
use core::f64::consts::TAU;

/// Interpolation of values on a regular grid of directions by trigonometric polynomials, exact for functions with at
/// most half as many harmonics as grid points. A ship's transfer functions have about `k L / 2` harmonics.
///
/// Each of several parts has a value f(beta - psi) for every wave, with the wave's direction beta. It is stored as the
/// weights of 1, cos psi, sin psi, cos 2 psi, ..., so that all waves share the harmonics of one heading psi, and a loop
/// over the waves becomes SIMD code.
///
/// A ship's slow heading hardly changes between stages of an integration step. The polynomials are therefore summed,
/// with three derivatives, at the nearest heading of a regular grid, and a Taylor series gives the values near it. The
/// grid is fixed, so a value depends on the heading only. Callers need sums over the waves, so the series is applied to
/// the sums, not wave by wave.
#[derive(Clone)]
pub struct ByHeading<S = f64> {
    waves: usize,
    /// Means, part by part, one for each wave.
    means: Vec<f64>,
    harmonics: Vec<Harmonic>,
    /// The grid heading about which the series are expanded.
    node: Option<S>,
    /// By part and wave: the value at the grid heading and its derivatives with respect to the heading; the derivative
    /// of order k is divided by k!.
    series: Vec<[S; TERMS]>,
    /// From the grid heading to the last requested one, rad.
    beyond: S,
}

/// Weights of cos m psi and sin m psi, with m the index in the list from 1, part by part, for the waves that have this
/// harmonic: long waves have few harmonics.
#[derive(Clone)]
struct Harmonic {
    first: usize,
    waves: usize,
    cosine: Vec<f64>,
    sine: Vec<f64>,
}

/// Share of the largest value of a part below which a harmonic is noise: data have seven digits.
const NEGLIGIBLE: f64 = 1e-7;
/// Number of terms of the Taylor series.
const TERMS: usize = 4;
/// Grid headings per radian. The error in harmonic m is `(m / 4096)^4 / 24` of it: 3e-12 for the twelfth.
const NODES_PER_RAD: f64 = 2048.0;

impl<S: Scalar> ByHeading<S> {
    /// Returns the coefficients for waves with these directions in the world, rad; `on_grid(part, wave)` is f on the
    /// grid.
    pub fn new(parts: usize, directions_rad: &[f64], on_grid: impl Fn(usize, usize) -> Vec<f64>) -> Self {
        let waves = directions_rad.len();
        let rows: Vec<Vec<f64>> = (0..parts * waves).map(|row| on_grid(row / waves, row % waves)).collect();
        let most = rows.iter().map(Vec::len).max().unwrap_or(0) / 2;
        let weights = |m: usize| -> Vec<[f64; 2]> {
            let turns: Vec<[f64; 2]> = directions_rad.iter().map(|beta| turn(m as f64 * beta)).collect();
            rows.iter().zip(turns.iter().cycle()).map(|(f, of_wave)| weights(f, m, *of_wave)).collect()
        };
        let least: Vec<f64> = (0..parts).map(|part| NEGLIGIBLE * largest(&rows[part * waves..][..waves])).collect();
        let harmonics = (1..=most).map(|m| Harmonic::new(&weights(m), &least)).collect();
        let means = weights(0).iter().map(|[mean, _]| *mean).collect();
        let series = vec![[S::ZERO; TERMS]; parts * waves];
        Self { waves, means, harmonics, node: None, series, beyond: S::ZERO }
    }

    /// Sets the heading, rad, for [`sum`](Self::sum) and [`number`](Self::number).
    pub fn turn_to(&mut self, heading: S) {
        let [node] = S::from_values([heading], &|[x]| [libm::round(x * NODES_PER_RAD) / NODES_PER_RAD]);
        if self.node != Some(node) {
            self.expand_about(node);
        }
        self.beyond = heading - node;
    }

    /// Returns the sum of a part's values over the waves, each times the weight of its wave, at the set heading.
    pub fn sum(&self, part: usize, weights: &[S]) -> S {
        self.go_on(weighted(&self.series[part * self.waves..][..self.waves], weights))
    }

    /// Returns a part's value for one wave, at the set heading.
    pub fn number(&self, part: usize, wave: usize) -> S {
        self.go_on(self.series[part * self.waves + wave])
    }

    /// Evaluates the Taylor series about the grid heading.
    fn go_on(&self, [f, first, second, third]: [S; TERMS]) -> S {
        f + self.beyond * (first + self.beyond * (second + self.beyond * third))
    }

    fn expand_about(&mut self, node: S) {
        let (sin, cos) = node.sin_cos();
        let terms = |mean: &f64| [S::constant(*mean), S::ZERO, S::ZERO, S::ZERO];
        self.series.iter_mut().zip(&self.means).for_each(|(series, mean)| *series = terms(mean));
        let mut power = [S::ONE, S::ZERO];
        for (order, harmonic) in (1_u32..).zip(&self.harmonics) {
            power = times(power, [cos, sin]);
            harmonic.add(f64::from(order), power, self.waves, &mut self.series);
        }
        self.node = Some(node);
    }
}

impl Harmonic {
    fn new(weights: &[[f64; 2]], least: &[f64]) -> Self {
        let waves = weights.len() / least.len();
        let counts = |&wave: &usize| {
            let of_wave = weights.iter().skip(wave).step_by(waves);
            of_wave.zip(least).any(|(pair, least)| pair.iter().any(|weight| weight.abs() > *least))
        };
        let first = (0..waves).find(counts).unwrap_or(0);
        let last = (first..waves).rev().find(counts).map_or(first, |wave| wave + 1);
        let kept = |k: usize| {
            let of_part = |part: usize| weights[part * waves..][first..last].iter().map(move |pair| pair[k]);
            (0..least.len()).flat_map(of_part).collect()
        };
        Self { first, waves: last - first, cosine: kept(0), sine: kept(1) }
    }

    /// Adds this harmonic, of order m, and its derivatives to the series: f'' = -m^2 f.
    fn add<S: Scalar>(&self, m: f64, [cos, sin]: [S; 2], stride: usize, series: &mut [[S; TERMS]]) {
        if self.waves == 0 {
            return;
        }
        let [to_first, to_second, to_third] = [m, -m * m / 2.0, -m * m * m / 6.0].map(S::constant);
        let parts = self.cosine.chunks_exact(self.waves).zip(self.sine.chunks_exact(self.waves));
        for (part, (cosine, sine)) in parts.enumerate() {
            let own = &mut series[part * stride + self.first..][..self.waves];
            for (([f, first, second, third], c), s) in own.iter_mut().zip(cosine).zip(sine) {
                let [c, s] = [*c, *s].map(S::constant);
                let (value, slope) = (c * cos + s * sin, s * cos - c * sin);
                *f += value;
                *first += to_first * slope;
                *second += to_second * value;
                *third += to_third * slope;
            }
        }
    }
}

/// Returns the weights of cos m psi and sin m psi in f(beta - psi), from f on the grid, and cos m beta and sin m beta.
fn weights(on_grid: &[f64], m: usize, [cos, sin]: [f64; 2]) -> [f64; 2] {
    let n = on_grid.len();
    let step = turn(TAU * m as f64 / n as f64);
    let (mut cosine, mut sine, mut at) = (0.0, 0.0, [1.0, 0.0]);
    for f in on_grid {
        cosine += f * at[0];
        sine += f * at[1];
        at = times(at, step);
    }
    // On a grid with an even number of points the highest harmonic has no separate mirror image.
    let whole = if m == 0 || 2 * m == n { 1.0 } else { 2.0 } / n as f64;
    [whole * (cosine * cos + sine * sin), whole * (cosine * sin - sine * cos)]
}

/// Returns the weighted sums of the terms, in two independent chains that a processor can add in parallel.
fn weighted<S: Scalar>(series: &[[S; TERMS]], weights: &[S]) -> [S; TERMS] {
    let mut strands = [[S::ZERO; TERMS]; 2];
    let mut add = |strand: usize, terms: &[S; TERMS], weight: S| {
        for (sum, term) in strands[strand].iter_mut().zip(terms) {
            *sum += *term * weight;
        }
    };
    let ((pairs, last), (weights, last_weight)) = (series.as_chunks(), weights.as_chunks());
    for ([even, odd], [of_even, of_odd]) in pairs.iter().zip(weights) {
        add(0, even, *of_even);
        add(1, odd, *of_odd);
    }
    last.iter().zip(last_weight).for_each(|(terms, weight)| add(0, terms, *weight));
    core::array::from_fn(|term| strands[0][term] + strands[1][term])
}

/// Returns cos and sin of an angle, rad.
fn turn(angle: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle);
    [cos, sin]
}

/// Returns cos and sin of the sum of two angles.
fn times<S: Scalar>(a: [S; 2], b: [S; 2]) -> [S; 2] {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

fn largest(rows: &[Vec<f64>]) -> f64 {
    rows.iter().flatten().fold(0.0, |largest, f| f.abs().max(largest))
}

/// Prints a hash of the weights, which are many.
impl<S: core::fmt::Debug> core::fmt::Debug for ByHeading<S> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let harmonics = self.harmonics.iter().flat_map(|harmonic| harmonic.cosine.iter().chain(&harmonic.sine));
        let fold = |hash: u64, weight: &f64| (hash ^ weight.to_bits()).wrapping_mul(0x0100_0000_01b3);
        let hash = self.means.iter().chain(harmonics).fold(0, fold);
        f.debug_struct("ByHeading").field("harmonics", &self.harmonics.len()).field("hash", &hash).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DIRECTIONS: usize = 24;

    fn f(beta: f64) -> f64 {
        1.5 + libm::cos(beta) - 0.25 * libm::sin(3.0 * beta) + 0.125 * libm::cos(11.0 * beta)
    }

    fn number(table: &mut ByHeading, heading: f64) -> f64 {
        table.turn_to(heading);
        table.number(0, 0)
    }

    #[test]
    fn what_has_few_harmonics_is_met_between_the_points_of_the_grid() {
        let grid: Vec<f64> = (0..DIRECTIONS).map(|k| f(TAU * k as f64 / DIRECTIONS as f64)).collect();
        let (directions, parts) = ([0.0, 2.1, -1.0, 3.0], 2);
        // The second part of a wave is its index times the first part; wave 0 has only the mean.
        let row = |part: usize, wave: usize| -> Vec<f64> {
            let share = if part == 0 { 1.0 } else { wave as f64 };
            grid.iter().map(|f| if wave == 0 { 1.5 * share } else { f * share }).collect()
        };
        let mut table = ByHeading::<f64>::new(parts, &directions, row);
        for heading in [0.0, 0.3, 4.0, -7.5] {
            table.turn_to(heading);
            for (wave, direction) in directions.into_iter().enumerate() {
                let expected = if wave == 0 { 1.5 } else { f(direction - heading) };
                assert!((table.number(0, wave) - expected).abs() < 1e-13, "{wave} {heading}");
                assert!((table.number(1, wave) - expected * wave as f64).abs() < 1e-12, "{wave} {heading}");
            }
            let weights = [0.5, -2.0, 0.25, 3.0];
            let of_each = (0..4).map(|wave| table.number(1, wave) * weights[wave]);
            assert!((table.sum(1, &weights) - of_each.sum::<f64>()).abs() < 1e-12, "{heading}");
        }
    }

    /// Midway between two grid headings the centre of the Taylor series changes; its error there is 3e-12 of the
    /// eleventh harmonic.
    #[test]
    fn a_value_depends_on_the_heading_only_and_does_not_jump_between_grid_headings() {
        let grid: Vec<f64> = (0..DIRECTIONS).map(|k| f(TAU * k as f64 / DIRECTIONS as f64)).collect();
        let table = ByHeading::<f64>::new(1, &[0.4], |_, _| grid.clone());
        let at = |heading: f64| number(&mut table.clone(), heading);
        for node in [-3.0, 0.0, 1.0, 517.0] {
            let edge = (node + 0.5) / NODES_PER_RAD;
            let (below, above) = (edge * (1.0 - 1e-15), edge * (1.0 + 1e-15));
            assert!((at(below) - at(above)).abs() < 1e-12, "{node}");
            assert!((at(above) - f(0.4 - above)).abs() < 1e-12, "{node}");
            let mut from_afar = table.clone();
            from_afar.turn_to(2.0);
            assert_eq!(number(&mut from_afar, edge), at(edge));
        }
    }

    #[test]
    fn a_table_on_any_grid_goes_through_its_points() {
        for n in [4_usize, 5, 8, 9] {
            let grid: Vec<f64> = (0..n).map(|k| libm::sin(1.0 + (k * k) as f64)).collect();
            let mut table = ByHeading::<f64>::new(1, &[0.0], |_, _| grid.clone());
            for (k, expected) in grid.iter().enumerate() {
                let found = number(&mut table, -TAU * k as f64 / n as f64);
                assert!((found - expected).abs() < 1e-13, "{n} {k}: {found} {expected}");
            }
        }
    }
}
