"""Inputs that are built where the answer is called."""

from pathlib import Path

import numpy as np
import pytest

from course.answers import Question, reply_to
from course.given import built_file, built_integrand, built_robot, handed_over, shown_built
from course.plain import Built
from course.robots import BEEGO

WAVY = built_integrand([1.0, -2.0, 0.5], [(3.0, 2.0, 0.25)])


def test_an_integrand_gives_the_like_of_what_it_gets():
    def expected(x):
        return 1 - 2 * x + 0.5 * x**2 + 3 * np.sin(2 * x + 0.25)

    with handed_over([WAVY]) as [f]:
        for x in (0.3, 2, np.float64(-1.5), np.array(0.5), np.array([0, 1, 2]), np.linspace(-1, 1, 6).reshape(2, 3)):
            assert np.shape(f(x)) == np.shape(x)
            np.testing.assert_allclose(f(x), expected(np.asarray(x, dtype=float)), rtol=1e-12)
        assert type(f(2)) is float


def test_a_constant_is_as_long_as_its_argument():
    with handed_over([built_integrand([4.0])]) as [f]:
        assert f(1) == 4.0
        assert f(np.arange(3)).tolist() == [4.0, 4.0, 4.0]


def test_a_robot_is_a_robot():
    with handed_over([built_robot(BEEGO)]) as [robot]:
        assert robot == BEEGO


def test_a_file_is_there_during_the_call_only():
    content = b"\xef\xbb\xbf# time\r\n0,1\r\n"
    with handed_over([built_file(content, "log_motor.dat")]) as [path]:
        assert isinstance(path, Path)
        assert path.name == "log_motor.dat"
        assert path.read_bytes() == content
    assert not path.exists()


def test_each_call_gets_things_of_its_own():
    def spoiling(path, values):
        path.write_text("spoiled")
        values[0] = 7.0
        return 0

    question = Question((built_file(b"1 2\n"), np.array([1.0])))
    first, second = reply_to(spoiling, question), reply_to(spoiling, question)
    assert first.trouble is second.trouble is None
    assert question.args[1][0] == 1.0
    with handed_over(question.args) as [path, _]:
        assert path.read_bytes() == b"1 2\n"


def test_what_is_unknown_is_not_built():
    with pytest.raises(ValueError, match="spaceship"), handed_over([Built("spaceship", None)]):
        pass


def test_what_is_built_is_shown_in_a_line():
    assert shown_built(WAVY) == "f(x) = 1 + -2 x + 0.5 x^2 + 3 sin(2 x + 0.25)"
    assert shown_built(built_file(b"# time\n0 1\n")) == "a file of 2 lines: # time | 0 1"
    assert "'tread': 0.2765" in shown_built(built_robot(BEEGO))
