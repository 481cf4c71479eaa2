"""Answers that are dicts, inputs that are to be refused, and inputs that are built: what the judge makes of them."""

from functools import partial

import numpy as np
import pytest

from autograder.exercise import Exercise, Group, Mistake, trial
from autograder.judging import judged
from autograder.sandbox.wire import packed_interview, packed_questions, unpacked_interview, unpacked_questions
from course.answers import interview
from course.given import built_file
from course.language import Text
from course.tolerances import ONE_QUANTITY, STAMPS, RecordTolerance, Tolerance


def read(path):
    rows = []
    for number, line in enumerate(path.read_text().splitlines(), start=1):
        values = line.split()
        if len(values) != 2:
            raise ValueError(number)
        rows.append([float(value) for value in values])
    table = np.array(rows)
    return {"time": table[:, 0], "speed": table[:, 1]}


def line_counted_from_zero(path):
    try:
        return read(path)
    except ValueError as error:
        raise ValueError(int(str(error)) - 1) from None


def columns_exchanged(path):
    log = read(path)
    return {"time": log["speed"], "speed": log["time"]}


def cases(rng):
    def good():
        rows = rng.uniform(1, 9, (5, 2)).cumsum(axis=0)
        rows[:, 0] += 1.6e9
        return "".join(f"{t:.6f} {v:.6f}\n" for t, v in rows)

    return [
        Group(Text("good files", "正しいファイル"), 1, [(built_file(good().encode()),) for _ in range(2)]),
        Group(Text("cut lines", "途中で切れた行"), 1, [(built_file((good() + "17\n").encode()),)]),
    ]


def a_table(path):
    return np.column_stack(list(read(path).values()))


READER = Exercise(
    name="read",
    notebook="odometry/pose_update",
    points=5,
    parameters=("path",),
    reference=read,
    cases=cases,
    examples=(),
    mistakes=tuple(
        Mistake(wrong, Text(wrong.__name__, wrong.__name__)) for wrong in (line_counted_from_zero, columns_exchanged, a_table)
    ),
    tolerance=RecordTolerance((("time", STAMPS), ("speed", Tolerance(skip=1, double=True)))),
    quantities=("time", "speed"),
    refuses=(ValueError,),
)


def changed(**entries):
    return lambda path: {**read(path), **{key: change(read(path)[key]) for key, change in entries.items()}}


def in_other_words(path):
    try:
        return {**read(path), "more": 1}
    except ValueError as error:
        raise UnicodeError(f"row {error} has the wrong number of columns, 2 are needed") from None


def lenient(path):
    try:
        return read(path)
    except ValueError:
        return {"time": np.zeros(1), "speed": np.zeros(1)}


def another_error(path):
    try:
        return read(path)
    except ValueError:
        raise KeyError("speed") from None


def says_nothing(path):
    try:
        return read(path)
    except ValueError:
        raise ValueError("bad file") from None


def first_unknown(speed):
    return np.concatenate([[np.nan], speed[1:]])


WRONG = {
    "a tuple": (lambda path: tuple(read(path).values()), "shape", None, "time, speed"),
    "a table": (a_table, "shape", "a_table", "a_table"),
    "another table": (lambda path: 2 * a_table(path), "shape", None, "time, speed"),
    "an entry missing": (lambda path: {"time": read(path)["time"], "Speed": 0.0}, "shape", None, "time, Speed"),
    "nothing": (lambda path: read(path) and None, "shape", None, "return"),
    "an entry of another shape": (changed(speed=lambda speed: speed[1:]), "shape", None, "In the entry 'speed'"),
    "an entry that is nothing": (changed(speed=lambda speed: None), "shape", None, "In the entry 'speed'"),
    "an entry with gaps": (changed(speed=lambda speed: speed * np.nan), "shape", None, "NaN"),
    "stamps in float32": (changed(time=np.float32), "value", None, "time is not right; speed is"),
    "numbers of another type": (changed(speed=np.float32), "shape", None, "float32"),
    "an entry in other units": (changed(speed=lambda speed: speed * 1000), "unit", None, "speed is right up to a constant"),
    "columns exchanged": (columns_exchanged, "value", "columns_exchanged", "columns_exchanged"),
    "nothing refused": (lenient, "shape", None, "raise ValueError"),
    "another error": (another_error, "runs", None, "another error came"),
    "no line named": (says_nothing, "value", None, "bad file"),
    "another line named": (line_counted_from_zero, "value", "line_counted_from_zero", "line_counted_from_zero"),
}


@pytest.mark.parametrize(
    "answer", [read, in_other_words, changed(speed=first_unknown), changed(time=list)], ids=["plain", "words", "first", "list"]
)
def test_right_answers_are_right(answer):
    verdict = judged(READER, partial(interview, answer), 1)
    assert (verdict.score, verdict.rung) == (1.0, None), verdict.message("en")


@pytest.mark.parametrize(("answer", "rung", "slug", "said"), WRONG.values(), ids=WRONG.keys())
def test_wrong_answers_are_told_what_is_wrong(answer, rung, slug, said):
    verdict = judged(READER, partial(interview, answer), 1)
    assert verdict.score < 1
    assert (verdict.rung, verdict.misconception) == (rung, slug)
    assert said in verdict.message("en")
    assert verdict.message("ja") != verdict.message("en") or slug


def test_what_is_right_in_part_keeps_its_share():
    assert judged(READER, partial(interview, says_nothing), 1).score == 0.5


def test_the_verdict_is_the_same_across_the_wire():
    def across(answer, questions):
        asked = unpacked_questions(packed_questions(tuple(questions)))
        return unpacked_interview(packed_interview(interview(answer, asked), asked), tuple(questions))

    for answer in (read, columns_exchanged, lenient, says_nothing):
        assert judged(READER, partial(across, answer), 3) == judged(READER, partial(interview, answer), 3)


def test_records_are_compared_entry_by_entry():
    right = {"a": np.array([1.0, 2.0]), "b": np.array([[3.0, 4.0]])}
    tolerance = RecordTolerance((("a", ONE_QUANTITY), ("b", Tolerance(axis=-1))))
    assert tolerance.quantities_right({**right, "b": right["b"] + 1}, right).tolist() == [True, False]


def test_the_cases_are_drawn_afresh():
    assert repr(trial(READER, 1).questions) != repr(trial(READER, 2).questions)


def twice(path):
    return {key: 2 * values for key, values in read(path).items()}


def test_a_reply_right_by_no_rule_is_compared_with_the_nearest():
    """Both entries are wrong by the reference; by the other rule it is the time alone, and no mistake is made out in the speed."""
    exercise = Exercise(**{**vars(READER), "also_right": (twice,), "mistakes": (Mistake(columns_exchanged, Text("no", "no")),)})
    verdict = judged(exercise, partial(interview, changed(time=lambda time: 2000 * time, speed=lambda speed: 2 * speed)), 1)
    assert (verdict.rung, verdict.misconception) == ("unit", None)
    assert "time is right up to a constant" in verdict.message("en")
