//! The elastic catenary: the shape and the forces of a line between its ends.

use crate::scalar::Scalar;

/// A uniform elastic line that hangs from its upper end to its lower one, in the vertical plane through both.
///
/// With the horizontal force H and the vertical force V at the upper end, the tension at the unstretched length s from
/// the upper end is T = sqrt(H^2 + v^2), v = V - w s. The length L_s hangs, with v from V to v_a = V - w L_s, and the
/// rest of L lies on the seabed, without friction:
///
/// ```text
/// x = L - L_s + H/w [asinh(V/H) - asinh(v_a/H)] + H L / EA
/// z = L_s (V + v_a) [1 / (T + T_a) + 1 / 2EA],     L_s = min(V/w, L) on a seabed, else L
/// ```
///
/// (Irvine, *Cable Structures*, 1981, ch. 1; Jonkman, NREL/TP-500-41958, 2007, eqs. 2-35 to 2-38, equivalent by (V^2 -
/// v_a^2) / w = L_s (V + v_a)). x and z are the derivatives of the complementary energy with respect to H and V,
///
/// ```text
/// C(H, V) = Integral (T + T^2 / 2EA) ds = (L - L_s) (H + H^2 / 2EA) + ...
/// ```
///
/// which is convex: for given ends the forces are unique, and Newton's method finds them. The energy of weight and
/// stretch is then U = H x + V z - C, relative to the unstretched line at the height of its lower end, and its gradient
/// along x and z is (H, V).
#[derive(Clone, Copy, Debug)]
pub struct Catenary<S = f64> {
    /// L without tension, m.
    pub unstretched_length: S,
    /// w, weight in water per unstretched length, N/m.
    pub weight: S,
    /// EA, N.
    pub axial_stiffness: S,
    /// Whether the line can lie on a flat seabed at its lower end.
    pub on_seabed: bool,
}

/// Vector from the lower end to the upper end, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span<S = f64> {
    /// x, horizontally; positive.
    pub across: S,
    /// z, upwards.
    pub up: S,
}

/// The force that holds the upper end, N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndForce<S = f64> {
    /// H, away from the lower end.
    pub horizontal: S,
    /// V, upwards.
    pub vertical: S,
}

/// Lengths and forces of the hanging part of a line and of the part on the seabed.
struct HangingPart<S> {
    /// L_s, m.
    length: S,
    /// L - L_s, m.
    grounded: S,
    /// v_a, N.
    lower_vertical: S,
    /// T, N.
    tension: S,
    /// T_a, N.
    lower_tension: S,
    /// asinh(V/H) - asinh(v_a/H).
    turn: S,
}

/// Smallest horizontal force with which a line is drawn, as a share of its weight.
const LEAST_PULL: f64 = 1e-6;
/// Largest number of iterations; 6 are usual.
const MOST_ITERATIONS: usize = 200;
/// Error of the end positions, relative to all lengths, that counts as 0.
const ROUNDING: f64 = 1e-13;
/// Smallest factor by which an iteration may reduce a force.
const LEAST_LEFT: f64 = 0.1;
/// Smallest height of the upper end above the seabed, as a share of the length: at 0 the line's stiffness is infinite.
const LEAST_HEIGHT: f64 = 1e-9;

impl<S: Scalar> Catenary<S> {
    /// Returns the span under a force; H must be positive.
    pub fn span(&self, force: &EndForce<S>) -> Span<S> {
        let hanging = self.hanging(force);
        let EndForce { horizontal, vertical } = *force;
        let slack = horizontal / self.weight * hanging.turn;
        let stretch = horizontal * self.unstretched_length / self.axial_stiffness;
        let sum = hanging.length * (vertical + hanging.lower_vertical);
        Span {
            across: hanging.grounded + slack + stretch,
            up: sum / (hanging.tension + hanging.lower_tension) + sum * half() / self.axial_stiffness,
        }
    }

    /// Returns the force for given ends. If the line lies slack on a seabed, the horizontal force is 0. NaN if an end
    /// is NaN.
    pub fn force(&self, span: &Span<S>) -> EndForce<S> {
        let span = self.above_seabed(span);
        let Self { unstretched_length, weight, axial_stiffness, on_seabed } = *self;
        let given = [span.across, span.up, unstretched_length, weight, axial_stiffness];
        let [horizontal, vertical] = S::from_values(given, &|[across, up, length, weight, stiffness]| {
            let line = Catenary { unstretched_length: length, weight, axial_stiffness: stiffness, on_seabed };
            let EndForce { horizontal, vertical } = line.iterate(&Span { across, up });
            [horizontal, vertical]
        });
        let pulls = horizontal.select_below(f64::MIN_POSITIVE, || S::ZERO, || S::ONE);
        let or = |other: S, value: S| pulls.select_below(0.5, || other, || value);
        // A last Newton step carries the derivatives.
        let found = EndForce { horizontal: or(S::ONE, horizontal), vertical };
        let step = self.newton_step(&found, &span);
        EndForce {
            horizontal: or(S::ZERO, found.horizontal + step.horizontal),
            vertical: or(self.hanging_weight(span.up), found.vertical + step.vertical),
        }
    }

