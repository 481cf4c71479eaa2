"""A course of one small notebook, in a folder of its own."""

import os
import sys
from pathlib import Path

import pytest

from autograder.reference import NOTEBOOKS, WRITTEN

SMALL = Path(__file__).with_name("small_notebook.md")


@pytest.fixture
def small_contents(monkeypatch):
    """A table of contents with one exercise and one written answer."""
    for notebook in [*NOTEBOOKS]:
        monkeypatch.delitem(NOTEBOOKS, notebook)
    monkeypatch.setitem(NOTEBOOKS, "odometry/pose_update", ("pose_step",))
    monkeypatch.setitem(WRITTEN, "odometry/pose_update", ("q1_derivation",))


@pytest.fixture
def small_source():
    return SMALL.read_text(encoding="utf-8")


@pytest.fixture
def small_course(tmp_path, small_contents, small_source):
    """The root of a course with that notebook's source, nothing built yet."""
    (tmp_path / "source/odometry").mkdir(parents=True)
    (tmp_path / "course").mkdir()
    (tmp_path / "source/odometry/pose_update.md").write_text(small_source, encoding="utf-8")
    return tmp_path


@pytest.fixture(scope="session", autouse=True)
def alembic_on_path():
    """nbgrader runs alembic, which lives beside this Python, when it makes a gradebook."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PATH", f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")
        yield


@pytest.fixture(scope="session")
def empty_gradebook(alembic_on_path, tmp_path_factory):
    """A new gradebook, to be copied: making one takes seconds."""
    from nbgrader.api import Gradebook

    path = tmp_path_factory.mktemp("gradebook") / "empty.db"
    Gradebook(f"sqlite:///{path}", "dead-reckoning").close()
    return path
