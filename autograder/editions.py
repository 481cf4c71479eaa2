"""The two editions of a notebook, made from its one source: MyST Markdown with both languages side by side.

Prose comes in pairs of cells, English then Japanese; code is shared. `source_cells` reads a source and refuses one with mistakes;
`edition` makes the instructor's notebook of one language from it, with nbgrader's metadata and without outputs.
"""

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

import jupytext
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from autograder.demonstrations import dependents
from autograder.exercise import check_cell
from autograder.reference import NOTEBOOKS, WRITTEN, exercise_named
from course.language import LANGUAGES

#: as nbgrader.preprocessors.ClearSolutions puts it in place of a solution region
STUB = "# YOUR CODE HERE\nraise NotImplementedError()"
MAX_LINES = 20

_IMPORT = re.compile(r"^from course\.en import (\w+(?:, \w+)*)$", re.MULTILINE)
_MARKER = re.compile(r"\b(BEGIN|END) SOLUTION\b")
_PROSE_KEYS = {"lang", "written", "points", "rubric"}
_CODE_KEYS = {"exercise", "tags"}


class SourceError(ValueError):
    """What is wrong in a source: a line for each mistake, with the file, the cell and what to do."""


def source_cells(text: str, notebook: str) -> list[NotebookNode]:
    """Return the cells of the source of `notebook`, such as odometry/pose_update. Raises SourceError if it has mistakes."""
    if notebook not in NOTEBOOKS:
        raise SourceError(f"source/{notebook}.md: no notebook is called {notebook}; name it in autograder/reference/__init__.py")
    cells: list[NotebookNode] = jupytext.reads(text, fmt="md:myst").cells
    mistakes = [f"source/{notebook}.md, {mistake}" for mistake in _mistakes(cells, notebook)]
    if mistakes:
        raise SourceError("\n".join(mistakes))
    return cells


