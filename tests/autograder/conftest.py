"""A course of one small notebook, in a folder of its own."""

import json
import os
import shutil
import sys
from concurrent.futures import Executor, Future
from contextlib import nullcontext
from pathlib import Path

import pytest

from autograder import batch, engine
from autograder.engine import Pool
from autograder.grading import plain_work
from tests.contents import table_of_contents

ROOT = Path(__file__).parents[2]
SMALL = Path(__file__).with_name("small_notebook.md")
WRITTEN_IN_CLASS = {"odometry/pose_update": ("q1_derivation",)}


@pytest.fixture
def small_contents():
    """A table of contents with one exercise and one written answer."""
    with table_of_contents({"odometry/pose_update": ("pose_step",)}, WRITTEN_IN_CLASS):
        yield


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


#: a second exercise in the first notebook, and a second notebook
EXERCISE = """
```{code-cell} ipython3
---
exercise: %s
---
def %s(%s):
    ### BEGIN SOLUTION
    return %s
    ### END SOLUTION
```
"""
CLASS_CONTENTS = {"odometry/pose_update": ("pose_step", "displacement"), "odometry/encoders": ("distance_per_count",)}
SOLUTIONS = {
    "pose_step": (
        "def pose_step(pose, distance, dtheta):\n    x, y, theta = pose\n"
        "    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])"
    ),
    "displacement": "def displacement(V, omega, dt):\n    return np.array([V * dt, 0.0, omega * dt])",
    "distance_per_count": (
        "def distance_per_count(radius, gear, counts_per_rev):\n    return 2 * np.pi * radius / (gear * counts_per_rev)"
    ),
}


@pytest.fixture
def class_contents():
    """A table of contents of two notebooks with three exercises and a written answer."""
    with table_of_contents(CLASS_CONTENTS, WRITTEN_IN_CLASS):
        yield


@pytest.fixture(scope="session")
def class_release(tmp_path_factory):
    """The root of a course of these notebooks, built. Copy it to change it."""
    from autograder.building import build

    root = tmp_path_factory.mktemp("course")
    (root / "source/odometry").mkdir(parents=True)
    (root / "course").mkdir()
    small = SMALL.read_text(encoding="utf-8")
    head, _, _ = small.partition('+++ {"lang": "en"}\n\nWhy?')
    sources = {
        "pose_update": small + EXERCISE % ("displacement", "displacement", "V, omega, dt", "np.array([V * dt, 0.0, omega * dt])"),
        "encoders": head
        + EXERCISE
        % (
            *("distance_per_count",) * 2,
            "radius, gear, counts_per_rev",
            "2 * np.pi * radius / (gear * counts_per_rev)",
        ),
    }
    for name, text in sources.items():
        (root / f"source/odometry/{name}.md").write_text(text, encoding="utf-8")
    with table_of_contents(CLASS_CONTENTS, WRITTEN_IN_CLASS):
        build(root)
    shutil.copy(ROOT / "nbgrader_config.py", root)
    return root


@pytest.fixture(scope="session")
def answered(class_release):
    """Returns a function that fills answers into a released notebook and gives its bytes."""

    def filled(notebook="pose_update", language="en", edit=None, **answers):
        path = class_release / f"release/{language}/odometry/{notebook}.ipynb"
        made = json.loads(path.read_text(encoding="utf-8"))
        for cell in made["cells"]:
            name = cell["metadata"].get("nbgrader", {}).get("grade_id")
            cell["source"] = {**SOLUTIONS, "q1_derivation": "Because.", **answers}.get(name, cell["source"])
        if edit is not None:
            edit(made)
        return json.dumps(made).encode()

    return filled


@pytest.fixture
def class_root(class_release, tmp_path, class_contents):
    """A copy of the course, where nobody has handed in anything yet."""
    root = tmp_path / "class"
    shutil.copytree(class_release, root)
    return root


@pytest.fixture
def hand_in(class_root):
    """Returns a function that puts notebooks, as bytes by name, where a student hands them in."""

    def put(student, **notebooks):
        folder = class_root / "submitted" / student / "odometry"
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in notebooks.items():
            (folder / f"{name}.ipynb").write_bytes(content)
        return folder

    return put


class Here(Executor):
    """Does all work at once, in this process, which sees what a test has patched."""

    def submit(self, call, *arguments):
        future = Future()
        try:
            future.set_result(call(*arguments))
        except BaseException as error:
            future.set_exception(error)
        return future


@pytest.fixture
def graded_here(monkeypatch):
    """Classes are graded in this process; the students who were graded, in order."""
    students = []

    def watched(work, version):
        students.append(work.student)
        return plain_work(work, version)

    monkeypatch.setattr(batch, "local_pool", lambda workers: nullcontext(Pool(Here(), workers, ())))
    monkeypatch.setattr(engine, "plain_work", watched)
    return students
