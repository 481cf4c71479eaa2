"""The views: sliders in a kernel, a still picture everywhere else, and films that need no network."""

import html
import re
from collections.abc import Callable
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.patches import Circle, Wedge

from course import language
from course.drawings.encoders import quadrature_bits
from course.plotting import Colour, new_sketch
from course.robots import BEEGO, ICART, Robot
from course.views import drive, encoders, film, frames, integration, pose_update, view, wheel_odometry

KANA_OR_KANJI = re.compile(r"[ぁ-んァ-ヶ一-龠]")
WIDGET = "application/vnd.jupyter.widget-view+json"
LINE = np.column_stack([np.linspace(0, 2, 500), np.zeros(500), np.zeros(500)])

HALF_CIRCLE = np.linspace(0, np.pi, 101)
HALF_CIRCLE_LOG = {"time": HALF_CIRCLE, "counter1": [300.0] * 101, "counter2": [-100] * 101}


def sums(log: dict[str, np.ndarray], robot: Robot) -> dict[str, np.ndarray]:
    """Return a path that depends on all that a calibration can change."""
    right, left = (robot.radius * np.cumsum(log[f"counter{number}"]) for number in (1, 2))
    return {"x": right - left, "y": np.sin(right / 10), "theta": (right + left) / robot.tread}


def calibration_view(robot: Robot = ICART) -> view.View:
    log = {name: np.asarray(values, dtype=float) for name, values in HALF_CIRCLE_LOG.items()}
    return wheel_odometry.calibration_view(sums, HALF_CIRCLE_LOG, sums(log, robot), robot)


VIEWS = [pose_update.step_view, encoders.wheels_view, integration.step_size_view, frames.point_view, calibration_view]
FILMS: list[Callable[[], film.Film]] = [encoders.encoder_animation, lambda: drive.drive_animation(LINE), frames.line_animation]


