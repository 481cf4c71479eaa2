"""A sandboxed notebook session, seen from the trusted side: start it, run cells, put questions, and never believe it."""

import contextlib
import math
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any

from autograder.sandbox.wire import WireError, packed_questions, receive, send, unpacked_interview
from course.answers import Interview, Question
from course.language import Text
from course.plain import Plain

ROOT = Path(__file__).resolve().parent.parent
_LIB, _WORK, _DATA = "/box/lib", "/box/work", "/box/data"
_FIRST_UID = 20_000


@dataclass(frozen=True)
class Limits:
    """What one submission's notebook may use: times in s, memory in MiB.

    `grace` is for code that does not let itself be interrupted: when it is over, the session is ended.
    """

    start: float = 60.0
    cell: float = 30.0
    check: float = 20.0
    notebook: float = 300.0
    grace: float = 5.0
    memory_mb: int = 3072
    processes: int = 64


class SessionEndedError(Exception):
    """The notebook's process is gone or not believed any more; `reason` says why in both languages."""

    def __init__(self, reason: Text) -> None:
        super().__init__(reason.en)
        self.reason = reason


class NoSandboxError(RuntimeError):
    """Sandboxing does not work on this machine; the message says what to type."""


def sandbox_problem() -> str | None:
    """Return why bubblewrap cannot be used here and what to do, or None if it can."""
    if shutil.which("bwrap") is None:
        return "bubblewrap is not installed. Type: apt-get install bubblewrap (or pass --no-sandbox for work that you trust)."
    probe = subprocess.run(
        ["bwrap", "--ro-bind", "/", "/", "--unshare-pid", "--unshare-net", "true"], capture_output=True, text=True, check=False
    )
    if probe.returncode:
        return f"bubblewrap cannot make a sandbox on this machine: {probe.stderr.strip()}"
    return None


class Session:
    """One notebook running in its own sandbox. Use it in a `with` statement; every process of it is gone afterwards."""

    def __init__(self, limits: Limits | None = None, sandbox: bool = True, slot: int = 0) -> None:
        self._limits = limits or Limits()
        self._sandbox, self._slot = sandbox, slot
        self._last_id = 0
        self._folder: tempfile.TemporaryDirectory[str] | None = None

    def __enter__(self) -> "Session":
        ours, theirs = socket.socketpair()
        self._socket, self._end = ours, time.monotonic() + self._limits.start
        with theirs:
            self._process = self._started(theirs)
        try:
            if self._received().get("ready") is not True:
                raise WireError("not ready")
        except (WireError, SessionEndedError) as error:
            complaint = self._complaint()
            self.__exit__(None, None, None)
            raise NoSandboxError(f"the sandbox did not start: {error}\n{complaint}") from None
        self._end = time.monotonic() + self._limits.notebook
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        # a sandbox has a process namespace of its own: with its first process everything in it dies; without one, the group must do
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        self._errors.close()
        self._socket.close()
        if self._folder is not None:
            self._folder.cleanup()

    def run(self, source: str) -> list[dict[str, Any]]:
        """Run one cell and return its outputs, as the sandbox tells them."""
        reply = self._asked({"do": "run", "source": source, "seconds": self._limits.cell}, self._limits.cell)
        outputs = reply.get("outputs")
        if not isinstance(outputs, list):
            raise SessionEndedError(_MALFORMED)
        return outputs

    def ask(self, name: str, questions: Sequence[Question]) -> Interview:
        """Put questions to the answer `name`."""
        packed = packed_questions(tuple(questions))
        request = {"do": "ask", "name": name, "questions": packed, "seconds": self._limits.check}
        reply = self._asked(request, self._limits.check)
        try:
            return unpacked_interview(reply.get("interview"))
        except WireError:
            raise SessionEndedError(_MALFORMED) from None

    def _asked(self, request: dict[str, Plain], seconds: float) -> dict[str, Any]:
        self._last_id += 1
        # the sandbox interrupts what is slow by itself
        deadline = min(time.monotonic() + seconds + self._limits.grace, self._end)
        try:
            self._socket.settimeout(max(deadline - time.monotonic(), 0.01))
            with self._socket.makefile("wb") as stream:
                send(stream, {"id": self._last_id, **request})
            reply = self._received(deadline)
        except TimeoutError:
            raise SessionEndedError(_TOO_SLOW) from None
        except OSError:
            raise SessionEndedError(_DIED) from None
        except WireError:
            raise SessionEndedError(_MALFORMED) from None
        number = reply.get("id")
        # of the type first: an array compares in its own way
        if type(number) is not int or number != self._last_id:
            raise SessionEndedError(_MALFORMED)
        return reply

    def _received(self, deadline: float | None = None) -> dict[str, Any]:
        end = self._end if deadline is None else deadline

        def read(count: int) -> bytes:
            parts: list[bytes] = []
            while count:
                left = end - time.monotonic()
                if left <= 0:
                    raise SessionEndedError(_TOO_SLOW)
                self._socket.settimeout(left)
                try:
                    part = self._socket.recv(min(count, 2**20))
                except TimeoutError:
                    raise SessionEndedError(_TOO_SLOW) from None
                except OSError:
                    raise SessionEndedError(_DIED) from None
                if not part:
                    raise SessionEndedError(_DIED)
                parts.append(part)
                count -= len(part)
            return b"".join(parts)

        return receive(read)

    def _started(self, theirs: socket.socket) -> "subprocess.Popen[bytes]":
        limits = self._limits
        descriptor = theirs.fileno()
        uid = _FIRST_UID + self._slot
        cpu_seconds = math.ceil(limits.start + limits.notebook)
        arguments = [descriptor, uid if self._sandbox else 0, limits.memory_mb, cpu_seconds, limits.processes]
        runner = [sys.executable, "-s", "-P", "-B", "-m", "autograder.sandbox.runner", *map(str, arguments)]
        self._errors = tempfile.TemporaryFile()  # noqa: SIM115 - closed in __exit__
        if self._sandbox:
            command, environment, folder = [*_bwrap_command(), *runner], {"PATH": os.environ.get("PATH", "")}, "/"
        else:
            self._folder = tempfile.TemporaryDirectory(prefix="notebook-")
            folder = self._folder.name
            (Path(folder) / "data").symlink_to(ROOT / "data")
            command, environment = runner, _environment(str(ROOT), folder)
        return subprocess.Popen(
            command, pass_fds=[descriptor], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=self._errors,
            env=environment, cwd=folder, start_new_session=True,
        )  # fmt: skip

    def _complaint(self) -> str:
        self._errors.seek(0)
        return self._errors.read(4000).decode(errors="replace").strip()


