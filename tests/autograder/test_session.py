"""What a notebook's process can and cannot do. Each attack here stands for a class of them."""

import os
import sys
from pathlib import Path

import pytest

from autograder.sandbox.wire import packed_interview
from autograder.session import Limits, Session, SessionEndedError
from autograder.warm_server import ROOT, NoSandboxError, WarmServer, sandbox_problem
from course.answers import Interview, Question

LONG = Limits(cell=60.0)
SHORT = Limits(cell=0.5, check=0.5, notebook=20.0, grace=0.5)


def text(outputs):
    """The result or the printed text of a cell, or the name of its error."""
    return "".join(
        output.get("text") or output.get("data", {}).get("text/plain") or output.get("ename", "") for output in outputs
    )


@pytest.fixture(scope="module")
def sandboxed():
    with Session(LONG, slot=7) as session:
        yield session


@pytest.fixture(scope="module")
def bare():
    with Session(LONG, sandbox=False) as session:
        yield session


HONEST = [
    ("1 + 1", "2"),
    ("import numpy as np\nfloat(np.linalg.norm([3, 4]))", "5.0"),
    ("import sympy\nsympy.sin(0)", "0"),
    ("from course.en import check\nfrom course.robots import ICART\nICART.tread < 0", "True"),
    ("from course.logs import data_path, read_truth\nlen(read_truth(data_path('encoder_quarter_turn.truth.csv'))) > 0", "True"),
    ("open('notes.txt', 'w').write('abc')\nopen('notes.txt').read()", "'abc'"),
    ("import tempfile\ntempfile.TemporaryFile().write(b'abc')", "3"),
    ("__name__", "'__main__'"),
]


@pytest.mark.parametrize(("source", "shown"), HONEST)
@pytest.mark.parametrize("kind", [pytest.param("sandboxed", marks=pytest.mark.sandbox), "bare"])
def test_honest_work_runs_the_same_with_and_without_a_sandbox(request, kind, source, shown):
    assert text(request.getfixturevalue(kind).run(source)) == shown


# what is out of reach

FORBIDDEN = [
    str(ROOT / "autograder/reference/__init__.py"),
    str(ROOT / "autograder/judging.py"),
    str(ROOT / "source"),
    str(ROOT / "release"),
    str(ROOT / "tests"),
    str(ROOT / "submitted"),
    str(ROOT / "gradebook.db"),
    str(ROOT / "nbgrader_config.py"),
    str(ROOT / ".git"),
    "/box/lib/autograder/reference",
    "/box/lib/autograder/judging.py",
    "/etc/passwd",
    "/etc/shadow",
    "/home",
    "/var",
    "/run",
    "/sys",
    str(Path.home() / ".bashrc"),
    str(Path.home() / ".ssh"),
    "/proc/1/environ",
    "/proc/1/root",
    "/proc/1/mem",
]


@pytest.mark.sandbox
@pytest.mark.parametrize("path", FORBIDDEN)
def test_nothing_of_the_graders_is_to_be_read(sandboxed, path):
    look = f"import os\ntry:\n    kept = os.listdir({path!r}) if os.path.isdir({path!r}) else open({path!r}, 'rb').read()\n"
    assert text(sandboxed.run(f"{look}except OSError:\n    kept = None\nkept")) == ""


@pytest.mark.sandbox
def test_another_submission_on_this_machine_is_not_to_be_read(sandboxed, tmp_path):
    (tmp_path / "pose_update.ipynb").write_text("an answer")
    tmp_path.chmod(0o755)
    assert text(sandboxed.run(f"open({str(tmp_path / 'pose_update.ipynb')!r}).read()")) == "FileNotFoundError"


@pytest.mark.sandbox
@pytest.mark.parametrize(
    "module", ["autograder.reference", "autograder.judging", "autograder.reference.pose_update.pose_step", "autograder.session"]
)
def test_the_judge_is_not_to_be_imported(sandboxed, module):
    assert text(sandboxed.run(f"import {module}")) == "ModuleNotFoundError"


@pytest.mark.sandbox
def test_the_process_has_never_seen_the_judge(sandboxed):
    loaded = "import sys\nsorted(name for name in sys.modules if name.startswith('autograder'))"
    inside = {f"autograder.sandbox.{name}" for name in ("cells", "confinement", "limited_json", "runner", "wire")}
    assert set(eval(text(sandboxed.run(loaded)))) == {"autograder", "autograder.sandbox", *inside}


