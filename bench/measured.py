"""What a command costs with everything that it starts: wall time, processor time, and the most memory it held."""

import contextlib
import ctypes
import os
import resource
import subprocess
import threading
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

_PR_SET_CHILD_SUBREAPER = 36
_SECONDS = 0.2


@dataclass
class Cost:
    """Seconds of wall and processor time; the most memory, in MB, of all processes together and of the largest one.

    `own` are the MB of the command's own first process in the course of time.
    """

    wall: float = 0.0
    cpu: float = 0.0
    memory: float = 0.0
    largest: float = 0.0
    own: list[float] = field(default_factory=list)


def measured(command: Sequence[str], folder: Path, cores: Sequence[int], environment: Mapping[str, str] = os.environ) -> Cost:
    """Run a command on these cores and return what it cost. Raises CalledProcessError with its output if it fails."""
    # whatever outlives its parent comes to us, so that its time is counted when it ends
    ctypes.CDLL(None).prctl(_PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    others = _children()
    cost, before, begun = Cost(), _children_cpu(), time.monotonic()
    process = subprocess.Popen(
        ["taskset", "--cpu-list", ",".join(map(str, cores)), *command],
        cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip
    done = threading.Event()
    watcher = threading.Thread(target=_watch_memory, args=(process.pid, cost, done))
    watcher.start()
    output, _ = process.communicate()
    cost.wall = time.monotonic() - begun
    done.set()
    watcher.join()
    for orphan in _children() - others:
        with contextlib.suppress(ChildProcessError):
            os.waitpid(orphan, 0)
    cost.cpu = _children_cpu() - before
    if process.returncode:
        raise subprocess.CalledProcessError(process.returncode, command, output)
    return cost


def _children() -> set[int]:
    return {pid for pid, parent in _parents() if parent == os.getpid()}


def _children_cpu() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _watch_memory(root: int, cost: Cost, done: threading.Event) -> None:
    """Look at all processes below `root` again and again."""
    family = {root}
    while not done.wait(_SECONDS):
        parents = dict(_parents())
        family |= {pid for pid in sorted(parents) if parents[pid] in family}
        sizes = {pid: _megabytes(pid) for pid in family & parents.keys()}
        cost.memory = max(cost.memory, sum(sizes.values()))
        cost.largest = max(cost.largest, *sizes.values(), 0.0)
        cost.own.append(sizes.get(root, 0.0))


def _parents() -> Iterator[tuple[int, int]]:
    for name in filter(str.isdigit, os.listdir("/proc")):
        with contextlib.suppress(OSError):
            yield int(name), int(Path("/proc", name, "stat").read_text().rpartition(")")[2].split()[1])


def _megabytes(pid: int) -> float:
    """Return the memory of a process, what it shares with others counted in shares; 0 when it is gone."""
    with contextlib.suppress(OSError), open(f"/proc/{pid}/smaps_rollup", encoding="ascii") as file:
        return next((int(line.split()[1]) / 1024 for line in file if line.startswith("Pss:")), 0.0)
    return 0.0
