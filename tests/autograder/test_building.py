import json
import os
from pathlib import Path

import nbformat
import pytest
from nbgrader.nbgraderformat import reads
from nbgrader.preprocessors import ClearSolutions

from autograder.building import build, verify
from autograder.editions import STUB, SourceError
from course.examples import restored

ROOT = Path(__file__).parents[2]
PRODUCTS = [
    "course/examples.json",
    "release/en/odometry/pose_update.ipynb",
    "release/ja/odometry/pose_update.ipynb",
    "source/odometry/pose_update.ipynb",
]


def contents(root):
    return {path.relative_to(root).as_posix(): path.read_bytes() for path in root.rglob("*") if path.is_file()}


def student_notebook(root, language="en"):
    return nbformat.read(root / f"release/{language}/odometry/pose_update.ipynb", as_version=4)


@pytest.fixture
def built(small_course):
    build(small_course)
    return small_course


def test_the_first_build_makes_everything_and_the_second_nothing(small_course):
    assert build(small_course) == PRODUCTS
    before = contents(small_course)
    assert sorted(before) == sorted([*PRODUCTS, "source/odometry/pose_update.md"])
    assert build(small_course) == []
    assert contents(small_course) == before
    assert verify(small_course) == []


def test_the_same_bytes_elsewhere_and_at_another_time(built, tmp_path_factory, monkeypatch, small_source):
    elsewhere = tmp_path_factory.mktemp("a course with spaces")
    (elsewhere / "source/odometry").mkdir(parents=True)
    (elsewhere / "course").mkdir()
    (elsewhere / "source/odometry/pose_update.md").write_text(small_source, encoding="utf-8")
    os.utime(elsewhere / "source/odometry/pose_update.md", (0, 0))
    monkeypatch.setenv("TZ", "Asia/Tokyo")
    monkeypatch.chdir(elsewhere)
    build(elsewhere)
    assert Path.cwd() == elsewhere
    assert contents(elsewhere) == contents(built)


def test_students_get_stubs_and_no_answers(built):
    for language in ("en", "ja"):
        text = (built / f"release/{language}/odometry/pose_update.ipynb").read_text(encoding="utf-8")
        for hidden in ("distance * np.cos", "Because", "だから", "Rubric", "採点基準", "SOLUTION"):
            assert hidden not in text
        cells = {cell.id: cell for cell in student_notebook(built, language).cells}
        assert cells["pose_step"].source.endswith("    # YOUR CODE HERE\n    raise NotImplementedError()")
        assert cells["q1_derivation"].source == ""


def test_the_instructor_keeps_answers_and_rubric(built):
    text = (built / "source/odometry/pose_update.ipynb").read_text(encoding="utf-8")
    assert all(kept in text for kept in ("distance * np.cos", "だから", "採点基準"))


def test_nbgrader_accepts_the_student_notebook(built):
    notebook = reads((built / "release/ja/odometry/pose_update.ipynb").read_text(encoding="utf-8"), as_version=4)
    graded = [cell.metadata.nbgrader for cell in notebook.cells if "nbgrader" in cell.metadata]
    assert [len(metadata.checksum) for metadata in graded] == [32, 32, 32]
    assert not any("nbgrader" in cell.metadata for cell in notebook.cells if cell.id.startswith("cell-"))


def test_the_stub_is_nbgraders():
    assert ClearSolutions().code_stub["python"] == STUB


def test_both_editions_have_the_same_graded_cells(built):
    english, japanese = (
        [cell for cell in student_notebook(built, language).cells if "nbgrader" in cell.metadata] for language in ("en", "ja")
    )
    assert english == japanese


def test_public_examples(built):
    entry = json.loads((built / "course/examples.json").read_bytes())["pose_step"]
    assert entry["parameters"] == ["pose", "distance", "dtheta"]
    assert (entry["tolerance"]["axis"], entry["tolerance"]["angles"]) == (-1, [])
    assert (entry["gear"], entry["warnings_are_faults"]) == (None, False)
    first = entry["examples"][0]
    assert restored(first["args"][1]) == 0.5
    assert restored(first["result"]) == pytest.approx([1 + 0.5 * 3**0.5 / 2, 2.25, 0.1 + 3.141592653589793 / 6], rel=1e-15)


def test_a_mistake_leaves_everything_as_it_was(built, small_source):
    source = built / "source/odometry/pose_update.md"
    source.write_text(small_source.replace("Why?", "Why not?").replace("exercise: pose_step", "exercise: pose"), encoding="utf-8")
    before = contents(built)
    for command in (build, verify):
        with pytest.raises(SourceError, match="no exercise is called pose"):
            command(built)
    assert contents(built) == before


def test_a_reference_that_fails_leaves_everything_as_it_was(built, small_source, monkeypatch):
    (built / "source/odometry/pose_update.md").write_text(small_source.replace("Why?", "Why not?"), encoding="utf-8")
    before = contents(built)

    def fail(*_):
        raise RuntimeError("reference")

    monkeypatch.setattr("autograder.building.right_value", fail)
    with pytest.raises(RuntimeError, match="reference"):
        build(built)
    assert contents(built) == before


def test_sources_and_table_of_contents_agree(built):
    (built / "source/odometry/extra.md").write_text("", encoding="utf-8")
    (built / "source/odometry/pose_update.md").unlink()
    with pytest.raises(SourceError) as told:
        build(built)
    assert "source/odometry/pose_update.md: missing" in str(told.value)
    assert "no notebook is called odometry/extra" in str(told.value)


def test_verify_tells_stale_missing_and_superfluous_and_touches_nothing(built, small_source):
    (built / "source/odometry/pose_update.md").write_text(small_source.replace("Why?", "Why not?"), encoding="utf-8")
    (built / "release/ja/odometry/pose_update.ipynb").rename(built / "release/ja/odometry/old.ipynb")
    before = contents(built)
    assert verify(built) == [
        "release/en/odometry/pose_update.ipynb: stale",
        "release/ja/odometry/old.ipynb: superfluous",
        "release/ja/odometry/pose_update.ipynb: missing",
    ]
    assert contents(built) == before
    assert "release/ja/odometry/old.ipynb" in build(built)
    assert verify(built) == []


def test_a_fresh_clone_has_no_instructor_notebooks(built):
    (built / "source/odometry/pose_update.ipynb").unlink()
    assert verify(built) == []


def test_notebooks_of_the_ta_stay(built):
    for place in ("source/odometry/mine.ipynb", "release/ja/odometry/mine.ipynb"):
        (built / place).write_text(nbformat.writes(nbformat.v4.new_notebook()), encoding="utf-8")
    assert build(built) == []
    assert (built / "source/odometry/mine.ipynb").exists()


@pytest.mark.parametrize(("digits", "stale"), [("1.4330127018922196", False), ("1.4330127118922194", True), ("true", True)])
def test_the_last_digit_may_differ_from_machine_to_machine(built, digits, stale):
    examples = built / "course/examples.json"
    text = examples.read_text(encoding="utf-8")
    assert "1.4330127018922194" in text
    examples.write_text(text.replace("1.4330127018922194", digits), encoding="utf-8")
    assert verify(built) == (["course/examples.json: stale"] if stale else [])


@pytest.mark.parametrize("broken", [b"", b"{}", b"[", b"\xff"])
def test_broken_examples_are_stale(built, broken):
    (built / "course/examples.json").write_bytes(broken)
    assert verify(built) == ["course/examples.json: stale"]


def test_what_is_in_git_is_what_the_sources_make():
    assert verify(ROOT) == []