    /// Returns the energy of weight and stretch, J, for the ends and their force.
    pub fn potential_energy(&self, span: &Span<S>, force: &EndForce<S>) -> S {
        let span = self.above_seabed(span);
        let slack = force.horizontal.select_below(f64::MIN_POSITIVE, || S::ONE, || S::ZERO);
        let or = |other: S, value: S| slack.select_below(0.5, || value, || other);
        let at = EndForce { horizontal: or(S::ONE, force.horizontal), vertical: force.vertical };
        let hanging = self.hanging(&at);
        let (h, v, v_a) = (force.horizontal, force.vertical, hanging.lower_vertical);
        // If H is 0, the tension at the lower end is 0.
        let tension = or(v, hanging.tension);
        let height = hanging.length * (v + v_a) / (tension + or(S::ZERO, hanging.lower_tension));
        let of_weight = hanging.length * tension + v_a * height + h * h / self.weight * hanging.turn;
        let of_stretch = hanging.length * (h * h + (v * v + v * v_a + v_a * v_a) * S::constant(1.0 / 3.0));
        let complementary = hanging.grounded * h
            + of_weight * half()
            + (of_stretch + hanging.grounded * h * h) * half() / self.axial_stiffness;
        h * span.across + v * span.up - complementary
    }

    /// Returns the tension at the upper and at the lower end (N), and the length on the seabed (m).
    pub fn tensions(&self, force: &EndForce<S>) -> [S; 3] {
        let hanging = self.hanging(force);
        [hanging.tension, hanging.lower_tension, hanging.grounded]
    }

    /// Returns the position, relative to the lower end, of the point at this share of the unstretched length, under the
    /// force that holds the upper end at `span`. The part below a point is a catenary with the vertical force at that
    /// point.
    pub fn place(&self, force: &EndForce<S>, span: &Span<S>, share: S) -> Span<S> {
        // Without a horizontal force the line hangs straight down: a small force gives that shape.
        let least = self.weight * self.unstretched_length * S::constant(LEAST_PULL);
        let horizontal = force.horizontal.select_less(least, || least, || force.horizontal);
        let below = |share: S| {
            let part = Self { unstretched_length: self.unstretched_length * share, ..*self };
            let vertical = force.vertical - self.weight * self.unstretched_length * (S::ONE - share);
            let lies = if self.on_seabed { vertical.select_below(0.0, || S::ONE, || S::ZERO) } else { S::ZERO };
            part.span(&EndForce { horizontal, vertical: lies.select_below(0.5, || vertical, || S::ZERO) })
        };
        let (point, top) = (below(share), below(S::ONE));
        // The shape must end at the upper end: the error at this end is distributed along the line.
        let along = point.across / top.across;
        Span { across: along * span.across, up: point.up + along * (span.up - top.up) }
    }

    fn hanging(&self, force: &EndForce<S>) -> HangingPart<S> {
        let EndForce { horizontal: h, vertical: v } = *force;
        let free = v - self.weight * self.unstretched_length;
        let lies = if self.on_seabed { free.select_below(0.0, || S::ONE, || S::ZERO) } else { S::ZERO };
        let or = |hangs: S, lying: S| lies.select_below(0.5, || hangs, || lying);
        let lower_vertical = or(free, S::ZERO);
        let length = or(self.unstretched_length, v / self.weight);
        let tension = (h * h + v * v).sqrt();
        let lower_tension = or((h * h + lower_vertical * lower_vertical).sqrt(), h);
        let weight = self.weight * length;
        // Each form is used in the range where it has no cancellation.
        let turn = (v * lower_vertical).select_below(
            0.0,
            || asinh(v / h) + asinh(-lower_vertical / h),
            || (weight * S::constant(2.0) / (tension + lower_tension - weight)).ln_1p(),
        );
        HangingPart { length, grounded: self.unstretched_length - length, lower_vertical, tension, lower_tension, turn }
    }

