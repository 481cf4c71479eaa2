"""Attacks by what lies in submitted/: kinds of files, their names, what lies beside them, and what changes meanwhile."""

import contextlib
import datetime
import json
import os
import re
import shutil
import socket
import stat
import tempfile
import threading
import unicodedata
import zipfile
from pathlib import Path

import numpy as np
import pytest

from autograder.reference import NOTEBOOKS
from autograder.submissions import students_with, submitted_notebooks
from tests.attacks.lineup import HONEST, Graded, Lineup, Outcome, answered, bare, sources
from tests.classroom import ASSIGNMENT, Classroom, graded_cell, solved, with_answer, with_cell

pytestmark = [pytest.mark.sandbox, pytest.mark.timeout(1800)]
LINEUP = Lineup()
RIGHT = "pose_step"
EXERCISES = NOTEBOOKS["odometry/pose_update"]
SECRET = "nobody may read this"


def notebook():
    """A notebook that deserves 5 points."""
    return answered(RIGHT)


def worth_all(path):
    """A notebook with all answers right and a secret, outside of the student's folder."""
    outside = path.parents[3] / "outside"
    outside.mkdir(exist_ok=True)
    target = outside / f"{path.parents[1].name}.ipynb"
    Classroom.write(target, with_cell(bare(solved()), f"# {SECRET}"))
    return target


def beside(name, content=b"", *, at="."):
    """Something that lies beside a notebook worth 5 points; `content` may be a function that makes it at its path."""

    def lay(path):
        Classroom.write(path, notebook())
        target = path.parent / at / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if callable(content):
            content(target)
        else:
            target.write_bytes(content)

    return lay


# 26 to 28: what is no ordinary file


def in_place_of_the_folder(make):
    """Puts something where the assignment's folder should be."""

    def lay(path):
        path.parent.rmdir()
        make(path.parent)

    return lay


def linked_folder(folder):
    target = worth_all(folder / "x").parent / f"folder of {folder.parent.name}"
    target.mkdir()
    Classroom.write(target / "pose_update.ipynb", with_cell(bare(solved()), f"# {SECRET}"))
    folder.symlink_to(target)


def device(path):
    try:
        os.mknod(path, stat.S_IFCHR | 0o644, os.makedev(1, 5))
    except PermissionError:  # only root may make one, and not everywhere
        os.mkfifo(path)


def unix_socket(path):
    here = Path.cwd()
    os.chdir(path.parent)  # a socket's path must be short
    try:
        with socket.socket(socket.AF_UNIX) as made:
            made.bind(path.name)
    finally:
        os.chdir(here)


def chain(path):
    path.with_name("a").symlink_to(worth_all(path))
    path.with_name("b").symlink_to("a")
    path.symlink_to("b")


@LINEUP.lays(
    {
        "to a file": lambda path: path.symlink_to(worth_all(path)),
        "to a file, relative": lambda path: path.symlink_to(os.path.relpath(worth_all(path), path.parent)),
        "to the honest student": lambda path: path.symlink_to(f"../../{HONEST}/odometry/pose_update.ipynb"),
        "to a link to a link": chain,
        "to itself": lambda path: path.symlink_to(path.name),
        "to nowhere": lambda path: path.symlink_to("nowhere"),
        "to our release": lambda path: path.symlink_to("../../../release/en/odometry/pose_update.ipynb"),
        "to the gradebook": lambda path: path.symlink_to("../../../gradebook.db"),
        "to passwords": lambda path: path.symlink_to("/etc/passwd"),
        "to zeros without end": lambda path: path.symlink_to("/dev/zero"),
        "to the terminal": lambda path: path.symlink_to("/dev/tty"),
        "to our own memory": lambda path: path.symlink_to("/proc/self/environ"),
        "to our own descriptor": lambda path: path.symlink_to("/proc/self/fd/0"),
    }
)
def test_026_a_link_is_not_followed(outcome):
    outcome.assert_earns()
    assert not re.search(f"{SECRET}|root:", outcome.shown)


