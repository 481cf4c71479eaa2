"""What lies in submitted/ and in release/: who handed in what, and what it is graded against."""

import hashlib
import os
from collections.abc import Mapping
from fnmatch import fnmatchcase
from pathlib import Path

from autograder.grading import notebook_names
from autograder.intake import submitted_files
from course.language import LANGUAGES, Text

#: nbgrader's tables hold no longer names
_LONGEST_ID = 128


class MissingReleaseError(RuntimeError):
    """There are no released notebooks to grade against."""


def students_with(root: Path, assignment: str, pattern: str = "*") -> dict[str, str]:
    """Return the students who handed in the assignment, sorted, with the name of each one's folder in submitted/.

    The two are the same, but for names that no database takes. Links and files in submitted/ are no students; whatever lies in a
    student's folder under the assignment's name is a submission, if only one that cannot be read.
    """
    folder = root / "submitted"
    if not folder.is_dir():
        return {}
    names = [entry.name for entry in os.scandir(folder) if entry.is_dir(follow_symlinks=False)]
    with_work = sorted(name for name in names if _has_entry(folder / name, assignment))
    return {student: name for student, name in _ids(with_work).items() if fnmatchcase(student, pattern)}


def release_notebooks(root: Path, assignment: str) -> dict[tuple[str, str], bytes]:
    """Return our own notebooks by (language, name). Raises MissingReleaseError if some are not built yet."""
    paths = {
        (language, name): root / "release" / language / assignment / f"{name}.ipynb"
        for language in LANGUAGES
        for name in notebook_names(assignment)
    }
    missing = [str(path.relative_to(root)) for path in paths.values() if not path.is_file()]
    if missing:
        raise MissingReleaseError(f"not built yet: {', '.join(missing)}. Type: autograder build")
    return {key: path.read_bytes() for key, path in paths.items()}


def submitted_notebooks(root: Path, folder: str, assignment: str) -> dict[str, bytes | Text]:
    """Return what lies in a student's folder, by notebook name: the bytes, or the reason why there are none."""
    names = {f"{name}.ipynb": name for name in notebook_names(assignment)}
    found = submitted_files(root / "submitted" / folder / assignment, [*names])
    return {names[file]: given for file, given in found.items()}


def hashes(notebooks: Mapping[str, bytes | Text]) -> dict[str, str]:
    """Return what tells one submission from another, by notebook: a hash, or why there is nothing."""
    return {
        name: hashlib.sha256(given).hexdigest() if isinstance(given, bytes) else f"none: {given.en}"
        for name, given in notebooks.items()
    }


def _has_entry(folder: Path, name: str) -> bool:
    try:
        os.lstat(folder / name)
    except (FileNotFoundError, NotADirectoryError):
        return False
    except OSError:
        # a folder that may not be looked into: there may be one, and somebody has to be told
        return True
    return True


def _ids(names: list[str]) -> dict[str, str]:
    """Return folder names by the id under which a student is graded, which is valid text of bearable length, and not another's."""
    ids: dict[str, str] = {}
    for name in sorted(names, key=lambda name: name != _as_text(name)):
        student = _as_text(name)
        while student in ids:
            student += "_"
        ids[student] = name
    return dict(sorted(ids.items()))


def _as_text(name: str) -> str:
    text = os.fsencode(name).decode(errors="backslashreplace")
    if len(text) <= _LONGEST_ID:
        return text
    return f"{text[: _LONGEST_ID - 17]}~{hashlib.sha256(os.fsencode(name)).hexdigest()[:16]}"
