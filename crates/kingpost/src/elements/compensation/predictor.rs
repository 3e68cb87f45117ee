//! A filter bank of oscillators that predicts a motion in waves and inverts the dynamics of its sensor.

use crate::scalar::Scalar;
use crate::sea::waves::jonswap_shape;

/// The recursions of the bank, for samples y_k of a velocity at the period T_s:
///
/// ```text
/// z_j <- r e^(i w_j T_s) z_j + (1 - r) y        oscillators, w_j spread evenly over the band, r = e^(-T_s d), d = the distance of the w_j
/// x   <- s x + (1 - s) y,  x' <- s x' + (1 - s) x    leaky integrators, s = e^(-T_s / (1.25 T_longest))
/// ```
///
/// A result is a weighted sum of the real and imaginary parts of the z_j, of x, x' and of y itself. The oscillators
/// follow Kuechler, Mahl, Neupert, Schneider & Sawodny, "Active control for an offshore crane using prediction of the
/// vessel's motion", *IEEE/ASME Trans. Mechatronics* 16(2), 2011, pp. 297-309, who track the frequencies in a running
/// spectrum; here the frequencies are fixed, and the weights are a Wiener filter (*Extrapolation, Interpolation, and
/// Smoothing of Stationary Time Series*, 1949) restricted to the filters that the bank can form.
#[derive(Clone, Debug)]
pub struct FilterBank {
    /// r cos(w_j T_s), r sin(w_j T_s).
    oscillators: Vec<[f64; 2]>,
    /// 1 - r.
    entry: f64,
    /// s.
    keeps: f64,
    band: PeriodBand,
}

/// The band of motions for which a bank is designed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeriodBand {
    /// Shortest period of the waves, s.
    pub shortest_period_s: f64,
    /// Longest period, s.
    pub longest_period_s: f64,
    /// Standard deviation of the noise of a sample over that of the motion.
    pub noise_share: f64,
    /// T_s, s.
    pub sampling_period_s: f64,
    /// Peak period of the motion, s, whose spectrum is then mostly that of JONSWAP; `None` if it is spread evenly over the band.
    pub peak_period_s: Option<f64>,
}

/// Dynamics of a signal's sensor and of the drive that receives the result.
#[derive(Clone, Copy, Debug)]
pub struct Dynamics<S> {
    /// The cut-off frequency (rad/s) and damping ratio of a second-order high-pass filter, if the sensor has one.
    pub high_pass: Option<[S; 2]>,
    /// Time from the motion to its use, s.
    pub delay: S,
    /// Time constant of the first-order lag with which the drive responds, s.
    pub lag: S,
}

/// Number of oscillators.
const OSCILLATORS: usize = 8;
/// Frequencies in the band at which the weights are fitted.
const FREQUENCIES: usize = 240;
/// Decay after which the impulse response is truncated: a factor of e to the power of minus this number.
const DECAYS: f64 = 12.0;
/// Variance that a motion with a peak period has beside its spectrum, evenly over the logarithm of the periods from half the shortest
/// to three times the longest: without it a filter that looks ahead amplifies what the spectrum does not contain. Of the tip of a
/// crane at sea 1 % is at periods above 16 s; shares from 1 to 10 % leave errors that differ by 4 % of its standard deviation.
const ELSEWHERE: f64 = 0.02;
/// Peak enhancement of a motion with a peak period: that of the mean JONSWAP spectrum.
const GAMMA: f64 = 3.3;
/// Diagonal added to the normal equations, as a share of their trace: rounding.
const REGULAR: f64 = 1e-13;

impl FilterBank {
    /// Returns the bank for a band.
    pub fn new(band: PeriodBand) -> Self {
        let [lowest, highest] = band.ends();
        let apart = (highest - lowest) / (OSCILLATORS - 1) as f64;
        let step_s = band.sampling_period_s;
        let keeps = libm::exp(-step_s * apart);
        let oscillator = |j: usize| {
            let angle = (lowest + apart * j as f64) * step_s;
            [keeps * libm::cos(angle), keeps * libm::sin(angle)]
        };
        Self {
            oscillators: (0..OSCILLATORS).map(oscillator).collect(),
            entry: 1.0 - keeps,
            keeps: libm::exp(-step_s / (1.25 * band.longest_period_s)),
            band,
        }
    }

