"""A class of its own for each module of attacks, graded once."""

import os
import sys
from pathlib import Path

import pytest

from tests.attacks.cohort import Fate, graded_cohort
from tests.classroom import LIMITS


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
