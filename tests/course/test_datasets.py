"""The committed data are what the recipes give, and show what their purpose says."""

from dataclasses import replace

import numpy as np
import pytest

from course.datasets import (
    CLEAN_LOG,
    RECIPES,
    UMBMARK_RUNS,
    UMBMARK_SIDE,
    UMBMARK_TREAD,
    UMBMARK_WHEELS,
    UMBMARKS,
    data_files,
    main,
    run,
    umbmark_runs,
)
from course.dirty_logs import DIRTY_LOGS
from course.logs import REPOSITORY_DATA, LogError, read_encoder_log, read_truth
from course.robots import BEEGO, ICART
from tests.odometry import allowed_by_quantisation, metres_per_count, midpoint_odometry, wheel_counts

BY_NAME = {recipe.name: recipe for recipe in RECIPES}
FAITHFUL = [recipe.name for recipe in RECIPES if recipe.conditions.faithful]
LARGEST_FILE = 200_000


@pytest.fixture(scope="module")
def files():
    return data_files()


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("made") / "data"
    main([str(folder)])
    return folder


@pytest.fixture(scope="module")
def log_and_truth(made):
    def read(name):
        return read_encoder_log(made / f"{name}.dat"), read_truth(made / f"{name}.truth.csv")

    return read


def poses(truth):
    return np.column_stack([truth["x"], truth["y"], truth["theta"]])


def end_of_odometry(name, log):
    return midpoint_odometry(log, BY_NAME[name].robot)[-1]


def path_length(log, robot, cycles=1):
    right, left = wheel_counts(log, robot)
    return np.abs((right + left) / 2 * cycles).sum() * metres_per_count(robot)


def test_the_folder_holds_logs_with_their_truth_umbmark_results_dirty_logs_and_a_readme(files):
    kinds = {f"{name}.{kind}" for name in BY_NAME for kind in ("dat", "truth.csv")}
    others = {f"{half.name}.csv" for half in UMBMARKS} | {f"dirty/{log.name}.dat" for log in DIRTY_LOGS}
    assert set(files) == {"README.md"} | kinds | others
    assert len(files) == 1 + 2 * len(RECIPES) + len(UMBMARKS) + len(DIRTY_LOGS)
    assert len({made.seed for made in (*RECIPES, *UMBMARKS)}) == len(RECIPES) + len(UMBMARKS)


def test_each_recipe_has_a_line_in_the_readme(files):
    readme = files["README.md"].decode()
    for recipe in RECIPES:
        rows = files[f"{recipe.name}.dat"].count(b"\n") - 1
        rate = {0.005: 200, 0.01: 100, 0.05: 20}[recipe.conditions.period]
        line = f"| `{recipe.name}` | {recipe.robot.name} | {rate} | {rows} | {recipe.seed} | "
        assert line + recipe.purpose.en + " |\n" in readme
        assert line + recipe.purpose.ja + " |\n" in readme


def test_the_committed_data_are_what_the_recipes_give(files):
    for name, content in files.items():
        assert (REPOSITORY_DATA / name).read_bytes() == content, f"{name}: run python -m course.datasets"
    assert {str(path.relative_to(REPOSITORY_DATA)) for path in REPOSITORY_DATA.rglob("*") if path.is_file()} == set(files)


def test_the_command_writes_the_same_bytes(made, files):
    written = {path.relative_to(made).as_posix(): path.read_bytes() for path in made.rglob("*") if path.is_file()}
    assert written == files


def test_the_command_leaves_other_files_alone(tmp_path):
    (tmp_path / "mine.dat").write_text("mine")
    main([str(tmp_path)])
    assert (tmp_path / "mine.dat").read_text() == "mine"


def test_files_are_small_and_end_their_lines_alike(files):
    for name, content in files.items():
        assert len(content) < LARGEST_FILE, name
        if name.startswith("dirty/"):
            continue
        assert b"\r" not in content, name
        assert content.endswith(b"\n"), name


