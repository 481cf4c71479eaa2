"""Running notebook cells as IPython runs them, without a kernel: the outputs come back as plain dictionaries."""

import ast
import base64
import builtins
import contextlib
import getpass
import io
import itertools
import os
import signal
import sys
import tempfile
import warnings
from asyncio import CancelledError
from collections.abc import Callable, Coroutine, Iterable, Iterator, Mapping
from types import CodeType
from typing import Any, NoReturn

import matplotlib_inline.config
from IPython.core import page
from IPython.core.async_helpers import get_asyncio_loop
from IPython.core.displayhook import DisplayHook
from IPython.core.displaypub import DisplayPublisher
from IPython.core.error import StdinNotImplementedError
from IPython.core.interactiveshell import InteractiveShell
from IPython.core.pylabtools import print_figure
from matplotlib.pyplot import close
from traitlets import Type
from traitlets.config import Config

from course.plotting import new_axes

MAX_TEXT = 100_000
MAX_PICTURES = 8 * 2**20
MAX_OUTPUTS = 200
MAX_NAMES = 10_000
# at the top of a cell `await` is allowed
_AWAIT = ast.PyCF_ALLOW_TOP_LEVEL_AWAIT

Output = dict[str, Any]


class Outputs:
    """What the cell that runs now has put out; capped, so that a flood costs no memory and fits into one message.

    `collect` is called before anything is appended: what programs wrote meanwhile comes first.
    """

    def __init__(self, collect: Callable[[], object] = lambda: None) -> None:
        self._collect = collect
        self.clear()

    def clear(self, wait: bool = False) -> None:
        """Begin anew, at once or when the next output comes."""
        self._cleared_by_next = wait
        if wait:
            return
        self.items: list[Output] = []
        #: displays that may still change, by the id that the cell gave them
        self._named: dict[str, list[Output]] = {}
        self._text, self._pictures = MAX_TEXT, MAX_PICTURES

    def stream(self, name: str, text: str) -> None:
        """Append printed text, joined to what the same stream just wrote."""
        self._prepare()
        text = self._fitted(text)
        if not text:
            return
        if self.items and self.items[-1].get("name") == name:
            self.items[-1]["text"] += text
        else:
            self._add({"output_type": "stream", "name": name, "text": text})

    def display(self, kind: str, data: Mapping[str, Any], display_id: object = None) -> None:
        """Append what was displayed: its text and its picture, which is all that is ever shown of it."""
        self._prepare()
        output = {"output_type": kind, "data": self._shown(data)}
        if self._add(output) and isinstance(display_id, str):
            self._named.setdefault(display_id, []).append(output)

    def update(self, display_id: object, data: Mapping[str, Any]) -> None:
        """Show something else in the place of what this cell displayed under this id; earlier cells are handed over already."""
        for output in self._named.get(display_id, ()) if isinstance(display_id, str) else ():
            self._text += len(output["data"].get("text/plain", ""))
            self._pictures += len(output["data"].get("image/png", ""))
            output["data"] = self._shown(data)

    def error(self, name: str, value: str, traceback: Iterable[str]) -> None:
        """Append an exception."""
        self._prepare()
        lines = [self._fitted(line) for line in itertools.islice(traceback, 60)]
        self._add({"output_type": "error", "ename": name[:200], "evalue": value[:2000], "traceback": lines})

    def _prepare(self) -> None:
        self._collect()
        if self._cleared_by_next:
            self.clear()

    def _add(self, output: Output) -> bool:
        """Append one output, if there is room for it."""
        if len(self.items) >= MAX_OUTPUTS:
            return False
        self.items.append(output)
        return True

    def _shown(self, data: Mapping[str, Any]) -> dict[str, str]:
        shown = {}
        text, picture = data.get("text/plain"), data.get("image/png")
        if isinstance(text, str):
            shown["text/plain"] = self._fitted(text)
        if isinstance(picture, bytes):
            picture = base64.b64encode(picture).decode()
        if isinstance(picture, str) and len(picture) <= self._pictures:
            self._pictures -= len(picture)
            shown["image/png"] = picture
        return shown

    def _fitted(self, text: str) -> str:
        text = text[: self._text]
        self._text -= len(text)
        return text


