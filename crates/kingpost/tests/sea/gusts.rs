//! Gusts: spectra against the published formulas, a realisation against its spectrum, and the effect on a
//! ship.

use crate::common;

use common::{simulation, values};
use core::f64::consts::TAU;
use kingpost::scenario::read;
use kingpost::sea::waves::Amplitudes;
use kingpost::world::{GustRealisation, GustSpectrum, Gusts, MeanWind};

fn mean(height: f64, speed: f64, at_ten_metres: f64) -> MeanWind {
    MeanWind { height, speed, at_ten_metres }
}

/// The variance from one frequency to another, in bins of a percent.
fn variance(spectrum: &GustSpectrum, mean: &MeanWind, [lowest, highest]: [f64; 2]) -> f64 {
    let bins = (libm::log(highest / lowest) / 0.01).ceil();
    let end = |i: f64| lowest * libm::pow(highest / lowest, i / bins);
    (0..bins as i32).map(|i| spectrum.deviation(mean, [end(f64::from(i)), end(f64::from(i) + 1.0)]).powi(2)).sum()
}

/// S of ISO 19901-1:2015, A.7.4, written out as in the standard.
fn npd(frequency_hz: f64, at_ten_metres: f64, height: f64) -> f64 {
    let x = 172.0 * frequency_hz * (height / 10.0).powf(2.0 / 3.0) * (at_ten_metres / 10.0).powf(-0.75);
    320.0 * (at_ten_metres / 10.0).powi(2) * (height / 10.0).powf(0.45)
        / (1.0 + x.powf(0.468)).powf(5.0 / (3.0 * 0.468))
}

/// The formula at several winds; 320 m^2/s at frequency 0, 10 m/s and 10 m; and the integral over all frequencies, by
/// Int_0^inf (1 + x^n)^(-5 / (3 n)) dx = Gamma(1/n) Gamma(2 / (3 n)) / (n Gamma(5 / (3 n))) = 0.567 22, whose tail beyond X is
/// 3/2 X^(-2/3) at most.
#[test]
fn the_npd_spectrum_is_that_of_the_standard() {
    let spectrum = GustSpectrum::Npd;
    for (f, u, z) in [(0.001, 10.0, 10.0), (0.01, 20.0, 10.0), (0.1, 30.0, 40.0), (0.5, 12.0, 5.0)] {
        let found = spectrum.density(&mean(z, 1.1 * u, u), f);
        assert!((found / npd(f, u, z) - 1.0).abs() < 1e-13, "{f} Hz: {found}");
    }
    let still = mean(10.0, 10.0, 10.0);
    assert!((spectrum.density(&still, 1e-30) / 320.0 - 1.0).abs() < 1e-10);
    let gamma = libm::tgamma;
    let n = 0.468;
    let integral = gamma(1.0 / n) * gamma(2.0 / (3.0 * n)) / (n * gamma(5.0 / (3.0 * n)));
    let found = variance(&spectrum, &still, [1e-9, 1e6]) * 172.0 / 320.0;
    let tail = 1.5 * libm::pow(172.0 * 1e6, -2.0 / 3.0);
    assert!((found - integral).abs() < 2.0 * tail, "{found} {integral}");
}

/// ISO 19901-1, A.7.3, also gives the turbulence intensity: 0.06 (1 + 0.043 U_10) (z / 10)^-0.22. The two
/// fits to the same measurements agree within 4 % from ten minutes to two seconds.
#[test]
fn the_npd_spectrum_has_about_the_turbulence_intensity_of_the_standard() {
    for (u, z) in [(10.0, 10.0), (20.0, 10.0), (30.0, 10.0), (20.0, 30.0), (25.0, 50.0)] {
        let speed = u * (1.0 + 0.0573 * f64::sqrt(1.0 + 0.15 * u) * f64::ln(z / 10.0));
        let intensity = 0.06 * (1.0 + 0.043 * u) * f64::powf(z / 10.0, -0.22);
        let found = variance(&GustSpectrum::Npd, &mean(z, speed, u), [1.0 / 600.0, 0.5]).sqrt() / (intensity * speed);
        assert!((found - 1.0).abs() < 0.04, "{u} m/s at {z} m: {found}");
    }
}

/// The integral over all frequencies is sigma^2 and that up to f is its share 1 - (1 + 1.5 f / f_p)^(-2/3); f S is largest at
/// f_p = 0.025 U / z (API RP 2A-WSD, 21st ed., 2.3.2).
#[test]
fn the_spectrum_of_api_has_its_variance_and_its_peak() {
    let spectrum = GustSpectrum::Api { peak_coefficient: 0.025 };
    for (z, intensity) in [(10.0, 0.15 * f64::powf(0.5, -0.125)), (20.0, 0.15), (60.0, 0.15 * f64::powf(3.0, -0.275))] {
        let (wind, peak) = (mean(z, 18.0, 16.0), 0.025 * 18.0 / z);
        let left = |f: f64| libm::pow(1.0 + 1.5 * f / peak, -2.0 / 3.0);
        let expected = (18.0 * intensity).powi(2) * (left(1e-3) - left(0.5));
        let found = variance(&spectrum, &wind, [1e-3, 0.5]);
        assert!((found / expected - 1.0).abs() < 1e-9, "{z} m: {found} {expected}");
        let at = |f: f64| f * spectrum.density(&wind, f);
        assert!(at(peak) > at(0.999 * peak) && at(peak) > at(1.001 * peak));
    }
}

