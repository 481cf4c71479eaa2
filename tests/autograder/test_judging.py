"""The judge: every honest answer is right, no impostor ever is, and each wrong one is told one thing."""

import builtins
import contextlib
import functools
import math
import sys
import types
import warnings
from collections import namedtuple
from functools import partial

import matplotlib as mpl
import numpy as np
import pytest
import sympy as sp
from hostile import IMPOSTORS, TRAPS, always, loop
from hypothesis import given
from hypothesis import strategies as st

from autograder import judge
from autograder.exercise import Exercise, GraphExercise, GraphFault, Group, Mistake, trial
from autograder.judging import judged, judged_by_name, verdict
from autograder.reference import NOTEBOOKS, exercise_named
from course.answers import Interview, Missing, Question, Reply, Trouble, interview
from course.language import Text
from course.plain import Odd
from course.tolerances import LAST_AXIS
from course.verdict import RUNGS

mpl.use("Agg")
import matplotlib.pyplot as plt

SEEDS = range(5)
POSE_STEP = exercise_named("pose_step")
Pose = namedtuple("Pose", "x y theta")


def true_pose(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * math.cos(theta), y + distance * math.sin(theta), theta + dtheta])


def judged_soon(exercise, answer, seed=0):
    return judged(exercise, partial(interview, answer, time_limit=0.1), seed)


def judged_fully(exercise, answer, seed=0):
    return judged(exercise, partial(interview, answer), seed)


# --- right answers in odd dress -----------------------------------------------------------------------------------------


class Robot:
    gain = 1.0

    def __call__(self, pose, distance, dtheta):
        return self.gain * true_pose(pose, distance, dtheta)

    @staticmethod
    def standing(pose, distance, dtheta):
        return true_pose(pose, distance, dtheta)

    def bound(self, pose, distance, dtheta):
        return self(pose, distance, dtheta)


def in_place_on_a_copy(pose, distance, dtheta):
    moved = np.array(pose, dtype=float)
    moved[:2] += distance * np.array([np.cos(moved[2]), np.sin(moved[2])])
    moved[2] += dtheta
    return moved


def homogeneous(pose, distance, dtheta):
    c, s = np.cos(pose[2]), np.sin(pose[2])
    here = np.array([[c, -s, pose[0]], [s, c, pose[1]], [0, 0, 1]])
    x, y, _ = here @ [distance, 0, 1]
    return np.hstack([x, y, pose[2] + dtheta])


def complex_plane(pose, distance, dtheta):
    z = complex(pose[0], pose[1]) + distance * np.exp(1j * pose[2])
    return z.real, z.imag, pose[2] + dtheta


def of_two_steps(pose, distance, dtheta):
    half = true_pose(pose, distance / 2, 0)
    return true_pose(half, distance / 2, dtheta)


def recursive(pose, distance, dtheta, pieces=8):
    if pieces == 1:
        return true_pose(pose, distance, dtheta)
    return recursive(true_pose(pose, distance / pieces, 0), distance * (pieces - 1) / pieces, dtheta, pieces - 1)


def with_japanese_names(姿勢, 距離, 回転):  # noqa: PLC2401 - as students may
    x, y, 方位 = 姿勢  # noqa: PLC2401
    return [x + 距離 * np.cos(方位), y + 距離 * np.sin(方位), 方位 + 回転]


def noisy(pose, distance, dtheta):
    print("pose:", pose, file=sys.stderr)
    warnings.warn("look \u202e out", stacklevel=1)
    return true_pose(pose, distance, dtheta) + 0 * np.log(np.zeros(3) + 1)


def strict(pose, distance, dtheta):
    with np.errstate(all="raise"), warnings.catch_warnings():
        warnings.simplefilter("error")
        return true_pose(pose, distance, dtheta)


def by_exceptions(pose, distance, dtheta):
    try:
        raise StopIteration(true_pose(pose, distance, dtheta))
    except StopIteration as found:
        return found.value


