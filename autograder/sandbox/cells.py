"""Running notebook cells as IPython runs them, without a kernel: the outputs come back as plain dictionaries."""

import ast
import base64
import builtins
import contextlib
import io
import itertools
import os
import signal
import sys
import tempfile
import warnings
from collections.abc import Iterable, Iterator, Mapping
from types import CodeType
from typing import Any

import matplotlib_inline.config
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
    """What the cell that runs now has put out; capped, so that a flood costs no memory and fits into one message."""

    def __init__(self) -> None:
        self.clear()

    def clear(self) -> None:
        """Begin a new cell."""
        self.items: list[Output] = []
        self._text, self._pictures = MAX_TEXT, MAX_PICTURES

    def add(self, output: Output) -> None:
        """Append one output, if there is room for it."""
        if len(self.items) < MAX_OUTPUTS:
            self.items.append(output)

    def stream(self, name: str, text: str) -> None:
        """Append printed text, joined to what the same stream just wrote."""
        text = self._fitted(text)
        if not text:
            return
        if self.items and self.items[-1].get("name") == name:
            self.items[-1]["text"] += text
        else:
            self.add({"output_type": "stream", "name": name, "text": text})

    def display(self, kind: str, data: Mapping[str, Any]) -> None:
        """Append what was displayed: its text and its picture, which is all that is ever shown of it."""
        shown = {}
        text, picture = data.get("text/plain"), data.get("image/png")
        if isinstance(text, str):
            shown["text/plain"] = self._fitted(text)
        if isinstance(picture, bytes):
            picture = base64.b64encode(picture).decode()
        if isinstance(picture, str) and len(picture) <= self._pictures:
            self._pictures -= len(picture)
            shown["image/png"] = picture
        self.add({"output_type": kind, "data": shown})

    def error(self, name: str, value: str, traceback: Iterable[str]) -> None:
        """Append an exception."""
        lines = [self._fitted(line) for line in itertools.islice(traceback, 60)]
        self.add({"output_type": "error", "ename": name[:200], "evalue": value[:2000], "traceback": lines})

    def _fitted(self, text: str) -> str:
        text = text[: self._text]
        self._text -= len(text)
        return text


class _Stream(io.TextIOBase):
    def __init__(self, outputs: Outputs, name: str) -> None:
        self._outputs, self._name = outputs, name

    def writable(self) -> bool:
        return True

    def write(self, text: str) -> int:
        self._outputs.stream(self._name, str(text))
        return len(text)


class _Descriptor:
    """A file without a name in the place of a descriptor, emptied after each cell."""

    def __init__(self, outputs: Outputs, name: str, descriptor: int) -> None:
        self._outputs, self._name = outputs, name
        self._file = os.open(tempfile.gettempdir(), os.O_TMPFILE | os.O_RDWR)
        os.dup2(self._file, descriptor)

    def collect(self) -> None:
        """Move what was written into the outputs of the cell."""
        size = os.lseek(self._file, 0, os.SEEK_CUR)
        if not size:
            return
        text = os.pread(self._file, MAX_TEXT, 0).decode(errors="replace")
        os.ftruncate(self._file, 0)
        os.lseek(self._file, 0, os.SEEK_SET)
        self._outputs.stream(self._name, text)


def _refused_input(prompt: object = "") -> str:
    raise StdinNotImplementedError("raw_input was called, but this frontend does not support input requests.")


class _Publisher(DisplayPublisher):
    outputs: Outputs

    def publish(self, data: Any, metadata: Any = None, *_: Any, **__: Any) -> None:
        self.outputs.display("display_data", data)

    def clear_output(self, wait: bool = False) -> None:
        self.outputs.clear()


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
        self._outputs = Outputs()
        self._descriptors: list[_Descriptor] = []
        self.sources: list[str] = []
        self._shell = _Shell.instance(config=config)
        for part in (self._shell, self._shell.displayhook, self._shell.display_pub):
            part.outputs = self._outputs
        self._shell.enable_matplotlib("inline")
        # the default, "tight", draws every picture twice
        matplotlib_inline.config.InlineBackend.instance(parent=self._shell).print_figure_kwargs = {}
        builtins.input = _refused_input

    def warm_up(self) -> None:
        """Run a cell and draw a figure with a formula and Japanese in it, as the first notebook would; nothing of it stays."""
        self._shell.run_cell("import math; [math.pi]", store_history=False, silent=True)
        figure = new_axes().figure
        figure.suptitle(r"姿勢 $\theta_1$")
        print_figure(figure, "png")
        close("all")
        del self._shell.user_ns["math"]

    def watch_descriptors(self) -> None:
        """Keep what programs write to this process's own standard output and error, not through Python."""
        self._descriptors = [_Descriptor(self._outputs, "stdout", 1), _Descriptor(self._outputs, "stderr", 2)]

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
        self.sources.append(self._without_magics(source))
        streams = _Stream(self._outputs, "stdout"), _Stream(self._outputs, "stderr")
        with contextlib.redirect_stdout(streams[0]), contextlib.redirect_stderr(streams[1]), _time_limit(seconds):
            self._shell.run_cell(source, store_history=True)
        for descriptor in self._descriptors:
            descriptor.collect()
        return self._outputs.items

    def _without_magics(self, source: str) -> str:
        """Return a cell as Python reads it, so that what it defines can be looked up."""
        try:
            return str(self._shell.transform_cell(source))
        except Exception:  # it will not run either
            return source


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
