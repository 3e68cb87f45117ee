//! Spectra and spreading, against closed forms and published values.

use kingpost::sea::waves::{
    Jonswap, OchiHubble, OchiHubblePart, PiersonMoskowitz, Spectrum, SpectrumTable, Spreading, Torsethaugen,
};
use std::f64::consts::{PI, TAU};

const G: f64 = 9.80665;

fn spectra() -> Vec<(f64, Spectrum)> {
    let part =
        |significant_height_m, peak_period_s, shape| OchiHubblePart { significant_height_m, peak_period_s, shape };
    let two_peaks = OchiHubble::new([part(3.0, 14.0, 3.0), part(4.0, 7.0, 1.5)]).unwrap();
    let jonswap = |gamma| Spectrum::Jonswap(Jonswap::new(2.5, 8.0, gamma).unwrap());
    let torsethaugen = |height, period| Spectrum::Torsethaugen(Torsethaugen::new(height, period, G).unwrap());
    vec![
        (2.5, Spectrum::PiersonMoskowitz(PiersonMoskowitz::new(2.5, 8.0).unwrap())),
        (2.5, jonswap(1.0)),
        (2.5, jonswap(3.3)),
        (2.5, jonswap(7.0)),
        (5.0, Spectrum::OchiHubble(two_peaks)),
        (4.0, torsethaugen(4.0, 8.0)),
        (4.0, torsethaugen(4.0, 15.0)),
        (6.6, torsethaugen(6.6, 6.6 * 6.6_f64.cbrt())),
    ]
}

/// The definition Hs = 4 sqrt(m0). The tail of w^-3 at least that lies above 10^4 times the peak holds
/// less than 1e-7 of the energy.
#[test]
fn every_spectrum_has_the_variance_of_its_significant_height() {
    for (height, spectrum) in spectra() {
        let m0 = spectrum.moment(0, spectrum.whole_band());
        assert!((m0 / (height * height / 16.0) - 1.0).abs() < 1e-7, "{spectrum:?}: {m0}");
        assert!((spectrum.significant_height_m() / height - 1.0).abs() < 1e-7);
    }
}

/// Checks the share that the usual band cuts off: 0.2 % of a tail of w^-5, 1.2 % of one of w^-4 that is all of it, and
/// of the sum of two peaks in between.
#[test]
fn the_usual_band_holds_nearly_all_energy() {
    for (_, spectrum) in spectra() {
        let share = spectrum.moment(0, spectrum.usual_band()) / spectrum.moment(0, spectrum.whole_band());
        let cut = if matches!(spectrum, Spectrum::Torsethaugen(_)) { 0.012 } else { 0.0021 };
        assert!(share < 1.0 && share > 1.0 - cut, "{spectrum:?}: {share}");
    }
}

/// Closed form: m_n = (Hs^2 / 16) w_p^n (5/4)^(n/4) Gamma(1 - n/4), by the substitution
/// u = (5/4) (w_p / w)^4; Gamma(1/2) = sqrt(pi), Gamma(3/4) = 1.2254167024651776.
#[test]
fn the_moments_of_pierson_and_moskowitz_are_their_closed_form() {
    let (height, period) = (3.0, 9.0);
    let spectrum = Spectrum::PiersonMoskowitz(PiersonMoskowitz::new(height, period).unwrap());
    let (variance, peak) = (height * height / 16.0, TAU / period);
    // The tails beyond 10^4 times the peak: of order 10^-8 for m2, 10^-12 for m1.
    let m1 = variance * peak * 1.25_f64.powf(0.25) * 1.225_416_702_465_177_6;
    let m2 = variance * peak * peak * (1.25 * PI).sqrt();
    assert!((spectrum.moment(1, spectrum.whole_band()) / m1 - 1.0).abs() < 1e-9);
    assert!((spectrum.moment(2, spectrum.whole_band()) / m2 - 1.0).abs() < 3e-8);
}

