"""How a reader sees a verdict."""

import re
from html.parser import HTMLParser

import pytest
from hypothesis import given
from hypothesis import strategies as st

from course import language
from course.language import LANGUAGES, Text, use_language
from course.verdict import RUNGS, Verdict

EVIL = "<script>alert(\"1\")</script>&<img src=x onerror='a'>"


@pytest.fixture(autouse=True)
def language_as_before(monkeypatch):
    monkeypatch.setattr(language, "_chosen", language.chosen_language())


STATES = [
    (Verdict("f", 1.0, Text("a", "b")), "passed", "f: correct", "f: 正解です"),
    (
        Verdict("f", 1.0, Text("a", "b"), public=True),
        "examples",
        "f: the public examples are right",
        "f: 公開例はすべて合っています",
    ),
    (Verdict("f", 0.5, Text("a", "b"), rung="value"), "partly", "f: partly right", "f: 一部は合っています"),
    (Verdict("f", 0.0, Text("a", "b"), rung="value"), "failed", "f: not right yet", "f: まだ正しくありません"),
    (Verdict("f", 0.0, Text("a", "b"), rung="value", public=True), "failed", "f: not right yet", "f: まだ正しくありません"),
]


@pytest.mark.parametrize(("verdict", "state", "english", "japanese"), STATES)
def test_states_have_headlines(verdict, state, english, japanese):
    assert verdict.state == state
    assert verdict.passed == (state in {"passed", "examples"})
    assert verdict.headline("en") == english
    assert verdict.headline("ja") == japanese
    for told in ("en", "ja"):
        assert verdict.headline(told) in verdict.html(told)
        assert f"check-{state}" in verdict.html(told)
        assert f'lang="{told}"' in verdict.html(told)
        assert verdict.plain_text(told)[2:].startswith(verdict.headline(told))
        assert verdict.plain_text(told).endswith(verdict.message(told))


@pytest.mark.parametrize("rung", RUNGS)
def test_no_broken_rung_passes(rung):
    assert not Verdict("f", 1.0, Text("", ""), rung=rung).passed


class Tags(HTMLParser):
    def __init__(self):
        super().__init__()
        self.tags, self.text = [], ""

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)

    def handle_data(self, data):
        self.text += data + "\n"


def read(html):
    reader = Tags()
    reader.feed(html)
    reader.close()
    return reader


@pytest.mark.parametrize("told", LANGUAGES)
@pytest.mark.parametrize("verdict", [Verdict(EVIL, 0.0, Text(EVIL, EVIL), rung="value"), Verdict(EVIL, 1.0, Text(EVIL, EVIL))])
def test_html_escapes_everything(verdict, told):
    page = read(verdict.html(told))
    assert set(page.tags) == {"div", "span"}
    assert page.text.count("<script>") == 2
    assert "<script" not in verdict.html(told)


@given(st.text(), st.text(max_size=20))
def test_html_shows_every_line_and_nothing_else(message, name):
    page = read(Verdict(name, 0.5, Text(message, message), rung="value").html("en"))
    assert set(page.tags) == {"div", "span"}
    assert page.tags.count("div") == 2 + len(message.splitlines())
    told = [line for line in page.text.splitlines() if line]
    assert re.sub(r"\s", "", "".join(told)) == re.sub(r"\s", "", f"◐{name}: partly right{message}".replace("\r", "\n"))


def test_braces_in_names_and_messages_are_left_alone():
    verdict = Verdict("{name}{0}", 0.0, Text("{x}", "{y}"), rung="runs")
    assert verdict.plain_text("en") == "✗ {name}{0}: not right yet\n{x}"
    assert verdict.message("ja") == "{y}"


def test_an_empty_message_leaves_no_empty_line():
    assert Verdict("f", 1.0, Text("", "")).plain_text("en") == "✓ f: correct"


@pytest.mark.parametrize(("chosen", "word"), [("en", "correct"), ("ja", "正解")])
def test_a_notebook_is_shown_the_language_of_its_edition(chosen, word):
    use_language(chosen)
    bundle = Verdict("f", 1.0, Text("well", "よし"))._repr_mimebundle_()
    assert set(bundle) == {"text/plain", "text/html"}
    assert all(word in shown for shown in bundle.values())


def test_colour_is_not_the_only_sign():
    marks = {verdict.plain_text("en")[0] for verdict, state, _, _ in STATES if state in {"passed", "partly", "failed"}}
    assert len(marks) == 3
