import os
import shutil
import sqlite3
from html.parser import HTMLParser

import pytest
from nbgrader.api import Gradebook
from sqlalchemy import event

from autograder.executed import executed_notebook
from autograder.files import replace_file
from autograder.gradebook import GradebookWriter, given_scores
from autograder.grading import GradedNotebook, Result
from autograder.intake import Cell, restored_cells
from autograder.receipts import CannotWriteError
from autograder.released import released

SCORES = {"pose_step": 5.0, "displacement": 0.5555, "q1_derivation": None, "distance_per_count": 0.0}
MAX = {"pose_step": 5.0, "displacement": 5.0, "q1_derivation": 10.0, "distance_per_count": 5.0}
NOTEBOOKS = {"pose_update": ("pose_step", "displacement", "q1_derivation"), "encoders": ("distance_per_count",)}

pytestmark = pytest.mark.usefixtures("class_contents")


@pytest.fixture
def course(class_root, empty_gradebook):
    shutil.copy(empty_gradebook, class_root / "gradebook.db")
    return class_root


def graded(root, text="Because.", status="graded", message="Fine.", source="def pose_step(*args): ...", **scores):
    """One student's graded notebooks, as if they had been run."""
    made = []
    for name, exercises in NOTEBOOKS.items():
        release = released((root / f"release/en/odometry/{name}.ipynb").read_bytes())
        ours = release.cells
        given = {"q1_derivation": text, "pose_step": source}
        handed = [Cell(cell.type, given.get(cell.grade_id, cell.source), cell.grade_id) for cell in ours]
        cells = restored_cells(ours, [cell for cell in handed if cell.source is not None])
        results = []
        for exercise in exercises:
            score = {**SCORES, **scores}[exercise]
            state = "manual" if exercise == "q1_derivation" and status == "graded" else status
            results.append(Result("ann", "odometry", name, exercise, score, MAX[exercise], message, status=state))
        made.append(GradedNotebook(name, "en", tuple(results), executed_notebook(release, cells, [])))
    return made


def write(root, *notebooks, student="ann"):
    with GradebookWriter(root, "odometry") as gradebook:
        gradebook.write(student, notebooks[0] if notebooks else graded(root))


def rows(root):
    """Everything in the gradebook, by table."""
    with sqlite3.connect(root / "gradebook.db") as database:
        tables = [name for (name,) in database.execute("SELECT name FROM sqlite_master WHERE type = 'table'")]
        return {table: sorted(map(str, database.execute(f"SELECT * FROM {table}"))) for table in tables}


@pytest.fixture
def grades(course):
    """Returns a function that looks up grades by exercise: (score, auto score, manual score, needs a person)."""

    def look(student="ann"):
        with Gradebook(f"sqlite:///{course}/gradebook.db", "dead-reckoning") as opened:
            submission = opened.find_submission("odometry", student)
            return {
                grade.name.removeprefix("check_"): (grade.score, grade.auto_score, grade.manual_score, grade.needs_manual_grade)
                for notebook in submission.notebooks
                for grade in notebook.grades
            }

    return look


def by_hand(root, name, score=None, comment=None):
    """What formgrader does when a person saves a grade or a comment."""
    with Gradebook(f"sqlite:///{root}/gradebook.db", "dead-reckoning") as opened:
        if score is not None:
            grade = opened.find_grade(name, "pose_update", "odometry", "ann")
            grade.manual_score, grade.needs_manual_grade = score, False
        if comment is not None:
            opened.find_comment(name, "pose_update", "odometry", "ann").manual_comment = comment
        opened.db.commit()


def comments(root):
    with Gradebook(f"sqlite:///{root}/gradebook.db", "dead-reckoning") as opened:
        submission = opened.find_submission("odometry", "ann")
        return {comment.name: comment.comment for notebook in submission.notebooks for comment in notebook.comments}


# what is written


def test_scores_of_every_exercise(course, grades):
    write(course)
    assert grades() == {
        "pose_step": (5.0, 5.0, None, False),
        "displacement": (0.5555, 0.5555, None, False),
        "q1_derivation": (0.0, None, None, True),
        "distance_per_count": (0.0, 0.0, None, False),
    }
    with Gradebook(f"sqlite:///{course}/gradebook.db", "dead-reckoning") as opened:
        submission = opened.find_submission("odometry", "ann")
        assert (submission.score, submission.max_score, submission.needs_manual_grade) == (5.5555, 25.0, True)
        assert [notebook.failed_tests for notebook in submission.notebooks if notebook.name == "pose_update"] == [True]