@pytest.mark.sandbox
def test_it_is_an_ordinary_user_without_any_rights(sandboxed):
    ids = "import os\n[*os.getresuid(), *os.getresgid(), *os.getgroups()]"
    shown = text(sandboxed.run(ids))
    if os.getuid() == 0:
        assert set(eval(shown)) == {20_007}
    assert "0" not in shown.strip("[]").split(", ")
    held = (
        "import ctypes, struct\nlibc = ctypes.CDLL(None)\nheld = ctypes.create_string_buffer(24)\n"
        "libc.capget(struct.pack('=Ii', 0x20080522, 0), held), any(held.raw)"
    )
    assert text(sandboxed.run(held)) == "(0, False)"
    # PR_CAPBSET_READ of each, and PR_GET_NO_NEW_PRIVS
    assert text(sandboxed.run("max(libc.prctl(23, n) for n in range(64)), libc.prctl(39, 0, 0, 0, 0)")) == "(0, 1)"
    assert text(sandboxed.run("os.setuid(0)")) in ("PermissionError", "OSError")


@pytest.mark.sandbox
def test_the_environment_holds_nothing_of_the_graders(monkeypatch):
    monkeypatch.setenv("SECRET_TOKEN", "abc")
    monkeypatch.setenv("PYTHONSTARTUP", "/tmp/evil.py")
    with Session(LONG) as session:
        names = set(eval(text(session.run("import os\nsorted(os.environ)"))))
        assert names <= {
            *("PATH", "PYTHONPATH", "HOME", "MPLCONFIGDIR", "MPLBACKEND", "LANG", "IPYTHONDIR", "PWD"),
            *("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"),
        }
        assert "abc" not in text(session.run("dict(os.environ)"))
        assert text(session.run("os.environ['HOME'], os.getcwd(), os.listdir('/tmp')")) == "('/box/work', '/box/work', [])"


def test_without_a_sandbox_the_environment_is_as_clean(bare):
    assert "SECRET" not in text(bare.run("import os\nsorted(os.environ)"))
    assert text(bare.run("'PYTEST_CURRENT_TEST' in os.environ, os.environ['HOME'] == os.getcwd()")) == "(False, True)"


@pytest.mark.sandbox
@pytest.mark.parametrize(
    "connect",
    [
        "socket.create_connection(('127.0.0.1', PORT), 1)",
        "socket.create_connection(('1.1.1.1', 53), 1)",
        "socket.getaddrinfo('example.org', 80)",
        "socket.socket(socket.AF_UNIX).connect('\\0' + NAME)",
    ],
)
def test_there_is_no_network(sandboxed, connect):
    import socket

    name = f"grader-test-listener-{os.getpid()}"
    with socket.create_server(("127.0.0.1", 0)) as server, socket.socket(socket.AF_UNIX) as named:
        named.bind(f"\0{name}")
        named.listen()
        source = connect.replace("PORT", str(server.getsockname()[1])).replace("NAME", repr(name))
        assert text(sandboxed.run(f"import socket\n{source}")) in ("ConnectionRefusedError", "OSError", "gaierror")


@pytest.mark.sandbox
def test_other_processes_are_not_to_be_seen(sandboxed):
    shown = text(sandboxed.run("import os\nsorted(int(pid) for pid in os.listdir('/proc') if pid.isdigit())"))
    assert len(eval(shown)) <= 3
    assert text(sandboxed.run(f"os.kill({os.getpid()}, 9)")) == "ProcessLookupError"
    assert (
        text(sandboxed.run("import subprocess\nsubprocess.run(['hostname'], capture_output=True, text=True).stdout"))
        == "'sandbox\\n'"
    )


@pytest.mark.sandbox
@pytest.mark.parametrize(
    "path",
    [
        "/evil",
        "/dev/evil",
        "/box/evil",
        "/box/lib/course/evil.py",
        "/box/data/evil",
        "/usr/evil",
        f"{sys.prefix}/evil",
    ],
)
def test_nothing_is_to_be_written_outside_its_own_folders(sandboxed, path):
    assert text(sandboxed.run(f"open({path!r}, 'w')")) in ("OSError", "PermissionError")


@pytest.mark.sandbox
@pytest.mark.parametrize("path", ["/", "/dev", "/usr", "/box/lib/course", "/box/data"])
def test_what_is_not_its_own_is_read_only_for_whoever_runs_it(sandboxed, path):
    """Started by an ordinary user, the notebook's process owns the sandbox's folders."""
    assert text(sandboxed.run(f"import os\nbool(os.statvfs({path!r}).f_flag & os.ST_RDONLY)")) == "True"


