//! Lines with mass: closed forms of their waves and modes, and conservation of energy.

use kingpost::analysis::{Linearization, Linearizer};
use kingpost::elements::{AnyElement, DynamicLine, LineGround, LinePart, LineSection};
use kingpost::model::Attachment;
use kingpost::plant::{Number, Plant};
use kingpost::scalar::Scalar;
use kingpost::scenario::read;
use kingpost::simulation::{SchemeName, Setup, Simulation};
use kingpost::spatial::{Frame, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// A load that slides along z, or floats, at a point of the world.
fn setup<S: Scalar>(build: impl Fn(&str) -> Setup<S>, joint: &str, mass_kg: f64, more: &str) -> Setup<S> {
    build(&format!(
        "version: 1
title: A load on a line
simulation: {{step_s: 0.001, duration_s: 1, record_every_s: 0.1}}
bodies:
  load:
    mass_kg: {mass_kg}
    shape: {{point: {{}}}}
    joint: {joint}
{more}"
    ))
}

fn plain(text: &str) -> Setup {
    read(text, "line.yaml", &[]).expect("it reads").setup().expect("it builds")
}

fn dual(text: &str) -> Setup<Number> {
    read(text, "line.yaml", &[]).expect("it reads").setup_over::<Number>().expect("it builds")
}

/// A line from a point of the world to the load, or to another point of the world; straight, with equal strain.
#[derive(Clone, Copy)]
struct Straight {
    from: [f64; 3],
    to: [f64; 3],
    on_load: bool,
    length: f64,
    elements: usize,
    section: LineSection,
}

/// Steel wire: 30 kg/m, EA = 800 MN, thin enough to have no water around it.
pub const WIRE: LineSection = LineSection {
    mass_per_length: 30.0,
    diameter: 1e-9,
    axial_stiffness: 8e8,
    damping_time: 0.0,
    bending_stiffness: 0.0,
    added_mass: [1.0, 0.0],
    drag: [1.2, 0.0],
};

fn over<S: Scalar>(section: LineSection) -> LineSection<S> {
    let LineSection { mass_per_length, diameter, axial_stiffness, damping_time, bending_stiffness, added_mass, drag } =
        section;
    LineSection {
        mass_per_length: S::constant(mass_per_length),
        diameter: S::constant(diameter),
        axial_stiffness: S::constant(axial_stiffness),
        damping_time: S::constant(damping_time),
        bending_stiffness: S::constant(bending_stiffness),
        added_mass: added_mass.map(S::constant),
        drag: drag.map(S::constant),
    }
}

impl Straight {
    fn line<S: Scalar>(&self, setup: &Setup<S>) -> DynamicLine<S> {
        let [from, to] = [self.from, self.to].map(|point| Vector3(point.map(S::constant)));
        let end = |body, at| setup.model.attachment(body, Frame::translation(at));
        let last: Attachment<S> = if self.on_load { end(Some(0), Vector3::zero()) } else { end(None, to) };
        let parts = 2 * self.elements;
        let at = |k: usize| from + (to - from) * S::constant(k as f64 / parts as f64);
        let start = (1..parts).map(at).collect();
        let ends = [end(None, from), last];
        let part = LinePart {
            unstretched_length: S::constant(self.length),
            section: over(self.section),
            elements: self.elements,
        };
        DynamicLine::new("wire", ends, &[part]).beginning_at(start)
    }

    /// Adds the line to a setup.
    fn on<S: Scalar>(&self, mut setup: Setup<S>) -> Setup<S> {
        let line: AnyElement<S> = Box::new(self.line(&setup));
        setup.elements.push(line);
        setup
    }

    fn linearised(&self, joint: &str, mass_kg: f64, more: &str) -> Linearization {
        let simulation = Simulation::new(self.on(setup(plain, joint, mass_kg, more)));
        let Setup { model, world, elements, .. } = self.on(setup(dual, joint, mass_kg, more));
        Linearizer::of_plant(Plant::new(model, world, elements)).at(&simulation)
    }
}

/// Returns the frequencies of a scenario at its start, rad/s, the lowest first.
pub fn frequencies_of(text: &str) -> Vec<f64> {
    let Setup { model, world, elements, .. } = dual(text);
    frequencies(&Linearizer::of_plant(Plant::new(model, world, elements)).at(&Simulation::new(plain(text))))
}

/// Returns the frequencies of the oscillations, rad/s, the lowest first.
fn frequencies(found: &Linearization) -> Vec<f64> {
    let mut found: Vec<f64> =
        found.a.complex_eigenvalues().iter().map(|value| value.im).filter(|frequency| *frequency > 1e-3).collect();
    found.sort_by(f64::total_cmp);
    found
}

/// Returns the relative distance from an expected frequency to the nearest one.
pub fn error(found: &[f64], expected: f64) -> f64 {
    found.iter().map(|frequency| (frequency / expected - 1.0).abs()).fold(f64::INFINITY, f64::min)
}

const STRAIN: f64 = 1e-3;

/// An anchor of 280 t on 3000 m of wire, which is stretched by a thousandth.
fn hanging(elements: usize) -> Straight {
    let bottom = -3000.0 * (1.0 + STRAIN);
    Straight { from: [0.0; 3], to: [0.0, 0.0, bottom], on_load: true, length: 3000.0, elements, section: WIRE }
}

#[test]
fn axial_frequencies_of_a_bar_with_a_mass_converge_with_fourth_order() {
    // beta tan beta = m L / M (Rao, Vibration of Continuous Systems, 2007, sec. 9.3). The strain energy is quadratic in
    // the stretch, so the tension does not matter.
    let (ratio, celerity) = (30.0 * 3000.0 / 280e3, (8e8_f64 / 30.0).sqrt());
    let root = |k: usize| {
        let (mut low, mut high) = (PI * k as f64, PI * k as f64 + FRAC_PI_2 - 1e-12);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            *(if middle * middle.tan() < ratio { &mut low } else { &mut high }) = middle;
        }
        low * celerity / 3000.0
    };
    let joint =
        format!("{{prismatic: {{name: lift, axis: [0, 0, 1], position_m: [0, 0, {}]}}}}", -3000.0 * (1.0 + STRAIN));
    let errors = |elements| {
        let found = frequencies(&hanging(elements).linearised(&joint, 280e3, ""));
        (0..5).map(|k| error(&found, root(k))).collect::<Vec<_>>()
    };
    let (coarse, fine) = (errors(8), errors(16));
    for (k, (coarse, fine)) in coarse.iter().zip(&fine).enumerate() {
        // (kappa h)^4 / 2880 for a quadratic element: 2e-3 for the fifth with 8 elements.
        assert!(*coarse < 3e-3, "mode {}: {coarse}", k + 1);
        assert!(*fine < 1e-9 || coarse / fine > 12.0, "mode {}: {coarse} {fine}", k + 1);
    }
    assert!(fine[0] < 1e-7, "{}", fine[0]);
}

