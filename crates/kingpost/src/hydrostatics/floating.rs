//! A hull at rest in still water.

use super::hanging::{HangingLoad, Restraints, Weight, aboard, loads};
use super::liquids::{FreeSurface, Liquids};
use super::righting::{RightingArmCurve, Side};
use super::{HullAfloat, HydrostaticsError};
use crate::dynamics::Kinematics;
use crate::elements::SlackTank;
use crate::elements::hull::{Hull, Hydrostatics, LARGEST_LIST_DEG};
use crate::model::Model;
use crate::sea::database::Database;
use crate::sea::hull::{FloatingPosition, HullMesh, HullTank, Loading, StabilityError, WettedHull};
use crate::spatial::{Frame, Vector3};
use crate::world::World;

/// Largest difference of the draught from that of linear hydrodynamic data without a warning, as a share.
const LARGEST_DRAUGHT_CHANGE: f64 = 0.05;
/// Smallest heel or trim, deg, at which the bottom may come out of the water without a warning.
const LARGEST_ANGLE_DEG: f64 = 3.0;
/// Largest difference of the displacement from the mass without a warning, as a share of the mass.
const LARGEST_PULL: f64 = 1e-3;

/// A hull with its data, in a model at rest.
pub(super) struct LoadedHull<'a> {
    pub(super) hull: &'a Hull,
    pub(super) database: &'a Database,
    pub(super) model: &'a Model,
    pub(super) at: &'a Kinematics,
    pub(super) world: &'a World,
    /// All tanks of the model.
    pub(super) liquids: &'a Liquids<'a>,
    /// Restraints that keep loads from swinging.
    pub(super) restraints: &'a Restraints,
}

/// Submerged part of the hull, in the hull's axes about its origin.
struct Underwater {
    volume: f64,
    centre: Vector3,
    metacentric_radius: [f64; 2],
    waterplane_area: f64,
    centre_of_flotation: Vector3,
}

