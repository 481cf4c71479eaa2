"""What holds for every exercise that is registered: a later exercise is covered by being there."""

import ast
import contextlib
import importlib.util
import io
import re
import warnings
from collections import Counter
from functools import cache
from pathlib import Path
from types import ModuleType

import jupytext
import numpy as np
import pytest

from autograder import exercises, judge
from autograder.exercise import Exercise, trial
from autograder.reference import NOTEBOOKS
from course.answers import Question, reply_to
from course.plain import Built
from course.verdict import RUNGS

ROOT = Path(__file__).resolve().parents[2]
ALL = exercises()
FUNCTIONS = [exercise for exercise in ALL if isinstance(exercise, Exercise)]
#: drawings that are tried each time; those up to SEEDS are tried in the time that is left
FEW, SEEDS = 4, 200


def names(item: object) -> str:
    return getattr(item, "name", getattr(item, "slug", str(item)))


def judged(name: str, answer: object, seed: int):
    with warnings.catch_warnings(), contextlib.redirect_stdout(io.StringIO()):
        warnings.simplefilter("ignore")
        return judge(name, answer, seed)


@cache
def solution_cells() -> dict[str, str]:
    """The teacher's solution cell of every exercise, as the notebook's source has it."""
    found = {}
    for notebook in NOTEBOOKS:
        for cell in jupytext.read(ROOT / "source" / f"{notebook}.md").cells:
            if "exercise" in cell.metadata:
                found[cell.metadata["exercise"]] = cell.source
    return found


@cache
def namespace_of(notebook: str) -> dict[str, object]:
    """What the cells of one notebook import and define as functions, later ones on top of earlier ones."""
    space: dict[str, object] = {}
    for cell in jupytext.read(ROOT / "source" / f"{notebook}.md").cells:
        if cell.cell_type == "code" and "demo" not in cell.metadata.get("tags", ()):
            tree = ast.parse(cell.source)
            kept = [node for node in tree.body if isinstance(node, ast.Import | ast.ImportFrom | ast.FunctionDef)]
            exec(compile(ast.Module(kept, []), notebook, "exec"), space)
    return space


