"""Grading one submission: intake, sandbox, judge; and out comes a score with a reason for every exercise.

`graded_submission` takes and gives plain dictionaries and bytes, so that it can run in any executor.
"""

import json
from collections.abc import Collection, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from typing import Any

from autograder.executed import Room, clean_outputs, executed_notebook, verdict_output, visible
from autograder.exercise import checked_exercise
from autograder.intake import NOT_HANDED_IN, Cell, UnreadableError, language_of, restored_cells, submitted_cells
from autograder.judging import judged
from autograder.reference import NOTEBOOKS, WRITTEN, exercise_named
from autograder.session import Limits, NoSandboxError, Session, SessionEndedError
from course.language import Text
from course.verdict import Verdict


@dataclass(frozen=True)
class Result:
    """What one exercise of one submission got, in points, and why.

    `status` is "graded", "manual" (a person grades it; score None), or why there is nothing to grade: "missing", "unreadable",
    "stopped" (the notebook's process ended before), "failed" (a fault of the grader).
    """

    student: str
    assignment: str
    notebook: str
    exercise: str
    score: float | None
    max_score: float
    message: str
    misconception: str | None = None
    status: str = "graded"


@dataclass(frozen=True)
class GradedNotebook:
    """The results of one notebook, the executed notebook as JSON bytes, and the language it was answered in."""

    notebook: str
    language: str
    results: tuple[Result, ...]
    executed: bytes = field(repr=False)


@dataclass(frozen=True)
class Work:
    """One submission on its way through an executor: what was handed in, and what we released, as bytes.

    `notebooks` maps each notebook's name to the submitted bytes, or to the reason why there are none; `release` maps language and
    name to our own notebook.
    """

    student: str
    assignment: str
    notebooks: Mapping[str, bytes | Text]
    release: Mapping[tuple[str, str], bytes]
    sandbox: bool = True
    slot: int = 0
    limits: Limits = field(default_factory=Limits)


def graded_submission(work: Work) -> list[GradedNotebook]:
    """Grade every notebook of one submission. Never raises for what the submission holds: each exercise gets a definite score.

    Raises NoSandboxError where notebooks cannot be run at all.
    """
    return [_graded_notebook(work, name) for name in work.notebooks]


def notebook_names(assignment: str) -> list[str]:
    """Return the names of an assignment's notebooks in the order of the course; KeyError if there is no such assignment."""
    names = [key.partition("/")[2] for key in NOTEBOOKS if key.startswith(f"{assignment}/")]
    if not names:
        known = ", ".join(sorted({key.partition("/")[0] for key in NOTEBOOKS}))
        raise KeyError(f"no assignment is called {assignment!r}; there are: {known}")
    return names


def release_cells(data: bytes) -> list[Cell]:
    """Return the cells of our own released notebook, with the flags that nbgrader gave them."""
    cells = []
    for raw in json.loads(data)["cells"]:
        ours = raw["metadata"].get("nbgrader", {})
        source = raw["source"] if isinstance(raw["source"], str) else "".join(raw["source"])
        cells.append(Cell(raw["cell_type"], source, ours.get("grade_id"), ours.get("locked", False), ours.get("grade", False)))
    return cells


def _graded_notebook(work: Work, name: str) -> GradedNotebook:
    handed_in = work.notebooks[name]
    try:
        if isinstance(handed_in, Text):
            raise UnreadableError(handed_in)
        return _run_and_judged(work, name, submitted_cells(handed_in))
    except UnreadableError as error:
        return _refused(work, name, error.reason, "missing" if error.reason == NOT_HANDED_IN else "unreadable")
    except NoSandboxError:
        raise
    except Exception as error:  # one submission must not stop the others, whatever it is
        return _refused(work, name, _FAILED.format(error=type(error).__name__), "failed")


def _run_and_judged(work: Work, name: str, submitted: Sequence[Cell]) -> GradedNotebook:
    language = language_of(submitted)
    release = work.release[language, name]
    cells = restored_cells(release_cells(release), submitted)
    outputs, verdicts, stopped = _run(work, cells, _demo_sources(release), language)
    handed_in = {cell.grade_id for cell in submitted}
    results = _results(work, name, language, cells, handed_in, verdicts, stopped)
    return GradedNotebook(name, language, tuple(results), executed_notebook(release, cells, outputs))


def _demo_sources(release: bytes) -> frozenset[str]:
    """Return the sources of the teacher's demonstrations: left unchanged, they need not run again to grade the rest."""
    return frozenset(
        raw["source"] if isinstance(raw["source"], str) else "".join(raw["source"])
        for raw in json.loads(release)["cells"]
        if "demo" in raw["metadata"].get("tags", [])
    )


