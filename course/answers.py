"""Asking an answer: find it, call it with inputs, and bring back plain data. Nothing here knows what is right.

The same functions run in the notebook of a student, in a full clone and inside the grader's sandbox. Whoever judges sees only
the `Interview` that comes out: names, texts and plain values.
"""

import ast
import builtins
import contextlib
import difflib
import inspect
import io
import linecache
import signal
import sys
import sysconfig
import threading
import time
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np

from course.figures import axes_summary, is_axes
from course.given import handed_over
from course.plain import Built, Plain, TimeUp, as_given, class_name, plain, plain_text, type_name

MAX_PRINTED = 2_000
MAX_MESSAGE = 500
MAX_WARNINGS = 5
TIME_LIMIT = 20.0

#: reads an exception's true traceback, whatever its class makes of attributes
_TRACEBACK = BaseException.__dict__["__traceback__"]
_OWN_CODE = (str(Path(__file__).resolve().parent), sysconfig.get_path("stdlib"), sysconfig.get_path("purelib"))


@dataclass(frozen=True)
class Question:
    """One call: positional arguments as plain data; `symbols`: call it with SymPy symbols, put the numbers in afterwards."""

    args: tuple[Plain, ...]
    symbols: bool = False


@dataclass(frozen=True)
class Trouble:
    """An exception as text: its type, the nearest built-in type, its message, and the student's own line."""

    type: str
    builtin: str
    message: str
    line: str = ""
    line_number: int = 0
    function: str = ""


@dataclass(frozen=True)
class Reply:
    """What one call gave: a plain value, or the trouble it ended in; and what it did on the way.

    `inputs` are the arguments as they stood after the call.
    """

    value: Plain = None
    trouble: Trouble | None = None
    inputs: tuple[Plain, ...] = ()
    printed: str = ""
    warned: tuple[str, ...] = ()


_UNANSWERED = Reply(trouble=Trouble("Unanswered", "Unanswered", ""))


@dataclass(frozen=True)
class Missing:
    """Why there is nothing to call.

    `reason` is "undefined", "nested" (in the function `where`), "similar" (the name `where` exists), "syntax" or "failed"
    (the cell that defines it ended in `trouble`).
    """

    reason: str
    where: str = ""
    trouble: Trouble | None = None


@dataclass(frozen=True)
class Interview:
    """Everything that is known of one answer after it was asked.

    `kind` names what the answer is ("function", "axes", or the name of its type); `mismatch` holds the number of arguments that
    did not fit and the answer's own parameters, when it cannot be called that way at all.
    """

    missing: Missing | None = None
    kind: str = "function"
    mismatch: tuple[int, str] | None = None
    replies: tuple[Reply, ...] = ()
    figure: Mapping[str, Plain] | None = None
    seconds: float = field(default=0.0, compare=False)

    def replies_to(self, questions: Sequence[Question]) -> tuple[Reply, ...]:
        """Return one reply for each question; one that never came is trouble."""
        missing = len(questions) - len(self.replies)
        return (*self.replies, *[_UNANSWERED] * missing)[: len(questions)]


def interview(answer: object, questions: Sequence[Question], time_limit: float = TIME_LIMIT) -> Interview:
    """Ask `answer` all the questions and return what came of it. Stops at the first call that is interrupted or too slow."""
    replies: list[Reply] = []
    try:
        with _alarm(time_limit):
            uncallable = _uncallable(answer, questions)
            if uncallable is not None:
                return uncallable
            for question in questions:
                reply = reply_to(answer, question)
                replies.append(reply)
                if reply.trouble is not None and reply.trouble.type in ("KeyboardInterrupt", "TimeUp"):
                    break
    except TimeUp as error:  # it rang between two calls, or while a hostile object was looked at
        replies.append(Reply(trouble=trouble_of(error)))
    return Interview(replies=tuple(replies))


