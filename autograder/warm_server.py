"""The warm server, seen from the trusted side: one process behind bubblewrap that forks a process for each notebook.

There is one for each worker. It has Python, NumPy, Matplotlib, IPython, SymPy and `course` loaded, and has never seen the judge.
"""

import contextlib
import functools
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from multiprocessing.util import Finalize
from pathlib import Path
from typing import Any, NamedTuple

from autograder.cgroups import ControlGroup
from autograder.sandbox.wire import MAX_CONTROL

ROOT = Path(__file__).resolve().parent.parent
START_SECONDS = 60.0
_ANSWER_SECONDS = 20.0
_END_SECONDS = 2.0
_LIB, _WORK, _DATA = "/box/lib", "/box/work", "/box/data"
#: what a notebook may write to, and how much (MiB)
_FOLDERS = {_WORK: 64, "/tmp": 64, "/dev/shm": 16}  # noqa: S108 - the sandbox's own
_FIRST_UID = 20_000


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
        return f"bubblewrap cannot make a sandbox on this machine: {probe.stderr.strip()} (autograder doctor says more)"
    return None


@functools.cache
def warm_server(sandbox: bool) -> "WarmServer":
    """Return this process's server; it is started at the first call and ends with this process."""
    server = WarmServer(sandbox)
    # in a process of a pool nothing else is run at its end
    Finalize(None, server.close, exitpriority=10)
    return server


class Process(NamedTuple):
    """The process of one notebook: its number, as the server knows it, the socket on which it talks, and its folder, if it is ours."""

    pid: int
    channel: socket.socket
    folder: "tempfile.TemporaryDirectory[str] | None"


class WarmServer:
    """A warm process and the socket on which it is told what to do."""

    def __init__(self, sandbox: bool) -> None:
        self._sandbox = sandbox
        self._process: subprocess.Popen[bytes] | None = None
        self._group: ControlGroup | None = None
        #: whether system calls are filtered
        self.sealed = False

    def start(self, slot: int, limits: Mapping[str, int]) -> Process:
        """Fork a process for one notebook.

        `slot` tells notebooks that run at the same time apart; `limits` as the sandbox's confinement takes them. Raises
        NoSandboxError if it cannot be done.
        """
        request = {"do": "start", "uid": _FIRST_UID + slot, "limits": dict(limits), "folders": _FOLDERS}
        try:
            return self._begun(request)
        except (OSError, ValueError, KeyError):
            # whatever became of it, a new one may do
            self.close()
        try:
            return self._begun(request)
        except (OSError, ValueError, KeyError) as error:
            complaint = self._complaint()
            self.close()
            raise NoSandboxError(f"the sandbox did not start: {error}\n{complaint}".rstrip()) from None

    def end(self, process: Process) -> None:
        """End a notebook's process and everything that it started."""
        try:
            self._asked({"do": "end", "pid": process.pid})
        except (OSError, ValueError):
            # what the server leaves behind dies with it
            self.close()
        process.channel.close()
        if process.folder is not None:
            process.folder.cleanup()

    def memory(self, process: Process) -> int:
        """Return how many bytes a notebook's processes hold at this moment."""
        try:
            return int(self._asked({"do": "memory", "pid": process.pid})["memory"])
        except (OSError, ValueError, KeyError):
            return 0

    def answers(self) -> bool:
        """Return whether the server lives."""
        try:
            self._asked({"do": "memory", "pid": 0})
        except (OSError, ValueError):
            return False
        return True

    def close(self) -> None:
        """End the server, and with it the notebook that runs."""
        if self._process is not None:
            # it ends when nobody is at the other end any more
            self._control.close()
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._process.wait(_END_SECONDS)
            with contextlib.suppress(ProcessLookupError):
                os.killpg(self._process.pid, signal.SIGKILL)
            self._process.wait()
            self._errors.close()
            self._process = None
        if self._group is not None:
            self._group.remove()
            self._group = None

    @property
    def pid(self) -> int | None:
        """Return the process id of bubblewrap, or of the server where there is no sandbox; None if it does not run."""
        return None if self._process is None else self._process.pid

    def _begun(self, request: dict[str, Any]) -> Process:
        if self._process is None or self._process.poll() is not None:
            self.close()
            self._launch()
        folder = None
        if not self._sandbox:
            folder = tempfile.TemporaryDirectory(prefix="notebook-")
            (Path(folder.name) / "data").symlink_to(ROOT / "data")
            request = request | {"folder": folder.name}
        ours, theirs = socket.socketpair()
        with theirs:
            return Process(self._asked(request, theirs)["started"], ours, folder)

    def _launch(self) -> None:
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self._control, self._errors = ours, tempfile.TemporaryFile()  # noqa: SIM115 - closed in close()
        server = [sys.executable, "-s", "-P", "-B", "-m", "autograder.sandbox.forking", str(theirs.fileno())]
        with theirs:
            if self._sandbox:
                self._group = ControlGroup.made()
                into_group = [] if self._group is None else self._group.command()
                command, environment = [*into_group, *_bwrap_command(), *server, "1"], {"PATH": os.environ.get("PATH", "")}
            else:
                command, environment = [*server, "0"], _environment(str(ROOT), tempfile.gettempdir())
            self._process = subprocess.Popen(
                command, pass_fds=[theirs.fileno()], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=self._errors,
                env=environment, cwd="/", start_new_session=True,
            )  # fmt: skip
        self.sealed = bool(self._told(START_SECONDS).get("seal"))

    def _asked(self, request: dict[str, Any], descriptor: socket.socket | None = None) -> dict[str, Any]:
        if self._process is None:
            raise ValueError("it does not run")
        self._control.settimeout(_ANSWER_SECONDS)
        socket.send_fds(self._control, [json.dumps(request).encode()], [] if descriptor is None else [descriptor.fileno()])
        return self._told(_ANSWER_SECONDS)

    def _told(self, seconds: float) -> dict[str, Any]:
        self._control.settimeout(seconds)
        data = self._control.recv(MAX_CONTROL)
        if not data:
            raise ValueError("it ended")
        told = json.loads(data)
        if not isinstance(told, dict):
            raise ValueError("it did not answer")
        return told

    def _complaint(self) -> str:
        if self._process is None:
            return ""
        self._errors.seek(0)
        return self._errors.read()[-4000:].decode(errors="replace").strip()


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
    if os.getuid() != 0:
        command += ["--unshare-user"]
    # the server needs them to make namespaces; a notebook's process keeps none
    command += ["--cap-add", "ALL", "--die-with-parent", "--new-session", "--hostname", "sandbox", "--clearenv"]
    for name, value in _environment(_LIB, _WORK).items():
        command += ["--setenv", name, value]
    # first of all, so that it does not hide a course that lives below /tmp
    command += _own_folder("/tmp")  # noqa: S108 - the sandbox's own
    for folder in _parents([*shown.values(), _WORK]):
        # bubblewrap would make them 700, and the other user could not pass
        command += ["--perms", "0755", "--dir", folder]
    for link in ("bin", "sbin", "lib", "lib64"):
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