def _run(
    work: Work, cells: Sequence[Cell], demos: frozenset[str], language: str
) -> tuple[list[list[Any]], dict[str, Verdict], Text | None]:
    """Run the cells in a sandbox and ask the judge at each check. Returns outputs by cell, verdicts, and why it stopped early."""
    outputs: list[list[Any]] = [[] for _ in cells]
    # cleaned at once, so that what a notebook puts out never fills the grader's memory
    room, answers_room = Room(), Room()
    verdicts: dict[str, Verdict] = {}
    try:
        with Session(work.limits, work.sandbox, work.slot) as session:
            for index, cell in enumerate(cells):
                if cell.type != "code" or cell.source in demos:
                    continue
                if cell.locked and cell.graded:
                    name = checked_exercise(str(cell.grade_id))
                    verdict = judged(exercise_named(name), partial(session.ask, name))
                    verdicts[name] = verdict
                    outputs[index] = clean_outputs([verdict_output(verdict, language)], answers_room)
                else:
                    outputs[index] = clean_outputs(session.run(cell.source), room)
    except SessionEndedError as error:
        return outputs, verdicts, error.reason
    return outputs, verdicts, None


def _results(  # noqa: PLR0913 - one row of the table needs it all
    work: Work,
    name: str,
    language: str,
    cells: Sequence[Cell],
    handed_in: Collection[str | None],
    verdicts: Mapping[str, Verdict],
    stopped: Text | None,
) -> list[Result]:
    written = {cell.grade_id: cell.source for cell in cells if cell.graded and not cell.locked}
    results = []
    for blank in _blank_results(work, name):
        verdict = verdicts.get(blank.exercise)
        if blank.status == "manual":
            # where the whole cell is gone, its text may stand elsewhere: a person has to look
            empty = blank.exercise in handed_in and not written[blank.exercise].strip()
            message = (_NOT_WRITTEN if empty else _MANUAL).to(language)
            results.append(replace(blank, message=message, score=0.0 if empty else None))
        elif verdict is not None:
            points = round(verdict.score * blank.max_score, 4)
            message = visible(verdict.message(language))
            results.append(replace(blank, score=points, message=message, misconception=verdict.misconception))
        else:
            reason = (stopped or _NOT_ASKED).to(language)
            results.append(replace(blank, message=reason, status="stopped"))
    return results


def _blank_results(work: Work, name: str) -> list[Result]:
    """Return a zero for every exercise of a notebook, in order, to be filled in."""
    key = f"{work.assignment}/{name}"
    graded = [
        Result(work.student, work.assignment, name, exercise, 0.0, float(exercise_named(exercise).points), "")
        for exercise in NOTEBOOKS[key]
    ]
    cells = {cell.grade_id for cell in release_cells(work.release["ja", name])}
    written = [
        Result(
            work.student,
            work.assignment,
            name,
            exercise,
            None,
            written_points(work.release["ja", name], exercise),
            "",
            status="manual",
        )
        for exercise in WRITTEN.get(key, ())
        if exercise in cells
    ]
    return graded + written


def written_points(release: bytes, exercise: str) -> float:
    """Return the points of a written answer, as the release states them."""
    for raw in json.loads(release)["cells"]:
        ours = raw["metadata"].get("nbgrader", {})
        if ours.get("grade_id") == exercise:
            return float(ours["points"])
    return 0.0


def _refused(work: Work, name: str, reason: Text, status: str) -> GradedNotebook:
    """Return zeros with a reason for a notebook that cannot be graded."""
    english = any(b"from course.en import" in data for data in work.notebooks.values() if isinstance(data, bytes))
    language = "en" if english else "ja"
    results = tuple(replace(blank, score=0.0, message=reason.to(language), status=status) for blank in _blank_results(work, name))
    release = work.release[language, name]
    return GradedNotebook(name, language, results, executed_notebook(release, release_cells(release), []))


def result_row(result: Result) -> dict[str, Any]:
    """Return a result as a row for JSON."""
    return asdict(result)


_MANUAL = Text("A person grades this answer.", "この解答は担当者が採点します。")
_NOT_WRITTEN = Text("Nothing is written here yet.", "解答が書かれていません。")
_FAILED = Text(
    "The grader failed on this notebook ({error}). This is not your fault; please tell the staff.",
    "このノートブックの採点中に採点プログラム側でエラーが起きました({error})。解答のせいではありません。担当者に連絡してください。",
)
_NOT_ASKED = Text("This exercise could not be checked.", "この課題は採点できませんでした。")
