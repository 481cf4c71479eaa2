"""English and Japanese say the same: every pair of prose cells has the same formulas, headings, code, links and build."""

import re
from functools import cache
from pathlib import Path

import pytest
from markdown_it import MarkdownIt
from markdown_it.token import Token
from nbformat import NotebookNode

from autograder.editions import edition, source_cells
from autograder.reference import NOTEBOOKS

ROOT = Path(__file__).parents[1]
MARKDOWN = MarkdownIt("commonmark").enable("table")
FORMULA = re.compile(r"\$\$(.+?)\$\$|\$(.+?)\$", re.DOTALL)


@cache
def source(notebook: str) -> list[NotebookNode]:
    return source_cells((ROOT / f"source/{notebook}.md").read_text(encoding="utf-8"), notebook)


@cache
def prose_pairs(notebook: str) -> list[tuple[str, str]]:
    prose = [cell.source for cell in source(notebook) if cell.cell_type == "markdown"]
    return list(zip(prose[::2], prose[1::2], strict=True))


def tokens(text: str) -> list[Token]:
    blocks = MARKDOWN.parse(text)
    return blocks + [inline for block in blocks for inline in block.children or []]


def formulas(text: str) -> list[str]:
    without_code = re.sub(r"(`+).+?\1", "", text, flags=re.DOTALL)
    return [" ".join((shown or inline).split()) for shown, inline in FORMULA.findall(without_code)]


def headings(text: str) -> list[str]:
    return [token.tag for token in tokens(text) if token.type == "heading_open"]


def code(text: str) -> set[str]:
    # a set: word order differs, and a name said twice in one language may be said once in the other
    return {token.content for token in tokens(text) if token.type in ("code_inline", "fence", "code_block")}


def links(text: str) -> list[str]:
    return sorted(
        str(token.attrs.get("href", token.attrs.get("src"))) for token in tokens(text) if token.type in ("link_open", "image")
    )


def html_tags(text: str) -> list[str]:
    return re.findall(r"</?[a-z]+", text)


def table_cells(text: str) -> int:
    return sum(token.type in ("th_open", "td_open") for token in tokens(text))


def count_of(text: str, kind: str) -> int:
    return sum(token.type == kind for token in tokens(text))


@pytest.mark.parametrize("notebook", NOTEBOOKS)
@pytest.mark.parametrize("part", [formulas, headings, code, links, html_tags, table_cells])
def test_pairs_have_the_same(notebook, part):
    different = [
        (english[:60], part(english), part(japanese))
        for english, japanese in prose_pairs(notebook)
        if part(english) != part(japanese)
    ]
    assert different == []


@pytest.mark.parametrize("notebook", NOTEBOOKS)
@pytest.mark.parametrize("kind", ["paragraph_open", "list_item_open"])
def test_pairs_have_nearly_the_same_number_of(notebook, kind):
    counts = [(english[:60], count_of(english, kind), count_of(japanese, kind)) for english, japanese in prose_pairs(notebook)]
    assert [pair for pair in counts if abs(pair[1] - pair[2]) > 1] == []


@pytest.mark.parametrize("notebook", NOTEBOOKS)
def test_each_language_is_written_in_its_own_script(notebook):
    for english, japanese in prose_pairs(notebook):
        assert not re.search(r"[ぁ-んァ-ン一-龥]", english), english[:60]
        # a cell that is nothing but formulas is the same in both
        assert re.search(r"[ぁ-んァ-ン一-龥]", japanese) or english == japanese, japanese[:60]


@pytest.mark.parametrize("notebook", NOTEBOOKS)
def test_emphasis_is_closed(notebook):
    """Beside Japanese brackets and full stops Markdown does not always see the end of **bold** text."""
    for text in sum(prose_pairs(notebook), ()):
        assert not [token.content for token in tokens(text) if token.type == "text" and "**" in token.content]


@pytest.mark.parametrize("notebook", NOTEBOOKS)
def test_both_editions_have_the_same_cells_and_code(notebook):
    cells = source(notebook)
    english, japanese = (edition(cells, notebook, language).cells for language in ("en", "ja"))
    assert [(cell.id, cell.cell_type, cell.metadata) for cell in english] == [
        (cell.id, cell.cell_type, cell.metadata) for cell in japanese
    ]
    lines = zip(code_lines(english), code_lines(japanese), strict=True)
    [(from_en, from_ja)] = [(one, other) for one, other in lines if one != other]
    assert from_en.startswith("from course.en import ")
    assert from_ja == from_en.replace("course.en", "course.ja")


def code_lines(cells: list[NotebookNode]) -> list[str]:
    return [line for cell in cells if cell.cell_type == "code" for line in cell.source.split("\n")]
