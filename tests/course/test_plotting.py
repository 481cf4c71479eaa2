"""The plotting style: fonts for both languages, labelled axes, and pictures that show once, silently and with alt text."""

import base64
import os
import re
import subprocess
import sys
from pathlib import Path

import matplotlib as mpl
import pytest
from matplotlib import pyplot as plt

from course import language, plotting
from course.drawings.pose_update import robot_pose
from course.language import Text
from course.plotting import Colour, Picture, Quantity, label_axes, new_axes, new_figure, new_xy_axes

SPEED = Quantity(Text("speed", "速度"), "m/s")


@pytest.fixture(autouse=True)
def _japanese(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(language, "_chosen", "ja")


def test_first_import_on_a_new_computer_is_silent(tmp_path: Path) -> None:
    program = "import course, sys; assert 'matplotlib' not in sys.modules; from course.drawings.pose_update import one_step; one_step().png"
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", program],
        env={**os.environ, "MPLCONFIGDIR": str(tmp_path)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout + done.stderr == ""


@pytest.mark.parametrize(("chosen", "label"), [("en", "speed [m/s]"), ("ja", "速度 [m/s]")])
def test_labels_hold_quantity_and_unit_in_the_chosen_language(monkeypatch: pytest.MonkeyPatch, chosen: str, label: str) -> None:
    monkeypatch.setattr(language, "_chosen", chosen)
    axes = new_axes()
    label_axes(axes, ("k", ""), SPEED)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("k", label)
    plt.close(axes.figure)


def test_xy_axes_show_a_metre_as_long_in_both_directions() -> None:
    axes = new_xy_axes()
    axes.plot([0, 4], [0, 1])
    axes.figure.canvas.draw()
    (x0, y0), (x1, y1) = axes.transData.transform([(0, 0), (1, 1)])
    assert x1 - x0 == pytest.approx(y1 - y0)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x [m]", "y [m]")
    plt.close(axes.figure)


@pytest.mark.parametrize(
    ("chosen", "text"),
    [
        ("ja", "姿勢の変化 $\\Delta\\theta$ −1 °"),
        ("ja", "pose change $\\Delta\\theta$ −1 °"),
        ("en", "pose change $\\Delta\\theta$ −1 °"),
        ("en", "姿勢の変化 Δθ −1 °"),
    ],
)
def test_students_own_labels_find_every_glyph(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture, chosen: str, text: str
) -> None:
    monkeypatch.setattr(language, "_chosen", chosen)
    axes = new_axes()
    axes.set_title(text)
    axes.figure.canvas.draw()
    assert not caplog.records
    plt.close(axes.figure)


def test_a_picture_is_an_image_with_its_alt_text_and_nothing_from_elsewhere() -> None:
    picture = Picture(new_figure(3, 2), Text('a "quoted" <graph>', "グラフ"))
    bundle = picture._repr_mimebundle_()
    assert set(bundle) == {"text/html", "text/plain"}
    assert bundle["text/plain"] == "グラフ"
    image = re.fullmatch(
        r'<img alt="グラフ" width="300" style="max-width:100%;.*" src="data:image/png;base64,(.+)">', picture.html
    )
    assert image
    assert base64.b64decode(image[1]) == picture.png
    width, height = (int.from_bytes(picture.png[at : at + 4], "big") for at in (16, 20))
    assert (width, height) == (600, 400)


def test_alt_text_is_escaped() -> None:
    assert 'alt="&quot;a&quot; &lt;b&gt;"' in Picture(new_figure(1, 1), '"a" <b>').html


def test_pictures_are_closed_so_that_nothing_shows_twice() -> None:
    plt.close("all")
    for _ in range(25):  # more than 20 open figures would warn
        Picture(new_axes().figure, "graph")
    assert plt.get_fignums() == []


def test_pictures_do_not_depend_on_what_the_reader_did_to_the_style_and_leave_it_alone() -> None:
    before = robot_pose().png
    with mpl.rc_context({"font.size": 30, "figure.facecolor": "black", "lines.linewidth": 9, "axes.grid": False}):
        assert robot_pose().png == before
        assert mpl.rcParams["lines.linewidth"] == 9


def test_fonts_do_not_come_from_the_system() -> None:
    for family in plotting.course_style()["font.family"]:
        path = mpl.font_manager.findfont(family, fallback_to_default=False)
        assert "site-packages" in path


def test_colours_of_opposed_roles_differ() -> None:
    opposed = [
        (Colour.RIGHT, Colour.LEFT),
        (Colour.EULER, Colour.MIDPOINT),
        (Colour.EULER, Colour.ARC),
        (Colour.MIDPOINT, Colour.ARC),
        (Colour.RIGHT_WAY, Colour.WRONG_WAY),
        (Colour.GLOBAL_FRAME, Colour.SENSOR_FRAME),
    ]
    assert all(one.value != other.value for one, other in opposed)
