//! The lines to draw in addition to the bodies.

use super::{Simulation, stage};
use crate::elements::{DrawnLine, LineStyle};
use crate::model::Joint;

impl Simulation {
    /// Returns the lines to draw: a rope for each body that hangs on its joint, and the lines of the
    /// elements.
    pub fn lines(&self) -> Vec<DrawnLine> {
        let rope = |(_, joint): (usize, &Joint)| DrawnLine::thin(&joint.name, LineStyle::Line, 2);
        self.hanging().map(rope).chain(self.plant.layout().lines.iter().cloned()).collect()
    }

    /// Returns the end points of [`lines`](Self::lines) at the present time, in the same order: x, y and z of
    /// each, m, world.
    pub fn line_points(&mut self) -> Vec<f64> {
        let mut points = Vec::new();
        let hanging: Vec<(usize, [f64; 3])> =
            self.hanging().map(|(body, joint)| (body, joint.kind.to_child().0)).collect();
        let bodies = self.plant.body_kinematics(&self.state.q, &self.state.v);
        for (body, [x, y, z]) in hanging {
            points.extend(bodies.world[body].point(crate::spatial::Vector3::new(-x, -y, -z)).0);
            points.extend(bodies.world[body].position.0);
        }
        self.plant.draw(stage(self.interval(), &self.state), &mut points);
        points
    }

    /// Returns the bodies that can swing about a joint outside their centre of mass, each with its joint:
    /// they hang as on a massless rope.
    fn hanging(&self) -> impl Iterator<Item = (usize, &Joint)> {
        let hangs = |joint: &Joint| joint.kind.swings() && joint.kind.to_child().norm() > 0.0;
        self.plant.model.joints.iter().enumerate().filter(move |(_, joint)| hangs(joint))
    }
}
