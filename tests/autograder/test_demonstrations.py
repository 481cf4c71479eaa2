"""Demonstrations: what they define, and the proof that nothing depends on those that grading leaves out."""

import json
from pathlib import Path

import pytest

from autograder.demonstrations import bound_names, dependents, names_read_first
from autograder.exercise import checked_exercise, trial
from autograder.grading import reply_bytes
from autograder.reference import NOTEBOOKS, exercise_named
from autograder.released import released
from autograder.session import Limits, Session
from tests.classroom import solved

ROOT = Path(__file__).parents[2]

BOUND = {
    "": "",
    "x = 1": "x",
    "x, (y, *z) = 1, (2, 3)": "x y z",
    "x += 1": "x",
    "x: int = 1": "x",
    "x[0] = 1; y.z = 2": "",
    "import numpy as np, os.path": "np os",
    "from math import pi as half, tau": "half tau",
    "def f(a): b = a": "f",
    "class C:\n    inner = 1": "C",
    "for i in range(3): j = i": "i j",
    "with open('a') as file: text = file.read()": "file text",
    "if (n := 10) > 5: big = True": "n big",
    "[k for k in range(3)]": "",
    "try: pass\nexcept OSError as error: failed = 1": "error failed",
    "def f():\n    global g\n    g = 1": "f",
    "del x": "x",
    "match p:\n    case [a, {'k': b}, *c]: pass": "a b c",
}


@pytest.mark.parametrize(("source", "names"), BOUND.items())
def test_the_names_that_a_cell_binds(source, names):
    assert bound_names(source) == frozenset(names.split())


READ = {
    "": "",
    "x": "x",
    "x = 1; x": "",
    "x = x": "x",
    "x += 1": "x",
    "y = x; x = 1": "x",
    "import numpy as np\nnp.pi": "",
    "a.b.c(d)": "a d",
    "def f(a): return a + b": "b",
    "def f(): return b\nb = 1": "b",
    "b = 1\ndef f(): return b": "",
    "def f(a=default): pass": "default",
    "for i in items: print(i)": "items print",
    "for i in [1]: pass\ni": "",
    "with opened(path) as file: file.read()": "opened path",
    "with a as x, x.b as y: y": "a",
    "for i in i: pass": "i",
    "if test: x = 1\nx": "test",
    "[k + n for k in rows]": "n rows",
    "lambda a: a + c": "c",
    "class C:\n    y = z": "z",
    "f'{x!r:{w}}'": "x w",
    "x[i] = 1": "x i",
    "x.y = 1": "x",
    "del x": "x",
    "x = 1; x += 1; del x": "",
    "if test: x += 1": "test x",
    "def f():\n    s = 0\n    s += 1": "",
    "print('x')": "print",
}


@pytest.mark.parametrize(("source", "names"), READ.items())
def test_the_names_that_a_cell_reads_before_it_binds_them(source, names):
    assert names_read_first(source) == frozenset(names.split())


DEPENDENT = {
    "nothing": (["a = 1", "b = 1"], "d.", []),
    "a cell that reads it": (["a = 1", "a"], "d.", [(0, 1, "a")]),
    "a function that reads it": (["a = 1", "def f(): return a"], "d.", [(0, 1, "a")]),
    "another demonstration": (["a = 1", "a"], "dd", [(0, 1, "a")]),
    "two names": (["b = a = 1", "a + b"], "d.", [(0, 1, "a"), (0, 1, "b")]),
    "a cell that counts on": (["a = 1", "a += 1"], "d.", [(0, 1, "a")]),
    "not what comes before": (["a", "a = 1"], ".d", []),
    "not what was there before it and is bound anew": (["a = 1", "a = 2", "a"], "d..", []),
    "what it overwrites": (["a = 1", "a = 2", "a"], ".d.", [(1, 2, "a")]),
    "the last of two": (["a = 1", "a = 2", "a"], "dd.", [(1, 2, "a")]),
    "an import in it": (["import numpy as np", "np.pi"], "d.", [(0, 1, "np")]),
    "its loop variable": (["for k in range(3): print(k)", "k"], "d.", [(0, 1, "k")]),
    "what a cell binds itself first": (["a = 1", "a = 2\nprint(a)"], "d.", []),
    "a name within another scope": (["a = 1", "def f(a): return a"], "d.", []),
    "an attribute of the same name": (["a = 1", "b.a"], "d.", []),
}


@pytest.mark.parametrize(("sources", "kinds", "found"), DEPENDENT.values(), ids=DEPENDENT.keys())
def test_what_depends_on_a_demonstration(sources, kinds, found):
    assert [*dependents(sources, [kind == "d" for kind in kinds])] == found


@pytest.mark.parametrize("language", ["en", "ja"])
@pytest.mark.parametrize("notebook", NOTEBOOKS)
def test_nothing_depends_on_the_demonstrations_of_a_released_notebook(notebook, language):
    release = released((ROOT / f"release/{language}/{notebook}.ipynb").read_bytes())
    code = [cell.source for cell in release.cells if cell.type == "code"]
    assert release.demos
    assert [*dependents(code, [source in release.demos for source in code])] == []


@pytest.mark.parametrize("notebook", NOTEBOOKS)
def test_a_solved_notebook_gives_the_same_with_and_without_its_demonstrations(notebook):
    """The proof by running it: outputs of all other cells, and what every answer replies to the same questions."""
    release = released((ROOT / f"release/en/{notebook}.ipynb").read_bytes())
    cells = [cell for cell in solved("en", notebook.partition("/")[2])["cells"] if cell["cell_type"] == "code"]
    with_demos, demos_shown = run(cells, ())
    without, nothing_shown = run(cells, release.demos)
    assert without == with_demos
    assert demos_shown > nothing_shown == 0
    # each exercise was asked
    assert sum(isinstance(told, bytes) for told in without) == len(NOTEBOOKS[notebook])


def run(cells, left_out):
    """What every cell but the demonstrations tells, and how many outputs the demonstrations have. Counts of cells are left out of it."""
    told, shown = [], 0
    with Session(Limits(), sandbox=False) as session:
        session.run("import random, numpy\nrandom.seed(1); numpy.random.seed(1)")
        for cell in cells:
            ours = cell["metadata"].get("nbgrader", {})
            if "demo" in cell["metadata"].get("tags", []):
                shown += 0 if cell["source"] in left_out else len(session.run(cell["source"]))
            elif ours.get("grade") and ours.get("locked"):
                name = checked_exercise(ours["grade_id"])
                exercise = exercise_named(name)
                questions = trial(exercise, 7).questions if hasattr(exercise, "cases") else []
                told.append(reply_bytes(session.ask(name, questions)))
            else:
                told.append(json.dumps(session.run(cell["source"])))
    return told, shown
