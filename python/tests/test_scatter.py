"""Scatter tables: reading, and errors for wrong ones."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from kingpost import KingpostError
from kingpost.study.sea_states import periods, scatter
from kingpost.study.sea_states.scatter import ScatterError

MATRIX = """# North Sea, made up
# classes: centres
Hs\\Tp,6,8,10,total
0.5,10,20,5,35
1.5,2,15,10,27
total,12,35,15,62
"""


def test_a_matrix_has_a_class_for_each_entry_with_its_edges(tmp_path: Path) -> None:
    file = tmp_path / "table.csv"
    file.write_text(MATRIX)
    table = scatter.read(file)
    assert table.period == "peak"
    assert table.total == 62
    assert table.height_m.tolist() == [0.5] * 3 + [1.5] * 3
    assert table.height_from_m.tolist() == [0.0] * 3 + [1.0] * 3
    assert table.height_to_m.tolist() == [1.0] * 3 + [2.0] * 3
    assert table.period_s.tolist() == [6, 8, 10] * 2
    assert table.occurrences.tolist() == [10, 20, 5, 2, 15, 10]
    assert table.cells()[:2] == [(0.5, 6.0), (0.5, 8.0)]


@pytest.mark.parametrize(
    "text",
    [
        "Hs/Tp;0-2;2-4\n0-1;1;2\n1-2;3;4",
        "Hs \\ Tp (s)\t0-2\t2-4\n0-1\t1\t2\n1-2\t3\t4",
        "# classes: lower edges\nHs|Tp,0,2\n0,1,2\n1,3,4",
        "#classes:Upper  Edges\nHs vs Tp,2,4\n1,1,2\n2,3,4",
        'Hs/Tp,"0,0-2,0","2,0-4,0"\n"0,0-1,0","1,0",2\n"1,0-2,0","3,0",4',
        "Hs/Tp;0,0-2,0;2,0-4,0\n0,0-1,0;1,0;2,0\n1,0-2,0;3,0;4,0",
    ],
)
def test_tables_with_edges_or_other_separators_are_equal(text: str) -> None:
    table = scatter.parse(text)
    assert table.height_from_m.tolist() == [0, 0, 1, 1]
    assert table.height_to_m.tolist() == [1, 1, 2, 2]
    assert table.period_s.tolist() == [1, 3, 1, 3]
    assert table.occurrences.tolist() == [1, 2, 3, 4]


CLIMATE = """\ufeffSite: Utsira, 59.3 N 4.4 E;;;;
Period 1991-2020, percent of time;;;;
Hs [m] / Tp [s];<6;6-8;>= 8;Sum
0,0 - 1,0;3,5;5,25;4;12,75
1,0 - 2,0;12;;10;22
> 2,0;0,25;15;50;65,25
Sum;15,75;20,25;64;100
"""


def test_a_table_exported_from_a_spreadsheet_is_read(tmp_path: Path) -> None:
    """Source: arithmetic. A byte order mark, titles, units, decimal commas, open classes as wide as their
    neighbours, sums, an empty cell."""
    (tmp_path / "climate.csv").write_text(CLIMATE, encoding="utf-8")
    table = scatter.read(tmp_path / "climate.csv", entries="per cent")
    assert table.period == "peak"
    assert table.height_from_m.tolist() == [0] * 3 + [1] * 3 + [2] * 3
    assert table.height_to_m.tolist() == [1] * 3 + [2] * 3 + [3] * 3
    assert table.period_s.tolist() == [5, 7, 9] * 3
    assert table.occurrences.tolist() == [3.5, 5.25, 4, 12, 0, 10, 0.25, 15, 50]


def test_a_list_of_seas_may_have_units_in_its_names_and_a_title() -> None:
    table = scatter.parse(
        "Wave climate of the site\n#entries: percent,,\nHs (m),Tp [s],Occurrence (%)\n1,8,60\n2,9,40\n"
    )
    assert (table.height_m.tolist(), table.period_s.tolist()) == ([1, 2], [8, 9])
    assert table.occurrences.tolist() == [60, 40]
    with pytest.raises(ScatterError, match=r"t.csv:1: columns: found hs, tp \[ft\]"):
        scatter.parse("hs,tp [ft],occurrences\n1,8,60\n", "t.csv")


def test_the_long_form_has_months_and_directions() -> None:
    table = scatter.parse("hs,tp,occurrences,month,mwd\n1.0,8,3,1,350\n2.0,9,1,7,90\n")
    assert table.month is not None
    assert table.direction_rad is not None
    assert table.month.tolist() == [1, 7]
    # What comes from 350 goes to 170.
    assert np.allclose(np.degrees(table.direction_rad), [170, 270])
    assert table.height_from_m.tolist() == table.height_to_m.tolist() == [1.0, 2.0]
    to = scatter.parse("hs,tz,occurrences,direction_to_deg\n1,8,3,-10\n")
    assert to.direction_rad is not None
    assert np.degrees(to.direction_rad).tolist() == pytest.approx([350])
    assert to.period == "zero_up_crossing"


def test_every_sea_counts_once_without_a_column_of_occurrences() -> None:
    assert scatter.parse("swh,pp1d\n1,8\n2,9\n").occurrences.tolist() == [1, 1]


@pytest.mark.parametrize("gamma", [1.0, 2.0, 3.3, 5.0, 6.9])
def test_zero_up_crossing_periods_of_jonswap_agree_with_the_recommended_practice(gamma: float) -> None:
    """DNV-RP-C205 (2010), 3.5.5.4: Tz / Tp = 0.6673 + 0.05037 g - 0.006230 g^2 + 0.0003341 g^3, a fit to
    half a per cent."""
    published = 0.6673 + 0.05037 * gamma - 0.006230 * gamma**2 + 0.0003341 * gamma**3
    assert periods.ratio("zero_up_crossing", gamma) == pytest.approx(published, rel=0.005)


def test_periods_of_pierson_and_moskowitz_have_closed_forms() -> None:
    """Moments of w^-5 exp(-b w^-4): m_n = b^((n - 4) / 4) Gamma(1 - n / 4) / 4; b = 5/4."""
    from math import gamma

    def moment(order: int) -> float:
        return 1.25 ** ((order - 4) / 4) * gamma(1 - order / 4) / 4

    # m2 lacks what is above w = 100: 1 / (2 * 100^2), of 0.4.
    assert periods.ratio("zero_up_crossing", 1.0) == pytest.approx((moment(0) / moment(2)) ** 0.5, rel=2e-4)
    assert periods.ratio("energy", 1.0) == pytest.approx(moment(-1) / moment(0), rel=1e-5)
    assert periods.ratio("mean", 1.0) == pytest.approx(moment(0) / moment(1), rel=1e-5)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            "Hs\\Tp,6,8\n0.5,1,2\n",
            "t.csv:1: period: found numbers, as 6, allowed: ranges, as 0.5-1.0, or a line",
        ),
        (
            "# classes: middles\nHs\\Tp,6,8\n",
            "t.csv:1: classes: found 'middles', allowed: centres, lower edges",
        ),
        (
            "# classes: centres\nTp\\Hs,6,8\n1,2,3\n2,2,2\n",
            "t.csv:2: first cell: found 'Tp.*rows Hs, columns",
        ),
        ("# classes: centres\nHs,6,8\n1,2,3\n", "t.csv:2: cells: found|t.csv:2: columns: found hs, 6, 8"),
        ("Hs\\Tp,0-2,2-4\n0-1,1,x\n", "t.csv:2: entry: found 'x', allowed: a number, 0 or more"),
        ("Hs\\Tp,0-2,2-4\n0-1,1,-1\n", "t.csv:2: entry: found '-1'"),
        ("Hs\\Tp,0-2,2-4\n0-1,1\n", "t.csv:2: cells: found 2, allowed: 3"),
        ("Hs\\Tp,0-2,1-4\n0-1,1,2\n", "t.csv:1: period: found '1-4', allowed: classes that increase"),
        ("Hs\\Tp,0-2,2-4\n\n1-0,1,2\n", "t.csv:3: Hs: found '1-0', allowed: classes from low to high"),
        ("Hs\\Tp,0-2,2-4\n0-1,0,0\n", "entries: found a sum of 0"),
        ("# entries: per cent\nHs\\Tp,0-2,2-4\n0-1,90,20\n", "found a sum of 110 per cent, allowed: 100"),
        ("hs,tp,occurrences,month\n1,8,3,13\n", "t.csv:2: month: found 13, allowed: a whole number from 1"),
        ("hs,occurrences\n1,8\n", "t.csv:1: columns: found hs, occurrences, allowed: hs, tp"),
        ("hs,tp,tz\n1,8,3\n", "t.csv:1: period: found tp, tz, allowed: one column"),
        ("hs,tp\n1,nan\n", "t.csv:2: tp: found 'nan'"),
        ("", "t.csv: rows: found 0"),
        ("Utsira\n1,2\n", "t.csv:1: header: found none; the first line is 'Utsira', allowed: a line that"),
        ("Utsira\nHs/Tp,0-2\n", "t.csv:2: rows: found none under the header, allowed: one or more"),
        ("Hs/Tp,0-2,<4\n1-2,1,2\n", "t.csv:1: period: found '0-2', allowed: a number"),
        ("Hs/Tp,<2,>3\n1-2,1,2\n", "t.csv:1: period: found '<2', allowed: a number"),
    ],
)
def test_the_error_for_a_wrong_table_names_the_line(text: str, message: str) -> None:
    with pytest.raises(ScatterError, match=message) as caught:
        scatter.parse(text, "t.csv")
    assert isinstance(caught.value, KingpostError)


def test_a_missing_scatter_table_is_refused() -> None:
    with pytest.raises(ScatterError, match=r"no\.csv: file: found No such file"):
        scatter.read("no.csv")
