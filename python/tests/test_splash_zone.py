"""The simplified method of DNV-RP-N103 on objects of scenarios, and its table in `check`.

Its loads on three objects are by hand in `kingpost verify` (`simplified-lowering`).
"""

import math
from pathlib import Path

import kingpost
import numpy as np
import pytest
from kingpost.cli import main

G = 9.80665
TEXT = """version: 1
title: A box under a hook
simulation: {step_s: 0.05, duration_s: 1}
sea: {waves: {wave: WAVE}}
bodies:
  box:
    mass_t: 60
    shape: {point: {}}
    joint: {prismatic: {name: lift, axis: [0, 0, 1], position_m: [0, 0, 5], mode: held}}
forces:
  gravity: {gravity: {}}
  water:
    submerged:
      body: box
      shape: {box: {length_m: 4, width_m: 3, height_m: 2}}
      added_mass: {coefficients: [0, 0, 1]}
      drag: {coefficients: [0, 0, 2]}
"""
REGULAR = "{regular: {height_m: 2, period_s: 7, direction_deg: 0}}"


@pytest.fixture
def box(tmp_path: Path):
    def written(wave: str = REGULAR, change: tuple[str, str] = ("", "")) -> Path:
        path = tmp_path / "box.yaml"
        path.write_text(TEXT.replace("WAVE", wave).replace(*change), encoding="utf-8")
        return path

    return written


def test_the_characteristic_wave_of_a_random_sea_has_0_9_hs_and_the_zero_up_crossing_period(box) -> None:
    """Source: Tz = 0.7104 Tp of a Pierson-Moskowitz sea, whose band from half to five times its peak leaves
    out its tail's second moment: Tz is 4 % longer at most."""
    found = kingpost.splash_zone(
        box("{pierson_moskowitz: {significant_height_m: 2, peak_period_s: 8, direction_deg: 0}}")
    )
    assert found.attrs["wave_amplitude_m"] == pytest.approx(1.8, rel=1e-4)
    assert 0.71 * 8 < found.attrs["zero_up_crossing_period_s"] < 1.04 * 0.711 * 8


def test_the_motion_of_the_tip_adds_to_speed_and_inertia(box) -> None:
    """Source: sec. 4.3 of DNV-RP-N103 by hand, of the immersed box."""
    found = kingpost.splash_zone(box(), tip_heave_m=0.6, tip_speed_m_s=0.5, tip_acceleration_m_s2=0.4)
    touches, immersed = found.isel(object=0, immersion=0), found.isel(object=0, immersion=-1)
    omega = 2 * math.pi / 7
    speed = omega * math.exp(-(omega**2) * 1.0 / G)
    whole = 1025 * 24.0
    assert float(immersed.drag_force) == pytest.approx(
        1025 * 12 * (0.5 + math.hypot(0.5, speed)) ** 2, rel=1e-9
    )
    inertia = math.hypot((60e3 + whole) * 0.4, 2 * whole * speed * omega)
    assert float(immersed.mass_force) == pytest.approx(inertia, rel=1e-9)
    assert float(touches.buoyancy_force) == pytest.approx(1025 * G * 12 * math.hypot(1, 0.6), rel=1e-6)


def test_several_objects_on_a_body_have_no_margin_against_slack(box) -> None:
    second = "  more: {submerged: {body: box, shape: {sphere: {radius_m: 0.2}}}}\n  water:\n"
    found = kingpost.splash_zone(box(change=("  water:\n", second)))
    assert list(found.object.values) == ["more", "water"]
    assert np.isnan(found.slack_utilisation.values).all()


def test_splash_zone_without_an_object_or_with_a_negative_speed_is_refused(box) -> None:
    with pytest.raises(kingpost.KingpostError, match="found no object that is lowered"):
        kingpost.splash_zone("paper")
    with pytest.raises(kingpost.KingpostError, match="tip_speed_m_s: found -1"):
        kingpost.splash_zone(box(), tip_speed_m_s=-1)


def test_check_prints_the_coefficients_in_effect_and_names_slack(box, capsys) -> None:
    """Source: C_S = 2 / (rho A_p) dA/dh = 2 x 24 / 12 / 2 = 2."""
    assert main(["check", str(box(change=("mass_t: 60", "mass_t: 26")))]) == 0
    printed = capsys.readouterr().out
    assert "2 by dA/dh" in printed
    assert "water: C_S 2 is below the least without tests or theory (DNV-RP-N103, sec. 4.3.5), 5" in printed
    assert "wave amplitude 1 m, Tz 7 s" in printed
    assert " slack" in printed
    given = ("drag:", "slamming: {coefficient: 6}\n      drag:")
    assert main(["check", str(box(change=given))]) == 0
    printed = capsys.readouterr().out
    assert "6 given" in printed
    assert "C_S 6 is below" not in printed


def test_check_of_still_water_prints_coefficients_alone(box, capsys) -> None:
    assert main(["check", str(box(change=("sea: {waves: {wave: " + REGULAR + "}}\n", "")))]) == 0
    printed = capsys.readouterr().out
    assert "by dA/dh" in printed
    assert "simplified method" not in printed
