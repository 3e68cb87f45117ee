//! Rows of results about rest: their values, and their derivatives with respect to the states, the wave forces and the water at
//! nodes.

use super::excitation::WaveLoads;
use super::not_linear::NotLinear;
use super::random_drags::{set_water, vary_water};
use super::wave_forces::FORCES;
use super::{AtRest, setup_of};
use crate::elements::AnyElement;
use crate::integrate::Stage;
use crate::ledger;
use crate::plant::{Along, DIRECTIONS, Number, Plant, Tangent};
use crate::results::{Channels, Sample};
use crate::scenario::{BuiltScenario, ScenarioError};
use crate::world::World;
use nalgebra::DMatrix;

/// All columns of a row at rest, with their derivatives.
pub(super) struct Rows {
    tangent: Tangent,
    channels: Channels,
    /// Variable of each state, then of each force.
    along: Vec<Along>,
    /// Number of components of the water's motion at nodes.
    water: usize,
    /// Time and interval at rest; d contains the inputs, followed by the forces.
    time: (f64, crate::integrate::Interval),
    q: Vec<f64>,
    v: Vec<f64>,
    s: Vec<f64>,
    d: Vec<f64>,
    m: Vec<i64>,
    /// Values of the columns at rest.
    pub(super) mean: Vec<f64>,
    /// Derivatives of each column with respect to each state, then to each force, then to each component of the water's
    /// motion; not finite if they do not exist.
    pub(super) derivatives: DMatrix<f64>,
    /// Reason for each column that is not proportional to small waves.
    pub(super) not_linear: Vec<Option<NotLinear>>,
}

impl Rows {
    /// Computes the rows of a scenario at rest.
    pub(super) fn new(scenario: &BuiltScenario, at: &AtRest, loads: &WaveLoads<'_>) -> Result<Self, ScenarioError> {
        let setup = setup_of(scenario, at.drags.as_ref())?;
        let mut elements = setup.elements;
        let forces = loads.as_inputs(&at.rest);
        let count = FORCES * forces.len();
        elements.extend(forces.into_iter().map(|forces| Box::new(forces) as AnyElement<Number>));
        // Elements that use the waves are evaluated in still water.
        let world = World { waves: None, ..setup.world };
        let mut tangent = Tangent::new(Plant::new(setup.model, world, elements));
        tangent.set_evaluation_mode(crate::elements::EvaluationMode::AtRest);
        let layout = tangent.plant().layout();
        let channels = Channels::new(&tangent.plant().model, layout);
        let inputs = layout.inputs.len() - count;
        let Stage { time_s, interval, q, v, s, d, m } = at.rest.stage();
        let (before, numbers) = d.split_at(inputs);
        let mut rows = Self {
            along: at.along.iter().copied().chain((inputs..inputs + count).map(Along::Input)).collect(),
            water: at.water_components(),
            time: (time_s, interval),
            q: q.to_vec(),
            v: v.to_vec(),
            s: s.to_vec(),
            d: [before, &vec![0.0; count], numbers].concat(),
            m: m.to_vec(),
            mean: Vec::new(),
            derivatives: DMatrix::zeros(0, 0),
            not_linear: vec![None; channels.columns()],
            channels,
            tangent,
        };
        rows.differentiate();
        rows.mark_what_no_state_moves();
        Ok(rows)
    }

    /// Returns the channels.
    pub(super) fn channels(&self) -> &Channels {
        &self.channels
    }

    /// Returns the indices of everything that the elements declare; the wave forces are the last elements.
    pub(super) fn layout(&self) -> &crate::elements::Layout {
        self.tangent.plant().layout()
    }

