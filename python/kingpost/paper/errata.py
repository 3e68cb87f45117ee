"""Differences between the paper's text and the physics.

Equations are LaTeX in the paper's notation; S(a) is the skew matrix of a, and the paper's axes
are 1 athwartship, 2 up, 3 along the ship.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from .equations import EQUATIONS
from .figures import DURATION_S
from .measured import PRINTED_AT_S, Measured


@dataclass(frozen=True)
class Erratum:
    """One remark: HTML text with equations as printed and as corrected."""

    title: str
    text: str
    printed: list[str] = field(default_factory=list)
    corrected: list[str] = field(default_factory=list)


def power(value: float) -> str:
    """A small number in HTML, as a power of ten.

    >>> power(2.3e-11)
    '2 \u00d7 10<sup>\u221211</sup>'
    """
    digit, exponent = f"{value:.0e}".split("e")
    return f"{digit} \u00d7 10<sup>{int(exponent)}</sup>".replace("-", "\u2212")


def errata(m: Measured) -> list[Erratum]:
    """The ten remarks, with numbers measured by the engine."""
    return [*_kinematics(m), *_statements(m), _names(), _figure_9(m), _figure_10(m), _smaller()]


def _kinematics(m: Measured) -> list[Erratum]:
    return [
        Erratum(
            "Eq. 43: the velocity of the arm's centre",
            "The last term must reach from the ship's centre to the tower's centre; the printed term "
            "starts at the tower's foot. With the crane at the ship's centre the two agree. With the "
            f"crane in the stern corner and both motors on for {PRINTED_AT_S:g} s, the printed form is off "
            f"by {m.eq_43_m_s:.2f} m/s where the arm's centre moves at {m.arm_m_s:.2f} m/s; the "
            f"corrected form agrees with the engine to {power(m.corrected_m_s)} m/s.",
            EQUATIONS["43"].printed,
            EQUATIONS["43"].corrected,
        ),
        Erratum(
            "Eq. 46b: the block B52",
            "The arm's own offset is meant in the first term and the tower's in the last, and the two "
            "transposes stand in the wrong order.",
            EQUATIONS["B52"].printed,
            EQUATIONS["B52"].corrected,
        ),
        Erratum(
            "Eq. 46b: the block B53",
            "The same slips; B54 is right. The second term of B53 is zero, printed or corrected, because the "
            "tower's centre and top lie on the axis that it turns about. With B52 and B53 as printed the "
            f"arm's velocity is off by {m.eq_46b_m_s:.1f} m/s at the instant of remark 1.",
            EQUATIONS["B53"].printed,
            EQUATIONS["B53"].corrected,
        ),
    ]


def _statements(m: Measured) -> list[Erratum]:
    ratio = m.slew_inertia_loaded / m.slew_inertia
    return [
        Erratum(
            "After eq. 61: how many equations, and of what kind",
            f"The list of velocities has {len(m.free)} entries, and {len(m.held)} with the ship's centre "
            "held as in the computation; five is right only then. The equations are driven by the "
            "motors, so they are not homogeneous.",
        ),
        Erratum(
            "Table 2: the load",
            "The load is in the table but in no equation: they end at body 3. It matters. With the arm "
            f"level, the inertia about the tower's axis is {m.slew_inertia:,.0f} kg m<sup>2</sup> without "
            f"and {m.slew_inertia_loaded:,.0f} kg m<sup>2</sup> with it, a factor of {ratio:.1f}. Here it "
            "is a point mass fixed at the arm's tip that can be switched; it is off on this page.",
        ),
        Erratum(
            "Two uses of one symbol",
            "\u03b6 is the rate of the arm's angle in Table 1 and the damping coefficient in the results. "
            "Here \u03be is the angle and \u03b6 the damping.",
            [r"\{\dot{q}\} = (\dot{x}_C^{(1)}, \omega^{(1)}, \dot{\phi}^{(2)}, \dot{\zeta}^{(3)})"],
            [r"\{\dot{q}\} = (\dot{x}_C^{(1)}, \omega^{(1)}, \dot{\phi}^{(2)}, \dot{\xi}^{(3)})"],
        ),
    ]


def _names() -> Erratum:
    remarks = (
        "The list {Q} of eq. 59 is the {F} of eq. 60c.",
        "Eq. 2, the inertial frame as a body's frame at the start, holds for the first body only.",
        "Before eq. 7, eq. 6 goes into eq. 5, not the reverse.",
        "After eq. 27 it is the inverse in the group SE(3) that is used, not orthogonality.",
        "Eq. 51 asks for a stationary action, not for a minimum.",
        "The third column of Table 1 holds the actual velocities, not virtual ones.",
        "A frame connection is the pair of frame and position; E is its matrix.",
        "The driving torques are in Table 2, not in Table 1.",
        "Reference 11 is cited for details that are in reference 14, and some printings lack reference 24.",
    )
    items = "".join(f"<li>{remark}</li>" for remark in remarks)
    return Erratum("Names and cross-references", f"<ul>{items}</ul>")


def _figure_9(m: Measured) -> Erratum:
    level, upright, damped = m.level, m.upright, m.level_damped
    reduced = 100 * (1 - damped["roll"] / level["roll"])
    return Erratum(
        "What Figs. 9 and 11 say",
        "The text expects yaw to dominate when the tower turns. With the arm level and pointing forward "
        f"at the start it does not: in Fig. 9 roll peaks at {level['roll']:.2f} rad/s, pitch at "
        f"{level['pitch']:.2f} rad/s and yaw at {level['yaw']:.2f} rad/s, so roll is "
        f"{level['roll'] / level['yaw']:.1f} times yaw. The motor turns the tower about the ship's "
        "vertical axis, but to swing the arm takes a force 7 m above the ship's centre, and its reaction "
        "rolls and pitches the ship. The expectation holds for an arm held upright: then only yaw is "
        f"left, {upright['yaw']:.2f} rad/s at most. The text also says that damping reduces all "
        f"magnitudes and can end all motion. With zero damping of roll it cannot: in Fig. 9 it takes "
        f"{reduced:.0f} % off the roll peak, in Fig. 11 roll still reaches {m.both_damped['roll']:.2f} "
        f"rad/s, and yaw peaks higher with damping ({m.both_damped['yaw']:.2f} rad/s) than without "
        f"({m.both['yaw']:.2f} rad/s). All this is for motors that stay on for {DURATION_S:g} s.",
    )


def _figure_10(m: Measured) -> Erratum:
    return Erratum(
        "Fig. 10: the arm goes down",
        "The text says that the arm is lifting. By eq. 40 a positive angle \u03be lowers the arm, and eq. 59 "
        "applies the +70 kN m of Table 2 along it: the arm of Fig. 10 goes down, and so it does on this "
        f"page. Pitch then peaks at {m.lowering[0]:.3f} rad/s, with damping at {m.lowering[1]:.3f} rad/s. "
        f"With the opposite torque the arm is lifted, and the peaks are {m.lifting[0]:.3f} and "
        f"{m.lifting[1]:.3f} rad/s: <code>kingpost run paper --set motor_1=false "
        "--set motor_2=true --set drives.motor_2.motor.torque_N_m=-70000</code>.",
    )


def _smaller() -> Erratum:
    return Erratum(
        "Smaller ones",
        "In the order of the list: eq. 47 needs a product of three matrices, not a square; the "
        "velocity in eq. 29b is in body components; eq. 55 unskews both of its terms; the blocks of D in "
        "eq. 57 stand on the diagonal; the second column of Table 1 holds displacements, not their rates; "
        "damping is in the results but in neither eq. 59 nor eq. 61, and although the text puts it on each "
        "coordinate, the figures' coefficients, and this page, have it on the ship's three rates only; and "
        "eq. 33 puts the crane's foot at the height of the ship's centre of mass, 2.5 m below the deck (the "
        "parameter <code>crane_z_m</code> moves it).",
        [
            r"(47) \quad K^{(\alpha)} = \tfrac{1}{2} \left\{ m (\dot{x}_C)^2 + J_C (\omega)^2 \right\}",
            r"(55) \quad \delta \omega = \frac{d}{dt} \left( R^T \delta R \right) + S(\omega) "
            r"\left( R^T \delta R \right)_{\mathrm{unskewed}}",
            r"(59) \quad M^{(1)} = M^{(w)} - M_m^{(t)} e_2",
        ],
        [
            r"(47) \quad K^{(\alpha)} = \tfrac{1}{2} \left( m \, \dot{x}_C^T \dot{x}_C "
            r"+ \omega^T J_C \, \omega \right)",
            r"(29\mathrm{b}) \quad v_C = R^T \dot{x}_C",
            r"(55) \quad \delta \omega = \frac{d}{dt} \delta \pi + S(\omega) \, \delta \pi",
            r"(57) \quad D = \mathrm{diag} \left( 0, S(\omega^{(1)}), 0, S(\omega^{(2)}), "
            r"0, S(\omega^{(3)}) \right)",
            r"(59) \quad M^{(1)} = M^{(w)} - M_m^{(t)} e_2 "
            r"- \mathrm{diag}(\zeta_1, \zeta_2, \zeta_3) \, \omega^{(1)}",
        ],
    )