/// DNV-RP-C205, sec. 3.5: Tz / Tp = 0.6673 + 0.05037 gamma - 0.006230 gamma^2 + 0.0003341 gamma^3, a fit
/// that is 0.0014 above the closed form 1 / sqrt(sqrt(5 pi / 4)) at gamma = 1.
#[test]
fn jonswap_has_the_published_ratio_of_periods() {
    for (gamma, published) in [(1.0, 0.711), (3.3, 0.778)] {
        let spectrum = Spectrum::Jonswap(Jonswap::new(3.0, 10.0, gamma).unwrap());
        let ratio = spectrum.zero_crossing_period_s(spectrum.whole_band()) / 10.0;
        assert!((ratio - published).abs() < 1.5e-3, "gamma {gamma}: {ratio}");
        let fit = 0.6673 + gamma * (0.05037 - gamma * (0.006230 - 0.0003341 * gamma));
        assert!((ratio - fit).abs() < 2e-3, "gamma {gamma}: {ratio}, fit {fit}");
    }
}

#[test]
fn jonswap_with_gamma_1_is_pierson_and_moskowitz() {
    let jonswap = Jonswap::new(2.5, 8.0, 1.0).unwrap();
    let pierson_moskowitz = PiersonMoskowitz::new(2.5, 8.0).unwrap();
    for w in [0.4, 0.785, 1.0, 3.0] {
        assert!((jonswap.density_m2_s(w) / pierson_moskowitz.density_m2_s(w) - 1.0).abs() < 1e-8);
    }
}

/// The peak of x^-5 exp(-(5/4) x^-4) and of gamma's power are both at x = 1.
#[test]
fn the_peak_is_at_the_peak_period() {
    for gamma in [1.0, 3.3, 7.0] {
        let spectrum = Jonswap::new(2.5, 8.0, gamma).unwrap();
        let peak = TAU / 8.0;
        for factor in [0.98, 0.999, 1.001, 1.02] {
            assert!(spectrum.density_m2_s(factor * peak) < spectrum.density_m2_s(peak));
        }
    }
}

/// Hasselmann et al. (1973): gamma is the ratio of the peaks with and without it, at the same tail.
#[test]
fn gamma_is_the_ratio_of_peak_to_tail() {
    let ratio = |gamma| {
        let spectrum = Jonswap::new(2.5, 8.0, gamma).unwrap();
        spectrum.density_m2_s(TAU / 8.0) / spectrum.density_m2_s(5.0 * TAU / 8.0)
    };
    assert!((ratio(3.3) / ratio(1.0) - 3.3).abs() < 1e-9);
}

/// Ochi & Hubble (1976): a part of shape 1 is Pierson & Moskowitz's spectrum.
#[test]
fn ochi_hubble_with_shape_1_is_the_sum_of_two_pierson_moskowitz_spectra() {
    let part = |significant_height_m, peak_period_s| OchiHubblePart { significant_height_m, peak_period_s, shape: 1.0 };
    let both = OchiHubble::new([part(2.0, 6.0), part(1.0, 12.0)]).unwrap();
    let (first, second) = (PiersonMoskowitz::new(2.0, 6.0).unwrap(), PiersonMoskowitz::new(1.0, 12.0).unwrap());
    for w in [0.4, 0.6, 1.1, 3.0] {
        let sum = first.density_m2_s(w) + second.density_m2_s(w);
        assert!((both.density_m2_s(w) / sum - 1.0).abs() < 1e-12);
    }
    assert_eq!(both.peaks_rad_s(), [TAU / 12.0, TAU / 6.0]);
}

