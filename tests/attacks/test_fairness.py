"""Honest but odd submissions score exactly what their answers deserve, and where stock nbgrader is fair, the same as there."""

import json
import os
import shutil
import subprocess
import sys
from functools import reduce
from pathlib import Path

import pytest

from autograder.reference import NOTEBOOKS
from tests.attacks.lineup import Graded, Lineup, Outcome, answered, answers, bare, checks, grade_id
from tests.classroom import ASSIGNMENT, Classroom, code_cell, graded_cell, solved, with_answer, with_cell

pytestmark = [pytest.mark.sandbox, pytest.mark.timeout(1800)]
LINEUP = Lineup()
EXERCISES = NOTEBOOKS["odometry/pose_update"]


# the notebook is odd, its answers are right


def stub_removed(*exercises):
    """A notebook in which these answers stand in cells of their own, after an answer cell that is left empty."""
    made = bare(solved())
    for name in exercises:
        cell = graded_cell(made, name)
        source, cell["source"] = cell["source"], ""
        made["cells"].insert(made["cells"].index(cell) + 1, code_cell(source))
    return made


def split():
    """A notebook in which each answer is split: what its cell needs stands in a cell before it."""
    made = bare(solved())
    for cell in answers(made):
        cell["source"] = cell["source"].replace("np.", "numerics.")
        made["cells"].insert(made["cells"].index(cell), code_cell("import numpy as numerics"))
    return made


def backwards():
    """All cells in the other order, with answers that need no other answer."""
    made = bare(solved())
    for style, exercise in (("einsum", "pose_step_matrix"), ("cumulative sums", "dead_reckoning")):
        made = with_answer(made, exercise, STYLES[style, exercise])
    return {**made, "cells": [made["cells"][0], *reversed(made["cells"][1:])]}


def answers_first():
    made = bare(solved())
    return {**made, "cells": [made["cells"][0], *checks(made), *answers(made)]}


def checks_first_and_once_more():
    made = bare(solved())
    return {**made, "cells": [made["cells"][0], *checks(made), *made["cells"][1:], *checks(made)]}


def without_cells(*gone):
    made = bare(solved())
    return {**made, "cells": [cell for cell in made["cells"] if grade_id(cell) not in gone]}


def copied(exercise):
    """A check cell copied below itself and to the end."""
    made = bare(solved())
    cell = graded_cell(made, f"check_{exercise}")
    made["cells"].insert(made["cells"].index(cell), cell)
    return {**made, "cells": [*made["cells"], cell]}


def all_in_one_cell():
    made = bare(solved())
    sources = [cell["source"] for cell in answers(made)]
    for cell in answers(made):
        cell["source"] = ""
    return with_cell(made, "\n\n\n".join(sources), 2)


def each_cell(change, notebook=None):
    made = notebook or solved()
    for cell in made["cells"]:
        change(cell)
    return made


def by_other_tools(cell):
    """Without ids, without what nbgrader wrote, with what another editor adds."""
    cell.pop("id", None)
    labels = cell["metadata"].get("nbgrader")
    cell["metadata"] = (
        {"nbgrader": labels, "colab": {"base_uri": "https://localhost:8080/"}, "id": "Xy7_"} if labels else {"id": "a1"}
    )


def without_metadata(cell):
    cell.pop("id", None)
    cell["metadata"] = {"vscode": {"languageId": "python"}}


def as_lines(cell):
    cell["source"] = cell["source"].splitlines(keepends=True)


def old_format(notebook):
    return {**each_cell(lambda cell: cell.pop("id", None), notebook), "nbformat": 4, "nbformat_minor": 4}


def in_languages(first, second):
    """A notebook of one edition, with answer cells and prose of the other."""
    made, other = solved(first), solved(second)
    for index in range(1, len(made["cells"]), 2):
        made["cells"][index] = other["cells"][index]
    return made


