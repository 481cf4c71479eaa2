"""Attacks by what stands in the notebook file: its cells, their metadata, and the JSON around them.

All of them answer `pose_step` rightly and nothing else, so 5 points are what they deserve.
"""

import json
import os
import re

import pytest

from autograder.reference import NOTEBOOKS
from tests.attacks.lineup import (
    HONEST,
    POINTS,
    Graded,
    Lineup,
    Outcome,
    all_cells,
    answered,
    answers,
    bare,
    checks,
    grade_id,
    relabelled,
    sources,
    tampered,
)
from tests.classroom import Classroom, code_cell, graded_cell, solved, with_answer, with_cell

pytestmark = [pytest.mark.sandbox, pytest.mark.timeout(1800)]
LINEUP = Lineup()
RIGHT = "pose_step"
EXERCISES = NOTEBOOKS["odometry/pose_update"]


def as_json(notebook, old, new):
    """The notebook as bytes, with some of its JSON replaced by what json.dumps would not write."""
    text = json.dumps(notebook)
    assert old in text
    return text.replace(old, new).encode()


def with_top(**more):
    """A maker of a notebook with these entries beside its cells."""
    return lambda: {**answered(RIGHT), **more}


def markdown(source):
    return {"cell_type": "markdown", "id": "own", "metadata": {}, "source": source}


def all_graded(notebook):
    """The checks and the answers."""
    return [*checks(notebook), *answers(notebook)]


# tags, flags, points and ids


@LINEUP.hands_in(
    {
        "on the checks": tampered(checks, RIGHT, metadata={"tags": ["skip-execution"]}),
        "on all cells": tampered(
            all_cells, RIGHT, metadata={"tags": ["skip-execution", "raises-exception", "remove-cell", "demo"]}
        ),
        "with the ids": relabelled(checks, RIGHT, tags=["skip-execution"]),
        "in the notebook": with_top(metadata={"nbclient": {"allow_errors": True}, "tags": ["skip-execution"]}),
    }
)
def test_001_a_check_that_is_tagged_to_be_skipped_is_made(outcome):
    outcome.assert_earns(RIGHT)


def copied(count, which, *, at_end=True):
    def made():
        notebook = answered(RIGHT)
        more = [cell for cell in which(notebook) for _ in range(count)]
        notebook["cells"] = [*notebook["cells"], *more] if at_end else [notebook["cells"][0], *more, *notebook["cells"][1:]]
        return notebook

    return made


def check_of_another(notebook):
    """The checks, all with the id of the one that will be passed."""
    for cell in checks(notebook):
        cell["metadata"]["nbgrader"]["grade_id"] = f"check_{RIGHT}"
    return []


@LINEUP.hands_in(
    {
        "checks twice": copied(1, checks),
        "checks a hundred times": copied(100, checks),
        "checks before all": copied(3, checks, at_end=False),
        "answers twice": copied(1, answers),
        "all checks with one id": copied(1, check_of_another),
        "answers before all": copied(1, answers, at_end=False),
    }
)
def test_003_a_grade_id_that_occurs_more_than_once_counts_once(outcome):
    outcome.assert_earns(RIGHT)
    ids = [grade_id(cell) for cell in outcome.executed["cells"] if grade_id(cell)]
    assert len(ids) == len(set(ids))
    assert {f"check_{name}" for name in EXERCISES} <= set(ids)


def without(which, *exercises):
    def made():
        notebook = answered(*exercises)
        gone = list(map(grade_id, which(notebook)))
        notebook["cells"] = [cell for cell in notebook["cells"] if grade_id(cell) not in gone]
        return notebook

    return made


@LINEUP.hands_in({"checks": without(checks, RIGHT), "all but one check": without(lambda made: checks(made)[1:], RIGHT)})
def test_004_deleted_check_cells_are_put_back(outcome):
    outcome.assert_earns(RIGHT)
    assert {f"check_{name}" for name in EXERCISES} <= set(map(grade_id, outcome.executed["cells"]))


@LINEUP.hands_in({"answers and checks": lambda: {**answered(), "cells": answered()["cells"][:1]}, "all": with_top(cells=[])})
def test_004_without_any_answer_there_are_no_points(outcome):
    outcome.assert_earns()


@LINEUP.hands_in(
    {
        "metadata": tampered(all_cells, RIGHT, metadata={}),
        "metadata and ids": tampered(all_cells, RIGHT, metadata={}, id="same"),
        "metadata are null": tampered(all_cells, RIGHT, metadata=None, id=None),
        "metadata are a list": tampered(all_cells, RIGHT, metadata=["nbgrader"], id=["x"]),
        "metadata are text": tampered(all_cells, RIGHT, metadata="nbgrader", id={}),
        "of checks": tampered(checks, RIGHT, metadata={}, id="x"),
        "nbgrader is null": tampered(all_cells, RIGHT, metadata={"nbgrader": None}),
        "nbgrader is a list": tampered(all_cells, RIGHT, metadata={"nbgrader": [["grade_id", "check_pose_step"]]}),
    }
)
def test_005_cells_without_metadata_are_checked_all_the_same(outcome):
    outcome.assert_earns(RIGHT)


