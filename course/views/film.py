"""A film that plays in the page, with buttons, without kernel and without network."""

import re
from collections.abc import Callable
from typing import TYPE_CHECKING

from matplotlib.animation import FuncAnimation

from course.language import Text
from course.plotting import Picture, in_chosen_language

if TYPE_CHECKING:
    from matplotlib.figure import Figure


FRAMES = 40


class Film:
    """A film that plays in the page, with buttons, without kernel and without network."""

    def __init__(self, figure: "Figure", draw: Callable[[int], None], frames: int, seconds: float, alt: Text) -> None:
        """`draw(k)` brings the figure to frame k; `seconds` is how long the film takes."""
        film = FuncAnimation(figure, draw, init_func=lambda: None, frames=frames, interval=1000 * seconds / frames)
        player = film.to_jshtml(default_mode="loop")
        self.still = Picture(figure, alt)
        self.html = _with_still(_without_network(player), self.still)

    def _repr_mimebundle_(self, **_: object) -> dict[str, str]:
        return {"text/html": self.html, "text/plain": self.still.alt}

    def __repr__(self) -> str:
        return self.still.alt


# Matplotlib's player: the icons that it takes from a font on the network, and its texts.
SYMBOLS = {
    "minus": "−",
    "fast-backward": "|◀",
    "step-backward": "◁",
    "play fa-flip-horizontal": "◀",
    "pause": "❚❚",
    "play": "▶",
    "step-forward": "▷",
    "fast-forward": "▶|",
    "plus": "+",
}
BUTTONS = {
    text.en: text
    for text in (
        Text("Decrease speed", "遅くする"),
        Text("First frame", "最初のコマ"),
        Text("Previous frame", "前のコマ"),
        Text("Play backwards", "逆再生"),
        Text("Pause", "一時停止"),
        Text("Play", "再生"),
        Text("Next frame", "次のコマ"),
        Text("Last frame", "最後のコマ"),
        Text("Increase speed", "速くする"),
        Text("Repetition mode", "繰り返し方"),
        Text("Once", "1回"),
        Text("Loop", "繰り返し"),
        Text("Reflect", "往復"),
    )
}


def _without_network(player: str) -> str:
    """Return Matplotlib's player with plain symbols in place of the linked icon font, in the reader's language."""
    player = re.sub(r"<link\b[^>]*>", "", player)
    player = re.sub(r'<i class="fa fa-([\w -]+)"></i>', lambda icon: SYMBOLS[icon[1]], player)
    player = re.sub(r'(title|aria-label)="([^"]+)"', lambda found: f'{found[1]}="{_button(found[2])}"', player)
    return re.sub(r">(\w+)</label>", lambda found: f">{_button(found[1])}</label>", player)


def _button(english: str) -> str:
    return in_chosen_language(BUTTONS[english])


def _with_still(player: str, still: Picture) -> str:
    """Give the player's image an alt text, a width and a still that shows where scripts may not run."""
    return re.sub(r"<img (id=\"\w+\")>", lambda found: still.html.replace("<img ", f"<img {found[1]} "), player)
