//! Runs with the same structure in the lanes of one simulation.

use crate::scalar::Lanes;
use crate::simulation::{Recording, Run, RunError, Setup, Simulation};

/// Runs the lanes of a setup together; `alone` contains the separate simulation of each run. `None` if
/// `go_on` returned false.
///
/// The lanes step together; each run's own simulation writes its rows from its lane's state. If one run
/// diverges, each run continues alone from its last row; a run ends before a row that is not finite.
pub(super) fn run(setup: Setup<Lanes>, mut alone: Vec<Simulation>, go_on: &dyn Fn() -> bool) -> Option<Vec<Run>> {
    let mut recording = Recording::new(*alone[0].settings(), alone[0].time_s());
    let mut rows = vec![RunRows { written: Vec::new(), status: Ok(()) }; alone.len()];
    write_rows(&mut alone, &mut rows);
    let mut together = Simulation::recursive(setup);
    while !recording.is_over(together.state().steps) {
        let due = recording.due(together.state().steps);
        if together.step((due - together.state().steps) as usize).is_err() {
            return one_by_one(alone, rows, &recording, go_on);
        }
        for (k, simulation) in alone.iter_mut().enumerate() {
            simulation.take_lane(&together, k);
        }
        write_rows(&mut alone, &mut rows);
        recording.written(together.time_s());
        if !go_on() {
            return None;
        }
    }
    let run = |(rows, simulation): (RunRows, &Simulation)| simulation.ended(rows.written, rows.status);
    Some(rows.into_iter().zip(&alone).map(run).collect())
}

/// Continues each run alone, from its last row to the end.
fn one_by_one(
    alone: Vec<Simulation>,
    rows: Vec<RunRows>,
    recording: &Recording,
    go_on: &dyn Fn() -> bool,
) -> Option<Vec<Run>> {
    let finish = |(mut simulation, rows): (Simulation, RunRows)| {
        if rows.status.is_err() {
            return Some(simulation.ended(rows.written, rows.status));
        }
        let mut stopped = false;
        let run = simulation.finish(rows.written, recording.clone(), |_| {
            stopped = !go_on();
            !stopped
        });
        (!stopped).then_some(run)
    };
    alone.into_iter().zip(rows).map(finish).collect()
}

/// Rows of a run, and the reason for its end.
#[derive(Clone)]
struct RunRows {
    written: Vec<f64>,
    status: Result<(), RunError>,
}

fn write_rows(simulations: &mut [Simulation], rows: &mut [RunRows]) {
    for (simulation, rows) in simulations.iter_mut().zip(rows).filter(|(_, rows)| rows.status.is_ok()) {
        let there = rows.written.len();
        simulation.write_row(&mut rows.written);
        rows.status = simulation.check_row(&rows.written[there..]);
        // The first row is always kept, so that a run has at least one row.
        if rows.status.is_err() && there > 0 {
            rows.written.truncate(there);
        }
    }
}