impl LoadedHull<'_> {
    /// Returns an error if the whole hull displaces less than its weight.
    pub(super) fn check_capacity(&self) -> Result<(), HydrostaticsError> {
        let Some(mesh) = self.mesh() else { return Ok(()) };
        let mass = self.carried_weight().mass;
        let (displacement_m3, largest_m3) = (mass / self.density(), mesh.volume());
        if displacement_m3 < largest_m3 {
            return Ok(());
        }
        let error = StabilityError::CannotFloat { mass_t: mass / 1000.0, displacement_m3, largest_m3 };
        Err(HydrostaticsError::Hull { force: self.hull.name.clone(), error })
    }

    /// Returns the floating position, if the hull floats, and warnings.
    pub(super) fn describe(&self) -> (Option<HullAfloat>, Vec<String>) {
        let (position, mesh) = (self.position(), self.mesh());
        let underwater = match &mesh {
            Some(mesh) => Underwater::of_mesh(mesh, &position),
            None => Underwater::of_waterplane(self.database, &position),
        };
        let name = &self.model.bodies[self.hull.frame.body].name;
        if matches!(self.hull.hydrostatics, Hydrostatics::None) {
            return (None, vec![format!("no hydrostatics of {name}: no buoyancy acts on it")]);
        }
        let Some(underwater) = underwater else {
            return (None, vec![format!("no hydrostatics of {name}: it rests above the water")]);
        };
        let hanging = self.hanging();
        let tanks = self.tanks(&hanging);
        let plane = (underwater.waterplane_area, underwater.centre_of_flotation);
        let levels = self.surfaces_of_levels(plane, tangents(position.vertical));
        let mut afloat = self.heights(&position, &underwater, &hanging, (&tanks, &levels));
        let mut warnings = self.warnings(&afloat);
        if let Some(mesh) = &mesh {
            match self.righting_arm(mesh, &position, &hanging, (&tanks, &levels)) {
                Ok(curve) => afloat.righting_arm = Some(curve),
                Err(error) => warnings.push(format!("{name}: no righting-arm curve: {error}")),
            }
        }
        afloat.hanging = hanging;
        afloat.by_mesh = mesh.is_some();
        (Some(afloat), warnings)
    }

    fn density(&self) -> f64 {
        self.world.water_density
    }

    /// Returns the mesh of the hull's data, if there is a valid one.
    fn mesh(&self) -> Option<HullMesh> {
        let mesh = self.database.hull.mesh.as_ref()?;
        HullMesh::new(mesh.vertices_m.clone(), mesh.triangles.clone()).ok()
    }

    /// Returns the frame of the hull's data in the world.
    pub(super) fn frame(&self) -> Frame {
        self.at.world[self.hull.frame.body].times(&Frame::translation(self.hull.frame.origin))
    }

    fn position(&self) -> FloatingPosition {
        FloatingPosition::of(&self.frame())
    }

    pub(super) fn carried_weight(&self) -> Weight {
        let aboard = aboard(self.model, self.at, self.hull.frame.body, self.restraints);
        let weight = self.restraints.weight(self.model, self.at, &aboard);
        self.liquids.with_flooding(weight, self.at, &aboard)
    }

    /// Returns the centre of gravity, with the liquid in slack tanks at its position in the upright hull;
    /// hull axes, from the data's origin, m.
    fn centre_of_gravity(&self) -> Vector3 {
        self.frame().inverse().point(self.carried_weight().centre)
    }

    fn hanging(&self) -> Vec<HangingLoad> {
        let frame = self.frame();
        let axes = tangents(self.position().vertical).map(|t| frame.rotation * t);
        // Heel rotates the vertical about the ship's longitudinal axis, in the transverse plane; trim rotates
        // it about the transverse axis.
        let [across, along] = axes;
        let all = loads(self.model, self.at, self.hull.frame.body, self.restraints, [along, across]);
        // In the model the liquid of a U-tank is a pendulum; for stability it is two free surfaces.
        all.into_iter().filter(|load| self.liquids.u_tanks.iter().all(|tank| tank.name != load.body)).collect()
    }

    fn heights(
        &self,
        position: &FloatingPosition,
        water: &Underwater,
        hanging: &[HangingLoad],
        (tanks, levels): (&[(&SlackTank, HullTank)], &[FreeSurface]),
    ) -> HullAfloat {
        let (vertical, draught) = (position.vertical, self.database.hull.draught_m);
        let [heel_rad, trim_rad] = heel_and_trim(vertical);
        let (mass, gravity) =
            (self.carried_weight().mass, self.centre_of_gravity() + self.liquid_shift(tanks, vertical));
        let slack = self.free_surfaces(tanks, vertical, tangents(vertical));
        let free_surfaces: Vec<FreeSurface> = slack.into_iter().chain(levels.iter().cloned()).collect();
        let of_surfaces = [0, 1].map(|k| free_surfaces.iter().map(|surface| surface.correction_m[k]).sum::<f64>());
        let of_loads = rise_of(hanging, mass);
        let rise = [0, 1].map(|k| of_loads[k] + of_surfaces[k]);
        let solid = water.metacentric_radius.map(|radius| radius + (water.centre - gravity).dot(vertical));
        HullAfloat {
            force: self.hull.name.clone(),
            body: self.model.bodies[self.hull.frame.body].name.clone(),
            mass_kg: mass,
            displacement_kg: water.volume * self.density(),
            displacement_m3: water.volume,
            draught_m: vertical[2] * draught - position.height,
            database_draught_m: draught,
            heel_rad,
            trim_rad,
            keel_to_buoyancy_m: water.centre[2] + draught,
            metacentric_radius_m: water.metacentric_radius,
            keel_to_metacentre_m: water.metacentric_radius.map(|radius| water.centre[2] + draught + radius),
            keel_to_gravity_m: gravity[2] + draught,
            fluid_keel_to_gravity_m: rise.map(|rise| gravity[2] + draught + rise),
            solid_metacentric_height_m: solid,
            metacentric_height_m: [solid[0] - rise[0], solid[1] - rise[1]],
            hanging: Vec::new(),
            free_surfaces,
            righting_arm: None,
            by_mesh: false,
            rests_by_mesh: matches!(self.hull.hydrostatics, Hydrostatics::Mesh(_)),
        }
    }

    /// Returns the warnings about a hull: outside the range of its linear data, bottom out of the water at
    /// small angles, displacement different from mass, GM not positive.
    fn warnings(&self, hull: &HullAfloat) -> Vec<String> {
        let mut warnings = if self.hull.is_linear() { self.off_the_database(hull) } else { Vec::new() };
        let (body, draught) = (&hull.body, hull.draught_m);
        let [length, beam] = [self.database.hull.length_m, self.database.hull.beam_m];
        let out_at = [beam, length].map(|size| libm::atan2(2.0 * draught, size).to_degrees());
        if out_at.iter().any(|angle| *angle < LARGEST_ANGLE_DEG) {
            warnings.push(format!(
                "{body}: it floats at {draught:.4} m: its bottom comes out of the water at about {:.2} deg of heel \
                 or {:.2} deg of trim (warned of below {LARGEST_ANGLE_DEG} deg)",
                out_at[0], out_at[1]
            ));
        }
        if (hull.displacement_kg - hull.mass_kg).abs() > LARGEST_PULL * hull.mass_kg {
            warnings.push(format!(
                "{body}: it displaces {:.3} t and weighs {:.3} t: other forces that carry or pull it, as of moorings and lines over sheaves, are not included in KG, GM and GZ",
                hull.displacement_kg / 1000.0,
                hull.mass_kg / 1000.0
            ));
        }
        if hull.metacentric_height_m[0] <= 0.0 {
            warnings.push(format!("{body}: GM is {:.3} m: it is not stable", hull.metacentric_height_m[0]));
        }
        warnings
    }

    fn off_the_database(&self, hull: &HullAfloat) -> Vec<String> {
        let mut warnings = Vec::new();
        let (body, draught, database) = (&hull.body, hull.draught_m, hull.database_draught_m);
        let change = (draught - database).abs() / database;
        let about = match self.database.hull.attitude {
            Some(_) => "linear hydrodynamics hold near the database's draught and attitude",
            None => "linear hydrodynamics hold near the database's draught, upright",
        };
        if change > LARGEST_DRAUGHT_CHANGE {
            warnings.push(format!(
                "{body}: draught {draught:.4} m, the database's is {database:.4} m, {:.1} % apart: {about} (warned of \
                 beyond {:.0} %)",
                100.0 * change,
                100.0 * LARGEST_DRAUGHT_CHANGE
            ));
        }
        let of_coefficients = self.at.world[self.hull.frame.body].times(&self.hull.coordinates.coefficients.in_body);
        let [heel, trim] = heel_and_trim(FloatingPosition::of(&of_coefficients).vertical);
        let end = if trim < 0.0 { "by the stern" } else { "by the bow" };
        let side = format!("to {}", Side::of(heel).name());
        for (what, angle, sense) in [("heel", heel, side.as_str()), ("trim", trim, end)] {
            let angle = angle.to_degrees().abs();
            if angle > LARGEST_LIST_DEG {
                let limit = format!("warned of beyond {LARGEST_LIST_DEG} deg");
                warnings.push(format!("{body}: {what} {angle:.2} deg {sense}: {about} ({limit})"));
            }
        }
        warnings
    }

    /// Returns GZ with the centre of gravity raised by hanging loads and by the levels of U-tanks and
    /// free-flooding tanks; the liquid in slack tanks is level at each heel.
    fn righting_arm(
        &self,
        mesh: &HullMesh,
        position: &FloatingPosition,
        hanging: &[HangingLoad],
        (tanks, levels): (&[(&SlackTank, HullTank)], &[FreeSurface]),
    ) -> Result<RightingArmCurve, StabilityError> {
        let mass = self.carried_weight().mass;
        let rise = rise_of(hanging, mass)[0] + levels.iter().map(|surface| surface.correction_m[0]).sum::<f64>();
        let loading = Loading {
            mass,
            centre_of_gravity: self.centre_of_gravity() + position.vertical * rise,
            water_density: self.density(),
        };
        let tanks: Vec<HullTank> = tanks.iter().map(|(_, tank)| *tank).collect();
        let heel_rad = libm::atan2(position.vertical[1], position.vertical[2]);
        RightingArmCurve::of(mesh, &loading, &tanks, heel_rad)
    }
}

