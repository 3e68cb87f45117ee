//! Exact derivatives of the right-hand side, by dual numbers.

use super::{Observation, ObservedPart, Plant};
use crate::elements::EvaluationMode;
use crate::integrate::{Interval, Jacobian, Sizes, Stage, System};
use crate::model::MotionType;
use crate::scalar::{Dual, Scalar};

/// Number of directions in one evaluation.
pub const DIRECTIONS: usize = 4;

/// Dual number of this module.
pub type Number = Dual<DIRECTIONS>;

/// A variable of the right-hand side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// Local coordinate of a coordinate of v.
    Position(usize),
    /// An entry of v.
    Velocity(usize),
    /// An entry of s.
    Extra(usize),
    /// An input: an entry of d.
    Input(usize),
}

/// A plant over dual numbers, with the working memory for differentiation.
#[derive(Clone, Debug)]
pub struct Tangent {
    plant: Plant<Number>,
    base: Vec<Number>,
    q: Vec<Number>,
    xi: Vec<Number>,
    v: Vec<Number>,
    s: Vec<Number>,
    d: Vec<Number>,
    /// Rate of the local coordinates at the last evaluation.
    pub xi_dot: Vec<Number>,
    /// Accelerations at the last evaluation.
    pub v_dot: Vec<Number>,
    /// Rates of the extra states at the last evaluation.
    pub s_dot: Vec<Number>,
}

impl Tangent {
    /// Creates the tangent of a plant.
    pub fn new(plant: Plant<Number>) -> Self {
        let Sizes { positions, velocities, extras, .. } = plant.sizes();
        let zeros = |n| vec![Number::ZERO; n];
        Self {
            base: zeros(positions),
            q: zeros(positions),
            xi: zeros(velocities),
            v: zeros(velocities),
            s: zeros(extras),
            d: zeros(plant.layout().discrete()),
            plant,
            xi_dot: zeros(velocities),
            v_dot: zeros(velocities),
            s_dot: zeros(extras),
        }
    }

    /// Sets the purpose of the evaluations, like [`Plant::set_evaluation_mode`].
    pub fn set_evaluation_mode(&mut self, evaluation: EvaluationMode) {
        self.plant.set_evaluation_mode(evaluation);
    }

    /// Removes the waves.
    pub fn calm(&mut self) {
        self.plant.world.waves = None;
    }

    /// Sets the waves like [`Plant::set_waves`].
    pub fn set_waves(&mut self, amplitudes_m: &[f64], phases_rad: &[f64]) {
        self.plant.set_waves(amplitudes_m, phases_rad);
    }

    /// Sets the trims like [`Plant::set_trims`].
    pub fn set_trims(&mut self, trims: &[Vec<f64>]) {
        let constant = |trim: &Vec<f64>| trim.iter().map(|entry| Number::constant(*entry)).collect();
        self.plant.set_trims(&trims.iter().map(constant).collect::<Vec<_>>());
    }

    /// Returns rates and accelerations that elements prescribe at the start of an interval, for each
    /// coordinate of v; 0 for others.
    pub fn prescribed(&mut self, interval: Interval, coordinates: usize) -> (Vec<f64>, Vec<f64>) {
        let plain = |from: &[Number]| from.iter().map(|number| number.value).collect();
        let mut rates = vec![Number::ZERO; coordinates];
        let accelerations = self.plant.prescribe(interval, &mut rates);
        (plain(&rates), plain(accelerations))
    }

    /// Starts to monitor the closed loops at q, like [`Plant::watch_loops`].
    pub fn watch_loops(&mut self, q: &[f64]) {
        self.q.iter_mut().zip(q).for_each(|(to, from)| *to = Number::constant(*from));
        self.v.fill(Number::ZERO);
        self.plant.watch_loops(&self.q, &self.v);
    }

    /// Returns the plant.
    pub fn plant(&self) -> &Plant<Number> {
        &self.plant
    }

    /// Returns the plant, mutable.
    pub fn plant_mut(&mut self) -> &mut Plant<Number> {
        &mut self.plant
    }

