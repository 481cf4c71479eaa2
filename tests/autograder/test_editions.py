import re

import nbformat
import pytest

from autograder.editions import SourceError, edition, source_cells
from autograder.reference import NOTEBOOKS, WRITTEN
from tests.contents import table_of_contents

NOTEBOOK = "odometry/pose_update"
pytestmark = pytest.mark.usefixtures("small_contents")

EXERCISE = """
```{code-cell} ipython3
---
exercise: %s
---
def %s():
    ### BEGIN SOLUTION
    return 1
    ### END SOLUTION
```
"""

#: what is replaced in the small notebook, by what, and what its author is told
MISTAKES = [
    ('{"lang": "ja"}\n\nなぜ', '{"lang": "en"}\n\nなぜ', r"cell 4 \('Why\?'\): put the Japanese cell"),
    ('+++ {"lang": "en"}\n\nWhy?\n', "", r"cell 4 \('なぜですか。'\): put the English cell"),
    ('+++ {"lang": "en"}\n\nWhy', "+++\n\nWhy", r"cell 4 \('Why\?'\): begin prose with"),
    ('{"lang": "en"}\n\nWhy', '{"lang": "fr"}\n\nWhy', r"cell 4 \('Why\?'\): begin prose with"),
    (
        '"lang": "ja", "written": "q1_derivation", "points": 10',
        '"lang": "ja"',
        "cell 6 .*: put the Japanese cell, with the same metadata",
    ),
    ("tags: [demo]", "tags: [demo]\nlang: en", r"cell 11 \('print.*'\): code is shared"),
    ("exercise: pose_step", "excercise: pose_step", r"cell 10 .*: unknown metadata excercise; there are exercise, tags"),
    ("exercise: pose_step", "exercise: pose_step\ntags: [demo]", r"cell 10 .*: an exercise is graded"),
    ("from course.en import check\n", "", "first code cell: it needs the line `from course.en import check`"),
    ("import check\n", "import hint\n", "first code cell: it needs the line"),
    ("from course.en import check", "from course.ja import check", "first code cell: it needs the line"),
    ('print("a picture")', "from course.en import hint", "cell 11 .*: import from course.en once only"),
    (
        "exercise: pose_step",
        "exercise: pose_stop",
        "cell 10 .*: no exercise is called pose_stop; .*\n.* exercise: pose_step is missing; add",
    ),
    ("exercise: pose_step", "exercise: wheel_angle", "cell 10 .*: wheel_angle belongs to odometry/encoders"),
    ("written", "wirtten", "cell 6 .*: unknown metadata wirtten.*(.*\n)*.*written: q1_derivation is missing"),
    ('"q1_derivation"', '"q2_derivation"', "cell 6 .*: no written is called q2_derivation"),
    (', "points": 10', "", "cell 6 .*: give the written answer q1_derivation its points"),
    ('"rubric": "q1_derivation"', '"rubric": "q1"', "cell 8 .*: put the rubric directly after its written answer q1"),
    ('"rubric": "q1_derivation"', '"lang": "en"', "end: the written answer q1_derivation has no rubric"),
    ("    ### BEGIN SOLUTION\n", "", "cell 10 .*: it must hold one ### BEGIN SOLUTION and after it one ### END SOLUTION"),
    ("    ### END SOLUTION\n", "", "cell 10 .*: it must hold one"),
    ("### BEGIN SOLUTION", "### END SOLUTION", "cell 10 .*: it must hold one"),
    ('print("a picture")', "### BEGIN SOLUTION\n1\n### END SOLUTION", "cell 11 .*: it must hold no solution; name its exercise"),
    ('print("a picture")', "print()\n" * 21, "cell 11 .*: students see 21 lines; split it, 20 are the limit"),
    ("    ### BEGIN", "    # think\n" * 17 + "    ### BEGIN", "cell 10 .*: students see 21 lines"),
]


@pytest.fixture
def other_notebook(small_contents):
    with table_of_contents({**NOTEBOOKS, "odometry/encoders": ("wheel_angle",)}, WRITTEN):
        yield


