//! Hulls in still water: closed forms, gradients, stability, and what is no hull.

#[allow(dead_code)] // the tests of forces use the rest
#[path = "common/hulls.rs"]
mod hulls;

use hulls::barge;
use kingpost::sea::hull::{FloatingPosition, HullMesh, WettedHull};
use kingpost::spatial::Vector3;

fn close(found: f64, expected: f64, relative: f64) {
    let allowed = relative * expected.abs().max(1e-300);
    assert!((found - expected).abs() <= allowed, "{found} instead of {expected}");
}

fn near(found: f64, expected: f64, allowed: f64) {
    assert!((found - expected).abs() <= allowed, "{found} instead of {expected}");
}

/// The box of the closed forms: 20 x 10 x 4 m at draught 2 m, origin amidships on the water plane.
fn box_barge(divisions: usize) -> HullMesh {
    barge(20.0, 10.0, 4.0, 2.0, divisions)
}

#[test]
fn a_box_displaces_its_length_by_its_beam_by_its_draught() {
    for divisions in [1, 3, 9] {
        let mesh = box_barge(divisions);
        let mut wetted = WettedHull::new(&mesh);
        for height in [-1.9, -0.3, 0.0, 0.7, 1.99] {
            let draught = 2.0 - height;
            let position = FloatingPosition::upright(height);
            let (buoyancy, waterplane) = (wetted.buoyancy(&mesh, &position), wetted.waterplane(&mesh, &position));
            close(buoyancy.volume, 200.0 * draught, 1e-14);
            close(buoyancy.height_moment, -100.0 * draught * draught, 1e-13);
            near((buoyancy.centre() - Vector3::new(0.0, 0.0, -2.0 + 0.5 * draught)).norm(), 0.0, 1e-13);
            close(waterplane.area, 200.0, 1e-14);
            close(waterplane.second_moments.xx, 20.0 * 20.0 * 20.0 * 10.0 / 12.0, 1e-13);
            close(waterplane.second_moments.yy, 20.0 * 10.0 * 10.0 * 10.0 / 12.0, 1e-13);
            near(waterplane.second_moments.xy, 0.0, 1e-11);
            near(waterplane.first_moments[0].abs() + waterplane.first_moments[1].abs(), 0.0, 1e-12);
            close(waterplane.first_moments[2], -height * 200.0, 1e-13);
        }
        close(mesh.volume(), 800.0, 1e-14);
    }
}