@pytest.mark.parametrize("name", BY_NAME)
def test_log_and_truth_share_their_stamps(log_and_truth, name):
    log, truth = log_and_truth(name)
    np.testing.assert_array_equal(log["time"], truth["time"])
    assert (np.diff(log["time"]) > 0).all()
    assert {column[0] for column_name, column in truth.items() if column_name != "time"} == {0.0}
    assert log["counter1"][0] == log["counter2"][0] == 0


@pytest.mark.parametrize("name", FAITHFUL)
def test_odometry_of_a_clean_log_stays_within_quantisation_of_its_truth(log_and_truth, name):
    log, truth = log_and_truth(name)
    position, heading = allowed_by_quantisation(log, BY_NAME[name].robot)
    error = np.abs(midpoint_odometry(log, BY_NAME[name].robot) - poses(truth))
    assert position < 0.002
    assert np.hypot(error[:, 0], error[:, 1]).max() < position
    assert error[:, 2].max() < heading + 5e-7


def test_the_logs_that_odometry_alone_does_not_explain():
    assert set(BY_NAME) - set(FAITHFUL) == {
        *("encoder_slip", "encoder_wrong_radius", "encoder_lost_cycles", "encoder_two_radii"),
    }


@pytest.mark.parametrize(
    ("name", "robot", "end"),
    [
        ("encoder_straight_5m", ICART, (5.0, 0.0, 0.0)),
        ("encoder_straight_left", ICART, (2.33, -1.13, -2.0)),
        ("encoder_beego_straight_left", BEEGO, (1.2, 0.0, 3.2)),
        ("encoder_quarter_turn", ICART, (2.26, -2.01, -np.pi / 2)),
        ("encoder_figure_eight", BEEGO, (0.0, 0.0, 0.0)),
        ("encoder_square_cw", BEEGO, (0.0, 0.0, -2 * np.pi)),
        ("encoder_square_ccw", BEEGO, (0.0, 0.0, 2 * np.pi)),
        ("encoder_slip", BEEGO, (3.2, 0.0, 0.0)),
        ("encoder_two_radii", ICART, (10.0, 0.0, 0.0)),
    ],
)
def test_drives_end_where_their_purpose_says(log_and_truth, name, robot, end):
    assert BY_NAME[name].robot == robot
    _, truth = log_and_truth(name)
    assert (truth["x"][-1], truth["y"][-1], truth["theta"][-1]) == pytest.approx(end, abs=0.01)


@pytest.mark.parametrize("name", ["encoder_straight_left", "encoder_beego_straight_left"])
def test_logs_for_the_signs_go_straight_then_left_for_a_quarter_of_the_rows_each(name):
    recipe = BY_NAME[name]
    truth = run(recipe).truth
    turning = np.abs(truth["yaw_rate"]) > 0
    straight = (truth["velocity"] > 0) & ~turning
    assert min(straight.mean(), turning.mean()) > 0.25
    assert np.flatnonzero(straight).max() < np.flatnonzero(turning).min()
    assert (np.sign(truth["yaw_rate"][turning]) == np.sign(recipe.robot.tread)).all()


def test_the_figure_eight_turns_past_pi_and_back(log_and_truth):
    theta = log_and_truth("encoder_figure_eight")[1]["theta"]
    assert theta.max() > 1.9 * np.pi
    assert theta.min() > -0.01


@pytest.mark.parametrize(("name", "side"), [("encoder_square_cw", -1), ("encoder_square_ccw", 1)])
def test_the_squares_close_but_for_quantisation_and_go_round_on_their_side(log_and_truth, name, side):
    log, truth = log_and_truth(name)
    assert np.hypot(truth["x"][-1], truth["y"][-1]) < 2e-6
    assert np.hypot(*end_of_odometry(name, log)[:2]) < allowed_by_quantisation(log, BEEGO)[0]
    assert np.ptp(truth["x"]) == pytest.approx(2.0, abs=1e-5)
    assert np.ptp(truth["y"]) == pytest.approx(2.0, abs=1e-5)
    assert (side * truth["y"] > -1e-5).all()
    on_the_spot = np.abs(truth["yaw_rate"]) > 0
    assert (truth["velocity"][on_the_spot] == 0).all()


