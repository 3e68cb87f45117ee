//! Random seas and measured records: energy, sampling, repetition, seeds.

use kingpost::scenario::read;
use kingpost::sea::waves::{
    Amplitudes, Band, ElevationRecord, ElevationTable, Jonswap, PiersonMoskowitz, Spectrum, Spreading, Water,
    WaveComponent, WaveField, WaveSystem, significant_height_of_components_m,
};
use std::f64::consts::TAU;

const THREE_HOURS_S: f64 = 10_800.0;

#[test]
fn waves_beyond_the_breaking_limit_are_refused() {
    let sea = |waves: &str| {
        let text = format!(
            "version: 1\ntitle: Sea\nsimulation: {{step_s: 0.1, duration_s: 1}}\nbodies:\n  ball: {{mass_kg: 1, shape: \
             {{sphere: {{radius_m: 1}}}}, joint: {{floating: {{}}}}}}\nforces: {{gravity: {{gravity: {{}}}}}}\n\
             sea: {{waves: {{w: {waves}}}}}\n"
        );
        read(&text, "sea.yaml", &[]).and_then(|s| s.setup().map(drop)).map_err(|error| error.to_string())
    };
    // 0.142 g T^2 / 2 pi of 4.5 s.
    let allowed = "allowed: at most 4.49 m, at which waves of 4.5 s break";
    let refused = |waves: &str, field: &str| {
        let error = sea(waves).expect_err(waves);
        assert!(error.contains(field) && error.contains(allowed), "{error}");
    };
    refused("{regular: {height_m: 20, period_s: 4.5}}", "sea.waves.w.regular.height_m: found 20");
    refused("{regular: {height_m: 4.5, period_s: 4.5}}", "sea.waves.w.regular.height_m: found 4.5");
    refused("{jonswap: {significant_height_m: 5, peak_period_s: 4.5}}", "w.jonswap.significant_height_m: found 5");
    refused("{pierson_moskowitz: {significant_height_m: 5, peak_period_s: 4.5}}", "significant_height_m: found 5");
    assert_eq!(sea("{regular: {height_m: 4.48, period_s: 4.5}}"), Ok(()));
}

fn system() -> WaveSystem {
    WaveSystem {
        spectrum: Spectrum::Jonswap(Jonswap::new(2.5, 8.0, 3.3).unwrap()),
        spreading: Spreading::cos_2s(10.0).unwrap(),
        direction_rad: 3.0,
        components: 200,
        amplitudes: Amplitudes::Deterministic,
        band: None,
    }
}

fn record(components: &[WaveComponent], interval_s: f64, duration_s: f64) -> Vec<f64> {
    let field = WaveField::new(components, Water::default(), 0.0);
    let samples = (duration_s / interval_s) as u32;
    (0..samples).map(|i| field.elevation_m([0.0, 0.0], f64::from(i) * interval_s)).collect()
}

fn significant_height(record: &[f64]) -> f64 {
    let mean = record.iter().sum::<f64>() / record.len() as f64;
    4.0 * (record.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / record.len() as f64).sqrt()
}

/// The standard error of the variance of a Gaussian record of length T is sqrt((2 pi / T) int S^2 dw)
/// (Bendat & Piersol, *Random Data*, 4th ed., sec. 8.2, with Parseval's theorem); that of Hs is half of
/// it, relative: 1.7 % here. Three of them are allowed; with deterministic amplitudes the sea keeps to
/// 0.5 % (measured).
#[test]
fn three_hours_of_the_sea_have_its_significant_height() {
    let system = system();
    let band = system.spectrum.usual_band();
    let (n, width) = (20_000, band.highest_rad_s - band.lowest_rad_s);
    let middle = |i: u32| band.lowest_rad_s + (f64::from(i) + 0.5) * width / f64::from(n);
    let square = (0..n).map(|i| system.spectrum.density_m2_s(middle(i)).powi(2)).sum::<f64>() * width / f64::from(n);
    let standard_error = 0.5 * (TAU / THREE_HOURS_S * square).sqrt() / (2.5 * 2.5 / 16.0);
    assert!((0.016..0.018).contains(&standard_error), "{standard_error}");
    for seed in 0..3 {
        let components = system.components(seed, 0, &Water::default()).unwrap();
        let height = significant_height(&record(&components, 0.5, THREE_HOURS_S));
        assert!((height / 2.5 - 1.0).abs() < 3.0 * standard_error, "seed {seed}: {height}");
    }
}

