"""Wrong scenarios of lifts: each is refused with a place, runs with finite results, or ends with a reason. No
case panics, hangs or continues with NaN. The cases are drawn from a seed, so that a failure can be repeated.
More of them, one of them:

    KINGPOST_FUZZ_SEED=7000 KINGPOST_FUZZ_CASES=5000 pytest python/tests/test_fuzz_lifts.py
    KINGPOST_FUZZ_SEED=7123 KINGPOST_FUZZ_CASES=1 pytest python/tests/test_fuzz_lifts.py
"""

from __future__ import annotations

import copy
import os
from collections import Counter
from pathlib import Path

import kingpost
import pytest
from fuzz.apart import Apart
from fuzz.contract import Case
from lanes import THOROUGH
from lift_mutations import Document, Lift, at, case, is_number, places, put, shown, written

YARD = (Path(__file__).parent / "lift_yard.yaml").read_text(encoding="utf-8")
SEED = int(os.environ.get("KINGPOST_FUZZ_SEED", "2"))
CASES = int(os.environ.get("KINGPOST_FUZZ_CASES", "120" if THOROUGH else "24"))
# Beside the gallery, so that its databases are found.
FILE = str(kingpost.gallery.folder() / "case.yaml")
GALLERY = [
    "container_to_quay",
    "lift_off_from_barge",
    "loss_of_hook_load",
    "lowering_by_winch",
    "subsea_lowering",
]

POSITIVE = {
    "mass_kg", "radius_m", "length_m", "width_m", "height_m", "step_s", "duration_s", "record_every_s",
    "rate_limit", "axial_stiffness_N", "series_stiffness_N_per_m", "breaking_load_N", "stiffness_N_per_m",
    "time_out_s", "friction_stiffness_N_per_m", "restitution_speed_m_s", "penetration_tolerance_m",
    "displaced_volume_m3", "reference_volume_m3", "speed_limit_rad_s", "speed_limit_m_s",
    "acceleration_limit_rad_s2", "acceleration_limit_m_s2", "jerk_limit_rad_s3", "jerk_limit_m_s3",
    "torque_limit_N_m", "force_limit_N", "power_limit_W", "stiffness_N_m_per_rad", "damping_N_m_s_per_rad",
    "damping_N_s_per_m", "response_time_s", "efficiency_hoisting", "efficiency_lowering", "restitution",
    "period_s",
}  # fmt: skip
NOT_NEGATIVE = {"damping_time_s", "tension_N", "friction_coefficient", "perforation", "at_s", "in_s",
                "after_s", "from_s", "within", "ramp_s", "speed_m_s"}  # fmt: skip
# A drive without damping has no controller; a line without damping is the usual constant-tension winch.
ALSO_ZERO = {("tugger_line", "damping_N_s_per_m")}


@pytest.fixture(scope="module")
def bases() -> dict[str, Document]:
    """The gallery's lifts, their runs short, and the yard, which a third of the cases are of."""
    found = {name: kingpost.load(name, {"simulation.duration_s": 1.5}).resolved for name in GALLERY}
    return found | {"yard": kingpost.Scenario(YARD, FILE).resolved}


@pytest.fixture(scope="module")
def apart():
    """Separate process, so that a panic, a stack overflow or an endless loop does not end the tests."""
    process = Apart()

    def ask(text: str, *, thorough: bool = False) -> str:
        how = "thorough" if thorough else "outcome"
        return process.ask(Case("lifts", {"case.yaml": text.encode()}, (how, FILE))).says

    yield ask
    process.end()


def test_the_unmutated_lifts_of_the_tests_and_the_gallery_run(bases, apart):
    """Else the cases below would be refused for something that is wrong in all of them."""
    assert {name: apart(written(base)) for name, base in bases.items()} == dict.fromkeys(bases, "ran")


