import shutil
import subprocess
from pathlib import Path

import nbformat
import pytest
from nbgrader.api import Gradebook
from sqlalchemy import event

from autograder.building import build
from autograder.registering import RegistrationError, register

ROOT = Path(__file__).parents[2]
SOLUTION = (
    "    x, y, theta = pose\n    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])"
)

# nbgrader's add_submission builds rows before it adds them to the session
pytestmark = pytest.mark.filterwarnings("ignore:Object of type <Submitted:sqlalchemy.exc.SAWarning")


@pytest.fixture
def built(small_course):
    build(small_course)
    return small_course


@pytest.fixture
def gradebook(tmp_path, empty_gradebook):
    shutil.copy(empty_gradebook, tmp_path / "gradebook.db")
    with Gradebook(f"sqlite:///{tmp_path}/gradebook.db", "dead-reckoning") as opened:
        yield opened


def rows(gradebook):
    """Every row that registering makes, with its id."""
    notebooks = gradebook.find_assignment("odometry").notebooks
    cells = [cell for book in notebooks for cell in [*book.grade_cells, *book.solution_cells, *book.source_cells]]
    return [{"kernelspec": book.kernelspec, **book.to_dict()} for book in notebooks] + [
        {"kind": type(cell).__name__, **cell.to_dict()} for cell in cells
    ]


def rows_without_ids(gradebook):
    return sorted(sorted((key, str(value)) for key, value in row.items() if key != "id") for row in rows(gradebook))


def files(folder):
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def hand_in(gradebook, student="ann"):
    gradebook.add_student(student)
    gradebook.add_submission("odometry", student)
    grade = gradebook.find_grade("q1_derivation", "pose_update", "odometry", student)
    grade.manual_score = 7
    gradebook.db.commit()


def edit_release(root, edit):
    for language in ("en", "ja"):
        path = root / f"release/{language}/odometry/pose_update.ipynb"
        notebook = nbformat.read(path, as_version=4)
        edit(notebook)
        nbformat.write(notebook, path)


def without_check(notebook):
    notebook.cells = [cell for cell in notebook.cells if cell.id != "check_pose_step"]


def worth_eight(notebook):
    [cell] = [cell for cell in notebook.cells if cell.id == "check_pose_step"]
    cell.metadata.nbgrader.points = 8


@pytest.mark.slow
def test_stock_generate_assignment_does_the_same(built, gradebook, empty_gradebook, tmp_path):
    register(gradebook, built, "odometry")
    release = files(built / "release")
    shutil.copy(ROOT / "nbgrader_config.py", built)
    shutil.copy(empty_gradebook, tmp_path / "theirs.db")
    theirs = f"sqlite:///{tmp_path}/theirs.db"
    nbgrader(built, "generate_assignment", "odometry", "--force", f"--CourseDirectory.db_url={theirs}")
    assert files(built / "release") == release
    with Gradebook(theirs, "dead-reckoning") as other:
        assert rows_without_ids(gradebook) == rows_without_ids(other)


def test_registering_again_changes_nothing(built, gradebook):
    register(gradebook, built, "odometry")
    before = rows(gradebook)
    written = []
    event.listen(gradebook.engine, "before_cursor_execute", lambda *args: written.append(args[2]))
    register(gradebook, built, "odometry")
    assert [statement for statement in written if not statement.startswith(("SELECT", "PRAGMA"))] == []
    assert rows(gradebook) == before


def test_one_commit(built, gradebook):
    commits = []
    event.listen(gradebook.engine, "commit", commits.append)
    register(gradebook, built, "odometry")
    assert len(commits) == 1


def test_new_texts_and_points_keep_grades(built, gradebook):
    register(gradebook, built, "odometry")
    hand_in(gradebook)
    edit_release(built, worth_eight)
    register(gradebook, built, "odometry")
    assert gradebook.find_grade_cell("check_pose_step", "pose_update", "odometry").max_score == 8
    assert gradebook.find_grade("q1_derivation", "pose_update", "odometry", "ann").manual_score == 7


def test_changed_cells_are_refused_after_hand_in(built, gradebook):
    register(gradebook, built, "odometry")
    hand_in(gradebook)
    before = rows(gradebook)
    edit_release(built, without_check)
    with pytest.raises(RegistrationError, match=r"odometry: cells of pose_update were added or removed, but students"):
        register(gradebook, built, "odometry")
    assert rows(gradebook) == before


