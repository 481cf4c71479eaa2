"""`autograder explain`: the cases of a recorded verdict, and that they really are those."""

import dataclasses
import re
import shutil

import numpy as np
import pytest
from typer.testing import CliRunner

from autograder import appeal as appeals
from autograder.appeal import AppealError, appeal
from autograder.batch import grade_class
from autograder.cli import app
from autograder.engine import Options
from autograder.exercise import trial
from autograder.grading import reply_bytes
from autograder.receipts import read_receipt, submission_folder
from autograder.reference import exercise_named
from course.answers import Interview, Reply

WRONG = "def displacement(V, omega, dt):\n    return np.array([V, 0.0, omega])"
RAISES = "def displacement(V, omega, dt):\n    if omega < 0:\n        raise ValueError('[bold]no reverse')\n    return np.array([V * dt, 0.0, omega * dt])"


@pytest.fixture
def course(class_root, hand_in, answered, empty_gradebook, graded_here):
    """A class: Ann has one answer wrong, Bob's raises, Cem handed in what is no notebook."""
    shutil.copy(empty_gradebook, class_root / "gradebook.db")
    hand_in("ann", pose_update=answered(displacement=WRONG))
    hand_in("bob", pose_update=answered(displacement=RAISES))
    hand_in("cem", pose_update=b"no notebook")
    grade_class(class_root, "odometry", Options(sandbox=False))
    return class_root


def recorded(course, student, exercise):
    return next(row for row in read_receipt(course, "odometry", student).results if row["exercise"] == exercise)


def said(course, *arguments):
    done = CliRunner().invoke(app, ["explain", *arguments, "--root", str(course)])
    assert done.exception is None or isinstance(done.exception, SystemExit), done.exception
    return " ".join(done.output.replace("│", " ").split()), done.exit_code


def numbers(text):
    return [float(number) for number in re.findall(r"-?\d+\.?\d*(?:e[-+]?\d+)?", text)]


def test_a_wrong_answer_is_shown_with_the_inputs_expected_and_given_values_of_its_verdict(course):
    found = appeal(course, "ann", "odometry", "displacement", full=True)
    row = recorded(course, "ann", "displacement")
    assert (found.result.score, found.result.seed, found.attempt) == (row["score"], row["seed"], 1)
    assert (found.unchanged, found.agrees) == (True, True)
    # worked out here from the seed on record: V, omega and dt, the right displacement, and what that answer makes of them
    questions = trial(exercise_named("displacement"), row["seed"]).questions
    assert len(found.cases) == len(questions) > 2
    for case, question in zip(found.cases, questions, strict=True):
        V, omega, dt = question.args
        assert numbers(case.inputs) == pytest.approx([V, omega, dt], rel=1e-5)
        assert numbers(case.expected) == pytest.approx([V * dt, 0.0, omega * dt], abs=1e-5)
        assert numbers(case.given) == pytest.approx([V, 0.0, omega], abs=1e-5)
        # at rest both are the same
        assert case.right == (V == omega == 0)


def test_a_right_answer_has_its_cases_too_and_no_replies_are_kept(course):
    found = appeal(course, "ann", "odometry", "pose_step")
    assert found.result.score == found.result.max_score
    assert {(case.given, case.right) for case in found.cases} == {("the same", True)}
    assert found.agrees is None
    assert not [*submission_folder(course, "odometry", "ann").glob("pose_step*")]


def test_an_exception_is_shown_in_the_cases_in_which_it_was_raised(course):
    found = appeal(course, "bob", "odometry", "displacement")
    raised = [case for case in found.cases if case.given == "ValueError: [bold]no reverse"]
    assert raised == [case for case in found.cases if not case.right]
    assert 0 < len(raised) < len(found.cases)
    assert all(numbers(case.inputs)[1] < 0 for case in raised)
    assert found.agrees is True
    text, code = said(course, "bob", "odometry", "displacement")
    assert code == 0
    # not taken for markup
    assert "[bold]no reverse" in text


def test_the_command_shows_verdict_cases_and_that_the_judge_says_the_same_today(course):
    text, code = said(course, "ann", "odometry", "displacement")
    row = recorded(course, "ann", "displacement")
    assert code == 0
    assert f"ann: displacement, {row['score']:g} of {row['max_score']:g} points, attempt 1" in text
    assert f"misconception: {row['misconception']}" in text
    assert f"seed {row['seed']}" in text
    for column in ("kind of input", "inputs", "expected", "given"):
        assert column in text
    assert text.endswith("Judged again just now: the same verdict.")
    assert "has changed since" not in text


def test_of_a_later_attempt_the_later_cases_are_shown(course, hand_in, answered):
    first = appeal(course, "ann", "odometry", "displacement")
    hand_in("ann", pose_update=answered(displacement=WRONG + "  # again"))
    grade_class(course, "odometry", Options(sandbox=False))
    second = appeal(course, "ann", "odometry", "displacement")
    assert second.attempt == 2
    assert second.agrees is True
    assert [case.inputs for case in first.cases] != [case.inputs for case in second.cases]