/// Values of waveresponse 1.4.1 (4Subsea, Python), which follows Torsethaugen & Haver (2004) with G = 3.26
/// and the published fit for A. The fit is 3 % off where gamma is 5; where the secondary system, of
/// gamma 1, is nearly alone, 3.26 is 0.13 % below the exact 4 / Gamma(3/4) = 3.2642.
#[test]
fn torsethaugen_agrees_with_another_program() {
    let frequencies = [0.3, 0.45, 0.6, 0.785, 1.0, 1.5, 2.5];
    let wind_sea = [0.004542363, 0.5271747, 0.9044152, 2.169015, 0.7996372, 0.2072753, 0.02853155];
    let swell = [0.2347542, 2.685528, 1.202034, 0.9129677, 0.4652805, 0.1067484, 0.01429116];
    for (period, densities) in [(8.0, wind_sea), (15.0, swell)] {
        let spectrum = Torsethaugen::new(4.0, period, 9.81).unwrap();
        for (w, density) in frequencies.into_iter().zip(densities) {
            assert!((spectrum.density_m2_s(w) / density - 1.0).abs() < 0.03, "Tp {period} s, {w} rad/s");
        }
    }
    let spectrum = Torsethaugen::new(4.0, 8.0, 9.81).unwrap();
    for (w, density) in [(0.3, 0.004542363), (0.45, 0.5271747)] {
        assert!((spectrum.density_m2_s(w) / density - 3.2642 / 3.26).abs() < 2e-4, "{w} rad/s");
    }
}

/// Values of waveresponse 1.4.1, seven digits.
#[test]
fn ochi_hubble_agrees_with_another_program() {
    let frequencies = [0.3, 0.45, 0.6, 0.785, 1.0, 1.5, 2.5];
    let densities = [0.001378248, 3.335902, 0.7443281, 1.536188, 1.757027, 0.2555616, 0.008696696];
    let part =
        |significant_height_m, peak_period_s, shape| OchiHubblePart { significant_height_m, peak_period_s, shape };
    let spectrum = OchiHubble::new([part(3.0, 14.0, 3.0), part(4.0, 7.0, 1.5)]).unwrap();
    for (w, density) in frequencies.into_iter().zip(densities) {
        assert!((spectrum.density_m2_s(w) / density - 1.0).abs() < 1e-6, "{w} rad/s");
    }
}

/// In a sea of T_f exactly, wind and swell formulas both put all energy into one peak.
#[test]
fn torsethaugen_has_one_peak_in_a_fully_developed_sea() {
    let period = 6.6 * 5.0_f64.cbrt();
    let wind = Torsethaugen::new(5.0, period * (1.0 - 1e-9), G).unwrap();
    let swell = Torsethaugen::new(5.0, period * (1.0 + 1e-9), G).unwrap();
    for w in [0.4, 0.6, 1.0, 2.0] {
        assert!((wind.density_m2_s(w) / swell.density_m2_s(w) - 1.0).abs() < 1e-6);
    }
}

#[test]
fn a_table_is_linear_between_its_rows_and_zero_outside() {
    let table = SpectrumTable::new(&[[0.0, 0.0], [1.0, 2.0], [3.0, 0.0]]).unwrap();
    assert_eq!(
        [-1.0, 0.0, 0.5, 1.0, 2.0, 3.0, 4.0].map(|w| table.density_m2_s(w)),
        [0.0, 0.0, 1.0, 2.0, 1.0, 0.0, 0.0]
    );
    let spectrum = Spectrum::Table(table);
    // The triangle's area, and its second moment 2 int_0^1 w^3 + int_1^3 w^2 (3 - w).
    assert!((spectrum.moment(0, spectrum.whole_band()) - 3.0).abs() < 1e-14);
    let second = 0.5 + (26.0 - 20.0);
    assert!((spectrum.moment(2, spectrum.whole_band()) - second).abs() < 1e-13);
}