/// By construction the sum of the waves has the energy of the whole spectrum.
#[test]
fn deterministic_amplitudes_have_the_significant_height_of_the_spectrum() {
    for components in [1, 2, 30, 200, 1000] {
        let system = WaveSystem { components, ..system() };
        let waves = system.components(1, 0, &Water::default()).unwrap();
        assert_eq!(waves.len(), components);
        assert!((significant_height_of_components_m(&waves) / 2.5 - 1.0).abs() < 1e-7);
    }
}

/// Mean period of the realisation: the second moment of 200 waves against that of the band, which
/// drawing a frequency within each bin moves by a fraction of the widest bin's share, below 1 %.
#[test]
fn the_waves_have_the_mean_period_of_the_band() {
    let system = system();
    let expected = system.spectrum.zero_crossing_period_s(system.spectrum.usual_band());
    let waves = system.components(1, 0, &Water::default()).unwrap();
    let moment = |n: i32| waves.iter().map(|c| c.amplitude_m.powi(2) * c.angular_frequency_rad_s.powi(n)).sum::<f64>();
    let period = TAU * (moment(0) / moment(2)).sqrt();
    assert!((period / expected - 1.0).abs() < 0.01, "{period} {expected}");
}

/// -ln u has mean 1 and variance 1, so m0 of one sea has the standard error sqrt(sum E_i^2), E_i the
/// energies of the bins; over 200 seeds 1/sqrt(200) of that. Four of them are allowed.
#[test]
fn random_amplitudes_have_the_energy_of_the_spectrum_on_average() {
    let deterministic = system().components(0, 0, &Water::default()).unwrap();
    let energies: Vec<f64> = deterministic.iter().map(|c| 0.5 * c.amplitude_m * c.amplitude_m).collect();
    let standard_error = energies.iter().map(|e| e * e).sum::<f64>().sqrt();
    let system = WaveSystem { amplitudes: Amplitudes::Random, ..system() };
    let variance = |seed| {
        (significant_height_of_components_m(&system.components(seed, 0, &Water::default()).unwrap()) / 4.0).powi(2)
    };
    let variances: Vec<f64> = (0..200).map(variance).collect();
    let mean = variances.iter().sum::<f64>() / 200.0;
    assert!((mean - 2.5 * 2.5 / 16.0).abs() < 4.0 * standard_error / 200.0_f64.sqrt());
    // The scatter itself has a standard error of about 1 / sqrt(2 * 200), 5 %, of itself.
    let scatter = (variances.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / 199.0).sqrt();
    assert!((scatter / standard_error - 1.0).abs() < 0.25, "{scatter} {standard_error}");
}

/// The autocorrelation of the sum, sum a^2 cos(w lag) / sum a^2, after the first ten periods: 1 at a lag
/// at which the sea repeats. Waves without a common divisor leave a random sum with the standard
/// deviation sqrt(sum a^4 / 2) / sum a^2, here 0.06; 21,600 lags see at most five of them (0.22 to 0.30 over six seeds). Equal
/// frequency steps over the same band repeat after 2 pi / step, 370 s.
#[test]
fn the_sea_does_not_repeat_within_three_hours() {
    let waves = system().components(11, 0, &Water::default()).unwrap();
    let whole: f64 = waves.iter().map(|c| c.amplitude_m.powi(2)).sum();
    let largest = |frequencies: &[f64]| {
        let correlation = |lag: f64| {
            let sum = |(c, w): (&WaveComponent, &f64)| c.amplitude_m.powi(2) * (w * lag).cos();
            waves.iter().zip(frequencies).map(sum).sum::<f64>() / whole
        };
        (160..21_600).map(|i| correlation(0.5 * f64::from(i)).abs()).fold(0.0, f64::max)
    };
    let drawn: Vec<f64> = waves.iter().map(|c| c.angular_frequency_rad_s).collect();
    let even: Vec<f64> = (0..200).map(|i| 0.393 + 0.017 * f64::from(i)).collect();
    assert!(largest(&drawn) < 0.4, "{}", largest(&drawn));
    assert!(largest(&even) > 0.9);
}

#[test]
fn equal_seeds_give_bitwise_identical_seas_and_different_seeds_different_ones() {
    let (system, water) = (system(), Water::default());
    let sea = |seed, number| system.components(seed, number, &water).unwrap();
    assert_eq!(sea(4, 0), sea(4, 0));
    let differ = |a: &[WaveComponent], b: &[WaveComponent]| a.iter().zip(b).all(|(a, b)| a.phase_rad != b.phase_rad);
    assert!(differ(&sea(4, 0), &sea(5, 0)));
    assert!(differ(&sea(4, 0), &sea(4, 1)));
}