    /// Number of its states.
    pub const STATES: usize = 2 * OSCILLATORS + 3;

    /// Updates the states by a sample.
    pub fn take<S: Scalar>(&self, states: &mut [S], sample: S) {
        let (entry, keeps) = (S::constant(self.entry), S::constant(self.keeps));
        for (z, [cosine, sine]) in states.chunks_exact_mut(2).zip(&self.oscillators) {
            let ([real, imaginary], cosine, sine) = ([z[0], z[1]], S::constant(*cosine), S::constant(*sine));
            z[0] = cosine * real - sine * imaginary + entry * sample;
            z[1] = sine * real + cosine * imaginary;
        }
        let [once, twice, last] = &mut states[2 * OSCILLATORS..] else { return };
        *once = keeps * *once + (S::ONE - keeps) * sample;
        *twice = keeps * *twice + (S::ONE - keeps) * *once;
        *last = sample;
    }

    /// Returns the weighted sum of the states: a result.
    pub fn read<S: Scalar>(weights: &[S], states: &[S]) -> S {
        weights.iter().zip(states).fold(S::ZERO, |sum, (weight, state)| sum + *weight * *state)
    }

    /// Computes the weights for a velocity: they minimise the deviation of the filter from a desired frequency response
    /// D at the frequencies w of the band:
    ///
    /// ```text
    /// mean of |F(w) / D(w) - 1|^2 over the spectrum of the positions  +  F(0)^2  +  (noise share w_m)^2 times the power of F n / (s + c)  ->  minimum
    /// ```
    ///
    /// with white noise n of variance 1 in each sample, c = 2 pi / T_longest, w_m = 2 pi over the geometric mean of
    /// both periods. The last term is the position error due to the noise, which a position gain corrects. The term
    /// F(0) removes the effect of a bias.
    pub fn velocity_weights<S: Scalar>(&self, wanted: impl Fn(f64) -> [S; 2]) -> Vec<S> {
        self.weights(wanted, 1.0)
    }

    /// Computes the weights for a position, from which a position gain commands a speed: like those for a velocity,
    /// with c times the noise.
    pub fn position_weights<S: Scalar>(&self, wanted: impl Fn(f64) -> [S; 2]) -> Vec<S> {
        self.weights(wanted, self.band.correction_rad_s())
    }

    fn weights<S: Scalar>(&self, wanted: impl Fn(f64) -> [S; 2], size: f64) -> Vec<S> {
        const N: usize = FilterBank::STATES;
        let mut normal = self.penalties(size);
        let mut right = vec![S::ZERO; N];
        let mut matrix: Vec<Vec<S>> = normal.iter().map(|row| row.iter().map(|x| S::constant(*x)).collect()).collect();
        for (frequency, share) in self.frequencies() {
            let ([real, imaginary], response) = (wanted(frequency), self.response(frequency));
            let weight = S::constant(share) / (real * real + imaginary * imaginary);
            for i in 0..N {
                let [re, im] = response[i];
                right[i] += weight * (S::constant(re) * real + S::constant(im) * imaginary);
                for j in 0..=i {
                    let product = re * response[j][0] + im * response[j][1];
                    matrix[i][j] += weight * S::constant(product);
                    normal[i][j] += product * share;
                }
            }
        }
        let trace: f64 = (0..N).map(|i| normal[i][i]).sum();
        (0..N).for_each(|i| matrix[i][i] += S::constant(REGULAR * trace));
        solve(matrix, right)
    }

