"""What all tests share: the root of the course, and what to do where bubblewrap or Chromium is missing."""

import os
import shutil
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


def pytest_runtest_setup(item: pytest.Item) -> None:
    for marker, program in (("sandbox", "bwrap"), ("browser", "chromium")):
        if item.get_closest_marker(marker) and shutil.which(program) is None:
            # in CI nothing is left out
            (pytest.fail if os.environ.get("CI") else pytest.skip)(f"{program} is not installed")
