"""Classes of hostile and of odd submissions: each module's is graded once, and its tests look at what came of it."""

import os
import sys
from pathlib import Path
from types import ModuleType

import pytest

pytest.register_assert_rewrite("tests.attacks.lineup")

from autograder.session import Limits  # noqa: E402
from tests.attacks.cohort import Cohort, Fate  # noqa: E402 - rewritten first
from tests.attacks.lineup import Graded, Outcome  # noqa: E402
from tests.classroom import LIMITS  # noqa: E402


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Keep the tests of a module in one process, so that its class is graded once; variants of an attack come later, in a second."""
    seen: set[str] = set()
    for item in items:
        if Path(__file__).parent in item.path.parents:
            test = f"{item.path.stem}::{getattr(item, 'originalname', item.name)}"
            # some modules compare the submissions of one class with one another
            if test in seen and not getattr(item.module, "ONE_CLASS", False):  # type: ignore[attr-defined]
                item.add_marker(pytest.mark.slow)
            seen.add(test)
            item.add_marker(pytest.mark.xdist_group(item.path.stem + (" variants" if is_variant(item) else "")))


def is_variant(item: pytest.Item) -> bool:
    return item.get_closest_marker("slow") is not None


def students_of(request: pytest.FixtureRequest, parameter: str) -> list:
    """Return what the tests of this module hand in that belong to the same class as the test that asks."""
    items = [item for item in request.session.items if item.path == request.path and is_variant(item) is is_variant(request.node)]
    calls = [item.callspec.params for item in items if hasattr(item, "callspec")]
    return [params[parameter] for params in calls if parameter in params]


@pytest.fixture(scope="module")
def classes() -> dict[bool, object]:
    """The module's two classes after grading: first the one of each attack, then the one of its variants."""
    return {}


@pytest.fixture
def graded(request, classes, tmp_path_factory) -> Graded:
    """The test's class after grading."""
    variants = is_variant(request.node)
    if variants not in classes:
        folder = tmp_path_factory.mktemp("class") / "course"
        classes[variants] = request.module.LINEUP.graded(folder, {*students_of(request, "outcome")})
    return classes[variants]


@pytest.fixture
def outcome(request, graded) -> Outcome:
    """What came of the submission of the student that a test is about."""
    return Outcome(graded, graded.id_of(request.param))


@pytest.fixture
def cohort(request, classes, tmp_path_factory) -> Cohort:
    """The test's class of hostile students and two honest ones, graded within the module's LIMITS."""
    variants = is_variant(request.node)
    if variants not in classes:
        with pytest.MonkeyPatch.context() as patch:
            # nbgrader runs alembic, which lives beside this Python
            patch.setenv("PATH", f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")
            submissions = dict(students_of(request, "fate"))
            classes[variants] = Cohort(tmp_path_factory.mktemp("attacked") / "class", submissions, limits_of(request.module))
    return classes[variants]


def limits_of(module: ModuleType) -> Limits:
    return getattr(module, "LIMITS", LIMITS)


@pytest.fixture
def fate(request, cohort):
    """What came of the test's own submission, after what holds for every submission was checked."""
    made = Fate(cohort, request.param[0])
    made.check()
    return made
