//! Kingpost's forward dynamics and steps, in the manner of the peers' programs:
//! `kingpost-bench MODEL OPERATION MODE NUMBERS`, where `MODEL.json` is the resolved scenario,
//! `MODEL.files.json` what it reads from other files, by name, and `MODEL.txt` the state.
//!
//! ```text
//! time BATCHES REPETITIONS   one line per batch: nanoseconds per repetition
//! count REPETITIONS          one batch without a clock, for an instruction counter
//! check REPETITIONS          the result after that many repetitions, one number per line
//! ```
//!
//! Compiled for WASM it has no command line: `exports` is called instead.

#[cfg(not(target_arch = "wasm32"))]
mod batch;
mod exports;
mod operations;

use operations::{Operation, Task};
use std::error::Error;

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [path, operation, mode, numbers @ ..] = arguments.as_slice() else {
        return Err("usage: MODEL OPERATION MODE NUMBERS".into());
    };
    let numbers = numbers.iter().map(|text| text.parse()).collect::<Result<Vec<usize>, _>>()?;
    let scenario = std::fs::read_to_string(format!("{path}.json"))?;
    let files = std::fs::read_to_string(format!("{path}.files.json"))?;
    let state = std::fs::read_to_string(format!("{path}.txt"))?;
    run(prepared(operation, &scenario, &files, &state)?.as_mut(), mode, &numbers)
}

/// Returns the operation of that name; whole batches need a host with threads.
fn prepared(name: &str, scenario: &str, files: &str, state: &str) -> Outcome<Box<dyn Operation>> {
    #[cfg(not(target_arch = "wasm32"))]
    if let Some(kind) = name.strip_prefix("batch_") {
        return Ok(Box::new(batch::Batch::new(scenario, kind)?));
    }
    Task::read(scenario, files, state)?.operation(name)
}

fn run(operation: &mut dyn Operation, mode: &str, numbers: &[usize]) -> Outcome<()> {
    operation.reset()?;
    match (mode, numbers) {
        ("time", &[batches, repetitions]) => {
            operation.repeat(repetitions)?; // warm-up
            for _ in 0..batches {
                println!("{:.3}", operation.time(repetitions)?);
            }
        }
        ("count", &[repetitions]) => operation.repeat(repetitions)?,
        ("check", &[repetitions]) => {
            operation.repeat(repetitions)?;
            operation.result().iter().for_each(|value| println!("{value:?}"));
        }
        _ => return Err("the mode is time BATCHES REPETITIONS, count N or check N".into()),
    }
    Ok(())
}
