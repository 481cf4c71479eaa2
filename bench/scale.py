"""Whether a large class costs what it should: flat memory, linear time, next to nothing when nothing is new, and the same on Dask.

    python bench/scale.py [--students N] [--sample N] [--json FILE]

Grades N generated submissions with two workers and the sandbox on, then once more unchanged. A sample of them is graded on a Dask
cluster of two workers started here, by stock nbgrader, and as the floor (bench/grading.py) for comparison.
"""

import argparse
import contextlib
import json
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console

from bench.classes import ASSIGNMENT, ROOT, make_class
from bench.grading import compared
from bench.measured import Cost, measured

_BIN = Path(sys.executable).parent
_FEW = 24


def main() -> None:
    """Measure, print, and write the figures."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--students", type=int, default=2000)
    parser.add_argument("--sample", type=int, default=_FEW, help="how many are graded by Dask, stock nbgrader and the floor")
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    cores = sorted(os.sched_getaffinity(0))[:2]
    with tempfile.TemporaryDirectory(prefix="bench-") as folder:
        figures = _figures(Path(folder), options.students, options.sample, cores)
    for name, value in figures.items():
        print(f"{name:>32}: {value if isinstance(value, str | int | list) else format(value, '.4g')}")
    if options.json:
        options.json.write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")


def _figures(folder: Path, students: int, sample: int, cores: list[int]) -> dict[str, Any]:
    console = Console(stderr=True)
    console.print(f"making {students} submissions ...")
    root = make_class(folder / "all", students)
    console.print("grading them ...")
    first = _graded(root, cores, root / "first.json")
    console.print("and again ...")
    second = _graded(root, cores, root / "second.json")
    console.print(f"{sample} of them on two Dask workers ...")
    on_dask = _graded_on_dask(root, folder / "dask", sample, cores)
    console.print(f"{sample} of them by stock nbgrader, and as the floor ...")
    ratios = compared(folder / "few", sample, cores)
    scores = _scores(root / "first.json")
    quarters = _quarters(root)
    own = np.array(first.own[len(first.own) // 20 :])
    return {
        "submissions": students,
        "first_run_s": first.wall,
        "submissions_per_s": students / first.wall,
        "quarters_s": [round(quarter, 1) for quarter in quarters],
        "last_quarter_to_first": quarters[-1] / quarters[0],
        "second_run_s": second.wall,
        "first_to_second": first.wall / second.wall,
        "second_run_says_the_same": str(_scores(root / "second.json") == scores),
        "grader_grows_mb": float(own[-20:-1].max() - own[0]),
        "grader_peak_mb": float(own.max()),
        "largest_process_mb": first.largest,
        "peak_memory_mb": first.memory,
        "dask_says_the_same": str(on_dask == {key: scores[key] for key in on_dask}),
        "dask_submissions": len({student for student, _ in on_dask}),
        **{name: ratios[name] for name in ("ratio_to_nbgrader", "ratio_to_floor")},
    }


def _graded(root: Path, cores: list[int], results: Path, *more: str) -> Cost:
    return measured([str(_BIN / "autograder"), "grade", ASSIGNMENT, "--workers", "2", "--json", str(results), *more], root, cores)


def _scores(path: Path) -> dict[tuple[str, str], tuple[float | None, str | None]]:
    rows = map(json.loads, path.read_text(encoding="utf-8").splitlines())
    return {(row["student"], row["exercise"]): (row["score"], row["misconception"]) for row in rows}


def _quarters(root: Path) -> list[float]:
    """Return the seconds that each quarter of the first run took, by when the receipts were written."""
    written = sorted(path.stat().st_mtime for path in (root / ".autograder/receipts" / ASSIGNMENT).glob("*/receipt.json"))
    return [float(part) for part in np.diff(np.quantile(written, [0, 0.25, 0.5, 0.75, 1]))]


def _graded_on_dask(root: Path, folder: Path, sample: int, cores: list[int]) -> dict[tuple[str, str], Any]:
    """Grade the first few with the same secret on a cluster and return their scores."""
    for name in ("release", "nbgrader_config.py", ".autograder/secret"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (shutil.copytree if (root / name).is_dir() else shutil.copy)(root / name, folder / name)
    for student in sorted((root / "submitted").iterdir())[:sample]:
        shutil.copytree(student, folder / "submitted" / student.name)
    with _cluster() as address:
        _graded(folder, cores, folder / "dask.json", "--scheduler", address)
    return _scores(folder / "dask.json")


@contextlib.contextmanager
def _cluster() -> Iterator[str]:
    """Run a Dask scheduler and two workers on this machine and yield the address."""
    with socket.create_server(("127.0.0.1", 0)) as probe:
        port = probe.getsockname()[1]
    address = f"tcp://127.0.0.1:{port}"
    commands = [
        ["scheduler", "--host", "127.0.0.1", "--port", str(port), "--no-dashboard"],
        *[["worker", address, "--nthreads", "1", "--no-dashboard", "--local-directory", tempfile.gettempdir()]] * 2,
    ]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    with contextlib.ExitStack() as stack:
        for command in commands:
            process = subprocess.Popen(
                [str(_BIN / "dask"), *command], env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
            )
            stack.callback(process.wait)
            stack.callback(process.terminate)
        _wait_for_workers(address, 2)
        yield address


def _wait_for_workers(address: str, count: int) -> None:
    from distributed import Client

    for _ in range(120):
        with contextlib.suppress(OSError, TimeoutError), Client(address, timeout=2, set_as_default=False) as client:
            if len(client.ncores()) >= count:
                return
        time.sleep(0.5)
    raise TimeoutError("the Dask workers did not come up")


if __name__ == "__main__":
    main()
