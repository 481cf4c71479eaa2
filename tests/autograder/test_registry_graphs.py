"""What holds for every graph that is asked for: a later graph exercise is covered by being registered."""

import importlib.util
import re
from functools import cache, partial
from pathlib import Path
from types import ModuleType

import jupytext
import matplotlib as mpl
import numpy as np
import pytest

from autograder import exercises, judge
from autograder.exercise import GraphExercise
from autograder.sandbox.wire import packed_interview, unpacked_interview
from course.answers import interview
from course.checking import verdict_from_examples
from course.examples import _entry
from course.graphs import structure_fault
from course.verdict import RUNGS

mpl.use("Agg")
import matplotlib.pyplot as plt

ROOT = Path(__file__).resolve().parents[2]
GRAPHS = [exercise for exercise in exercises() if isinstance(exercise, GraphExercise)]
SIDES_OF_A_NUMBER = r"(?<![\d.])"


def names(item: object) -> str:
    return getattr(item, "name", getattr(item, "slug", str(item)))


@pytest.fixture(autouse=True)
def figures_closed():
    yield
    plt.close("all")


@cache
def answers(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"answers_{name}", ROOT / "tests" / "answers" / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def drawn(exercise: GraphExercise, factory):
    """The Axes of a factory without arguments; it finds the data in its module."""
    answers(exercise.name).RESULT = exercise.shown
    return factory()


@pytest.mark.parametrize("exercise", GRAPHS, ids=names)
def test_every_mistake_loses_points_and_is_named(exercise):
    for mistake in exercise.mistakes:
        verdict = judge(exercise.name, mistake.wrong(exercise.shown))
        assert verdict.score < 1, mistake.slug
        assert verdict.misconception == mistake.slug, verdict.message("en")
        assert verdict.rung in RUNGS
        assert verdict.message("en").startswith(mistake.message.en)
        plt.close("all")


@pytest.mark.parametrize("exercise", GRAPHS, ids=names)
def test_every_fault_speaks_both_languages_and_shows_no_hidden_number(exercise):
    shown = exercise.shown if isinstance(exercise.shown, dict) else {}
    for mistake in exercise.mistakes:
        verdict = judge(exercise.name, mistake.wrong(exercise.shown))
        english, japanese = verdict.message("en"), verdict.message("ja")
        assert re.search("[ぁ-んァ-ン一-龥]", japanese), mistake.slug
        assert not re.search("[ぁ-んァ-ン一-龥]", english), mistake.slug
        for values in shown.values():
            ends = {f"{value:.{digits}g}" for value in (values[-1], values.min(), values.max()) for digits in (3, 4, 6)}
            for number in ends - {"0"}:
                assert not re.search(SIDES_OF_A_NUMBER + re.escape(number), english + japanese), (mistake.slug, number)
        plt.close("all")


@pytest.mark.parametrize("exercise", GRAPHS, ids=names)
def test_right_graphs_in_other_styles_are_right(exercise):
    right = answers(exercise.name).RIGHT
    assert len(right) >= 5
    for label, factory in right.items():
        verdict = judge(exercise.name, drawn(exercise, factory))
        assert verdict.score == 1.0, (label, verdict.message("en"))
        assert verdict.passed
        plt.close("all")


@pytest.mark.parametrize("exercise", GRAPHS, ids=names)
def test_wrong_graphs_nobody_declared_lose_points(exercise):
    wrong = answers(exercise.name).WRONG
    assert len(wrong) >= 12
    told = {}
    for label, (factory, _, _) in wrong.items():
        told[label] = judge(exercise.name, drawn(exercise, factory))
        plt.close("all")
    assert [label for label, verdict in told.items() if verdict.score >= 1] == []
    plain = [label for label, (_, _, kind) in wrong.items() if kind == "plain"]
    named = [label for label in plain if told[label].misconception is not None or told[label].rung != "value"]
    assert len(named) >= 0.9 * len(plain), set(plain) - set(named)


@pytest.mark.parametrize("exercise", GRAPHS, ids=names)
def test_a_graph_is_judged_alike_across_the_wire(exercise):
    for factory in answers(exercise.name).RIGHT.values():
        talk = interview(drawn(exercise, factory), ())
        sent = unpacked_interview(packed_interview(talk, ()), ())
        assert exercise.fault(sent.figure, exercise.shown) is None
        plt.close("all")


@pytest.mark.parametrize("exercise", GRAPHS, ids=names)
def test_a_bundle_accepts_every_right_graph_by_its_structure(exercise):
    for label, factory in answers(exercise.name).RIGHT.items():
        talk = interview(drawn(exercise, factory), ())
        assert structure_fault(exercise.structure, talk.figure) is None, label
        plt.close("all")


@pytest.mark.parametrize("exercise", GRAPHS, ids=names)
def test_a_bundle_knows_the_graph(exercise):
    empty = plt.figure().add_subplot()
    verdict = verdict_from_examples(exercise.name, partial(interview, empty))
    assert verdict.public
    assert verdict.rung == "shape"
    assert _entry(exercise.name, {"graph": vars(exercise.structure)}) == exercise.structure


@pytest.mark.parametrize("exercise", GRAPHS, ids=names)
def test_what_must_be_shown_is_a_copy(exercise):
    shown = exercise.shown
    if isinstance(shown, dict):
        shown["time"] += 1
        assert np.array_equal(exercise.shown["time"], shown["time"] - 1)


@pytest.mark.parametrize("exercise", GRAPHS, ids=names)
def test_what_is_no_axes_is_told_so(exercise):
    for answer in (plt.figure(), None, [1, 2], plt.plot([1, 2])):
        verdict = judge(exercise.name, answer)
        assert (verdict.score, verdict.rung) == (0.0, "callable")


@pytest.mark.parametrize("exercise", GRAPHS, ids=names)
def test_a_flood_of_points_is_judged_too(exercise):
    ax = plt.figure().add_subplot()
    for _ in range(20):
        ax.plot(np.linspace(0, 30, 100_000), np.linspace(-1, 1, 100_000))
    assert judge(exercise.name, ax).score < 1


@pytest.mark.parametrize("exercise", GRAPHS, ids=names)
def test_solution_of_the_notebook_names_the_graph(exercise):
    """The whole notebook is run elsewhere; here only that its solution binds an Axes to the name."""
    cells = jupytext.read(ROOT / "source" / f"{exercise.notebook}.md").cells
    [solution] = [cell.source for cell in cells if cell.metadata.get("exercise") == exercise.name]
    assert re.search(rf"\b{exercise.name}\b", solution)