def _uncallable(answer: object, questions: Sequence[Question]) -> Interview | None:
    """Return the whole interview if the answer is no function, or one of other arguments; else None."""
    if is_axes(answer):
        try:
            return Interview(kind="axes", figure=axes_summary(answer))
        except TimeUp:
            raise
        except BaseException:  # an Axes of the student's own making
            return Interview(kind=type_name(answer))
    if not callable(answer):
        return Interview(kind=type_name(answer))
    for count in {len(question.args) for question in questions}:
        mismatch = _signature_mismatch(answer, count)
        if mismatch:
            return Interview(mismatch=mismatch)
    return None


def reply_to(answer: Any, question: Question) -> Reply:
    """Put one question to `answer`, with copies of the arguments, and return its reply."""
    if question.symbols:
        return _symbolic_reply(answer, question)
    with handed_over(question.args) as given:
        value, trouble, printed, warned = _called(answer, given)
    try:
        # nobody can tell whether a robot or a file is still what it was, and nothing is seen of it later
        after = tuple(arg if isinstance(arg, Built) else as_given(now) for arg, now in zip(question.args, given, strict=True))
        return Reply(plain(value), trouble, after, printed, warned)
    except BaseException as error:  # an object that fails while it is read is an answer that fails
        return Reply(None, trouble_of(error), (), printed, warned)


def find(name: str, namespace: Mapping[str, object], cells: Sequence[str] = ()) -> tuple[object, Missing | None]:
    """Look `name` up in a notebook's namespace; `cells` are the sources run so far, read only to explain its absence.

    Returns (answer, None) or (None, why it is missing).
    """
    if name in namespace:
        return namespace[name], None
    for source in reversed(cells):
        if name not in source:
            continue
        missing = _missing_in_cell(name, source)
        if missing:
            return None, missing
    own_names = [
        key for key, value in namespace.items() if type(key) is str and key[:1] != "_" and (callable(value) or is_axes(value))
    ]
    close = difflib.get_close_matches(name, own_names, n=1, cutoff=0.85)
    return None, Missing("similar", close[0]) if close else Missing("undefined")


