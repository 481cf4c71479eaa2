"""Classes of hostile and of odd submissions: each module's is graded once, and its tests look at what came of it."""

import os
import sys
from pathlib import Path

import pytest

pytest.register_assert_rewrite("tests.attacks.lineup")

from tests.attacks.cohort import Fate, graded_cohort  # noqa: E402 - rewritten first
from tests.attacks.lineup import Graded, Outcome  # noqa: E402
from tests.classroom import LIMITS  # noqa: E402


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Keep the tests of a module in one process, so that its class is graded once."""
    for item in items:
        if Path(__file__).parent in item.path.parents:
            item.add_marker(pytest.mark.xdist_group(item.path.stem))


@pytest.fixture(scope="module")
def graded(request, tmp_path_factory) -> Graded:
    """The module's class after grading; of what it hands in, only what the chosen tests look at."""
    chosen = [getattr(item, "callspec", None) for item in request.session.items if item.module is request.module]
    students = {spec.params["outcome"] for spec in chosen if spec is not None and "outcome" in spec.params}
    return request.module.LINEUP.graded(tmp_path_factory.mktemp("class") / "course", students)


@pytest.fixture
def outcome(request, graded) -> Outcome:
    """What came of the submission of the student that a test is about."""
    return Outcome(graded, graded.id_of(request.param))


@pytest.fixture(scope="module")
def cohort(request, tmp_path_factory):
    """The class of the module's hostile students and two honest ones, graded within the module's LIMITS."""
    with pytest.MonkeyPatch.context() as patch:
        # nbgrader runs alembic, which lives beside this Python
        patch.setenv("PATH", f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")
        yield graded_cohort(request, tmp_path_factory.mktemp("attacked") / "class", getattr(request.module, "LIMITS", LIMITS))


@pytest.fixture
def fate(request, cohort):
    """What came of the test's own submission, after what holds for every submission was checked."""
    made = Fate(cohort, request.param[0])
    made.check()
    return made
