"""A grader in a process of its own, and everything that it starts: to be watched, killed, and looked for afterwards."""

import contextlib
import ctypes
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from autograder import cgroups

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(__file__).with_name("program.py")
_PR_SET_CHILD_SUBREAPER = 36
_PATIENCE = 60.0


class Grader:
    """`autograder grade odometry` on the course in `root`; use it in a `with` statement, at whose end nothing of it may be left."""

    def __init__(self, root: Path, *arguments: str) -> None:
        self._command = [
            sys.executable,
            str(PROGRAM),
            "grade",
            "odometry",
            "--root",
            str(root),
            *(arguments or ("--workers", "2")),
        ]
        self._root = root
        #: every process that was seen to be part of it
        self.pids: set[int] = set()

    def __enter__(self) -> "Grader":
        # orphans become ours instead of vanishing from sight
        ctypes.CDLL(None).prctl(_PR_SET_CHILD_SUBREAPER, 1)
        self._before = set(descendants())
        self._said = open(self._root / "said", "w+b")
        self.process = subprocess.Popen(
            self._command, stdout=self._said, stderr=self._said, stdin=subprocess.DEVNULL,
            env={**os.environ, "PYTHONPATH": str(ROOT)}, start_new_session=True,
        )  # fmt: skip
        return self

    def __exit__(self, *failed: object) -> None:
        if self.process.poll() is None and failed[0] is not None:
            self.process.kill()
        self.process.wait()
        if failed[0] is None:
            until(lambda: not self.left(), "processes are left: {}", lambda: [command(pid)[:100] for pid in self.left()])
        self._said.close()
        ctypes.CDLL(None).prctl(_PR_SET_CHILD_SUBREAPER, 0)

    def left(self) -> set[int]:
        """Return its processes that run at this moment; those that have ended are buried."""
        # a browser that an earlier test has opened may start processes at any time
        now = {pid for pid in set(descendants()) - self._before if "chromium" not in command(pid)}
        self.pids |= now
        for pid in now:
            if state_of(pid) == "Z" and pid != self.process.pid:
                with contextlib.suppress(ChildProcessError):
                    os.waitpid(pid, os.WNOHANG)
        self.process.poll()
        return {pid for pid in now if state_of(pid) not in ("Z", "")}

    def named(self, part: str) -> list[int]:
        """Return those of its processes that have this in their command line, the oldest first."""
        return sorted(pid for pid in self.left() if part in command(pid))

    def workers(self) -> list[int]:
        """Return the processes that grade: each has started a sandbox or will."""
        servers = self.named("multiprocessing.forkserver")
        return [pid for pid in servers if parent_of(pid) in servers]

    def ended(self) -> int:
        """Wait for its end and return its exit code."""
        until(lambda: self.left() is not None and self.process.poll() is not None, "it does not end: {}", self.said)
        return self.process.wait()

    def said(self) -> str:
        """Return what it printed so far, in one line."""
        return " ".join((self._root / "said").read_text(errors="replace").split())

    def until_graded(self, root: Path, count: int) -> None:
        """Wait until this many submissions are done."""
        until(lambda: self._graded(root) >= count or self.process.poll() is not None, "nothing is graded: {}", self.said)
        assert self.process.poll() is None, self.said()

    def until_looping(self) -> None:
        """Wait until the answer that never ends has been running for a moment: everything has begun, and something is under way."""
        until(
            lambda: any(map(is_first_notebook, self.left())) or self.process.poll() is not None, "no notebook runs: {}", self.said
        )
        assert self.process.poll() is None, self.said()

    def _graded(self, root: Path) -> int:
        self.left()
        return len(list(root.glob(".autograder/receipts/odometry/*/receipt.json")))


def is_first_notebook(pid: int) -> bool:
    """Is this the process of the class's first notebook, which has computed for a moment?"""
    with contextlib.suppress(OSError):
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(") ")[2].split()
        owner = Path(f"/proc/{pid}").stat().st_uid
        return owner == 20_000 and int(fields[11]) + int(fields[12]) > 0.2 * os.sysconf("SC_CLK_TCK")
    return False


def grade_to_the_end(root: Path) -> None:
    """Grade what is left, as a TA would."""
    with Grader(root) as grader:
        assert grader.ended() == 0, grader.said()


def until(holds: Callable[[], bool], message: str, *shown: Callable[[], object]) -> None:
    """Wait until something holds, and fail if it never does."""
    end = time.monotonic() + _PATIENCE
    while not holds():
        if time.monotonic() > end:
            pytest.fail(message.format(*(show() for show in shown)))
        time.sleep(0.01)


def groups_of(pids: set[int]) -> list[Path]:
    """Return the control groups that these processes made and that are still there."""
    # below our own group: elsewhere may lie those of others, who had the same numbers
    places = cgroups._places(Path("/sys/fs/cgroup"), Path("/proc/self/cgroup"))
    found = [folder for parent, _ in places for folder in parent.glob("autograder-*-*")]
    return [folder for folder in found if int(folder.name.split("-")[1]) in pids]


def descendants() -> Iterator[int]:
    """Yield all processes that this one started, and those that these started."""
    children: dict[int, list[int]] = {}
    for pid in (int(name) for name in os.listdir("/proc") if name.isdigit()):
        children.setdefault(parent_of(pid), []).append(pid)
    waiting = [os.getpid()]
    while waiting:
        for pid in children.get(waiting.pop(), ()):
            yield pid
            waiting.append(pid)


def command(pid: int) -> str:
    with contextlib.suppress(OSError):
        return Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
    return ""


def state_of(pid: int) -> str:
    """Return a letter ("Z": ended, but not buried), or nothing if there is no such process."""
    return _status(pid)[0]


def parent_of(pid: int) -> int:
    return int(_status(pid)[1])


def _status(pid: int) -> tuple[str, str]:
    with contextlib.suppress(OSError):
        # the name before it may hold anything
        letter, parent = Path(f"/proc/{pid}/stat").read_text().rpartition(") ")[2].split()[:2]
        return letter, parent
    return "", "0"