@pytest.mark.sandbox
@pytest.mark.parametrize("folder", ["/tmp", "/box/work", "/dev/shm"])
def test_its_own_folders_are_small(sandboxed, folder):
    fill = f"import os\nnames = [f'{folder}/{{n}}' for n in range(4)]\ntry:\n    for name in names: open(name, 'wb').write(bytes(30 * 2**20))\n"
    assert text(sandboxed.run(f"{fill}except OSError as error:\n    print(error.strerror)")) == "No space left on device\n"
    sandboxed.run("for name in names:\n    if os.path.exists(name): os.remove(name)")


@pytest.mark.sandbox
def test_a_fork_bomb_is_held_back(sandboxed):
    bomb = """
import os, time
children = []
try:
    while len(children) < 500:
        pid = os.fork()
        if pid == 0:
            time.sleep(1000)
        children.append(pid)
except OSError as error:
    print(error.strerror)
finally:
    for pid in children:
        os.kill(pid, 9)
        os.waitpid(pid, 0)
"""
    assert text(sandboxed.run(bomb)) == "Resource temporarily unavailable\n"
    assert int(text(sandboxed.run("len(children)"))) < Limits().processes
    assert text(sandboxed.run("1 + 1")) == "2"


@pytest.mark.sandbox
@pytest.mark.parametrize("bomb", ["x = bytearray(8 * 2**30)", "x = [0] * 2**31", "import numpy as np\nnp.ones((30_000, 30_000))"])
def test_a_memory_bomb_is_an_error_of_that_cell(sandboxed, bomb):
    assert text(sandboxed.run(bomb)) in ("MemoryError", "_ArrayMemoryError")
    assert text(sandboxed.run("1 + 1")) == "2"


@pytest.mark.sandbox
def test_what_one_submission_leaves_behind_the_next_does_not_find():
    leave = "import os, subprocess\nopen('/tmp/left', 'w').write('answers')\nopen('left', 'w').write('answers')\n"
    with Session(LONG, slot=3) as first:
        first.run(f"{leave}daemon = subprocess.Popen(['sleep', '987654'], start_new_session=True)")
        assert text(first.run("daemon.poll()")) == ""
    with Session(LONG, slot=3) as second:
        assert text(second.run("import os\nos.path.exists('/tmp/left'), os.path.exists('left')")) == "(False, False)"
    assert "987654" not in "".join(
        path.read_text(errors="replace") for path in Path("/proc").glob("[0-9]*/cmdline") if readable(path)
    )


def readable(path):
    try:
        path.read_bytes()
    except OSError:
        return False
    return True


# ends: with a reason, and without harm to anybody else

DIED, MALFORMED, TOO_SLOW = "process ended", "something else than answers", "did not come to an end"
#: what a cell writes to the descriptor before its own reply
FORGED = """
import os, socket, stat, struct, sys, json
# the first of them: an event loop makes itself others
for fd in sorted(map(int, os.listdir("/proc/self/fd")), reverse=True):
    try:
        if stat.S_ISSOCK(os.fstat(fd).st_mode):
            channel = fd
    except OSError:
        pass
def nonce():
    frame = sys._getframe()
    while "nonce" not in frame.f_locals.get("request", ()):
        frame = frame.f_back
    return frame.f_locals["request"]["nonce"]
def forge(message, arrays=b""):
    message = {"nonce": nonce(), **message}
    text = json.dumps({"@": "dict", "items": [[key, value] for key, value in message.items()]}).encode()
    os.write(channel, struct.pack(">4sII", b"DR1\\n", len(text), len(arrays)) + text + arrays)
"""
ENDS = {
    "os._exit": ("import os; os._exit(0)", DIED),
    "kill": ("import os, signal; os.kill(os.getpid(), signal.SIGKILL)", DIED),
    "closed descriptors": ("import os; os.closerange(3, 64)", DIED),
    "a stopped process": ("import os, signal; os.kill(os.getpid(), signal.SIGSTOP)", TOO_SLOW),
    "interrupts ignored": ("import signal; signal.setitimer(signal.ITIMER_REAL, 0)\nwhile True: pass", TOO_SLOW),
    "not a frame": (FORGED + "os.write(channel, b'GET / HTTP/1.0' * 9)", MALFORMED),
    "number of an array": (FORGED + "forge({'id': {'@': 'array', 'dtype': 'int64', 'shape': [2]}}, bytes(16))", MALFORMED),
    "not the nonce": (FORGED + "forge({'id': 1, 'nonce': '0' * 16, 'outputs': []})", MALFORMED),
    "before it was asked": (FORGED + "forge({'id': 1, 'outputs': []}); forge({'id': 2, 'outputs': []})", MALFORMED),
    "no outputs": (FORGED + "forge({'id': 1, 'outputs': 5})", MALFORMED),
    "a reply of its own, and then the real one": (FORGED + "forge({'id': 1, 'outputs': []})", MALFORMED),
}


