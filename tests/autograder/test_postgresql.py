"""The gradebook in a real PostgreSQL server: the same as in SQLite."""

import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from autograder import batch, doctor
from autograder.batch import BatchError
from tests.classroom import Classroom, solved
from tests.crash.program import LIMITS
from tests.small_class import TOTALS, differences, gradebook_rows, new_class, state

pytestmark = [pytest.mark.postgresql, pytest.mark.sandbox, pytest.mark.xdist_group("postgresql")]

LONG = "x" * 199
#: names that a database, an address or a shell could take for something else; folders may be called so
ODD_NAMES = [
    f"{LONG}a",
    f"{LONG}b",
    "学生 一",
    "o'brien",
    'a"b; DROP TABLE grade;--',
    "100%",
    "a\\b",
    "%(x)s:y",
    "tab\tand\nline",
    "é",
]


class Server(NamedTuple):
    """A PostgreSQL server in a folder of its own, which listens on a socket there and nowhere else."""

    folder: Path
    programs: Path

    def run(self, program: str, *arguments: str) -> None:
        # it refuses to be run by root
        user = ["setpriv", "--reuid=nobody", "--regid=nogroup", "--clear-groups"] if os.getuid() == 0 else []
        command = [*user, str(self.programs / program), *arguments]
        done = subprocess.run(
            command, cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False
        )  # fmt: skip
        assert done.returncode == 0, f"{program}: {done.stdout}"

    def start(self) -> None:
        options = f"-k {self.folder} -c listen_addresses= -c fsync=off"
        self.run("pg_ctl", "start", "--wait", "-D", f"{self.folder}/data", "-l", f"{self.folder}/log", "-o", options)

    def stop(self, mode: str = "immediate") -> None:
        self.run("pg_ctl", "stop", "--wait", "-D", f"{self.folder}/data", "-m", mode)

    def url(self, database: str, kind: str = "postgresql+psycopg") -> str:
        self.run("createdb", "-h", str(self.folder), "-U", "ta", database)
        return f"{kind}://ta@/{database}?host={self.folder}"


@pytest.fixture(scope="module")
def server() -> Iterator[Server]:
    found = shutil.which("initdb") or str(max(Path("/usr/lib/postgresql").glob("*/bin/initdb")))
    # not below pytest's own folder: nobody else may look into that, and a socket's path must be short
    with tempfile.TemporaryDirectory(prefix="pg-") as folder:
        if os.getuid() == 0:
            shutil.chown(folder, "nobody", "nogroup")
        made = Server(Path(folder), Path(found).resolve().parent)
        made.run("initdb", "-D", f"{folder}/data", "-U", "ta", "-A", "trust", "-E", "UTF8", "--no-sync")
        made.start()
        yield made
        made.stop()


def use_database(root: Path, url: str) -> None:
    with (root / "nbgrader_config.py").open("a") as file:
        file.write(f"c.CourseDirectory.db_url = {url!r}\n")


@pytest.fixture(scope="module")
def graded_class(undisturbed, server, tmp_path_factory) -> Classroom:
    """The class, graded into a new database."""
    classroom = new_class(tmp_path_factory.mktemp("class") / "course", undisturbed.secret)
    use_database(classroom.root, server.url("grades"))
    classroom.grade(limits=LIMITS, workers=2)
    return classroom


@pytest.fixture
def another_class(undisturbed, server, tmp_path, monkeypatch, request) -> Classroom:
    """A class of which nothing is graded yet, with an empty database; the workers say what they said in the undisturbed run."""
    monkeypatch.setattr(batch, "graded", undisturbed.replayed)
    classroom = new_class(tmp_path / "course", undisturbed.secret)
    use_database(classroom.root, server.url(request.function.__name__[:60], "postgresql"))
    return classroom


def test_a_class_gets_in_postgresql_what_it_gets_in_sqlite(undisturbed, graded_class):
    assert differences(state(graded_class.root), undisturbed.state) == []
    assert not (graded_class.root / "gradebook.db").exists()


