//! Thrust allocation and the response of a wave filter, against closed forms.

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use kingpost::elements::dynamic_positioning::{Allocation, Thruster, ThrusterKind, WaveFilter};
use kingpost::spatial::Vector3;
use nalgebra::{Complex, ComplexField, DMatrix, DVector};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};

fn fixed(x: f64, y: f64, angle: f64, [ahead, astern]: [f64; 2]) -> Thruster {
    let (sin, cos) = libm::sincos(angle);
    let kind = ThrusterKind::Fixed { direction: [cos, sin], ahead, astern };
    Thruster { name: String::new(), position: Vector3::new(x, y, -3.0), kind, time_constant: 3.0, weight: 1.0 }
}

fn azimuth(x: f64, y: f64, limit: f64) -> Thruster {
    Thruster { kind: ThrusterKind::Azimuth { limit }, ..fixed(x, y, 0.0, [limit; 2]) }
}

/// Returns B f.
fn given(allocation: &Allocation, demand: [f64; 3]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (i, thruster) in allocation.thrusters().iter().enumerate() {
        let [x, y] = thruster.force(allocation.thrust(i, demand));
        let moment = thruster.position[0] * y - thruster.position[1] * x;
        sum = [sum[0] + x, sum[1] + y, sum[2] + moment];
    }
    sum
}

fn utilisation(allocation: &Allocation, demand: [f64; 3]) -> Vec<f64> {
    let of = |(i, thruster): (usize, &Thruster)| thruster.utilisation(allocation.thrust(i, demand));
    allocation.thrusters().iter().enumerate().map(of).collect()
}

/// Two tunnels at x1 and x2 and two propellers at +-b astern: what can be shifted among them without changing the force is
/// (1, -1) of the propellers and -+2b / (x1 - x2) of the tunnels, and of that least sum of squared utilisations takes its
/// part.
#[test]
fn the_allocation_to_two_tunnels_and_two_propellers_is_that_of_a_hand_calculation() {
    let ([x1, x2, b], [t, p]) = ([30.0, -25.0, 4.0], [1.2e5, 4e5]);
    let thrusters = vec![
        fixed(x1, 0.0, FRAC_PI_2, [t, t]),
        fixed(x2, 0.0, FRAC_PI_2, [t, t]),
        fixed(-35.0, b, 0.0, [p, p]),
        fixed(-35.0, -b, 0.0, [p, p]),
    ];
    let allocation = Allocation::new(thrusters, true).unwrap();
    let [x, y, n] = [3e4, -2e4, 9e5];
    let bow = (n - x2 * y) / (x1 - x2);
    let one = [bow, y - bow, 0.5 * x, 0.5 * x];
    let s = 2.0 * b / (x1 - x2);
    let null = [s, -s, 1.0, -1.0];
    let w = [1.0 / (t * t), 1.0 / (t * t), 1.0 / (p * p), 1.0 / (p * p)];
    let dot = |a: [f64; 4], b: [f64; 4]| (0..4).map(|i| w[i] * a[i] * b[i]).sum::<f64>();
    let shift = dot(one, null) / dot(null, null);
    for i in 0..4 {
        let found = allocation.thrust(i, [x, y, n])[0];
        assert!((found - (one[i] - shift * null[i])).abs() < 1e-10 * bow, "{i} {found}");
    }
}

fn random_allocation(rng: &mut StdRng, heading_first: bool) -> Allocation {
    let mut thrusters = vec![azimuth(rng.random_range(-40.0..-20.0), rng.random_range(-8.0..8.0), 3e5)];
    for _ in 0..rng.random_range(2..5) {
        let limits = [rng.random_range(1e5..5e5), rng.random_range(1e5..5e5)];
        let (x, y) = (rng.random_range(-40.0..40.0), rng.random_range(-8.0..8.0));
        thrusters.push(fixed(x, y, rng.random_range(-PI..PI), limits));
    }
    thrusters.push(azimuth(rng.random_range(10.0..40.0), rng.random_range(-8.0..8.0), rng.random_range(1e5..4e5)));
    thrusters.iter_mut().for_each(|thruster| thruster.weight = rng.random_range(0.5..2.0));
    Allocation::new(thrusters, heading_first).unwrap()
}

