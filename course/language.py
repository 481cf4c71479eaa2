"""The two languages of the course: texts side by side, and which one the reader chose."""

from typing import NamedTuple

LANGUAGES = ("ja", "en")


class Text(NamedTuple):
    """One text in English and in Japanese.

    >>> Text("pose of {who}", "{who}の姿勢").format(who="Beego").to("en")
    'pose of Beego'
    """

    en: str
    ja: str

    def to(self, language: str) -> str:
        """Return the text in `language` ("en" or "ja")."""
        return self.ja if language == "ja" else self.en

    def format(self, **values: object) -> "Text":
        """Fill the same values into both languages; a value that is itself a Text is filled in by language."""
        english = {name: value.en if isinstance(value, Text) else value for name, value in values.items()}
        japanese = {name: value.ja if isinstance(value, Text) else value for name, value in values.items()}
        return Text(self.en.format(**english), self.ja.format(**japanese))

    def __add__(self, other: object) -> "Text":
        """Join two texts, language by language."""
        if not isinstance(other, Text):
            return NotImplemented
        return Text(self.en + other.en, self.ja + other.ja)


_chosen = "ja"


def use_language(language: str) -> None:
    """Choose the language of pictures and messages; `course.en` and `course.ja` call this when imported."""
    if language not in LANGUAGES:
        raise ValueError(f"language must be one of {LANGUAGES}, not {language!r}")
    global _chosen  # noqa: PLW0603 - the reader's choice holds for the whole notebook
    _chosen = language


def chosen_language() -> str:
    """Return "en" or "ja": the language of the edition that the reader opened."""
    return _chosen
