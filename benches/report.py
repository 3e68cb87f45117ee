"""Evaluation of a run's figures: ratios, speeds, growth along chains, and the sections of README.md."""

from __future__ import annotations

import datetime
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from pathlib import Path

import models
from measure import Figure

README = Path(__file__).resolve().parent / "README.md"


def ratios(figures: Sequence[Figure]) -> Iterator[str]:
    """Ratio of each of Kingpost's figures to each peer's for the same work on the same model."""
    for ours in figures:
        if not ours.engine.startswith("kingpost"):
            continue
        for peer in figures:
            same = ours.model == peer.model and peer.operation in _same_work(ours.operation)
            if not same or peer.engine.startswith("kingpost"):
                continue
            yield (
                f"{ours.engine} {ours.operation} / {peer.engine} {peer.operation}, {ours.model}: "
                f"{_ratio(ours, peer)}"
            )


def _same_work(operation: str) -> tuple[str, ...]:
    """The peers' operations to compare with one of Kingpost's: a step in lanes also counts as a step of many
    runs."""
    if operation.startswith("lanes_"):
        scheme = operation.removeprefix("lanes_")
        return (f"{scheme}_step", f"batch_{scheme}_1")
    return (operation.removesuffix("_ledger"),)


def _ratio(ours: Figure, peer: Figure) -> str:
    """Ratio of times, and of instructions if both are counted."""
    text = f"time {ours.median_ns / peer.median_ns:.2f}"
    if ours.instructions and peer.instructions:
        text += f", instructions {ours.instructions / peer.instructions:.2f}"
    return text


def speeds(figures: Sequence[Figure]) -> Iterator[str]:
    """Speed of a ship in the water relative to real time, and the share of WASM."""
    afloat = [figure for figure in figures if figure.model in map(models.afloat_name, models.AFLOAT)]
    for figure in afloat:
        native = next((f for f in afloat if (f.engine, f.model) == ("kingpost", figure.model)), figure)
        share = "" if native is figure else f", {native.median_ns / figure.median_ns:.2f} of kingpost's"
        yield (
            f"{figure.engine}, {figure.model}: {figure.median_ns / 1000:.1f} us a step of "
            f"{models.AFLOAT_STEP_S * 1000:g} ms, {_count(figure)} instructions, "
            f"{models.AFLOAT_STEP_S * 1e9 / figure.median_ns:,.0f} times real time{share}"
        )


def growth(figures: Sequence[Figure]) -> Iterator[str]:
    """Instructions per additional link between successive lengths of chain: equal if the growth is linear."""
    for engine in dict.fromkeys(figure.engine for figure in figures):
        counts = {
            links: figure.instructions
            for links in models.CHAIN_LINKS
            for figure in figures
            if (figure.engine, figure.model) == (engine, models.chain_name(links)) and figure.instructions
        }
        if len(counts) > 1:
            steps = [(b, (counts[b] - counts[a]) / (b - a)) for a, b in pairwise(counts)]
            yield f"{engine}, one more link: " + ", ".join(f"{each:,.0f} to {b}" for b, each in steps)


def tables(figures: Sequence[Figure], head: str) -> dict[str, str]:
    """Figures, ratios and growth as Markdown, by the measured section of README.md."""
    measured = {
        "paper": [figure for figure in figures if figure.model == models.PAPER],
        "lift": [figure for figure in figures if figure.model == models.LIFT],
        "afloat": [f for f in figures if f.model in map(models.afloat_name, models.AFLOAT)],
        "chains": [f for f in figures if f.model in map(models.chain_name, models.CHAIN_LINKS)],
    }
    lines = {"paper": _operations, "lift": _operations, "afloat": _afloat, "chains": _chains}
    when = f"{datetime.datetime.now(datetime.UTC).date().isoformat()}, {head}."
    return {name: "\n".join([when, "", *lines[name](here)]) for name, here in measured.items() if here}


def _operations(figures: Sequence[Figure]) -> Iterator[str]:
    """A row for each engine and operation, then the ratios."""
    yield "| engine | operation | median, ns | fastest tenth, ns | instructions |"
    yield "| --- | --- | --- | --- | --- |"
    for figure in figures:
        cells = [figure.engine, figure.operation, f"{figure.median_ns:,.0f}", f"{figure.low_ns:,.0f}"]
        yield f"| {' | '.join([*cells, _count(figure)])} |"
    yield ""
    yield from (f"- {line.replace(f', {figures[0].model}', '')}" for line in ratios(figures))


def _afloat(figures: Sequence[Figure]) -> Iterator[str]:
    """A line for each engine and kind of buoyancy."""
    yield from (f"- {line}" for line in speeds(figures))


def _chains(figures: Sequence[Figure]) -> Iterator[str]:
    """A row for each length and engine, then the growth."""
    yield "| links | engine | median, ns | instructions | kingpost over it: time | instructions |"
    yield "| --- | --- | --- | --- | --- | --- |"
    for links in models.CHAIN_LINKS:
        here = [figure for figure in figures if figure.model == models.chain_name(links)]
        for figure in here:
            ours = next((f for f in here if f.engine == "kingpost"), None)
            time, count = "-", "-"
            if ours and figure is not ours:
                time = f"{ours.median_ns / figure.median_ns:.2f}"
                if ours.instructions and figure.instructions:
                    count = f"{ours.instructions / figure.instructions:.2f}"
            cells = [str(links), figure.engine, f"{figure.median_ns:,.0f}", _count(figure), time, count]
            yield f"| {' | '.join(cells)} |"
    yield ""
    yield from (f"- {line}" for line in growth(figures))


def _count(figure: Figure) -> str:
    """Formats instructions, or a dash if they are not counted."""
    return "-" if figure.instructions is None else f"{figure.instructions:,.0f}"


def write_readme(texts: Mapping[str, str]) -> None:
    """Replaces these sections in README.md."""
    page = README.read_text()
    for name, text in texts.items():
        start, end = f"<!-- {name}: start -->", f"<!-- {name}: end -->"
        before, _, rest = page.partition(start)
        _, _, after = rest.partition(end)
        page = f"{before}{start}\n\n{text}\n\n{end}{after}"
    README.write_text(page)
