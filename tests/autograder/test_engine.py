import os
from concurrent.futures import Executor, Future

import pytest

from autograder import engine
from autograder.engine import (
    MissingReleaseError,
    Options,
    graded,
    release_notebooks,
    students_with,
    submitted_notebooks,
)
from autograder.intake import NOT_HANDED_IN
from autograder.session import Limits


class OneByOne(Executor):
    """Does the first work that waits, and another one whenever `done` is called."""

    def __init__(self):
        self.works, self.waiting, self.most = [], [], 0

    def submit(self, call, work):
        future = Future()
        self.works.append(work)
        self.waiting.append((future, call, work))
        self.most = max(self.most, len(self.waiting))
        if len(self.waiting) == 1:
            self.do_next()
        return future

    def do_next(self):
        future, call, work = self.waiting[0]
        future.set_running_or_notify_cancel()
        try:
            future.set_result(call(work))
        except Exception as error:
            future.set_exception(error)

    def done(self):
        del self.waiting[0]
        if self.waiting:
            self.do_next()


def all_of(root, options, executor):
    """Everything that is graded, each taken before the next is done."""
    found = []
    for student, notebooks in graded(root, "odometry", options, executor):
        found.append((student, notebooks))
        executor.done()
    return found


def submissions(root, *students, assignment="odometry"):
    for student in students:
        (root / "submitted" / student / assignment).mkdir(parents=True)


def test_students_are_the_folders_with_the_assignment(tmp_path):
    submissions(tmp_path, "s2", "s10", "s1", "x y")
    submissions(tmp_path, "other", assignment="imu")
    (tmp_path / "submitted/file").write_text("")
    (tmp_path / "submitted/link").symlink_to(tmp_path / "submitted/s1")
    (tmp_path / "submitted/linked").mkdir()
    (tmp_path / "submitted/linked/odometry").symlink_to(tmp_path / "submitted/s1/odometry")
    assert students_with(tmp_path, "odometry") == ["s1", "s10", "s2", "x y"]
    assert students_with(tmp_path, "odometry", "s?") == ["s1", "s2"]
    assert students_with(tmp_path, "odometry", "S*") == []
    assert students_with(tmp_path / "nowhere", "odometry") == []


def test_what_was_handed_in_comes_as_bytes_or_as_the_reason_why_not(hand_in, class_root):
    folder = hand_in("ann", pose_update=b"anything")
    assert submitted_notebooks(class_root, "ann", "odometry") == {"pose_update": b"anything", "encoders": NOT_HANDED_IN}
    os.symlink(class_root / "nbgrader_config.py", folder / "encoders.ipynb")
    assert "a link or a folder is not read" in submitted_notebooks(class_root, "ann", "odometry")["encoders"].en


def test_only_the_courses_notebooks_are_taken(hand_in, class_root):
    folder = hand_in("ann", pose_update=b"1", numpy=b"2")
    (folder / "numpy.py").write_text("")
    assert submitted_notebooks(class_root, "ann", "odometry").keys() == {"pose_update", "encoders"}


def test_the_release_is_read_in_both_languages(class_root):
    release = release_notebooks(class_root, "odometry")
    assert sorted(release) == [(language, name) for language in ("en", "ja") for name in ("encoders", "pose_update")]
    assert release["ja", "encoders"] == (class_root / "release/ja/odometry/encoders.ipynb").read_bytes()


def test_a_release_that_is_not_there_says_what_to_type(class_root):
    (class_root / "release/ja/odometry/encoders.ipynb").unlink()
    with pytest.raises(MissingReleaseError, match=r"not built yet: release/ja/odometry/encoders.ipynb. Type: autograder build"):
        release_notebooks(class_root, "odometry")


@pytest.fixture
def echoing(monkeypatch):
    """Grading that gives back the work that it was given."""
    monkeypatch.setattr(engine, "graded_submission", lambda work: [work])


@pytest.mark.usefixtures("echoing")
def test_each_submission_is_graded_once_with_the_options_given(hand_in, class_root):
    for student in ("ann", "bob", "cho"):
        hand_in(student, pose_update=student.encode())
    limits = Limits(cell=1.0)
    done = all_of(class_root, Options("[ab]*", sandbox=False, limits=limits), OneByOne())
    assert sorted(student for student, _ in done) == ["ann", "bob"]
    for student, [work] in done:
        assert (work.student, work.assignment, work.sandbox, work.limits) == (student, "odometry", False, limits)
        assert work.notebooks == {"pose_update": student.encode(), "encoders": NOT_HANDED_IN}
    assert len({work.slot for _, [work] in done}) == 2


@pytest.mark.usefixtures("echoing")
def test_only_so_many_submissions_are_in_memory_at_a_time(hand_in, class_root):
    for number in range(10):
        hand_in(f"s{number}", pose_update=b"")
    executor = OneByOne()
    assert len(all_of(class_root, Options(workers=2), executor)) == 10
    assert len(executor.works) == 10
    # two workers, and one piece of work ahead for each
    assert executor.most == 4


def test_a_fault_reaches_the_caller(hand_in, class_root, monkeypatch):
    def fail(work):
        raise RuntimeError("no sandbox")

    monkeypatch.setattr(engine, "graded_submission", fail)
    hand_in("ann", pose_update=b"")
    with pytest.raises(RuntimeError, match="no sandbox"):
        list(graded(class_root, "odometry", Options(), OneByOne()))


def test_nobody_handed_in(class_root):
    assert list(graded(class_root, "odometry", Options(), OneByOne())) == []


def test_processes_of_its_own(root, tmp_path):
    """With the course itself: a process does not see what a test put into the table of contents."""
    for student, content in (("ann", b""), ("bob", b"[]")):
        folder = tmp_path / "submitted" / student / "odometry"
        folder.mkdir(parents=True)
        (folder / "pose_update.ipynb").write_bytes(content)
    (tmp_path / "release").symlink_to(root / "release")
    done = dict(graded(tmp_path, "odometry", Options(workers=1)))
    assert {
        (student, notebook.notebook): {result.status for result in notebook.results}
        for student, notebooks in done.items()
        for notebook in notebooks
    } == {
        **{(student, "pose_update"): {"unreadable"} for student in ("ann", "bob")},
        **{(student, "encoders"): {"missing"} for student in ("ann", "bob")},
    }