def test_the_reversing_robot_has_speeds_of_either_sign_and_turning_points_at_rest(log_and_truth):
    velocity = log_and_truth("encoder_reversing")[1]["velocity"]
    forward, backward = (np.flatnonzero(sign * velocity > 0.2) for sign in (1, -1))
    assert min(len(forward), len(backward)) > 300
    assert forward[0] < backward[0] < backward[-1] < forward[-1]
    assert (velocity[[495, 945]] == 0).all()


def test_the_slip_turns_odometry_for_good_and_the_robot_not_at_all(log_and_truth):
    log, truth = log_and_truth("encoder_slip")
    error = midpoint_odometry(log, BEEGO) - poses(truth)
    assert not truth["theta"].any()
    before, after = log["time"] <= 4.0, log["time"] >= 4.4
    assert np.abs(error[before]).max() < 1e-4
    np.testing.assert_allclose(error[after, 2], 0.05 / BEEGO.tread, rtol=0, atol=1e-4)
    assert error[-1, 1] == pytest.approx(0.05 / BEEGO.tread * (truth["x"][-1] - 1.4), abs=0.05)


def test_with_the_true_radius_odometry_is_right_again(log_and_truth):
    log, truth = log_and_truth("encoder_wrong_radius")
    nominal = midpoint_odometry(log, BEEGO)
    assert np.hypot(*(nominal - poses(truth))[-1, :2]) > 0.04
    assert truth["theta"][-1] / nominal[-1, 2] == pytest.approx(1.007, abs=1e-4)
    larger = replace(BEEGO, radius=1.007 * BEEGO.radius)
    assert np.abs(midpoint_odometry(log, larger) - poses(truth)).max() < allowed_by_quantisation(log, larger)[0]


def test_two_radii_bend_a_straight_drive(log_and_truth):
    log, truth = log_and_truth("encoder_two_radii")
    right, left = wheel_counts(log, ICART)
    assert right.sum() / left.sum() == pytest.approx(0.14533 / 0.14457758, abs=1e-5)
    assert not truth["y"].any()
    bent = 10 * (1 - 0.14457758 / 0.14533) / ICART.tread
    assert end_of_odometry("encoder_two_radii", log) == pytest.approx([9.95, 10 * bent / 2, bent], abs=0.05)


@pytest.mark.parametrize("name", ["encoder_jitter", "encoder_practical"])
def test_jitter_strays_by_a_millisecond_about_an_even_grid(log_and_truth, name):
    log, _ = log_and_truth(name)
    period = BY_NAME[name].conditions.period
    stray = log["time"] - log["time"][0] - period * np.arange(len(log["time"]))
    assert stray.std() == pytest.approx(0.001, rel=0.06)
    assert stray.mean() == pytest.approx(0, abs=1e-4)
    steps = np.diff(log["time"])
    assert steps.std() == pytest.approx(0.001 * np.sqrt(2), rel=0.06)
    assert steps.min() > 0.2 * period - 1e-6


def test_dividing_by_the_nominal_period_makes_noise_of_jitter(log_and_truth):
    log, truth = log_and_truth("encoder_jitter")
    right, left = wheel_counts(log, ICART)
    travel = (right + left)[1:] / 2 * metres_per_count(ICART)
    cruising = truth["velocity"][1:] == 0.5
    stamped, nominal = (np.std((travel / dt)[cruising]) for dt in (np.diff(log["time"]), 0.005))
    assert nominal > 20 * stamped


