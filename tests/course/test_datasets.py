"""The committed data are what the recipes give, and show what their purpose says."""

import numpy as np
import pytest

from course.datasets import RECIPES, data_files, main, run
from course.logs import REPOSITORY_DATA, read_encoder_log, read_truth
from course.robots import BEEGO, ICART

BY_NAME = {recipe.name: recipe for recipe in RECIPES}
LARGEST_FILE = 150_000


@pytest.fixture(scope="module")
def files():
    return data_files()


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("made") / "data"
    main([str(folder)])
    return folder


def test_each_recipe_has_a_log_a_truth_and_a_line_in_the_readme(files):
    assert set(files) == {"README.md"} | {f"{name}.{kind}" for name in BY_NAME for kind in ("dat", "truth.csv")}
    assert len(BY_NAME) == len(RECIPES)
    assert len({recipe.seed for recipe in RECIPES}) == len(RECIPES)
    readme = files["README.md"].decode()
    for recipe in RECIPES:
        rows = files[f"{recipe.name}.dat"].count(b"\n") - 1
        line = f"| `{recipe.name}` | {recipe.robot.name} | 200 | {rows} | {recipe.seed} | "
        assert line + recipe.purpose.en + " |\n" in readme
        assert line + recipe.purpose.ja + " |\n" in readme


def test_the_committed_data_are_what_the_recipes_give(files):
    for name, content in files.items():
        assert (REPOSITORY_DATA / name).read_bytes() == content, f"{name}: run python -m course.datasets"


def test_the_command_writes_the_same_bytes(made, files):
    assert {path.name: path.read_bytes() for path in made.iterdir()} == files


def test_the_command_leaves_other_files_alone(tmp_path):
    (tmp_path / "mine.dat").write_text("mine")
    main([str(tmp_path)])
    assert (tmp_path / "mine.dat").read_text() == "mine"


def test_files_are_small_and_end_their_lines_alike(files):
    for name, content in files.items():
        assert len(content) < LARGEST_FILE, name
        assert b"\r" not in content, name
        assert content.endswith(b"\n"), name


@pytest.mark.parametrize("name", BY_NAME)
def test_log_and_truth_share_their_stamps(made, name):
    log, truth = read_encoder_log(made / f"{name}.dat"), read_truth(made / f"{name}.truth.csv")
    np.testing.assert_array_equal(log["time"], truth["time"])
    assert (np.diff(log["time"]) > 0).all()
    assert {column[0] for column in truth.values()} == {0.0}


@pytest.mark.parametrize(
    ("name", "robot", "end"),
    [
        ("encoder_straight_5m", ICART, (5.0, 0.0, 0.0)),
        ("encoder_straight_left", ICART, (2.33, -1.13, -2.0)),
        ("encoder_beego_straight_left", BEEGO, (1.2, 0.0, 3.2)),
        ("encoder_quarter_turn", ICART, (2.26, -2.01, -np.pi / 2)),
        ("encoder_figure_eight", BEEGO, (0.0, 0.0, 0.0)),
    ],
)
def test_drives_end_where_their_purpose_says(made, name, robot, end):
    assert BY_NAME[name].robot == robot
    truth = read_truth(made / f"{name}.truth.csv")
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


def test_the_figure_eight_turns_past_pi_and_back(made):
    theta = read_truth(made / "encoder_figure_eight.truth.csv")["theta"]
    assert theta.max() > 1.9 * np.pi
    assert theta.min() > -0.01