/// Checks the scatter of directions: of cos^2s, the standard deviation of b is about sqrt(2 / s), here 0.44 rad; the
/// mean of 2000 is drawn within four standard errors.
#[test]
fn directions_scatter_about_the_mean_direction() {
    let system = WaveSystem { components: 2000, ..system() };
    let waves = system.components(2, 0, &Water::default()).unwrap();
    let mean = waves.iter().map(|c| c.direction_rad).sum::<f64>() / 2000.0;
    assert!((mean - 3.0).abs() < 4.0 * 0.44 / 2000.0_f64.sqrt());
    let scatter = (waves.iter().map(|c| (c.direction_rad - mean).powi(2)).sum::<f64>() / 2000.0).sqrt();
    assert!((0.40..0.48).contains(&scatter), "{scatter}");
    let long_crested = WaveSystem { spreading: Spreading::LongCrested, ..system };
    let waves = long_crested.components(2, 0, &Water::default()).unwrap();
    assert!(waves.iter().all(|c| c.direction_rad == 3.0));
}

/// Independent seas add their variances.
#[test]
fn wind_sea_and_swell_are_combined_in_one_list() {
    let swell = WaveSystem {
        spectrum: Spectrum::PiersonMoskowitz(PiersonMoskowitz::new(1.5, 14.0).unwrap()),
        spreading: Spreading::LongCrested,
        direction_rad: 0.5,
        ..system()
    };
    let mut waves = system().components(1, 0, &Water::default()).unwrap();
    waves.extend(swell.components(1, 1, &Water::default()).unwrap());
    let both = (2.5_f64 * 2.5 + 1.5 * 1.5).sqrt();
    assert!((significant_height_of_components_m(&waves) / both - 1.0).abs() < 1e-7);
}

#[test]
fn frequencies_are_in_order_within_the_band_and_never_equal() {
    let band = Band { lowest_rad_s: 0.5, highest_rad_s: 2.0 };
    let waves = WaveSystem { band: Some(band), ..system() }.components(1, 0, &Water::default()).unwrap();
    assert!(waves.windows(2).all(|pair| pair[0].angular_frequency_rad_s < pair[1].angular_frequency_rad_s));
    assert!(waves[0].angular_frequency_rad_s >= 0.5 && waves[199].angular_frequency_rad_s <= 2.0);
    let kept = 4.0 * system().spectrum.moment(0, band).sqrt();
    assert!((significant_height_of_components_m(&waves) / kept - 1.0).abs() < 1e-7);
}

/// `Int S dw = Hs^2 / 16 e^(-(5/4) (w_p / w)^4)` from 0 to w of Pierson and Moskowitz' spectrum: the other
/// waves do not replace the energy that is cut off, and at an end without a cut the sea is unchanged.
#[test]
fn a_cut_takes_the_energy_of_the_spectrum_there_and_leaves_the_rest() {
    let spectrum = Spectrum::PiersonMoskowitz(PiersonMoskowitz::new(2.5, 8.0).unwrap());
    let below = |w: f64| (-1.25 * (TAU / 8.0 / w).powi(4)).exp();
    let all = Band { lowest_rad_s: 0.0, highest_rad_s: f64::INFINITY };
    let of = |band: Option<Band>| {
        let system = WaveSystem { spectrum: spectrum.clone(), band, ..system() };
        let waves = system.components(1, 0, &Water::default()).unwrap();
        (system.energy_cut_off(), (significant_height_of_components_m(&waves) / 2.5).powi(2), waves)
    };
    let cases = [
        (all, 0.0),
        (Band { highest_rad_s: 1.5, ..all }, 1.0 - below(1.5)),
        (Band { lowest_rad_s: 0.7, ..all }, below(0.7)),
        (Band { lowest_rad_s: 0.7, highest_rad_s: 1.5 }, below(0.7) + 1.0 - below(1.5)),
    ];
    for (band, cut) in cases {
        let (told, kept, _) = of(Some(band));
        assert!((told - cut).abs() < 1e-7 && (kept - (1.0 - cut)).abs() < 1e-6, "{band:?}: {told} {kept} {cut}");
    }
    assert_eq!(of(Some(all)).2, of(None).2);
}

fn measured(elevations_m: Vec<f64>, band: Option<Band>) -> ElevationRecord {
    ElevationRecord {
        elevations_m,
        start_s: 12.0,
        interval_s: 0.5,
        position_m: [30.0, -40.0],
        direction_rad: 2.0,
        band,
    }
}