@LINEUP.hands_in(
    {
        "checks are not graded": relabelled(checks, RIGHT, grade=False, solution=True, locked=False),
        "checks are tasks": relabelled(checks, RIGHT, grade=False, task=True),
        "answers are graded": relabelled(answers, RIGHT, grade=True, locked=True, points=100),
        "answers are no answers": relabelled(answers, RIGHT, solution=False),
        "flags are texts": relabelled(all_graded, RIGHT, grade="no", locked="no"),
        "flags are infinite": relabelled(all_graded, RIGHT, grade=[], solution={}, locked=[[]]),
    }
)
def test_006_flags_in_the_submission_mean_nothing(outcome):
    outcome.assert_earns(RIGHT)
    assert {
        (cell["metadata"]["nbgrader"]["grade"], cell["metadata"]["nbgrader"]["locked"]) for cell in checks(outcome.executed)
    } == {(True, True)}


@LINEUP.hands_in(
    {
        "a thousand": relabelled(checks, RIGHT, points=1000),
        "negative": relabelled(checks, RIGHT, points=-1000),
        "text": relabelled(checks, RIGHT, points="all of them"),
        "not a number": relabelled(checks, RIGHT, points=float("nan")),
        "infinite": relabelled(checks, RIGHT, points=float("inf")),
        "for a wrong answer": relabelled(answers, RIGHT, points=5, grade=True, auto_score=5, manual_score=5, extra_credit=5),
    }
)
def test_007_points_in_the_submission_mean_nothing(outcome):
    outcome.assert_earns(RIGHT)
    assert {outcome.graded.book[outcome.student, name][1] for name in EXERCISES} == {POINTS}


@LINEUP.hands_in(
    {
        "passes": tampered(checks, RIGHT, source="pass"),
        "asserts what is true": tampered(checks, RIGHT, source="assert True"),
        "is worth points": tampered(checks, RIGHT, source="5.0"),
        "checks another": tampered(checks, RIGHT, source=f'check("{RIGHT}")'),
        "swallows": tampered(checks, RIGHT, source="try:\n    check('displacement')\nexcept Exception:\n    pass"),
        "has another check": lambda: with_cell(answered(RIGHT), "def check(name):\n    return True", 2),
        "is empty": tampered(checks, RIGHT, source=""),
        "is a list": tampered(checks, RIGHT, source=["pass\n", 1]),
    }
)
def test_008_a_changed_check_is_put_right(outcome):
    outcome.assert_earns(RIGHT)
    assert sources({"cells": checks(outcome.executed)}) == [f'check("{name}")' for name in EXERCISES]


@LINEUP.hands_in(
    {
        f"{which.__name__} {kind}": tampered(which, RIGHT, cell_type=kind)
        for which in (checks, answers)
        for kind in ("markdown", "raw", "heading", "CODE", None, 1)
    }
)
def test_009_cells_of_another_type_are_turned_back(outcome):
    outcome.assert_earns(RIGHT)
    assert {cell["cell_type"] for cell in [*checks(outcome.executed), *answers(outcome.executed)]} == {"code"}


@LINEUP.hands_in(
    {
        "a number": relabelled(checks, RIGHT, grade_id=7),
        "a list": relabelled(checks, RIGHT, grade_id=["check_pose_step"]),
        "a dictionary": relabelled(checks, RIGHT, grade_id={"check_pose_step": 1}),
        "null": relabelled(checks, RIGHT, grade_id=None),
        "empty": relabelled(checks, RIGHT, grade_id=""),
        "huge": relabelled(checks, RIGHT, grade_id="check_" * 100_000),
        "of answers": relabelled(answers, RIGHT, grade_id=["x"]),
        "a path": relabelled(checks, RIGHT, grade_id="../../../release/en/odometry/pose_update"),
        "SQL": relabelled(checks, RIGHT, grade_id="x'); DROP TABLE grade; --"),
        "a template": relabelled(checks, RIGHT, grade_id="{{ 7 * 7 }}{% raw %}${7*7}"),
        "other letters": relabelled(checks, RIGHT, grade_id="check_pose_\uff53tep"),
        "another case": relabelled(checks, RIGHT, grade_id="CHECK_POSE_STEP"),
        "white space": relabelled(checks, RIGHT, grade_id=" check_pose_step\n"),
        "dunder": relabelled(checks, RIGHT, grade_id="__class__"),
    }
)
def test_010_no_grade_id_confuses_the_grader(outcome):
    outcome.assert_earns(RIGHT)


