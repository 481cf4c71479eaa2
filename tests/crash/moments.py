"""Grade a class again and again, killed each time before another thing that it would write, and then to the end.

    python -m tests.crash.moments UNDISTURBED FOLDER

UNDISTURBED is a pickle of tests.small_class.Undisturbed: what the workers say is taken from there. Each course is left in a folder of
its own below FOLDER. Prints a line for each: the name of its folder, and what it was killed before.
"""

import json
import os
import pickle
import re
import shutil
import signal
import sys
from pathlib import Path
from typing import Any, NoReturn

import nbgrader.api
from sqlalchemy import event
from sqlalchemy.engine import Engine

from autograder import batch
from autograder.batch import grade_class
from autograder.engine import Options
from tests.crash.program import LIMITS
from tests.small_class import Undisturbed, new_class

#: enough for each kind of submission: a right one with points to give by hand, a wrong one, one without cells
STUDENTS = ("partly", "unreadable", "written")
_FILE_EVENTS = {"open": 0, "os.rename": 1, "os.remove": 0, "os.mkdir": 0, "os.link": 1}
_WRITES = os.O_WRONLY | os.O_RDWR | os.O_CREAT


class Moments:
    """Counts what is written, and ends this process before the `last`."""

    def __init__(self, root: Path, last: int | None) -> None:
        self._root, self._last = str(root), last
        self.labels: list[str] = []

    def watch(self) -> None:
        sys.addaudithook(self._file)
        event.listen(Engine, "before_cursor_execute", lambda *given: self._statement(given[2]))
        event.listen(Engine, "commit", lambda _: self._reached("commit"))

    def _file(self, name: str, arguments: tuple[Any, ...]) -> None:
        if name not in _FILE_EVENTS or (name == "open" and not (isinstance(arguments[2], int) and arguments[2] & _WRITES)):
            return
        path = str(arguments[_FILE_EVENTS[name]])
        if path.startswith(self._root):
            path = re.sub(r"\.new-.*|[a-z_0-9]+(?=\.reply)|" + "|".join(STUDENTS), "*", path.removeprefix(self._root))
            self._reached(f"{name} {path}")

    def _statement(self, statement: str) -> None:
        words = statement.split()
        if words[0] not in ("SELECT", "PRAGMA"):
            self._reached(" ".join(words[: 2 if words[0] == "CREATE" else 3]))

    def _reached(self, label: str) -> None:
        self.labels.append(label)
        if len(self.labels) == self._last:
            os.kill(os.getpid(), signal.SIGKILL)


def main(undisturbed: Undisturbed, folder: Path) -> None:
    """Go through the moments: of each kind the first and the last, and one in the middle where there are many."""
    batch.graded = undisturbed.replayed
    version = nbgrader.api.get_alembic_version()
    # a program that takes a second; it is the same each time
    nbgrader.api.get_alembic_version = lambda: version
    status, labels = _graded(new_class(folder / "whole", undisturbed.secret, STUDENTS).root, None)
    assert status == 0, "the undisturbed run failed"
    kinds: dict[str, list[int]] = {}
    for number, label in enumerate(labels, 1):
        kinds.setdefault(label, []).append(number)
    chosen = {number for numbers in kinds.values() for number in (numbers[0], *numbers[4:-4:6], numbers[-1])}
    for number in sorted(chosen):
        root = folder / str(number)
        shutil.copytree(folder / "whole", root, ignore=shutil.ignore_patterns("receipts", "autograded", "gradebook.db*", "lock"))
        status, _ = _graded(root, number)
        assert os.WIFSIGNALED(status), f"{number}: it was to be killed before {labels[number - 1]!r}"
        status, _ = _graded(root, None)
        print(f"{number}\t{labels[number - 1]}\t{'graded' if status == 0 else 'failed'}", flush=True)


def _graded(root: Path, last: int | None) -> tuple[int, list[str]]:
    """Grade in a fork; return how that ended, and the moments that it went through."""
    child = os.fork()
    if not child:
        _grade(root, last)
    _, status = os.waitpid(child, 0)
    told = root / "labels"
    labels = json.loads(told.read_bytes()) if told.exists() else []
    told.unlink(missing_ok=True)
    return status, labels


def _grade(root: Path, last: int | None) -> NoReturn:
    code = 1
    try:
        moments = Moments(root, last)
        moments.watch()
        grade_class(root, "odometry", Options(workers=1, limits=LIMITS))
        labels = list(moments.labels)
        (root / "labels").write_text(json.dumps(labels))
        code = 0
    except BaseException as error:
        print(f"{type(error).__name__}: {error}", file=sys.stderr, flush=True)
    finally:
        os._exit(code)


if __name__ == "__main__":
    main(pickle.loads(Path(sys.argv[1]).read_bytes()), Path(sys.argv[2]))