@pytest.fixture(params=["en", "ja"])
def chosen(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setattr(language, "_chosen", request.param)
    return str(request.param)


@pytest.fixture
def kernel(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(view, "get_ipython", lambda: SimpleNamespace(kernel=object()))


@pytest.mark.parametrize("made", VIEWS)
def test_without_a_kernel_a_view_is_its_picture(
    made: Callable[[], view.View], chosen: str, caplog: pytest.LogCaptureFixture, capfd: pytest.CaptureFixture[str]
) -> None:
    shown = made()
    bundle = shown._repr_mimebundle_()
    assert set(bundle) == {"text/html", "text/plain"}
    assert bundle["text/html"].startswith("<img alt=")
    assert bool(KANA_OR_KANJI.search(bundle["text/plain"])) is (chosen == "ja")
    assert not caplog.records
    assert capfd.readouterr() == ("", "")


@pytest.mark.usefixtures("kernel")
@pytest.mark.parametrize("made", VIEWS)
def test_sliders_redraw_the_image_and_the_picture_stays_for_static_pages(made: Callable[[], view.View], chosen: str) -> None:
    shown = made()
    bundle = shown._repr_mimebundle_()
    assert {WIDGET, "text/html", "text/plain"} == set(bundle)
    *sliders, image = shown.controls.children
    assert image.value == shown.picture.html
    for slider in sliders:
        before = image.value
        slider.value = slider.min
        assert image.value != before
        assert "alt=" in image.value
        assert re.search(r"\[(m|deg|m/s|s|%)\]", slider.description)
        assert bool(KANA_OR_KANJI.search(slider.description)) is (chosen == "ja")


@pytest.mark.parametrize(
    ("right", "left", "says"),
    [
        (0.2, 0.2, "V = 0.20 m/s, omega = 0.00 rad/s; turning centre: none"),
        (0.2, -0.2, "V = 0.00 m/s, omega = 0.80 rad/s; turning centre: 0.00 m to the left"),
        (0.3, 0.1, "V = 0.20 m/s, omega = 0.40 rad/s; turning centre: 0.50 m to the left"),
        (0.1, 0.3, "V = 0.20 m/s, omega = -0.40 rad/s; turning centre: 0.50 m to the right"),
        (0.0, 0.0, "V = 0.00 m/s, omega = 0.00 rad/s; turning centre: none"),
    ],
)
def test_wheels_view_tells_velocity_yaw_rate_and_turning_centre(
    monkeypatch: pytest.MonkeyPatch, right: float, left: float, says: str
) -> None:
    monkeypatch.setattr(language, "_chosen", "en")
    assert says in encoders._picture_of_drive(right, left, tread=0.5, seconds=4).alt


def test_wheels_view_drives_the_circle_that_the_speeds_define() -> None:
    axes = encoders._picture_of_drive(0.3, 0.1, tread=0.5, seconds=4).figure.axes[0]
    middle = next(line for line in axes.get_lines() if to_hex(line.get_color()) == Colour.INK).get_xydata()
    assert np.hypot(middle[:, 0], middle[:, 1] - 0.5) == pytest.approx(0.5, abs=1e-5)
    assert middle[-1] == pytest.approx([0.5 * np.sin(1.6), 0.5 - 0.5 * np.cos(1.6)], abs=1e-5)


def test_rules_converge_to_the_true_drive_with_their_orders() -> None:
    steps = (0.05, 0.1, 0.2)
    errors = [integration.errors_at_the_end(step) for step in steps]
    for rule, order in (("euler", 1), ("trapezoid", 2), ("midpoint", 2)):
        slope = np.polyfit(np.log(steps), np.log([error[rule] for error in errors]), 1)[0]
        assert slope == pytest.approx(order, abs=0.02)


def test_the_last_step_of_the_drive_is_what_the_others_leave() -> None:
    assert integration.stamps(1.0) == pytest.approx([0, 1, 2, 3, 4])
    assert integration.stamps(0.8)[-1] == integration.SECONDS
    assert integration.stamps(0.75) == pytest.approx([0, 0.75, 1.5, 2.25, 3, 3.75, 4])


def test_calibration_view_starts_on_the_truth_and_leaves_the_log_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(language, "_chosen", "en")
    assert "it ends 0.00 m and +0.0 degrees from the truth" in calibration_view().picture.alt
    assert HALF_CIRCLE_LOG["counter1"] == [300.0] * 101


@pytest.mark.usefixtures("kernel")
@pytest.mark.parametrize("robot", [ICART, BEEGO])
def test_calibration_view_makes_the_parameters_wrong_that_its_sliders_name(robot: Robot) -> None:
    asked = []

    def program(log: dict[str, np.ndarray], assumed: Robot) -> dict[str, np.ndarray]:
        ratios = (assumed.radius / robot.radius, assumed.tread / robot.tread, log["counter1"][1] / 300, log["counter2"][1] / -100)
        asked.append([round(float(ratio), 9) for ratio in ratios])
        return dict.fromkeys(("x", "y", "theta"), HALF_CIRCLE)

    truth = dict.fromkeys(("x", "y", "theta"), HALF_CIRCLE)
    both, right, tread, _ = wheel_odometry.calibration_view(program, HALF_CIRCLE_LOG, truth, robot).controls.children
    both.value, right.value, tread.value = 5, -1, 2.5
    assert asked[0] == [1, 1, 1, 1]
    assert asked[-1] == [1.05, 1.025, 0.99, 1]


@pytest.mark.parametrize(
    "wrong", [None, {}, {"x": 0, "y": 0, "theta": 0}, dict.fromkeys(("x", "y", "theta"), HALF_CIRCLE * np.nan)]
)
def test_calibration_view_says_what_a_program_has_to_return(wrong: object, chosen: str) -> None:
    truth = dict.fromkeys(("x", "y", "theta"), HALF_CIRCLE)
    with pytest.raises(ValueError, match="dict") as caught:
        wheel_odometry.calibration_view(lambda log, robot: wrong, HALF_CIRCLE_LOG, truth, ICART)  # type: ignore[arg-type,return-value]
    assert bool(KANA_OR_KANJI.search(str(caught.value))) is (chosen == "ja")


@pytest.mark.parametrize("tread", [0, -0.3045, float("nan"), float("inf")])
def test_wheels_view_refuses_a_tread_that_is_no_length(tread: float, chosen: str) -> None:
    with pytest.raises(ValueError, match="tread") as caught:
        encoders.wheels_view(tread)
    assert bool(KANA_OR_KANJI.search(str(caught.value))) is (chosen == "ja")


@pytest.fixture
def few_frames(monkeypatch: pytest.MonkeyPatch) -> None:
    """Films have three frames: drawing all of them takes seconds."""
    whole = film.FuncAnimation
    monkeypatch.setattr(film, "FuncAnimation", lambda *made, frames, **options: whole(*made, frames=min(frames, 3), **options))


@pytest.mark.usefixtures("few_frames")
@pytest.mark.parametrize("made", FILMS, ids=["encoder", "drive", "line"])
def test_films_need_no_network_and_speak_the_chosen_language(
    made: Callable[[], film.Film], chosen: str, caplog: pytest.LogCaptureFixture, capfd: pytest.CaptureFixture[str]
) -> None:
    shown = made()
    page = shown._repr_mimebundle_()["text/html"]
    assert "http:" not in page
    assert "https:" not in page
    assert all(link.startswith("data:") for link in re.findall(r'(?:src|href)="([^"]{0,30})', page))
    assert "<link" not in page
    assert 'class="fa' not in page
    assert 1 < len(re.findall(r"frames\[\d+\] = ", page)) <= film.FRAMES
    assert page.count(f'alt="{html.escape(shown.still.alt)}"') == 1
    assert ('title="再生"' in page) is (chosen == "ja")
    assert (">Loop<" in page) is (chosen == "en")
    assert bool(KANA_OR_KANJI.search(shown.still.alt)) is (chosen == "ja")
    assert not caplog.records
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("x", "y", "heading", "says"),
    [
        (0, 0, 0, "u = 1.20 m, v = 0.80 m"),
        (1.2, 0.8, 45, "u = 0.00 m, v = 0.00 m"),
        (1.2, -0.2, 90, "u = 1.00 m, v = 0.00 m"),
        (0.2, 0.8, -90, "u = 0.00 m, v = 1.00 m"),
        (0, 0, 180, "u = -1.20 m, v = -0.80 m"),
    ],
)
def test_point_view_tells_where_the_frame_sees_the_post(
    monkeypatch: pytest.MonkeyPatch, x: float, y: float, heading: float, says: str
) -> None:
    monkeypatch.setattr(language, "_chosen", "en")
    assert says in frames._picture_of_post(x, y, heading).alt


def test_robot_of_the_film_keeps_its_line_after_set_and_swerves_to_the_moved_line_after_adjust() -> None:
    (kept, moved), (swerved, also_moved) = frames.driven(moves_line=False), frames.driven(moves_line=True)
    call = frames.CALL_AFTER * frames.STEPS_PER_FRAME
    assert moved == also_moved
    assert kept[:, 1:] == pytest.approx(0, abs=1e-12)
    assert swerved[: call + 1] == pytest.approx(kept[: call + 1])
    end = (complex(*swerved[-1, :2]) - moved.origin) / moved.forward
    assert end.imag == pytest.approx(0, abs=0.01)
    assert np.exp(1j * swerved[-1, 2]) == pytest.approx(moved.forward, abs=0.02)


def test_the_call_of_the_film_puts_the_robot_where_it_was_told() -> None:
    path, moved = frames.driven(moves_line=False)
    x, y, theta = path[frames.CALL_AFTER * frames.STEPS_PER_FRAME]
    told = (complex(x, y) - moved.origin) / moved.forward
    assert (told.real, told.imag) == pytest.approx(frames.CALLED_WITH[:2])
    assert np.exp(1j * theta) / moved.forward == pytest.approx(np.exp(1j * frames.CALLED_WITH[2]))


def test_a_sensor_is_lit_exactly_when_a_slit_is_before_it() -> None:
    axes = new_sketch((-1.5, 1.5), (-1.5, 1.5))
    turn_to = encoders._turning_disc(axes)
    slits = [patch for patch in axes.patches if isinstance(patch, Wedge)]
    sensors = [patch for patch in axes.patches if isinstance(patch, Circle)][-2:]
    for position in np.arange(-4, 5, 0.25) + 0.1:
        turn_to(position)
        for sensor, bit in zip(sensors, quadrature_bits(np.floor(position)), strict=True):
            place = np.degrees(np.angle(complex(*sensor.center)))
            open_before_it = any((place - slit.theta1) % 360 < encoders.PITCH / 2 for slit in slits)
            assert open_before_it == bit
            assert (to_hex(sensor.get_facecolor()) == encoders.LIGHT.lower()) == bit


@pytest.mark.parametrize("count", [1, 2, 3, 40, 41, 5000])
def test_drive_animation_takes_any_number_of_poses(monkeypatch: pytest.MonkeyPatch, count: int) -> None:
    monkeypatch.setattr(drive, "FRAMES", 4)
    page = drive.drive_animation(LINE[np.linspace(0, 499, count).astype(int)]).html
    assert len(re.findall(r"frames\[\d+\] = ", page)) == min(count, 4)


def test_drive_animation_takes_lists_and_leaves_the_poses_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drive, "FRAMES", 2)
    poses = [[0, 0, 0], [1, 0, 0], [1, 1, 2]]
    assert "1.00" in drive.drive_animation(poses).still.alt
    assert poses == [[0, 0, 0], [1, 0, 0], [1, 1, 2]]


@pytest.mark.parametrize(
    ("poses", "says"),
    [
        ([0, 0, 0], r"\(3,\)"),
        (np.zeros((4, 2)), r"\(4, 2\)"),
        (np.zeros((0, 3)), r"\(0, 3\)"),
        (np.zeros((3, 5)), r"\(3, 5\)"),
        ([[0, 0, 0], [1, 2]], "numbers"),
        ("path", "numbers"),
        (None, "shape"),
        ([[0, 0, 0], [0, float("nan"), 0]], "row 1"),
        ([[0, 0, float("inf")]], "row 0"),
    ],
)
def test_drive_animation_says_what_is_wrong_with_poses(monkeypatch: pytest.MonkeyPatch, poses: object, says: str) -> None:
    monkeypatch.setattr(language, "_chosen", "en")
    with pytest.raises(ValueError, match=says):
        drive.drive_animation(poses)  # type: ignore[arg-type]
