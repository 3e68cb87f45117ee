//! Drag in a random sea: the covariances over which it is the mean, and its elements in the linear response.

use super::AtRest;
use super::excitation::WaveLoads;
use crate::elements::{AnyElement, WATER_COMPONENTS, WaterMotion};
use crate::integrate::Stage;
use crate::plant::{Along, DIRECTIONS, Number, Plant, Tangent};
use crate::scalar::Scalar;
use crate::sea::waves::{Water, wave_number};
use crate::spatial::{Symmetric3, Vector3};
use nalgebra::{Complex, DMatrix};

/// Covariances of the water's relative velocities at the nodes of each element with random drag, m^2/s^2.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RandomDrags {
    pub(super) spreads: Vec<Vec<Symmetric3>>,
    /// Those with which the model is settled.
    pub(super) at_rest: Vec<Vec<Symmetric3>>,
}

impl RandomDrags {
    /// Lets the elements respond to a random sea.
    pub(super) fn put_into(&self, elements: &mut [AnyElement<Number>]) {
        let with_drag = elements.iter_mut().filter(|element| element.random_drag().is_some());
        for (element, spread) in with_drag.zip(&self.spreads) {
            element.move_about_rest(true);
            if let Some(drag) = element.random_drag_mut() {
                drag.set_spread(spread);
            }
        }
    }

    /// Returns the number of components of the water's motion at all nodes.
    pub(super) fn components(&self) -> usize {
        WATER_COMPONENTS * self.spreads.iter().map(Vec::len).sum::<usize>()
    }
}

/// Sets the components of the water's motion at all nodes, one after another.
pub(super) fn set_water(elements: &mut [AnyElement<Number>], component: impl Fn(usize) -> Number) {
    let mut first = 0;
    for drag in elements.iter_mut().filter_map(|element| element.random_drag_mut()) {
        for node in 0..drag.nodes() {
            drag.set_water(node, WaterMotion::from_components(core::array::from_fn(|k| component(first + k))));
            first += WATER_COMPONENTS;
        }
    }
}

/// Sets the water at all nodes at rest, with derivatives along at most [`DIRECTIONS`] components from the first one on.
pub(super) fn vary_water(elements: &mut [AnyElement<Number>], first: usize) {
    set_water(elements, |component| {
        let mut number = Number::ZERO;
        if (first..first + DIRECTIONS).contains(&component) {
            number.derivative[component - first] = 1.0;
        }
        number
    });
}

/// The water at the nodes of elements with random drag, as an input of the linearised system.
pub(super) struct WaterAtNodes {
    /// Positions of the nodes at rest, world, m.
    places: Vec<Vector3>,
    water: Water,
    /// Derivatives of the states' rates along the components of the water's motion.
    rates: DMatrix<f64>,
    /// Derivatives of the nodes' velocities, three of each, along the states.
    velocities: DMatrix<f64>,
}

impl WaterAtNodes {
    /// Differentiates a plant at rest, whose elements respond to the random sea; `along` are the variables of the states.
    pub(super) fn new(plant: Plant<Number>, at: Stage<'_>, along: &[Along], drags: &RandomDrags) -> Self {
        let water = plant.world.plain_water();
        let mut tangent = Tangent::new(plant);
        tangent.set_evaluation_mode(crate::elements::EvaluationMode::AtRest);
        tangent.watch_loops(at.q);
        let still = vec![0.0; at.v.len()];
        let nodes = drags.components() / WATER_COMPONENTS;
        let mut velocities = DMatrix::zeros(3 * nodes, along.len());
        let mut places = Vec::new();
        for (chunk, directions) in along.chunks(DIRECTIONS).enumerate() {
            tangent.evaluate(at.q, &still, at, directions);
            let moved = motions(tangent.plant().elements());
            for (row, number) in moved.iter().flat_map(|[_, velocity]| velocity.0).enumerate() {
                for k in 0..directions.len() {
                    velocities[(row, chunk * DIRECTIONS + k)] = number.derivative[k];
                }
            }
            places = moved.iter().map(|[place, _]| Vector3(place.0.map(Scalar::value))).collect();
        }
        let mut rates = DMatrix::zeros(along.len(), drags.components());
        for first in (0..drags.components()).step_by(DIRECTIONS) {
            vary_water(tangent.plant_mut().elements_mut(), first);
            tangent.evaluate(at.q, &still, at, &[]);
            for (row, variable) in along.iter().enumerate() {
                let rate = tangent.rate(*variable);
                for k in 0..DIRECTIONS.min(drags.components() - first) {
                    rates[(row, first + k)] = rate.derivative[k];
                }
            }
        }
        Self { places, water, rates, velocities }
    }