def in_front_of_each_answer(head):
    made = bare(solved())
    for cell in answers(made):
        cell["source"] = f"{head}\n{cell['source']}"
    return made


def after_each_answer(tail):
    made = bare(solved())
    for cell in answers(made):
        cell["source"] = f"{cell['source']}\n{tail}"
    return made


SLOW = "import time\ntime.sleep(0.2)"
LOUD = "for line in range(2000):\n    print(line, 'x' * 40)"
WHOLE = {
    "as it is": solved,
    "Japanese": lambda: solved("ja"),
    "bare": lambda: bare(solved()),
    "run, with all its outputs": lambda: each_cell(
        lambda cell: (
            cell.update(outputs=[{"output_type": "stream", "name": "stdout", "text": "1\n"}], execution_count=7)
            if cell["cell_type"] == "code"
            else None
        )
    ),
    "with more cells": lambda: reduce(
        lambda made, at: with_cell(made, f"note_{at} = {at}\nnote_{at}", at), range(1, 90, 3), solved()
    ),
    "with cells that fail": lambda: reduce(lambda made, at: with_cell(made, "undefined_name", at), (1, 5, 9), bare(solved())),
    "with a cell that cannot be read": lambda: reduce(lambda made, at: with_cell(made, "for in:", at), (1, 5, 9), bare(solved())),
    "split": split,
    "backwards": backwards,
    "checks at the end": lambda: {
        **bare(solved()),
        "cells": [*bare(solved())["cells"][:1], *answers(bare(solved())), *checks(bare(solved()))],
    },
    "checks before the answers": answers_first,
    "checks before and after": checks_first_and_once_more,
    "one check deleted": lambda: without_cells("check_pose_step"),
    "all checks deleted": lambda: without_cells(*[f"check_{name}" for name in EXERCISES]),
    "written answer deleted": lambda: without_cells("q1_derivation"),
    "a check copied": lambda: copied("pose_step"),
    "a check written over": lambda: with_answer(bare(solved()), "check_pose_step", "check('pose_step'); check('displacement')"),
    "all answers in one cell": all_in_one_cell,
    "answers in other cells": lambda: stub_removed(*EXERCISES),
    "answer cells deleted, answers elsewhere": lambda: {
        **bare(solved()),
        "cells": [code_cell(cell["source"]) if cell in answers(bare(solved())) else cell for cell in bare(solved())["cells"]],
    },
    "from Colab": lambda: each_cell(by_other_tools),
    "metadata and ids dropped": lambda: each_cell(without_metadata),
    "metadata dropped, ids kept": lambda: each_cell(lambda cell: cell.update(metadata={})),
    "lines": lambda: each_cell(as_lines),
    "nbformat 4.4": lambda: old_format(solved()),
    "nbformat 4.2 from a text": lambda: {
        **old_format(solved()),
        "nbformat_minor": 2,
        "metadata": {"jupytext": {"main_language": "python"}},
    },
    "English with Japanese cells": lambda: in_languages("en", "ja"),
    "Japanese with English cells": lambda: in_languages("ja", "en"),
    "indented JSON": lambda: json.dumps(solved(), indent=4).encode(),
    "Windows": lambda: json.dumps(solved(), indent=1).encode().replace(b"\n", b"\r\n").replace(b"\\n", b"\\r\\n"),
    "escaped": lambda: json.dumps(solved("ja"), ensure_ascii=True).encode(),
    "slow": lambda: in_front_of_each_answer(SLOW),
    "loud": lambda: in_front_of_each_answer(LOUD),
    "prints Japanese": lambda: in_front_of_each_answer("print('こんにちは、計算します 😀')\n結果 = '良い'"),
    "%%time on top": lambda: in_front_of_each_answer("%%time"),
    "%%capture on top": lambda: in_front_of_each_answer("%%capture"),
    "magics": lambda: in_front_of_each_answer(
        "%matplotlib inline\n%precision 3\n%config InlineBackend.figure_format = 'retina'\nnp.cos?"
    ),
    "timed": lambda: with_cell(
        bare(solved()), "%timeit -n 2 -r 1 pose_step([0, 0, 0], 1, 0)\n%time pose_step([0, 0, 0], 1, 0)", -1
    ),
    "a shell": lambda: with_cell(bare(solved()), "!pip list\n!ls\n%pip --version\nfiles = !ls"),
    "checks itself": lambda: after_each_answer("check('pose_step')\nassert True"),
    "prints at each call": lambda: after_each_answer("print(*range(100))"),
    "ends with a value": lambda: after_each_answer("0.0"),
    "ends with a negative value": lambda: after_each_answer("-1"),
    "installs warnings": lambda: with_cell(
        bare(solved()), "import warnings\nwarnings.simplefilter('error')\nnp.seterr(all='raise')"
    ),
    "silences warnings": lambda: with_cell(
        bare(solved()), "import warnings\nwarnings.filterwarnings('ignore')\nnp.seterr(all='ignore')"
    ),
    "other print options": lambda: with_cell(
        bare(solved()), "np.set_printoptions(precision=2, suppress=True)\nsp.init_printing()"
    ),
    "another style of figures": lambda: with_cell(
        solved(), "import matplotlib.pyplot as plt\nplt.style.use('ggplot')\nplt.rcParams['figure.dpi'] = 50"
    ),
    "other names for modules": lambda: with_cell(
        bare(solved()), "import numpy\nimport math as m\nfrom numpy import *\nfrom math import *"
    ),
    "names of its own": lambda: with_cell(bare(solved()), "name = answer = result = verdict = cells = shell = 0\nlist_ = [1]"),
    "seeds": lambda: with_cell(
        bare(solved()), "import random\nrandom.seed(0)\nnp.random.seed(0)\nrng = np.random.default_rng(0)"
    ),
    "a thread": lambda: with_cell(
        bare(solved()), "import threading\nthread = threading.Thread(target=print, args=('x',))\nthread.start()\nthread.join()"
    ),
    "a file of its own": lambda: with_cell(
        bare(solved()), "from pathlib import Path\nPath('notes.txt').write_text('x')\nPath('notes.txt').read_text()"
    ),
    "asks for input": lambda: with_cell(bare(solved()), "name = input('name? ')"),
    "very long lines": lambda: with_cell(bare(solved()), "table = [" + ", ".join(map(str, range(20_000))) + "]"),
    "await": lambda: with_cell(bare(solved()), "import asyncio\nawait asyncio.sleep(0.01)"),
    "exit at the end": lambda: with_cell(bare(solved()), "exit()", -1),
    "a plot for each answer": lambda: after_each_answer("import matplotlib.pyplot as plt\nplt.plot([1, 2])\nplt.show()"),
    "names in Japanese": lambda: with_cell(bare(solved()), "def 姿勢(値):\n    return 値\n姿勢(3)"),
}