class _Stream(io.TextIOBase):
    #: as a kernel's: what is printed may depend on it
    encoding = "UTF-8"

    def __init__(self, outputs: Outputs, name: str, descriptor: int) -> None:
        self._outputs, self._name, self._descriptor = outputs, name, descriptor

    def writable(self) -> bool:
        return True

    def fileno(self) -> int:
        return self._descriptor

    def write(self, text: str) -> int:
        self._outputs.stream(self._name, str(text))
        return len(text)


class _Descriptor:
    """A file without a name in the place of a descriptor, emptied whenever something else is put out, and after each cell."""

    def __init__(self, name: str, descriptor: int) -> None:
        self.name = name
        self._file = os.open(tempfile.gettempdir(), os.O_TMPFILE | os.O_RDWR)
        os.dup2(self._file, descriptor)

    def taken(self) -> str:
        """Return what was written since the last time."""
        if not os.lseek(self._file, 0, os.SEEK_CUR):
            return ""
        text = os.pread(self._file, MAX_TEXT, 0).decode(errors="replace")
        os.ftruncate(self._file, 0)
        os.lseek(self._file, 0, os.SEEK_SET)
        return text


def _refused_input(prompt: object = "") -> NoReturn:
    raise StdinNotImplementedError("raw_input was called, but this frontend does not support input requests.")


def _refused_getpass(prompt: object = "", stream: object = None) -> NoReturn:
    raise StdinNotImplementedError("getpass was called, but this frontend does not support input requests.")


class _Publisher(DisplayPublisher):
    outputs: Outputs

    def publish(
        self, data: Any, metadata: Any = None, source: Any = None, *, transient: Any = None, update: bool = False, **_: Any
    ) -> None:
        display_id = (transient or {}).get("display_id")
        if update:
            self.outputs.update(display_id, data)
        else:
            self.outputs.display("display_data", data, display_id)

    def clear_output(self, wait: bool = False) -> None:
        self.outputs.clear(wait)


class _Hook(DisplayHook):
    outputs: Outputs

    def write_output_prompt(self) -> None:
        """Print no prompt: a notebook shows it beside the output."""

    def write_format_data(self, format_dict: dict[str, Any], md_dict: Any = None) -> None:
        self.outputs.display("execute_result", format_dict)


class _Shell(InteractiveShell):
    """IPython's shell whose results, displays and errors are kept instead of printed."""

    displayhook_class = Type(_Hook)
    display_pub_class = Type(_Publisher)
    outputs: Outputs

    def enable_gui(self, gui: Any = None) -> None:
        """Do nothing: figures are drawn inline, and there are no windows here."""

    def init_hooks(self) -> None:
        """Show help in no pager: a notebook keeps nothing of it."""
        super().init_hooks()
        self.set_hook("show_in_pager", page.as_hook(lambda *_, **__: None), 99)

    def ask_exit(self) -> None:
        """Go on: what comes after exit() is graded too."""

    def _showtraceback(self, etype: type, evalue: BaseException, stb: Any) -> None:
        try:
            value = str(evalue)
        except Exception:
            value = ""
        self.outputs.error(str(etype.__name__), value, map(str, stb))


