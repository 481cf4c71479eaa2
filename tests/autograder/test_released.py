import json
from pathlib import Path

import pytest

from autograder.exercise import check_cell
from autograder.reference import NOTEBOOKS, WRITTEN
from autograder.released import released

ROOT = Path(__file__).parents[2]
EDITIONS = [(language, notebook) for language in ("en", "ja") for notebook in NOTEBOOKS]


def data(language, notebook):
    return (ROOT / f"release/{language}/{notebook}.ipynb").read_bytes()


@pytest.mark.parametrize(("language", "notebook"), EDITIONS)
def test_everything_that_is_graded_is_there_with_its_points(language, notebook):
    release = released(data(language, notebook))
    checks = {check_cell(exercise) for exercise in NOTEBOOKS[notebook]}
    assert release.points.keys() == checks | {*WRITTEN.get(notebook, ())} & release.points.keys()
    assert checks <= release.points.keys()
    graded = {cell.grade_id: cell for cell in release.cells if cell.graded}
    assert graded.keys() == release.points.keys()
    assert {name for name, cell in graded.items() if cell.locked} == checks
    # a check holds the call and nothing else
    assert all(graded[check_cell(exercise)].source == f'check("{exercise}")' for exercise in NOTEBOOKS[notebook])
    assert release.templates.keys() == {cell.grade_id for cell in release.cells if cell.grade_id}


@pytest.mark.parametrize(("language", "notebook"), EDITIONS)
def test_cells_are_code_prose_or_demonstrations_as_the_file_says(language, notebook):
    release, raw = released(data(language, notebook)), json.loads(data(language, notebook))
    sources = [("".join(cell["source"]), cell) for cell in raw["cells"]]
    assert [cell.source for cell in release.cells] == [source for source, _ in sources]
    assert release.code == {source for source, cell in sources if cell["cell_type"] == "code"}
    assert release.prose == {source for source, cell in sources if cell["cell_type"] == "markdown"}
    assert release.demos.keys() == {source for source, cell in sources if "demo" in cell["metadata"].get("tags", [])}
    assert release.demos.keys() <= release.code
    # none is an answer or a check: it would not be run
    assert not release.demos.keys() & {cell.source for cell in release.cells if cell.grade_id}


def test_a_release_is_read_once():
    one = data(*EDITIONS[0])
    assert released(one) is released(bytes(bytearray(one)))
    assert released(one) is not released(one + b"\n")