HONEST = {
    "tuple": lambda *args: tuple(true_pose(*args).tolist()),
    "list of NumPy scalars": lambda *args: list(true_pose(*args)),
    "namedtuple": lambda *args: Pose(*true_pose(*args)),
    "list of a class of its own": lambda *args: type("Row", (list,), {})(true_pose(*args)),
    "float32": lambda *args: true_pose(*args).astype(np.float32),
    "long double": lambda *args: true_pose(*args).astype(np.longdouble),
    "big-endian": lambda *args: true_pose(*args).astype(">f8"),
    "0-d arrays": lambda *args: tuple(map(np.array, true_pose(*args))),
    "column of a matrix": lambda *args: np.column_stack([true_pose(*args)] * 2)[:, 1],
    "backwards twice": lambda *args: true_pose(*args)[::-1].copy()[::-1],
    "read-only": lambda *args: np.broadcast_to(true_pose(*args), (3,)),
    "SymPy matrix": lambda *args: sp.Matrix(true_pose(*args)),
    "SymPy numbers": lambda *args: [sp.Float(float(value)) for value in true_pose(*args)],
    "object": Robot(),
    "bound method": Robot().bound,
    "static method": Robot.standing,
    "partial": partial(lambda unit, *args: unit * true_pose(*args), 1.0),
    "wrapped": functools.wraps(math.hypot)(Robot()),
    "further parameters": lambda pose, distance, dtheta, unit=1.0, *, verbose=False: unit * true_pose(pose, distance, dtheta),
    "in place on a copy": in_place_on_a_copy,
    "homogeneous matrix": homogeneous,
    "complex plane": complex_plane,
    "two half steps": of_two_steps,
    "recursive": recursive,
    "Japanese names": with_japanese_names,
    "noisy": noisy,
    "strict": strict,
    "by exceptions": by_exceptions,
    "a hair off": lambda *args: true_pose(*args) * (1 + 5e-7),
}


@pytest.mark.parametrize("answer", HONEST.values(), ids=HONEST)
def test_honest_answers_are_right_however_odd(answer):
    for seed in SEEDS:
        found = judge("pose_step", answer, seed)
        assert (found.score, found.rung, found.misconception) == (1.0, None, None), found.message("en")
        assert found.passed
        assert found.state == "passed"


def test_printing_and_warning_are_mentioned_and_cost_nothing():
    message = judge("pose_step", noisy, 0).message("en")
    assert "It also prints something; that costs nothing" in message
    assert "It warned on the way (UserWarning: look <U+202E> out); that costs nothing" in message
    assert "減点はありません" in judge("pose_step", noisy, 0).message("ja")
    assert "prints" not in judge("pose_step", true_pose, 0).message("en")


# --- hostile and unlucky ones --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("make", IMPOSTORS.values(), ids=IMPOSTORS)
def test_impostors_never_score(make):
    found = judged_soon(POSE_STEP, lambda *args: make(true_pose(*args)))
    assert found.score == 0, found.message("en")
    assert found.rung in RUNGS
    assert found.message("en")
    assert found.message("ja")


@pytest.mark.parametrize("make", TRAPS.values(), ids=TRAPS)
def test_traps_never_score_nor_break_the_judge(make):
    returned = judged_soon(POSE_STEP, lambda *args: make(true_pose(*args)))
    bound = judged_soon(POSE_STEP, make(np.zeros(3)))
    for found in (returned, bound):
        assert found.score == 0
        assert found.rung in RUNGS


@pytest.mark.parametrize("answer", [*IMPOSTORS.values()], ids=IMPOSTORS)
def test_impostors_in_the_place_of_the_function_never_score(answer):
    found = judged_soon(POSE_STEP, answer(np.array([1.0, 2.0, 3.0])))
    assert found.score == 0
    assert found.rung in {"callable", "runs", "shape"}


def raising(error):
    def answer(pose, distance, dtheta):
        raise error

    return answer


def right_once():
    calls = iter(range(10**9))
    return lambda *args: true_pose(*args) if next(calls) == 0 else np.zeros(3)


def spoils(pose, distance, dtheta):
    moved = true_pose(pose, distance, dtheta)
    pose[:] = moved
    return moved


def spoils_badly(pose, distance, dtheta):
    moved = true_pose(pose, distance, dtheta)
    if isinstance(pose, list):
        pose.append(pose)
    else:
        pose.resize(4, refcheck=False)
    return moved


def recurses(pose, distance, dtheta):
    return recurses(pose, distance, dtheta)


def grows(pose, distance, dtheta):
    return bytearray(2**62)


def prints_only(pose, distance, dtheta):
    print(true_pose(pose, distance, dtheta))


def yields(pose, distance, dtheta):
    yield from true_pose(pose, distance, dtheta)


