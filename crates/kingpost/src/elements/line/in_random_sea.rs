//! A line in a linear response to a random sea: its nodes move by its states about rest, and the drag is its mean over the
//! Gaussian velocities of the water relative to the nodes.

use super::DynamicLine;
use super::section::{LineDrag, WetPart};
use crate::elements::random_drag::{mean_across, mean_along};
use crate::elements::{RandomDrag, WATER_COMPONENTS, WaterMotion};
use crate::scalar::Scalar;
use crate::spatial::{Symmetric3, Vector3};

/// The random sea about a node.
#[derive(Clone, Copy, Debug)]
pub struct RandomWater<S> {
    /// Covariance of the velocity of the water relative to the node, world, m^2/s^2.
    pub spread: Symmetric3,
    /// Motion of the water by waves.
    pub water: WaterMotion<S>,
}

impl<S: Scalar> WetPart<S> {
    /// Returns the part in a random sea.
    pub fn in_random_sea(self, sea: &RandomWater<S>) -> Self {
        let WaterMotion { elevation, velocity, acceleration } = sea.water;
        let along = self.tangent * self.tangent.dot(acceleration);
        let inertial =
            acceleration * (self.displaced + self.added.across) + along * (self.added.along - self.added.across);
        let rise = Vector3::new(S::ZERO, S::ZERO, self.stiffness * elevation);
        Self {
            velocity: self.velocity + velocity,
            steady: self.steady + inertial + rise,
            spread: Some(sea.spread),
            ..self
        }
    }

    /// Returns the mean drag at a mean relative velocity with this covariance.
    pub fn mean_drag(&self, relative: Vector3<S>, spread: &Symmetric3) -> LineDrag<S> {
        let [across, along] = self.drag;
        let (of_across, slope_across) = mean_across(self.tangent, relative, spread);
        let (of_along, slope_along) = mean_along(self.tangent, relative, spread);
        LineDrag {
            force: of_across * across + of_along * along,
            relative,
            slope: slope_across.scaled(across) + slope_along.scaled(along),
        }
    }
}

impl<S: Scalar> DynamicLine<S> {
    /// Whether a linear response can have its drag: it has some, and begins at rest.
    pub(super) fn has_random_drag(&self) -> bool {
        let has = |drag: S| drag.value() > 0.0;
        let meshes = || self.strands.iter().map(|strand| &strand.mesh);
        let sections = meshes().flat_map(|mesh| &mesh.elements).flat_map(|element| element.section.drag);
        let clumps = meshes().flat_map(|mesh| &mesh.nodes).filter_map(|node| Some(node.clump?.drag_area));
        self.start.is_none() && sections.chain(clumps).any(has)
    }
}

impl<S: Scalar> RandomDrag<S> for DynamicLine<S> {
    fn nodes(&self) -> usize {
        self.strands.iter().map(|strand| strand.mesh.nodes.len()).sum()
    }

    fn set_spread(&mut self, spread: &[Symmetric3]) {
        let water = WaterMotion::from_components([S::ZERO; WATER_COMPONENTS]);
        let nodes = self.strands.iter_mut().flat_map(|strand| &mut strand.mesh.nodes);
        for (node, spread) in nodes.zip(spread) {
            node.random = Some(RandomWater { spread: *spread, water });
        }
    }

    fn set_water(&mut self, node: usize, water: WaterMotion<S>) {
        let (strand, node) = self.among_all(node);
        if let Some(random) = &mut self.strands[strand].mesh.nodes[node].random {
            random.water = water;
        }
    }

    fn motion(&self, node: usize) -> [Vector3<S>; 2] {
        let (strand, node) = self.among_all(node);
        let found = self.strands[strand].nodes.node(node);
        [found.position, found.velocity]
    }
}
