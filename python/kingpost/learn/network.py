"""Policies as small neural networks, and their files of plain numbers."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import KingpostError
from ..output import write_text
from ..reading import text_of
from .policies import Policy
from .task import LARGEST_OBSERVATION, Task

DIGITS = 6
"""Significant digits of the weights in a file; the policy, also for its score, has the rounded weights."""


@dataclass(frozen=True)
class NeuralPolicy:
    """A multilayer perceptron with tanh: actions ``a = tanh(W_n tanh(... tanh(W_1 o + b_1)) + b_n)``.

    The observations o are over their scales, as the environment gives them, clipped to ten scales; the
    actions are from -1 to 1. It has no internal state (Goodfellow, Bengio & Courville, *Deep Learning*, 2016,
    sec. 6.1, 6.3).

    Attributes
    ----------
    environment
        Name of the environment of the policy.
    observations
        Names of the observations.
    units
        Their units before they are divided by their scales.
    scales
        Their scales, in these units.
    actions
        Names of the inputs that it sets.
    action_units
        Their units.
    bounds
        Lower and upper value of each input: actions of -1 and 1.
    control_period_s
        Time between two actions, s.
    layers
        Weights and biases of each layer, as W (outputs x inputs) and b.
    about
        Settings of the training and the score, by name.

    Examples
    --------
    >>> from kingpost.learn import anti_sway
    >>> policy = untrained(anti_sway(), "Kingpost/AntiSway-v0", [4])
    >>> policy(np.zeros((3, 12))).tolist()
    [[0.0, 0.0], [0.0, 0.0], [0.0, 0.0]]
    """

    environment: str
    observations: tuple[str, ...]
    units: tuple[str, ...]
    scales: tuple[float, ...]
    actions: tuple[str, ...]
    action_units: tuple[str, ...]
    bounds: tuple[tuple[float, float], ...]
    control_period_s: float
    layers: tuple[tuple[np.ndarray, np.ndarray], ...]
    about: dict[str, Any]

    def __call__(self, seen: np.ndarray) -> np.ndarray:
        """Actions from observations over their scales, a row for each environment."""
        # In C order, on which the order of summation below depends.
        given = np.ascontiguousarray(seen, np.float64)
        signal = np.clip(given, -LARGEST_OBSERVATION, LARGEST_OBSERVATION)
        for weights, biases in self.layers:
            # Not a matrix product: its sums would depend on the library's number of threads.
            signal = np.tanh(np.einsum("ei,oi->eo", signal, weights) + biases)
        return signal

    def of(self, task: Task) -> Policy:
        """Adapt the policy to a task with more observations, another order or other scales, by the names of
        observations.

        Raises
        ------
        KingpostError
            If the task does not see what the policy needs.
        """
        places, ratios = self._picked(task)
        return lambda seen: self(np.asarray(seen, np.float64)[:, places] * ratios)

    def begun_for(self, task: Task, environment: str) -> NeuralPolicy:
        """Extend the policy to all observations of a task with the same actions: weights of the added
        observations are zero.

        Raises
        ------
        KingpostError
            If the task does not see what the policy needs.
        """
        places, ratios = self._picked(task)
        (first, biases), *others = self.layers
        weights = np.zeros((len(biases), len(task.seen)))
        weights[:, places] = first * ratios
        empty = untrained(task, environment, [len(biases) for _, biases in self.layers[:-1]])
        return replace(empty, layers=((weights, biases), *others))

    def _picked(self, task: Task) -> tuple[list[int], np.ndarray]:
        """Indices of the policy's observations in a task, and ratios of the task's scales to the policy's."""
        seen = list(task.observation_names)
        missing = [name for name in self.observations if name not in seen]
        if missing:
            allowed = f"a task with {', '.join(missing)}"
            raise KingpostError(f"observations: found {', '.join(seen)}, allowed: {allowed}")
        places = [seen.index(name) for name in self.observations]
        return places, np.array([task.seen[place].scale for place in places]) / np.array(self.scales)

    @cached_property
    def numbers(self) -> np.ndarray:
        """All weights and biases, layer by layer."""
        return np.concatenate([part.ravel() for layer in self.layers for part in layer])

    def with_numbers(self, numbers: np.ndarray) -> NeuralPolicy:
        """Return this network with other weights and biases, in the order of `numbers`."""
        shapes = [(len(biases), weights.shape[1]) for weights, biases in self.layers]
        return replace(self, layers=tuple(taken(numbers, shapes)))

    def json(self) -> str:
        """Text of the policy's file."""
        rows = [{"weights": _rows(weights), "biases": _rounded(biases)} for weights, biases in self.layers]
        observed = zip(self.observations, self.units, self.scales, strict=True)
        acting = zip(self.actions, self.action_units, self.bounds, strict=True)
        head = {
            "environment": self.environment,
            "control_period_s": self.control_period_s,
            "observations": [{"name": a, "unit": b, "scale": c} for a, b, c in observed],
            "actions": [{"name": a, "unit": b, "lower": c[0], "upper": c[1]} for a, b, c in acting],
            "about": self.about,
        }
        lines = json.dumps(head, indent=1).removesuffix("\n}")
        layers = ",\n".join(f"  {json.dumps(row)}" for row in rows)
        return f'{lines},\n "layers": [\n{layers}\n ]\n}}\n'

    def save(self, path: str | Path) -> None:
        """Write the policy to a file."""
        write_text(path, self.json())


