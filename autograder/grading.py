"""Grading one submission: intake, sandbox, judge; and out comes a score with a reason for every exercise.

`graded_submission` takes and gives plain dictionaries and bytes, so that it can run in any executor.
"""

import contextlib
import io
import logging
import sys
import threading
from collections.abc import Collection, Mapping, Sequence
from dataclasses import asdict, dataclass, field, fields, replace
from typing import Any

from autograder.executed import Room, clean_outputs, executed_notebook, verdict_output, visible
from autograder.exercise import checked_exercise
from autograder.intake import NOT_HANDED_IN, Cell, UnreadableError, language_of, restored_cells, submitted_cells
from autograder.judging import judged
from autograder.receipts import exercises_hash
from autograder.reference import NOTEBOOKS, WRITTEN, exercise_named
from autograder.released import Release, released
from autograder.sandbox.wire import packed_interview, send
from autograder.session import Limits, SandboxEndedError, Session, SessionEndedError
from autograder.warm_server import NoSandboxError
from course.answers import Interview, Question
from course.language import Text
from course.verdict import Verdict


@dataclass(frozen=True, slots=True)
class Result:
    """What one exercise of one submission got, in points, and why.

    `status` is "graded", "manual" (a person grades it; score None), or why there is nothing to grade: "missing", "unreadable",
    "stopped" (the notebook's process ended before), "failed" (a fault of the grader), "attempts" (there were too many: the last
    verdict that counted stands). `seed` is that of the cases.
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
    seed: int | None = None


@dataclass(frozen=True)
class GradedNotebook:
    """The results of one notebook, the executed notebook as JSON bytes, and the language it was answered in.

    `replies` holds what the answers that are not right replied, by exercise, as it would cross the wire.
    """

    notebook: str
    language: str
    results: tuple[Result, ...]
    executed: bytes = field(repr=False)
    replies: Mapping[str, bytes] = field(default_factory=dict, repr=False)


@dataclass(frozen=True)
class Work:
    """One submission on its way through an executor: what was handed in, and what we released, as bytes.

    `notebooks` maps each notebook's name to the submitted bytes, or to the reason why there are none; `release` maps language and
    name to our own notebook; `seeds` are those of the cases by exercise (a missing one is drawn); `slot` tells submissions apart
    that run at the same time.
    """

    student: str
    assignment: str
    notebooks: Mapping[str, bytes | Text]
    release: Mapping[tuple[str, str], bytes]
    sandbox: bool = True
    slot: int = 0
    limits: Limits = field(default_factory=Limits)
    seeds: Mapping[str, int] = field(default_factory=dict)


class OtherVersionError(RuntimeError):
    """A worker has another version of the course than the grader, so its verdicts would not be ours."""


_log = logging.getLogger(__name__)
# a worker of a cluster may have several threads, and warnings and alarms belong to a whole process
_one_at_a_time = threading.Lock()


def graded_submission(work: Work) -> list[GradedNotebook]:
    """Grade every notebook of one submission. Never raises for what the submission holds: each exercise gets a definite score.

    Raises NoSandboxError where notebooks cannot be run at all.
    """
    with _one_at_a_time:
        return [_graded_notebook(work, name) for name in work.notebooks]


def refused_submission(work: Work, reason: Text) -> list[GradedNotebook]:
    """Return zeros with a reason for every notebook of a submission, because of a fault of the grader."""
    return [_refused(work, name, reason, "failed") for name in work.notebooks]


def plain_work(work: Work, version: str) -> dict[str, Any]:
    """Return a submission as plain dictionaries and bytes, for a worker of this version of the course, wherever it is."""
    return {
        "version": version,
        **{entry.name: getattr(work, entry.name) for entry in fields(work)},
        "notebooks": {name: tuple(given) if isinstance(given, Text) else given for name, given in work.notebooks.items()},
        "limits": asdict(work.limits),
    }


def graded_plainly(data: dict[str, Any]) -> list[dict[str, Any]]:
    """Grade what `plain_work` packed, in any executor. Raises OtherVersionError if this is another version of the course."""
    version = data.pop("version")
    if version != exercises_hash():
        raise OtherVersionError(
            "a worker has another version of the course than the grader; bring it up to date and start it again"
        )
    notebooks = {name: given if isinstance(given, bytes) else Text(*given) for name, given in data["notebooks"].items()}
    graded = graded_submission(Work(**data | {"notebooks": notebooks, "limits": Limits(**data["limits"])}))
    return [asdict(notebook) for notebook in graded]


def graded_from_plain(data: list[dict[str, Any]]) -> list[GradedNotebook]:
    """Return what `graded_plainly` sent back."""
    return [GradedNotebook(**entry | {"results": tuple(map(result_from_row, entry["results"]))}) for entry in data]


def result_from_row(row: Mapping[str, Any]) -> Result:
    """Return a result that was a row."""
    # of thousands of submissions most say the same few things: each text is kept once
    texts: dict[str, Any] = {key: sys.intern(value) if type(value) is str else value for key, value in row.items()}
    return Result(**texts)


def notebook_names(assignment: str) -> list[str]:
    """Return the names of an assignment's notebooks in the order of the course; KeyError if there is no such assignment."""
    names = [key.partition("/")[2] for key in NOTEBOOKS if key.startswith(f"{assignment}/")]
    if not names:
        known = ", ".join(sorted({key.partition("/")[0] for key in NOTEBOOKS}))
        raise KeyError(f"no assignment is called {assignment!r}; there are: {known}")
    return names


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
        _log.exception("the grader failed on %r of %r", name, work.student)
        return _refused(work, name, _FAILED.format(error=type(error).__name__), "failed")


