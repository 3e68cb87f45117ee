//! The field of linear waves against the equations that it solves.

use kingpost::scalar::{Dual, Lanes, Scalar};
use kingpost::sea::waves::{Noise, Stretching, Water, WaveComponent, WaveField, WavesAtBody, WavesAtPoints};
use kingpost::spatial::Vector3;
use std::f64::consts::TAU;

const SHALLOW: Water = Water { density_kg_m3: 1000.0, gravity_m_s2: 9.81, depth_m: Some(25.0) };
const TIME: f64 = 37.3;

/// Twelve waves from 0.4 to 1.5 rad/s in all directions.
fn waves(water: &Water) -> Vec<WaveComponent> {
    let noise = Noise::new(5);
    let draw = |i, channel| noise.uniform(channel, i);
    let wave =
        |i| WaveComponent::in_water(water, 0.2 + draw(i, 0), 0.4 + 0.1 * i as f64, TAU * draw(i, 1), TAU * draw(i, 2));
    (0..12).map(wave).collect()
}

fn field(water: Water) -> WaveField {
    WaveField::new(&waves(&water), water, 0.0)
}

fn points() -> Vec<Vector3> {
    let noise = Noise::new(6);
    (0..20)
        .map(|i| {
            let [x, y, z] = [0, 1, 2].map(|channel| noise.uniform(channel, i));
            Vector3::new(100.0 * x - 50.0, 100.0 * y - 50.0, -0.01 - 24.98 * z)
        })
        .collect()
}

/// Central differences along the three axes.
fn gradient(point: Vector3, step: f64, f: impl Fn(Vector3) -> f64) -> [f64; 3] {
    [0, 1, 2].map(|axis| {
        let mut moved = [Vector3::zero(); 2];
        moved[0][axis] = step;
        moved[1][axis] = -step;
        (f(point + moved[0]) - f(point + moved[1])) / (2.0 * step)
    })
}

/// Speeds are up to 10 m/s and wave numbers up to 0.23 1/m: with steps of 1 mm, central differences
/// are off by k^3 h^2 / 6 = 2e-9 of the speed, and by rounding 1e-12.
const STEP: f64 = 1e-3;
const DIFFERENCES: f64 = 2e-7;

/// Laplace's equation for the potential: no divergence and no curl of the velocity.
#[test]
fn the_wave_velocity_field_is_free_of_divergence_and_curl() {
    for water in [SHALLOW, Water::default()] {
        let field = field(water);
        for point in points() {
            let slope = [0, 1, 2].map(|i| gradient(point, STEP, |p| field.linear_kinematics(p, TIME).velocity_m_s[i]));
            assert!((slope[0][0] + slope[1][1] + slope[2][2]).abs() < DIFFERENCES);
            for [i, j] in [[0, 1], [1, 2], [2, 0]] {
                assert!((slope[i][j] - slope[j][i]).abs() < DIFFERENCES);
            }
        }
    }
}

/// Euler's equation, linear: rho dv/dt = -grad p, with dv/dt by differences too.
#[test]
fn pressure_accelerates_the_water() {
    for water in [SHALLOW, Water::default()] {
        let field = field(water);
        for point in points() {
            let at = field.linear_kinematics(point, TIME);
            let slope = gradient(point, STEP, |p| field.linear_kinematics(p, TIME).dynamic_pressure_pa);
            let (after, before) = (TIME + STEP, TIME - STEP);
            for (i, slope) in slope.into_iter().enumerate() {
                assert!((at.acceleration_m_s2[i] + slope / water.density_kg_m3).abs() < DIFFERENCES);
                let velocity = |time| field.linear_kinematics(point, time).velocity_m_s[i];
                let rate = (velocity(after) - velocity(before)) / (2.0 * STEP);
                assert!((at.acceleration_m_s2[i] - rate).abs() < 1e-6); // 1.5^3 h^2 / 6 of 10 m/s
            }
        }
    }
}

