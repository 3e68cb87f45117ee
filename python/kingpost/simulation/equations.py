"""Computations at the present state of a simulation: matrices, accelerations, linearisation, equilibrium,
RAOs, hydrostatics."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import KingpostError
from ..given import numbers
from .linear import Equilibrium, Linearization, labelled
from .matrices import MovingFrame
from .records import WaveSystem

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ..engine import engine
    from ..scenario import Scenario


MOST_DENSE = 2000
"""Largest number of free coordinates for dense matrices: a matrix of twice as many states takes 128 MB."""


class Equations:
    """The methods of `kingpost.Simulation` that compute at the present state, without a step."""

    scenario: Scenario
    _engine: engine.Simulation

    def acceleration(self, tau: ArrayLike | None = None) -> NDArray[np.float64]:
        """Accelerations of the free coordinates now (m/s2 or rad/s2).

        `tau` adds a generalized force per free coordinate (N or N m) to the acting loads.

        Parameters
        ----------
        tau
            A generalized force for each free coordinate, shape (coordinates,), N or N m.

        Returns
        -------
        numpy.ndarray
            Shape (coordinates,), m/s2 or rad/s2.

        Raises
        ------
        KingpostError
            If `tau` has another length.

        >>> from kingpost import Simulation, load
        >>> Simulation(load("paper")).acceleration().shape
        (5,)
        """
        return self._engine.acceleration(None if tau is None else numbers("tau", tau))

    def mass_matrix(self) -> NDArray[np.float64]:
        """Reduced mass matrix M* = B^T M B of the free coordinates (kg, kg m, kg m2).

        Returns
        -------
        numpy.ndarray
            Shape (coordinates, coordinates), symmetric.

        >>> from kingpost import Simulation, load
        >>> Simulation(load("paper")).mass_matrix().shape
        (5, 5)
        """
        return self._engine.mass_matrix()

    def constraint_matrix(self) -> NDArray[np.float64]:
        """J of closed loops and of taut inextensible ropes, over the free coordinates: J v = 0.

        Returns
        -------
        numpy.ndarray
            Shape (constraints, coordinates).

        >>> from kingpost import Simulation, load
        >>> Simulation(load("paper")).constraint_matrix().shape
        (0, 5)
        """
        return self._engine.constraint_matrix()

    def bias_force(self) -> NDArray[np.float64]:
        """Bias force N* v of the free coordinates (N or N m).

        Returns
        -------
        numpy.ndarray
            Shape (coordinates,).

        >>> from kingpost import Simulation, load
        >>> Simulation(load("paper")).bias_force().shape
        (5,)
        """
        return self._engine.bias_force()

    def moving_frame(self) -> MovingFrame:
        """The matrices of the moving frame method now, by name.

        Frame connection matrices ``E_ship`` and ``E_tower/ship``, their rates ``Omega_..``,
        rotations ``R_..``, then ``B``, ``B_dot``, ``X_dot``, ``M``, ``D``, ``F``, ``q_dot``,
        ``M_star``, ``N_star`` and ``F_star``, ``q_ddot_given`` if motions are prescribed, and ``J`` if there
        are closed loops or taut inextensible ropes, whose forces are not in ``F``. Each has labels and units
        by row and column. `MovingFrame` also gives their LaTeX, their formulas and their CSV files.

        Returns
        -------
        MovingFrame
            The matrices by name.

        >>> from kingpost import Simulation, load
        >>> matrices = Simulation(load("paper")).moving_frame()
        >>> matrices["M_star"].sel(row="slew", column="slew")["unit"].item()
        'kg m^2'
        """
        return MovingFrame(self._engine.moving_frame(), self._engine.symbols_json)

    def linearize(self) -> Linearization:
        """Compute A and B of the system linearised about the present state, exact to rounding.

        Returns
        -------
        Linearization
            A, B and the rates, with names and units.

        Raises
        ------
        KingpostError
            If there are more than 2,000 free coordinates.

        >>> from kingpost import Simulation, load
        >>> linear = Simulation(load("paper")).linearize()
        >>> linear.states[:2], linear.inputs
        (['ship.roll', 'ship.pitch'], [])
        """
        count = len(self._engine.coordinates())
        if count > MOST_DENSE:
            raise KingpostError(f"linearize: found {count} free coordinates, allowed: at most {MOST_DENSE}")
        return labelled(*self._engine.linearize(in_waves=True))

    def settle(self) -> Equilibrium:
        """Move to an equilibrium near the present state, with all rates zero, and restart the ledger there.

        Returns
        -------
        Equilibrium
            Number of iterations and residual.

        Raises
        ------
        KingpostError
            If there is none; the state is then unchanged.

        >>> from kingpost import Simulation, load
        >>> simulation = Simulation(load("chain"))
        >>> simulation.settle().residual < 1e-6
        True
        """
        return Equilibrium(*self._engine.settle())

    def wave_response(self, directions_rad: ArrayLike, frequencies_rad_s: ArrayLike) -> dict[str, Any]:
        """Compute complex amplitudes of all motions by direction and frequency, with the crane in its present
        state; `kingpost.rao` returns them with labels.

        Parameters
        ----------
        directions_rad
            Directions that the waves travel towards, rad.
        frequencies_rad_s
            Angular frequencies; if empty, those of the hull's database, refined.

        Returns
        -------
        dict
            ``real`` and ``imaginary`` parts of all motions, flat, and the names of the moving points and
            joints.

        Raises
        ------
        KingpostError
            If there is no equilibrium, or a database does not cover a frequency.

        >>> from kingpost import Simulation, load
        >>> found = Simulation(load("barge")).wave_response([0.0], [1.0])
        >>> found["places"]
        ['ship', 'tower', 'arm', 'load', 'tower.top', 'arm.tip']
        """
        waves = {
            "directions_rad": np.asarray(directions_rad, float).tolist(),
            "frequencies_rad_s": np.asarray(frequencies_rad_s, float).tolist(),
        }
        return json.loads(self._engine.wave_response_json(json.dumps(waves)))

    def column_response(
        self,
        directions_rad: ArrayLike,
        frequencies_rad_s: ArrayLike,
        columns: Sequence[str] = (),
        about_resonances: bool = False,
        sea: dict[str, Any] | None = None,
    ) -> dict[str, Any]:
        """Compute complex amplitudes of columns of the results by direction, frequency and column, with the
        crane in its present state; `kingpost.wave_response` returns them with labels.

        Parameters
        ----------
        directions_rad
            Directions that the waves travel towards, rad.
        frequencies_rad_s
            Angular frequencies, rad/s; if empty, those of the database, refined.
        columns
            Names of the columns; if empty, all.
        about_resonances
            Whether to add frequencies about each resonance that is narrower than the frequency steps.
        sea
            Random sea for which the drag on lines with mass is linearised: ``waves``, with ``directions_rad``
            and ``frequencies_rad_s``, and ``variances_m2`` of the elevation by direction and frequency;
            default: lines are at rest between their ends, without drag.

        Returns
        -------
        dict
            ``amplitudes``, complex, shape (directions, frequencies, columns), NaN for a column without linear
            response; ``columns``, ``units``, ``mean``, ``not_linear``, ``resonances``, ``frequencies_rad_s``,
            ``linearised`` (the lines whose drag is), ``warnings``.

        Raises
        ------
        KingpostError
            If there is no equilibrium, a database does not cover a frequency, a column is unknown, or the
            drag in `sea` is not found.

        >>> from kingpost import Simulation, load
        >>> found = Simulation(load("barge")).column_response([0.0], [1.0], ["ship.roll", "ship.pitch"])
        >>> found["amplitudes"].shape
        (1, 1, 2)
        """
        waves = {
            "directions_rad": np.asarray(directions_rad, float).tolist(),
            "frequencies_rad_s": np.asarray(frequencies_rad_s, float).tolist(),
        }
        asked = json.dumps([waves, list(columns), bool(about_resonances), sea])
        parts, about = self._engine.column_response(asked)
        found = json.loads(about)
        shape = (len(found["directions_rad"]), len(found["frequencies_rad_s"]), len(found["columns"]))
        found["amplitudes"] = parts.view(complex).reshape(shape)
        return found

    def sea_spectra(
        self,
        frequencies_rad_s: ArrayLike,
        directions: int = 1,
        seas: Sequence[dict[str, Any]] | None = None,
    ) -> list[list[WaveSystem]]:
        """Return the spectrum of each wave system of a sea, from which runs draw their waves.

        Parameters
        ----------
        frequencies_rad_s
            Angular frequencies at which the density is given, rad/s.
        directions
            Number of directions of equal energy that represent a short-crested sea.
        seas
            ``sea.waves`` of resolved scenarios, which replace that of this scenario.

        Returns
        -------
        list of list of dict
            For each enabled system of each sea: ``name``, ``directions_rad`` with equal shares of the energy,
            ``band_rad_s``, ``nodes_rad_s`` at which the density has a kink, ``density_m2_s`` (m^2 s/rad), and
            ``lines`` of waves of one frequency: angular frequency (rad/s), direction (rad), variance (m^2).

        Raises
        ------
        ScenarioError
            If a wave system is not valid.

        >>> from kingpost import Simulation, load
        >>> ((sea,),) = Simulation(load("offshore_vessel", waves=True)).sea_spectra(np.linspace(0.4, 4, 2000))
        >>> height_m = 4 * np.sqrt(np.trapezoid(sea["density_m2_s"], np.linspace(0.4, 4, 2000)))
        >>> round(float(height_m), 2)
        2.5
        """
        own = (self.scenario.resolved.get("sea") or {}).get("waves", {})
        given = [own] if seas is None else list(seas)
        frequencies = np.asarray(frequencies_rad_s, float).ravel().tolist()
        return json.loads(self._engine.sea_spectra_json(json.dumps([given, frequencies, directions])))

    def hydrostatics(self) -> dict[str, Any]:
        """Compute `Scenario.hydrostatics` with the crane in its present state: held and prescribed
        coordinates stay, the others settle in still water. The simulation itself is unchanged.

        Returns
        -------
        dict
            The same entries as `Scenario.hydrostatics`.

        Raises
        ------
        KingpostError
            If a hull weighs more than the water it displaces when fully submerged.

        >>> from kingpost import Simulation, load
        >>> simulation = Simulation(load("barge"))
        >>> simulation.hydrostatics()["hulls"][0]["body"]
        'ship'
        """
        return json.loads(self._engine.hydrostatics_json())