@LINEUP.lays(
    {
        "linked": in_place_of_the_folder(linked_folder),
        "linked to the honest student": in_place_of_the_folder(lambda folder: folder.symlink_to(f"../{HONEST}/odometry")),
        "linked to the root": in_place_of_the_folder(lambda folder: folder.symlink_to("/")),
        "linked to itself": in_place_of_the_folder(lambda folder: folder.symlink_to(folder.name)),
        "linked to nowhere": in_place_of_the_folder(lambda folder: folder.symlink_to("nowhere")),
        "a file": in_place_of_the_folder(lambda folder: folder.write_bytes(b"x")),
        "a pipe": in_place_of_the_folder(os.mkfifo),
    }
)
def test_026_what_is_no_folder_of_the_assignment_gets_zero_with_a_reason(outcome):
    outcome.assert_earns()
    assert SECRET not in outcome.shown


@LINEUP.lays(
    {
        "folder": lambda path: path.mkdir(),
        "full folder": lambda path: (path.mkdir(), Classroom.write(path / "pose_update.ipynb", solved())),
        "pipe": os.mkfifo,
        "socket": unix_socket,
        "device": device,
        "hard link": lambda path: os.link(worth_all(path), path),
        "hard link within": lambda path: (Classroom.write(path.with_name("a"), notebook()), os.link(path.with_name("a"), path)),
        "sparse terabyte": lambda path: (path.touch(), os.truncate(path, 2**40)),
        "executable that is none": lambda path: (path.write_bytes(b"#!/bin/sh\ntouch /tmp/evil\n"), path.chmod(0o4755)),
    }
)
def test_028_what_is_no_file_of_its_own_gets_zero_with_a_reason(outcome):
    outcome.assert_earns()
    assert SECRET not in outcome.shown


@LINEUP.lays({"nothing at all": lambda path: None})
def test_028_a_folder_without_a_notebook_gets_zero_with_a_reason(outcome):
    outcome.assert_earns()
    assert all(re.search("not handed in|提出されていません", message) for message in outcome.messages)


# 29 and 30: what an archive could leave behind when it was unpacked


def elsewhere(*names):
    """All answers right, in files of other names only."""

    def lay(path):
        for name in names:
            target = path.parent / name
            target.parent.mkdir(parents=True, exist_ok=True)
            Classroom.write(target, bare(solved()))

    return lay


def archive(path):
    with zipfile.ZipFile(path, "w") as made:
        made.writestr("pose_update.ipynb", json.dumps(bare(solved())))
        made.writestr("../../../gradebook.db", b"")


@LINEUP.lays(
    {
        "a folder deeper": elsewhere("odometry/pose_update.ipynb", "pose_update/pose_update.ipynb"),
        "names of paths": elsewhere(
            "..\\pose_update.ipynb", "C:\\pose_update.ipynb", "%2e%2e%2fpose_update.ipynb", "\\pose_update.ipynb"
        ),
        "a student in a student": elsewhere(
            f"submitted/{HONEST}/odometry/pose_update.ipynb", f"{HONEST}/odometry/pose_update.ipynb"
        ),
        "an archive": lambda path: archive(path.with_name("pose_update.zip")),
        "an archive in place": archive,
        "a resource fork": elsewhere("__MACOSX/._pose_update.ipynb", "._pose_update.ipynb"),
    }
)
def test_029_an_archive_unpacked_to_another_place_is_not_searched(outcome):
    outcome.assert_earns()


def many_files(folder):
    folder.mkdir()
    for number in range(2000):
        (folder / str(number)).touch()


def deep_folders(path):
    here = os.open(path.parent, os.O_RDONLY)
    for _ in range(300):  # deeper than a path can be long
        os.mkdir("d" * 50, dir_fd=here)
        inner = os.open("d" * 50, os.O_RDONLY, dir_fd=here)
        os.close(here)
        here = inner
    os.close(here)


def sparse(path):
    path.touch()
    os.truncate(path, 2**42)


