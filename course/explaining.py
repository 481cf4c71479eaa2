"""Kind words for what went wrong: the records of an asked answer, turned into messages in both languages.

Each message says what happened, the likely cause, and what to do or where to look; never what the right answer is. Errors are
explained from one table: the first row whose exception and message fit is told. What a student wrote is only ever filled in as a
value, shortened, with invisible characters made visible.
"""

import functools
import re

from course.answers import Missing, Trouble
from course.explanations import (
    FALLBACK,
    FALLBACK_SILENT,
    KIND,
    KINDS,
    LINE,
    LINE_ELSEWHERE,
    MISMATCH,
    MISSING,
    NO_RETURN,
    NOT_AX,
    NOT_AXES,
    ODD,
    ODD_TYPES,
    PRINTED,
    ROWS,
    TYPES,
)
from course.language import Text
from course.plain import Odd

MAX_SHOWN = 120
_MAX_READ = 500
_NUMERALS = {"no": "0", "one": "1", "two": "2", "three": "3"}
_AMOUNT = Text("{number}", "{number}個")
_AMOUNTS = {
    "least": Text("at least {number}", "{number}個以上"),
    "most": Text("at most {number}", "{number}個以下"),
    "from": Text("{least} to {number}", "{least}〜{number}個"),
}


def explained_trouble(name: str, trouble: Trouble) -> Text:
    """Explain the exception in which a call of the answer `name` ended."""
    return _place(name, trouble) + _explained(name, trouble)


def explained_missing(name: str, missing: Missing) -> Text:
    """Explain why there is no answer called `name` yet."""
    text = MISSING.get(missing.reason, MISSING["undefined"]).format(name=shown(name), where=shown(missing.where))
    return text if missing.trouble is None else text + Text("\n", "\n") + explained_trouble(name, missing.trouble)


def explained_mismatch(name: str, parameters: str, mismatch: tuple[int, str]) -> Text:
    """Explain that the answer cannot be called with as many arguments as the exercise gives.

    `parameters` are those of the stub, such as "pose, distance"; `mismatch` is the number given and the answer's own parameters.
    """
    count, own = mismatch
    given = Text("1 value" if count == 1 else f"{count} values", f"{count}個の値")
    return MISMATCH.format(name=shown(name), given=given, parameters=shown(parameters), own=shown(own))


def explained_kind(name: str, kind: str) -> Text:
    """Explain that `name` holds a value of type `kind` where a function is asked for."""
    return KINDS.get(kind, KIND).format(name=shown(name), kind=_type_in_words(kind))


def explained_not_axes(name: str, kind: str) -> Text:
    """Explain that `name` holds a value of type `kind` where the Axes of a graph is asked for."""
    return NOT_AXES.get(kind, NOT_AX).format(name=shown(name), kind=_type_in_words(kind))


def explained_odd(odd: Odd) -> Text:
    """Explain that a value came back that is not made of plain numbers."""
    text = ODD_TYPES.get((odd.kind, odd.type_name)) or ODD.get(odd.kind, ODD["other"])
    return text.format(kind=_type_in_words(odd.type_name), type_name=shown(odd.type_name))


def explained_none(printed: str) -> Text:
    """Explain that None came back; `printed` is what the answer printed instead."""
    first = next((line.strip() for line in printed[:_MAX_READ].splitlines() if line.strip()), "")
    return PRINTED.format(printed=shown(first)) if first else NO_RETURN


def shown(text: str, longest: int = MAX_SHOWN) -> str:
    r"""Return a student's text fit to be quoted: on one line, not too long, invisible characters made visible.

    >>> shown("a\u3000=\u202e 1")
    'a<U+3000>=<U+202E> 1'
    """
    flat = text[: longest + 1].replace("\n", " ").replace("\t", " ")
    visible = "".join(mark if mark.isprintable() else f"<U+{ord(mark):04X}>" for mark in flat)
    return visible if len(visible) <= longest else visible[: longest - 1] + "…"