@cache
def answers(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"answers_{name}", ROOT / "tests" / "answers" / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("exercise", ALL, ids=names)
def test_describes_itself(exercise):
    assert exercise.points > 0
    assert len(exercise.misconceptions) >= 3
    assert len(set(exercise.misconceptions)) == len(exercise.misconceptions)
    for mistake in exercise.mistakes:
        english, japanese = mistake.message
        assert re.search("[ぁ-んァ-ン一-龥]", japanese), mistake.slug
        assert not re.search("[ぁ-んァ-ン一-龥]", english), mistake.slug
        assert 30 < len(english) < 600, mistake.slug


@pytest.mark.parametrize("exercise", FUNCTIONS, ids=names)
def test_solution_of_the_notebook_is_right(exercise):
    assert misjudged_solution(exercise, range(FEW)) == {}


@pytest.mark.slow
@pytest.mark.parametrize("exercise", FUNCTIONS, ids=names)
def test_solution_of_the_notebook_is_right_in_200_drawings(exercise):
    assert misjudged_solution(exercise, range(FEW, SEEDS)) == {}


def misjudged_solution(exercise, seeds):
    """Return the seeds for which the teacher's solution is not fully right, and what it was told."""
    answer = namespace_of(exercise.notebook)[exercise.name]
    verdicts = {seed: judged(exercise.name, answer, seed) for seed in seeds}
    return {seed: verdict.message("en") for seed, verdict in verdicts.items() if verdict.score != 1.0 or not verdict.passed}


@pytest.mark.parametrize("exercise", FUNCTIONS, ids=names)
def test_untouched_stub_is_told_kindly(exercise):
    stub = re.sub(
        r"^( *)### BEGIN SOLUTION(.|\n)*END SOLUTION.*$",
        r"\1raise NotImplementedError()",
        solution_cells()[exercise.name],
        flags=re.M,
    )
    space: dict[str, object] = {"np": np}
    exec(stub, space)
    verdict = judged(exercise.name, space[exercise.name], 0)
    assert verdict.score == 0
    assert verdict.rung == "runs"
    assert verdict.misconception is None
    assert "not written" in verdict.message("en")
    assert "書" in verdict.message("ja")


@pytest.mark.parametrize("exercise", FUNCTIONS, ids=names)
def test_every_mistake_loses_points_and_is_named(exercise):
    assert unrecognised(exercise, range(FEW)) == {}


@pytest.mark.slow
@pytest.mark.parametrize("exercise", FUNCTIONS, ids=names)
def test_every_mistake_loses_points_and_is_named_in_200_drawings(exercise):
    assert unrecognised(exercise, range(FEW, SEEDS)) == {}


def unrecognised(exercise, seeds):
    """Return the mistakes that passed in some drawing, or went by their name in fewer than 95 %: slug -> what happened."""
    passed, named = Counter(), Counter()
    for seed in seeds:
        # the mistakes of one drawing one after the other: the judge then draws its cases once
        for mistake in exercise.mistakes:
            verdict = judged(exercise.name, mistake.wrong, seed)
            assert verdict.rung is None or verdict.rung in RUNGS
            passed[mistake.slug] += verdict.score >= 1
            named[mistake.slug] += verdict.misconception == mistake.slug
    return {
        slug: f"passed {passed[slug]}, named {named[slug]} of {len(seeds)}"
        for slug in exercise.misconceptions
        if passed[slug] or named[slug] < 0.95 * len(seeds)
    }


@pytest.mark.parametrize("exercise", FUNCTIONS, ids=names)
def test_right_answers_in_other_styles_are_right(exercise):
    right = answers(exercise.name).RIGHT
    assert len(right) >= 3
    for seed in range(FEW):
        for label, answer in right.items():
            verdict = judged(exercise.name, answer, seed)
            assert verdict.score == 1.0, (label, seed, verdict.message("en"))


@pytest.mark.parametrize("exercise", FUNCTIONS, ids=names)
def test_wrong_answers_nobody_declared_lose_points(exercise):
    wrong = answers(exercise.name).WRONG
    seeds = range(FEW)
    told = {label: [] for label in wrong}
    for seed in seeds:
        for label, (answer, _, _) in wrong.items():
            told[label].append(judged(exercise.name, answer, seed))
    assert [label for label, verdicts in told.items() if any(verdict.score >= 1 for verdict in verdicts)] == []
    plain = [label for label, (_, _, kind) in wrong.items() if kind == "plain"]
    named = [
        label for label in plain if sum(v.misconception is not None or v.rung != "value" for v in told[label]) > len(seeds) / 2
    ]
    assert len(named) >= 0.9 * len(plain), set(plain) - set(named)


@pytest.mark.parametrize("exercise", FUNCTIONS, ids=names)
def test_cases_are_drawn_afresh_and_repeatably(exercise):
    one, same, other = trial(exercise, 1), trial(exercise, 1), trial(exercise, 2)
    assert repr(one.questions) == repr(same.questions)
    assert repr(one.questions) != repr(other.questions)


@pytest.mark.parametrize("exercise", FUNCTIONS, ids=names)
def test_reference_leaves_its_inputs_alone_and_does_not_warn(exercise):
    for question in trial(exercise, 3).questions:
        reply = reply_to(exercise.reference, Question(question.args))
        assert reply.trouble is None or reply.trouble.builtin in [error.__name__ for error in exercise.refuses]
        assert reply.warned == ()
        assert reply.printed == ""
        assert repr(reply.inputs) == repr(question.args)


def numbers_of(value):
    """Return the numbers that a plain value holds, in its entries too; a text holds none."""
    if isinstance(value, Built):
        return numbers_of(value.data)
    if isinstance(value, dict):
        return [number for entry in value.values() for number in numbers_of(entry)]
    return [] if value is None or isinstance(value, str) else np.ravel(np.asarray(value, dtype=float))


@pytest.mark.parametrize("exercise", FUNCTIONS, ids=names)
def test_messages_never_show_hidden_numbers(exercise):
    """No float of the inputs or of the expected values stands in what a wrong answer is told."""
    for mistake in exercise.mistakes:
        verdict = judged(exercise.name, mistake.wrong, 5)
        told = verdict.message("en") + verdict.message("ja")
        for question in trial(exercise, 5).questions:
            for value in (*question.args, reply_to(exercise.reference, Question(question.args)).value):
                for number in numbers_of(value):
                    # inputs that a definition names, such as 1e-12, may be named to the student too
                    if number != round(number, 2) and abs(number) > 1e-6 and len(f"{number:.6g}") > 3:
                        assert f"{number:.6g}" not in told
