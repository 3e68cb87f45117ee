//! Kingpost's forward dynamics and RK4 step, in the manner of the peers' programs:
//! `kingpost-bench MODEL OPERATION MODE NUMBERS`, where `MODEL.json` is the resolved scenario and
//! `MODEL.txt` the state.
//!
//! ```text
//! time BATCHES REPETITIONS   one line per batch: nanoseconds per repetition
//! count REPETITIONS          one batch without a clock, for an instruction counter
//! check REPETITIONS          the result after that many repetitions, one number per line
//! ```

mod operations;

use operations::{Forward, Operation, Shipped, Step, Task};
use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [path, operation, mode, numbers @ ..] = arguments.as_slice() else {
        return Err("usage: MODEL OPERATION MODE NUMBERS".into());
    };
    let numbers = numbers.iter().map(|text| text.parse()).collect::<Result<Vec<usize>, _>>()?;
    let task = Task::read(path)?;
    match operation.as_str() {
        "forward" => run(Forward::new(task), mode, &numbers),
        "rk4_step" => run(Step::new(task), mode, &numbers),
        "rk4_step_ledger" => run(Shipped::new(task)?, mode, &numbers),
        other => Err(format!("unknown operation {other}").into()),
    }
}

fn run<O: Operation>(mut operation: O, mode: &str, numbers: &[usize]) -> Outcome<()> {
    match (mode, numbers) {
        ("time", &[batches, repetitions]) => {
            batch(&mut operation, repetitions)?; // warm-up
            for _ in 0..batches {
                operation.reset()?;
                let start = Instant::now();
                repeat(&mut operation, repetitions)?;
                println!("{:.3}", start.elapsed().as_nanos() as f64 / repetitions as f64);
            }
        }
        ("count", &[repetitions]) => batch(&mut operation, repetitions)?,
        ("check", &[repetitions]) => {
            batch(&mut operation, repetitions)?;
            operation.result().iter().for_each(|value| println!("{value:?}"));
        }
        _ => return Err("the mode is time BATCHES REPETITIONS, count N or check N".into()),
    }
    Ok(())
}

fn batch<O: Operation>(operation: &mut O, repetitions: usize) -> Outcome<()> {
    operation.reset()?;
    repeat(operation, repetitions)
}

#[inline]
fn repeat<O: Operation>(operation: &mut O, repetitions: usize) -> Outcome<()> {
    for _ in 0..repetitions {
        black_box(&mut *operation).once()?;
    }
    Ok(())
}
