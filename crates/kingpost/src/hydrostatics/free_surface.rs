//! Tanks: the reduction of the metacentric height by their free surfaces.

use super::floating::LoadedHull;
use super::hanging::HangingLoad;
use super::liquids::FreeSurface;
use crate::elements::{FreeFloodingTank, SlackTank, UTank};
use crate::sea::hull::HullTank;
use crate::spatial::{Matrix3, Vector3};

impl LoadedHull<'_> {
    /// Returns the slack tanks on the hull and on bodies that move with it, with their axes in hull axes.
    pub(super) fn tanks(&self, hanging: &[HangingLoad]) -> Vec<(&SlackTank, HullTank)> {
        let to_hull = self.frame().rotation.transpose();
        let hull = self.model.carried(self.hull.frame.body);
        let hangs = |body: usize| {
            let hanging = hanging.iter().filter_map(|load| self.model.body(&load.body));
            hanging.into_iter().any(|load| self.model.carried(load).contains(&body))
        };
        let is_slack = |tank: &SlackTank| tank.tank.filling > 0.0 && tank.tank.filling < 1.0;
        let of_hull = |tank: &&&SlackTank| is_slack(tank) && hull.contains(&tank.place.body) && !hangs(tank.place.body);
        let placed = |tank: &SlackTank| {
            let rotation: Matrix3 = to_hull * self.at.world[tank.place.body].rotation;
            HullTank { tank: tank.tank, rotation, density: tank.density }
        };
        self.liquids.slack_tanks.iter().filter(of_hull).map(|tank| (*tank, placed(tank))).collect()
    }

    /// Returns the shift of the centre of gravity by the liquid in tanks, hull axes, m.
    pub(super) fn liquid_shift(&self, tanks: &[(&SlackTank, HullTank)], vertical: Vector3) -> Vector3 {
        let shift = tanks.iter().fold(Vector3::zero(), |sum, (_, tank)| sum + tank.shift(vertical));
        shift * (1.0 / self.carried_weight().mass)
    }

    /// Returns the free surfaces of the tanks; `tangents` are the axes across and along the ship in the
    /// water's plane, hull axes.
    pub(super) fn free_surfaces(
        &self,
        tanks: &[(&SlackTank, HullTank)],
        vertical: Vector3,
        tangents: [Vector3; 2],
    ) -> Vec<FreeSurface> {
        let mass = self.carried_weight().mass;
        let to_hull = self.frame().inverse();
        let describe = |(tank, placed): &(&SlackTank, HullTank)| {
            let volume = placed.tank.volume();
            let box_centre = to_hull.point(self.at.world[tank.place.body].point(tank.place.origin));
            let upright = Vector3::new(0.0, 0.0, 0.5 * (placed.tank.filling - 1.0) * placed.tank.edges[2]);
            let moved = placed.shift(vertical) * (1.0 / (placed.density * volume));
            let centre = box_centre + placed.rotation * upright + moved;
            FreeSurface {
                force: tank.name.clone(),
                body: self.model.bodies[tank.place.body].name.clone(),
                liquid_kg: placed.density * volume,
                keel_to_liquid_m: centre[2] + self.database.hull.draught_m,
                correction_m: tangents.map(|t| placed.second_moment(vertical, t, t) / mass),
            }
        };
        tanks.iter().map(describe).collect()
    }

    /// Returns the free surfaces of the U-tanks and the free-flooding tanks that the hull carries; `plane` is
    /// the area of her waterplane and its centre, hull axes.
    pub(super) fn surfaces_of_levels(&self, plane: (f64, Vector3), tangents: [Vector3; 2]) -> Vec<FreeSurface> {
        let hull = self.model.carried(self.hull.frame.body);
        let u_tanks = self.liquids.u_tanks.iter().filter(|tank| hull.contains(&tank.carrier));
        let u_tanks = u_tanks.filter_map(|tank| self.surface_of_u_tank(tank, tangents));
        let flooded = self.liquids.flooded.iter().filter(|tank| tank.open && hull.contains(&tank.carrier));
        u_tanks.chain(self.surfaces_of_flooded(flooded, plane, tangents)).collect()
    }

    fn surface_of_u_tank(&self, tank: &UTank, tangents: [Vector3; 2]) -> Option<FreeSurface> {
        let liquid = self.model.body(&tank.name)?;
        let (to_hull, mass) = (self.frame().inverse(), self.carried_weight().mass);
        let across = to_hull.rotation * self.at.world[tank.carrier].rotation.column(1);
        Some(FreeSurface {
            force: tank.name.clone(),
            body: self.model.bodies[tank.carrier].name.clone(),
            liquid_kg: tank.liquid.mass,
            keel_to_liquid_m: to_hull.point(self.at.world[liquid].position)[2] + self.database.hull.draught_m,
            correction_m: tangents.map(|t| tank.free_surface() * t.dot(across) * t.dot(across) / mass),
        })
    }

    /// Returns the free surfaces of tanks whose opening is under water: their area is subtracted from the
    /// waterplane, whose centre moves.
    fn surfaces_of_flooded<'b>(
        &self,
        tanks: impl Iterator<Item = &'b &'b FreeFloodingTank>,
        (area, centre): (f64, Vector3),
        tangents: [Vector3; 2],
    ) -> Vec<FreeSurface> {
        let (to_hull, mass) = (self.frame().inverse(), self.carried_weight().mass);
        let openings = tanks.map(|tank| (*tank, self.at.world[tank.carrier].point(tank.opening)));
        let under_water = openings.filter(|(_, opening)| opening[2] < 0.0);
        let flooded: Vec<_> = under_water.map(|(tank, opening)| (tank, to_hull.point(opening))).collect();
        let left_area = flooded.iter().fold(area, |left, (tank, _)| left - tank.column.area());
        let moment = flooded.iter().fold(centre * area, |left, (tank, place)| left - *place * tank.column.area());
        let left = if left_area > 0.0 { moment * (1.0 / left_area) } else { centre };
        let of = |(tank, place): &(&FreeFloodingTank, Vector3)| {
            let per_metre = tank.column.mass_per_metre();
            let liquid_kg = tank.column.mass() + tank.added(self.at).mass;
            FreeSurface {
                force: tank.name.clone(),
                body: self.model.bodies[tank.carrier].name.clone(),
                liquid_kg,
                keel_to_liquid_m: place[2] + self.database.hull.draught_m + 0.5 * liquid_kg / per_metre,
                correction_m: tangents.map(|t| per_metre * t.dot(*place - left) * t.dot(*place - centre) / mass),
            }
        };
        flooded.iter().map(of).collect()
    }
}
