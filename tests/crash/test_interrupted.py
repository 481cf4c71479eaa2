"""Whatever ends a grader or stands in its way: the next run makes the gradebook what it would have been, nothing lost or doubled."""

import json
import os
import pickle
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
from pathlib import Path

import pytest

from autograder import batch, receipts, settings
from autograder.batch import BatchError
from tests.classroom import Classroom
from tests.crash.grader import ROOT, Grader, command, grade_to_the_end, groups_of, parent_of, until
from tests.crash.program import LIMITS
from tests.small_class import TOTALS, Undisturbed, differences, new_class, put_secret, state

pytestmark = pytest.mark.sandbox


def later(*values):
    """Return values of a parameter that are tried in the time that is left."""
    return [pytest.param(value, marks=pytest.mark.slow) for value in values]


@pytest.fixture
def classroom(undisturbed, tmp_path) -> Classroom:
    """The class has handed in, and nothing is graded yet."""
    return new_class(tmp_path / "course", undisturbed.secret)


@pytest.fixture
def replayed(undisturbed, monkeypatch) -> list[str]:
    """No notebook runs: the workers say what they said in the undisturbed run. The names of those who are graded come here."""
    names = []

    def graded(works, open_pool):
        for work, notebooks in undisturbed.replayed(works, open_pool):
            names.append(work.student)
            yield work, notebooks

    monkeypatch.setattr(batch, "graded", graded)
    return names


@pytest.fixture
def graded_class(undisturbed, tmp_path, replayed) -> Classroom:
    """A copy of the class that was graded undisturbed; nothing runs from here on."""
    shutil.copytree(undisturbed.root, tmp_path / "course", symlinks=True)
    return Classroom.at(tmp_path / "course")


def done(root: Path) -> list[str]:
    return [path.parent.name for path in root.glob(".autograder/receipts/odometry/*/receipt.json")]


# the grader is killed

SEED = 20
#: how often the grader is killed in each course before it is let finish
CHAINS = (1, 2, 3, 3, 3, 4, 4)


@pytest.mark.slow
@pytest.mark.parametrize("chain", range(len(CHAINS)))
def test_a_grader_that_is_killed_at_random_moments_loses_and_doubles_nothing(undisturbed, tmp_path, chain):
    moments = random.Random(SEED + chain)
    kills = course = 0
    pids: set[int] = set()
    while kills < CHAINS[chain]:
        # where it was done before it could be killed the next one begins anew
        course += 1
        root = new_class(tmp_path / str(course), undisturbed.secret).root
        while kills < CHAINS[chain] and killed_after(moments.uniform(0.0, undisturbed.seconds), root, pids):
            kills += 1
            # what has a receipt is there, whole
            assert_same(root, undisturbed, done(root))
        grade_to_the_end(root)
        assert_same(root, undisturbed)
    assert groups_of(pids) == []


def killed_after(seconds: float, root: Path, pids: set[int]) -> bool:
    """Start a grader and kill it after this time; return whether it was still at work."""
    with Grader(root) as grader:
        end = time.monotonic() + seconds
        until(
            lambda: grader.left() is not None and (time.monotonic() > end or grader.process.poll() is not None), "{}", grader.said
        )
        alive = grader.process.poll() is None
        grader.process.kill()
    pids |= grader.pids
    return alive


def assert_same(root: Path, undisturbed: Undisturbed, students=TOTALS) -> None:
    if not students:
        return
    found, expected = state(root).of(students), undisturbed.state.of(students)
    if len(students) < len(TOTALS):
        # one of the others may have been written, and not have its receipt yet
        found = found._replace(rows=found.rows & expected.rows)
    assert differences(found, expected) == []