/// The transform of a record of odd length is its inverse, but for the mean.
#[test]
fn a_measured_record_is_reproduced_at_its_position_and_time() {
    let waves = system().components(3, 0, &Water::default()).unwrap();
    let taken = record(&waves, 0.5, 300.5);
    let mean = taken.iter().sum::<f64>() / taken.len() as f64;
    let water = Water { depth_m: Some(40.0), ..Water::default() };
    let components = measured(taken.clone(), None).components(&water).unwrap();
    let field = WaveField::new(&components, water, 0.0);
    for (i, elevation) in taken.iter().enumerate() {
        let back = field.elevation_m([30.0, -40.0], 12.0 + 0.5 * i as f64);
        assert!((back - (elevation - mean)).abs() < 1e-11, "sample {i}");
    }
}

/// Checks that the sums stored in a table do not change: of one band, of another band beyond it, and of the
/// first band again.
#[test]
fn the_waves_of_a_table_are_bitwise_identical_at_every_call() {
    let taken = record(&system().components(3, 0, &Water::default()).unwrap(), 0.5, 300.5);
    let rows: Vec<String> = (0..).zip(&taken).map(|(i, eta)| format!("{},{eta}", 12.0 + 0.5 * f64::from(i))).collect();
    let table = ElevationTable::read_csv(&format!("time_s,elevation_m\n{}\n", rows.join("\n"))).unwrap();
    let water = Water::default();
    for (lowest_rad_s, highest_rad_s) in [(0.4, 1.0), (0.2, 2.0), (0.4, 1.0)] {
        let band = Band { lowest_rad_s, highest_rad_s };
        let expected = measured(taken.clone(), Some(band)).components(&water).unwrap();
        assert_eq!(table.components([30.0, -40.0], 2.0, band, &water).unwrap(), expected);
    }
}

#[test]
fn a_file_without_waves_is_an_error() {
    let error = ElevationTable::read_csv("time_s,elevation_m\n0,0\n0.5,0\n1,0\n1.5,0\n").unwrap_err();
    assert!(error.to_string().contains("no waves in the record: every elevation is 0 m"), "{error}");
}

/// Parseval's theorem: the energy that a band cuts off is that of the other harmonics.
#[test]
fn a_band_keeps_its_harmonics_of_a_record_only() {
    let tone = |n: u32, cycles: f64| (TAU * cycles * f64::from(n) / 600.0).cos();
    let taken: Vec<f64> = (0..600).map(|n| 0.3 + tone(n, 2.0) + 0.5 * tone(n, 30.0) + 0.2 * tone(n, 200.0)).collect();
    let band = Band { lowest_rad_s: 0.2, highest_rad_s: 2.0 };
    let components = measured(taken, Some(band)).components(&Water::default()).unwrap();
    // Harmonics of 2 pi / 300 rad/s from 10 to 95.
    assert_eq!(components.len(), 86);
    for wave in &components {
        let expected = if (wave.angular_frequency_rad_s - TAU / 10.0).abs() < 1e-9 { 0.5 } else { 0.0 };
        assert!((wave.amplitude_m - expected).abs() < 1e-12);
    }
}

#[test]
fn the_error_of_an_invalid_sea_contains_the_allowed_values() {
    let water = Water::default();
    let band = |lowest_rad_s, highest_rad_s| Some(Band { lowest_rad_s, highest_rad_s });
    let of = |system: WaveSystem| system.components(0, 0, &water).unwrap_err().to_string();
    let record = |record: ElevationRecord| record.components(&water).unwrap_err().to_string();
    let messages = [
        of(WaveSystem { components: 0, ..system() }),
        of(WaveSystem { direction_rad: f64::INFINITY, ..system() }),
        of(WaveSystem { band: band(2.0, 1.0), ..system() }),
        of(WaveSystem { band: band(1e-4, 1e-3), ..system() }),
        record(measured(vec![0.0; 3], None)),
        record(measured(vec![0.0, f64::NAN, 0.0, 0.0], None)),
        record(measured([0.0, 1.0].repeat(50), band(0.01, 0.02))),
        record(measured(vec![0.25; 100], None)),
    ];
    let expected = [
        "components: found 0, allowed: a number from 1 to 20000",
        "direction_rad: found inf, allowed: a number from -10000 to 10000",
        "highest_rad_s: found 1, allowed: a number above lowest_rad_s, which is 2",
        "lowest_rad_s, highest_rad_s: found no energy from 0.0001 to 0.001 rad/s, allowed: a band in which S(w) is above 0",
        "elevations_m: found 3 samples, allowed: 4 to 65536 samples",
        "elevations_m[1]: found NaN, allowed: a number from -100 to 100",
        "lowest_rad_s, highest_rad_s: found 0 harmonics of 0.125664 rad/s, allowed: a band with 1 to 20000 harmonics below half the sampling frequency",
        "elevations_m: found no waves in the record: every elevation is 0.25 m, allowed: elevations that differ",
    ];
    assert_eq!(messages, expected);
}
