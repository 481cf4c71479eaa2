import base64
import io
import json
import re
import zlib
from html.parser import HTMLParser
from urllib.parse import urlsplit

import nbformat
import numpy as np
import pytest
from nbconvert.filters.markdown_mistune import markdown2html_mistune
from PIL import Image

from autograder.executed import (
    MAX_MARKDOWN,
    MAX_PIXELS,
    MAX_TEXT,
    Room,
    as_markdown,
    clean_output,
    clean_outputs,
    executed_notebook,
    safe_markdown,
    verdict_output,
    visible,
)
from autograder.intake import Cell
from autograder.released import released
from course.language import Text
from course.verdict import Verdict


class Page(HTMLParser):
    """What a browser makes of a page: its tags with their attributes, and its text."""

    def __init__(self, html):
        super().__init__(convert_charrefs=True)
        self.tags, self.text = [], ""
        self.feed(html)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))

    def handle_data(self, data):
        self.text += data


def shown(markdown):
    """The page that nbgrader makes of Markdown."""
    return Page(markdown2html_mistune(markdown))


HOSTILE = {
    "script": "<script>alert(1)</script>",
    "script between words": "a <script src='http://evil'></script> b",
    "event handler": "<img src=x onerror=alert(1)>",
    "event handler in capitals": "<IMG SRC=x OnErRoR=alert(1)>",
    "event handler on details": "<details open ontoggle=alert(1)>x</details>",
    "link": "[x](javascript:alert(1))",
    "link with a line feed": "[x](java\nscript:alert(1))",
    "link with entities": "[x](&#106;avascript:alert(1))",
    "link in angles": "[x](<javascript:alert(1)>)",
    "picture": "![x](javascript:alert(1))",
    "data URL": "[x](data:text/html;base64,PHNjcmlwdD4=)",
    "data picture": "![x](data:image/svg+xml;base64,PHN2Zz4=)",
    "attachment": "![x](attachment:secret.svg)",
    "remote picture": "![x](http://evil/pixel.png)",
    "reference": "[x]\n\n[x]: javascript:alert(1)",
    "collapsed reference": "[x][]\n\n[x]:\njavascript:alert(1)",
    "automatic link": "<javascript:alert(1)>",
    "link in HTML": "<a href='javascript:alert(1)'>x</a>",
    "link in HTML with entities": "<a href='java&#115;cript:alert(1)'>x</a>",
    "data URL in HTML": "<a href='data:text/html,<script>alert(1)</script>'>x</a>",
    "svg": "<svg onload=alert(1)><animate onbegin=alert(1)></svg>",
    "iframe": "<iframe srcdoc='<script>alert(1)</script>'></iframe>",
    "style": "<style>body {display: none}</style>",
    "style attribute": "<div style='position:fixed;top:0'>cover</div>",
    "form": "<form action='/formgrader'><input name=x></form>",
    "comment": "<!-- --><script>alert(1)</script> -->",
    "unfinished tag": "<img src=x onerror=alert(1) ",
    "link made of entities": "<b>x</b> &#91;x&#93;(javascript:alert(1))",
    "link made of escapes": "<b>x</b> \\[x\\](javascript:alert(1))",
    "link that outlives a stripped tag": "<textarea>\n\n&#91;x&#93;(javascript:alert(1))\n</textarea>",
    "reference that outlives a stripped tag": "<textarea>\n\n&#91;x]\n\n&#91;x]: javascript:alert(1)\n</textarea>",
    "code block": "```html\n<script>alert(1)</script>\n```",
    "diagram": "```mermaid\n<img src=x onerror=alert(1)>\n```",
    "diagram with a click": '```mermaid\nclick a "javascript:alert(1)"\n```',
    "tag in a formula": "$<img src=x onerror=alert(1)>$",
    "tag in a displayed formula": "$$\n<script>alert(1)</script>\n$$",
    "tag in an environment": "\\begin{align}\n<script>alert(1)</script>\n\\end{align}",
    "link in a formula": "$[x](javascript:alert(1))$ <b>x</b>",
    "formula that the next reader does not take for one": "\\$<img src=x onerror=alert(1)>$",
    "formula that wants into an attribute": """<a href='#' title="&#120;&#48;x0x">x</a> $" onclick="alert(1)$ x0x""",
    "formula in an attribute": "<a href='$x$ javascript:alert(1)' title='$<b>$'>x</a> $x$",
    "acting formula": "$\\href{javascript:alert(1)}{x}$",
    "acting formula in HTML": "<b>$\\href {javascript:alert(1)}{x}$</b>",
    "acting formula outside dollars": "\\\\(\\style{position:fixed}{\\cssId{a}{\\class{b}{x}}}\\\\) \\require{html}",
    "very long": "<script>alert(1)</script> [x](javascript:alert(1))\n\n" * 1000,
}
HARMLESS = {
    *("p", "a", "b", "i", "em", "strong", "code", "pre", "div", "span", "br", "hr", "ul", "ol", "li", "table", "thead", "tbody"),
    *("tr", "td", "th", "details", "summary", "h1", "h2", "h3", "blockquote"),
}


