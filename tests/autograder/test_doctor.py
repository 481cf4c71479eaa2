"""The doctor: what it says of a good machine, and of each thing that may be wrong with one."""

import os
import shutil
import sqlite3
from pathlib import Path

import pytest
from typer.testing import CliRunner

from autograder import doctor, warm_server
from autograder.cgroups import ControlGroup
from autograder.cli import app
from autograder.doctor import Finding, findings
from autograder.session import Limits


def said(root, *options):
    """What the command prints, in one line, and its exit code."""
    done = CliRunner().invoke(app, ["doctor", "--root", str(root), *options])
    assert done.exception is None or isinstance(done.exception, SystemExit), done.exception
    return " ".join(done.output.split()), done.exit_code


def found(root, what):
    return [finding for finding in findings(root) if finding.what == what]


@pytest.fixture
def no_session(monkeypatch):
    """The machine is looked at, and no notebook is run."""
    monkeypatch.setattr(doctor, "_sandbox", lambda: iter([Finding("sandbox", "good", "not tried")]))


@pytest.mark.sandbox
def test_a_good_machine(tmp_path):
    text, code = said(tmp_path)
    assert code == 0
    assert "✗" not in text
    for what in ("machine", "bubblewrap", "sandbox", "fork bombs", "system calls", "control groups", "gradebook", "cluster"):
        assert f" {what}: " in text
    # it names what stops a fork bomb, and did try
    limit = Limits().processes
    assert f"fork bombs: stopped by RLIMIT_NPROC = {limit} for each notebook's own user: refused after " in text
    assert 0 < int(text.partition("refused after ")[2].split()[0]) < limit
    # what it ran was in a sandbox: an ordinary user, the first process, and nobody else in sight
    assert "process 1 of its own namespaces, seeing 0 of others" in text
    assert "as user 0," not in text
    assert "will be made by the first grading" in text
    assert not (tmp_path / "gradebook.db").exists()


@pytest.mark.sandbox
def test_a_fork_bomb_that_is_not_stopped_is_told(tmp_path, monkeypatch):
    """One process more than the limit, and the reason is another."""
    monkeypatch.setattr(doctor, "_printed", lambda session, source: ["64", "nothing"] if "fork" in source else ["1", "1", "0"])
    [finding] = found(tmp_path, "fork bombs")
    assert (finding.state, finding.seen) == ("bad", "not stopped (64 forks)")


@pytest.mark.usefixtures("no_session")
def test_without_bubblewrap(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    text, code = said(tmp_path)
    assert code == 1
    assert "✗ bubblewrap: not installed → apt-get install bubblewrap" in text
    assert "sandbox:" not in text  # not tried
    assert text.endswith("error: this machine cannot grade safely yet.")


def false_bwrap(folder, monkeypatch):
    folder.mkdir()
    program = folder / "bwrap"
    program.write_text(
        '#!/bin/sh\n[ "$1" = --version ] && echo bubblewrap 0.0 && exit\necho "no permission to make namespaces" >&2\nexit 1\n'
    )
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder}:{os.environ['PATH']}")


@pytest.mark.usefixtures("no_session")
def test_where_namespaces_are_refused(tmp_path, monkeypatch):
    false_bwrap(tmp_path / "programs", monkeypatch)
    text, code = said(tmp_path)
    assert code == 1
    assert "✗ bubblewrap: bubblewrap 0.0: no permission to make namespaces → see what is said of the kernel below" in text
    assert "sandbox:" not in text


def test_where_the_sandbox_does_not_start(tmp_path, monkeypatch):
    false_bwrap(tmp_path / "programs", monkeypatch)
    monkeypatch.setattr(doctor, "_bubblewrap", lambda: Finding("bubblewrap", "good", "says that it works"))
    monkeypatch.setattr(doctor, "warm_server", warm_server.WarmServer)
    monkeypatch.setattr("autograder.session.warm_server", warm_server.WarmServer)
    [finding] = found(tmp_path, "sandbox")
    assert finding.state == "bad"
    assert "no permission to make namespaces" in finding.seen


SWITCHES = [
    ("user.max_user_namespaces", "0", 0, "bad"),
    ("user.max_user_namespaces", "0", 1000, "bad"),
    ("user.max_user_namespaces", "15000", 1000, "good"),
    ("kernel.unprivileged_userns_clone", "0", 1000, "bad"),
    ("kernel.unprivileged_userns_clone", "0", 0, "good"),
    ("kernel.unprivileged_userns_clone", "1", 1000, "good"),
    ("kernel.apparmor_restrict_unprivileged_userns", "1", 1000, "bad"),
    ("kernel.apparmor_restrict_unprivileged_userns", "1", 0, "good"),
    ("kernel.apparmor_restrict_unprivileged_userns", "0", 1000, "good"),
]


@pytest.mark.parametrize(("switch", "value", "user", "state"), SWITCHES)
def test_the_switches_of_the_kernel(monkeypatch, switch, value, user, state):
    def read(path):
        if path != Path("/proc/sys", *switch.split(".")):
            raise FileNotFoundError(path)
        return f"{value}\n"

    monkeypatch.setattr(Path, "read_text", read)
    monkeypatch.setattr(os, "getuid", lambda: user)
    [finding] = doctor._kernel()
    assert finding[:3] == ("kernel", state, f"{switch} = {value}")
    assert (switch.removesuffix("user_namespaces") in finding.advice) == (state == "bad")


@pytest.mark.parametrize(("group", "state"), [(None, "weak"), (ControlGroup([]), "good")])
def test_control_groups(monkeypatch, group, state):
    monkeypatch.setattr(doctor.ControlGroup, "made", lambda: group)
    finding = doctor._control_group()
    assert finding.state == state
    assert ("systemd-run" in finding.advice) == (state == "weak")


@pytest.mark.usefixtures("no_session")
def test_a_damaged_gradebook(tmp_path):
    (tmp_path / "gradebook.db").write_bytes(b"SQLite format 3\0" + bytes(range(256)) * 20)
    text, code = said(tmp_path)
    assert code == 1
    assert "✗ gradebook: " in text
    assert "→ put it back from a backup, or move it away: grading makes a new one" in text


@pytest.mark.parametrize("content", [b"", b"not a database at all, but a text of some length" * 100])
def test_another_file_in_the_place_of_the_gradebook(tmp_path, content):
    (tmp_path / "gradebook.db").write_bytes(content)
    assert doctor._gradebook(tmp_path).state == "bad"
    assert (tmp_path / "gradebook.db").read_bytes() == content


def test_a_good_gradebook(tmp_path, empty_gradebook):
    shutil.copy(empty_gradebook, tmp_path / "gradebook.db")
    with sqlite3.connect(tmp_path / "gradebook.db") as database:
        database.execute("INSERT INTO student (id) VALUES ('ann')")
    database.close()
    assert doctor._gradebook(tmp_path)[1:] == ("good", f"{tmp_path / 'gradebook.db'}: 1 students", "")


def test_a_database_server_that_does_not_answer(tmp_path):
    (tmp_path / "nbgrader_config.py").write_text(
        'c = get_config()\nc.CourseDirectory.db_url = "postgresql+psycopg://ta:secret@127.0.0.1:9/class"\n'
    )
    finding = doctor._gradebook(tmp_path)
    assert finding.state == "bad"
    assert "secret" not in finding.seen
    assert "start the database server" in finding.advice


@pytest.mark.parametrize(("installed", "state"), [(None, "weak"), (object(), "good")])
def test_dask(monkeypatch, installed, state):
    monkeypatch.setattr(doctor, "find_spec", lambda name: installed)
    assert doctor._dask().state == state
