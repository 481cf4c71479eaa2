"""How much time the judge adds to an answer's own running time, exercise by exercise; and what importing `course` costs.

    python bench/check.py [--seeds N] [--json FILE]

"own" calls the answer on the inputs of the drawn cases and does nothing else. "adds" is a whole judgement of the same answer with
the same seed, less that. Right answers are the references, wrong ones all misconceptions.
"""

import argparse
import contextlib
import io
import json
import statistics
import subprocess
import sys
import time
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import sympy

from autograder import exercises, judge
from autograder.exercise import Exercise, trial
from course.plain import fresh


def own_time(answer: Callable[..., Any], exercise: Exercise, seed: int) -> float:
    """Return the seconds that the answer itself takes for the cases drawn from `seed`."""
    total = 0.0
    for question in trial(exercise, seed).questions:
        given = sympy.symbols(f"s0:{len(question.args)}", real=True) if question.symbols else list(map(fresh, question.args))
        begin = time.perf_counter()
        with contextlib.suppress(Exception):
            answer(*given)
        total += time.perf_counter() - begin
    return total


def added_times(answer: Callable[..., Any], exercise: Exercise, seeds: int) -> list[float]:
    """Return in ms what the judge adds, for each seed."""
    added = []
    for seed in range(seeds):
        own = own_time(answer, exercise, seed)
        begin = time.perf_counter()
        judge(exercise.name, answer, seed)
        added.append((time.perf_counter() - begin - own) * 1e3)
    return added


def import_seconds(module: str, runs: int = 5) -> float:
    """Return the median time that a fresh Python takes to import `module`, less that of importing nothing."""

    def run(code: str) -> float:
        begin = time.perf_counter()
        subprocess.run([sys.executable, "-c", code], check=True, cwd="/")
        return time.perf_counter() - begin

    return statistics.median(run(f"import {module}") - run("pass") for _ in range(runs))


def main() -> None:
    """Measure every exercise and print a table."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--seeds", type=int, default=20, help="drawings of cases for each answer (default 20)")
    parser.add_argument("--json", type=Path, help="write the figures to this file too")
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    np.seterr(all="ignore")
    rows: dict[str, dict[str, float]] = {}
    print(f"{'exercise':24}{'right: median':>15}{'max':>8}{'wrong: median':>15}{'max':>8}   [ms]")
    for exercise in exercises():
        if not isinstance(exercise, Exercise):
            continue
        with contextlib.redirect_stdout(io.StringIO()):
            judge(exercise.name, exercise.reference, 0)  # the first call imports what the exercise needs
            right = added_times(exercise.reference, exercise, options.seeds)
            few = max(options.seeds // 5, 2)
            wrong = [ms for mistake in exercise.mistakes for ms in added_times(mistake.wrong, exercise, few)]
        row = [statistics.median(right), max(right), statistics.median(wrong), max(wrong)]
        rows[exercise.name] = dict(zip(("right_median_ms", "right_max_ms", "wrong_median_ms", "wrong_max_ms"), row, strict=True))
        print(f"{exercise.name:24}{row[0]:15.2f}{row[1]:8.2f}{row[2]:15.2f}{row[3]:8.2f}")
    imports = {module: import_seconds(module) for module in ("numpy", "course", "course.en")}
    for module, seconds in imports.items():
        print(f"import {module:17}{seconds:15.3f} s")
    if options.json:
        options.json.write_text(json.dumps({"exercises": rows, "import_seconds": imports}, indent=1) + "\n")


if __name__ == "__main__":
    main()
