"""Report of `kingpost modes`: unique names, shapes of positions and angles."""

import kingpost
import pytest
from kingpost.reports import modes as modes_report


@pytest.fixture(scope="module")
def kept_in_place():
    return kingpost.modes("offshore_vessel_on_dp")


def table(text: str) -> list[str]:
    return [line for line in text.splitlines() if line[:4].strip().isdigit()]


def test_shapes_of_a_ship_on_positioning_are_of_places_and_angles(kept_in_place) -> None:
    shown = modes_report.text(kept_in_place)
    moving = set(kept_in_place.coordinate.values[kept_in_place.moves.values])
    for line in table(shown):
        words = line.replace(",", " ").split()
        assert [word for word in words if word.count(".") and word[0].isalpha() and word not in moving] == []
    assert "e+" not in shown, "no amplitude is beside the largest, which is 1"
    assert "modes of the states of controls and drives (--all shows them)" in shown


def test_all_modes_have_amplitudes_of_at_most_one(kept_in_place) -> None:
    shown = modes_report.text(kept_in_place, all_modes=True)
    assert len(table(shown)) == kept_in_place.sizes["mode"]
    assert "dp.filter" in shown
    assert all("e+" not in line.split(" s  ")[-1] for line in table(shown))


def test_names_of_modes_are_unique(kept_in_place) -> None:
    names = [line[5:].split("  ")[0] for line in table(modes_report.text(kept_in_place))]
    assert len(names) == len(set(names)) > 5