@pytest.mark.parametrize("source", HOSTILE.values(), ids=HOSTILE.keys())
def test_no_markdown_acts_on_the_page_that_nbgrader_makes_of_it(source):
    page = shown(safe_markdown(source))
    assert {tag for tag, _ in page.tags} <= HARMLESS
    for _, attributes in page.tags:
        assert attributes.keys() <= {"href", "title", "rel", "class", "id"}
        # nbconvert would have a program draw it
        assert "mermaid" not in (attributes.get("class") or "").lower()
        assert urlsplit(attributes.get("href") or "").scheme in ("", "http", "https", "mailto")
    # MathJax reads the page's text
    assert not re.search(r"\\(href|style|cssId|class|require)\b", page.text)


@pytest.mark.parametrize("source", HOSTILE.values(), ids=HOSTILE.keys())
def test_no_comment_acts_on_the_page_and_all_of_it_is_shown(source):
    text = source[:2000].strip()
    page = shown(as_markdown(text))
    assert {tag for tag, _ in page.tags} <= {"p", "br"}
    words = re.findall(r"\w+", page.text)
    assert words == re.findall(r"\w+", re.sub(r"\\(href|style|cssId|class|require)", r"\\text{\1}", text))


COMMENTS = [
    "np.array(pose, dtype=float), __init__ and a_b * c * d, 2*x*y",
    "Line 3: x = a[0](b) < c & d &lt; e `f` ~~g~~ $h$ \\alpha \\* i",
    "方位が 0 のとき *x* だけに動くはずです。[y](z)",
]


@pytest.mark.parametrize("text", COMMENTS)
def test_a_comment_is_shown_to_the_letter(text):
    assert shown(as_markdown(text)).text.strip() == text


def test_the_lines_of_a_comment_stay_lines():
    assert [tag for tag, _ in shown(as_markdown("one\ntwo\nthree")).tags] == ["p", "br", "br"]


FORMULAS = [
    "$a_1 & b_2 * c * d$",
    "$x < y$",
    "$\\begin{pmatrix} a & b \\\\ c & d \\end{pmatrix}$",
    "$$\\begin{aligned} x_2 &= x_1 + D \\cos\\theta_1 \\\\[2pt] y_2 &= y_1 + D \\sin\\theta_1 \\end{aligned}$$",
    "$$\n\\begin{aligned}\na_1 &= b_2 \\\\\nc^* &< d_*\n\\end{aligned}\n$$",
    "\\begin{align}\na_1 &= b_2 \\\\\nc_3 &= d_4\n\\end{align}",
]
AROUND = {
    "alone": "{}",
    "before a link": "{}\n\n[slides](https://example.org/a_b)",
    "after HTML": "<b>bold</b>\n\n{}",
    "between HTML": "<details><summary>s</summary>\n\n{}\n\n</details>\n\n<script>x</script>",
}


