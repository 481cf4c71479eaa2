"""Anything at all as a submission: the notebook reader gives cells or a reason, in bounded time and memory."""

import json
import tracemalloc
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from autograder import intake
from autograder.intake import (
    MAX_BYTES,
    MAX_CELLS,
    MAX_VALUES,
    Cell,
    UnreadableError,
    language_of,
    restored_cells,
    submitted_cells,
)
from autograder.released import released

ROOT = Path(__file__).parents[2]
RELEASED = (ROOT / "release/en/odometry/pose_update.ipynb").read_bytes()
OURS = released(RELEASED).cells
GRADED = {cell.grade_id for cell in OURS if cell.graded}
CHECKS = [cell for cell in OURS if cell.locked and cell.graded]


def read(data):
    """The cells of a submission, or none where it is refused; whatever comes of it is what the grader can work with."""
    try:
        cells, reason = submitted_cells(data), None
    except UnreadableError as error:
        cells, reason = None, error.reason
    if cells is None:
        assert reason.en
        assert reason.ja
        return None
    assert len(cells) <= MAX_CELLS
    for cell in cells:
        assert cell.type in ("code", "markdown", "raw")
        assert "\0" not in cell.source
        cell.source.encode()
        # nothing that a student hands in makes a cell ours
        assert not cell.locked
        assert not cell.graded
    assert language_of(cells) in ("en", "ja")
    restored = restored_cells(OURS, cells)
    assert sorted((cell for cell in restored if cell.locked and cell.graded), key=OURS.index) == CHECKS
    graded = [cell.grade_id for cell in restored if cell.graded]
    assert len(graded) == len(set(graded))
    assert set(graded) <= GRADED
    # no source of a student's is lost, but those in the place of ours
    locked = {cell.grade_id for cell in OURS if cell.locked}
    handed = [cell.source for cell in cells if cell.grade_id not in locked]
    kept = [cell.source for cell in restored if not cell.locked]
    assert sorted(kept) == sorted(handed + [""] * (len(kept) - len(handed)))
    return cells


def as_bytes(value):
    return json.dumps(value).encode()


texts = st.text(max_size=8) | st.sampled_from(
    ["code", "markdown", "from course.en import check", "\ud800", "\0", "\u202e", "pose_step", "check_pose_step", "q1_derivation"]
)
anything = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | texts,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(texts, inner, max_size=4),
    max_leaves=8,
)
like_cells = st.fixed_dictionaries(
    {},
    optional={
        "cell_type": st.sampled_from(["code", "markdown", "raw", "heading"]) | anything,
        "source": texts | st.lists(texts, max_size=3) | anything,
        "id": st.sampled_from(sorted(filter(None, (cell.grade_id for cell in OURS)))) | anything,
        "metadata": st.fixed_dictionaries({"nbgrader": st.fixed_dictionaries({"grade_id": texts | anything}) | anything})
        | anything,
        "outputs": anything,
    },
)


@given(st.binary(max_size=200))
@example(b"\xef\xbb\xbf{}")
@example(b'"')
def test_any_bytes(data):
    assert read(data) is None


@given(anything)
def test_any_json(value):
    read(as_bytes(value))


@given(st.fixed_dictionaries({"cells": st.lists(like_cells | anything, max_size=12)}))
def test_anything_like_a_notebook(value):
    assert read(as_bytes(value)) is not None


def places(value):
    """Every place in JSON data, as the container and the key in it."""
    items = list(value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ())
    return [(value, key) for key, _ in items] + [place for _, item in items for place in places(item)]


@given(st.data())
def test_a_real_notebook_with_anything_in_any_place(data):
    made = json.loads(RELEASED)
    for _ in range(data.draw(st.integers(1, 4))):
        container, key = data.draw(st.sampled_from(places(made)))
        match data.draw(st.sampled_from(["replaced", "removed", "copied"])):
            case "replaced":
                container[key] = data.draw(anything)
            case "removed":
                del container[key]
            case "copied" if isinstance(container, list):
                container.insert(0, container[key])
    read(as_bytes(made))


@given(st.lists(st.tuples(st.integers(0, len(RELEASED) - 1), st.binary(max_size=3)), max_size=4), st.integers(0, len(RELEASED)))
def test_a_real_notebook_with_damaged_bytes(damages, end):
    data = bytearray(RELEASED)
    for place, put in damages:
        data[place : place + len(put)] = put
    read(bytes(data))
    if end < len(RELEASED.rstrip()):
        assert read(bytes(data[:end])) is None


