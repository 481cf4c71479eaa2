"""A verdict on one answer, and how a reader sees it."""

from dataclasses import dataclass
from html import escape

from course.language import Text, chosen_language

RUNGS = ("defined", "callable", "runs", "inputs", "shape", "unit", "value")

_HEADLINES = {
    "passed": Text("{name}: correct", "{name}: 正解です"),
    "examples": Text("{name}: the public examples are right", "{name}: 公開例はすべて合っています"),
    "partly": Text("{name}: partly right", "{name}: 一部は合っています"),
    "failed": Text("{name}: not right yet", "{name}: まだ正しくありません"),
}
_COLOURS = {"passed": "#009E73", "examples": "#0072B2", "partly": "#E69F00", "failed": "#D55E00"}
_MARKS = {"passed": "✓", "examples": "✓", "partly": "◐", "failed": "✗"}


@dataclass(frozen=True)
class Verdict:
    """What a judge says of one answer.

    `score` is 0..1; `rung` names the step of the ladder that broke (one of RUNGS), None when passed; `misconception` is the slug
    of a recognised mistake; `text` says what was seen. `public` marks a verdict from the public examples alone: it is a help and
    counts for nothing.
    """

    name: str
    score: float
    text: Text
    rung: str | None = None
    misconception: str | None = None
    public: bool = False
    seed: int | None = None

    @property
    def passed(self) -> bool:
        """Is the answer right in every case that was tried?"""
        return self.rung is None

    @property
    def state(self) -> str:
        """Return "passed", "examples", "partly" or "failed"."""
        if self.passed:
            return "examples" if self.public else "passed"
        return "partly" if self.score > 0 else "failed"

    def headline(self, language: str) -> str:
        """Return one line that says how it stands, without the details."""
        return _HEADLINES[self.state].to(language).replace("{name}", self.name)

    def message(self, language: str) -> str:
        """Return what was seen, the likely cause, and where to look, in "en" or "ja"."""
        return self.text.to(language)

    def plain_text(self, language: str) -> str:
        """Return the whole verdict as text for a terminal or a notebook file."""
        return f"{_MARKS[self.state]} {self.headline(language)}\n{self.message(language)}".rstrip()

    def html(self, language: str) -> str:
        """Return the whole verdict as a box; everything in it is escaped."""
        lines = "".join(f"<div>{escape(line)}</div>" for line in self.message(language).splitlines())
        colour = _COLOURS[self.state]
        return (
            f'<div role="status" lang="{language}" class="check-{self.state}" style="border-left:5px solid {colour};'
            f'padding:.5em .9em;margin:.3em 0;max-width:46em;line-height:1.6">'
            f'<div style="font-weight:600"><span aria-hidden="true" style="color:{colour}">{_MARKS[self.state]}</span> '
            f"{escape(self.headline(language))}</div>{lines}</div>"
        )

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        language = chosen_language()
        return {"text/plain": self.plain_text(language), "text/html": self.html(language)}