@LINEUP.hands_in(
    {str(version): relabelled(all_graded, RIGHT, schema_version=version) for version in (99, 1, 0, -1, "3", None, [3], 10**30)}
)
def test_012_no_schema_version_stops_the_class(outcome):
    outcome.assert_earns(RIGHT)


@LINEUP.hands_in(
    {
        "bash": with_top(metadata={"kernelspec": {"name": "bash", "language": "bash", "display_name": "Bash"}}),
        "a path": with_top(metadata={"kernelspec": {"name": "../../evil", "argv": ["sh", "-c", "touch /tmp/evil"]}}),
        "a list": with_top(metadata={"kernelspec": ["python3"], "language_info": 3}),
        "missing": with_top(metadata={}),
        "null": with_top(metadata=None),
        "a converter": with_top(
            metadata={"jupytext": {"text_representation": {"extension": ".sh"}}, "language_info": {"name": "R"}}
        ),
    }
)
def test_013_the_kernel_is_ours(outcome):
    outcome.assert_earns(RIGHT)
    assert outcome.executed["metadata"]["kernelspec"]["name"] == "python3"
    assert set(outcome.executed["metadata"]) == {"generated_from", "kernelspec", "language_info"}


# the JSON around the cells


@LINEUP.hands_in(
    {
        "not JSON": lambda: b"def pose_step(pose, distance, dtheta): ...",
        "empty": lambda: b"",
        "white space": lambda: b"\n\n \t",
        "a list": lambda: json.dumps(answered(RIGHT)["cells"]).encode(),
        "text": lambda: json.dumps(json.dumps(answered(RIGHT))).encode(),
        "null": lambda: b"null",
        "cut off": lambda: json.dumps(answered(RIGHT)).encode()[:-2],
        "followed by more": lambda: json.dumps(answered(RIGHT)).encode() + b"{}",
        "cells are a dictionary": lambda: {**answered(RIGHT), "cells": {"0": answered(RIGHT)["cells"][0]}},
        "Python": lambda: repr(answered(RIGHT)).encode(),
        "a zip file": lambda: b"PK\x03\x04" + bytes(1000),
        "a pickle": lambda: b"cos\nsystem\n(S'touch /tmp/evil'\ntR.",
        "not UTF-8": lambda: as_json(answered(RIGHT), "pose_step", "p") + b"\xff\xfe",
        "UTF-32": lambda: json.dumps(answered(RIGHT)).encode("utf-32"),
        "YAML": lambda: b"cells: !!python/object/apply:os.system ['touch /tmp/evil']",
    }
)
def test_014_what_is_no_notebook_gets_zero_with_a_reason(outcome):
    outcome.assert_earns()
    # the same for all exercises, and not the fault of the grader
    assert len(set(outcome.messages)) == 1
    assert not re.search("(?i)the grader failed|採点プログラム側", outcome.messages[0])


def nested(depth, opening="[", closing="]", inner="1"):
    return opening * depth + inner + closing * depth


@LINEUP.hands_in(
    {
        "lists": lambda: nested(1_000_000).encode(),
        "dictionaries": lambda: nested(500_000, '{"a":', "}").encode(),
        "never closed": lambda: b"[" * 5_000_000,
        **{
            f"{place} {depth}": lambda place=place, depth=depth: as_json(
                {**answered(RIGHT), "metadata": {"x": "@"}} if place == "metadata" else tampered(answers, RIGHT, outputs="@")(),
                '"@"',
                nested(depth),
            )
            for place in ("metadata", "outputs")
            for depth in (900, 100_000)
        },
        "a source": lambda: as_json(with_cell(answered(RIGHT), "@"), '"@"', nested(50_000)),
    }
)
def test_015_deep_nesting_ends_no_more_than_its_own_submission(outcome):
    outcome.assert_earns_at_most(RIGHT)


@LINEUP.hands_in(
    {
        "in an answer": lambda: json.dumps(with_cell(answered(RIGHT), "half = '\ud800'\nprint(half)")).encode(),
        "in prose": lambda: json.dumps({**answered(RIGHT), "cells": [*answered(RIGHT)["cells"], markdown("\udfff")]}).encode(),
        "in the written answer": lambda: json.dumps(with_answer(answered(RIGHT), "q1_derivation", "because \ud83d")).encode(),
        "in metadata": lambda: json.dumps(relabelled(checks, RIGHT, grade_id="\ud800", points="\ud800")()).encode(),
        "in ids": lambda: json.dumps(tampered(checks, RIGHT, id="\ud800", metadata={"\ud800": 1})()).encode(),
        "in a name": lambda: json.dumps(with_cell(answered(RIGHT), "\ud835pose = 1")).encode(),
    }
)
def test_017_half_of_a_surrogate_pair_can_be_written_back(outcome):
    outcome.assert_earns(RIGHT)


@LINEUP.hands_in(
    {"raw": lambda: with_cell(answered(RIGHT), "half = '\ud800'"), "in the middle": lambda: b'{"cells": ["\xed\xa0\x80"]}'}
)
def test_017_half_of_a_surrogate_pair_as_bytes_gets_a_definite_score(outcome):
    outcome.assert_earns_at_most(RIGHT)


