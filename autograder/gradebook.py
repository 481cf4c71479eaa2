"""Writing results into nbgrader's gradebook and autograded/: one writer, one transaction for each submission."""

import json
import os
import signal
import sys
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

from autograder.executed import as_markdown
from autograder.exercise import check_cell, checked_exercise
from autograder.files import replace_file
from autograder.grading import GradedNotebook, Result
from autograder.late import LatePenalties
from autograder.receipts import CannotWriteError
from autograder.registering import RegistrationError, register
from autograder.settings import course_id, db_url
from autograder.standing import said_plainly


class GradebookWriter:
    """The open gradebook of one course, for one assignment. Use it in a `with` statement."""

    def __init__(self, root: Path, assignment: str) -> None:
        self._root, self._assignment = root, assignment

    def __enter__(self) -> "GradebookWriter":
        with _written_or_said():
            self._gradebook = open_gradebook(self._root)
        try:
            self._late = LatePenalties(self._root)
            with _written_or_said():
                register(self._gradebook, self._root, self._assignment)
                self._cells = _Cells.of(self._gradebook, self._assignment)
        except BaseException:
            self._gradebook.close()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self._gradebook.close()

    def write(
        self, student: str, graded: Sequence[GradedNotebook], kept: Sequence[Result] = (), unchanged: Collection[str] = ()
    ) -> None:
        """Write one submission: scores and comments in one transaction, and the executed notebooks into autograded/.

        `kept` are results that stand although something newer was handed in: they are entered, and their notebooks stay.
        `unchanged` names the notebooks that were graded before, just as they are: they arrived then.

        The notebooks are put in place last: if anything fails before, the next run still sees which written answers have changed.
        """
        folder = self._root / "autograded" / student / self._assignment
        folder.mkdir(parents=True, exist_ok=True)
        paths = {notebook.notebook: folder / f"{notebook.notebook}.ipynb" for notebook in graded}
        try:
            with _written_or_said():
                submission = self._submission(student)
                _enter_all(submission, self._cells, graded, kept, paths)
                new = [notebook.notebook for notebook in graded if notebook.notebook not in unchanged]
                self._late.enter(submission, self._root / "submitted" / student / self._assignment, new)
                self._gradebook.db.commit()
        except BaseException:
            self._gradebook.db.rollback()
            raise
        for notebook in graded:
            replace_file(paths[notebook.notebook], notebook.executed)

    def _submission(self, student: str) -> Any:
        """Return the student's submission with a grade and a comment for every cell, making what is not there."""
        from nbgrader.api import Student, SubmittedAssignment

        session = self._gradebook.db
        person = session.get(Student, student) or Student(id=student)
        submission = (
            session.query(SubmittedAssignment)
            .filter(SubmittedAssignment.student_id == student, SubmittedAssignment.assignment_id == self._cells.assignment)
            .one_or_none()
        )
        if submission is None:
            submission = SubmittedAssignment(assignment_id=self._cells.assignment, student=person)
            session.add(submission)
        with session.no_autoflush:
            _complete(submission, self._cells)
        session.flush()
        return submission


class _Cells(NamedTuple):
    """The ids of what an assignment consists of, read once: nothing of it changes while a class is graded."""

    assignment: str
    #: of notebooks, by name
    notebooks: Mapping[str, str]
    #: names of graded cells, and of cells that get a comment, by id; for each notebook's id
    graded: Mapping[str, Mapping[str, str]]
    commented: Mapping[str, Mapping[str, str]]

    @classmethod
    def of(cls, gradebook: Any, assignment: str) -> "_Cells":
        from nbgrader.api import Assignment

        found = gradebook.db.query(Assignment).filter(Assignment.name == assignment).one()
        return cls(
            found.id,
            {notebook.name: notebook.id for notebook in found.notebooks},
            {notebook.id: {cell.id: cell.name for cell in notebook.grade_cells} for notebook in found.notebooks},
            {notebook.id: {cell.id: cell.name for cell in notebook.solution_cells} for notebook in found.notebooks},
        )


@contextmanager
def _written_or_said() -> Iterator[None]:
    """Say in plain words why the database did not take something."""
    try:
        with said_plainly("written"):
            yield
    except RegistrationError as error:
        raise CannotWriteError(str(error)) from error


def given_scores(
    root: Path, assignment: str, results: Sequence[Result]
) -> dict[tuple[str, str], tuple[float | None, str | None]]:
    """Return the points that stand in the gradebook, and the misconception of the result, by (student, exercise)."""
    given = {}
    with open_gradebook(root) as gradebook:
        scores = {
            (grade.student.id, checked_exercise(grade.name)): None if grade.needs_manual_grade else grade.score
            for submission in gradebook.assignment_submissions(assignment)
            for notebook in submission.notebooks
            for grade in notebook.grades
        }
    for result in results:
        key = result.student, result.exercise
        given[key] = scores[key], result.misconception
    return given


