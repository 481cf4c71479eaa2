"""The program that runs inside the sandbox: it runs cells and puts questions to answers, as it is told over a descriptor.

    python -m autograder.sandbox.runner FD UID

It decides nothing: points come from the judge at the other end of the descriptor.
"""

import os
import resource
import socket
import sys
from typing import Any

from autograder.sandbox.cells import Cells
from autograder.sandbox.wire import packed_interview, receive, send, unpacked_questions
from course.answers import Interview, find, interview

_MEBI = 2**20


def main(descriptor: int, uid: int, limits: dict[str, int]) -> None:
    """Give up what the sandbox's start needed, then serve requests until the other side hangs up."""
    _drop_privileges(uid)
    _limit_resources(limits)
    channel = socket.socket(fileno=descriptor)
    stream = channel.makefile("rwb")

    def read(count: int) -> bytes:
        data = stream.read(count)
        if len(data) != count:
            raise EOFError
        return data

    cells = Cells()
    send(stream, {"id": 0, "ready": True})
    while True:
        try:
            request = receive(read)
        except EOFError:
            return
        send(stream, {"id": request["id"], **_answer(cells, request)})


def _answer(cells: Cells, request: dict[str, Any]) -> dict[str, Any]:
    if request["do"] == "run":
        return {"outputs": cells.run(request["source"], request["seconds"])}
    answer, missing = find(request["name"], cells.namespace, cells.sources)
    if missing is not None:
        return {"interview": packed_interview(Interview(missing=missing))}
    questions = unpacked_questions(request["questions"])
    return {"interview": packed_interview(interview(answer, questions, request["seconds"]))}


def _drop_privileges(uid: int) -> None:
    """Become the user `uid`, if started by root: limits on processes never hold root back."""
    if os.getuid() == 0 and uid > 0:
        os.setgroups([])
        os.setresgid(uid, uid, uid)
        os.setresuid(uid, uid, uid)


def _limit_resources(limits: dict[str, int]) -> None:
    memory = limits["memory_mb"] * _MEBI
    for kind, value in (
        (resource.RLIMIT_AS, memory),
        (resource.RLIMIT_CPU, limits["cpu_seconds"]),
        (resource.RLIMIT_NPROC, limits["processes"]),
        (resource.RLIMIT_FSIZE, 64 * _MEBI),
        (resource.RLIMIT_NOFILE, 256),
        (resource.RLIMIT_CORE, 0),
    ):
        resource.setrlimit(kind, (value, value))


if __name__ == "__main__":
    memory_mb, cpu_seconds, processes = map(int, sys.argv[3:6])
    main(int(sys.argv[1]), int(sys.argv[2]), {"memory_mb": memory_mb, "cpu_seconds": cpu_seconds, "processes": processes})