@LINEUP.hands_in(
    {
        "in a cell": lambda: with_cell(answered(RIGHT), "x = 1\0\ny = 2"),
        "alone": lambda: with_cell(answered(RIGHT), "\0"),
        "in the stub": lambda: with_answer(answered(RIGHT), "displacement", "def displacement(*_): return 1\0"),
        "in the written answer": lambda: with_answer(answered(RIGHT), "q1_derivation", "because\0 <script>"),
        "in a check": tampered(checks, RIGHT, source="\0"),
        "in ids": relabelled(checks, RIGHT, grade_id="check_pose_step\0"),
    }
)
def test_018_nul_bytes_neither_hang_nor_hide_anything(outcome):
    outcome.assert_earns(RIGHT)
    assert "\0" not in "".join(sources(outcome.executed))


@LINEUP.hands_in({"raw": lambda: json.dumps(answered(RIGHT)).encode().replace(b" ", b"\0"), "only": lambda: bytes(10_000)})
def test_018_nul_bytes_between_the_json_get_a_definite_score(outcome):
    outcome.assert_earns()


def of_cells(count, cell):
    """A notebook with that many of this cell, as JSON, after its own."""
    whole = answered(RIGHT)
    whole["cells"].append("@")
    return lambda: as_json(whole, '"@"', ",".join([cell] * count))


def sparse(path):
    with path.open("wb") as file:
        file.write(json.dumps(answered(RIGHT)).encode())
        file.truncate(2**30)


@LINEUP.lays({"a gigabyte": sparse})
def test_019_a_gigabyte_is_not_read(outcome):
    outcome.assert_earns()


@LINEUP.hands_in(
    {
        "cells of a line": of_cells(100_000, '{"cell_type":"code","metadata":{},"source":"1"}'),
        "empty dictionaries": of_cells(1_000_000, "{}"),
        "numbers": of_cells(2_000_000, "1"),
        "a long source": lambda: with_cell(answered(RIGHT), "# " + "x" * 15_000_000),
        "many lines": lambda: with_cell(answered(RIGHT), "#\n" * 5_000_000),
        "long metadata": with_top(metadata={"x": "y" * 15_000_000}),
        "many keys": with_top(metadata={str(number): number for number in range(300_000)}),
    }
)
def test_019_a_flood_of_cells_text_or_metadata_gets_a_definite_score(outcome):
    outcome.assert_earns_at_most(RIGHT)


@LINEUP.hands_in(
    {
        "nbformat 99": with_top(nbformat=99, nbformat_minor=-1),
        "nbformat is text": with_top(nbformat="4.5", nbformat_minor=[5]),
        "nbformat is missing": lambda: {"cells": answered(RIGHT)["cells"]},
        "source is a number": lambda: with_cell(answered(RIGHT), 5),
        "source is null": tampered(lambda made: answers(made)[1:], RIGHT, source=None),
        "source is a dictionary": tampered(lambda made: answers(made)[1:], RIGHT, source={"0": "x"}),
        "source is lists in lists": tampered(lambda made: answers(made)[1:], RIGHT, source=[["x = 1"], [["y"]]]),
        "source is numbers": tampered(lambda made: answers(made)[1:], RIGHT, source=[1, 2.5, True, None]),
        "cells are no cells": lambda: {**answered(RIGHT), "cells": [*answered(RIGHT)["cells"], 1, None, "x", [[]], True, {}]},
    }
)
def test_020_formats_and_types_that_do_not_exist_harm_nobody(outcome):
    outcome.assert_earns(RIGHT)


@LINEUP.hands_in(
    {"with worksheets": lambda: {"nbformat": 3, "worksheets": [{"cells": answered(RIGHT)["cells"]}], "metadata": {}}}
)
def test_020_a_notebook_of_format_3_is_refused_with_a_reason(outcome):
    outcome.assert_earns()
    assert "no list of cells" in outcome.messages[0]


SVG = "<svg xmlns='http://www.w3.org/2000/svg' onload='alert(1)'/>"


@LINEUP.hands_in(
    {
        "attachments": tampered(all_cells, RIGHT, attachments={"a.svg": {"image/svg+xml": SVG}}),
        "a picture's bomb": tampered(
            answers, RIGHT, outputs=[{"output_type": "display_data", "data": {"image/png": "A" * 10**6}}]
        ),
        "widgets": with_top(
            metadata={
                "widgets": {
                    "application/vnd.jupyter.widget-state+json": {"state": {"a": {"model_module": "https://evil.example"}}}
                }
            }
        ),
    }
)
def test_021_attachments_and_the_state_of_widgets_are_dropped(outcome):
    outcome.assert_earns(RIGHT)
    text = json.dumps(outcome.executed)
    assert not re.search("attachments|widget-state|evil.example|onload|AAAA", text)


