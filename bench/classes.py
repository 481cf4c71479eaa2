"""Classes to measure with: the real assignment, answered as a class answers it, mostly right and here and there wrong."""

import inspect
import json
import random
import shutil
from functools import cache
from pathlib import Path
from typing import Any

from autograder.grading import notebook_names
from autograder.reference import NOTEBOOKS, exercise_named
from autograder.sample import solutions

ROOT = Path(__file__).resolve().parent.parent
ASSIGNMENT = "odometry"
_WRONG_SHARE = 0.15
_OWN_CELLS = (
    "1 + 1",
    "import numpy as np\nnp.linspace(0, 1, 5)",
    "print('ここまで')",
    "# still to do\nx = [n**2 for n in range(10)]\nx",
)


def make_class(folder: Path, students: int) -> Path:
    """Make a course root in `folder` with this many submissions, the same ones every time, and return it."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    shutil.copytree(ROOT / "release", folder / "release")
    shutil.copy(ROOT / "nbgrader_config.py", folder)
    for number in range(students):
        draw = random.Random(number)
        target = folder / "submitted" / f"s{number:04d}" / ASSIGNMENT
        target.mkdir(parents=True)
        for name in notebook_names(ASSIGNMENT):
            made = _answered(name, ("ja", "en")[number % 2], draw)
            (target / f"{name}.ipynb").write_text(json.dumps(made, ensure_ascii=False), encoding="utf-8")
    return folder


def _answered(name: str, language: str, draw: random.Random) -> dict[str, Any]:
    notebook = json.loads(_release(name, language))
    solved = _solved(name, language)
    for cell in notebook["cells"]:
        grade_id = cell["metadata"].get("nbgrader", {}).get("grade_id")
        if grade_id in solved:
            cell["source"] = solved[grade_id]
            if grade_id in NOTEBOOKS[f"{ASSIGNMENT}/{name}"] and draw.random() < _WRONG_SHARE:
                cell["source"] = _wrong(grade_id, draw)
    for source in draw.sample(_OWN_CELLS, draw.randrange(3)):
        own = {"cell_type": "code", "id": f"own-{draw.randrange(10**6)}", "metadata": {}, "source": source, "outputs": []}
        notebook["cells"].insert(draw.randrange(2, len(notebook["cells"])), own | {"execution_count": None})
    return notebook


@cache
def _release(name: str, language: str) -> str:
    return (ROOT / "release" / language / ASSIGNMENT / f"{name}.ipynb").read_text(encoding="utf-8")


@cache
def _solved(name: str, language: str) -> dict[str, str]:
    return solutions(ROOT, f"{ASSIGNMENT}/{name}", language)


def _wrong(exercise: str, draw: random.Random) -> str:
    mistake = draw.choice(exercise_named(exercise).mistakes)
    source = inspect.getsource(mistake.wrong).replace(f"def {mistake.slug}(", f"def {exercise}(", 1)
    return f"import math\n\nimport numpy as np\nimport sympy as sp\n\n\n{source}"
