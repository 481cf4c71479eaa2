"""A sandboxed notebook session, seen from the trusted side: start it, run cells, put questions, and never believe it."""

import math
import secrets
import time
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from autograder.sandbox.wire import WireError, packed_questions, receive, send, unpacked_interview
from autograder.warm_server import warm_server
from course.answers import Interview, Question
from course.language import Text
from course.plain import Plain

#: what the warm process has mapped already, and what is mapped without being used
_ADDRESSES_MB = 1536
_WATCH_SECONDS = 0.2


@dataclass(frozen=True)
class Limits:
    """What one submission's notebook may use: times in s, memory in MiB.

    `grace` is for code that does not let itself be interrupted: when it is over, the session is ended. `memory_mb` holds for all
    processes of a notebook together.
    """

    cell: float = 30.0
    check: float = 20.0
    notebook: float = 300.0
    grace: float = 5.0
    memory_mb: int = 2048
    processes: int = 64

    def of_each_process(self) -> dict[str, int]:
        """Return the limits that the system itself keeps: of addresses there must be more than of memory."""
        cpu_seconds = math.ceil(self.notebook)
        return {"memory_mb": self.memory_mb + _ADDRESSES_MB, "cpu_seconds": cpu_seconds, "processes": self.processes}


class SessionEndedError(Exception):
    """The notebook's process is gone or not believed any more; `reason` says why in both languages."""

    def __init__(self, reason: Text) -> None:
        super().__init__(reason.en)
        self.reason = reason


class SandboxEndedError(SessionEndedError):
    """The sandbox itself is gone, which is not a notebook's doing: another try is fair."""


class Session:
    """One notebook running in its own sandbox. Use it in a `with` statement; every process of it is gone afterwards."""

    def __init__(self, limits: Limits | None = None, sandbox: bool = True, slot: int = 0) -> None:
        self._limits = limits or Limits()
        self._server, self._slot = warm_server(sandbox), slot
        self._last_id = 0

    def __enter__(self) -> "Session":
        self._process = self._server.start(self._slot, self._limits.of_each_process())
        self._end = time.monotonic() + self._limits.notebook
        self._next_watch = time.monotonic() + _WATCH_SECONDS
        return self

    def __exit__(self, *_: object) -> None:
        self._server.end(self._process)

    def run(self, source: str) -> list[dict[str, Any]]:
        """Run one cell and return its outputs, as the sandbox tells them."""
        reply = self._asked({"do": "run", "source": source, "seconds": self._limits.cell}, self._limits.cell)
        outputs = reply.get("outputs")
        if not isinstance(outputs, list):
            raise SessionEndedError(_MALFORMED)
        return outputs

    def names(self, sources: Sequence[str]) -> frozenset[str]:
        """Return the names of the notebook that these cells use, as the sandbox reads them: hostile code is not parsed here."""
        reply = self._asked({"do": "names", "sources": list(sources)}, self._limits.check)
        names = reply.get("names")
        if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
            raise SessionEndedError(_MALFORMED)
        return frozenset(names)

    def ask(self, name: str, questions: Sequence[Question]) -> Interview:
        """Put questions to the answer `name`."""
        packed = packed_questions(tuple(questions))
        request = {"do": "ask", "name": name, "questions": packed, "seconds": self._limits.check}
        reply = self._asked(request, self._limits.check)
        try:
            return unpacked_interview(reply.get("interview"), questions)
        except WireError:
            raise SessionEndedError(_MALFORMED) from None

    def _asked(self, request: dict[str, Plain], seconds: float) -> dict[str, Any]:
        self._last_id += 1
        # whatever was sent before this request does not know it
        nonce = secrets.token_hex(8)
        # the sandbox interrupts what is slow by itself
        deadline = min(time.monotonic() + seconds + self._limits.grace, self._end)
        try:
            self._process.channel.settimeout(max(deadline - time.monotonic(), 0.01))
            with self._process.channel.makefile("wb") as stream:
                send(stream, {"id": self._last_id, "nonce": nonce, **request})
            reply = receive(partial(self._read, deadline))
        except TimeoutError:
            raise SessionEndedError(_TOO_SLOW) from None
        except OSError:
            raise self._died() from None
        except WireError:
            raise SessionEndedError(_MALFORMED) from None
        # of the type first: an array compares in its own way
        number, echo = reply.get("id"), reply.get("nonce")
        if type(number) is not int or number != self._last_id or type(echo) is not str or echo != nonce:
            raise SessionEndedError(_MALFORMED)
        return reply

    def _died(self) -> SessionEndedError:
        return (SessionEndedError if self._server.answers() else SandboxEndedError)(_DIED)

    def _watch_memory(self) -> None:
        """Look from time to time at how much all processes of the notebook hold together."""
        if time.monotonic() < self._next_watch:
            return
        if self._server.memory(self._process) > self._limits.memory_mb * 2**20:
            raise SessionEndedError(_TOO_MUCH_MEMORY)
        self._next_watch = time.monotonic() + _WATCH_SECONDS

    def _read(self, deadline: float, count: int) -> bytes:
        """Return exactly `count` bytes from the notebook's process."""
        parts: list[bytes] = []
        while count:
            left = deadline - time.monotonic()
            if left <= 0:
                raise SessionEndedError(_TOO_SLOW)
            self._watch_memory()
            self._process.channel.settimeout(min(left, _WATCH_SECONDS))
            try:
                part = self._process.channel.recv(min(count, 2**20))
            except TimeoutError:
                continue
            except OSError:
                raise self._died() from None
            if not part:
                raise self._died()
            parts.append(part)
            count -= len(part)
        return b"".join(parts)


_DIED = Text(
    "The notebook's process ended while this was graded (for example by exit(), by using too much memory, or by a crash).",
    "採点中にノートブックのプロセスが終了しました(exit() の呼び出し、メモリの使いすぎ、クラッシュなど)。",
)
_TOO_SLOW = Text(
    "The notebook did not come to an end in the time that grading allows.",
    "採点の制限時間内にノートブックの実行が終わりませんでした。",
)
_TOO_MUCH_MEMORY = Text(
    "The notebook used more memory than grading allows, and was ended.",
    "ノートブックが採点で許されるより多くのメモリを使ったため、実行を打ち切りました。",
)
_MALFORMED = Text(
    "The notebook's process sent something else than answers, so nothing after that is counted.",
    "ノートブックのプロセスから答え以外のものが送られてきたため、それ以降は採点していません。",
)