@pytest.mark.slow
def test_a_grader_that_is_killed_before_anything_that_it_writes_loses_and_doubles_nothing(undisturbed, tmp_path):
    """With the workers' answers of the undisturbed run, so that many moments can be tried."""
    (tmp_path / "pickle").write_bytes(pickle.dumps(undisturbed))
    programs = str(Path(sys.executable).parent)
    tried = subprocess.run(
        [sys.executable, "-m", "tests.crash.moments", str(tmp_path / "pickle"), str(tmp_path)],
        env={**os.environ, "PYTHONPATH": str(ROOT), "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}"},
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert tried.returncode == 0, tried.stderr
    moments = [line.split("\t") for line in tried.stdout.splitlines()]
    what = {label for _, label, _ in moments}
    assert {"CREATE TABLE", "INSERT INTO grade", "commit", "os.rename /autograded/*/odometry/pose_update.ipynb"} <= what
    assert {"os.rename /.autograder/receipts/odometry/*/receipt.json", "os.mkdir /autograded/*", "UPDATE grade SET"} <= what
    whole = state(tmp_path / "whole")
    assert differences(whole, undisturbed.state.of(["partly", "unreadable", "written"])._replace(rows=whole.rows)) == []
    different = [
        (number, label, end, differences(state(tmp_path / number), whole)[:3])
        for number, label, end in moments
        if end != "graded" or state(tmp_path / number) != whole
    ]
    assert different[:5] == []


@pytest.mark.parametrize("end", [signal.SIGINT, *later(signal.SIGTERM, signal.SIGHUP)])
def test_a_grader_that_is_told_to_stop_says_so_and_leaves_no_process(undisturbed, classroom, end):
    with Grader(classroom.root) as grader:
        grader.until_looping()
        grader.process.send_signal(end)
        assert grader.ended() == 1
        assert "Stopped. What was graded so far is in the gradebook; type the same command again for the rest." in grader.said()
        assert "Traceback" not in grader.said()
    first = done(classroom.root)
    assert "loops" not in first
    assert groups_of(grader.pids) == []
    assert_same(classroom.root, undisturbed, first)
    grade_to_the_end(classroom.root)
    assert_same(classroom.root, undisturbed)


def test_ctrl_c_reaches_every_process_of_the_terminal_and_is_said_once(undisturbed, classroom):
    with Grader(classroom.root) as grader:
        grader.until_looping()
        # it leads its session, as in a terminal
        os.killpg(grader.process.pid, signal.SIGINT)
        assert grader.ended() == 1
        assert "Traceback" not in grader.said()
        assert grader.said().count("Stopped.") == 1


# a part of it is killed


def test_a_worker_that_is_killed_is_replaced_and_everybody_gets_what_they_deserve(undisturbed, classroom):
    with Grader(classroom.root) as grader:
        grader.until_looping()
        os.kill(grader.workers()[0], signal.SIGKILL)
        assert grader.ended() == 0, grader.said()
    assert_same(classroom.root, undisturbed)
    assert groups_of(grader.pids) == []


@pytest.mark.slow
def test_the_process_from_which_workers_come_may_be_killed(undisturbed, classroom):
    with Grader(classroom.root) as grader:
        grader.until_looping()
        [first] = {parent_of(pid) for pid in grader.workers()}
        os.kill(first, signal.SIGKILL)
        assert grader.ended() == 0, grader.said()
    assert_same(classroom.root, undisturbed)
    assert groups_of(grader.pids) == []


@pytest.mark.parametrize("which", ["bubblewrap", *later("its server")])
def test_a_sandbox_that_is_killed_costs_no_student_a_point(undisturbed, classroom, which):
    with Grader(classroom.root) as grader:
        grader.until_looping()
        for pid in sandboxes(grader, which):
            os.kill(pid, signal.SIGKILL)
        assert grader.ended() == 0, grader.said()
    assert_same(classroom.root, undisturbed)
    assert groups_of(grader.pids) == []


def sandboxes(grader: Grader, which: str) -> list[int]:
    """Return the outermost process of each sandbox, or the servers inside."""
    workers = grader.workers()
    outer = [pid for pid in grader.named("autograder.sandbox.forking") if parent_of(pid) in workers]
    if which == "bubblewrap":
        return outer
    inner = [pid for pid in grader.named("autograder.sandbox.forking") if not command(pid).startswith("bwrap")]
    return [pid for pid in inner if command(parent_of(pid)).startswith("bwrap")]


# something stands in its way


@pytest.fixture
def small_disk(tmp_path):
    """A file system of 4 MB."""
    folder = tmp_path / "disk"
    folder.mkdir()
    made = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=4m", "none", folder], capture_output=True, text=True, check=False)
    if made.returncode:
        # in CI nothing is left out
        (pytest.fail if os.environ.get("CI") else pytest.skip)(f"no file system can be mounted here: {made.stderr.strip()}")
    yield folder
    subprocess.run(["umount", "--lazy", folder], check=True)


@pytest.mark.usefixtures("replayed")
@pytest.mark.parametrize("room", [0, 500, *later(8, 100, 700, 900)])
def test_a_full_disk_is_said_and_grading_goes_on_when_there_is_room(undisturbed, small_disk, tmp_path, room):
    classroom = new_class(small_disk / "course")
    root = classroom.root
    if room:
        put_secret(root, undisturbed.secret)
    fill(small_disk / "filler", room)
    with pytest.raises(BatchError, match=r"No space left|disk is full|disk I/O error"):
        classroom.grade(limits=LIMITS)
    if (root / "gradebook.db").exists():
        assert_same(root, undisturbed, done(root))
    (small_disk / "filler").unlink()
    if not room:
        # no secret came to be: that of the undisturbed run has its place
        put_secret(root, undisturbed.secret)
    classroom.grade(limits=LIMITS)
    assert_same(root, undisturbed)
    assert not list(root.rglob(".new-*"))


def fill(path: Path, room: int) -> None:
    """Fill a file system up to so many KB."""
    free = os.statvfs(path.parent)
    path.write_bytes(bytes(free.f_bavail * free.f_frsize - room * 1024))


@pytest.mark.parametrize("when", ["before it begins", "once it has begun"])
def test_a_gradebook_that_another_program_holds_is_said(undisturbed, classroom, replayed, monkeypatch, when):
    monkeypatch.setattr(settings, "_LOCK_SECONDS", 0.2)
    path = classroom.root / "gradebook.db"
    if when == "before it begins":
        classroom.grade(limits=LIMITS, student="right")
    held = sqlite3.connect(path, isolation_level=None)

    def hold(count):
        for number, pair in enumerate(undisturbed.replayed(*count)):
            if number == 3:
                held.execute("BEGIN EXCLUSIVE")
            yield pair

    if when == "before it begins":
        held.execute("BEGIN EXCLUSIVE")
    else:
        monkeypatch.setattr(batch, "graded", lambda *given: hold(given))
    with pytest.raises(BatchError, match=r"locked.*another program has it open.*type the same command again"):
        classroom.grade(limits=LIMITS)
    held.execute("ROLLBACK")
    held.close()
    assert len(done(classroom.root)) == (1 if when == "before it begins" else 3)
    monkeypatch.setattr(batch, "graded", undisturbed.replayed)
    classroom.grade(limits=LIMITS)
    assert_same(classroom.root, undisturbed)


def test_a_gradebook_that_is_none_is_said(classroom, replayed):
    (classroom.root / "gradebook.db").write_bytes(b"no database" * 1000)
    with pytest.raises(BatchError, match=r"gradebook cannot be .*not a database"):
        classroom.grade(limits=LIMITS)
    assert (classroom.root / "gradebook.db").read_bytes() == b"no database" * 1000


def test_a_second_grader_says_that_there_is_one(undisturbed, classroom):
    with Grader(classroom.root) as first:
        first.until_graded(classroom.root, 1)
        with pytest.raises(BatchError, match="another grader is at work in this course"):
            classroom.grade(limits=LIMITS)
        assert first.ended() == 0, first.said()
    assert_same(classroom.root, undisturbed)


# what it left before is damaged


def shortened(share: float):
    return lambda content: content[: int(len(content) * share)]


def changed(**values):
    """One that is as if it had been written so."""

    def written_so(content):
        data = {**json.loads(content), **values}
        del data["digest"]
        return json.dumps(data | {"digest": receipts._digest(data)}).encode()

    return written_so


DAMAGE = {
    "empty": shortened(0.0),
    "half": shortened(0.5),
    "without its end": lambda content: content[:-1],
    "zeros": lambda content: bytes(len(content)),
    "no text": lambda content: b"\xff\xfe" + content,
    "another thing": lambda content: b"[1, 2]",
    "a number": lambda content: b"7",
    "no fields": lambda content: b"{}",
    "one field more": changed(more=1),
    "another version": changed(version=0),
    "another student's": changed(student="written"),
    "another score": lambda content: content.replace(b'"score": 5.0', b'"score": 4.0'),
    "another hash": lambda content: content.replace(b'"pose_update": ["', b'"pose_update": ["0'),
    "attempts that are none": lambda content: content.replace(b'"attempts": {', b'"attempts": 7, "was": {'),
}


@pytest.mark.parametrize("damage", DAMAGE.values(), ids=DAMAGE.keys())
def test_a_damaged_receipt_is_none_and_only_its_submission_is_graded_again(undisturbed, graded_class, replayed, damage):
    path = graded_class.root / ".autograder/receipts/odometry/partly/receipt.json"
    content = path.read_bytes()
    path.write_bytes(damage(content))
    assert path.read_bytes() != content
    graded_class.grade(limits=LIMITS)
    assert replayed == ["partly"]
    assert_same(graded_class.root, undisturbed)


def test_a_receipt_that_is_gone_is_made_again(undisturbed, graded_class, replayed):
    shutil.rmtree(graded_class.root / ".autograder/receipts/odometry/right")
    graded_class.grade(limits=LIMITS)
    assert replayed == ["right"]
    assert_same(graded_class.root, undisturbed)


@pytest.mark.parametrize("content", [b"", b"x" * 31, b"x" * 33])
def test_a_damaged_secret_is_said_and_nothing_is_graded_with_it(undisturbed, graded_class, replayed, content):
    path = graded_class.root / ".autograder/secret"
    path.write_bytes(content)
    with pytest.raises(BatchError, match=r"secret is damaged\. Put it back from a backup"):
        graded_class.grade(limits=LIMITS, regrade=True)
    assert replayed == []
    path.write_bytes(undisturbed.secret)
    graded_class.grade(limits=LIMITS, regrade=True)
    assert_same(graded_class.root, undisturbed)


@pytest.mark.parametrize("share", [0.0, 0.5, 0.99])
def test_a_truncated_notebook_in_autograded_is_made_again(undisturbed, graded_class, replayed, share):
    path = graded_class.root / "autograded/right/odometry/pose_update.ipynb"
    path.write_bytes(shortened(share)(path.read_bytes()))
    graded_class.grade(limits=LIMITS)
    assert replayed == ["right"]
    assert_same(graded_class.root, undisturbed)


def test_a_gradebook_from_which_something_is_gone_is_filled_again(undisturbed, graded_class, replayed):
    with sqlite3.connect(graded_class.root / "gradebook.db") as database:
        database.execute("DELETE FROM grade WHERE auto_score > 4")
    database.close()
    graded_class.grade(limits=LIMITS)
    assert set(replayed) == {"loops", "partly", "right", "written"}
    assert_same(graded_class.root, undisturbed)


def test_a_gradebook_that_is_gone_is_made_again(undisturbed, graded_class, replayed):
    (graded_class.root / "gradebook.db").unlink()
    graded_class.grade(limits=LIMITS)
    assert sorted(replayed) == sorted(TOTALS)
    assert_same(graded_class.root, undisturbed)


def test_nothing_is_done_where_nothing_is_wrong(undisturbed, graded_class, replayed):
    before = {path: path.stat().st_mtime_ns for path in graded_class.root.rglob("*") if path.name != "lock"}
    graded_class.grade(limits=LIMITS)
    assert replayed == []
    assert {path: path.stat().st_mtime_ns for path in graded_class.root.rglob("*") if path.name != "lock"} == before
