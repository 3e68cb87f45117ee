"""Two boxes that feel each other, from panels to motions: the engine against the coefficients themselves."""

from dataclasses import replace
from pathlib import Path

import kingpost
import numpy as np
import pytest
from kingpost import hydro
from kingpost.hydro import several_build
from kingpost.hydro.database import Water
from kingpost.hydro.database_file import rounded
from kingpost.hydro.hull_options import parse_shape
from kingpost.hydro.meshes import parametric
from kingpost.hydro.radiation_fit import evaluate
from kingpost.hydro.several import Place, SeveralHulls
from kingpost.hydro.several_mesh import Member

pytest.importorskip("capytaine")

BOX = "box:length_m=20,beam_m=10,draught_m=2,depth_m=5"
MASS_KG, RADII_M, ROLL_DAMPING = 410e3, (3.5, 6.0, 6.0), 5e5
PLACES = {"weather": Place(0.0, 0.0, 0.0), "lee": Place(2.0, 14.0, 0.3)}
DIRECTIONS_RAD = np.deg2rad([90.0, 150.0])

BODY = """
  {name}:
    mass_kg: 410000
    centre_of_mass_m: [0, 0, 2]
    inertia: {{radii_of_gyration: {{radii_m: [3.5, 6, 6]}}}}
    joint:
      floating: {{initial: {{drawing_frame_m: [{x}, {y}, -2], orientation_rad: [0, 0, {heading}]}}}}"""
FORCES = """
  {name}_water: {{hydrodynamics: {{body: {name}, database: boxes.hydro.json, origin_m: [0, 0, 2]}}}}
  {name}_damping:
    viscous_damping:
      {{body: {name}, position_m: [0, 0, 2], linear_N_s_m: [0, 0, 0], angular_N_m_s: [5e5, 0, 0]}}"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the database of the boxes and their scenario."""
    folder = tmp_path_factory.mktemp("boxes")
    hull = parametric(parse_shape(BOX), BOX, 60)
    members = [Member(name, place, hull) for name, place in PLACES.items()]
    # Below the resonance of the gap, whose narrow peak few panels and frequencies do not resolve.
    omega = np.linspace(0.3, 1.6, 20)
    solved = several_build.build_several(members, Water(), "two boxes", omega, 24)
    stored = rounded(solved)
    memory = hydro.fit(stored, accept=True)
    hydro.write(replace(stored, radiation=memory), folder / "boxes.hydro.json")
    at = {
        name: {"name": name, "x": p.x_m, "y": p.y_m, "heading": p.heading_rad} for name, p in PLACES.items()
    }
    text = "version: 1\ntitle: Two boxes\nsimulation: {step_s: 0.05, duration_s: 400, record_every_s: 0.1}\n"
    text += "sea: {waves: {swell: {regular: {height_m: 0.1, period_s: 6, direction_deg: 90}}}, ramp_s: 60}\n"
    text += "bodies:"
    text += "".join(BODY.format(**one) for one in at.values()) + "\nforces:\n  gravity: {gravity: {}}"
    text += "".join(FORCES.format(**one) for one in at.values()) + "\n"
    (folder / "boxes.yaml").write_text(text, encoding="utf-8")
    return folder


def impedance_and_forces(data: SeveralHulls, added_mass, damping):
    """Impedance (frequency, 12, 12) and excitation (frequency, direction, 12), crests at the first origin."""
    omega, water = data.frequencies_rad_s, data.water
    mass, stiffness, more = np.zeros((12, 12)), np.zeros((12, 12)), np.zeros((12, 12))
    forces = np.zeros((len(omega), len(DIRECTIONS_RAD), 12), complex)
    for k, one in enumerate(data.hulls):
        own, plane = slice(6 * k, 6 * k + 6), one.hull.waterplane
        mass[own, own] = MASS_KG * np.diag([1, 1, 1, *np.square(RADII_M)])
        # The centre of gravity is on the water plane.
        height = one.hull.volume_m3 * one.hull.centre_of_buoyancy_m[2]
        lengthwise, _, athwart = plane.second_moments_m4
        restoring = [0, 0, plane.area_m2, athwart + height, lengthwise + height, 0]
        stiffness[own, own] = water.density_kg_m3 * water.gravity_m_s2 * np.diag(restoring)
        more[6 * k + 3, 6 * k + 3] = ROLL_DAMPING
        forces[:, :, own] = on_hull(one, data, omega**2 / water.gravity_m_s2)
    w = omega[:, None, None]
    return -(w**2) * (mass + added_mass) - 1j * w * (damping + more) + stiffness, forces