/// A table of 400 rows of a spectrum has the height of the spectrum: the trapezoidal rule with steps
/// of 0.01 rad/s, an eighth of the width of the peak.
#[test]
fn a_table_of_a_spectrum_has_its_height() {
    let spectrum = Jonswap::new(2.5, 8.0, 3.3).unwrap();
    let rows: Vec<[f64; 2]> = (1..=800).map(|i| f64::from(i) * 0.01).map(|w| [w, spectrum.density_m2_s(w)]).collect();
    let table = Spectrum::Table(SpectrumTable::new(&rows).unwrap());
    assert!((table.significant_height_m() / 2.5 - 1.0).abs() < 1e-3);
}

/// Closed form: the mean of cos b over cos^2s(b/2) is s / (s + 1) (Longuet-Higgins et al. 1963).
#[test]
fn spreading_is_normalised_and_has_the_width_of_its_exponent() {
    for exponent in [0.0, 0.5, 1.0, 4.0, 25.0, 1000.0] {
        let spreading = Spreading::cos_2s(exponent).unwrap();
        let n = 20_000;
        let angle = |i: u32| -PI + TAU * (f64::from(i) + 0.5) / f64::from(n);
        let mean = |f: &dyn Fn(f64) -> f64| {
            (0..n).map(|i| f(angle(i)) * spreading.density_per_rad(angle(i))).sum::<f64>() * TAU / f64::from(n)
        };
        assert!((mean(&|_| 1.0) - 1.0).abs() < 1e-7, "s = {exponent}");
        assert!((mean(&f64::cos) - exponent / (exponent + 1.0)).abs() < 1e-7, "s = {exponent}");
        assert!(mean(&f64::sin).abs() < 1e-12);
        // The same from the quantiles of evenly spaced shares.
        let shares: Vec<f64> = (0..n).map(|i| (f64::from(i) + 0.5) / f64::from(n)).collect();
        let angles = spreading.quantiles_rad(&shares);
        let cosine = angles.iter().map(|b| b.cos()).sum::<f64>() / f64::from(n);
        assert!((cosine - exponent / (exponent + 1.0)).abs() < 1e-4, "s = {exponent}: {cosine}");
        assert!(angles.windows(2).all(|pair| pair[0] < pair[1]));
    }
}

#[test]
fn a_long_crested_sea_has_one_direction() {
    assert_eq!(Spreading::LongCrested.quantiles_rad(&[0.1, 0.9]), [0.0, 0.0]);
    assert_eq!(Spreading::LongCrested.density_per_rad(0.1), 0.0);
}

#[test]
fn errors_of_invalid_sea_quantities_contain_the_allowed_values() {
    let messages = [
        Jonswap::new(-1.0, 8.0, 1.0).unwrap_err().to_string(),
        Jonswap::new(1.0, f64::NAN, 1.0).unwrap_err().to_string(),
        Jonswap::new(1.0, 8.0, 0.5).unwrap_err().to_string(),
        Torsethaugen::new(9.0, 6.0, G).unwrap_err().to_string(),
        SpectrumTable::new(&[[1.0, 1.0]]).unwrap_err().to_string(),
        SpectrumTable::new(&[[1.0, 1.0], [1.0, 2.0]]).unwrap_err().to_string(),
        SpectrumTable::new(&[[1.0, 0.0], [2.0, 0.0]]).unwrap_err().to_string(),
        Spreading::cos_2s(-1.0).unwrap_err().to_string(),
    ];
    let expected = [
        "significant_height_m: found -1, allowed: a number from 0.000001 to 100",
        "peak_period_s: found NaN, allowed: a number from 0.01 to 1000",
        "gamma: found 0.5, allowed: a number from 1 to 20",
        "peak_period_s: found 6, allowed: above 6.000 s, which is 2 sqrt(Hs), and below 25 s, with Hs below 54 m",
        "rows: found 1 rows, allowed: at least 2 rows",
        "rows[1][0]: found 1, allowed: a number above that of the row before, 1",
        "rows: found no energy, allowed: at least one density above 0",
        "spreading_exponent: found -1, allowed: a number from 0 to 10000",
    ];
    assert_eq!(messages, expected);
}
