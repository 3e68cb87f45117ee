//! A kind of element that is defined only in this file has all functions of the engine's elements.

use kingpost::analysis::Linearizer;
use kingpost::batch::{Batch, Built, run_built};
use kingpost::dynamics::Loads;
use kingpost::elements::{
    AnyElement, AnyWatcher, Components, Context, Crossing, Declaration, Element, ElementState, Event, Exceeded,
    Extreme, Input, Output, StateDeclaration, VectorFrame, Warning, Watcher,
};
use kingpost::integrate::Tolerances;
use kingpost::plant::{Number, Plant};
use kingpost::scalar::{LANES, Lanes, Scalar};
use kingpost::scenario::{Scenario, read};
use kingpost::simulation::{Run, SchemeName, Setup, Simulation};
use serde_json::json;
use std::path::Path;
use std::{env, fs};

const TEXT: &str = include_str!("../../../../scenarios/paper.yaml");

/// A governor of the slew. Its state is the rate after a first-order lag; each sample stores the largest
/// lagged rate so far; if the lagged rate exceeds a limit, the governor latches, and brakes from then on. An
/// input applies a torque.
#[derive(Clone, Debug)]
struct Governor<S> {
    coordinate: usize,
    time_constant_s: f64,
    limit: S,
}

impl<S: Scalar> Element<S> for Governor<S> {
    fn name(&self) -> &str {
        "governor"
    }

    fn declare(&self) -> Declaration {
        let output = |variable, description, unit| Output::number(variable, description, "governor", "governor", unit);
        let wrench = Output {
            components: Components::Axis,
            frame: VectorFrame::Body,
            ..output("governor_moment", "moment of a governor", &["N m"])
        };
        Declaration {
            states: vec![StateDeclaration::new("lagged_rate", "rad/s")],
            numbers: vec!["largest".to_owned()],
            modes: vec!["latched".to_owned()],
            inputs: vec![Input {
                name: "governor.push".to_owned(),
                unit: "N m",
                lower: -1e6,
                upper: 1e6,
                value: 0.0,
                signal: None,
            }],
            outputs: vec![output("governor_rate", "rate behind the lag of a governor", &["rad/s"]), wrench],
            events: vec![Event { code: "latched", what: "latched", crossing: Crossing::Rising }],
            period_s: Some(0.01),
            ..Declaration::default()
        }
    }

    fn watchers(&self) -> Vec<AnyWatcher> {
        vec![Box::new(Haste { limit: self.limit.value(), largest: Extreme::default() })]
    }

    fn begin(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        own.states[0] = at.v[self.coordinate];
    }

    fn loads(&mut self, at: &Context<'_, S>, loads: &mut Loads<S>) {
        let rate = at.v[self.coordinate];
        let brake = S::constant(2e3 * at.modes[0] as f64) * rate;
        loads.force[self.coordinate] += at.inputs[0] - brake;
        loads.power.drives += at.inputs[0] * rate;
        loads.power.dissipated += brake * rate;
    }

    fn rates(&mut self, at: &Context<'_, S>, rates: &mut [S]) {
        rates[0] = (at.v[self.coordinate] - at.states[0]) / S::constant(self.time_constant_s);
    }

    fn sample(&mut self, at: &Context<'_, S>, own: &mut ElementState<'_, S>) {
        let now = at.states[0];
        own.numbers[0] = now.select_less(own.numbers[0], || own.numbers[0], || now);
    }

    fn event_indicators(&mut self, at: &Context<'_, S>, values: &mut [S]) {
        values[0] = at.states[0] - self.limit;
    }

    fn handle_event(&mut self, _: usize, _: &Context<'_, S>, own: &mut ElementState<'_, S>, _: &mut [S]) {
        own.modes[0] = 1;
    }

    fn outputs(&mut self, at: &Context<'_, S>, out: &mut Vec<S>) {
        let brake = S::constant(-2e3 * at.modes[0] as f64) * at.v[self.coordinate];
        out.extend([at.states[0], S::ZERO, S::ZERO, brake]);
    }
}

/// Warns of the largest lagged rate beyond the limit, by the governor's own column.
#[derive(Clone, Debug)]
struct Haste {
    limit: f64,
    largest: Extreme,
}

impl Watcher for Haste {
    fn columns(&self) -> Vec<String> {
        vec!["governor.governor_rate".to_owned()]
    }

    fn see(&mut self, time_s: f64, values: &[f64]) {
        self.largest.see(time_s, values[0]);
    }

    fn warnings(&self) -> Vec<Warning> {
        let Extreme { value, time_s } = self.largest;
        let warning = haste(time_s, value, self.limit);
        (value.abs() > self.limit).then_some(warning).into_iter().collect()
    }
}

fn haste(time_s: f64, value: f64, bound: f64) -> Warning {
    Warning::exceeded("haste", time_s, "governor", Exceeded { value, bound, unit: "rad/s" }, format!("{value}"))
}

fn scenario() -> Scenario {
    let overrides = [("simulation.duration_s".to_owned(), json!(0.5)), ("simulation.step_s".to_owned(), json!(0.002))];
    read(TEXT, "paper.yaml", &overrides).unwrap()
}

