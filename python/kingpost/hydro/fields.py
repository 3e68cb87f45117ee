"""Checked access to the fields of a tree read from JSON; each error names the field."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import HydrodynamicsError, shortened

if TYPE_CHECKING:
    from numpy.typing import NDArray

_LONGEST_SHOWN = 60


@dataclass(frozen=True)
class Fields:
    """One object of the tree and its path."""

    values: dict[str, Any]
    path: str
    file: str | None

    @classmethod
    def of(
        cls, value: object, path: str, file: str | None, names: Sequence[str], optional: Sequence[str] = ()
    ) -> Fields:
        """Check that an object has these fields and no others; missing optional fields become null."""
        if not isinstance(value, dict):
            raise HydrodynamicsError(path, shown(value), "an object", file)
        value, names = {**dict.fromkeys(optional), **value}, (*names, *optional)
        fields = cls(value, path, file)
        for name in names:
            if name not in value:
                raise HydrodynamicsError(fields.at(name), "nothing", "this field is required", file)
        for name in value:
            if name not in names:
                raise HydrodynamicsError(fields.at(name), "an unknown field", ", ".join(names), file)
        return fields

    def at(self, name: str) -> str:
        """Path of one of the object's fields."""
        return f"{self.path}.{name}" if self.path else name

    def wrong(self, name: str, found: object, allowed: str) -> HydrodynamicsError:
        """Make the error for one of the object's fields."""
        return HydrodynamicsError(self.at(name), found, allowed, self.file)

    def fields(self, name: str, names: Sequence[str], optional: Sequence[str] = ()) -> Fields:
        """Read a field that is an object with these fields."""
        return Fields.of(self.values[name], self.at(name), self.file, names, optional)

    def constant(self, name: str, allowed: object) -> None:
        """Check a field with a single allowed value."""
        if self.values[name] != allowed:
            raise self.wrong(name, shown(self.values[name]), repr(allowed))

    def text(self, name: str) -> str:
        """Read a text field."""
        if not isinstance(self.values[name], str):
            raise self.wrong(name, shown(self.values[name]), "text")
        return self.values[name]

    def texts(self, name: str) -> tuple[str, ...]:
        """Read a field with a list of texts."""
        value = self.values[name]
        if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
            raise self.wrong(name, shown(value), "a list of texts")
        return tuple(value)

    def count(self, name: str) -> int | None:
        """Read a field with a non-negative whole number or null."""
        value = self.values[name]
        if value is None:
            return None
        if not isinstance(value, int) or isinstance(value, bool) or value < 0:
            raise self.wrong(name, shown(value), "null or a whole number from 0")
        return value

    def number(self, name: str, *, positive: bool = False) -> float:
        """Read a field with a finite number, greater than 0 if required."""
        value = self.values[name]
        allowed = "a number greater than 0" if positive else "a finite number"
        if not isinstance(value, int | float) or isinstance(value, bool):
            raise self.wrong(name, shown(value), allowed)
        try:
            number = float(value)
        except OverflowError:  # a whole number of more than 308 digits
            number = math.inf
        if not math.isfinite(number) or (positive and number <= 0):
            raise self.wrong(name, shown(value), allowed)
        return number

    def numbers(self, name: str, *shape: int | None) -> NDArray[np.float64]:
        """Read a field with a nested list of finite numbers; `None` in the shape stands for any length."""
        allowed = f"numbers in the shape {_shape(shape)}"
        value = self.values[name]
        try:
            array = np.array(value)
        except ValueError:
            raise self.wrong(name, "lists of unequal lengths", allowed) from None
        if array.size == 0 and 0 in array.shape:
            # An empty list does not determine the length of its members.
            array = np.zeros([0 if length is None else length for length in shape])
        if array.dtype.kind not in "iuf":
            raise self.wrong(name, shown(value), allowed)
        fits = len(shape) == array.ndim and all(
            wanted in (None, length) for wanted, length in zip(shape, array.shape, strict=True)
        )
        if not fits:
            raise self.wrong(name, f"the shape {_shape(array.shape)}", allowed)
        if not np.isfinite(array).all():
            place = np.argwhere(~np.isfinite(array))[0]
            where = name + "".join(f"[{index}]" for index in place)
            raise self.wrong(where, array[tuple(place)], "a finite number")
        array = array.astype(np.float64)
        array.setflags(write=False)
        return array


def shown(value: object) -> str:
    """Format a value for an error message, shortened if it is long."""
    return shortened("null" if value is None else repr(value), _LONGEST_SHOWN)


def _shape(shape: Sequence[int | None]) -> str:
    return " x ".join("n" if length is None else str(length) for length in shape) or "of a single number"