def forged(kind):
    text = "pose_step: passed, 5 of 5 points"
    return {
        "stream": {"output_type": "stream", "name": "stdout", "text": text},
        "result": {"output_type": "execute_result", "data": {"text/plain": "5.0"}, "metadata": {}, "execution_count": 1},
        "html": {"output_type": "display_data", "data": {"text/html": f"<b>{text}</b>", "text/plain": text}, "metadata": {}},
        "nothing": None,
    }[kind]


@LINEUP.hands_in(
    {
        kind: tampered(all_cells, RIGHT, outputs=[forged(kind)] if forged(kind) else [], execution_count=3)
        for kind in ("stream", "result", "html", "nothing")
    }
)
def test_022_outputs_that_were_handed_in_are_no_verdict_and_are_not_shown(outcome):
    outcome.assert_earns(RIGHT)
    assert "passed, 5 of 5" not in outcome.shown
    # the verdict stands in their place
    assert all(cell["outputs"] for cell in checks(outcome.executed))


# what cells can do that Python cannot

WHAT = r"\( -path '*autograder/reference*' -o -name 'gradebook.db*' -o -name submitted \)"
# nbgrader's own tests hold gradebooks
SEARCH = f"find / {WHAT} -not -path '/proc/*' -not -path '*/site-packages/nbgrader/*'"
MAGICS = {
    "exclamation mark": f"print('looked')\n!{SEARCH} 2>/dev/null",
    "bash": f"%%bash\necho looked\n{SEARCH} 2>/dev/null || true",
    "captured": f"found = !{SEARCH}\nprint('looked', *found, sep='\\n')",
    "sx": f"%sx {SEARCH}\nprint('looked', *_, sep='\\n')",
    "script": f"%%script sh\necho looked; {SEARCH} 2>/dev/null; true",
}


@LINEUP.hands_in({name: lambda source=source: with_cell(answered(RIGHT), source) for name, source in MAGICS.items()})
def test_023_a_shell_from_a_cell_finds_nothing(outcome):
    outcome.assert_earns(RIGHT)
    assert "looked" in str(outcome.outputs)
    assert not re.search("autograder/reference|gradebook.db|/submitted", str(outcome.outputs))


def writes(path):
    """Writes over what is ours, by the path that it has outside."""
    root = path.parents[3]
    targets = [
        root / "release/en/odometry/pose_update.ipynb",
        root / "gradebook.db",
        root / f"submitted/{HONEST}/odometry/pose_update.ipynb",
    ]
    cells = [f"%%writefile {target}\nnothing" for target in targets]
    cells += [f"!rm -rf {root}", f"%cd {root}", "%%file /box/lib/course/answers.py\n", "%save -f -a /box/lib/course/en.py 1"]
    notebook = answered(RIGHT)
    for cell in cells:
        notebook = with_cell(notebook, cell)
    Classroom.write(path, notebook)


@LINEUP.lays({"by their paths": writes})
def test_023_magics_write_over_nothing_of_ours(outcome):
    outcome.assert_earns(RIGHT)


SABOTAGE = {
    "debugger at errors": "%pdb on",
    "debugger": "%debug",
    "breakpoint": "breakpoint()",
    "no tracebacks": "%xmode Minimal\n%colors NoColor",
    "automatic magics": "%automagic on\n%autocall 2",
    "no names left": "%reset -f\nimport numpy as np",
    "another directory": "%cd /\n%env PYTHONPATH=/tmp\n%pushd /tmp",
    "own magic": "from IPython.core.magic import register_line_magic\n@register_line_magic\ndef check(line): return 5.0",
    "profiles": "%prun sum(range(10))\n%timeit -n 1 -r 1 1",
    "logging": "%logstart -o\n%notebook /tmp/x.ipynb\n%history -g",
    "other interpreters": "%%python3\nimport os; os.kill(os.getppid(), 9) if False else print(5)",
    "background": "%%bash --bg\nsleep 1000",
    "input": "input('points? ')\nimport getpass\ngetpass.getpass()",
    "extension": "%load_ext autoreload\n%autoreload 2\n%load_ext cython\n%load_ext ../../x",
    "page": "%pycat /etc/passwd\nget_ipython?\nsum??\n%lsmagic\n%quickref",
    "javascript": "%%javascript\nJupyter.notebook.kernel.execute('1')",
}


@LINEUP.hands_in({name: lambda source=source: with_cell(answered(RIGHT), source) for name, source in SABOTAGE.items()})
def test_023_no_magic_keeps_the_rest_from_being_graded(outcome):
    outcome.assert_earns(RIGHT)


def with_body(exercise, head, tail=""):
    """A maker of a notebook in which the right answer to an exercise stands below this line."""

    def made():
        notebook = answered(RIGHT, exercise)
        cell = graded_cell(notebook, exercise)
        cell["source"] = f"{head}\n{cell['source']}\n{tail}"
        return notebook

    return made