def _missing_in_cell(name: str, source: str) -> Missing | None:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(_without_magics(source))
    except SyntaxError as error:
        return Missing("syntax", trouble=_syntax_trouble(error)) if f"def {name}" in source else None
    except (ValueError, RuntimeError, MemoryError):
        return None
    for outer in ast.walk(tree):
        if isinstance(outer, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            inner = [node for node in ast.walk(outer) if isinstance(node, ast.FunctionDef) and node is not outer]
            if any(node.name == name for node in inner):
                return Missing("nested", outer.name[:80])
    return None


def _without_magics(source: str) -> str:
    """Return a cell as the Python that IPython makes of it: %magics and !commands are no syntax errors in a notebook."""
    if "IPython" not in sys.modules or not any(mark in source for mark in "%!?"):
        return source
    from IPython.core.inputtransformer2 import TransformerManager

    return TransformerManager().transform_cell(source)


def _syntax_trouble(error: SyntaxError) -> Trouble:
    line = (error.text or "").strip()[:MAX_MESSAGE]
    return Trouble(type(error).__name__, "SyntaxError", str(error.msg)[:MAX_MESSAGE], line, error.lineno or 0)


def _signature_mismatch(answer: Any, count: int) -> tuple[int, str] | None:
    try:
        signature = inspect.signature(answer)
    except Exception:  # it has none, or a hostile one: the call will tell
        return None
    try:
        signature.bind(*range(count))
    except TypeError:
        return count, plain_text(signature, 200)
    return None


class _Capped(io.TextIOBase):
    """A text stream that keeps only the beginning of what is written to it."""

    def __init__(self) -> None:
        self.text = ""

    def writable(self) -> bool:
        return True

    def write(self, text: str) -> int:
        length = str.__len__(text)
        self.text += str.__getitem__(text, slice(max(MAX_PRINTED - len(self.text), 0)))
        return length


def _called(answer: Any, given: Sequence[object]) -> tuple[object, Trouble | None, str, tuple[str, ...]]:
    printed = _Capped()
    value, trouble = None, None
    with warnings.catch_warnings(record=True) as caught:
        # filters and NumPy's error state are set here, so that a notebook that silenced them is judged like any other
        warnings.simplefilter("always")
        with np.errstate(divide="warn", over="warn", invalid="warn", under="ignore"):
            try:
                with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
                    value = answer(*given)
            except BaseException as error:  # SystemExit, TimeUp and what students derive from BaseException are its business too
                trouble = trouble_of(error)
    # a set first: a warning inside a loop comes back thousands of times
    warned = {f"{class_name(item.category)}: {plain_text(item.message)}"[:MAX_MESSAGE] for item in caught[:1000]}
    return value, trouble, plain_text(printed.text, MAX_PRINTED), tuple(sorted(warned)[:MAX_WARNINGS])


def trouble_of(error: BaseException) -> Trouble:
    """Return an exception as text, with the student's own line."""
    bases = [(class_name(base), base) for base in type.mro(type(error))]
    builtin = next((name for name, base in bases if getattr(builtins, name, None) is base), "Exception")
    line, number, function = _own_line(_TRACEBACK.__get__(error))
    return Trouble(type_name(error), builtin, plain_text(error, MAX_MESSAGE), line, number, function)


def _own_line(traceback: TracebackType | None) -> tuple[str, int, str]:
    """Return (source, line number, function) of the deepest frame that is the student's own code."""
    own = ("", 0, "")
    while traceback is not None:
        code = traceback.tb_frame.f_code
        if not code.co_filename.startswith((*_OWN_CODE, "<frozen", "<__array_function__")):
            line = plain_text(linecache.getline(code.co_filename, traceback.tb_lineno)).strip()[:200]
            own = (line, traceback.tb_lineno, plain_text(code.co_name, 80))
        traceback = traceback.tb_next
    return own


@contextlib.contextmanager
def _alarm(seconds: float) -> Iterator[None]:
    """Raise `TimeUp` in this thread after `seconds`, where the system has such alarms (main thread, not on Windows)."""
    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    def ring(*_: object) -> None:
        raise TimeUp

    before = signal.signal(signal.SIGALRM, ring)
    # it rings again every second: an answer with a bare `except:` may swallow the first one
    remaining, interval = signal.setitimer(signal.ITIMER_REAL, seconds, 1.0)
    started = time.monotonic()
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before or signal.SIG_DFL)
        if remaining:  # somebody's alarm was under way already
            signal.setitimer(signal.ITIMER_REAL, max(remaining - (time.monotonic() - started), 0.001), interval)


def _symbolic_reply(answer: Any, question: Question) -> Reply:
    """Call the answer with symbols; then put the numbers into the expressions that it returned."""
    import sympy

    symbols = sympy.symbols(f"s0:{len(question.args)}", real=True)
    value, trouble, printed, warned = _called(answer, symbols)
    if trouble is not None:
        return Reply(None, trouble, question.args, printed, warned)
    numbers = {symbol: sympy.Float(number) for symbol, number in zip(symbols, question.args, strict=True)}
    try:
        return Reply(plain(_substituted(value, numbers)), None, question.args, printed, warned)
    except BaseException as error:
        return Reply(None, trouble_of(error), question.args, printed, warned)


def _substituted(value: object, numbers: Mapping[Any, Any]) -> object:
    sympy = sys.modules["sympy"]
    if isinstance(value, sympy.MatrixBase | sympy.Expr):
        # not xreplace, which would build the whole expression anew
        return value.evalf(17, subs=numbers)
    if isinstance(value, list | tuple):
        return [_substituted(item, numbers) for item in value]
    if type(value) is np.ndarray and value.dtype.kind == "O" and value.ndim <= 1:
        return [_substituted(item, numbers) for item in value.tolist()]
    return value
