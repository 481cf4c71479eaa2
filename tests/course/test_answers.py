"""Asking an answer: whatever it does on the way, plain data comes back, and the asker lives on."""

import contextlib
import functools
import signal
import sys
import threading
import types
import warnings

import numpy as np
import pytest
import sympy as sp
from hostile import IMPOSTORS, TRAPS, loop

from course.answers import MAX_PRINTED, MAX_WARNINGS, Interview, Missing, Question, Reply, find, interview, reply_to
from course.plain import Odd

TWO = Question((np.array([1.0, 2.0]), 3.0))
SOON = 0.1


def asked(answer, *args, symbols=False):
    return reply_to(answer, Question(args, symbols))


def test_a_call_gives_plain_data():
    reply = asked(lambda pose, distance: pose + distance, np.array([1.0, 2.0]), 3)
    assert reply.value.tolist() == [4.0, 5.0]
    assert reply.inputs[0].tolist() == [1.0, 2.0]
    assert reply.inputs[1] == 3
    assert (reply.trouble, reply.printed, reply.warned) == (None, "", ())


CALLABLES = {
    "partial": functools.partial(lambda k, a, b: a * b * k, 1.0),
    "object": type("Call", (), {"__call__": lambda self, a, b: a * b})(),
    "bound method": types.MethodType(lambda self, a, b: a * b, object()),
    "ufunc": np.multiply,
    "any arguments": lambda *args: args[0] * args[1],
    "further parameters": lambda a, b, c=0, *, d=1: a * b,
    "wrapped": functools.wraps(np.mean)(lambda a, b: a * b),
    "cached": functools.cache(lambda *_: [3.0, 6.0]),
}


@pytest.mark.parametrize("answer", [CALLABLES[label] for label in CALLABLES if label != "cached"])
def test_whatever_can_be_called_is_asked(answer):
    [reply] = interview(answer, [TWO]).replies
    assert reply.value.tolist() == [3.0, 6.0]


def test_an_answer_that_needs_hashable_inputs_fails_by_itself():
    [reply] = interview(CALLABLES["cached"], [TWO]).replies
    assert reply.trouble.builtin == "TypeError"


MISMATCHES = [
    (lambda: 0, "()"),
    (lambda pose: 0, "(pose)"),
    (lambda pose, distance, dtheta: 0, "(pose, distance, dtheta)"),
    (lambda pose, *, distance: 0, "(pose, *, distance)"),
]


@pytest.mark.parametrize(("answer", "signature"), MISMATCHES)
def test_other_parameters_are_noticed_without_a_call(answer, signature):
    assert interview(answer, [TWO]) == Interview(mismatch=(2, signature))


NO_FUNCTIONS = [(None, "NoneType"), (3.0, "float"), (np.zeros(3), "ndarray"), ("f", "str"), ([1], "list"), (np, "module")]


@pytest.mark.parametrize(("answer", "kind"), NO_FUNCTIONS)
def test_what_is_no_function_is_not_called(answer, kind):
    assert interview(answer, [TWO]) == Interview(kind=kind)


def derived(base):
    return type("Own", (base,), {})


RAISED = [
    (ValueError("no"), "ValueError", "ValueError"),
    (derived(KeyError)("k"), "Own", "KeyError"),
    (type("ValueError", (Exception,), {})("no"), "ValueError", "Exception"),
    (np.linalg.LinAlgError("singular"), "LinAlgError", "ValueError"),
    (KeyboardInterrupt(), "KeyboardInterrupt", "KeyboardInterrupt"),
    (SystemExit(0), "SystemExit", "SystemExit"),
    (GeneratorExit(), "GeneratorExit", "GeneratorExit"),
    (BaseException("b"), "BaseException", "BaseException"),
    (derived(BaseException)("b"), "Own", "BaseException"),
    (BaseExceptionGroup("g", [KeyboardInterrupt()]), "BaseExceptionGroup", "BaseExceptionGroup"),
]


@pytest.mark.parametrize(("error", "name", "builtin"), RAISED, ids=str)
def test_whatever_is_raised_is_trouble_of_the_answer(error, name, builtin):
    def answer():
        raise error

    trouble = asked(answer).trouble
    assert (trouble.type, trouble.builtin) == (name, builtin)
    assert trouble.line == "raise error"
    assert trouble.function == "answer"


def breaks_in(method, error=SystemExit):
    def broken(*_):
        raise error

    return type("Broken", (Exception,), {method: broken})


@pytest.mark.parametrize("error", [breaks_in("__str__"), breaks_in("__str__", ValueError), breaks_in("__getattribute__")])
def test_an_error_that_cannot_be_read_is_still_trouble(error):
    def answer():
        raise error

    assert asked(answer).trouble is not None