def reads_the_judge(pose, distance, dtheta):
    """Looks in the calling frames for somebody's idea of a right answer."""
    frame = sys._getframe()
    while frame is not None:
        for value in frame.f_locals.values():
            if isinstance(value, list) and len(value) == len(POSE_STEP.parameters) and isinstance(value[0], np.ndarray):
                return value[0]
        frame = frame.f_back
    return np.zeros(3)


#: (answer, rung, words in English, words in Japanese); none of them scores
WRONG = {
    "raises": (raising(ValueError("a {brace} <b>")), "runs", "a {brace} <b>", "a {brace} <b>"),
    "raises what is no Exception": (raising(type("Stop", (BaseException,), {})()), "runs", "Stop", "Stop"),
    "raises a group": (
        raising(BaseExceptionGroup("g", [KeyboardInterrupt()])),
        "runs",
        "BaseExceptionGroup",
        "BaseExceptionGroup",
    ),
    "exits": (raising(SystemExit(0)), "runs", "exit", "exit"),
    "interrupted": (raising(KeyboardInterrupt()), "runs", "stopped by hand", "手動で止められました"),
    "does not end": (loop, "runs", "did not finish in time", "時間内に終わらなかった"),
    "recurses": (recurses, "runs", "calls itself", "自分自身"),
    "takes too much memory": (grows, "runs", "memory", "メモリ"),
    "prints instead": (prints_only, "shape", "print", "print"),
    "yields instead": (yields, "shape", "generator", "ジェネレータ"),
    "not written": (raising(NotImplementedError()), "runs", "not written yet", "まだ書かれていません"),
    "changes its input": (spoils, "inputs", "changes its input (pose)", "引数(pose)を書き換え"),
    "spoils its input": (spoils_badly, "inputs", "changes its input (pose)", "引数(pose)を書き換え"),
    "too few parameters": (lambda pose, distance: 0, "callable", "pose, distance, dtheta", "pose, distance, dtheta"),
    "keyword-only parameters": (lambda pose, *, distance, dtheta: 0, "callable", "distance", "distance"),
    "no function": (np.zeros(3), "callable", "where a function is asked for", "関数ではなく"),
    "the result of a call": (None, "callable", "None", "None"),
    "zeros": (lambda *_: np.zeros(3), "value", "x, y, theta", "x、y、theta"),
    "reads the judge": (reads_the_judge, "value", "theta", "theta"),
    "a class": (types.SimpleNamespace, "runs", "no positional arguments", "no positional arguments"),
}


@pytest.mark.parametrize(("answer", "rung", "english", "japanese"), WRONG.values(), ids=WRONG)
def test_wrong_answers_are_told_why(answer, rung, english, japanese):
    found = (judged_soon if answer is loop else judged_fully)(POSE_STEP, answer)
    assert (found.score, found.rung) == (0.0, rung), found.message("en")
    assert english in found.message("en")
    assert japanese in found.message("ja")
    assert "Traceback" not in found.message("en")


def test_right_the_first_time_only_is_not_right():
    found = judge("pose_step", right_once(), 0)
    assert found.score == 0
    found = judge("pose_step", lambda *args: true_pose(*args) if args[1] > 0 else np.zeros(3), 0)
    assert 0 < found.score < 1


def test_what_came_before_an_interruption_counts():
    def answer(pose, distance, dtheta):
        if distance < 0:
            raise KeyboardInterrupt
        return true_pose(pose, distance, dtheta)

    found = judge("pose_step", answer, 0)
    assert found.rung == "runs"
    assert found.score == pytest.approx(3 / 9, abs=1e-4)


def hidden_numbers(seed):
    for question in trial(POSE_STEP, seed).questions:
        for value in (*question.args, true_pose(*question.args)):
            for number in np.ravel(value):
                shown = f"{abs(number):.4g}"
                # short ones stand in messages by chance, as the number of a line
                if len(shown) > 4:
                    yield shown


QUIET = [row[0] for label, row in WRONG.items() if label != "prints instead"]


@pytest.mark.parametrize(
    "answer",
    [*QUIET, *(mistake.wrong for mistake in POSE_STEP.mistakes), lambda *args: 1.7 * true_pose(*args)],
    ids=lambda answer: getattr(answer, "__name__", "object"),
)
def test_no_message_shows_a_hidden_number(answer):
    told = "".join(judged_soon(POSE_STEP, answer, 5).text)
    assert not [number for number in hidden_numbers(5) if number in told]