#[test]
fn transverse_frequencies_of_a_taut_string_converge_with_fourth_order() {
    // omega_n = n pi / L sqrt(T / (m lambda)), with L and m of the unstretched line.
    let (strain, length) = (0.01, 100.0);
    let string = |elements| Straight {
        from: [0.0; 3],
        to: [length * (1.0 + strain), 0.0, 0.0],
        on_load: false,
        length,
        elements,
        section: LineSection { axial_stiffness: 1e8, ..WIRE },
    };
    let first = PI / length * (1e8 * strain / (30.0 * (1.0 + strain))).sqrt();
    let joint = "{fixed: {}}";
    let errors = |elements| {
        let found = frequencies(&string(elements).linearised(joint, 1.0, ""));
        (1..=5).map(|n| error(&found, first * f64::from(n))).collect::<Vec<_>>()
    };
    let (coarse, fine) = (errors(8), errors(16));
    for (n, (coarse, fine)) in coarse.iter().zip(&fine).enumerate() {
        assert!(*coarse < 1e-2, "mode {}: {coarse}", n + 1);
        assert!(*fine < 1e-9 || coarse / fine > 11.0, "mode {}: {coarse} {fine}", n + 1);
    }
}

#[test]
fn energy_is_conserved_while_a_load_swings_on_a_chain() {
    // A chain of 20 m with a load of 100 kg, released at 45 degrees; the error is that of Kutta's scheme.
    let gravity = "forces: {gravity: {gravity: {}}}\n";
    let down = 20.0 / 2.0_f64.sqrt();
    let chain = Straight {
        from: [0.0; 3],
        to: [down, 0.0, -down],
        on_load: true,
        length: 20.0,
        elements: 6,
        section: LineSection { mass_per_length: 10.0, axial_stiffness: 1e6, ..WIRE },
    };
    let joint = format!("{{floating: {{hold_rotation: true, initial: {{position_m: [{down}, 0, {}]}}}}}}", -down);
    let error = |step_s: f64| {
        let mut setup = chain.on(setup(plain, &joint, 100.0, gravity));
        setup.settings.step_s = step_s;
        setup.settings.scheme = SchemeName::RungeKutta4;
        let mut run = Simulation::new(setup);
        run.step((1.0 / step_s) as usize).expect("it does not diverge");
        let value = |run: &mut Simulation, name: &str| crate::common::values(run, name)[0];
        value(&mut run, "energy_error").abs() / value(&mut run, "energy_scale")
    };
    let errors = [0.002, 0.001].map(error);
    assert!(errors[1] < 1e-6, "{errors:?}");
}