@pytest.mark.parametrize("name", ["encoder_unix_time", "encoder_practical", "encoder_lost_cycles"])
def test_unix_stamps_are_of_2024_and_exact_in_float64_alone(made, log_and_truth, name):
    log, _ = log_and_truth(name)
    assert log["time"][0] == pytest.approx(1713150000, abs=5000)
    assert (np.diff(log["time"].astype(np.float32)) == 0).mean() > 0.99
    rows = (made / f"{name}.dat").read_text().splitlines()[1:]
    assert [f"{time:.6f}" for time in log["time"]] == [row.split(",")[0] for row in rows]


def test_unix_stamps_keep_their_period(log_and_truth):
    log, _ = log_and_truth("encoder_unix_time")
    assert np.diff(log["time"]) == pytest.approx(0.01, abs=1e-6)


def test_seven_percent_of_the_cycles_are_lost_as_on_real_robots(log_and_truth):
    log, _ = log_and_truth("encoder_lost_cycles")
    cycles = np.diff(log["time"]) / 0.005
    assert np.abs(cycles - np.rint(cycles)).max() < 0.3
    lost = np.rint(cycles).astype(int) - 1
    assert lost.sum() / (lost.sum() + len(log["time"])) == pytest.approx(0.07, abs=0.01)
    assert set(np.delete(lost, lost.argmax())) == {0, 1, 2}
    assert lost.max() * 0.005 == pytest.approx(0.17, abs=0.011)


def test_lost_counts_shorten_the_path_and_the_cycles_of_dt_bring_them_back(log_and_truth):
    log, truth = log_and_truth("encoder_lost_cycles")
    driven = np.hypot(np.diff(truth["x"]), np.diff(truth["y"])).sum()
    cycles = np.rint(np.diff(log["time"], prepend=log["time"][0] - 0.005) / 0.005)
    assert 1 - path_length(log, ICART) / driven == pytest.approx(0.07, abs=0.01)
    assert path_length(log, ICART, cycles) / driven == pytest.approx(1, abs=0.001)
    recovered = {**log, "counter1": log["counter1"] * cycles, "counter2": log["counter2"] * cycles}
    far, near = (np.hypot(*(midpoint_odometry(one, ICART) - poses(truth))[-1, :2]) for one in (log, recovered))
    assert far > 0.5
    assert near < 0.02


def test_in_the_practical_the_usual_mistakes_show(log_and_truth):
    """Wrapped yaw, speed without sign, row numbers or the slides' 5 ms for time, a start that is not subtracted."""
    log, truth = log_and_truth("encoder_practical")
    assert np.ptp(truth["theta"]) > 2 * np.pi
    assert (np.abs(truth["theta"]) > np.pi).mean() > 0.3
    assert (truth["velocity"] < -0.2).mean() > 0.1
    assert (truth["velocity"] > 0.2).mean() > 0.3
    assert 20 < np.ptp(log["time"]) < 40
    assert np.diff(log["time"]).mean() == pytest.approx(0.01, rel=1e-3)
    mirrored = midpoint_odometry(log, replace(ICART, tread=-ICART.tread))
    assert np.abs(mirrored - poses(truth)).max() > 2


def umbmark(clockwise, counter_clockwise):
    """Borenstein and Feng 1996, from the x errors."""
    alpha, beta = ((clockwise[0] + sign * counter_clockwise[0]) / (-4 * UMBMARK_SIDE) for sign in (1, -1))
    radius = UMBMARK_SIDE / 2 / np.sin(beta / 2)
    return (radius + BEEGO.tread / 2) / (radius - BEEGO.tread / 2), np.pi / 2 / (np.pi / 2 - alpha)