def test_an_error_lies_about_its_text_in_vain():
    sly = type("Sly", (str,), {"__getitem__": lambda *_: 7})

    def answer():
        raise type("E", (Exception,), {"__str__": lambda self: sly("abc"), "__module__": "builtins"})

    trouble = asked(answer).trouble
    assert (type(trouble.message), trouble.message, trouble.builtin) == (str, "abc", "Exception")


def test_recursion_without_end_is_trouble():
    def answer():
        return answer()

    trouble = asked(answer).trouble
    assert (trouble.builtin, trouble.line) == ("RecursionError", "return answer()")


def test_an_answer_that_exits_is_asked_on():
    def answer(value):
        if value == 1:
            sys.exit(0)
        return value

    replies = interview(answer, [Question((value,)) for value in (0, 1, 2)]).replies
    assert [reply.value for reply in replies] == [0, None, 2]
    assert replies[1].trouble.type == "SystemExit"


def test_an_interrupted_answer_is_not_asked_on():
    def answer(value):
        if value == 1:
            raise KeyboardInterrupt
        return value

    replies = interview(answer, [Question((value,)) for value in (0, 1, 2)]).replies
    assert [reply.value for reply in replies] == [0, None]
    assert replies[1].trouble.type == "KeyboardInterrupt"


def sleeps_through_one_alarm():
    try:
        loop()
    except:  # noqa: E722 - students write this
        loop()


def endless_attempts():
    while True:
        with contextlib.suppress(Exception):
            loop()


def endless_recursion():
    while True:
        with contextlib.suppress(RecursionError):
            endless_recursion()


ENDLESS = {
    "loop": loop,
    "loop that goes on after exceptions": endless_attempts,
    "recursion that is caught": endless_recursion,
    "endless generator": lambda: sum(1 for _ in iter(int, 1)),
}


@pytest.mark.parametrize("answer", ENDLESS.values(), ids=ENDLESS)
def test_an_endless_answer_is_stopped_and_not_asked_on(answer):
    replies = interview(answer, [Question(())] * 3, time_limit=SOON).replies
    assert [reply.trouble.type for reply in replies] == ["TimeUp"]


def test_an_answer_that_swallows_the_alarm_is_stopped_by_the_next():
    [reply] = interview(sleeps_through_one_alarm, [Question(())], time_limit=SOON).replies
    assert reply.trouble.type == "TimeUp"


def test_an_earlier_alarm_still_rings():
    rung = []
    before = signal.signal(signal.SIGALRM, lambda *_: rung.append(1))
    timer = signal.setitimer(signal.ITIMER_REAL, 1000.0, 7.0)
    try:
        interview(lambda: 0, [Question(())])
        remaining, interval = signal.getitimer(signal.ITIMER_REAL)
        assert 900 < remaining <= 1000
        assert interval == pytest.approx(7.0, abs=0.1)
        signal.raise_signal(signal.SIGALRM)
        assert rung == [1]
    finally:
        signal.setitimer(signal.ITIMER_REAL, *timer)
        signal.signal(signal.SIGALRM, before)


def test_no_alarm_is_left_behind():
    before = signal.getsignal(signal.SIGALRM)
    timer = signal.setitimer(signal.ITIMER_REAL, 0)
    try:
        interview(loop, [Question(())], time_limit=SOON)
        assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
        assert signal.getsignal(signal.SIGALRM) is before
    finally:
        signal.setitimer(signal.ITIMER_REAL, *timer)


def test_asking_works_beside_the_main_thread():
    talks = []
    thread = threading.Thread(target=lambda: talks.append(interview(lambda: 1.0, [Question(())])))
    thread.start()
    thread.join()
    assert talks[0].replies[0].value == 1.0


RIGHT = np.array([1.25, -2.5, 3.0])


@pytest.mark.parametrize("make", [*IMPOSTORS.values(), *TRAPS.values()], ids=[*IMPOSTORS, *TRAPS])
def test_whatever_comes_back_or_stands_for_the_answer_is_survived(make):
    [reply] = interview(lambda: make(RIGHT), [Question(())], time_limit=SOON).replies
    assert type(reply) is Reply
    talk = interview(make(RIGHT), [Question(())], time_limit=SOON)
    assert type(talk.kind) is str
    [symbolic] = interview(lambda _: make(RIGHT), [Question((1.0,), symbols=True)], time_limit=SOON).replies
    assert symbolic.trouble is None or type(symbolic.trouble.message) is str