    /// Returns the mean of |F(w) / D(w) - 1|^2 over the spectrum, for the filter F of these weights and a desired response D: the
    /// variance of the error over that of the result.
    pub fn error_share(&self, weights: &[f64], wanted: impl Fn(f64) -> [f64; 2]) -> f64 {
        let miss = |(frequency, share): (f64, f64)| {
            let each = self.response(frequency).into_iter().zip(weights);
            let found = each.fold([0.0; 2], |found, (response, weight)| sum(found, scaled(response, *weight)));
            let [real, imaginary] = over(found, wanted(frequency));
            share * ((real - 1.0) * (real - 1.0) + imaginary * imaginary)
        };
        self.frequencies().into_iter().map(miss).sum()
    }

    /// Returns the factor on a velocity from one sample to the next while the sensor is out: it decays at the middle frequency.
    pub fn fades(&self) -> f64 {
        libm::exp(-self.band.sampling_period_s * self.band.middle_rad_s())
    }

    /// Returns the [frequency](PeriodBand::correction_rad_s) below which measured positions correct measured velocities, rad/s.
    pub fn correction_rad_s(&self) -> f64 {
        self.band.correction_rad_s()
    }

    /// Returns the frequencies at which the weights are fitted, rad/s, each with its share of the variance.
    fn frequencies(&self) -> Vec<(f64, f64)> {
        let [lowest, highest] = self.band.ends();
        let Some(peak_period_s) = self.band.peak_period_s else {
            let share = 1.0 / FREQUENCIES as f64;
            let apart = highest - lowest;
            return (0..FREQUENCIES).map(|k| (lowest + apart * k as f64 / (FREQUENCIES - 1) as f64, share)).collect();
        };
        let (lowest, span) = (lowest / 3.0, libm::log(6.0 * highest / lowest));
        let at = |k: usize| lowest * libm::exp(span * k as f64 / (FREQUENCIES - 1) as f64);
        // On a logarithmic axis the density is that over the frequency times the frequency.
        let peaked = |x: f64| x * jonswap_shape(x, GAMMA);
        let densities = (0..FREQUENCIES).map(|k| peaked(at(k) * peak_period_s / core::f64::consts::TAU));
        let densities: Vec<f64> = densities.collect();
        let whole: f64 = densities.iter().sum();
        let share = |density: f64| (density / whole + ELSEWHERE / FREQUENCIES as f64) / (1.0 + ELSEWHERE);
        densities.into_iter().enumerate().map(|(k, density)| (at(k), share(density))).collect()
    }

    /// Returns the frequency response of each state: real and imaginary part.
    pub fn response(&self, frequency: f64) -> Vec<[f64; 2]> {
        let angle = frequency * self.band.sampling_period_s;
        let back = [libm::cos(angle), -libm::sin(angle)];
        let mut all = Vec::with_capacity(Self::STATES);
        for [cosine, sine] in &self.oscillators {
            let slowed = |x: f64| [x * back[0], x * back[1]];
            let ([a, b], [c, d]) = (slowed(*cosine), slowed(*sine));
            // (1 - p z^-1)(1 - p* z^-1) = (1 - r cos z^-1)^2 + (r sin z^-1)^2.
            let lead = [1.0 - a, -b];
            let below = sum(times(lead, lead), times([c, d], [c, d]));
            all.push(scaled(over(lead, below), self.entry));
            all.push(scaled(over([c, d], below), self.entry));
        }
        let leak = over([1.0 - self.keeps, 0.0], [1.0 - self.keeps * back[0], -self.keeps * back[1]]);
        all.extend([leak, times(leak, leak), [1.0, 0.0]]);
        all
    }

