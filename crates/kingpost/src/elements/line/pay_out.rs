//! A line whose first part is paid out and hauled in at its first end: its material moves through its nodes.
//!
//! The nodes of the first part stay at the same shares of its length L (an arbitrary Lagrangian-Eulerian mesh: Donea et al.,
//! *Encyclopedia of Computational Mechanics*, 2004, ch. 14). With the unstretched length s from the end of the part, the share
//! `xi = s / L` and the velocity v of the material,
//!
//! ```text
//! x' = v + c L',      v' = a + xi (dv/ds) L',      c = xi dx/ds
//! ```
//!
//! where a is the acceleration of the material by the forces on it. The line pulls material from its supply with the force
//! along L at which energy is conserved by the equations of the nodes, with the conservative forces F, the strain energy W,
//! the mass m(L), weight and ground in V, and velocities w relative to the first end:
//!
//! ```text
//! Q = sum F . c - dV/dL - sum (m xi w . dv/ds + m_L w^2 / 2),      V = W + sum m g z + ...
//! ```
//!
//! In the limit of short elements it is `T (1 + e) - W_L - mu (g z + w^2 / 2)` at the first end: a part of the tension stretches
//! what comes out (compare `ropes/mod.rs`). The material leaves the first end with its velocity there plus w, and pushes it with
//! the thrust `-mu L' w`. If the last node grows, its weight and `m_L w^2 / 2` are in Q and its share in the thrust, but its
//! kinetic energy is that of its body.

use super::feed::{LineFeed, convected, write_drifts};
use super::ground::LineGround;
use super::mesh::LineMesh;
use super::nodes::{LineNode, Nodes};
use super::strain::{gauss, slopes};
use crate::elements::Context;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

impl<S: Scalar> Nodes<S> {
    /// Sets the rate at which the first part is paid out, m/s, with all nodes put; the first node gets the velocity of the
    /// material.
    pub fn pay_out(&mut self, mesh: &LineMesh<S>, rate: S) {
        let Self { nodes, feed, .. } = self;
        write_drifts(mesh, |node| nodes[node].position, &mut feed.drifts);
        (feed.rate, feed.tip) = (rate, nodes[0].velocity);
        nodes[0].velocity = feed.tip - feed.drifts[0] * rate;
    }

    /// Returns the velocity of a node, world, m/s: that of the material with its motion along the line.
    pub fn mesh_velocity(&self, node: usize) -> Vector3<S> {
        self.nodes[node].velocity + self.feed.drift(node) * self.feed.rate
    }

    /// Returns the rate of the velocity of a node between the ends, world, m/s^2.
    pub fn mesh_acceleration(&self, node: usize, mesh: &LineMesh<S>) -> Vector3<S> {
        self.nodes[node].acceleration + self.convected(node, mesh) * self.feed.rate
    }

    /// Returns `xi dv/ds` at a node between the ends, 1/s.
    fn convected(&self, node: usize, mesh: &LineMesh<S>) -> Vector3<S> {
        if node >= 2 * mesh.supplied {
            return Vector3::zero();
        }
        convected(mesh, node, |node| self.nodes[node].velocity)
    }

    /// Computes the force on the supply and the thrust, after the line is stretched. Returns their power on the strain and on
    /// the nodes between the ends, W, without that of the material that comes in.
    pub fn draw_supply(&mut self, mesh: &LineMesh<S>, ground: Option<&LineGround<S>>, at: &Context<'_, S>) -> S {
        let strained = self.drawn_by_strain(mesh);
        let (mut force, mut momentum, mut grown) = (strained, Vector3::zero(), S::ZERO);
        let (half, last) = (S::constant(0.5), self.nodes.len() - 1);
        for node in 1..=2 * mesh.supplied {
            let (part, place) = (&mesh.nodes[node], self.nodes[node].position);
            let (mass, growth) = (part.dry_mass(), mesh.mass_per_length() * S::constant(part.growth));
            if node == last {
                break;
            }
            let drift = self.feed.drift(node);
            force -= (mass * drift[2] + growth * place[2]) * at.world.gravity;
            if let Some(ground) = ground {
                let [support, energy] = ground.held_per_length(place);
                force += support * part.length * drift[2] - energy * S::constant(part.growth);
            }
            let (convected, own) = (self.convected(node, mesh), self.nodes[node].velocity);
            let relative = own - self.feed.tip;
            force -= mass * relative.dot(convected) + growth * half * relative.norm_squared();
            momentum += convected * mass + own * growth;
            grown += growth;
        }
        let LineFeed { rate, tip, .. } = self.feed;
        let thrust = (tip * grown - momentum) * rate;
        let entering = grown * half * tip.norm_squared() * rate;
        let feed = &mut self.feed;
        (feed.force, feed.taken_up, feed.thrust, feed.entering) = (force, momentum * rate, thrust, entering);
        if last == 2 * mesh.supplied {
            self.grow_end(mesh, ground, at);
        }
        force * rate + thrust.dot(tip) - entering
    }

    /// Adds what grows at the last node, whose kinetic energy is that of its body.
    fn grow_end(&mut self, mesh: &LineMesh<S>, ground: Option<&LineGround<S>>, at: &Context<'_, S>) {
        let (half, last) = (S::constant(0.5), self.nodes.len() - 1);
        let (share, LineNode { position, velocity, .. }) = (S::constant(mesh.nodes[last].growth), self.nodes[last]);
        let growth = mesh.mass_per_length() * share;
        let feed = &mut self.feed;
        let relative = velocity - feed.tip;
        feed.of_end = -growth * (at.world.gravity * position[2] + half * relative.norm_squared());
        if let Some(ground) = ground {
            feed.of_end -= ground.held_per_length(position)[1] * share;
        }
        feed.thrust -= relative * (growth * feed.rate);
        let kinetic = (feed.tip.norm_squared() - velocity.norm_squared()) * half;
        feed.entering += growth * kinetic * feed.rate;
    }

    /// Returns Q of the strain and of its damping, N.
    fn drawn_by_strain(&self, mesh: &LineMesh<S>) -> S {
        let half = S::constant(0.5);
        let per_length = half / mesh.first();
        let mut force = S::ZERO;
        for (k, point) in self.points[..2 * mesh.supplied].iter().enumerate() {
            let length = mesh.elements[k / 2].length;
            let ([elastic, whole], [ratio, _]) = (point.tension, point.ratio);
            for (slope, node) in slopes(gauss(k), length).iter().zip(k / 2 * 2..) {
                let pull = if node == 0 { elastic - whole } else { elastic };
                force -= pull * *slope * length * half * point.tangent.dot(self.feed.drift(node));
            }
            let strain_energy = elastic * (ratio - S::ONE) * half;
            force += length * per_length * (elastic * ratio - strain_energy);
        }
        force
    }
}
