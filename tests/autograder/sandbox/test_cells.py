import base64
import io

import pytest
from PIL import Image

from autograder.sandbox.cells import MAX_OUTPUTS, MAX_PICTURES, MAX_TEXT, Outputs

# what a cell puts out


def stream(text, name="stdout"):
    return {"output_type": "stream", "name": name, "text": text}


def result(text):
    return {"output_type": "execute_result", "data": {"text/plain": text}}


def shown(text):
    return {"output_type": "display_data", "data": {"text/plain": text}}


CELLS = {
    "nothing": ("", []),
    "a comment": ("# nothing", []),
    "an assignment": ("x = 1", []),
    "a result": ("1 + 1", [result("2")]),
    "a result kept back": ("1 + 1;", []),
    "None": ("None", []),
    "printed": ("print('a')\nprint('b')", [stream("a\nb\n")]),
    "stderr": ("import sys\nprint('a', file=sys.stderr)", [stream("a\n", "stderr")]),
    "both streams": (
        "print('a'); print('b', file=sys.stderr); print('c')",
        [stream("a\n"), stream("b\n", "stderr"), stream("c\n")],
    ),
    "printed and a result": ("print('a')\n5", [stream("a\n"), result("5")]),
    "a warning": ("import warnings\nwarnings.filterwarnings('ignore')\nwarnings.warn('x')", []),
    "display": ("display(1, 'a')", [shown("1"), shown("'a'")]),
    "display of html shows its text": (
        "from IPython.display import HTML\ndisplay(HTML('<b>x</b>'))",
        [shown("<IPython.core.display.HTML object>")],
    ),
    "raw display of html shows nothing of it": ("display({'text/plain': 'x', 'text/html': '<b>'}, raw=True)", [shown("x")]),
    "raw display of anything": (
        "display({'text/plain': object(), 5: 6}, raw=True)",
        [{"output_type": "display_data", "data": {}}],
    ),
    "clear_output": ("from IPython.display import clear_output\nprint('a')\nclear_output()\nprint('b')", [stream("b\n")]),
    "top-level await": ("import asyncio\nawait asyncio.sleep(0, 'woken')", [result("'woken'")]),
    "line magic": ("%who_ls NoSuchType", [result("[]")]),
    "cell magic": ("%%capture caught\nprint('a')", []),
    "what a cell magic caught": ("caught.stdout", [result("'a\\n'")]),
    "matplotlib magic": ("%matplotlib inline", []),
    "shell command": ("!echo a", [stream("a\r\n")]),
    "sys.stdout written to": ("_ = sys.stdout.write('a')", [stream("a")]),
    "exit() goes on": ("exit()\nprint('on')", [stream("on\n")]),
    "half a surrogate pair": ("print('\\ud800')", [stream("\\ud800\n")]),
}


@pytest.mark.parametrize(("source", "outputs"), CELLS.values(), ids=CELLS.keys())
def test_a_cell_puts_out_what_jupyter_shows(session, source, outputs):
    session.run("import sys")
    if source == "caught.stdout":
        session.run("%%capture caught\nprint('a')")
    assert session.run(source) == outputs


ERRORS = {
    "exception": ("1 / 0", "ZeroDivisionError", "division by zero"),
    "syntax": ("def f(:", "SyntaxError", "invalid syntax"),
    "unknown name": ("nosuchname", "NameError", "name 'nosuchname' is not defined"),
    "unknown magic": ("%nosuchmagic", "UsageError", ""),
    "assertion": ("assert False, 'said so'", "AssertionError", "said so"),
    "sys.exit": ("import sys\nsys.exit(3)", "SystemExit", "3"),
    "own exception": ("class Mine(BaseException): pass\nraise Mine('x')", "Mine", "x"),
    "an exception whose text fails": (
        "class Mute(Exception):\n    def __str__(self): raise ValueError\nraise Mute",
        "Mute",
        "",
    ),
    "input": ("input('name?')", "StdinNotImplementedError", "does not support input requests"),
    "NUL": ("x = 'a\0b'", "SyntaxError", ""),
}


@pytest.mark.parametrize(("source", "name", "value"), ERRORS.values(), ids=ERRORS.keys())
def test_an_error_is_an_output_and_later_cells_run(session, source, name, value):
    outputs = session.run(source)
    errors = [output for output in outputs if output["output_type"] == "error"]
    if name == "UsageError":
        assert outputs[0]["name"] == "stderr"
        assert "nosuchmagic" in outputs[0]["text"]
    else:
        assert (errors[0]["ename"], value in errors[0]["evalue"]) == (name, True)
        assert "\x1b" not in "".join(errors[0]["traceback"])
    assert session.run("1 + 1") == [result("2")]


def test_an_error_points_at_the_line_of_the_cell(session):
    [error] = session.run("x = 1\ny = x.nosuch\n")
    assert "----> 2 y = x.nosuch" in "\n".join(error["traceback"])


@pytest.mark.parametrize(
    "last", ["plt.plot([1, 2])", "plt.plot([1, 2]);", "fig, ax = plt.subplots()", "plt.plot([1]); plt.show()"]
)
def test_a_figure_is_a_png_and_is_shown_once(session, last):
    outputs = session.run(f"import matplotlib.pyplot as plt\n{last}")
    pictures = [output["data"]["image/png"] for output in outputs if "image/png" in output.get("data", {})]
    assert len(pictures) == 1
    assert Image.open(io.BytesIO(base64.b64decode(pictures[0]))).format == "PNG"
    assert session.run("1") == [result("1")]