@LINEUP.hands_in(WHOLE)
def test_right_answers_in_an_odd_notebook_have_all_points(outcome):
    outcome.assert_earns(*EXERCISES)


# the answer is odd, and right

STYLES = {
    ("lambda", "pose_step"): "pose_step = lambda p, d, t: [p[0] + d * np.cos(p[2]), p[1] + d * np.sin(p[2]), p[2] + t]",
    (
        "tuple",
        "pose_step",
    ): "def pose_step(pose, distance, dtheta):\n    x, y, h = pose\n    return x + distance * np.cos(h), y + distance * np.sin(h), h + dtheta",
    ("class", "pose_step"): (
        "class Step:\n    def __call__(self, pose, distance, dtheta):\n        x, y, h = pose\n"
        "        return np.array([x + distance * np.cos(h), y + distance * np.sin(h), h + dtheta])\npose_step = Step()"
    ),
    ("bound method", "pose_step"): (
        "class Robot:\n    def step(self, pose, distance, dtheta):\n        x, y, h = pose\n"
        "        return np.array([x + distance * np.cos(h), y + distance * np.sin(h), h + dtheta])\npose_step = Robot().step"
    ),
    ("star arguments", "pose_step"): (
        "def pose_step(*args, **options):\n    (x, y, h), d, t = args\n    return np.array([x + d * np.cos(h), y + d * np.sin(h), h + t])"
    ),
    ("defaults", "pose_step"): (
        "def pose_step(pose, distance=1.0, dtheta=0.0, *, verbose=True):\n    pose = np.array(pose, dtype=float)\n    h = pose[2]\n"
        "    if verbose: print(pose)\n    return pose + [distance * np.cos(h), distance * np.sin(h), dtheta]"
    ),
    ("type hints", "pose_step"): (
        "from typing import Sequence\ndef pose_step(pose: Sequence[float], distance: float, dtheta: float) -> 'np.ndarray[float]':\n"
        "    x: float; y: float\n    x, y, h = pose\n    return np.array([x + distance * np.cos(h), y + distance * np.sin(h), h + dtheta])"
    ),
    ("walrus", "pose_step"): (
        "def pose_step(pose, distance, dtheta):\n    return np.array([pose[0] + distance * np.cos(h := pose[2]), pose[1] + distance * np.sin(h), h + dtheta])"
    ),
    ("complex numbers", "pose_step"): (
        "import cmath\ndef pose_step(pose, distance, dtheta):\n    z = complex(pose[0], pose[1]) + distance * cmath.exp(1j * pose[2])\n"
        "    return z.real, z.imag, pose[2] + dtheta"
    ),
    ("imports within", "pose_step"): (
        "def pose_step(pose, distance, dtheta):\n    import math\n    from numpy import array\n    x, y, h = pose\n"
        "    return array([x + distance * math.cos(h), y + distance * math.sin(h), h + dtheta])"
    ),
    ("single precision", "planar_rotation"): (
        "def planar_rotation(theta):\n    c, s = np.cos(theta, dtype=np.float32), np.sin(theta, dtype=np.float32)\n"
        "    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]], dtype=np.float32)"
    ),
    ("lists", "planar_rotation"): (
        "import math\ndef planar_rotation(theta):\n    c, s = math.cos(theta), math.sin(theta)\n    return [[c, -s, 0], [s, c, 0], [0, 0, 1]]"
    ),
    ("tuples of tuples", "planar_rotation"): (
        "def planar_rotation(theta):\n    c, s = np.cos(theta), np.sin(theta)\n    return (c, -s, 0), (s, c, 0), (0, 0, 1)"
    ),
    ("list of arrays", "planar_rotation"): (
        "def planar_rotation(theta):\n    c, s = np.cos(theta), np.sin(theta)\n    return [np.array([c, -s, 0]), np.array([s, c, 0]), np.eye(3)[2]]"
    ),
    ("stacked", "planar_rotation"): (
        "def planar_rotation(theta):\n    m = np.eye(3)\n    m[:2, :2] = np.cos(theta) * np.eye(2) + np.sin(theta) * np.array([[0, -1], [1, 0]])\n    return m"
    ),
    ("transposed", "planar_rotation"): (
        "def planar_rotation(theta):\n    c, s = np.cos(theta), np.sin(theta)\n    return np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]).T"
    ),
    ("in Fortran's order", "planar_rotation"): (
        "def planar_rotation(theta):\n    c, s = np.cos(theta), np.sin(theta)\n    return np.asfortranarray([[c, -s, 0], [s, c, 0], [0, 0, 1]])"
    ),
    ("solved for", "planar_rotation"): (
        "def planar_rotation(theta):\n    c, s = np.cos(theta), np.sin(theta)\n    return np.linalg.inv(np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]))"
    ),
    ("partial", "displacement"): (
        "from functools import partial\ndef planar(lateral, velocity, yaw_rate, dt):\n    return np.array([velocity, lateral, yaw_rate]) * dt\n"
        "displacement = partial(planar, 0.0)"
    ),
    ("decorated", "displacement"): (
        "import functools\ndef logged(f):\n    @functools.wraps(f)\n    def inner(*args):\n        print(f.__name__, args)\n        return f(*args)\n"
        "    return inner\n@logged\ndef displacement(velocity, yaw_rate, dt):\n    return np.array([velocity * dt, 0, yaw_rate * dt])"
    ),
    ("undocumented decorator", "displacement"): (
        "def twice(f):\n    return lambda *args: (f(*args), f(*args))[1]\n@twice\ndef displacement(velocity, yaw_rate, dt):\n    return [velocity * dt, 0, yaw_rate * dt]"
    ),
    ("cached", "displacement"): (
        "import functools\n@functools.lru_cache\ndef displacement(velocity, yaw_rate, dt):\n    return np.array([velocity * dt, 0.0, yaw_rate * dt])"
    ),
    ("generator within", "displacement"): (
        "def displacement(velocity, yaw_rate, dt):\n    def parts():\n        yield velocity * dt\n        yield 0.0\n        yield yaw_rate * dt\n    return np.fromiter(parts(), float)"
    ),
    ("nested functions", "displacement"): (
        "def displacement(velocity, yaw_rate, dt):\n    def times(a):\n        return a * dt\n    u, phi = map(times, (velocity, yaw_rate))\n    return np.array([u, 0, phi])"
    ),
    (
        "two names",
        "displacement",
    ): "def my_displacement(v, w, t):\n    return np.array([v * t, 0, w * t])\ndisplacement = my_displacement",
    (
        "vectorised",
        "displacement",
    ): "both = np.vectorize(lambda a, t: a * t)\ndef displacement(velocity, yaw_rate, dt):\n    return both([velocity, 0, yaw_rate], dt)",
    ("a warning", "displacement"): (
        "import warnings\ndef displacement(velocity, yaw_rate, dt):\n    warnings.warn('old', DeprecationWarning)\n    return np.array([velocity * dt, 0, yaw_rate * dt])"
    ),
    ("standard error", "displacement"): (
        "import sys\ndef displacement(velocity, yaw_rate, dt):\n    print('error?', file=sys.stderr)\n    return np.array([velocity * dt, 0, yaw_rate * dt])"
    ),
    (
        "a table",
        "displacement",
    ): "def displacement(velocity, yaw_rate, dt):\n    return np.array([[1, 0], [0, 0], [0, 1]]) @ [velocity * dt, yaw_rate * dt]",
    ("global state", "pose_step_matrix"): (
        "R = None\ndef pose_step_matrix(pose, displacement):\n    global R\n    c, s = np.cos(pose[2]), np.sin(pose[2])\n"
        "    R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])\n    return np.array(pose) + R @ np.array(displacement)"
    ),
    ("another cell's function", "pose_step_matrix"): (
        "def pose_step_matrix(pose, displacement):\n    p, d = np.array(pose, float)[:, None], np.array(displacement, float)[:, None]\n"
        "    c, s = np.cos(pose[2]), np.sin(pose[2])\n    return (p + np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ d).ravel()"
    ),
    ("try and except", "pose_step_matrix"): (
        "def pose_step_matrix(pose, displacement):\n    try:\n        x, y, h = pose\n    except TypeError:\n        raise\n    finally:\n        u, v, phi = displacement\n"
        "    c, s = np.cos(h), np.sin(h)\n    return [x + c * u - s * v, y + s * u + c * v, h + phi]"
    ),
    ("match", "pose_step_matrix"): (
        "def pose_step_matrix(pose, displacement):\n    match tuple(pose), tuple(displacement):\n        case (x, y, h), (u, v, phi):\n"
        "            c, s = np.cos(h), np.sin(h)\n            return np.hstack([x + c * u - s * v, y + s * u + c * v, h + phi])"
    ),
    ("einsum", "pose_step_matrix"): (
        "def pose_step_matrix(pose, displacement):\n    c, s = np.cos(pose[2]), np.sin(pose[2])\n"
        "    return pose + np.einsum('ij,j->i', np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]]), displacement)"
    ),
    ("by another answer", "pose_step_midpoint"): (
        "def pose_step_midpoint(pose, distance, dtheta):\n    def euler(p, d, t):\n        x, y, h = p\n        return np.array([x + d * np.cos(h), y + d * np.sin(h), h + t])\n"
        "    half = euler(pose, 0.0, dtheta / 2)\n    return euler(half, distance, dtheta / 2)"
    ),
    ("one expression", "pose_step_midpoint"): (
        "def pose_step_midpoint(pose, distance, dtheta): return (lambda x, y, h: np.r_[x + distance * np.cos(h + dtheta / 2), "
        "y + distance * np.sin(h + dtheta / 2), h + dtheta])(*pose)"
    ),
    ("in a loop", "pose_step_midpoint"): (
        "def pose_step_midpoint(pose, distance, dtheta):\n    new = [0.0] * 3\n    for i, f in enumerate((np.cos, np.sin)):\n"
        "        new[i] = pose[i] + distance * f(pose[2] + 0.5 * dtheta)\n    new[2] = pose[2] + dtheta\n    return new"
    ),
    ("sinc", "pose_step_arc"): (
        "def pose_step_arc(pose, distance, dtheta):\n    x, y, h = pose\n    chord = distance * np.sinc(dtheta / 2 / np.pi)\n"
        "    return np.array([x + chord * np.cos(h + dtheta / 2), y + chord * np.sin(h + dtheta / 2), h + dtheta])"
    ),
    ("SciPy", "pose_step_arc"): (
        "from scipy.special import spherical_jn\ndef pose_step_arc(pose, distance, dtheta):\n    x, y, h = pose\n    chord = distance * spherical_jn(0, abs(dtheta) / 2)\n"
        "    return np.array([x + chord * np.cos(h + dtheta / 2), y + chord * np.sin(h + dtheta / 2), h + dtheta])"
    ),
    ("loop with append", "dead_reckoning"): (
        "def dead_reckoning(velocity, yaw_rate, dt, pose0):\n    n = len(velocity)\n    dts = [dt] * n if np.ndim(dt) == 0 else dt\n    path = [list(pose0)]\n"
        "    for v, w, t in zip(velocity, yaw_rate, dts):\n        x, y, h = path[-1]\n        path.append([x + v * np.cos(h) * t, y + v * np.sin(h) * t, h + w * t])\n    return path"
    ),
    ("cumulative sums", "dead_reckoning"): (
        "def dead_reckoning(velocity, yaw_rate, dt, pose0):\n    x0, y0, h0 = pose0\n    v, w = np.asarray(velocity, float), np.asarray(yaw_rate, float)\n"
        "    h = h0 + np.r_[0.0, np.cumsum(w * dt)]\n    x = x0 + np.r_[0.0, np.cumsum(v * np.cos(h[:-1]) * dt)]\n"
        "    y = y0 + np.r_[0.0, np.cumsum(v * np.sin(h[:-1]) * dt)]\n    return np.c_[x, y, h]"
    ),
    ("recursion", "dead_reckoning"): (
        "import sys\nsys.setrecursionlimit(20000)\ndef dead_reckoning(velocity, yaw_rate, dt, pose0):\n    dts = np.broadcast_to(dt, np.shape(velocity))\n"
        "    def rest(k, pose):\n        if k == len(velocity):\n            return [pose]\n        x, y, h = pose\n        step = velocity[k] * dts[k]\n"
        "        return [pose] + rest(k + 1, (x + step * np.cos(h), y + step * np.sin(h), h + yaw_rate[k] * dts[k]))\n    return np.array(rest(0, tuple(pose0)))"
    ),
    ("generator", "dead_reckoning"): (
        "from itertools import accumulate\ndef dead_reckoning(velocity, yaw_rate, dt, pose0):\n    dts = np.broadcast_to(dt, np.shape(velocity))\n"
        "    steps = zip(velocity, yaw_rate, dts)\n    move = lambda p, s: (p[0] + s[0] * s[2] * np.cos(p[2]), p[1] + s[0] * s[2] * np.sin(p[2]), p[2] + s[1] * s[2])\n"
        "    return np.array(list(accumulate(steps, move, initial=tuple(pose0))))"
    ),
    ("a cumulative product", "dead_reckoning"): (
        "def dead_reckoning(velocity, yaw_rate, dt, pose0):\n    turn = np.asarray(yaw_rate) * dt\n    h = np.concatenate(([pose0[2]], pose0[2] + np.cumsum(turn)))\n"
        "    z = complex(*pose0[:2]) + np.concatenate(([0], np.cumsum(np.asarray(velocity) * dt * np.exp(1j * h[:-1]))))\n    return np.stack([z.real, z.imag, h], axis=1)"
    ),
    ("SymPy", "q1_symbolic"): (
        "def q1_symbolic(x1, y1, theta1, u, v, phi):\n    R = sp.Matrix([[sp.cos(theta1), -sp.sin(theta1), 0], [sp.sin(theta1), sp.cos(theta1), 0], [0, 0, 1]])\n"
        "    return tuple(sp.Matrix([x1, y1, theta1]) + R * sp.Matrix([u, v, phi]))"
    ),
    ("a list", "q1_symbolic"): (
        "def q1_symbolic(x1, y1, theta1, u, v, phi):\n    c, s = sp.cos(theta1), sp.sin(theta1)\n    return [x1 + u * c - v * s, y1 + u * s + v * c, theta1 + phi]"
    ),
    ("a matrix", "q1_symbolic"): (
        "from sympy import *\ndef q1_symbolic(x1, y1, theta1, u, v, phi):\n"
        "    return Matrix([x1 + u*cos(theta1) - v*sin(theta1), y1 + u*sin(theta1) + v*cos(theta1), theta1 + phi])"
    ),
    ("expanded", "q1_symbolic"): (
        "def q1_symbolic(x1, y1, theta1, u, v, phi):\n    z = sp.expand((u + sp.I * v) * (sp.cos(theta1) + sp.I * sp.sin(theta1)))\n"
        "    return x1 + u * sp.cos(theta1) - v * sp.sin(theta1), y1 + sp.simplify(u * sp.sin(theta1) + v * sp.cos(theta1)), sp.Add(theta1, phi)"
    ),
}