/// IEC 61400-1, annex B: f S / sigma^2 = 4 f L / U / (1 + 6 f L / U)^(5/3).
#[test]
fn kaimals_spectrum_is_that_of_the_standard() {
    let spectrum = GustSpectrum::Kaimal { turbulence_intensity: 0.12, length_scale: 340.2 };
    for f in [0.002, 0.02, 0.2] {
        let x = f * 340.2 / 25.0;
        let expected = (0.12_f64 * 25.0).powi(2) * 4.0 * x / (1.0 + 6.0 * x).powf(5.0 / 3.0) / f;
        assert!((spectrum.density(&mean(90.0, 25.0, 20.0), f) / expected - 1.0).abs() < 1e-13);
    }
}

fn realisation(seed: u64, amplitudes: Amplitudes) -> GustRealisation {
    GustRealisation { seed, components: 200, band_hz: [1.0 / 3600.0, 0.5], amplitudes, ramp_s: 0.0 }
}

/// The variance of all components is that of the band, and of a long record too, which no period divides: over the time T the
/// squares of N components and their products leave some sqrt(2 / (N T df)) of it.
#[test]
fn a_realisation_has_the_variance_of_its_spectrum_and_its_seed() {
    let wind = mean(15.0, 21.0, 20.0);
    let drawn = |seed, amplitudes| {
        Gusts::new(GustSpectrum::Npd, &realisation(seed, amplitudes)).expect("it is drawn").at_height(&wind)
    };
    let band = variance(&GustSpectrum::Npd, &wind, [1.0 / 3600.0, 0.5]).sqrt();
    let gusts = drawn(7, Amplitudes::Deterministic);
    assert!((gusts.deviation() / band - 1.0).abs() < 1e-9);
    let record: Vec<f64> = (0..200_000).map(|i| gusts.speed(f64::from(i))).collect();
    let count = record.len() as f64;
    let average = record.iter().sum::<f64>() / count;
    let deviation = (record.iter().map(|u| u * u).sum::<f64>() / count).sqrt();
    assert!(average.abs() < 0.01 * band && (deviation / band - 1.0).abs() < 0.02, "{average} {deviation} {band}");
    // An hour later it blows otherwise: the correlation is that of chance.
    let later = record.iter().zip(&record[3600..]).map(|(a, b)| a * b).sum::<f64>() / (count - 3600.0) / (band * band);
    assert!(later.abs() < 0.2, "{later}");
    assert_eq!(gusts, drawn(7, Amplitudes::Deterministic));
    assert_ne!(gusts, drawn(8, Amplitudes::Deterministic));
    // -ln u of 200 components has the mean 1 and the deviation 1 / sqrt(200), weighed by their energy a little more.
    let random: Vec<f64> =
        (0..40).map(|seed| drawn(seed, Amplitudes::Random).deviation().powi(2) / (band * band)).collect();
    let average = random.iter().sum::<f64>() / 40.0;
    assert!((average - 1.0).abs() < 0.06 && random.iter().any(|share| (share - 1.0).abs() > 0.03), "{average}");
}

/// Each band of frequencies of a record has the variance of the spectrum there: by the sum over the record times e^(i w t) at the
/// middle of a band one component alone would not show.
#[test]
fn the_components_lie_where_the_spectrum_has_its_energy() {
    let wind = mean(10.0, 20.0, 20.0);
    for band in [[1.0 / 3600.0, 0.003], [0.003, 0.03], [0.03, 0.5]] {
        let of_band = GustRealisation { band_hz: band, components: 60, ..realisation(3, Amplitudes::Deterministic) };
        let gusts = Gusts::new(GustSpectrum::Npd, &of_band).expect("it is drawn").at_height(&wind);
        let expected = variance(&GustSpectrum::Npd, &wind, band).sqrt();
        assert!((gusts.deviation() / expected - 1.0).abs() < 1e-6);
        // Rice: the mean square of the rate lies between those of the ends.
        let step = 0.05;
        let rate = |i: i32| (gusts.speed(step * f64::from(i + 1)) - gusts.speed(step * f64::from(i))) / step;
        let square = (0..100_000).map(|i| rate(i).powi(2)).sum::<f64>() / 1e5;
        let frequency = square.sqrt() / (TAU * expected);
        assert!(frequency > 0.9 * band[0] && frequency < 1.1 * band[1], "{frequency} of {band:?}");
    }
}

