"""A sample class: twelve submissions with known mistakes, and what each of them should get."""

import inspect
import json
import re
import shutil
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from matplotlib.pyplot import close

from autograder.editions import edition, source_cells
from autograder.exercise import GraphExercise
from autograder.grading import notebook_names
from autograder.judging import judge
from autograder.reference import NOTEBOOKS, WRITTEN, exercise_named
from autograder.session import Limits

ASSIGNMENT = "odometry"
#: short, so that the endless loop does not hold up the demonstration
LIMITS = Limits(cell=20.0, check=4.0)

#: instead of a misconception's slug: the stub as it came, an answer that never ends, one that prints instead of returning,
#: one that leaves its process
STUB, ENDLESS, PRINTS, EXITS = "untouched stub", "endless loop", "prints", "exits"
#: a right answer that calls a wrong one
INHERITS = "right, on a wrong one"
#: what becomes of an answer that comes after one that leaves its process: there is nobody left to ask
UNREACHED = "after the exit"
#: what is handed in instead of a notebook
NOTHING, BROKEN, EMPTY = "not handed in", "broken file", "empty file"

_ODD_ANSWERS = {
    ENDLESS: "def {name}(*args):\n    while True:\n        pass\n",
    PRINTS: "def {name}(*args):\n    print(args)\n",
    EXITS: "import os\n\n\ndef {name}(*args):\n    os._exit(0)\n",
}


@dataclass(frozen=True)
class SampleStudent:
    """One student of the sample class: the edition, the wrong answers by exercise, and notebooks that are odd as a whole.

    `inherits` names the mistakes that right answers have from the wrong ones that they call.
    """

    language: str
    wrong: Mapping[str, str] = field(default_factory=dict)
    inherits: Mapping[str, str] = field(default_factory=dict)
    odd: Mapping[str, str] = field(default_factory=dict)
    writes: bool = True


STUDENTS: dict[str, SampleStudent] = {
    "s01-akari": SampleStudent("ja"),
    "s02-ben": SampleStudent(
        "en",
        {"trapezoid_integral": "last_trapezoid_left_out", "adjust_pos_gl": "sp_stays"},
        inherits={"convergence_axes": "trapezoid_of_first_order"},
    ),
    "s03-chie": SampleStudent(
        "ja",
        {"pose_step": "sin_cos_exchanged", "wheel_angle": "gear_forgotten", "wrap_angle": "not_wrapped"},
        inherits={"dead_reckoning": "sin_cos_exchanged", "wheel_speed": "gear_forgotten"},
    ),
    "s04-dan": SampleStudent(
        "en",
        {
            "pose_step": "new_heading_used",
            "body_velocity": "half_missing",
            "count_increments": "wrap_ignored",
            "umbmark": "alpha_and_beta_exchanged",
        },
        inherits={"dead_reckoning": "new_heading_used"},
    ),
    "s05-emi": SampleStudent(
        "ja",
        {
            "planar_rotation": "transposed",
            "body_velocity_matrix": "radii_exchanged",
            "integrate_increments": "euler_rule",
            "convergence_axes": "linear_axes",
        },
        inherits={"pose_step_matrix": "rotated_backwards"},
    ),
    "s06-finn": SampleStudent(
        "en",
        {
            "displacement": "dt_forgotten",
            "pose_step_arc": STUB,
            "wheel_signs": "straight_part_decides",
            "line_command_changes": "answers_exchanged",
            "closing_error": "heading_at_the_end_returned",
        },
    ),
    "s07-goro": SampleStudent(
        "ja",
        {
            "displacement": PRINTS,
            "dead_reckoning": "heading_one_step_late",
            "wheel_speed": "mean_time_step",
            "observed_order": "step_and_error_exchanged",
            "recover_lost_counts": "only_lost_cycles_counted",
        },
    ),
    "s08-holly": SampleStudent("en", {"quadrature_count": "direction_lost", "speed_resolution": ENDLESS}),
    "s09-ichiro": SampleStudent(
        "ja",
        {"pose_step_midpoint": EXITS, "distance_per_count": "two_pi_forgotten"},
        inherits={"speed_resolution": "two_pi_forgotten"},
    ),
    "s10-jack": SampleStudent("en", {"q1_symbolic": "plus_in_x"}, odd={"encoders": NOTHING}),
    "s11-kei": SampleStudent("ja", {"wheel_signs": "icart_assumed"}, odd={"pose_update": BROKEN}),
    "s12-lena": SampleStudent("en", {"pose_step_arc": "divided_by_zero", "dead_reckoning": "last_step_not_taken"}, writes=False),
}


class Row(NamedTuple):
    """One line of the comparison: the cells of the table, and whether what was given is what was expected."""

    shown: tuple[str, ...]
    agrees: bool


class Expected(NamedTuple):
    """What an exercise of a sample student should get: points (None: by hand), misconception, and what was handed in."""

    points: float | None
    misconception: str | None
    handed_in: str


def make_class(root: Path) -> Path:
    """Make the sample class afresh in build/demo below `root`, a course root of its own, and return that folder."""
    folder = root / "build" / "demo"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    shutil.copytree(root / "release", folder / "release")
    shutil.copy(root / "nbgrader_config.py", folder)
    for name in notebook_names(ASSIGNMENT):
        solved = {language: solutions(root, f"{ASSIGNMENT}/{name}", language) for language in ("ja", "en")}
        for student, plan in STUDENTS.items():
            target = folder / "submitted" / student / ASSIGNMENT / f"{name}.ipynb"
            target.parent.mkdir(parents=True, exist_ok=True)
            _hand_in(root, target, plan, solved[plan.language])
    return folder


