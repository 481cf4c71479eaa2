"""What a notebook's process does: it runs cells and puts questions to answers, as it is told on its socket.

It decides nothing: points come from the judge at the other end.
"""

import socket
from typing import Any

from autograder.sandbox.cells import Cells
from autograder.sandbox.wire import WireError, packed_interview, receive, send, unpacked_questions
from course.answers import Interview, Reply, find, interview
from course.plain import Odd


def serve(channel: socket.socket, cells: Cells) -> None:
    """Answer requests until the other side hangs up. Each reply carries the number and the nonce of its request."""
    stream = channel.makefile("rwb")

    def read(count: int) -> bytes:
        data = stream.read(count)
        if len(data) != count:
            raise EOFError
        return data

    while True:
        try:
            request = receive(read)
        except EOFError:
            return
        numbered = {"id": request["id"], "nonce": request["nonce"]}
        try:
            send(stream, numbered | _answer(cells, request))
        except WireError:
            # each value fits, all together do not
            send(stream, numbered | {"interview": packed_interview(_too_big(request))})


def _too_big(request: dict[str, Any]) -> Interview:
    """Return the interview of an answer that returns more than a message holds: no case is right, and the student is told why."""
    questions = unpacked_questions(request.get("questions", []))
    return Interview(replies=tuple(Reply(Odd("too_big", "value"), inputs=question.args) for question in questions))


def _answer(cells: Cells, request: dict[str, Any]) -> dict[str, Any]:
    if request["do"] == "run":
        return {"outputs": cells.run(request["source"], request["seconds"])}
    if request["do"] == "names":
        return {"names": cells.names_used(request["sources"])}
    cells.count(f'check("{request["name"]}")')
    answer, missing = find(request["name"], cells.namespace, cells.sources)
    if missing is not None:
        return {"interview": packed_interview(Interview(missing=missing))}
    questions = unpacked_questions(request["questions"])
    return {"interview": packed_interview(interview(answer, questions, request["seconds"]), questions)}
