"""Training of policies by an evolution strategy."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from .episodes import Episodes
from .network import NeuralPolicy, taken, untrained
from .task import Task

FIRST_SEED = 1_000_000
"""First seed of the training episodes; the seeds of the scores are far below it."""
FORGETS = (0.9, 0.99)
"""Decay rates of the averages of the gradient and of its square (Adam's beta_1, beta_2)."""
Shown = Callable[[int, float], None]
"""Called after each generation with its number and the mean score of its candidates."""


@dataclass(frozen=True)
class Training:
    """Settings of the training of a policy.

    Attributes
    ----------
    generations
        Number of updates of the weights.
    pairs
        Number of pairs of candidates, on either side of the present weights, in each generation.
    episodes
        Number of episodes of each candidate; all candidates of a generation have the same episodes.
    hidden
        Sizes of the layers between observations and actions.
    spread
        Standard deviation of the candidates' weights at the start and at the end; its logarithm falls
        linearly.
    rate
        Size of an update of a weight, at the start and at the end.
    seed
        Seed of all random numbers.
    """

    generations: int = 250
    pairs: int = 32
    episodes: int = 8
    hidden: tuple[int, ...] = (16,)
    spread: tuple[float, float] = (0.1, 0.02)
    rate: tuple[float, float] = (0.05, 0.005)
    seed: int = 1


def train(
    task: Task,
    environment: str,
    training: Training | None = None,
    start: NeuralPolicy | None = None,
    threads: int = 1,
    shown: Shown | None = None,
) -> NeuralPolicy:
    """Train a policy by an evolution strategy.

    Each generation tries weights ``w + s e`` and ``w - s e`` with normal e, and moves w along the gradient
    of the expected score that their ranks estimate (Salimans et al., "Evolution strategies as a scalable
    alternative to reinforcement learning", arXiv 1703.03864, 2017; the steps are Adam's, Kingma & Ba, ICLR
    2015). The same seed gives the same weights to the last bit, whatever the number of threads.

    Parameters
    ----------
    task
        Task to learn.
    environment
        The name of the task's environment, for the file.
    training
        Settings of the training.
    start
        A policy to begin with; default: random weights with zeros in the last layer.
    threads
        Threads that step the episodes; 0 takes as many as the machine has.
    shown
        Called after each generation.

    Returns
    -------
    NeuralPolicy
        The policy, its weights rounded as in its file.

    Examples
    --------
    >>> from kingpost.learn import anti_sway
    >>> few = Training(generations=1, pairs=1, episodes=1, hidden=(4,))
    >>> train(anti_sway(), "Kingpost/AntiSway-v0", few).layers[0][0].shape
    (4, 12)
    """
    training = Training() if training is None else training
    random = np.random.default_rng(training.seed)
    policy = _begun(task, environment, training, random) if start is None else start
    numbers, shapes = policy.numbers.copy(), [weights.shape for weights, _ in policy.layers]
    episodes = Episodes(task, 2 * training.pairs * training.episodes, threads)
    momentum, square = np.zeros_like(numbers), np.zeros_like(numbers)
    for generation in range(training.generations):
        share = generation / max(1, training.generations - 1)
        spread, rate = (first * (last / first) ** share for first, last in (training.spread, training.rate))
        aside = random.standard_normal((training.pairs, numbers.size))
        candidates = np.concatenate([numbers + spread * aside, numbers - spread * aside])
        first_seed = FIRST_SEED + training.seed * 100_000_000 + generation * training.episodes
        seeds = range(first_seed, first_seed + training.episodes)
        scores = candidate_scores(episodes, candidates, shapes, seeds)
        ranks = centred_ranks(scores)
        apart = ranks[: training.pairs] - ranks[training.pairs :]
        # Not a matrix product: its sums would depend on the library's number of threads.
        climb = np.einsum("p,pn->n", apart, aside) / (2 * training.pairs * spread)
        momentum = FORGETS[0] * momentum + (1 - FORGETS[0]) * climb
        square = FORGETS[1] * square + (1 - FORGETS[1]) * climb**2
        corrected = [1 - forget ** (generation + 1) for forget in FORGETS]
        numbers += rate * (momentum / corrected[0]) / (np.sqrt(square / corrected[1]) + 1e-8)
        if shown is not None:
            shown(generation, float(scores.mean()))
    rounded = np.array([float(f"{value:.6g}") for value in numbers])
    return policy.with_numbers(rounded)


def _begun(task: Task, environment: str, training: Training, random: np.random.Generator) -> NeuralPolicy:
    """Random weights that preserve the variance of a signal; the last layer is zero, so that the first
    actions are zero."""
    empty = untrained(task, environment, training.hidden)
    layers = [
        (random.standard_normal(weights.shape) / np.sqrt(weights.shape[1]), biases)
        for weights, biases in empty.layers[:-1]
    ]
    return replace(empty, layers=(*layers, empty.layers[-1]))


def candidate_scores(
    episodes: Episodes, candidates: np.ndarray, shapes: Sequence[tuple[int, ...]], seeds: Sequence[int]
) -> np.ndarray:
    """The mean score of each candidate's weights over episodes with these seeds."""
    count, each = len(candidates), len(seeds)
    layers = taken(candidates, [(shape[0], shape[1]) for shape in shapes])
    episodes.begin({copy: np.random.default_rng(seeds[copy % each]) for copy in range(count * each)})
    seen = episodes.observations()
    sums, going = np.zeros(count * each), np.ones(count * each, np.bool_)
    for _ in range(episodes.episode_steps):
        signal = seen.reshape(count, each, -1).astype(np.float64)
        for weights, biases in layers:
            signal = np.tanh(np.einsum("cei,coi->ceo", signal, weights) + biases[:, None])
        seen, rewards, terminated, truncated = episodes.step(signal.reshape(count * each, -1))
        sums += np.where(going, rewards, 0.0)
        going &= ~(terminated | truncated)
    return sums.reshape(count, each).mean(axis=1)


def centred_ranks(scores: np.ndarray) -> np.ndarray:
    """Ranks from -1/2 for the worst score to 1/2 for the best; equal scores keep their order.

    >>> centred_ranks(np.array([5.0, -1, 7])).tolist()
    [0.0, -0.5, 0.5]
    """
    ranks = np.empty(len(scores))
    ranks[np.argsort(scores, kind="stable")] = np.arange(len(scores))
    return ranks / max(1, len(scores) - 1) - 0.5