def packed():
    """The odd answers in as few notebooks as they fit, by student; and in whose notebook each one is."""
    notebooks, place = [], {}
    for (style, exercise), source in STYLES.items():
        number = sum(1 for _, other in place if other == exercise)
        if number == len(notebooks):
            notebooks.append({})
        notebooks[number][exercise] = source
        place[style, exercise] = f"style-{number}"
    return {f"style-{number}": chosen for number, chosen in enumerate(notebooks)}, place


PACKED, PLACE = packed()


def in_style(chosen):
    return reduce(lambda made, name: with_answer(made, name, chosen[name]), chosen, bare(solved()))


@LINEUP.called({student: lambda chosen=chosen: in_style(chosen) for student, chosen in PACKED.items()})
def test_right_answers_of_many_styles_have_all_points(outcome):
    outcome.assert_earns(*EXERCISES)


@pytest.mark.parametrize(
    ("style", "exercise", "outcome"),
    [(*key, student) for key, student in PLACE.items()],
    ids=[f"{exercise}, {style}" for style, exercise in STYLES],
    indirect=["outcome"],
)
def test_a_right_answer_in_any_style_has_all_points(outcome, style, exercise):
    assert outcome.earned.get(exercise) == 5.0, outcome.messages[EXERCISES.index(exercise)]


