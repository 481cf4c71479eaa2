import numpy as np
import pytest

from course.answers import Missing, Question
from course.plain import Odd


def test_an_answer_is_asked_with_what_it_is_given(session):
    session.run("def area(width, height):\n    return width * height")
    talk = session.ask("area", [Question((2.0, 3.0)), Question((1.5, 4.0))])
    assert [reply.value for reply in talk.replies] == [6.0, 6.0]


MISSING = [
    ("nowhere", "", "undefined", ""),
    ("inner", "def outer():\n    def inner(): pass", "nested", "outer"),
    ("innermost", "%matplotlib inline\ndef surface():\n    def innermost(): pass", "nested", "surface"),
    ("broken", "def broken(:\n    pass", "syntax", ""),
    ("wheel_radius", "def wheel_radios(): pass", "similar", "wheel_radios"),
]


@pytest.mark.parametrize(("name", "source", "reason", "where"), MISSING)
def test_why_an_answer_is_missing(session, name, source, reason, where):
    session.run(source)
    missing = session.ask(name, [Question(())]).missing
    assert (missing.reason, missing.where) == (reason, where)


def test_a_notebook_may_use_ipythons_own_names(session):
    session.run("In = 5; Out = 6; get_ipython = 7; display = 8; exit = 9")
    assert session.ask("missing_two", [Question(())]).missing == Missing("undefined")


def test_an_answer_that_never_ends_is_interrupted_and_the_others_are_asked(session):
    session.run("def endless():\n    while True: pass\ndef right(): return 1")
    [reply] = session.ask("endless", [Question(()), Question(())]).replies
    assert reply.trouble.type == "TimeUp"
    assert session.ask("right", [Question(())]).replies[0].value == 1


@pytest.mark.parametrize("leave", ["import sys; sys.exit(0)", "raise SystemExit", "raise KeyboardInterrupt", "quit()"])
def test_leaving_politely_is_a_trouble_like_any_other(session, leave):
    session.run(f"def leaver():\n    {leave}\n    return 1")
    [reply] = session.ask("leaver", [Question(())]).replies
    assert reply.trouble is not None or reply.value == 1


def test_a_value_that_is_no_function(session):
    session.run("number = 5")
    assert session.ask("number", [Question(())]).kind == "int"


def test_an_axes_comes_as_a_summary(session):
    session.run("import matplotlib.pyplot as plt\nfig, graph = plt.subplots()\ngraph.plot([0, 1], [2, 3], label='path');")
    figure = session.ask("graph", []).figure
    assert figure["lines"][0]["xy"].tolist() == [[0, 2], [1, 3]]
    assert figure["lines"][0]["label"] == "path"


TOO_MUCH = {"arrays": "np.zeros(4_000_000)", "texts": "['x' * 10_000] * 2_000"}


@pytest.mark.parametrize("value", TOO_MUCH.values(), ids=TOO_MUCH.keys())
def test_an_answer_that_returns_more_than_a_message_holds_is_wrong_and_the_others_are_asked(session, value):
    session.run(f"import numpy as np\ndef huge(row): return {value}\ndef right(): return 1")
    talk = session.ask("huge", [Question((np.arange(3.0),))] * 3)
    assert [reply.value for reply in talk.replies] == [Odd("too_big", "value")] * 3
    # what it was given stands as it was, so that the fault is found in the value
    assert [reply.inputs[0].tolist() for reply in talk.replies] == [[0.0, 1.0, 2.0]] * 3
    assert session.ask("right", [Question(())]).replies[0].value == 1