def test_a_mutated_lift_is_refused_with_its_place_or_runs_with_finite_results(bases, apart):
    """Source: the public contract: `lift_outcomes` says what is allowed."""
    came_to: Counter[str] = Counter()
    wrong = []
    for seed in range(SEED, SEED + CASES):
        one = drawn(bases, seed)
        says = apart(one.text, thorough=seed % 7 == 0)
        came_to[says.split(":")[0]] += 1
        if says.startswith("WRONG"):
            wrong.append(f"{one}\n  {says}")
    assert not wrong, "\n".join(wrong)
    # Neither is the rule: mistakes are found, and what is only unusual is not taken for one.
    assert CASES < 100 or min(came_to["refused"], came_to["ran"]) > CASES / 10, came_to


def drawn(bases: dict[str, Document], seed: int) -> Lift:
    return case({"yard": bases["yard"]} if seed % 3 == 0 else bases, seed)


def test_the_same_seed_draws_the_same_case(bases):
    """Source: a failure that cannot be repeated cannot be mended."""
    cases = [drawn(bases, seed) for seed in range(30)]
    assert [one.text for one in cases] == [drawn(bases, seed).text for seed in range(30)]
    assert len({one.text for one in cases}) == 30


def signed(base: Document) -> list[tuple[tuple[str | int, ...], float]]:
    """Places of numbers with a sign, and what they may not be."""
    found: list[tuple[tuple[str | int, ...], float]] = []
    for path in places(base):
        # A swell's speed has a direction, a joint's too; a wind's speed and a limit's have none.
        if path[0] == "parameters" or not is_number(at(base, path)):
            continue
        if path[-2:] in ALSO_ZERO:
            found.append((path, -1.0))
        elif path[-1] in POSITIVE:
            found += [(path, -1.0), (path, 0.0)]
        elif path[-1] in NOT_NEGATIVE and path[0] != "bodies":
            found.append((path, -1e-3))
    return found


def test_a_number_that_has_a_sign_is_refused_without_it(bases):
    """Source: a radius, a stiffness, a limit, a time of no size or of a negative one is nothing."""
    base = bases["yard"]
    cases = signed(base)
    assert len(cases) > 120
    for path, value in cases:
        changed = copy.deepcopy(base)
        put(changed, path, value)
        with pytest.raises(kingpost.ScenarioError) as caught:
            kingpost.Scenario(written(changed), FILE)
        assert caught.value.field == shown(path)
        assert caught.value.line is not None


@pytest.mark.parametrize("depth", [100, 1000, 100_000])
def test_conditions_nested_too_deeply_are_refused_at_their_place(depth, apart):
    """Source: a stack ends; the error has the line of the first bracket too many."""
    nested = "{all: [" * depth + "{after_s: 1}" + "]}" * depth
    says = apart(YARD.replace("until: {after_s: 0.1}", f"until: {nested}"))
    line = next(k for k, text in enumerate(YARD.splitlines(), 1) if "until: {after_s: 0.1}" in text)
    assert says.startswith(f"refused: {FILE}:{line}:"), says
    assert "too deep" in says


@pytest.mark.parametrize(
    ("old", "new", "field"),
    [
        ("within: 5, unit: deg}", "within: 5, unit: ''}", "limits.heel.unit"),
        ("{column: load.roll,", "{column: ' ',", "limits.heel.column"),
        ("{name: wait,", "{name: ' ',", "operation.steps.0.name"),
        ("{body: world, position_m: [0, -3, 1]}", "[world, [0, -3, 1], 1]",
         "forces.tag_line.tugger_line.path.0.point"),
        ("{column: load.roll, within: 5, unit: deg}", "[true, load.roll, 5, null, null, deg, 0]",
         "limits.heel"),
        ("{body: load, position_m: [-0.7, -0.5, 0]}", "{body: world, position_m: [5, -3, 1]}",
         "forces.tag_line.tugger_line.path"),
        ("tension_N: 300", "tension_N: 1e308", "forces"),
    ],
    ids=["no unit", "no column", "no name", "a list for a point", "a list for a limit", "all on the world",
         "beyond all numbers"],
)  # fmt: skip
def test_inputs_that_were_once_accepted_are_refused_at_their_field(old, new, field):
    """Source: cases that this file has found."""
    assert YARD.count(old) == 1
    with pytest.raises(kingpost.ScenarioError) as caught:
        kingpost.Scenario(YARD.replace(old, new), FILE)
    assert caught.value.field == field
    assert caught.value.found.strip()