@LINEUP.lays(
    {
        "many files": beside("many", many_files),
        "deep folders": beside("deep", deep_folders),
        "sparse file": beside("big.bin", sparse),
        "link upwards": beside("up", lambda path: path.symlink_to("../../..")),
        "link to the root": beside("root", lambda path: path.symlink_to("/")),
        "link in a circle": beside("here", lambda path: path.symlink_to(".")),
        "archives": beside("more.zip", archive),
        "pipe": beside("encoders", os.mkfifo),
        "other notebook is a link": beside(
            "encoders.ipynb", lambda path: path.symlink_to(f"../../{HONEST}/odometry/pose_update.ipynb")
        ),
        "other notebook is a pipe": beside("encoders.ipynb", os.mkfifo),
        "other notebook is a folder": beside("encoders.ipynb", Path.mkdir),
        "names without end": beside("n" * 255),
        "names of other bytes": beside(os.fsdecode(b"\xff\xfe\x01\n")),
        "names like options": beside("--db=sqlite:///evil.db"),
    }
)
def test_030_what_an_archive_leaves_beside_a_notebook_does_not_matter(outcome):
    outcome.assert_earns(RIGHT)
    assert outcome.graded.room.total(outcome.student, "encoders") == 0
    assert not (outcome.graded.room.root / f"autograded/{outcome.student}/odometry/up").exists()


# 32 to 34: names and times that claim something


@LINEUP.lays(
    {
        "file": elsewhere(
            f"{HONEST}_attempt_2026-01-01_pose_update.ipynb", f"{HONEST}.ipynb", f"odometry_{HONEST}_pose_update.ipynb"
        ),
        "metadata": lambda path: Classroom.write(
            path,
            {**answered(), "metadata": {"student": HONEST, "nbgrader": {"student_id": HONEST}, "authors": [{"name": HONEST}]}},
        ),
        "cells": lambda path: Classroom.write(path, with_cell(answered(), f"student_id = '{HONEST}'\nscore = 40")),
    }
)
def test_032_who_somebody_is_stands_in_no_file(outcome):
    outcome.assert_earns()
    folders = {entry.name for entry in os.scandir(outcome.graded.room.root / "autograded")}
    assert folders <= set(map(outcome.graded.id_of, outcome.graded.students))


@LINEUP.lays(
    {
        "long ago": beside("timestamp.txt", b"2001-01-01 00:00:00 UTC"),
        "to come": beside("timestamp.txt", b"2999-12-31 23:59:59.999999 UTC"),
        "the file itself": lambda path: (Classroom.write(path, notebook()), os.utime(path, (0, 0))),
        "before 1970": lambda path: (Classroom.write(path, notebook()), os.utime(path, (-(2**33), -(2**33)))),
        "far ahead": lambda path: (Classroom.write(path, notebook()), os.utime(path, (2**35, 2**35))),
        "the folder": lambda path: (Classroom.write(path, notebook()), os.utime(path.parent, (0, 0))),
    }
)
def test_033_the_time_is_the_servers(outcome):
    outcome.assert_earns(RIGHT)
    now = datetime.datetime.now(datetime.UTC).replace(tzinfo=None)
    assert abs(now - outcome.graded.times[outcome.student]) < datetime.timedelta(days=1)


@LINEUP.lays(
    {
        "words": beside("timestamp.txt", b"yesterday"),
        "nothing": beside("timestamp.txt", b""),
        "bytes": beside("timestamp.txt", b"\xff\x00\xfe"),
        "a folder": beside("timestamp.txt", Path.mkdir),
        "a pipe": beside("timestamp.txt", os.mkfifo),
        "a link": beside("timestamp.txt", lambda path: path.symlink_to("/dev/zero")),
        "huge": beside("timestamp.txt", sparse),
        "year 10000": beside("timestamp.txt", b"10000-01-01 00:00:00 UTC"),
        "no such zone": beside("timestamp.txt", b"2026-01-01 00:00:00 Mars/Olympus"),
    }
)
def test_034_no_timestamp_leaves_a_student_without_a_score(outcome):
    outcome.assert_earns(RIGHT)


# 35 to 37: what Python and its friends pick up where they start


def surrounded_by(content, *names):
    def lay(path):
        Classroom.write(path, notebook())
        for name in names:
            target = path.parent / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)

    return lay


ENDS = b"import os\nprint('picked up')\nos._exit(0)\n"


@LINEUP.lays(
    {
        "libraries": surrounded_by(ENDS, "numpy.py", "json.py", "matplotlib.py", "IPython/__init__.py", "sympy.py", "ast.py"),
        "ours": surrounded_by(ENDS, "course.py", "course/__init__.py", "autograder/__init__.py", "nbgrader_config.py"),
        "start-up": surrounded_by(ENDS, "sitecustomize.py", "usercustomize.py", "python311._pth", "pyvenv.cfg"),
        "paths": surrounded_by(b"import os; os._exit(0)", "evil.pth", "distutils-precedence.pth"),
        "compiled": surrounded_by(b"\xa7\r\r\n" + bytes(12) + b"x", "__pycache__/numpy.cpython-311.pyc", "numpy.pyc"),
    }
)
def test_035_modules_beside_the_notebook_are_not_picked_up(outcome):
    outcome.assert_earns(RIGHT)
    assert "picked up" not in outcome.shown


