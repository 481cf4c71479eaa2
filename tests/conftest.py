"""What all tests share: the root of the course, and what to do where bubblewrap, Chromium or PostgreSQL is missing."""

import math
import os
import shutil
import time
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import settings

if TYPE_CHECKING:
    from tests.small_class import Undisturbed

# on a busy machine one example may take a second: that says nothing
settings.register_profile("patient", deadline=None)
settings.load_profile("patient")

ROOT = Path(__file__).resolve().parent.parent
BEGAN = time.monotonic()


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--slow-until", type=float, default=math.inf, metavar="SECONDS",
        help="begin no test marked slow when the run has lasted so long; they come last (default: run all)",
    )  # fmt: skip


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put the slow tests at the end: what time is left is theirs."""
    items.sort(key=lambda item: item.get_closest_marker("slow") is not None)


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


def pytest_runtest_setup(item: pytest.Item) -> None:
    if item.get_closest_marker("slow") and time.monotonic() - BEGAN > item.config.getoption("--slow-until"):
        pytest.skip("no time is left for slow tests; type: make slow")
    # Debian keeps the programs of the PostgreSQL server off PATH
    servers = os.pathsep.join([os.environ["PATH"], *map(str, Path("/usr/lib/postgresql").glob("*/bin"))])
    for marker, program in (("sandbox", "bwrap"), ("browser", "chromium"), ("postgresql", "initdb")):
        if item.get_closest_marker(marker) and shutil.which(program, path=servers) is None:
            # in CI nothing is left out
            (pytest.fail if os.environ.get("CI") else pytest.skip)(f"{program} is not installed")


@pytest.fixture(scope="session")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> "Undisturbed":
    """A small class that was graded with nothing in the way: see tests/small_class.py."""
    from tests.small_class import graded_undisturbed

    return graded_undisturbed(tmp_path_factory.mktemp("undisturbed") / "course")