def _run_and_judged(work: Work, name: str, submitted: Sequence[Cell]) -> GradedNotebook:
    for exercise in NOTEBOOKS[f"{work.assignment}/{name}"]:
        # loaded before the notebook's time begins
        exercise_named(exercise)
    language = language_of(submitted)
    release = released(work.release[language, name])
    cells = restored_cells(release.cells, submitted)
    run = _Run(work, language)
    try:
        run.all_cells(cells, release)
    except SandboxEndedError:
        run = _Run(work, language)
        with contextlib.suppress(SandboxEndedError):
            run.all_cells(cells, release)
    handed_in = {cell.grade_id for cell in submitted}
    results = _results(work, name, cells, handed_in, run)
    return GradedNotebook(name, language, tuple(results), executed_notebook(release, cells, run.outputs), run.replies)


class _Run:
    """One notebook's run in a sandbox: outputs by cell, verdicts, replies of answers that are not right, and why it stopped early."""

    def __init__(self, work: Work, language: str) -> None:
        self._work, self.language = work, language
        # cleaned at once, so that what a notebook puts out never fills the grader's memory
        self._room, self._answers_room = Room(), Room()
        self.outputs: list[list[Any] | None] = []
        self.verdicts: dict[str, Verdict] = {}
        self.replies: dict[str, bytes] = {}
        self.stopped: Text | None = None

    def all_cells(self, cells: Sequence[Cell], release: Release) -> None:
        """Run the cells and ask the judge at each check. Raises SandboxEndedError where that ended before; the rest is kept."""
        self.outputs = [None for _ in cells]
        try:
            with Session(self._work.limits, self._work.sandbox, self._work.slot) as session:
                left_out = _left_out(session, cells, release)
                for index, cell in enumerate(cells):
                    if cell.type != "code" or cell.source in left_out:
                        continue
                    if cell.locked and cell.graded:
                        shown, room = [self._judged(session, checked_exercise(str(cell.grade_id)))], self._answers_room
                    else:
                        shown, room = session.run(cell.source), self._room
                    self.outputs[index] = clean_outputs(shown, room)
        except SessionEndedError as error:
            self.stopped = error.reason
            if isinstance(error, SandboxEndedError):
                raise

    def _judged(self, session: Session, name: str) -> dict[str, Any]:
        """Judge one answer, keep the verdict, and return the output that the check cell shows."""
        talks: list[Interview] = []

        def ask(questions: Sequence[Question]) -> Interview:
            talks.append(session.ask(name, questions))
            return talks[-1]

        verdict = judged(exercise_named(name), ask, self._work.seeds.get(name), apart=True)
        self.verdicts[name] = verdict
        if not verdict.passed and talks:
            self.replies[name] = reply_bytes(talks[-1])
        return verdict_output(verdict, self.language)


def _left_out(session: Session, cells: Sequence[Cell], release: Release) -> frozenset[str]:
    """Return the sources of demonstrations that need not run: left unchanged, and without a name that the student's own code uses."""
    own = [cell.source for cell in cells if cell.type == "code" and cell.source not in release.code]
    used = session.names(own)
    return frozenset(source for source, names in release.demos.items() if not names & used)


def _results(work: Work, name: str, cells: Sequence[Cell], handed_in: Collection[str | None], run: _Run) -> list[Result]:
    language = run.language
    written = {cell.grade_id: cell.source for cell in cells if cell.graded and not cell.locked}
    results = []
    for blank in _blank_results(work, name):
        verdict = run.verdicts.get(blank.exercise)
        if blank.status == "manual":
            # where the whole cell is gone, its text may stand elsewhere: a person has to look
            empty = blank.exercise in handed_in and not written[blank.exercise].strip()
            message = (_NOT_WRITTEN if empty else _MANUAL).to(language)
            results.append(replace(blank, message=message, score=0.0 if empty else None))
        elif verdict is not None:
            points = round(verdict.score * blank.max_score, 4)
            message = visible(verdict.message(language))
            results.append(replace(blank, score=points, message=message, misconception=verdict.misconception, seed=verdict.seed))
        else:
            reason = (run.stopped or _NOT_ASKED).to(language)
            results.append(replace(blank, message=reason, status="stopped"))
    return results


def _blank_results(work: Work, name: str) -> list[Result]:
    """Return a zero for every exercise of a notebook, in order, to be filled in."""
    key = f"{work.assignment}/{name}"
    graded = [
        Result(work.student, work.assignment, name, exercise, 0.0, float(exercise_named(exercise).points), "")
        for exercise in NOTEBOOKS[key]
    ]
    points = released(work.release["ja", name]).points
    written = [
        Result(work.student, work.assignment, name, exercise, None, points[exercise], "", status="manual")
        for exercise in WRITTEN.get(key, ())
        if exercise in points
    ]
    return graded + written


def _refused(work: Work, name: str, reason: Text, status: str) -> GradedNotebook:
    """Return zeros with a reason for a notebook that cannot be graded."""
    english = any(b"from course.en import" in data for data in work.notebooks.values() if isinstance(data, bytes))
    language = "en" if english else "ja"
    results = tuple(replace(blank, score=0.0, message=reason.to(language), status=status) for blank in _blank_results(work, name))
    release = released(work.release[language, name])
    return GradedNotebook(name, language, results, executed_notebook(release, release.cells, []))


def reply_bytes(talk: Interview) -> bytes:
    """Return an interview as one frame of the wire."""
    frame = io.BytesIO()
    send(frame, packed_interview(talk))
    return frame.getvalue()


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