def test_the_message_is_no_template():
    found = judge("pose_step", raising(ValueError("{name} {0} {x!r} %s")), 0)
    assert "{name} {0} {x!r} %s" in found.message("en")
    assert "{name} {0} {x!r} %s" in found.message("ja")


# --- seeds and names -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("answer", [true_pose, lambda *args: 1.7 * true_pose(*args), POSE_STEP.mistakes[0].wrong])
def test_the_same_seed_gives_the_same_verdict(answer):
    assert judge("pose_step", answer, 3) == judge("pose_step", answer, 3)
    assert judge("pose_step", answer, 3).seed == 3


def test_without_a_seed_other_inputs_are_drawn_each_time():
    asked = []
    verdicts = [judge("pose_step", lambda *args: asked.append(args[1:]) or true_pose(*args)) for _ in range(3)]
    assert len(asked) == 3 * len(trial(POSE_STEP, 0).questions)
    fractions = [args for args in asked if args[0] != round(args[0])]
    assert len(set(fractions)) == len(fractions) > 30
    assert len({found.seed for found in verdicts}) == 3


def test_the_drawing_does_not_follow_the_notebooks_generator():
    asked = []
    for _ in range(2):
        np.random.seed(0)
        judge("pose_step", lambda *args: asked.append(args[1]) or true_pose(*args))
    assert len(set(asked[: len(asked) // 2])) > 5
    assert asked[: len(asked) // 2] != asked[len(asked) // 2 :]


def test_judging_leaves_the_notebooks_generator_alone():
    np.random.seed(0)
    expected = np.random.random()
    np.random.seed(0)
    judge("pose_step", true_pose)
    assert np.random.random() == expected


@pytest.mark.parametrize("name", ["pose_stepp", "", "__init__", "pose_step.reference", "../pose_step", "pose_update"])
def test_an_unknown_name_is_answered_with_the_known_ones(name):
    with pytest.raises(KeyError, match="no exercise is called") as caught:
        judge(name, true_pose)
    for names in NOTEBOOKS.values():
        assert all(known in str(caught.value) for known in names)


def test_a_missing_answer_is_told():
    found = judged_by_name("pose_step", lambda _: Interview(missing=Missing("undefined")), 0)
    assert (found.rung, found.score) == ("defined", 0.0)
    assert "not defined yet" in found.message("en")


# --- a notebook that changed Python or NumPy -------------------------------------------------------------------------------


def lies(name, *results):
    """Patches of a function that would make wrong look right."""
    return [(name, always(result)) for result in results]


NUMPY = [
    *lies("allclose", True),
    *lies("all", True, np.True_),
    *lies("any", False),
    *lies("isfinite", True, np.array(True)),
    *lies("abs", 0.0, np.zeros((3, 1))),
    *lies("absolute", 0.0),
    *lies("array_equal", True),
    *lies("minimum", 0.0),
    *lies("asarray", np.zeros(3)),
    *lies("moveaxis", np.zeros((3, 1))),
    *lies("where", np.zeros(3)),
    *lies("flatnonzero", np.zeros(0)),
    *lies("zeros", np.zeros(6, dtype=bool)),
    *lies("array", np.zeros(3)),
    *lies("isclose", np.ones(3, dtype=bool)),
]
PYTHON = [
    *lies("any", False),
    *lies("all", True),
    *lies("abs", 0.0),
    *lies("round", 1.0),
    *lies("max", 1.0),
    *lies("sum", 0.0),
    *lies("sorted", []),
    *lies("bool", False),
    *lies("zip", ()),
    *lies("len", 0),
]
PATCHES = [*((np, *patch) for patch in NUMPY), *((builtins, *patch) for patch in PYTHON)]
PATCHES += [(math, "cos", always(0.0)), (math, "sin", always(0.0)), (np.random, "default_rng", always(np.random.default_rng(0)))]


@contextlib.contextmanager
def patched(module, name, lie):
    original = getattr(module, name)
    setattr(module, name, lie)
    try:
        yield
    finally:
        setattr(module, name, original)


def wrong_pose(pose, distance, dtheta):
    return [pose[0] + 1.0, pose[1] - distance, pose[2] + dtheta]


@pytest.mark.parametrize(("module", "name", "lie"), PATCHES, ids=lambda value: getattr(value, "__name__", str(value)))
def test_a_patched_function_does_not_make_wrong_right(module, name, lie):
    fair = judge("pose_step", wrong_pose, 0)
    assert (fair.score, fair.passed) == (0, False)
    found = None
    # what reads the answer in this process may well break; what judges it may not be deceived
    with patched(module, name, lie), contextlib.suppress(Exception):
        found = judge("pose_step", wrong_pose, 0)
    assert found is None or (found.score, found.passed) == (0, False)


def test_an_answer_keeps_its_own_patches_and_the_judge_takes_none_over():
    def answer(pose, distance, dtheta):
        np.all = always(True)
        assert np.all([False])
        return np.zeros(3)

    original = np.all
    try:
        found = judge("pose_step", answer, 0)
        assert np.all is not original
    finally:
        np.all = original
    assert found.rung == "value"


@pytest.mark.parametrize("answer", [true_pose, wrong_pose, lambda *_: [1e-320, 1.7e308, -1.7e308]])
def test_a_strict_notebook_gets_the_same_verdict(answer):
    fair = judge("pose_step", answer, 0)
    before = np.seterr(all="raise")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            found = judge("pose_step", answer, 0)
        assert np.geterr()["under"] == "raise"
    finally:
        np.seterr(**before)
    assert found == fair


# --- an exercise made for the tests ----------------------------------------------------------------------------------------


def euler(start, turn):
    return start[0] + math.cos(start[1]), start[1] + turn


def midpoint(start, turn):
    return start[0] + math.cos(start[1] + turn / 2), start[1] + turn


def turn_ignored(start, turn):
    return start[0] + math.cos(start[1]), start[1]


def sine_used(start, turn):
    return start[0] + math.sin(start[1]), start[1] + turn


def single_number(start, turn):
    return start[0]


def division_by_zero(start, turn):
    return [math.nan, start[1] + turn]


def parts_of_two_lengths(start, turn):
    return [[start[0]], [start[1], turn]]


def unknown_key(start, turn):
    return {}["x"]


def asks_for_more(start, turn):
    return {"start": np.array(start), "turn": turn}


def drawn_cases(rng):
    def case(sign):
        return [float(rng.uniform(1, 2)), float(rng.uniform(0.3, 0.6))], sign * float(rng.uniform(0.2, 0.4))

    return [
        Group(Text("left", "左"), 3, [case(1), case(1)]),
        Group(Text("right", "右"), 1, [case(-1)]),
    ]


def exercise_with(**more):
    fields = {
        "name": "step",
        "notebook": "odometry/pose_update",
        "points": 5,
        "parameters": ("start", "turn"),
        "reference": euler,
        "cases": drawn_cases,
        "examples": (([1.0, 0.5], 0.25),),
        "mistakes": (
            Mistake(turn_ignored, Text("The turn is missing.", "回転がありません。")),
            Mistake(sine_used, Text("The sine is used.", "sin です。")),
            Mistake(single_number, Text("One number only.", "数値が 1 つだけです。")),
            Mistake(asks_for_more, Text("A dict.", "辞書です。")),
            Mistake(division_by_zero, Text("Divided by zero.", "0 で割っています。")),
            Mistake(parts_of_two_lengths, Text("Two lengths.", "長さが違います。")),
            Mistake(unknown_key, Text("No such key.", "キーがありません。")),
        ),
        "also_right": (midpoint,),
        "tolerance": LAST_AXIS,
        "quantities": ("x", "theta"),
    }
    return Exercise(**fields | more)


STEP = exercise_with()


def on(sign, right, otherwise):
    return lambda start, turn: (right if turn * sign > 0 else otherwise)(start, turn)


def both_mistakes(start, turn):
    return start[0] + math.sin(start[1]), start[1]


#: (answer, score, rung, misconception)
SCORES = {
    "reference": (euler, 1.0, None, None),
    "also right": (midpoint, 1.0, None, None),
    "right half the time": (on(1, euler, turn_ignored), 0.75, "value", "turn_ignored"),
    "right in the light group": (on(-1, euler, turn_ignored), 0.25, "value", "turn_ignored"),
    "also right, half the time": (on(1, midpoint, turn_ignored), 0.75, "value", "turn_ignored"),
    "raises to the right": (on(-1, lambda *_: 1 / 0, euler), 0.75, "runs", None),
    "one mistake": (sine_used, 0.0, "value", "sine_used"),
    "two mistakes": (both_mistakes, 0.0, "value", "turn_ignored"),
    "a mistake here, another there": (on(1, sine_used, turn_ignored), 0.0, "value", None),
    "a mistake of form": (single_number, 0.0, "shape", "single_number"),
    "a dictionary like a known one": (asks_for_more, 0.0, "shape", "asks_for_more"),
    "another dictionary": (lambda start, turn: {"start": start, "turn": 0}, 0.0, "shape", None),
    "NaN at a known place": (lambda start, turn: (np.nan, start[1] + turn), 0.0, "shape", "division_by_zero"),
    "NaN at another place": (lambda start, turn: (start[0], np.nan), 0.0, "shape", None),
    "NaN at a known place, the rest wrong": (lambda start, turn: (np.nan, start[1]), 0.0, "shape", None),
    "known parts of two lengths": (
        lambda start, turn: ([start[0]], np.array([start[1], turn])),
        0.0,
        "shape",
        "parts_of_two_lengths",
    ),
    "other parts of two lengths": (lambda start, turn: [[start[0]], [start[1], 7.0]], 0.0, "shape", None),
    "more parts of two lengths": (lambda start, turn: [[start[0]], [start[1], turn], [0.0]], 0.0, "shape", None),
    "a known error": (lambda start, turn: {1: 2}["y"], 0.0, "runs", "unknown_key"),
    "nearly a known mistake": (lambda start, turn: [start[0] + 1.001 * math.sin(start[1]), 0.0], 0.0, "value", None),
    "nothing known": (lambda start, turn: [7.0, -7.0], 0.0, "value", None),
    "right up to a factor": (lambda start, turn: [euler(start, turn)[0], 2 * euler(start, turn)[1]], 0.0, "unit", None),
    "wrong form somewhere": (on(1, euler, lambda *_: 7.0), 0.75, "shape", None),
    "lowest rung of all": (on(1, lambda *_: "a", lambda *_: 1 / 0), 0.0, "runs", None),
}


@pytest.mark.parametrize(("answer", "score", "rung", "misconception"), SCORES.values(), ids=SCORES)
def test_scores_follow_the_weights(answer, score, rung, misconception):
    for seed in SEEDS:
        found = judged_fully(STEP, answer, seed)
        assert (found.score, found.rung, found.misconception) == (score, rung, misconception), found.message("en")


def spoiling(answer):
    def spoils_start(start, turn):
        result = answer(start, turn)
        start.append(0.0)
        return result

    return spoils_start


@pytest.mark.parametrize("answer", [euler, single_number, lambda start, turn: 1 / 0], ids=["right", "wrong", "raises"])
def test_changed_inputs_are_no_sign_of_a_mistake(answer):
    found = judged_fully(STEP, spoiling(answer))
    assert (found.score, found.misconception) == (0.0, None)
    assert found.rung == ("runs" if answer not in {euler, single_number} else "inputs")


@pytest.mark.parametrize("answer", [on(1, euler, midpoint), on(1, midpoint, euler)], ids=["euler first", "midpoint first"])
def test_right_rules_are_not_mixed(answer):
    for seed in SEEDS:
        found = judged(exercise_with(mistakes=()), partial(interview, answer), seed)
        assert (found.score, found.rung) == (0.75, "value")


def test_of_two_mistakes_one_is_told():
    message = judged_fully(STEP, both_mistakes).message("en")
    assert ("The turn is missing." in message) + ("The sine is used." in message) == 1


def test_partial_credit_says_what_is_right_already():
    found = judged_fully(STEP, on(1, euler, turn_ignored))
    assert found.message("en") == "The turn is missing.\nRight already: left. Not yet: right."
    assert found.message("ja") == "回転がありません。\nできている入力: 左。まだの入力: 右。"
    assert found.state == "partly"
    assert "Right already" not in judged_fully(STEP, turn_ignored).message("en")
    assert judged_fully(STEP, euler).message("en") == "Tried with: left; right."


def offset(index):
    def answer(start, turn):
        right = list(euler(start, turn))
        right[index] += 0.37
        return right

    return answer


@pytest.mark.parametrize(("index", "wrong", "fine"), [(0, "x", "theta"), (1, "theta", "x")])
def test_wrong_quantities_are_named(index, wrong, fine):
    found = judged_fully(STEP, offset(index))
    assert found.message("en").startswith(f"{wrong} is not right; {fine} is.")
    assert found.message("ja").startswith(f"{wrong} の値が正しくありません({fine} は合っています)")


SEQUENCE = exercise_with(
    name="sums",
    reference=np.cumsum,
    parameters=("values",),
    cases=lambda rng: [Group(Text("all", "すべて"), 1, [(rng.uniform(1, 2, 6),) for _ in range(2)])],
    mistakes=(),
    also_right=(),
    quantities=(),
)


def off_at(*indices):
    def answer(values):
        sums = np.cumsum(values)
        sums[list(indices)] += 0.77
        return sums

    return answer


PLACES = [
    (off_at(0), "Only the first entry", "最初の要素だけ"),
    (off_at(5), "Only the last entry", "最後の要素だけ"),
    (off_at(2, 3, 4, 5), "The first wrong entry is number 2", "最初に違うのは 2 番目"),
    (off_at(*range(6)), "compare step by step.", "比べてみましょう。"),
]


@pytest.mark.parametrize(("answer", "english", "japanese"), PLACES)
def test_where_a_sequence_goes_wrong_is_told(answer, english, japanese):
    exercise = exercise_with(**{**vars(SEQUENCE), "tolerance": type(LAST_AXIS)()})
    found = judged(exercise, partial(interview, answer), 0)
    assert english in found.message("en")
    assert japanese in found.message("ja")


def test_warnings_are_a_fault_where_the_exercise_says_so():
    def warns(start, turn):
        warnings.warn("divide by zero", stacklevel=1)
        return euler(start, turn)

    assert judged_fully(STEP, warns).score == 1.0
    found = judged(exercise_with(warnings_are_faults=True), partial(interview, warns), 0)
    assert (found.score, found.rung) == (0.0, "runs")
    assert "warns: UserWarning: divide by zero" in found.message("en")
    silent = judged(exercise_with(warnings_are_faults=True), partial(interview, euler), 0)
    assert silent.passed


def test_a_silenced_warning_inside_the_answer_is_no_fault():
    def careful(start, turn):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            warnings.warn("silent", stacklevel=1)
        return euler(start, turn)

    assert judged(exercise_with(warnings_are_faults=True), partial(interview, careful), 0).passed


values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=3) | st.just(Odd("other", "C")),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=2), inner, max_size=2),
    max_leaves=5,
)
arrays = st.builds(np.full, st.sampled_from([(), (2,), (0,), (2, 2)]), st.floats() | st.booleans() | st.integers(-9, 9))
texts = st.text(max_size=10)
troubles = st.none() | st.builds(Trouble, texts, texts, texts, texts, st.integers(), texts)
replies = st.builds(Reply, values | arrays, troubles, st.lists(values, max_size=3).map(tuple), texts, st.lists(texts).map(tuple))


