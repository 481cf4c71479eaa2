"""One run over a class after another: what is graded again and what is not, attempts, and seeds."""

import json
import os
import shutil
import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest

from autograder import batch
from autograder.batch import BatchError, grade_class
from autograder.engine import Options
from autograder.receipts import read_receipt, receipts_folder
from autograder.seeds import course_secret, exercise_seed

ROOT = Path(__file__).parents[2]
BARE = Options(sandbox=False)
WRONG = "def displacement(V, omega, dt):\n    return np.array([V, 0.0, omega])"
ALSO_WRONG = "def displacement(V, omega, dt):\n    return np.array([0.0, V * dt, omega * dt])"


@pytest.fixture
def course(class_root, hand_in, answered, empty_gradebook, graded_here):
    """A class of two, where everything is graded already: Ann has everything right, Bob one of three."""
    shutil.copy(empty_gradebook, class_root / "gradebook.db")
    hand_in("ann", pose_update=answered(), encoders=answered("encoders"))
    hand_in("bob", pose_update=answered(language="ja", displacement=WRONG))
    grade_class(class_root, "odometry", BARE)
    assert graded_here == ["ann", "bob"]
    graded_here.clear()
    return class_root


def scores(results):
    return {(result.student, result.exercise): result.score for result in results}


def in_gradebook(root):
    """The automatic points that stand in the gradebook."""
    with sqlite3.connect(root / "gradebook.db") as database:
        rows = database.execute(
            "SELECT submitted_assignment.student_id, base_cell.name, grade.auto_score FROM grade"
            " JOIN base_cell ON base_cell.id = grade.cell_id"
            " JOIN submitted_notebook ON submitted_notebook.id = grade.notebook_id"
            " JOIN submitted_assignment ON submitted_assignment.id = submitted_notebook.assignment_id"
        ).fetchall()
    database.close()
    return {(student, cell.removeprefix("check_")): score for student, cell, score in rows}


SCORES = {
    ("ann", "pose_step"): 5.0, ("ann", "displacement"): 5.0, ("ann", "q1_derivation"): None, ("ann", "distance_per_count"): 5.0,
    ("bob", "pose_step"): 5.0, ("bob", "displacement"): 0.0, ("bob", "q1_derivation"): None, ("bob", "distance_per_count"): 0.0,
}  # fmt: skip


# what is graded again


def test_what_has_not_changed_is_not_graded_again_and_its_results_are_the_same(course, graded_here):
    first = grade_class(course, "odometry", Options(sandbox=False, regrade=True))
    graded_here.clear()
    before = {path: path.stat().st_mtime_ns for path in [*course.glob("autograded/*/*/*"), course / "gradebook.db"]}
    second = grade_class(course, "odometry", BARE)
    assert graded_here == []
    assert second == first
    assert scores(second) == in_gradebook(course) == SCORES
    assert {path: path.stat().st_mtime_ns for path in before} == before


def changes():
    """Each of these makes both submissions, or the one that is named, new."""

    def submission(course, answered, monkeypatch):
        path = course / "submitted/bob/odometry/pose_update.ipynb"
        path.write_bytes(path.read_bytes() + b" ")

    def another_notebook(course, answered, monkeypatch):
        (course / "submitted/bob/odometry/encoders.ipynb").write_bytes(answered("encoders"))

    def one_notebook_less(course, answered, monkeypatch):
        (course / "submitted/ann/odometry/encoders.ipynb").unlink()

    def release(course, answered, monkeypatch):
        path = course / "release/en/odometry/encoders.ipynb"
        path.write_bytes(path.read_bytes() + b"\n")

    def exercises(course, answered, monkeypatch):
        monkeypatch.setattr(batch, "exercises_hash", lambda: "another")

    def gradebook(course, answered, monkeypatch):
        with sqlite3.connect(course / "gradebook.db") as database:
            database.execute("UPDATE grade SET auto_score = 9 WHERE auto_score = 0")
        database.close()

    def gradebook_gone(course, answered, monkeypatch):
        (course / "gradebook.db").unlink()

    def autograded(course, answered, monkeypatch):
        (course / "autograded/ann/odometry/encoders.ipynb").unlink()

    def receipt(course, answered, monkeypatch):
        path = course / ".autograder/receipts/odometry/bob/receipt.json"
        path.write_bytes(path.read_bytes()[:-9])

    def anothers_receipt(course, answered, monkeypatch):
        receipts = course / ".autograder/receipts/odometry"
        shutil.copy(receipts / "ann/receipt.json", receipts / "bob/receipt.json")

    return {
        submission: ["bob"], another_notebook: ["bob"], one_notebook_less: ["ann"], release: ["ann", "bob"], exercises: ["ann", "bob"],
        gradebook: ["bob"], gradebook_gone: ["ann", "bob"], autograded: ["ann"], receipt: ["bob"], anothers_receipt: ["bob"],
    }  # fmt: skip