def _rounded(values: np.ndarray) -> list[float]:
    return [float(f"{value:.{DIGITS}g}") for value in values]


def _rows(matrix: np.ndarray) -> list[list[float]]:
    return [_rounded(row) for row in matrix]


def taken(numbers: np.ndarray, shapes: Sequence[tuple[int, int]]) -> list[tuple[np.ndarray, np.ndarray]]:
    """Layers from their numbers; leading axes of `numbers` stay.

    >>> [(w.shape, b.shape) for w, b in taken(np.zeros((5, 11)), [(3, 2), (1, 1)])]
    [((5, 3, 2), (5, 3)), ((5, 1, 1), (5, 1))]
    """
    layers, at = [], 0
    for outputs, inputs in shapes:
        middle, end = at + outputs * inputs, at + outputs * (inputs + 1)
        weights = numbers[..., at:middle].reshape(*numbers.shape[:-1], outputs, inputs)
        layers.append((weights, numbers[..., middle:end]))
        at = end
    return layers


def untrained(task: Task, environment: str, hidden: Sequence[int]) -> NeuralPolicy:
    """A network of zeros with layers of these sizes between observations and actions.

    >>> from kingpost.learn import anti_sway
    >>> untrained(anti_sway(), "Kingpost/AntiSway-v0", [16]).numbers.size
    242
    """
    sizes = [len(task.seen), *hidden, len(task.set)]
    layers = [(np.zeros((out, into)), np.zeros(out)) for into, out in pairwise(sizes)]
    return NeuralPolicy(
        environment,
        task.observation_names,
        task.observation_units,
        tuple(one.scale for one in task.seen),
        task.action_names,
        task.action_units,
        tuple(task.bounds),
        task.control_period_s,
        tuple(layers),
        {},
    )


def read_policy(path: str | Path) -> NeuralPolicy:
    """Read a policy from its file.

    Parameters
    ----------
    path
        The file, as `NeuralPolicy.save` writes it.

    Returns
    -------
    NeuralPolicy
        The policy.

    Raises
    ------
    KingpostError
        If the file does not contain a policy, or its layers do not fit.

    >>> from kingpost.learn import trained
    >>> trained("Kingpost/AntiSway-v0").actions
    ('slewing', 'luffing')
    """
    try:
        given = json.loads(text_of(path, "utf-8"))
        seen, set_ = given["observations"], given["actions"]
        layers = tuple(
            (np.array(one["weights"], np.float64), np.array(one["biases"], np.float64))
            for one in given["layers"]
        )
        policy = NeuralPolicy(
            given["environment"],
            tuple(one["name"] for one in seen),
            tuple(one["unit"] for one in seen),
            tuple(float(one["scale"]) for one in seen),
            tuple(one["name"] for one in set_),
            tuple(one["unit"] for one in set_),
            tuple((float(one["lower"]), float(one["upper"])) for one in set_),
            float(given["control_period_s"]),
            layers,
            given.get("about", {}),
        )
    except OSError as error:
        raise KingpostError(f"{path}: found {error.strerror}, allowed: a file of a policy") from None
    except (ValueError, KeyError, TypeError) as error:
        raise KingpostError(f"{path}: found no policy ({error}), allowed: a file of a policy") from error
    _check(path, policy)
    return policy


def _check(path: str | Path, policy: NeuralPolicy) -> None:
    """Refuse layers whose sizes do not match."""
    inputs = len(policy.observations)
    for k, (weights, biases) in enumerate(policy.layers):
        if weights.shape != (len(biases), inputs):
            raise KingpostError(
                f"{path}: layers.{k}: found weights of the shape {weights.shape}, "
                f"allowed: {(len(biases), inputs)}"
            )
        if not (np.isfinite(weights).all() and np.isfinite(biases).all()):
            raise KingpostError(f"{path}: layers.{k}: found NaN or infinity, allowed: finite numbers")
        inputs = len(biases)
    if inputs != len(policy.actions):
        raise KingpostError(f"{path}: layers: found {inputs} outputs, allowed: {len(policy.actions)}")
