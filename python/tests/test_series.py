"""Series of sea states: reading, and errors for wrong ones."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import xarray
from kingpost import KingpostError
from kingpost.study.sea_states import series_file
from kingpost.study.sea_states.series import Series, SeriesError

PLAIN = "time,hs,tp,mwd\n2026-05-01T00:00,1.5,8,350\n2026-05-01T03:00,1.6,8.5,10\n"


def written(folder: Path, text: str, name: str = "sea.csv") -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_a_plain_file_is_read_in_utc(tmp_path: Path) -> None:
    found = series_file.read(written(tmp_path, PLAIN))
    assert [str(time) for time in found.time] == ["2026-05-01T00:00:00", "2026-05-01T03:00:00"]
    assert found.height_m.tolist() == [1.5, 1.6]
    assert found.period_s.tolist() == [8.0, 8.5]
    assert found.period == "peak"
    assert found.direction_from_deg is not None
    assert found.direction_from_deg.tolist() == [350, 10]
    assert found.step_hours == 3


@pytest.mark.parametrize(
    "text",
    [
        "# a buoy\nTime;Hs (m);Tp (s);MWD [deg]\n2026-05-01T00:00Z;1,5;8;350\n2026-05-01T03Z;1,6;8,5;10\n",
        'time,Hs,Tp,MWD\n2026-05-01T00:00Z,"1,5",8,350\n2026-05-01T03Z,"1,6","8,5",10\n',
        "valid_time\tVHM0\tVTPK\tVMDR\n2026-05-01 02:00+02:00\t1.5\t8\t350\n2026-05-01 03:00\t1.6\t8.5\t10\n",
        "date,swh,mwp,pp1d,direction_to_deg,wind\n2026-05-01,1.5,6,8,170,3\n2026-05-01T03,1.6,6,8.5,190,nan\n",
    ],
)
def test_series_with_other_names_units_zones_or_separators_are_equal(tmp_path: Path, text: str) -> None:
    found, plain = (
        series_file.read(written(tmp_path, text)),
        series_file.read(written(tmp_path, PLAIN, "plain.csv")),
    )
    assert (found.time == plain.time).all()
    assert found.height_m.tolist() == plain.height_m.tolist()
    assert found.period_s.tolist() == plain.period_s.tolist()
    assert found.direction_from_deg is not None
    assert plain.direction_from_deg is not None
    assert found.direction_from_deg.tolist() == plain.direction_from_deg.tolist()


def test_a_quoted_number_that_may_group_thousands_is_refused(tmp_path: Path) -> None:
    with pytest.raises(KingpostError, match="found '1,500', allowed: a number"):
        series_file.read(written(tmp_path, 'time,hs,tp\n2026-05-01,"1,500",8\n2026-05-02,1,8\n'))


def test_gaps_and_uneven_steps_are_kept(tmp_path: Path) -> None:
    text = "time,hs,tp\n2026-05-01T00,1,8\n2026-05-01T01,,8\n2026-05-01T02,1,nan\n2026-05-01T09,1,0\n"
    found = series_file.read(written(tmp_path, text))
    assert found.hours.tolist() == [0, 1, 2, 9]
    assert np.isnan(found.height_m).tolist() == [False, True, False, False]
    assert np.isnan(found.period_s).tolist() == [False, False, True, True]
    assert found.direction_from_deg is None


def test_mean_periods_become_peak_periods() -> None:
    time = np.array(["2026-05-01"], "datetime64[s]")
    found = Series(time, np.ones(1), np.array([7.104]), "zero_up_crossing").with_peak_periods(1.0)
    # Pierson-Moskowitz: Tz = (4 / (5 pi))^(1/4) ... of Tp, 0.7104 of it.
    assert found.period_s.tolist() == pytest.approx([10.0], rel=1e-3)
    assert found.period == "peak"


@pytest.mark.parametrize(
    ("heading", "came_from", "goes_to"),
    [(0, 0, 180), (0, 180, 0), (0, 90, 90), (0, 270, 270), (90, 90, 180), (30, 75, 135), (350, 10, 160)],
)
def test_waves_from_ahead_travel_astern_and_waves_from_starboard_to_port(
    heading: float, came_from: float, goes_to: float
) -> None:
    """Source: geometry. Directions of a scenario go from x, forward, to port; a compass the other way."""
    time = np.array(["2026-05-01"], "datetime64[s]")
    found = Series(time, np.ones(1), np.ones(1), direction_from_deg=np.array([float(came_from)]))
    assert np.degrees(found.directions_rad(heading)).tolist() == pytest.approx([goes_to])


def era5(points: tuple[int, int] = (1, 1)) -> xarray.Dataset:
    """As the Climate Data Store writes it since 2024, made up."""
    time = np.array(["2026-05-01T00", "2026-05-01T01"], "datetime64[ns]")
    shape = (2, *points)
    values = np.arange(np.prod(shape), dtype=float).reshape(shape)
    about = {"swh": ("m", 1.0), "pp1d": ("s", 7.0), "mwp": ("s", 6.0), "mwd": ("Degree true", 90.0)}
    return xarray.Dataset(
        {name: (("valid_time", "latitude", "longitude"), start + 0.1 * values, {"units": unit})
         for name, (unit, start) in about.items()},
        {"valid_time": time, "latitude": 60.0 - 0.5 * np.arange(points[0]),
         "longitude": 3.0 + 0.5 * np.arange(points[1]), "number": 0,
         "expver": ("valid_time", ["0001", "0001"])},
    )  # fmt: skip


def test_era5_of_one_point_and_of_the_nearest_of_several(tmp_path: Path) -> None:
    era5().to_netcdf(tmp_path / "one.nc", engine="h5netcdf")
    one = series_file.read(tmp_path / "one.nc")
    assert one.height_m.tolist() == pytest.approx([1.0, 1.1])
    assert one.period_s.tolist() == pytest.approx([7.0, 7.1])
    assert one.direction_from_deg is not None
    assert one.direction_from_deg.tolist() == pytest.approx([90.0, 90.1])
    assert str(one.time[1]) == "2026-05-01T01:00:00"
    era5((3, 4)).to_netcdf(tmp_path / "many.nc", engine="h5netcdf")
    near = series_file.read(tmp_path / "many.nc", at=(59.6, -356.1))
    # Row 1 and column 2 of 3 x 4: number 6, a step of 12 in time.
    assert near.height_m.tolist() == pytest.approx([1.6, 2.8])
    assert near.place == "latitude 59.5, longitude 4"
    with pytest.raises(SeriesError, match="latitude: found 3 values from 59 to 60, allowed: one point"):
        series_file.read(tmp_path / "many.nc")
    with pytest.raises(SeriesError, match="latitude: found 40, outside of 59 to 60, allowed"):
        series_file.read(tmp_path / "many.nc", at=(40.0, 4.0))


def test_unknown_names_are_given_by_options(tmp_path: Path) -> None:
    text = PLAIN.replace("hs", "H_sig").replace("mwd", "wave_dir").replace("tp", "T")
    path = written(tmp_path, text)
    with pytest.raises(
        SeriesError, match=r"sea.csv:1: Hs: found time, H_sig, T, wave_dir, allowed: a column"
    ):
        series_file.read(path)
    columns = {"height": "H_sig", "period": "T", "direction": "wave_dir"}
    asked = "direction: found the column wave_dir, allowed: what it means: --direction-is from or to"
    with pytest.raises(SeriesError, match=asked):
        series_file.read(path, columns)
    asked = "period: found the column T, allowed: which period it is: --period-is peak, zero_up_crossing"
    with pytest.raises(SeriesError, match=asked):
        series_file.read(path, columns, "to")
    found = series_file.read(path, columns, "to", period="energy")
    assert found.period == "energy"
    assert found.direction_from_deg is not None
    assert found.direction_from_deg.tolist() == [170, 190]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (PLAIN.replace("1.6", "high"), "sea.csv:3: hs: found 'high', allowed: a number, or nothing in a gap"),
        (
            PLAIN.replace("1.6", "-1"),
            "sea.csv:3: hs: found -1 at 2026-05-01T03:00:00, allowed: 0 to 30 m, or nothing in a gap",
        ),
        (PLAIN.replace("T03", "T00"), "sea.csv:3: time: found 2026-05-01T00:00:00 after 2026-05-01T00"),
        (
            PLAIN.replace("2026-05-01T03:00", "1 May"),
            "sea.csv:3: time: found '1 May', allowed: a time in ISO",
        ),
        (PLAIN.replace(",10\n", "\n"), "sea.csv:3: cells: found 3, allowed: 4, as the header has"),
        (PLAIN.replace("hs", "hs (ft)"), r"sea.csv:1: unit of hs \(ft\): found 'ft', allowed: m"),
        (PLAIN.replace("tp", "hm0"), "sea.csv:1: Hs: found hs, hm0, allowed: one column"),
        (PLAIN.replace("tp", "power"), "sea.csv:1: period: found time, hs, power, mwd, allowed: a column"),
        ("time,hs,tp\n2026-05-01,,8\n", "sea.csv: hs: found gaps alone"),
        ("time,hs,tp\n", "sea.csv: rows: found 0"),
    ],
)
def test_the_error_for_a_wrong_series_names_the_line(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(SeriesError, match=message) as caught:
        series_file.read(written(tmp_path, text))
    assert isinstance(caught.value, KingpostError)


def test_a_period_column_with_its_kind_in_full_needs_no_option(tmp_path: Path) -> None:
    path = written(tmp_path, PLAIN.replace("tp", "Zero-up-crossing period(s)"))
    assert series_file.read(path).period == "zero_up_crossing"


def test_directions_that_may_be_in_radians_require_their_unit(tmp_path: Path) -> None:
    """Source: a hindcast in radians read as degrees, all seas from ahead: GO instead of NO-GO."""
    text = "time,hs,tp,mwd\n2026-05-01T00:00,1.5,8,4.712389\n2026-05-01T03:00,1.6,8.5,0.785398\n"
    with pytest.raises(
        SeriesError, match=r"mwd: found no unit, and all values from 0.785398 to 4.71239, allowed: --"
    ):
        series_file.read(written(tmp_path, text))
    for found in (
        series_file.read(written(tmp_path, text), direction_unit="rad"),
        series_file.read(written(tmp_path, text.replace("mwd", "mwd (rad)"))),
    ):
        assert found.direction_from_deg == pytest.approx([270, 45], abs=1e-4)
    small = series_file.read(written(tmp_path, text.replace("mwd", "mwd (deg)"))).direction_from_deg
    assert small == pytest.approx([4.712389, 0.785398])
    with pytest.raises(SeriesError, match="direction_unit: found 'grad', allowed: deg, rad"):
        series_file.read(written(tmp_path, text), direction_unit="grad")


@pytest.mark.parametrize(
    ("row", "message"),
    [
        ("2026-05-01T00:00,130,8,10", "hs: found 130 at 2026-05-01T00:00:00, allowed: 0 to 30 m"),
        ("2026-05-01T00:00,1.3,8000,10", "tp: found 8000 at 2026-05-01T00:00:00, allowed: 0 to 40 s"),
    ],
)
def test_heights_and_periods_beyond_any_sea_are_refused(tmp_path: Path, row: str, message: str) -> None:
    with pytest.raises(SeriesError, match=message):
        series_file.read(written(tmp_path, f"time,hs,tp,mwd\n{row}\n"))


def test_files_that_are_not_series_are_refused(tmp_path: Path) -> None:
    with pytest.raises(SeriesError, match=r"no\.csv: file: found none"):
        series_file.read(tmp_path / "no.csv")
    with pytest.raises(SeriesError, match=r"bad\.nc: file: found what xarray cannot open"):
        series_file.read(written(tmp_path, "no NetCDF", "bad.nc"))
    with pytest.raises(SeriesError, match="columns: found 'wind', allowed: time, height"):
        series_file.read(written(tmp_path, PLAIN), {"wind": "u10"})
    with pytest.raises(SeriesError, match="columns: found 'u10', allowed: time, hs, tp, mwd"):
        series_file.read(written(tmp_path, PLAIN), {"height": "u10"})