@LINEUP.lays(
    {
        "IPython": surrounded_by(
            b"c = get_config()\nc.InteractiveShellApp.exec_lines = ['import os; os._exit(0)']\n",
            *("ipython_config.py", "ipython_kernel_config.py", ".ipython/profile_default/ipython_config.py"),
        ),
        "start-up files": surrounded_by(ENDS, ".ipython/profile_default/startup/00-first.py", ".pythonrc.py", ".pdbrc"),
        "Matplotlib": surrounded_by(
            b"backend: module://evil\n", "matplotlibrc", ".matplotlibrc", ".config/matplotlib/matplotlibrc"
        ),
        "tests": surrounded_by(ENDS, "conftest.py", "pytest.ini", "tox.ini", "setup.py", "setup.cfg", "pyproject.toml"),
        "nbgrader": surrounded_by(ENDS, "nbgrader_config.py", "jupyter_config.py", ".jupyter/jupyter_nbconvert_config.py"),
        "templates": surrounded_by(b"{{ 1/0 }}", "feedback.tpl", "templates/feedback/index.html.j2"),
        "environment": surrounded_by(
            b"PYTHONSTARTUP=x.py\nLD_PRELOAD=./x.so\n", ".env", ".bashrc", ".profile", "environment.txt"
        ),
    }
)
def test_036_no_configuration_of_the_student_is_picked_up(outcome):
    outcome.assert_earns(RIGHT)
    assert "picked up" not in outcome.shown


def library(path):
    """The right answers in modules, arrays and pickles beside a notebook that only loads them."""
    right = {name: graded_cell(solved(), name)["source"] for name in EXERCISES}
    path.with_name("answers.py").write_text(
        "import numpy as np\nimport sympy as sp\n" + "\n\n".join(right.values()), encoding="utf-8"
    )
    path.with_name("answers.so").write_bytes(b"\x7fELF" + bytes(100))
    np.save(path.with_name("answers.npy"), np.eye(3))
    path.with_name("answers.pkl").write_bytes(b"cnumpy\neye\n(I3\ntR.")
    made = with_cell(answered(), "from answers import *")
    made = with_cell(made, "import ctypes; ctypes.CDLL('./answers.so')")
    made = with_answer(made, "planar_rotation", "matrix = np.load('answers.npy')\ndef planar_rotation(theta): return matrix")
    made = with_answer(
        made, "displacement", "import pickle\nmade = pickle.load(open('answers.pkl', 'rb'))\ndef displacement(*_): return made"
    )
    Classroom.write(path, made)


@LINEUP.lays({"modules, arrays, pickles": library})
def test_037_only_the_notebook_is_taken(outcome):
    outcome.assert_earns()


# in ways that nobody has listed


@LINEUP.lays(
    {
        "in capitals": elsewhere("Pose_Update.ipynb", "POSE_UPDATE.IPYNB"),
        "with white space": elsewhere("pose_update.ipynb ", " pose_update.ipynb", "pose_update .ipynb", "pose_update.ipynb\n"),
        "in wide letters": elsewhere("ｐose_update.ipynb", "pose＿update.ipynb"),
        "with something invisible": elsewhere("pose\u200b_update.ipynb", "\ufeffpose_update.ipynb", "pose_update\u00ad.ipynb"),
        "as a copy": elsewhere(
            "pose_update-Copy1.ipynb", "pose_update.ipynb~", ".ipynb_checkpoints/pose_update-checkpoint.ipynb"
        ),
        "with another ending": elsewhere("pose_update.json", "pose_update", "pose_update.ipynb.gz", "pose_update.py"),
    }
)
def test_a_name_that_only_looks_like_the_notebooks_is_not_its_name(outcome):
    outcome.assert_earns()
    assert all(re.search("not handed in|提出されていません", message) for message in outcome.messages)


