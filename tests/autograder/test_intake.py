import json
import os
import socket

import pytest

from autograder.intake import (
    MAX_BYTES,
    MAX_CELLS,
    MAX_SOURCE,
    NOT_HANDED_IN,
    Cell,
    UnreadableError,
    language_of,
    restored_cells,
    submitted_bytes,
    submitted_cells,
)

CODE = {"cell_type": "code", "source": "x = 1", "metadata": {}, "outputs": [], "execution_count": None}


def notebook(*cells, **more):
    return json.dumps({"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": list(cells), **more}).encode()


def graded(source, grade_id, kind="code", **flags):
    return {"cell_type": kind, "source": source, "metadata": {"nbgrader": {"grade_id": grade_id, **flags}}}


def reason(call, *args):
    with pytest.raises(UnreadableError) as told:
        call(*args)
    assert told.value.reason.ja != told.value.reason.en
    return told.value.reason


# what lies where the notebook should be


def test_a_regular_file_is_read_to_the_letter(tmp_path):
    (tmp_path / "a.ipynb").write_bytes(b"\xff\x00anything")
    assert submitted_bytes(tmp_path / "a.ipynb") == b"\xff\x00anything"


def symlink(path):
    path.with_name("secret").write_text("{}")
    path.symlink_to("secret")


def dangling_symlink(path):
    path.symlink_to("nowhere")


def hard_link(path):
    path.with_name("secret").write_text("{}")
    os.link(path.with_name("secret"), path)


def folder(path):
    path.mkdir()


def fifo(path):
    os.mkfifo(path)


def unix_socket(path):
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(str(path))


@pytest.mark.parametrize("make", [symlink, dangling_symlink, hard_link, folder, fifo, unix_socket])
def test_only_regular_files_of_their_own_are_read(tmp_path, monkeypatch, make):
    monkeypatch.chdir(tmp_path)  # a socket's path must be short
    make(tmp_path / "a.ipynb")
    told = reason(submitted_bytes, tmp_path / "a.ipynb")
    assert "no ordinary file" in told.en
    assert told != NOT_HANDED_IN


def test_refusing_leaves_no_descriptor_open(tmp_path):
    (tmp_path / "a.ipynb").mkdir()
    before = os.listdir("/proc/self/fd")
    reason(submitted_bytes, tmp_path / "a.ipynb")
    assert os.listdir("/proc/self/fd") == before


def test_nothing_there_is_another_reason_than_a_bad_file(tmp_path):
    assert reason(submitted_bytes, tmp_path / "a.ipynb") == NOT_HANDED_IN


@pytest.mark.parametrize(("size", "readable"), [(MAX_BYTES, True), (MAX_BYTES + 1, False), (2**40, False)])
def test_the_size_is_looked_at_before_anything_is_read(tmp_path, size, readable):
    with (tmp_path / "a.ipynb").open("wb") as file:
        file.truncate(size)  # sparse: nothing is written
    if readable:
        assert len(submitted_bytes(tmp_path / "a.ipynb")) == size
    else:
        assert "too large" in reason(submitted_bytes, tmp_path / "a.ipynb").en


# what is in it