/// A ship of 1000 t with C_x = 1 from all sides.
fn ship(gusts: &str) -> String {
    format!(
        "version: 1\ntitle: A ship in gusts\nsimulation: {{step_s: 0.1, duration_s: 100, seed: 4}}\nbodies:\n  ship:\n    \
         mass_t: 1000\n    inertia: {{tensor: {{moments_kg_m2: [2e7, 4e8, 4e8]}}}}\n    joint: {{floating: {{}}}}\n\
         wind: {{speed_m_s: 20, direction_deg: 0, profile: uniform{gusts}}}\n\
         forces: {{breeze: {{wind_load: {{body: ship, coefficients: {{symmetric: true, directions_deg: [0, 90, 180], \
         surge: [1, 1, 1], sway: [0, 0, 0], yaw: [0, 0, 0], frontal_area_m2: 200, lateral_area_m2: 900, length_m: 80}}}}}}}}\n"
    )
}

/// The force is rho/2 (U + u - v)^2 A with the u of a realisation with the same seed at the load's height,
/// and the work of the wind is the energy of the ship.
#[test]
fn gusts_push_a_ship_by_the_square_of_the_whole_wind_and_the_ledger_has_their_work() {
    let mut simulation = simulation(&ship(", gusts: {ramp_s: 5}"));
    let of_run = GustRealisation { ramp_s: 5.0, ..realisation(4, Amplitudes::Deterministic) };
    let wind = mean(10.0, 20.0, 20.0);
    let gusts = Gusts::new(GustSpectrum::Npd, &of_run).expect("it is drawn").at_height(&wind);
    let mut speeds = Vec::new();
    for steps in 0..20 {
        let (time_s, v) = (5.0 * f64::from(steps), simulation.state().v[0]);
        let expected = 20.0 + gusts.speed(time_s);
        let found = values(&mut simulation, "flow_speed")[0];
        assert!((found - expected).abs() < 1e-12, "{time_s} s: {found} {expected}");
        let force = values(&mut simulation, "flow_force")[0];
        assert!((force / (0.5 * 1.225 * (expected - v).powi(2) * 200.0) - 1.0).abs() < 1e-12);
        speeds.push(found);
        simulation.step(50).expect("it runs");
    }
    assert_eq!(speeds[0], 20.0);
    // Of a deviation of 2.4 m/s.
    let largest = speeds.iter().fold(0.0_f64, |largest, speed| largest.max(*speed));
    let least = speeds.iter().fold(f64::INFINITY, |least, speed| least.min(*speed));
    assert!(largest - least > 3.0, "{speeds:?}");
    let (v, work) = (simulation.state().v[0], values(&mut simulation, "work_by_outside")[0]);
    assert!((work / (0.5e6 * v * v) - 1.0).abs() < 1e-9, "{work}");
    assert!(values(&mut simulation, "energy_error")[0].abs() < 1e-9 * work);
}

/// A ship comes to rest in the mean wind, and its run starts there.
#[test]
fn an_equilibrium_is_that_of_the_mean_wind() {
    let line = "hawser: {spring_line: {first: {body: ship}, second: {body: world, position_m: [-300, 0, 0]}, \
                unstretched_length_m: 100, axial_stiffness_N: 1e6}}, hold: {soft_hold: {body: ship}}}\n";
    let text = |gusts: &str| {
        let held = ship(gusts).replace("80}}}}\n", &format!("80}}}}}}, {line}"));
        held.replace("seed: 4", "begin_at_equilibrium: true")
    };
    let steady = simulation(&text("")).state().q.clone();
    let gusty = simulation(&text(", gusts: {}")).state().q.clone();
    assert!(steady[0].abs() > 0.0 || steady[4].abs() > 0.0);
    assert_eq!(steady, gusty);
}

#[test]
fn invalid_gusts_are_refused() {
    let refused = |gusts: &str, message: &str| {
        let error = read(&ship(gusts), "test.yaml", &[]).expect_err("it is refused").to_string();
        assert!(error.contains(message), "{error}");
    };
    refused(", gusts: {components: 0}", "wind.gusts.components: found 0, allowed: a number from 1 to 20000");
    refused(", gusts: {lowest_Hz: 1}", "wind.gusts.highest_Hz: found 0.5, allowed: more than lowest_Hz, 1");
    refused(", gusts: {spectrum: {kaimal: {turbulence_intensity: 0.1}}}", "length_scale_m");
    let npd = ship(", reference_height_m: 20").replace("uniform", "npd");
    let error = read(&npd, "test.yaml", &[]).expect_err("it is refused").to_string();
    assert!(
        error.contains("wind.reference_height_m: found 20, allowed: 10, to which the profile npd refers"),
        "{error}"
    );
}