@pytest.mark.parametrize(("change", "again"), changes().items(), ids=lambda value: getattr(value, "__name__", None))
def test_what_has_changed_is_graded_again_and_only_that(course, graded_here, answered, monkeypatch, change, again):
    change(course, answered, monkeypatch)
    results = grade_class(course, "odometry", BARE)
    assert graded_here == again
    # and the gradebook says what the results say, whatever stood there
    assert in_gradebook(course) == scores(results)
    graded_here.clear()
    assert scores(grade_class(course, "odometry", BARE)) == scores(results)
    assert graded_here == []


@pytest.mark.sandbox
def test_what_was_graded_without_a_sandbox_is_graded_again_in_one(course, graded_here):
    assert scores(grade_class(course, "odometry", Options())) == SCORES
    assert graded_here == ["ann", "bob"]
    graded_here.clear()
    grade_class(course, "odometry", Options())
    assert graded_here == []


def test_regrade_grades_everything_again_with_the_same_cases(course, graded_here):
    before = grade_class(course, "odometry", BARE)
    assert grade_class(course, "odometry", Options(sandbox=False, regrade=True)) == before
    assert graded_here == ["ann", "bob"]


def test_only_who_is_asked_for_is_graded_again(course, graded_here):
    results = grade_class(course, "odometry", Options("b*", sandbox=False, regrade=True))
    assert graded_here == ["bob"]
    assert {result.student for result in results} == {"bob"}
    graded_here.clear()
    results = grade_class(course, "odometry", Options(sandbox=False, regrade=True, only=frozenset({"ann", "nobody"})))
    assert graded_here == ["ann"]
    assert {result.student for result in results} == {"ann"}


def test_a_run_that_was_ended_goes_on_where_it_stopped(course, graded_here, monkeypatch):
    finished = []

    def stop(done, count, student):
        if done:
            finished.append(student)
            raise KeyboardInterrupt

    monkeypatch.setattr(batch, "exercises_hash", lambda: "another")
    with pytest.raises(KeyboardInterrupt):
        grade_class(course, "odometry", BARE, stop)
    graded_here.clear()
    assert scores(grade_class(course, "odometry", BARE)) == SCORES
    assert sorted(graded_here + finished) == ["ann", "bob"]


def test_progress_is_told_for_who_is_graded_and_who_is_not(course, hand_in, answered):
    hand_in("aaron", pose_update=answered())
    told = []
    grade_class(course, "odometry", BARE, lambda *progress: told.append(progress))
    assert told[0] == (0, 3, "")
    assert [progress[:2] for progress in told[1:]] == [(1, 3), (2, 3), (3, 3)]
    assert sorted(progress[2] for progress in told[1:]) == ["aaron", "ann", "bob"]


AGAIN = """
import json, sys
from pathlib import Path
from autograder.batch import grade_class
from autograder.engine import Options
results = grade_class(Path(sys.argv[1]), "odometry", Options(sandbox=False))
slow = [name for name in ("nbgrader", "nbconvert", "IPython", "multiprocessing.pool") if name in sys.modules]
print(json.dumps([slow, [[result.exercise, result.score] for result in results]]))
"""


def test_a_second_run_does_not_even_import_nbgrader(tmp_path, graded_here):
    """With the course itself: another process does not see what a test put into the table of contents."""
    shutil.copytree(ROOT / "release", tmp_path / "release")
    shutil.copy(ROOT / "nbgrader_config.py", tmp_path)
    folder = tmp_path / "submitted/ann/odometry"
    folder.mkdir(parents=True)
    (folder / "pose_update.ipynb").write_bytes(b"broken")
    first = grade_class(tmp_path, "odometry", BARE)
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-c", AGAIN, tmp_path], env=environment, capture_output=True, text=True, check=True, timeout=120
    )
    slow, results = json.loads(done.stdout)
    assert slow == []
    assert results == [[result.exercise, result.score] for result in first]


# attempts


def bobs(results):
    return {result.exercise: result for result in results if result.student == "bob" and result.notebook == "pose_update"}


@pytest.fixture
def bob_hands_in(course, hand_in, answered):
    """Returns a function: Bob hands in another version, the class is graded, and what came of his notebook is returned."""

    def graded(displacement, language="ja", attempts=2):
        hand_in("bob", pose_update=answered(language=language, displacement=displacement))
        return bobs(grade_class(course, "odometry", Options(sandbox=False, attempts=attempts)))

    return graded