/// The linear conditions at z = 0, d elevation / dt = w and p = rho g elevation, and at the bottom, w = 0.
#[test]
fn the_surface_moves_with_the_water_and_the_bottom_holds_it() {
    let field = field(SHALLOW);
    for point in points() {
        let [x, y, _] = point.0;
        let surface = field.linear_kinematics(Vector3::new(x, y, 0.0), TIME);
        let elevation = |time| field.elevation_m([x, y], time);
        let rate = (elevation(TIME + STEP) - elevation(TIME - STEP)) / (2.0 * STEP);
        assert!((surface.velocity_m_s[2] - rate).abs() < 1e-6);
        assert!((surface.dynamic_pressure_pa / (1000.0 * 9.81) - elevation(TIME)).abs() < 1e-12);
        assert_eq!(surface.elevation_m, elevation(TIME));
        assert_eq!(field.linear_kinematics(Vector3::new(x, y, -25.0), TIME).velocity_m_s[2], 0.0);
    }
}

/// cosh k(z + h) / cosh kh differs from e^kz by less than 2 e^-2kh e^-kz.
#[test]
fn deep_water_is_the_limit_of_finite_depth() {
    let deep = Water { depth_m: None, ..SHALLOW };
    let finite = Water { depth_m: Some(2000.0), ..SHALLOW };
    let waves = waves(&deep);
    let (deep, finite) = (WaveField::new(&waves, deep, 0.0), WaveField::new(&waves, finite, 0.0));
    for point in points() {
        let (a, b) = (deep.linear_kinematics(point, TIME), finite.linear_kinematics(point, TIME));
        assert!((a.dynamic_pressure_pa - b.dynamic_pressure_pa).abs() < 1e-8);
        assert!((a.velocity_m_s - b.velocity_m_s).norm() < 1e-12);
        assert!((a.acceleration_m_s2 - b.acceleration_m_s2).norm() < 1e-12);
    }
}

/// A wave of 1 rad/s over 25 m by hand: k = 0.10365 1/m from w^2 = g k tanh kh.
#[test]
fn a_regular_wave_has_the_closed_form() {
    let wave = WaveComponent::regular(2.0, TAU, 0.0, 0.0, &SHALLOW).unwrap();
    let field = WaveField::new(&[wave], SHALLOW, 0.0);
    let (k, z) = (wave.wave_number_per_m, -5.0);
    let crest = field.linear_kinematics(Vector3::new(0.0, 0.0, z), 0.0);
    assert!((crest.elevation_m - 1.0).abs() < 1e-15);
    let horizontal = (k * (z + 25.0)).cosh() / (k * 25.0).sinh();
    assert!((crest.velocity_m_s - Vector3::new(horizontal, 0.0, 0.0)).norm() < 1e-14);
    // A quarter of a period later the surface falls through zero where the crest was.
    let falling = field.linear_kinematics(Vector3::new(0.0, 0.0, z), TAU / 4.0);
    let vertical = (k * (z + 25.0)).sinh() / (k * 25.0).sinh();
    assert!((falling.velocity_m_s - Vector3::new(0.0, 0.0, -vertical)).norm() < 1e-14);
    // The crest goes to +x at w / k.
    assert!((field.elevation_m([1.0 / k, 0.0], 1.0) - 1.0).abs() < 1e-15);
}