#[test]
fn heat_of_damping_water_and_ground_is_booked() {
    // A slack chain falls through the water onto the ground, where it slides.
    let more = "sea: {depth_m: 12, current_m_s: [0.4, 0.2]}\nforces: {gravity: {gravity: {}}}\n";
    let chain = Straight {
        from: [-8.0, 0.0, -6.0],
        to: [8.0, 0.0, -6.0],
        on_load: false,
        length: 24.0,
        elements: 6,
        section: LineSection {
            mass_per_length: 40.0,
            diameter: 0.1,
            axial_stiffness: 1e6,
            damping_time: 0.01,
            bending_stiffness: 0.0,
            added_mass: [1.0, 0.5],
            drag: [2.4, 0.3],
        },
    };
    let level = LineGround { damping_time: 0.05, friction: 0.7, ..LineGround::level(12.0, 2e4) };
    for normal in [[0.0, 0.0, 1.0], [0.36, 0.48, 0.8]].map(Vector3) {
        let mut setup = setup(plain, "{fixed: {}}", 1.0, more);
        let line: AnyElement = Box::new(chain.line(&setup).on(LineGround { normal, ..level }));
        setup.elements.push(line);
        setup.settings.scheme = SchemeName::RungeKutta4;
        let mut run = Simulation::new(setup);
        run.step(10_000).expect("it does not diverge");
        let mut value = |name: &str| crate::common::values(&mut run, name)[0];
        assert!(value("line_grounded_length") > 2.0, "{}", value("line_grounded_length"));
        // A node that touches changes its force within a step.
        let [error, scale] = ["energy_error", "energy_scale"].map(&mut value);
        assert!(error.abs() < 1e-4 * scale, "{normal:?} {error} {scale}");
    }
}

#[test]
fn current_accelerates_a_line_by_morison() {
    // 1/2 rho d C_D U^2 / (m + rho pi/4 d^2 C_A) across a straight line.
    let (d, u) = (0.2, 1.5);
    let section = LineSection {
        mass_per_length: 60.0,
        diameter: d,
        axial_stiffness: 1e8,
        damping_time: 0.0,
        bending_stiffness: 0.0,
        added_mass: [1.0, 0.0],
        drag: [1.2, 0.0],
    };
    let wire = Straight {
        from: [0.0, 0.0, -20.0],
        to: [50.0, 0.0, -20.0],
        on_load: false,
        length: 50.0,
        elements: 4,
        section,
    };
    let found = wire.linearised("{fixed: {}}", 1.0, "sea: {current_m_s: [0, 1.5]}\n");
    let displaced = 1025.0 * PI / 4.0 * d * d;
    let expected = 0.5 * 1025.0 * d * 1.2 * u * u / (60.0 + displaced);
    let row = found.states.iter().position(|name| name == "wire.node_4.velocity.y").expect("a state");
    assert!((found.rates[row] / expected - 1.0).abs() < 1e-12, "{} {expected}", found.rates[row]);
}