def test_the_attempt_is_that_of_the_version_that_counts(course, hand_in, answered):
    """Not of the last one that was new: an earlier version may be handed in again."""
    first = appeal(course, "ann", "odometry", "displacement")
    for answer in (WRONG + "  # again", WRONG):
        hand_in("ann", pose_update=answered(displacement=answer))
        grade_class(course, "odometry", Options(sandbox=False))
    again = appeal(course, "ann", "odometry", "displacement")
    assert (again.attempt, again.cases) == (first.attempt, first.cases)
    hand_in("ann", pose_update=answered())
    grade_class(course, "odometry", Options(sandbox=False, attempts=2))
    too_late = appeal(course, "ann", "odometry", "displacement")
    assert (too_late.result.status, too_late.attempt, too_late.cases) == ("attempts", first.attempt, first.cases)


def test_other_replies_than_those_of_the_verdict_are_noticed(course):
    """Here: those of an answer that is right, put in their place."""
    questions = trial(exercise_named("displacement"), recorded(course, "ann", "displacement")["seed"]).questions
    right = [np.array([V * dt, 0.0, omega * dt]) for V, omega, dt in (question.args for question in questions)]
    replies = tuple(Reply(value, inputs=question.args) for value, question in zip(right, questions, strict=True))
    path = submission_folder(course, "odometry", "ann") / "displacement.reply"
    path.write_bytes(reply_bytes(Interview(replies=replies)))
    assert appeal(course, "ann", "odometry", "displacement").agrees is False
    text, code = said(course, "ann", "odometry", "displacement")
    assert (code, text.endswith("Judged again just now: another verdict.")) == (0, True)


def test_exercises_that_have_changed_since_are_said(course, monkeypatch):
    monkeypatch.setattr(appeals, "exercises_hash", lambda: "another")
    assert not appeal(course, "ann", "odometry", "displacement").unchanged
    text, _ = said(course, "ann", "odometry", "displacement")
    assert "The exercise or the judge has changed since: today's cases are shown. Type: autograder grade --regrade" in text


def test_long_arrays_are_shortened_unless_they_are_asked_for(monkeypatch):
    assert "..." in appeals._given(Reply(np.arange(5000.0)))
    seed = 3
    name, long = "pose_step", Reply(np.arange(2000.0))
    questions = trial(exercise_named(name), seed).questions
    talk = Interview(replies=tuple(dataclasses.replace(long, inputs=question.args) for question in questions))
    assert "..." in appeals._cases(name, seed, talk, False)[0].given
    assert "..." not in appeals._cases(name, seed, talk, True)[0].given


# what cannot be explained

REFUSED = {
    "an unknown student": (["zoe", "odometry", "displacement"], "nothing is recorded of zoe in odometry. Type: autograder grade odometry --student 'zoe'"),
    "an unknown assignment": (["ann", "imu", "displacement"], "nothing is recorded of ann in imu."),
    "an unknown exercise": (["ann", "odometry", "nosuch"], "odometry has no exercise 'nosuch'; there are: pose_step, displacement, q1_derivation, distance_per_count"),
    "a written answer": (["ann", "odometry", "q1_derivation"], "q1_derivation was not judged by cases: A person grades this answer."),
    "a notebook that is not there": (["ann", "odometry", "distance_per_count"], "distance_per_count was not judged by cases: This notebook was not handed in."),
    "no notebook": (["cem", "odometry", "displacement"], "displacement was not judged by cases: ノートブックとして読めません"),
    "a student of another folder": (["../odometry/ann", "odometry", "displacement"], "nothing is recorded of ../odometry/ann"),
}  # fmt: skip


@pytest.mark.parametrize(("arguments", "told"), REFUSED.values(), ids=REFUSED.keys())
def test_what_there_is_no_verdict_on(course, arguments, told):
    text, code = said(course, *arguments)
    assert code == 1
    assert f"error: {told}" in text


@pytest.mark.parametrize(
    "damage", [b"", b"DR1\n", b"\0" * 100, b"DR1\n\0\0\0\x09\0\0\0\0{}"], ids=["empty", "cut off", "zeros", "cut off text"]
)
def test_replies_that_cannot_be_read_any_more(course, damage):
    (submission_folder(course, "odometry", "ann") / "displacement.reply").write_bytes(damage)
    with pytest.raises(AppealError, match=r"displacement\.reply cannot be read any more"):
        appeal(course, "ann", "odometry", "displacement")


def test_nothing_is_changed_by_asking(course):
    def everything():
        return {path: path.read_bytes() for path in course.rglob("*") if path.is_file()}

    before = everything()
    said(course, "ann", "odometry", "displacement")
    said(course, "zoe", "odometry", "displacement")
    assert everything() == before