/// The paper's crane with the governor, over any scalar.
fn with_governor<S: Scalar>(mut setup: Setup<S>, limit: S) -> Setup<S> {
    let coordinate = setup.model.coordinate("slew").unwrap();
    let governor: AnyElement<S> = Box::new(Governor { coordinate, time_constant_s: 0.05, limit });
    setup.elements.push(governor);
    setup
}

fn governed(limit: f64, scheme: SchemeName) -> Setup {
    let mut setup = with_governor(scenario().setup().unwrap(), limit);
    setup.settings.scheme = scheme;
    setup
}

/// The lagged slew rate exceeds 3 rad/s within half a second.
const LIMIT: f64 = 3.0;

const SCHEMES: [SchemeName; 8] = [
    SchemeName::ForwardEuler,
    SchemeName::MidpointEuler,
    SchemeName::SemiImplicitEuler,
    SchemeName::RungeKutta4,
    SchemeName::DormandPrince(Tolerances { absolute: 1e-9, relative: 1e-9, largest_step_s: 0.1 }),
    SchemeName::Newmark { beta: 0.25, gamma: 0.5 },
    SchemeName::GeneralizedAlpha { rho_infinity: 0.8 },
    SchemeName::ImplicitMidpoint,
];

/// The time of the event under every scheme is that of a fine run, to a share that the coarsest scheme allows: of order 1
/// in steps of 2 ms, errors of some 2 % of half a second.
#[test]
fn a_new_element_runs_under_every_scheme_and_its_event_is_in_the_table() {
    let event = |scheme, step_s: f64| {
        let mut setup = governed(LIMIT, scheme);
        setup.settings.step_s = step_s;
        let run = Simulation::new(setup).run(|_| true);
        run.status.unwrap();
        let [event] = run.events.as_slice() else { panic!("{scheme:?}: {:?}", run.events) };
        assert_eq!((event.element.as_str(), event.what.as_ref()), ("governor", "latched"));
        event.time_s
    };
    let truth = event(SchemeName::RungeKutta4, 0.000_1);
    assert!(truth > 0.1 && truth < 0.49, "{truth}");
    for scheme in SCHEMES {
        let found = event(scheme, 0.002);
        assert!((found - truth).abs() < 0.01, "{scheme:?}: {found} {truth}");
    }
}

#[test]
fn its_columns_are_published_with_their_units() {
    let simulation = Simulation::new(governed(LIMIT, SchemeName::RungeKutta4));
    let of = |variable: &str| simulation.channels().iter().find(|channel| channel.variable == variable).unwrap();
    let rate = of("governor_rate");
    assert_eq!(
        (rate.columns.as_slice(), rate.units.as_slice()),
        (["governor.governor_rate".to_owned()].as_slice(), ["rad/s"].as_slice())
    );
    let moment = of("governor_moment");
    assert_eq!(moment.columns, ["x", "y", "z"].map(|axis| format!("governor.governor_moment.{axis}")));
    assert_eq!(
        (moment.dims.as_slice(), moment.units.as_slice()),
        (["governor", "axis"].map(str::to_owned).as_slice(), ["N m"; 3].as_slice())
    );
    let channels: usize = simulation.channels().iter().map(|channel| channel.len).sum();
    assert_eq!(channels, simulation.columns());
}

const CHANNELS: &str = "tests/golden/new_element.channels.json";

/// The tests of the Python package and of the app read the same file: the declarations of an element reach
/// their tables, plots and files without code for this element. With `KINGPOST_WRITE_GOLDEN` set, this test
/// writes the file.
#[test]
fn its_table_of_channels_is_the_one_that_the_views_are_tested_with() {
    let simulation = Simulation::new(governed(LIMIT, SchemeName::RungeKutta4));
    let channels: Vec<String> =
        simulation.channels().iter().map(|channel| serde_json::to_string(channel).unwrap()).collect();
    let text = format!("[\n{}\n]\n", channels.join(",\n"));
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(CHANNELS);
    if env::var_os("KINGPOST_WRITE_GOLDEN").is_some() {
        fs::write(&file, &text).unwrap();
    }
    let written = fs::read_to_string(&file).unwrap_or_default();
    let command = "KINGPOST_WRITE_GOLDEN=1 cargo test -p kingpost --test new_element";
    assert!(text == written, "{CHANNELS} has drifted; run: {command}");
}

/// Checks that the warning is for the rows that are written: the largest value of the column, and the time of
/// that row.
#[test]
fn the_warnings_of_a_new_element_belong_to_the_run_and_restart_with_it() {
    let mut simulation = Simulation::new(governed(LIMIT, SchemeName::RungeKutta4));
    assert!(simulation.warnings().is_empty());
    let run = simulation.run(|_| true);
    let channel = simulation.channels().iter().find(|channel| channel.variable == "governor_rate").unwrap();
    let times_and_rates = run.rows.chunks(run.columns).map(|row| (row[0], row[channel.offset]));
    let (time_s, largest) = times_and_rates
        .fold((0.0, 0.0), |most: (f64, f64), next| if next.1.abs() > most.1.abs() { next } else { most });
    let expected = haste(time_s, largest, LIMIT);
    assert_eq!(run.warnings, [expected]);
    assert_eq!(simulation.warnings(), run.warnings);
    simulation.reset();
    assert!(simulation.warnings().is_empty());
    assert!(Simulation::new(governed(90.0, SchemeName::RungeKutta4)).run(|_| true).warnings.is_empty());
}

