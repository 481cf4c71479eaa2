"""The warm process: everything a notebook needs is loaded once, and each notebook runs in a fork of it.

    python -m autograder.sandbox.forking CONTROL CONFINED

CONTROL is the descriptor of a socket (SOCK_SEQPACKET) on which the grader's side asks for notebook processes, and
hands over the socket on which each of them will talk. CONFINED is 1 inside bubblewrap. No student code ever runs in this process,
and nothing of a student's is ever told to it.
"""

import contextlib
import gc
import importlib
import json
import os
import pkgutil
import random
import signal
import socket
import sys
from collections.abc import Collection
from typing import Any, NoReturn

from autograder.sandbox.cells import Cells
from autograder.sandbox.confinement import Seal, adopt_grandchildren, confined_child, limit_resources, seal_if_possible
from autograder.sandbox.runner import serve
from autograder.sandbox.wire import MAX_CONTROL
from course.answers import Question, reply_to

# imported by students' notebooks, or by Matplotlib, IPython and NumPy at their first use
_WARM = ("numpy.random", "numpy.fft", "numpy.linalg", "matplotlib.pyplot", "sympy", "scipy", "ipywidgets", "unittest.mock")


def main(control: socket.socket, confined: bool) -> None:
    """Load everything, say so, and serve until the grader hangs up."""
    cells = warm_cells()
    seal = seal_if_possible() if confined else None
    adopt_grandchildren()
    control.send(json.dumps({"ready": True, "seal": seal is not None}).encode())
    children: set[int] = set()
    while True:
        text, descriptors, _, _ = socket.recv_fds(control, MAX_CONTROL, 1)
        if not text:
            break
        request = json.loads(text)
        match request["do"]:
            case "start":
                with socket.socket(fileno=descriptors[0]) as channel:
                    child = _forked(request, confined, seal)
                    if not child:
                        control.close()
                        _serve(cells, channel, request, confined)
                children.add(child)
                told = {"started": child}
            case "end":
                # of its own children only: another server may have had this number
                _end({request["pid"]} & children)
                children.discard(request["pid"])
                told = {"ended": request["pid"]}
            case _:
                told = {"memory": _memory_of(request["pid"], confined)}
        control.send(json.dumps(told).encode())
    _end(children)


def _forked(request: dict[str, Any], confined: bool, seal: Seal | None) -> int:
    """Fork a process for one notebook: return its pid here, and 0 there."""
    if confined:
        return confined_child(request["uid"], request["limits"], request["folders"], seal)
    return os.fork()


def _serve(cells: Cells, channel: socket.socket, request: dict[str, Any], confined: bool) -> NoReturn:
    """Be the process of one notebook. Nothing comes back from here into the loop of the server."""
    try:
        if not confined:
            os.setsid()
            os.chdir(request["folder"])
            os.environ |= dict.fromkeys(("HOME", "MPLCONFIGDIR", "IPYTHONDIR"), request["folder"])
            limit_resources(request["limits"])
        _begin_anew()
        cells.watch_descriptors()
        serve(channel, cells)
    finally:
        os._exit(0)


def _begin_anew() -> None:
    """Make what a fork inherits its own: random numbers differ, and a signal does what it does in a new process."""
    import numpy as np

    random.seed()
    np.random.seed()
    signal.signal(signal.SIGINT, signal.default_int_handler)
    gc.enable()


def _end(children: Collection[int]) -> None:
    """Kill processes of notebooks: with the first of its pid namespace, or with its group, goes everything that it started."""
    for child in children:
        for kill in (os.kill, os.killpg):
            with contextlib.suppress(ProcessLookupError, PermissionError):
                kill(child, signal.SIGKILL)
        with contextlib.suppress(ChildProcessError):
            os.waitpid(child, 0)
    # adopted ones that have ended
    with contextlib.suppress(ChildProcessError):
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass


def _memory_of(child: int, confined: bool) -> int:
    """Return how many bytes the child and all processes of its notebook hold; what they share counts in shares."""
    total = 0
    for pid in map(int, filter(str.isdigit, os.listdir("/proc"))):
        # they come and go while we look
        with contextlib.suppress(OSError, ValueError, IndexError, StopIteration):
            if _home(pid, confined) == _home(child, confined):
                total += _proportional(pid)
    return total


def _home(pid: int, confined: bool) -> int:
    """Return what all processes of a notebook have in common: their pid namespace, or else their session."""
    return os.stat(f"/proc/{pid}/ns/pid").st_ino if confined else os.getsid(pid)


def _proportional(pid: int) -> int:
    with open(f"/proc/{pid}/smaps_rollup", encoding="ascii") as file:
        return 1024 * int(next(line for line in file if line.startswith("Pss:")).split()[1])


def warm_cells() -> Cells:
    """Load what notebooks use, run a cell, draw a figure: what is slow the first time is over when a notebook comes."""
    gc.disable()
    for name in _WARM:
        importlib.import_module(name)
    import course

    for module in pkgutil.walk_packages(course.__path__, "course."):
        # the editions choose the language when they are imported: that is left to the notebook
        if module.name not in ("course.en", "course.ja"):
            importlib.import_module(module.name)
    # SymPy loads half of itself with the first sum, and the rest with the first number that is put in
    reply_to(lambda a, b: a + 2 * sys.modules["sympy"].cos(b), Question((0.5, 1.0), symbols=True))
    cells = Cells()
    cells.warm_up()
    gc.collect()
    gc.freeze()
    return cells


if __name__ == "__main__":
    main(socket.socket(fileno=int(sys.argv[1])), sys.argv[2] == "1")
    # taking the modules down one by one would take longer than all else here
    os._exit(0)