# what is wrong or missing costs just that


def wrong(exercise, source):
    return with_answer(bare(solved()), exercise, source)


PARTS = {
    "one stub left": (
        lambda: with_answer(bare(solved()), "displacement", graded_cell(answered(), "displacement")["source"]),
        "displacement",
    ),
    "one answer wrong": (
        lambda: wrong("displacement", "def displacement(v, w, dt):\n    return np.array([v + 7, 9.0, w - 3])"),
        "displacement",
    ),
    "one answer fails": (lambda: wrong("displacement", "def displacement(v, w, dt):\n    return v / 0"), "displacement"),
    "one answer empty": (lambda: wrong("displacement", ""), "displacement"),
    "one answer cannot be read": (lambda: wrong("displacement", "def displacement(v, w, dt)\n    return"), "displacement"),
    "one answer never ends": (lambda: wrong("displacement", "def displacement(v, w, dt):\n    while True: pass"), "displacement"),
    "one answer exits": (lambda: wrong("displacement", "def displacement(v, w, dt):\n    raise SystemExit"), "displacement"),
    "one cell never ends": (lambda: wrong("displacement", "while True: pass"), "displacement"),
    "one answer prints instead": (
        lambda: wrong("displacement", "def displacement(v, w, dt):\n    print(v * dt, 0, w * dt)"),
        "displacement",
    ),
    "one cell deleted": (lambda: without_cells("displacement"), "displacement"),
}


