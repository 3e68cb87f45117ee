//! Many runs by the batch of the released engine, over lanes and threads.

use crate::Outcome;
use crate::operations::Operation;
use kingpost::batch::{self, Variant};
use kingpost::scenario::Files;
use std::time::Instant;

const RUNS: usize = 128;
const STEP_S: f64 = 1e-3;

/// Variants of one scenario from its start, each with a load heavier by 1 kg than the previous one.
pub struct Batch {
    scenario: String,
    integrator: &'static str,
    threads: usize,
}

impl Batch {
    /// `euler_2` is forward Euler on two threads.
    pub fn new(scenario: &str, kind: &str) -> Outcome<Self> {
        let (scheme, threads) = kind.split_once('_').ok_or("an operation is batch_SCHEME_THREADS")?;
        let integrator = match scheme {
            "euler" => "forward_euler",
            "rk4" => "rk4",
            other => return Err(format!("unknown scheme {other}").into()),
        };
        Ok(Self { scenario: scenario.to_owned(), integrator, threads: threads.parse()? })
    }

    /// Returns the time of a number of steps of every run, s, with all preparation and completion.
    fn elapsed(&self, steps: usize) -> Outcome<f64> {
        let duration = steps as f64 * STEP_S;
        let variant = |k: usize| -> Variant {
            let set = |path: &str, value: f64| (path.to_owned(), value.into());
            vec![
                ("simulation.integrator".to_owned(), self.integrator.into()),
                set("simulation.duration_s", duration),
                set("simulation.record_every_s", duration),
                set("bodies.load.mass_kg", 1000.0 + k as f64),
            ]
        };
        let variants: Vec<Variant> = (0..RUNS).map(variant).collect();
        let start = Instant::now();
        let batch = batch::run(&self.scenario, "kingpost.json", &Files::default(), &variants, self.threads, |_| true)?;
        let elapsed = start.elapsed().as_secs_f64();
        batch.runs.into_iter().try_for_each(|run| run.status)?;
        Ok(elapsed)
    }
}

impl Operation for Batch {
    fn reset(&mut self) -> Outcome<()> {
        Ok(())
    }

    fn repeat(&mut self, times: usize) -> Outcome<()> {
        self.elapsed(times).map(|_| ())
    }

    fn result(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Subtracts the time of a batch of one step: reading, building, the rows at the start and the end.
    fn time(&mut self, times: usize) -> Outcome<f64> {
        let seconds = self.elapsed(times + 1)? - self.elapsed(1)?;
        Ok(seconds * 1e9 / (times * RUNS) as f64)
    }
}