/// Wheeler (1970): the field at the surface is the linear one of still water, and the total pressure there is
/// atmospheric. The bottom does not move.
#[test]
fn the_pressure_at_the_moving_surface_is_zero() {
    for water in [SHALLOW, Water::default()] {
        let field = field(water).with_stretching(Stretching::Wheeler);
        for point in points() {
            let [x, y, _] = point.0;
            let elevation = field.elevation_m([x, y], TIME);
            let just_below = Vector3::new(x, y, elevation - 1e-9);
            assert!(field.pressure_pa(just_below, TIME).abs() < 1e-4); // rho g 1e-9
            assert_eq!(field.pressure_pa(Vector3::new(x, y, elevation + 0.1), TIME), 0.0);
            let whole = field.kinematics(point, TIME);
            assert_eq!(whole.elevation_m, elevation);
            assert_eq!(whole.dynamic_pressure_pa, field.dynamic_pressure_pa(point, elevation, TIME));
            let stretched = field.kinematics(Vector3::new(x, y, elevation), TIME);
            let linear = field.linear_kinematics(Vector3::new(x, y, 0.0), TIME);
            assert!((stretched.velocity_m_s - linear.velocity_m_s).norm() < 1e-12);
        }
    }
    let bottom = field(SHALLOW).with_stretching(Stretching::Wheeler).kinematics(Vector3::new(3.0, 4.0, -25.0), TIME);
    assert!(bottom.velocity_m_s[2].abs() < 1e-12);
}

/// Velocity along x and z over a (g k / w), and pressure over rho g a, of a wave with the cosine and sine of its phase, at
/// the height z below the elevation: the methods written out from DNV-RP-C205, sec. 3.3.3, for cosh and sinh.
fn stretched([cos, sin]: [f64; 2], amplitude: f64, k: f64, z: f64, water: &Water, method: Stretching) -> [f64; 3] {
    let level = |z: f64| match water.depth_m {
        Some(h) => (k * (z + h)).cosh() / (k * h).cosh(),
        None => (k * z).exp(),
    };
    let upward = |z: f64| match water.depth_m {
        Some(h) => (k * (z + h)).sinh() / (k * h).cosh(),
        None => (k * z).exp(),
    };
    let elevation = amplitude * cos;
    let [c, d] = match method {
        Stretching::Wheeler => {
            let z = (z - elevation) / water.depth_m.map_or(1.0, |h| 1.0 + elevation / h);
            [level(z), upward(z)]
        }
        _ if z <= 0.0 => [level(z), upward(z)],
        Stretching::None => return [0.0, 0.0, z / amplitude],
        Stretching::Vertical => [level(0.0), upward(0.0)],
        Stretching::Extrapolated => [level(0.0) + k * z * upward(0.0), upward(0.0) + k * z * level(0.0)],
    };
    [c * cos, d * sin, c * cos]
}

#[test]
fn each_stretching_has_its_closed_form_from_bottom_to_crest() {
    let methods = [Stretching::None, Stretching::Vertical, Stretching::Wheeler, Stretching::Extrapolated];
    for water in [SHALLOW, Water::default()] {
        let wave = WaveComponent::regular(4.0, TAU, 0.0, 0.0, &water).unwrap();
        let (a, k, omega) = (wave.amplitude_m, wave.wave_number_per_m, wave.angular_frequency_rad_s);
        let (speed, weight) = (a * water.gravity_m_s2 * k / omega, water.density_kg_m3 * water.gravity_m_s2);
        for (method, time) in methods.into_iter().flat_map(|method| [0.0, 0.9, TAU / 2.0, 4.0].map(|t| (method, t))) {
            let field = WaveField::new(&[wave], water, 0.0).with_stretching(method);
            let (mut points, mut body) = (WavesAtPoints::new(&field), WavesAtBody::new(&field));
            points.set_time(&field, time);
            let phase = [time.cos(), -time.sin()];
            for z in [-25.0, -12.0, -3.0, -0.5, 0.0, 0.4, 1.2, 2.0] {
                if z > a * phase[0] {
                    continue;
                }
                let point = Vector3::new(0.0, 0.0, z);
                let [along, up, pressure] = stretched(phase, a, k, z, &water, method);
                let [x_rate, z_rate, _] = stretched([phase[1], -phase[0]], a, k, z, &water, Stretching::Vertical);
                let found = field.kinematics(point, time);
                let velocity = Vector3::new(along * speed, 0.0, up * speed);
                // Rounding of a phase of a few turns, and of exponents: 1e-13 of each value.
                assert!((found.velocity_m_s - velocity).norm() < 1e-13 * speed, "{method:?} {z} {time}");
                assert!((found.dynamic_pressure_pa - pressure * weight * a).abs() < 1e-13 * weight * a);
                // Below the still water level every method but Wheeler's leaves accelerations alone.
                if z <= 0.0 && method != Stretching::Wheeler {
                    let rate = Vector3::new(x_rate, 0.0, z_rate) * (speed * omega);
                    assert!((found.acceleration_m_s2 - rate).norm() < 1e-13 * speed * omega, "{method:?} {z} {time}");
                }
                let [elevation, at_point] = points.at(&field, point);
                assert!((elevation - found.elevation_m).abs() < 1e-13 * a);
                assert!((at_point - found.dynamic_pressure_pa).abs() < 1e-13 * weight * a, "{method:?} {z} {time}");
                let surface = body.surface(&field, [0.0, 0.0], time);
                let [velocity, acceleration] = body.motion(&field, surface.elevation, z);
                assert!((velocity - found.velocity_m_s).norm() < 1e-13 * speed, "{method:?} {z} {time}");
                assert!((acceleration - found.acceleration_m_s2).norm() < 1e-13 * speed * omega);
            }
        }
    }
}

