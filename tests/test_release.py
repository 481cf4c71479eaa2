"""What students get holds no solution, no reference and no hidden module: compared by runs of tokens."""

import ast
import io
import json
import re
import tokenize
from collections.abc import Iterator
from pathlib import Path

import jupytext
import pytest

from autograder import exercises
from autograder.reference import NOTEBOOKS, WRITTEN

ROOT = Path(__file__).resolve().parents[1]
#: so many equal tokens in a row are no accident; shorter runs are idioms such as np.array([x, y, theta])
RUN = 16
_SKIPPED = {
    tokenize.COMMENT,
    tokenize.NL,
    tokenize.NEWLINE,
    tokenize.INDENT,
    tokenize.DEDENT,
    tokenize.ENCODING,
    tokenize.ENDMARKER,
}


def tokens(code: str) -> list[str]:
    """Return the tokens of Python code without comments, strings and layout."""
    found = []
    try:
        for token in tokenize.generate_tokens(io.StringIO(code).readline):
            if token.type not in _SKIPPED and token.type != tokenize.STRING:
                found.append(token.string)
    except (tokenize.TokenError, IndentationError):
        pass
    return found


def runs(code: str) -> set[tuple[str, ...]]:
    found = tokens(code)
    return {tuple(found[start : start + RUN]) for start in range(len(found) - RUN + 1)}


def released_code() -> Iterator[tuple[str, str]]:
    for path in sorted(ROOT.glob("release/*/*/*.ipynb")):
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        yield str(path.relative_to(ROOT)), "\n\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")
    for path in sorted(ROOT.glob("course/**/*.py")):
        yield str(path.relative_to(ROOT)), path.read_text(encoding="utf-8")


def solutions() -> dict[str, str]:
    found = {}
    for notebook in NOTEBOOKS:
        for cell in jupytext.read(ROOT / "source" / f"{notebook}.md").cells:
            region = re.search(r"### BEGIN SOLUTION\n((.|\n)*?)\n *### END SOLUTION", cell.source)
            if region and "exercise" in cell.metadata:
                found[cell.metadata["exercise"]] = region.group(1)
    return found


def references() -> dict[str, str]:
    """The functions of the hidden module by exercise: right rules and the drawing of cases.

    Wrong rules are no secret: the notebooks show some of them, for the reader to find the error.
    """
    found = {}
    for exercise in exercises():
        wrong = set(exercise.misconceptions)
        folder = ROOT / "autograder/reference" / exercise.notebook.rpartition("/")[2]
        tree = ast.parse((folder / f"{exercise.name}.py").read_text(encoding="utf-8"))
        hidden = [node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name not in wrong]
        found[exercise.name] = "\n".join(ast.unparse(node) for node in hidden)
    return found


@pytest.fixture(scope="module")
def visible() -> dict[tuple[str, ...], str]:
    return {run: place for place, code in released_code() for run in runs(code)}


def test_both_editions_are_released():
    for notebook in NOTEBOOKS:
        for language in ("en", "ja"):
            assert (ROOT / "release" / language / f"{notebook}.ipynb").is_file()


def test_a_leaked_solution_would_be_found():
    solution = "x, y, theta = pose\nreturn np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])"
    assert runs(solution) & runs(f"def some_function(pose, distance, dtheta):\n    {solution.splitlines()[1]}\n")


def test_no_solution_is_released(visible):
    leaks = {name: visible[run] for name, code in solutions().items() for run in runs(code) if run in visible}
    assert leaks == {}


def test_nothing_of_the_hidden_module_is_released(visible):
    leaks = {
        f"{name}: {' '.join(run)}": visible[run] for name, code in references().items() for run in runs(code) if run in visible
    }
    assert leaks == {}


def test_short_solutions_are_not_released_whole():
    """A solution shorter than a run must not stand anywhere as a statement of its own either."""
    visible_lines = {" ".join(tokens(line)) for _, code in released_code() for line in code.splitlines()}
    for name, code in solutions().items():
        returned = [line for line in code.splitlines() if line.strip().startswith("return") and len(tokens(line)) >= 8]
        for line in returned:
            assert " ".join(tokens(line)) not in visible_lines, name


def test_every_exercise_is_a_stub_with_a_locked_check():
    for notebook, names in NOTEBOOKS.items():
        for language in ("en", "ja"):
            cells = json.loads((ROOT / "release" / language / f"{notebook}.ipynb").read_text(encoding="utf-8"))["cells"]
            by_id = {cell["metadata"]["nbgrader"]["grade_id"]: cell for cell in cells if "nbgrader" in cell["metadata"]}
            for name in names:
                assert "raise NotImplementedError()" in "".join(by_id[name]["source"])
                assert "".join(by_id[f"check_{name}"]["source"]) == f'check("{name}")'
                assert by_id[f"check_{name}"]["metadata"]["nbgrader"]["locked"]
            for name in WRITTEN.get(notebook, ()):
                assert "".join(by_id[name]["source"]) == ""
            assert all(not cell.get("outputs") for cell in cells)
            text = json.dumps(cells, ensure_ascii=False)
            assert "BEGIN SOLUTION" not in text
            assert "autograder" not in text
            assert "rubric" not in text.lower()
