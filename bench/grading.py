"""How fast a class is graded: stock `nbgrader autograde` and `autograder grade` side by side on the same class and the same two cores.

    python bench/grading.py [--students N] [--json FILE] [--profile]

Stock runs as it comes: one process, no sandbox. Ours runs with two workers and the sandbox on. The floor (bench/floor.py) runs the
same cells and asks the same answers on the same cases in forks of a warm IPython, with no sandbox, no wire, no judgement and no
gradebook. "At the margin" leaves out what is paid once in a run, measured with a class of two; the floor's loading is left out too.
"""

import argparse
import json
import os
import sys
import tempfile
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table

from autograder.gradebook import GradebookWriter
from autograder.grading import notebook_names
from bench.classes import ASSIGNMENT, ROOT, make_class
from bench.measured import Cost, measured

_BIN = Path(sys.executable).parent
_STOCK = "--Autograde.exporter_class=nbconvert.exporters.NotebookExporter"


def main() -> None:
    """Measure, print a table, and write the figures."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--students", type=int, default=24)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--profile", action="store_true", help="say where the time of the trusted side goes")
    options = parser.parse_args()
    cores = sorted(os.sched_getaffinity(0))[:2]
    with tempfile.TemporaryDirectory(prefix="bench-") as folder:
        figures = compared(Path(folder), options.students, cores)
        if options.profile:
            _print_profile(Path(folder) / "ours")
    _print_table(figures)
    if options.json:
        options.json.write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")


def compared(folder: Path, students: int, cores: list[int]) -> dict[str, Any]:
    """Grade a class of so many by us, as the floor, and by stock nbgrader, below `folder`, and return the figures."""
    console = Console(stderr=True)
    notebooks = students * len(notebook_names(ASSIGNMENT))
    console.print(f"{students} submissions, {notebooks} notebooks, cores {cores}")
    root, two, stock_root = (
        make_class(folder / "ours", students),
        make_class(folder / "two", 2),
        make_class(folder / "stock", students),
    )
    console.print("ours ...")
    start_up, ours = _graded(two, cores), _graded(root, cores)
    console.print("the floor ...")
    floor = _floor(root, cores)
    console.print("stock nbgrader ...")
    stock = _graded_by_stock(stock_root, cores)
    marginal = (ours.cpu - start_up.cpu) / (notebooks - 2 * len(notebook_names(ASSIGNMENT)))
    per_notebook = floor["notebooks"] / floor["count"]
    return {
        "submissions": students,
        "notebooks": notebooks,
        "stock": _row(stock, students, notebooks),
        "ours": _row(ours, students, notebooks) | {"cpu_s_per_notebook_at_the_margin": marginal, "start_up_cpu_s": start_up.cpu},
        "floor": {"cpu_s_per_notebook": per_notebook, "loading_cpu_s": floor["loading"]},
        "ratio_to_nbgrader": stock.wall / ours.wall,
        "ratio_to_floor": marginal / per_notebook,
        "ratio_to_floor_with_start_up": ours.cpu / (floor["loading"] + floor["notebooks"]),
    }


def _row(cost: Cost, students: int, notebooks: int) -> dict[str, float]:
    return {
        "wall_s": cost.wall,
        "submissions_per_s": students / cost.wall,
        "cpu_s_per_notebook": cost.cpu / notebooks,
        "peak_memory_mb": cost.memory,
        "largest_process_mb": cost.largest,
    }


def _graded(root: Path, cores: list[int]) -> Cost:
    return measured([str(_BIN / "autograder"), "grade", ASSIGNMENT, "--workers", "2"], root, cores)


def _graded_by_stock(root: Path, cores: list[int]) -> Cost:
    # the cells have to be in the gradebook before, as after nbgrader's own generate_assignment
    with GradebookWriter(root, ASSIGNMENT):
        pass
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "PATH": f"{_BIN}{os.pathsep}{os.environ['PATH']}"}
    return measured([str(_BIN / "nbgrader"), "autograde", ASSIGNMENT, _STOCK], root, cores, environment)


def _floor(root: Path, cores: list[int]) -> dict[str, float]:
    environment = {
        **os.environ, "PYTHONPATH": str(ROOT), "MPLBACKEND": "module://matplotlib_inline.backend_inline",
        "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
    }  # fmt: skip
    told = root.parent / "floor.json"
    measured([sys.executable, str(ROOT / "bench/floor.py"), str(root), str(told)], root, cores, environment)
    figures: dict[str, float] = json.loads(told.read_text())
    return figures


def _print_table(figures: dict[str, Any]) -> None:
    table = Table(title=f"{figures['submissions']} submissions of two notebooks, two cores")
    for column in ("", "wall s", "submissions/s", "CPU s/notebook", "peak memory MB"):
        table.add_column(column, justify="right")
    for name in ("stock", "ours"):
        row = figures[name]
        cells = (row["wall_s"], row["submissions_per_s"], row["cpu_s_per_notebook"], row["peak_memory_mb"])
        table.add_row(name, *(f"{cell:.3g}" for cell in cells))
    ours, floor = figures["ours"], figures["floor"]
    table.add_row("ours, at the margin", "", "", f"{ours['cpu_s_per_notebook_at_the_margin']:.3g}", "")
    table.add_row("floor", "", "", f"{floor['cpu_s_per_notebook']:.3g}", "")
    output = Console(width=None if sys.stdout.isatty() else 110)
    output.print(table)
    output.print(
        f"throughput: {figures['ratio_to_nbgrader']:.1f} times stock's; CPU: {figures['ratio_to_floor']:.2f} times the floor's at the "
        f"margin, {figures['ratio_to_floor_with_start_up']:.2f} times with start-up"
    )


def _print_profile(root: Path) -> None:
    """Grade the class once more in this process, and say where the time of the trusted side goes; the rest is the notebooks' own."""
    import cProfile
    import pstats

    from autograder.grading import Work, graded_submission
    from autograder.submissions import release_notebooks, students_with, submitted_notebooks

    release = release_notebooks(root, ASSIGNMENT)
    works = [
        Work(student, ASSIGNMENT, submitted_notebooks(root, name, ASSIGNMENT), release)
        for student, name in students_with(root, ASSIGNMENT).items()
    ]
    graded_submission(works[0])
    profile = cProfile.Profile()
    with GradebookWriter(root, ASSIGNMENT) as gradebook:
        profile.enable()
        for work in works:
            gradebook.write(work.student, graded_submission(work))
        profile.disable()
    pstats.Stats(profile).sort_stats("cumulative").print_stats("autograder|course|nbgrader|socket.*recv", 45)


if __name__ == "__main__":
    main()