/// Waves of a metre over kilometres, and points far above and below: no exponential overflows.
#[test]
fn short_waves_over_deep_water_stay_finite() {
    for depth_m in [Some(0.5), Some(1e4), None] {
        let water = Water { depth_m, ..SHALLOW };
        let waves: Vec<WaveComponent> =
            [0.01, 1.0, 30.0].map(|w| WaveComponent::in_water(&water, 0.2, w, 0.3, 0.0)).to_vec();
        let field = WaveField::new(&waves, water, 0.0);
        for z in [-1e6, -1e4, -1.0, 0.0, 0.3, 1e4] {
            let point = Vector3::new(10.0, -20.0, z);
            for at in [field.kinematics(point, 1e4), field.linear_kinematics(point, 1e4)] {
                let numbers = [at.velocity_m_s.norm(), at.acceleration_m_s2.norm(), at.dynamic_pressure_pa];
                assert!(numbers.iter().all(|number| number.is_finite()), "{at:?}");
                assert!(at.acceleration_m_s2.norm() < 3.0 * 0.2 * 900.0);
            }
            assert!(field.pressure_pa(point, 1e4).is_finite());
        }
    }
}

/// The stated polynomial has value, slope and curvature 0, 0, 0 at its begin and 1, 0, 0 at its end;
/// 0.5 in the middle.
#[test]
fn waves_grow_smoothly_from_rest() {
    let field = WaveField::new(&waves(&SHALLOW), SHALLOW, 60.0);
    assert_eq!([-1.0, 0.0, 30.0, 60.0, 1e3].map(|t| field.ramp(t)), [0.0, 0.0, 0.5, 1.0, 1.0]);
    for (time, value) in [(0.0, 0.0), (60.0, 1.0)] {
        // From s^3 (10 - ...): 10 (1/600)^3 at 0.1 s from either end.
        assert!((field.ramp(time + 0.1) - value).abs() < 5e-8);
        assert!((field.ramp(time - 0.1) - value).abs() < 5e-8);
    }
    let whole = WaveField::new(&waves(&SHALLOW), SHALLOW, 0.0);
    assert!((field.elevation_m([3.0, 4.0], 30.0) - 0.5 * whole.elevation_m([3.0, 4.0], 30.0)).abs() < 1e-15);
    assert_eq!(field.elevation_m([3.0, 4.0], 90.0), whole.elevation_m([3.0, 4.0], 90.0));
    assert_eq!(WaveField::<f64>::calm(SHALLOW).elevation_m([0.0; 2], 5.0), 0.0);
}

