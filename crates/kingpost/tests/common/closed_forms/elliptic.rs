//! Elliptic integrals and functions of the parameter m = k^2, 0 <= m < 1.

use core::f64::consts::FRAC_PI_2;

/// Halvings after which the arithmetic-geometric mean has settled.
const STEPS: usize = 12;

/// Complete integral of the first kind, K(m), by the arithmetic-geometric mean
/// (Abramowitz & Stegun 17.6.3).
pub fn complete_first(m: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - m).sqrt());
    for _ in 0..STEPS {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    FRAC_PI_2 / a
}

/// Integral of the first kind, F(phi, m), for any angle phi (DLMF 19.25.5).
pub fn first(phi: f64, m: f64) -> f64 {
    let turns = (phi / core::f64::consts::PI).round();
    let rest = phi - turns * core::f64::consts::PI;
    let (sine, cosine) = rest.sin_cos();
    2.0 * turns * complete_first(m) + sine * carlson_f(cosine * cosine, 1.0 - m * sine * sine, 1.0)
}

/// Complete integral of the third kind, Pi(n, m) = integral of 1 / ((1 - n sin^2) sqrt(1 - m sin^2))
/// from 0 to pi/2, for n < 1 (DLMF 19.25.2).
pub fn complete_third(n: f64, m: f64) -> f64 {
    carlson_f(0.0, 1.0 - m, 1.0) + n / 3.0 * carlson_j(0.0, 1.0 - m, 1.0, 1.0 - n)
}

/// Jacobi's sn, cn and dn of u by Landen's descending transformation
/// (Abramowitz & Stegun 16.4).
pub fn jacobi(u: f64, m: f64) -> [f64; 3] {
    let mut levels = vec![(1.0, m.sqrt())];
    let (mut a, mut b) = (1.0, (1.0 - m).sqrt());
    for _ in 0..STEPS {
        levels.push(((a + b) / 2.0, (a - b) / 2.0));
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    let mut phi = f64::from(1 << STEPS) * a * u;
    for (a, c) in levels.iter().skip(1).rev() {
        phi = (phi + (c / a * phi.sin()).asin()) / 2.0;
    }
    let (sine, cosine) = phi.sin_cos();
    [sine, cosine, (1.0 - m * sine * sine).sqrt()]
}

/// Carlson's R_F by duplication (DLMF 19.36.1).
fn carlson_f(mut x: f64, mut y: f64, mut z: f64) -> f64 {
    loop {
        let mean = (x + y + z) / 3.0;
        let [dx, dy, dz] = [x, y, z].map(|entry| 1.0 - entry / mean);
        if dx.abs().max(dy.abs()).max(dz.abs()) < 1e-3 {
            let (e2, e3) = (dx * dy - dz * dz, dx * dy * dz);
            return (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0) / mean.sqrt();
        }
        let lambda = (x * y).sqrt() + (y * z).sqrt() + (z * x).sqrt();
        [x, y, z] = [x, y, z].map(|entry| (entry + lambda) / 4.0);
    }
}

/// Carlson's R_J by duplication, for p > 0 (DLMF 19.36.2 and Carlson 1995, Algorithm 3).
fn carlson_j(mut x: f64, mut y: f64, mut z: f64, mut p: f64) -> f64 {
    let (mut sum, mut power) = (0.0, 1.0);
    loop {
        let mean = (x + y + z + 2.0 * p) / 5.0;
        let [dx, dy, dz, dp] = [x, y, z, p].map(|entry| 1.0 - entry / mean);
        if dx.abs().max(dy.abs()).max(dz.abs()).max(dp.abs()) < 1e-3 {
            let e2 = dx * dy + dy * dz + dz * dx - 3.0 * dp * dp;
            let e3 = dx * dy * dz + 2.0 * e2 * dp + 4.0 * dp * dp * dp;
            let e4 = (2.0 * dx * dy * dz + e2 * dp + 3.0 * dp * dp * dp) * dp;
            let e5 = dx * dy * dz * dp * dp;
            let series =
                1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0 - 3.0 * e4 / 22.0 - 9.0 * e2 * e3 / 52.0
                    + 3.0 * e5 / 26.0;
            return 3.0 * sum + power * series / (mean * mean.sqrt());
        }
        let lambda = (x * y).sqrt() + (y * z).sqrt() + (z * x).sqrt();
        let alpha = p * (x.sqrt() + y.sqrt() + z.sqrt()) + (x * y * z).sqrt();
        let beta = p * (p + lambda) * (p + lambda);
        sum += power * carlson_c(alpha * alpha, beta);
        power /= 4.0;
        [x, y, z, p] = [x, y, z, p].map(|entry| (entry + lambda) / 4.0);
    }
}

/// R_C(x, y) = R_F(x, y, y).
fn carlson_c(x: f64, y: f64) -> f64 {
    carlson_f(x, y, y)
}
