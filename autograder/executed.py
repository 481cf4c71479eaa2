"""The executed notebook that goes into autograded/: the student's cells and what they put out, made safe to open.

nbgrader's pages show Markdown, comments included, with its HTML and any link, and run MathJax over it.
"""

import base64
import io
import json
import re
import secrets
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

import nh3
from markdown_it import MarkdownIt
from mdit_py_plugins.amsmath import amsmath_plugin
from mdit_py_plugins.dollarmath import dollarmath_plugin
from PIL import Image

from autograder.intake import Cell
from autograder.released import Release
from course.verdict import Verdict

MAX_PIXELS = 4_000_000
MAX_TEXT = 100_000
#: hostile Markdown takes time that grows with the square of its length; nobody writes that much in one cell
MAX_MARKDOWN = 20_000

# C0 and C1 controls except tab and line feed, marks that turn text around, halves of surrogate pairs, and what has no width or no
# shape (but for the joiner U+200D, which emoji need), tags included
_HIDDEN = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u00ad\u061c\u115f\u1160\u17b4\u17b5\u180e\u200b\u200c\u200e\u200f\u2028-\u202e\u2060-\u206f"
    "\u3164\ud800-\udfff\ufeff\uffa0\ufff9-\ufffb\U000e0000-\U000e007f]"
)
# a tag, the end of a link's text, or a diagram: the only ways in which Markdown can do more than show text
_MAY_ACT = re.compile(r"<[A-Za-z/!?]|\]\s*[(:\[]|mermaid")
# where a space, which means nothing in a formula, keeps it from being read as a tag or a link
_LIKE_TAG_OR_LINK = re.compile(r"<(?=[A-Za-z/!?])|\](?=[(:\[])")
_ACTING_MACRO = re.compile(r"\\(href|url|require|class|cssId|style|data|mmlToken|bbox|includegraphics)(?![A-Za-z])")
_MARKDOWN_MARK = re.compile(r"[\\`<\[$&~]|:(?=//)|\*(?=\S)|(?<=\S)\*|_(?!\w)|(?<![A-Za-z0-9])_")


@dataclass
class Room:
    """How much of a notebook's outputs is still to be shown: characters of text, and pixels of pictures."""

    text: int = 2_000_000
    pixels: int = 100_000_000


def executed_notebook(release: Release, cells: Sequence[Cell], outputs: Sequence[Sequence[Any] | None]) -> bytes:
    """Return the notebook as JSON: our metadata for the cells that are ours, nothing of the student's but sources and outputs.

    `outputs` holds the clean outputs (`clean_outputs`) of each cell; None (or nothing at all) for one that was not run.
    """
    made, count = [], 0
    for index, cell in enumerate(cells):
        shown = outputs[index] if index < len(outputs) else None
        entry = _made_cell(cell, release.prose, shown or [])
        if shown is not None and cell.type == "code" and cell.source.strip():
            count += 1
            _number(entry, count)
        template = release.templates.get(cell.grade_id) if cell.grade_id is not None else None
        if template is None:
            made.append({"id": f"cell-{index}", "metadata": {}, **entry})
        else:
            made.append({"id": template["id"], "metadata": {"nbgrader": template["metadata"]["nbgrader"]}, **entry})
    # in one line: an indented one takes ten times as long to write
    return json.dumps({**release.notebook, "cells": made}, ensure_ascii=False).encode()


def _number(entry: dict[str, Any], count: int) -> None:
    """Give a cell that was run its number, as Jupyter does."""
    entry["execution_count"] = count
    for output in entry["outputs"]:
        if output["output_type"] == "execute_result":
            output["execution_count"] = count


def verdict_output(verdict: Verdict, language: str) -> dict[str, Any]:
    """Return the output that a check cell shows: display data when passed, the error that stock nbgrader counts as 0 otherwise."""
    text = verdict.plain_text(language)
    if verdict.passed:
        return {"output_type": "display_data", "data": {"text/plain": text}}
    return {"output_type": "error", "ename": "CheckFailed", "evalue": verdict.headline(language), "traceback": text.splitlines()}


def clean_outputs(outputs: Sequence[Any], room: Room) -> list[dict[str, Any]]:
    """Return the outputs of one cell as `clean_output` makes them, as long as there is room; what they fill is taken from it."""
    shown = (clean_output(output, room) for output in outputs)
    return [output for output in shown if output is not None]


def clean_output(output: Any, room: Room | None = None) -> dict[str, Any] | None:
    """Return one output with only what is safe to show: text, and pictures drawn anew; None if nothing is left."""
    room = room or Room()
    if not isinstance(output, dict):
        return None
    kind = output.get("output_type")
    if not isinstance(kind, str) or room.text <= 0:
        return None
    match kind, output:
        case "stream", {"name": str(name), "text": str(text)} if name in ("stdout", "stderr"):
            return {"output_type": kind, "name": name, "text": _fitted(text, room)}
        case "error", {"ename": str(name), "evalue": str(value), "traceback": list(lines)}:
            trace = [_fitted(line, room) for line in lines[:100] if isinstance(line, str)]
            return {"output_type": kind, "ename": _fitted(name, room), "evalue": _fitted(value, room), "traceback": trace}
        case (("display_data" | "execute_result"), {"data": dict(data)}):
            clean = _clean_data(data, room)
            extra = {"execution_count": None} if kind == "execute_result" else {}
            return {"output_type": kind, "data": clean, "metadata": {}, **extra} if clean else None
    return None


