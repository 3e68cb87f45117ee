"""``python -m kingpost.learn scores [FILE]`` and ``python -m kingpost.learn train FILE``."""

from __future__ import annotations

import argparse
from dataclasses import asdict, replace
from pathlib import Path

from .evolution import Training, train
from .pretrained import FILES, trained
from .registered import IDS
from .scores import score, table

START, END = "<!-- scores: start -->", "<!-- scores: end -->"


def write_scores(page: Path) -> None:
    """Write the scores of all controllers into a page, between its marks."""
    found = table()
    text = page.read_text(encoding="utf-8") if page.is_file() else f"{START}{END}"
    before, after = text.split(START)[0], text.split(END)[-1]
    page.write_text(f"{before}{START}\n\n{found}\n{END}{after}", encoding="utf-8")


def write_policy(given: argparse.Namespace) -> None:
    """Train a policy, score it on the episodes of the table, and write its file."""
    task = IDS[given.environment]()
    spread, rate = tuple(given.spread), tuple(given.rate)
    sizes = (given.generations, given.pairs, given.episodes, (given.hidden,))
    training = Training(*sizes, spread, rate, given.seed)
    start = None if given.start is None else trained(given.start).begun_for(task, given.environment)

    def shown(generation: int, mean: float) -> None:
        if generation % 10 == 0 or generation + 1 == training.generations:
            print(f"generation {generation}: mean score {mean:.2f}", flush=True)

    policy = train(task, given.environment, training, start, given.threads, shown)
    scores = score(task, lambda _: policy, threads=given.threads)
    about = {
        "training": asdict(training) | ({} if start is None else {"start": given.start}),
        "score": {"mean": float(scores.mean()), "worst": float(scores.min())},
    }
    replace(policy, about=about).save(given.file)
    print(f"{given.file}: mean score {scores.mean():.2f}, worst {scores.min():.2f}")


def main(words: list[str] | None = None) -> None:
    """The command line."""
    default = Training()
    parser = argparse.ArgumentParser(
        "python -m kingpost.learn", description="Scores and training of controllers."
    )
    commands = parser.add_subparsers(dest="command")
    scores = commands.add_parser("scores", help="write all controllers' scores into a page")
    scores.add_argument("file", nargs="?", type=Path, default=Path("docs/learning.md"))
    training = commands.add_parser("train", help="train a policy and write its file")
    training.add_argument("file", type=Path)
    training.add_argument("--environment", choices=list(IDS), default=next(iter(IDS)))
    for name in ("generations", "pairs", "episodes", "seed"):
        training.add_argument(f"--{name}", type=int, default=getattr(default, name))
    for name in ("spread", "rate"):
        first_and_last = {"nargs": 2, "default": getattr(default, name), "metavar": ("FIRST", "LAST")}
        training.add_argument(f"--{name}", type=float, **first_and_last)
    training.add_argument("--start", choices=list(FILES), help="begin with the policy of this environment")
    training.add_argument("--hidden", type=int, default=default.hidden[0], help="size of the hidden layer")
    training.add_argument("--threads", type=int, default=1)
    given = parser.parse_args(words)
    if given.command == "train":
        write_policy(given)
    else:
        write_scores(getattr(given, "file", Path("docs/learning.md")))


if __name__ == "__main__":
    main()