@given(st.lists(replies, max_size=6), st.integers(0, 100), st.booleans())
def test_whatever_a_sandbox_sends_gets_a_verdict(sent, seed, untouched):
    drawn = trial(STEP, seed)
    if untouched:
        sent = [
            Reply(reply.value, reply.trouble, question.args, reply.printed, reply.warned)
            for reply, question in zip(sent, drawn.questions, strict=False)
        ]
    found = verdict(STEP, drawn, Interview(replies=tuple(sent)), seed)
    assert 0 <= found.score < 1
    assert found.rung in RUNGS
    assert found.html("ja")


@given(st.builds(Interview, st.none(), texts, st.none() | st.tuples(st.integers(), texts)))
def test_whatever_stands_for_the_answer_gets_a_verdict(talk):
    found = verdict(STEP, trial(STEP, 0), talk, 0)
    assert found.score == 0
    assert found.rung in {"callable", "runs"}


def test_replies_beyond_the_questions_do_not_count():
    drawn = trial(STEP, 0)
    right = [Reply(np.array(euler(*question.args)), inputs=question.args) for question in drawn.questions]
    assert verdict(STEP, drawn, Interview(replies=tuple(right + right))).passed
    assert not verdict(STEP, drawn, Interview(replies=tuple(right[:-1]))).passed
    assert not verdict(STEP, drawn, Interview(replies=(*right[:-1], right[0]))).passed


