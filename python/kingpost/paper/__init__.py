"""The paper's results from the engine: figures, table, integrators, and errors in its text.

The paper is Jardim, Rein, Haveland, Rykkje and Impelluso, "Modeling Crane-Induced Ship Motion
Using the Moving Frame Method", J. Offshore Mech. Arct. Eng. 141(5), 2019, doi 10.1115/1.4042536.
"""

from __future__ import annotations

from pathlib import Path

from .. import output, progress
from ..errors import KingpostError
from ..reports.tables import table as rows_of
from . import comparison, figures, integrators, measured, page, summary, table

RUNS = 2 * len(figures.CASES) + len(integrators.ORDERS)


def command(folder: str | Path) -> int:
    """Write everything to `folder`, and print a summary and the paths."""
    folder = Path(folder)
    written, tables = write(folder)
    for rows in tables:
        print(*rows_of(rows), "", sep="\n")
    print(f"{folder / 'index.html'}: the page, with all of it")
    print(f"{folder}: {', '.join(path.name for path in written if path.name != 'index.html')}")
    return 0


def write(folder: str | Path) -> tuple[list[Path], list[summary.Table]]:
    """Simulate the paper's cases and write data, pictures and the page.

    Returns
    -------
    files, tables
        The files, sorted; the largest rates, and the integrators compared.

    Raises
    ------
    KingpostError
        If the folder cannot be made or written to.
    """
    folder = Path(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        return _write(folder)
    except OSError as error:
        raise KingpostError(f"{folder}: cannot be written: {error.strerror}") from None


def _write(folder: Path) -> tuple[list[Path], list[summary.Table]]:
    # A folder that cannot be written to should fail before the computation, not after it.
    rows = table.write(folder)
    with progress.bar(RUNS, "runs") as update:
        done = iter(range(1, RUNS + 1))
        drawn = figures.run(lambda: update(next(done)))
        compared = integrators.run(lambda: update(next(done)))
    figures.write(folder, drawn)
    comparison.write(folder, compared)
    remarks = measured.measure(drawn)
    output.write_text(folder / "index.html", page.html(folder, drawn, rows, compared, remarks))
    names = ["index.html", "table_2.csv", "table_2.md"]
    for name in [*(figure.name for figure in drawn), comparison.NAME]:
        names += [f"{name}.{ending}" for ending in ("csv", "png", "svg")]
    tables = [summary.largest_rates(drawn), comparison.table(compared)]
    return [folder / name for name in sorted(names)], tables
