//! Events are located within a step, and samples are taken at their times, under every scheme.

use crate::common;

use common::closed_forms::{GRAVITY, Pendulum};
use kingpost::dynamics::Loads;
use kingpost::elements::{
    AnyElement, Context, Crossing, Declaration, Delay, Element, ElementState, Event, Gravity, Input, Output,
};
use kingpost::integrate::Tolerances;
use kingpost::model::joint::{Prismatic, Revolute};
use kingpost::model::{BodyDefinition, Joint, JointKind, Model, MotionType};
use kingpost::plant::Form;
use kingpost::plant::Number;
use kingpost::scalar::Scalar;
use kingpost::simulation::{RunError, SchemeName, Settings, Setup, Simulation};
use kingpost::spatial::{Frame, SpatialInertia, Symmetric3, Vector3};
use kingpost::state::State;
use kingpost::world::World;

const DORMAND_PRINCE: SchemeName =
    SchemeName::DormandPrince(Tolerances { absolute: 1e-12, relative: 1e-12, largest_step_s: 0.1 });

fn setup<S: Scalar>(
    kind: JointKind<S>,
    elements: Vec<AnyElement<S>>,
    (q, v): (S, S),
    scheme: SchemeName,
    step_s: f64,
) -> Setup<S> {
    let mass = S::constant(2.0);
    let body = BodyDefinition {
        name: "body".to_owned(),
        parent: None,
        joint: Joint { name: "joint".to_owned(), kind, mode: MotionType::Free },
        mass,
        inertia: SpatialInertia::rigid(mass, Symmetric3::diagonal([S::ONE; 3])),
        points: Vec::new(),
    };
    let settings =
        Settings { scheme, step_s, duration_s: 10.0, record_every_s: step_s, rate_limit: 1e4, form: Form::Recursive };
    Setup {
        model: Model::new(vec![body]),
        world: World::calm().with_gravity(S::constant(GRAVITY)),
        elements,
        watchers: Vec::new(),
        limits: Vec::new(),
        settings,
        q: vec![q],
        v: vec![v],
        wires: Vec::new(),
        fingerprint: 0,
    }
}

fn upwards<S: Scalar>() -> JointKind<S> {
    let axis = Vector3::new(S::ZERO, S::ZERO, S::ONE);
    JointKind::Prismatic(Prismatic::new(Frame::identity(), axis, Vector3::zero()))
}

fn gravity<S: Scalar>() -> AnyElement<S> {
    Box::new(Gravity)
}

/// A stop at zero that returns a share of the speed (Newton's law of impact).
#[derive(Clone, Debug)]
struct Floor<S> {
    restitution: S,
}

impl<S: Scalar> Element<S> for Floor<S> {
    fn name(&self) -> &str {
        "floor"
    }

    fn declare(&self) -> Declaration {
        let events = vec![Event { code: "impact", what: "impact", crossing: Crossing::Falling }];
        Declaration { events, ..Declaration::default() }
    }

    fn event_indicators(&mut self, at: &Context<'_, S>, values: &mut [S]) {
        values[0] = at.q[0];
    }

    fn handle_event(&mut self, _: usize, at: &Context<'_, S>, _: &mut ElementState<'_, S>, v: &mut [S]) {
        v[0] = -(self.restitution * at.v[0]);
    }
}

/// Falls from `height`; impacts at `sqrt(2 h / g)` and then after flights of `2 e^k v / g`.
fn ball<S: Scalar>(height: S, restitution: S, scheme: SchemeName) -> Simulation<S> {
    let elements: Vec<AnyElement<S>> = vec![gravity(), Box::new(Floor { restitution })];
    Simulation::recursive(setup(upwards(), elements, (height, S::ZERO), scheme, 1e-3))
}