def visible(text: str) -> str:
    """Return text in which control characters and marks that reverse its direction can be seen."""
    return _HIDDEN.sub(lambda mark: _escape(ord(mark.group())), text[:MAX_TEXT].replace("\r\n", "\n"))


def _escape(code: int) -> str:
    return f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def safe_markdown(source: str) -> str:
    """Return Markdown without anything that could act on a page: HTML and links go through an allow-list, formulas stay."""
    text = _without_acting_macros(visible(source))
    if not _MAY_ACT.search(text):
        return text
    if len(text) > MAX_MARKDOWN:
        return f"<pre>{escape(text).replace('[', '&#91;')}</pre>"
    # formulas pass by the sanitiser, which would write & as &amp;: what reads a formula afterwards does not undo that. Nobody can
    # guess what stands for them meanwhile, or they could be had into an attribute.
    mark = secrets.token_hex(8)
    formulas: list[str] = []
    parser = MarkdownIt("commonmark", {"html": True}).enable("table")
    parser.use(dollarmath_plugin, allow_labels=False, double_inline=True).use(amsmath_plugin)
    for rule, around in {"math_inline": "$", "math_inline_double": "$$", "math_block": "$$", "amsmath": ""}.items():
        parser.add_render_rule(rule, _put_aside(formulas, mark, around))
    html = nh3.clean(parser.render(text), tags=nh3.ALLOWED_TAGS - {"img"}, url_schemes={"http", "https", "mailto"})
    # the page reads this as Markdown once more: no link must come to life in it
    html = html.replace("[", "&#91;")
    return re.sub(rf"x{mark}x(\d+)x", lambda found: formulas[int(found.group(1))], html)


def as_markdown(text: str) -> str:
    """Return plain text as Markdown that shows just this text: nbgrader renders comments, and they quote the student."""
    marked = _MARKDOWN_MARK.sub(lambda mark: f"\\{mark.group()}", _without_acting_macros(visible(text)))
    return marked.replace("\n", "  \n")


def _put_aside(formulas: list[str], mark: str, around: str) -> Callable[..., str]:
    """Return a rule that renders a formula as a word, and keeps the formula, with `around` on both sides, in the list."""

    def rendered(renderer: object, tokens: Sequence[Any], index: int, *_: object) -> str:
        inert = _LIKE_TAG_OR_LINK.sub(r"\g<0> ", tokens[index].content)
        formulas.append(f"{around}{inert}{around}")
        return f"x{mark}x{len(formulas) - 1}x" + ("\n" if tokens[index].block else "")

    return rendered


def _without_acting_macros(text: str) -> str:
    """Return text without the macros by which MathJax makes links, loads extensions, or styles the page."""
    return _ACTING_MACRO.sub(r"\\text{\1}", text)


def _fitted(text: str, room: Room) -> str:
    shown = visible(text[: max(room.text, 0)])
    room.text -= len(shown)
    return shown


def _clean_data(data: dict[str, Any], room: Room) -> dict[str, str]:
    clean = {}
    text, picture = data.get("text/plain"), data.get("image/png")
    if isinstance(text, str):
        clean["text/plain"] = _fitted(text, room)
    if isinstance(picture, str):
        redrawn = _redrawn(picture, room)
        if redrawn is not None:
            clean["image/png"] = redrawn
    return clean


def _redrawn(picture: str, room: Room) -> str | None:
    """Return a PNG decoded and encoded anew, so that only pixels are left of it; None if it is not one or too large."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # Pillow warns of decompression bombs
            with Image.open(io.BytesIO(base64.b64decode(picture)), formats=["PNG"]) as image:
                size = image.width * image.height
                if size > min(MAX_PIXELS, room.pixels):
                    return None
                room.pixels -= size
                pixels = image.convert("RGB")
    except Exception:  # whatever is wrong with a hostile picture, it is left out
        return None
    file = io.BytesIO()
    pixels.save(file, "PNG", compress_level=1)
    return base64.b64encode(file.getvalue()).decode()


def _made_cell(cell: Cell, prose: frozenset[str], outputs: Sequence[Any]) -> dict[str, Any]:
    if cell.type == "code":
        return {"cell_type": "code", "source": visible(cell.source), "execution_count": None, "outputs": list(outputs)}
    if cell.type == "markdown":
        # the course's own prose is safe as it is
        return {"cell_type": "markdown", "source": cell.source if cell.source in prose else safe_markdown(cell.source)}
    return {"cell_type": "raw", "source": _without_acting_macros(visible(cell.source))}
