//! The elastic catenary against closed forms, its energy, and a published mooring.

use kingpost::elements::lines::{Catenary, EndForce, Span};
use kingpost::scalar::{Dual, LANES, Lanes, Scalar};

const LENGTH: f64 = 100.0;
const WEIGHT: f64 = 200.0;

fn line(axial_stiffness: f64, on_seabed: bool) -> Catenary {
    Catenary { unstretched_length: LENGTH, weight: WEIGHT, axial_stiffness, on_seabed }
}

/// Spans from slack to taut, the upper end above the lower one.
fn spans() -> impl Iterator<Item = Span> {
    let heights = [0.5, 20.0, 60.0, 99.0, 110.0];
    heights.into_iter().flat_map(|up| [1e-3, 5.0, 45.0, 79.0, 82.0, 99.5, 130.0].map(|across| Span { across, up }))
}

/// Without stretch: `z = a (cosh(x_s/a) - 1)`, `L_s = a sinh(x_s/a)`, a = H/w; the remainder of L lies on the
/// seabed.
#[test]
fn an_inextensible_line_is_the_textbook_catenary() {
    for a in [3.0, 20.0, 90.0] {
        for turn in [0.2, 0.5, 0.8] {
            let (hangs, rises) = (a * libm::sinh(turn), a * (libm::cosh(turn) - 1.0));
            let span = Span { across: LENGTH - hangs + a * turn, up: rises };
            let EndForce { horizontal, vertical } = line(1e17, true).force(&span);
            // The geometry is known to rounding; the force by its stiffness.
            assert!((horizontal - WEIGHT * a).abs() < 1e-9 * WEIGHT * LENGTH, "{horizontal} {a}");
            assert!((vertical - WEIGHT * hangs).abs() < 1e-9 * WEIGHT * LENGTH);
            let [tension, end_tension, grounded] = line(1e17, true).tensions(&EndForce { horizontal, vertical });
            assert!((tension - WEIGHT * (a + rises)).abs() < 1e-9 * WEIGHT * LENGTH, "T = H + w z");
            assert!((end_tension - horizontal).abs() < 1e-9 && (grounded - LENGTH + hangs).abs() < 1e-9 * LENGTH);
        }
    }
    // Between two points at one height: L = 2 a sinh(x / 2a).
    let a = 70.0;
    let half_span = a * libm::log(LENGTH / 2.0 / a + libm::sqrt(1.0 + LENGTH * LENGTH / 4.0 / a / a));
    let force = line(1e17, false).force(&Span { across: 2.0 * half_span, up: 0.0 });
    assert!((force.horizontal - WEIGHT * a).abs() < 1e-8 * WEIGHT * LENGTH);
    assert!((force.vertical - WEIGHT * LENGTH / 2.0).abs() < 1e-8 * WEIGHT * LENGTH);
}

#[test]
fn the_computed_force_places_the_ends_at_their_positions() {
    for stiffness in [3e4, 1e6, 1e9] {
        for (span, on_seabed) in spans().flat_map(|span| [(span, true), (span, false)]) {
            let line = line(stiffness, on_seabed);
            let force = line.force(&span);
            if force.horizontal > 0.0 {
                let back = line.span(&force);
                let error = (back.across - span.across).abs() + (back.up - span.up).abs();
                assert!(error < 1e-12 * LENGTH, "{span:?} {force:?} {back:?}");
            }
        }
    }
}

/// Irvine's straight line: T = EA (d / L - 1), if its weight is negligible.
#[test]
fn a_taut_line_is_a_spring() {
    let light = Catenary { weight: 1e-3, ..line(5e6, true) };
    let EndForce { horizontal, vertical } = light.force(&Span { across: 84.0, up: 63.0 });
    let tension = 5e6 * (105.0 / 100.0 - 1.0);
    // Weight bends by (w L / T)^2 / 24, and shares itself between the ends.
    assert!((horizontal - 0.8 * tension).abs() < 1e-6 * tension && (vertical - 0.6 * tension).abs() < 0.1);
}

/// H = dU/dx, V = dU/dz by dual numbers, in every state of the line.
#[test]
fn the_force_is_the_gradient_of_the_energy() {
    for stiffness in [3e4, 1e6, 1e9] {
        for (span, on_seabed) in spans().flat_map(|span| [(span, true), (span, false)]) {
            let of = line(stiffness, on_seabed);
            let c = Dual::<2>::constant;
            let dual =
                Catenary { unstretched_length: c(LENGTH), weight: c(WEIGHT), axial_stiffness: c(stiffness), on_seabed };
            let span = Span { across: Dual::<2>::variable(span.across, 0), up: Dual::variable(span.up, 1) };
            let force = dual.force(&span);
            let gradient = dual.potential_energy(&span, &force).derivative;
            let size = WEIGHT * LENGTH + force.horizontal.value;
            for (slope, force) in gradient.iter().zip([force.horizontal.value, force.vertical.value]) {
                assert!((slope - force).abs() < 1e-11 * size, "{span:?} {gradient:?} {force}");
            }
            // And the derivative of the force is that of differences.
            let h = 1e-5;
            for (k, [across, up]) in [[h, 0.0], [0.0, h]].into_iter().enumerate() {
                let at = |by: f64| {
                    let span = Span { across: span.across.value + by * across, up: span.up.value + by * up };
                    of.force(&span)
                };
                let (ahead, behind) = (at(1.0), at(-1.0));
                let stiff =
                    stiffness / LENGTH + force.horizontal.derivative[0].abs() + force.vertical.derivative[1].abs();
                for (exact, difference) in [
                    (force.horizontal, ahead.horizontal - behind.horizontal),
                    (force.vertical, ahead.vertical - behind.vertical),
                ] {
                    assert!(
                        (exact.derivative[k] - difference / (2.0 * h)).abs() < 1e-4 * stiff,
                        "{span:?} {on_seabed}"
                    );
                }
            }
        }
    }
}