@pytest.mark.parametrize("formula", FORMULAS)
@pytest.mark.parametrize("around", AROUND.values(), ids=AROUND.keys())
def test_formulas_survive_to_the_letter(formula, around):
    made = safe_markdown(around.format(formula))
    # as JupyterLab reads it, which takes formulas out of the Markdown first; and as nbgrader shows it
    assert formula in made
    assert formula in shown(made).text


@pytest.mark.parametrize("formula", ["$a<b$", "$$x<y$$", "$[0, 1](t)$", "$$[a][b]$$"])
def test_a_formula_that_looks_like_a_tag_or_a_link_gets_a_space_that_means_nothing(formula):
    made = safe_markdown(formula)
    assert formula.replace("<", "< ").replace("](", "] (").replace("][", "] [") in made
    assert shown(made).tags == [("p", {})]


PLAIN = [
    "# 見出し\n\n*斜体* `code` と $x_1$\n\n- a\n- b\n\n| a | b |\n|---|---|\n| 1 | 2 |",
    "Because $\\theta_1 < \\theta_2$ and 3 < 4 > 2.",
    "> [!] quoted]",
]


@pytest.mark.parametrize("source", PLAIN)
def test_markdown_that_can_do_nothing_stays_as_it_is(source):
    assert safe_markdown(source) == source


def test_honest_html_and_links_are_kept():
    page = shown(safe_markdown("<b>bold</b> [slides](https://example.org/?a=1&b=2)\n\n| <i>a</i> |\n|---|\n| 1 |"))
    assert ("a", {"href": "https://example.org/?a=1&b=2", "rel": "noopener noreferrer"}) in page.tags
    assert {"b", "i", "table", "td"} <= {tag for tag, _ in page.tags}


def test_very_long_markdown_is_shown_as_text():
    source = "[a](http://b) <b>bold</b>\n\n" * 2000
    assert len(source) > MAX_MARKDOWN
    page = shown(safe_markdown(source))
    assert page.tags == [("pre", {})]
    assert page.text.strip() == source.strip()


VISIBLE = [
    ("plain 日本語 😀\tx\n", "plain 日本語 😀\tx\n"),
    ("a\r\nb", "a\nb"),
    ("50%\r100%", "50%\\u000d100%"),
    ("\x1b[31mred\x07", "\\u001b[31mred\\u0007"),
    ("\x00\x7f\x85\x9f", "\\u0000\\u007f\\u0085\\u009f"),
    ("if admin\u202e\u2066: pass\u2069", "if admin\\u202e\\u2066: pass\\u2069"),
    ("\u200e\u200f\u061c", "\\u200e\\u200f\\u061c"),
    ("half \ud83d pair", "half \\ud83d pair"),
    ("x" * (MAX_TEXT + 5), "x" * MAX_TEXT),
]


@pytest.mark.parametrize(("text", "seen"), VISIBLE)
def test_what_hides_or_turns_text_around_becomes_visible(text, seen):
    assert visible(text) == seen


# outputs


def png(width=2, height=3, mode="RGB", **more):
    file = io.BytesIO()
    Image.new(mode, (width, height), (10, 20, 30)).save(file, "PNG", **more)
    return base64.b64encode(file.getvalue()).decode()


def displayed(**data):
    return {"output_type": "display_data", "data": {key.replace("_", "/"): value for key, value in data.items()}}


