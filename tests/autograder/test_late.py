"""Late penalties: the server's time alone counts, and what is taken off is what stock nbgrader takes off."""

import os
import shutil
import sys
import time
from datetime import UTC, datetime, timedelta

import pytest
from nbgrader.api import Gradebook, Student, SubmittedAssignment

from autograder.batch import BatchError, grade_class
from autograder.engine import Options
from autograder.gradebook import GradebookWriter
from autograder.grading import GradedNotebook, Result
from autograder.late import LatePenalties, LatePenaltyError, arrival

pytestmark = pytest.mark.usefixtures("class_contents")

#: in points, by exercise; the written answer waits for a person
SCORES = {
    "pose_update": {"pose_step": 5.0, "displacement": 0.5, "q1_derivation": None},
    "encoders": {"distance_per_count": 2.0},
}
PLUGIN = """
from nbgrader.plugins import BasePlugin
from traitlets import Float

class HalfAndMore(BasePlugin):
    per_hour = Float(1.5).tag(config=True)

    def late_submission_penalty(self, student_id, score, total_seconds_late):
        return {"ann": self.per_hour * total_seconds_late // 3600, "bob": -3.0, "cyd": 1000.0, "dan": None}[student_id]
"""
CUSTOM = 'c.AssignLatePenalties.plugin_class = "half_and_more.HalfAndMore"\nc.HalfAndMore.per_hour = 2.0\n'
ZERO = 'c.LateSubmissionPlugin.penalty_method = "zero"\n'
LONG_AGO, LONG_AFTER = timedelta(hours=-1), timedelta(hours=1)


@pytest.fixture
def course(class_root, empty_gradebook, monkeypatch):
    # each course has its own
    monkeypatch.delitem(sys.modules, "half_and_more", raising=False)
    shutil.copy(empty_gradebook, class_root / "gradebook.db")
    (class_root / "half_and_more.py").write_text(PLUGIN)
    return class_root


@pytest.fixture
def configured(course):
    """Returns a function that adds lines to nbgrader_config.py."""

    def add(lines):
        with (course / "nbgrader_config.py").open("a") as file:
            file.write(lines)

    return add


@pytest.fixture
def handed_in(course, hand_in):
    """Returns a function that hands in both notebooks of a student."""
    return lambda student: hand_in(student, pose_update=b"{}", encoders=b"{}")


def graded(root, student):
    """A submission as it comes from the engine, without anything having been run."""
    made = []
    for name, scores in SCORES.items():
        release = (root / f"release/en/odometry/{name}.ipynb").read_bytes()
        results = [Result(student, "odometry", name, exercise, score, 5.0, "Told.") for exercise, score in scores.items()]
        made.append(GradedNotebook(name, "en", tuple(results), release))
    return made


def write(root, *students, unchanged=()):
    with GradebookWriter(root, "odometry") as gradebook:
        for student in students:
            gradebook.write(student, graded(root, student), unchanged=unchanged)


def opened(root):
    return Gradebook(f"sqlite:///{root}/gradebook.db", "dead-reckoning")


def due(root, when):
    """Set the due date, counted from now."""
    with opened(root) as gradebook:
        gradebook.update_or_create_assignment("odometry", duedate=datetime.now(UTC).replace(tzinfo=None) + when)


def penalties(root, student="ann"):
    with opened(root) as gradebook:
        return {entry.name: entry.late_submission_penalty for entry in gradebook.find_submission("odometry", student).notebooks}


def stock_penalties(root, student):
    """What nbgrader's own preprocessor writes, given the time that we wrote."""
    from nbformat.v4 import new_notebook
    from nbgrader.preprocessors import AssignLatePenalties

    from autograder.settings import configuration

    for name in SCORES:
        resources = {"notebook": name, "assignment": "odometry", "student": student, "db_url": f"sqlite:///{root}/gradebook.db"}
        AssignLatePenalties(config=configuration(root)).preprocess(new_notebook(), {"nbgrader": resources})
    return penalties(root, student)


# what is taken off


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
@pytest.mark.parametrize("lines", ["", ZERO, CUSTOM], ids=["none", "zero", "a plug-in of the course"])
def test_penalties_are_those_of_stock_nbgrader(course, configured, handed_in, lines, monkeypatch):
    configured(lines)
    students = ("ann", "bob", "cyd", "dan")
    for student in students:
        handed_in(student)
    write(course)
    due(course, timedelta(hours=-2, minutes=-1))
    write(course, *students)
    ours = {student: penalties(course, student) for student in students}
    # nbgrader's commands look for plug-ins where they are started
    monkeypatch.syspath_prepend(course)
    assert ours == {student: stock_penalties(course, student) for student in students}
    nothing = dict.fromkeys(SCORES)
    everything = {"pose_update": 5.5, "encoders": 2.0}
    expected = {
        "": dict.fromkeys(students, nothing),
        ZERO: dict.fromkeys(students, everything),
        # never below nothing, nor more than the notebook is worth
        CUSTOM: {
            "ann": {"pose_update": 4.0, "encoders": 2.0},
            "bob": dict.fromkeys(SCORES, 0.0),
            "cyd": everything,
            "dan": nothing,
        },
    }
    assert ours == expected[lines]