def test_messages_become_comments_and_an_answer_that_waits_for_a_person_has_none(course):
    write(course, graded(course, message="x <y> *z*\nline two"))
    written = comments(course)
    assert written["pose_step"] == written["distance_per_count"] == "x \\<y> \\*z\\*  \nline two"
    assert written["q1_derivation"] is None


@pytest.mark.parametrize("status", ["missing", "unreadable", "failed"])
def test_a_notebook_that_could_not_be_graded_has_zeros_for_written_answers_too(course, grades, status):
    zeros = dict.fromkeys(SCORES, 0.0)
    write(course, graded(course, status=status, message="Not handed in.", **zeros))
    assert grades() == dict.fromkeys(SCORES, (0.0, 0.0, None, False))
    assert set(comments(course).values()) == {"Not handed in."}


def test_an_empty_written_answer_gets_0_without_a_person(course, grades):
    write(course, graded(course, text="", q1_derivation=0.0))
    assert grades()["q1_derivation"] == (0.0, 0.0, None, False)


def test_the_executed_notebooks_lie_where_formgrader_looks(course):
    notebooks = graded(course)
    write(course, notebooks)
    folder = course / "autograded/ann/odometry"
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == {
        f"{notebook.notebook}.ipynb": notebook.executed for notebook in notebooks
    }
    assert {path.stat().st_mode & 0o777 for path in folder.iterdir()} == {0o644}


def test_grading_again_changes_nothing(course):
    write(course)
    before = rows(course)
    write(course)
    assert rows(course) == before
    assert before["grade"]
    assert before["comment"]


def test_a_better_answer_changes_its_score_and_comment_and_nothing_else(course, grades):
    write(course)
    before = grades()
    write(course, graded(course, displacement=5.0, message="Fine now."))
    assert grades() == {**before, "displacement": (5.0, 5.0, None, False)}
    assert comments(course)["displacement"] == "Fine now."


def test_students_are_kept_apart(course, grades):
    write(course)
    write(course, graded(course, pose_step=0.0), student="bob")
    assert (grades("ann")["pose_step"][0], grades("bob")["pose_step"][0]) == (5.0, 0.0)


def test_one_commit_for_each_submission(course):
    with GradebookWriter(course, "odometry") as gradebook:
        commits = []
        event.listen(gradebook._gradebook.engine, "commit", commits.append)
        gradebook.write("ann", graded(course))
        assert len(commits) == 1
        gradebook.write("bob", graded(course))
        assert len(commits) == 2


def test_the_time_is_the_servers(course, hand_in):
    folder = hand_in("ann", pose_update=b"")
    (folder / "timestamp.txt").write_text("1999-01-01 00:00:00 UTC")
    write(course)
    with Gradebook(f"sqlite:///{course}/gradebook.db", "dead-reckoning") as opened:
        assert opened.find_submission("odometry", "ann").timestamp.year > 2000


# what a person gave


def test_a_manual_grade_and_comment_stay_as_they_are(course, grades):
    write(course)
    by_hand(course, "q1_derivation", 7.0, "Nearly.")
    write(course)
    assert grades()["q1_derivation"] == (7.0, None, 7.0, False)
    assert comments(course)["q1_derivation"] == "Nearly."


REWRITTEN = {"another text": "Therefore.", "no text": "", "white space": "Because. "}


@pytest.mark.parametrize("text", REWRITTEN.values(), ids=REWRITTEN.keys())
def test_a_manual_grade_is_kept_and_flagged_when_the_text_changed(course, grades, text):
    write(course)
    by_hand(course, "q1_derivation", 7.0)
    write(course, graded(course, text=text, q1_derivation=None if text.strip() else 0.0))
    assert grades()["q1_derivation"][0] == 7.0
    assert grades()["q1_derivation"][2:] == (7.0, True)