    /// Returns the part of the normal equations that does not depend on the desired response: the noise, by sums over
    /// the impulse response, and the response to a constant.
    fn penalties(&self, size: f64) -> Vec<Vec<f64>> {
        let mut sums = vec![vec![0.0; Self::STATES]; Self::STATES];
        let (mut states, mut moved) = (vec![0.0; Self::STATES], vec![0.0; Self::STATES]);
        let PeriodBand { longest_period_s, noise_share, sampling_period_s, .. } = self.band;
        let share = noise_share * self.band.middle_rad_s() * size;
        let keeps = libm::exp(-sampling_period_s * self.band.correction_rad_s());
        let samples = (1.25 * longest_period_s * DECAYS / sampling_period_s) as usize;
        for k in 0..samples.max(1) {
            self.take(&mut states, if k == 0 { 1.0 } else { 0.0 });
            for i in 0..Self::STATES {
                moved[i] = keeps * moved[i] + sampling_period_s * states[i];
            }
            for i in 0..Self::STATES {
                (0..=i).for_each(|j| sums[i][j] += share * share * moved[i] * moved[j]);
            }
        }
        let constant = self.response(0.0);
        for i in 0..Self::STATES {
            (0..=i).for_each(|j| sums[i][j] += constant[i][0] * constant[j][0]);
        }
        sums
    }
}

impl PeriodBand {
    /// Returns the geometric mean of the lowest and the highest frequency, rad/s.
    pub fn middle_rad_s(&self) -> f64 {
        core::f64::consts::TAU / libm::sqrt(self.longest_period_s * self.shortest_period_s)
    }

    /// Returns the frequency below which measured positions correct measured velocities, rad/s: that of the longest
    /// period.
    pub fn correction_rad_s(&self) -> f64 {
        core::f64::consts::TAU / self.longest_period_s
    }

    /// Lowest and highest frequency, rad/s.
    pub fn ends(&self) -> [f64; 2] {
        [self.longest_period_s, self.shortest_period_s].map(|period| core::f64::consts::TAU / period)
    }
}

impl<S: Scalar> Dynamics<S> {
    /// Returns the factor from the measured velocity to the velocity to command: `e^(i w tau) (1 + i w T) / H(i w)`,
    /// with the high-pass filter H.
    pub fn velocity(&self, frequency: f64) -> [S; 2] {
        product(self.undone(frequency), [S::ONE, S::constant(frequency) * self.lag])
    }

    /// Returns the factor from the measured velocity to the position at the same time: `e^(i w tau) / (i w H(i w))`.
    pub fn position(&self, frequency: f64) -> [S; 2] {
        let [real, imaginary] = self.undone(frequency);
        let over = S::constant(1.0 / frequency);
        [imaginary * over, -real * over]
    }

    /// `e^(i w tau) / H(i w)`.
    fn undone(&self, frequency: f64) -> [S; 2] {
        let w = S::constant(frequency);
        let (sine, cosine) = (w * self.delay).sin_cos();
        let ahead = [cosine, sine];
        let Some([cutoff, damping]) = self.high_pass else { return ahead };
        let square = w * w;
        let inverse = [S::ONE - cutoff * cutoff / square, -(S::constant(2.0) * damping * cutoff / w)];
        product(ahead, inverse)
    }
}

/// Solves a positive definite system, given by its lower triangle, by Cholesky factorisation.
pub(super) fn solve<S: Scalar>(mut a: Vec<Vec<S>>, mut b: Vec<S>) -> Vec<S> {
    let n = b.len();
    for i in 0..n {
        for j in 0..=i {
            let sum = (0..j).fold(a[i][j], |sum, k| sum - a[i][k] * a[j][k]);
            a[i][j] = if i == j { sum.sqrt() } else { sum / a[j][j] };
        }
        b[i] = (0..i).fold(b[i], |sum, k| sum - a[i][k] * b[k]) / a[i][i];
    }
    for i in (0..n).rev() {
        b[i] = (i + 1..n).fold(b[i], |sum, k| sum - a[k][i] * b[k]) / a[i][i];
    }
    b
}

fn product<S: Scalar>([a, b]: [S; 2], [c, d]: [S; 2]) -> [S; 2] {
    [a * c - b * d, a * d + b * c]
}

fn times(first: [f64; 2], second: [f64; 2]) -> [f64; 2] {
    product(first, second)
}

fn sum([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a + c, b + d]
}

fn scaled([a, b]: [f64; 2], by: f64) -> [f64; 2] {
    [a * by, b * by]
}

fn over(above: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    scaled(times(above, [c, -d]), 1.0 / (c * c + d * d))
}