#[test]
fn a_ball_hits_a_stop_at_the_time_of_the_closed_form() {
    let (height, restitution): (f64, f64) = (1.3, 0.7);
    for scheme in [SchemeName::RungeKutta4, DORMAND_PRINCE] {
        let mut simulation = ball(height, restitution, scheme);
        simulation.step(2_500).unwrap();
        let first = (2.0 * height / GRAVITY).sqrt();
        let (mut expected, mut flight) = (vec![first], 2.0 * GRAVITY * first * restitution / GRAVITY);
        while expected[expected.len() - 1] + flight < 2.5 {
            expected.push(expected[expected.len() - 1] + flight);
            flight *= restitution;
        }
        let times: Vec<f64> = simulation.events().iter().map(|event| event.time_s).collect();
        assert_eq!(times.len(), expected.len(), "{scheme:?}: {times:?} {expected:?}");
        for (time, expected) in times.iter().zip(&expected) {
            assert!((time - expected).abs() < 1e-9, "{scheme:?}: {time} {expected}");
        }
        assert!(simulation.events().iter().all(|event| event.element == "floor" && event.what == "impact"));
    }
}

/// The energy lost in impacts is heat, and the momentum change comes from outside.
#[test]
fn the_ledger_closes_over_impacts() {
    let mut simulation = ball(1.3, 0.7, SchemeName::RungeKutta4);
    simulation.step(2_000).unwrap();
    assert_eq!(simulation.events().len(), 3);
    // Of 25 J and 7 kg m/s; RK4 is exact for a steady acceleration.
    for channel in ["energy_error", "momentum_error", "linear_momentum_error"] {
        let error = common::values(&mut simulation, channel)[0].abs();
        assert!(error < 1e-9, "{channel}: {error:e}");
    }
}

/// q(t) after an impact moves with the height by `e sqrt(2 g / h) (t - t1) - 2 e - ...`, from
/// q = e v1 (t - t1) - g (t - t1)^2 / 2 with t1 = sqrt(2 h / g) and v1 = g t1.
#[test]
fn derivatives_follow_through_an_event() {
    let (height, restitution, end) = (1.3, 0.7, 0.8);
    let dual = |value: f64, direction: usize| Number {
        value,
        derivative: core::array::from_fn(|k| f64::from(u8::from(k == direction))),
    };
    for scheme in [SchemeName::RungeKutta4, DORMAND_PRINCE] {
        let mut simulation = ball(dual(height, 0), dual(restitution, 1), scheme);
        simulation.step(800).unwrap();
        assert_eq!(simulation.events().len(), 1);
        let first = (2.0 * height / GRAVITY).sqrt();
        let (flown, by_height) = (end - first, 1.0 / (GRAVITY * first));
        let expected = [
            restitution * GRAVITY * by_height * flown - restitution * GRAVITY * first * by_height
                + GRAVITY * flown * by_height,
            GRAVITY * first * flown,
        ];
        let found = simulation.state().q[0].derivative;
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-8, "{scheme:?}: {found} {expected}");
        }
    }
}

/// A brake that is applied when an angle is passed, and is viscous from then on.
#[derive(Clone, Debug)]
struct Catch {
    angle: f64,
    damping: f64,
}

impl<S: Scalar> Element<S> for Catch {
    fn name(&self) -> &str {
        "brake"
    }

    fn declare(&self) -> Declaration {
        Declaration {
            modes: vec!["set".to_owned()],
            events: vec![Event { code: "caught", what: "caught", crossing: Crossing::Rising }],
            ..Declaration::default()
        }
    }

    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let moment = S::constant(self.damping * at.modes[0] as f64) * at.v[0];
        loads.force[0] -= moment;
        loads.power.dissipated += moment * at.v[0];
    }

    fn event_indicators(&mut self, at: &Context<'_, S>, values: &mut [S]) {
        values[0] = at.q[0] - S::constant(self.angle);
    }

    fn handle_event(&mut self, _: usize, _: &Context<'_, S>, own: &mut ElementState<'_, S>, _: &mut [S]) {
        own.modes[0] = 1;
    }
}

/// 2 kg, 1 kg m2 about its centre of mass, 1.5 m below the hinge, released 1.2 rad behind hanging.
fn pendulum(scheme: SchemeName, step_s: f64) -> Simulation {
    let down = Vector3::new(0.0, 0.0, -1.5);
    let hinge = Revolute::new(Frame::identity(), Vector3::new(0.0, 1.0, 0.0), down);
    let elements: Vec<AnyElement> = vec![gravity(), Box::new(Catch { angle: 0.4, damping: 30.0 })];
    Simulation::new(setup(JointKind::Revolute(hinge), elements, (-1.2, 0.0), scheme, step_s))
}