def test_an_answer_to_other_questions_is_not_right():
    other = trial(STEP, 1).questions
    replies_to_others = tuple(Reply(np.array(euler(*question.args)), inputs=question.args) for question in other)
    assert not verdict(STEP, trial(STEP, 0), Interview(replies=replies_to_others)).passed


# --- graphs ----------------------------------------------------------------------------------------------------------------

T = np.linspace(0, 2, 9)


def graph_fault(figure, shown):
    if not figure["lines"]:
        return GraphFault("shape", "nothing_drawn", 0.0, Text("There is no line.", "線がありません。"))
    if not np.allclose(figure["lines"][0]["xy"], np.column_stack([shown["time"], shown["x"]])):
        return GraphFault("value", None, 0.2, Text("Another line.", "違う線です。"))
    if figure["labels"] != ["t [s]", "x [m]"]:
        return GraphFault("unit", "no_labels", 1.0, Text("No labels.", "ラベルがありません。"))
    return None


def nothing_drawn(shown):
    return plt.figure().add_subplot()


GRAPH = GraphExercise(
    name="x_axes",
    notebook="odometry/wheel_odometry",
    points=5,
    drawn_from=lambda: {"time": T, "x": T**2},
    fault=graph_fault,
    mistakes=(Mistake(nothing_drawn, Text("There is no line.", "線がありません。")),),
)


