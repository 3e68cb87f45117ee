//! Lines with mass at the step of a ship: closed forms of their forced motion, order of the coupled scheme, and energy.

use crate::line_dynamics::WIRE;
use kingpost::elements::{DynamicLine, LinePart, LineSection};
use kingpost::integrate::Tolerances;
use kingpost::model::Attachment;
use kingpost::scenario::read;
use kingpost::simulation::{SchemeName, Setup, Simulation};
use kingpost::spatial::{Frame, Vector3};
use nalgebra::{Complex, ComplexField};
use std::f64::consts::TAU;

const G: f64 = 9.80665;
const AMPLITUDE_M: f64 = 0.05;

/// A load on a wire from a point that moves up and down, after a smooth start of half the run.
#[derive(Clone, Copy)]
struct Forced {
    length: f64,
    mass_kg: f64,
    period_s: f64,
    damping_time: f64,
    elements: usize,
}

/// Number of periods of a run.
const PERIODS: f64 = 24.0;

impl Forced {
    /// Returns the height of the load at rest, m: it stretches the wire by (M + m L / 2) g L / EA.
    fn load_at_rest(&self) -> f64 {
        let carried = self.mass_kg + WIRE.mass_per_length * 0.5 * self.length;
        -self.length * (1.0 + carried * G / WIRE.axial_stiffness)
    }

    fn simulation(&self, step_s: f64, scheme: SchemeName) -> Simulation {
        let Self { length, mass_kg, period_s, damping_time, elements } = *self;
        let text = format!(
            "version: 1
title: A forced wire
simulation: {{step_s: {step_s}, duration_s: 1, record_every_s: {step_s}}}
forces: {{gravity: {{gravity: {{}}}}}}
bodies:
  load:
    mass_kg: {mass_kg}
    shape: {{point: {{}}}}
    joint: {{prismatic: {{name: lift, axis: [0, 0, 1], position_m: [0, 0, {}]}}}}
  top:
    mass_kg: 1
    shape: {{point: {{}}}}
    joint:
      prismatic:
        name: tip
        axis: [0, 0, 1]
        mode: {{oscillation: {{amplitude_m: {AMPLITUDE_M}, period_s: {period_s}, ramp_s: {}}}}}
",
            self.load_at_rest(),
            0.5 * PERIODS * period_s
        );
        let mut setup: Setup = read(&text, "wire.yaml", &[]).expect("it reads").setup().expect("it builds");
        let end = |body| -> Attachment { setup.model.attachment(Some(body), Frame::translation(Vector3::zero())) };
        let section = LineSection { damping_time, ..WIRE };
        let part = LinePart { unstretched_length: length, section, elements };
        let line = DynamicLine::new("wire", [end(1), end(0)], &[part]);
        setup.elements.push(Box::new(line));
        setup.settings.scheme = scheme;
        Simulation::new(setup)
    }

    /// Returns the harmonic of the tension at the top over the last period, N, relative to the motion of the top.
    fn computed(&self, step_s: f64) -> Complex<f64> {
        let mut run = self.simulation(step_s, SchemeName::RungeKutta4);
        let of_period = (self.period_s / step_s).round() as usize;
        run.step((PERIODS as usize - 1) * of_period).expect("it does not diverge");
        let mut sum = Complex::new(0.0, 0.0);
        for _ in 0..of_period {
            run.step(1).expect("it does not diverge");
            let angle = -TAU * run.time_s() / self.period_s;
            let tension = crate::common::values(&mut run, "line_tension")[0];
            sum += Complex::new(angle.cos(), angle.sin()) * tension;
        }
        // The top moves with the sine.
        sum * Complex::new(0.0, 2.0 / of_period as f64)
    }

    /// Returns the harmonic by the bar with a mass, with u upwards and the tension -EA u': u'' = -kappa^2 u, EA (1 + i omega tau) u'(L) = M omega^2 u(L).
    fn by_bar(&self) -> Complex<f64> {
        let omega = TAU / self.period_s;
        let stiffness = Complex::new(1.0, omega * self.damping_time) * WIRE.axial_stiffness;
        let kappa = (Complex::new(WIRE.mass_per_length, 0.0) / stiffness).sqrt() * omega;
        let (sine, cosine) = ((kappa * self.length).sin(), (kappa * self.length).cos());
        let inertia = Complex::new(self.mass_kg * omega * omega, 0.0);
        let b = (inertia * cosine + stiffness * kappa * sine) / (stiffness * kappa * cosine - inertia * sine);
        stiffness * kappa * b * -AMPLITUDE_M
    }
}

#[test]
fn tension_over_a_moving_top_is_that_of_a_bar_with_a_mass() {
    // 50 ms. The error of the step is (omega h)^2 / 12 of the inertia, 3e-4 at 5 s, and larger near resonance; what is left
    // of the start has decayed to some thousandths.
    for length in [200.0, 1000.0, 3000.0] {
        for period_s in [5.0, 8.0, 12.0, 16.0] {
            let forced = Forced { length, mass_kg: 280e3, period_s, damping_time: 0.05, elements: 6 };
            let (computed, expected) = (forced.computed(0.05), forced.by_bar());
            let ratio = computed / expected;
            assert!((ratio - 1.0).modulus() < 0.01, "{length} m, {period_s} s: {ratio}");
        }
    }
}

#[test]
fn the_coupled_scheme_has_second_order() {
    // Tension against a run with small steps that resolves the axial waves, where the motion is largest.
    let forced = Forced { length: 1000.0, mass_kg: 100e3, period_s: 4.0, damping_time: 0.05, elements: 3 };
    let at = |step_s: f64, scheme| {
        let mut run = forced.simulation(step_s, scheme);
        run.step((50.2 / step_s).round() as usize).expect("it does not diverge");
        crate::common::values(&mut run, "line_tension")[0]
    };
    let exact =
        at(0.001, SchemeName::DormandPrince(Tolerances { absolute: 1e-9, relative: 1e-9, largest_step_s: 0.01 }));
    let errors = [0.05, 0.025, 0.0125].map(|step_s| (at(step_s, SchemeName::RungeKutta4) - exact).abs());
    assert!(errors[0] / errors[1] > 3.0 && errors[1] / errors[2] > 3.4, "{errors:?}");
}

#[test]
fn energy_closes_with_third_order_in_the_step() {
    // Work of the top, energy of wire and load, heat of the wire, and what the scheme takes: an error of third order and more.
    let forced = Forced { length: 3000.0, mass_kg: 280e3, period_s: 8.0, damping_time: 0.01, elements: 10 };
    let error = |step_s: f64| {
        let mut run = forced.simulation(step_s, SchemeName::RungeKutta4);
        run.step((160.0 / step_s).round() as usize).expect("it does not diverge");
        let mut value = |name: &str| crate::common::values(&mut run, name)[0];
        let lost = value("line_energy_lost_to_scheme").abs() / value("energy_dissipated");
        (value("energy_error").abs() / value("energy_scale"), lost)
    };
    let [(coarse, lost), (fine, _)] = [0.025, 0.0125].map(error);
    assert!(fine < 1e-6 && coarse / fine > 8.0, "{coarse} {fine}");
    assert!(lost < 0.01, "{lost}");
}