def test_who_is_in_time_loses_nothing(course, configured, handed_in):
    configured(ZERO)
    handed_in("ann")
    write(course)
    due(course, LONG_AFTER)
    write(course, "ann")
    assert penalties(course) == dict.fromkeys(SCORES)


def test_a_course_without_a_due_date_takes_nothing_off(course, configured, handed_in):
    configured(ZERO)
    handed_in("ann")
    write(course, "ann")
    assert penalties(course) == dict.fromkeys(SCORES)


def test_an_extension_moves_the_due_date_and_a_penalty_goes_when_it_is_given(course, configured, handed_in):
    configured(ZERO)
    handed_in("ann")
    write(course)
    due(course, LONG_AGO)
    write(course, "ann")
    assert penalties(course) == {"pose_update": 5.5, "encoders": 2.0}
    with opened(course) as gradebook:
        gradebook.grant_extension("odometry", "ann", hours=2)
    write(course, "ann")
    assert penalties(course) == dict.fromkeys(SCORES)


def test_a_manual_grade_and_extra_credit_count_in_what_is_taken_off(course, configured, handed_in):
    configured(ZERO)
    handed_in("ann")
    write(course)
    due(course, LONG_AGO)
    write(course, "ann")
    with opened(course) as gradebook:
        grade = gradebook.find_grade("q1_derivation", "pose_update", "odometry", "ann")
        grade.manual_score, grade.extra_credit, grade.needs_manual_grade = 7.0, 1.0, False
        gradebook.db.commit()
    write(course, "ann")
    assert penalties(course)["pose_update"] == 13.5
    with opened(course) as gradebook:
        submission = gradebook.find_submission("odometry", "ann")
        assert submission.score - submission.late_submission_penalty == 0.0


# when a submission arrived


def test_what_a_student_writes_says_nothing_about_the_time(course, configured, handed_in):
    """A forged timestamp.txt, and notebooks that say they are from the last century."""
    configured(ZERO)
    folder = handed_in("ann")
    (folder / "timestamp.txt").write_text("1999-01-01 00:00:00 UTC")
    for path in folder.iterdir():
        os.utime(path, (0, 0))
    write(course)
    due(course, LONG_AGO)
    write(course, "ann")
    assert penalties(course) == {"pose_update": 5.5, "encoders": 2.0}
    with opened(course) as gradebook:
        submission = gradebook.find_submission("odometry", "ann")
        assert abs(submission.total_seconds_late - 3600) < 600


def test_a_submission_arrives_with_its_newest_notebook_whatever_else_lies_beside_it(tmp_path, monkeypatch):
    """Times of arrival cannot be set, so `lstat` says what they are."""
    changed = {"a.ipynb": 1_000_000.9, "b.ipynb": 2_000_000.9, "notes.ipynb": 3_000_000.0, "timestamp.txt": 4_000_000.0}
    for name in changed:
        (tmp_path / name).touch()
    (tmp_path / "c.ipynb").symlink_to(tmp_path / "notes.ipynb")
    (tmp_path / "d.ipynb").mkdir()
    real = os.lstat

    class Status:
        def __init__(self, path):
            self.st_mode, self.st_ctime, self.st_mtime = real(path).st_mode, changed.get(path.name, 9_000_000.0), 0.0

    monkeypatch.setattr("autograder.late.os.lstat", Status)
    assert arrival(tmp_path, ["a", "b", "c", "d", "missing"]) == datetime(1970, 1, 24, 3, 33, 20)


def test_nothing_that_could_arrive(tmp_path):
    assert arrival(tmp_path, ["a"]) is None
    assert arrival(tmp_path / "nowhere", ["a"]) is None


HOSTILE = {
    "malformed": lambda path: path.write_text("yesterday, honestly"),
    "not text": lambda path: path.write_bytes(b"\xff\xfe"),
    "empty": lambda path: path.write_text(""),
    "forged": lambda path: path.write_text("1999-01-01 00:00:00 UTC"),
    "a folder": lambda path: path.mkdir(),
    "a pipe": os.mkfifo,
    "missing": lambda path: None,
}