def more_beside(path):
    elsewhere("pose_update-Copy1.ipynb", "Pose_Update.ipynb", "pose_update.ipynb.orig", "solution.ipynb")(path)
    Classroom.write(path, notebook())


@LINEUP.lays(
    {"copies": more_beside, "other contents": lambda path: Classroom.write(path.with_name("encoders.ipynb"), notebook())}
)
def test_what_counts_is_the_notebook_of_that_name(outcome):
    outcome.assert_earns(*([RIGHT] if "copies" in outcome.student else []))
    assert outcome.graded.room.total(outcome.student, "encoders") == 0


def with_mode(mode, of):
    def lay(path):
        Classroom.write(path, notebook())
        of(path).chmod(mode)

    return lay


@LINEUP.lays(
    {
        "the file": with_mode(0, lambda path: path),
        "the folder": with_mode(0, lambda path: path.parent),
        "setuid": with_mode(0o6777, lambda path: path),
        "folder without listing": with_mode(0o111, lambda path: path.parent),
    }
)
def test_permissions_leave_nobody_without_a_score(outcome):
    # root may read all of them
    outcome.assert_earns_at_most(RIGHT)


@pytest.mark.skipif(os.geteuid() != 0, reason="becomes another user to lose the permission to read")
@pytest.mark.parametrize("closed", ["submitted/a", "submitted/a/odometry", "submitted/a/odometry/pose_update.ipynb"])
def test_what_may_not_be_read_stops_nobody_else(closed):
    root = Path(tempfile.mkdtemp())
    try:
        for student in ("a", "b"):
            folder = root / "submitted" / student / ASSIGNMENT
            folder.mkdir(parents=True)
            (folder / "pose_update.ipynb").write_bytes(b"{}")
        root.chmod(0o755)
        (root / closed).chmod(0)
        os.seteuid(65534)
        try:
            found = students_with(root, ASSIGNMENT)
            handed_in = {student: submitted_notebooks(root, student, ASSIGNMENT) for student in found}
        finally:
            os.seteuid(0)
    finally:
        shutil.rmtree(root)
    assert list(found) == ["a", "b"]
    assert handed_in["b"]["pose_update"] == b"{}"
    assert not isinstance(handed_in["a"]["pose_update"], bytes)


NAMES = [
    'o\'brien "the" `id` $(id) ${HOME}',
    "x'); DROP TABLE student; --",
    "new\nline",
    "tab\tand\x01\x1b[2Jescape",
    "-rf",
    "--help",
    "...",
    "..%2f..%2f",
    "..\\..\\windows",
    " leading and trailing ",
    "=cmd|' calc'!A0",
    "@SUM(1+1)*cmd|' calc'!A0",
    "+1-2",
    "<img src=x onerror=alert(1)>",
    "{{ 7*7 }}{0.__class__}%s%n",
    "*",
    "[a-z]?",
    "~root",
    "a,b;c|d",
    ".hidden",
    "con",
    "student.",
    "admin\u202etxt.x",
    "😀" * 60,
    "x" * 255,
    "山田 太郎",
    unicodedata.normalize("NFC", "zé"),
    unicodedata.normalize("NFD", "zé"),
    HONEST.upper(),
    f"{HONEST} ",
    f"{HONEST}\u200b",
    "None",
    "0",
    "gradebook.db",
]


@LINEUP.called(dict.fromkeys(NAMES, notebook))
def test_no_name_of_a_folder_confuses_the_grader(outcome):
    outcome.assert_earns(RIGHT)
    assert sources(outcome.executed)


BYTES = [os.fsdecode(name) for name in (b"caf\xe9", b"\xff\xfe", b"\xed\xa0\x80")]
LINKS = {"linked": "../outside", "linked-to-honest": HONEST, "linked-to-all": ".", "linked-to-itself": "linked-to-itself"}


@pytest.fixture(scope="module")
def graded_oddly(tmp_path_factory):
    """A class in which some names in submitted/ are no text, and some are no folders."""
    room = Classroom(tmp_path_factory.mktemp("odd") / "course")
    for student in BYTES:
        room.hand_in(student, notebook())
    (room.root / "outside" / ASSIGNMENT).mkdir(parents=True)
    Classroom.write(room.root / "outside" / ASSIGNMENT / "pose_update.ipynb", bare(solved()))
    for student, target in LINKS.items():
        (room.root / "submitted" / student).symlink_to(target)
    (room.root / "submitted" / "a file").touch()
    os.mkfifo(room.root / "submitted" / "a pipe")
    room.hand_in(HONEST, solved())
    room.grade()
    return Graded(room, frozenset([*BYTES, HONEST]))


