"""The table of source/README.md, where each formula of the slides and notes is taught, names sections that exist."""

import re
from pathlib import Path
from typing import NamedTuple

import pytest

from autograder.editions import edition, source_cells

SOURCE = Path(__file__).resolve().parents[1] / "source"


class Row(NamedTuple):
    """A row of the table: where the material has a formula, and where the course has it."""

    place: str
    formula: str
    notebook: str
    section: str
    section_ja: str


def rows() -> list[Row]:
    lines = (SOURCE / "README.md").read_text(encoding="utf-8").splitlines()
    cells = [[cell.strip() for cell in line.strip("|").split(" | ")] for line in lines if line.startswith("| ")]
    return [Row(*row) for row in cells if row[2] != "notebook"]


def headings(notebook: str, language: str) -> list[str]:
    """Return the headings of one edition, in their order."""
    text = (SOURCE / "odometry" / f"{notebook}.md").read_text(encoding="utf-8")
    cells = edition(source_cells(text, f"odometry/{notebook}"), f"odometry/{notebook}", language).cells
    markdown = "\n".join(cell.source for cell in cells if cell.cell_type == "markdown")
    return re.findall(r"^#+ +(.+?) *$", markdown, re.MULTILINE)


@pytest.mark.parametrize("notebook", sorted({row.notebook for row in rows()}))
def test_sections_exist_in_both_languages(notebook):
    named = [row for row in rows() if row.notebook == notebook]
    english, japanese = headings(notebook, "en"), headings(notebook, "ja")
    for row in named:
        assert row.section in english, row
        assert row.section_ja in japanese, row
        # the same section, not two that happen to exist
        assert english.index(row.section) == japanese.index(row.section_ja), row


def test_every_notebook_and_every_numbered_formula_is_named():
    table = rows()
    assert {row.notebook for row in table} == {path.stem for path in (SOURCE / "odometry").glob("*.md")}
    places = {row.place for row in table}
    assert {f"overview #{number}" for number in range(1, 7)} <= places
    assert {f"equation ({number})" for number in range(1, 7)} <= places
    assert any("(4.32), (4.33), (4.34)" in row.formula for row in table)