@pytest.mark.parametrize("make", HOSTILE.values(), ids=HOSTILE.keys())
def test_formgrader_reads_the_time_that_stands_in_the_gradebook(course, handed_in, make):
    """It takes a submission as graded only then, and one unreadable timestamp.txt would hide a whole class."""
    from nbgrader.apps.api import NbGraderAPI
    from nbgrader.coursedir import CourseDirectory

    make(handed_in("ann") / "timestamp.txt")
    write(course, "ann")
    api = NbGraderAPI(CourseDirectory(root=str(course)))
    [shown] = api.get_submissions("odometry")
    assert (shown["autograded"], shown["score"]) == (True, 7.5)
    assert abs(datetime.fromisoformat(shown["timestamp"]).replace(tzinfo=UTC).timestamp() - time.time()) < 600


def test_a_link_called_timestamp_is_replaced_and_what_it_leads_to_is_not_touched(course, handed_in, tmp_path):
    secret = tmp_path / "secret"
    secret.write_text("of the TA")
    path = handed_in("ann") / "timestamp.txt"
    path.symlink_to(secret)
    write(course, "ann")
    assert secret.read_text() == "of the TA"
    assert not path.is_symlink()


def test_a_timestamp_that_is_right_is_left_alone(course, handed_in):
    path = handed_in("ann") / "timestamp.txt"
    write(course, "ann")
    before = path.stat()
    write(course, "ann")
    assert path.stat().st_ino == before.st_ino


def test_a_folder_that_cannot_be_written_is_graded_all_the_same(course, handed_in, monkeypatch, caplog):
    handed_in("ann")

    def fail(*_):
        raise PermissionError("read-only")

    monkeypatch.setattr("autograder.late.replace_file", fail)
    write(course, "ann")
    with opened(course) as gradebook:
        assert gradebook.find_submission("odometry", "ann").score == 7.5
    assert "formgrader will not see" in caplog.text


def test_a_folder_with_none_of_the_notebooks_keeps_the_time_of_its_first_grading(course, hand_in):
    hand_in("ann", something_else=b"")
    write(course)
    with opened(course) as gradebook:
        session = gradebook.db
        long_ago = datetime(2001, 1, 1)
        session.add(SubmittedAssignment(assignment=gradebook.assignments[0], student=Student(id="ann"), timestamp=long_ago))
        session.commit()
    write(course, "ann")
    with opened(course) as gradebook:
        assert gradebook.find_submission("odometry", "ann").timestamp == long_ago


@pytest.mark.parametrize(("unchanged", "stays"), [(("pose_update", "encoders"), True), (("encoders",), False), ((), False)])
def test_a_submission_arrives_again_only_with_a_new_notebook(course, handed_in, unchanged, stays):
    handed_in("ann")
    write(course, "ann")
    with opened(course) as gradebook:
        gradebook.find_submission("odometry", "ann").timestamp = datetime(2001, 1, 1)
        gradebook.db.commit()
    write(course, "ann", unchanged=unchanged)
    with opened(course) as gradebook:
        assert (gradebook.find_submission("odometry", "ann").timestamp == datetime(2001, 1, 1)) == stays


def test_what_is_new_to_the_gradebook_arrived_with_its_notebooks_although_it_was_graded_before(course, handed_in, monkeypatch):
    handed_in("ann")
    monkeypatch.setattr("autograder.late.arrival", lambda folder, names: datetime(2001, 1, 1) if [*names] else None)
    write(course, "ann", unchanged=[*SCORES])
    with opened(course) as gradebook:
        assert gradebook.find_submission("odometry", "ann").timestamp == datetime(2001, 1, 1)


# what is configured wrongly

WRONG = {
    'c.AssignLatePenalties.plugin_class = "no_such_module.Plugin"\n': "no_such_module",
    'c.LateSubmissionPlugin.penalty_method = "double"\n': "double",
}


@pytest.mark.parametrize(("lines", "told"), WRONG.items(), ids=["a plug-in that is not there", "a method that is not there"])
def test_a_penalty_that_is_configured_wrongly_is_told_before_anything_is_graded(course, configured, lines, told):
    configured(lines)
    with pytest.raises(LatePenaltyError, match=f"nbgrader_config.py does not work: .*{told}"):
        LatePenalties(course)


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_plug_in_that_fails_says_for_whom_and_leaves_the_submission_as_it_was(course, configured, handed_in):
    configured(CUSTOM)
    handed_in("eve")
    write(course)
    due(course, LONG_AGO)
    with pytest.raises(LatePenaltyError, match=r"HalfAndMore cannot say what 'eve' loses for being \d+ s late: KeyError: 'eve'"):
        write(course, "eve")
    with opened(course) as gradebook:
        assert gradebook.assignment_submissions("odometry") == []


def test_a_run_over_a_class_ends_with_that_message(course, configured, handed_in):
    configured('c.LateSubmissionPlugin.penalty_method = "double"\n')
    handed_in("ann")
    with pytest.raises(BatchError, match=r"c\.AssignLatePenalties in nbgrader_config\.py does not work"):
        grade_class(course, "odometry", Options(sandbox=False))