def edition(cells: Sequence[NotebookNode], notebook: str, language: str) -> NotebookNode:
    """Return the instructor's notebook in `language` ("en" or "ja"), of nbformat 4.5, from the cells of its source."""
    made: list[NotebookNode] = []
    for cell in cells:
        if cell.metadata.get("lang", language) != language:
            continue
        if "rubric" in cell.metadata:
            # it joins the model answer, which nbgrader clears for students whatever its settings
            made[-1].source += f"\n\n---\n\n{cell.source}"
        else:
            made += _made_from(cell, language)
    for position, cell in enumerate(made):
        # random ids would differ from one build to the next
        cell.id = cell.metadata.get("nbgrader", {}).get("grade_id", f"cell-{position}")
    metadata = {
        "generated_from": f"source/{notebook}.md",
        "kernelspec": {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"},
        "language_info": {"name": "python"},
    }
    return new_notebook(nbformat_minor=5, cells=made, metadata=metadata)


def _made_from(cell: NotebookNode, language: str) -> list[NotebookNode]:
    """Return the cells of the edition that one cell of the source becomes."""
    if "written" in cell.metadata:
        manual = _nbgrader(cell.metadata.written, grade=True, solution=True, points=cell.metadata.points)
        return [new_markdown_cell(cell.source, metadata=manual)]
    if cell.cell_type == "markdown":
        return [new_markdown_cell(cell.source)]
    tags = {"tags": list(cell.metadata.tags)} if cell.metadata.get("tags") else {}
    source = _IMPORT.sub(rf"from course.{language} import \1", cell.source)
    if "exercise" not in cell.metadata:
        return [new_code_cell(source, metadata=tags)]
    name = cell.metadata.exercise
    solution = _nbgrader(name, solution=True)
    test = _nbgrader(check_cell(name), grade=True, locked=True, points=exercise_named(name).points)
    return [new_code_cell(source, metadata=solution | tags), new_code_cell(f'check("{name}")', metadata=test)]


def _nbgrader(grade_id: str, **settings: object) -> dict[str, dict[str, object]]:
    fixed = {"grade_id": grade_id, "grade": False, "solution": False, "locked": False, "task": False, "schema_version": 3}
    return {"nbgrader": fixed | settings}


def _mistakes(cells: Sequence[NotebookNode], notebook: str) -> Iterator[str]:
    yield from _language_mistakes(cells)
    yield from _metadata_mistakes(cells)
    yield from _import_mistakes(cells)
    yield from _name_mistakes(cells, notebook, "exercise", NOTEBOOKS)
    yield from _name_mistakes(cells, notebook, "written", WRITTEN)
    yield from _written_mistakes(cells)
    yield from _solution_mistakes(cells)
    yield from _demo_mistakes(cells)


def _at(cells: Sequence[NotebookNode], index: int) -> str:
    """Return where a cell is, as a person finds it."""
    first_line = cells[index].source.partition("\n")[0][:60]
    return f"cell {index + 1} ({first_line!r})"


def _language_mistakes(cells: Sequence[NotebookNode]) -> Iterator[str]:
    for index, cell in enumerate(cells):
        language = cell.metadata.get("lang")
        if cell.cell_type != "markdown":
            if language is not None:
                yield f"{_at(cells, index)}: code is shared by both languages; remove its lang"
        elif language not in LANGUAGES:
            yield f'{_at(cells, index)}: begin prose with +++ {{"lang": "en"}} or +++ {{"lang": "ja"}}'
        elif language == "en" and not _are_pair(cells[index : index + 2]):
            yield f"{_at(cells, index)}: put the Japanese cell, with the same metadata, directly after this English one"
        elif language == "ja" and not _are_pair(cells[max(index - 1, 0) : index + 1]):
            yield f"{_at(cells, index)}: put the English cell, with the same metadata, directly before this Japanese one"


def _are_pair(two: Sequence[NotebookNode]) -> bool:
    if [cell.metadata.get("lang") for cell in two] != ["en", "ja"]:
        return False
    english, japanese = ({**cell.metadata, "lang": None} for cell in two)
    return english == japanese


def _metadata_mistakes(cells: Sequence[NotebookNode]) -> Iterator[str]:
    for index, cell in enumerate(cells):
        allowed = _PROSE_KEYS if cell.cell_type == "markdown" else _CODE_KEYS
        unknown = sorted(set(cell.metadata) - allowed)
        if unknown:
            yield f"{_at(cells, index)}: unknown metadata {', '.join(unknown)}; there are {', '.join(sorted(allowed))}"
        if "exercise" in cell.metadata and "demo" in cell.metadata.get("tags", []):
            yield f"{_at(cells, index)}: an exercise is graded, so it cannot be tagged demo"


def _import_mistakes(cells: Sequence[NotebookNode]) -> Iterator[str]:
    code = [index for index, cell in enumerate(cells) if cell.cell_type == "code"]
    imported = _IMPORT.search(cells[code[0]].source) if code else None
    if imported is None or "check" not in imported.group(1).split(", "):
        yield "first code cell: it needs the line `from course.en import check`"
    for index in code:
        mentions = len(re.findall(r"\bcourse\.(?:en|ja)\b", cells[index].source))
        if mentions > (index == code[0]):
            yield f"{_at(cells, index)}: import from course.en once only, in the first code cell, and never from course.ja"


def _name_mistakes(
    cells: Sequence[NotebookNode], notebook: str, kind: str, contents: Mapping[str, Sequence[str]]
) -> Iterator[str]:
    """Compare what the cells are named with the table of contents; `kind` is "exercise" or "written"."""
    expected = contents.get(notebook, ())
    indices = [i for i, cell in enumerate(cells) if kind in cell.metadata and cell.metadata.get("lang", "en") == "en"]
    names = [str(cells[index].metadata[kind]) for index in indices]
    for index, name in zip(indices, names, strict=True):
        home = next((other for other, owned in contents.items() if name in owned), None)
        if home is None:
            yield f"{_at(cells, index)}: no {kind} is called {name}; name it in autograder/reference/__init__.py"
        elif home != notebook:
            yield f"{_at(cells, index)}: {name} belongs to {home}"
    for name, count in Counter(names).items():
        if count > 1:
            yield f"{kind}: {name} occurs {count} times; keep one"
    for name in expected:
        if name not in names:
            yield f"{kind}: {name} is missing; add its cell, or take it out of autograder/reference/__init__.py"
    known = list(dict.fromkeys(name for name in names if name in expected))
    in_order = [name for name in expected if name in known]
    if known != in_order:
        yield f"{kind}: the order is {', '.join(known)}; change it to {', '.join(in_order)}"


def _written_mistakes(cells: Sequence[NotebookNode]) -> Iterator[str]:
    for index, cell in enumerate(cells):
        points = cell.metadata.get("points", 0)
        if "written" in cell.metadata and not (isinstance(points, int | float) and points > 0):
            yield f"{_at(cells, index)}: give the written answer {cell.metadata.written} its points"
        if "rubric" in cell.metadata:
            before = [earlier.metadata.get("written") for earlier in cells[max(index - 2, 0) : index]]
            if cell.metadata.rubric not in before:
                yield f"{_at(cells, index)}: put the rubric directly after its written answer {cell.metadata.rubric}"
    rubrics = {cell.metadata.get("rubric") for cell in cells}
    for name in dict.fromkeys(cell.metadata.written for cell in cells if "written" in cell.metadata):
        if name not in rubrics:
            yield f"end: the written answer {name} has no rubric; add a pair of cells with the metadata rubric: {name} after it"


def _solution_mistakes(cells: Sequence[NotebookNode]) -> Iterator[str]:
    for index, cell in enumerate(cells):
        markers = _MARKER.findall(cell.source)
        wanted = ["BEGIN", "END"] if "exercise" in cell.metadata else []
        if markers != wanted:
            what = "one ### BEGIN SOLUTION and after it one ### END SOLUTION" if wanted else "no solution; name its exercise"
            yield f"{_at(cells, index)}: it must hold {what}"
        elif cell.cell_type == "code" and len(_shown_lines(cell.source)) > MAX_LINES:
            yield f"{_at(cells, index)}: students see {len(_shown_lines(cell.source))} lines; split it, {MAX_LINES} are the limit"


def _demo_mistakes(cells: Sequence[NotebookNode]) -> Iterator[str]:
    """Yield where a demonstration is needed by what comes after it: when work is graded it is left out."""
    code = [index for index, cell in enumerate(cells) if cell.cell_type == "code"]
    demos = ["demo" in cells[index].metadata.get("tags", []) for index in code]
    try:
        for demo, cell, name in dependents([cells[index].source for index in code], demos):
            yield f"{_at(cells, code[cell])}: it needs {name} from {_at(cells, code[demo])}, which is tagged demo: take that tag away"
    except SyntaxError as error:
        yield f"a code cell is no Python: {error}"


def _shown_lines(source: str) -> list[str]:
    """Return the lines of a code cell that a student sees: the stub stands in place of the solution."""
    return re.sub(r"^.*BEGIN SOLUTION(.|\n)*END SOLUTION.*$", STUB, source, flags=re.MULTILINE).splitlines()