RIGHT = "def displacement(V, omega, dt):\n    return np.array([V * dt, 0.0, omega * dt])"


def test_the_version_after_the_last_attempt_is_not_graded_and_the_one_before_counts(course, graded_here, bob_hands_in):
    second = bob_hands_in(ALSO_WRONG)
    third = bob_hands_in(RIGHT)
    # the submission is looked at, for its other notebook; this one is not
    assert {name: result.score for name, result in third.items()} == {name: result.score for name, result in second.items()}
    assert in_gradebook(course) == SCORES
    assert {result.status for result in third.values()} == {"attempts"}
    for name, result in third.items():
        assert (
            result.message
            == f"{second[name].message}\nこのノートブックの提出回数の上限(2回)に達しました。最後に採点した提出の結果をそのまま使います。"
        )
        assert result.misconception == second[name].misconception
        assert result.seed == second[name].seed
    assert len(read_receipt(course, "odometry", "bob").attempts["pose_update"]) == 2


def test_the_message_is_in_the_language_of_the_version_that_counts(bob_hands_in):
    bob_hands_in(ALSO_WRONG, "en")
    third = bob_hands_in(RIGHT, "ja")
    assert {result.message.splitlines()[-1] for result in third.values()} == {
        "All 2 attempts at this notebook are used up: the last one that was graded counts."
    }


def test_it_is_said_once_however_often_the_class_is_graded(course, graded_here, bob_hands_in):
    bob_hands_in(ALSO_WRONG)
    third = bob_hands_in(RIGHT)
    graded_here.clear()
    assert bobs(grade_class(course, "odometry", Options(sandbox=False, attempts=2))) == third
    assert graded_here == []
    assert bob_hands_in(RIGHT + "\n") == third
    assert bobs(grade_class(course, "odometry", Options(sandbox=False, attempts=2, regrade=True))) == third


def test_with_more_attempts_it_is_graded_after_all(course, bob_hands_in):
    bob_hands_in(ALSO_WRONG)
    bob_hands_in(RIGHT)
    results = bobs(grade_class(course, "odometry", Options(sandbox=False, attempts=3, regrade=True)))
    assert results["displacement"].score == 5.0
    assert results["displacement"].status == "graded"
    assert in_gradebook(course)["bob", "displacement"] == 5.0


def test_an_earlier_version_is_no_new_attempt_and_gets_its_earlier_cases(course, bob_hands_in):
    first = bobs(grade_class(course, "odometry", BARE))
    second = bob_hands_in(ALSO_WRONG)
    assert bob_hands_in(WRONG) == first
    assert bob_hands_in(ALSO_WRONG) == second
    assert len(read_receipt(course, "odometry", "bob").attempts["pose_update"]) == 2
    assert {name: first[name].seed != second[name].seed for name in ("pose_step", "displacement")} == {
        "pose_step": True,
        "displacement": True,
    }


def test_the_cases_are_those_of_the_secret_the_student_the_exercise_and_the_attempt(course, bob_hands_in):
    secret = course_secret(receipts_folder(course))
    for attempt, answer in enumerate((WRONG, ALSO_WRONG), 1):
        results = bob_hands_in(answer)
        for name in ("pose_step", "displacement"):
            assert results[name].seed == exercise_seed(secret, "bob", "odometry", name, attempt)
    seeds = [result.seed for result in grade_class(course, "odometry", BARE) if result.seed is not None]
    assert len(set(seeds)) == len(seeds) == 5


def test_what_was_never_readable_takes_no_attempt_of_what_is(course, hand_in, bob_hands_in):
    """A file that is missing is none; a broken one is."""
    (course / "submitted/bob/odometry/pose_update.ipynb").unlink()
    grade_class(course, "odometry", Options(sandbox=False, attempts=2))
    assert len(read_receipt(course, "odometry", "bob").attempts["pose_update"]) == 1
    assert bob_hands_in(RIGHT)["displacement"].score == 5.0


# what cannot be graded


def test_two_graders_at_a_time_do_not_write_over_one_another(course, graded_here):
    with batch._only_grader(course), pytest.raises(BatchError, match="another grader is at work"):
        grade_class(course, "odometry", Options(sandbox=False, regrade=True))
    assert graded_here == []
    assert len(grade_class(course, "odometry", BARE)) == len(SCORES)


def test_a_damaged_secret_stops_everything_and_is_said(course, graded_here):
    (course / ".autograder/secret").write_bytes(b"short")
    with pytest.raises(BatchError, match="secret is damaged"):
        grade_class(course, "odometry", Options(sandbox=False, regrade=True))
    assert graded_here == []
