"""The sample class: what it shows, what each of it gets, and that stock nbgrader gives the same where it can."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from autograder.reference import NOTEBOOKS, WRITTEN, exercise_named
from autograder.sample import (
    BROKEN,
    ENDLESS,
    EXITS,
    INHERITS,
    NOTHING,
    PRINTS,
    STUB,
    STUDENTS,
    UNREACHED,
    compared_rows,
    expected_results,
)

ODD = {STUB, PRINTS, ENDLESS, EXITS}
#: with right, wrong, partly right and inherited answers, and with nothing written; each costs half a minute
BY_STOCK = ("s04-dan", "s12-lena")


def test_twelve_students_six_in_each_language():
    assert len(STUDENTS) == 12
    assert [plan.language for plan in STUDENTS.values()].count("en") == 6
    assert [plan.language for plan in STUDENTS.values()].count("ja") == 6


def test_it_shows_at_least_ten_misconceptions_in_both_notebooks():
    shown = {(exercise, slug) for plan in STUDENTS.values() for exercise, slug in plan.wrong.items() if slug not in ODD}
    for exercise, slug in shown:
        assert slug in exercise_named(exercise).misconceptions
    assert len({slug for _, slug in shown}) >= 10
    for names in NOTEBOOKS.values():
        assert len({slug for exercise, slug in shown if exercise in names}) >= 3


def test_it_shows_every_mishap_once():
    handed_in = [kind for plan in STUDENTS.values() for kind in [*plan.wrong.values(), *plan.odd.values()]]
    assert {kind: handed_in.count(kind) for kind in (*ODD, NOTHING, BROKEN)} == dict.fromkeys((*ODD, NOTHING, BROKEN), 1)
    assert [plan.writes for plan in STUDENTS.values()].count(False) == 1


def test_something_is_expected_of_every_exercise_of_every_student():
    exercises = {name for names in (*NOTEBOOKS.values(), *WRITTEN.values()) for name in names}
    assert expected_results().keys() == {(student, exercise) for student in STUDENTS for exercise in exercises}


def test_what_comes_after_an_exit_is_expected_to_be_zero_and_what_came_before_is_not():
    [(student, exited)] = [(s, e) for s, plan in STUDENTS.items() for e, kind in plan.wrong.items() if kind == EXITS]
    [names] = [names for names in NOTEBOOKS.values() if exited in names]
    expected = {name: expected_results()[student, name] for name in names}
    place = names.index(exited)
    assert 0 < place < len(names) - 1
    assert {expected[name].handed_in for name in names[place + 1 :]} == {UNREACHED}
    assert {expected[name].points for name in names[place:]} == {0.0}
    assert {expected[name].points for name in names[:place]} == {5.0}


@pytest.fixture
def given():
    """What would be given if everything were as expected."""
    return {key: (wanted.points, wanted.misconception) for key, wanted in expected_results().items()}


def test_the_comparison_leaves_out_what_is_right_and_joins_notebooks_without_answers(given):
    rows = compared_rows(given)
    assert all(row.agrees for row in rows)
    assert [row.shown[2] for row in rows if row.shown[0] == "s01-akari"] == ["q1_derivation", "odometry_discussion"]
    [joined] = [row.shown for row in rows if row.shown[3] == NOTHING]
    assert joined == ("s10-jack", "en", "all of encoders", NOTHING, "0", "0", "-")
    assert any(row.shown[3] == INHERITS for row in rows)


@pytest.mark.parametrize(
    ("key", "wrong"),
    [
        (("s01-akari", "pose_step"), (4.0, None)),
        (("s01-akari", "q1_derivation"), (0.0, None)),
        (("s03-chie", "pose_step"), (0.5555, "new_heading_used")),
        (("s10-jack", "wheel_angle"), (5.0, None)),
        (("s02-ben", "wheel_signs"), None),
    ],
)
def test_the_comparison_finds_every_difference(given, key, wrong):
    if wrong is None:
        del given[key]
    else:
        given[key] = wrong
    [row] = [row for row in compared_rows(given) if not row.agrees]
    assert (row.shown[0], row.shown[2]) == key


# graded


@pytest.fixture(scope="module")
def course(root, tmp_path_factory):
    """A course of its own to make the class in, so that build/demo stays as it is."""
    folder = tmp_path_factory.mktemp("course")
    for name in ("source", "release", "nbgrader_config.py"):
        (folder / name).symlink_to(root / name)
    return folder


def run(folder, *command):
    """Run a command of this environment in `folder` and return what it prints."""
    programs = Path(sys.executable).parent
    path = f"{programs}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, env={**os.environ, "PATH": path})
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def demo(course):
    """(what `autograder demo` prints, the rows of its results)."""
    printed = run(course, "autograder", "demo")
    lines = (course / "build/demo/results.json").read_text(encoding="utf-8").splitlines()
    return printed, [json.loads(line) for line in lines]


@pytest.mark.slow
@pytest.mark.sandbox
@pytest.mark.timeout(900)
def test_the_demonstration_ends_with_every_score_as_expected(demo):
    printed, rows = demo
    assert f"All {len(rows)} results are as expected" in printed
    assert "✗" not in printed
    assert len(rows) == len(expected_results())
    given = {(row["student"], row["exercise"]): (row["score"], row["misconception"]) for row in rows}
    assert all(row.agrees for row in compared_rows(given))


@pytest.mark.slow
@pytest.mark.sandbox
@pytest.mark.timeout(900)
def test_each_student_is_answered_in_the_language_of_the_edition(demo):
    for row in demo[1]:
        japanese = any("ぁ" <= letter <= "ん" for letter in row["message"])
        # a file that cannot be read has no language any more, but what is left of it may tell
        assert japanese == (STUDENTS[row["student"]].language == "ja"), row


@pytest.mark.slow
@pytest.mark.sandbox
@pytest.mark.timeout(900)
def test_stock_nbgrader_gives_the_same_where_an_answer_is_right_or_wrong_and_0_where_it_is_partly_right(course, demo, tmp_path):
    from nbgrader.api import Gradebook

    from autograder.registering import register

    class_root = tmp_path / "stock"
    for student in BY_STOCK:
        shutil.copytree(course / "build/demo/submitted" / student, class_root / "submitted" / student)
    shutil.copytree(course / "build/demo/release", class_root / "release")
    shutil.copy(course / "nbgrader_config.py", class_root)
    # one made by us, like the TA's; stock nbgrader finds its cells there
    shutil.copy(course / "build/demo/gradebook.db", class_root)
    with Gradebook(f"sqlite:///{class_root}/gradebook.db", "dead-reckoning") as gradebook:
        for student in gradebook.students:
            gradebook.remove_student(student.id)
        register(gradebook, class_root, "odometry")
    run(class_root, "nbgrader", "autograde", "odometry", "--Autograde.exporter_class=nbconvert.exporters.NotebookExporter")
    with Gradebook(f"sqlite:///{class_root}/gradebook.db", "dead-reckoning") as gradebook:
        stock = {
            (submission.student.id, grade.name.removeprefix("check_")): None if grade.needs_manual_grade else grade.auto_score
            for submission in gradebook.assignment_submissions("odometry")
            for notebook in submission.notebooks
            for grade in notebook.grades
        }
    ours = {(row["student"], row["exercise"]): row for row in demo[1] if row["student"] in BY_STOCK}
    partly = {key for key, row in ours.items() if row["score"] is not None and 0 < row["score"] < row["max_score"]}
    assert len(partly) >= 3
    assert stock == {key: 0.0 if key in partly else row["score"] for key, row in ours.items()}
