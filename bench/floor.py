"""The floor: the same cells run and the same answers called on the same cases, in forks of a warm IPython and with nothing else.

    python bench/floor.py ROOT FILE

ROOT is a course root that `autograder grade` has graded: the seeds of the cases come from its receipts. No sandbox, no wire, no
judgement, no gradebook. Writes, as JSON, the
processor time for loading, for the notebooks, and their number.
"""

import gc
import json
import os
import resource
import sys
from collections.abc import Iterator
from pathlib import Path

from autograder.exercise import Exercise, checked_exercise, trial
from autograder.grading import notebook_names
from autograder.intake import language_of, restored_cells, submitted_cells
from autograder.receipts import read_receipt
from autograder.reference import exercise_named
from autograder.released import released
from autograder.sandbox.cells import Cells
from autograder.sandbox.forking import warm_cells
from autograder.submissions import release_notebooks, students_with
from bench.classes import ASSIGNMENT
from course.answers import Question, find, interview

#: (source, "") for a cell that is run, (name, questions) for an answer that is asked
Step = tuple[str, tuple[Question, ...] | None]


def main(root: Path, told: Path) -> None:
    """Run every submission of the class, each notebook in a fork."""
    cells = warm_cells()
    notebooks = [steps for student in students_with(root, ASSIGNMENT) for steps in _steps(root, student, cells)]
    gc.freeze()
    loading = _seconds(resource.RUSAGE_SELF)
    for number, steps in enumerate(notebooks):
        # two at a time, as with two workers: busy cores slow each other
        if number >= 2:
            os.wait()
        child = os.fork()
        if child == 0:
            # as in any process that runs notebooks
            gc.enable()
            for source, questions in steps:
                if questions is None:
                    cells.run(source, 30.0)
                    continue
                answer, missing = find(source, cells.namespace, cells.sources)
                if missing is None:
                    interview(answer, questions)
            os._exit(0)
    for _ in notebooks[:2]:
        os.wait()
    forking = _seconds(resource.RUSAGE_SELF) - loading
    running = _seconds(resource.RUSAGE_CHILDREN) + forking
    told.write_text(json.dumps({"loading": loading, "notebooks": running, "count": len(notebooks)}))


def _steps(root: Path, student: str, cells: Cells) -> Iterator[list[Step]]:
    """Yield what is done with each notebook of one student, as grading did it."""
    release = release_notebooks(root, ASSIGNMENT)
    receipt = read_receipt(root, ASSIGNMENT, student)
    assert receipt is not None
    seeds = {row["exercise"]: row["seed"] for row in receipt.results}
    for name in notebook_names(ASSIGNMENT):
        submitted = submitted_cells((root / "submitted" / student / ASSIGNMENT / f"{name}.ipynb").read_bytes())
        ours = released(release[language_of(submitted), name])
        restored = restored_cells(ours.cells, submitted)
        used = set(cells.names_used(cell.source for cell in restored if cell.type == "code" and cell.source not in ours.code))
        left_out = {source for source, names in ours.demos.items() if not names & used}
        steps: list[Step] = []
        for cell in restored:
            if cell.locked and cell.graded:
                exercise = exercise_named(checked_exercise(str(cell.grade_id)))
                questions = trial(exercise, seeds[exercise.name]).questions if isinstance(exercise, Exercise) else ()
                steps.append((exercise.name, questions))
            elif cell.type == "code" and cell.source not in left_out:
                steps.append((cell.source, None))
        yield steps


def _seconds(who: int) -> float:
    used = resource.getrusage(who)
    return used.ru_utime + used.ru_stime


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