#[test]
fn its_state_numbers_and_modes_are_in_snapshots() {
    let mut simulation = Simulation::new(governed(LIMIT, SchemeName::RungeKutta4));
    simulation.set_input("governor.push", 1e4).unwrap();
    simulation.step(240).unwrap();
    let snapshot = simulation.snapshot();
    let (state, row) = (simulation.state().clone(), row(&mut simulation));
    assert_eq!(state.m, [1]);
    // The input, the number, and the input at the end of the step.
    assert_eq!(state.d.len(), 3);
    assert!(state.d[0] == 1e4 && state.d[1] > LIMIT - 0.5 && state.d[2] == 1e4, "{:?}", state.d);
    simulation.reset();
    assert!(simulation.state().m == [0] && simulation.events().is_empty());
    simulation.restore(&snapshot).unwrap();
    assert_eq!(simulation.state(), &state);
    assert_eq!(self::row(&mut simulation), row);
}

fn row(simulation: &mut Simulation) -> Vec<u64> {
    let mut row = Vec::new();
    simulation.write_row(&mut row);
    row.into_iter().map(f64::to_bits).collect()
}

/// A and B contain `x' = (v - x) / T` and `M a = u` under the element's names.
#[test]
fn its_state_and_input_are_in_a_and_b() {
    let simulation = Simulation::new(governed(LIMIT, SchemeName::RungeKutta4));
    let setup = with_governor(scenario().setup_over::<Number>().unwrap(), Number::constant(LIMIT));
    let linear = Linearizer::of_plant(Plant::new(setup.model, setup.world, setup.elements)).at(&simulation);
    let state = |name: &str| linear.states.iter().position(|state| state == name).unwrap();
    let (lagged, rate) = (state("governor.lagged_rate"), state("slew.rate"));
    assert!((linear.a[(lagged, lagged)] + 20.0).abs() < 1e-12 && (linear.a[(lagged, rate)] - 20.0).abs() < 1e-12);
    let input = linear.inputs.iter().position(|input| input == "governor.push").unwrap();
    // The moment accelerates the slew by the inverse of its mass matrix.
    let mut alone = simulation.clone();
    let free = alone.coordinates();
    let tau: Vec<f64> = free.iter().map(|name| f64::from(u8::from(name == "slew"))).collect();
    let (pushed, still) = (alone.acceleration(Some(&tau)).unwrap(), alone.acceleration(None).unwrap());
    let slew = free.iter().position(|name| name == "slew").unwrap();
    let expected = pushed[slew] - still[slew];
    assert!((linear.b[(rate, input)] / expected - 1.0).abs() < 1e-9, "{} {expected}", linear.b[(rate, input)]);
}

/// Runs that differ in the governor's limit.
struct Limits {
    scenario: Scenario,
    setups: Vec<Setup>,
    limits: Vec<f64>,
}

impl Built for Limits {
    fn count(&self) -> usize {
        self.setups.len()
    }

    fn setup(&self, run: usize) -> &Setup {
        &self.setups[run]
    }

    fn structure(&self, _: usize) -> &str {
        ""
    }

    fn side_by_side(&self, group: &[usize]) -> Option<Setup<Lanes>> {
        let lane = |k: usize| self.limits[group[k.min(group.len() - 1)]];
        let limit = Lanes::new(core::array::from_fn::<_, LANES, _>(lane));
        Some(with_governor(self.scenario.setup_over::<Lanes>().ok()?, limit))
    }
}

fn bits(run: &Run) -> Vec<u64> {
    run.rows.iter().map(|x| x.to_bits()).collect()
}

/// The runs are in lanes until an event occurs, and alone from the step of the event on: some never latch.
#[test]
fn a_new_element_in_lanes_and_in_a_batch_is_bitwise_identical_to_a_single_run() {
    for limits in [vec![2.0, 2.5, 3.0, 90.0, 91.0, 92.0, 93.0], vec![80.0, 90.0, 91.0, 92.0]] {
        let setups = limits.iter().map(|limit| governed(*limit, SchemeName::RungeKutta4)).collect();
        let built = Limits { scenario: scenario(), setups, limits };
        let batch: Batch = run_built(&built, 2, |_| true).unwrap();
        for (run, setup) in batch.runs.iter().zip(&built.setups) {
            let alone = Simulation::new(setup.clone()).run(|_| true);
            assert!(run.status.is_ok() && bits(run) == bits(&alone));
            assert_eq!(run.events, alone.events);
            assert_eq!(run.warnings, alone.warnings);
        }
        let latched: Vec<bool> = batch.runs.iter().map(|run| !run.events.is_empty()).collect();
        let expected: Vec<bool> = built.limits.iter().map(|limit| *limit < 10.0).collect();
        assert_eq!(latched, expected);
    }
}