/// elevation = Re of the sum of a e^(i q), and a quarter of a period later, Im of each.
#[test]
fn the_phasors_sum_to_the_elevation() {
    let field = WaveField::new(&waves(&SHALLOW), SHALLOW, 60.0);
    let (mut real, mut imaginary) = (vec![0.0; field.len()], vec![0.0; field.len()]);
    field.phasors([7.0, -3.0], 45.0, &mut real, &mut imaginary);
    assert!((real.iter().sum::<f64>() - field.elevation_m([7.0, -3.0], 45.0)).abs() < 1e-12);
    for (i, wave) in field.components().enumerate() {
        let one = WaveField::new(&[*wave], SHALLOW, 0.0);
        let later = one.elevation_m([7.0, -3.0], 45.0 + TAU / 4.0 / wave.angular_frequency_rad_s);
        assert!((imaginary[i] - field.ramp(45.0) * later).abs() < 1e-12);
    }
}

/// Dual numbers: the derivative along x is the slope of the surface; lanes: the bits of plain numbers.
#[test]
fn the_field_supports_derivatives_and_lanes() {
    let (plain, point) = (field(SHALLOW), Vector3::new(3.0, -8.0, -2.0));
    let over = |waves: &[WaveComponent]| waves.iter().map(|wave| wave.constant()).collect::<Vec<_>>();
    let dual: WaveField<Dual<1>> = WaveField::new(&over(&waves(&SHALLOW)), SHALLOW, 0.0);
    let moved = Vector3::new(Dual::variable(3.0, 0), Dual::constant(-8.0), Dual::constant(-2.0));
    let exact = dual.kinematics(moved, TIME).dynamic_pressure_pa.derivative[0];
    let slope = gradient(point, STEP, |p| plain.kinematics(p, TIME).dynamic_pressure_pa)[0];
    assert!((exact - slope).abs() < 1000.0 * DIFFERENCES * 10.0, "{exact} {slope}");

    let waves = waves(&SHALLOW);
    let lanes: Vec<WaveComponent<Lanes>> = waves.iter().map(|wave| wave.constant()).collect();
    let lanes = WaveField::new(&lanes, SHALLOW, 0.0);
    let together = lanes.pressure_pa(Vector3(point.0.map(Lanes::constant)), TIME).to_array();
    assert_eq!(together, [plain.pressure_pa(point, TIME); 4]);
}

/// Comparison with the plain sums of sines and exponentials, point by point. Phases are up to 40 turns, so
/// their error is 1e-14 of a turn or 7e-14 rad in each, for 8 m of waves.
#[test]
fn the_waves_at_many_points_are_those_of_the_plain_sum_at_each() {
    for water in [SHALLOW, Water { depth_m: None, ..SHALLOW }] {
        let field = WaveField::new(&waves(&water), water, 60.0);
        let mut at_points = WavesAtPoints::new(&field);
        for time in [0.0, 20.0, TIME, 90.0] {
            at_points.set_time(&field, time);
            for point in points() {
                for z in [point[2], 0.3 * (point[2] + 12.5), 9.0, -40.0] {
                    let point = Vector3::new(point[0], point[1], z);
                    let expected = field.kinematics(point, time);
                    let [elevation, pressure] = at_points.at(&field, point);
                    assert!((elevation - expected.elevation_m).abs() < 1e-12);
                    assert!((pressure - expected.dynamic_pressure_pa).abs() < 1e-12 * 1000.0 * 9.81);
                    assert!(elevation <= at_points.highest_m());
                }
            }
        }
    }
}

/// One regular wave: the surface never exceeds its amplitude, and its crest reaches it, except for the 1e-9
/// allowed for rounding.
#[test]
fn the_upper_bound_of_the_surface_is_the_sum_of_all_amplitudes() {
    let wave = WaveComponent::regular(3.0, TAU, 0.0, 0.0, &SHALLOW).unwrap();
    let field = WaveField::new(&[wave, wave], SHALLOW, 0.0);
    let mut at_points = WavesAtPoints::new(&field);
    at_points.set_time(&field, 0.0);
    let [crest, _] = at_points.at(&field, Vector3::zero());
    assert!(crest <= at_points.highest_m() && at_points.highest_m() < crest * (1.0 + 2e-9));
}