def _place(name: str, trouble: Trouble) -> Text:
    """Return the student's line as a first line of the message, or nothing if it is not known."""
    if not trouble.line.strip():
        return Text("", "")
    elsewhere = trouble.function.isidentifier() and trouble.function != name
    template = LINE_ELSEWHERE if elsewhere else LINE
    return template.format(number=trouble.line_number, line=shown(trouble.line), function=shown(trouble.function))


def _explained(name: str, trouble: Trouble) -> Text:
    message = trouble.message[:_MAX_READ]
    values: dict[str, object] = {
        "name": shown(name),
        "type": shown(trouble.type),
        "message": shown(_without_path(message).strip().rstrip(".")),
    }
    for row in ROWS:
        if not {trouble.type, trouble.builtin} & set(row.errors.split()):
            continue
        match = _compiled(row.pattern).search(message)
        if match is None or not _compiled(row.line).search(trouble.line[:_MAX_READ]):
            continue
        groups = {key: value or "" for key, value in match.groupdict().items()}
        found = row.found({**groups, "name": name, "raised_in": trouble.function}) if row.found else ""
        if found is not None:
            words = {key: _in_words(key, value) for key, value in groups.items()}
            return Text(row.en, row.ja).format(**values, **words, found=shown(found))
    return (FALLBACK if message.strip() else FALLBACK_SILENT).format(**values)


@functools.cache
def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern, re.DOTALL)


def _without_path(message: str) -> str:
    """Drop the path of a library that Python adds in parentheses: it tells a student nothing."""
    return re.sub(r" ?\((?:/|[A-Za-z]:\\)[^)]*\)", "", message)


def _in_words(group: str, value: str) -> object:
    if not value:
        return ""
    if group.startswith("type"):
        return _type_in_words(value)
    if group == "amount":
        return _amount_in_words(value)
    if group == "shapes":
        return _shapes_in_words(value)
    if group.startswith("shape"):
        return _shape_in_words(value)
    if group.startswith("names"):
        return shown(", ".join(re.findall(r"'([^']*)'", value)))
    return shown(value.rpartition("<locals>.")[2])


def _type_in_words(type_name: str) -> Text:
    bare = type_name.removeprefix("numpy.")
    known = TYPES.get(bare)
    return known or Text("a value of type {name}", "{name}型の値").format(name=shown(bare, 60))


def _amount_in_words(amount: str) -> Text:
    """Return how many arguments a function takes, as in Python's messages: "from 1 to 2", "at least 1", "exactly one", "no"."""
    words = amount.removeprefix("at ").split() or [amount]
    least, number = (_NUMERALS.get(word, word) for word in (words[min(1, len(words) - 1)], words[-1]))
    return _AMOUNTS.get(words[0], _AMOUNT).format(least=shown(least), number=shown(number))


def _shapes_in_words(text: str) -> Text:
    """Return the different shapes in one of NumPy's messages in words, in order."""
    shapes = re.findall(r"\([\d, ]*\)", re.sub(r"->\([^)]*\)", "", text))[:8]
    words = list(dict.fromkeys(map(_shape_in_words, shapes)))
    return Text(", ".join(word.en for word in words), "、".join(word.ja for word in words))


def _shape_in_words(shape: str) -> Text:
    """Return a shape as NumPy writes it, such as "(2,3)", in words."""
    sizes = ["-1" if size == "newaxis" else size for size in re.findall(r"\d{1,20}|newaxis", shape)][:8]
    if not sizes:
        return Text("a single number", "数値1個")
    if len(sizes) == 1:
        return Text("1 value" if sizes[0] == "1" else f"{sizes[0]} values", f"{sizes[0]}個の値")
    if len(sizes) == 2:
        rows = "1 row" if sizes[0] == "1" else f"{sizes[0]} rows"
        return Text(f"{rows} of {sizes[1]}", f"{sizes[0]}行{sizes[1]}列")
    return Text(f"shape ({', '.join(sizes)})", f"形状({', '.join(sizes)})")
