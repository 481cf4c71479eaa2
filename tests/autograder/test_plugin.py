"""nbgrader's own commands on our grader: which students they grade, what they say, and that everything else of nbgrader still works."""

import csv
import json
import os
import re
import shutil
import subprocess
import sys
import zipfile
from datetime import datetime
from html.parser import HTMLParser
from pathlib import Path

import pytest
from nbgrader.api import Gradebook
from nbgrader.apps.api import NbGraderAPI
from nbgrader.converters import Autograde, GenerateFeedback, NbGraderException
from nbgrader.coursedir import CourseDirectory
from traitlets.config import Config

from autograder import exercises
from autograder.batch import BatchError
from autograder.grading import Result, notebook_names
from autograder.plugin import GradingExporter, points
from autograder.settings import configuration
from tests.classroom import Classroom, solved, with_answer, with_cell

ROOT = Path(__file__).resolve().parents[2]

#: what the assignment is worth, its written answers included, of which one waits for a person in these submissions
ALL_POINTS = sum(exercise.points for exercise in exercises() if exercise.notebook.startswith("odometry/")) + 2 * 10
BY_JUDGE = ALL_POINTS - 10
OTHERS_MISSING = ", ".join(f"{name} missing" for name in notebook_names("odometry") if name != "pose_update")
pytestmark = [pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::UserWarning"), pytest.mark.xdist_group("plugin")]


def nbgrader_api(root, **course):
    """What formgrader has in its hands."""
    config = configuration(root)
    config.CourseDirectory.update(course)
    return NbGraderAPI(CourseDirectory(config=config, root=str(root)), config=config)


def nbgrader(root, *arguments):
    """Run a command of nbgrader where a TA runs it."""
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    return subprocess.run(
        ["nbgrader", *arguments],
        cwd=root,
        env={**os.environ, "PATH": path, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )


# whom it grades, and what it says: without running anything


@pytest.fixture
def calls(monkeypatch):
    """What the grader was asked for: (root, assignment, students), and what it shall do instead of grading."""

    class Calls(list):
        error = None
        regrade = None

    calls = Calls()

    def grade_class(root, assignment, options, on_progress):
        calls.append((root, assignment, set(options.only)))
        calls.regrade = options.regrade
        if calls.error is not None:
            raise calls.error
        on_progress(0, len(options.only), "")
        for done, student in enumerate(sorted(options.only), 1):
            on_progress(done, len(options.only), student)
        return [Result(student, assignment, "pose_update", "pose_step", 2.5, 5.0, "Told.") for student in sorted(options.only)]

    monkeypatch.setattr("autograder.plugin.grade_class", grade_class)
    return calls


@pytest.fixture
def submitted(class_root, hand_in):
    """A class of five students; returns its root."""
    for student in ("ann", "bob", "cyd", "ann2"):
        hand_in(student, pose_update=b"not a notebook")
    hand_in("dan", scratch=b"none of ours")
    (hand_in("nobody") / "notes.txt").write_text("I did nothing.")
    return class_root


def test_every_student_with_a_notebook_is_graded_in_one_run(submitted, calls):
    assert nbgrader_api(submitted).autograde("odometry", "*")["success"]
    assert calls == [(submitted, "odometry", {"ann", "bob", "cyd", "dan", "ann2"})]


def test_formgraders_button_grades_that_student_alone(submitted, calls):
    assert nbgrader_api(submitted).autograde("odometry", "ann")["success"]
    assert calls == [(submitted, "odometry", {"ann"})]


SELECTIONS = {
    "a pattern": ({}, "a*", {"ann", "ann2"}),
    "a student whose id looks like a pattern to us only": ({}, "[a]nn", {"ann"}),
    "all but some": ({"student_id_exclude": "bob,ann2"}, "*", {"ann", "cyd", "dan"}),
    "those with a certain notebook": ({"notebook_id": "scr*"}, "*", {"dan"}),
}


@pytest.mark.parametrize(("course", "student", "expected"), SELECTIONS.values(), ids=SELECTIONS.keys())
def test_exactly_those_whom_nbgrader_selects_are_graded(submitted, calls, course, student, expected):
    assert nbgrader_api(submitted, **course).autograde("odometry", student)["success"]
    assert [students for _, _, students in calls] == [expected]


def test_nobody_is_left_when_all_are_excluded(submitted, calls):
    assert nbgrader_api(submitted, student_id_exclude="ann").autograde("odometry", "ann")["success"]
    assert calls == []


def test_asking_for_one_notebook_says_that_submissions_are_graded_whole(submitted, calls):
    log = nbgrader_api(submitted, notebook_id="pose_update").autograde("odometry", "ann")["log"]
    assert "[WARNING] Submissions are graded whole, not only the notebooks 'pose_update'." in log


def test_the_log_has_a_line_with_points_for_each_student(submitted, calls):
    log = nbgrader_api(submitted).autograde("odometry", "ann*")["log"]
    assert log.splitlines() == [
        "[INFO] Graded 1 of 2: ann",
        "[INFO] Graded 2 of 2: ann2",
        "[INFO] ann: 2.5 / 5",
        "[INFO] ann2: 2.5 / 5",
    ]


def test_nothing_of_the_stock_grader_runs(submitted, calls, monkeypatch):
    """Not even where it only looks at a submission: its folder holds links and a timestamp.txt that cannot be read."""
    for name in ("init_destination", "init_assignment", "convert_single_notebook", "set_permissions"):
        monkeypatch.setattr(Autograde, name, lambda *_: pytest.fail("stock code ran"))
    assert nbgrader_api(submitted).autograde("odometry", "*")["success"]
    assert len(calls) == 1


def test_students_that_shall_not_be_made_are_not_graded_and_the_others_are(submitted, calls, empty_gradebook):
    shutil.copy(empty_gradebook, submitted / "gradebook.db")
    with Gradebook(f"sqlite:///{submitted}/gradebook.db", "dead-reckoning") as gradebook:
        gradebook.add_student("bob")
    result = nbgrader_api(submitted).autograde("odometry", "*", create=False)
    assert [students for _, _, students in calls] == [{"bob"}]
    assert not result["success"]
    assert "[ERROR] Not graded, because the gradebook has no such student: ann, ann2, cyd, dan" in result["log"]


def test_a_student_behind_a_link_is_not_graded_and_the_others_are(submitted, calls):
    (submitted / "submitted/eve").symlink_to(submitted / "submitted/ann")
    (submitted / "submitted/fay").mkdir()
    (submitted / "submitted/fay/odometry").symlink_to(submitted / "submitted/ann/odometry")
    result = nbgrader_api(submitted).autograde("odometry", "*")
    assert not result["success"]
    assert [students for _, _, students in calls] == [{"ann", "bob", "cyd", "dan", "ann2", "fay"}]
    assert "[INFO] cyd: 2.5 / 5" in result["log"]
    assert "[ERROR] Not graded, because what was handed in is reached through a link: eve" in result["log"]


@pytest.mark.parametrize("force", [True, False])
def test_force_grades_again_what_has_not_changed(submitted, calls, force):
    assert nbgrader_api(submitted).autograde("odometry", "ann", force=force)["success"]
    assert calls.regrade == force


ERRORS = {
    "a grader that cannot begin": (BatchError("install bubblewrap"), r"\[ERROR\] install bubblewrap"),
    "a fault of the grader": (ZeroDivisionError("by zero"), r"\[ERROR\] The grader failed \(ZeroDivisionError: by zero\)"),
    "Ctrl-C": (KeyboardInterrupt(), r"\[ERROR\] Stopped\. What was graded so far is in the gradebook"),
}


@pytest.mark.parametrize(("error", "told"), ERRORS.values(), ids=ERRORS.keys())
def test_whoever_pressed_the_button_is_told_what_went_wrong(submitted, calls, error, told):
    calls.error = error
    result = nbgrader_api(submitted).autograde("odometry", "*")
    assert not result["success"]
    assert re.search(told, result["log"])
    assert ("NbGraderException" in result["error"]) == isinstance(error, Exception)


REFUSED = {
    "no-execute": ({"Execute": {"enabled": False}}, "--no-execute: the outputs that students hand in are never believed"),
    "another gradebook": (
        {"CourseDirectory": {"db_url": "sqlite:////tmp/other.db"}},
        "c.CourseDirectory.db_url is 'sqlite:////tmp/other",
    ),
    "another course": (
        {"CourseDirectory": {"course_id": "physics"}},
        "c.CourseDirectory.course_id is 'physics' here, but 'dead-reck",
    ),
    "another folder": (
        {"CourseDirectory": {"autograded_directory": "graded"}},
        "c.CourseDirectory.autograded_directory must be 'auto",
    ),
}


@pytest.mark.parametrize(("given", "told"), REFUSED.values(), ids=REFUSED.keys())
def test_what_the_grader_cannot_follow_is_refused(submitted, calls, given, told):
    config = configuration(submitted)
    config.merge(Config(given))
    api = NbGraderAPI(CourseDirectory(config=config, root=str(submitted)), config=config)
    result = api.autograde("odometry", "ann")
    assert not result["success"]
    assert f"[ERROR] {told}" in result["log"]
    assert calls == []


def test_the_gradebook_may_be_named_in_the_configuration(submitted, calls):
    with (submitted / "nbgrader_config.py").open("a") as file:
        file.write('c.CourseDirectory.db_url = "postgresql://ta@localhost/grades"\n')
    assert nbgrader_api(submitted).autograde("odometry", "ann")["success"]


def test_an_nbgrader_that_makes_its_exporter_before_it_looks_for_submissions_is_refused(submitted, calls):
    converter = Autograde(coursedir=CourseDirectory(config=configuration(submitted), root=str(submitted)))
    with pytest.raises(NbGraderException, match="This version of nbgrader does not work"):
        GradingExporter(parent=converter)


def test_the_exporter_is_for_grading_only(submitted):
    course = CourseDirectory(config=configuration(submitted), root=str(submitted))
    with pytest.raises(NbGraderException, match=r"is for c\.Autograde\.exporter_class"):
        GradingExporter(parent=GenerateFeedback(coursedir=course))


def test_the_exporter_exports_nothing(submitted, calls):
    course = CourseDirectory(config=configuration(submitted), root=str(submitted), assignment_id="odometry")
    converter = Autograde(coursedir=course)
    converter.init_notebooks()
    path = submitted / "release/en/odometry/pose_update.ipynb"
    with pytest.raises(NbGraderException, match="This version of nbgrader does not work"):
        GradingExporter(parent=converter).from_filename(str(path))


def test_points_in_a_line():
    results = [
        Result("ann", "odometry", "a", "one", 1.5, 5.0, ""),
        Result("ann", "odometry", "a", "two", None, 10.0, "", status="manual"),
        Result("ann", "odometry", "b", "three", 0.0, 5.0, "", status="missing"),
        Result("ann", "odometry", "b", "four", 0.0, 5.0, "", status="missing"),
    ]
    assert points(results) == "1.5 / 15, 1 by hand, b missing"


# a class, with everything real

#: dead_reckoning calls it, and goes wrong with it
WRONG = """def pose_step(pose, distance, dtheta):
    raise ValueError("<script>alert(1)</script><img src=x onerror=alert(1)>")
"""
LONG_AGO = datetime(2001, 1, 1)
SECRET = "the examination of next year"
ZIPPED = {
    "Zoe Ito_2001_assignsubmission_file_/pose_update.ipynb": "solved",
    "Yui Abe_2002_assignsubmission_file_/pose_update.ipynb": "broken",
    # two ways to hand in for somebody else
    "Yui Abe_2002_assignsubmission_file_/Zoe Ito_2001_assignsubmission_file_/encoders.ipynb": "broken",
    "Yui Abe_2002_assignsubmission_file_/x_2001_assignsubmission_file_encoders.ipynb": "broken",
}
MOODLE = r".*/extracted/[^/]+/[^/]*_(?P<student_id>\d+)_assignsubmission_file_/(?P<file_id>[^/]+)\.ipynb$"


@pytest.fixture(scope="module")
def classroom(tmp_path_factory):
    """What a class handed in: an honest student, one with a hostile answer and hostile files, and others with other misfortunes."""
    room = Classroom(tmp_path_factory.mktemp("class"))
    (room.root / "source/odometry").mkdir(parents=True)
    outside = tmp_path_factory.mktemp("outside")
    (outside / "exam.txt").write_text(SECRET)
    (outside / "pose_update.ipynb").write_text(json.dumps(solved()))
    for student in ("ann", "dan"):
        room.hand_in(student, solved())
    hostile = with_answer(solved(), "pose_step", WRONG)
    hostile["cells"].insert(
        1, {"cell_type": "markdown", "id": "own", "metadata": {}, "source": "<script>alert(1)</script> [x](javascript:alert(1))"}
    )
    folder = room.hand_in("bob", hostile).parent
    (folder / "exam.txt").symlink_to(outside / "exam.txt")
    (folder / "numpy.py").write_text("raise SystemExit")
    (folder / "timestamp.txt").write_text("when I was done")
    room.hand_in("cyd", b"{")
    (room.folder("eve") / "pose_update.ipynb").symlink_to(outside / "pose_update.ipynb")
    (room.folder("nobody") / "notes.txt").write_text("I did nothing.")
    return room


@pytest.fixture(scope="module")
def commanded(classroom):
    """The class graded by `nbgrader autograde`, all but dan: what the command left."""
    done = nbgrader(classroom.root, "autograde", "odometry", "--CourseDirectory.student_id_exclude=dan")
    assert done.returncode == 0, done.stderr
    return done


@pytest.fixture(scope="module")
def button(classroom, commanded):
    """What formgrader's button says after it graded dan."""
    return nbgrader_api(classroom.root).autograde("odometry", "dan")


def opened(room):
    return Gradebook(f"sqlite:///{room.root}/gradebook.db", "dead-reckoning")


def score(room, student, notebook="pose_update"):
    with opened(room) as gradebook:
        return gradebook.find_submission_notebook(notebook, "odometry", student).score


@pytest.mark.sandbox
def test_the_command_gives_the_points_that_answers_deserve(classroom, commanded):
    assert {student: score(classroom, student) for student in ("ann", "bob", "cyd", "eve")} == {
        "ann": 40.0,
        "bob": 30.0,
        "cyd": 0.0,
        "eve": 0.0,
    }


@pytest.mark.sandbox
def test_the_command_says_what_each_student_got(commanded):
    lines = [line.partition("] ")[2] for line in commanded.stderr.splitlines()]
    assert f"ann: 40 / {BY_JUDGE}, 1 by hand, {OTHERS_MISSING}" in lines
    assert f"cyd: 0 / {ALL_POINTS}, pose_update unreadable, {OTHERS_MISSING}" in lines
    assert f"eve: 0 / {ALL_POINTS}, pose_update unreadable, {OTHERS_MISSING}" in lines
    assert "Graded 4 of 4" in commanded.stderr


@pytest.mark.sandbox
def test_every_exercise_has_a_score_and_a_reason_where_a_notebook_is_broken_or_missing(classroom, commanded):
    with opened(classroom) as gradebook:
        for student in ("cyd", "eve"):
            for notebook in gradebook.find_submission("odometry", student).notebooks:
                assert {(grade.auto_score, grade.needs_manual_grade) for grade in notebook.grades} == {(0.0, False)}
                assert all(comment.comment for comment in notebook.comments)


@pytest.mark.sandbox
def test_who_is_excluded_or_has_no_notebook_is_not_graded(classroom, commanded):
    with opened(classroom) as gradebook:
        graded = {submission.student.id for submission in gradebook.assignment_submissions("odometry")}
    assert graded.isdisjoint({"nobody"})
    assert "dan" not in commanded.stderr


@pytest.mark.sandbox
def test_nothing_but_executed_notebooks_lies_in_autograded(classroom, commanded):
    files = {path.name for path in (classroom.root / "autograded").rglob("*") if not path.is_dir()}
    assert files == {f"{name}.ipynb" for name in notebook_names("odometry")}
    assert all(path.is_file() and not path.is_symlink() for path in (classroom.root / "autograded").glob("*/*/*"))


@pytest.mark.sandbox
def test_a_command_that_cannot_grade_says_so_and_fails(classroom, commanded):
    done = nbgrader(classroom.root, "autograde", "odometry", "--no-execute")
    assert done.returncode == 1
    assert "ERROR] --no-execute: the outputs that students hand in are never believed" in done.stderr


@pytest.mark.sandbox
def test_the_button_grades_and_says_so(classroom, button):
    assert button["success"], button
    assert f"[INFO] dan: 40 / {BY_JUDGE}, 1 by hand, {OTHERS_MISSING}" in button["log"]
    assert score(classroom, "dan") == 40.0


@pytest.mark.sandbox
def test_formgrader_lists_the_submissions_with_their_scores(classroom, button):
    shown = {entry["student"]: entry for entry in nbgrader_api(classroom.root).get_submissions("odometry")}
    graded = {student: entry["score"] for student, entry in shown.items() if entry["autograded"]}
    assert graded.items() >= {"ann": 40.0, "bob": 30.0, "cyd": 0.0, "eve": 0.0, "dan": 40.0}.items()
    assert (shown["ann"]["needs_manual_grade"], shown["cyd"]["needs_manual_grade"]) == (True, False)
    assert not shown["nobody"]["autograded"]
    assert nbgrader_api(classroom.root).get_assignment("odometry")["average_score"] > 0


# what a person does by hand, and a second time


@pytest.fixture(scope="module")
def regraded(classroom, button):
    """ann was given points, extra credit and comments by hand; then the button was pressed again."""
    with opened(classroom) as gradebook:
        written = gradebook.find_grade("q1_derivation", "pose_update", "odometry", "ann")
        written.manual_score, written.extra_credit, written.needs_manual_grade = 7.0, 2.0, False
        gradebook.find_comment("q1_derivation", "pose_update", "odometry", "ann").manual_comment = "Nearly."
        gradebook.find_comment("pose_step", "pose_update", "odometry", "ann").manual_comment = "Very neat."
        check = gradebook.find_grade("check_pose_step", "pose_update", "odometry", "ann")
        check.manual_score, check.needs_manual_grade = 3.0, False
        for student in ("ann", "dan"):
            gradebook.find_submission("odometry", student).timestamp = LONG_AGO
        gradebook.db.commit()
    classroom.hand_in("dan", with_cell(solved(), "1 + 1"))
    # such as copying the course to another machine does
    (classroom.root / "submitted/ann/odometry/pose_update.ipynb").chmod(0o600)
    result = nbgrader_api(classroom.root).autograde("odometry", "[ad]*n", force=True)
    assert result["success"], result
    return classroom


@pytest.mark.sandbox
def test_what_is_graded_again_arrived_when_it_was_handed_in_and_what_is_new_arrives_now(regraded):
    with opened(regraded) as gradebook:
        assert gradebook.find_submission("odometry", "ann").timestamp == LONG_AGO
        assert gradebook.find_submission("odometry", "dan").timestamp > LONG_AGO
    shown = {entry["student"]: entry["autograded"] for entry in nbgrader_api(regraded.root).get_submissions("odometry")}
    assert (shown["ann"], shown["dan"]) == (True, True)


@pytest.mark.sandbox
def test_points_and_comments_given_by_hand_are_kept(regraded):
    with opened(regraded) as gradebook:
        grades = {grade.name: grade for grade in gradebook.find_submission_notebook("pose_update", "odometry", "ann").grades}
        written, check = grades["q1_derivation"], grades["check_pose_step"]
        assert (written.manual_score, written.extra_credit, written.needs_manual_grade) == (7.0, 2.0, False)
        assert (check.manual_score, check.auto_score, check.score, check.needs_manual_grade) == (3.0, 5.0, 3.0, False)
        for name, comment in {"q1_derivation": "Nearly.", "pose_step": "Very neat."}.items():
            assert gradebook.find_comment(name, "pose_update", "odometry", "ann").comment == comment


@pytest.mark.sandbox
def test_extra_credit_counts(regraded):
    # 40 less 2 for the check, 7 for the written answer and 2 more
    assert score(regraded, "ann") == 47.0


# zip_collect


@pytest.fixture(scope="module")
def collected(regraded, tmp_path_factory):
    """Submissions that `nbgrader zip_collect` took out of what Moodle gives, graded."""
    root = regraded.root
    archive = root / "downloaded/odometry/archive"
    archive.mkdir(parents=True)
    contents = {"solved": json.dumps(solved("ja"), ensure_ascii=False), "broken": "{"}
    with zipfile.ZipFile(archive / "moodle.zip", "w") as file:
        for name, kind in ZIPPED.items():
            file.writestr(name, contents[kind])
    done = nbgrader(root, "zip_collect", "odometry", "--strict", f"--FileNameCollectorPlugin.named_regexp={MOODLE}")
    assert done.returncode == 0, done.stderr
    result = nbgrader_api(root).autograde("odometry", "200?")
    assert result["success"], result
    return regraded


@pytest.mark.sandbox
def test_what_zip_collect_collects_is_graded(collected):
    assert (score(collected, "2001"), score(collected, "2002")) == (40.0, 0.0)
    shown = {entry["student"]: entry for entry in nbgrader_api(collected.root).get_submissions("odometry")}
    assert shown["2001"]["autograded"]


@pytest.mark.sandbox
def test_a_name_inside_a_submission_puts_nothing_into_the_folder_of_another_student(collected):
    assert sorted(path.name for path in (collected.root / "submitted/2001/odometry").iterdir()) == [
        "pose_update.ipynb",
        "timestamp.txt",
    ]


# export and feedback, of all that


@pytest.mark.sandbox
def test_export_has_the_scores(collected):
    done = nbgrader(collected.root, "export", "--to=grades.csv")
    assert done.returncode == 0, done.stderr
    with (collected.root / "grades.csv").open() as file:
        rows = {row["student_id"]: row for row in csv.DictReader(file)}
    assert {student: float(row["score"]) for student, row in rows.items()} == {
        **{"ann": 47.0, "bob": 30.0, "cyd": 0.0, "dan": 40.0, "eve": 0.0},
        **{"2001": 40.0, "2002": 0.0},
    }
    assert {(row["assignment"], float(row["max_score"])) for row in rows.values()} == {("odometry", float(ALL_POINTS))}
    assert all(row["timestamp"] for row in rows.values())


class Page(HTMLParser):
    """A page's tags, its scripts and its text."""

    def __init__(self, path):
        super().__init__()
        self.tags, self.scripts, self.text = [], "", ""
        self._in = None
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        self._in = tag
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        self._in = None

    def handle_data(self, data):
        if self._in == "script":
            self.scripts += data
        elif self._in != "style":
            self.text += data


@pytest.fixture(scope="module")
def feedback(collected):
    """The folder feedback/ that formgrader makes."""
    result = nbgrader_api(collected.root).generate_feedback("odometry")
    assert result["success"], result
    return collected.root / "feedback"


@pytest.mark.sandbox
def test_feedback_has_our_messages_beside_the_answers(feedback):
    text = Page(feedback / "bob/odometry/pose_update.html").text
    answer = text.index('raise ValueError("<script>alert(1)</script>')
    told = text.index("Comments:", answer)
    following = text.index("def ", told)
    assert "ValueError" in text[told:following]
    assert "Score: 30.0 / 50.0" in text
    assert "Very neat." in Page(feedback / "ann/odometry/pose_update.html").text


@pytest.mark.sandbox
def test_feedback_says_why_a_notebook_was_not_graded(feedback):
    text = Page(feedback / "cyd/odometry/pose_update.html").text
    assert "ノートブックとして読めません" in text


@pytest.mark.sandbox
def test_feedback_acts_on_nobodys_machine(feedback):
    page = Page(feedback / "bob/odometry/pose_update.html")
    assert "alert(1)" in page.text
    assert "alert(1)" not in page.scripts
    assert not [tag for tag in page.tags if any("alert" in (value or "") for value in tag[1].values())]


@pytest.mark.sandbox
def test_feedback_holds_no_other_file_of_a_student_and_nothing_that_a_link_led_to(feedback):
    files = [path for path in feedback.rglob("*") if not path.is_dir()]
    assert {path.name for path in files} == {f"{name}.html" for name in notebook_names("odometry")}
    assert not [path for path in files if SECRET in path.read_text(encoding="utf-8")]
    assert len(files) == 7 * len(notebook_names("odometry"))