ODD_JSON = {
    "duplicate keys": (b'{"cells": 1, "cells": [{"source": "a", "source": "b"}]}', [Cell("raw", "b")]),
    "infinite": (b'{"cells": [{"source": "a"}], "nbformat": 1e999, "x": -1e999, "y": NaN, "z": -Infinity}', [Cell("raw", "a")]),
    "a number of 4300 digits": (b'{"cells": [], "n": ' + b"9" * 4300 + b"}", []),
    "a number of more": (b'{"cells": [], "n": ' + b"9" * 4301 + b"}", None),
    "a million digits": (b'{"cells": [], "n": ' + b"9" * 10**6 + b"}", None),
    "a fraction of a million digits": (b'{"cells": [], "n": 0.' + b"9" * 10**6 + b"}", []),
    "halves of pairs": (b'{"cells": [{"source": "\\ud83d"}], "\\udfff": "\\ud800"}', [Cell("raw", "?")]),
    "a pair in two halves": (b'{"cells": [{"source": ["\\ud83d", "\\ude00"]}]}', [Cell("raw", "??")]),
    "a pair": (b'{"cells": [{"source": "\\ud83d\\ude00"}]}', [Cell("raw", "\N{GRINNING FACE}")]),
    "half a pair as UTF-8": (b'{"cells": [{"source": "\xed\xa0\x80"}]}', None),
    "nested below the parser's limit": (
        b'{"cells": [{"source": "a"}], "x": ' + b"[" * 300 + b"]" * 300 + b"}",
        [Cell("raw", "a")],
    ),
    "nested without end": (b'{"cells": [' + b"[" * (MAX_VALUES - 9), None),
    "two notebooks": (RELEASED + RELEASED, None),
}


@pytest.mark.parametrize(("data", "cells"), ODD_JSON.values(), ids=ODD_JSON.keys())
def test_odd_json(data, cells):
    assert read(data) == cells


# memory


def peak_of(data):
    """The most memory that reading takes, in bytes."""
    tracemalloc.start()
    try:
        read(data)
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


#: what a file may be filled with: a unit that is repeated
FILLED = {
    "lists": "[],",
    "nested lists": "[[[]]],",
    "dictionaries": "{},",
    "dictionaries of one": '{"a":1},',
    "cells": '{"source":""},',
    "numbers": "1.5,",
    "long numbers": "9" * 4000 + ",",
    "texts": '"\\u3042",',
    "wide texts": f'"{"😀" * 1000}",',
    "halves of pairs": f'"{chr(92)}ud800",',
    "quotes": '"',
    "escaped quotes": '\\"',
    "backslashes": "\\",
    "marks within a text": '"[{,",',
    "spaces": " ",
}


@pytest.mark.parametrize("unit", FILLED.values(), ids=FILLED.keys())
def test_reading_takes_no_more_than_a_few_times_the_memory_of_the_bytes(unit, monkeypatch):
    """At a fiftieth of the limits: what takes memory grows with the bytes, and measuring it takes time."""
    most = MAX_VALUES // 50
    monkeypatch.setattr(intake, "MAX_VALUES", most)
    for size in (MAX_BYTES // 50, 3 * most):
        data = b'{"cells":[' + (unit * (size // len(unit.encode()))).encode() + b"0]}"
        # the second is what so many of the smallest values take
        assert peak_of(data) < 8 * len(data) + 150 * most


@pytest.mark.parametrize("unit", ["[],", '{"a":1},', '"",'])
def test_a_full_file_of_small_values_is_refused_before_any_of_them_is_made(unit):
    data = b'{"cells":[' + unit.encode() * ((MAX_BYTES - 20) // len(unit)) + b"0]}"
    assert peak_of(data) < 2 * len(data)


def stream_output(lines):
    return {"output_type": "stream", "name": "stdout", "text": lines}


MANY_OUTPUTS = {
    "a hundred thousand printed lines": [[stream_output([f"{n:9.4f}, {n:9.4f}, [{n}]\n" for n in range(100_000)])]],
    "two hundred pictures": [
        [{"output_type": "display_data", "data": {"image/png": "A" * 60_000, "text/plain": ["<Figure>"]}, "metadata": {}}] * 4
    ]
    * 50,
    "a page of JavaScript with a million numbers": [
        [{"output_type": "display_data", "data": {"text/html": ["[1.5, 2.5],\n" * 1000] * 500}, "metadata": {}}]
    ],
    "a graph as JSON with fifty thousand points": [
        [{"output_type": "display_data", "data": {"application/vnd.plotly.v1+json": {"data": [{"x": [0.123] * 50_000}] * 4}}}]
    ],
}


@pytest.mark.parametrize("outputs", MANY_OUTPUTS.values(), ids=MANY_OUTPUTS.keys())
def test_a_real_notebook_with_many_outputs_is_read(outputs):
    made = json.loads(RELEASED)
    code = [cell for cell in made["cells"] if cell["cell_type"] == "code"]
    for index, shown in enumerate(outputs):
        code[index % len(code)]["outputs"] += shown
    data = json.dumps(made, indent=1).encode()
    assert len(data) < MAX_BYTES
    assert submitted_cells(data) == submitted_cells(RELEASED)


def test_the_largest_regular_notebook_is_read():
    """As many cells as are taken, each with two hundred lines and some outputs."""
    cell = {
        **{"cell_type": "code", "id": "0", "metadata": {}, "execution_count": 1, "source": ["x = 1\n"] * 80},
        "outputs": [stream_output(["a\n"] * 40)] * 2,
    }
    data = json.dumps({"cells": [cell] * MAX_CELLS, "metadata": {}}, indent=1).encode()
    assert len(submitted_cells(data)) == MAX_CELLS