/// Returns heel and trim for a vertical in hull axes, rad.
fn heel_and_trim(vertical: Vector3) -> [f64; 2] {
    [libm::atan2(vertical[1], vertical[2]), libm::atan2(-vertical[0], libm::hypot(vertical[1], vertical[2]))]
}

/// Returns the rise of the total centre of gravity by hanging loads, for heel and for trim, m.
fn rise_of(hanging: &[HangingLoad], mass: f64) -> [f64; 2] {
    [0, 1].map(|k| {
        let moments = hanging.iter().map(|load| load.mass_kg * load.length_m * load.free_share[k]);
        moments.sum::<f64>() / mass
    })
}

impl Underwater {
    fn of_mesh(mesh: &HullMesh, position: &FloatingPosition) -> Option<Self> {
        let mut wetted = WettedHull::new(mesh);
        let (buoyancy, waterplane) = (wetted.buoyancy(mesh, position), wetted.waterplane(mesh, position));
        let volume = buoyancy.volume;
        (volume > 0.0).then(|| Self {
            volume,
            centre: buoyancy.centre(),
            metacentric_radius: tangents(position.vertical).map(|t| waterplane.second_moment(t, t) / volume),
            waterplane_area: waterplane.area,
            centre_of_flotation: waterplane.centre(),
        })
    }

    /// Returns the submerged part of a wall-sided hull with the waterplane of its data, for small angles:
    /// sinkage adds a layer with the area of this waterplane.
    fn of_waterplane(database: &Database, position: &FloatingPosition) -> Option<Self> {
        let (hull, plane) = (&database.hull, &database.hull.waterplane);
        let ([x, y], [xx, _, yy]) = (plane.first_moments_m3, plane.second_moments_m4);
        let (area, sinkage) = (plane.area_m2, -position.height);
        let volume = hull.volume_m3 + area * sinkage;
        let strake = Vector3::new(x * sinkage, y * sinkage, 0.5 * area * sinkage * sinkage);
        let moment = Vector3(hull.centre_of_buoyancy_m) * hull.volume_m3 + strake;
        (volume > 0.0).then(|| Self {
            volume,
            centre: moment * (1.0 / volume),
            metacentric_radius: [(yy - y * y / area) / volume, (xx - x * x / area) / volume],
            waterplane_area: area,
            centre_of_flotation: Vector3::new(x / area, y / area, 0.0),
        })
    }
}

/// Returns unit vectors in the water's plane, across and along the ship, in hull axes.
fn tangents(vertical: Vector3) -> [Vector3; 2] {
    let along = (Vector3::new(1.0, 0.0, 0.0) - vertical * vertical[0]).direction();
    [vertical.cross(along), along]
}