@pytest.fixture
def ax():
    yield plt.figure().add_subplot()
    plt.close("all")


def test_a_right_graph_passes(ax):
    ax.plot(T, T**2)
    ax.set(xlabel="t [s]", ylabel="x [m]")
    found = judged_fully(GRAPH, ax)
    assert (found.score, found.rung, found.misconception) == (1.0, None, None)
    assert "right data" in found.message("en")


GRAPHS = [
    (lambda ax: None, 0.0, "shape", "nothing_drawn"),
    (lambda ax: ax.plot(T, T), 0.2, "value", None),
    (lambda ax: ax.plot(T, T**2), 0.99, "unit", "no_labels"),
]


@pytest.mark.parametrize(("draw", "score", "rung", "slug"), GRAPHS)
def test_a_wrong_graph_never_gets_full_points(ax, draw, score, rung, slug):
    draw(ax)
    found = judged_fully(GRAPH, ax)
    assert (found.score, found.rung, found.misconception) == (score, rung, slug)


OTHER_KINDS = [
    (lambda ax: ax.figure, "Figure", "図全体"),
    (lambda ax: ax.plot(T, T), "list", "リスト"),
    (lambda ax: ax.plot(T, T)[0], "one line of the graph", "線1本"),
    (lambda ax: (ax.figure, ax), "fig, ax", "タプル"),
    (lambda ax: np.array([ax, ax]), "array", "配列"),
    (lambda ax: None, "None", "None"),
    (lambda ax: plt.plot, "x_axes", "x_axes"),
    (lambda ax: lambda: ax, "x_axes", "x_axes"),
    (lambda ax: plt, "x_axes", "x_axes"),
    (lambda ax: TRAPS["raises when seen"](T), "RaisesWhenSeen", "RaisesWhenSeen"),
]


