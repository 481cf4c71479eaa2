"""Intake: read what a student handed in as hostile data, and put our own cells back in their places.

Only cell types, sources and grade ids are read from a submission. Its outputs, metadata, points and flags are not.
"""

import os
import stat
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from autograder.sandbox.limited_json import TooManyValuesError, limited_json
from course.language import Text

MAX_BYTES = 20 * 2**20
MAX_CELLS = 2_000
#: in its JSON, outputs and metadata included: half a million lines of printed text, for example
MAX_VALUES = 1_000_000
MAX_SOURCE = 2**20
MAX_GRADE_ID = 200


class UnreadableError(Exception):
    """A submitted notebook cannot be used; `reason` says why in both languages."""

    def __init__(self, reason: Text) -> None:
        super().__init__(reason.en)
        self.reason = reason


@dataclass(frozen=True)
class Cell:
    """One cell of a notebook: its type ("code", "markdown" or "raw"), source, grade id if it has one, and whether it is ours.

    `locked`: the source is that of the release, whatever was handed in; `graded`: points hang on it.
    """

    type: str
    source: str
    grade_id: str | None = None
    locked: bool = False
    graded: bool = False


def submitted_files(folder: Path, names: Sequence[str]) -> dict[str, bytes | Text]:
    """Return what lies in a submission's folder, by file name: the bytes, or the reason why there are none.

    The folder is opened once: what is put in its place afterwards, a link for example, is not looked at.
    """
    try:
        opened = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
    except OSError:
        return dict.fromkeys(names, _NO_FILE)
    try:
        return {name: _bytes_or_reason(Path(name), opened) for name in names}
    finally:
        os.close(opened)


def _bytes_or_reason(path: Path, folder: int) -> bytes | Text:
    try:
        return submitted_bytes(path, folder)
    except UnreadableError as error:
        return error.reason


def submitted_bytes(path: Path, folder: int | None = None) -> bytes:
    """Return the content of a submitted file: a regular file of bearable size, not reached through a link.

    `folder`: the descriptor of the folder in which `path` is looked up.
    """
    try:
        # a FIFO would keep an ordinary open waiting
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_NOCTTY, dir_fd=folder)
    except FileNotFoundError:
        raise UnreadableError(NOT_HANDED_IN) from None
    except OSError:
        raise UnreadableError(_NO_FILE) from None
    try:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode) or status.st_nlink > 1:
            raise UnreadableError(_NO_FILE)
        if status.st_size > MAX_BYTES:
            raise UnreadableError(_TOO_LARGE)
        with os.fdopen(descriptor, "rb", closefd=False) as file:
            data = file.read(MAX_BYTES + 1)
    finally:
        os.close(descriptor)
    if len(data) > MAX_BYTES:
        raise UnreadableError(_TOO_LARGE)
    return data


def submitted_cells(data: bytes) -> list[Cell]:
    """Return the cells of a submitted notebook. Raises UnreadableError for anything that is no notebook."""
    if not data.strip():
        raise UnreadableError(_EMPTY)
    try:
        notebook = limited_json(data, MAX_VALUES)
    except TooManyValuesError:
        raise UnreadableError(_TOO_LARGE) from None
    except ValueError:
        raise UnreadableError(_NO_JSON) from None
    cells = notebook.get("cells") if isinstance(notebook, dict) else None
    if not isinstance(cells, list):
        raise UnreadableError(_NO_NOTEBOOK)
    if len(cells) > MAX_CELLS:
        raise UnreadableError(_TOO_LARGE)
    read = [cell for cell in map(_cell, cells) if cell is not None]
    if sum(len(cell.source) for cell in read) > MAX_SOURCE:
        raise UnreadableError(_TOO_LARGE)
    return read


def restored_cells(release: Sequence[Cell], submitted: Sequence[Cell]) -> list[Cell]:
    """Return the notebook to grade: the student's cells in their order, with the release's locked cells in place.

    Of several cells with one grade id the first that is not blank counts as the graded one; the others stay as ordinary cells. A
    check cell stands where the student has it, but not before the answer that it checks; one that is missing is put after that
    answer, or at the end. A written answer that is missing comes back empty, at the end, so that it can be given points.
    """
    known = {cell.grade_id: cell for cell in release if cell.grade_id is not None}
    counts = _counted(submitted)
    kept: list[Cell] = []
    checks_at: dict[str, int] = {}
    for index, cell in enumerate(submitted):
        ours = known.get(cell.grade_id) if cell.grade_id is not None else None
        if ours is None:
            kept.append(Cell(cell.type, cell.source))
        elif ours.locked:
            checks_at.setdefault(str(ours.grade_id), len(kept))
        elif counts[str(ours.grade_id)] != index:
            kept.append(Cell(cell.type, cell.source))
        else:
            kept.append(Cell(ours.type, cell.source, ours.grade_id, graded=ours.graded))
    kept += [cell for cell in release if cell.graded and not cell.locked and cell.grade_id not in counts]
    return _with_checks(release, kept, checks_at)