@LINEUP.hands_in({name: maker for name, (maker, _) in PARTS.items()})
def test_what_is_wrong_costs_no_more_than_its_own_points(outcome):
    outcome.assert_earns(*[name for name in EXERCISES if name != "displacement"])


# beside stock nbgrader

#: where it is fair: nothing is missing, nothing is partly right, nobody writes to standard error
BY_STOCK = ("style-0", "style-1", "parts")


@pytest.fixture(scope="module")
def beside_stock(tmp_path_factory, root):
    """(a class that we have graded, the points by student and exercise that stock nbgrader gives the same class)."""
    room = Classroom(tmp_path_factory.mktemp("beside") / "course")
    for student in BY_STOCK[:2]:
        quiet = {name: source for name, source in PACKED[student].items() if "warn" not in source and "stderr" not in source}
        room.hand_in(student, in_style(quiet))
    room.hand_in("parts", PARTS["one answer wrong"][0]())
    room.hand_in("zz-honest", bare(solved()))
    room.grade()
    copy = tmp_path_factory.mktemp("stock") / "course"
    shutil.copytree(room.root, copy, ignore=shutil.ignore_patterns("autograded", "zz-honest"))
    _forget(copy)
    programs = Path(sys.executable).parent
    environment = {**os.environ, "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}", "PYTHONPATH": str(root)}
    run = subprocess.run(
        ["nbgrader", "autograde", ASSIGNMENT], cwd=copy, env=environment, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stdout + run.stderr
    return Graded(room, frozenset(BY_STOCK)), Graded(Classroom.at(copy), frozenset(BY_STOCK)).book


def _forget(root):
    """Leave the cells of the assignment in a gradebook, and no student."""
    from nbgrader.api import Gradebook

    with Gradebook(f"sqlite:///{root}/gradebook.db", "dead-reckoning") as gradebook:
        for student in gradebook.students:
            gradebook.remove_student(student.id)


@pytest.mark.slow
@pytest.mark.parametrize("student", BY_STOCK)
def test_stock_nbgrader_gives_the_same_where_it_is_fair(beside_stock, student):
    ours, stock = beside_stock
    scores = ours.room.scores(student)
    assert {name: stock[student, name][0] for name in EXERCISES} == scores
    assert sum(scores.values()) == (35.0 if student == "parts" else 40.0)
    assert Outcome(ours, "zz-honest").earned == dict.fromkeys(EXERCISES, 5.0)