@pytest.mark.parametrize(("bound", "english", "japanese"), OTHER_KINDS)
def test_what_is_no_axes_is_told_kindly(ax, bound, english, japanese):
    found = judged_fully(GRAPH, bound(ax))
    assert (found.score, found.rung) == (0.0, "callable")
    assert english in found.message("en")
    assert japanese in found.message("ja")
    assert "Axes" in found.message("en")


def test_a_missing_graph_is_told():
    found = judged(GRAPH, lambda _: Interview(missing=Missing("undefined")), 0)
    assert (found.score, found.rung) == (0.0, "defined")


@pytest.mark.parametrize("figure", [{}, {"lines": 5}, {"lines": [], "points": []}])
def test_a_forged_summary_is_no_graph(figure):
    found = judged(GRAPH, lambda _: Interview(kind="axes", figure=figure), 0)
    assert (found.score, found.rung) == (0.0, "callable")


def test_a_function_is_no_graph_and_a_graph_no_function(ax):
    assert judged_fully(GRAPH, true_pose).rung == "callable"
    found = judge("pose_step", ax, 0)
    assert found.rung == "callable"
    assert "Axes of a graph" in found.message("en")


def test_questions_reach_whoever_is_asked():
    asked = []

    def ask(questions):
        asked.extend(questions)
        return interview(true_pose, questions)

    assert judged_by_name("pose_step", ask, 4).passed
    assert all(isinstance(question, Question) for question in asked)
    assert repr(asked) == repr(list(trial(POSE_STEP, 4).questions))
