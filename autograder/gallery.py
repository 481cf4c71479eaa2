"""The gallery: one page in each language with every drawing, view and film of the course, each with its alt text beneath."""

import importlib
import inspect
import pkgutil
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

from jinja2 import Environment

import course.drawings
import course.views
from course.language import Text, chosen_language, use_language
from course.logs import data_path, read_encoder_log, read_truth
from course.robots import ICART
from course.views.film import Film
from course.views.view import View

#: a log with all that the practical has to deal with
LOG = "encoder_practical"
TITLE = Text("Drawings, views and films", "図・対話型の図・動画の一覧")
INTRODUCTION = Text(
    "Everything that the notebooks show. Beneath each stands its alternative text, for those who do not see it. Sliders need a "
    "running kernel: here a view is shown as it starts.",
    "ノートブックに出てくる図のすべてです。下にあるのは、図を見られない人のための代替テキストです。"
    "スライダーは実行中のカーネルが必要なため、ここでは最初の状態を示します。",
)
_PAGE = Environment(autoescape=True).from_string("""<!doctype html>
<html lang="{{ language }}">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{{ title }}</title>
<style>
  body { font-family: sans-serif; max-width: 56rem; margin: 2rem auto; padding: 0 1rem; color: #222; line-height: 1.5 }
  figure { margin: 2.5rem 0; border-top: 1px solid #ccc; padding-top: 1rem }
  figcaption { color: #444 } code { color: #555 } img { max-width: 100% }
</style>
<h1>{{ title }}</h1>
<p>{{ introduction }}</p>
{% for shown in exhibits %}
<figure id="{{ shown.name }}">
<code>{{ shown.name }}</code>
<div>{{ shown.html | safe }}</div>
<figcaption>{{ shown.alt }}</figcaption>
</figure>
{% endfor %}
</html>
""")


class Exhibit(NamedTuple):
    """Something that notebooks show: its name, the HTML that shows it, and its alternative text."""

    name: str
    html: str
    alt: str


def gallery_page(language: str) -> str:
    """Return the page in "en" or "ja"; it needs no other file."""
    before = chosen_language()
    use_language(language)
    try:
        texts = {"title": TITLE.to(language), "introduction": INTRODUCTION.to(language), "language": language}
        return _PAGE.render(exhibits=list(exhibits()), **texts)
    finally:
        use_language(before)


def write_gallery(folder: Path) -> list[Path]:
    """Write the page in both languages into `folder` and return their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    paths = {language: folder / f"{language}.html" for language in ("en", "ja")}
    for language, path in paths.items():
        path.write_text(gallery_page(language), encoding="utf-8")
    return list(paths.values())


def exhibits() -> Iterator[Exhibit]:
    """Yield what the modules of course.drawings and course.views show, in the chosen language."""
    for package in (course.drawings, course.views):
        for found in pkgutil.iter_modules(package.__path__):
            module = importlib.import_module(f"{package.__name__}.{found.name}")
            for make in _makers(module):
                yield _exhibit(f"{found.name}.{make.__name__}", make())


def _makers(module: ModuleType) -> Iterator[Callable[[], Any]]:
    """Yield functions without arguments that make the module's pictures, views and films."""
    for name, function in inspect.getmembers(module, inspect.isfunction):
        if function.__module__ != module.__name__ or name.startswith("_"):
            continue
        # what is drawn by a function that @pictured has wrapped is a Picture
        shows = hasattr(function, "__wrapped__") or function.__annotations__.get("return") in (View, Film)
        needed = [each for each in inspect.signature(function).parameters.values() if each.default is each.empty]
        if shows and needed:
            yield _with_arguments(function)
        elif shows:
            yield function


def _with_arguments(function: Callable[..., Any]) -> Callable[[], Any]:
    """Return the function with something to show; KeyError, with its name, for one that is not known here."""
    arguments = {"drive_animation": _trajectory, "calibration_view": _calibration}[function.__name__]

    def make() -> Any:
        return function(*arguments())

    make.__name__ = function.__name__
    return make


def _trajectory() -> tuple[Any]:
    import numpy as np

    truth = read_truth(data_path("encoder_figure_eight.truth.csv"))
    return (np.column_stack([truth[name] for name in ("x", "y", "theta")]),)


def _calibration() -> tuple[Any, ...]:
    from autograder.reference import exercise_named

    odometry = exercise_named("wheel_odometry").reference  # type: ignore[union-attr]
    return odometry, read_encoder_log(data_path(f"{LOG}.dat")), read_truth(data_path(f"{LOG}.truth.csv")), ICART


def _exhibit(name: str, shown: Any) -> Exhibit:
    picture = shown.still if isinstance(shown, Film) else shown.picture if isinstance(shown, View) else shown
    return Exhibit(name, shown.html if isinstance(shown, Film) else picture.html, picture.alt)