def test_umbmark_finds_the_wheels_and_the_tread_of_its_robot(made):
    errors = [np.loadtxt(made / f"{half.name}.csv", delimiter=",") for half in UMBMARKS]
    assert [half.shape for half in errors] == [(UMBMARK_RUNS, 2)] * 2
    wheels, tread = umbmark(*(half.mean(axis=0) for half in errors))
    assert wheels == pytest.approx(UMBMARK_WHEELS, abs=1e-4)
    assert tread == pytest.approx(UMBMARK_TREAD, abs=5e-4)
    scatter = max(half.std(axis=0).max() for half in errors)
    assert 0.005 < scatter < 0.02
    assert np.hypot(*(errors[0] - errors[1]).mean(axis=0)) > 10 * scatter


@pytest.mark.parametrize("half", UMBMARKS, ids=lambda half: half.name)
def test_in_every_umbmark_run_odometry_believes_to_be_back(made, half):
    """So the true end of a run is its return error: true position minus that of odometry."""
    errors = np.loadtxt(made / f"{half.name}.csv", delimiter=",")
    for one, error in zip(umbmark_runs(half), errors, strict=True):
        believed = midpoint_odometry(one.log, BEEGO)[-1]
        assert believed == pytest.approx([0, 0, half.turn * 2 * np.pi], abs=allowed_by_quantisation(one.log, BEEGO)[0])
        assert poses(one.truth)[-1, :2] == pytest.approx(error, abs=6e-5)


REFUSED = [log for log in DIRTY_LOGS if log.refusal]
READ = [log for log in DIRTY_LOGS if not log.refusal]


@pytest.mark.parametrize("dirty", REFUSED, ids=lambda log: log.name)
def test_dirty_logs_are_refused_in_the_words_of_the_readme(files, dirty, monkeypatch):
    monkeypatch.chdir(REPOSITORY_DATA)
    with pytest.raises(LogError) as error:
        read_encoder_log(f"dirty/{dirty.name}.dat")
    english, japanese = str(error.value).split("\n")
    readme = files["README.md"].decode()
    assert f"| `{dirty.name}` | {dirty.oddity.en} | refuses it: `{english}` |\n" in readme
    assert f"| `{dirty.name}` | {dirty.oddity.ja} | エラーにします: `{japanese}` |\n" in readme


@pytest.mark.parametrize("dirty", READ, ids=lambda log: log.name)
def test_odd_logs_are_read_as_the_readme_says(made, files, dirty):
    clean, log = (read_encoder_log(made / name) for name in (f"{CLEAN_LOG}.dat", f"dirty/{dirty.name}.dat"))
    back = 0.3 * (np.arange(len(clean["time"])) >= 20) if dirty.name == "time_running_back" else 0.0
    np.testing.assert_allclose(log.pop("time"), clean.pop("time") - back, rtol=0, atol=1e-9)
    for name, column in log.items():
        np.testing.assert_array_equal(column, clean[name])
    assert f"| `{dirty.name}` | {dirty.oddity.ja} | {dirty.reading.ja} |\n" in files["README.md"].decode()
    assert files[f"dirty/{dirty.name}.dat"] != files[f"{CLEAN_LOG}.dat"]


def test_time_runs_back_where_the_readme_says(made):
    steps = np.diff(read_encoder_log(made / "dirty/time_running_back.dat")["time"])
    assert steps.min() == pytest.approx(-0.25)
    assert (made / "dirty/time_running_back.dat").read_text().splitlines()[21].startswith(f"{0.7:.6f},")


def test_the_dirt_is_in_the_bytes(files):
    """What editors, version control or a careless writer could clean away unseen."""
    assert files["dirty/byte_order_mark.dat"].startswith(b"\xef\xbb\xbf#")
    assert files["dirty/windows_line_ends.dat"].count(b"\r\n") == files["dirty/windows_line_ends.dat"].count(b"\n") == 42
    assert files["dirty/empty.dat"] == b""
    assert not files["dirty/cut_off.dat"].endswith(b"\n")
    assert b"," not in files["dirty/white_space.dat"].split(b"\n", 1)[1]
    assert b"\n\n" in files["dirty/blank_lines.dat"]
