"""The executed notebook that goes into autograded/: the student's cells and what they put out, made safe to open."""

import base64
import io
import re
import warnings
from collections.abc import Callable, Sequence
from html import escape
from typing import Any

import nbformat
import nh3
from markdown_it import MarkdownIt
from mdit_py_plugins.dollarmath import dollarmath_plugin
from nbformat.v4 import new_code_cell, new_markdown_cell, new_output, new_raw_cell
from PIL import Image

from autograder.intake import Cell
from course.verdict import Verdict

MAX_PIXELS = 4_000_000
MAX_TEXT = 100_000
# C0 and C1 controls except tab, line feed and escape-free carriage return; and the marks that turn text around
_HIDDEN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]")


# a tag, or the end of a link's text: the only ways in which Markdown can do more than show text
_MAY_ACT = re.compile(r"<[A-Za-z/!?]|\]\s*[(:\[]")


def executed_notebook(release: bytes, cells: Sequence[Cell], outputs: Sequence[Sequence[dict[str, Any]]]) -> bytes:
    """Return the notebook as JSON: our metadata for the cells that are ours, nothing of the student's but sources and clean outputs."""
    ours = nbformat.reads(release.decode(), as_version=4)
    by_id = {cell.metadata["nbgrader"]["grade_id"]: cell for cell in ours.cells if "nbgrader" in cell.metadata}
    made = []
    for index, cell in enumerate(cells):
        shown = list(map(clean_output, outputs[index])) if index < len(outputs) else []
        made.append(_made_cell(index, cell, by_id, [output for output in shown if output is not None]))
    ours.cells = made
    return nbformat.writes(ours).encode()


def verdict_output(verdict: Verdict, language: str) -> dict[str, Any]:
    """Return the output that a check cell shows: display data when passed, the error that stock nbgrader counts as 0 otherwise."""
    text = verdict.plain_text(language)
    if verdict.passed:
        return {"output_type": "display_data", "data": {"text/plain": text}}
    return {"output_type": "error", "ename": "CheckFailed", "evalue": verdict.headline(language), "traceback": text.splitlines()}


def clean_output(output: Any) -> Any | None:
    """Return one output with only what is safe to show: text, and pictures drawn anew; None if nothing is left."""
    match output:
        case {"output_type": "stream", "name": ("stdout" | "stderr") as name, "text": str(text)}:
            return new_output("stream", name=name, text=visible(text))
        case {"output_type": "error", "ename": str(name), "evalue": str(value), "traceback": list(lines)}:
            return new_output(
                "error", ename=visible(name), evalue=visible(value), traceback=[visible(str(line)) for line in lines[:100]]
            )
        case {"output_type": ("display_data" | "execute_result") as kind, "data": dict(data)}:
            clean = _clean_data(data)
            extra = {"execution_count": None} if kind == "execute_result" else {}
            return new_output(kind, data=clean, **extra) if clean else None
    return None


def visible(text: str) -> str:
    """Return text in which control characters and marks that reverse its direction can be seen."""
    return _HIDDEN.sub(lambda mark: f"\\u{ord(mark.group()):04x}", text[:MAX_TEXT])


def safe_markdown(source: str) -> str:
    """Return Markdown without anything that could act on a page: HTML and links go through an allow-list, formulas stay."""
    text = visible(source)
    if not _MAY_ACT.search(text):
        return text
    parser = MarkdownIt("commonmark", {"html": True}).enable("table").use(dollarmath_plugin)
    parser.add_render_rule("math_inline", _formula("$"))
    parser.add_render_rule("math_block", _formula("$$"))
    return nh3.clean(parser.render(text), url_schemes={"http", "https", "mailto"})


def _formula(mark: str) -> Callable[..., str]:
    def rendered(renderer: object, tokens: Sequence[Any], index: int, *_: object) -> str:
        return f"{mark}{escape(tokens[index].content)}{mark}"

    return rendered


def _clean_data(data: dict[str, Any]) -> dict[str, str]:
    clean = {}
    text, picture = data.get("text/plain"), data.get("image/png")
    if isinstance(text, str):
        clean["text/plain"] = visible(text)
    if isinstance(picture, str):
        redrawn = _redrawn(picture)
        if redrawn is not None:
            clean["image/png"] = redrawn
    return clean


def _redrawn(picture: str) -> str | None:
    """Return a PNG decoded and encoded anew, so that only pixels are left of it; None if it is not one or too large."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # Pillow warns of decompression bombs
            with Image.open(io.BytesIO(base64.b64decode(picture)), formats=["PNG"]) as image:
                if image.width * image.height > MAX_PIXELS:
                    return None
                pixels = image.convert("RGB")
    except Exception:  # whatever is wrong with a hostile picture, it is left out
        return None
    file = io.BytesIO()
    pixels.save(file, "PNG", compress_level=1)
    return base64.b64encode(file.getvalue()).decode()


def _made_cell(index: int, cell: Cell, by_id: dict[str, Any], outputs: list[Any]) -> Any:
    if cell.type == "code":
        made = new_code_cell(cell.source, outputs=outputs)
    elif cell.type == "markdown":
        made = new_markdown_cell(safe_markdown(cell.source))
    else:
        made = new_raw_cell(visible(cell.source))
    made["id"] = f"cell-{index}"
    template = by_id.get(cell.grade_id) if cell.grade_id is not None else None
    if template is not None:
        made.metadata["nbgrader"] = template.metadata["nbgrader"]
        made["id"] = template.id
    return made
