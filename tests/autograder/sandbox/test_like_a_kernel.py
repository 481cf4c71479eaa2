"""Cells put out what a real kernel puts out: one notebook of many kinds of cells, run by both.

What is different on purpose stands in `kept`. Besides, and not in the table: exit() and quit() do not end the notebook; what a
display of an earlier cell is changed to is lost, because that cell's outputs are handed over already; what is printed into an
ipywidgets.Output is shown where it was printed, because no widget is kept; an exception that cannot say what it is gets an empty text.
"""

import json
import os
import re

import nbformat
import pytest
from nbclient import NotebookClient

from autograder.executed import executed_notebook
from autograder.intake import Cell
from autograder.released import released
from autograder.session import Limits, Session
from course.answers import Question

# the notebook is run once for all of them
pytestmark = pytest.mark.xdist_group("like a kernel")

# where a cell sleeps, a kernel takes that long to see what came another way than through Python
CELLS = {
    "nothing": "",
    "a comment": "# nothing",
    "prints": "print('a')\nprint('b', end='')\nprint('c')",
    "stderr": "import sys\nprint('a', file=sys.stderr)",
    "both": "print('a'); print('b', file=sys.stderr); print('c')",
    "last expression": "x = 3\nx * 2",
    "several expressions": "1\n2\n3",
    "none": "None",
    "semicolon": "x;",
    "underscore": "_ + 1",
    "Out": "sorted(Out)",
    "Out n": "Out[8]",
    "In": "In[3], len(In)",
    "wide list": "list(range(40))",
    "dict": "{'b': 1, 'a': [1, 2], 'long': 'x' * 70, 'longer': 'y' * 70}",
    "array": "import numpy as np\nnp.arange(12.).reshape(3, 4)",
    "a big array": "np.zeros(2000)",
    "text": "'日本語 \\n'",
    "a warning": "import warnings\nwarnings.warn('careful')",
    "the same warning twice": "for _ in range(2):\n    warnings.warn('twice')",
    "numpy warning": "np.array([1.0]) / 0",
    "display": "display(1, 'a')",
    "display and result": "display('shown')\n'result'",
    "HTML": "from IPython.display import HTML, Latex, Markdown, SVG, Javascript, Math, Image\nHTML('<b>x</b>')",
    "Latex": "Latex('$x$')",
    "Markdown": "display(Markdown('**x**'))",
    "Math": "Math('x')",
    "SVG": "SVG('<svg xmlns=\"http://www.w3.org/2000/svg\"/>')",
    "javascript": "%%javascript\nconsole.log(1)",
    "raw": "display({'text/plain': 'x', 'text/html': '<b>x</b>'}, raw=True)",
    "mimebundle": "class Bundle:\n    def _repr_mimebundle_(self, include=None, exclude=None):\n        return {'text/plain': 'bundle', 'text/html': '<b>bundle</b>'}\nBundle()",
    "ipython display": "class Own:\n    def _ipython_display_(self):\n        print('own')\n        display('own way')\nOwn()",
    "repr html": "class Rich:\n    def _repr_html_(self): return '<i>rich</i>'\n    def __repr__(self): return 'rich'\nRich()",
    "repr fails": "class Bad:\n    def __repr__(self):\n        raise ValueError('no repr')\nBad()",
    "repr html fails": "class BadRich:\n    def _repr_html_(self):\n        raise ValueError('no html')\n    def __repr__(self):\n        return 'plain'\nBadRich()",
    "clear": "from IPython.display import clear_output\nprint('a')\nclear_output()\nprint('b')",
    "clear wait": "print('a')\nclear_output(wait=True)\nprint('b')",
    "clear wait nothing after": "print('a')\nclear_output(wait=True)",
    "display id": "handle = display('first', display_id=True)\nhandle.update('second')",
    "named display id": "display('one', display_id='name')\nfrom IPython.display import update_display\nupdate_display('two', display_id='name')",
    "unknown display id": "update_display('nowhere', display_id='nosuch')\nprint('after')",
    "plot": "import matplotlib.pyplot as plt\nplt.plot([1, 2])",
    "plot semicolon": "plt.plot([1, 2]);",
    "plot None": "_ = plt.plot([1, 2])",
    "plot show": "plt.plot([1, 2])\nplt.show()\nprint('after')",
    "figure last": "fig, ax = plt.subplots()\nfig",
    "figure later": "fig",
    "two figures": "plt.figure()\nplt.figure()\nprint('two')",
    "display figure": "f = plt.figure()\ndisplay(f)\nplt.close(f)",
    "figure and error": "plt.plot([1])\n1 / 0",
    "inline": "%matplotlib inline",
    "sympy": "import sympy\nsympy.Symbol('x') ** 2",
    "time": "%%time\nprint('timed')",
    "time line": "%time 1 + 1",
    "timeit": "%timeit -n1 -r1 1 + 1",
    "capture": "%%capture caught\nprint('a')\n5",
    "caught": "caught.stdout, caught.outputs",
    "caught show": "caught.show()",
    "shell": "!echo a",
    "shell err": "!echo b >&2",
    "shell assigned": "said = !echo c\nsaid",
    "bash": "%%bash\necho a\necho b >&2",
    "bash fails": "%%bash\nexit 3",
    "writefile": "%%writefile note.txt\nwritten",
    "read back": "print(open('note.txt').read())",
    "writefile again": "%%writefile -a note.txt\nmore",
    "cat": "%cat note.txt",
    "await": "import asyncio\nawait asyncio.sleep(0, 'woken')",
    "async for": "async def numbers():\n    for n in range(2):\n        yield n\nasync for n in numbers():\n    print(n)",
    "async with error": "async def fail():\n    await asyncio.sleep(0)\n    raise ValueError('async')\nawait fail()",
    "task": "async def later():\n    print('task')\ntask = asyncio.create_task(later())\nawait task",
    "loop": "asyncio.get_running_loop().is_running()",
    "asyncio.run": "asyncio.run(numbers().__anext__())",
    "input": "input('name? ')",
    "getpass": "import getpass\ngetpass.getpass('secret? ')",
    "exception": "1 / 0",
    "deep exception": "def inner():\n    raise KeyError('k')\ndef outer():\n    return inner()\nouter()",
    "chained": "try:\n    1 / 0\nexcept ZeroDivisionError as error:\n    raise ValueError('chained') from error",
    "in handling": "try:\n    1 / 0\nexcept ZeroDivisionError:\n    raise ValueError('in handling')",
    "from None": "try:\n    1 / 0\nexcept ZeroDivisionError:\n    raise ValueError('alone') from None",
    "group": "raise ExceptionGroup('several', [ValueError('a'), TypeError('b')])",
    "note": "error = ValueError('noted')\nerror.add_note('a note')\nraise error",
    "library exception": "np.linalg.inv(np.zeros((2, 2)))",
    "print and exception": "print('before')\nassert x == 4, 'not four'",
    "keyboard": "raise KeyboardInterrupt",
    "keyboard text": "raise KeyboardInterrupt('stop')",
    "own base exception": "class Mine(BaseException): pass\nraise Mine('x')",
    "syntax": "def f(:\n    pass",
    "indentation": "def f():\nreturn 1",
    "unclosed": "print('a'",
    "await outside": "def g():\n    await x",
    "name error": "nosuchname",
    "unicode name": "距離 = 1\n距離 + nosuch",
    "recursion": "def r(): return r()\nr()",
    "multi-line exception": "raise ValueError('one\\ntwo')",
    "empty exception": "raise ValueError",
    "render traceback": "class Short(AssertionError):\n    def _render_traceback_(self): return ['short']\nraise Short('said')",
    "sys.exit": "import sys\nsys.exit(3)",
    "sys.exit text": "sys.exit('bye')",
    "help": "len?",
    "own help": "def documented(a, b=1):\n    '''Documented.'''\n    return a\n",
    "own help 2": "documented?",
    "python help": "help(documented)",
    "who": "mine = 1\n%who int",
    "whos": "%whos float",
    "magic error": "%nosuchmagic",
    "cell magic error": "%%nosuchmagic\nx",
    "usage error": "%timeit -q",
    "os.system": "import os, time\nstatus = os.system('echo from the shell')\ntime.sleep(0.2)\nstatus",
    "subprocess": "import subprocess\nprint('python')\ndone = subprocess.run(['echo', 'program'])\ntime.sleep(0.2)\ndone",
    "true stdout": "print('true', file=sys.__stdout__)\ntime.sleep(0.2)",
    "os.write": "_ = os.write(1, b'written\\n')\ntime.sleep(0.2)\n_",
    "logging": "import logging\nlogging.warning('logged')\nlogging.getLogger('a').error('b')",
    "logging info": "logging.getLogger().setLevel('INFO')\nlogging.info('told')",
    "thread": "import threading\nt = threading.Thread(target=lambda: print('thread'))\nt.start(); t.join()",
    "thread exception": "def broken():\n    raise ValueError('in a thread')\nt = threading.Thread(target=broken, name='named')\nt.start(); t.join()",
    "sys.stdout": "_ = sys.stdout.write('a')\nsys.stdout.flush()",
    "isatty": "sys.stdout.isatty(), sys.stdout.encoding",
    "fileno": "sys.stdout.fileno() >= 0",
    "carriage": "print('a\\rb')",
    "backspace": "print('a\\bb')",
    "ansi": "print('\\x1b[31mred\\x1b[0m')",
    "pprint": "import pprint\npprint.pprint({'a': list(range(30))})",
    "name": "__name__",
    "file": "__file__",
    "get_ipython": "get_ipython().execution_count",
    "display of None": "display()",
    "display None": "display(None)",
    "run": "%run -i script.py",
    "magic result": "%pwd;\n5",
    "env": "%env NOSUCH=1",
    "precision": "%precision 3\n3.14159265",
    "precision back": "%precision\n3.14159265",
    "system": "get_ipython().system('echo sys')",
    "getoutput": "get_ipython().getoutput('echo out')",
    "traceback": "import traceback\ntry:\n    1 / 0\nexcept ZeroDivisionError:\n    traceback.print_exc()",
    "showtraceback": "try:\n    1 / 0\nexcept ZeroDivisionError:\n    get_ipython().showtraceback()\nprint('after')",
    "del": "class Loud:\n    def __del__(self): raise ValueError('in del')\nl = Loud()\ndel l",
    "decorated": "@property\ndef p(self): return 1\np.fget(0)",
    "assignment expression": "(y := 5)",
    "multi display": "for n in range(3):\n    display(n)\n    print(n)",
    "interleaved": "for n in range(3):\n    print(n)\n    print(n, file=sys.stderr)",
    "pandas-less": "class Table:\n    def _repr_html_(self): return '<table></table>'\n    def _repr_latex_(self): return '$t$'\nTable().__class__.__name__",
    "widget": "import ipywidgets\nipywidgets.IntSlider(description='k')",
    "progress": "from IPython.display import ProgressBar\nProgressBar(3)",
    "audio": "Image(data=b'\\x89PNG\\r\\n\\x1a\\n' + bytes(30))",
    "publish": "from IPython.display import publish_display_data\npublish_display_data({'text/plain': 'published'})",
    "json": "from IPython.display import JSON\nJSON({'a': 1})",
    "pretty": "class Pretty:\n    def _repr_pretty_(self, p, cycle): p.text('pretty')\n[Pretty()]",
    "type": "Pretty",
    "function": "documented",
    "set": "{3, 1, 2}",
    "nested": "[[np.eye(2)], {'a': np.arange(3)}]",
    "lambda": "(lambda a: a).__name__",
    "ellipsis": "...",
    "bytes": "b'abc'",
    "task begun": "begun = asyncio.create_task(asyncio.sleep(0, 'waited for'))",
    "task waited for": "await begun",
    "a picture between prints": "print('a')\nplt.plot([1])\nplt.show()\nos.system('echo b')\ntime.sleep(0.2)\nprint('c')",
    "magic in a function": "def listing():\n    get_ipython().run_line_magic('who_ls', 'NoSuchType')\nlisting()",
}
NOTEBOOK = b'{"cells": [], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}'
#: first of all in the real kernel: without colours, and cells named as IPython names them. Under the names that ipykernel gives them
#: IPython 9 takes its short way through tracebacks, which marks the line that runs now and not the one that failed.
PREPARE = """
import ipykernel.compiler, IPython.core.compilerop
ipykernel.compiler.XCachingCompiler.get_code_name = IPython.core.compilerop.CachingCompiler.get_code_name
get_ipython().colors = "nocolor"
"""