def test_026_a_linked_student_is_no_student_of_the_class(graded_oddly):
    Outcome(graded_oddly, HONEST).assert_earns(*EXERCISES)
    assert {student for student, _ in graded_oddly.room.results} == {*map(graded_oddly.id_of, BYTES), HONEST}


def test_a_name_that_is_no_text_keeps_nobody_else_from_a_score(graded_oddly):
    Outcome(graded_oddly, HONEST).assert_earns(*EXERCISES)


@pytest.mark.parametrize("student", BYTES, ids=ascii)
def test_a_name_that_is_no_text_gets_a_definite_score(graded_oddly, student):
    Outcome(graded_oddly, graded_oddly.id_of(student)).assert_earns(RIGHT)


# 39: what changes while it is graded


def full(mark):
    return json.dumps(with_cell(bare(solved()), f"# {mark}")).encode()


def replaced(path, content):
    """Put content, or a link to a path, in place of a file, at once."""
    made = path.with_name("next")
    with contextlib.suppress(FileNotFoundError):
        made.unlink()
    if isinstance(content, bytes):
        made.write_bytes(content)
    else:
        made.symlink_to(content)
    os.replace(made, path)


def grows(path):
    """Written slowly, in place."""
    content = full("right")
    with path.open("wb") as file:
        for start in range(0, len(content), 500):
            file.write(content[start : start + 500])
            file.flush()


@pytest.fixture(scope="module")
def raced(tmp_path_factory):
    """A class whose submissions change all the time while they are graded."""
    room = Classroom(tmp_path_factory.mktemp("race") / "course")
    paths = {student: room.hand_in(student, full("right")) for student in ("replaced", "linked", "growing", "vanishing")}
    room.hand_in(HONEST, solved())
    secret = worth_all(paths["linked"])
    nothing = json.dumps(with_cell(answered(), "# wrong")).encode()
    over = threading.Event()
    changed = [0]

    def change():
        while not over.is_set():
            for content in (full("right"), nothing):
                replaced(paths["replaced"], content)
            for content in (nothing, secret):
                replaced(paths["linked"], content)
            grows(paths["growing"])
            paths["vanishing"].unlink(missing_ok=True)
            replaced(paths["vanishing"], nothing)
            changed[0] += 1

    thread = threading.Thread(target=change)
    thread.start()
    try:
        room.grade()
    finally:
        over.set()
        thread.join()
    assert changed[0] > 10
    return Graded(room, frozenset([*paths, HONEST]))


def test_039_a_submission_that_is_replaced_is_graded_as_one_of_the_two(raced):
    outcome = Outcome(raced, "replaced")
    text = "".join(sources(outcome.executed))
    assert ("# right" in text) != ("# wrong" in text)
    outcome.assert_earns(*(EXERCISES if "# right" in text else ()))


def test_039_a_link_put_in_place_of_a_file_is_never_followed(raced):
    outcome = Outcome(raced, "linked")
    outcome.assert_earns()
    assert SECRET not in outcome.shown


@pytest.mark.parametrize("student", ["growing", "vanishing"])
def test_039_a_submission_that_is_written_meanwhile_gets_a_definite_score(raced, student):
    outcome = Outcome(raced, student)
    text = "".join(sources(outcome.executed))
    outcome.assert_earns(*(EXERCISES if "# right" in text else ()))


def test_nothing_that_was_handed_in_is_changed(graded):
    honest = graded.room.root / f"submitted/{HONEST}/{ASSIGNMENT}/pose_update.ipynb"
    assert json.loads(honest.read_bytes()) == solved()
    # formgrader wants the time of arrival there, and has it from us
    assert sorted(entry.name for entry in os.scandir(honest.parent)) == ["pose_update.ipynb", "timestamp.txt"]


def test_nothing_is_written_where_a_student_wants_it(graded):
    assert not list(graded.room.root.glob("*evil*"))
    assert not Path("/tmp/evil").exists()
