"""What stands in the gradebook, read in one go and without importing nbgrader, which takes seconds."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from autograder.receipts import CannotWriteError
from autograder.settings import db_url

_SCORES = """
    SELECT submitted_assignment.student_id, base_cell.name, grade.auto_score
    FROM grade
    JOIN base_cell ON base_cell.id = grade.cell_id
    JOIN submitted_notebook ON submitted_notebook.id = grade.notebook_id
    JOIN submitted_assignment ON submitted_assignment.id = submitted_notebook.assignment_id
    JOIN assignment ON assignment.id = submitted_assignment.assignment_id
    WHERE assignment.name = :assignment
"""


def standing_scores(root: Path, assignment: str) -> dict[str, dict[str, float | None]]:
    """Return the automatic points of each student by the name of the graded cell; nothing if there is no gradebook yet.

    None: a cell without automatic points.
    """
    from sqlalchemy import create_engine, inspect, text

    url = db_url(root)
    if url.startswith("sqlite:///") and not Path(url.removeprefix("sqlite:///").partition("?")[0]).exists():
        # only to look must not make one
        return {}
    standing: dict[str, dict[str, float | None]] = {}
    with said_plainly("read"):
        engine = create_engine(url)
        try:
            with engine.connect() as connection:
                if not inspect(connection).has_table("grade"):
                    return {}
                for student, cell, score in connection.execute(text(_SCORES), {"assignment": assignment}):
                    standing.setdefault(student, {})[cell] = score
        finally:
            engine.dispose()
    return standing


@contextmanager
def said_plainly(done: str) -> Iterator[None]:
    """Say in plain words why the database did not let itself be "read" or "written"."""
    from sqlalchemy.exc import ArgumentError, DBAPIError

    try:
        yield
    except (DBAPIError, ArgumentError, ImportError) as error:
        reason = " ".join(str(getattr(error, "orig", error)).split())
        raise CannotWriteError(
            f"the gradebook cannot be {done}: {reason}. If it is locked, another program has it open for writing: close that. "
            "What was graded so far is kept; type the same command again for the rest (autograder doctor says more)."
        ) from error
