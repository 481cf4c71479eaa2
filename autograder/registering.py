"""Putting the cells of an assignment into nbgrader's gradebook, as nbgrader's SaveCells does, but in one transaction.

Both editions have the same graded cells, so one registration serves students of either language.
"""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from course.language import LANGUAGES

if TYPE_CHECKING:
    from nbformat import NotebookNode

#: the values of each row that a notebook needs in the gradebook, by the row's class in nbgrader.api and the cell's grade id
Rows = dict[tuple[str, str], dict[str, Any]]


class RegistrationError(RuntimeError):
    """Why the cells of an assignment cannot enter the gradebook, and what to do."""


def register(gradebook: Any, root: Path, assignment: str) -> None:
    """Bring the cells of `assignment` in `gradebook`, an nbgrader.api.Gradebook, up to date with the student notebooks in release/.

    Grades are kept. Raises RegistrationError, and changes nothing, where cells were added or removed after students handed in.
    """
    notebooks = _released(root, assignment)
    try:
        _update(gradebook, assignment, notebooks)
        gradebook.db.commit()
    except BaseException:
        gradebook.db.rollback()
        raise


def _released(root: Path, assignment: str) -> "dict[str, NotebookNode]":
    """Return the student notebooks by name, after a look whether both editions have the same graded cells."""
    # imported here: it takes seconds
    import nbformat

    editions = []
    for language in LANGUAGES:
        paths = sorted((root / "release" / language / assignment).glob("*.ipynb"))
        editions.append({path.stem: nbformat.read(path, as_version=4) for path in paths})
    if not editions[0]:
        raise RegistrationError(f"{assignment}: release/ has no notebooks of it; run `autograder build`, or check its name")
    if len({json.dumps({name: [*_rows(notebook).items()] for name, notebook in edition.items()}) for edition in editions}) > 1:
        raise RegistrationError(f"{assignment}: the editions in release/ differ in their graded cells; run `autograder build`")
    return editions[0]


def _rows(notebook: "NotebookNode") -> Rows:
    from nbgrader.utils import compute_checksum, is_grade, is_locked, is_solution, is_task

    rows: Rows = {}
    for cell in notebook.cells:
        if not (is_grade(cell) or is_solution(cell) or is_locked(cell) or is_task(cell)):
            continue
        name = cell.metadata.nbgrader.grade_id
        graded = {"max_score": float(cell.metadata.nbgrader.get("points", 0)), "cell_type": cell.cell_type}
        if is_grade(cell):
            rows["GradeCell", name] = graded
        if is_solution(cell):
            rows["SolutionCell", name] = {}
        if is_task(cell):
            rows["TaskCell", name] = graded
        rows["SourceCell", name] = {
            "cell_type": cell.cell_type,
            "locked": is_locked(cell),
            "source": cell.source,
            "checksum": compute_checksum(cell),
        }
    return rows


def _update(gradebook: Any, assignment: str, notebooks: "Mapping[str, NotebookNode]") -> None:
    from nbgrader.api import Assignment, Notebook

    session = gradebook.db
    master = session.query(Assignment).filter(Assignment.name == assignment).one_or_none()
    if master is None:
        master = Assignment(name=assignment, course_id=gradebook.course_id)
        session.add(master)
    present = {notebook.name: notebook for notebook in master.notebooks}
    rows = {name: _rows(notebook) for name, notebook in notebooks.items()}
    changed = {
        name
        for name in present.keys() | rows.keys()
        if name not in present or name not in rows or _cells(present[name]).keys() != rows[name].keys()
    }
    if changed and master.submissions:
        raise RegistrationError(
            f"{assignment}: cells of {', '.join(sorted(changed))} were added or removed, but students have handed in already. "
            "Put the cells back, or give the changed assignment another name."
        )
    for name in changed & present.keys():
        _remove(session, present.pop(name))
    for name, notebook in notebooks.items():
        entry = present.get(name) or Notebook(name=name, assignment=master)
        entry.kernelspec = json.dumps(notebook.metadata.kernelspec)
        session.add(entry)
        _store(session, entry, rows[name])


def _cells(notebook: Any) -> dict[tuple[str, str], Any]:
    """Return the cells of a notebook in the gradebook, by class and grade id."""
    cells = [*notebook.grade_cells, *notebook.solution_cells, *notebook.task_cells, *notebook.source_cells]
    return {(type(cell).__name__, cell.name): cell for cell in cells}


def _remove(session: Any, notebook: Any) -> None:
    for cell in _cells(notebook).values():
        session.delete(cell)
    session.delete(notebook)
    # otherwise the session inserts the new rows before it deletes the old ones of the same name
    session.flush()


def _store(session: Any, notebook: Any, rows: Rows) -> None:
    from nbgrader import api

    present = _cells(notebook)
    for (kind, name), values in rows.items():
        cell = present.get((kind, name)) or getattr(api, kind)(name=name, notebook=notebook)
        for key, value in values.items():
            setattr(cell, key, value)
        session.add(cell)
