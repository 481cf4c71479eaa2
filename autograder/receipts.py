"""Receipts: what was graded, against what, with which cases, and what came of it; one folder for each submission.

They lie below .autograder/ in the root of the course, which no student and no notebook ever sees. A receipt is written last of
all, so that whatever has one is graded and written; a receipt that cannot be read is none.
"""

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cache
from pathlib import Path
from typing import Any

from autograder.files import replace_file

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ".autograder"
#: how the file ends in which an answer's replies are kept as they came over the wire
REPLY = ".reply"
_VERSION = 1


class CannotWriteError(RuntimeError):
    """What was graded cannot be written down; the message says why and what to do."""


@dataclass(frozen=True, kw_only=True)
class Receipt:
    """The record of one graded submission.

    `notebooks` holds the hash of each notebook as it was handed in, or why there was none; `attempts` the hashes that were graded
    in the course of time, in order, so that the place of a hash is the number of its attempt. `release` and `exercises` are hashes
    of what it was graded against, `languages` those in which it was answered. `results` are rows (autograder.grading.Result) with the seeds of their cases. Times are UTC.
    """

    student: str
    assignment: str
    notebooks: Mapping[str, str]
    attempts: Mapping[str, Sequence[str]]
    release: str
    exercises: str
    sandbox: bool
    limits: Mapping[str, Any]
    languages: Mapping[str, str]
    results: Sequence[Mapping[str, Any]]
    begun: str = ""
    seconds: float = 0.0
    version: int = _VERSION

    def same_work(self, other: "Receipt") -> bool:
        """Was the same handed in, and graded against the same?"""
        return (self.notebooks, self.release, self.exercises, self.sandbox, self.version) == (
            other.notebooks, other.release, other.exercises, other.sandbox, other.version,
        )  # fmt: skip


def receipts_folder(root: Path) -> Path:
    """Return the folder of receipts and secrets, made for its owner alone if it is not there."""
    folder = root / FOLDER
    folder.mkdir(mode=0o700, exist_ok=True)
    return folder


def submission_folder(root: Path, assignment: str, student: str) -> Path:
    """Return where the receipt of one submission lies, with the notebooks that were graded and replies worth keeping."""
    return receipts_folder(root) / "receipts" / assignment / student


def read_receipt(root: Path, assignment: str, student: str) -> Receipt | None:
    """Return the receipt of a submission; None if there is none, or none that can be believed."""
    try:
        data = json.loads((submission_folder(root, assignment, student) / "receipt.json").read_bytes())
        if data.pop("digest") != _digest(data):
            return None
        receipt = Receipt(**data)
    except (OSError, ValueError, TypeError, LookupError, AttributeError):
        return None
    believed = receipt.version == _VERSION and (receipt.student, receipt.assignment) == (student, assignment)
    return receipt if believed else None


def write_receipt(root: Path, receipt: Receipt, notebooks: Mapping[str, bytes], replies: Mapping[str, bytes]) -> None:
    """Put down a receipt with the notebooks that were graded, and replies by exercise; the receipt itself comes last."""
    folder = submission_folder(root, receipt.assignment, receipt.student)
    folder.mkdir(parents=True, exist_ok=True)
    kept = {f"{name}.ipynb": content for name, content in notebooks.items()}
    kept |= {f"{exercise}{REPLY}": content for exercise, content in replies.items()}
    for name, content in kept.items():
        replace_file(folder / name, content, mode=0o600)
    data = {entry.name: getattr(receipt, entry.name) for entry in fields(receipt)}
    replace_file(folder / "receipt.json", json.dumps(data | {"digest": _digest(data)}).encode(), mode=0o600)
    for row in receipt.results:
        # of a notebook that was graded anew; the others keep what there was
        if row["notebook"] in notebooks and row["exercise"] not in replies:
            (folder / f"{row['exercise']}{REPLY}").unlink(missing_ok=True)


def _digest(data: Mapping[str, Any]) -> str:
    """Return what shows that a receipt is as it was written: damage may leave it readable."""
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()


def release_hash(release: Mapping[tuple[str, str], bytes]) -> str:
    """Return the hash of the released notebooks."""
    return _joined_hash({"/".join(key): content for key, content in release.items()})


@cache
def exercises_hash() -> str:
    """Return the hash of everything that decides on a verdict: the code of the course, the exercises and the judge."""
    paths = [
        path for folder in ("course", "autograder") for path in (ROOT / folder).rglob("*") if path.suffix in (".py", ".json")
    ]
    return _joined_hash({str(path.relative_to(ROOT)): path.read_bytes() for path in sorted(paths)})


def _joined_hash(contents: Mapping[str, bytes]) -> str:
    joined = hashlib.sha256()
    for name in sorted(contents):
        for part in (name.encode(), contents[name]):
            joined.update(len(part).to_bytes(8, "big") + part)
    return joined.hexdigest()
