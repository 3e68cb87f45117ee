//! Offlead and sidelead: the angles of a rope from the vertical below its crane.

use super::RopePath;
use crate::scalar::Scalar;
use crate::spatial::Vector3;

/// The place where a rope leaves its crane.
struct Leaves {
    /// The leg between crane and load.
    leg: usize,
    /// Whether the rope runs along the leg from the load to the crane, as a rope with its dead end on the crane does.
    runs_up: bool,
    /// The sheave or drum whose axis is perpendicular to the plane of the boom.
    across: usize,
}

impl<S: Scalar> RopePath<S> {
    /// Returns the last leg between two bodies, and whether the rope runs along it from the load to the crane. The
    /// crane's body is the first body on the path.
    pub(super) fn leaving_leg(&self) -> Option<(usize, bool)> {
        let body = |k: usize| self.stations()[k].centre.body;
        let leg = (0..self.stations().len().saturating_sub(1)).rev().find(|&k| body(k) != body(k + 1))?;
        let first = |k: usize| self.stations().iter().position(|station| station.centre.body == body(k));
        Some((leg, first(leg + 1) < first(leg)))
    }

    /// Returns the place where the rope leaves its crane. The plane of the boom is perpendicular to the axis of the
    /// last sheave, or the drum, on the crane.
    fn leaves(&self) -> Option<Leaves> {
        let (leg, runs_up) = self.leaving_leg()?;
        let crane = self.stations()[leg + usize::from(runs_up)].centre.body;
        let on_crane = |&k: &usize| self.stations()[k].centre.body == crane && self.stations()[k].round.is_some();
        let across = (0..self.stations().len()).rev().find(on_crane)?;
        Some(Leaves { leg, runs_up, across })
    }

    /// Whether the rope has an offlead and a sidelead.
    pub fn has_leads(&self) -> bool {
        self.leaves().is_some()
    }

    /// Returns offlead and sidelead of the leg between crane and load, rad: the angle between the leg and the vertical
    /// in the plane of the boom, positive outward, and the angle between the leg and that plane, positive along the
    /// axis of the sheave. With the unit vectors u down the leg, z up, a along the axis, and h across a, level and
    /// outward: offlead = atan2(u.h, -u.z), sidelead = asin(u.a). `None` without a sheave or drum on the crane. Call
    /// after [`extent`](Self::extent).
    pub fn leads(&self) -> Option<[S; 2]> {
        let Leaves { leg, runs_up, across } = self.leaves()?;
        let [from, to] = self.straights().nth(leg)?;
        let down_the_leg = if runs_up { from - to } else { to - from };
        let axis = self.axis(across);
        let level = axis.cross(Vector3([S::ZERO, S::ZERO, S::ONE]));
        let outward =
            across.checked_sub(1).map_or(S::ONE, |before| level.dot(self.centre(across) - self.centre(before)));
        // With a vertical axis there is no outward direction: the offlead is then 0.
        let size = (level.norm_squared() + S::constant(f64::MIN_POSITIVE)).sqrt();
        let level = level * (S::ONE / outward.select_below(0.0, || -size, || size));
        let (out, aside, down) = (down_the_leg.dot(level), down_the_leg.dot(axis), -down_the_leg[2]);
        let in_plane = down_the_leg - axis * aside;
        Some([out.atan2(down), aside.atan2(in_plane.norm())])
    }
}