/// U = Integral (w z + T^2 / 2EA) ds along the line, whose height is (T - T_a) / w + (v^2 - v_a^2) / 2 EA w, by Simpson.
#[test]
fn the_energy_is_that_of_weight_and_stretch() {
    for (span, on_seabed) in spans().flat_map(|span| [(span, true), (span, false)]) {
        let stiffness = 1e6;
        let line = line(stiffness, on_seabed);
        let force = line.force(&span);
        let hangs = if on_seabed { (force.vertical / WEIGHT).min(LENGTH) } else { LENGTH };
        let lower = force.vertical - WEIGHT * hangs;
        let tension = |v: f64| libm::hypot(force.horizontal, v);
        let density = |s: f64| {
            let v = lower + WEIGHT * s;
            let height = tension(v) - tension(lower) + (v * v - lower * lower) / (2.0 * stiffness);
            height + tension(v) * tension(v) / (2.0 * stiffness)
        };
        let (n, mut sum) = (20_000, 0.0);
        for k in 0..n {
            let [a, b] = [k, k + 1].map(|k| hangs * f64::from(k) / f64::from(n));
            sum += (b - a) / 6.0 * (density(a) + 4.0 * density(0.5 * (a + b)) + density(b));
        }
        let lies = (LENGTH - hangs) * force.horizontal * force.horizontal / (2.0 * stiffness);
        let energy = line.potential_energy(&span, &force);
        // A nearly vertical bend at the bottom of a slack line is narrower than the strips.
        assert!((energy - sum - lies).abs() < 1e-7 * WEIGHT * LENGTH * LENGTH, "{span:?} {energy} {sum} {lies}");
    }
}

/// At touchdown of the whole line and where it becomes slack, force and stiffness are continuous although the
/// formulas change.
#[test]
fn nothing_jumps_where_the_line_lifts_off_or_goes_slack() {
    let lifts = line(1e6, true).span(&EndForce { horizontal: 8000.0, vertical: WEIGHT * LENGTH });
    let above = |by: f64| line(1e6, true).force(&Span { up: lifts.up + by, ..lifts });
    let below = 60.0;
    let slack = LENGTH - below * WEIGHT / WEIGHT;
    let away = |by: f64| {
        let up = below + WEIGHT * below * below / 2.0 / 1e6;
        line(1e6, true).force(&Span { across: slack + by, up })
    };
    for by in [1e-4, 1e-6, 1e-8] {
        let jump = above(by).horizontal - above(-by).horizontal;
        assert!(jump > 0.0 && jump < 2e5 * by);
        assert!((above(by).vertical - above(-by).vertical - jump).abs() < 2e5 * by);
        assert_eq!(away(-by), EndForce { horizontal: 0.0, vertical: WEIGHT * below });
        // x - L + L_s = H/w asinh(V/H) + H L/EA: less than w over the logarithm of 2 V / H.
        assert!(away(by).horizontal > 0.0 && away(by).horizontal < WEIGHT * by);
        assert!((away(by).vertical - WEIGHT * below).abs() < WEIGHT * by);
    }
}

/// Each lane is bitwise identical to a single run.
#[test]
fn lanes_of_slack_and_taut_lines_are_bitwise_identical_to_single_lines() {
    let all: Vec<Span> = spans().collect();
    for four in all.chunks_exact(LANES) {
        let c = Lanes::constant;
        let lanes =
            Catenary { unstretched_length: c(LENGTH), weight: c(WEIGHT), axial_stiffness: c(1e6), on_seabed: true };
        let across = Lanes::new(core::array::from_fn(|k| four[k].across));
        let span = Span { across, up: Lanes::new(core::array::from_fn(|k| four[k].up)) };
        let force = lanes.force(&span);
        let energy = lanes.potential_energy(&span, &force).to_array();
        for (k, span) in four.iter().enumerate() {
            let alone = line(1e6, true).force(span);
            assert_eq!(force.horizontal.to_array()[k].to_bits(), alone.horizontal.to_bits());
            assert_eq!(force.vertical.to_array()[k].to_bits(), alone.vertical.to_bits());
            assert_eq!(energy[k].to_bits(), line(1e6, true).potential_energy(span, &alone).to_bits());
        }
    }
}

/// Three lines of the spar of OC3 (Jonkman, NREL/TP-500-47535, 2010, table 5-1): 902.2 m long, 698.094 N/m in
/// water, EA 384.243 MN, fairleads at radius 5.2 m and 70 m down, anchors at radius 853.87 m and 320 m down. Its sec. 5.3
/// gives the mooring's load and stiffness at rest: 1607 kN down, 41.18 kN/m in surge, 11.94 kN/m in heave.
#[test]
fn the_mooring_of_the_oc3_spar_has_its_published_stiffness() {
    let c = Dual::<2>::constant;
    let line =
        Catenary { unstretched_length: c(902.2), weight: c(698.094), axial_stiffness: c(384.243e6), on_seabed: true };
    let span = Span { across: Dual::variable(853.87 - 5.2, 0), up: Dual::variable(250.0, 1) };
    let EndForce { horizontal, vertical } = line.force(&span);
    let surge = 1.5 * (horizontal.derivative[0] + horizontal.value / span.across.value);
    let figures = [(3.0 * vertical.value, 1607e3), (surge, 41.18e3), (3.0 * vertical.derivative[1], 11.94e3)];
    for (found, published) in figures {
        // As many figures as are printed, and the report's own differences.
        assert!((found / published - 1.0).abs() < 5e-3, "{found} {published}");
    }
}