def open_gradebook(root: Path) -> Any:
    """Return an open nbgrader.api.Gradebook of the course; one that was begun and not finished is finished."""
    with _quick_import():
        from nbgrader.api import Gradebook

    # it runs the program alembic to make a new gradebook, which is beside this Python whether or not the environment is activated
    programs = str(Path(sys.executable).parent)
    path = os.environ.get("PATH", os.defpath)
    if programs not in path.split(os.pathsep):
        os.environ["PATH"] = f"{programs}{os.pathsep}{path}"
    url = db_url(root)
    begun = _begun_only(url)
    with _uninterrupted():
        gradebook = Gradebook(url, course_id=course_id(root))
        if begun:
            _enter_version(gradebook)
    return gradebook


@contextmanager
def _uninterrupted() -> Iterator[None]:
    """Let Ctrl-C wait for a moment: alembic would be hit by it too, and say so at length."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _begun_only(url: str) -> bool:
    """Return whether there are tables and nothing in them: perhaps the program was ended while it made them.

    nbgrader would never enter the version of those, and without it cannot upgrade them.
    """
    from sqlalchemy import create_engine, inspect, text

    engine = create_engine(url)
    try:
        with engine.connect() as connection:
            tables = inspect(connection).get_table_names()
            # one that is in use is none of ours to finish: it may be from before there were versions
            return bool(tables) and not ("assignment" in tables and connection.scalar(text("SELECT count(*) FROM assignment")))
    finally:
        engine.dispose()


def _enter_version(gradebook: Any) -> None:
    from nbgrader.api import get_alembic_version
    from sqlalchemy import text

    gradebook.db.execute(text("CREATE TABLE IF NOT EXISTS alembic_version (version_num VARCHAR(32) NOT NULL)"))
    if not gradebook.db.scalar(text("SELECT count(*) FROM alembic_version")):
        gradebook.db.execute(
            text("INSERT INTO alembic_version (version_num) VALUES (:version)"), {"version": get_alembic_version()}
        )
    gradebook.db.commit()


@contextmanager
def _quick_import() -> Iterator[None]:
    """Import nbgrader without what its libraries have no need of here: a grammar of web addresses that takes seconds to compile."""
    module = "rfc3987_syntax"
    if module in sys.modules:
        yield
        return
    # this is how Python marks a module that is not to be found
    sys.modules[module] = None  # type: ignore[assignment]
    try:
        yield
    finally:
        del sys.modules[module]


def _complete(submission: Any, cells: _Cells) -> None:
    """Give the submission every notebook, grade and comment that the assignment has by now."""
    from nbgrader.api import Comment, Grade, SubmittedNotebook

    present = {entry.notebook_id: entry for entry in submission.notebooks}
    for notebook in cells.notebooks.values():
        entry = present.get(notebook)
        if entry is None:
            entry = SubmittedNotebook(notebook_id=notebook)
            submission.notebooks.append(entry)
        graded = {grade.cell_id for grade in entry.grades}
        entry.grades.extend(Grade(cell_id=cell) for cell in cells.graded[notebook] if cell not in graded)
        commented = {comment.cell_id for comment in entry.comments}
        entry.comments.extend(Comment(cell_id=cell) for cell in cells.commented[notebook] if cell not in commented)


def _written_before(path: Path) -> dict[str, str]:
    """Return the answers in the notebook that was graded before; empty if there is none that can be read."""
    try:
        return _written_texts(path.read_bytes())
    except (OSError, ValueError, TypeError, LookupError):
        return {}


def _written_texts(executed: bytes) -> dict[str, str]:
    """Return the texts of the graded cells in an executed notebook by grade id."""
    cells = json.loads(executed)["cells"]
    sources = {cell["metadata"]["nbgrader"]["grade_id"]: cell["source"] for cell in cells if "nbgrader" in cell["metadata"]}
    return {grade_id: "".join(source) for grade_id, source in sources.items()}


def _enter_all(
    submission: Any, cells: _Cells, graded: Sequence[GradedNotebook], kept: Sequence[Result], paths: Mapping[str, Path]
) -> None:
    by_id = {entry.notebook_id: entry for entry in submission.notebooks}
    rows = {name: by_id[notebook] for name, notebook in cells.notebooks.items()}
    for notebook in graded:
        before, after = _written_before(paths[notebook.notebook]), _written_texts(notebook.executed)
        rewritten = {name for name, text in before.items() if text != after.get(name)}
        _enter(rows[notebook.notebook], cells, notebook.results, rewritten)
    for result in kept:
        _enter(rows[result.notebook], cells, [result], set())


def _enter(entry: Any, cells: _Cells, results: Sequence[Result], rewritten: set[str]) -> None:
    """Enter scores and messages. What a person gave by hand stays; it asks for another look when the answer was rewritten."""
    graded, commented = cells.graded[entry.notebook_id], cells.commented[entry.notebook_id]
    grades = {graded[grade.cell_id]: grade for grade in entry.grades if grade.cell_id in graded}
    comments = {commented[comment.cell_id]: comment for comment in entry.comments if comment.cell_id in commented}
    for result in results:
        written = result.exercise in grades
        grade = grades[result.exercise if written else check_cell(result.exercise)]
        if grade.manual_score is None:
            grade.needs_manual_grade = result.score is None
        else:
            changed = result.exercise in rewritten if written else grade.auto_score != result.score
            grade.needs_manual_grade = bool(grade.needs_manual_grade or changed)
        grade.auto_score = result.score
        # an answer that waits for a person gets that person's comment
        comments[result.exercise].auto_comment = None if result.score is None else as_markdown(result.message)