def _environment(library: str, folder: str) -> dict[str, str]:
    """Return the whole environment of a notebook's process: nothing of the grader's own."""
    return {
        "PATH": "/usr/bin:/bin",
        "PYTHONPATH": library,
        "HOME": folder,
        "MPLCONFIGDIR": folder + "/.matplotlib",
        "MPLBACKEND": "module://matplotlib_inline.backend_inline",
        "LANG": "C.UTF-8",
        "IPYTHONDIR": folder + "/.ipython",
        # one submission, one thread: linear algebra must not take the cores of the neighbours
        "OPENBLAS_NUM_THREADS": "1",
        "OMP_NUM_THREADS": "1",
    }


def _bwrap_command() -> list[str]:
    """Return bubblewrap's command line: Python and its packages, `course`, `autograder.sandbox`, `data`, and nothing else."""
    shown = {
        "/usr": "/usr",
        "/etc/ld.so.cache": "/etc/ld.so.cache",
        sys.base_prefix: sys.base_prefix,
        sys.prefix: sys.prefix,
        str(ROOT / "course"): f"{_LIB}/course",
        str(ROOT / "autograder" / "sandbox"): f"{_LIB}/autograder/sandbox",
        str(ROOT / "data"): _DATA,
    }
    command = ["bwrap", "--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts", "--unshare-cgroup-try"]
    if os.getuid() == 0:
        # the runner becomes another user before any student code runs
        command += ["--cap-drop", "ALL", "--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID"]
    else:
        command += ["--unshare-user"]
    command += ["--die-with-parent", "--new-session", "--hostname", "sandbox", "--clearenv"]
    for name, value in _environment(_LIB, _WORK).items():
        command += ["--setenv", name, value]
    # first of all, so that it does not hide a course that lives below /tmp
    command += _own_folder("/tmp")  # noqa: S108 - the sandbox's own
    for folder in _parents([*shown.values(), _WORK]):
        # bubblewrap would make them 700, and the other user could not pass
        command += ["--perms", "0755", "--dir", folder]
    for link in ("bin", "lib", "lib64"):
        if Path(f"/{link}").is_symlink():
            command += ["--symlink", os.readlink(f"/{link}"), f"/{link}"]
    for here, there in shown.items():
        if Path(here).exists() and not (here != "/usr" and here.startswith("/usr/")):
            command += ["--ro-bind", here, there]
    command += [*_own_folder(_WORK), "--dev", "/dev", "--proc", "/proc"]
    # an ordinary user owns these folders in the sandbox, and what they hold is not limited in size
    command += ["--remount-ro", "/dev", "--remount-ro", "/"]
    return [*command, "--chdir", _WORK]


def _own_folder(path: str) -> list[str]:
    return ["--perms", "1777", "--size", str(64 * 2**20), "--tmpfs", path]


def _parents(paths: Sequence[str]) -> list[str]:
    """Return every folder above the paths, the outer ones first."""
    return sorted({str(parent) for path in paths for parent in Path(path).parents if str(parent) != "/"})


_DIED = Text(
    "The notebook's process ended while this was graded (for example by exit(), by using too much memory, or by a crash).",
    "採点中にノートブックのプロセスが終了しました(exit() の呼び出し、メモリの使いすぎ、クラッシュなど)。",
)
_TOO_SLOW = Text(
    "The notebook did not come to an end in the time that grading allows.",
    "採点の制限時間内にノートブックの実行が終わりませんでした。",
)
_MALFORMED = Text(
    "The notebook's process sent something else than answers, so nothing after that is counted.",
    "ノートブックのプロセスから答え以外のものが送られてきたため、それ以降は採点していません。",
)