class Cells:
    """One notebook's namespace, and the running of its cells; `sources` are those run so far."""

    def __init__(self) -> None:
        config = Config()
        config.HistoryManager.enabled = False
        config.InteractiveShell.colors = "nocolor"
        self._descriptors: list[_Descriptor] = []
        self._outputs = Outputs(self._collect)
        self.sources: list[str] = []
        self._shell = _Shell.instance(config=config)
        for part in (self._shell, self._shell.displayhook, self._shell.display_pub):
            part.outputs = self._outputs
        self._shell.loop_runner = _until_done
        self._shell.enable_matplotlib("inline")
        # the default, "tight", draws every picture twice
        matplotlib_inline.config.InlineBackend.instance(parent=self._shell).print_figure_kwargs = {}
        builtins.input = _refused_input
        getpass.getpass = _refused_getpass

    def warm_up(self) -> None:
        """Run a cell, fail in another, and draw a figure with a formula and Japanese, as a first notebook would; nothing of it stays.

        The first traceback looks at the files of all modules, which takes longer than most notebooks.
        """
        self._shell.run_cell("import math; [math.pi]", store_history=False, silent=True)
        self._shell.run_cell("(lambda: math.sqrt(-1))()", store_history=False, silent=True)
        self._outputs.clear()
        del sys.last_type, sys.last_value, sys.last_traceback
        figure = new_axes().figure
        figure.suptitle(r"姿勢 $\theta_1$")
        print_figure(figure, "png")
        close("all")
        del self._shell.user_ns["math"]

    def watch_descriptors(self) -> None:
        """Keep what programs write to this process's own standard output and error, not through Python."""
        self._descriptors = [_Descriptor("stdout", 1), _Descriptor("stderr", 2)]

    @property
    def namespace(self) -> dict[str, object]:
        """Return the names that the cells have defined."""
        names: dict[str, object] = self._shell.user_ns
        return names

    def names_used(self, sources: Iterable[str]) -> list[str]:
        """Return the names that cells use and do not define within a function of their own; attributes are among them."""
        used: set[str] = set()
        for source in sources:
            # what does not compile will not run either
            with contextlib.suppress(Exception), warnings.catch_warnings(action="ignore"):
                used |= _names_in(compile(self._without_magics(source), "cell", "exec", _AWAIT))
        return sorted(used)[:MAX_NAMES]

    def run(self, source: str, seconds: float) -> list[Output]:
        """Run one cell for at most `seconds` and return its outputs."""
        self._outputs.clear()
        python = self._without_magics(source)
        self.sources.append(python)
        streams = _Stream(self._outputs, "stdout", 1), _Stream(self._outputs, "stderr", 2)
        with contextlib.redirect_stdout(streams[0]), contextlib.redirect_stderr(streams[1]), _time_limit(seconds):
            if self._shell.should_run_async(source, transformed_cell=python):
                # IPython runs the loop
                self._shell.run_cell(source, store_history=True)
            else:
                _until_done(self._cell(source))
        self._collect()
        return self._outputs.items

    def count(self, source: str) -> None:
        """Count a cell that is not run here as if it were: the numbers of those after it are the same then as in Jupyter."""
        history: Any = self._shell.history_manager
        history.store_inputs(self._shell.execution_count, source)
        self._shell.execution_count += 1

    async def _cell(self, source: str) -> None:
        """Run a cell that does not wait for anything. An event loop runs meanwhile, as in a kernel: it may begin a task."""
        self._shell.run_cell(source, store_history=True)

    def _collect(self) -> None:
        """Move what was written to this process's own standard output and error into the outputs of the cell."""
        for stream in (sys.__stdout__, sys.__stderr__):
            # closed by a cell, perhaps
            with contextlib.suppress(Exception):
                if stream is not None:
                    stream.flush()
        # all of it first: with each output this is called again
        for name, text in [(descriptor.name, descriptor.taken()) for descriptor in self._descriptors]:
            if text:
                self._outputs.stream(name, text)

    def _without_magics(self, source: str) -> str:
        """Return a cell as Python reads it, so that what it defines can be looked up."""
        if not any(mark in source for mark in "%!?"):
            return source
        try:
            return str(self._shell.transform_cell(source))
        except Exception:  # it will not run either
            return source


def _until_done(coroutine: Coroutine[Any, Any, Any]) -> Any:
    """Run the event loop until a cell is done."""
    # made in the notebook's own process: forks would share what it waits on
    loop = get_asyncio_loop()
    task = loop.create_task(coroutine)
    try:
        return loop.run_until_complete(task)
    except KeyboardInterrupt as interrupt:
        # or it would go on while later cells run
        task.cancel(str(interrupt))
        try:
            return loop.run_until_complete(task)
        except CancelledError:
            # it had not even begun
            raise interrupt from None


def _names_in(code: CodeType) -> set[str]:
    return set(code.co_names).union(*(_names_in(part) for part in code.co_consts if isinstance(part, CodeType)))


@contextlib.contextmanager
def _time_limit(seconds: float) -> Iterator[None]:
    """Interrupt the cell as the stop button does, again every second until it gives in."""

    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt(f"the cell did not finish within {seconds:g} s")

    signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, seconds, 1.0)
    try:
        yield
    except KeyboardInterrupt:
        # it rang between the cell's end and the next line
        print("interrupted", file=sys.stderr)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