def _counted(submitted: Sequence[Cell]) -> dict[str, int]:
    """Return for each grade id the index of the cell that counts: the first that is not blank, or else the first."""
    first: dict[str, int] = {}
    for index, cell in enumerate(submitted):
        if cell.grade_id is None:
            continue
        known = first.setdefault(cell.grade_id, index)
        if not submitted[known].source.strip() and cell.source.strip():
            first[cell.grade_id] = index
    return first


def _with_checks(release: Sequence[Cell], kept: list[Cell], checks_at: dict[str, int]) -> list[Cell]:
    """Return the student's cells with every locked cell of the release inserted once."""
    position = {cell.grade_id: index + 1 for index, cell in enumerate(kept) if cell.grade_id is not None}
    inserts: list[tuple[int, int, Cell]] = []
    answer: Cell | None = None
    for cell in release:
        if cell.grade_id is None:
            continue
        if not cell.locked:
            answer = cell
            continue
        after_answer = position.get(str(answer.grade_id), 0) if answer is not None else 0
        place = max(checks_at.get(cell.grade_id, 0), after_answer) or len(kept)
        inserts.append((place, len(inserts), cell))
    cells = list(kept)
    # from the end, so that earlier places keep their meaning
    for place, _, cell in sorted(inserts, key=lambda item: item[:2], reverse=True):
        cells.insert(place, cell)
    return cells


def language_of(cells: Sequence[Cell]) -> str:
    """Return the edition that a notebook belongs to, read from its import line as text: "en" or "ja" (also when neither is there)."""
    for cell in cells:
        if cell.type == "code" and "from course.en import" in cell.source:
            return "en"
        if cell.type == "code" and "from course.ja import" in cell.source:
            return "ja"
    return "ja"


def _cell(raw: Any) -> Cell | None:
    if not isinstance(raw, dict):
        return None
    source = raw.get("source", "")
    if isinstance(source, list) and all(isinstance(line, str) for line in source):
        source = "".join(source)
    if not isinstance(source, str):
        return None
    try:
        source.encode()
    except UnicodeEncodeError:
        source = source.encode(errors="replace").decode()
    kind = raw.get("cell_type")
    # a NUL ends a C string: neither Python nor a page gets to see what comes after it
    return Cell(
        kind if kind in ("code", "markdown") else "raw", source.replace("\0", "\N{REPLACEMENT CHARACTER}"), _grade_id(raw)
    )


def _grade_id(raw: dict[str, Any]) -> str | None:
    metadata = raw.get("metadata")
    ours = metadata.get("nbgrader") if isinstance(metadata, dict) else None
    # our notebooks use the grade id as the cell's own id too: it survives tools that drop metadata
    grade_id = ours.get("grade_id") if isinstance(ours, dict) else raw.get("id")
    return grade_id if isinstance(grade_id, str) and 0 < len(grade_id) <= MAX_GRADE_ID else None


NOT_HANDED_IN = Text("This notebook was not handed in.", "このノートブックは提出されていません。")
_NO_FILE = Text(
    "There is no ordinary file with the notebook's name (a link or a folder is not read).",
    "ノートブックのファイルがありません(リンクやフォルダは読み込みません)。",
)
_TOO_LARGE = Text(
    "The notebook is too large to be graded. Clear its outputs and hand it in again.",
    "ノートブックが大きすぎて採点できません。出力を消してから提出し直してください。",
)
_EMPTY = Text("The file is empty.", "ファイルが空です。")
_NO_JSON = Text(
    "The file is not a readable notebook (broken or cut off). Save it in JupyterLab and hand it in again.",
    "ノートブックとして読めません(壊れているか、途中で切れています)。JupyterLab で保存し直して提出してください。",
)
_NO_NOTEBOOK = Text(
    "The file is not a notebook: it has no list of cells.",
    "ノートブックではありません(セルの一覧がありません)。",
)
