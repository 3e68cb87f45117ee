"""Influence matrices of a hull with planes of symmetry, with minimal memory.

For a hull of 2^p mirrored parts, the matrix between all panels has 2^p different blocks: the block between
parts i and j is block i XOR j. The Walsh-Hadamard transform over the parts makes it block diagonal, so that
one system of 2^p n unknowns becomes 2^p systems of n unknowns (`scipy.linalg.hadamard` has the matrix of the
transform).
Blocks are transformed and factored in place: S and D need 2 x 2^p matrices of n x n complex numbers and
nothing else. For two planes, Capytaine's own engine expands the blocks into matrices of twice the size, which
it copies and keeps: ten times as much at its peak.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import HydrodynamicsError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray


def transform(parts: Sequence[NDArray]) -> None:
    """In-place Walsh-Hadamard transform of arrays of one shape; their number is a power of two.

    Applied twice, it multiplies by the number of the arrays.

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
    """A matrix with the given first column of blocks; the blocks are transformed in place.

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
        """Solve A x = vector, or several vectors that are the columns of a matrix. The first call overwrites
        the matrix with its factors, which are kept."""
        from scipy.linalg import lu_factor

        while self.blocks:
            self.factors.append(lu_factor(self.blocks.pop(0), overwrite_a=True, check_finite=False))
        return self._by_block(vector, [_solver(factor) for factor in self.factors])

    def _by_block(self, vector: NDArray, maps: Sequence[Any]) -> NDArray:
        parts = np.array(np.split(vector, len(maps)), dtype=self.dtype)
        transform(parts)
        found = np.array([map_(part) for map_, part in zip(maps, parts, strict=True)])
        transform(found)
        return found.reshape(vector.shape) / len(maps)


def _solver(factor: Any) -> Any:
    from scipy.linalg import lu_solve

    return lambda vector: lu_solve(factor, vector, check_finite=False)


class Engine:
    """The matrix engine for Capytaine's solver: the matrices S and D of a hull, and the solution of D x = b.

    It holds the matrices of one frequency and frees them before it builds the next.

    Parameters
    ----------
    green_function
        A Green function of Capytaine.
    """

    def __init__(self, green_function: Any) -> None:
        self.green_function = green_function
        self.exportable_settings = {"engine": "kingpost", **green_function.exportable_settings}
        self.forget()

    def forget(self) -> None:
        """Free the matrices."""
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
            # The jump term of the double layer acts on the diagonal.
            at_home = {**settings, "diagonal_term_in_double_layer": number == 0}
            s, d = self.green_function.evaluate(part, parts[0], early_dot_product=True, **at_home)
            # The sum needs no temporary array and is NaN if any entry is NaN.
            if not np.isfinite(s.sum() + d.sum()):
                found = f"panels between which there is no influence at {settings}"
                raise HydrodynamicsError("hull", found, "panels that do not overlap")
            single.append(s)
            double.append(d)
        return Influence(single), Influence(double)

    def linear_solver(self, matrix: Influence, vector: NDArray) -> NDArray:
        """Solve matrix x = vector."""
        return matrix.solve(vector)


def parts_of(mesh: Any) -> list[Any]:
    """The mirrored parts of a Capytaine mesh, in the order of its panels; the mesh itself if it has no
    symmetry plane."""
    if hasattr(mesh, "other_half"):
        return [*parts_of(mesh.half), *parts_of(mesh.other_half)]
    return [mesh]