#[test]
fn a_brake_catches_a_pendulum_when_the_closed_form_passes_its_angle() {
    let closed = Pendulum::new(1.0 + 2.0 * 1.5 * 1.5, 2.0 * 1.5, 1.2);
    // From the release at +1.2 the angle falls; mirrored, -0.4 is passed: bisection of the closed form.
    let (mut low, mut high) = (0.0, 0.5 * closed.period_s());
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if closed.angle(middle) > -0.4 { low = middle } else { high = middle }
    }
    for scheme in [SchemeName::RungeKutta4, DORMAND_PRINCE] {
        let mut simulation = pendulum(scheme, 1e-3);
        simulation.step(1_500).unwrap();
        let [event] = simulation.events() else { panic!("{:?}", simulation.events()) };
        assert!((event.time_s - low).abs() < 1e-9, "{scheme:?}: {} {low}", event.time_s);
        assert_eq!(simulation.state().m, [1]);
    }
}

#[test]
fn a_scheme_keeps_its_order_over_an_event() {
    let schemes = [
        (SchemeName::RungeKutta4, 0.02, 4.0, 0.3),
        (SchemeName::ForwardEuler, 0.000_5, 1.0, 0.1),
        (SchemeName::SemiImplicitEuler, 0.000_5, 1.0, 0.1),
        (SchemeName::ImplicitMidpoint, 0.005, 2.0, 0.15),
        (SchemeName::GeneralizedAlpha { rho_infinity: 0.8 }, 0.005, 2.0, 0.15),
        (SchemeName::Newmark { beta: 0.25, gamma: 0.5 }, 0.005, 2.0, 0.15),
    ];
    let end = |scheme, step_s: f64| {
        let mut simulation = pendulum(scheme, step_s);
        simulation.step((1.0 / step_s).round() as usize).unwrap();
        assert_eq!(simulation.events().len(), 1);
        [simulation.state().q[0], simulation.state().v[0]]
    };
    let truth = end(SchemeName::RungeKutta4, 0.000_25);
    for (scheme, step_s, order, tolerance) in schemes {
        let [coarse, fine] = [step_s, step_s / 2.0].map(|step_s| {
            let found = end(scheme, step_s);
            (found[0] - truth[0]).hypot(found[1] - truth[1])
        });
        let found = (coarse / fine).log2();
        assert!((found - order).abs() < tolerance, "{scheme:?}: order {found}, {coarse:e} {fine:e}");
    }
}

/// `u_k = -K x_(k-2)` on `x' = u`, sampled every `period_s`.
#[derive(Clone, Debug)]
struct Controller {
    gain: f64,
    period_s: f64,
}

const DELAY: Delay = Delay { first_number: 1, mode: 0, ticks: 2 };

impl<S: Scalar> Element<S> for Controller {
    fn name(&self) -> &str {
        "controller"
    }

    fn declare(&self) -> Declaration {
        let numbers = ["command", "late.0", "late.1"].map(str::to_owned).to_vec();
        let command = Output::number("command", "commanded speed", "controller", "controller", &["m/s"]);
        Declaration {
            numbers,
            modes: vec!["head".to_owned()],
            outputs: vec![command],
            period_s: Some(self.period_s),
            ..Declaration::default()
        }
    }

    fn sample(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        let late = DELAY.pass(own, at.q[0]);
        own.numbers[0] = S::constant(-self.gain) * late;
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        out.push(at.numbers[0]);
    }
}