@pytest.fixture(scope="module")
def in_a_kernel(tmp_path_factory):
    """The code cells as a real kernel leaves them."""
    made = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source) for source in (PREPARE, *CELLS.values())])
    with pytest.MonkeyPatch.context() as patch:
        patch.delenv("MPLBACKEND", raising=False)
        # a kernel that sees it does not watch its descriptors
        patch.delenv("PYTEST_CURRENT_TEST", raising=False)
        patch.setenv("IPYTHONDIR", str(tmp_path_factory.mktemp("ipython")))
        folder = {"metadata": {"path": str(tmp_path_factory.mktemp("kernel"))}}
        NotebookClient(made, kernel_name="python3", allow_errors=True, timeout=60, resources=folder).execute()
    return dict(zip(CELLS, made.cells[1:], strict=True))


@pytest.fixture(scope="module")
def in_a_session():
    """The outputs of the same cells as they cross the wire."""
    with Session(Limits(), sandbox=False) as session:
        session.run(PREPARE)
        return {name: session.run(source) for name, source in CELLS.items()}


@pytest.mark.parametrize("name", CELLS)
def test_a_cell_puts_out_what_a_kernel_puts_out(in_a_kernel, in_a_session, name):
    assert kept(in_a_session[name]) == kept(in_a_kernel[name]["outputs"])