OUTPUTS = {
    "stdout": ({"output_type": "stream", "name": "stdout", "text": "a\x1bb"}, {"name": "stdout", "text": "a\\u001bb"}),
    "stderr": ({"output_type": "stream", "name": "stderr", "text": "a"}, {"name": "stderr", "text": "a"}),
    "error": (
        {"output_type": "error", "ename": "E\x07", "evalue": "v\u202e", "traceback": ["one", 2, "\x1b"]},
        {"ename": "E\\u0007", "evalue": "v\\u202e", "traceback": ["one", "\\u001b"]},
    ),
    "text": (displayed(text_plain="x"), {"data": {"text/plain": "x"}}),
    "html beside text": (displayed(text_plain="x", text_html="<script>"), {"data": {"text/plain": "x"}}),
    "result": (
        {"output_type": "execute_result", "data": {"text/plain": "1"}, "metadata": {"a": 1}, "execution_count": 7},
        {"data": {"text/plain": "1"}},
    ),
    "html alone": (displayed(text_html="<script>"), None),
    "svg": (displayed(**{"image_svg+xml": "<svg onload=alert(1)>"}), None),
    "javascript": (displayed(application_javascript="alert(1)"), None),
    "latex": (displayed(text_latex="\\href{javascript:x}{y}"), None),
    "widget": (displayed(**{"application_vnd.jupyter.widget-view+json": {}}), None),
    "text is a list": (displayed(text_plain=["x"]), None),
    "text is an array": (displayed(text_plain=np.zeros(3)), None),
    "data is a list": ({"output_type": "display_data", "data": ["x"]}, None),
    "no picture": (displayed(image_png="AAAA"), None),
    "picture is no base64": (displayed(image_png="é"), None),
    "gif for a picture": (displayed(image_png=base64.b64encode(b"GIF89a").decode()), None),
    "other stream": ({"output_type": "stream", "name": "stdin", "text": "a"}, None),
    "stream name is an array": ({"output_type": "stream", "name": np.zeros(3), "text": "a"}, None),
    "kind is an array": ({"output_type": np.zeros(3), "name": "stdout", "text": "a"}, None),
    "kind is missing": ({"name": "stdout", "text": "a"}, None),
    "unknown kind": ({"output_type": "update_display_data", "data": {"text/plain": "x"}}, None),
    "error without traceback": ({"output_type": "error", "ename": "E", "evalue": "v"}, None),
    "no dictionary": (["stream"], None),
    "nothing": (None, None),
}


@pytest.mark.parametrize(("output", "clean"), OUTPUTS.values(), ids=OUTPUTS.keys())
def test_only_text_and_pictures_are_left_of_an_output(output, clean):
    made = clean_output(output)
    if clean is None:
        assert made is None
    else:
        assert {key: made[key] for key in clean} == clean
        nbformat.validate(nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell("", outputs=nbformat.from_dict([made]))]))


def pixels(output):
    return Image.open(io.BytesIO(base64.b64decode(output["data"]["image/png"])))


def test_only_the_pixels_are_left_of_a_picture():
    from PIL.PngImagePlugin import PngInfo

    info = PngInfo()
    info.add_text("Comment", "<script>")
    made = clean_output(displayed(image_png=png(pnginfo=info)))
    picture = pixels(made)
    assert picture.size == (2, 3)
    assert picture.getpixel((1, 1)) == (10, 20, 30)
    assert picture.info == {}


def test_what_follows_the_picture_is_gone():
    hidden = base64.b64encode(base64.b64decode(png()) + b"<script>").decode()
    assert b"<script>" not in base64.b64decode(clean_output(displayed(image_png=hidden))["data"]["image/png"])


def bomb(width, height):
    """A PNG that claims a size; its pixels would come from a few bytes."""

    def chunk(kind, data):
        return len(data).to_bytes(4, "big") + kind + data + zlib.crc32(kind + data).to_bytes(4, "big")

    header = width.to_bytes(4, "big") + height.to_bytes(4, "big") + bytes([8, 0, 0, 0, 0])
    data = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(10**6))) + chunk(b"IEND", b"")
    return base64.b64encode(data).decode()


