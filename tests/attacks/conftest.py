"""One run of the grader for all submissions of a test module."""

import pytest

from tests.attacks.lineup import Graded, Outcome


@pytest.fixture(scope="module")
def graded(request, tmp_path_factory) -> Graded:
    """The module's class after grading."""
    return request.module.LINEUP.graded(tmp_path_factory.mktemp("class") / "course")


@pytest.fixture
def outcome(request, graded) -> Outcome:
    """What came of the submission of the student that a test is about."""
    return Outcome(graded, request.param)
