"""Running notebook cells as IPython runs them, without a kernel: the outputs come back as plain dictionaries."""

import contextlib
import io
import signal
import sys
from collections.abc import Iterator
from typing import Any

from IPython.core.displayhook import DisplayHook
from IPython.core.displaypub import DisplayPublisher
from IPython.core.interactiveshell import InteractiveShell
from traitlets import Type
from traitlets.config import Config

MAX_TEXT = 100_000
MAX_OUTPUTS = 200

Output = dict[str, Any]


class Outputs:
    """What the cell that runs now has put out; capped, so that a flood costs no memory."""

    def __init__(self) -> None:
        self.items: list[Output] = []
        self._room = MAX_TEXT

    def clear(self) -> None:
        """Begin a new cell."""
        self.items = []
        self._room = MAX_TEXT

    def add(self, output: Output) -> None:
        """Append one output, if there is room for it."""
        if len(self.items) < MAX_OUTPUTS:
            self.items.append(output)

    def stream(self, name: str, text: str) -> None:
        """Append printed text, joined to what the same stream just wrote."""
        text, self._room = text[: self._room], self._room - min(len(text), self._room)
        if not text:
            return
        if self.items and self.items[-1].get("name") == name:
            self.items[-1]["text"] += text
        else:
            self.add({"output_type": "stream", "name": name, "text": text})


class _Stream(io.TextIOBase):
    def __init__(self, outputs: Outputs, name: str) -> None:
        self._outputs, self._name = outputs, name

    def writable(self) -> bool:
        return True

    def write(self, text: str) -> int:
        self._outputs.stream(self._name, str(text))
        return len(text)


class _Publisher(DisplayPublisher):
    outputs: Outputs

    def publish(self, data: Any, metadata: Any = None, *_: Any, **__: Any) -> None:
        self.outputs.add({"output_type": "display_data", "data": dict(data), "metadata": {}})

    def clear_output(self, wait: bool = False) -> None:
        self.outputs.clear()


class _Hook(DisplayHook):
    outputs: Outputs

    def write_output_prompt(self) -> None:
        """Print no prompt: a notebook shows it beside the output."""

    def write_format_data(self, format_dict: dict[str, Any], md_dict: Any = None) -> None:
        self.outputs.add({"output_type": "execute_result", "data": dict(format_dict), "metadata": {}})


class _Shell(InteractiveShell):
    """IPython's shell whose results, displays and errors are kept instead of printed."""

    displayhook_class = Type(_Hook)
    display_pub_class = Type(_Publisher)
    outputs: Outputs

    def enable_gui(self, gui: Any = None) -> None:
        """Do nothing: figures are drawn inline, and there are no windows here."""

    def _showtraceback(self, etype: type, evalue: BaseException, stb: Any) -> None:
        self.outputs.add(
            {
                "output_type": "error",
                "ename": str(etype.__name__)[:200],
                "evalue": str(evalue)[:2000],
                "traceback": [str(line)[:5000] for line in list(stb)[:60]],
            }
        )


class Cells:
    """One notebook's namespace, and the running of its cells."""

    def __init__(self) -> None:
        config = Config()
        config.HistoryManager.enabled = False
        config.InteractiveShell.colors = "nocolor"
        self._outputs = Outputs()
        self._shell = _Shell.instance(config=config)
        for part in (self._shell, self._shell.displayhook, self._shell.display_pub):
            part.outputs = self._outputs
        self._shell.enable_matplotlib("inline")

    @property
    def namespace(self) -> dict[str, object]:
        """Return the names that the cells have defined."""
        names: dict[str, object] = self._shell.user_ns
        return names

    @property
    def sources(self) -> list[str]:
        """Return the sources of the cells run so far."""
        return [str(source) for source in self._shell.user_ns.get("In", [])]

    def run(self, source: str, seconds: float) -> list[Output]:
        """Run one cell for at most `seconds` and return its outputs."""
        self._outputs.clear()
        streams = _Stream(self._outputs, "stdout"), _Stream(self._outputs, "stderr")
        with contextlib.redirect_stdout(streams[0]), contextlib.redirect_stderr(streams[1]), _time_limit(seconds):
            self._shell.run_cell(source, store_history=True)
        return self._outputs.items


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