/// On and above the surface the dynamic pressure is rho g times the elevation, in lanes as alone.
#[test]
fn points_in_lanes_are_bitwise_identical_to_single_points() {
    for water in [SHALLOW, Water { depth_m: None, ..SHALLOW }] {
        let waves = waves(&water);
        let in_lanes: Vec<WaveComponent<Lanes>> = waves.iter().map(|wave| wave.constant()).collect();
        let (side_by_side, field) = (WaveField::new(&in_lanes, water, 0.0), WaveField::new(&waves, water, 0.0));
        let mut in_lanes = WavesAtPoints::new(&side_by_side);
        let mut alone = WavesAtPoints::new(&field);
        in_lanes.set_time(&side_by_side, TIME);
        alone.set_time(&field, TIME);
        for four in points().chunks_exact(4) {
            // One above the waves, one about their surface, two below it.
            let point = |k: usize| Vector3::new(four[k][0], four[k][1], [9.0, 0.1, -1.0, -20.0][k]);
            let lanes = |axis: usize| Lanes::new(std::array::from_fn(|k| point(k)[axis]));
            let at = Vector3::new(lanes(0), lanes(1), lanes(2));
            let [elevations, pressures] = in_lanes.at(&side_by_side, at).map(Lanes::to_array);
            for (k, together) in elevations.into_iter().zip(pressures).enumerate() {
                assert_eq!([together.0, together.1], alone.at(&field, point(k)));
            }
            let [elevation, pressure] = alone.at(&field, point(0));
            assert_eq!(pressure, elevation * (1000.0 * 9.81));
        }
    }
}

/// Agrees with central differences along all three axes, like the plain sum.
#[test]
fn the_waves_at_points_support_derivatives() {
    let over: Vec<WaveComponent<Dual<3>>> = waves(&SHALLOW).iter().map(|wave| wave.constant()).collect();
    let dual = WaveField::new(&over, SHALLOW, 0.0);
    let mut exact = WavesAtPoints::new(&dual);
    exact.set_time(&dual, TIME);
    let field = field(SHALLOW);
    for point in points().into_iter().filter(|point| point[2] < -8.0) {
        let moved = Vector3([0, 1, 2].map(|axis| Dual::variable(point[axis], axis)));
        let [_, pressure] = exact.at(&dual, moved);
        let slope = gradient(point, STEP, |p| field.kinematics(p, TIME).dynamic_pressure_pa);
        for (exact, slope) in pressure.derivative.into_iter().zip(slope) {
            assert!((exact - slope).abs() < 1000.0 * DIFFERENCES * 10.0);
        }
    }
}

/// On a grid the sines are products of one along x and one along y: the angles' sum, to rounding.
#[test]
fn the_surface_on_a_grid_agrees_with_each_grid_point() {
    let field = WaveField::new(&waves(&SHALLOW), SHALLOW, 60.0);
    let (x, y) = ([-120.0, -3.0, 0.5, 88.0], [0.0, 41.0, -250.0]);
    let grid = field.elevations_m(&x, &y, TIME);
    assert_eq!(grid.len(), 12);
    for (i, elevation) in grid.iter().enumerate() {
        let alone = field.elevation_m([x[i / 3], y[i % 3]], TIME);
        assert!((elevation - alone).abs() < 1e-11, "{elevation} {alone}");
    }
    assert!(field.elevations_m(&[], &y, TIME).is_empty() && field.elevations_m(&x, &[], TIME).is_empty());
    assert!(WaveField::calm(SHALLOW).elevations_m(&x, &y, TIME).iter().all(|elevation| *elevation == 0.0));
}