def test_changed_cells_are_taken_over_before_hand_in(built, gradebook):
    register(gradebook, built, "odometry")
    edit_release(built, without_check)
    register(gradebook, built, "odometry")
    [notebook] = gradebook.find_assignment("odometry").notebooks
    assert [cell.name for cell in notebook.grade_cells] == ["q1_derivation"]


def renamed(root):
    for language in ("en", "ja"):
        folder = root / f"release/{language}/odometry"
        (folder / "pose_update.ipynb").rename(folder / "poses.ipynb")


def test_a_renamed_notebook(built, gradebook):
    register(gradebook, built, "odometry")
    renamed(built)
    register(gradebook, built, "odometry")
    assert [notebook.name for notebook in gradebook.find_assignment("odometry").notebooks] == ["poses"]
    gradebook.add_student("bob")
    gradebook.add_submission("odometry", "bob")
    build(built)
    with pytest.raises(RegistrationError, match="cells of pose_update, poses were added or removed"):
        register(gradebook, built, "odometry")


def test_failing_half_way_changes_nothing(built, gradebook, monkeypatch):
    register(gradebook, built, "odometry")
    before = rows(gradebook)
    edit_release(built, worth_eight)

    def fail(session, *_):
        session.flush()
        raise OSError("disk full")

    monkeypatch.setattr("autograder.registering._store", fail)
    with pytest.raises(OSError, match="disk full"):
        register(gradebook, built, "odometry")
    assert rows(gradebook) == before


def test_nothing_to_register(built, gradebook):
    with pytest.raises(RegistrationError, match="imu: release/ has no notebooks of it; run `autograder build`"):
        register(gradebook, built, "imu")
    assert gradebook.assignments == []


def test_editions_that_differ_are_refused(built, gradebook):
    build_of_one = built / "release/en/odometry/pose_update.ipynb"
    notebook = nbformat.read(build_of_one, as_version=4)
    worth_eight(notebook)
    nbformat.write(notebook, build_of_one)
    with pytest.raises(RegistrationError, match="the editions in release/ differ"):
        register(gradebook, built, "odometry")


def nbgrader(root, *arguments):
    done = subprocess.run(["nbgrader", *arguments], cwd=root, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def submission(root, student, language, body, answer):
    notebook = nbformat.read(root / f"release/{language}/odometry/pose_update.ipynb", as_version=4)
    cells = {cell.id: cell for cell in notebook.cells}
    cells["pose_step"].source = cells["pose_step"].source.partition("    # YOUR CODE")[0] + body
    cells["q1_derivation"].source = answer
    # whatever a student makes of the locked cell, nbgrader puts it back
    cells["check_pose_step"].source = "pass"
    folder = root / "submitted" / student / "odometry"
    folder.mkdir(parents=True)
    nbformat.write(notebook, folder / "pose_update.ipynb")
    return folder / "pose_update.ipynb"


@pytest.mark.slow
def test_stock_nbgrader_grades_either_edition(built, gradebook):
    """Its own commands, with the settings of this repository, after `register` alone."""
    shutil.copy(ROOT / "nbgrader_config.py", built)
    register(gradebook, built, "odometry")
    right = submission(built, "ann", "ja", SOLUTION, "だからです。")
    submission(built, "bob", "en", "    return pose", "")
    validated = nbgrader(built, "validate", "release/en/odometry/pose_update.ipynb")
    assert "VALIDATION FAILED ON 2 CELL(S)" in validated
    nbgrader(built, "autograde", "odometry", "--Autograde.exporter_class=nbconvert.exporters.NotebookExporter")
    nbgrader(built, "generate_feedback", "odometry")
    scores = {
        (student, cell): (grade.auto_score, grade.needs_manual_grade)
        for student in ("ann", "bob")
        for cell in ("q1_derivation", "check_pose_step")
        for grade in [gradebook.find_grade(cell, "pose_update", "odometry", student)]
    }
    assert scores == {
        ("ann", "q1_derivation"): (None, True),
        ("ann", "check_pose_step"): (5, False),
        ("bob", "q1_derivation"): (0, False),
        ("bob", "check_pose_step"): (0, False),
    }
    assert right.exists()
    # nbgrader copies what lies beside the source; the source holds the solutions
    assert not [*built.rglob("autograded/**/*.md"), *built.rglob("feedback/**/*.md")]
