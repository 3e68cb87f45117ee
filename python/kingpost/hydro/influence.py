"""Influence matrices of a hull with planes of symmetry, in the memory that the least of them needs.

The matrix between all panels of a hull of 2^p like parts consists of 2^p different blocks: between parts i
and j stands the block i XOR j. The Walsh-Hadamard transform over the parts makes it block diagonal, so that
one system of 2^p n unknowns falls into 2^p of n (`scipy.linalg.hadamard` has the matrix of the transform).
Blocks are transformed and factored where they stand: S and D take 2 x 2^p matrices of n x n complex numbers
and nothing beside them. Capytaine's own engine writes the blocks of two planes out in matrices of
twice the size, which it copies and keeps: ten times as much at its peak.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import HydrodynamicsError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray


def transform(parts: Sequence[NDArray]) -> None:
    """Walsh-Hadamard transform over arrays of one shape, their number a power of two, in place.

    Twice it is the number of the arrays.

    >>> a, b = np.array([5.0]), np.array([3.0])
    >>> transform([a, b])
    >>> a, b
    (array([8.]), array([2.]))
    """
    half = 1
    while half < len(parts):
        for first in range(len(parts)):
            if not first & half:
                a, b = parts[first], parts[first | half]
                a += b
                b *= -2.0
                b += a
        half *= 2


class Influence:
    """The matrix whose first column of blocks is given; the blocks are transformed where they stand.

    Parameters
    ----------
    blocks
        (n, n) each, Fortran's order, the influence of the first part's panels on those of each part.
    """

    def __init__(self, blocks: list[NDArray]) -> None:
        transform(blocks)
        self.blocks, self.factors = blocks, []
        self.dtype = blocks[0].dtype
        size = len(blocks) * len(blocks[0])
        self.shape = (size, size)

    def __matmul__(self, vector: Any) -> NDArray:
        if not isinstance(vector, np.ndarray):
            return NotImplemented
        return self._by_block(vector, [block.__matmul__ for block in self.blocks])

    def solve(self, vector: NDArray) -> NDArray:
        """x of A x = vector. The first call overwrites the matrix by its factors, which are kept."""
        from scipy.linalg import lu_factor

        while self.blocks:
            self.factors.append(lu_factor(self.blocks.pop(0), overwrite_a=True, check_finite=False))
        return self._by_block(vector, [_solver(factor) for factor in self.factors])

    def _by_block(self, vector: NDArray, maps: Sequence[Any]) -> NDArray:
        parts = np.array(np.split(vector, len(maps)), dtype=self.dtype)
        transform(parts)
        found = np.array([map_(part) for map_, part in zip(maps, parts, strict=True)])
        transform(found)
        return found.reshape(-1) / len(maps)


def _solver(factor: Any) -> Any:
    from scipy.linalg import lu_solve

    return lambda vector: lu_solve(factor, vector, check_finite=False)


class Engine:
    """What Capytaine's solver asks of an engine: the matrices S and D of a hull, and x of D x = b.

    It has the matrices of one frequency and lets them go before it builds the next.

    Parameters
    ----------
    green_function
        One of Capytaine's.
    """

    def __init__(self, green_function: Any) -> None:
        self.green_function = green_function
        self.exportable_settings = {"engine": "kingpost", **green_function.exportable_settings}
        self.forget()

    def forget(self) -> None:
        """Let the matrices go."""
        self._mesh: Any = None
        self._settings: dict[str, Any] = {}
        self._matrices: tuple[Influence, Influence] | None = None

    def build_matrices(self, mesh: Any, _same: Any, **settings: Any) -> tuple[Influence, Influence]:
        """S and D between the panels of a mesh."""
        if self._matrices is None or mesh is not self._mesh or settings != self._settings:
            self.forget()
            self._matrices = self._build(parts_of(mesh), settings)
            self._mesh, self._settings = mesh, settings
        return self._matrices

    def _build(self, parts: Sequence[Any], settings: dict[str, Any]) -> tuple[Influence, Influence]:
        single, double = [], []
        for number, part in enumerate(parts):
            # The jump of the double layer is that of panels on themselves.
            at_home = {**settings, "diagonal_term_in_double_layer": number == 0}
            s, d = self.green_function.evaluate(part, parts[0], early_dot_product=True, **at_home)
            # Sums need no memory, and one NaN spoils them.
            if not np.isfinite(s.sum() + d.sum()):
                found = f"panels between which there is no influence at {settings}"
                raise HydrodynamicsError("hull", found, "panels that do not overlap")
            single.append(s)
            double.append(d)
        return Influence(single), Influence(double)

    def linear_solver(self, matrix: Influence, vector: NDArray) -> NDArray:
        """x of matrix x = vector."""
        return matrix.solve(vector)


def parts_of(mesh: Any) -> list[Any]:
    """The like parts of one of Capytaine's meshes, the order of its panels; itself where it has no plane."""
    if hasattr(mesh, "other_half"):
        return [*parts_of(mesh.half), *parts_of(mesh.other_half)]
    return [mesh]