def test_a_notebook_that_is_not_handed_in_any_more_is_a_changed_text(course, grades):
    write(course)
    by_hand(course, "q1_derivation", 7.0)
    write(course, graded(course, text="", status="missing", **dict.fromkeys(SCORES, 0.0)))
    assert grades()["q1_derivation"] == (7.0, 0.0, 7.0, True)


def test_other_changes_flag_nothing(course, grades):
    write(course)
    by_hand(course, "q1_derivation", 7.0)
    write(course, graded(course, source="def pose_step(*args): return 1", pose_step=0.0, message="Other."))
    assert grades()["q1_derivation"] == (7.0, None, 7.0, False)


def test_a_flag_stays_until_a_person_has_looked(course, grades):
    write(course)
    by_hand(course, "q1_derivation", 7.0)
    write(course, graded(course, text="Therefore."))
    write(course, graded(course, text="Therefore."))
    assert grades()["q1_derivation"] == (7.0, None, 7.0, True)
    by_hand(course, "q1_derivation", 8.0)
    write(course, graded(course, text="Therefore."))
    assert grades()["q1_derivation"] == (8.0, None, 8.0, False)


def test_a_score_that_a_person_changed_is_kept_and_flagged_only_when_the_judge_changes_its_mind(course, grades):
    write(course)
    by_hand(course, "check_displacement", 4.0)
    write(course)
    assert grades()["displacement"] == (4.0, 0.5555, 4.0, False)
    write(course, graded(course, displacement=5.0))
    assert grades()["displacement"] == (4.0, 5.0, 4.0, True)


# what goes wrong on the way


def test_failing_half_way_leaves_gradebook_and_notebooks_as_they_were(course, monkeypatch):
    write(course)
    before = rows(course)
    files = {path: path.read_bytes() for path in course.glob("autograded/**/*.ipynb")}
    bad = graded(course, text="Therefore.", pose_step=0.0)
    broken = [bad[0], GradedNotebook("no_such_notebook", "en", bad[1].results, bad[1].executed)]
    with pytest.raises(KeyError):
        write(course, broken)
    assert rows(course) == before
    assert {path: path.read_bytes() for path in course.glob("autograded/**/*.ipynb")} == files


def test_a_submission_that_fails_leaves_nothing_behind_in_the_next_one(course):
    good = graded(course)
    broken = [*graded(course, pose_step=0.0), GradedNotebook("no_such_notebook", "en", good[1].results, good[1].executed)]
    with GradebookWriter(course, "odometry") as gradebook:
        with pytest.raises(KeyError):
            gradebook.write("ann", broken)
        gradebook.write("bob", good)
    with Gradebook(f"sqlite:///{course}/gradebook.db", "dead-reckoning") as opened:
        assert [submission.student.id for submission in opened.assignment_submissions("odometry")] == ["bob"]


def test_a_run_that_stopped_before_the_notebooks_were_in_place_loses_no_flag(course, grades, monkeypatch):
    write(course)
    by_hand(course, "q1_derivation", 7.0)

    def fail(*_):
        raise OSError("disk full")

    with monkeypatch.context() as patch:
        patch.setattr("autograder.gradebook.replace_file", fail)
        with pytest.raises(OSError, match="disk full"):
            write(course, graded(course, text="Therefore."))
    write(course, graded(course, text="Therefore."))
    assert grades()["q1_derivation"] == (7.0, None, 7.0, True)


@pytest.mark.parametrize("content", [b"", b"[]", b'{"cells": [{}]}', b"\xff"])
def test_a_damaged_notebook_in_autograded_is_replaced(course, grades, content):
    write(course)
    path = course / "autograded/ann/odometry/pose_update.ipynb"
    right = path.read_bytes()
    path.write_bytes(content)
    write(course)
    assert path.read_bytes() == right


def test_a_release_that_does_not_fit_closes_the_gradebook(course, monkeypatch):
    closed = []
    close = Gradebook.close
    monkeypatch.setattr(Gradebook, "close", lambda self: closed.append(close(self)))
    shutil.rmtree(course / "release/ja")
    with pytest.raises(CannotWriteError, match="release/ has no notebooks"), GradebookWriter(course, "odometry"):
        pytest.fail("it opened")
    assert len(closed) == 1