    /// Returns the rates of the states by the water in waves of unit amplitude, one column for each direction.
    pub(super) fn forcing(&self, loads: &WaveLoads<'_>, omega: f64, directions: &[f64]) -> DMatrix<Complex<f64>> {
        self.rates.map(|rate| Complex::new(rate, 0.0)) * self.amplitudes(loads, omega, directions)
    }

    /// Returns the components of the water's motion in waves of unit amplitude, one column for each direction: linear theory in the
    /// depth of the world, at the place of each node at rest.
    pub(super) fn amplitudes(&self, loads: &WaveLoads<'_>, omega: f64, directions: &[f64]) -> DMatrix<Complex<f64>> {
        let mut all = DMatrix::zeros(WATER_COMPONENTS * self.places.len(), directions.len());
        for (node, place) in self.places.iter().enumerate() {
            let [level, upward] = decay(omega, place[2], &self.water);
            for (wave, &direction) in directions.iter().enumerate() {
                let elevation = loads.elevation(omega, direction, [place[0], place[1]]);
                let (sin, cos) = libm::sincos(direction);
                let velocity = [
                    elevation * (omega * level * cos),
                    elevation * (omega * level * sin),
                    elevation * Complex::new(0.0, -omega * upward),
                ];
                let first = WATER_COMPONENTS * node;
                all[(first, wave)] = elevation;
                for (axis, part) in velocity.into_iter().enumerate() {
                    all[(first + 1 + axis, wave)] = part;
                    all[(first + 4 + axis, wave)] = part * Complex::new(0.0, -omega);
                }
            }
        }
        all
    }

    /// Returns the velocities of the water relative to the nodes, three of each, for amplitudes of the water and of the states.
    pub(super) fn relative(
        &self,
        water: &DMatrix<Complex<f64>>,
        states: &DMatrix<Complex<f64>>,
    ) -> DMatrix<Complex<f64>> {
        let by = |part: fn(&Complex<f64>) -> f64| &self.velocities * states.map(|x| part(&x));
        let (re, im) = (by(|x| x.re), by(|x| x.im));
        DMatrix::from_fn(re.nrows(), re.ncols(), |row, wave| {
            water[(WATER_COMPONENTS * (row / 3) + 1 + row % 3, wave)] - Complex::new(re[(row, wave)], im[(row, wave)])
        })
    }
}

impl AtRest {
    /// Returns the number of components of the water's motion, 0 without random drag.
    pub(super) fn water_components(&self) -> usize {
        self.drags.as_ref().map_or(0, RandomDrags::components)
    }
}

/// Returns position and velocity of all nodes at the last evaluation.
fn motions(elements: &[AnyElement<Number>]) -> Vec<[Vector3<Number>; 2]> {
    let drags = elements.iter().filter_map(|element| element.random_drag());
    drags.flat_map(|drag| (0..drag.nodes()).map(move |node| drag.motion(node))).collect()
}

/// Returns the horizontal and the vertical velocity at a height, over that of the surface in deep water; a place above the still
/// water has that of the surface, one below the seabed that of the seabed.
fn decay(omega: f64, height: f64, water: &Water) -> [f64; 2] {
    let k = wave_number(omega, water);
    let Some(depth) = water.depth_m else { return [libm::exp(k * height.min(0.0)); 2] };
    let height = height.clamp(-depth, 0.0);
    let (down, up) = (libm::exp(k * height), libm::exp(-k * (height + 2.0 * depth)));
    let scale = 1.0 / (1.0 - libm::exp(-2.0 * k * depth));
    [(down + up) * scale, (down - up) * scale]
}