#[test]
fn a_sampled_controller_with_two_ticks_delay_is_its_recursion() {
    // The command is a force on 2 kg without friction: x'' = u / m is exact under RK4 between ticks.
    #[derive(Clone, Debug)]
    struct Push;
    impl<S: Scalar> Element<S> for Push {
        fn declare(&self) -> Declaration {
            let signal = Some("controller.command".to_owned());
            let input = Input { name: "push".to_owned(), unit: "N", lower: -9e9, upper: 9e9, value: 0.0, signal };
            Declaration { inputs: vec![input], ..Declaration::default() }
        }

        fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
            loads.force[0] += at.inputs[0];
            loads.power.drives += at.inputs[0] * at.v[0];
        }
    }
    // The tick is no multiple of the step: samples cut steps.
    let (period_s, gain, mass) = (0.025, 3.0, 2.0);
    for (scheme, step_s) in [(SchemeName::RungeKutta4, 0.01), (DORMAND_PRINCE, 0.04)] {
        let elements: Vec<AnyElement> = vec![Box::new(Controller { gain, period_s }), Box::new(Push)];
        let mut simulation = Simulation::new(setup(upwards(), elements, (1.0, 0.0), scheme, step_s));
        simulation.layout().check_signals().unwrap();
        simulation.step((2.0 / step_s).round() as usize).unwrap();
        let (mut x, mut v, mut past) = (1.0, 0.0, [0.0; 2]);
        for _ in 0..80 {
            let force = -gain * past[0];
            past = [past[1], x];
            (x, v) = (x + v * period_s + 0.5 * force / mass * period_s * period_s, v + force / mass * period_s);
        }
        let State { q, v: found, .. } = simulation.state();
        assert!((q[0] - x).abs() < 1e-11 && (found[0] - v).abs() < 1e-11, "{scheme:?}: {q:?} {x} {found:?} {v}");
    }
}

/// Between two restarts the scheme continues its inner steps, for any step of the display.
#[test]
fn dormand_prince_does_not_restart_at_every_step() {
    let evaluations = |step_s: f64| {
        let mut simulation = pendulum(DORMAND_PRINCE, step_s);
        simulation.step((1.0 / step_s).round() as usize).unwrap();
        simulation.evaluations()
    };
    let (coarse, fine) = (evaluations(0.1), evaluations(0.001));
    // The event is located by dense output; finer steps cost no evaluations but those of the first trial step.
    assert!(fine <= coarse + 100, "{coarse} {fine}");
}

#[test]
fn an_element_that_responds_to_itself_without_end_stops_the_run() {
    #[derive(Clone, Debug)]
    struct Chatter;
    impl<S: Scalar> Element<S> for Chatter {
        fn name(&self) -> &str {
            "chatter"
        }

        fn declare(&self) -> Declaration {
            let events = vec![Event { code: "turn", what: "turn", crossing: Crossing::Falling }];
            Declaration { modes: vec!["turns".to_owned()], events, ..Declaration::default() }
        }

        /// An element that falls through zero 1e-6 s after each response.
        fn event_indicators(&mut self, at: &Context<'_, S>, values: &mut [S]) {
            let next = 0.001 + 1e-6 * at.modes[0] as f64;
            values[0] = S::constant(next - at.clock.time_s);
        }

        fn handle_event(&mut self, _: usize, _: &Context<'_, S>, own: &mut ElementState<'_, S>, _: &mut [S]) {
            own.modes[0] += 1;
        }
    }
    let elements: Vec<AnyElement> = vec![Box::new(Chatter)];
    let mut simulation = Simulation::new(setup(upwards(), elements, (0.0, 0.0), SchemeName::RungeKutta4, 0.01));
    let stopped = simulation.step(2).unwrap_err();
    assert!(matches!(stopped, RunError::TooManyEvents { ref element, .. } if element == "chatter"), "{stopped}");
    assert_eq!(simulation.time_s(), 0.0);
    assert!(simulation.events().is_empty());
}

#[test]
fn a_snapshot_holds_modes_and_discrete_numbers_and_the_table_of_events_follows_it() {
    let mut simulation = pendulum(SchemeName::RungeKutta4, 1e-3);
    let start = simulation.snapshot();
    simulation.step(1_500).unwrap();
    let (state, events) = (simulation.state().clone(), simulation.events().to_vec());
    simulation.restore(&start).unwrap();
    assert!(simulation.events().is_empty() && simulation.state().m == [0]);
    simulation.step(1_500).unwrap();
    assert_eq!((simulation.state(), simulation.events()), (&state, events.as_slice()));
    simulation.reset();
    assert!(simulation.events().is_empty() && simulation.state().m == [0]);
}