/// B P tau = tau; no other thrusts that give tau have a smaller norm; a demand beyond the limits is met along
/// its direction by the largest share at which one thruster is at its limit, or its moment first and then its
/// force.
#[test]
fn random_thrusters_provide_the_demand_within_their_limits() {
    let mut rng = StdRng::seed_from_u64(5);
    for case in 0..200 {
        let heading_first = case % 2 == 0;
        let allocation = random_allocation(&mut rng, heading_first);
        let scale = 10_f64.powf(rng.random_range(4.0..6.5));
        let demand = [scale, scale, 20.0 * scale].map(|size| size * rng.random_range(-1.0..1.0));
        let size = |[x, y, n]: [f64; 3]| x.abs() + y.abs() + n.abs() / 20.0;
        let off = |a: [f64; 3], b: [f64; 3]| size(core::array::from_fn(|k| a[k] - b[k]));
        assert!(off(given(&allocation, demand), demand) < 1e-12 * size(demand));
        // W f is in the range of B^T: W f = B^T lambda by components, lambda = (B W^-1 B^T)^-1 tau.
        let rows: Vec<([f64; 3], f64)> = components(&allocation, demand);
        let b = DMatrix::from_fn(3, rows.len(), |i, j| rows[j].0[i] / if i == 2 { 20.0 } else { 1.0 });
        let wf = DVector::from_iterator(rows.len(), rows.iter().map(|row| row.1));
        let lambda = (&b * b.transpose()).try_inverse().unwrap() * &b * &wf;
        assert!((b.transpose() * lambda - &wf).norm() < 1e-9 * wf.norm());
        let limited = allocation.limited(demand);
        let most = utilisation(&allocation, limited).into_iter().fold(0.0, f64::max);
        assert!(most < 1.0 + 1e-12);
        let within = utilisation(&allocation, demand).into_iter().all(|share| share <= 1.0);
        let turning = [0.0, 0.0, demand[2]];
        let turns = utilisation(&allocation, turning).into_iter().all(|share| share <= 1.0);
        if within && (!heading_first || turns) {
            assert!(off(limited, demand) <= 1e-12 * size(demand));
        } else if heading_first {
            assert!((limited[0] * demand[1] - limited[1] * demand[0]).abs() < 1e-9 * scale * scale);
            assert!(!turns || limited[2] == demand[2]);
            assert!((most - 1.0).abs() < 1e-9);
        } else {
            let share = limited[0] / demand[0];
            assert!(off(limited, demand.map(|entry| entry * share)) < 1e-12 * size(demand));
            assert!(share > 0.0 && share < 1.0 && (most - 1.0).abs() < 1e-9, "{share} {most}");
        }
    }
}

/// Columns of B, and W f, by components.
fn components(allocation: &Allocation, demand: [f64; 3]) -> Vec<([f64; 3], f64)> {
    let mut rows = Vec::new();
    for (i, thruster) in allocation.thrusters().iter().enumerate() {
        let thrust = allocation.thrust(i, demand);
        for (k, thrust) in thrust.iter().enumerate().take(thruster.components()) {
            let [x, y] = thruster.force(core::array::from_fn(|j| if j == k { 1.0 } else { 0.0 }));
            let moment = thruster.position[0] * y - thruster.position[1] * x;
            rows.push(([x, y, moment], thrust * thruster.weight / (thruster.limit() * thruster.limit())));
        }
    }
    rows
}

/// Returns the response of the filter at a frequency, by its states' rates.
fn response(filter: &WaveFilter, omega: f64) -> Complex<f64> {
    let n = filter.state_count();
    let rates = |input: f64, states: &[f64]| {
        let mut rates = vec![0.0; n];
        filter.rates([0.0, input, 0.0], states, &mut rates);
        rates
    };
    let unit = |k: usize| (0..n).map(|i| if i == k { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
    let columns: Vec<Vec<f64>> = (0..n).map(|k| rates(0.0, &unit(k))).collect();
    let by_input = rates(1.0, &vec![0.0; n]);
    let system = DMatrix::from_fn(n, n, |i, j| Complex::new(-columns[j][i], if i == j { omega } else { 0.0 }));
    let states = system.lu().solve(&DVector::from_fn(n, |i, _| Complex::new(by_input[i], 0.0))).unwrap();
    let passed = |input: f64, part: &dyn Fn(Complex<f64>) -> f64| {
        let states: Vec<f64> = states.iter().map(|x| part(*x)).collect();
        filter.output([0.0, input, 0.0], &states)[1]
    };
    Complex::new(passed(1.0, &|x| x.re), passed(0.0, &|x| x.im))
}

/// h(s) of Fossen (2011), sec. 11.1.2, at any frequency; a constant passes fully, and the notch's wave by no
/// more than its damping ratio.
#[test]
fn the_wave_filter_has_its_transfer_function() {
    let (notch, zeta, cutoff, damping) = (TAU / 9.0, 0.1, TAU / 15.0, 0.6);
    let filter = WaveFilter::default().with_notch(notch, zeta).with_notch(0.5, 0.2).with_low_pass(cutoff, damping);
    let section = |s: Complex<f64>, omega: f64, zeta: f64| s * s + s * (2.0 * zeta * omega) + omega * omega;
    for omega in [1e-9, 0.05, 0.3, 0.5, notch, 2.0, 40.0] {
        let s = Complex::new(0.0, omega);
        let notches = section(s, notch, zeta) / section(s, notch, 1.0) * section(s, 0.5, 0.2) / section(s, 0.5, 1.0);
        let expected = notches * cutoff * cutoff / section(s, cutoff, damping);
        let found = response(&filter, omega);
        assert!((found - expected).modulus() < 1e-12, "{omega} {found} {expected}");
    }
    assert!((response(&filter, 1e-9).modulus() - 1.0).abs() < 1e-8);
    let one = WaveFilter::default().with_notch(notch, zeta);
    assert!((response(&one, notch).modulus() - zeta).abs() < 1e-14);
    let mut states = vec![0.0; filter.state_count()];
    filter.settled_states([3.0, -2.0, 5.0], &mut states);
    let mut rates = vec![1.0; states.len()];
    filter.rates([3.0, -2.0, 5.0], &states, &mut rates);
    assert!(rates.iter().all(|rate| *rate == 0.0));
    assert_eq!(filter.output([3.0, -2.0, 5.0], &states), [3.0, -2.0, 5.0]);
}