def test_a_second_run_finds_nothing_to_do(graded_class, monkeypatch):
    monkeypatch.setattr(batch, "graded", lambda *_: pytest.fail("something is graded again"))
    before = state(graded_class.root)
    graded_class.grade(limits=LIMITS)
    assert differences(state(graded_class.root), before) == []
    assert {student: round(graded_class.total(student), 4) for student in TOTALS} == TOTALS


def test_a_changed_submission_and_students_of_any_name(undisturbed, graded_class, tmp_path, server):
    """On a copy of the course that goes on with the same database."""
    root = tmp_path / "course"
    shutil.copytree(graded_class.root, root, symlinks=True)
    classroom = Classroom.at(root)
    classroom.hand_in("untouched", solved("ja"))
    for name in ODD_NAMES:
        classroom.hand_in(name, b"{")
    classroom.grade(limits=LIMITS, workers=2)
    students = {student for student, _ in classroom.results}
    assert len(students) == len(TOTALS) + len(ODD_NAMES)
    assert classroom.total("untouched") == 40.0
    rows = gradebook_rows(server_url(root))
    assert {row[1] for row in rows if row[0] == "student"} == students >= {*ODD_NAMES[2:]}
    assert {len(student) for student in students if student.startswith("xxx")} == {128}
    assert max(rows.values()) == 1
    others = [student for student in TOTALS if student != "untouched"]
    assert undisturbed.state.of(others).rows - rows == {}
    assert sum(row[4] for row in rows if row[:2] == ("grade", "untouched") and row[4]) == 40.0


def server_url(root: Path) -> str:
    from autograder.settings import db_url

    return db_url(root)


def test_the_doctor_says_that_it_answers_and_when_it_does_not(graded_class, server):
    found = doctor._gradebook(graded_class.root)
    assert found.state == "good"
    assert found.seen.endswith("answers")
    server.stop("fast")
    try:
        found = doctor._gradebook(graded_class.root)
    finally:
        server.start()
    assert found.state == "bad"
    assert "Is the server running" in found.seen


def test_a_server_that_is_down_is_said_and_nothing_is_graded(another_class, server, monkeypatch):
    monkeypatch.setattr(batch, "graded", lambda *_: pytest.fail("it began to grade"))
    server.stop("fast")
    try:
        with pytest.raises(BatchError, match=r"the gradebook cannot be read: .*Is the server running"):
            another_class.grade(limits=LIMITS)
    finally:
        server.start()


def test_a_server_that_goes_down_meanwhile_loses_and_doubles_nothing(undisturbed, another_class, server, monkeypatch):
    def graded(works, open_pool):
        for count, pair in enumerate(undisturbed.replayed(works, open_pool)):
            if count == 2:
                server.stop()
            yield pair

    with monkeypatch.context() as patch:
        patch.setattr(batch, "graded", graded)
        with pytest.raises(BatchError, match=r"the gradebook cannot be written: .*type the same command again for the rest"):
            another_class.grade(limits=LIMITS)
    server.start()
    assert len(list(another_class.root.glob(".autograder/receipts/odometry/*/receipt.json"))) == 2
    another_class.grade(limits=LIMITS)
    assert differences(state(another_class.root), undisturbed.state) == []


def test_a_database_that_nobody_made_is_said(another_class):
    path = another_class.root / "nbgrader_config.py"
    path.write_text(path.read_text().replace("@/", "@/no_such_"))
    with pytest.raises(BatchError, match=r'the gradebook cannot be read: .*database "no_such_.*" does not exist'):
        another_class.grade(limits=LIMITS)


def test_nbgrader_itself_reads_what_was_graded(graded_class):
    from nbgrader.api import Gradebook
    from nbgrader.coursedir import CourseDirectory

    from autograder.settings import configuration

    course = CourseDirectory(config=configuration(graded_class.root), root=str(graded_class.root))
    with Gradebook(course.db_url, course.course_id) as gradebook:
        assert round(gradebook.find_submission("odometry", "partly").score, 4) == TOTALS["partly"]