def on_hull(one, data: SeveralHulls, wave_number):
    """Excitation (frequency, direction, 6): between the directions of the table by its harmonics."""
    count = len(data.wave_directions_rad)
    harmonics = np.fft.fft(one.excitation, axis=1) / count
    orders = np.fft.fftfreq(count, 1 / count)
    turns = np.exp(1j * np.outer(DIRECTIONS_RAD - one.place.heading_rad, orders))
    along = one.place.x_m * np.cos(DIRECTIONS_RAD) + one.place.y_m * np.sin(DIRECTIONS_RAD)
    phase = np.exp(1j * wave_number[:, None] * along)
    return np.einsum("dm,nmk->ndk", turns, harmonics) * phase[:, :, None]


def solved_directly(data: SeveralHulls, added_mass, damping):
    """Motions (frequency, direction, 12), in the axes of each hull."""
    impedance, forces = impedance_and_forces(data, added_mass, damping)
    return np.linalg.solve(impedance[:, None], forces[..., None])[..., 0]


def by_the_engine(folder: Path, data: SeveralHulls):
    """Motions (frequency, direction, 12) from `kingpost.rao`, in the axes of each hull."""
    found = kingpost.rao(
        folder / "boxes.yaml", directions_rad=DIRECTIONS_RAD, frequencies_rad_s=data.frequencies_rad_s
    )
    motions = np.zeros((len(data.frequencies_rad_s), len(DIRECTIONS_RAD), 12), complex)
    for k, one in enumerate(data.hulls):
        for start, variable, along in ((0, "displacement", "axis"), (3, "rotation", "angle")):
            which = {"point" if start == 0 else "body": one.name}
            size, lag = (
                found[name].sel(which).transpose("omega", "direction", along).values
                for name in (variable, f"{variable}_phase")
            )
            motions[:, :, 6 * k + start : 6 * k + start + 3] = size * np.exp(1j * lag)
        cos, sin = np.cos(one.place.heading_rad), np.sin(one.place.heading_rad)
        x, y = motions[:, :, 6 * k].copy(), motions[:, :, 6 * k + 1].copy()
        motions[:, :, 6 * k], motions[:, :, 6 * k + 1] = cos * x + sin * y, cos * y - sin * x
    return motions


def test_responses_are_those_of_both_hulls_solved_at_once(folder: Path) -> None:
    data = hydro.read_several(folder / "boxes.hydro.json")
    raw = solved_directly(data, data.added_mass, data.radiation_damping)
    memory = evaluate(data.radiation, data.frequencies_rad_s)
    omega = data.frequencies_rad_s[:, None, None]
    fitted = solved_directly(data, data.added_mass_infinite + memory.imag / omega, memory.real)
    found, peaks = by_the_engine(folder, data), np.abs(raw).max(axis=(0, 1))
    # Harmonics below 1e-7 of the largest are left out of the tables by heading; resonances multiply that.
    assert (np.abs(found - fitted) / peaks).max() < 3e-5
    # The fit of the memory may cost what the documentation states.
    assert (np.abs(found - raw) / peaks).max() < 0.02
    alone = np.kron(np.eye(2), np.ones((6, 6)))
    single = solved_directly(data, data.added_mass * alone, data.radiation_damping * alone)
    assert (np.abs(single - raw) / peaks).max() > 0.1, "the coupling matters"


def test_a_run_in_a_regular_wave_has_the_amplitudes_of_the_coefficients(folder: Path) -> None:
    data = hydro.read_several(folder / "boxes.hydro.json")
    raw = solved_directly(data, data.added_mass, data.radiation_damping)
    peaks, k = np.abs(raw).max(axis=(0, 1)), 12
    omega = data.frequencies_rad_s[k]
    period, periods = 2 * np.pi / omega, 15
    wave = {"sea.waves.swell.regular.period_s": float(period)}
    found = kingpost.run(folder / "boxes.yaml", overrides=wave)
    last = found.time.values > found.time.values[-1] - periods * period
    turning = np.exp(1j * omega * found.time.values[last])
    for hull, one in enumerate(data.hulls):
        for variable, motion in (("position", 2), ("roll", 3)):
            record = found[variable].sel(body=one.name)
            values = record.sel(axis="z").values[last] if variable == "position" else record.values[last]
            amplitude = 2 * abs(np.mean((values - values.mean()) * turning)) / 0.05
            expected = abs(raw[k, 0, 6 * hull + motion])
            assert amplitude == pytest.approx(expected, abs=0.02 * peaks[6 * hull + motion]), (
                one.name,
                variable,
            )
    assert {"interaction_force", "interaction_kinetic_energy"} <= set(found.data_vars)