    /// Evaluates the rates at `q = retract(base, xi)` and `at`'s v, s, d, with derivatives along at most
    /// [`DIRECTIONS`] directions; `at.q` is not used. Allocates nothing.
    pub fn evaluate(&mut self, base: &[f64], xi: &[f64], at: Stage<'_>, along: &[Along]) {
        self.lift(base, xi, at, along);
        self.plant.dexp_inverse(&self.xi, &self.v, &mut self.xi_dot);
        let (q, v, s, d) = (&self.q, &self.v, &self.s, &self.d);
        let stage = Stage { time_s: at.time_s, interval: at.interval, q, v, s, d, m: at.m };
        self.plant.rates(stage, &mut self.v_dot, &mut self.s_dot);
    }

    /// Returns the rate of a variable at the last evaluation; 0 for an input.
    pub fn rate(&self, of: Along) -> Number {
        match of {
            Along::Position(i) => self.xi_dot[i],
            Along::Velocity(i) => self.v_dot[i],
            Along::Extra(i) => self.s_dot[i],
            Along::Input(_) => Number::ZERO,
        }
    }

    /// Calls `see` with an observation of the plant at this state, with the same derivatives; returns its
    /// result.
    pub fn observe<T>(
        &mut self,
        base: &[f64],
        xi: &[f64],
        at: Stage<'_>,
        along: &[Along],
        see: impl FnOnce(Stage<'_, Number>, Observation<'_, Number>) -> T,
    ) -> T {
        self.lift(base, xi, at, along);
        let (q, v, s, d) = (&self.q, &self.v, &self.s, &self.d);
        let stage = Stage { time_s: at.time_s, interval: at.interval, q, v, s, d, m: at.m };
        see(stage, self.plant.observe(stage, &ObservedPart::Everything, &mut self.v_dot))
    }

    /// Returns the stage over dual numbers.
    fn lift(&mut self, base: &[f64], xi: &[f64], at: Stage<'_>, along: &[Along]) {
        let lift = |from: &[f64], to: &mut [Number]| {
            to.iter_mut().zip(from).for_each(|(to, from)| *to = Number::constant(*from));
        };
        lift(base, &mut self.base);
        lift(xi, &mut self.xi);
        lift(at.v, &mut self.v);
        lift(at.s, &mut self.s);
        lift(at.d, &mut self.d);
        for (k, direction) in along.iter().enumerate() {
            let entry = match *direction {
                Along::Position(i) => &mut self.xi[i],
                Along::Velocity(i) => &mut self.v[i],
                Along::Extra(i) => &mut self.s[i],
                Along::Input(i) => &mut self.d[i],
            };
            entry.derivative[k] = 1.0;
        }
        self.plant.retract(&self.base, &self.xi, &mut self.q);
    }

    /// Writes the derivatives of the rates at `q = retract(base, xi)`; see [`System::jacobian`]. Returns
    /// their cost in plain evaluations: one plus one per direction, for each evaluation.
    pub(super) fn jacobian(&mut self, base: &[f64], xi: &[f64], at: Stage<'_>, out: &mut Jacobian) -> u64 {
        let n = xi.len();
        let (rows, first) = (out.rows, out.passive);
        let (mut column, mut worth) = (0, 0);
        loop {
            let mut along = [Along::Input(0); DIRECTIONS];
            let mut count = 0;
            while count < DIRECTIONS && column < n + rows {
                let direction = match column {
                    i if i < n => Along::Position(i),
                    i if i < 2 * n => Along::Velocity(i - n),
                    i => Along::Extra(first + i - 2 * n),
                };
                if column >= 2 * n || self.plant.model.modes[column % n] == MotionType::Free {
                    along[count] = direction;
                    count += 1;
                }
                column += 1;
            }
            if count == 0 {
                return worth;
            }
            worth += 1 + DIRECTIONS as u64;
            self.evaluate(base, xi, at, &along[..count]);
            for (k, along) in along[..count].iter().enumerate() {
                let column = match *along {
                    Along::Position(i) => &mut out.by_xi[i * rows..][..rows],
                    Along::Velocity(i) => &mut out.by_v[i * rows..][..rows],
                    Along::Extra(i) => &mut out.by_s[(i - first) * rows..][..rows],
                    Along::Input(_) => continue,
                };
                let rates = self.v_dot.iter().chain(&self.s_dot[first..]);
                column.iter_mut().zip(rates).for_each(|(entry, rate)| *entry = rate.derivative[k]);
            }
        }
    }
}