def test_names_live_on_from_cell_to_cell(session):
    session.run("first = 20")
    session.run("def twice(x): return 2 * x")
    assert session.run("twice(first) + 2") == [result("42")]


@pytest.mark.parametrize(
    "source",
    [
        "print('x' * 10**7)",
        "for _ in range(10**5): print('x' * 100)",
        "display({'text/plain': 'x' * 10**7}, raw=True)",
        "for _ in range(1000): display('x' * 1000)",
        "raise ValueError('x' * 10**7)",
        "class Long:\n    def __repr__(self): return 'x' * 10**7\nLong()",
    ],
)
def test_a_flood_is_cut_off_and_later_cells_run(session, source):
    outputs = session.run(source)
    assert len(str(outputs)) < 2 * MAX_TEXT
    assert session.run("print('fresh')") == [stream("fresh\n")]


def test_a_cell_that_never_ends_is_interrupted_and_later_cells_run(session):
    session.run("kept = 'still here'")
    [error] = session.run("while True:\n    pass")
    assert (error["ename"], error["evalue"]) == ("KeyboardInterrupt", "the cell did not finish within 2 s")
    assert session.run("kept") == [result("'still here'")]


def test_a_loop_that_swallows_one_interrupt_is_interrupted_again(session):
    session.run("swallowed = 0")
    session.run(
        "while swallowed < 2:\n    try:\n        while True: sum(range(99))\n    except KeyboardInterrupt:\n        swallowed += 1"
    )
    assert session.run("swallowed") == [result("2")]


def test_sleeping_is_interrupted_too(session):
    [error] = session.run("import time\ntime.sleep(1000)")
    assert error["ename"] == "KeyboardInterrupt"


def test_a_cell_that_awaits_for_ever_is_interrupted_and_does_not_go_on(session):
    [error] = session.run("import asyncio\nturns = 0\nwhile True:\n    await asyncio.sleep(0.01)\n    turns += 1")
    assert (error["ename"], error["evalue"]) == ("CancelledError", "the cell did not finish within 2 s")
    session.run("before = turns")
    assert session.run("await asyncio.sleep(0.05, turns - before)") == [result("0")]


def test_a_task_that_one_cell_begins_a_later_one_waits_for(session):
    session.run("import asyncio\nbegun = asyncio.create_task(asyncio.sleep(0.01, 'waited for'))")
    assert session.run("await begun") == [result("'waited for'")]


def test_what_programs_write_stands_where_they_wrote_it(session):
    outputs = session.run(
        "import os\nprint('a')\nos.system('echo b; echo c >&2')\nprint('d')\ndisplay('e')\nos.system('echo f');"
    )
    assert outputs == [stream("a\nb\n"), stream("c\n", "stderr"), stream("d\n"), shown("'e'"), stream("f\n")]


# the caps themselves


def test_streams_are_joined_only_to_the_same_stream():
    outputs = Outputs()
    for name, text in (("stdout", "a"), ("stdout", "b"), ("stderr", "c"), ("stdout", "d"), ("stdout", "")):
        outputs.stream(name, text)
    assert outputs.items == [stream("ab"), stream("c", "stderr"), stream("d")]


def test_texts_share_one_cap_and_a_new_cell_begins_afresh():
    outputs = Outputs()
    outputs.stream("stdout", "x" * (MAX_TEXT - 1))
    outputs.display("display_data", {"text/plain": "abc"})
    outputs.stream("stdout", "more")
    outputs.error("E", "v", ["line"])
    assert outputs.items[1:] == [shown("a"), {"output_type": "error", "ename": "E", "evalue": "v", "traceback": [""]}]
    outputs.clear()
    outputs.stream("stdout", "new")
    assert outputs.items == [stream("new")]


def test_pictures_are_counted_by_size_and_outputs_by_number():
    outputs = Outputs()
    for _ in range(3):
        outputs.display("display_data", {"image/png": "A" * (MAX_PICTURES // 2)})
    assert [list(output["data"]) for output in outputs.items] == [["image/png"], ["image/png"], []]
    for _ in range(MAX_OUTPUTS):
        outputs.display("display_data", {"text/plain": "a"})
    assert len(outputs.items) == MAX_OUTPUTS


def test_a_picture_in_bytes_becomes_text():
    outputs = Outputs()
    outputs.display("display_data", {"image/png": b"\x89PNG"})
    assert outputs.items[0]["data"] == {"image/png": "iVBORw=="}


def test_a_display_that_changes_without_end_takes_no_more_room_than_what_it_shows():
    outputs, picture = Outputs(), "A" * (MAX_PICTURES // 2)
    outputs.display("display_data", {"text/plain": "first"}, "bar")
    for count in range(MAX_TEXT // 9 + 10):
        last = {"text/plain": f"{count:09}", "image/png": picture}
        outputs.update("bar", last)
    assert outputs.items == [{"output_type": "display_data", "data": last}]


@pytest.mark.parametrize("display_id", ["nosuch", None, [], {}])
def test_a_display_that_is_not_there_is_not_changed(display_id):
    outputs = Outputs()
    outputs.display("display_data", {"text/plain": "a"}, display_id if display_id != "nosuch" else None)
    outputs.update(display_id, {"text/plain": "b"})
    assert outputs.items == [shown("a")]


def test_what_is_to_be_cleared_by_the_next_output_stays_until_there_is_one():
    outputs = Outputs()
    outputs.stream("stdout", "a")
    outputs.clear(wait=True)
    assert outputs.items == [stream("a")]
    outputs.display("display_data", {"text/plain": "b"})
    assert outputs.items == [shown("b")]
