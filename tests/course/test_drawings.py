"""The drawings: complete and silent in both languages, and true to the course's definitions."""

import math
import re

import numpy as np
import pytest

from course import language
from course.drawings import encoders, frames, integration, pose_update, wheel_odometry
from course.drawings.robot import draw_robot
from course.plotting import new_sketch

DRAWINGS = [
    pose_update.robot_pose,
    pose_update.one_step,
    pose_update.sensor_and_global_frames,
    pose_update.heading_choices,
    encoders.drive_train,
    encoders.quadrature_signals,
    encoders.two_wheels,
    encoders.mirrored_motors,
    encoders.counter_wrap,
    encoders.signed_tread,
    integration.pieces_of_area,
    integration.last_trapezoid,
    integration.uneven_stamps,
    integration.samples_and_means,
    frames.point_in_two_frames,
    frames.chain_of_frames,
    frames.ypspur_frames,
    frames.axes_of_slides_003,
    frames.half_tread,
    frames.compass_and_heading,
    wheel_odometry.practical,
    wheel_odometry.log_rows,
    wheel_odometry.lost_cycles,
    wheel_odometry.poor_graphs,
    wheel_odometry.umbmark_squares,
]
KANA_OR_KANJI = re.compile(r"[ぁ-んァ-ヶ一-龠]")


def texts(picture: object) -> list[str]:
    """Return all texts that a picture shows."""
    figure = picture.figure  # type: ignore[attr-defined]
    axes = figure.axes
    return [text.get_text() for part in axes for text in part.texts] + [part.get_xlabel() for part in axes]


@pytest.mark.parametrize("draw", DRAWINGS, ids=lambda draw: draw.__name__)
def test_drawing_speaks_both_languages_without_a_sound(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture, capfd: pytest.CaptureFixture[str], draw: object
) -> None:
    shown = {}
    for chosen in ("en", "ja"):
        monkeypatch.setattr(language, "_chosen", chosen)
        picture = draw()  # type: ignore[operator]
        assert picture.png.startswith(b"\x89PNG")
        assert len(picture.png) > 10_000
        assert len(picture.alt) > 40
        assert bool(KANA_OR_KANJI.search(picture.alt)) is (chosen == "ja")
        shown[chosen] = texts(picture)
    assert not any(KANA_OR_KANJI.search(text) for text in shown["en"])
    assert any(KANA_OR_KANJI.search(text) for text in shown["ja"])
    assert len(shown["en"]) == len(shown["ja"])
    assert not caplog.records  # a glyph missing from a formula is only logged
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("draw", DRAWINGS, ids=lambda draw: draw.__name__)
@pytest.mark.parametrize("chosen", ["en", "ja"])
def test_no_text_leaves_the_picture(monkeypatch: pytest.MonkeyPatch, draw: object, chosen: str) -> None:
    monkeypatch.setattr(language, "_chosen", chosen)
    figure = draw().figure  # type: ignore[operator]
    figure.draw_without_rendering()
    page = figure.bbox
    for text in (text for part in figure.axes for text in [*part.texts, part.xaxis.label, part.yaxis.label]):
        box = text.get_window_extent()
        if text.get_text():
            assert page.contains(box.x0, box.y0), text.get_text()
            assert page.contains(box.x1, box.y1), text.get_text()


@pytest.mark.parametrize(("distance", "dtheta", "heading"), [(0.9, 60, 0), (-0.4, 135, 30), (1.0, -180, -90), (0.5, 0, 45)])
def test_step_paths_end_where_geometry_says(distance: float, dtheta: float, heading: float) -> None:
    ends = {rule: path[-1] for rule, path in pose_update.step_paths(distance, dtheta, heading).items()}
    half = math.radians(dtheta) / 2
    chord = distance * np.sinc(half / np.pi)
    middle = np.exp(1j * (math.radians(heading) + half))
    assert ends["euler"] == pytest.approx(distance * np.exp(1j * math.radians(heading)))
    assert ends["midpoint"] == pytest.approx(distance * middle)
    assert ends["arc"] == pytest.approx(chord * middle, abs=1e-6)


def test_a_leads_b_when_the_count_rises() -> None:
    a, b = encoders.quadrature_bits(np.arange(5))
    assert [f"{one:d}{other:d}" for one, other in zip(a, b, strict=True)] == ["00", "10", "11", "01", "00"]


def test_the_uneven_stamps_enclose_the_areas_that_are_written_there() -> None:
    areas = [text for text in texts(integration.uneven_stamps()) if re.search(r"\d\.\d\d$", text)]
    true_area, pretended = 0.5, (0.05 + 0.15 + 0.6) / 3
    assert [float(area.split()[-1]) for area in areas] == pytest.approx([true_area, pretended], abs=0.005)


def test_means_lie_on_the_speed_half_an_interval_before_their_ends() -> None:
    means = next(line for line in integration.samples_and_means().figure.axes[1].get_lines() if line.get_marker() == "s")
    ends, levels = means.get_xydata().T
    assert levels == pytest.approx(integration._speed(ends - 0.5))


@pytest.mark.parametrize("way", [1, -1])
def test_a_square_with_the_right_parameters_closes(way: int) -> None:
    path = wheel_odometry._driven_square(way, wheel_ratio=1.0, tread_ratio=1.0)
    assert path[-1] == pytest.approx(0, abs=1e-9)
    assert path[440] == pytest.approx(4 + 4j * way)


def test_a_wrong_tread_mirrors_the_returns_and_unequal_wheels_do_not() -> None:
    ends = [wheel_odometry._driven_square(way, 1.0, 0.94)[-1] for way in (1, -1)]
    assert ends[0] == pytest.approx(np.conj(ends[1]))
    left, right = (wheel_odometry._driven_square(way, 1.012, 1.0)[-1].real for way in (1, -1))
    assert left > 0.5
    assert right < -0.5


def test_robot_looks_where_its_heading_points() -> None:
    axes = new_sketch((-2, 2), (-2, 2))
    patches = draw_robot(axes, (1.0, -0.5, math.pi / 2), tread=0.5)
    nose = max(axes.transData.inverted().transform(patch.get_window_extent().corners())[:, 1].max() for patch in patches)
    assert nose == pytest.approx(-0.5 + 0.45 * 0.5, abs=0.01)
    assert set(patches) <= set(axes.patches)
