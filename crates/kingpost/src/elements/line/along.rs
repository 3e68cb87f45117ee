//! Results along a line: tensions at points evenly spaced along its unstretched length, its length, and where it touches the
//! seabed.

use super::ground::LineGround;
use super::mesh::LineMesh;
use super::nodes::Nodes;
use super::strain::{BEYOND_GAUSS, GAUSS};
use crate::elements::{Output, PlacesAlong};
use crate::scalar::Scalar;

/// Variable with the unstretched length of a line.
const LENGTH: &str = "line_length";

/// Returns the outputs of [`Nodes::write_along`].
pub fn outputs_along(name: &str, points: usize, has_ground: bool) -> Vec<Output> {
    let length = "unstretched length of a line with mass";
    let mut outputs = vec![Output::number(LENGTH, length, "line", name, &["m"])];
    if has_ground {
        let touchdown = "unstretched length of a line from its first end to where it touches the seabed; its whole length if it does not";
        outputs.push(Output::number("line_touchdown", touchdown, "line", name, &["m"]));
    }
    if points > 0 {
        let tension = "tension at points along a line, evenly spaced along its unstretched length";
        let along = PlacesAlong {
            lines: vec![name.to_owned(); points],
            shares: (0..points).map(|point| share(point, points)).collect(),
            length: LENGTH,
        };
        outputs.push(Output {
            labels: (1..=points).map(|point| format!("{name}.point_{point}")).collect(),
            along: Some(along),
            ..Output::number("line_tension_along", tension, "line_point", name, &["N"])
        });
    }
    outputs
}

/// Returns the share of the length at which a point of several is.
fn share(point: usize, points: usize) -> f64 {
    point as f64 / (points - 1) as f64
}

impl<S: Scalar> Nodes<S> {
    /// Appends the length, the touchdown if there is a ground, and the tensions at this number of points: 0, or 2 and more.
    pub fn write_along(&self, mesh: &LineMesh<S>, ground: Option<&LineGround<S>>, points: usize, out: &mut Vec<S>) {
        out.push(mesh.length);
        out.extend(ground.map(|ground| self.touchdown(mesh, ground)));
        if points == 0 {
            return;
        }
        let ends = self.end_tensions(mesh);
        out.push(ends[0]);
        out.extend((1..points - 1).map(|point| self.tension_at(share(point, points), mesh, ends)));
        out.push(ends[1]);
    }

    /// Returns the unstretched length from the first end to where the line first touches the ground, linear between nodes, m.
    fn touchdown(&self, mesh: &LineMesh<S>, ground: &LineGround<S>) -> S {
        let above = |node: usize| -ground.under(self.node(node).position);
        let (mut found, mut to) = (mesh.length, mesh.length);
        for node in (1..self.len()).rev() {
            let half = mesh.elements[(node - 1) / 2].length * S::constant(0.5);
            let [near, far] = [above(node - 1), above(node)];
            let crossing = || near.select_below(0.0, || found, || to - half * far / (far - near));
            found = far.select_below(0.0, crossing, || found);
            to -= half;
        }
        above(0).select_below(0.0, || S::ZERO, || found)
    }

    /// Returns the tension at a share of the length between these tensions of the ends, N.
    fn tension_at(&self, share: f64, mesh: &LineMesh<S>, ends: [S; 2]) -> S {
        let place = mesh.length * S::constant(share);
        let (mut found, mut from) = (ends[0], S::ZERO);
        for (element, part) in mesh.elements.iter().enumerate() {
            let to = from + part.length;
            // Lanes can have the place in different elements.
            let is_last = element + 1 == mesh.elements.len();
            if is_last || !(place - to).all(|beyond| beyond >= 0.0) {
                let two = S::constant(2.0);
                let xi = || (place - from) * two / part.length - S::ONE;
                let tension = || self.tension_in(element, mesh, xi(), ends);
                found = place.select_less(from, || found, tension);
            }
            if (place - to).all(|beyond| beyond < 0.0) {
                break;
            }
            from = to;
        }
        found
    }

    /// Returns the tension in an element, xi halves of its length from its middle, N: linear between its ends and the points
    /// of Gauss's rule.
    fn tension_in(&self, element: usize, mesh: &LineMesh<S>, xi: S, ends: [S; 2]) -> S {
        let [first, second] = self.at_gauss(element);
        let between = |[a, b]: [S; 2], [from, to]: [f64; 2]| {
            a + (b - a) * (xi - S::constant(from)) * S::constant(1.0 / (to - from))
        };
        let before = || between([self.at_joint(element, mesh, ends), first], [-1.0, -GAUSS]);
        let after = || between([second, self.at_joint(element + 1, mesh, ends)], [GAUSS, 1.0]);
        let inner = || xi.select_below(GAUSS, || between([first, second], [-GAUSS, GAUSS]), after);
        xi.select_below(-GAUSS, before, inner)
    }

    /// Returns the tension between an element and the one before it, N: the mean of both, extrapolated; that of the end where
    /// there is no other element.
    fn at_joint(&self, element: usize, mesh: &LineMesh<S>, ends: [S; 2]) -> S {
        if element == 0 {
            return ends[0];
        }
        if 2 * element == self.len() - 1 {
            return ends[1];
        }
        let beyond = S::constant(BEYOND_GAUSS);
        let ([second, last], [first, next]) = (self.at_gauss(element - 1), self.at_gauss(element));
        let mean = (last + first + (last - second + first - next) * beyond) * S::constant(0.5);
        mesh.elements[element].section.possible(mean)
    }

    /// Returns the tensions at the points of Gauss's rule of an element, N.
    fn at_gauss(&self, element: usize) -> [S; 2] {
        [0, 1].map(|k| self.tension(2 * element + k))
    }
}