@pytest.mark.usefixtures("other_notebook")
@pytest.mark.parametrize(("old", "new", "told"), MISTAKES)
def test_a_mistake_is_named_with_its_place(small_source, old, new, told):
    assert old in small_source
    with pytest.raises(SourceError, match=rf"source/odometry/pose_update\.md, {told}"):
        source_cells(small_source.replace(old, new), NOTEBOOK)


def test_all_mistakes_are_told_at_once(small_source):
    with pytest.raises(SourceError) as told:
        source_cells(small_source.replace("course.en", "course").replace(', "points": 10', ""), NOTEBOOK)
    assert len(str(told.value).splitlines()) == 3


def test_an_unknown_notebook_is_refused(small_source):
    with pytest.raises(SourceError, match="no notebook is called odometry/poses"):
        source_cells(small_source, "odometry/poses")


def test_exercises_come_once_and_in_the_order_of_the_table_of_contents(small_source):
    order = "exercise: the order is pose_step, displacement; change it to displacement, pose_step$"
    with table_of_contents({NOTEBOOK: ("displacement", "pose_step")}, WRITTEN), pytest.raises(SourceError, match=order):
        source_cells(small_source + EXERCISE % ("displacement", "displacement"), NOTEBOOK)
    with pytest.raises(SourceError, match="exercise: pose_step occurs 2 times; keep one"):
        source_cells(small_source + EXERCISE % ("pose_step", "pose_step"), NOTEBOOK)


def test_a_long_solution_is_no_mistake(small_source):
    longer = small_source.replace("    x, y, theta = pose\n", "    x, y, theta = pose\n" * 30)
    assert len(source_cells(longer, NOTEBOOK)) == 11


@pytest.fixture(params=["en", "ja"])
def language(request):
    return request.param


@pytest.fixture
def made(small_source, language):
    return edition(source_cells(small_source, NOTEBOOK), NOTEBOOK, language)


def test_an_edition_speaks_one_language(made, language):
    assert made.cells[0].source.startswith({"en": "# The pose\n", "ja": "# 姿勢\n"}[language])
    assert made.cells[1].source == f"from course.{language} import check\nimport numpy as np"
    assert bool(re.search("[ぁ-ん]", nbformat.writes(made))) == (language == "ja")


def test_an_edition_is_valid_and_bare(made):
    nbformat.validate(made)
    assert (made.nbformat, made.nbformat_minor) == (4, 5)
    assert made.metadata.kernelspec.name == "python3"
    assert all(not cell.get("outputs") and cell.get("execution_count") is None for cell in made.cells)
    assert {key for cell in made.cells for key in cell.metadata} == {"nbgrader", "tags"}


def test_graded_cells(made):
    cells = {cell.metadata.nbgrader.grade_id: cell for cell in made.cells if "nbgrader" in cell.metadata}
    columns = ("grade", "solution", "locked", "points")
    assert {name: tuple(cell.metadata.nbgrader.get(column) for column in columns) for name, cell in cells.items()} == {
        "q1_derivation": (True, True, False, 10),
        "pose_step": (False, True, False, None),
        "check_pose_step": (True, False, True, 5),
    }
    assert cells["check_pose_step"].source == 'check("pose_step")'
    assert cells["q1_derivation"].cell_type == "markdown"
    assert {cell.metadata.nbgrader.schema_version for cell in cells.values()} == {3}


def test_the_rubric_joins_the_model_answer(small_source):
    cells = edition(source_cells(small_source, NOTEBOOK), NOTEBOOK, "en").cells
    [manual] = [cell for cell in cells if cell.id == "q1_derivation"]
    assert manual.source == "Because.\n\n---\n\nRubric: 10 points for a reason."


def test_ids_are_the_same_every_time(made, small_source, language):
    again = edition(source_cells(small_source, NOTEBOOK), NOTEBOOK, language)
    assert [cell.id for cell in made.cells] == [cell.id for cell in again.cells]
    assert [cell.id for cell in made.cells] == [
        "cell-0",
        "cell-1",
        "cell-2",
        "q1_derivation",
        "pose_step",
        "check_pose_step",
        "cell-6",
    ]


def test_tags_are_kept(made):
    assert [cell.source for cell in made.cells if "demo" in cell.metadata.get("tags", [])] == ['print("a picture")']