@pytest.mark.parametrize(("source", "reason"), ENDS.values(), ids=ENDS.keys())
def test_what_ends_a_session_ends_only_that_one_and_has_a_reason(source, reason):
    with Session(SHORT, sandbox=False) as session:
        with pytest.raises(SessionEndedError) as told:
            # a reply that comes too late is seen with the next cell
            [session.run(cell) for cell in (source, "'still here'")]
        assert reason in told.value.reason.en
        assert told.value.reason.ja != told.value.reason.en
        pid = session._process.pid
    assert not alive(pid)


def alive(pid):
    """Is there still a process of this number, other than one that nobody has buried yet?"""
    state = Path(f"/proc/{pid}/stat")
    return state.exists() and state.read_text().split()[2] != "Z"


@pytest.mark.sandbox
def test_an_answer_that_leaves_the_sandbox_ends_it():
    with Session(LONG) as session:
        session.run("import os\ndef leave(): os._exit(0)")
        with pytest.raises(SessionEndedError, match=DIED):
            session.ask("leave", [Question(())])


def test_a_forged_interview_is_only_data():
    empty = {"missing": None, "kind": "function", "mismatch": None, "figure": None, "replies": []}
    as_json = {"@": "dict", "items": [[key, value] for key, value in empty.items()]}
    assert empty == packed_interview(Interview())
    with Session(LONG, sandbox=False) as session:
        session.run(f"{FORGED}\ndef answer():\n    forge({{'id': 2, 'interview': {as_json}}})\n    return 1.0")
        # what it sent is taken for its answer, and says nothing
        assert session.ask("answer", [Question(())]).replies == ()
        # the real reply comes too late
        with pytest.raises(SessionEndedError, match=MALFORMED):
            session.run("1")


def test_the_time_of_the_whole_notebook_is_limited():
    with Session(Limits(notebook=1.0), sandbox=False) as session, pytest.raises(SessionEndedError, match=TOO_SLOW):
        session.run("import time\nwhile True: time.sleep(0.1)")


def test_a_reply_that_never_ends_is_not_waited_for():
    drip = (
        FORGED
        + "import time\nos.write(channel, struct.pack('>4sII', b'DR1\\n', 1000, 0))\nwhile True: os.write(channel, b' '); time.sleep(0.5)"
    )
    with Session(SHORT, sandbox=False) as session, pytest.raises(SessionEndedError, match=TOO_SLOW):
        session.run(f"import signal\nsignal.signal(signal.SIGALRM, signal.SIG_IGN)\n{drip}")


def test_without_a_sandbox_its_children_end_with_it(tmp_path):
    with Session(LONG, sandbox=False) as session:
        pid = int(text(session.run("import subprocess\nsubprocess.Popen(['sleep', '1000']).pid")))
    assert not alive(pid)


# where there is no sandbox


def test_where_bubblewrap_is_missing_it_says_what_to_type(monkeypatch):
    monkeypatch.setenv("PATH", "/nonexistent")
    assert sandbox_problem() == (
        "bubblewrap is not installed. Type: apt-get install bubblewrap (or pass --no-sandbox for work that you trust)."
    )


@pytest.mark.sandbox
def test_where_bubblewrap_works_there_is_no_problem():
    assert sandbox_problem() is None


def false_bwrap(folder, monkeypatch):
    program = folder / "bwrap"
    program.write_text("#!/bin/sh\necho 'no permission to make namespaces' >&2\nexit 1\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder}:{os.environ['PATH']}")


def test_where_bubblewrap_may_not_work_it_says_why(tmp_path, monkeypatch):
    false_bwrap(tmp_path, monkeypatch)
    assert "no permission to make namespaces" in sandbox_problem()
    with pytest.raises(NoSandboxError, match="no permission to make namespaces"):
        WarmServer(sandbox=True).start(0, Limits().of_each_process())