def expected_results() -> dict[tuple[str, str], Expected]:
    """Return what every exercise of every sample student should get, by (student, exercise)."""
    expected = {}
    for student, plan in STUDENTS.items():
        for name in notebook_names(ASSIGNMENT):
            odd = plan.odd.get(name)
            exited = False
            for exercise in NOTEBOOKS[f"{ASSIGNMENT}/{name}"]:
                wrong = plan.wrong.get(exercise) or plan.inherits.get(exercise)
                wanted = _expected(exercise, wrong, odd or (UNREACHED if exited else None))
                expected[student, exercise] = wanted._replace(handed_in=INHERITS) if exercise in plan.inherits else wanted
                exited = exited or plan.wrong.get(exercise) == EXITS
            for exercise in WRITTEN.get(f"{ASSIGNMENT}/{name}", ()):
                by_hand = plan.writes and odd is None
                expected[student, exercise] = Expected(
                    None if by_hand else 0.0, None, odd or ("written" if by_hand else "nothing written")
                )
    return expected


def compared_rows(given: Mapping[tuple[str, str], tuple[float | None, str | None]]) -> list[Row]:
    """Compare `given` (points and misconception by student and exercise) with what is expected.

    Answers that are simply right, and were given full points, are left out; a notebook without any answer is one row.
    """
    rows: dict[tuple[str, str], Row] = {}
    for (student, exercise), wanted in expected_results().items():
        points, misconception = given.get((student, exercise), (None, "no such result"))
        agrees = points == wanted.points and misconception == wanted.misconception
        if agrees and wanted.handed_in == "right":
            continue
        notebook = next((name for name, odd in STUDENTS[student].odd.items() if odd == wanted.handed_in), None)
        what = f"all of {notebook}" if notebook and agrees else exercise
        shown = (student, STUDENTS[student].language, what, wanted.handed_in, _points(wanted.points), _points(points))
        rows[student, what] = Row((*shown, misconception or "-"), agrees)
    return list(rows.values())


def _points(points: float | None) -> str:
    return "by hand" if points is None else f"{points:g}"


def _expected(exercise: str, wrong: str | None, odd: str | None) -> Expected:
    """Return what the judge, asked here without notebook, sandbox and gradebook, says of an answer."""
    points = exercise_named(exercise).points
    if odd is not None:
        return Expected(0.0, None, odd)
    if wrong is None:
        return Expected(float(points), None, "right")
    if wrong == STUB or wrong in _ODD_ANSWERS:
        return Expected(0.0, None, wrong)
    known = exercise_named(exercise)
    mistake = _mistake(exercise, wrong)
    if isinstance(known, GraphExercise):
        drawn = mistake(known.shown)
        verdict = judge(exercise, drawn, seed=0)
        close(drawn.figure)
    else:
        verdict = judge(exercise, mistake, seed=0)
    return Expected(round(verdict.score * points, 4), wrong, wrong)


def _mistake(exercise: str, slug: str) -> Any:
    return next(mistake.wrong for mistake in exercise_named(exercise).mistakes if mistake.slug == slug)


def solutions(root: Path, notebook: str, language: str) -> dict[str, str]:
    """Return the teacher's answers of one notebook by grade id, without the marks around them."""
    text = (root / "source" / f"{notebook}.md").read_text(encoding="utf-8")
    cells = edition(source_cells(text, notebook), notebook, language).cells
    answers = {
        cell.metadata.nbgrader.grade_id: cell.source for cell in cells if cell.metadata.get("nbgrader", {}).get("solution")
    }
    return {
        grade_id: re.sub(r"^ *### (BEGIN|END) SOLUTION\n?", "", source, flags=re.MULTILINE)
        for grade_id, source in answers.items()
    }


def _hand_in(root: Path, target: Path, plan: SampleStudent, solved: Mapping[str, Any]) -> None:
    """Write one student's notebook: the released one with answers filled in."""
    odd = plan.odd.get(target.stem)
    if odd == NOTHING:
        return
    release = root / "release" / plan.language / ASSIGNMENT / target.name
    notebook = json.loads(release.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        grade_id = cell["metadata"].get("nbgrader", {}).get("grade_id", "")
        if grade_id in solved:
            cell["source"] = _answer(grade_id, plan, solved, "".join(cell["source"]))
    text = json.dumps(notebook, ensure_ascii=False)
    target.write_text({BROKEN: text[: len(text) // 2], EMPTY: ""}.get(odd or "", text), encoding="utf-8")


def _answer(grade_id: str, plan: SampleStudent, solved: Mapping[str, str], stub: str) -> str:
    wrong = plan.wrong.get(grade_id)
    if grade_id in (name for names in WRITTEN.values() for name in names):
        return solved[grade_id] if plan.writes else stub
    if wrong is None:
        return solved[grade_id]
    if wrong == STUB:
        return stub
    if wrong in _ODD_ANSWERS:
        return _ODD_ANSWERS[wrong].format(name=grade_id)
    source = inspect.getsource(_mistake(grade_id, wrong))
    if isinstance(exercise_named(grade_id), GraphExercise):
        source += f"\n\n{grade_id} = {wrong}()\n"
    else:
        source = source.replace(f"def {wrong}(", f"def {grade_id}(", 1)
    return f"import math\n\nimport numpy as np\nimport sympy as sp\n\n\n{source}"