@pytest.mark.parametrize("size", [(MAX_PIXELS + 1, 1), (2000, 2001), (20_000, 20_000), (2**31 - 1, 2**31 - 1), (0, 0)])
def test_a_picture_that_would_fill_the_memory_is_left_out_and_its_text_stays(size):
    assert clean_output(displayed(text_plain="x", image_png=bomb(*size)))["data"] == {"text/plain": "x"}


def test_a_notebook_shows_only_so_much():
    room = Room(text=10, pixels=13)
    outputs = [displayed(text_plain="abc", image_png=png())] * 3 + [
        {"output_type": "stream", "name": "stdout", "text": "0123456"}
    ]
    made = clean_outputs(outputs, room)
    assert [sorted(output.get("data", output["output_type"])) for output in made[:3]] == [
        ["image/png", "text/plain"],
        ["image/png", "text/plain"],
        ["text/plain"],
    ]
    assert made[3]["text"] == "0"
    assert clean_outputs(outputs, room) == []


# the notebook

GRADED = {"grade_id": "check_a", "grade": True, "solution": False, "locked": True, "points": 5, "schema_version": 3}
RELEASE = nbformat.writes(
    nbformat.v4.new_notebook(
        metadata={"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}},
        cells=[
            nbformat.v4.new_markdown_cell("<details>ours [x](a)</details>", id="cell-0"),
            nbformat.v4.new_code_cell("check('a')", id="check_a", metadata={"nbgrader": GRADED}),
        ],
    )
).encode()


def test_the_executed_notebook_is_valid_and_holds_only_our_metadata():
    cells = [
        Cell("markdown", "<details>ours [x](a)</details>"),
        Cell("markdown", "<script>alert(1)</script>"),
        Cell("raw", "raw\u202e \\href{x}"),
        Cell("code", "x = 1  # \u202e"),
        Cell("code", "check('a')", "check_a", locked=True, graded=True),
        Cell("code", "more"),
    ]
    outputs = [[], [], [], clean_outputs([displayed(text_plain="1")], Room()), []]
    made = nbformat.reads(executed_notebook(released(RELEASE), cells, outputs).decode(), as_version=4)
    nbformat.validate(made)
    assert made.metadata.kernelspec.name == "python3"
    assert [cell.id for cell in made.cells] == ["cell-0", "cell-1", "cell-2", "cell-3", "check_a", "cell-5"]
    assert [cell.metadata for cell in made.cells] == [{}, {}, {}, {}, {"nbgrader": GRADED}, {}]
    assert [cell.source for cell in made.cells] == [
        "<details>ours [x](a)</details>",
        "",
        "raw\\u202e \\text{href}{x}",
        "x = 1  # \\u202e",
        "check('a')",
        "more",
    ]
    assert [cell.get("execution_count") for cell in made.cells] == [None, None, None, 1, 2, None]
    assert made.cells[3].outputs == [{"output_type": "display_data", "metadata": {}, "data": {"text/plain": "1"}}]


@pytest.mark.parametrize("text", ["half a pair \ud800", "NUL \0", "bidi \u202e", "end of line \u2028"])
def test_no_text_keeps_the_notebook_from_being_written(text):
    output = clean_output({"output_type": "stream", "name": "stdout", "text": text})
    cells = [Cell(kind, text) for kind in ("code", "markdown", "raw")]
    made = json.loads(executed_notebook(released(RELEASE), cells, [[output]]))
    assert [cell["cell_type"] for cell in made["cells"]] == ["code", "markdown", "raw"]


def test_a_right_answer_shows_as_display_and_a_wrong_one_as_the_error_that_stock_nbgrader_counts():
    right = clean_output(verdict_output(Verdict("a", 1.0, Text("fine", "よい")), "en"))
    wrong = clean_output(verdict_output(Verdict("a", 0.5, Text("so so", "まあまあ"), rung="value"), "ja"))
    assert right["output_type"] == "display_data"
    assert right["data"]["text/plain"].endswith("fine")
    assert (wrong["output_type"], wrong["ename"], wrong["traceback"][-1]) == ("error", "CheckFailed", "まあまあ")