def test_the_kernel_really_put_something_out(in_a_kernel):
    kinds = [output["output_type"] for cell in in_a_kernel.values() for output in cell["outputs"]]
    assert {kind: kinds.count(kind) > 9 for kind in set(kinds)} == dict.fromkeys(
        ("stream", "display_data", "execute_result", "error"), True
    )
    assert sum("image/png" in output.get("data", {}) for cell in in_a_kernel.values() for output in cell["outputs"]) > 9


def test_cells_are_numbered_as_by_a_kernel(in_a_kernel, in_a_session):
    """A traceback tells the number, and the executed notebook shows it beside the cell."""
    own = [Cell("code", source) for source in (PREPARE, *CELLS.values())]
    made = json.loads(executed_notebook(released(NOTEBOOK), own, [[], *in_a_session.values()]))
    numbers = dict(zip(CELLS, (cell["execution_count"] for cell in made["cells"][1:]), strict=True))
    assert numbers == {name: cell["execution_count"] for name, cell in in_a_kernel.items()}
    [error] = in_a_session["exception"]
    assert f"Cell In[{numbers['exception']}]" in "\n".join(error["traceback"])


def test_a_check_counts_as_the_cell_that_it_is_in_jupyter():
    with Session(Limits(), sandbox=False) as session:
        session.run("def one(): return 1")
        session.ask("one", [Question(())])
        [error] = session.run("1 / 0")
        assert "Cell In[3]" in "\n".join(error["traceback"])
        [output] = session.run("In")
        assert output["data"]["text/plain"] == repr(["", "def one(): return 1", 'check("one")', "1 / 0", "In"])


