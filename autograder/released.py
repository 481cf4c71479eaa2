"""Our own released notebooks, read once however many submissions are graded against them."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from autograder.demonstrations import bound_names
from autograder.intake import Cell


@dataclass(frozen=True, eq=False)
class Release:
    """A released notebook.

    `notebook` is its JSON as it stands; `cells` its cells with the flags that nbgrader gave them; `templates` the cells as JSON by
    grade id; `points` of each grade id; `demos` the sources of the teacher's demonstrations with the names that they define; `code` the
    sources of all our code; `prose` those of the course's own text.
    """

    notebook: Mapping[str, Any]
    cells: tuple[Cell, ...]
    templates: Mapping[str, Mapping[str, Any]]
    points: Mapping[str, float]
    demos: Mapping[str, frozenset[str]]
    code: frozenset[str]
    prose: frozenset[str]


@lru_cache(maxsize=64)
def released(data: bytes) -> Release:
    """Return the released notebook in `data`. Nobody may change what comes back: it is shared."""
    notebook = json.loads(data)
    raw_cells = [raw | {"source": "".join(raw["source"])} for raw in notebook["cells"]]
    ours = [raw["metadata"].get("nbgrader", {}) for raw in raw_cells]
    return Release(
        notebook=notebook,
        cells=tuple(
            Cell(raw["cell_type"], raw["source"], own.get("grade_id"), own.get("locked", False), own.get("grade", False))
            for raw, own in zip(raw_cells, ours, strict=True)
        ),
        templates={own["grade_id"]: raw for raw, own in zip(raw_cells, ours, strict=True) if own},
        points={own["grade_id"]: float(own["points"]) for own in ours if "points" in own},
        demos={raw["source"]: bound_names(raw["source"]) for raw in raw_cells if "demo" in raw["metadata"].get("tags", [])},
        code=frozenset(raw["source"] for raw in raw_cells if raw["cell_type"] == "code"),
        prose=frozenset(raw["source"] for raw in raw_cells if raw["cell_type"] == "markdown"),
    )