SPOILS = {
    "array in place": (np.array([1.0, 2.0]), lambda a: a.__iadd__(1)),
    "array entry": (np.array([1.0, 2.0]), lambda a: a.__setitem__(0, 9)),
    "array shape": (np.array([1.0, 2.0]), lambda a: setattr(a, "shape", (2, 1))),
    "array of counts": (np.array([1, 2]), lambda a: a.__imul__(2)),
    "list entry": ([1.0, 2.0], lambda a: a.__setitem__(0, 9)),
    "list grown": ([1.0, 2.0], lambda a: a.append(3.0)),
    "list sorted": ([2.0, 1.0], list.sort),
    "list in a list": ([[1.0], [2.0]], lambda a: a[0].clear()),
    "list in itself": ([1.0], lambda a: a.append(a)),
    "list in itself many times": ([1.0], lambda a: a.extend([a] * 1000)),
    "dict entry": ({"t": [1.0]}, lambda a: a.update(t=[2.0])),
    "dict grown": ({"t": [1.0]}, lambda a: a.update(u=1.0)),
    "dict emptied": ({"t": [1.0]}, dict.clear),
    "array in a dict": ({"t": np.array([1.0, 2.0])}, lambda a: a["t"].sort() or a["t"].__imul__(2)),
    "hostile key": ({"t": 1.0}, lambda a: a.__setitem__(7, 1)),
}


@pytest.mark.parametrize(("given", "spoil"), SPOILS.values(), ids=SPOILS)
def test_a_changed_input_shows_and_leaves_the_question_alone(given, spoil):
    question = Question((given,))
    as_it_was = repr(given)
    reply = reply_to(lambda a: (spoil(a), 1.0)[1], question)
    assert reply.value == 1.0
    assert repr(given) == as_it_was
    assert repr(reply.inputs[0]) != as_it_was
    assert repr(reply_to(lambda a: 1.0, question).inputs[0]) == as_it_was


def test_no_answer_reaches_the_next_question():
    question = Question(({"t": [np.array([1.0])]},))
    seen = []
    interview(lambda log: seen.append(log["t"][0].copy()) or log["t"][0].fill(7), [question, question])
    assert seen[0] == seen[1]


def test_what_is_printed_is_kept_from_the_screen_and_cut(capsys):
    def answer():
        print("a" * 1500)
        print("b" * 1500, file=sys.stderr)
        return sys.stdout.write("c" * 10)

    reply = asked(answer)
    assert capsys.readouterr() == ("", "")
    assert reply.value == 10
    assert reply.printed == ("a" * 1500 + "\n" + "b" * 1500)[:MAX_PRINTED]


def test_printing_a_sly_text_gives_plain_text():
    sly = type("Sly", (str,), {"__getitem__": lambda *_: 7, "__len__": lambda _: 1, "__radd__": lambda *_: 8})
    reply = asked(lambda: sys.stdout.write(sly("abc")))
    assert (reply.trouble, reply.printed, reply.value) == (None, "abc", 3)
    reply = asked(lambda: setattr(sys.stdout, "text", 7))
    assert type(reply.printed) is str


def test_warnings_are_kept_sorted_and_few():
    def answer():
        for number in range(20):
            warnings.warn(f"w{number:02} " + "x" * 1000, stacklevel=1)
        return np.float64(1) / 0

    reply = asked(answer)
    assert len(reply.warned) == MAX_WARNINGS
    assert reply.warned[0].startswith("RuntimeWarning: divide by zero")
    assert reply.warned[1].startswith("UserWarning: w00")
    assert all(len(text) <= 500 for text in reply.warned)


@pytest.mark.parametrize("error", [ValueError, SystemExit])
def test_a_warning_that_can_be_read_only_once_is_survived(error):
    class Broken(UserWarning):
        texts = iter(["a"])

        def __str__(self):
            for text in self.texts:
                return text
            raise error

    reply = asked(lambda: warnings.warn(Broken(), stacklevel=1))
    assert reply.trouble is None
    assert reply.warned == ("Broken: ",)


@pytest.fixture
def strict_notebook():
    """A notebook that made every warning and every floating-point event an error, or silenced them."""
    before = np.seterr(all="raise")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield
    np.seterr(**before)


def divides(value):
    warnings.warn("careful", stacklevel=1)
    return np.array([1.0]) / value * 1e-320


def test_a_strict_notebook_is_asked_like_any_other(strict_notebook):
    reply = asked(divides, np.array([0.0]))
    assert reply.trouble is None
    assert reply.warned == ("RuntimeWarning: divide by zero encountered in divide", "UserWarning: careful")
    assert asked(lambda: np.longdouble("1e400") * np.ones(2)).value.tolist() == [np.inf, np.inf]
    assert np.geterr()["divide"] == "raise"
    assert warnings.filters[0][0] == "error"


def test_a_silent_notebook_is_asked_like_any_other():
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        assert len(asked(divides, np.array([0.0])).warned) == 2