def kept(outputs):
    """What is the same: kinds and order of outputs, texts, exceptions, and where there is a picture.

    Left out on purpose: other MIME types than text and PNG. When a kernel's streams are emptied depends on the clock, so what is
    written to one of them between two other outputs is taken together. Times, addresses, and the frames of the kernel's own code and ours are not compared.
    """
    made, written = [], {}
    for output in outputs:
        if output["output_type"] == "stream":
            written[output["name"]] = written.get(output["name"], "") + steady(output["text"])
            continue
        made += [*sorted(written.items()), _kept(output)]
        written = {}
    return made + sorted(written.items())


def _kept(output):
    if output["output_type"] == "error":
        frames = steady("\n".join(output["traceback"])).split("\n\n")
        students = [frame for frame in frames if not re.match(r"File \S*/(ipykernel|autograder/sandbox)/", frame)]
        return "error", output["ename"], steady(output["evalue"]), *students
    return output["output_type"], steady(output["data"].get("text/plain", "")), "image/png" in output["data"]


def steady(text):
    """The text without what differs from run to run."""
    text = text.replace(os.path.expanduser("~"), "~")
    return re.sub(r"[\d.e+]+ [nµμm]?s\b", "TIME", re.sub(r"\b0x[0-9a-f]+", "0x", re.sub(r"\(\d+ times\)", "(n times)", text)))