    /// Returns the Newton step of the force for these ends.
    fn newton_step(&self, force: &EndForce<S>, span: &Span<S>) -> EndForce<S> {
        let at = self.span(force);
        let (across, up) = (span.across - at.across, span.up - at.up);
        let [xx, xz, zz] = self.compliance(force);
        let determinant = xx * zz - xz * xz;
        EndForce { horizontal: (zz * across - xz * up) / determinant, vertical: (xx * up - xz * across) / determinant }
    }

    /// Returns the second derivatives of C: dx/dH, dx/dV = dz/dH, dz/dV, m/N.
    pub fn compliance(&self, force: &EndForce<S>) -> [S; 3] {
        let hanging = self.hanging(force);
        let EndForce { horizontal: h, vertical: v } = *force;
        let (t, t_a, v_a) = (hanging.tension, hanging.lower_tension, hanging.lower_vertical);
        let rise = v / t - v_a / t_a;
        [
            (hanging.turn - rise) / self.weight + self.unstretched_length / self.axial_stiffness,
            h / self.weight * (S::ONE / t - S::ONE / t_a),
            rise / self.weight + hanging.length / self.axial_stiffness,
        ]
    }

    /// Returns the force at the top of a vertical line of this height: z = V / w + V^2 / 2 EA w.
    fn hanging_weight(&self, up: S) -> S {
        let weight = self.weight * up * S::constant(2.0);
        weight / (S::ONE + (S::ONE + weight / self.axial_stiffness).sqrt())
    }

    /// Returns the span with an upper end below the seabed moved onto it.
    fn above_seabed(&self, span: &Span<S>) -> Span<S> {
        if !self.on_seabed {
            return *span;
        }
        let least = self.unstretched_length * S::constant(LEAST_HEIGHT);
        Span { up: span.up.select_less(least, || least, || span.up), ..*span }
    }
}

impl Catenary {
    fn iterate(&self, span: &Span) -> EndForce {
        let hanging_weight = self.hanging_weight(span.up);
        let lying = self.unstretched_length - hanging_weight / self.weight;
        if self.on_seabed && lying >= span.across {
            return EndForce { horizontal: 0.0, vertical: hanging_weight };
        }
        let mut force = self.guess(span);
        let rounding = ROUNDING * (self.unstretched_length + span.across + span.up.abs());
        for _ in 0..MOST_ITERATIONS {
            let at = self.span(&force);
            if (at.across - span.across).abs() + (at.up - span.up).abs() <= rounding {
                return force;
            }
            force = self.improved(&force, span);
        }
        EndForce { horizontal: f64::NAN, vertical: f64::NAN }
    }

    /// Takes one Newton step towards the minimum of C - H x - V z, which is convex. The step is shortened if it would
    /// leave the admissible forces or increase the function.
    fn improved(&self, force: &EndForce, span: &Span) -> EndForce {
        let step = self.newton_step(force, span);
        let after = |share: f64| EndForce {
            horizontal: force.horizontal + share * step.horizontal,
            vertical: force.vertical + share * step.vertical,
        };
        let slope = |at: &EndForce| {
            let there = self.span(at);
            (there.across - span.across) * step.horizontal + (there.up - span.up) * step.vertical
        };
        let keeps = |before: f64, after: f64| after >= LEAST_LEFT * before;
        let allowed = |at: &EndForce| {
            keeps(force.horizontal, at.horizontal) && (!self.on_seabed || keeps(force.vertical, at.vertical))
        };
        let downhill = slope(force);
        let mut share = 1.0;
        while share > f64::EPSILON && !(allowed(&after(share)) && slope(&after(share)) <= -0.5 * downhill) {
            share *= 0.5;
        }
        after(share)
    }

    /// Returns Jonkman's initial guess (2007, eqs. 2-39 and 2-40).
    fn guess(&self, span: &Span) -> EndForce {
        let (x, z, length) = (span.across, span.up, self.unstretched_length);
        let excess = (length * length - z * z) / (x * x) - 1.0;
        let sag = libm::sqrt(3.0 * excess.max(0.0)).max(0.2);
        EndForce {
            horizontal: 0.5 * self.weight * x / sag,
            vertical: 0.5 * self.weight * (z / libm::tanh(sag) + length),
        }
    }
}

fn half<S: Scalar>() -> S {
    S::constant(0.5)
}

/// Returns asinh of an argument that is not negative.
fn asinh<S: Scalar>(x: S) -> S {
    let size = x.select_below(0.0, || -x, || x);
    let of_size = (size + size * size / (S::ONE + (S::ONE + size * size).sqrt())).ln_1p();
    x.select_below(0.0, || -of_size, || of_size)
}