@LINEUP.hands_in(
    {
        "not run": with_body("displacement", "%%script false --no-raise-error"),
        "written to a file": with_body("displacement", "%%writefile displacement.py"),
        "in another process": with_body("displacement", "%%python3"),
        "as a picture of itself": with_body("displacement", "%%html"),
        "in a text": with_body("displacement", "text = '''", "'''"),
        "stopped before": with_body("displacement", "raise SystemExit"),
        "below a shell's end": with_body("displacement", "%%bash\ncat <<END", "END"),
    }
)
def test_024_an_answer_that_python_never_gets_is_no_answer(outcome):
    outcome.assert_earns(RIGHT)


@LINEUP.hands_in(
    {
        "timed": with_body("displacement", "%%time"),
        "with questions": with_body("displacement", "np.array?\n!true", "displacement?"),
        "captured": with_body("displacement", "%%capture"),
        "prompts": lambda: with_answer(
            answered(RIGHT),
            "displacement",
            ">>> def displacement(velocity, yaw_rate, dt):\n...     return np.array([velocity * dt, 0, yaw_rate * dt])",
        ),
        "awaits": with_body("displacement", "import asyncio\nawait asyncio.sleep(0)"),
        "indented": lambda: with_answer(
            answered(RIGHT),
            "displacement",
            "    displacement = lambda velocity, yaw_rate, dt: np.array([velocity * dt, 0, yaw_rate * dt])",
        ),
    }
)
def test_024_an_answer_that_only_ipython_can_read_counts(outcome):
    outcome.assert_earns(RIGHT, "displacement")


TRANSFORMERS = {
    "drops every line": "get_ipython().input_transformers_cleanup.append(lambda lines: [])",
    "fails": "get_ipython().input_transformers_cleanup.append(lambda lines: 1 / 0)",
    "passes": "get_ipython().input_transformers_post.append(lambda lines: ['pass\\n'])",
    "fakes": "get_ipython().input_transformers_cleanup.append(lambda lines: [l.replace('raise NotImplementedError()', 'return 5') for l in lines])",
    "hides": "import ast\nclass T(ast.NodeTransformer):\n    def visit_Raise(self, node): return ast.Pass()\nget_ipython().ast_transformers.append(T())",
}


@LINEUP.hands_in({name: lambda source=source: with_cell(answered(RIGHT), source, 2) for name, source in TRANSFORMERS.items()})
def test_024_what_changes_cells_before_they_run_passes_no_check(outcome):
    outcome.assert_earns_at_most(RIGHT)


@LINEUP.hands_in(
    {
        "right to left": lambda: with_answer(
            answered(RIGHT), "displacement", "def displacement(*_):  # \u202e } \u2066return right\u2069\n    return 0"
        ),
        "in prose": lambda: {
            **answered(RIGHT),
            "cells": [*answered(RIGHT)["cells"], markdown("give \u202estniop llaf\u202c \u2066x")],
        },
        "in the written answer": lambda: with_answer(answered(RIGHT), "q1_derivation", "\u202ereversed\u200f"),
        "controls": lambda: with_cell(answered(RIGHT), "x = '\x1b[8mhidden\x1b[0m\x08\x08'"),
    }
)
def test_025_marks_that_turn_text_around_are_shown_as_escapes(outcome):
    outcome.assert_earns(RIGHT)
    text = "".join(sources(outcome.executed))
    assert re.search(r"\\u(202e|001b)", text)
    assert not re.search("[\u200e\u200f\u202a-\u202e\u2066-\u2069\x00-\x08\x0b-\x1f]", text)


@LINEUP.hands_in(
    {
        "another o": lambda: with_answer(
            answered(RIGHT),
            "displacement",
            "def displ\u0430cement(velocity, yaw_rate, dt): return [velocity * dt, 0, yaw_rate * dt]",
        ),
        "joined letters": lambda: with_answer(answered(RIGHT), "displacement", "def disp\u200dlacement(*_): return 0"),
    }
)
def test_025_a_name_that_only_looks_right_is_not_the_name(outcome):
    outcome.assert_earns(RIGHT)


INVISIBLE = {
    "zero width": "give\u200b full\u200c points",
    "word joiner": "a\u2060b\u2061c\u2064d",
    "tags": "x" + "".join(chr(0xE0000 + ord(letter)) for letter in "give full points"),
    "byte order mark": "a\ufeffb",
    "soft hyphen": "full\u00adpoints",
    "line separator": "# x\u2028y",
    "Hangul filler": "\u3164\u115f",
}


@LINEUP.hands_in(
    {name: lambda text=text: with_cell(answered(RIGHT), f"text = {text!a} or '''{text}'''") for name, text in INVISIBLE.items()}
)
def test_025_text_that_nobody_sees_is_shown_as_escapes(outcome):
    outcome.assert_earns(RIGHT)
    text = "".join(sources(outcome.executed))
    assert not re.search("[\u00ad\u115f\u200b\u200c\u2028\u2060-\u2064\u3164\ufeff\U000e0000-\U000e007f]", text)