def test_a_file_is_the_old_one_or_the_new_one(tmp_path, monkeypatch):
    path = tmp_path / "a"
    replace_file(path, b"old")

    def fail(*_):
        raise OSError("power cut")

    monkeypatch.setattr(os, "replace", fail)
    with pytest.raises(OSError, match="power cut"):
        replace_file(path, b"new")
    assert path.read_bytes() == b"old"


def test_given_scores_are_those_of_the_gradebook(course):
    write(course)
    by_hand(course, "q1_derivation", 7.0)
    by_hand(course, "check_pose_step", 1.0)
    results = [result for notebook in graded(course) for result in notebook.results]
    assert given_scores(course, "odometry", results) == {
        ("ann", "pose_step"): (1.0, None),
        ("ann", "displacement"): (0.5555, None),
        ("ann", "q1_derivation"): (7.0, None),
        ("ann", "distance_per_count"): (0.0, None),
    }


# nbgrader's own tools, on what we wrote


class Tags(HTMLParser):
    def __init__(self, page):
        super().__init__()
        self.found = []
        self.feed(page)

    def handle_starttag(self, tag, attrs):
        self.found.append((tag, dict(attrs)))


HOSTILE = "<img src=x onerror=alert(1)> [x](javascript:alert(1)) $\\href{javascript:alert(1)}{x}$"


@pytest.fixture
def hostile_class(course):
    write(course, graded(course, text=f"Because.\n\n{HOSTILE}", message=f"You wrote: {HOSTILE}", source=f"# {HOSTILE}"))
    return course


def assert_harmless(page):
    tags = Tags(page).found
    assert not [tag for tag in tags if any(name.startswith("on") and "alert" in (value or "") for name, value in tag[1].items())]
    assert not [tag for tag in tags if (tag[1].get("href") or "").startswith("javascript")]
    assert "Because." in page


@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::UserWarning")
def test_stock_feedback_shows_scores_and_comments_and_nothing_that_acts(hostile_class):
    from nbgrader.converters import GenerateFeedback
    from nbgrader.coursedir import CourseDirectory
    from traitlets.config import Config

    config = Config()
    config.CourseDirectory.assignment_id = "odometry"
    config.CourseDirectory.course_id = "dead-reckoning"
    coursedir = CourseDirectory(config=config, root=str(hostile_class))
    GenerateFeedback(coursedir=coursedir, config=config).start()
    page = (hostile_class / "feedback/ann/odometry/pose_update.html").read_text(encoding="utf-8")
    assert_harmless(page)
    assert "Score: 0.56 / 5.0" in page
    assert "You wrote: &lt;img src=x onerror=alert(1)&gt; [x](javascript:alert(1)) $\\text{href}" in page


@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::UserWarning")
def test_formgrader_finds_the_submission_and_shows_it_without_anything_that_acts(hostile_class):
    from nbconvert.exporters import HTMLExporter
    from nbgrader.apps.api import NbGraderAPI
    from nbgrader.coursedir import CourseDirectory
    from nbgrader.server_extensions.formgrader import handlers
    from traitlets.config import Config

    config = Config()
    config.CourseDirectory.course_id = "dead-reckoning"
    config.HTMLExporter.template_name = "formgrade"
    config.HTMLExporter.extra_template_basedirs = [handlers.template_path]
    api = NbGraderAPI(CourseDirectory(config=config, root=str(hostile_class)), config=config)
    [notebook] = [found for found in api.get_student_notebook_submissions("ann", "odometry") if found["name"] == "pose_update"]
    assert (notebook["needs_manual_grade"], notebook["failed_tests"]) == (True, True)
    assert (notebook["score"], notebook["max_score"]) == (5.5555, 20)
    assert api.get_notebook_submission_indices("odometry", "pose_update") == {notebook["id"]: 0}
    resources = {
        **{"assignment_id": "odometry", "notebook_id": "pose_update", "submission_id": notebook["id"], "index": 0, "total": 1},
        **{"base_url": "/", "student": "ann", "last_name": None, "first_name": None, "notebook_path": "autograded"},
    }
    path = hostile_class / "autograded/ann/odometry/pose_update.ipynb"
    page, _ = HTMLExporter(config=config).from_filename(str(path), resources=resources)
    assert_harmless(page)
    # where a person enters points and comments
    assert 'id="q1_derivation"' in page
    assert 'id="q1_derivation-comment"' in page