    /// Returns a row with these changes of states, forces and water, in the order of the derivatives.
    pub(super) fn changed_by(&mut self, changes: &[f64]) -> Vec<f64> {
        let (mut xi, mut v, mut s, mut d) = (vec![0.0; self.v.len()], self.v.clone(), self.s.clone(), self.d.clone());
        for (along, change) in self.along.iter().zip(changes) {
            let entry = match *along {
                Along::Position(i) => &mut xi[i],
                Along::Velocity(i) => &mut v[i],
                Along::Extra(i) => &mut s[i],
                Along::Input(i) => &mut d[i],
            };
            *entry += change;
        }
        let (time_s, interval) = self.time;
        let at = Stage { time_s, interval, q: &self.q, v: &v, s: &s, d: &d, m: &self.m };
        if self.water > 0 {
            let of_water = &changes[self.along.len()..];
            set_water(self.tangent.plant_mut().elements_mut(), |component| Number::still(of_water[component]));
        }
        row(&mut self.tangent, &self.channels, at, &xi, &[]).iter().map(|number| number.value).collect()
    }

    fn differentiate(&mut self) {
        let of_ledger = (0..ledger::COUNT).map(Along::Extra);
        let all: Vec<Along> = self.along.iter().copied().chain(of_ledger).collect();
        let mut derivatives = DMatrix::zeros(self.channels.columns(), all.len());
        let (time_s, interval) = self.time;
        let still = vec![0.0; self.v.len()];
        self.tangent.watch_loops(&self.q);
        for (chunk, directions) in all.chunks(DIRECTIONS).enumerate() {
            let at = Stage { time_s, interval, q: &self.q, v: &self.v, s: &self.s, d: &self.d, m: &self.m };
            let row = row(&mut self.tangent, &self.channels, at, &still, directions);
            for (column, number) in row.iter().enumerate() {
                for k in 0..directions.len() {
                    derivatives[(column, chunk * DIRECTIONS + k)] = number.derivative[k];
                }
            }
            self.mean = row.iter().map(|number| number.value).collect();
        }
        let by_ledger = derivatives.columns(self.along.len(), ledger::COUNT);
        for (column, not_linear) in self.not_linear.iter_mut().enumerate() {
            let over_time = by_ledger.row(column).iter().any(|entry| *entry != 0.0);
            *not_linear = over_time.then_some(NotLinear::OverTime);
        }
        let mut whole = derivatives
            .columns(0, self.along.len())
            .into_owned()
            .resize_horizontally(self.along.len() + self.water, 0.0);
        self.differentiate_by_water(&mut whole);
        self.derivatives = whole;
    }

    /// Writes the derivatives with respect to the water's motion at nodes, behind the others.
    fn differentiate_by_water(&mut self, derivatives: &mut DMatrix<f64>) {
        let (time_s, interval) = self.time;
        let still = vec![0.0; self.v.len()];
        for first in (0..self.water).step_by(DIRECTIONS) {
            vary_water(self.tangent.plant_mut().elements_mut(), first);
            let at = Stage { time_s, interval, q: &self.q, v: &self.v, s: &self.s, d: &self.d, m: &self.m };
            let row = row(&mut self.tangent, &self.channels, at, &still, &[]);
            for (column, number) in row.iter().enumerate() {
                for k in 0..DIRECTIONS.min(self.water - first) {
                    derivatives[(column, self.along.len() + first + k)] = number.derivative[k];
                }
            }
        }
    }

    /// Marks the time, and the columns that are constant between two samples.
    fn mark_what_no_state_moves(&mut self) {
        self.not_linear[0] = Some(NotLinear::OverTime);
        for signal in self.tangent.plant().layout().signals() {
            if let Some(place) = self.channels.place(&signal.name) {
                self.not_linear[place] = Some(NotLinear::Sampled);
            }
        }
    }
}

/// Returns a row at a stage whose q is moved by `xi`, with derivatives along at most [`DIRECTIONS`]
/// directions.
fn row(tangent: &mut Tangent, channels: &Channels, at: Stage<'_>, xi: &[f64], along: &[Along]) -> Vec<Number> {
    tangent.observe(at.q, xi, at, along, |at, observed| {
        let mut row = Vec::with_capacity(channels.columns());
        channels.write_row(&Sample { time_s: at.time_s, q: at.q, v: at.v, s: at.s, observed }, &mut row);
        row
    })
}