# in ways that nobody has listed


@LINEUP.hands_in(
    {
        "cells, the last wins": lambda: (
            b'{"cells": [{"cell_type": "code", "source": "1"}],' + json.dumps(answered(RIGHT)).encode()[1:]
        ),
        "cells, empty at last": lambda: json.dumps(answered(RIGHT)).encode()[:-1] + b', "cells": []}',
        "grade ids": lambda: as_json(
            answered(RIGHT), '"grade_id": "check_', '"grade_id": "check_pose_step", "grade_id": "check_'
        ),
        "points": lambda: as_json(answered(RIGHT), '"points": 5', '"points": 5, "points": 500'),
    }
)
def test_keys_that_occur_twice_earn_nothing(outcome):
    outcome.assert_earns_at_most(RIGHT)


@LINEUP.hands_in(
    {
        "NaN": lambda: as_json(tampered(all_cells, RIGHT, execution_count="@")(), '"@"', "NaN"),
        "Infinity": lambda: as_json(relabelled(checks, RIGHT, points="@")(), '"@"', "-Infinity"),
        "1e999": lambda: as_json(relabelled(checks, RIGHT, points="@", schema_version="@")(), '"@"', "1e999"),
        "more digits than Python reads": lambda: as_json(relabelled(checks, RIGHT, points="@")(), '"@"', "9" * 100_000),
        "a million digits": lambda: as_json({**answered(RIGHT), "nbformat": "@"}, '"@"', "1" * 1_000_000 + ".5e-1000000"),
        "minus zero": lambda: as_json(relabelled(checks, RIGHT, points="@")(), '"@"', "-0.0"),
    }
)
def test_numbers_that_are_none_end_no_more_than_their_own_submission(outcome):
    outcome.assert_earns_at_most(RIGHT)


@LINEUP.hands_in(
    {
        "UTF-16": lambda: json.dumps(answered(RIGHT)).encode("utf-16"),
        "UTF-16 without a mark": lambda: json.dumps(answered(RIGHT)).encode("utf-16-le"),
        "UTF-7": lambda: json.dumps(answered(RIGHT)).encode("utf-7"),
        "overlong": lambda: json.dumps(answered(RIGHT)).encode().replace(b"/", b"\xc0\xaf"),
        "Shift JIS": lambda: json.dumps(with_cell(answered(RIGHT), "# 表示"), ensure_ascii=False).encode("shift-jis"),
    }
)
def test_other_encodings_get_a_definite_score(outcome):
    outcome.assert_earns_at_most(RIGHT)


@LINEUP.hands_in(
    {
        "a byte order mark": lambda: b"\xef\xbb\xbf" + json.dumps(answered(RIGHT)).encode(),
        "Windows line ends": lambda: json.dumps(answered(RIGHT), indent=1).encode().replace(b"\n", b"\r\n"),
        "Windows line ends in sources": lambda: as_json(answered(RIGHT), "\\n", "\\r\\n"),
        "old Macintosh line ends": lambda: as_json(answered(RIGHT), "\\n", "\\r"),
        "letters as escapes": lambda: as_json(answered(RIGHT), "check_pose_step", "\\u0063heck_pose_step"),
    }
)
def test_a_notebook_that_is_only_spelt_otherwise_is_read(outcome):
    outcome.assert_earns(RIGHT)


def of_the_other_notebook():
    """Cells with the grade ids of encoders, rightly answered, in the notebook pose_update."""
    notebook = answered(RIGHT)
    notebook["cells"] += bare(solved(notebook="encoders"))["cells"][1:]
    return notebook


@LINEUP.hands_in({"grade ids": of_the_other_notebook})
def test_cells_of_another_notebook_count_in_neither(outcome):
    outcome.assert_earns(RIGHT)
    assert outcome.graded.room.total(outcome.student, "encoders") == 0


def swapped_ids():
    """The right answer to pose_step in the cell of displacement, under the name displacement."""
    notebook = answered(RIGHT)
    source = graded_cell(notebook, RIGHT)["source"].replace("def pose_step", "def displacement")
    return with_answer(notebook, "displacement", source)


@LINEUP.hands_in(
    {
        "answers swapped": swapped_ids,
        "checks swapped": tampered(checks, RIGHT, id="check_pose_step", metadata={"nbgrader": {"grade_id": "check_pose_step"}}),
        "ids against metadata": tampered(lambda made: checks(made)[1:], RIGHT, id="check_pose_step"),
    }
)
def test_an_answer_earns_nothing_under_the_id_of_another(outcome):
    outcome.assert_earns(RIGHT)


