"""The gallery shows everything that is drawn, with its alternative text, without another file and without a word on stderr."""

import pkgutil
import re
from html.parser import HTMLParser

import pytest

import course.drawings
import course.views
from autograder.gallery import gallery_page
from course.views import film

SHARED = {"robot", "view", "film"}


class Reader(HTMLParser):
    """What a page holds: its images' alternative texts, and what it takes from elsewhere."""

    def __init__(self, page):
        super().__init__()
        self.alts, self.elsewhere, self.names = [], [], []
        self.feed(page)

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        if tag == "figure":
            self.names.append(found["id"])
        if tag == "img":
            self.alts.append(found.get("alt", ""))
        self.elsewhere += [value for name, value in attributes if name in ("src", "href") and not value.startswith("data:")]


@pytest.fixture(scope="module", params=["en", "ja"])
def page(request):
    """The page, with films of three frames: drawing all of them takes seconds."""
    whole = film.FuncAnimation
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(film, "FuncAnimation", lambda *made, frames, **options: whole(*made, frames=min(frames, 3), **options))
        yield request.param, gallery_page(request.param)


@pytest.mark.xdist_group("gallery")
def test_everything_is_shown_with_its_text(page, capfd, caplog):
    language, text = page
    read = Reader(text)
    modules = {found.name for package in (course.drawings, course.views) for found in pkgutil.iter_modules(package.__path__)}
    assert modules - SHARED <= {name.partition(".")[0] for name in read.names}
    assert len(read.names) == len(set(read.names))
    assert len(read.alts) >= len(read.names)
    assert all(len(alt) > 25 for alt in read.alts)
    assert all(bool(re.search("[ぁ-んァ-ン一-龥]", alt)) is (language == "ja") for alt in read.alts)
    assert read.elsewhere == []
    assert capfd.readouterr() == ("", "")
    assert not caplog.records
