"""One run of the grader for all submissions of a test module."""

import pytest

pytest.register_assert_rewrite("tests.attacks.lineup")

from tests.attacks.lineup import Graded, Outcome  # noqa: E402 - rewritten first


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
