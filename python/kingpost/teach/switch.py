"""The D switch: the effect of leaving out the restricted variation on energy and momentum."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..scenario import Overrides, Scenario, load
from ..simulation.simulate import run

if TYPE_CHECKING:
    import xarray

FORMS = {"with D": "moving_frame", "without D": "moving_frame_without_d"}


def with_and_without_d(
    scenario_or_path: Scenario | str | Path, overrides: Overrides | None = None, **parameters: Any
) -> xarray.Dataset:
    """Run a scenario with D (paper eq. 57) and with D = 0, side by side along the dimension ``form``.

    The term with D does no work, omega^T S(omega) J omega = 0, so ``energy_error`` stays small
    in both; ``momentum_error`` grows without it.

    >>> runs = with_and_without_d("paper", {"simulation.duration_s": 0.5}, crane_x_m=0, crane_y_m=0)
    >>> runs.momentum_error.isel(time=-1).round(3).values > 1
    array([False,  True])
    """
    import xarray

    if isinstance(scenario_or_path, Scenario):
        scenario = scenario_or_path.with_overrides(overrides, **parameters)
    else:
        scenario = load(scenario_or_path, overrides, **parameters)
    runs = [run(scenario, {"simulation.form": form}) for form in FORMS.values()]
    form = xarray.DataArray(list(FORMS), dims="form", name="form")
    return xarray.concat(runs, form, combine_attrs="drop_conflicts")
