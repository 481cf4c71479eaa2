"""Everything that is generated: student notebooks in both languages, the instructor's notebooks, the public examples.

nbgrader's own GenerateAssignment makes the student notebooks. All is made in memory and in a temporary directory first, so that a
source with a mistake leaves what is there as it was. The same sources give the same bytes.
"""

import io
import json
import logging
import math
import os
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import nbformat
import numpy as np
from nbformat import NotebookNode

from autograder.editions import SourceError, edition, source_cells
from autograder.exercise import Exercise, right_value
from autograder.reference import NOTEBOOKS, all_exercises
from course.answers import Question
from course.examples import stored, stored_tolerance
from course.language import LANGUAGES

EXAMPLES = "course/examples.json"
#: the language of the instructor's notebooks, which stock nbgrader and formgrader work on
INSTRUCTOR_LANGUAGE = "ja"


def build(root: Path) -> list[str]:
    """Bring everything that is generated up to date; return the paths, relative to `root`, that were written or removed.

    Raises SourceError, with every mistake there is, and then changes nothing.
    """
    products = _products(root)
    changed = [path for path, content in products.items() if _content(root / path) != content]
    superfluous = list(_superfluous(root, products))
    (root / "build").mkdir(exist_ok=True)
    # staged on the same file system, where renaming cannot leave half a file
    with tempfile.TemporaryDirectory(dir=root / "build") as stage:
        for number, path in enumerate(changed):
            Path(stage, str(number)).write_bytes(products[path])
        for number, path in enumerate(changed):
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            os.replace(Path(stage, str(number)), root / path)
    for path in superfluous:
        (root / path).unlink()
    return sorted(changed + superfluous)


def verify(root: Path) -> list[str]:
    """Return what `build` would change, as "path: stale", "path: missing" or "path: superfluous", and change nothing.

    Instructor notebooks are not kept in git, so one that is missing is no fault.
    """
    products = _products(root)
    found = [f"{path}: superfluous" for path in _superfluous(root, products)]
    for path, content in products.items():
        present = _content(root / path)
        if present is None:
            found += [] if path.startswith("source/") else [f"{path}: missing"]
        elif present != content and not (path == EXAMPLES and _same_examples(present, content)):
            found.append(f"{path}: stale")
    return sorted(found)


def _products(root: Path) -> dict[str, bytes]:
    """Return the content of every generated file by its path relative to `root`."""
    cells = _cells_by_notebook(root)
    products = {EXAMPLES: _examples()}
    for language in LANGUAGES:
        editions = {notebook: edition(cells[notebook], notebook, language) for notebook in cells}
        for notebook, content in _released(editions).items():
            products[f"release/{language}/{notebook}.ipynb"] = content
        if language == INSTRUCTOR_LANGUAGE:
            products |= {f"source/{notebook}.ipynb": _written_out(made) for notebook, made in editions.items()}
    return products


def _cells_by_notebook(root: Path) -> dict[str, list[NotebookNode]]:
    """Read all sources; raises one SourceError for the mistakes in all of them."""
    cells, mistakes = {}, []
    paths = {f"{path.parent.name}/{path.stem}": path for path in sorted(root.glob("source/*/*.md"))}
    mistakes += [f"source/{notebook}.md: missing; write it" for notebook in NOTEBOOKS if notebook not in paths]
    for notebook, path in paths.items():
        try:
            cells[notebook] = source_cells(path.read_text(encoding="utf-8"), notebook)
        except SourceError as error:
            mistakes.append(str(error))
    if mistakes:
        raise SourceError("\n".join(mistakes))
    return cells


def _released(editions: Mapping[str, NotebookNode]) -> dict[str, bytes]:
    """Return the student notebooks that nbgrader makes from the instructor's notebooks of one language."""
    # importing nbgrader takes seconds
    from nbgrader.converters import GenerateAssignment
    from nbgrader.converters.base import NbGraderException
    from nbgrader.coursedir import CourseDirectory
    from traitlets.config import Config

    config = Config()
    config.CourseDirectory.assignment_id = "*"
    config.ClearSolutions.text_stub = ""
    # the cells enter the real gradebook when a class is graded (autograder.registering)
    config.GenerateAssignment.no_database = True
    config.SaveCells.enabled = False
    log, report = _quiet_log()
    with tempfile.TemporaryDirectory() as scratch:
        top = Path(scratch).resolve()
        for notebook, made in editions.items():
            (top / "source" / notebook).parent.mkdir(parents=True, exist_ok=True)
            (top / "source" / f"{notebook}.ipynb").write_bytes(_written_out(made))
        coursedir = CourseDirectory(config=config, root=str(top), log=log)
        try:
            GenerateAssignment(coursedir=coursedir, config=config, log=log).start()
        except NbGraderException as error:
            # its own message only points at the log
            raise SourceError(f"nbgrader could not make the student notebooks:\n{report.getvalue()}") from error
        return {notebook: (top / "release" / f"{notebook}.ipynb").read_bytes() for notebook in editions}


def _quiet_log() -> tuple[logging.Logger, io.StringIO]:
    """Return a logger that nobody hears, and where its errors can be read."""
    report = io.StringIO()
    log = logging.Logger("nbgrader", logging.ERROR)
    log.addHandler(logging.StreamHandler(report))
    return log, report


def _written_out(notebook: NotebookNode) -> bytes:
    text: str = nbformat.writes(notebook)
    return f"{text.rstrip()}\n".encode()


def _examples() -> bytes:
    """Return course/examples.json: for each exercise what its public examples ask and what is right; of a graph its structure."""
    entries = {
        exercise.name: _entry(exercise) if isinstance(exercise, Exercise) else {"graph": asdict(exercise.structure)}
        for exercise in all_exercises()
    }
    return f"{json.dumps(entries, indent=1, sort_keys=True, ensure_ascii=False, allow_nan=False)}\n".encode()


def _entry(exercise: Exercise) -> dict[str, Any]:
    examples = [tuple(arg.item() if isinstance(arg, np.generic) else arg for arg in args) for args in exercise.examples]
    return {
        "parameters": exercise.parameters,
        "tolerance": stored_tolerance(exercise.tolerance),
        "quantities": exercise.quantities,
        "warnings_are_faults": exercise.warnings_are_faults,
        "gear": exercise.gear,
        "examples": [
            {
                "args": [stored(arg) for arg in args],
                "result": stored(right_value(exercise.reference, Question(args), exercise.refuses)),
            }
            for args in examples
        ],
    }


def _same_examples(present: bytes, content: bytes) -> bool:
    """Are the examples the same but for the last digits, in which mathematical libraries differ from machine to machine?"""
    try:
        return _close(json.loads(present), json.loads(content))
    except ValueError:
        return False


def _close(one: Any, other: Any) -> bool:
    if isinstance(one, float) and isinstance(other, float):
        return math.isclose(one, other, rel_tol=1e-12, abs_tol=1e-15)
    if type(one) is not type(other):
        return False
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(_close(one[key], other[key]) for key in one)
    if isinstance(one, list):
        return len(one) == len(other) and all(map(_close, one, other))
    return bool(one == other)


def _superfluous(root: Path, products: Mapping[str, bytes]) -> Iterator[str]:
    """Yield the generated notebooks that have no source any more."""
    for path in [*root.glob("release/*/*/*.ipynb"), *root.glob("source/*/*.ipynb")]:
        name = path.relative_to(root).as_posix()
        # notebooks of the TA's own carry no such mark
        if name not in products and b'"generated_from": "source/' in path.read_bytes():
            yield name


def _content(path: Path) -> bytes | None:
    return path.read_bytes() if path.is_file() else None