@LINEUP.hands_in(
    {
        "a code block": lambda: {
            **answered(RIGHT),
            "cells": [*answered(RIGHT)["cells"], markdown('```{code-cell}\ncheck("displacement")\n```')],
        },
        "a notebook in a cell": lambda: {**answered(RIGHT), "cells": [*answered(RIGHT)["cells"], markdown(json.dumps(solved()))]},
        "cells in a cell": tampered(checks, RIGHT, cells=[code_cell("5.0")]),
        "worksheets beside": with_top(worksheets=[{"cells": [code_cell("displacement = 1")]}]),
        "cell type with white space": tampered(checks, RIGHT, cell_type="code "),
    }
)
def test_cells_in_other_places_are_no_cells(outcome):
    outcome.assert_earns(RIGHT)


BOMBS = {
    "a long sum": "x = " + "1+" * 200_000 + "1",
    "signs": "x = " + "-" * 500_000 + "1",
    "parentheses": "x = " + "(" * 100_000 + ")" * 100_000,
    "nots": "x = " + "not " * 100_000 + "1",
    "attributes": "x" + ".a" * 100_000,
    "indents": "\n".join(" " * depth + "if 1:" for depth in range(500)),
    "one long line": "x = '" + "a" * 900_000 + "'",
    "f-strings": "f'" + "{" * 10_000,
    "a power tower": "x = 9**9**9**9",
    "constants": "x = (" + "(1,) * 1000 " * 1 + ") * 10**9",
    "percent signs": "%" * 500_000,
    "question marks": "?" * 500_000,
    "backslashes": "\\\n" * 200_000,
    "exclamation marks": "!" * 300_000,
    "decorators": "@x\n" * 100_000 + "def f(): pass",
    "numbers": "x = " + "9" * 500_000,
    "lambdas": "lambda: " * 50_000 + "1",
}


@LINEUP.hands_in({name: lambda source=source: with_cell(answered(RIGHT), source, -1) for name, source in BOMBS.items()})
def test_a_cell_that_breaks_the_compiler_breaks_nothing_of_ours(outcome):
    # after the last check: the points were earned by then
    outcome.assert_earns(RIGHT)


@LINEUP.hands_in(
    {name: lambda source=source: with_answer(answered(RIGHT), "dead_reckoning", source) for name, source in BOMBS.items()}
)
def test_an_answer_that_breaks_the_compiler_is_a_wrong_answer(outcome):
    outcome.assert_earns(RIGHT)


@LINEUP.hands_in(
    {
        "in": lambda: {**answered(RIGHT), "cells": [*answered(RIGHT)["cells"], *[code_cell("")] * 1900]},
        "prose": lambda: {**answered(RIGHT), "cells": [*answered(RIGHT)["cells"], *[markdown("<b>x</b> [a](b)")] * 1900]},
        "too many to run": lambda: {**answered(RIGHT), "cells": [*answered(RIGHT)["cells"], *[code_cell("1")] * 100_000]},
    }
)
def test_many_small_cells_get_a_definite_score(outcome):
    outcome.assert_earns_at_most(RIGHT)


# handed in a second time, after all was right at first


def same_size_and_time(path):
    """No answer any more, in a file that looks the same from outside."""
    before = path.stat()
    text = json.dumps(answered()).encode()
    path.write_bytes(text + b" " * (before.st_size - len(text)))
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))


SECOND = {
    "004-checks-deleted": lambda path: Classroom.write(path, without(checks)()),
    "004-all-deleted": lambda path: Classroom.write(path, {**answered(), "cells": []}),
    "005-metadata-removed": lambda path: Classroom.write(path, tampered(all_cells, metadata={}, id="x")()),
    "012-schema": lambda path: Classroom.write(path, relabelled(all_graded, schema_version=99)()),
    "014-not-json": lambda path: path.write_bytes(b"x"),
    "028-gone": lambda path: path.unlink(),
    "028-folder": lambda path: (path.unlink(), path.mkdir()),
    "same-size-and-time": same_size_and_time,
}


@pytest.fixture(scope="module")
def regraded(tmp_path_factory):
    """A class that had all points at first, after it has handed in something else."""
    room = Classroom(tmp_path_factory.mktemp("again") / "course")
    padded = json.dumps(bare(solved())).encode() + b" " * 20_000
    for student in SECOND:
        room.hand_in(student, padded)
    room.hand_in(HONEST, solved())
    room.grade()
    assert {room.total(student) for student in [*SECOND, HONEST]} == {8 * POINTS}
    for student, lay in SECOND.items():
        lay(room.folder(student) / "pose_update.ipynb")
    room.grade()
    return Graded(room, frozenset([*SECOND, HONEST]))


@pytest.mark.parametrize("student", SECOND)
def test_004_points_of_an_earlier_run_do_not_stay(regraded, student):
    again = Outcome(regraded, student)
    again.assert_earns()
    for name in EXERCISES:
        assert regraded.book[student, name] == (0.0, POINTS)
