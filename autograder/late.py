"""When a submission arrived, and the penalty for being late, as nbgrader's AssignLatePenalties would give it.

timestamp.txt and the names of folders are written on the student's side. Only the time at which this machine last changed a
file's inode cannot be set by anybody: a submission arrived when the newest of its notebooks did. What is collected from elsewhere
(`nbgrader collect`, `nbgrader zip_collect`) so arrives when it is collected, and what is moved or copied before it is graded arrives
when that is done; once it is graded, it has arrived.
"""

import logging
import os
import stat
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from autograder.files import replace_file
from autograder.settings import configuration

logger = logging.getLogger(__name__)


class LatePenaltyError(RuntimeError):
    """The penalty for late submissions that the course is configured with does not work; the message says why."""


class LatePenalties:
    """The penalties of a course: the plug-in that `c.AssignLatePenalties.plugin_class` names, with its configuration."""

    def __init__(self, root: Path) -> None:
        from nbgrader.preprocessors import AssignLatePenalties

        try:
            with _importing_from(root):
                self._stock = AssignLatePenalties(config=configuration(root))
                self._stock.init_plugin()
        except Exception as error:  # a plug-in is a module of the course's own: anything may go wrong in it
            raise LatePenaltyError(f"c.AssignLatePenalties in nbgrader_config.py does not work: {error}") from error

    def enter(self, submission: Any, folder: Path, new: Iterable[str]) -> None:
        """Enter when the submission in `folder` arrived, and what each of its notebooks loses for it.

        `submission` is an nbgrader.api.SubmittedAssignment with its scores, in an open session; nothing is committed. `new` names the
        notebooks that were not graded before as they are; where there are none the time stays that was entered then.
        """
        arrived = arrival(folder, new) or submission.timestamp or arrival(folder, [entry.name for entry in submission.notebooks])
        submission.timestamp = (arrived or datetime.now(UTC).replace(tzinfo=None)).replace(microsecond=0)
        if folder.is_dir() and not folder.is_symlink():
            _show(submission.timestamp, folder)
        for entry in submission.notebooks:
            entry.late_submission_penalty = self._penalty(submission, entry)

    def _penalty(self, submission: Any, entry: Any) -> float | None:
        """Return what a notebook loses, in points; None if nothing, as in nbgrader."""
        seconds = submission.total_seconds_late
        if seconds <= 0:
            return None
        try:
            penalty = self._stock.plugin_inst.late_submission_penalty(submission.student.id, entry.score, seconds)
            return None if penalty is None else float(self._stock._check_late_penalty(entry, penalty))
        except Exception as error:
            name = type(self._stock.plugin_inst).__name__
            raise LatePenaltyError(
                f"{name} cannot say what {submission.student.id!r} loses for being {seconds:.0f} s late: "
                f"{type(error).__name__}: {error}"
            ) from error


def arrival(folder: Path, notebooks: Iterable[str]) -> datetime | None:
    """Return when the newest of these notebooks arrived in `folder`, in UTC and whole seconds; None if there is none of them."""
    times = []
    for name in notebooks:
        try:
            status = os.lstat(folder / f"{name}.ipynb")
        except OSError:
            continue
        if stat.S_ISREG(status.st_mode):
            times.append(int(status.st_ctime))
    return datetime.fromtimestamp(max(times), UTC).replace(tzinfo=None) if times else None


def _show(arrived: datetime, folder: Path) -> None:
    """Write the time into the submission's timestamp.txt.

    Formgrader takes a submission as graded only when that file says the same as the gradebook, and shows no submission at all of a
    class where one such file cannot be read.
    """
    path = folder / "timestamp.txt"
    content = f"{arrived:%Y-%m-%d %H:%M:%S} UTC\n".encode()
    try:
        status = os.lstat(path)
        if stat.S_ISREG(status.st_mode) and status.st_size == len(content) and path.read_bytes() == content:
            return
    except OSError:
        pass
    try:
        if path.is_dir() and not path.is_symlink():
            path.rename(folder / "timestamp.txt (a folder)")
        replace_file(path, content)
    except OSError as error:
        logger.warning("%s cannot be written (%s): formgrader will not see that this submission is graded", path, error)


@contextmanager
def _importing_from(root: Path) -> Iterator[None]:
    """Let modules be imported from `root` for a moment: nbgrader's own commands look for plug-ins there too."""
    sys.path.append(str(root))
    try:
        yield
    finally:
        sys.path.remove(str(root))