def test_an_answer_cannot_change_how_others_are_asked():
    def answer():
        np.seterr(all="raise")
        warnings.simplefilter("error")
        sys.stdout = None

    before = np.geterr(), warnings.filters[:], sys.stdout
    asked(answer)
    assert (np.geterr(), warnings.filters[:], sys.stdout) == before


SYMBOLIC = [
    (lambda a, b: (a + sp.cos(b), a * b), [1 + np.cos(2.0), 2.0]),
    (lambda a, b: sp.Matrix([a + sp.cos(b), a * b]), [1 + np.cos(2.0), 2.0]),
    (lambda a, b: np.array([a + sp.cos(b), a * b]), [1 + np.cos(2.0), 2.0]),
    (lambda a, b: [sp.Integer(3), 4.0], [3.0, 4.0]),
    (lambda a, b: a**2 + b, 3.0),
]


@pytest.mark.parametrize(("answer", "expected"), SYMBOLIC)
def test_symbols_are_asked_and_numbers_put_in_afterwards(answer, expected):
    reply = asked(answer, 1.0, 2.0, symbols=True)
    assert np.allclose(reply.value, expected)
    assert reply.inputs == (1.0, 2.0)


SYMBOLS_FAIL = [
    (lambda a, b: np.cos(a), "TypeError", None),
    (lambda a, b: sp.Symbol("z"), None, Odd("symbols", "z")),
    (sp.Eq, None, None),
    (lambda a, b: sys.exit(), "SystemExit", None),
]


@pytest.mark.parametrize(("answer", "error", "value"), SYMBOLS_FAIL)
def test_answers_that_cannot_do_symbols(answer, error, value):
    reply = asked(answer, 1.0, 2.0, symbols=True)
    assert (reply.trouble and reply.trouble.builtin) == error
    assert value is None or reply.value == value


def step():
    """A function that is there."""


TYPED = "def pose_step(pose):\n    return pose\n"
INSIDE = "def outer():\n    def pose_step(pose):\n        return pose\n"
METHOD = "class Robot:\n    def pose_step(self):\n        return 0\n"
BROKEN = "x = 1\ndef pose_step(pose)\n    return pose\n"

FOUND = [
    ("nothing there", {}, [], Missing("undefined")),
    ("misspelt", {"pose_steps": step}, [], Missing("similar", "pose_steps")),
    ("capitals", {"Pose_step": step}, [], Missing("similar", "Pose_step")),
    ("another name", {"position": step}, [], Missing("undefined")),
    ("similar, but no function", {"pose_steps": 3.0}, [], Missing("undefined")),
    ("similar, but private", {"_pose_step": step}, [], Missing("undefined")),
    ("names that are no text", {7: step, None: 1}, [], Missing("undefined")),
    ("in a function", {"outer": step}, [INSIDE], Missing("nested", "outer")),
    ("in a class", {"Robot": step}, [METHOD], Missing("nested", "Robot")),
    ("not run yet", {}, ["x = pose_step(1)"], Missing("undefined")),
    ("in a comment", {}, ["# def pose_step later"], Missing("undefined")),
    ("cell of null bytes", {}, ["pose_step\0"], Missing("undefined")),
    ("cell nested too deeply", {}, ["pose_step" + "(" * 5000], Missing("undefined")),
]


@pytest.mark.parametrize(("space", "cells", "missing"), [row[1:] for row in FOUND], ids=[row[0] for row in FOUND])
def test_why_an_answer_is_missing(space, cells, missing):
    assert find("pose_step", space, cells) == (None, missing)


def test_a_syntax_error_is_quoted():
    answer, missing = find("pose_step", {}, ["y = 2", BROKEN, "z = 3"])
    assert answer is None
    assert missing.reason == "syntax"
    assert (missing.trouble.builtin, missing.trouble.line, missing.trouble.line_number) == (
        "SyntaxError",
        "def pose_step(pose)",
        2,
    )


def test_the_newest_cell_counts():
    assert find("pose_step", {}, [BROKEN, INSIDE])[1].reason == "nested"
    assert find("pose_step", {}, [INSIDE, BROKEN])[1].reason == "syntax"


def test_what_is_defined_is_found_whatever_the_cells_say():
    assert find("pose_step", {"pose_step": step}, [BROKEN]) == (step, None)
    assert find("pose_step", {"pose_step": None}, []) == (None, None)
    assert find("pose_step", {"pose_steps": TRAPS["raises when seen"](RIGHT)}, [TYPED])[1].reason == "undefined"


def test_a_misspelt_graph_is_found():
    plt = pytest.importorskip("matplotlib.pyplot")
    axes = plt.figure().add_subplot()
    assert find("xy_axes", {"xy_axis": axes})[1] == Missing("similar", "xy_axis")
    plt.close("all")