UNREADABLE = {
    "empty": (b"", "The file is empty."),
    "white space": (b" \n\t", "The file is empty."),
    "not JSON": (b"x = 1", "not a readable notebook"),
    "cut off": (notebook(CODE)[:-10], "not a readable notebook"),
    "not UTF-8": (b'{"cells": ["\xff"]}', "not a readable notebook"),
    "UTF-16": ("{}".encode("utf-16"), "not a readable notebook"),
    "nested lists": (b"[" * 100_000 + b"]" * 100_000, "not a readable notebook"),
    "nested dictionaries": (b'{"a":' * 100_000 + b"1" + b"}" * 100_000, "not a readable notebook"),
    "endless number": (b'{"cells": [' + b"9" * 10_000 + b"]}", "not a readable notebook"),
    "a list": (b"[]", "it has no list of cells"),
    "a number": (b"1", "it has no list of cells"),
    "null": (b"null", "it has no list of cells"),
    "no cells": (b'{"nbformat": 4}', "it has no list of cells"),
    "cells are a dictionary": (b'{"cells": {"0": 1}}', "it has no list of cells"),
    "nbformat 3": (b'{"nbformat": 3, "worksheets": [{"cells": []}]}', "it has no list of cells"),
    "a hundred thousand cells": (b'{"cells": [' + b"{}," * 99_999 + b"{}]}", "too large"),
    "a long source": (notebook({**CODE, "source": "x" * (MAX_SOURCE + 1)}), "too large"),
    "many long sources": (notebook(*[{**CODE, "source": "x" * (MAX_SOURCE // 4)}] * 5), "too large"),
}


@pytest.mark.parametrize(("data", "told"), UNREADABLE.values(), ids=UNREADABLE.keys())
def test_what_is_no_notebook_is_refused_with_a_reason(data, told):
    assert told in reason(submitted_cells, data).en


READABLE = {
    "a notebook": (notebook(CODE), [Cell("code", "x = 1")]),
    "no cells at all": (notebook(), []),
    "byte order mark": (b"\xef\xbb\xbf" + notebook(CODE), [Cell("code", "x = 1")]),
    "lines": (notebook({**CODE, "source": ["x = 1\n", "y"]}), [Cell("code", "x = 1\ny")]),
    "no source": (notebook({"cell_type": "markdown"}), [Cell("markdown", "")]),
    "nbformat 99": (notebook(CODE, nbformat=99), [Cell("code", "x = 1")]),
    "nbformat is text": (notebook(CODE, nbformat="four", metadata=[]), [Cell("code", "x = 1")]),
    "source is a number": (notebook({**CODE, "source": 5}, CODE), [Cell("code", "x = 1")]),
    "source is a list of numbers": (notebook({**CODE, "source": ["x", 5]}, CODE), [Cell("code", "x = 1")]),
    "source is null": (notebook({**CODE, "source": None}, CODE), [Cell("code", "x = 1")]),
    "cell is no dictionary": (notebook("x", None, [1], CODE), [Cell("code", "x = 1")]),
    "unknown cell type": (notebook({**CODE, "cell_type": "heading"}), [Cell("raw", "x = 1")]),
    "cell type is a list": (notebook({**CODE, "cell_type": ["code"]}), [Cell("raw", "x = 1")]),
    "metadata is a list": (notebook({**CODE, "metadata": [1]}), [Cell("code", "x = 1")]),
    "nbgrader is text": (notebook({**CODE, "metadata": {"nbgrader": "yes"}}), [Cell("code", "x = 1")]),
    "grade id is a number": (notebook(graded("x = 1", 7)), [Cell("code", "x = 1")]),
    "grade id is a list": (notebook(graded("x = 1", ["a"])), [Cell("code", "x = 1")]),
    "grade id is empty": (notebook(graded("x = 1", "")), [Cell("code", "x = 1")]),
    "grade id is endless": (notebook(graded("x = 1", "a" * 201)), [Cell("code", "x = 1")]),
    "grade id": (notebook(graded("x = 1", "a" * 200)), [Cell("code", "x = 1", "a" * 200)]),
    "flags are not ours": (notebook(graded("x = 1", "a", locked=True, grade=True)), [Cell("code", "x = 1", "a")]),
    "metadata dropped, id kept": (notebook({**CODE, "id": "pose_step"}), [Cell("code", "x = 1", "pose_step")]),
    "NUL": (notebook({**CODE, "source": "x\0 = 1"}), [Cell("code", "x\ufffd = 1")]),
    "half a surrogate pair": (b'{"cells": [{"cell_type": "code", "source": "\'\\ud800\'"}]}', [Cell("code", "'?'")]),
    "outputs are not read": (notebook({**CODE, "outputs": {"not": "a list"}}), [Cell("code", "x = 1")]),
}


@pytest.mark.parametrize(("data", "cells"), READABLE.values(), ids=READABLE.keys())
def test_only_types_sources_and_grade_ids_are_read(data, cells):
    assert submitted_cells(data) == cells


@pytest.mark.parametrize(("count", "readable"), [(MAX_CELLS, True), (MAX_CELLS + 1, False)])
def test_the_number_of_cells_is_limited(count, readable):
    data = notebook(*[CODE] * count)
    if readable:
        assert len(submitted_cells(data)) == count
    else:
        assert "too large" in reason(submitted_cells, data).en


# our cells, put back

WHY = Cell("markdown", "", "why", graded=True)
A, CHECK_A = Cell("code", "def a(): ...", "a"), Cell("code", 'check("a")', "check_a", locked=True, graded=True)
B, CHECK_B = Cell("code", "def b(): ...", "b"), Cell("code", 'check("b")', "check_b", locked=True, graded=True)
INTRO = Cell("markdown", "# Intro")
RELEASE = [INTRO, WHY, A, CHECK_A, INTRO, B, CHECK_B]


def own(source, kind="code"):
    return Cell(kind, source)


def handed(cell, source=None, kind=None):
    """The cell as it is read from a submission."""
    return Cell(kind or cell.type, cell.source if source is None else source, cell.grade_id)


WHY_, A_, B_ = handed(WHY, "because"), handed(A, "def a(): return 1"), handed(B, "def b(): return 2")
CA_, CB_ = handed(CHECK_A), handed(CHECK_B)
#: the same as they stand in the notebook that is graded
WHY1, A1, B1 = (Cell(c.type, c.source, c.grade_id, graded=c is WHY_) for c in (WHY_, A_, B_))
NOTE = own("a note", "markdown")

RESTORED = {
    "as released": ([WHY_, A_, CA_, B_, CB_], [WHY1, A1, CHECK_A, B1, CHECK_B]),
    "edited checks": ([WHY_, A_, handed(CHECK_A, "pass"), B_, CB_], [WHY1, A1, CHECK_A, B1, CHECK_B]),
    "retyped checks": ([WHY_, A_, handed(CHECK_A, kind="raw"), B_, CB_], [WHY1, A1, CHECK_A, B1, CHECK_B]),
    "deleted checks": ([WHY_, A_, B_], [WHY1, A1, CHECK_A, B1, CHECK_B]),
    "one check deleted": ([WHY_, A_, NOTE, B_, CB_], [WHY1, A1, CHECK_A, NOTE, B1, CHECK_B]),
    "copied checks": ([WHY_, A_, CA_, CA_, B_, CB_, CA_], [WHY1, A1, CHECK_A, B1, CHECK_B]),
    "a copy of the check before its answer": ([CA_, WHY_, A_, CA_, B_, CB_], [WHY1, A1, CHECK_A, B1, CHECK_B]),
    "check before its answer": ([WHY_, CA_, A_, B_, CB_], [WHY1, A1, CHECK_A, B1, CHECK_B]),
    "check well after its answer": ([WHY_, A_, NOTE, CA_, B_, CB_], [WHY1, A1, NOTE, CHECK_A, B1, CHECK_B]),
    "exercises in another order": ([B_, CB_, A_, CA_, WHY_], [B1, CHECK_B, A1, CHECK_A, WHY1]),
    "all checks at the end": ([WHY_, A_, B_, CA_, CB_], [WHY1, A1, B1, CHECK_A, CHECK_B]),
    "retyped answer": ([WHY_, handed(A, kind="markdown"), CA_, B_, CB_], [WHY1, A, CHECK_A, B1, CHECK_B]),
    "retyped written answer": ([handed(WHY_, kind="code"), A_, CA_, B_, CB_], [WHY1, A1, CHECK_A, B1, CHECK_B]),
    "copied answer": (
        [WHY_, A_, handed(A, "def a(): return 9"), CA_, B_, CB_],
        [WHY1, A1, own("def a(): return 9"), CHECK_A, B1, CHECK_B],
    ),
    "written answer in the second of two copies": (
        [handed(WHY, " \n"), WHY_, A_, CA_, B_, CB_],
        [own(" \n", "markdown"), WHY1, A1, CHECK_A, B1, CHECK_B],
    ),
    "own cells stay where they are": (
        [NOTE, WHY_, own("1"), A_, own("2"), CA_, own("3"), B_, CB_, own("4")],
        [NOTE, WHY1, own("1"), A1, own("2"), CHECK_A, own("3"), B1, CHECK_B, own("4")],
    ),
    "unknown grade ids": ([WHY_, A_, CA_, B_, CB_, Cell("code", "x", "zzz")], [WHY1, A1, CHECK_A, B1, CHECK_B, own("x")]),
    "deleted answer": ([WHY_, CA_, B_, CB_], [WHY1, CHECK_A, B1, CHECK_B]),
    "an answer without metadata, its check in place": (
        [WHY_, own(A_.source), CA_, B_, CB_],
        [WHY1, own(A_.source), CHECK_A, B1, CHECK_B],
    ),
    "no metadata at all": (
        [own("because", "markdown"), own(A_.source), own('check("a")'), own(B_.source), own('check("b")')],
        [
            *[own("because", "markdown"), own(A_.source), own('check("a")'), own(B_.source), own('check("b")')],
            *[WHY, CHECK_A, CHECK_B],
        ],
    ),
    "deleted written answer": ([A_, CA_, B_, CB_], [A1, CHECK_A, B1, CHECK_B, WHY]),
    "nothing": ([], [WHY, CHECK_A, CHECK_B]),
}


@pytest.mark.parametrize(("submitted", "restored"), RESTORED.values(), ids=RESTORED.keys())
def test_our_cells_are_put_back(submitted, restored):
    assert restored_cells(RELEASE, submitted) == restored


@pytest.mark.parametrize("submitted", [submitted for submitted, _ in RESTORED.values()], ids=RESTORED.keys())
def test_every_check_is_there_once_and_after_its_answer(submitted):
    cells = restored_cells(RELEASE, submitted)
    assert [cell for cell in cells if cell.locked] in ([CHECK_A, CHECK_B], [CHECK_B, CHECK_A])
    for answer, check in (("a", CHECK_A), ("b", CHECK_B)):
        places = [index for index, cell in enumerate(cells) if cell.grade_id == answer]
        assert places == [] or places[0] < cells.index(check)


@pytest.mark.parametrize("submitted", [submitted for submitted, _ in RESTORED.values()], ids=RESTORED.keys())
def test_restoring_what_was_restored_changes_nothing(submitted):
    once = restored_cells(RELEASE, submitted)
    assert restored_cells(RELEASE, [Cell(cell.type, cell.source, cell.grade_id) for cell in once]) == once


LANGUAGE = [
    ([], "ja"),
    ([own("import numpy as np")], "ja"),
    ([own("from course.en import check, hint\nimport numpy")], "en"),
    ([own("from course.ja import check")], "ja"),
    ([own("x"), own("from course.en import check")], "en"),
    ([own("from course.en import check", "markdown")], "ja"),
    ([own("from course.ja import check"), own("from course.en import check")], "ja"),
]


@pytest.mark.parametrize(("cells", "language"), LANGUAGE)
def test_the_language_is_read_from_the_first_import_line(cells, language):
    assert language_of(cells) == language
